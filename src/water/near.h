/* water/near.h - the waves of a motion: at places that are asked for again and again, at times a little
 * later each. As hawser_waves_at, at a small part of its cost for seas with many components.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_WATER_NEAR_H
#define HAWSER_WATER_NEAR_H

#include <hawser/status.h>
#include <hawser/waves.h>

/* A workspace for this number of places, about which nothing is known yet. Threads must not share it;
 * the waves stay those of the caller. HAWSER_ERR_MEMORY. */
struct hawser__near;
enum hawser_status hawser__near_open(struct hawser__near **near, const struct hawser_waves *waves,
                                     int places, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__near_free(struct hawser__near *near);

/* hawser_waves_at at x [3] (m) and t (s) of a place. In the seas of bench/waves within 2e-4 of the root
 * mean square of the velocity and 7e-4 of that of the acceleration (2e-3 and 5e-3 where they are
 * extrapolated above the mean surface). A place may be anywhere, but is quick if it moves little. */
void hawser__near_at(struct hawser_wave_flow *flow, struct hawser__near *near, int place,
                     const double x[3], double t);

/* --- regular.c: a regular wave at its phase, with derivatives --- */

/* A wave of any frequency, with the direction, depth, surface and stretching of `of`. */
struct hawser__regular {
	const struct hawser_waves *of;
	double amplitude, phase; /* m, rad */
	double omega, k, slope;  /* rad/s, 1/m; dk/domega, s/m */
};
/* amplitude and phase: those of the scene's wave. */
struct hawser__regular hawser__regular_wave(const struct hawser_waves *waves, double omega, double g);

/* The water at a place: as struct hawser_wave_flow, and the derivatives by the place (entries 0 to 2)
 * and by omega, with the phase omega t held (entry 3). */
struct hawser__regular_flow {
	double elevation, u[3], du[3];
	double elevation_by[4], u_by[3][4], du_by[3][4];
};
/* At x [3] (m), when omega t is tau. Without ramp. */
void hawser__regular_at(struct hawser__regular_flow *flow, const struct hawser__regular *wave,
                        const double x[3], double tau);

/* --- the factors of linear waves over the height and over time, of water/waves.c --- */

/* C and S of hawser/waves.h at y (m) above the mean surface, in this depth. */
struct hawser__profile {
	double C, S;
};
struct hawser__profile hawser__wave_profile(double k, double y, double depth);

/* The height (m) above the mean surface at which the formulas are taken, for y above it. *beyond: by
 * this more on the tangent there. */
double hawser__wave_height(double *beyond, const struct hawser_waves *waves, double y,
                           double elevation);

/* The flow of waves that have grown, of velocities u and accelerations du along them and upwards. */
void hawser__wave_flow(struct hawser_wave_flow *flow, const struct hawser_waves *waves,
                       const double u[2], const double du[2], double t);
/* The factor by which the waves have grown at a time, and its *rate (1/s). */
double hawser__wave_growth(double *rate, const struct hawser_waves *waves, double t);

#endif
