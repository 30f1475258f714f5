/* response/time/gauss.c - Gauss collocation, order 2s = 16, with a controlled step and dense output.
 *
 *    a(x)     acceleration over a step as a polynomial of degree s - 1, x in [0, 1]
 *    alpha_m  its Legendre coefficients: a(x) = sum_m alpha_m P_m(2x - 1)
 *    I_m, J_m the first and second integrals of P_m(2x - 1) from 0
 *    c_i, b_i Gauss nodes and weights on [0, 1]
 *
 * In a step, a(x) equals the acceleration of the model at the nodes, where
 *
 *    v(x) = v0 + h sum_m alpha_m I_m(x),   u(x) = u0 + h x v0 + h^2 sum_m alpha_m J_m(x)
 *
 * The equations are solved by fixed-point iteration, which starts from the extrapolated polynomial
 * of the last step.
 *
 * Advantages over CVODE: the second-order form squares the contraction, (h omega)^2; the method is
 * symplectic and symmetric, so that an undamped model keeps its energy to the order of round-off;
 * and the polynomial itself is the output between steps. Measured figures: doc/theory-integrate.md.
 *
 * Step control: the first omitted coefficient, alpha_s, is extrapolated from the decay of the
 * computed ones over two indices (the decay over one would be misled by parity). The tolerance
 * limits its contribution to u and v inside the step. The end of the step has twice the order and
 * is far more accurate, so that the output has the stated accuracy everywhere. The step is kept if
 * it could grow by less than GROW_FROM, since a constant step conserves energy best. It is also
 * kept if the iteration contracts by e^-2 or faster. The number of iterations is
 * log(tol)/log(rate), and the iterations per unit of time are fewest at that rate.
 *
 * u, v and t are summed with compensation: at 1e5 steps plain sums would lose three digits. The
 * round-off of t also enters the phase of the forcing, the output between steps and the last step;
 * after 1e8 periods it would be 1e-7 of a period.
 *
 * Reference: Hairer, Lubich, Wanner, Geometric Numerical Integration, 2nd ed., II.1.3, VIII.5,
 * VIII.6.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/orbit/collocation.h"
#include "response/orbit/weights.h"

#define S HAWSER__NODES
#define MAX_ITERATIONS 40 /* with BEST_RATE, round-off is reached in 18 */
#define ITERATE_TO 1e-2     /* remaining iteration error, in units of the tolerance; chosen */
#define FLOOR 0.1           /* the same if round-off ends the iteration earlier, or 4 ulp; chosen */
#define BEST_RATE 0.135     /* e^-2, see above */
#define SAFETY 0.9 /* factor on the step, so that an error slightly too large does not repeat it;
                    * chosen */
#define GROW_FROM 1.2 /* see above; chosen */
#define GROW_AT_MOST 2.0 /* an error estimate of order 16 does not hold for much longer steps;
                          * chosen */

struct gauss {
	struct hawser__stepper base;
	struct hawser__collocation table;
	double begin, begin_low;  /* time at the start of the last step, and its rounding error */
	double end, end_low;      /* time reached, and its rounding error */
	double phase;             /* phase of the forcing at that time */
	double step;              /* of the last step; 0 before the first */
	double next;              /* length of the next step */
	double *from;             /* [2n] state at begin */
	double *to, *low;         /* [2n] state at end, and its rounding error */
	double *alpha, *trial;    /* [S][n] coefficients of the last step and of the present one */
	double *slope;            /* [S][n] accelerations at the nodes */
	double *stage, *before;   /* [S][2n] states at the nodes, in this and the last iteration */
	double *weight;           /* [2n] allowed error */
	struct hawser__weights followers; /* if base.watched */
	double rate;              /* contraction in the last iteration */
};

/* y at fraction x of the last step. */
static void interpolate(const struct gauss *gauss, double *y, double x)
{
	int n = gauss->base.rom->n;
	double once[S], twice[S], h = gauss->step;

	hawser__collocation_integrals(once, twice, x);
	for (int k = 0; k < n; k++) {
		double u = 0.0, v = 0.0;

		for (int m = S - 1; m >= 0; m--) {
			u += twice[m]*gauss->alpha[m*n + k];
			v += once[m]*gauss->alpha[m*n + k];
		}
		y[k] = gauss->from[k] + h*(x*gauss->from[n + k] + h*u);
		y[n + k] = gauss->from[n + k] + h*v;
	}
}

/* --- one step --- */

/* Initial slopes: the extrapolated polynomial of the last step, or a constant at the start. */
static int predict(struct gauss *gauss, double h)
{
	int n = gauss->base.rom->n;
	double p[S];

	if (gauss->step == 0.0) {
		if (hawser__stepper_acceleration(&gauss->base, gauss->slope, gauss->end, gauss->phase,
		                                 gauss->to, gauss->to + n))
			return -1;
		for (int i = 1; i < S; i++)
			memcpy(gauss->slope + i*n, gauss->slope, (size_t)n*sizeof(double));
		return 0;
	}
	for (int i = 0; i < S; i++) {
		hawser__legendre(p, 1.0 + 2.0*gauss->table.node[i]*h/gauss->step, S);
		for (int k = 0; k < n; k++) {
			double sum = 0.0;

			for (int m = S - 1; m >= 0; m--)
				sum += p[m]*gauss->alpha[m*n + k];
			gauss->slope[i*n + k] = sum;
		}
	}
	return 0;
}

/* States at the nodes from the slopes. */
static void fill_stages(struct gauss *gauss, double h)
{
	int n = gauss->base.rom->n;

	for (int i = 0; i < S; i++) {
		double *y = gauss->stage + i*2*n;

		memset(y, 0, 2*(size_t)n*sizeof *y);
		for (int j = 0; j < S; j++) {
			const double *a = gauss->slope + j*n;
			double once = h*gauss->table.once[i][j], twice = h*h*gauss->table.twice[i][j];

			for (int k = 0; k < n; k++) {
				y[k] += twice*a[k];
				y[n + k] += once*a[k];
			}
		}
		for (int k = 0; k < n; k++) {
			y[k] += h*gauss->table.node[i]*gauss->to[n + k] + gauss->to[k];
			y[n + k] += gauss->to[n + k];
		}
	}
}

static int fill_slopes(struct gauss *gauss, double h)
{
	int n = gauss->base.rom->n;

	for (int i = 0; i < S; i++) {
		const double *y = gauss->stage + i*2*n;

		double since = gauss->table.node[i]*h;
		double omega = hawser__stepper_omega(&gauss->base, gauss->end + 0.5*since); /* the mean */

		if (hawser__stepper_acceleration(&gauss->base, gauss->slope + i*n, gauss->end + since,
		                                 gauss->phase + omega*since, y, y + n))
			return -1;
	}
	return 0;
}

static void set_weights(struct gauss *gauss)
{
	int width = 2*gauss->base.rom->n;

	for (int k = 0; k < width; k++) {
		double size = fabs(gauss->to[k]);

		for (int i = 0; i < S; i++)
			size = fmax(size, fabs(gauss->stage[i*width + k]));
		gauss->weight[k] = gauss->base.rtol*size + gauss->base.atol;
	}
}

/* Largest change of a stage since the last iteration, in units of the tolerance. */
static double change(const struct gauss *gauss)
{
	int width = 2*gauss->base.rom->n;
	double worst = 0.0;

	for (int i = 0; i < S; i++)
		for (int k = 0; k < width; k++)
			worst = fmax(worst, fabs(gauss->stage[i*width + k] -
			                         gauss->before[i*width + k])/gauss->weight[k]);
	return worst;
}

/* Solve the equations of the step; returns 0, or -1 if h is too long for convergence. */
static int substitute(struct gauss *gauss, double h)
{
	double last = 0.0, floor = fmax(FLOOR, 4.0*DBL_EPSILON/gauss->base.rtol);

	gauss->rate = 0.0;
	gauss->phase = hawser__stepper_phase(&gauss->base, gauss->end, gauss->end_low);
	if (predict(gauss, h))
		return -1;
	fill_stages(gauss, h);
	set_weights(gauss);
	for (int iteration = 1; iteration <= MAX_ITERATIONS; iteration++) {
		double *swap = gauss->before, now;

		if (fill_slopes(gauss, h))
			return -1;
		gauss->before = gauss->stage;
		gauss->stage = swap;
		fill_stages(gauss, h);
		now = change(gauss);
		if (iteration > 1 && now > FLOOR)
			gauss->rate = fmax(gauss->rate, now/last);
		if (now == 0.0 || now*now <= ITERATE_TO*last)
			return 0;
		if (iteration > 1 && now >= 0.7*last)
			return now <= floor ? 0 : -1;
		last = now;
	}
	return -1;
}

/* Coefficients of the step just solved. */
static void transform(struct gauss *gauss)
{
	int n = gauss->base.rom->n;

	for (int m = 0; m < S; m++)
		for (int k = 0; k < n; k++) {
			double sum = 0.0;

			for (int i = 0; i < S; i++)
				sum += gauss->table.transform[m][i]*gauss->slope[i*n + k];
			gauss->trial[m*n + k] = sum;
		}
}

/* The error inside the step just solved, in units of weight [2n]. */
static double estimate(const struct gauss *gauss, double h, const double *weight)
{
	int n = gauss->base.rom->n;
	double worst = 0.0;

	for (int k = 0; k < n; k++) {
		const double *a = gauss->trial + k;
		double top = fabs(a[(S - 1)*n]), second = fabs(a[(S - 2)*n]);
		double above = fabs(a[(S - 3)*n]) + fabs(a[(S - 4)*n]);
		double decay = above > 0.0 ? fmin(1.0, sqrt((top + second)/above)) : 1.0;
		double left_out = h*decay*fmax(top, decay*second)/(2*S + 1);

		worst = fmax(worst, left_out/weight[n + k]);
		worst = fmax(worst, h*left_out/(2*S + 3)/weight[k]);
	}
	return worst;
}

/* sum + low += term; low is the rounding error of the sum. */
static void add(double *sum, double *low, double term)
{
	double old = *sum, all = term + *low;

	*sum = old + all;
	*low = all - (*sum - old);
}

/* Time left until the end of the run. */
static double left_over(const struct gauss *gauss)
{
	return gauss->base.until - gauss->end - gauss->end_low;
}

static void accept(struct gauss *gauss, double h)
{
	int n = gauss->base.rom->n;
	double *swap = gauss->alpha;

	gauss->alpha = gauss->trial;
	gauss->trial = swap;
	memcpy(gauss->from, gauss->to, 2*(size_t)n*sizeof *gauss->from);
	for (int k = 0; k < n; k++) {
		double u = 0.0, v = 0.0;

		for (int j = 0; j < S; j++) {
			u += gauss->table.end_twice[j]*gauss->slope[j*n + k];
			v += gauss->table.end_once[j]*gauss->slope[j*n + k];
		}
		u = h*(gauss->from[n + k] + h*u) + h*gauss->low[n + k];
		add(&gauss->to[k], &gauss->low[k], u);
		add(&gauss->to[n + k], &gauss->low[n + k], h*v);
	}
	gauss->begin = gauss->end;
	gauss->begin_low = gauss->end_low;
	if (h == left_over(gauss)) {
		gauss->end = gauss->base.until; /* to the last bit */
		gauss->end_low = 0.0;
	} else {
		add(&gauss->end, &gauss->end_low, h);
	}
	gauss->step = gauss->base.step = h;
	gauss->base.reached = gauss->end;
	gauss->base.steps++;
}

/* How much longer the step could be for its error. */
static double longer(double error)
{
	return SAFETY*pow(fmax(error, 1e-30), -1.0/(S + 1));
}

static double factor(const struct gauss *gauss, double error)
{
	double by_error = longer(error);
	double by_rate = gauss->rate > 0.0 ? sqrt(BEST_RATE/gauss->rate) : GROW_AT_MOST;
	double ratio = fmin(fmin(by_error, fmax(by_rate, 0.5)), GROW_AT_MOST);

	/* An accepted step is shortened only if the iteration converges slowly. */
	if (error <= 1.0 && ratio < GROW_FROM && by_rate > 1.0/GROW_FROM)
		return 1.0;
	return ratio;
}

/* Sets base.longer. */
static void watch(struct gauss *gauss, double h)
{
	if (!gauss->base.watched)
		return;
	hawser__weights_set(&gauss->followers, &gauss->base, gauss->to, gauss->stage, S, h);
	gauss->base.longer = longer(estimate(gauss, h, gauss->followers.weight));
	hawser__weights_keep(&gauss->followers);
}

/* The length of the next step: the last steps before `until` get equal lengths, so that none is
 * very short. */
static double attempt(const struct gauss *gauss)
{
	double left = left_over(gauss);
	double next = hawser__stepper_limited(&gauss->base, gauss->next);

	if (next >= left)
		return left;
	return next > left/2.0 ? left/2.0 : next;
}

static enum hawser_status take_step(struct hawser__stepper *base, struct hawser_report *report)
{
	struct gauss *gauss = (struct gauss *)base;
	double shortest = DBL_EPSILON*(16.0*gauss->end + base->until - gauss->end);

	for (;;) {
		double h = attempt(gauss), error;

		if (gauss->next < shortest)
			return hawser__stepper_escaped(base, gauss->to, gauss->end, gauss->next, report);
		if (substitute(gauss, h)) {
			gauss->next = h/2.0;
			continue;
		}
		transform(gauss);
		error = estimate(gauss, h, gauss->weight);
		if (!(error <= 1.0)) {
			gauss->next = h*fmax(0.2, isfinite(error) ? factor(gauss, error) : 0.0);
			continue;
		}
		watch(gauss, h);
		accept(gauss, h);
		if (h == gauss->next)
			gauss->next = h*factor(gauss, error);
		return HAWSER_OK;
	}
}

/* --- the method's record --- */

static void close_gauss(struct hawser__stepper *stepper)
{
	struct gauss *gauss = (struct gauss *)stepper;

	hawser__weights_clear(&gauss->followers);
	free(gauss->from);
	free(gauss->to);
	free(gauss->low);
	free(gauss->alpha);
	free(gauss->trial);
	free(gauss->slope);
	free(gauss->stage);
	free(gauss->before);
	free(gauss->weight);
	free(gauss);
}

static struct hawser__stepper *open_gauss(const struct hawser__stepper *problem, const double *y0)
{
	size_t n = (size_t)problem->rom->n, size = sizeof(double);
	struct gauss *gauss = calloc(1, sizeof *gauss);

	if (!gauss)
		return NULL;
	gauss->base = *problem;
	gauss->from = calloc(2*n, size);
	gauss->to = calloc(2*n, size);
	gauss->low = calloc(2*n, size);
	gauss->alpha = calloc(S*n, size);
	gauss->trial = calloc(S*n, size);
	gauss->slope = calloc(S*n, size);
	gauss->stage = calloc(S*2*n, size);
	gauss->before = calloc(S*2*n, size);
	gauss->weight = calloc(2*n, size);
	if (!gauss->from || !gauss->to || !gauss->low || !gauss->alpha || !gauss->trial ||
	    !gauss->slope || !gauss->stage || !gauss->before || !gauss->weight ||
	    (problem->watched && hawser__weights_init(&gauss->followers, problem))) {
		close_gauss(&gauss->base);
		return NULL;
	}
	memcpy(gauss->to, y0, 2*n*size);
	hawser__collocation_make(&gauss->table);
	gauss->begin = gauss->end = gauss->base.reached = problem->begin;
	gauss->next = hawser__stepper_first(problem);
	return &gauss->base;
}

static enum hawser_status advance(struct hawser__stepper *stepper, double *y, double t,
                                  struct hawser_report *report)
{
	struct gauss *gauss = (struct gauss *)stepper;
	enum hawser_status status;

	while (gauss->end < t) {
		if (stepper->steps >= stepper->max_steps)
			return hawser__stepper_too_long(stepper, gauss->end, report);
		if ((status = take_step(stepper, report)))
			return status;
	}
	if (gauss->end == t && (gauss->end_low == 0.0 || gauss->step == 0.0))
		memcpy(y, gauss->to, 2*(size_t)stepper->rom->n*sizeof *y);
	else
		interpolate(gauss, y, (t - gauss->begin - gauss->begin_low)/gauss->step);
	return HAWSER_OK;
}

const struct hawser__method hawser__gauss = {
	{"gauss", "Gauss collocation of order 16: tight tolerances, energy kept over long times"},
	open_gauss, advance, close_gauss, take_step
};
