/* beam/boundary_follow.c - one piece of a stability boundary, by the operations of
 * continuation/curve.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "beam/boundary.h"
#include "continuation/curve.h"
#include "core/grow.h"
#include "core/report.h"

#define BESIDE 1e-5     /* relative offset in speed of the two counts of growing modes */
#define WORST_ANGLE 0.2 /* rad between successive tangents */
#define ANY_ANGLE 1e-3  /* relative step (of the range) below which any angle is accepted */
#define CORNER 2e-4     /* relative step at which a piece ends at a corner */
#define FIRST_STEP 0.25 /* fraction of the longest step */

/* --- points --- */

enum hawser_status hawser__boundary_keep(struct hawser__boundary_work *work,
                                         const struct hawser_beam_boundary_point *point,
                                         struct hawser_report *report)
{
	struct hawser_beam_boundary *boundary = work->boundary;

	if (boundary->points >= work->most)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "beam",
		                    "%d points were not enough for the boundary", work->most);
	if (hawser__more(&boundary->point, boundary->points, sizeof *boundary->point))
		return hawser__no_memory(report, "beam");
	boundary->point[boundary->points++] = *point;
	return HAWSER_OK;
}

/* Number of growing modes at v; for v_bif, number of real pairs. */
static enum hawser_status count(int *number, struct hawser__boundary_work *work,
                                const struct hawser_beam *beam, double v,
                                struct hawser_report *report)
{
	struct hawser__beam_sample sample;
	enum hawser_status status = hawser__beam_sample(&sample, work->is, beam, v,
	                                                work->options->modes, report);

	if (status)
		return status;
	*number = work->options->bifurcation ? sample.real : sample.growing;
	hawser__beam_sample_clear(&sample);
	return HAWSER_OK;
}

enum hawser_status hawser__boundary_point(struct hawser_beam_boundary_point *point, int *good,
                                          struct hawser__boundary_work *work, const double *u,
                                          struct hawser_report *report)
{
	const struct hawser__onset_equation *e = &work->equation;
	struct hawser_beam beam;
	double v = fabs(u[1]*e->scale[1]);
	enum hawser_status status = work->family->at(&beam, work->family->context, u[0]*e->scale[0],
	                                             report);

	if (status)
		return status;
	*point = (struct hawser_beam_boundary_point){.parameter = u[0]*e->scale[0], .speed = v,
		.im = e->onset == HAWSER__AXIS ? fabs(u[2])*e->scale[2] : 0.0,
		.re = e->onset == HAWSER__DOUBLE ? u[2]*e->scale[2] : 0.0,
		.per_speed = beam.time > 0.0 ? beam.length/beam.time : 1.0,
		.cause = e->onset == HAWSER__AXIS ? HAWSER_BEAM_FLUTTERS : HAWSER_BEAM_DIVERGES,
		.piece = work->boundary->pieces};
	status = count(&point->growing[0], work, &beam, v*(1.0 - BESIDE), report);
	if (!status)
		status = count(&point->growing[1], work, &beam, v*(1.0 + BESIDE), report);
	*good = point->growing[0] == 0 && point->growing[1] > 0;
	return status;
}

const double hawser__along_parameter[3] = {1.0, 0.0, 0.0}, hawser__along_speed[3] = {0.0, 1.0, 0.0};

/* Set one unknown to `value` and correct the others. */
static enum hawser_status move_to(struct hawser__boundary_work *work, double *u, int unknown,
                                  double value, struct hawser_report *report)
{
	const double *along = unknown ? hawser__along_speed : hawser__along_parameter;
	int iterations;

	u[unknown] = value;
	return hawser__onset_correct(&work->equation, u, along, &iterations, report);
}

/* State of the continuation of one piece. */
struct walk {
	struct hawser__boundary_work *work;
	double u[3], tangent[3], next[3], turn[3]; /* current and next: point, tangent */
	int at_end;     /* 1: next is at an end of the range; 2: next is at speed 0 */
	double reached; /* last parameter at which the piece is known */
	enum hawser__boundary_end end;
	struct hawser_beam_boundary_point point; /* the point at next */
	struct hawser_report *report;
};

static enum hawser_status prepare(void *owner, int *ended)
{
	struct walk *walk = owner;

	*ended = 0;
	walk->reached = walk->u[0]*walk->work->range;
	return HAWSER_OK;
}

static int predict(void *owner, double ds)
{
	struct walk *walk = owner;

	for (int k = 0; k < 3; k++)
		walk->next[k] = walk->u[k] + ds*walk->tangent[k];
	return 0;
}

/* Correct the prediction. If it lies beyond the range or below speed 0, move it to that limit. Then
 * compute the tangent. */
static enum hawser_status correct(void *owner, double ds, struct hawser__correction *correction,
                                  int *failed)
{
	struct walk *walk = owner;
	struct hawser__boundary_work *work = walk->work;
	double low = work->low/work->range, high = work->high/work->range, *next = walk->next;

	(void)ds;
	*correction = (struct hawser__correction){0};
	*failed = 1;
	if (hawser__onset_correct(&work->equation, next, walk->tangent, &correction->iterations,
	                          walk->report))
		return HAWSER_OK;
	walk->at_end = next[0] > high || next[0] < low ? 1 : next[1] < 0.0 ? 2 : 0;
	if (walk->at_end == 1 && move_to(work, next, 0, next[0] > high ? high : low, walk->report))
		return HAWSER_OK;
	if (walk->at_end == 2 && move_to(work, next, 1, 0.0, walk->report))
		return HAWSER_OK;
	*failed = hawser__onset_tangent(&work->equation, walk->turn, next, walk->report) != HAWSER_OK;
	return HAWSER_OK;
}

static enum hawser_status finish(void *owner, double ds, double *angle)
{
	struct walk *walk = owner;
	double cosine = 0.0;

	(void)ds;
	for (int k = 0; k < 3; k++)
		cosine += walk->turn[k]*walk->tangent[k];
	for (int k = 0; k < 3 && cosine < 0.0; k++)
		walk->turn[k] = -walk->turn[k];
	*angle = acos(fmin(1.0, fabs(cosine)));
	return HAWSER_OK;
}

static enum hawser_status judge(void *owner, double ds, double angle, enum hawser__verdict *verdict)
{
	struct walk *walk = owner;
	struct hawser__boundary_work *work = walk->work;
	int good;
	enum hawser_status status;

	*verdict = HAWSER__SHORTEN;
	if (angle > WORST_ANGLE && ds > ANY_ANGLE && !walk->at_end)
		return HAWSER_OK;
	status = hawser__boundary_point(&walk->point, &good, work, walk->next, walk->report);
	if (status)
		return status;
	/* beyond w = 0 the curve retraces itself, because the conjugate pair has become real */
	good = good && !(work->equation.onset == HAWSER__AXIS && walk->next[2]*walk->u[2] <= 0.0 &&
	                 walk->at_end != 2);
	walk->end = walk->at_end == 2 ? HAWSER__SPEED_ENDS : !good ? HAWSER__OVERTAKEN
	             : walk->at_end == 1 ? HAWSER__RANGE_ENDS : HAWSER__GOES_ON;
	if (walk->end != HAWSER__OVERTAKEN || ds <= CORNER)
		*verdict = HAWSER__KEEP;
	return HAWSER_OK;
}

static double longest(void *owner)
{
	return ((const struct walk *)owner)->work->longest;
}

static enum hawser_status arrive(void *owner, enum hawser__arrival *arrival, double taken, double *ds)
{
	struct walk *walk = owner;

	(void)taken;
	(void)ds;
	memcpy(walk->u, walk->next, sizeof walk->u);
	memcpy(walk->tangent, walk->turn, sizeof walk->tangent);
	*arrival = walk->end == HAWSER__GOES_ON ? HAWSER__GO_ON : HAWSER__AT_END;
	if (walk->end == HAWSER__RANGE_ENDS || walk->end == HAWSER__SPEED_ENDS)
		walk->reached = walk->u[0]*walk->work->range;
	return walk->end == HAWSER__OVERTAKEN ? HAWSER_OK :
	       hawser__boundary_keep(walk->work, &walk->point, walk->report);
}

static const struct hawser__curve_ops boundary_ops = {
	.prepare = prepare, .predict = predict, .correct = correct, .finish = finish, .judge = judge,
	.longest = longest, .arrive = arrive
};

enum hawser_status hawser__boundary_follow(enum hawser__boundary_end *end, double *reached,
                                           struct hawser__boundary_work *work, const double *start,
                                           double sign, struct hawser_report *report)
{
	struct walk walk = {.work = work, .u = {start[0], start[1], start[2]}, .report = report};
	struct hawser__curve curve = {.ops = &boundary_ops, .settings = &hawser__boundary_steps,
		.owner = &walk, .ds = FIRST_STEP*work->longest};
	enum hawser__outcome outcome = HAWSER__ENDED;
	enum hawser_status status = hawser__onset_tangent(&work->equation, walk.tangent, walk.u, report);
	double sense = walk.tangent[0]*sign < 0.0 ? -1.0 : 1.0;

	for (int k = 0; k < 3; k++)
		walk.tangent[k] *= sense;
	if (!status)
		status = hawser__curve_follow(&curve, &outcome);
	*end = outcome == HAWSER__LOST ? HAWSER__PIECE_LOST : walk.end;
	*reached = walk.reached;
	return status;
}
