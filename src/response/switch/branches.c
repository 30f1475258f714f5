/* response/switch/branches.c - see hawser/branches.h.
 *
 *    x      state at phase 0 of the old orbit at the event
 *    v      eigenvector of its period map, of the multiplier nearest to -1 or 1
 *
 * The new branch leaves the old one in the direction of v, at right angles to Omega. Its first orbit is
 * corrected in the plane through x + e v that is normal to v, where Omega is free: at fixed Omega
 * Newton's method would return to the old branch. The orbit must be none of the old branch: after a
 * period doubling it does not close after the period of the old one.
 *
 * The place of an orbit is its frequency, in that of the old branch, or the parameter of the family.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/branches.h>

#include "core/hold.h"
#include "core/report.h"
#include "response/time/flow.h"
#include "response/orbit/shooting.h"
#include "response/switch/slower.h"
#include "response/branch/trace.h"
#include "response/cycle/cycle.h"

#define SHORT 0.01 /* of the step to a branch point that is left out; chosen */
#define OFF 1e-4 /* least distance of the new orbit from the old branch, relative; chosen */
#define FINER 4 /* shorter steps than those that shooting begins with, which are coarse; chosen */
/* Distances of the first orbit from the old branch, relative to the orbit; chosen. Small ones are
 * first: in a cascade each branch is shorter and steeper than its parent, by Feigenbaum's numbers. */
static const double size[] = {1e-3, 1e-4, 1e-5, 3e-3, 0.01, 0.03, 0.1, 0.3};
enum { SIZE = sizeof size/sizeof *size, SMALL = 3 };
/* At a small distance Omega changes by less than this part of the parent's way to the event: in a
 * cascade the branch's own period doubling is at 0.2. Chosen. */
#define NEAR 0.1

/* --- the direction --- */

/* v [m]: the real eigenvector of A [m][m] (row-major) of the eigenvalue nearest to `target`. */
static enum hawser_status eigenvector(double *v, double *A, int m, double target,
                                      struct hawser_report *report)
{
	double *re = malloc(2*(size_t)m*sizeof *re), *im = re ? re + m : NULL;
	double *right = malloc((size_t)m*(size_t)m*sizeof *right);
	int info = re && right ? LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'V', m, A, m, re, im, NULL, 1, right,
	                                       m) : LAPACK_WORK_MEMORY_ERROR;
	int best = 0;
	enum hawser_status status = HAWSER_OK;

	if (hawser__lapack_starved(info))
		status = hawser__no_memory(report, "frf");
	else if (info)
		status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "frf",
		                      "the eigenvectors of the period map were not found");
	for (int i = 1; i < m && !status; i++)
		if (hypot(re[i] - target, im[i]) < hypot(re[best] - target, im[best]))
			best = i;
	for (int i = 0; i < m && !status; i++)
		v[i] = right[(size_t)i*(size_t)m + (size_t)best];
	free(re);
	free(right);
	return status;
}

enum hawser_status hawser__branch_period(double *x, double *A, const struct hawser_rom *rom,
                                         double omega, struct hawser_report *report)
{
	int steps = FINER*hawser__shooting_steps(rom, omega, 1);
	struct hawser__stretch period = {.h = 2.0*M_PI/steps, .steps = steps, .count = 1};
	double *by_omega = malloc(2*(size_t)rom->n*sizeof *by_omega);
	struct hawser__flow flow;
	enum hawser_status status = hawser__flow_init(&flow, rom, report);

	if (!status && !by_omega)
		status = hawser__no_memory(report, "frf");
	if (!status && A)
		hawser__flow_derive(&flow, x, A, by_omega, NULL, &period, omega);
	else if (!status)
		hawser__flow_map(&flow, x, NULL, &period, omega);
	hawser__flow_clear(&flow);
	free(by_omega);
	return status;
}

enum hawser_status hawser__branch_direction(double *v, const struct hawser_rom *rom, const double *x,
                                            double omega, double target,
                                            struct hawser_report *report)
{
	size_t m = 2*(size_t)rom->n;
	double *A = malloc((m + 1)*m*sizeof *A), *end = hawser__behind(A, m*m);
	enum hawser_status status = A ? HAWSER_OK : hawser__no_memory(report, "frf");

	if (!status) {
		memcpy(end, x, m*sizeof *x);
		status = hawser__branch_period(end, A, rom, omega, report);
	}
	if (!status)
		status = eigenvector(v, A, (int)m, target, report);
	free(A);
	return status;
}

/* --- the first orbit --- */

struct search {
	const struct hawser__slower *old, *new; /* models of the old and of the new branch */
	int b;                              /* periods of the old one in the new one */
	const struct hawser_frf_options *options;
	double reach;                       /* largest change of the place to a near orbit; 0: any */
	double start;                       /* place and */
	const double *near;                 /* [m] state of the old branch before the event */
	double *x, *v;                      /* [m] the old orbit and its direction */
	double *along, *state, *other;      /* [m] from the old orbit to the new one; this; workspace */
	double *A;                          /* [m][m] */
	struct hawser_report *report, why;  /* why: of the last attempt that failed */
};

static const struct hawser_rom_family *family_of(const struct hawser__slower *models)
{
	return models->family.model ? &models->family : NULL;
}

/* state [m] and place of the last orbit of a short trace. */
static enum hawser_status last_of(double *state, double *place, int *found,
                                  const struct hawser_rom *rom,
                                  const struct hawser_frf_options *options,
                                  struct hawser_report *why)
{
	struct hawser_frf frf;
	enum hawser_status status = hawser_frf_trace(&frf, rom, options, why);

	*found = frf.points > 0 && (options->max_points == 1 || frf.end == HAWSER_END_RANGE);
	if (*found)
		*place = frf.point[frf.points - 1].parameter;
	if (*found)
		memcpy(state, frf.state + (size_t)(frf.points - 1)*2*(size_t)rom->n,
		       2*(size_t)rom->n*sizeof *state);
	hawser_frf_clear(&frf);
	return status == HAWSER_ERR_MEMORY ? status : HAWSER_OK;
}

/* The old branch from the orbit before the event to `there`. */
static enum hawser_status walk(struct search *search, int *found, double there)
{
	const struct hawser_frf_options options = {.method = search->options->method,
		.family = family_of(search->old), .from = search->start, .to = there,
		.tolerance = search->options->tolerance, .start = search->near, .skip_events = 1,
		.samples = HAWSER_NONE, .step_max = 0.3};
	double unused;

	*found = there == search->start;
	if (*found) {
		memcpy(search->x, search->near, 2*(size_t)search->old->rom->n*sizeof *search->x);
		return HAWSER_OK;
	}
	return last_of(search->x, &unused, found, search->old->rom, &options, &search->why);
}

/* The period map of the old branch's model at this place, as hawser__branch_period. */
static enum hawser_status old_period(struct search *search, double *x, double *A, double there)
{
	const struct hawser_rom_family *family = family_of(search->old);
	const struct hawser_rom *rom = search->old->rom;
	enum hawser_status status = !family ? HAWSER_OK
	                            : family->model(family->context, &rom, there, search->report);

	return status ? status : hawser__branch_period(x, A, rom, family ? family->omega*rom->time : there,
	                                               search->report);
}

static double distance(const double *a, const double *b, int m)
{
	double gap = 0.0, whole = 0.0;

	for (int i = 0; i < m; i++) {
		gap += (a[i] - b[i])*(a[i] - b[i]);
		whole += b[i]*b[i];
	}
	return sqrt(gap/fmax(whole, 1e-300));
}

/* The old orbit at `there` and its direction, in x and v; *found is 0 if there is none. */
static enum hawser_status old_orbit(struct search *search, int *found, double there)
{
	int m = 2*search->old->rom->n;
	double extent;
	enum hawser_status status = walk(search, found, there);

	if (status || !*found)
		return status;
	memcpy(search->other, search->x, (size_t)m*sizeof *search->x);
	status = old_period(search, search->other, search->A, there);
	if (!status)
		status = eigenvector(search->v, search->A, m, search->b == 2 ? -1.0 : 1.0, search->report);
	extent = cblas_dnrm2(m, search->x, 1);
	if (!status) /* rest has no size: that of the model's scale */
		cblas_dscal(m, (extent > 0.0 ? extent : 1.0)/fmax(cblas_dnrm2(m, search->v, 1), 1e-300),
		            search->v, 1);
	return status;
}

/* The orbit at the distance e in the direction of v; *found is 1 for one of another branch, at
 * *place. */
static enum hawser_status attempt(struct search *search, int *found, double *place, double there,
                                  double e)
{
	const struct hawser_rom_family *family = family_of(search->new);
	double per = family ? 1.0 : search->b;
	struct hawser_frf_options options = {.method = search->options->method, .family = family,
		.from = family ? search->options->from : 0.9*there/per,
		.to = family ? search->options->to : 1.1*there/per, .begin = there/per,
		.tolerance = search->options->tolerance, .start = search->x, .along = search->along,
		.max_points = 1, .skip_events = 1, .samples = HAWSER_NONE};
	int m = 2*search->new->rom->n, twice = search->b > 1;
	enum hawser_status status;

	for (int i = 0; i < m; i++)
		search->along[i] = e*search->v[i];
	status = last_of(search->state, place, found, search->new->rom, &options, &search->why);
	if (status || !*found)
		return status;
	*place *= per;
	memcpy(search->other, search->state, (size_t)m*sizeof *search->other);
	if (twice) /* the direction changes its sign: their distance is 2 e */
		status = old_period(search, search->other, NULL, *place);
	*found = distance(twice ? search->other : search->x, search->state, m) > (twice ? 0.5 : OFF)*e;
	return status;
}

/* *place: that of the first orbit, whose state is search->state and which is search->along from
 * search->x; NAN if none was found. `at`: of the event. */
static enum hawser_status look(struct search *search, double *place, double at)
{
	enum hawser_status status;
	int found;

	*place = NAN;
	if (search->b == 1) /* where the old orbit's Jacobian is singular */
		at += SHORT*(search->start - at);
	if ((status = old_orbit(search, &found, at)))
		return status;
	for (int k = 0, may = found; may && k < SIZE; k++) {
		if ((status = attempt(search, &found, place, at, size[k])))
			return status;
		/* another one may lie beyond events */
		if (found && (k >= SMALL || search->reach == 0.0 || fabs(*place - at) < search->reach))
			return status;
		*place = NAN;
	}
	return HAWSER_OK;
}

/* --- the branch --- */

/* place, at: of the first orbit, and of the event. */
static enum hawser_status follow(struct hawser_frf *branch, const struct search *search, int periods,
                                 double place, double at, struct hawser_report *report)
{
	struct hawser_frf_options options = *search->options;
	double lo = fmin(options.from, options.to), hi = fmax(options.from, options.to);
	double per = options.family ? 1.0 : search->b;
	enum hawser_status status;

	options.family = family_of(search->new);
	options.from = (place > at ? lo : hi)/per;
	options.to = (place > at ? hi : lo)/per;
	options.begin = at/per;
	options.start = search->x;
	options.along = search->along;
	status = hawser_frf_trace(branch, search->new->rom, &options, report);
	hawser__frf_in_loads(branch, periods, options.family != NULL);
	return status;
}

static enum hawser_status check(const struct hawser_frf *from, int event,
                                struct hawser_report *report)
{
	const struct hawser_frf_event *at = event >= 0 && event < from->events ? &from->event[event] : NULL;

	if (at && at->located && (at->kind == HAWSER_PERIOD_DOUBLING || at->kind == HAWSER_BRANCH_POINT))
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
	                    "event %d begins no branch that can be followed: a located period doubling or "
	                    "branch point does", event);
}

enum hawser_status hawser_branch_switch(struct hawser_frf *branch, const struct hawser_rom *rom,
                                        const struct hawser_frf *from, int event,
                                        const struct hawser_frf_options *options,
                                        struct hawser_report *report)
{
	const struct hawser_frf_event *at = from->event + event;
	int m = 2*rom->n, P = from->period, b;
	double per = options->family ? 1.0 : P, place;
	struct hawser_frf_options range = *options;
	struct hawser__slower old = {.rom = NULL}, new = {.rom = NULL};
	struct search search = {.options = &range, .old = &old, .new = &new, .report = report};
	double *memory;
	enum hawser_status status;

	if (event < from->events && options->family && options->family->omega == 0.0)
		return event < 0 ? hawser__own_leave(branch, rom, from, event < -1, options, report)
		                 : hawser__own_switch(branch, rom, from, event, options, report);
	status = check(from, event, report);

	*branch = (struct hawser_frf){.n = rom->n};
	if (status)
		return status;
	b = at->kind == HAWSER_PERIOD_DOUBLING ? 2 : 1;
	memory = malloc(((size_t)m + 5)*(size_t)m*sizeof *memory);
	if (!memory)
		return hawser__no_memory(report, "frf");
	search.near = from->state + (size_t)at->after*(size_t)m;
	search.start = from->point[at->after].parameter/per;
	search.reach = from->parent ? NEAR*fabs(at->parameter - from->born_at)/per : 0.0;
	search.A = memory;
	search.x = memory + (size_t)m*(size_t)m;
	search.v = search.x + m;
	search.state = search.v + m;
	search.other = search.state + m;
	search.along = search.other + m;
	search.b = b;
	range.from /= per; /* in the frequency of the old branch */
	range.to /= per;
	status = hawser__slower_open(&old, rom, options->family, P/hawser__rom_periods(rom), report);
	if (!status)
		status = hawser__slower_open(&new, rom, options->family, P/hawser__rom_periods(rom)*b, report);
	if (!status)
		status = look(&search, &place, at->parameter/per);
	if (!status && isnan(place))
		status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "frf",
		                      "no orbit of another branch was found beside the %s at Omega %.9g%s; the "
		                      "last attempt: %s", hawser_event_name(at->kind),
		                      HAWSER_SHOWN(rom, at->omega/hawser__rom_periods(rom)),
		                      search.why.message[0] ? search.why.message : "it led to the old branch");
	if (!status)
		status = follow(branch, &search, P*b, place, at->parameter/per, report);
	branch->parent = from->branch;
	branch->born = at->omega;
	branch->born_at = at->parameter;
	hawser__slower_close(&old);
	hawser__slower_close(&new);
	free(memory);
	return status;
}

enum hawser_status hawser_branch_trace(struct hawser_frf *branch, const struct hawser_rom *rom,
                                       int periods, const struct hawser_frf_options *options,
                                       struct hawser_report *report)
{
	struct hawser_frf_options slow = *options;
	struct hawser__slower slower = {.rom = NULL};
	int own = hawser__rom_periods(rom);
	double per = options->family ? 1.0 : periods;
	enum hawser_status status;

	*branch = (struct hawser_frf){.n = rom->n};
	if (periods < 1 || periods % own)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "a motion of %d periods of the load: give a multiple of %d", periods, own);
	slow.from /= per;
	slow.to /= per;
	slow.begin /= per;
	status = hawser__slower_open(&slower, rom, options->family, periods/own, report);
	slow.family = family_of(&slower);
	if (!status)
		status = hawser_frf_trace(branch, slower.rom, &slow, report);
	hawser__frf_in_loads(branch, periods, slow.family != NULL);
	hawser__slower_close(&slower);
	return status;
}
