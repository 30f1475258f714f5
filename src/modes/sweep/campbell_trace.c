/* modes/sweep/campbell_trace.c - sweep the speed: from the options to the result.
 *
 * The abscissa is the speed. Shapes are correlated in the inner product of the energy
 * (branches_sample.c). The theory of branches_crossover.c holds for complex modes too: near the
 * point where two frequencies are closest they are eigenvalues of a Hermitian 2 x 2 matrix, so that
 * the square of their gap is a parabola to leading order. The Coriolis force couples even and odd
 * shapes, so that no symmetry uncouples two in-plane branches of a travelling cable. A level span
 * therefore has crossings along a sweep of the tension at rest, but veerings along a sweep of the
 * speed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>

#include "core/hold.h"
#include "core/names.h"
#include "core/report.h"
#include "modes/sweep/branches.h"

static const char where[] = "campbell";
/* Smallest step relative to the limit. */
static const double least_step = 1e-11;
/* Part of the time of a sweep when its branches have been followed, before veerings; measured on the
 * travelling cables of B. */
static const double followed = 0.95;

HAWSER__NAMES(hawser_critical_name, enum hawser_critical_kind, "divergence", "flutter",
	"no-steady-state")

void hawser_campbell_clear(struct hawser_campbell *campbell)
{
	if (!campbell)
		return;
	hawser__hold_clear(&(struct hawser__hold){.last = campbell->held});
	*campbell = (struct hawser_campbell){0};
}

/* What a sweep is of. */
struct source {
	const struct hawser_scene *scene;
	struct hawser_equivalent equal;
};

static enum hawser_status statics_at(struct hawser_statics *st, const struct hawser__branches *all,
                                double x, struct hawser_report *report)
{
	const struct source *source = all->context;
	const struct hawser_equivalent *equal = &source->equal;
	const struct hawser_motion motion = {.speed = x,
	                                     .fluctuation = source->scene->travel.fluctuation,
	                                     .hold = source->scene->travel.hold};

	return hawser_statics_travel(st, &equal->span, equal->given, equal->value, equal->branch,
	                             &motion, report);
}

static void describe(char *text, size_t size, const struct hawser_statics *st)
{
	snprintf(text, size, "a speed of %.12g m/s", st->motion.speed);
}

/* --- from places to branches --- */

static enum hawser_status allocate(struct hawser_campbell *campbell,
                                   const struct hawser__branches *all, struct hawser_report *report)
{
	size_t stations = (size_t)all->samples, branches = (size_t)all->in + (size_t)all->out;
	size_t size = stations*branches;
	struct hawser__hold hold = {0};

	campbell->station = hawser__hold(&hold, stations, sizeof *campbell->station);
	campbell->branch = hawser__hold(&hold, branches, sizeof *campbell->branch);
	campbell->crossover = hawser__hold(&hold, (size_t)all->crossovers + 1, sizeof *campbell->crossover);
	campbell->critical = hawser__hold(&hold, 1, sizeof *campbell->critical);
	campbell->re = hawser__hold(&hold, size, sizeof *campbell->re);
	campbell->im = hawser__hold(&hold, size, sizeof *campbell->im);
	campbell->residual = hawser__hold(&hold, size, sizeof *campbell->residual);
	campbell->downstream = hawser__hold(&hold, size, sizeof *campbell->downstream);
	campbell->place = hawser__hold(&hold, size, sizeof *campbell->place);
	campbell->family = hawser__hold(&hold, size, sizeof *campbell->family);
	campbell->held = hold.last;
	return hold.short_of_memory ? hawser__no_memory(report, where) : HAWSER_OK;
}

static void fill_branch(void *result, size_t at, int place, const struct hawser_mode *mode)
{
	struct hawser_campbell *campbell = result;

	campbell->re[at] = mode->re;
	campbell->im[at] = mode->omega;
	campbell->residual[at] = mode->residual;
	campbell->downstream[at] = mode->downstream;
	campbell->family[at] = mode->family;
	campbell->place[at] = place;
}

static void fill_station(void *result, int i, const struct hawser__sample *sample)
{
	struct hawser_campbell *campbell = result;

	campbell->station[i] = (struct hawser_campbell_station){
		sample->statics, sample->x, sample->moved, sample->inserted, sample->unsure};
	campbell->unsure += sample->unsure;
}

static void fill_crossover(void *result, const struct hawser__crossover *at, int below, int above)
{
	struct hawser_campbell *campbell = result;

	campbell->crossover[campbell->crossovers++] = (struct hawser_campbell_crossover){
		.kind = at->kind, .speed = at->x, .below = below, .above = above,
		.omega = at->omega, .gap = at->gap*at->omega, .relative_gap = at->gap};
}

static const struct hawser__sweep sweep = {where, statics_at, describe, fill_station, fill_branch,
                                           fill_crossover, 1, 1, 1};

static enum hawser_status finish(struct hawser_campbell *campbell, struct hawser__branches *all,
                                 struct hawser_report *report)
{
	enum hawser_status status = allocate(campbell, all, report);

	if (status)
		return status;
	campbell->method = all->method;
	campbell->stations = all->samples;
	campbell->branches = all->in + all->out;
	campbell->in_plane = all->in;
	campbell->solves = all->solves;
	campbell->basis = all->basis;
	campbell->least_correlation = all->least_correlation;
	hawser__branches_read(campbell, campbell->branch, all);
	return HAWSER_OK;
}

/* Stations beyond the last requested one, which approach the limit, count as inserted. */
static void mark_approach(struct hawser__branches *all, double last)
{
	for (int i = all->samples - 1; i >= 0 && all->sample[i].x > last; i--)
		all->sample[i].inserted = 1;
}

enum hawser_status hawser_campbell_trace(struct hawser_campbell *campbell,
                                         const struct hawser_scene *scene,
                                         const struct hawser_campbell_options *options,
                                         struct hawser_report *report)
{
	struct hawser_campbell_options o = *options;
	struct source source = {.scene = scene};
	struct hawser__branches all = {.sweep = &sweep, .context = &source};
	double *x = NULL;
	struct hawser_held held[2];
	int count, asked;
	enum hawser_status status;

	*campbell = (struct hawser_campbell){0};
	status = hawser__campbell_settle(&o, &campbell->limit, scene, report);
	if (!status)
		status = hawser_statics_equivalent(&source.equal, scene, report);
	if (!status && hawser_statics_held(held, scene))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                      "the supports are elastic: travelling cables are modelled between rigid "
		                      "supports, leave support.A.stiffness and support.B.stiffness out");
	if (status)
		return status;
	all.span = source.equal.span;
	all.options = (struct hawser__branch_options){o.n, o.method, o.basis, o.tolerance,
	                                              o.correlation, o.crossing,
	                                              least_step*campbell->limit};
	status = hawser__campbell_place(&x, &count, &asked, &o, campbell->limit, report);
	if (!status)
		status = hawser__branches_open(&all, report);
	all.progress = &o.progress;
	all.done.began = hawser__wall_seconds();
	hawser__span_stage(&all.done, 0.0, followed);
	if (!status)
		status = hawser__branches_follow(&all, x, count, report);
	hawser__span_stage(&all.done, followed, 1.0);
	if (!status) {
		mark_approach(&all, x[asked - 1]);
		status = hawser__branches_veerings(&all, report);
	}
	if (!status)
		status = finish(campbell, &all, report);
	if (!status && o.to >= campbell->limit)
		campbell->critical[campbell->criticals++] = (struct hawser_critical){
			campbell->limit, HAWSER_CRITICAL_NO_STEADY_STATE, HAWSER_IN_PLANE};
	if (status)
		hawser_campbell_clear(campbell);
	hawser__branches_clear(&all);
	free(x);
	return status;
}
