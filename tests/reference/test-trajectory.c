/* Paths of a towing point: the numbers of D 5.2 as corrected, least integral by perturbation,
 * smoothness, what may be given, and what is refused.
 *
 * D: Dehadrai, 2018; its e1 (down), e2, e3 are -y, x, z here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/trajectory.h>

#include "tests/tap.h"

enum { ORDERS = HAWSER_PATH_ORDERS };

static struct hawser_waypoint at(double t, double x, double z)
{
	return (struct hawser_waypoint){.t = t, .at = {{x, 0.0, z}}};
}

/* Derivatives from 1 to `last` are given, as they stand. */
static struct hawser_waypoint given(struct hawser_waypoint point, int last)
{
	for (int k = 1; k <= last; k++)
		point.given[k] = 1;
	return point;
}

static double value(const struct hawser_path *path, double t, int order, int axis)
{
	double state[ORDERS][3] = {{0.0}};
	struct hawser_report report = {0};

	if (hawser_path_at(state, path, t, &report))
		return NAN;
	return state[order][axis];
}

/* By the midpoint rule. */
static double squared_snap(const struct hawser_path *path)
{
	enum { STEPS = 2000 };
	double h = (path->to - path->from)/STEPS, sum = 0.0;

	for (int i = 0; i < STEPS; i++)
		for (int axis = 0; axis < 3; axis++)
			sum += h*pow(value(path, path->from + (i + 0.5)*h, 4, axis), 2.0);
	return sum;
}

/* --- D 5.2 --- */

static void published(void)
{
	struct hawser_report report = {0};
	struct hawser_path path;
	const double start[3] = {0.0}, velocity[3] = {8.0, 0.0, 0.0};
	struct hawser_path_largest largest;

	if (ok(!hawser_path_straight(&path, start, velocity, 32.0, HAWSER_PATH_RAMP_ERF, &report),
	       "D 5.2.2: %s", report.message)) {
		ok(fabs(value(&path, 60.0, 0, 0) - 8.0*(60.0 - 10.157)) < 8.0*5e-4,
		   "u0 = 8 (t - 10.157), not 8 t: %.6f", 60.0 - value(&path, 60.0, 0, 0)/8.0);
		ok(!hawser_path_largest(&largest, &path, 0.0, 40.0, &report), "its largest acceleration");
		ok(fabs(largest.value[2] - 1.617) < 5e-4, "peak 1.617 m/s^2: %.6f", largest.value[2]);
		close_to(value(&path, 9.0, 1, 0), 4.0*(erf(12.0) - erf(6.0 - 1.5*pow(9.0, 0.6))), 1e-14,
		         "its law at 9 s");
	}
	for (int jerk = 0; jerk < 2; jerk++)
		for (int round = 0; round < 2; round++) {
			const struct hawser_waypoint u[] = {
				given(at(0.0, 0.0, 0.0), 2 + jerk), at(30.0, 100.0, round ? -100.0 : 0.0),
				at(70.0, 100.0, 100.0), given(at(100.0, 0.0, round ? 0.0 : 100.0), 2 + jerk)};
			double want = jerk ? 7.4162 : 6.3538;

			if (!ok(!hawser_path_waypoints(&path, u, 4, HAWSER_MINIMISE_SNAP, &report),
			        "D 5.2.%d%s: %s", 5 + round, jerk ? " with the jerk" : "", report.message))
				continue;
			ok(fabs(value(&path, 30.0, 1, 0) - want) < 5e-5, "velocity at 30 s %.4f: %.6f", want,
			   value(&path, 30.0, 1, 0));
			ok(!round || jerk || fabs(value(&path, 30.0, 1, 2) + 1.8876) < 5e-5,
			   "across %.6f", value(&path, 30.0, 1, 2));
			ok(path.smooth == 6 && path.error < 1e-12, "error %.1e", path.error);
			close_to(path.cost, squared_snap(&path), 1e-5, "integral of the squared snap");
			hawser_path_clear(&path);
		}
}

/* c[14] of powers of tau = (t - 50)/20 into those of t. */
static void expand(double *of, const double *c)
{
	for (int p = 0; p < 14; p++)
		of[p] = 0.0;
	for (int p = 13; p >= 0; p--) { /* Horner's scheme */
		for (int k = 13; k >= 0; k--)
			of[k] = (k ? of[k - 1]/20.0 : 0.0) - 2.5*of[k];
		of[0] += c[p];
	}
}

/* The pieces of D 5.2.4 from 30 to 70 s in closed form, as derivatives 3 to 6 vanish at both times:
 * u3' is (1 - tau^2)^6, u2'' (1 - tau^2)^5 times a constant. Their powers 0 to 8 of t have the printed
 * digits; without the others (9 to 12 and 9 to 13), as printed, u3(70) is -1.4e10 m. */
static void printed(const struct hawser_path *path)
{
	static const double print[2][9] = {
		{9703589.0/236.0, -1020973.0/84.0, 2330461.0/1439.0, -406546.0/3163.0, 69323.0/10250.0,
		 -24350.0/98059.0, 1909.0/292879.0, -88.0/714447.0, NAN},
		{-31791879.0/65.0, 19035877.0/124.0, -2719411.0/124.0, 839599.0/445.0, -290133.0/2662.0,
		 119078.0/26689.0, -5991.0/45011.0, 1243.0/424393.0, -215.0/4522888.0}};
	double c[2][14] = {{0.0}}, of[14], sum[2] = {0.0}, choose = 1.0, worst, shape = 0.0, left = 0.0;

	for (int k = 0; k < 7; k++) { /* integrals of the powers of 1 - tau^2 */
		c[1][2*k + 1] = choose/(2*k + 1);
		sum[1] += c[1][2*k + 1];
		choose *= -(6.0 - k)/(k + 1.0);
	}
	choose = 1.0;
	for (int k = 0; k < 6; k++) {
		c[0][2*k + 2] = choose/(2*k + 1)/(2*k + 2);
		sum[0] += choose/(2*k + 1);
		choose *= -(5.0 - k)/(k + 1.0);
	}
	for (int p = 1; p < 14; p++) {
		c[1][p] *= 50.0/sum[1];
		c[0][p] *= -120.0/sum[0];
		left += c[0][p];
	}
	c[0][0] = 100.0 - left;
	c[1][0] = 50.0;
	for (int axis = 0; axis < 2; axis++) {
		expand(of, c[axis]);
		worst = left = 0.0;
		for (int p = 0; p < 9; p++) {
			if (isfinite(print[axis][p])) /* the last one of e2 was not legible */
				worst = fmax(worst, fabs(of[p]/print[axis][p] - 1.0));
			left += of[p]*pow(70.0, p);
		}
		ok(worst < 1e-8, "the printed powers of e%d: %.1e", axis + 2, worst);
		for (double t = 30.0; t <= 70.0; t += 2.385) {
			double tau = (t - 50.0)/20.0, u = 0.0;

			for (int p = 13; p >= 0; p--)
				u = u*tau + c[axis][p];
			shape = fmax(shape, fabs(u - value(path, t, 0, 2*axis)));
		}
	}
	ok(shape < 1e-11, "degrees 12 and 13: %.1e m from the closed forms", shape);
	ok(fabs(left/-1.4e10 - 1.0) < 0.05, "without the powers 9 to 13 u3(70) is -1.4e10 m: %.3e", left);
}

/* D 5.2.4: seven conditions at 30 s and at 70 s. Its first piece has five, its coefficients as
 * printed. */
static void repaired(void)
{
	struct hawser_report report = {0};
	struct hawser_path path;
	struct hawser_waypoint u[2] = {given(at(30.0, 100.0, 0.0), 6), given(at(70.0, 100.0, 100.0), 6)},
		first[2] = {given(at(0.0, 0.0, 0.0), 2), given(at(30.0, 100.0, 0.0), 2)};

	u[0].at[1][0] = first[1].at[1][0] = 6.0;
	u[1].at[1][0] = -6.0;
	if (ok(!hawser_path_waypoints(&path, u, 2, HAWSER_MINIMISE_NOTHING, &report), "D 5.2.4: %s",
	       report.message)) {
		ok(fabs(value(&path, 50.0, 0, 0) - 192.930) < 5e-4, "u2(50) = 192.930: %.6f",
		   value(&path, 50.0, 0, 0));
		ok(fabs(value(&path, 50.0, 1, 2) - 7.3315) < 5e-5, "u3'(50) = 7.3315: %.6f",
		   value(&path, 50.0, 1, 2));
		close_to(value(&path, 70.0, 0, 2), 100.0, 1e-14, "u3(70)");
		printed(&path);
		hawser_path_clear(&path);
	}
	if (ok(!hawser_path_waypoints(&path, first, 2, HAWSER_MINIMISE_NOTHING, &report), "first piece: %s",
	       report.message)) {
		double t = 13.385;

		close_to(value(&path, t, 0, 0), t*t*t*(7.0/675.0 - t/3375.0 + t*t/405000.0), 1e-13,
		         "the printed polynomial of D 5.2.4 up to 30 s");
		hawser_path_clear(&path);
	}
}

/* --- the least integral --- */

enum { NODES = 5, MOST = 40 };

/* Multiply the polynomial [*degree+1] by (t - root), with t in units of the whole time. */
static void times(double *c, int *degree, double root)
{
	c[++*degree] = 0.0;
	for (int p = *degree; p >= 0; p--)
		c[p] = (p ? c[p - 1] : 0.0) - root*c[p];
}

static double derivative(const double *c, int degree, int order, double t)
{
	double sum = 0.0;

	for (int p = degree; p >= order; p--) {
		double factor = c[p];

		for (int k = 0; k < order; k++)
			factor *= p - k;
		sum = sum*t + factor;
	}
	return sum;
}

/* The integral of u^(m) times the m-th derivative of a function that vanishes at all waypoints, and
 * with its derivatives where those are given, over the root of the product of their squares: 0 if u
 * is optimal. */
static double defect(const struct hawser_path *path, const struct hawser_waypoint *u, int m, int power)
{
	static const double node[] = {-0.9324695142031521, -0.6612093864662645, -0.2386191860831969,
	                              0.2386191860831969, 0.6612093864662645, 0.9324695142031521},
	                    weight[] = {0.1713244923791704, 0.3607615730481386, 0.4679139345726910,
	                                0.4679139345726910, 0.3607615730481386, 0.1713244923791704};
	double c[MOST] = {1.0}, sum[3] = {0.0}, whole = u[NODES - 1].t - u[0].t;
	int degree = 0;
	enum { PARTS = 8 };

	for (int i = 0; i < NODES; i++)
		for (int k = 0; k < m && (!k || u[i].given[k]); k++)
			times(c, &degree, (u[i].t - u[0].t)/whole);
	for (; power > 0; power--)
		times(c, &degree, 0.37);
	for (int i = 0; i < PARTS*(NODES - 1); i++) {
		double h = (u[i/PARTS + 1].t - u[i/PARTS].t)/PARTS, from = u[i/PARTS].t + (i%PARTS)*h;

		for (int k = 0; k < 6; k++) {
			double t = from + 0.5*h*(1.0 + node[k]), v = value(path, t, m, 0);
			double d = derivative(c, degree, m, (t - u[0].t)/whole);

			sum[0] += h*weight[k]*v*d;
			sum[1] += h*weight[k]*v*v;
			sum[2] += h*weight[k]*d*d;
		}
	}
	return fabs(sum[0])/sqrt(sum[1]*sum[2]);
}

static void optimal(void)
{
	static const double unit[] = {1e-3, 1.0, 86400.0}; /* s: milliseconds to days */

	for (int minimise = HAWSER_MINIMISE_SNAP; minimise <= HAWSER_MINIMISE_ACCELERATION; minimise++)
		for (int scale = 0; scale < 3; scale++) {
			int m = 4 - minimise;
			double s = unit[scale], largest = 0.0;
			struct hawser_waypoint u[NODES] = {
				at(2.385*s, 1.0, 0.0), at(3.1*s, -2.0, 1.0), at(5.7*s, 4.0, 3.0),
				at(6.9*s, 3.5, -2.0), at(9.3*s, 0.2, 7.0)};
			struct hawser_report report = {0};
			struct hawser_path path;

			u[0].given[1] = u[NODES - 1].given[1] = 1;
			u[0].at[1][0] = 0.8/s;
			u[2].given[1] = 1;
			u[2].at[1][0] = -1.3/s;
			if (m > 2)
				u[NODES - 1].given[2] = 1;
			if (!ok(!hawser_path_waypoints(&path, u, NODES, (enum hawser_minimise)minimise, &report),
			        "least %s: %s", hawser_minimise_name((enum hawser_minimise)minimise),
			        report.message))
				continue;
			for (int power = 0; power < 5; power++)
				largest = fmax(largest, defect(&path, u, m, power));
			ok(largest < 1e-11, "%s in %g s: no neighbour has less: %.1e",
			   hawser_minimise_name(path.minimise), s, largest);
			ok(path.error < 1e-11, "stated error %.1e", path.error);
			close_to(value(&path, u[2].t, 1, 0), -1.3/s, 1e-12, "the given velocity");
			for (int i = 1; i < NODES - 1; i++)
				for (int k = 0; k <= path.smooth && k < ORDERS; k++) {
					double left = value(&path, nextafter(u[i].t, 0.0), k, 2),
					       right = value(&path, u[i].t, k, 2);

					if (fabs(left - right) > 1e-9*(fabs(right) + pow(s, -k)))
						ok(0, "derivative %d jumps at %d: %g, %g", k, i, left, right);
				}
			hawser_path_clear(&path);
		}
}

/* A path is a linear function of its waypoints, and does not depend on the origins of time and
 * place; a motion that has no snap is kept as it is. */
static void invariant(void)
{
	struct hawser_report report = {0};
	struct hawser_path a, b;
	struct hawser_waypoint u[NODES], v[NODES];

	for (int i = 0; i < NODES; i++) {
		double t = 0.7*i + 0.11*i*i;

		u[i] = at(t, 1.0 + t*(2.0 - t*(0.3 - 0.04*t)), sin(3.0*t));
		v[i] = u[i];
		v[i].t += 1000.0;
		v[i].at[0][0] += 5e5;
		v[i].at[0][2] *= -3.0;
	}
	if (!ok(!hawser_path_waypoints(&a, u, NODES, HAWSER_MINIMISE_SNAP, &report) &&
	        !hawser_path_waypoints(&b, v, NODES, HAWSER_MINIMISE_SNAP, &report), "%s", report.message))
		return;
	close_to(value(&a, 2.385, 0, 0), 1.0 + 2.385*(2.0 - 2.385*(0.3 - 0.04*2.385)), 1e-13,
	         "a cubic motion is kept");
	close_to(value(&b, 1002.385, 0, 0) - 5e5, value(&a, 2.385, 0, 0), 1e-9, "another origin of place");
	close_to(value(&b, 1002.385, 3, 2), -3.0*value(&a, 2.385, 3, 2), 1e-9, "linear, and of time");
	hawser_path_clear(&a);
	hawser_path_clear(&b);
}

/* Short and long pieces beside each other: the values at waypoints, and the smoothness, stay. */
static void uneven(void)
{
	for (double ratio = 10.0; ratio < 1e9; ratio *= 100.0) {
		struct hawser_waypoint u[NODES];
		struct hawser_report report = {0};
		struct hawser_path path;
		double t = 0.0, worst = 0.0;
		enum hawser_status status;

		for (int i = 0; i < NODES; i++) {
			u[i] = at(t, sin(1.7*t), cos(t));
			t += i % 2 ? 1.0/ratio : 1.3;
		}
		status = hawser_path_waypoints(&path, u, NODES, HAWSER_MINIMISE_SNAP, &report);
		if (!ok(!status, "durations in the ratio %g: %s", ratio, report.message))
			continue;
		for (int i = 1; i < NODES - 1; i++)
			worst = fmax(worst, fabs(value(&path, nextafter(u[i].t, 0.0), 4, 0) -
			                         value(&path, u[i].t, 4, 0)));
		ok(path.error < 1e-15 && worst < 1e-12*sqrt(path.cost), "stated error %.1e, jump of the "
		   "snap %.1e of %.1e", path.error, worst, sqrt(path.cost));
		hawser_path_clear(&path);
	}
}

/* Derivatives of flights by differences, and the circle's radius. */
static void flights(void)
{
	const double origin[3] = {3.0, -2.0, 1.0}, velocity[3] = {12.0, 1.0, -5.0};
	struct hawser_report report = {0};
	struct hawser_path path[3];
	double h = 1e-4, worst = 0.0;

	if (!ok(!hawser_path_straight(&path[0], origin, velocity, 7.3, HAWSER_PATH_RAMP_SMOOTH, &report) &&
	        !hawser_path_straight(&path[1], origin, velocity, 7.3, HAWSER_PATH_RAMP_ERF, &report) &&
	        !hawser_path_orbit(&path[2], origin, 40.0, -20.0, 7.3, HAWSER_PATH_RAMP_SMOOTH, &report),
	        "%s",
	        report.message))
		return;
	for (int k = 0; k < 3; k++)
		for (double t = 1.1; t < 9.0; t += 0.77)
			for (int order = 1; order < ORDERS; order++)
				for (int axis = 0; axis < 3; axis++) {
					double slope = (value(&path[k], t + h, order - 1, axis) -
					                value(&path[k], t - h, order - 1, axis))/(2.0*h);

					worst = fmax(worst, fabs(slope - value(&path[k], t, order, axis))/
					                    (1.0 + fabs(slope)));
				}
	ok(worst < 1e-6, "derivatives agree with differences: %.1e", worst);
	close_to(hypot(value(&path[2], 20.0, 0, 0) - 3.0, value(&path[2], 20.0, 0, 2) - 1.0), 40.0, 1e-13,
	         "radius");
	close_to(hypot(value(&path[2], 20.0, 2, 0), value(&path[2], 20.0, 2, 2)), 10.0, 1e-13,
	         "V^2/R");
	ok(value(&path[2], 2.0, 0, 2) < 1.0, "a negative speed turns away from z");
}

static void refused(const char *what, const struct hawser_waypoint *u, int count,
                    enum hawser_minimise minimise, const char *text)
{
	struct hawser_report report = {0};
	struct hawser_path path;
	enum hawser_status status = hawser_path_waypoints(&path, u, count, minimise, &report);

	ok(status == HAWSER_ERR_ARGUMENT && strstr(report.message, text) && !path.time, "%s: %s", what,
	   report.message);
}

static void refusals(void)
{
	struct hawser_waypoint u[4] = {at(0.0, 0.0, 0.0), at(1.0, 1.0, 0.0), at(2.0, 0.0, 1.0),
	                               at(3.0, 2.0, 2.0)};

	refused("one", u, 1, HAWSER_MINIMISE_SNAP, "at least 2");
	refused("too few", u, 3, HAWSER_MINIMISE_SNAP, "needs 4 of both");
	u[2].t = 1.0;
	refused("equal times", u, 4, HAWSER_MINIMISE_SNAP, "waypoint 2");
	u[2].t = 0.5;
	refused("decreasing times", u, 4, HAWSER_MINIMISE_NOTHING, "must increase");
	u[2].t = 1.0 + 1e-14;
	refused("times that are too close", u, 4, HAWSER_MINIMISE_SNAP, "too close");
	u[2].t = NAN;
	refused("no number", u, 4, HAWSER_MINIMISE_SNAP, "not a finite number");
	u[2].t = 2.0;
	u[1].at[0][1] = INFINITY;
	refused("infinite", u, 4, HAWSER_MINIMISE_SNAP, "waypoint 1");
	u[1].at[0][1] = 0.0;
	u[1].given[4] = 1;
	refused("a given snap", u, 4, HAWSER_MINIMISE_SNAP, "snap cannot be given");
	refused("a gap", u, 4, HAWSER_MINIMISE_NOTHING, "but no velocity");
	u[1].given[4] = 0;
	u[0].given[3] = u[1].given[3] = 1; /* 4 conditions, and a parabola is free */
	refused("not determined", u, 2, HAWSER_MINIMISE_SNAP, "do not determine");
}

CASE(reference_trajectory)
{
	published();
	repaired();
	optimal();
	invariant();
	uneven();
	flights();
	refusals();
	return done_testing();
}
