/* response/branch/frf_begin.c - the first orbit of a branch.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/report.h"
#include "response/orbit/start.h"
#include "response/branch/trace.h"

#define FIRST_REFINEMENTS 3 /* refinements of the mesh at the first orbit; chosen */
#define SAME_LOAD 1e-2 /* relative increase of the load that was reached, below which a mesh is not
                        * refined again; chosen */
#define FIRST_WORK 30.0 /* most work for it, s, where nothing else is asked for; chosen */
#define FIRST_STEP 0.05 /* relative to the orbit's size; short, since the first prediction has one
                         * tangent only; chosen */

/* The model at the first orbit, and its frequency. */
static enum hawser_status place(struct hawser__trace *trace, double *omega)
{
	const struct hawser_rom_family *family = trace->options.family;
	struct hawser__orbit *orbit = trace->orbit;
	enum hawser_status status;

	*omega = trace->options.begin;
	if (!family)
		return HAWSER_OK;
	status = family->model(family->context, &orbit->rom, trace->options.begin, trace->report);
	if (!status)
		*omega = family->omega*orbit->rom->time;
	return status;
}

/* From a state [m], or NULL. If the mesh is too coarse for the first orbit, Newton's method fails even
 * for a good initial value: refine it and try again, unless the mesh before reached the same load. */
static enum hawser_status start(struct hawser__trace *trace, const double *x,
                                struct hawser__raised *raised)
{
	const struct hawser_rom_family *family = trace->options.family;
	struct hawser__orbit *orbit = trace->orbit;
	double before = -1.0;
	enum hawser_status status;

	for (int refined = 0;; refined++) {
		double omega;

		orbit->family = NULL; /* at the parameter `begin`, with Omega as the last unknown */
		if ((status = place(trace, &omega)))
			return status;
		status = hawser__start(trace->here.y, orbit, &trace->here.correction, x, omega,
		                       trace->options.tolerance, raised, trace->report);
		orbit->family = family;
		trace->here.y[orbit->size - 1] = trace->options.begin;
		if (status != HAWSER_ERR_CONVERGENCE || refined == FIRST_REFINEMENTS ||
		    hawser__start_spent(orbit, raised) ||
		    (before > 0.0 && raised->load <= before*(1.0 + SAME_LOAD)))
			return status;
		before = raised->load;
		if ((status = orbit->ops->enrich(orbit, 1, trace->report)))
			return status;
	}
}

/* No way led to an orbit; tried[] is empty where a way was not tried. */
static enum hawser_status no_orbit(const struct hawser__trace *trace, double load,
                                   char tried[HAWSER__WAYS][80])
{
	const struct hawser__orbit *orbit = trace->orbit;
	const struct hawser_rom_family *family = trace->options.family;
	double omega = family ? family->omega*orbit->rom->time : trace->options.begin;
	char ways[240] = "";

	if (tried[0][0])
		snprintf(ways, sizeof ways, ", nor did curves lead there: over the load (%s)%s%s%s", tried[0],
		         *tried[1] ? " or from the other end of the range (" : "", tried[1],
		         *tried[1] ? ")" : "");
	return hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
	                       trace->here.correction.iterations, trace->here.correction.residual,
	                       "no periodic orbit found at Omega %.9g%s: the load could be raised to %.3g "
	                       "of its value only, and the motion from rest did not settle%s; start at "
	                       "another frequency, or from a state of your own",
	                       HAWSER_SHOWN(orbit->rom, omega), load, ways);
}

/* The caller ended the trace while its first orbit was looked for. */
static enum hawser_status stopped(const struct hawser__trace *trace)
{
	trace->frf->end = HAWSER_END_INTERRUPTED;
	return hawser__fail(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
	                    "the trace was ended before its first orbit, at %s, was found",
	                    hawser__orbit_where(trace->orbit, trace->options.begin).text);
}

static enum hawser_status first_orbit(struct hawser__trace *trace)
{
	int ways = trace->watch && trace->watch->direct ? 0 : HAWSER__WAYS, found;
	char tried[HAWSER__WAYS][80] = {"", ""};
	double most = trace->watch && trace->watch->first > 0.0 ? trace->watch->first : FIRST_WORK;
	struct hawser__raised raised = {.most = most, .x = trace->start_y};
	double *x = trace->mark_y;
	enum hawser_status status = hawser__known_first(trace, &found);

	if (status || found)
		return status;
	if (trace->orbit->own) {
		if ((status = hawser__own_equilibrium(trace, trace->next.y)))
			return status;
		memcpy(trace->here.y, trace->next.y, (size_t)trace->orbit->n*sizeof(double));
		trace->here.y[trace->orbit->n] = trace->options.begin;
		trace->orbit->ops->metric(trace->orbit, trace->here.y);
		return HAWSER_OK;
	}
	status = start(trace, trace->options.start, &raised);
	if (status != HAWSER_ERR_CONVERGENCE || raised.load < 0.0)
		return status;
	for (int way = 0; way < ways && !trace->stopped &&
	                  !hawser__start_spent(trace->orbit, &raised); way++) {
		if ((status = hawser__detour(x, &found, tried[way], trace, way, &raised)))
			return status;
		if (!found)
			continue;
		status = start(trace, x, &(struct hawser__raised){.load = 0.0});
		if (status != HAWSER_ERR_CONVERGENCE)
			return status;
		snprintf(tried[way], sizeof tried[way], "its last orbit could not be taken over");
	}
	return no_orbit(trace, raised.load, tried);
}

/* The point to which a closed curve returns: the point of the curve nearest to the first orbit.
 * Near a fold Omega determines an orbit badly, and any point nearby serves as well. */
static enum hawser_status mark_start(struct hawser__trace *trace)
{
	int size = trace->orbit->size, failed;
	enum hawser_status status;

	memcpy(trace->next.y, trace->here.y, (size_t)size*sizeof(double));
	status = hawser__trace_correct(trace, &trace->next, trace->here.t, &failed);
	if (!status && !failed)
		memcpy(trace->start_y, trace->next.y, (size_t)size*sizeof(double));
	return status;
}

/* The initial direction of Omega. */
static double heading(const struct hawser_frf_options *options)
{
	if (options->direction)
		return options->direction < 0 ? -1.0 : 1.0;
	return options->to > options->from ? 1.0 : -1.0;
}

/* The initial value at the distance `along` from `start`, and the direction between them, on a
 * discretisation `refined` times finer than their states alone suggest: what they leave out is small
 * beside the orbit, but need not be so beside `along`. */
static enum hawser_status aim(struct hawser__trace *trace, int refined)
{
	const struct hawser_frf_options *options = &trace->options;
	struct hawser__orbit *orbit = trace->orbit;
	double *x = trace->mark_y, *base = trace->next.y, *y = trace->here.y, length, omega;
	enum hawser_status status;

	for (int i = 0; i < orbit->m; i++)
		x[i] = options->start[i] + options->along[i];
	if ((status = place(trace, &omega)) ||
	    (status = orbit->ops->enrich(orbit, 1, trace->report)) ||
	    (status = orbit->ops->from_state(orbit, base, options->start, omega, trace->report)) ||
	    (status = orbit->ops->from_state(orbit, y, x, omega, trace->report)))
		return status;
	for (int i = 0; i < refined && !status; i++)
		status = orbit->ops->enrich(orbit, 1, trace->report);
	if (status)
		return status;
	orbit->family = options->family;
	y[orbit->size - 1] = base[orbit->size - 1] = options->begin;
	orbit->ops->metric(orbit, base);
	for (int i = 0; i < orbit->size; i++)
		trace->direction[i] = y[i] - base[i];
	length = sqrt(hawser__orbit_dot(orbit, trace->direction, trace->direction));
	for (int i = 0; i < orbit->size; i++)
		trace->direction[i] /= length;
	return HAWSER_OK;
}

/* The orbit at the distance `along` from `start`: corrected in the plane through it that is normal to
 * this direction. */
static enum hawser_status first_along(struct hawser__trace *trace, int *failed)
{
	struct hawser__orbit *orbit = trace->orbit;
	enum hawser_status status = HAWSER_OK;

	*failed = 1;
	for (int refined = 1; *failed && refined <= FIRST_REFINEMENTS; refined++) {
		if (!(status = aim(trace, refined)))
			status = hawser__trace_correct(trace, &trace->here, trace->direction, failed);
		if (status)
			return status;
	}
	return *failed ? status
	       : hawser__station_finish(&trace->here, orbit, trace->direction, trace->report);
}

enum hawser_status hawser__trace_begin(struct hawser__trace *trace)
{
	struct hawser__orbit *orbit = trace->orbit;
	int failed;
	enum hawser_status status;

	orbit->tick = hawser__trace_tick;
	orbit->owner = trace;
	if (orbit->own == HAWSER__CYCLES) {
		failed = 0;
		status = hawser__own_cycle(trace, heading(&trace->options));
	} else if (trace->options.along) {
		status = first_along(trace, &failed);
	} else {
		if ((status = first_orbit(trace)))
			return status == HAWSER_ERR_CONVERGENCE && trace->stopped ? stopped(trace) : status;
		status = hawser__trace_settle(trace, &trace->here, heading(&trace->options), NULL,
		                              &failed);
	}
	if (status)
		return status;
	if (failed && trace->options.along)
		return hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
		                       trace->here.correction.iterations,
		                       trace->here.correction.residual,
		                       "no orbit was found at the given distance from that at %s",
		                       hawser__orbit_where(orbit, trace->options.begin).text);
	if (failed)
		return hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
		                       trace->here.correction.iterations,
		                       trace->here.correction.residual,
		                       "the first orbit, at %s, was lost when its mesh was refined",
		                       hawser__orbit_where(orbit, trace->options.begin).text);
	if ((status = hawser__trace_determined(trace, &trace->here)))
		return status;
	memcpy(trace->start_y, trace->here.y, (size_t)orbit->size*sizeof(double));
	memcpy(trace->start_t, trace->here.t, (size_t)orbit->size*sizeof(double));
	trace->known = 1;
	trace->curve.ds = fmin(FIRST_STEP, hawser__trace_longest(trace));
	status = hawser__record_point(trace->frf, trace->amplitude, &trace->here, orbit,
	                              trace->report);
	return status || trace->options.begin == trace->options.from || orbit->own ? status
	       : mark_start(trace);
}
