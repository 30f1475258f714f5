/* ropeway/modes/modes_running.c - complex modes of a rope that runs over its sheaves.
 *
 *   nu       scaled speed: positive from A to B, in each lane
 *   G        (G x, y) = integral of X'.Y, with the real derivative X' = sa strain_a e + sb strain_b n;
 *            on an
 *            arc that along the circle. Skew: the ends of a segment meet those of the next, and what
 *                flows
 *            out of the last end of a lane flows into the other lane, or around the wheel to it
 *   y_j      basis of real states: real and imaginary parts of approximate modes, with their loads K
 *            y_j
 *
 * The steady state is that of the apparent rope (src/statics/travel.c), whose modes are real; the
 * Coriolis force couples them: M u'' + 2 nu G u' + K u = 0. A round projects this on the basis and
 * solves the Hermitian problem of src/modes/complex/gyroscopic_spectral.c, so that the frequencies
 * are real for any speed. Then inverse iteration x := K^-1 (omega^2 M x - 2 i nu omega G x) with
 * the exact compliance makes the next basis. A projection on modes at rest alone would converge
 * slowly, since G couples all of them.
 *
 * Carriers are at rest: they load the rope as they hang at this moment, and do not run with it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <complex.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/complex/gyroscopic.h"
#include "ropeway/modes/modes.h"

/* Rounds on the first grids, and on the fine ones; further modes that speed up their convergence. */
enum { ROUNDS = 60, FINE_ROUNDS = 3, GUARD = 2 };
/* Relative change of a frequency in a round at which it is taken as found; and, if it does not fall any
 * more, that at which round-off is the reason. */
static const double found = 1e-13, settled = 1e-10;
/* Of vectors of unit energy, combinations whose energy is less than this part of the largest one's are
 * round-off. */
static const double dependent = 1e-10;

struct basis {
	struct hawser__lmode_system *system;
	const struct hawser__lmode *rope;
	int n, kept;                /* vectors, independent combinations of them */
	double *y, *strain, *load;  /* [n][size], [n][strains], [n][size] */
	double *work;               /* [n][size] */
	double *A, *B, *C;          /* [n][n] of K, M and 2 nu G */
	double *at_rest;            /* [kept] frequencies of modes at rest in the basis */
	double *combination;        /* [kept] columns of n */
	struct hawser__hold hold;
};

static void basis_clear(struct basis *t)
{
	hawser__hold_clear(&t->hold);
}

static enum hawser_status basis_open(struct basis *t, struct hawser_report *report)
{
	size_t n = (size_t)t->n, size = (size_t)t->system->size;

	t->y = hawser__hold(&t->hold, n*size + 1, sizeof *t->y);
	t->strain = hawser__hold(&t->hold, n*(size_t)t->system->strains + 1, sizeof *t->strain);
	t->load = hawser__hold(&t->hold, n*size + 1, sizeof *t->load);
	t->work = hawser__hold(&t->hold, n*size + 1, sizeof *t->work);
	t->A = hawser__hold(&t->hold, n*n + 1, sizeof *t->A);
	t->B = hawser__hold(&t->hold, n*n + 1, sizeof *t->B);
	t->C = hawser__hold(&t->hold, n*n + 1, sizeof *t->C);
	t->at_rest = hawser__hold(&t->hold, n + 1, sizeof *t->at_rest);
	t->combination = hawser__hold(&t->hold, n*n + 1, sizeof *t->combination);
	if (!t->hold.short_of_memory)
		return HAWSER_OK;
	return hawser__no_memory(report, "line modes");
}

/* load = 2 nu G x of a state with its strains: per length, and at borders what flows through them. */
static void coriolis(double *load, const double *x, const double *strain,
                     const struct hawser__lmode_system *system, const struct hawser__lmode *rope)
{
	memset(load, 0, (size_t)system->size*sizeof *load);
	for (int i = 0; i < system->segments; i++) {
		const struct hawser__lmode_segment *s = &system->segment[i];
		double nu = hawser__lmode_nu(rope, s->piece->lane);
		const double *a = strain + s->strain, *b = a + s->grid.points;
		double *f = load + s->at;

		for (int p = 0; p < s->grid.points; p++) {
			if (s->D == 2) {
				double along = s->sa*a[p], across = s->sb[p]*b[p];

				f[p] = 2.0*nu*(s->cosine[p]*along - s->sine[p]*across);
				f[s->grid.points + p] = 2.0*nu*(s->sine[p]*along + s->cosine[p]*across);
			} else {
				f[p] = 2.0*nu*(s->sb ? s->sb[p] : s->sa)*a[p];
			}
		}
		for (int end = 0; end < HAWSER__ENDS; end++)
			for (int c = 0; c < s->D; c++)
				for (int r = 0; r < system->borders; r++) {
					const double *map = s->border + (end*2 + c)*system->borders;
					double at = 0.0;

					for (int q = 0; q < system->borders && map[r] != 0.0; q++)
						at += map[q]*x[system->border[q].at];
					load[system->border[r].at] += (end ? -nu : nu)*map[r]*at;
				}
	}
}

/* Basis vectors 2 k and 2 k + 1 from mode k: the real and the imaginary part of
 * K^-1 (omega^2 M x - i omega 2 nu G x). */
static void respond(struct basis *t, const struct hawser__lmode_pairs *pairs, int k)
{
	struct hawser__lmode_system *system = t->system;
	size_t size = (size_t)system->size, strains = (size_t)system->strains;
	double omega = pairs->omega[k];

	for (int part = 0; part < 2; part++) {
		size_t to = (size_t)(2*k + part), own = (size_t)(2*k + part), other = (size_t)(2*k + 1 - part);
		double *load = t->load + to*size;

		hawser__lmode_inertia(load, pairs->x + own*size, system);
		cblas_dscal(system->size, omega*omega, load, 1);
		coriolis(t->work, pairs->x + other*size, pairs->strain + other*strains, system, t->rope);
		cblas_daxpy(system->size, part ? -omega : omega, t->work, 1, load, 1);
		hawser__lmode_static(t->y + to*size, t->strain + to*strains, system, load);
	}
}

/* out [n][n]: products of the states y with the loads in `load` [n][size]. */
static void project(double *out, struct basis *t, const double *load)
{
	int n = t->n, size = t->system->size;
	double *weighted = t->work;

	for (int k = 0; k < n; k++)
		for (int i = 0; i < size; i++)
			weighted[(size_t)k*(size_t)size + (size_t)i] =
				t->system->weight[i]*load[(size_t)k*(size_t)size + (size_t)i];
	cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, n, n, size, 1.0, t->y, size, weighted, size,
	            0.0,
	            out, n);
}

static void symmetrise(double *A, int n, double sign)
{
	for (int i = 0; i < n; i++)
		for (int j = 0; j <= i; j++) {
			double mean = 0.5*(A[i*n + j] + sign*A[j*n + i]);

			A[i*n + j] = mean;
			A[j*n + i] = sign*mean;
		}
}

/* Scale the vectors to unit energy, and project K, M and 2 nu G on them. */
static enum hawser_status matrices(struct basis *t)
{
	size_t size = (size_t)t->system->size, strains = (size_t)t->system->strains;
	double *load = hawser__numbers((size_t)t->n, size);

	if (!load)
		return HAWSER_ERR_MEMORY;
	for (int k = 0; k < t->n; k++) {
		double *y = t->y + (size_t)k*size, *f = t->load + (size_t)k*size;
		double energy = hawser__lmode_product(f, y, t->system), scale = energy > 0.0 ? 1.0/sqrt(energy)
			: 0.0;

		cblas_dscal((int)size, scale, y, 1);
		cblas_dscal((int)size, scale, f, 1);
		cblas_dscal((int)strains, scale, t->strain + (size_t)k*strains, 1);
	}
	project(t->A, t, t->load);
	for (int k = 0; k < t->n; k++)
		hawser__lmode_inertia(load + (size_t)k*size, t->y + (size_t)k*size, t->system);
	project(t->B, t, load);
	for (int k = 0; k < t->n; k++)
		coriolis(load + (size_t)k*size, t->y + (size_t)k*size, t->strain + (size_t)k*strains, t->system,
		         t->rope);
	project(t->C, t, load);
	symmetrise(t->A, t->n, 1.0);
	symmetrise(t->B, t->n, 1.0);
	symmetrise(t->C, t->n, -1.0);
	free(load);
	return HAWSER_OK;
}

/* out [kept][kept] = V' S V for V = combination; work [n][n]. */
static void transform(double *out, const struct basis *t, const double *S, double *work)
{
	int n = t->n, m = t->kept;

	cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n, m, n, 1.0, S, n, t->combination, n, 0.0,
	            work,
	            n);
	cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, m, m, n, 1.0, t->combination, n, work, n, 0.0,
	            out,
	            m);
}

/* Independent combinations that are modes at rest: K diagonal, M = 1; C becomes that of these. */
static enum hawser_status rest(struct basis *t, struct hawser_report *report)
{
	int n = t->n, first = 0, info;
	double *value = hawser__numbers((size_t)n, 1), *work = hawser__numbers((size_t)n, (size_t)n);
	double *reduced = hawser__numbers((size_t)n, (size_t)n);
	double *V = hawser__numbers((size_t)n, (size_t)n);
	enum hawser_status status = HAWSER_OK;

	if (!value || !work || !reduced || !V) {
		status = hawser__no_memory(report, "line modes");
		goto done;
	}
	info = (int)LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', n, t->A, n, value);
	if (info) {
		status = hawser__lapack_starved(info) ? hawser__no_memory(report, "line modes")
			: hawser__fail(report, HAWSER_ERR_NAN, "line modes", "the modes of the running rope came "
			               "out as not a number: check EA, rho, speed and tension");
		goto done;
	}
	while (first < n && !(value[first] > dependent*value[n - 1]))
		first++;
	t->kept = n - first;
	for (int k = 0; k < t->kept; k++)
		for (int i = 0; i < n; i++)
			t->combination[k*n + i] = t->A[(first + k)*n + i]/sqrt(value[first + k]);
	transform(reduced, t, t->B, work);
	info = (int)LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', t->kept, reduced, t->kept, value);
	if (info || !(value[0] > 0.0)) {
		status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "line modes", "the modes of the "
		                      "running rope cannot be told apart to double precision: ask for fewer");
		goto done;
	}
	for (int k = 0; k < t->kept; k++) { /* columns for M = 1 */
		t->at_rest[k] = 1.0/sqrt(value[k]);
		cblas_dscal(t->kept, t->at_rest[k], reduced + k*t->kept, 1);
	}
	cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n, t->kept, t->kept, 1.0, t->combination, n,
	            reduced, t->kept, 0.0, V, n);
	memcpy(t->combination, V, (size_t)n*(size_t)t->kept*sizeof *V);
	transform(reduced, t, t->C, work);
	memcpy(t->C, reduced, (size_t)t->kept*(size_t)t->kept*sizeof *reduced);
done:
	free(value);
	free(work);
	free(reduced);
	free(V);
	return status;
}

/* State and strain of the combination q [kept] of the basis, of unit norm with a phase that makes the
 * sum of x M x real: real and imaginary part are then orthogonal. */
static void unfold(struct hawser__lmode_pairs *pairs, int k, const struct basis *t,
                   const double complex *q)
{
	size_t size = (size_t)t->system->size, strains = (size_t)t->system->strains;
	double complex square = 0.0, turn;
	double norm = 0.0;

	for (int j = 0; j < t->kept; j++) {
		square += q[j]*q[j];
		norm += creal(q[j])*creal(q[j]) + cimag(q[j])*cimag(q[j]);
	}
	turn = cexp(-0.5*I*carg(square))/sqrt(norm);
	memset(pairs->x + 2*(size_t)k*size, 0, 2*size*sizeof *pairs->x);
	memset(pairs->strain + 2*(size_t)k*strains, 0, 2*strains*sizeof *pairs->strain);
	for (int i = 0; i < t->n; i++) {
		double complex c = 0.0;

		for (int j = 0; j < t->kept; j++)
			c += turn*q[j]*t->combination[j*t->n + i];
		for (size_t part = 0; part < 2; part++) {
			double by = part ? cimag(c) : creal(c);

			cblas_daxpy((int)size, by, t->y + (size_t)i*size, 1,
			            pairs->x + (2*(size_t)k + part)*size, 1);
			cblas_daxpy((int)strains, by, t->strain + (size_t)i*strains, 1,
			            pairs->strain + (2*(size_t)k + part)*strains, 1);
		}
	}
}

/* Condition of the frequencies, as in doc/theory-gyroscopic.md: 1 plus 2 nu omega |u| |u'| over
 * k + omega^2 |u|^2, where |u| is 1 and k twice the strain energy. load [size]. */
static void judge(struct hawser__lmode_pairs *pairs, const struct hawser__lmode_system *system,
                  const struct hawser__lmode *rope, double *load)
{
	size_t size = (size_t)system->size, strains = (size_t)system->strains;

	for (int k = 0; k < pairs->n; k++) {
		double flow = 0.0, stiff = 0.0, omega = pairs->omega[k];

		for (size_t part = 0; part < 2; part++) {
			const double *x = pairs->x + (2*(size_t)k + part)*size;
			const double *strain = pairs->strain + (2*(size_t)k + part)*strains;

			coriolis(load, x, strain, system, rope);
			for (int i = 0; i < system->strains; i++)
				flow += system->weight[i]*load[i]*load[i];
			stiff += hawser__lmode_stiffness(x, strain, x, strain, system);
		}
		pairs->condition[k] = 1.0 + omega*sqrt(flow)/(stiff + omega*omega);
	}
}

/* The pairs->n lowest modes of the basis. *change: of the first n - GUARD frequencies, relative. */
static enum hawser_status solve(double *change, struct hawser__lmode_pairs *pairs, struct basis *t,
                                struct hawser_report *report)
{
	size_t order = 2*(size_t)t->kept, n = (size_t)pairs->n;
	double complex *z = calloc(order*n + 1, sizeof *z);
	double *mu = hawser__numbers(order, 1);
	int have = 0, info = z && mu ? 0 : LAPACK_WORK_MEMORY_ERROR;
	enum hawser_status status = HAWSER_OK;

	if (!info && t->kept >= pairs->n)
		info = hawser__gyroscopic_pairs(mu, z, &have, pairs->n, t->C, t->at_rest, t->kept);
	if (hawser__lapack_starved(info))
		status = hawser__no_memory(report, "line modes");
	else if (info || have != pairs->n || !(mu[0] > 0.0))
		status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "line modes", "the modes of the running "
		                      "rope were not found: ask for fewer than %d", pairs->n);
	if (status)
		goto done;
	*change = 0.0;
	for (int k = 0; k < pairs->n; k++) {
		double complex *q = z + (n - 1 - (size_t)k)*order;
		double omega = 1.0/mu[n - 1 - (size_t)k];

		for (int j = 0; j < t->kept; j++)
			q[j] /= t->at_rest[j];
		if (k < pairs->n - GUARD || k == 0)
			*change = fmax(*change, fabs(omega/pairs->omega[k] - 1.0));
		pairs->omega[k] = omega;
		unfold(pairs, k, t, q);
	}
done:
	free(z);
	free(mu);
	return status;
}

static enum hawser_status round_of(double *change, struct hawser__lmode_pairs *pairs, struct basis *t,
                                   struct hawser_report *report)
{
	enum hawser_status status;

	for (int k = 0; k < pairs->n; k++)
		respond(t, pairs, k);
	status = matrices(t);
	if (status)
		return hawser__no_memory(report, "line modes");
	status = rest(t, report);
	return status ? status : solve(change, pairs, t, report);
}

/* Rounds until the frequencies are settled, at most `most`. */
static enum hawser_status iterate(struct hawser__lmode_pairs *pairs,
                                  struct hawser__lmode_system *system,
                                  const struct hawser__lmode *rope, int most, int must,
                                  struct hawser_report *report)
{
	struct basis t = {.system = system, .rope = rope, .n = 2*pairs->n};
	double change = HUGE_VAL, before;
	enum hawser_status status = basis_open(&t, report);

	for (int i = 0; i < most && !status; i++) {
		before = change;
		status = round_of(&change, pairs, &t, report);
		pairs->iterations++;
		if (change <= found || (change <= settled && change > 0.5*before))
			break;
	}
	basis_clear(&t);
	if (!status && must && !(change <= settled))
		status = hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "line modes", most, change,
		                         "the modes of the running rope did not settle in %d rounds: lower the "
		                         "speed, or ask for fewer modes", most);
	return status;
}

enum hawser_status hawser__lmode_running(struct hawser__lmode_pairs *pairs,
                                         struct hawser__lmode_system *system,
                                         const struct hawser__lmode *rope,
                                         const struct hawser__lmode_pairs *resting,
                                         struct hawser_report *report)
{
	size_t n = (size_t)resting->n, size = (size_t)system->size, strains = (size_t)system->strains;
	double *load;
	enum hawser_status status = HAWSER_OK;

	*pairs = (struct hawser__lmode_pairs){.n = resting->n, .parts = 2};
	if (n == 0)
		return HAWSER_OK;
	if (system->circulates)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line modes", "the rope is a loop that "
		                    "nothing drives: a rope that runs has a drive, which holds its "
		                    "circulation, so fix one of the wheels");
	pairs->omega = hawser__numbers(n, 1);
	pairs->error = hawser__numbers(n, 1);
	pairs->condition = hawser__numbers(n, 1);
	pairs->x = hawser__numbers(2*n, size);
	pairs->strain = hawser__numbers(2*n, strains);
	load = hawser__numbers(size, 1);
	if (!pairs->omega || !pairs->error || !pairs->condition || !pairs->x || !pairs->strain || !load)
		status = hawser__no_memory(report, "line modes");
	for (size_t k = 0; k < n && !status; k++) {
		pairs->omega[k] = resting->omega[k];
		hawser__lmode_inertia(load, resting->x + k*size, system);
		cblas_dscal((int)size, resting->omega[k]*resting->omega[k], load, 1);
		hawser__lmode_static(pairs->x + 2*k*size, pairs->strain + 2*k*strains, system, load);
	}
	free(load);
	if (!status)
		status = iterate(pairs, system, rope, ROUNDS, 1, report);
	return status;
}

enum hawser_status hawser__lmode_running_refine(struct hawser__lmode_pairs *pairs,
                                                struct hawser__lmode_system *system,
                                                const struct hawser__lmode *rope, double omega,
                                                struct hawser_report *report)
{
	int elements = 1;
	double *before = hawser__numbers((size_t)pairs->n, 1), *load = NULL;
	enum hawser_status status = HAWSER_OK;

	if (!before)
		return hawser__no_memory(report, "line modes");
	if (pairs->n > 0) {
		memcpy(before, pairs->omega, (size_t)pairs->n*sizeof *before);
		status = hawser__lmode_regrid(&pairs->x, &pairs->strain, 2*pairs->n, system, rope, omega,
		                              rope->options.extra + HAWSER__LMODE_FINER, report);
		if (!status)
			status = iterate(pairs, system, rope, FINE_ROUNDS, 0, report);
	}
	for (int i = 0; i < system->segments; i++)
		elements += system->segment[i].grid.elements;
	load = hawser__numbers((size_t)system->size, 1);
	if (!status && !load)
		status = hawser__no_memory(report, "line modes");
	if (!status)
		judge(pairs, system, rope, load);
	for (int k = 0; k < pairs->n && !status; k++)
		pairs->error[k] = 3.0*fabs(pairs->omega[k]/before[k] - 1.0) + 4e-15*elements;
	free(before);
	free(load);
	return status;
}
