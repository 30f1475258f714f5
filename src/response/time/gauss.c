/* response/time/gauss.c - Gauss collocation, order 2s = 16, with a controlled step and dense output.
 *
 *    a(x)     acceleration over a step, with the coefficients alpha_m (collocated.h)
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
 * The step is kept if it could grow by less than GROW_FROM, since a constant step conserves energy
 * best. It is also kept if the iteration contracts by e^-2 or faster. The number of iterations is
 * log(tol)/log(rate), and the iterations per unit of time are fewest at that rate.
 *
 * Reference: Hairer, Lubich, Wanner, Geometric Numerical Integration, 2nd ed., II.1.3, VIII.5,
 * VIII.6.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "response/orbit/weights.h"
#include "response/time/collocated.h"

#define S HAWSER__NODES
#define MAX_ITERATIONS 40 /* with BEST_RATE, round-off is reached in 18 */
#define ITERATE_TO 1e-2     /* remaining iteration error, in units of the tolerance; chosen */
#define FLOOR 0.1           /* the same if round-off ends the iteration earlier, or 4 ulp; chosen */
#define BEST_RATE 0.135     /* e^-2, see above */
#define GROW_FROM 1.2 /* see above; chosen */
#define GROW_AT_MOST 2.0 /* an error estimate of order 16 does not hold for much longer steps;
                          * chosen */

struct gauss {
	struct hawser__collocated of;
	double phase;             /* of the forcing at the time reached */
	double *before;           /* [S][2n] states at the nodes in the last iteration */
	double *weight;           /* [2n] allowed error */
	struct hawser__weights followers; /* if base.watched */
	double rate;              /* contraction in the last iteration */
};

/* y at fraction x of the last step. */
static void interpolate(const struct hawser__collocated *of, double *y, double x)
{
	int n = of->base.rom->n;
	double once[S], twice[S], h = of->step;

	hawser__collocation_integrals(once, twice, x);
	for (int k = 0; k < n; k++) {
		double u = 0.0, v = 0.0;

		for (int m = S - 1; m >= 0; m--) {
			u += twice[m]*of->alpha[m*n + k];
			v += once[m]*of->alpha[m*n + k];
		}
		y[k] = of->from[k] + h*(x*of->from[n + k] + h*u);
		y[n + k] = of->from[n + k] + h*v;
	}
}

/* --- one step --- */

/* States at the nodes from the slopes. */
static void fill_stages(struct gauss *gauss, double h)
{
	int n = gauss->of.base.rom->n;

	for (int i = 0; i < S; i++) {
		double *y = gauss->of.stage + i*2*n;

		memset(y, 0, 2*(size_t)n*sizeof *y);
		for (int j = 0; j < S; j++) {
			const double *a = gauss->of.slope + j*n;
			double once = h*gauss->of.table.once[i][j], twice = h*h*gauss->of.table.twice[i][j];

			for (int k = 0; k < n; k++) {
				y[k] += twice*a[k];
				y[n + k] += once*a[k];
			}
		}
		for (int k = 0; k < n; k++) {
			y[k] += h*gauss->of.table.node[i]*gauss->of.to[n + k] + gauss->of.to[k];
			y[n + k] += gauss->of.to[n + k];
		}
	}
}

static int fill_slopes(struct gauss *gauss, double h)
{
	int n = gauss->of.base.rom->n;

	for (int i = 0; i < S; i++) {
		const double *y = gauss->of.stage + i*2*n;

		double since = gauss->of.table.node[i]*h;
		double omega = hawser__stepper_omega(&gauss->of.base, gauss->of.end + 0.5*since); /* the mean */

		if (hawser__stepper_acceleration(&gauss->of.base, gauss->of.slope + i*n, gauss->of.end + since,
		                                 gauss->phase + omega*since, y, y + n))
			return -1;
	}
	return 0;
}

static void set_weights(struct gauss *gauss)
{
	int width = 2*gauss->of.base.rom->n;

	for (int k = 0; k < width; k++) {
		double size = fabs(gauss->of.to[k]);

		for (int i = 0; i < S; i++)
			size = fmax(size, fabs(gauss->of.stage[i*width + k]));
		gauss->weight[k] = gauss->of.base.rtol*size + gauss->of.base.atol;
	}
}

/* Largest change of a stage since the last iteration, in units of the tolerance. */
static double change(const struct gauss *gauss)
{
	int width = 2*gauss->of.base.rom->n;
	double worst = 0.0;

	for (int i = 0; i < S; i++)
		for (int k = 0; k < width; k++)
			worst = fmax(worst, fabs(gauss->of.stage[i*width + k] -
			                         gauss->before[i*width + k])/gauss->weight[k]);
	return worst;
}

/* Solve the equations of the step; returns 0, or -1 if h is too long for convergence. */
static int substitute(struct hawser__collocated *of, double h)
{
	struct gauss *gauss = (struct gauss *)of;
	double last = 0.0, floor = fmax(FLOOR, 4.0*DBL_EPSILON/gauss->of.base.rtol);

	gauss->rate = 0.0;
	gauss->phase = hawser__stepper_phase(&gauss->of.base, gauss->of.end, gauss->of.end_low);
	if (hawser__collocated_predict(of, h))
		return -1;
	fill_stages(gauss, h);
	set_weights(gauss);
	for (int iteration = 1; iteration <= MAX_ITERATIONS; iteration++) {
		double *swap = gauss->before, now;

		if (fill_slopes(gauss, h))
			return -1;
		gauss->before = gauss->of.stage;
		gauss->of.stage = swap;
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

/* Sets base.longer. */
static void watch(struct gauss *gauss, double h)
{
	if (!gauss->of.base.watched)
		return;
	hawser__weights_set(&gauss->followers, &gauss->of.base, gauss->of.to, gauss->of.stage, S, h);
	gauss->of.base.longer = hawser__collocated_longer(
		hawser__collocated_error(&gauss->of, gauss->of.alpha, h, gauss->followers.weight));
	hawser__weights_keep(&gauss->followers);
}

static void accept(struct hawser__collocated *of, double h)
{
	int n = of->base.rom->n;

	watch((struct gauss *)of, h);
	for (int k = 0; k < n; k++) {
		double u = 0.0, v = 0.0;

		for (int j = 0; j < S; j++) {
			u += of->table.end_twice[j]*of->slope[j*n + k];
			v += of->table.end_once[j]*of->slope[j*n + k];
		}
		u = h*(of->from[n + k] + h*u) + h*of->low[n + k];
		hawser__collocated_add(&of->to[k], &of->low[k], u);
		hawser__collocated_add(&of->to[n + k], &of->low[n + k], h*v);
	}
}

static double factor(const struct hawser__collocated *of, double error)
{
	const struct gauss *gauss = (const struct gauss *)of;
	double by_error = hawser__collocated_longer(error);
	double by_rate = gauss->rate > 0.0 ? sqrt(BEST_RATE/gauss->rate) : GROW_AT_MOST;
	double ratio = fmin(fmin(by_error, fmax(by_rate, 0.5)), GROW_AT_MOST);

	/* An accepted step is shortened only if the iteration converges slowly. */
	if (error <= 1.0 && ratio < GROW_FROM && by_rate > 1.0/GROW_FROM)
		return 1.0;
	return ratio;
}

static const double *weight_of(const struct hawser__collocated *of)
{
	return ((const struct gauss *)of)->weight;
}

/* --- the method's record --- */

static const struct hawser__collocated_rule rule = {
	substitute, weight_of, accept, factor, interpolate};

static void close_gauss(struct hawser__stepper *stepper)
{
	struct gauss *gauss = (struct gauss *)stepper;

	hawser__weights_clear(&gauss->followers);
	hawser__hold_clear(&gauss->of.hold);
	free(gauss);
}

static struct hawser__stepper *open_gauss(const struct hawser__stepper *problem, const double *y0)
{
	size_t n = (size_t)problem->rom->n, size = sizeof(double);
	struct gauss *gauss = calloc(1, sizeof *gauss);

	if (!gauss)
		return NULL;
	gauss->before = hawser__hold(&gauss->of.hold, S*2*n, size);
	gauss->weight = hawser__hold(&gauss->of.hold, 2*n, size);
	if (hawser__collocated_open(&gauss->of, problem, &rule, y0) ||
	    (problem->watched && hawser__weights_init(&gauss->followers, problem))) {
		close_gauss(&gauss->of.base);
		return NULL;
	}
	hawser__collocation_make(&gauss->of.table);
	return &gauss->of.base;
}

const struct hawser__method hawser__gauss = {
	{"gauss", "Gauss collocation of order 16: tight tolerances, energy kept over long times"},
	open_gauss, hawser__collocated_advance, close_gauss, hawser__collocated_step
};
