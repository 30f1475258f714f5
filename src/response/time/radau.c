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
#include "config.h"

#include <cblas.h>
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/orbit/collocation.h"
#include "response/orbit/weights.h"
#include "rom/terms/history.h"
#include "rom/build/ramp.h"

#define S HAWSER__NODES
#define MAX_ITERATIONS 10 /* an iteration that needs more is repeated with half the step */
#define ITERATE_TO 1e-2     /* remaining error of the iteration, in units of the tolerance */
#define FLOOR 0.1           /* acceptable where round-off stops the iteration sooner; or 4 ulp */
#define SAFETY 0.9          /* on the step, as in gauss.c */
#define GROW_AT_MOST 2.0    /* as in gauss.c */

struct radau {
	struct hawser__stepper base;
	struct hawser__collocation table;
	double begin, begin_low;  /* time at the start of the last step, and what it rounded off */
	double end, end_low;      /* time reached, and what it rounded off */
	double step;              /* of the last step; 0 before the first */
	double next;              /* step to try */
	double *from;             /* [2n] state at begin */
	double *to, *low;         /* [2n] state at end, and what it rounded off */
	double *alpha, *beta;     /* [S][n] coefficients of a and of v over the last step */
	double *trial;            /* [S][n] those of a over the step in progress */
	double *a, *right;        /* [S][n] accelerations at the nodes, and the residual */
	double *stage;            /* [S][2n] states at the nodes */
	struct hawser__weights weights;
	double *by_u, *by_v;      /* [n][n] */
	double *by_omega;         /* [n] */
	double *M;                /* [S n][S n] by columns */
	double *memory;           /* what holds all of these */
	lapack_int *pivot;        /* [S n] */
};

/* y at fraction x of the last step. */
static void interpolate(const struct radau *radau, double *y, double x)
{
	int n = radau->base.rom->n;
	double once[S], twice[S];

	hawser__collocation_integrals(once, twice, x);
	for (int k = 0; k < n; k++) {
		double u = 0.0, v = 0.0;

		for (int m = S - 1; m >= 0; m--) {
			u += once[m]*radau->beta[m*n + k];
			v += once[m]*radau->alpha[m*n + k];
		}
		y[k] = radau->from[k] + radau->step*u;
		y[n + k] = radau->from[n + k] + radau->step*v;
	}
}

/* --- one step --- */

/* First guess of the accelerations: the last step's polynomial continued, or a constant. */
static int predict(struct radau *radau, double h)
{
	int n = radau->base.rom->n;
	double p[S];

	if (radau->step == 0.0) {
		double phase = hawser__stepper_phase(&radau->base, radau->end, radau->end_low);

		if (hawser__stepper_acceleration(&radau->base, radau->a, radau->end, phase, radau->to,
		                                 radau->to + n))
			return -1;
		for (int i = 1; i < S; i++)
			memcpy(radau->a + i*n, radau->a, (size_t)n*sizeof(double));
		return 0;
	}
	for (int i = 0; i < S; i++) {
		hawser__legendre(p, 1.0 + 2.0*radau->table.node[i]*h/radau->step, S);
		for (int k = 0; k < n; k++) {
			double sum = 0.0;

			for (int m = S - 1; m >= 0; m--)
				sum += p[m]*radau->alpha[m*n + k];
			radau->a[i*n + k] = sum;
		}
	}
	return 0;
}

/* The increments of u and v at node i by the accelerations a [S][n]; v0 [n] or NULL. */
static void increment(const struct radau *radau, double *du, double *dv, int i, const double *a,
                      const double *v0, double h)
{
	int n = radau->base.rom->n;

	for (int k = 0; k < n; k++) {
		du[k] = v0 ? h*radau->table.node[i]*v0[k] : 0.0;
		dv[k] = 0.0;
	}
	for (int j = 0; j < S; j++) {
		double once = h*radau->table.once[i][j], twice = h*h*radau->table.twice[i][j];

		for (int k = 0; k < n; k++) {
			du[k] += twice*a[j*n + k];
			dv[k] += once*a[j*n + k];
		}
	}
}

static void fill_stages(struct radau *radau, double h)
{
	int n = radau->base.rom->n;

	for (int i = 0; i < S; i++) {
		double *y = radau->stage + i*2*n;

		increment(radau, y, y + n, i, radau->a, radau->to + n, h);
		for (int k = 0; k < 2*n; k++)
			y[k] += radau->to[k];
	}
}

/* Rows of node i of M. */
static void fill_rows(struct radau *radau, int i, double h)
{
	int n = radau->base.rom->n;
	size_t order = (size_t)S*(size_t)n;

	for (int j = 0; j < S; j++) {
		double once = h*radau->table.once[i][j], twice = h*h*radau->table.twice[i][j];

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
	struct hawser__stepper *base = &radau->base;
	int n = base->rom->n, order = S*n;

	for (int i = 0; i < S; i++) {
		const double *u = radau->stage + i*2*n;
		double t = radau->end + radau->table.node[i]*h;
		double phase = hawser__stepper_phase(base, t, radau->end_low);

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
	int n = radau->base.rom->n;

	for (int i = 0; i < S; i++) {
		const double *y = radau->stage + i*2*n;
		double t = radau->end + radau->table.node[i]*h, *f = radau->right + i*n;
		double phase = hawser__stepper_phase(&radau->base, t, radau->end_low);

		if (hawser__stepper_acceleration(&radau->base, f, t, phase, y, y + n))
			return -1;
		for (int k = 0; k < n; k++)
			f[k] -= radau->a[i*n + k];
	}
	return 0;
}

/* Adds the correction `right` to the accelerations and the states; largest change of a state in units
 * of the tolerance. */
static double correct(struct radau *radau, double h)
{
	int n = radau->base.rom->n;
	double worst = 0.0, *change = radau->by_u; /* scratch once M is factorised: [2n] */

	for (int i = 0; i < S*n; i++)
		radau->a[i] += radau->right[i];
	for (int i = 0; i < S; i++) {
		increment(radau, change, change + n, i, radau->right, NULL, h);
		for (int k = 0; k < 2*n; k++) {
			radau->stage[i*2*n + k] += change[k];
			worst = fmax(worst, fabs(change[k])/radau->weights.weight[k]);
		}
	}
	return worst;
}

/* Solve the step's equations; 0 when done, -1 when h is too long for it. */
static int solve(struct radau *radau, double h)
{
	double last = 0.0, floor = fmax(FLOOR, 4.0*DBL_EPSILON/radau->base.rtol);
	int order = S*radau->base.rom->n;

	if (predict(radau, h))
		return -1;
	fill_stages(radau, h);
	hawser__weights_set(&radau->weights, &radau->base, radau->to, radau->stage, S, h);
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

/* sum_i transform[m][i] x_i, of x [S][stride]. */
static void coefficients(const struct radau *radau, double *out, const double *x, int stride)
{
	int n = radau->base.rom->n;

	for (int m = 0; m < S; m++)
		for (int k = 0; k < n; k++) {
			double sum = 0.0;

			for (int i = 0; i < S; i++)
				sum += radau->table.transform[m][i]*x[i*stride + k];
			out[m*n + k] = sum;
		}
}

/* Coefficients of the step just solved, and the error inside it in units of the tolerance, by the rule
 * of gauss.c. */
static double estimate(struct radau *radau, double h)
{
	int n = radau->base.rom->n;
	double worst = 0.0;

	coefficients(radau, radau->trial, radau->a, n);
	for (int k = 0; k < n; k++) {
		const double *a = radau->trial + k;
		double top = fabs(a[(S - 1)*n]), second = fabs(a[(S - 2)*n]);
		double above = fabs(a[(S - 3)*n]) + fabs(a[(S - 4)*n]);
		double decay = above > 0.0 ? fmin(1.0, sqrt((top + second)/above)) : 1.0;
		double left_out = h*decay*fmax(top, decay*second)/(2*S + 1);

		worst = fmax(worst, left_out/radau->weights.weight[n + k]);
		worst = fmax(worst, h*left_out/(2*S + 3)/radau->weights.weight[k]);
	}
	return worst;
}

/* sum + low += term, with low what the sum's rounding left behind. */
static void add(double *sum, double *low, double term)
{
	double old = *sum, all = term + *low;

	*sum = old + all;
	*low = all - (*sum - old);
}

static double left_over(const struct radau *radau)
{
	return radau->base.until - radau->end - radau->end_low;
}

static void accept(struct radau *radau, double h)
{
	int n = radau->base.rom->n;
	double *swap = radau->alpha, *change = radau->by_u;

	radau->alpha = radau->trial;
	radau->trial = swap;
	coefficients(radau, radau->beta, radau->stage + n, 2*n);
	memcpy(radau->from, radau->to, 2*(size_t)n*sizeof *radau->from);
	increment(radau, change, change + n, S - 1, radau->a, radau->from + n, h);
	for (int k = 0; k < n; k++) {
		add(&radau->to[k], &radau->low[k], change[k] + h*radau->low[n + k]);
		add(&radau->to[n + k], &radau->low[n + k], change[n + k]);
	}
	hawser__weights_keep(&radau->weights);
	radau->begin = radau->end;
	radau->begin_low = radau->end_low;
	if (h == left_over(radau)) {
		radau->end = radau->base.until; /* to the last bit */
		radau->end_low = 0.0;
	} else {
		add(&radau->end, &radau->end_low, h);
	}
	radau->step = radau->base.step = h;
	radau->base.reached = radau->end;
	radau->base.steps++;
}

static double factor(double error)
{
	return fmin(SAFETY*pow(fmax(error, 1e-30), -1.0/(S + 1)), GROW_AT_MOST);
}

/* The step to try: the last ones before `until` are evened out, so that no sliver is left over. */
static double attempt(const struct radau *radau)
{
	double left = left_over(radau);
	double next = hawser__stepper_limited(&radau->base, radau->next);

	if (next >= left)
		return left;
	return next > left/2.0 ? left/2.0 : next;
}

static enum hawser_status take_step(struct hawser__stepper *base, struct hawser_report *report)
{
	struct radau *radau = (struct radau *)base;
	double shortest = DBL_EPSILON*(16.0*radau->end + base->until - radau->end);

	for (;;) {
		double h = attempt(radau), error;

		if (radau->next < shortest)
			return hawser__stepper_escaped(base, radau->to, radau->end, radau->next, report);
		if (solve(radau, h)) {
			radau->next = h/2.0;
			continue;
		}
		error = estimate(radau, h);
		if (!(error <= 1.0)) {
			radau->next = h*fmax(0.2, isfinite(error) ? factor(error) : 0.0);
			continue;
		}
		accept(radau, h);
		if (h == radau->next)
			radau->next = h*factor(error);
		return HAWSER_OK;
	}
}

/* --- the method's record --- */

static void close_radau(struct hawser__stepper *stepper)
{
	struct radau *radau = (struct radau *)stepper;

	hawser__weights_clear(&radau->weights);
	free(radau->memory);
	free(radau->pivot);
	free(radau);
}

static void set_up(struct radau *radau, const double *y0)
{
	size_t n = (size_t)radau->base.rom->n;
	double *at = radau->memory;

	radau->from = at;
	radau->to = at += 2*n;
	radau->low = at += 2*n;
	radau->alpha = at += 2*n;
	radau->beta = at += S*n;
	radau->trial = at += S*n;
	radau->a = at += S*n;
	radau->right = at += S*n;
	radau->stage = at += S*n;
	radau->by_omega = at += 2*S*n;
	radau->by_u = at += n;
	radau->by_v = at += n*n + 2*n; /* by_u is scratch of [2n] too */
	radau->M = at += n*n;
	memcpy(radau->to, y0, 2*n*sizeof *y0);
	hawser__collocation_make_radau(&radau->table);
	hawser__collocation_indirect(&radau->table);
	radau->begin = radau->end = radau->base.reached = radau->base.begin;
	radau->next = hawser__stepper_first(&radau->base);
}

static struct hawser__stepper *open_radau(const struct hawser__stepper *problem, const double *y0)
{
	size_t n = (size_t)problem->rom->n;
	struct radau *radau = calloc(1, sizeof *radau);

	if (!radau)
		return NULL;
	radau->base = *problem;
	radau->memory = calloc(3*2*n + 7*S*n + n + 2*n*n + 2*n + S*n*S*n, sizeof(double));
	radau->pivot = calloc(S*n, sizeof *radau->pivot);
	if (!radau->memory || !radau->pivot || hawser__weights_init(&radau->weights, problem)) {
		close_radau(&radau->base);
		return NULL;
	}
	set_up(radau, y0);
	return &radau->base;
}

static enum hawser_status advance(struct hawser__stepper *stepper, double *y, double t,
                                  struct hawser_report *report)
{
	struct radau *radau = (struct radau *)stepper;
	enum hawser_status status;

	while (radau->end < t) {
		if (stepper->steps >= stepper->max_steps)
			return hawser__stepper_too_long(stepper, radau->end, report);
		if ((status = take_step(stepper, report)))
			return status;
	}
	if (radau->end == t && (radau->end_low == 0.0 || radau->step == 0.0))
		memcpy(y, radau->to, 2*(size_t)stepper->rom->n*sizeof *y);
	else
		interpolate(radau, y, (t - radau->begin - radau->begin_low)/radau->step);
	return HAWSER_OK;
}

const struct hawser__method hawser__radau = {
	{"radau", "Radau IIA collocation of order 15, Newton: coordinates too fast for the steps follow"},
	open_radau, advance, close_radau, take_step
};
