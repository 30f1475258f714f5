/* response/gauss.c - Gauss collocation, order 2s = 16, with a controlled step and dense output.
 *
 *   a(x)     acceleration over a step as a polynomial of degree s - 1, x in [0, 1]
 *   alpha_m  its Legendre coefficients: a(x) = sum_m alpha_m P_m(2x - 1)
 *   I_m, J_m the first and second integrals of P_m(2x - 1) from 0
 *   c_i, b_i Gauss nodes and weights on [0, 1]
 *
 * The step asks that a(x) equal the model's acceleration at the nodes, where
 *
 *   v(x) = v0 + h sum_m alpha_m I_m(x),   u(x) = u0 + h x v0 + h^2 sum_m alpha_m J_m(x)
 *
 * and finds it by repeated substitution, started from the last step's polynomial continued.
 *
 * Why this and not only CVODE: the second-order form squares the contraction (h omega)^2, the
 * method is symplectic and symmetric, so an undamped model keeps its energy to the order of
 * round-off, and the polynomial itself is the output between steps. Measured figures:
 * doc/theory-integrate.md.
 *
 * Step control: the first coefficient left out, alpha_s, is extrapolated from the decay of those at
 * hand over two indices (one would be fooled by parity), and its share of u and v *inside* the step
 * is held to the tolerance; the step's end is of twice the order and better by far, so the output
 * is as good anywhere as the tolerance says. The step is kept when it could grow by less than
 * GROW_FROM: a constant step is what conserves. It also stays where substitution contracts by
 * e^-2 or better: iterations times steps per unit of time is least there, for log(tol)/log(rate)
 * iterations with rate ~ h^2.
 *
 * Compensated summation of u, v and t: at 1e5 steps plain sums would lose three digits. What t rounds
 * off counts in the forcing's phase, in the output between steps and in the last step too: after 1e8
 * periods it is 1e-7 of one.
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
#include "response/collocation.h"
#include "response/stepper.h"

#define S HAWSER__NODES
#define MAX_ITERATIONS 40 /* BEST_RATE reaches round-off in 18 */
#define ITERATE_TO 1e-2     /* remaining substitution error, in units of the tolerance */
#define FLOOR 0.1           /* acceptable where round-off stops the substitution sooner; or 4 ulp */
#define BEST_RATE 0.135     /* e^-2 */
#define SAFETY 0.9 /* on the step: it need not be repeated for an error just too large */
#define GROW_FROM 1.2 /* as above: a step that hardly differs stays */
#define GROW_AT_MOST 2.0 /* an error of order 16 says little about a step longer than that */

struct gauss {
	struct hawser__stepper base;
	struct hawser__collocation table;
	double begin, begin_low;  /* time at the start of the last step, and what it rounded off */
	double end, end_low;      /* time reached, and what it rounded off */
	double phase;             /* of the forcing, there */
	double step;              /* of the last step; 0 before the first */
	double next;              /* step to try */
	double *from;             /* [2n] state at begin */
	double *to, *low;         /* [2n] state at end, and what it rounded off */
	double *alpha, *trial;    /* [S][n] coefficients of the last step, of the one in progress */
	double *slope;            /* [S][n] accelerations at the nodes */
	double *stage, *before;   /* [S][2n] states at the nodes, in this and the last iteration */
	double *weight;           /* [2n] what the tolerance allows */
	double rate;              /* of contraction in the last substitution */
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

/* First guess of the slopes: the last step's polynomial continued, or a constant at the start. */
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

		if (hawser__stepper_acceleration(&gauss->base, gauss->slope + i*n, gauss->end + since,
		                                 gauss->phase + gauss->base.omega*since, y, y + n))
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

/* Solve the step's equations; 0 when done, -1 when h is too long for it. */
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

/* Coefficients of the step just solved, and the error inside it in units of the tolerance. */
static double estimate(struct gauss *gauss, double h)
{
	int n = gauss->base.rom->n;
	double worst = 0.0;

	for (int m = 0; m < S; m++)
		for (int k = 0; k < n; k++) {
			double sum = 0.0;

			for (int i = 0; i < S; i++)
				sum += gauss->table.transform[m][i]*gauss->slope[i*n + k];
			gauss->trial[m*n + k] = sum;
		}
	for (int k = 0; k < n; k++) {
		const double *a = gauss->trial + k;
		double top = fabs(a[(S - 1)*n]), second = fabs(a[(S - 2)*n]);
		double above = fabs(a[(S - 3)*n]) + fabs(a[(S - 4)*n]);
		double decay = above > 0.0 ? fmin(1.0, sqrt((top + second)/above)) : 1.0;
		double left_out = h*decay*fmax(top, decay*second)/(2*S + 1);

		worst = fmax(worst, left_out/gauss->weight[n + k]);
		worst = fmax(worst, h*left_out/(2*S + 3)/gauss->weight[k]);
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

/* Time to the end of the run. */
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
	gauss->step = h;
	gauss->base.steps++;
}

static double factor(const struct gauss *gauss, double error)
{
	double by_error = SAFETY*pow(fmax(error, 1e-30), -1.0/(S + 1));
	double by_rate = gauss->rate > 0.0 ? sqrt(BEST_RATE/gauss->rate) : GROW_AT_MOST;
	double ratio = fmin(fmin(by_error, fmax(by_rate, 0.5)), GROW_AT_MOST);

	/* An accepted step shrinks only where substitution is slow. */
	if (error <= 1.0 && ratio < GROW_FROM && by_rate > 1.0/GROW_FROM)
		return 1.0;
	return ratio;
}

/* The step to try: the last ones before `until` are evened out, so that no sliver is left over. */
static double attempt(const struct gauss *gauss)
{
	double left = left_over(gauss);

	if (gauss->next >= left)
		return left;
	return gauss->next > left/2.0 ? left/2.0 : gauss->next;
}

static enum hawser_status take_step(struct gauss *gauss, struct hawser_report *report)
{
	struct hawser__stepper *base = &gauss->base;
	double shortest = DBL_EPSILON*(16.0*gauss->end + base->until - gauss->end);

	for (;;) {
		double h = attempt(gauss), error;

		if (gauss->next < shortest)
			return hawser__stepper_escaped(base, gauss->to, gauss->end, gauss->next, report);
		if (substitute(gauss, h)) {
			gauss->next = h/2.0;
			continue;
		}
		error = estimate(gauss, h);
		if (!(error <= 1.0)) {
			gauss->next = h*fmax(0.2, isfinite(error) ? factor(gauss, error) : 0.0);
			continue;
		}
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

/* A first step: short against the forcing, and against every rate in the row sums of the Jacobian,
 * so that the controller starts from below. */
static double first_step(struct gauss *gauss)
{
	const struct hawser_rom *rom = gauss->base.rom;
	int n = rom->n, highest = 0;
	double rate = 0.0;

	for (int h = 0; h < rom->harmonics; h++)
		highest = rom->harmonic[h].k > highest ? rom->harmonic[h].k : highest;
	for (int j = 0; j < n; j++) {
		double stiffness = 0.0, damping = 0.0;

		for (int k = 0; k < n; k++) {
			stiffness += fabs(rom->K[j*n + k]);
			damping += fabs(rom->D[j*n + k]);
		}
		rate = fmax(rate, sqrt(stiffness) + damping);
	}
	rate = fmax(rate, highest*gauss->base.omega);
	return rate > 0.0 ? fmin(0.5/rate, gauss->base.until - gauss->end)
	                  : (gauss->base.until - gauss->end)/16.0;
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
	    !gauss->slope || !gauss->stage || !gauss->before || !gauss->weight) {
		close_gauss(&gauss->base);
		return NULL;
	}
	memcpy(gauss->to, y0, 2*n*size);
	hawser__collocation_make(&gauss->table);
	gauss->begin = gauss->end = problem->begin;
	gauss->next = first_step(gauss);
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
		if ((status = take_step(gauss, report)))
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
	open_gauss, advance, close_gauss
};
