/* response/time/radau.c - Radau IIA collocation, order 2s - 1 = 15, solved by Newton's method.
 *
 *   a_i, V_i, U_i  acceleration, velocity and displacement at node i of the step [S][n]
 *   A              the method's matrix (table.once); table.twice is A^2
 *   J_i, G_i       derivatives of the model's acceleration by u and by v at node i [n][n]
 *   f              the model's acceleration
 *
 * The step asks that a_i = f(U_i, V_i) where V = v0 + h A a and U = u0 + h A V. Newton's matrix is
 *
 *   M = I - h^2 (A^2)_ij J_i - h A_ij G_i   [S n][S n]
 *
 * factorised once a step with the derivatives at the predicted states of all nodes.
 *
 * The fixed-point iteration of gauss.c contracts only if (h omega)^2 is small for every frequency of
 * the model, even of a coordinate that follows the others and hardly vibrates. Radau IIA is
 * L-stable, and its last node is the end of the step: a coordinate too fast for the step follows
 * the others to the order of the method, and its own vibration below the tolerance decays.
 * Vibration above the tolerance is resolved.
 *
 * M is one matrix of order S n. With the same J at all nodes it would split into S/2 complex
 * matrices of order n, by the eigenvalues of A. But in a condensed model the stiffness between a
 * fast coordinate and a slow one varies within a period by more than the stiffness of the fast one.
 *
 * Reference: Hairer, Wanner, Solving Ordinary Differential Equations II, 2nd ed., IV.5, IV.8.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "response/orbit/weights.h"
#include "response/time/collocated.h"
#include "rom/terms/history.h"
#include "rom/build/model.h"

#define S HAWSER__NODES
#define MAX_ITERATIONS 10 /* an iteration that needs more is repeated with half the step */
#define ITERATE_TO 1e-2     /* remaining error of the iteration, in units of the tolerance */
#define FLOOR 0.1           /* acceptable where round-off stops the iteration sooner; or 4 ulp */
#define GROW_AT_MOST 2.0    /* as in gauss.c */

struct radau {
	struct hawser__collocated of;
	double *beta;             /* [S][n] coefficients of v over the last step */
	double *right;            /* [S][n] the residual */
	struct hawser__weights weights;
	double *by_u, *by_v;      /* [n][n] */
	double *by_omega;         /* [n] */
	double *M;                /* [S n][S n] by columns */
	lapack_int *pivot;        /* [S n] */
};

/* y at fraction x of the last step. */
static void interpolate(const struct hawser__collocated *of, double *y, double x)
{
	const struct radau *radau = (const struct radau *)of;
	int n = radau->of.base.rom->n;
	double once[S], twice[S];

	hawser__collocation_integrals(once, twice, x);
	for (int k = 0; k < n; k++) {
		double u = 0.0, v = 0.0;

		for (int m = S - 1; m >= 0; m--) {
			u += once[m]*radau->beta[m*n + k];
			v += once[m]*radau->of.alpha[m*n + k];
		}
		y[k] = radau->of.from[k] + radau->of.step*u;
		y[n + k] = radau->of.from[n + k] + radau->of.step*v;
	}
}

/* --- one step --- */

/* The increments of u and v at node i by the accelerations a [S][n]; v0 [n] or NULL. */
static void increment(const struct radau *radau, double *du, double *dv, int i, const double *a,
                      const double *v0, double h)
{
	int n = radau->of.base.rom->n;

	for (int k = 0; k < n; k++) {
		du[k] = v0 ? h*radau->of.table.node[i]*v0[k] : 0.0;
		dv[k] = 0.0;
	}
	for (int j = 0; j < S; j++) {
		double once = h*radau->of.table.once[i][j], twice = h*h*radau->of.table.twice[i][j];

		for (int k = 0; k < n; k++) {
			du[k] += twice*a[j*n + k];
			dv[k] += once*a[j*n + k];
		}
	}
}

static void fill_stages(struct radau *radau, double h)
{
	int n = radau->of.base.rom->n;

	for (int i = 0; i < S; i++) {
		double *y = radau->of.stage + i*2*n;

		increment(radau, y, y + n, i, radau->of.slope, radau->of.to + n, h);
		for (int k = 0; k < 2*n; k++)
			y[k] += radau->of.to[k];
	}
}

/* Rows of node i of M. */
static void fill_rows(struct radau *radau, int i, double h)
{
	int n = radau->of.base.rom->n;
	size_t order = (size_t)S*(size_t)n;

	for (int j = 0; j < S; j++) {
		double once = h*radau->of.table.once[i][j], twice = h*h*radau->of.table.twice[i][j];

		for (int l = 0; l < n; l++) {
			double *column = radau->M + ((size_t)j*n + l)*order + (size_t)i*n;

			for (int k = 0; k < n; k++)
				column[k] = -twice*radau->by_u[k*n + l] - once*radau->by_v[k*n + l];
			if (i == j)
				column[l] += 1.0;
		}
	}
}

/* Newton's matrix at the states of `stage`, factorised. Returns 0, or -1 where it is singular or not
 * finite. */
static int factorise(struct radau *radau, double h)
{
	struct hawser__stepper *base = &radau->of.base;
	int n = base->rom->n, order = S*n;

	for (int i = 0; i < S; i++) {
		const double *u = radau->of.stage + i*2*n;
		double t = radau->of.end + radau->of.table.node[i]*h;
		double phase = hawser__stepper_phase(base, t, radau->of.end_low);

		hawser_rom_acceleration_jacobian(base->rom, radau->right, radau->by_u, radau->by_v,
		                                 radau->by_omega, u, u + n, phase,
		                                 hawser__stepper_omega(base, t));
		if (base->rom->ramp)
			hawser__rom_ramp(base->rom, radau->right, radau->by_u, radau->by_v, u, u + n, t,
			                 base->over);
		if (base->rom->history)
			hawser__rom_history(base->rom, radau->right, radau->by_u, radau->by_v, u, u + n, t);
		fill_rows(radau, i, h);
	}
	base->jacobians += S;
	return LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, order, order, radau->M, order, radau->pivot) ? -1
	                                                                                         : 0;
}

/* The residual f - a at the states of `stage`. */
static int fill_residual(struct radau *radau, double h)
{
	int n = radau->of.base.rom->n;

	for (int i = 0; i < S; i++) {
		const double *y = radau->of.stage + i*2*n;
		double t = radau->of.end + radau->of.table.node[i]*h, *f = radau->right + i*n;
		double phase = hawser__stepper_phase(&radau->of.base, t, radau->of.end_low);

		if (hawser__stepper_acceleration(&radau->of.base, f, t, phase, y, y + n))
			return -1;
		for (int k = 0; k < n; k++)
			f[k] -= radau->of.slope[i*n + k];
	}
	return 0;
}

/* Adds the correction `right` to the accelerations and the states; largest change of a state in units
 * of the tolerance. */
static double correct(struct radau *radau, double h)
{
	int n = radau->of.base.rom->n;
	double worst = 0.0, *change = radau->by_u; /* scratch once M is factorised: [2n] */

	for (int i = 0; i < S*n; i++)
		radau->of.slope[i] += radau->right[i];
	for (int i = 0; i < S; i++) {
		increment(radau, change, change + n, i, radau->right, NULL, h);
		for (int k = 0; k < 2*n; k++) {
			radau->of.stage[i*2*n + k] += change[k];
			worst = fmax(worst, fabs(change[k])/radau->weights.weight[k]);
		}
	}
	return worst;
}

/* Solve the step's equations; 0 when done, -1 when h is too long for it. */
static int solve(struct hawser__collocated *of, double h)
{
	struct radau *radau = (struct radau *)of;
	double last = 0.0, floor = fmax(FLOOR, 4.0*DBL_EPSILON/radau->of.base.rtol);
	int order = S*radau->of.base.rom->n;

	if (hawser__collocated_predict(of, h))
		return -1;
	fill_stages(radau, h);
	hawser__weights_set(&radau->weights, &radau->of.base, radau->of.to, radau->of.stage, S, h);
	if (factorise(radau, h))
		return -1;
	for (int iteration = 1; iteration <= MAX_ITERATIONS; iteration++) {
		double now;

		if (fill_residual(radau, h))
			return -1;
		LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', order, 1, radau->M, order, radau->pivot,
		                    radau->right, order);
		now = correct(radau, h);
		if (!isfinite(now))
			return -1;
		if (now == 0.0 || now*now <= ITERATE_TO*last)
			return 0;
		if (iteration > 2 && now >= 0.5*last)
			return now <= floor ? 0 : -1;
		last = now;
	}
	return -1;
}

static void accept(struct hawser__collocated *of, double h)
{
	struct radau *radau = (struct radau *)of;
	int n = of->base.rom->n;
	double *change = radau->by_u;

	hawser__collocated_transform(of, radau->beta, of->stage + n, 2*n);
	increment(radau, change, change + n, S - 1, of->slope, of->from + n, h);
	for (int k = 0; k < n; k++) {
		hawser__collocated_add(&of->to[k], &of->low[k], change[k] + h*of->low[n + k]);
		hawser__collocated_add(&of->to[n + k], &of->low[n + k], change[n + k]);
	}
	hawser__weights_keep(&radau->weights);
}

static double factor(const struct hawser__collocated *of, double error)
{
	(void)of;
	return fmin(hawser__collocated_longer(error), GROW_AT_MOST);
}

static const double *weight_of(const struct hawser__collocated *of)
{
	return ((const struct radau *)of)->weights.weight;
}

/* --- the method's record --- */

static const struct hawser__collocated_rule rule = {solve, weight_of, accept, factor, interpolate};

static void close_radau(struct hawser__stepper *stepper)
{
	struct radau *radau = (struct radau *)stepper;

	hawser__weights_clear(&radau->weights);
	hawser__hold_clear(&radau->of.hold);
	free(radau);
}

static struct hawser__stepper *open_radau(const struct hawser__stepper *problem, const double *y0)
{
	size_t n = (size_t)problem->rom->n, size = sizeof(double);
	struct radau *radau = calloc(1, sizeof *radau);
	struct hawser__hold *hold;

	if (!radau)
		return NULL;
	hold = &radau->of.hold;
	radau->beta = hawser__hold(hold, S*n, size);
	radau->right = hawser__hold(hold, S*n, size);
	radau->by_omega = hawser__hold(hold, n, size);
	radau->by_u = hawser__hold(hold, n*n + 2*n, size); /* scratch of [2n] too */
	radau->by_v = hawser__hold(hold, n*n, size);
	radau->M = hawser__hold(hold, S*n*S*n, size);
	radau->pivot = hawser__hold(hold, S*n, sizeof *radau->pivot);
	if (hawser__collocated_open(&radau->of, problem, &rule, y0) ||
	    hawser__weights_init(&radau->weights, problem)) {
		close_radau(&radau->of.base);
		return NULL;
	}
	hawser__collocation_make_radau(&radau->of.table, S);
	hawser__collocation_indirect(&radau->of.table);
	return &radau->of.base;
}

const struct hawser__method hawser__radau = {
	{"radau", "Radau IIA collocation of order 15, Newton: coordinates too fast for the steps follow"},
	open_radau, hawser__collocated_advance, close_radau, hawser__collocated_step
};
