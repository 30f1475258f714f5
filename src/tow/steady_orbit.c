/* tow/steady_orbit.c - the steady states of an orbit.
 *
 *   r      radius of the free end about the axis of the orbit
 *   g(r)   radius of the upper end of the cable that is integrated from there, less that of the
 * orbit
 *
 * In the frame that turns with the towing point everything is at rest and symmetric about the axis,
 * so that the free end may be put at [r, 0, 0]: one equation in one unknown, g(r) = 0. On the axis
 * the cable hangs down, g(0) = -R, and from beyond R and its length it does not reach back: there
 * is always a solution. All sign changes on a grid are solutions; of several the one is taken to
 * which the state at rest leads when the speed is raised.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "continuation/false_position.h"
#include "core/report.h"
#include "tow/steady.h"

enum { GRID = 96,      /* places at which g is looked at first */
       TRIES = 60,     /* of false position: it needs 10 */
       SPEEDS = 24,    /* from rest to the speed */
       PARTS = 4 };    /* the mesh of the result: twice the elements */
#define TOLERANCE 1e-13 /* of the radius, relative */
#define JUMP 1e-6       /* the same: with more, a zero is a jump between attitudes of a ring */
#define NARROW 1e-3     /* the same: over a shorter interval of radii the ring hardly turns, and */
#define CLOSE 0.98      /* a turn with a smaller cosine is a jump to another attitude */
#define STRETCHED 1.2  /* the cable is at most so much longer than unstretched */

static const char where[] = "tow steady";

/* *end is the body at the place before, and becomes that at this one. */
static double miss(const struct hawser__tow_frame *frame, double r, struct hawser__tow_end *end,
                   int parts)
{
	double x[3] = {r, 0.0, 0.0}, top[3], n[3];

	if (!hawser__tow_body_near(end, frame, x, parts == 1))
		return NAN;
	hawser__tow_string(top, n, NULL, frame, x, end, parts);
	return hypot(top[0], top[2]) - frame->tow->path.radius;
}

/* Between two places of different signs; *end is the body at a, and becomes that at the zero. */
static double zero(const struct hawser__tow_frame *frame, double a, double b,
                   struct hawser__tow_end *end)
{
	struct hawser__bracketed in = {.a = a, .b = b};
	double scale = frame->tow->path.radius, r = a, f;

	in.fa = f = miss(frame, a, end, PARTS);
	in.fb = miss(frame, b, end, PARTS);
	if ((in.fa < 0.0) == (in.fb < 0.0)) /* the coarse mesh of the grid saw one that is not there */
		return NAN;
	for (int i = 0; i < TRIES && in.b - in.a > TOLERANCE*scale; i++) {
		double before[3];

		memcpy(before, end->axis, sizeof before);
		r = hawser__false_position(&in, i);
		f = miss(frame, r, end, PARTS);
		if (in.b - in.a < NARROW*scale && frame->tow->body.kind == HAWSER_TOW_RING &&
		    hawser__dot(before, end->axis) < CLOSE)
			return NAN;
		if (!(fabs(f) > TOLERANCE*scale))
			return f == f ? r : NAN;
		hawser__false_position_take(&in, r, f);
	}
	return fabs(f) < JUMP*scale ? r : NAN;
}

static double reach(const struct hawser_tow *tow)
{
	double length = 0.0;

	for (int i = 0; i < tow->segments; i++)
		length += tow->segment[i].length;
	return tow->path.radius + STRETCHED*length;
}

/* A solution: the radius, and the body there. */
struct root {
	double r;
	struct hawser__tow_end end;
};

/* All solutions on the grid, in ascending order, on a mesh of half the elements times `parts`. */
static int seen(struct root *root, const struct hawser__tow_frame *frame, int parts)
{
	struct hawser__tow_end end = {.residual = 0.0}, last;
	double far = reach(frame->tow), before = 0.0, value = miss(frame, 0.0, &end, parts);
	int found = 0;

	for (int i = 1; i <= GRID; i++) {
		double r = far*i/GRID, next;

		last = end;
		next = miss(frame, r, &end, parts);
		if (value == value && next == next && (value < 0.0) != (next < 0.0) &&
		    found < HAWSER_TOW_STATES) {
			root[found] = (struct root){.end = last};
			root[found].r = zero(frame, before, r, &root[found].end);
			found += root[found].r == root[found].r;
		}
		before = r;
		value = next;
	}
	return found;
}

/* Where elements are longer than the orbit is wide, the coarse mesh sees none that is there. */
static int all(struct root *root, const struct hawser__tow_frame *frame)
{
	int found = seen(root, frame, 1);

	return found ? found : seen(root, frame, PARTS);
}

/* The solution to which the state at rest leads: the nearest to the one before, as the speed grows. */
static int from_rest(const struct root *root, int roots, const struct hawser__tow_frame *frame)
{
	struct hawser__tow_frame slow = *frame;
	double r = frame->tow->path.radius;
	int best = 0;

	for (int k = 1; k < SPEEDS; k++) {
		struct root other[HAWSER_TOW_STATES];
		double nearest = NAN;
		int count;

		slow.spin = frame->spin*k/SPEEDS;
		count = all(other, &slow);
		for (int i = 0; i < count; i++)
			if (!(fabs(other[i].r - r) >= fabs(nearest - r)))
				nearest = other[i].r;
		if (nearest == nearest)
			r = nearest;
	}
	for (int i = 1; i < roots; i++)
		if (fabs(root[i].r - r) < fabs(root[best].r - r))
			best = i;
	return best;
}

static struct hawser_tow_state describe(const struct hawser__tow_frame *frame, const struct root *root)
{
	double x[3] = {root->r, 0.0, 0.0}, top[3], n[3], angle;

	hawser__tow_string(top, n, NULL, frame, x, &root->end, PARTS);
	angle = atan2(top[2], top[0]);
	return (struct hawser_tow_state){.radius = root->r, .depth = top[1],
	                                 .tension_top = hawser__norm(n),
	                                 .lag = frame->tow->path.speed < 0.0 ? -angle : angle};
}

enum hawser_status hawser__tow_orbit(struct hawser_tow_steady *steady,
                                     struct hawser__tow_frame *frame, double end[3],
                                     struct hawser__tow_end *body, struct hawser_report *report)
{
	struct root root[HAWSER_TOW_STATES];
	int roots, chosen;

	/* a positive speed turns x toward z, which is a negative rotation about y */
	frame->spin = -frame->tow->path.speed/frame->tow->path.radius;
	roots = all(root, frame);
	if (!roots)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, where, "no steady state was found in "
		                    "the orbit of %.6g m at %.6g m/s, among radii of the free end up to "
		                    "%.6g m: give cable.segments.elements more; is the speed plausible?",
		                    frame->tow->path.radius, frame->tow->path.speed, reach(frame->tow));
	chosen = roots > 1 ? from_rest(root, roots, frame) : 0;
	for (int i = 0; i < roots; i++)
		if (i != chosen)
			steady->other[steady->others++] = describe(frame, &root[i]);
	steady->state = describe(frame, &root[chosen]);
	*body = root[chosen].end;
	end[0] = root[chosen].r;
	end[1] = end[2] = 0.0;
	return HAWSER_OK;
}
