/* response/branch/detour.c - ways to the first orbit of a branch that pass other orbits.
 *
 * Newton's method finds an orbit from a guess that is near. Where neither the linear response, nor
 * loads that increase, nor the motion from rest is, an orbit that is found elsewhere is followed to
 * the place where the branch begins:
 *
 *   over the load       from the greatest load that could be reached. Loads that increase end at a
 *                       fold, which a curve by arclength passes
 *   over the parameter  from the other end of the range
 *
 * Neither need lead there: a model that softens without bound may have no orbit at this load. So a
 * curve is given up after some work, more than those that arrive need. What a way leads to is an
 * orbit of the model itself, with its whole load, and is corrected by the method of the branch.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "response/orbit/start.h"
#include "response/branch/trace.h"

/* Work of a way: the sum of the steps of its orbits (shooting; coefficients of harmonic balance) times
 * the number of coordinates or MANY, whichever is less. Those of 50 random strongly forced oscillators
 * and spans that arrived over the load needed 900 to 165 000, but one 260 000; over the frequency, up
 * to 10 000. With 12 coordinates it is some 400 points. */
#define MANY 4
static const double most_work[HAWSER__WAYS] = {1.7e5, 4e4};

#define FAINT 1e-3 /* least load of the curve over it, relative to that where it begins; chosen */
#define COARSE 0.1 /* largest step, relative to the range: events are of no interest; chosen */

/* After each step: whether the way is given up, since no work is left. */
static enum hawser_status count(void *context, struct hawser__trace *trace)
{
	double *left = context;

	*left -= (double)trace->orbit->resolution*fmin(trace->orbit->n, MANY);
	return *left > 0.0 ? HAWSER_OK : HAWSER_ERR_CONVERGENCE;
}

/* The trace that the detour is for has no points yet. */
static int watch(void *data, const struct hawser_progress_state *state)
{
	struct hawser__trace *trace = data;
	struct hawser_progress_state told = *state;

	told.frf = trace->frf;
	trace->stopped |= hawser__told_to_stop(&trace->options.progress, &told);
	return trace->stopped;
}

static void tell(char tried[80], const struct hawser_frf *frf, enum hawser_status status, int given_up)
{
	if (given_up)
		snprintf(tried, 80, "it did not in %d points", frf->points);
	else if (status)
		snprintf(tried, 80, frf->points ? "it was lost after %d points" : "it has no beginning",
		         frf->points);
	else
		snprintf(tried, 80, "%s", frf->end == HAWSER_END_INTERRUPTED ? "it was interrupted"
		                                                            : "it turned back");
}

/* Follow the curve; the goal is where its parameter is options->to. */
static enum hawser_status follow(double *x, int *found, char tried[80], struct hawser__trace *trace,
                                 const struct hawser_frf_options *options, int way)
{
	double left = most_work[way];
	const struct hawser__trace_watch plain = {.direct = 1, .coarse = 1, .context = &left,
		.step = count};
	int m = trace->orbit->m;
	struct hawser_frf frf;
	enum hawser_status status = hawser__frf_trace(&frf, trace->orbit->rom, options, &plain, NULL);

	*found = !status && frf.end == HAWSER_END_RANGE &&
	         (frf.point[frf.points - 1].direction > 0) == (options->to > options->from);
	if (*found)
		memcpy(x, frf.state + (size_t)m*((size_t)frf.points - 1), (size_t)m*sizeof *x);
	else
		tell(tried, &frf, status, !(left > 0.0));
	hawser_frf_clear(&frf);
	return status == HAWSER_ERR_MEMORY ? hawser__no_memory(trace->report, "frf") : HAWSER_OK;
}

/* From the orbit at the greatest load that was reached. */
static enum hawser_status over_load(double *x, int *found, char tried[80],
                                    struct hawser__trace *trace, struct hawser_frf_options *options,
                                    const struct hawser__raised *raised)
{
	const struct hawser_rom_family *own = options->family;
	const struct hawser_rom *rom = trace->orbit->rom;
	double omega = own ? own->omega : options->to/rom->time;
	struct hawser_rom_family loads;
	enum hawser_status status;

	snprintf(tried, 80, "it has no beginning");
	if (!(raised->load > 0.0))
		return HAWSER_OK;
	status = hawser_factor_open(&loads, rom, HAWSER_FACTOR_LOAD, omega, NULL);
	if (status)
		return status == HAWSER_ERR_MEMORY ? hawser__no_memory(trace->report, "frf") : HAWSER_OK;
	/* cppcheck-suppress autoVariables ; its options are not used again */
	options->family = &loads;
	options->from = FAINT*raised->load;
	options->to = 1.0;
	options->begin = raised->load;
	options->start = raised->x;
	status = follow(x, found, tried, trace, options, 0);
	hawser_factor_close(&loads);
	return status;
}

enum hawser_status hawser__detour(double *x, int *found, char tried[80], struct hawser__trace *trace,
                                  int way, const struct hawser__raised *raised)
{
	const struct hawser_frf_options *own = &trace->options;
	int periods = own->family ? 1 : hawser__rom_periods(trace->orbit->rom);
	struct hawser_frf_options options = {.method = trace->frf->method, .family = own->family,
		.tolerance = own->tolerance, .step_max = COARSE, .skip_events = 1, .samples = HAWSER_NONE,
		.progress = {watch, trace}};

	*found = 0;
	if (trace->watch)
		options.most_work = trace->watch->first;
	if (strcmp(options.method, hawser__scales_method.about.name) == 0)
		options.method = NULL;
	options.from = periods*(own->begin == own->to ? own->from : own->to);
	options.to = periods*own->begin;
	return way == 0 ? over_load(x, found, tried, trace, &options, raised)
	                : follow(x, found, tried, trace, &options, way);
}
