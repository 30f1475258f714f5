/* tow/trajectory.c - paths through waypoints: what may be given, and the value at a time.
 *
 *   tau    time within a piece, -1 at its first waypoint and 1 at its second: the digits of a result do
 *          not depend on the unit of time
 *   h      duration of a piece; d/dt = (2/h) d/dtau
 *   u      position; the first waypoint is subtracted before the solution, so that large coordinates
 *          (of a map) cost no digits
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/names.h"
#include "core/order.h"
#include "core/report.h"
#include "tow/trajectory.h"

/* A duration must be at least this part of the times themselves: of the 16 digits of a time, 6 are then
 * left for the duration. */
#define CLOSEST 1e-10
#define ERROR 1e-6 /* relative; beyond it the solution is refused */

static const char *const order_name[HAWSER_PATH_GIVEN] = {
	"position", "velocity", "acceleration", "jerk", "snap", "derivative 5", "derivative 6"};

HAWSER__NAMES(hawser_minimise_name, enum hawser_minimise, "snap", "jerk", "acceleration", "none")

HAWSER__NAMES(hawser_path_name, enum hawser_path_kind, "waypoints", "straight", "orbit")

void hawser__trajectory_row(double *row, int degree, int order, double tau)
{
	double power = 1.0;

	for (int p = 0; p <= degree; p++) {
		double factor = 1.0;

		if (p < order) {
			row[p] = 0.0;
			continue;
		}
		for (int k = 0; k < order; k++)
			factor *= p - k;
		row[p] = factor*power;
		power *= tau;
	}
}

/* --- what may be given --- */

static enum hawser_status fail(struct hawser_report *report, int index, const char *text,
                               double first, double second)
{
	return hawser__fail_at(report, HAWSER_ERR_ARGUMENT, "trajectory", index, 0.0, text, index, first,
	                       second);
}

static enum hawser_status check_point(const struct hawser_waypoint *point, int i, int m,
                                      struct hawser_report *report)
{
	const struct hawser_waypoint *one = &point[i];
	double before = i ? point[i - 1].t : 0.0;

	if (!isfinite(one->t))
		return fail(report, i, "the time of waypoint %d is not a finite number", 0.0, 0.0);
	for (int k = 0; k < HAWSER_PATH_GIVEN; k++)
		for (int axis = 0; axis < 3 && (!k || one->given[k]); axis++)
			if (!isfinite(one->at[k][axis]))
				return hawser__fail_at(report, HAWSER_ERR_ARGUMENT, "trajectory", i, 0.0,
				                       "waypoint %d: a component of its %s is not a finite number",
				                       i, order_name[k]);
	if (i && one->t <= before)
		return fail(report, i, "the time of waypoint %d is %.10g s, but the waypoint before it is "
		            "at %.10g s: times must increase", one->t, before);
	if (i && one->t - before < CLOSEST*fmax(fabs(one->t), fabs(before)))
		return fail(report, i, "waypoint %d at %.17g s is too close to the one before it at %.17g "
		            "s for the digits of these numbers: count time from a later origin", one->t,
		            before);
	for (int k = m; k < HAWSER_PATH_GIVEN && m; k++)
		if (one->given[k])
			return hawser__fail_at(report, HAWSER_ERR_ARGUMENT, "trajectory", i, 0.0,
			                       "waypoint %d: its %s cannot be given where the %s is minimised: "
			                       "leave it out, or minimise none", i, order_name[k],
			                       order_name[m]);
	return HAWSER_OK;
}

/* Derivatives without a gap, where nothing is minimised. */
static enum hawser_status check_gap(const struct hawser_waypoint *point, int i,
                                    struct hawser_report *report)
{
	for (int k = hawser__waypoint_orders(point); k < HAWSER_PATH_GIVEN; k++)
		if (point->given[k])
			return hawser__fail_at(report, HAWSER_ERR_ARGUMENT, "trajectory", i, 0.0,
			                       "waypoint %d has a given %s but no %s: give both, or minimise "
			                       "snap, jerk or acceleration", i, order_name[k],
			                       order_name[hawser__waypoint_orders(point)]);
	return HAWSER_OK;
}

static enum hawser_status check(const struct hawser_waypoint *point, int count, int m,
                                struct hawser_report *report)
{
	int conditions = count;
	enum hawser_status status = HAWSER_OK;

	if (count < 2)
		return hawser__fail_at(report, HAWSER_ERR_ARGUMENT, "trajectory", -1, 0.0,
		                       "a path needs at least 2 waypoints, and %d is given", count);
	for (int i = 0; i < count && !status; i++) {
		status = check_point(point, i, m, report);
		if (!status && !m)
			status = check_gap(&point[i], i, report);
		for (int k = 1; k < HAWSER_PATH_GIVEN; k++)
			conditions += point[i].given[k];
	}
	if (!status && conditions < m)
		return hawser__fail_at(report, HAWSER_ERR_ARGUMENT, "trajectory", -1, 0.0,
		                       "%d waypoints with %d given derivatives do not determine a path of "
		                       "least %s, which needs %d of both: give more waypoints, or ends "
		                       "such as [velocity, acceleration]", count, conditions - count,
		                       order_name[m], m);
	return status;
}

/* --- after the solution --- */

/* The integral over a piece of the squared derivative of order m. */
static double piece_cost(const double *c, int degree, int m, double h)
{
	double row[HAWSER__TRAJECTORY_DEGREE + 1], sum = 0.0;

	hawser__trajectory_row(row, degree, m, 1.0);
	for (int p = m; p <= degree; p++)
		for (int q = m; q <= degree; q++)
			if ((p + q) % 2 == 0)
				sum += row[p]*c[p]*row[q]*c[q]*2.0/(p + q - 2*m + 1);
	return sum*pow(2.0/h, 2*m - 1);
}

static double cost(const struct hawser_path *of, int m)
{
	double sum = 0.0;

	for (int i = 0; i < 3*of->pieces; i++)
		sum += piece_cost(&of->coefficient[i*(of->degree + 1)], of->degree, m,
		                  of->time[i/3 + 1] - of->time[i/3]);
	return sum;
}

/* Derivatives that are continuous because of what is minimised, or because both pieces have them. */
static int smooth(const struct hawser_waypoint *point, int count, int m)
{
	int least = m ? 2*m - 2 : HAWSER_PATH_GIVEN - 1;

	for (int i = 1; i < count - 1; i++) {
		if (!m && hawser__waypoint_orders(&point[i]) - 1 < least)
			least = hawser__waypoint_orders(&point[i]) - 1;
		for (int k = 1; k < m; k++) /* a force at the waypoint, that holds a given derivative */
			if (point[i].given[k] && 2*m - 2 - k < least)
				least = 2*m - 2 - k;
	}
	return least;
}

static enum hawser_status room(struct hawser_path *of, const struct hawser_waypoint *point,
                               int count, int degree, struct hawser_report *report)
{
	of->pieces = count - 1;
	of->degree = degree;
	of->time = calloc((size_t)count, sizeof *of->time);
	of->coefficient = calloc((size_t)of->pieces*3*((size_t)degree + 1), sizeof *of->coefficient);
	if (!of->time || !of->coefficient)
		return hawser__no_memory(report, "trajectory");
	for (int i = 0; i < count; i++)
		of->time[i] = point[i].t;
	of->from = point[0].t;
	of->to = point[count - 1].t;
	memcpy(of->origin, point[0].at[0], sizeof of->origin);
	return HAWSER_OK;
}

enum hawser_status hawser_path_waypoints(struct hawser_path *trajectory,
                                               const struct hawser_waypoint *point, int count,
                                               enum hawser_minimise minimise,
                                               struct hawser_report *report)
{
	int m = minimise == HAWSER_MINIMISE_NOTHING ? 0 : 4 - (int)minimise;
	enum hawser_status status;

	memset(trajectory, 0, sizeof *trajectory);
	trajectory->minimise = minimise;
	status = check(point, count, m, report);
	if (!status)
		status = room(trajectory, point, count, m ? 2*m - 1 : HAWSER__TRAJECTORY_DEGREE, report);
	if (!status)
		status = m ? hawser__trajectory_solve(trajectory, point, m, report)
		           : hawser__trajectory_pieces(trajectory, point, report);
	if (!status && !(trajectory->error < ERROR))
		status = hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "trajectory", -1, trajectory->error,
		                         "the path through %d waypoints has an estimated relative error of "
		                         "%.1e by round-off: their times are too unevenly spaced; leave "
		                         "out some of those that are close together", count, trajectory->error);
	if (!status) {
		trajectory->smooth = smooth(point, count, m);
		trajectory->cost = cost(trajectory, m ? m : 4);
	}
	if (status)
		hawser_path_clear(trajectory);
	return status;
}

/* --- values --- */

/* The piece that contains t. */
static void piece_at(double (*state)[3], const struct hawser_path *of, double t)
{
	int i = hawser__interval(of->time, of->pieces, t), n = of->degree + 1;
	double h = of->time[i + 1] - of->time[i];
	double tau = 2.0*(t - of->time[i])/h - 1.0, per = 1.0; /* exact at both ends */

	for (int k = 0; k < HAWSER_PATH_ORDERS; k++, per *= 2.0/h) {
		double row[HAWSER__TRAJECTORY_DEGREE + 1];

		hawser__trajectory_row(row, of->degree, k, tau);
		for (int axis = 0; axis < 3; axis++) {
			const double *c = &of->coefficient[(3*i + axis)*n];
			double sum = 0.0;

			for (int p = of->degree; p >= k; p--)
				sum += row[p]*c[p];
			state[k][axis] = sum*per + (k ? 0.0 : of->origin[axis]);
		}
	}
}

static void straight_at(double (*state)[3], const struct hawser_path *of, double t)
{
	double s[HAWSER_PATH_ORDERS] = {t, 1.0}, T = of->ramp_time, per = T > 0.0 ? T : 1.0;

	if (T > 0.0)
		hawser__ramp(s, of->ramp, t/T);
	for (int k = 0; k < HAWSER_PATH_ORDERS; k++, per /= T > 0.0 ? T : 1.0)
		for (int axis = 0; axis < 3; axis++)
			state[k][axis] = (k ? 0.0 : of->origin[axis]) + of->velocity[axis]*(s[k]*per);
}

/* With e = (cos, sin) of the angle and n its derivative by the angle; w: derivatives of the angle. */
static void orbit_at(double (*state)[3], const struct hawser_path *of, double t)
{
	double s[HAWSER_PATH_ORDERS] = {t, 1.0}, T = of->ramp_time, per = T > 0.0 ? T : 1.0;
	double w[HAWSER_PATH_ORDERS], along[HAWSER_PATH_ORDERS],
	       across[HAWSER_PATH_ORDERS], e[2];

	if (T > 0.0)
		hawser__ramp(s, of->ramp, t/T);
	for (int k = 0; k < HAWSER_PATH_ORDERS; k++, per /= T > 0.0 ? T : 1.0)
		w[k] = of->speed/of->radius*s[k]*per;
	e[0] = cos(w[0]);
	e[1] = sin(w[0]);
	along[0] = 1.0;
	across[0] = 0.0;
	along[1] = 0.0;
	across[1] = w[1];
	along[2] = -w[1]*w[1];
	across[2] = w[2];
	along[3] = -3.0*w[1]*w[2];
	across[3] = w[3] - w[1]*w[1]*w[1];
	along[4] = w[1]*w[1]*w[1]*w[1] - 4.0*w[1]*w[3] - 3.0*w[2]*w[2];
	across[4] = w[4] - 6.0*w[1]*w[1]*w[2];
	for (int k = 0; k < HAWSER_PATH_ORDERS; k++) {
		state[k][0] = of->radius*(along[k]*e[0] - across[k]*e[1]);
		state[k][1] = 0.0;
		state[k][2] = of->radius*(along[k]*e[1] + across[k]*e[0]);
	}
	for (int axis = 0; axis < 3; axis++)
		state[0][axis] += of->origin[axis];
}

enum hawser_status hawser_path_at(double (*state)[3], const struct hawser_path *trajectory,
                                        double t, struct hawser_report *report)
{
	if (!(t >= trajectory->from && t <= trajectory->to))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "trajectory", "the path is defined from "
		                    "%.10g to %.10g s, and not at %.10g s", trajectory->from,
		                    trajectory->to, t);
	if (trajectory->kind == HAWSER_PATH_WAYPOINTS)
		piece_at(state, trajectory, t);
	else if (trajectory->kind == HAWSER_PATH_STRAIGHT)
		straight_at(state, trajectory, t);
	else
		orbit_at(state, trajectory, t);
	return HAWSER_OK;
}

void hawser_path_clear(struct hawser_path *trajectory)
{
	if (!trajectory)
		return;
	free(trajectory->time);
	free(trajectory->coefficient);
	memset(trajectory, 0, sizeof *trajectory);
}
