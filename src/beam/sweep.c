/* beam/sweep.c - eigenvalues along the speed, branches, and every change of stability.
 *
 * Branches are followed by bi-orthogonal correlation (sample.h). A step is halved in four cases:
 *
 *   - a branch has no partner with a clear correlation;
 *   - a real part, as a cubic through both ends with its slopes, would become positive inside the
 *     step although it is not positive at either end;
 *   - a pair leaves the real axis or reaches it, so that the curves are resolved there;
 *   - two frequencies of an undamped beam whose modes have energies of opposite signs exchange their
 *     order: where such frequencies coincide there is flutter, if only between two close speeds.
 *
 * Changes of the number of growing modes are bracketed between neighbouring samples (sample.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "beam/sample.h"
#include "core/grow.h"
#include "core/names.h"
#include "core/report.h"

#define CLEAR 0.6          /* smallest share (of a row's sum) of a clear partner */
#define SMALLEST 1e-4      /* smallest step, relative to the range */
#define SMALLEST_TURN 2e-3 /* smallest step at which a pair leaves or reaches the real axis */
#define SMALLEST_MEETING 1e-7 /* the same if two frequencies of opposite energies exchange their
                               * order: half of the digits */
#define NOTHING 1e-9       /* largest ratio of real to imaginary part that is round-off */
enum {
	SPARE = 4,       /* pairs beyond the branches, to replace those that leave */
	MOST_SOLVES = 20 /* largest number of solutions per requested sample */
};

struct work {
	struct hawser_beam_sweep *sweep;
	const struct hawser_beam_integrals *is;
	const struct hawser_beam *beam;
	const struct hawser_beam_sweep_options *options;
	struct hawser__beam_sample *stop; /* [stops] */
	int *at;       /* [stops][branches] pair of a branch */
	int stops, branches, watched;
	double *share; /* [pairs][pairs] */
	size_t shares;
};

static enum hawser_status solve(struct hawser__beam_sample *stop, struct work *work, double speed,
                                struct hawser_report *report)
{
	if (work->sweep->solves++ > MOST_SOLVES*work->options->points + 400)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "beam",
		                    "%d eigenvalue problems were not enough for the speeds from %g to %g, the "
		                    "last one at %.12g: choose a smaller range, or fewer modes",
		                    work->sweep->solves, work->options->from, work->options->to, speed);
	return hawser__beam_sample(stop, work->is, work->beam, speed, work->watched, report);
}

/* --- branches --- */

static enum hawser_status share_room(struct work *work, size_t need, struct hawser_report *report)
{
	double *more;

	if (need <= work->shares)
		return HAWSER_OK;
	more = realloc(work->share, need*sizeof *more);
	if (!more)
		return hawser__no_memory(report, "beam");
	work->share = more;
	work->shares = need;
	return HAWSER_OK;
}

/* Assign partners in descending order of correlation. *least is the smallest share. */
static enum hawser_status match(int *to, double *least, struct work *work,
                                const struct hawser__beam_sample *a, const int *from,
                                const struct hawser__beam_sample *b, struct hawser_report *report)
{
	int taken[256] = {0}, done[256] = {0}, many = b->pairs < 256 ? b->pairs : 256;
	enum hawser_status status = share_room(work, (size_t)a->pairs*(size_t)b->pairs, report);

	if (!status)
		status = hawser__beam_correlate(work->share, a, b, work->is, work->beam, report);
	*least = 1.0;
	for (int turn = 0; !status && turn < work->branches; turn++) {
		double best = -1.0;
		int branch = 0, partner = 0;

		for (int k = 0; k < work->branches; k++)
			for (int p = 0; !done[k] && p < many; p++) {
				/* NOLINTNEXTLINE(clang-analyzer-core.NullDereference): share_room made it */
				double share = work->share[(size_t)from[k]*(size_t)b->pairs + (size_t)p];

				if (!taken[p] && share > best) {
					best = share;
					branch = k;
					partner = p;
				}
			}
		done[branch] = taken[partner] = 1;
		to[branch] = partner;
		*least = fmin(*least, best);
	}
	return status;
}

/* Maximum over the step of the cubic with these end values and slopes. */
static double crest(double a, double da, double b, double db, double h)
{
	double most = fmax(a, b);

	for (int i = 1; i < 16; i++) {
		double t = i/16.0, u = 1.0 - t;

		most = fmax(most, a*u*u*(1.0 + 2.0*t) + b*t*t*(3.0 - 2.0*t) + h*t*u*(da*u - db*t));
	}
	return most;
}

static int may_grow(const struct work *work, const struct hawser__beam_sample *a, const int *from,
                    const struct hawser__beam_sample *b, const int *to)
{
	double h = b->speed - a->speed;

	for (int k = 0; k < work->branches; k++) {
		const struct hawser__beam_pair *pa = &a->pair[from[k]], *pb = &b->pair[to[k]];

		if (pa->growing || pb->growing || pa->re[0] == 0.0 || pb->re[0] == 0.0)
			continue;
		if (crest(pa->re[0], pa->slope_re, pb->re[0], pb->slope_re, h) > NOTHING*pb->im)
			return 1;
	}
	return 0;
}

/* 1 if a pair is complex conjugate at one end of the step and real at the other. */
static int turns(const struct work *work, const struct hawser__beam_sample *a, const int *from,
                 const struct hawser__beam_sample *b, const int *to)
{
	for (int k = 0; k < work->branches; k++)
		if ((a->pair[from[k]].im == 0.0) != (b->pair[to[k]].im == 0.0))
			return 1;
	return 0;
}

/* 1 if two frequencies of opposite energies exchange their order. */
static int may_meet(const struct work *work, const struct hawser__beam_sample *a, const int *from,
                    const struct hawser__beam_sample *b, const int *to)
{
	for (int k = 0; k < work->branches; k++)
		for (int m = 0; m < k; m++) {
			const struct hawser__beam_pair *ka = &a->pair[from[k]], *ma = &a->pair[from[m]];
			const struct hawser__beam_pair *kb = &b->pair[to[k]], *mb = &b->pair[to[m]];

			if (ka->energy*ma->energy < 0 && kb->energy*mb->energy < 0 &&
			    (ka->im - ma->im)*(kb->im - mb->im) < 0.0)
				return 1;
		}
	return 0;
}

static enum hawser_status append(struct work *work, struct hawser__beam_sample *stop, const int *at,
                                 struct hawser_report *report)
{
	size_t b = (size_t)work->branches;

	if (hawser__more(&work->stop, work->stops, sizeof *work->stop) ||
	    hawser__more(&work->at, work->stops, b*sizeof *work->at)) {
		hawser__beam_sample_clear(stop);
		return hawser__no_memory(report, "beam");
	}
	memcpy(work->at + (size_t)work->stops*b, at, b*sizeof *at);
	work->stop[work->stops++] = *stop;
	return HAWSER_OK;
}

/* Follow the branches from the last sample to `goal`, with as many steps as needed. Takes ownership
 * of `goal`. */
static enum hawser_status reach(struct work *work, struct hawser__beam_sample *goal,
                                struct hawser_report *report)
{
	double range = fabs(work->options->to - work->options->from);
	enum hawser_status status = HAWSER_OK;

	while (!status) {
		struct hawser__beam_sample *last = &work->stop[work->stops - 1], half;
		const int *from = work->at + (size_t)(work->stops - 1)*(size_t)work->branches;
		double step = fabs(goal->speed - last->speed), least;
		int to[256], unclear, small = step <= SMALLEST*range;

		status = match(to, &least, work, last, from, goal, report);
		if (status)
			break;
		unclear = (least < CLEAR && !work->options->loose) || may_grow(work, last, from, goal, to);
		if ((!unclear || small) &&
		    (step <= SMALLEST_TURN*range || work->options->loose || !turns(work, last, from, goal,
		            to)) &&
		    (!may_meet(work, last, from, goal, to) ||
		     step <= SMALLEST_MEETING*range)) {
			work->sweep->unsure += least < CLEAR;
			work->sweep->least_correlation = fmin(work->sweep->least_correlation, least);
			return append(work, goal, to, report);
		}
		status = solve(&half, work, 0.5*(last->speed + goal->speed), report);
		half.inserted = 1;
		if (!status)
			status = reach(work, &half, report);
	}
	/* NOLINTNEXTLINE(clang-analyzer-unix.Malloc): the stops kept are cleared with `work` */
	hawser__beam_sample_clear(goal);
	return status;
}

static enum hawser_status follow(struct work *work, struct hawser_report *report)
{
	const struct hawser_beam_sweep_options *options = work->options;
	enum hawser_status status = HAWSER_OK;
	int at[256];

	for (int i = 0; !status && i < options->points; i++) {
		double t = i/(options->points - 1.0);
		struct hawser__beam_sample stop;

		status = solve(&stop, work, options->from + t*(options->to - options->from), report);
		if (status)
			break;
		if (i > 0) {
			status = reach(work, &stop, report);
			continue;
		}
		if (work->branches > stop.pairs)
			work->branches = stop.pairs;
		for (int k = 0; k < work->branches; k++)
			at[k] = k;
		status = append(work, &stop, at, report);
	}
	return status;
}

/* --- events --- */

static enum hawser_beam_event_kind kind_of(const struct hawser__beam_change *change)
{
	if (change->after < change->before)
		return HAWSER_BEAM_CALM;
	return change->im > 0.0 ? HAWSER_BEAM_FLUTTER : HAWSER_BEAM_DIVERGENCE;
}

static enum hawser_status add_event(struct hawser_beam_sweep *sweep,
                                    const struct hawser_beam_event *event,
                                    struct hawser_report *report)
{
	if (hawser__more(&sweep->event, sweep->events, sizeof *sweep->event))
		return hawser__no_memory(report, "beam");
	sweep->event[sweep->events++] = *event;
	return HAWSER_OK;
}

/* A solver for hawser__beam_change. */
static enum hawser_status solve_for_change(struct hawser__beam_sample *stop, void *context,
                                           double speed, struct hawser_report *report)
{
	return solve(stop, context, speed, report);
}

static struct hawser__beam_solver solver_of(struct work *work)
{
	return (struct hawser__beam_solver){solve_for_change, work, work->watched};
}

/* All changes between two neighbouring samples. */
static enum hawser_status changes(struct work *work, const struct hawser__beam_sample *a,
                                  const struct hawser__beam_sample *b, struct hawser_report *report)
{
	enum { MOST = 8 };
	const struct hawser__beam_solver solver = solver_of(work);
	struct hawser__beam_sample from = *a; /* *a itself at first, later a sample of this function */
	enum hawser_status status = HAWSER_OK;
	int i;

	for (i = 0; !status && from.growing != b->growing && i < MOST; i++) {
		struct hawser_beam_event event = {.speed = NAN};
		struct hawser__beam_change change;

		status = hawser__beam_change(&change, &solver, &from, b, HAWSER__BEAM_GROWING, report);
		if (i > 0)
			hawser__beam_sample_clear(&from);
		if (status)
			return status;
		event.speed = change.speed;
		event.kind = kind_of(&change);
		event.im = event.kind == HAWSER_BEAM_CALM ? 0.0 : change.im;
		event.growing[0] = change.before;
		event.growing[1] = change.after;
		status = add_event(work->sweep, &event, report);
		if (status || change.after == b->growing)
			return status;
		status = solve(&from, work, change.beyond, report);
	}
	if (!status && i > 0)
		hawser__beam_sample_clear(&from);
	return status;
}

/* Speeds at which branch 0 begins to grow (v_first) and at which its frequency vanishes (v_bif). */
static enum hawser_status first_mode(struct work *work, const struct hawser__beam_sample *a, int pa,
                                     const struct hawser__beam_sample *b, int pb, int events,
                                     struct hawser_report *report)
{
	struct hawser_beam_sweep *sweep = work->sweep;
	const struct hawser__beam_solver solver = solver_of(work);
	enum hawser_status status = HAWSER_OK;
	struct hawser__beam_change change;

	if (isnan(sweep->v_first) && b->pair[pb].growing && !a->pair[pa].growing && events < sweep->events)
		sweep->v_first = sweep->event[events].speed;
	if (isnan(sweep->v_bif) && b->pair[pb].im == 0.0 && a->pair[pa].im > 0.0 && a->real != b->real) {
		status = hawser__beam_change(&change, &solver, a, b, HAWSER__BEAM_REAL, report);
		if (!status)
			sweep->v_bif = change.speed;
	}
	return status;
}

/* At rest, with a flux of rotary momentum at every nonzero speed: a mode counts as growing if it
 * grows as soon as the beam moves. */
static void look_beyond(struct work *work)
{
	double direction = work->options->to > work->options->from ? 1.0 : -1.0;
	struct hawser__beam_sample *rest = &work->stop[0];

	if (rest->speed != 0.0 || !hawser__beam_flux(work->beam) || work->beam->drag > 0.0 ||
	    work->beam->weight == 0.0)
		return;
	rest->growing = 0;
	for (int p = 0; p < rest->pairs; p++) {
		rest->pair[p].growing |= direction*rest->pair[p].slope_re > 0.0;
		rest->growing += p < work->watched && rest->pair[p].growing;
	}
}

static enum hawser_status locate(struct work *work, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	size_t b = (size_t)work->branches;

	look_beyond(work);
	if (work->stop[0].pair[0].growing)
		work->sweep->v_first = work->stop[0].speed;
	if (work->stop[0].pair[0].im == 0.0)
		work->sweep->v_bif = work->stop[0].speed;
	for (int i = 1; !status && i < work->stops; i++) {
		int events = work->sweep->events;

		status = changes(work, &work->stop[i - 1], &work->stop[i], report);
		if (!status)
			status = first_mode(work, &work->stop[i - 1], work->at[(size_t)(i - 1)*b],
			                    &work->stop[i], work->at[(size_t)i*b], events, report);
	}
	return status;
}

/* --- all together --- */

static enum hawser_status keep(struct work *work, struct hawser_report *report)
{
	struct hawser_beam_sweep *sweep = work->sweep;
	size_t b = (size_t)work->branches, cells = (size_t)work->stops*b;

	sweep->branches = work->branches;
	sweep->stations = work->stops;
	sweep->station = malloc((size_t)work->stops*sizeof *sweep->station);
	sweep->re = malloc(4*cells*sizeof *sweep->re);
	if (!sweep->station || !sweep->re)
		return hawser__no_memory(report, "beam");
	sweep->im = sweep->re + 2*cells;
	sweep->condition = sweep->im + cells;
	for (int i = 0; i < work->stops; i++) {
		const struct hawser__beam_sample *stop = &work->stop[i];

		sweep->station[i] = (struct hawser_beam_station){stop->speed, stop->growing, stop->inserted};
		for (size_t k = 0; k < b; k++) {
			const struct hawser__beam_pair *pair = &stop->pair[work->at[(size_t)i*b + k]];
			size_t cell = (size_t)i*b + k;

			sweep->re[2*cell] = pair->re[0];
			sweep->re[2*cell + 1] = pair->re[1];
			sweep->im[cell] = pair->im;
			sweep->condition[cell] = pair->condition;
		}
	}
	return HAWSER_OK;
}

enum hawser_status hawser_beam_sweep(struct hawser_beam_sweep *sweep,
                                     const struct hawser_beam_integrals *is,
                                     const struct hawser_beam *beam,
                                     const struct hawser_beam_sweep_options *options,
                                     struct hawser_report *report)
{
	struct work work = {.sweep = sweep, .is = is, .beam = beam, .options = options,
	                    .branches = options->branches};
	enum hawser_status status;

	memset(sweep, 0, sizeof *sweep);
	sweep->v_first = sweep->v_bif = NAN;
	sweep->least_correlation = 1.0;
	if (options->points < 2 || options->branches < 1 || options->branches > 200 ||
	    !isfinite(options->from) || !isfinite(options->to) || options->from == options->to)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "beam",
		                    "%d points from speed %g to %g, %d modes: give 2 points or more, two "
		                    "different speeds, and 1 to 200 modes", options->points, options->from,
		                    options->to, options->branches);
	if (work.branches > is->n)
		work.branches = is->n;
	work.watched = work.branches + SPARE < is->n ? work.branches + SPARE : is->n;
	status = follow(&work, report);
	if (!status)
		status = locate(&work, report);
	if (!status)
		status = keep(&work, report);
	for (int i = 0; i < work.stops; i++)
		hawser__beam_sample_clear(&work.stop[i]);
	free(work.stop);
	free(work.at);
	free(work.share);
	if (status)
		hawser_beam_sweep_clear(sweep);
	return status;
}

void hawser_beam_sweep_clear(struct hawser_beam_sweep *sweep)
{
	if (!sweep)
		return;
	free(sweep->station);
	free(sweep->re);
	free(sweep->event);
	memset(sweep, 0, sizeof *sweep);
}

HAWSER__NAMES(hawser_beam_event_name, enum hawser_beam_event_kind, "divergence", "flutter",
	"calm")
