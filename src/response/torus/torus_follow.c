/* response/torus/torus_follow.c - see hawser/torus.h: the operations of continuation/curve.h for
 * invariant circles.
 *
 *    y       x [N][m], rho, Omega of a circle, or the parameter of the family
 *    metric  x relative to the size of each component, with the mean over the circle; rho in rad; the
 *            last one relative to the range
 *
 * A circle is predicted on the tangent. Its points are as many as its error requires: where the error
 * between the points is too large, the circle is interpolated at more of them and corrected again.
 * Circles on which the motion locks in (rho/(2 pi) rational) are no solutions of the equations; a
 * resonance whose range of Omega is narrower than the tolerance is passed without notice, a wider one
 * ends the curve.
 *
 * Near a torus point the circle is a multiple of the eigenvector, and its multiples of both signs are
 * the same circle, shifted by half a turn. The curve passes through the torus point smoothly and comes
 * back on the same circles. Its end is where the circle changes its sign.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "continuation/metric.h"
#include "core/progress.h"
#include "core/report.h"
#include "response/torus/torus.h"

#define WHERE "tori"
#define MORE 1.4 /* factor of the number of points where there are too few; chosen */
#define FLOOR 0.05 /* least size of a component in the metric, relative to the state; chosen */
#define FIRST_STEP 0.02 /* chosen */
#define LARGEST_STEP 0.1 /* chosen */
#define WORST_ANGLE 0.5 /* rad, between successive tangents; chosen */
#define WORST_CONTRACTION 0.7 /* chosen */
#define BESIDE 0.02 /* of the range: distance of the extrapolated end from a torus point; chosen */
#define STALL 12 /* circles on which the curve hardly goes on; chosen */
#define STALLED 0.01 /* length of the curve that they have, at least; chosen */
#define ORDER 20 /* of resonances that are named; chosen */
#define CLOSE 2e-3 /* of rho/(2 pi) to a resonance that is named; chosen */
/* Sizes of the first circle, relative to the orbit. */
static const double first_size[] = {0.02, 0.005, 0.05, 0.1, 1e-3};

struct walk {
	struct hawser__torus torus;
	const struct hawser_rom *rom;
	const struct hawser_frf *frf;
	struct hawser_tori_options options;
	struct hawser_tori *list;
	struct hawser__torus_ruler *ruler;
	struct hawser_report *report;
	struct hawser__metric metric;
	double *weight, *here, *t, *next, *turn, *work; /* [most m + 2] */
	double *exponent;      /* [m] */
	double arc, began;
	int stop;              /* 1: the caller asked for the end, 2: too many points are needed, 3: the
	                        * steps have become so short that no end is seen */
};

/* --- circles --- */

static void load(struct walk *walk, const double *y)
{
	struct hawser__torus *torus = &walk->torus;
	int Nm = torus->points*torus->m;

	memcpy(torus->x, y, (size_t)Nm*sizeof *y);
	torus->rho = y[Nm];
	torus->place = y[Nm + 1];
}

static void store(const struct walk *walk, double *y)
{
	const struct hawser__torus *torus = &walk->torus;
	int Nm = torus->points*torus->m;

	memcpy(y, torus->x, (size_t)Nm*sizeof *y);
	y[Nm] = torus->rho;
	y[Nm + 1] = torus->place;
}

/* Product of the deviations of two circles from their means, divided by their number of points. */
static double product(const struct walk *walk, const double *a, const double *b)
{
	int N = walk->torus.points, m = walk->torus.m;
	double sum = 0.0;

	for (int j = 0; j < m; j++) {
		double p = 0.0, q = 0.0, r = 0.0;

		for (int i = 0; i < N; i++) {
			p += a[i*m + j]/N;
			q += b[i*m + j]/N;
			r += a[i*m + j]*b[i*m + j]/N;
		}
		sum += r - p*q;
	}
	return sum;
}

static void weigh(struct walk *walk, const double *y)
{
	int N = walk->torus.points, m = walk->torus.m;
	double all = cblas_dnrm2(N*m, y, 1)/sqrt((double)N*m);
	double range = fabs(walk->options.to - walk->options.from);

	for (int j = 0; j < m; j++) {
		double size = fmax(FLOOR*all, cblas_dnrm2(N, y + j, m)/sqrt(N));

		for (int i = 0; i < N; i++)
			walk->weight[i*m + j] = 1.0/(size*size*N*m);
	}
	walk->weight[N*m] = 1.0;
	walk->weight[N*m + 1] = 1.0/(range*range);
	walk->metric = (struct hawser__metric){walk->torus.size, walk->weight};
}

/* More points or steps; 0 if the circle is as good as it must be, -1 if it cannot be made better. */
static int improve(struct walk *walk)
{
	struct hawser__torus *torus = &walk->torus;
	int N = torus->points, m = torus->m, more = (int)(MORE*N) | 1;

	hawser__torus_judge(torus);
	if (torus->period_error > torus->mesh) {
		torus->steps += torus->steps/2;
		return 1;
	}
	if (torus->defect <= walk->options.tolerance)
		return 0;
	more = more > torus->most ? torus->most : more;
	if (more <= N)
		return -1;
	hawser__torus_resample(walk->here, walk->work, m, N, more);
	hawser__torus_resample(walk->t, walk->work, m, N, more);
	store(walk, walk->next);
	hawser__torus_resample(walk->next, walk->work, m, N, more);
	hawser__torus_points(torus, more);
	load(walk, walk->next);
	weigh(walk, walk->here);
	return 1;
}

/* The first circle, of the given size, and its tangent. */
static enum hawser_status first(struct walk *walk, const double *x0, double place, double size)
{
	struct hawser__torus *torus = &walk->torus;
	double largest = 0.0;
	enum hawser_status status;
	int again;

	for (int j = 0; j < torus->m; j++)
		largest = fmax(largest, fabs(x0[j]));
	hawser__torus_points(torus, HAWSER_TORUS_FIRST < torus->most ? HAWSER_TORUS_FIRST : torus->most);
	if ((status = hawser__torus_begin(torus, x0, place, size*largest, walk->report)))
		return status;
	do {
		if ((status = hawser__torus_correct(torus, 1, walk->report)))
			return status;
		again = improve(walk);
	} while (again > 0);
	if (again < 0)
		return hawser__fail_at(walk->report, HAWSER_ERR_CONVERGENCE, WHERE, torus->iterations,
		                       torus->defect, "the first torus beside it needs more than %d points "
		                       "of its circle (error %.1e)", torus->points, torus->defect);
	store(walk, walk->here);
	weigh(walk, walk->here);
	if (hawser__torus_tangent(torus, walk->t))
		return hawser__fail(walk->report, HAWSER_ERR_CONVERGENCE, WHERE,
		                    "the circles beside it have no tangent");
	cblas_dscal(torus->size, 1.0/hawser__metric_length(&walk->metric, walk->t), walk->t, 1);
	/* hawser__torus_tangent has overwritten nothing but the matrix */
	return HAWSER_OK;
}

/* Point of the present circle. *slack is 1 where it is not recorded, since the cable would be slack. */
static enum hawser_status record(struct walk *walk, int *slack)
{
	struct hawser__torus *torus = &walk->torus;
	struct hawser_tori *list = walk->list;
	struct hawser_tori_point *point;
	int i = list->points;
	struct hawser_progress_state state;

	*slack = 0;
	if (hawser__tori_room(list, walk->rom) ||
	    hawser__torus_growth(torus, walk->exponent, &list->point[i].growth_error) ||
	    hawser__torus_measure(walk->ruler, list, i, torus))
		return hawser__no_memory(walk->report, WHERE);
	point = &list->point[i];
	*slack = walk->options.end_at_slack && list->tension && list->tension[2*i] < 0.0;
	if (*slack)
		return HAWSER_OK;
	*point = (struct hawser_tori_point){.omega = torus->omega, .parameter = torus->place,
		.rotation = torus->rho, .second = torus->rho*torus->omega/(2.0*M_PI),
		.growth = walk->exponent[0], .growth_error = point->growth_error, .arc = walk->arc,
		.size = sqrt(product(walk, torus->x, torus->x)), .residual = torus->residual,
		.error = torus->defect, .tail = torus->tail, .circle = torus->points,
		.steps = torus->steps, .iterations = torus->iterations};
	for (int k = 0; k < torus->m - 1; k++) {
		point->unstable += walk->exponent[k] > point->growth_error;
		point->undecided += fabs(walk->exponent[k]) <= point->growth_error;
	}
	memcpy(list->state + (size_t)i*(size_t)torus->m, torus->x, (size_t)torus->m*sizeof *torus->x);
	list->points++;
	state = hawser__progress_state("tori", "circles", list->points, walk->began);
	state.omega = torus->omega/torus->flow.rom->time;
	if (i >= STALL && walk->arc - list->point[i - STALL].arc < STALLED)
		walk->stop = 3;
	if (hawser__told_to_stop(&walk->options.progress, &state))
		walk->stop = 1;
	return HAWSER_OK;
}

/* --- the operations of a step --- */

static enum hawser_status prepare(void *owner, int *ended)
{
	struct walk *walk = owner;

	*ended = walk->list->points >= walk->options.max_points;
	if (*ended)
		walk->list->end = HAWSER_TORI_MAX_POINTS;
	weigh(walk, walk->here);
	return HAWSER_OK;
}

static int interrupted(void *owner, int tries)
{
	(void)tries;
	return ((struct walk *)owner)->stop;
}

static int predict(void *owner, double ds)
{
	struct walk *walk = owner;

	for (int k = 0; k < walk->torus.size; k++)
		walk->next[k] = walk->here[k] + ds*walk->t[k];
	return !walk->options.family && !(walk->next[walk->torus.size - 1] > 0.0);
}

static enum hawser_status correct(void *owner, double ds, struct hawser__correction *correction,
                                  int *failed)
{
	struct walk *walk = owner;
	struct hawser__torus *torus = &walk->torus;

	(void)ds;
	load(walk, walk->next);
	hawser__torus_guess(torus);
	for (int k = 0; k < torus->size; k++)
		torus->row[k] = walk->weight[k]*walk->t[k];
	*failed = hawser__torus_newton(torus, correction, walk->weight) ||
	          correction->contraction > WORST_CONTRACTION;
	return HAWSER_OK;
}

static enum hawser_status finish(void *owner, double ds, double *angle)
{
	struct walk *walk = owner;
	struct hawser__torus *torus = &walk->torus;

	(void)ds;
	store(walk, walk->next);
	if (hawser__torus_tangent(torus, walk->turn))
		memcpy(walk->turn, walk->t, (size_t)torus->size*sizeof *walk->t);
	cblas_dscal(torus->size, 1.0/hawser__metric_length(&walk->metric, walk->turn), walk->turn, 1);
	*angle = hawser__metric_angle(&walk->metric, walk->turn, walk->t);
	return HAWSER_OK;
}

static enum hawser_status judge(void *owner, double ds, double angle, enum hawser__verdict *verdict)
{
	struct walk *walk = owner;
	int better;

	(void)ds;
	*verdict = HAWSER__SHORTEN;
	if (angle > WORST_ANGLE)
		return HAWSER_OK;
	better = improve(walk);
	if (better < 0)
		walk->stop = 2;
	*verdict = better > 0 ? HAWSER__REPEAT : better < 0 ? HAWSER__SHORTEN : HAWSER__KEEP;
	return HAWSER_OK;
}

static double longest(void *owner)
{
	const struct walk *walk = owner;
	double range = fabs(walk->options.to - walk->options.from);
	double pace = fabs(walk->turn[walk->torus.size - 1])/range;

	return fmin(LARGEST_STEP, walk->options.step_max/fmax(pace, 1e-12));
}

/* The torus point that the circles shrink to, from the last two that were recorded. */
static void name_end(struct walk *walk)
{
	struct hawser_tori *list = walk->list;
	const struct hawser_tori_point *p = list->point + list->points - 1, *o = p - 1;
	double a = p->size*p->size, b, to = p->parameter, range = walk->options.to - walk->options.from;
	double nearest = BESIDE*fabs(range);

	if (list->points > 1 && (b = o->size*o->size) != a)
		to += a*(o->parameter - p->parameter)/(a - b);
	list->end = HAWSER_TORI_TORUS_POINT;
	list->to = -1;
	for (int e = 0; e < walk->frf->events; e++) {
		const struct hawser_frf_event *event = &walk->frf->event[e];

		if (event->kind != HAWSER_TORUS || !event->located || !(fabs(event->parameter - to) < nearest))
			continue;
		nearest = fabs(event->parameter - to);
		list->to = e;
	}
	list->to_at = list->to < 0 ? to : walk->frf->event[list->to].parameter;
}

/* The circle at the bound that the step has passed; *failed where it is not found. */
static enum hawser_status at_bound(struct walk *walk, double bound, int *failed)
{
	struct hawser__torus *torus = &walk->torus;
	int size = torus->size;
	double from = walk->here[size - 1], part = (bound - from)/(walk->next[size - 1] - from);
	struct hawser__correction did;

	for (int k = 0; k < size; k++)
		walk->next[k] = walk->here[k] + part*(walk->next[k] - walk->here[k]);
	load(walk, walk->next);
	hawser__torus_guess(torus);
	memset(torus->row, 0, (size_t)size*sizeof *torus->row);
	torus->row[size - 1] = 1.0;
	*failed = hawser__torus_newton(torus, &did, NULL);
	if (!*failed)
		hawser__torus_judge(torus);
	return HAWSER_OK;
}

static enum hawser_status arrive(void *owner, enum hawser__arrival *arrival, double taken, double *ds)
{
	struct walk *walk = owner;
	struct hawser_tori *list = walk->list;
	int size = walk->torus.size, slack = 0, failed = 0, out;
	double place = walk->next[size - 1];
	double lo = fmin(walk->options.from, walk->options.to);
	double hi = fmax(walk->options.from, walk->options.to);
	enum hawser_status status = HAWSER_OK;

	(void)ds;
	*arrival = HAWSER__AT_END;
	if (product(walk, walk->here, walk->next) < 0.0) {
		name_end(walk);
		return HAWSER_OK;
	}
	walk->arc += taken;
	out = place < lo || place > hi;
	if (out) {
		list->end = HAWSER_TORI_RANGE;
		status = at_bound(walk, place < lo ? lo : hi, &failed);
	}
	if (!status && !failed)
		status = record(walk, &slack);
	if (slack)
		list->end = HAWSER_TORI_SLACK;
	if (status || out || slack)
		return status;
	*arrival = HAWSER__GO_ON;
	memcpy(walk->here, walk->next, (size_t)size*sizeof *walk->next);
	memcpy(walk->t, walk->turn, (size_t)size*sizeof *walk->t);
	return HAWSER_OK;
}

static const struct hawser__curve_ops circle_ops = {
	.prepare = prepare, .interrupted = interrupted, .predict = predict, .correct = correct,
	.finish = finish, .judge = judge, .longest = longest, .arrive = arrive
};

/* --- the curve --- */

/* ", near the resonance 2/5" or nothing: the fraction of the lowest order near rho/(2 pi). Where the
 * motion hardly turns, a circle comes near an unstable periodic motion and stays there ever longer. */
static void name_resonance(char text[160], double rho)
{
	double turns = rho/(2.0*M_PI);

	text[0] = '\0';
	if (fabs(remainder(turns, 1.0)) < CLOSE)
		snprintf(text, 160, "; its second period, %.0f periods of the load, grows as near a homoclinic "
		         "motion of an unstable periodic one", fabs(1.0/remainder(turns, 1.0)));
	for (int q = 2; q <= ORDER && !*text; q++)
		if (fabs(turns - round(turns*q)/q) < CLOSE/q)
			snprintf(text, 160, ", near the resonance %.0f/%d", round(turns*q), q);
}

static enum hawser_status follow(struct walk *walk)
{
	struct hawser_tori *list = walk->list;
	struct hawser__curve curve = {.ops = &circle_ops, .settings = &hawser__torus_steps,
	                              .owner = walk, .ds = FIRST_STEP};
	const struct hawser__torus *torus = &walk->torus;
	char resonance[160];
	enum hawser__outcome outcome;
	enum hawser_status status;
	int slack;

	if ((status = record(walk, &slack)))
		return status;
	if (slack) {
		list->end = HAWSER_TORI_SLACK;
		return HAWSER_OK;
	}
	memcpy(walk->turn, walk->t, (size_t)torus->size*sizeof *walk->t);
	status = hawser__curve_follow(&curve, &outcome);
	if (status || outcome == HAWSER__ENDED)
		return status;
	name_resonance(resonance, list->point[list->points - 1].rotation);
	list->end = walk->stop == 2 ? HAWSER_TORI_ROUGH
	            : walk->stop == 1 ? HAWSER_TORI_INTERRUPTED : HAWSER_TORI_LOST;
	if (list->end == HAWSER_TORI_ROUGH)
		snprintf(list->lost, sizeof list->lost, "%d points of the circle leave an error of %.1e: it "
		         "breaks or locks in%s", torus->points, torus->defect, resonance);
	else if (list->end == HAWSER_TORI_LOST)
		snprintf(list->lost, sizeof list->lost, "the steps become ever shorter: the circle "
		         "breaks or locks in%s", resonance);
	return HAWSER_OK;
}

static enum hawser_status open(struct walk *walk, double omega)
{
	int m = 2*walk->rom->n, most = HAWSER_TORUS_NUMBERS/m;
	size_t room;
	enum hawser_status status;

	most = most < walk->options.most_circle ? most : walk->options.most_circle;
	most -= most % 2 == 0;
	room = (size_t)most*(size_t)m + 2;
	walk->weight = calloc(6*room + (size_t)m, sizeof *walk->weight);
	walk->ruler = hawser__torus_ruler_new(walk->rom);
	if (!walk->weight || !walk->ruler)
		return hawser__no_memory(walk->report, WHERE);
	walk->here = walk->weight + room;
	walk->t = walk->here + room;
	walk->next = walk->t + room;
	walk->turn = walk->next + room;
	walk->work = walk->turn + room;
	walk->exponent = walk->work + room;
	status = hawser__torus_room(&walk->torus, walk->rom, most, most, omega, walk->report);
	walk->torus.mesh = 0.01*walk->options.tolerance;
	walk->torus.family = walk->options.family;
	walk->torus.extent = fabs(walk->options.to - walk->options.from);
	return status;
}

enum hawser_status hawser_tori_trace(struct hawser_tori *tori, const struct hawser_rom *rom,
                                     const struct hawser_frf *frf, int event,
                                     const struct hawser_tori_options *options,
                                     struct hawser_report *report)
{
	struct walk walk = {.rom = rom, .frf = frf, .options = *options, .list = tori, .report = report,
	                    .began = hawser__wall_seconds()};
	size_t m = 2*(size_t)rom->n;
	enum hawser_status status;

	*tori = (struct hawser_tori){.n = rom->n, .probes = rom->shapes.points, .length = rom->length,
		.time = rom->time, .curve = 1, .branch = frf->branch, .from = event, .to = -1, .to_at = NAN};
	hawser_tori_settle(&walk.options);
	if ((status = hawser__tori_check(rom, frf, event, &walk.options, report)))
		return status;
	tori->from_at = frf->event[event].parameter;
	status = open(&walk, frf->event[event].omega);
	for (size_t k = 0; !status && k < sizeof first_size/sizeof *first_size; k++) {
		status = first(&walk, frf->event_state + (size_t)event*m, tori->from_at, first_size[k]);
		if (status != HAWSER_ERR_CONVERGENCE || k + 1 == sizeof first_size/sizeof *first_size)
			break;
		status = HAWSER_OK;
	}
	if (!status)
		status = follow(&walk);
	hawser__torus_clear(&walk.torus);
	hawser__torus_ruler_free(walk.ruler);
	free(walk.weight);
	return status;
}
