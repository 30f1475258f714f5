/* response/branch/step.c - the operations of a step along a branch of periodic orbits.
 *
 * The predictor is the quintic through the last three stations and their tangents, so its error
 * falls with ds^6 and the corrector starts close.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "response/branch/trace.h"

#define LARGEST_STEP 0.4       /* largest relative change of the orbit in one step; chosen */
#define LARGEST_TURN 0.01      /* largest relative change of Omega in a step: resonances are this
                                * narrow; chosen */
#define LARGE_TURN 0.03        /* the same of a large model; chosen */
#define COARSE_TURN 0.1        /* the same on a detour, whose points are of no interest, and for a
                                * curve of which only the shape matters; chosen */
#define TRUSTED_STEP 1e-6      /* a step as short as this is accepted in any case; chosen */
#define COARSE_STEP 1e-5       /* if a step of this length fails, the discretisation is considered
                                * too coarse; chosen */
#define REFINED_STEP 100.0     /* factor on that step with a finer discretisation; chosen */
#define MOST_ENRICHED 4        /* finer discretisations of one orbit, each of which has to reduce */
#define ENRICHED_ERROR 0.5     /* its error by this factor; both chosen */
#define CUT_CONTRACTION 3.0    /* largest ratio of two successive corrections of a point between two
                                * points of the branch, where there is no other branch: the second
                                * one has the second-order response of stiff coordinates, and may be
                                * larger than the first; chosen */
#define WORST_ERROR 0.05       /* largest estimated relative error of an accepted orbit; chosen */

/* Part of the range that is done and time left: folds turn back, and the furthest place counts. Not
 * of curves that need not end at an end of the range. */
static void foretell(struct hawser_progress_state *state, struct hawser__trace *trace, double omega)
{
	const struct hawser_frf_options *o = &trace->options;

	if (o->family || o->begin != o->from)
		return;
	trace->reached = fmax(trace->reached, fmin((omega - o->from)/(o->to - o->from), 1.0));
	state->fraction = trace->reached;
}

int hawser__trace_told_to_stop(struct hawser__trace *trace)
{
	struct hawser_progress_state state;

	if (trace->stopped || !hawser__is_watched(&trace->options.progress))
		return trace->stopped;
	state = hawser__progress_state("response", "points", trace->frf->points, trace->began);
	state.frf = trace->frf;
	state.events = trace->frf->events;
	if (trace->frf->points > 0) {
		double omega = trace->frf->point[trace->frf->points - 1].omega;

		state.omega = omega/trace->rom->time;
		foretell(&state, trace, omega);
	}
	trace->stopped = hawser__told_to_stop(&trace->options.progress, &state);
	return trace->stopped;
}

void hawser__trace_tick(void *owner)
{
	(void)hawser__trace_told_to_stop(owner);
}

int hawser__trace_interrupted(void *owner, int tries)
{
	struct hawser__trace *trace = owner;

	/* a difficult step takes many attempts, between which the user may interrupt */
	return tries > 0 && hawser__trace_told_to_stop(trace);
}

/* The last stations, of which there are one to three. */
static int last_nodes(struct hawser__node *node, const struct hawser__trace *trace)
{
	const struct hawser__station *last[] = {&trace->before, &trace->prev, &trace->here};
	int nodes = trace->known < 3 ? trace->known : 3;

	for (int k = 0; k < nodes; k++)
		node[k] = hawser__station_node(last[3 - nodes + k]);
	return nodes;
}

int hawser__trace_predict(void *owner, double ds)
{
	struct hawser__trace *trace = owner;
	const struct hawser__metric metric = hawser__orbit_metric(trace->orbit);
	struct hawser__node node[3];
	int nodes = last_nodes(node, trace);

	if (!hawser__known_ahead(trace, ds))
		hawser__curve_ahead(trace->next.y, node, nodes, ds, &metric);
	/* The plane is normal to the known tangent, since the direction of an extrapolated one may be
	 * wrong. */
	memcpy(trace->direction, trace->here.t, (size_t)trace->orbit->size*sizeof(double));
	return 0;
}

enum hawser_status hawser__trace_correct(struct hawser__trace *trace,
                                         struct hawser__station *station, const double *row,
                                         int *failed)
{
	struct hawser__orbit *orbit = trace->orbit;
	double tolerance = trace->options.tolerance;

	for (;;) {
		int again;
		enum hawser_status status;

		*failed = hawser__orbit_correct(orbit, station->y, &station->correction, row,
		                                tolerance);
		if (*failed)
			return HAWSER_OK;
		status = orbit->ops->refine(orbit, &again, tolerance,
		                            hawser__orbit_omega(orbit, station->y), trace->report);
		if (status || !again)
			return status;
	}
}

enum hawser_status hawser__trace_correct_next(void *owner, double ds,
                                              struct hawser__correction *correction, int *failed)
{
	struct hawser__trace *trace = owner;
	enum hawser_status status;

	trace->orbit->reach = ds;
	status = hawser__trace_correct(trace, &trace->next, trace->direction, failed);
	trace->orbit->reach = 0.0;
	trace->orbit->known = 0;
	*correction = trace->next.correction;
	return status;
}

double hawser__trace_longest(void *owner)
{
	const struct hawser__trace *trace = owner;
	const struct hawser__orbit *orbit = trace->orbit;
	double extent = hawser__orbit_extent(orbit, trace->here.y);
	int coarse = (trace->watch && trace->watch->coarse) || trace->options.unjudged;
	double part = coarse ? COARSE_TURN : hawser__trace_steps_long(trace) ? LARGE_TURN : LARGEST_TURN;
	double turn = fmin(orbit->own ? INFINITY : part*extent,
	                   trace->options.step_max*(trace->hi - trace->lo));
	/* Omega changes by |t_Omega| ds; if the branch is steep, only the change of the orbit limits
	 * the step */
	double share = fabs(trace->here.t[orbit->size - 1]);

	return share*LARGEST_STEP > turn ? turn/share : LARGEST_STEP;
}

static int trace_is_determined(const struct hawser__station *station)
{
	return station->error <= WORST_ERROR;
}

/* Without damping a linear resonance has no finite orbit. The damping of the integrator would then
 * limit the amplitude, and the peak would be wrong. */
enum hawser_status hawser__trace_determined(const struct hawser__trace *trace,
                                            const struct hawser__station *station)
{
	return trace_is_determined(station) ? HAWSER_OK :
	       hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
	                       station->correction.iterations, station->error,
	                       "at %s the orbit is determined to no better than %.1g of its "
	                       "size: tighten --tolerance (%.1g); if that does not help, it is a "
	                       "resonance without damping",
	                       hawser__orbit_where(trace->orbit,
	                                           hawser__trace_parameter(trace, station)).text,
	                       station->error, trace->options.tolerance);
}

/* A finer discretisation for an orbit that is not determined. Returns 0 where it is not to be had, or
 * where the last one did not help. The neglected terms, though small, may make an orbit
 * indeterminate: the estimate by one sweep after the other grows without bound where high harmonics
 * of stiff coordinates are neglected. */
static int trace_enrich(struct hawser__trace *trace, const struct hawser__station *station)
{
	if (trace->enriched >= MOST_ENRICHED ||
	    (trace->enriched > 0 && !(station->error < ENRICHED_ERROR*trace->undetermined)) ||
	    trace->orbit->ops->enrich(trace->orbit, 0, NULL))
		return 0;
	trace->enriched++;
	trace->undetermined = station->error;
	return 1;
}

enum hawser_status hawser__trace_settle(struct hawser__trace *trace,
                                        struct hawser__station *station, double side,
                                        const double *along, int *failed)
{
	struct hawser__orbit *orbit = trace->orbit;
	int last = orbit->size - 1;
	double at = station->y[last];
	enum hawser_status status;

	trace->enriched = 0;
	do {
		memset(trace->direction, 0, (size_t)orbit->size*sizeof(double));
		trace->direction[last] = side*orbit->W;
		status = hawser__trace_correct(trace, station, trace->direction, failed);
		station->y[last] = at; /* not one unit of round-off beyond, where no trace may begin */
		if (!status && !*failed)
			status = hawser__station_finish(station, orbit, along ? along : trace->direction,
			                                trace->report);
	} while (!status && !*failed && !trace_is_determined(station) &&
	         trace_enrich(trace, station));
	return status;
}

enum hawser_status hawser__trace_refine(void *owner, double ds, double *factor)
{
	struct hawser__trace *trace = owner;

	*factor = 0.0;
	/* the reason may be active pairs or nodes that were removed or never included */
	if (ds >= COARSE_STEP || trace->enriched++)
		return HAWSER_OK;
	*factor = REFINED_STEP;
	return trace->orbit->ops->enrich(trace->orbit, 1, trace->report);
}

/* Whether a step is refused whatever its multipliers are. One that ends at a known orbit may turn
 * farther. */
static int refused(const struct hawser__trace *trace, double angle, double ds)
{
	const struct hawser__step_settings *goal = ds == trace->aim ? &hawser__known_steps
	                                                            : &hawser__exact_steps;

	if (hawser__trace_steps_long(trace))
		angle *= hawser__frf_steps.goal_angle/goal->goal_angle;
	return ds > TRUSTED_STEP && !hawser__trace_trusted(&trace->next.correction, angle);
}

enum hawser_status hawser__trace_finish(void *owner, double ds, double *angle)
{
	struct hawser__trace *trace = owner;
	const struct hawser__metric metric = hawser__orbit_metric(trace->orbit);
	struct hawser__node node[3];

	if (!trace->options.along)
		hawser__curve_slope(trace->direction, trace->next.y, node, last_nodes(node, trace), ds,
		                    &metric);
	hawser__station_turn(&trace->next, trace->orbit, hawser__known_side(trace, ds),
	                     trace->options.along ? NULL : trace->direction);
	*angle = hawser__metric_angle(&metric, trace->here.t, trace->next.t);
	trace->next.arc = trace->here.arc + ds;
	if (refused(trace, *angle, ds)) /* multipliers would take most of the time of the step */
		return HAWSER_OK;
	return hawser__station_judge(&trace->next, trace->orbit, trace->report);
}

enum hawser_status hawser__trace_judge(void *owner, double ds, double angle,
                                       enum hawser__verdict *verdict)
{
	struct hawser__trace *trace = owner;
	enum hawser_status status;
	int hidden, sure;

	*verdict = HAWSER__SHORTEN;
	if (refused(trace, angle, ds))
		return HAWSER_OK;
	if ((status = hawser__trace_hides(trace, &hidden)) || hidden)
		return status;
	*verdict = HAWSER__KEEP;
	if (hawser__account_crossings(&trace->here, &trace->next, &sure,
	                              hawser__station_unsure(&trace->here, &trace->next)))
		return HAWSER_OK;
	status = hawser__trace_determined(trace, &trace->next);
	if (!status)
		return HAWSER_OK;
	if (!trace_enrich(trace, &trace->next))
		return status;
	*verdict = HAWSER__REPEAT;
	return HAWSER_OK;
}

enum hawser_status hawser__trace_cut(struct hawser__trace *trace, double bound)
{
	struct hawser__orbit *orbit = trace->orbit;
	const struct hawser__node here = hawser__station_node(&trace->here);
	const struct hawser__node next = hawser__station_node(&trace->next);
	const struct hawser__metric metric = hawser__orbit_metric(orbit);
	int last = orbit->size - 1, failed;
	double side = trace->here.y[last] < bound ? 1.0 : -1.0;
	double share = hawser__curve_meets(trace->scratch.y, trace->direction, &here, &next, last, bound,
	                                   &metric);
	enum hawser_status status;

	trace->scratch.y[last] = bound;
	orbit->patience = CUT_CONTRACTION;
	status = hawser__trace_settle(trace, &trace->scratch, side, trace->here.t, &failed);
	orbit->patience = 0.0;
	if (status)
		return status;
	if (failed)
		return hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
		                       trace->scratch.correction.iterations,
		                       trace->scratch.correction.residual,
		                       "the corrector failed at the end of the range, %s",
		                       hawser__orbit_where(orbit, bound).text);
	trace->scratch.arc = trace->here.arc + share*(trace->next.arc - trace->here.arc);
	hawser__station_swap(&trace->scratch, &trace->next);
	return hawser__trace_determined(trace, &trace->next);
}
