/* tow/steady.c - the steady state of a towed body: straight flight, and what follows from a
 * solution.
 *
 * In straight flight the free end may be anywhere: the cable is integrated from the origin, and
 * moved so that it begins at the towing point.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "tow/steady.h"

static const char where[] = "tow steady";
enum { SINKS = 100 }; /* iterations for the depth: without a current over the depth 2 */
#define LEVEL 1e-12 /* of the cable's length: of the depth */
#define SEGMENTS (4.0/3.0) /* the error of a ring over its change: 8/7 for order 3, with a margin */
#define ROUND_OFF 1e-9 /* of the depth of water, by which a point may be below its bed */
#define COARSE 1e-3 /* of the cable's length: a mesh error beyond it is no result */

static enum hawser_status check(const struct hawser_tow *tow, struct hawser_report *report)
{
	double weight = tow->body.mass;

	if (tow->path.kind == HAWSER_PATH_WAYPOINTS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "a path through waypoints has no "
		                    "steady state: give tow.speed or tow.orbit");
	if (!tow->segments)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "the scene has no cable: add, for "
		                    "example, cable: {segments: [{length: 14 m, rho: 58 g/m, diameter: 8 "
		                    "mm, drag: {normal: 1.2}}]}");
	for (int i = 0; i < tow->segments; i++)
		weight += tow->segment[i].rho;
	if (weight == 0.0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "cable and body have no mass, so "
		                    "that nothing holds them down: give a body, or cable.segments.rho");
	if (tow->path.kind == HAWSER_PATH_ORBIT && (tow->wind[0] != 0.0 || tow->wind[2] != 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "an orbit in a horizontal wind has "
		                    "no steady state: the flow changes along the circle; leave air.wind "
		                    "out, or give a vertical one");
	if (tow->path.kind == HAWSER_PATH_ORBIT && tow->path.speed != 0.0 && tow->water.density > 0.0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "the steady state of an orbit in water "
		                    "is not known: give tow.ramp, with which a motion begins at rest and comes "
		                    "to it, or tow.speed");
	return HAWSER_OK;
}

/* In water: the height of the axes of the frame, in which the free end is at 0, by the height of the
 * towing point. */
static enum hawser_status sink(struct hawser__tow_frame *frame, const double end[3],
                               struct hawser__tow_end *body, struct hawser_report *report)
{
	double top[3], n[3], change = INFINITY, length = 0.0, part = 1.0;

	for (int i = 0; i < frame->tow->segments; i++)
		length += frame->tow->segment[i].length;
	frame->lift = frame->tow->path.origin[1];
	for (int i = 0; i < SINKS; i++) {
		double before = fabs(change);

		(void)hawser__tow_body_at(body, frame, end);
		hawser__tow_string(top, n, NULL, frame, end, body, 4);
		change = frame->tow->path.origin[1] - top[1] - frame->lift;
		if (fabs(change) <= LEVEL*length)
			return HAWSER_OK;
		part *= fabs(change) > 0.5*before ? 0.7 : 1.0;
		frame->lift += part*change;
	}
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, where, SINKS, change/length, "the depth of "
	                       "the free end was not found: it changes by %.2g m from one iteration to the "
	                       "next; lines or bodies that float on the surface have none here", change);
}

static enum hawser_status straight(struct hawser__tow_frame *frame, double end[3],
                                   struct hawser__tow_end *body, struct hawser_report *report)
{
	memcpy(frame->velocity, frame->tow->path.velocity, sizeof frame->velocity);
	memset(end, 0, 3*sizeof *end);
	if (!hawser__tow_body_at(body, frame, end))
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, where, 0, body->residual,
		                       "the attitude of the ring was not found (moment %.1e of offset "
		                       "times force): give body.ring.segments more than %d", body->residual,
		                       frame->tow->body.ring.segments ? frame->tow->body.ring.segments
		                                                      : HAWSER_RING_SEGMENTS);
	return frame->tow->water.density > 0.0 ? sink(frame, end, body, report) : HAWSER_OK;
}

/* --- from a solution --- */

/* The largest distance of a point in the finer of two shapes, both seen from the towing point. */
static double change(const struct hawser_tow_point *coarse, const struct hawser_tow_point *fine,
                     int points)
{
	double largest = 0.0;

	for (int i = 0; i < points; i++) {
		double one[3];

		for (int k = 0; k < 3; k++)
			one[k] = (coarse[i].x[k] - coarse[0].x[k]) - (fine[i].x[k] - fine[0].x[k]);
		largest = fmax(largest, hawser__norm(one));
	}
	return largest;
}

/* 1 if the cable is a rod: with EI. */
static int bends(const struct hawser__tow_frame *frame)
{
	int stiff = 0;

	for (int i = 0; i < frame->tow->segments; i++)
		stiff |= frame->tow->segment[i].EI > 0.0;
	return stiff;
}

/* The cable from its free end, and as a rod from there; on a mesh and one of twice the elements. */
static enum hawser_status meshes(struct hawser_tow_steady *steady, struct hawser_tow_point *coarse,
                                 struct hawser__tow_end *body, const struct hawser__tow_frame *frame,
                                 const double end[3], struct hawser_report *report)
{
	struct hawser__tow_end other = *body;
	double top[3], n[3];
	enum hawser_status status = HAWSER_OK;

	hawser__tow_string(top, n, coarse, frame, end, body, 2);
	hawser__tow_string(top, n, steady->point, frame, end, body, 4);
	steady->bent = bends(frame);
	if (steady->bent) {
		status = hawser__tow_bend(coarse, &other, frame, steady->point, 1, report);
		if (!status)
			status = hawser__tow_bend(steady->point, body, frame, coarse, 2, report);
	}
	steady->raised = steady->bent ? body->raised : 0;
	steady->mesh_error = change(coarse, steady->point, steady->points);
	for (int k = 0; k < 3 && steady->bent && frame->tow->body.kind == HAWSER_TOW_RING; k++)
		steady->mesh_error = fmax(steady->mesh_error, frame->tow->body.offset*
		                          fabs(other.axis[k] - body->axis[k]));
	return status;
}

static double length_of(const struct hawser_tow *tow)
{
	double length = 0.0;

	for (int i = 0; i < tow->segments; i++)
		length += tow->segment[i].length;
	return length;
}

/* What is known when the points are: errors, and where the body is. */
static enum hawser_status judge(struct hawser_tow_steady *steady,
                                const struct hawser__tow_frame *frame,
                                const struct hawser__tow_end *body, struct hawser_report *report)
{
	const struct hawser_tow *tow = frame->tow;
	const struct hawser_tow_point *top = steady->point, *last = top + steady->points - 1;
	int ring = tow->body.kind == HAWSER_TOW_RING;

	for (int i = 0; i < steady->points; i++)
		if (!isfinite(top[i].x[0] + top[i].x[1] + top[i].x[2] + top[i].tension))
			return hawser__fail(report, HAWSER_ERR_NAN, where, "a number of the steady state is beyond "
			                    "double precision: are the values of the scene plausible?");
	if (steady->mesh_error > COARSE*length_of(tow))
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, where, steady->points - 1,
		                       steady->mesh_error, "%d elements are too few: halving them moves a "
		                       "point by %.3g m; give cable.segments.elements more", steady->points - 1,
		                       steady->mesh_error);
	steady->residual = body->residual;
	if (frame->spin != 0.0)
		steady->residual = fmax(body->residual, fabs(hypot(top->x[0], top->x[2]) - tow->path.radius)/
		                                        length_of(tow));
	memcpy(steady->axis, ring ? body->axis : last->along, sizeof steady->axis);
	for (int k = 0; k < 3; k++)
		steady->centre[k] = last->x[k] + (ring ? tow->body.offset*body->axis[k] : 0.0);
	memcpy(steady->body_force, body->force, sizeof body->force);
	return HAWSER_OK;
}

static enum hawser_status shape(struct hawser_tow_steady *steady, const struct hawser__tow_frame *frame,
                                const double end[3], struct hawser__tow_end *body,
                                struct hawser_report *report)
{
	struct hawser_tow_point *coarse;
	enum hawser_status status = HAWSER_OK;

	steady->points = hawser__tow_elements(frame->tow) + 1;
	steady->point = calloc((size_t)steady->points, sizeof *steady->point);
	coarse = calloc((size_t)steady->points, sizeof *coarse);
	if (!steady->point || !coarse)
		status = hawser__no_memory(report, where);
	else
		status = meshes(steady, coarse, body, frame, end, report);
	free(coarse);
	return status ? status : judge(steady, frame, body, report);
}

/* Turn about y, x toward z by -angle, then move. */
static void place(double x[3], double angle, const double move[3])
{
	double from = x[0];

	x[0] = cos(angle)*from + sin(angle)*x[2] + move[0];
	x[1] += move[1];
	x[2] = -sin(angle)*from + cos(angle)*x[2] + move[2];
}

/* Put the solution where the towing point is at its start. */
static void move(struct hawser_tow_steady *steady, const struct hawser__tow_frame *frame)
{
	const struct hawser_path *path = &frame->tow->path;
	const double *top = steady->point[0].x, *end = steady->point[steady->points - 1].x;
	const double still[3] = {0.0};
	double angle = frame->spin != 0.0 ? atan2(top[2], top[0]) : 0.0, by[3], lag;

	for (int k = 0; k < 3; k++)
		by[k] = path->origin[k] - (frame->spin != 0.0 && k != 1 ? 0.0 : top[k]);
	if (path->kind == HAWSER_PATH_ORBIT && frame->spin == 0.0)
		by[0] += path->radius;
	/* of a rod the end is no longer at [r, 0, 0] */
	lag = frame->spin == 0.0 ? 0.0
	      : atan2(top[2]*end[0] - top[0]*end[2], top[0]*end[0] + top[2]*end[2]);
	if (frame->spin != 0.0)
		steady->state.radius = hypot(end[0], end[2]);
	for (int i = 0; i < steady->points; i++) {
		place(steady->point[i].x, angle, by);
		place(steady->point[i].along, angle, still);
	}
	place(steady->centre, angle, by);
	place(steady->axis, angle, still);
	place(steady->body_force, angle, still);
	steady->state.lag = path->speed < 0.0 ? -lag : lag;
}

enum hawser_status hawser__tow_above_bed(const struct hawser_tow *tow, double y, double s, double t,
                                         const char *stage, struct hawser_report *report)
{
	const struct hawser_water *water = &tow->water;
	double bed = water->surface - water->depth;
	char what[40] = "the body", when[40] = "";

	if (!(water->density > 0.0 && water->depth > 0.0 && y < bed - ROUND_OFF*water->depth))
		return HAWSER_OK;
	if (!isnan(s))
		snprintf(what, sizeof what, "the cable at s = %.6g m", s);
	if (!isnan(t))
		snprintf(when, sizeof when, "at %.6g s ", t);
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, stage, "%s%s is at y = %.6g m, below the bed "
	                    "of the water, surface - depth = %.6g m, and a tow does not touch it: give a "
	                    "shorter cable, a lighter body, a higher speed, or water.depth at its "
	                    "deepest place", when, what, y, bed);
}

/* Where it has been put: the cable and the body above the bed of the water. */
static enum hawser_status above_bed(const struct hawser_tow_steady *steady,
                                    const struct hawser_tow *tow, struct hawser_report *report)
{
	enum hawser_status status = hawser__tow_above_bed(tow, steady->centre[1], NAN, NAN, where, report);

	for (int i = 0; i < steady->points && !status; i++)
		status = hawser__tow_above_bed(tow, steady->point[i].x[1], steady->point[i].s, NAN, where,
		                               report);
	return status;
}

/* The rotation that turns -y into the axis, without twist. */
static void turned(struct hawser_tow_steady *steady, const struct hawser__tow_frame *frame)
{
	const double *a = steady->axis, *v = frame->tow->path.velocity;
	double side = hypot(a[0], a[2]), angle = atan2(side, -a[1]);
	double ahead = frame->tow->path.kind == HAWSER_PATH_ORBIT
	               ? (frame->tow->path.speed < 0.0 ? -a[2] : a[2])
	               : hypot(v[0], v[2]) > 0.0 ? a[0]*v[0] + a[2]*v[2] : a[0];

	steady->tilt = ahead > 0.0 ? angle : -angle;
	steady->attitude[0] = cos(0.5*angle);
	steady->attitude[1] = side > 0.0 ? -a[2]/side*sin(0.5*angle) : 0.0;
	steady->attitude[2] = 0.0;
	steady->attitude[3] = side > 0.0 ? a[0]/side*sin(0.5*angle) : 0.0;
	steady->rotation[0] = side > 0.0 ? -a[2]/side*angle : 0.0;
	steady->rotation[1] = 0.0;
	steady->rotation[2] = side > 0.0 ? a[0]/side*angle : 0.0;
	if (side == 0.0)
		steady->tilt = angle;
}

static void numbers(struct hawser_tow_steady *steady, const struct hawser__tow_frame *frame)
{
	const struct hawser_tow *tow = frame->tow;
	const struct hawser_tow_point *last = &steady->point[steady->points - 1];
	double from = 0.0;
	int at = 0;

	memcpy(steady->end, last->x, sizeof steady->end);
	steady->tension_top = steady->point[0].tension;
	steady->tension_end = last->tension;
	steady->state.tension_top = steady->tension_top;
	steady->state.depth = steady->point[0].x[1] - last->x[1];
	steady->spin = frame->spin;
	for (int i = 0; i < tow->segments; i++) {
		from += tow->segment[i].length;
		for (; at < steady->points && steady->point[at].s <= from; at++)
			if (tow->segment[i].EI > 0.0 && steady->point[at].tension > 0.0)
				steady->bending = fmax(steady->bending,
				                       sqrt(tow->segment[i].EI/steady->point[at].tension));
	}
}

enum hawser_status hawser__tow_rod_start(struct hawser__tow_rod *b, struct hawser__tow_frame *frame,
                                         struct hawser__tow_end *body, const struct hawser_tow *tow,
                                         int parts, struct hawser_report *report)
{
	struct hawser_tow_steady orbit = {.points = 0};
	struct hawser_tow_point *string;
	double end[3], top[3], n[3];
	enum hawser_status status = check(tow, report);

	*frame = (struct hawser__tow_frame){.tow = tow};
	*b = (struct hawser__tow_rod){.frame = frame, .moves = 1,
	                              .hung = hawser__tow_hangs(tow) ? body : NULL};
	if (!status && tow->path.kind == HAWSER_PATH_ORBIT && tow->path.speed != 0.0)
		status = hawser__tow_orbit(&orbit, frame, end, body, report);
	else if (!status)
		status = straight(frame, end, body, report);
	if (status)
		return status;
	string = calloc((size_t)hawser__tow_elements(tow) + 1, sizeof *string);
	if (!string)
		return hawser__no_memory(report, where);
	hawser__tow_string(top, n, string, frame, end, body, 2);
	status = hawser__tow_rod_solve(b, string, parts, body, report);
	free(string);
	return status;
}

static enum hawser_status solve(struct hawser_tow_steady *steady, const struct hawser_tow *tow,
                                struct hawser_report *report)
{
	struct hawser__tow_frame frame = {.tow = tow};
	struct hawser__tow_end body;
	double end[3];
	enum hawser_status status;

	memset(steady, 0, sizeof *steady);
	status = check(tow, report);
	if (!status && tow->path.kind == HAWSER_PATH_ORBIT && tow->path.speed != 0.0)
		status = hawser__tow_orbit(steady, &frame, end, &body, report);
	else if (!status)
		status = straight(&frame, end, &body, report);
	if (!status)
		status = shape(steady, &frame, end, &body, report);
	if (!status) {
		move(steady, &frame);
		turned(steady, &frame);
		numbers(steady, &frame);
		status = above_bed(steady, tow, report);
	}
	if (status)
		hawser_tow_steady_clear(steady);
	return status;
}

/* What twice the segments of a ring change: points, the body's force and its axis. The drag of a
 * ring is of order 3 in them, which leaves 1/7 of the change. */
static enum hawser_status ring(struct hawser_tow_steady *steady, const struct hawser_tow *tow,
                               struct hawser_report *report)
{
	struct hawser_tow twice = *tow;
	struct hawser_tow_steady fine;
	struct hawser_report own;
	double force[3], axis[3], centre[3];
	enum hawser_status status;

	twice.body.ring.segments = 2*(tow->body.ring.segments > 0 ? tow->body.ring.segments
	                                                          : HAWSER_RING_SEGMENTS);
	status = solve(&fine, &twice, &own);
	steady->ring_error = NAN;
	if (!status) {
		for (int k = 0; k < 3; k++) {
			force[k] = fine.body_force[k] - steady->body_force[k];
			axis[k] = fine.axis[k] - steady->axis[k];
			centre[k] = fine.centre[k] - steady->centre[k];
		}
		steady->ring_error = SEGMENTS*fmax(hawser__norm(force)/hawser__norm(steady->body_force),
		                                   hawser__norm(axis));
		steady->mesh_error += SEGMENTS*fmax(change(steady->point, fine.point, steady->points),
		                                    hawser__norm(centre));
	}
	hawser_tow_steady_clear(&fine);
	return status == HAWSER_ERR_MEMORY ? hawser__no_memory(report, where) : HAWSER_OK;
}

enum hawser_status hawser_tow_steady_solve(struct hawser_tow_steady *steady,
                                           const struct hawser_tow *tow, struct hawser_report *report)
{
	enum hawser_status status = solve(steady, tow, report);

	if (!status && tow->body.kind == HAWSER_TOW_RING)
		status = ring(steady, tow, report);
	if (status)
		hawser_tow_steady_clear(steady);
	return status;
}

void hawser_tow_steady_clear(struct hawser_tow_steady *steady)
{
	if (!steady)
		return;
	free(steady->point);
	memset(steady, 0, sizeof *steady);
}
