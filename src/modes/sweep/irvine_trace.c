/* modes/sweep/irvine_trace.c - sweep the tension: from the options to the result.
 *
 * The abscissa is the logarithm of H; for a travelling cable that of the apparent H, since at any
 * speed there is exactly one steady state for each apparent H.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/sweep/branches.h"

enum { POINTS = 200, BRANCHES = 10, BRANCHES_MOST = 500 };
static const double default_correlation = 0.9, default_crossing = 1e-10;
/* Smallest step, in log H. */
static const double least_step = 1e-9;

static enum hawser_status statics_at(struct hawser_statics *st, const struct hawser__branches *all,
                                double x, struct hawser_report *report)
{
	const struct hawser_irvine_options *o = all->context;
	enum hawser_status status = hawser__irvine_at(st, &all->span, o, exp(x), report);

	st->bending = o->bending;
	return status || !o->held ? status : hawser_statics_hold(st, o->held, report);
}

static void describe(char *text, size_t size, const struct hawser_statics *st)
{
	snprintf(text, size, "H = %.12g N", hawser_irvine_value(st, HAWSER_GIVEN_H));
}

const char *hawser_crossover_name(enum hawser_crossover_kind kind)
{
	return kind == HAWSER_CROSSING ? "crossing" : "veering";
}

double hawser_irvine_string(const struct hawser_irvine_station *station)
{
	const struct hawser_statics *st = &station->statics;

	return M_PI*sqrt(hawser_irvine_value(st, HAWSER_GIVEN_H)
	                 /(st->span.rho/(1.0 - st->motion.mach2)))/st->span.d;
}

void hawser_irvine_clear(struct hawser_irvine *irvine)
{
	if (!irvine)
		return;
	hawser__hold_clear(&(struct hawser__hold){.last = irvine->held});
	*irvine = (struct hawser_irvine){0};
}

static enum hawser_status check(const struct hawser_irvine_options *o, struct hawser_report *report)
{
	const char *name = hawser_given_name(o->sweep);

	if (o->attachments > 0 && (o->speed != 0.0 || o->fluctuation != 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "irvine",
		                    "attachments are at rest, and a cable at %g m/s would move past them: "
		                    "sweep one without the other", o->speed);
	if (o->n < 1 || o->n > BRANCHES_MOST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "irvine",
		                    "%d branches asked: ask for 1 to %d", o->n, BRANCHES_MOST);
	if (o->points < 2)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "irvine",
		                    "a sweep of %d points: ask for two at least", o->points);
	if (!(o->from > 0.0 && o->to > 0.0) || isinf(o->from) || isinf(o->to) || o->from == o->to)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "irvine",
		                    "%s from %g to %g: give two different positive values", name,
		                    o->from, o->to);
	if (!(o->correlation > 0.5 && o->correlation < 1.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "irvine",
		                    "a squared correlation of %g: give one in (0.5, 1), or 0 for %g",
		                    o->correlation, default_correlation);
	if (!(o->crossing > 0.0 && o->crossing < 1e-3))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "irvine",
		                    "a gap of %g for crossings: give a relative gap in (0, 0.001), or 0 "
		                    "for %g", o->crossing, default_crossing);
	return HAWSER_OK;
}

/* Replace zeros by defaults. */
static enum hawser_status settle(struct hawser_irvine_options *o, const struct hawser_span *span,
                                 struct hawser_report *report)
{
	double from = o->from, to = o->to;

	o->sweep = o->sweep == HAWSER_GIVEN_NONE ? HAWSER_GIVEN_H : o->sweep;
	o->points = o->points == 0 ? POINTS : o->points;
	o->n = o->n == 0 ? BRANCHES : o->n;
	o->correlation = o->correlation == 0.0 ? default_correlation : o->correlation;
	o->crossing = o->crossing == 0.0 ? default_crossing : o->crossing;
	if (o->from == 0.0 || o->to == 0.0) {
		enum hawser_status status = hawser__irvine_range(&from, &to, span, o, o->sweep, report);

		if (status)
			return status;
	}
	o->from = o->from == 0.0 ? from : o->from;
	o->to = o->to == 0.0 ? to : o->to;
	return check(o, report);
}

/* --- from places to branches --- */

static enum hawser_status allocate(struct hawser_irvine *irvine,
                                   const struct hawser__branches *all, struct hawser_report *report)
{
	size_t stations = (size_t)all->samples, branches = (size_t)all->in + (size_t)all->out;
	struct hawser__hold hold = {0};

	irvine->station = hawser__hold(&hold, stations, sizeof *irvine->station);
	irvine->branch = hawser__hold(&hold, branches, sizeof *irvine->branch);
	irvine->crossover = hawser__hold(&hold, (size_t)all->crossovers + 1, sizeof *irvine->crossover);
	irvine->omega = hawser__hold(&hold, stations*branches, sizeof *irvine->omega);
	irvine->residual = hawser__hold(&hold, stations*branches, sizeof *irvine->residual);
	irvine->place = hawser__hold(&hold, stations*branches, sizeof *irvine->place);
	irvine->symmetry = hawser__hold(&hold, stations*branches, sizeof *irvine->symmetry);
	irvine->family = hawser__hold(&hold, stations*branches, sizeof *irvine->family);
	irvine->held = hold.last;
	return hold.short_of_memory ? hawser__no_memory(report, "irvine") : HAWSER_OK;
}

static void fill_branch(void *result, size_t at, int place, const struct hawser_mode *mode)
{
	struct hawser_irvine *irvine = result;

	irvine->omega[at] = mode->omega;
	irvine->residual[at] = mode->residual;
	irvine->place[at] = place;
	irvine->symmetry[at] = mode->symmetry;
	irvine->family[at] = mode->family;
}

static void fill_station(void *result, int i, const struct hawser__sample *sample)
{
	struct hawser_irvine *irvine = result;

	irvine->station[i] = (struct hawser_irvine_station){
		sample->statics, hawser_irvine_value(&sample->statics, irvine->sweep), expm1(sample->moved),
		sample->inserted};
}

static void fill_crossover(void *result, const struct hawser__crossover *at, int below, int above)
{
	struct hawser_irvine *irvine = result;

	irvine->crossover[irvine->crossovers++] = (struct hawser_irvine_crossover){
		.kind = at->kind, .value = hawser_irvine_value(&at->statics, irvine->sweep),
		.H = hawser_irvine_value(&at->statics, HAWSER_GIVEN_H), .irvine = at->statics.irvine,
		.irvine_source = at->statics.irvine_source, .below = below, .above = above,
		.omega = at->omega, .gap = at->gap*at->omega, .relative_gap = at->gap};
}

static const struct hawser__sweep resting = {"irvine", statics_at, describe, fill_station,
                                             fill_branch, fill_crossover, 0, 0, 0};
static const struct hawser__sweep travelling = {"irvine", statics_at, describe, fill_station,
                                                fill_branch, fill_crossover, 1, 0, 0};

static enum hawser_status finish(struct hawser_irvine *irvine, struct hawser__branches *all,
                                 struct hawser_report *report)
{
	const struct hawser_irvine_options *options = all->context;
	enum hawser_status status = allocate(irvine, all, report);

	if (status)
		return status;
	irvine->span = all->span;
	irvine->sweep = options->sweep;
	irvine->speed = options->speed;
	irvine->fluctuation = options->fluctuation;
	irvine->method = all->method;
	irvine->stations = all->samples;
	irvine->branches = all->in + all->out;
	irvine->in_plane = all->in;
	irvine->solves = all->solves;
	irvine->least_correlation = all->least_correlation;
	hawser__branches_read(irvine, irvine->branch, all);
	return HAWSER_OK;
}

enum hawser_status hawser_irvine_trace(struct hawser_irvine *irvine,
                                       const struct hawser_span *span,
                                       const struct hawser_irvine_options *options,
                                       struct hawser_report *report)
{
	struct hawser_irvine_options o = *options;
	struct hawser__branches all = {.span = *span, .context = &o};
	double *x = NULL;
	enum hawser_status status;

	*irvine = (struct hawser_irvine){0};
	status = settle(&o, span, report);
	if (status)
		return status;
	all.sweep = o.speed != 0.0 || o.fluctuation != 0.0 ? &travelling : &resting;
	all.options = (struct hawser__branch_options){o.n, o.method, o.basis, o.tolerance,
	                                              o.correlation, o.crossing, least_step};
	x = malloc((size_t)o.points*sizeof *x);
	if (!x)
		return hawser__no_memory(report, "irvine");
	status = hawser__irvine_place(x, o.points, span, &o, report);
	if (!status)
		status = hawser__branches_open(&all, report);
	if (!status)
		status = hawser__branches_follow(&all, x, o.points, report);
	if (!status)
		status = hawser__branches_veerings(&all, report);
	if (!status)
		status = finish(irvine, &all, report);
	if (status)
		hawser_irvine_clear(irvine);
	hawser__branches_clear(&all);
	free(x);
	return status;
}
