/* hawser/waves.h - linear (Airy) waves, regular ones and seas with a JONSWAP spectrum.
 *
 * A wave of the amplitude a runs along the horizontal direction d = (cos heading, 0, sin heading).
 * With its phase q = k d.x - omega t + phase and omega^2 = g k tanh(k h):
 *
 *     elevation a cos q,  velocity a omega (C cos q d + S sin q e_y)
 *     C = cosh(k(y + h))/sinh(k h),  S = sinh(k(y + h))/sinh(k h)
 *
 * h is the depth and y the height above the mean surface. Accelerations are those at a fixed place.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_WAVES_H
#define HAWSER_WAVES_H

#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number k > 0 (1/m) of waves of the frequency omega > 0 (rad/s) in this depth (m; infinite: deep
 * water), to round-off. g: m/s^2 */
double hawser_wave_number(double omega, double depth, double g);

/* The frequency (rad/s) above which waves of this height (m) break; 0: all do. */
double hawser_wave_breaking(double height, double depth, double g);

/* --- the spectrum --- */

/* S(omega) = scale w^-5 exp(-1.25 w^-4) gamma^exp(-(w - 1)^2/(2 s^2)), w = omega/omega_p, with s = 0.07
 * below the peak and 0.09 above, so that its integral is Hs^2/16. */
struct hawser_jonswap {
	double omega_p;  /* rad/s, of the peak */
	double gamma;    /* its enhancement, 1: Pierson-Moskowitz */
	double scale;    /* m^2 s */
};
/* Hs (m) and Tp (s) above 0; gamma of 1 or more. */
void hawser_jonswap_of(struct hawser_jonswap *spectrum, double Hs, double Tp, double gamma);
/* S, m^2 s */
double hawser_jonswap_at(const struct hawser_jonswap *spectrum, double omega);
/* The integral of omega^power S between two frequencies; to may be infinite. power: below 4 */
double hawser_jonswap_moment(const struct hawser_jonswap *spectrum, double power, double from,
                             double to);

/* --- waves --- */

/* What the velocity is above the mean surface, where the formulas do not hold. */
enum hawser_wave_stretching {
	HAWSER_STRETCH_WHEELER = 0, /* that at (y - elevation) h/(h + elevation) */
	HAWSER_STRETCH_NONE,        /* by the formulas */
	HAWSER_STRETCH_VERTICAL,    /* that at the mean surface */
	HAWSER_STRETCH_EXTRAPOLATE  /* on the tangent there */
};

/* Waves as a scene has them: of one height and period, or those of a spectrum. */
struct hawser_waves_given {
	double height, period;  /* m, s: a regular wave, or */
	double Hs, Tp;          /* m, s: a sea */
	double gamma;           /* of the sea; 0: 3.3 */
	double heading;         /* rad, from x towards z */
	double phase;           /* rad, of a regular wave */
	int components;         /* of a sea; 0: 400 */
	int seed;               /* of its random numbers, 0 or more; HAWSER_NONE: frequencies in the middle
	                         * of their bins and phases of 0, for sums over the spectrum only */
	double range[2];        /* rad/s, of its frequencies; 0, 0: 0.5 and 5 times that of the peak */
	double depth;           /* m; infinite: deep water */
	double surface;         /* m, y of the mean surface */
	double g;               /* m/s^2; 0: 9.81 */
	double ramp;            /* s: elevation and velocity grow from 0 in this time from t = 0 on, by the
	                         * factor q^3 (10 - 15 q + 6 q^2), q = t/ramp; 0: none */
	enum hawser_wave_stretching stretching;
};

struct hawser_wave {
	double amplitude, omega, k, phase; /* m, rad/s, 1/m, rad */
};
struct hawser_waves {
	struct hawser_wave *wave; /* [count] by rising omega */
	int count;
	double along[2];          /* x and z of their direction */
	double depth, surface, ramp; /* as given */
	enum hawser_wave_stretching stretching;
};

/* The waves. Of a sea, the range of frequencies is divided into bins of one width. Each component has
 * the energy of the spectrum in its bin, the first that below as well, the last that above; so the
 * variance of the elevation is Hs^2/16. Frequencies are drawn within the bins: with equal distances
 * the sea would repeat itself. The same seed makes the same sea on every machine. Release it with
 * hawser_waves_clear. HAWSER_ERR_ARGUMENT, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_waves_make(struct hawser_waves *waves,
                                     const struct hawser_waves_given *given,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_waves_clear(struct hawser_waves *waves);

/* The water at one place and time. */
struct hawser_wave_flow {
	double u[3];      /* m/s */
	double du[3];     /* m/s^2: change of u with time at this place */
	double elevation; /* m, of the surface above this place, over the mean one */
};
/* At x [3] (m) and t (s). Below the bed: as at the bed. */
void hawser_waves_at(struct hawser_wave_flow *flow, const struct hawser_waves *waves,
                     const double x[3], double t);
/* The elevation (m) above x [3] alone. */
double hawser_waves_elevation(const struct hawser_waves *waves, const double x[3], double t);

#ifdef __cplusplus
}
#endif
#endif
