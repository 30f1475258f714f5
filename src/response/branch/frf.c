/* response/branch/frf.c - the frequency response: a branch of forced periodic orbits, from its
 * first orbit to its end. trace.h lists the parts. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "core/settle.h"
#include "response/orbit/certify.h"
#include "response/branch/trace.h"
#include "rom/terms/drag.h"
#include "rom/terms/terms.h"

/* Relative error of Omega above which an event does not count as located: a step is at most 0.01 of
 * Omega, so that such an error is no better than the step. */
#define WORST_LOCATED 0.01
/* Error to which events are located, of Omega; and of large models (hawser__is_large), of which an
 * orbit takes long, and a basis with exact energy has a far larger error. */
#define LOCATED 1e-10
#define LOCATED_LARGE 1e-7
#define MOST_RETRIES 3 /* repetitions of a step with an unresolved event, each a quarter as long;
                        * chosen */
#define SURE_STEP 1e-6 /* arclength; in a shorter step a gap is not resolved further; chosen */
#define RETRY 0.83 /* factor on a step to avoid a point: no power of it is a simple fraction;
                    * chosen */
#define BACK 0.5 /* factor on a step that is made again since it may hide events; chosen */
#define MOST_JUMPS 3     /* traces that are started anew, each with SHORTER times the longest step;
                          * chosen */
#define SHORTER 0.25 /* see there; chosen */

void hawser_frf_settle(struct hawser_frf_options *options)
{
	hawser__settle(&options->tolerance, 1e-9);
	hawser__settle(&options->step_max, 0.02);
	hawser__settle_count(&options->max_points, 20000);
	hawser__settle_count(&options->samples, 5);
}

/* Record the events of the last step. */
static enum hawser_status record_events(struct hawser__trace *trace)
{
	struct hawser__account *account = &trace->account;
	int together = 0;

	for (int i = 0; i < account->events; i++) {
		struct hawser_frf_event *event = &account->event[i];
		const double *state = event->after < 0 ? NULL
		                      : account->state + (size_t)event->after*(size_t)trace->orbit->m;
		double frequency = event->parameter;
		enum hawser_status status;

		event->after = trace->frf->points - 2; /* next has already been stored */
		event->parameter = event->omega;
		if (trace->options.family)
			event->omega = (trace->orbit->own ? frequency : trace->options.family->omega)*
			               trace->rom->time;
		if (trace->orbit->own == HAWSER__RESTS) {
			status = hawser__trace_hopf(trace, event, state, &together);
			if (status || together)
				return status;
		}
		event->located = event->kind != HAWSER_UNEXPLAINED && event->error <= WORST_LOCATED;
		status = hawser__record_event(trace->frf, event, state, trace->orbit->rom, trace->report);
		if (status)
			return status;
	}
	return HAWSER_OK;
}

/* Find the events of the step. *again is set and *ds shortened if the step must be repeated. If an
 * event cannot be located, next lies across a gap (a bifurcation that a small load has separated
 * into two branches): the step is halved until the gap is resolved. If events do not explain the
 * count, a station may be so near to an event that its count depends on round-off. Such a station,
 * and one with more undecided multipliers than before, is avoided by a step of another length. */
static enum hawser_status account_step(struct hawser__trace *trace, int *again, double *ds)
{
	struct hawser__account *account = &trace->account;
	double taken = trace->next.arc - trace->here.arc;
	enum hawser_status status;

	*again = 0;
	if (trace->options.skip_events) {
		account->events = 0;
		return HAWSER_OK;
	}
	if (trace->next.circle.undecided > trace->here.circle.undecided && trace->retries < MOST_RETRIES) {
		trace->retries++;
		*ds = RETRY*taken;
		*again = 1;
		return HAWSER_OK;
	}
	status = hawser__account_step(account, trace->orbit, &trace->here, &trace->next,
	                              trace->report);
	if (status)
		return status;
	if (account->gaps > 0 && taken > SURE_STEP) {
		*ds = 0.5*taken;
		*again = 1;
	} else if (account->unresolved > 0 && trace->retries < MOST_RETRIES) {
		trace->retries++;
		*ds = RETRY*taken;
		*again = 1;
	}
	return HAWSER_OK;
}

/* Least tension at the last recorded point; 1 where the curve does not end at slackness. */
static double least_tension(const struct hawser__trace *trace)
{
	const struct hawser_frf *frf = trace->frf;

	return trace->options.end_at_slack && frf->tension ? frf->tension[2*((size_t)frf->points - 1)]
	                                                   : 1.0;
}

/* Record the new station; where the cable is slack there, one where it just becomes so, and *event. */
static enum hawser_status record_next(struct hawser__trace *trace, struct hawser_frf_event *event)
{
	double before = least_tension(trace), after;
	enum hawser_status status = hawser__record_point(trace->frf, trace->amplitude, &trace->next,
	                                                 trace->orbit, trace->report);

	trace->slack = 0;
	if (status || !((after = least_tension(trace)) < 0.0))
		return status;
	trace->frf->points--;
	trace->slack = 1;
	status = hawser__trace_slacken(trace, before, after, event);
	return status ? status : hawser__record_point(trace->frf, trace->amplitude, &trace->next,
	                                              trace->orbit, trace->report);
}

/* The event at the last point. */
static enum hawser_status record_slack(struct hawser__trace *trace,
                                       const struct hawser_frf_event *slack)
{
	struct hawser__orbit *orbit = trace->orbit;

	orbit->ops->state(orbit, orbit->step, trace->next.y);
	return hawser__record_event(trace->frf, slack, orbit->step, orbit->rom, trace->report);
}

/* Store the new station and its events, and make it the current one; or set *again. */
static enum hawser_status accept(struct hawser__trace *trace, int *again, double *ds)
{
	struct hawser_frf_event slack;
	enum hawser_status status = record_next(trace, &slack);

	*again = 0;
	if (status || (status = account_step(trace, again, ds)))
		return status;
	if (*again) {
		trace->frf->points--;
		return HAWSER_OK;
	}
	if ((status = record_events(trace)))
		return status;
	slack.after = trace->frf->points - 2;
	if (trace->slack && (status = record_slack(trace, &slack)))
		return status;
	if (trace->watch && trace->watch->step &&
	    (status = trace->watch->step(trace->watch->context, trace)))
		return status;
	trace->retries = 0;
	hawser__station_swap(&trace->before, &trace->prev);
	hawser__station_swap(&trace->prev, &trace->here);
	hawser__station_swap(&trace->here, &trace->next);
	trace->known++;
	return HAWSER_OK;
}

/* Whether the next step can start here; the metric is that of the present orbit. */
static enum hawser_status prepare(void *owner, int *ended)
{
	struct hawser__trace *trace = owner;
	struct hawser_frf *frf = trace->frf;
	enum hawser_status status;

	trace->enriched = 0;
	*ended = 1;
	if (hawser__trace_told_to_stop(trace)) {
		frf->end = HAWSER_END_INTERRUPTED;
		return HAWSER_OK;
	}
	if (least_tension(trace) < 0.0) { /* from the first orbit on */
		frf->end = HAWSER_END_SLACK;
		return HAWSER_OK;
	}
	if (trace->options.most_unstable > 0 &&
	    frf->point[frf->points - 1].unstable > trace->options.most_unstable) {
		frf->end = HAWSER_END_UNSTABLE;
		return HAWSER_OK;
	}
	if (frf->points >= trace->options.max_points) {
		frf->end = HAWSER_END_MAX_POINTS;
		return HAWSER_OK;
	}
	if (trace->options.most_work > 0.0 &&
	    hawser_orbit_work(&trace->orbit->cost, trace->rom) > trace->options.most_work) {
		frf->end = HAWSER_END_WORK;
		return HAWSER_OK;
	}
	if ((status = hawser__trace_climbs(trace)))
		return status;
	trace->orbit->ops->metric(trace->orbit, trace->here.y);
	hawser__known_aim(trace);
	if (trace->orbit->own)
		return hawser__own_ends(trace, ended);
	return hawser__trace_vanish(trace, ended);
}

/* Take the step from prev to here back; the next one begins at prev and is half as long. */
static void go_back(struct hawser__trace *trace, double *ds)
{
	struct hawser_frf *frf = trace->frf;

	*ds = BACK*(trace->here.arc - trace->prev.arc);
	frf->points--;
	while (frf->events > 0 && frf->event[frf->events - 1].after >= frf->points - 1)
		frf->events--;
	if (trace->watch && trace->watch->back)
		trace->watch->back(trace->watch->context);
	trace->retries = 0;
	hawser__station_swap(&trace->here, &trace->prev);
	hawser__station_swap(&trace->prev, &trace->before);
	trace->known = trace->known < 3 ? trace->known - 1 : 2; /* what was before `before` is lost */
}

/* Ends of the range, the start of a closed curve, then the events of the step. */
static enum hawser_status arrive(void *owner, enum hawser__arrival *arrival, double taken, double *ds)
{
	struct hawser__trace *trace = owner;
	double omega = hawser__trace_parameter(trace, &trace->next), share;
	int outside = omega >= trace->hi || omega <= trace->lo, round, again, met = 0, hidden = 0;
	enum hawser_status status;

	(void)taken;
	if (!trace->options.skip_events && (status = hawser__trace_hid(trace, &hidden)))
		return status;
	if (hidden) {
		go_back(trace, ds);
		*arrival = HAWSER__AGAIN;
		return HAWSER_OK;
	}
	if (outside && (status = hawser__trace_cut(trace, omega >= trace->hi ? trace->hi : trace->lo)))
		return status;
	if (hawser__trace_came_back(trace))
		return hawser__trace_jumped(trace);
	round = !outside && hawser__trace_closed(trace, &share);
	if (round && (status = hawser__trace_close(trace, share)))
		return status;
	trace->frf->end = round ? HAWSER_END_CLOSED
	                  : trace->options.begin != trace->options.from ||
	                    (omega > trace->lo) == (trace->options.to > trace->options.from)
	                          ? HAWSER_END_RANGE : HAWSER_END_RETURNED;
	if ((status = accept(trace, &again, ds)))
		return status;
	if (trace->slack)
		trace->frf->end = HAWSER_END_SLACK;
	if (!again && !round && (status = hawser__trace_meet(trace, &met)))
		return status;
	outside |= round | trace->slack | met;
	*arrival = again ? HAWSER__AGAIN : outside ? HAWSER__AT_END : HAWSER__GO_ON;
	if (*arrival != HAWSER__GO_ON)
		return HAWSER_OK;
	hawser__trace_mark(trace);
	/* the last orbit evaluated may be that of an event, as at a branch point, where the parts that make
	 * the branch are zero: they must not be dropped */
	if (trace->account.events > 0)
		return HAWSER_OK;
	trace->orbit->tangent = trace->here.t;
	status = trace->orbit->ops->relax(trace->orbit, trace->options.tolerance, trace->report);
	trace->orbit->tangent = NULL;
	return status;
}

static const struct hawser__curve_ops branch_ops = {
	.prepare = prepare, .interrupted = hawser__trace_interrupted, .predict = hawser__trace_predict,
	.correct = hawser__trace_correct_next, .refine = hawser__trace_refine,
	.finish = hawser__trace_finish, .judge = hawser__trace_judge,
	.longest = hawser__trace_longest, .arrive = arrive
};

static enum hawser_status follow(struct hawser__trace *trace)
{
	const struct hawser__correction *last = &trace->curve.correction;
	struct hawser__where here;
	enum hawser__outcome outcome;
	enum hawser_status status = hawser__curve_follow(&trace->curve, &outcome);

	if (!status && outcome == HAWSER__INTERRUPTED)
		trace->frf->end = HAWSER_END_INTERRUPTED;
	here = hawser__orbit_where(trace->orbit, hawser__trace_parameter(trace, &trace->here));
	if (!status && outcome == HAWSER__LOST)
		status = hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf", last->iterations,
		                         last->residual,
		                         "the corrector failed at the smallest step near %s (residual %.2g); "
		                         "%d points were traced%s", here.text,
		                         last->residual, trace->frf->points,
		                         hawser__trace_undamped(trace)
		                         ? "; without damping a resonance has no peak: give the model "
		                           "damping, or end the range before the resonance" : "");
	return status;
}

/* The method, for orbits in the range; those of a family have one frequency. */
static enum hawser_status open_orbit(struct hawser__trace *trace, struct hawser_report *report)
{
	struct hawser_frf_options options = trace->options;
	const struct hawser__orbit_method *method = &hawser__balance_method;
	enum hawser_status status = HAWSER_OK;

	if (options.family && options.family->omega == 0.0)
		return hawser__own_open(trace, report);
	if (options.family)
		options.from = options.to = options.begin = options.family->omega*trace->rom->time;
	if (!options.family || trace->rom->drag || hawser__rom_more(trace->rom) || options.method)
		status = hawser__orbit_method(&method, trace->rom, &options, report);
	if (status || (status = method->open(&trace->orbit, trace->rom, &options, report)))
		return status;
	trace->frf->method = method->about.name;
	trace->orbit->unjudged = options.unjudged;
	if (options.family)
		trace->orbit->floor = HAWSER_OMEGA_WIDTH*(trace->hi - trace->lo);
	return HAWSER_OK;
}

static enum hawser_status open_trace(struct hawser__trace *trace, struct hawser_report *report)
{
	const struct hawser_rom *rom = trace->rom;
	const struct hawser__orbit *orbit;
	enum hawser_status status = open_orbit(trace, report);

	if (status)
		return status;
	orbit = trace->orbit;
	if ((status = hawser__station_init(&trace->before, orbit, report)) ||
	    (status = hawser__station_init(&trace->prev, orbit, report)) ||
	    (status = hawser__station_init(&trace->here, orbit, report)) ||
	    (status = hawser__station_init(&trace->next, orbit, report)) ||
	    (status = hawser__station_init(&trace->scratch, orbit, report)) ||
	    (status = hawser__account_init(&trace->account, orbit, report)))
		return status;
	trace->account.tolerance = trace->options.tolerance;
	trace->account.event_tolerance = trace->options.event_tolerance;
	trace->account.lo = trace->lo;
	trace->account.hi = trace->hi;
	if (trace->watch) {
		trace->account.watch = trace->watch->event;
		trace->account.context = trace->watch->context;
	}
	trace->direction = hawser__hold(&trace->hold, (size_t)orbit->size, sizeof(double));
	trace->side = hawser__hold(&trace->hold, (size_t)orbit->size, sizeof(double));
	trace->start_y = hawser__hold(&trace->hold, (size_t)orbit->size, sizeof(double));
	trace->start_t = hawser__hold(&trace->hold, (size_t)orbit->size, sizeof(double));
	trace->mark_y = hawser__hold(&trace->hold, (size_t)orbit->size + (size_t)orbit->m, sizeof(double));
	trace->mark_t = hawser__hold(&trace->hold, (size_t)orbit->size, sizeof(double));
	trace->pairs = hawser__hold(&trace->hold, 7*(size_t)orbit->n, sizeof *trace->pairs);
	trace->amplitude = hawser__amplitude_new(rom);
	if (trace->hold.short_of_memory || !trace->amplitude)
		return hawser__no_memory(report, "frf");
	return HAWSER_OK;
}

static void close_trace(struct hawser__trace *trace)
{
	if (trace->orbit)
		trace->orbit->ops->clear(trace->orbit);
	hawser__station_clear(&trace->before);
	hawser__station_clear(&trace->prev);
	hawser__station_clear(&trace->here);
	hawser__station_clear(&trace->next);
	hawser__station_clear(&trace->scratch);
	hawser__account_clear(&trace->account);
	hawser__amplitude_free(trace->amplitude);
	hawser__hold_clear(&trace->hold);
}

/* From the first orbit to the end of the curve. *jumped: 1: a step jumped to another curve. */
static enum hawser_status trace_once(int *jumped, struct hawser_frf *frf,
                                     const struct hawser_rom *rom,
                                     const struct hawser_frf_options *options,
                                     const struct hawser__trace_watch *watch,
                                     struct hawser_report *report)
{
	struct hawser__trace trace = {.rom = rom, .options = *options, .frf = frf, .report = report,
		.watch = watch, .curve = {.ops = &branch_ops, .settings = hawser__known_settings(rom, watch)},
		.lo = fmin(options->from, options->to),
		.hi = fmax(options->from, options->to)};
	enum hawser_status status;

	trace.curve.owner = &trace;
	trace.began = hawser__wall_seconds();
	if (trace.options.begin == 0.0)
		trace.options.begin = options->from;
	*frf = (struct hawser_frf){.n = rom->n, .probes = rom->shapes.points, .branch = 1, .period = 1,
		.length = rom->length, .time = rom->time};
	if (!(status = open_trace(&trace, report)) && !(status = hawser__trace_begin(&trace)))
		status = follow(&trace);
	if (trace.orbit)
		frf->cost = trace.orbit->cost;
	hawser__record_order(frf);
	*jumped = trace.jumped;
	close_trace(&trace);
	return status;
}

/* With most_unstable, a branch whose last motions are unstable ends there if the next one can't be
 * computed. */
static enum hawser_status end_lost(struct hawser_frf *frf, enum hawser_status status,
                                   const struct hawser_frf_options *options,
                                   const struct hawser_report *report)
{
	if (status != HAWSER_ERR_CONVERGENCE || !options->most_unstable || frf->points < 2 ||
	    frf->point[frf->points - 1].unstable == 0)
		return status;
	frf->end = HAWSER_END_LOST;
	memcpy(frf->lost, report->message, sizeof frf->lost);
	return HAWSER_OK;
}

/* Equilibria and limit cycles. */
static int is_own(const struct hawser_frf_options *options)
{
	return options->family && options->family->omega == 0.0;
}

/* At the frequency of the model, which is that of the load but for `periods`. */
static enum hawser_status trace_own(struct hawser_frf *frf, const struct hawser_rom *rom,
                                    const struct hawser_frf_options *options,
                                    const struct hawser__trace_watch *watch,
                                    struct hawser_report *report)
{
	struct hawser_report local = {.status = HAWSER_OK}; /* also has failures that were overcome */
	struct hawser_frf_options settled = *options, shorter;
	enum hawser_status status;
	int jumped = 0;

	*frf = (struct hawser_frf){.n = rom->n, .probes = rom->shapes.points};
	if (hawser__drag_rough(rom))
		hawser__settle(&settled.tolerance, HAWSER__DRAG_TOLERANCE);
	hawser_frf_settle(&settled);
	hawser__settle(&settled.event_tolerance, hawser__is_large(rom) ? LOCATED_LARGE : LOCATED);
	if ((status = hawser__frf_check(rom, &settled, report)))
		return status;
	shorter = settled;
	for (int jumps = 0; jumps == 0 || (jumped && jumps <= MOST_JUMPS); jumps++) {
		hawser_frf_clear(frf);
		status = trace_once(&jumped, frf, rom, &shorter, watch, &local);
		shorter.step_max *= SHORTER;
	}
	status = end_lost(frf, status, &settled, &local);
	for (int i = 0; i < frf->points; i++)
		frf->undecided += frf->point[i].undecided > 0;
	if (!status && frf->end != HAWSER_END_INTERRUPTED && settled.samples > 0 && !is_own(&settled) &&
	    strcmp(frf->method, hawser__shooting_method.about.name) != 0)
		status = hawser__certify(frf, rom, &settled, &local);
	if (status && frf->end != HAWSER_END_INTERRUPTED)
		frf->end = HAWSER_END_FAILED;
	if (status && report)
		*report = local;
	return status;
}

enum hawser_status hawser__frf_trace(struct hawser_frf *frf, const struct hawser_rom *rom,
                                     const struct hawser_frf_options *options,
                                     const struct hawser__trace_watch *watch,
                                     struct hawser_report *report)
{
	struct hawser_frf_options slower = *options;
	struct hawser_rom_family family;
	int periods = hawser__rom_periods(rom);
	enum hawser_status status;

	if (periods == 1 || is_own(options))
		return trace_own(frf, rom, options, watch, report);
	if (options->family) {
		family = *options->family;
		family.omega /= periods;
		slower.family = &family;
	} else {
		slower.from /= periods;
		slower.to /= periods;
		slower.begin /= periods;
	}
	status = trace_own(frf, rom, &slower, watch, report);
	hawser__frf_in_loads(frf, periods, options->family != NULL);
	return status;
}

enum hawser_status hawser_frf_trace(struct hawser_frf *frf, const struct hawser_rom *rom,
                                    const struct hawser_frf_options *options,
                                    struct hawser_report *report)
{
	return hawser__frf_trace(frf, rom, options, NULL, report);
}
