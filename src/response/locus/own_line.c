/* response/locus/own_line.c - a bifurcation of an autonomous model on a line across its locus.
 *
 * On the line the model is one over a single parameter t, whose equilibria and cycles are followed as
 * any others: the bifurcation is the event of that kind. A Hopf point needs no branch, but Newton's
 * method for the growth of its pair (cycle/hopf.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/cycle/cycle.h"
#include "response/cycle/hopf.h"
#include "response/locus/locus_own.h"

enum { POINTS = 300 }; /* of a branch along a line, at most; chosen */
#define NEAR 0.25 /* distance of the nearer state from the event, to that of the other; chosen */

/* --- eigenvalues besides the critical ones --- */

/* How far eigenvalue i is from the critical ones. */
static double from_critical(const double *re, const double *im, int i, double omega)
{
	return hypot(re[i], fabs(im[i]) - omega);
}

/* Tests and count of the equilibrium of `spot`. */
static enum hawser_status judge_rest(struct hawser__own_spot *spot, const struct hawser_rom *rom,
                                     struct hawser_report *report)
{
	size_t m = 2*(size_t)rom->n, n = (size_t)rom->n;
	double *memory = calloc(2*m*m + 5*m, sizeof *memory), *A = memory, *by_u = A + m*m;
	double *work = by_u + m*m, *re = work + 3*m, *im = re + m, unused;
	int order, info, critical[2] = {0, 0};

	if (!memory)
		return hawser__no_memory(report, "locus");
	order = hawser__autonomous_matrix(A, by_u, by_u + n*n, work, rom, spot->state, spot->state + n);
	info = LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'N', order, A, order, re, im, &unused, 1, &unused, 1);
	for (int i = 1; i < order; i++) /* the two next to the axis at +- i omega, or at 0 */
		if (from_critical(re, im, i, spot->omega) < from_critical(re, im, critical[0], spot->omega))
			critical[0] = i;
	critical[1] = spot->omega > 0.0 ? critical[0] + (im[critical[0]] > 0.0 ? 1 : -1) : critical[0];
	spot->unstable = 0;
	for (int i = 0; i < order; i++) {
		int which = im[i] == 0.0 ? HAWSER__OWN_REAL : HAWSER__OWN_PAIR;

		if (i == critical[0] || i == critical[1])
			continue;
		spot->unstable += re[i] > 0.0;
		if (!(fabs(re[i]) >= fabs(spot->test[which])))
			spot->test[which] = re[i];
	}
	free(memory);
	return hawser__lapack_starved(info) ? hawser__no_memory(report, "locus") : HAWSER_OK;
}

/* --- on the line --- */

static enum hawser_status meet_hopf(struct hawser__own_spot *to, int *found,
                                    struct hawser__own_line *line,
                                    const struct hawser__own_spot *from, double reach,
                                    struct hawser_report *report)
{
	size_t n = (size_t)line->n;
	double *wave = malloc(2*n*sizeof *wave), t = 0.0;
	const struct hawser_rom *rom;
	struct hawser_hopf hopf = {.turning = 0};
	enum hawser_status status = wave ? HAWSER_OK : hawser__no_memory(report, "locus");

	memset(to->state, 0, 2*n*sizeof *to->state);
	memcpy(to->state, from->state, n*sizeof *to->state);
	if (!status)
		status = hawser__hopf_near(&hopf, wave, to->state, &t, &line->family, from->omega, 1.0, NULL);
	free(wave);
	*found = !status && fabs(t) <= reach;
	if (!*found)
		return status == HAWSER_ERR_MEMORY ? hawser__no_memory(report, "locus") : HAWSER_OK;
	to->omega = hopf.omega;
	to->angle = 0.0;
	to->error = 1e-11; /* NEAR of cycle/hopf.c */
	to->test[HAWSER__OWN_DEGENERATE] = hopf.l1;
	for (int k = 0; k < 2; k++)
		to->at[k] = line->base[k] + t*line->normal[k];
	if (line->family.model(line->family.context, &rom, t, NULL)) {
		*found = 0;
		return HAWSER_OK;
	}
	to->time = rom->time;
	return judge_rest(to, rom, report);
}

/* The event of that kind next to t = 0, or -1. */
static int nearest_event(const struct hawser_frf *frf, enum hawser_event_kind kind, double reach)
{
	int best = -1;

	for (int e = 0; e < frf->events; e++)
		if (frf->event[e].kind == kind && frf->event[e].located &&
		    fabs(frf->event[e].parameter) <= reach &&
		    (best < 0 || fabs(frf->event[e].parameter) < fabs(frf->event[best].parameter)))
			best = e;
	return best;
}

/* Of the complex pair [m] (logarithm of the modulus, argument) next to the unit circle. */
static double pair_angle(const double *multiplier, int m)
{
	int best = -1;

	for (int i = 0; i < m; i++)
		if (fabs(sin(multiplier[2*i + 1])) > 0.0 &&
		    (best < 0 || fabs(multiplier[2*i]) < fabs(multiplier[2*best])))
			best = i;
	return best < 0 ? 0.0 : fabs(multiplier[2*best + 1]);
}

/* The first point of the branch to event e, and one that is nearer. */
static void take_beside(struct hawser__own_spot *to, const struct hawser_frf *frf, int e)
{
	double at = frf->event[e].parameter;
	int i = frf->event[e].after;

	while (i > 0 && fabs(frf->point[i].parameter - at) < NEAR*fabs(frf->point[0].parameter - at))
		i--;
	for (int k = 0; k < 2; k++) {
		size_t m = 2*(size_t)frf->n, which = k ? (size_t)i : 0;

		to->beside[k].t = frf->point[which].parameter;
		to->beside[k].omega = frf->point[which].omega;
		memcpy(to->beside[k].state, frf->state + m*which, m*sizeof(double));
	}
}

/* *to from event e of the branch. */
static enum hawser_status take_event(struct hawser__own_spot *to, const struct hawser_frf *frf, int e,
                                     const struct hawser__own_line *line,
                                     struct hawser_report *report)
{
	const struct hawser_frf_event *event = &frf->event[e];
	size_t m = 2*(size_t)line->n;
	const struct hawser_rom *rom;

	memcpy(to->state, frf->event_state + m*(size_t)e, m*sizeof *to->state);
	take_beside(to, frf, e);
	to->omega = line->cycles ? event->omega : 0.0;
	to->angle = event->kind == HAWSER_PERIOD_DOUBLING ? M_PI : 0.0;
	if (event->kind == HAWSER_TORUS)
		to->angle = pair_angle(frf->multiplier + m*2*(size_t)event->after, (int)m);
	to->error = event->error;
	to->unstable = event->unstable[0] < event->unstable[1] ? event->unstable[0] : event->unstable[1];
	for (int k = 0; k < 2; k++)
		to->at[k] = line->base[k] + event->parameter*line->normal[k];
	if (line->cycles || line->family.model(line->family.context, &rom, event->parameter, NULL))
		return HAWSER_OK;
	return judge_rest(to, rom, report);
}

/* The branch on the line from a state beside that of another line: *e, its event, or -1. */
static enum hawser_status trace_line(struct hawser_frf *frf, int *e,
                                     const struct hawser__own_line *line,
                                     const struct hawser__own_beside *beside, double reach)
{
	struct hawser_frf_options choice = {.family = &line->family, .start = beside->state,
		.omega = beside->omega, .from = beside->t, .begin = beside->t, .to = -beside->t,
		.tolerance = line->tolerance, .step_max = 0.2, .max_points = POINTS,
		.samples = HAWSER_NONE};
	const struct hawser_rom *rom;
	enum hawser_status status = HAWSER_OK;

	*frf = (struct hawser_frf){.n = 0};
	if (!line->family.model(line->family.context, &rom, choice.begin, NULL))
		status = hawser_frf_trace(frf, rom, &choice, NULL);
	*e = frf->points > 0 ? nearest_event(frf, line->kind, reach) : -1;
	return status;
}

enum hawser_status hawser__own_meet(struct hawser__own_spot *to, int *found,
                                    struct hawser__own_line *line,
                                    const struct hawser__own_spot *from, double reach,
                                    struct hawser_report *report)
{
	struct hawser_frf frf;
	enum hawser_status status = HAWSER_OK;
	int e;

	for (int k = 0; k < HAWSER__OWN_TESTS; k++)
		to->test[k] = NAN;
	if (line->kind == HAWSER_HOPF)
		return meet_hopf(to, found, line, from, reach, report);
	*found = 0;
	for (int k = 0; k < 2 && !*found && status != HAWSER_ERR_MEMORY; k++) {
		status = trace_line(&frf, &e, line, &from->beside[k], reach);
		*found = e >= 0 && status != HAWSER_ERR_MEMORY;
		to->time = frf.time;
		if (status == HAWSER_ERR_MEMORY)
			status = hawser__no_memory(report, "locus");
		else
			status = *found ? take_event(to, &frf, e, line, report) : HAWSER_OK;
		hawser_frf_clear(&frf);
	}
	return status;
}

void hawser__own_copy(struct hawser__own_spot *to, const struct hawser__own_spot *from, int n)
{
	double *const own[] = {to->state, to->beside[0].state, to->beside[1].state};
	const double *const other[] = {from->state, from->beside[0].state, from->beside[1].state};

	*to = *from;
	to->state = own[0];
	for (int k = 0; k < 3; k++)
		memcpy(own[k], other[k], 2*(size_t)n*sizeof **own);
	for (int k = 0; k < 2; k++)
		to->beside[k].state = own[k + 1];
}

double hawser__own_distance(const double a[2], const double b[2])
{
	return hypot(a[0] - b[0], a[1] - b[1]);
}

enum hawser_status hawser__own_across(struct hawser__own *own, struct hawser__own_spot *to, int *found,
                                      const double base[2], const double direction[2], double reach,
                                      const struct hawser__own_spot *from,
                                      struct hawser_report *report)
{
	double length = hypot(direction[0], direction[1]);
	double normal[2] = {direction[1]/length, -direction[0]/length};
	/* the side on which the branches begin stays the same */
	double side = normal[0]*own->line.normal[0] + normal[1]*own->line.normal[1] < 0.0 ? -1.0 : 1.0;

	for (int k = 0; k < 2; k++) {
		own->line.base[k] = base[k];
		own->line.normal[k] = side*normal[k];
	}
	own->locus->solves++;
	return hawser__own_meet(to, found, &own->line, from, reach, report);
}
