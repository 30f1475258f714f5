/* tow/trajectory_flight.c - straight flight and circles, and the ramps by which they begin.
 *
 *   x      t/T, time over that of the ramp
 *   s      [0] way over speed times T, [1] speed over the final one, [2..4] its derivatives by x
 *
 * ERF, of D (5.2.2), has a root of x in its argument: toward x = 0 its derivatives grow without
 * limit, with a factor of exp(-36) = 2e-16, and at x = 0 itself 0 is taken.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "tow/trajectory.h"

#define PI 3.14159265358979323846 /* to the digits of a double */
#define POWER 0.6 /* of x in the law of D (5.2.2): (1 - erf(6 - 12 x^0.6))/2 */
#define RISE 12.0 /* its factor: the speed rises from erf(-6) to erf(6), 1 but for 2e-17 */
enum { PANELS = 48, POINTS = 5 }; /* of the integral of the speed: a panel is 1/48 of x^0.6, over which
                                   * the argument of erf changes by 1/4: an error of 1e-15 */

static void smooth(double s[HAWSER_PATH_ORDERS], double x)
{
	double x2 = x*x, x4 = x2*x2;

	s[0] = x4*x*(7.0 + x*(-14.0 + x*(10.0 - 2.5*x)));
	s[1] = x4*(35.0 + x*(-84.0 + x*(70.0 - 20.0*x)));
	s[2] = x2*x*(140.0 + x*(-420.0 + x*(420.0 - 140.0*x)));
	s[3] = x2*(420.0 + x*(-1680.0 + x*(2100.0 - 840.0*x)));
	s[4] = x*(840.0 + x*(-5040.0 + x*(8400.0 - 4200.0*x)));
}

/* The integral of erfc(6 - 12 x^0.6)/2 from 0 to x, with y = x^0.6 by Gauss's rule on panels. */
static double erf_way(double x)
{
	static const double node[POINTS] = {-0.9061798459386640, -0.5384693101056831, 0.0,
	                                    0.5384693101056831, 0.9061798459386640},
	                    weight[POINTS] = {0.2369268850561891, 0.4786286704993665,
	                                      0.5688888888888889, 0.4786286704993665,
	                                      0.2369268850561891};
	double end = pow(x, POWER), half = 0.5*end/PANELS, sum = 0.0;

	for (int i = 0; i < PANELS; i++)
		for (int k = 0; k < POINTS; k++) {
			double y = half*(2*i + 1 + node[k]);

			sum += half*weight[k]*0.5*erfc(0.5*RISE - RISE*y)*pow(y, 1.0/POWER - 1.0)/POWER;
		}
	return sum;
}

static void error_function(double s[HAWSER_PATH_ORDERS], double x)
{
	double z = 0.5*RISE - RISE*pow(x, POWER), g, g1, g2, e;

	s[0] = erf_way(x);
	s[1] = 0.5*erfc(z);
	s[2] = s[3] = s[4] = 0.0;
	if (x <= 0.0)
		return;
	g = RISE*POWER*pow(x, POWER - 1.0); /* -dz/dx */
	g1 = (POWER - 1.0)*g/x;
	g2 = (POWER - 2.0)*g1/x;
	e = exp(-z*z)/sqrt(PI);
	s[2] = e*g;
	s[3] = e*(2.0*z*g*g + g1);
	s[4] = e*(2.0*z*g*(2.0*z*g*g + g1) - 2.0*g*g*g + 4.0*z*g*g1 + g2);
}

void hawser__ramp(double s[HAWSER_PATH_ORDERS], enum hawser_path_ramp ramp, double x)
{
	double inside = fmin(fmax(x, 0.0), 1.0);

	if (ramp == HAWSER_PATH_RAMP_ERF)
		error_function(s, inside);
	else
		smooth(s, inside);
	if (x < 1.0)
		return;
	s[0] += x - 1.0;
	s[1] = 1.0;
	s[2] = s[3] = s[4] = 0.0;
}

/* --- the two flights --- */

static enum hawser_status bad(struct hawser_report *report, const char *what)
{
	return hawser__fail_at(report, HAWSER_ERR_ARGUMENT, "trajectory", -1, 0.0, "%s", what);
}

static int finite3(const double *x)
{
	return isfinite(x[0]) && isfinite(x[1]) && isfinite(x[2]);
}

static enum hawser_status begin(struct hawser_path *of, const double *origin, double ramp_time,
                                enum hawser_path_ramp ramp, struct hawser_report *report)
{
	memset(of, 0, sizeof *of);
	if (!finite3(origin))
		return bad(report, "a component of the start is not a finite number");
	if (!(ramp_time >= 0.0) || isinf(ramp_time))
		return bad(report, "the time of the ramp must be a finite number >= 0");
	memcpy(of->origin, origin, sizeof of->origin);
	of->to = INFINITY;
	of->ramp_time = ramp_time;
	of->ramp = ramp;
	of->smooth = HAWSER_PATH_ORDERS - 1;
	return HAWSER_OK;
}

enum hawser_status hawser_path_straight(struct hawser_path *trajectory,
                                              const double start[3], const double velocity[3],
                                              double ramp_time, enum hawser_path_ramp ramp,
                                              struct hawser_report *report)
{
	enum hawser_status status = begin(trajectory, start, ramp_time, ramp, report);

	if (!status && !finite3(velocity))
		status = bad(report, "a component of the velocity is not a finite number");
	if (status) {
		memset(trajectory, 0, sizeof *trajectory);
		return status;
	}
	trajectory->kind = HAWSER_PATH_STRAIGHT;
	memcpy(trajectory->velocity, velocity, sizeof trajectory->velocity);
	return HAWSER_OK;
}

enum hawser_status hawser_path_orbit(struct hawser_path *trajectory,
                                           const double centre[3], double radius, double speed,
                                           double ramp_time, enum hawser_path_ramp ramp,
                                           struct hawser_report *report)
{
	enum hawser_status status = begin(trajectory, centre, ramp_time, ramp, report);

	if (!status && (!(radius > 0.0) || isinf(radius)))
		status = bad(report, "the radius of an orbit must be a finite number > 0");
	if (!status && !isfinite(speed))
		status = bad(report, "the speed of an orbit must be a finite number");
	if (status) {
		memset(trajectory, 0, sizeof *trajectory);
		return status;
	}
	trajectory->kind = HAWSER_PATH_ORBIT;
	trajectory->radius = radius;
	trajectory->speed = speed;
	return HAWSER_OK;
}
