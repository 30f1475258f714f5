/* water/water.h - what meshes need of the water. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_WATER_WATER_H
#define HAWSER_WATER_WATER_H

#include <hawser/water.h>

/* The current at a height y (m), and its derivative u_y[3] (1/s). */
void hawser__water_current(double u[3], double u_y[3], const struct hawser_water *water, double y);

/* The largest height (m) of waves of the frequency omega > 0 (rad/s) in this depth, beyond which they
 * break (Miche 1944): 0.142 wavelengths times tanh(k h). It falls with omega. */
double hawser__wave_highest(double omega, double depth, double g);

/* What of an element is in the water, by its ends, and its derivatives by their heights y (m). With
 * the shape functions N, part[i] is the integral of N_i over what is wet, over the length: 1/2 of
 * an element below the surface. A line comes out of the water within the height `band` (m). */
struct hawser__wet {
	double part[2], by[2][2];
};
void hawser__wet_line(struct hawser__wet *wet, double surface, double band, const double y[2]);
/* The volume of a sphere that is in the water, m^3, and its derivative by the height y of the
 * centre. */
double hawser__wet_sphere(double *by, double surface, double volume, double y);

/* --- linear.c: linear drag in place of quadratic drag |r| r of a relative velocity r, for
 * responses over the frequency --- */

/* C r stands for |r| r, C in m/s.
 *
 * r: mean [3] (m/s) and a Gaussian part with the covariance cov (m^2/s^2). C is the mean of the
 * derivative of |r| r, which for Gaussian velocities has the least mean square of the error
 * (statistical linearisation). Along one line, sqrt(8/pi) s without a mean. */
void hawser__drag_random(double C[3][3], const double cov[3][3], const double mean[3]);

/* r: mean [3] and re cos q + im sin q, over a turn of q. C, the same in all directions, takes the work
 * of |r| r in this part. Along one line, 8/(3 pi) of its amplitude without a mean. */
void hawser__drag_orbit(double C[3][3], const double re[3], const double im[3], const double mean[3]);

#endif
