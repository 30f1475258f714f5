/* response/cycle/switch.c - the branches that begin at events of equilibria and of limit cycles.
 *
 *    e    first cycle's amplitude, of the coordinate that moves most: by the normal form the
 *         parameter is START of its range from the Hopf point
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "response/cycle/cycle.h"
#include "response/cycle/hopf.h"

#define APART_BY 1e-3  /* distance of a first orbit from the other branch, relative to it; chosen */
#define START 1e-4   /* see above; chosen */
#define PLAIN 1e-3   /* amplitude, where the normal form says nothing; chosen */
enum { LARGER = 2 }; /* times ten times as large, where no cycle is found with that; chosen */

/* The eigenvector v [n] of the eigenvalue 0 of the forces' derivative at the equilibrium u [n]. */
static enum hawser_status null_vector(double *v, const struct hawser_rom *rom, const double *u,
                                      struct hawser_report *report)
{
	size_t n = (size_t)rom->n;
	double *memory = calloc(4*n*n + 6*n, sizeof *memory), *J = memory, *by_v = hawser__behind(J, n*n);
	double *right = hawser__behind(by_v, n*n), *re = hawser__behind(right, n*n);
	double *im = hawser__behind(re, n), *f = hawser__behind(im, n);
	double *rest = hawser__behind(f, 2*n), unused;
	const struct hawser_rom *of = rom->first ? rom->first : rom;
	int best = 0, info;

	if (!memory)
		return hawser__no_memory(report, "frf");
	hawser_rom_acceleration_jacobian(of, f, J, by_v, f + n, u, rest, 0.0, 1.0);
	info = LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'V', (int)n, J, (int)n, re, im, &unused, (int)n, right,
	                     (int)n);
	for (int i = 1; i < (int)n; i++)
		if (hypot(re[i], im[i]) < hypot(re[best], im[best]))
			best = i;
	for (size_t j = 0; j < n; j++)
		v[j] = right[j*n + (size_t)best];
	free(memory);
	return !info ? HAWSER_OK : hawser__lapack_starved(info) ? hawser__no_memory(report, "frf")
	       : hawser__fail(report, HAWSER_ERR_CONVERGENCE, "frf", "no direction of a branch was found");
}

/* The other branch of equilibria at a branch point. */
static enum hawser_status switch_equilibria(struct hawser_frf *branch, const struct hawser_rom *rom,
                                            const struct hawser_rom *there, const double *state,
                                            struct hawser_frf_options *options,
                                            struct hawser_report *report)
{
	int n = rom->n;
	double *along = calloc(2*(size_t)n, sizeof *along), size = cblas_dnrm2(n, state, 1);
	enum hawser_status status = along ? null_vector(along, there, state, report)
	                                  : hawser__no_memory(report, "frf");

	cblas_dscal(along ? n : 0, APART_BY*(size > 0.0 ? size : 1.0), along, 1);
	options->along = along;
	if (!status)
		status = hawser_frf_trace(branch, rom, options, report);
	free(along);
	return status;
}

/* v [m] of length 1 at right angles to the motion f at the state x: the change of the cycle x that is
 * again one after a period, but for a shift along f, (M - 1) v = c f. */
static enum hawser_status other_cycle(double *v, const struct hawser_rom *rom, const double *x,
                                      double omega, struct hawser_report *report)
{
	int n = rom->n, m = 2*n, size = m + 1, info;
	double *memory = calloc((size_t)size*(2*(size_t)size + 2) + 3*(size_t)m, sizeof *memory), unused;
	double *matrix = memory, *right = hawser__behind(matrix, (size_t)(size*size));
	double *value = hawser__behind(right, (size_t)(size*size)), *M;
	double *work = hawser__behind(value, (size_t)size), *f = hawser__behind(work, (size_t)size);
	double *end = hawser__behind(f, (size_t)m);
	enum hawser_status status;

	M = memory ? malloc((size_t)m*(size_t)m*sizeof *M) : NULL;
	if (!M) {
		free(memory);
		return hawser__no_memory(report, "frf");
	}
	memcpy(end, x, (size_t)m*sizeof *end);
	status = hawser__branch_period(end, M, rom, omega, report);
	memcpy(f, x + n, (size_t)n*sizeof *f);
	hawser_rom_acceleration(rom, f + n, x, x + n, 0.0, 1.0);
	cblas_dscal(m, 1.0/cblas_dnrm2(m, f, 1), f, 1);
	for (int i = 0; i < m; i++) {
		memcpy(matrix + i*size, M + i*m, (size_t)m*sizeof *matrix);
		matrix[i*size + i] -= 1.0;
		matrix[i*size + m] = matrix[m*size + i] = f[i];
	}
	info = LAPACKE_dgesvd(LAPACK_ROW_MAJOR, 'N', 'A', size, size, matrix, size, value, &unused, 1,
	                      right, size, work);
	memcpy(v, right + m*size, (size_t)m*sizeof *v);
	cblas_dscal(m, 1.0/cblas_dnrm2(m, v, 1), v, 1);
	free(memory);
	free(M);
	return status ? status : hawser__lapack_starved(info) ? hawser__no_memory(report, "frf")
	       : HAWSER_OK;
}

/* The other cycles at a branch point. Near to it the corrector is nearly singular: greater distances
 * are first. */
static enum hawser_status switch_point(struct hawser_frf *branch, const struct hawser_rom *rom,
                                       const struct hawser_rom *there, const double *state,
                                       struct hawser_frf_options *options,
                                       struct hawser_report *report)
{
	static const double apart[] = {0.01, 3e-3, 0.03, APART_BY};
	int m = 2*rom->n;
	double *along = calloc(2*(size_t)m, sizeof *along), *v = along ? along + m : NULL;
	enum hawser_status status = along ? other_cycle(v, there, state, options->omega, report)
	                                  : hawser__no_memory(report, "frf");

	options->along = along;
	for (int i = 0; !status && branch->points < 2 && i < 4; i++) {
		hawser_frf_clear(branch);
		for (int j = 0; j < m; j++)
			along[j] = apart[i]*cblas_dnrm2(m, state, 1)*v[j];
		status = hawser_frf_trace(branch, rom, options, report);
		if (status == HAWSER_ERR_CONVERGENCE && i < 3)
			status = HAWSER_OK;
	}
	free(along);
	return status;
}

/* The cycles of twice the period at a period doubling. */
static enum hawser_status switch_doubled(struct hawser_frf *branch, const struct hawser_rom *rom,
                                         const struct hawser_rom *there, const double *state,
                                         struct hawser_frf_options *options,
                                         struct hawser_report *report)
{
	int m = 2*rom->n;
	double *along = calloc((size_t)m, sizeof *along);
	enum hawser_status status = along ? hawser__branch_direction(along, there, state, options->omega,
	                                                             -1.0, report)
	                                  : hawser__no_memory(report, "frf");

	cblas_dscal(along ? m : 0, APART_BY*cblas_dnrm2(m, state, 1), along, 1);
	options->along = along;
	options->omega *= 0.5;
	if (!status)
		status = hawser_frf_trace(branch, rom, options, report);
	free(along);
	return status;
}

/* The cycles at a Hopf point. */
static enum hawser_status switch_cycles(struct hawser_frf *branch, const struct hawser_rom *rom,
                                        const struct hawser_frf_event *event,
                                        struct hawser_frf_options *options,
                                        struct hawser_report *report)
{
	int n = rom->n;
	double range = fabs(options->to - options->from), extent = fmax(fabs(event->parameter), range);
	double *wave = malloc(4*(size_t)n*sizeof *wave), size, rate;
	struct hawser_hopf hopf = {.turning = event->hopf.turning};
	int known = 0;
	enum hawser_status status = wave ? hawser__hopf(&hopf, &rate, wave, options->family, options->start,
	                                                event->parameter, event->hopf.omega, extent, report)
	                                 : hawser__no_memory(report, "frf");

	if (!status) {
		size = sqrt(fabs(hopf.swing)*START*range);
		known = isfinite(size) && size > 0.0;
		size = (known ? size : PLAIN)/hypot(wave[hopf.coordinate], wave[n + hopf.coordinate]);
		cblas_dscal(2*n, size, wave, 1);
		options->along = wave;
		options->turn = wave + n;
		status = hawser_frf_trace(branch, rom, options, report);
	}
	for (int i = 0; i < LARGER && !known && status == HAWSER_ERR_CONVERGENCE && branch->points < 2;
	     i++) {
		hawser_frf_clear(branch);
		cblas_dscal(2*n, 10.0, wave, 1);
		status = hawser_frf_trace(branch, rom, options, report);
	}
	free(wave);
	return status;
}

/* v [m]: the direction in which the motion about the equilibrium u [n] grows fastest, of length 1, so
 * that slowly decaying ones are not excited. */
static enum hawser_status growing(double *v, const struct hawser_rom *rom, const double *u,
                                  struct hawser_report *report)
{
	size_t n = (size_t)rom->n, m = 2*n;
	double *memory = calloc(3*m*m + 8*m, sizeof *memory), *A = memory, *right = hawser__behind(A, m*m);
	double *by_u = hawser__behind(right, m*m), *re = hawser__behind(by_u, m*m);
	double *im = hawser__behind(re, m), *rest = hawser__behind(im, m), *work = hawser__behind(rest, m);
	double unused;
	int order, info, best = 0;

	if (!memory)
		return hawser__no_memory(report, "frf");
	order = hawser__autonomous_matrix(A, by_u, by_u + n*n, work, rom, u, rest);
	info = LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'V', order, A, order, re, im, &unused, 1, right,
	                     order);
	for (int i = 1; i < order; i++)
		best = re[i] > re[best] ? i : best;
	memset(v, 0, m*sizeof *v);
	memcpy(v, right + (size_t)best*(size_t)order, (size_t)order*sizeof *v);
	cblas_dscal(order, 1.0/cblas_dnrm2(order, v, 1), v, 1);
	free(memory);
	return hawser__lapack_starved(info) ? hawser__no_memory(report, "frf") : HAWSER_OK;
}

/* The motion is followed in time from beside an equilibrium: the first one, the last one and that in
 * the middle, until it comes to a cycle. With `back` from that in the middle, to the other end. */
enum hawser_status hawser__own_leave(struct hawser_frf *branch, const struct hawser_rom *rom,
                                     const struct hawser_frf *from, int back,
                                     const struct hawser_frf_options *as,
                                     struct hawser_report *report)
{
	struct hawser_frf_options options = *as;
	const int at[] = {0, from->points - 1, from->points/2};
	int m = 2*from->n;
	double *state = malloc(2*(size_t)m*sizeof *state);
	enum hawser_status status = state ? HAWSER_ERR_CONVERGENCE : hawser__no_memory(report, "frf");

	options.start = state;
	options.omega = -1.0;
	*branch = (struct hawser_frf){.n = rom->n};
	for (int i = back ? 2 : 0; status == HAWSER_ERR_CONVERGENCE && branch->points < 2 && i < 3; i++) {
		int turned = i == 1 || back;
		const double *rest = from->state + (size_t)at[i]*(size_t)m;
		double size = cblas_dnrm2(m, rest, 1);
		const struct hawser_rom *there;

		options.begin = from->point[at[i]].parameter;
		if (as->family->model(as->family->context, &there, options.begin, NULL))
			continue;
		status = growing(state + m, there, rest, report);
		for (int j = 0; j < m; j++)
			state[j] = rest[j] + (size > 0.0 ? size : 1.0)*APART_BY*state[m + j];
		if (status)
			break;
		hawser_frf_clear(branch);
		options.from = turned ? as->to : as->from;
		options.to = turned ? as->from : as->to;
		status = hawser_frf_trace(branch, rom, &options, report);
	}
	free(state);
	branch->parent = from->branch;
	branch->born_at = options.begin;
	return status;
}

enum hawser_status hawser__own_switch(struct hawser_frf *branch, const struct hawser_rom *rom,
                                      const struct hawser_frf *from, int e,
                                      const struct hawser_frf_options *as,
                                      struct hawser_report *report)
{
	const struct hawser_frf_event *event = from->event + e;
	const struct hawser_rom *there;
	const double *state = from->event_state + 2*(size_t)from->n*(size_t)e;
	struct hawser_frf_options options = *as;
	int rests = from->point[0].omega == 0.0;
	enum hawser_status status = as->family->model(as->family->context, &there, event->parameter,
	                                              report);

	*branch = (struct hawser_frf){.n = rom->n};
	options.start = state;
	options.begin = event->parameter;
	options.omega = event->omega;
	if (status)
		return status;
	if (event->kind == HAWSER_HOPF && event->located)
		status = switch_cycles(branch, rom, event, &options, report);
	else if (event->kind == HAWSER_PERIOD_DOUBLING && event->located)
		status = switch_doubled(branch, rom, there, state, &options, report);
	else if (event->kind == HAWSER_BRANCH_POINT && event->located && rests)
		status = switch_equilibria(branch, rom, there, state, &options, report);
	else if (event->kind == HAWSER_BRANCH_POINT && event->located)
		status = switch_point(branch, rom, there, state, &options, report);
	else
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                      "no branch is followed from a %s of %s", hawser_event_name(event->kind),
		                      rests ? "equilibria" : "limit cycles");
	branch->parent = from->branch;
	branch->born = event->omega;
	branch->born_at = event->parameter;
	return status;
}
