/* ropeway/modes/modes_iterate.c - the lowest modes of a system by subspace iteration with its
 * compliance.
 *
 *   X      block of `vectors` displacements; Y = K^-1 M X by modes_static.c, without any matrix K
 *   mu     1/omega^2: (Y'MY) c = mu (Y'MX) c, since Y'KY = Y'MX
 *
 * The error of a frequency falls by (omega_n/omega_q)^4 in each iteration, q the number of vectors,
 * some 16 times if q is 2 n. Modes of equal frequency, as of equal spans, cost nothing more, and
 * random vectors to begin with miss no mode for its symmetry. The largest mu are computed, to full
 * relative accuracy.
 *
 * Then the modes are carried over to finer grids, and two steps of inverse iteration there remove the
 * error of the first grids; by how much the first of them moves a frequency is that error. This is the
 * iterated Galerkin method (compliance_refine.c) with grids in the place of a basis.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "ropeway/modes/modes.h"

enum { MOST = 300, EXTRA = 8, GUESSES = 4, STALLED = 4 };
/* Relative change of mu in an iteration at which it is taken as found; of the largest mu, round-off. */
static const double found = 1e-13, round_off = 1e-15;
/* If no mu has changed by less than this for STALLED iterations, round-off decides. */
static const double settled = 1e-11;
/* Grids are made for this multiple of the highest frequency. */
static const double margin = 1.1;

struct work {
	struct hawser__lmode_system *system;
	int vectors, n;
	double *x, *y, *mx, *my; /* [vectors][size]; mx and my with the weights of the inner product */
	double *a, *b;           /* [vectors][vectors] */
	double *mu, *last;       /* [vectors] */
	struct hawser__hold hold;
};

void hawser__lmode_pairs_clear(struct hawser__lmode_pairs *pairs)
{
	free(pairs->omega);
	free(pairs->error);
	free(pairs->condition);
	free(pairs->x);
	free(pairs->strain);
	*pairs = (struct hawser__lmode_pairs){0};
}

static void work_clear(struct work *t)
{
	hawser__hold_clear(&t->hold);
	free(t->x); /* that of another grid may take its place */
	t->x = NULL;
}

static enum hawser_status work_open(struct work *t, struct hawser_report *report)
{
	size_t q = (size_t)t->vectors, size = (size_t)t->system->size;

	t->x = hawser__numbers(q, size);
	t->y = hawser__hold(&t->hold, q*size, sizeof *t->y);
	t->mx = hawser__hold(&t->hold, q*size, sizeof *t->mx);
	t->my = hawser__hold(&t->hold, q*size, sizeof *t->my);
	t->a = hawser__hold(&t->hold, q*q, sizeof *t->a);
	t->b = hawser__hold(&t->hold, q*q, sizeof *t->b);
	t->mu = hawser__hold(&t->hold, q, sizeof *t->mu);
	t->last = hawser__hold(&t->hold, q, sizeof *t->last);
	return !t->x || t->hold.short_of_memory ? hawser__no_memory(report, "line modes") : HAWSER_OK;
}

/* Fill with random numbers, the same in each run. */
static void begin(double *x, size_t count)
{
	unsigned long long seed = 88172645463325252ULL;

	for (size_t i = 0; i < count; i++) {
		seed ^= seed << 13;
		seed ^= seed >> 7;
		seed ^= seed << 17;
		x[i] = (double)(seed >> 11)/9007199254740992.0 - 0.5;
	}
}

/* out [size] = M x times the weights, so that inner products are sums. */
static void weigh(double *out, const double *x, const struct hawser__lmode_system *system)
{
	hawser__lmode_inertia(out, x, system);
	for (int i = 0; i < system->size; i++)
		out[i] *= system->weight[i];
}

static enum hawser_status unstable(const struct hawser__lmode_system *system,
                                   struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "line modes", "the equilibrium of the line "
	                    "is not stable %s: the rope would slide off along its sheaves, so that a "
	                    "frequency is imaginary", system->plane == HAWSER_IN_PLANE ? "in the plane"
	                    : "out of the plane");
}

static enum hawser_status project(struct work *t, struct hawser_report *report)
{
	int q = t->vectors, size = t->system->size, info;

	for (int i = 0; i < q; i++) {
		double *x = t->x + (size_t)i*(size_t)size, *y = t->y + (size_t)i*(size_t)size;
		double *mx = t->mx + (size_t)i*(size_t)size, *my = t->my + (size_t)i*(size_t)size, scale;

		hawser__lmode_inertia(y, x, t->system);
		weigh(mx, x, t->system);
		hawser__lmode_static(y, NULL, t->system, y);
		weigh(my, y, t->system);
		scale = 1.0/sqrt(cblas_ddot(size, y, 1, my, 1));
		cblas_dscal(size, scale, y, 1);
		cblas_dscal(size, scale, my, 1);
		cblas_dscal(size, scale, mx, 1);
	}
	cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, q, q, size, 1.0, t->y, size, t->mx, size, 0.0,
	            t->a, q);
	cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, q, q, size, 1.0, t->y, size, t->my, size, 0.0,
	            t->b, q);
	for (int i = 0; i < q*q; i++)
		if (!isfinite(t->a[i] + t->b[i]))
			return hawser__fail(report, HAWSER_ERR_NAN, "line modes", "the modes came out as not a "
			                    "number: check EA, rho and the tension of the line");
	info = (int)LAPACKE_dsygvd(LAPACK_COL_MAJOR, 1, 'V', 'L', q, t->b, q, t->a, q, t->mu);
	if (hawser__lapack_starved(info))
		return hawser__no_memory(report, "line modes");
	return info == 0 ? HAWSER_OK : unstable(t->system, report);
}

/* x = Y c with the largest mu first. */
static void combine(struct work *t)
{
	int q = t->vectors, size = t->system->size;

	for (int j = 0; j < q/2; j++) {
		double swap = t->mu[j];

		t->mu[j] = t->mu[q - 1 - j];
		t->mu[q - 1 - j] = swap;
		cblas_dswap(q, t->b + j*q, 1, t->b + (q - 1 - j)*q, 1);
	}
	cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, size, q, q, 1.0, t->y, size, t->b, q, 0.0,
	            t->x, size);
}

static enum hawser_status iterate(struct work *t, int *iterations, struct hawser_report *report)
{
	double before = HUGE_VAL;
	int still = 0;

	for (int i = 1; i <= MOST; i++) {
		double worst = 0.0;
		enum hawser_status status = project(t, report);

		if (status)
			return status;
		combine(t);
		*iterations = i;
		for (int k = 0; k < t->n; k++)
			worst = fmax(worst, fabs(t->mu[k] - t->last[k])/
			                    (t->mu[k] + round_off/found*t->mu[0]));
		memcpy(t->last, t->mu, (size_t)t->vectors*sizeof *t->last);
		if (!(t->mu[t->n - 1] > 0.0))
			return unstable(t->system, report);
		still = worst < settled && worst >= 0.5*before ? still + 1 : 0;
		before = worst;
		if (worst <= found || still >= STALLED)
			return HAWSER_OK;
	}
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "line modes", MOST, before,
	                       "the modes were not found in %d iterations: ask for more or fewer than %d",
	                       MOST, t->n);
}

/* --- from grid to grid --- */

/* x [vectors][size] on new grids, from `from` [vectors][old_size] on the grids of old [segments]. */
static void carry(double *x, const double *from, int vectors, int old_size,
                  const struct hawser__lmode_system *system, const struct hawser__lmode_segment *old)
{
	for (int v = 0; v < vectors; v++, x += system->size, from += old_size) {
		int tail = 0;

		for (int i = 0; i < system->segments; i++) {
			const struct hawser__lmode_segment *s = &system->segment[i];

			for (int c = 0; c < s->D; c++)
				for (int k = 0; k < s->grid.points; k++)
					hawser__grid_at(x + s->at + c*s->grid.points + k, &old[i].grid,
					                from + old[i].at + c*old[i].grid.points, 1, 1, s->grid.s[k]);
			tail += s->D*s->grid.points;
		}
		memcpy(x + tail, from + old_size - (system->size - tail),
		       (size_t)(system->size - tail)*sizeof *x);
	}
}

/* The same for strains [vectors][strains]. */
static void carry_strains(double *to, const double *from, int vectors, int old_strains,
                          const struct hawser__lmode_system *system,
                          const struct hawser__lmode_segment *old)
{
	for (int v = 0; v < vectors; v++, to += system->strains, from += old_strains)
		for (int i = 0; i < system->segments; i++) {
			const struct hawser__lmode_segment *s = &system->segment[i];

			for (int c = 0; c < s->D; c++)
				for (int k = 0; k < s->grid.points; k++)
					hawser__grid_at(to + s->strain + c*s->grid.points + k, &old[i].grid,
					                from + old[i].strain + c*old[i].grid.points, 1, 1,
					                s->grid.s[k]);
		}
}

enum hawser_status hawser__lmode_regrid(double **x, double **strain, int vectors,
                                        struct hawser__lmode_system *system,
                                        const struct hawser__lmode *rope, double omega, int extra,
                                        struct hawser_report *report)
{
	struct hawser__lmode_segment *old = malloc(((size_t)system->segments + 1)*sizeof *old);
	int old_size = system->size, old_strains = system->strains;
	double *to = NULL, *to_strain = NULL;
	enum hawser_status status;

	if (!old)
		return hawser__no_memory(report, "line modes");
	memcpy(old, system->segment, (size_t)system->segments*sizeof *old);
	for (int i = 0; i < system->segments; i++) {
		struct hawser__lmode_segment *s = &system->segment[i];

		s->cosine = s->sine = s->sb = s->k = s->inverse = s->unit[0] = s->unit[1] = NULL;
		s->grid = (struct hawser_grid){0};
		s->table = (struct hawser__reference){0};
	}
	status = hawser__lmode_grids(system, rope, omega, extra, report);
	if (!status)
		status = hawser__lmode_factor(system, report);
	if (!status) {
		to = hawser__numbers((size_t)vectors, (size_t)system->size);
		to_strain = strain ? hawser__numbers((size_t)vectors, (size_t)system->strains) : NULL;
		if (!to || (strain && !to_strain))
			status = hawser__no_memory(report, "line modes");
	}
	if (!status) {
		carry(to, *x, vectors, old_size, system, old);
		free(*x);
		*x = to;
		to = NULL;
	}
	if (!status && strain) {
		carry_strains(to_strain, *strain, vectors, old_strains, system, old);
		free(*strain);
		*strain = to_strain;
		to_strain = NULL;
	}
	free(to);
	free(to_strain);
	for (int i = 0; i < system->segments; i++)
		hawser__lmode_grid_clear(&old[i]);
	free(old);
	return status;
}

/* --- the steps on the fine grids --- */

static void step(struct hawser__lmode_pairs *pairs, int k, struct hawser__lmode_system *system,
                 double *load)
{
	size_t size = (size_t)system->size, strains = (size_t)system->strains;
	double *x = pairs->x + (size_t)k*size, *strain = pairs->strain + (size_t)k*strains, norm;

	hawser__lmode_inertia(load, x, system);
	cblas_dscal((int)size, pairs->omega[k]*pairs->omega[k], load, 1);
	hawser__lmode_static(x, strain, system, load);
	for (int j = 0; j < k; j++) {
		const double *lower = pairs->x + (size_t)j*size;
		double part;

		hawser__lmode_inertia(load, lower, system);
		part = hawser__lmode_product(load, x, system);
		cblas_daxpy((int)size, -part, lower, 1, x, 1);
		cblas_daxpy((int)strains, -part, pairs->strain + (size_t)j*strains, 1, strain, 1);
	}
	hawser__lmode_inertia(load, x, system);
	norm = 1.0/sqrt(hawser__lmode_product(load, x, system));
	cblas_dscal((int)size, norm, x, 1);
	cblas_dscal((int)strains, norm, strain, 1);
	pairs->omega[k] = sqrt(hawser__lmode_stiffness(x, strain, x, strain, system));
}

/* Ascending frequencies: the steps may exchange two that are equal to round-off. */
static void sort(struct hawser__lmode_pairs *pairs, const struct hawser__lmode_system *system)
{
	for (int k = 1; k < pairs->n; k++)
		for (int j = k; j > 0 && pairs->omega[j] < pairs->omega[j - 1]; j--) {
			double omega = pairs->omega[j], error = pairs->error[j];
			size_t size = (size_t)system->size, strains = (size_t)system->strains;

			pairs->omega[j] = pairs->omega[j - 1];
			pairs->omega[j - 1] = omega;
			pairs->error[j] = pairs->error[j - 1];
			pairs->error[j - 1] = error;
			cblas_dswap((int)size, pairs->x + (size_t)j*size, 1, pairs->x + (size_t)(j - 1)*size, 1);
			cblas_dswap((int)strains, pairs->strain + (size_t)j*strains, 1,
			            pairs->strain + (size_t)(j - 1)*strains, 1);
		}
}

enum hawser_status hawser__lmode_refine(struct hawser__lmode_pairs *pairs,
                                       struct hawser__lmode_system *system,
                                       const struct hawser__lmode *rope, double omega,
                                       struct hawser_report *report)
{
	int elements = 1;
	double *load = NULL;
	enum hawser_status status = hawser__lmode_regrid(&pairs->x, NULL, pairs->n, system, rope, omega,
	                                                 rope->options.extra + HAWSER__LMODE_FINER, report);

	if (status)
		return status;
	for (int i = 0; i < system->segments; i++)
		elements += system->segment[i].grid.elements;
	pairs->strain = hawser__numbers((size_t)pairs->n, (size_t)system->strains);
	load = hawser__numbers((size_t)system->size, 1);
	if (!pairs->strain || !load) {
		free(load);
		return hawser__no_memory(report, "line modes");
	}
	for (int k = 0; k < pairs->n; k++) {
		double before = pairs->omega[k];

		if (k == 0 && system->circulates) {
			memcpy(pairs->x, system->null, (size_t)system->size*sizeof *pairs->x);
			memcpy(pairs->strain, system->null_strain, (size_t)system->strains*sizeof *pairs->strain);
			continue;
		}
		step(pairs, k, system, load);
		pairs->error[k] = 3.0*fabs(pairs->omega[k]/before - 1.0) + 4e-15*elements;
		step(pairs, k, system, load);
		if (!isfinite(pairs->omega[k]))
			status = unstable(system, report);
	}
	free(load);
	if (!status)
		sort(pairs, system);
	return status;
}

static double phase_of(const struct hawser__lmode_system *system, const struct hawser__lmode *rope)
{
	double phase = 0.0;

	for (int i = 0; i < system->segments; i++)
		phase += hawser__lmode_phase(&system->segment[i], rope);
	return phase;
}

int hawser__lmode_count(const struct hawser__lmode_system *system, const struct hawser__lmode *rope,
                       double omega)
{
	double count = omega*phase_of(system, rope)/M_PI;

	for (int i = 0; i < system->pendulums; i++)
		count += omega*omega*system->pendulum[i].compliance*system->pendulum[i].mass > 1.0;
	return count < 1e6 ? (int)count : 1000000;
}

/* A frequency below which there are some n modes: waves on all segments. */
static double guess(const struct hawser__lmode_system *system, const struct hawser__lmode *rope, int n)
{
	return M_PI*(n + 1)/phase_of(system, rope);
}

/* At most half of the coordinates that have a mass. */
static int vectors_of(const struct hawser__lmode_system *system, int n)
{
	int most = (system->strains + system->pendulums + 1)/2;
	int wanted = 2*n + EXTRA + system->pendulums + system->borders;

	return wanted < most ? wanted : most;
}

/* Iterate on grids that resolve the highest of t->n modes; *omega: what they resolve. */
static enum hawser_status converge(struct work *t, struct hawser__lmode_pairs *pairs, double *omega,
                                   const struct hawser__lmode *rope, struct hawser_report *report)
{
	struct hawser__lmode_system *system = t->system;
	enum hawser_status status = work_open(t, report);

	if (!status)
		begin(t->x, (size_t)t->vectors*(size_t)system->size);
	for (int tries = 1; !status; tries++) {
		double *x, highest;

		status = iterate(t, &pairs->iterations, report);
		highest = 1.0/sqrt(t->mu[t->n - 1]);
		if (status || highest <= *omega || tries == GUESSES)
			break;
		*omega = margin*highest;
		status = hawser__lmode_regrid(&t->x, NULL, t->vectors, system, rope, *omega,
		                              rope->options.extra, report);
		x = t->x; /* the other arrays have a new size */
		t->x = NULL;
		work_clear(t);
		if (!status)
			status = work_open(t, report);
		free(t->x);
		t->x = x;
	}
	return status;
}

enum hawser_status hawser__lmode_pairs(struct hawser__lmode_pairs *pairs,
                                       struct hawser__lmode_system *system,
                                       const struct hawser__lmode *rope, int n,
                                       struct hawser_report *report)
{
	struct work t = {.system = system};
	enum hawser_status status;

	*pairs = (struct hawser__lmode_pairs){.n = n, .parts = 1, .grid_for = guess(system, rope, n)};
	status = hawser__lmode_grids(system, rope, pairs->grid_for, rope->options.extra, report);
	if (!status)
		status = hawser__lmode_factor(system, report);
	t.n = n - system->circulates;
	t.vectors = vectors_of(system, n);
	if (!status && n > t.vectors)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "line modes", "%d modes asked of a part "
		                      "of the rope whose grid has %d: ask for fewer", n, t.vectors);
	if (!status && t.n > 0)
		status = converge(&t, pairs, &pairs->grid_for, rope, report);
	pairs->omega = hawser__numbers((size_t)n, 1);
	pairs->error = hawser__numbers((size_t)n, 1);
	pairs->x = hawser__numbers((size_t)n, (size_t)system->size);
	if (!status && (!pairs->omega || !pairs->error || !pairs->x))
		status = hawser__no_memory(report, "line modes");
	for (int k = 0; k < t.n && !status; k++) {
		pairs->omega[n - t.n + k] = 1.0/sqrt(t.mu[k]);
		memcpy(pairs->x + (size_t)(n - t.n + k)*(size_t)system->size,
		       t.x + (size_t)k*(size_t)system->size, (size_t)system->size*sizeof *t.x);
	}
	work_clear(&t);
	if (status)
		hawser__lmode_pairs_clear(pairs);
	return status;
}
