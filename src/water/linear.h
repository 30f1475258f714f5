/* water/linear.h - linear drag in place of quadratic drag |r| r of a relative velocity r, for responses
 * over the frequency. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_WATER_LINEAR_H
#define HAWSER_WATER_LINEAR_H

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
