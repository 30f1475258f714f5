/* study/basin/basin_form.c - a stable periodic response from a state nearby, and the neighbourhood in
 * which motions end at it.
 *
 * That a motion is close to a response does not say that it stays: the multipliers tell the decay
 * in the long run, and before that a distance may grow. The quadratic form V of a Lyapunov
 * equation decays from period to period by at least q < 1 as long as the map is nearly linear. How
 * far that reaches is tried: on ellipsoids V = const, along their axes and in further directions,
 * the form must decay by half of what the linear map promises, over as many periods as the slowest
 * distance takes to halve: in one period alone what is nonlinear may outweigh a weak damping,
 * whose effect adds up, while the other changes its sign as the distance turns. The largest of
 * three ellipsoids in a row, each half of the one before, that pass is the neighbourhood.
 * Directions are tried, not all of them; so a motion counts as ended only if the form decays over
 * so many more periods too.
 *
 * Reference: W. Hahn, Stability of Motion, 1967, section 26.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include "core/hold.h"
#include "core/report.h"
#include "study/basin/basin.h"

#define CONVERGED 1e-10 /* last Newton step, relative; chosen */
#define NEUTRAL 1e-7    /* a multiplier nearer to 1 is not known to be inside; chosen */
#define FIRST 1.0       /* radius of the first ellipsoid, relative to the state; chosen */
#define LAST 1e-6       /* of the last one; a smaller one could not be told from errors; chosen */
enum { MOST_TURNS = 40, ITERATIONS = 12, DOUBLINGS = 60, FURTHER = 24, IN_A_ROW = 3 };

/* x over `period` periods; matrix [m][m] becomes the derivative. 1: it escapes. */
static int derive(struct hawser__orbiter *orbiter, double *x, double *matrix, int period)
{
	int m = orbiter->m;
	size_t mm = (size_t)m*(size_t)m;
	double *A = orbiter->work + m, *b = A + mm, *product = b + m, *at = product + mm;

	for (int k = 0; k < period; k++) {
		struct hawser__stretch stretch;

		memcpy(at, x, (size_t)m*sizeof *x);
		if (hawser__orbiter_map(orbiter, at) != HAWSER__MOVES)
			return 1;
		stretch = (struct hawser__stretch){0.0, M_PI/orbiter->steps, 2*orbiter->steps, 1, 0.0};
		(void)hawser__flow_derive(&orbiter->flow, x, A, b, NULL, &stretch, orbiter->omega);
		if (k == 0) {
			memcpy(matrix, A, mm*sizeof *A);
			continue;
		}
		for (int i = 0; i < m; i++)
			for (int j = 0; j < m; j++) {
				double sum = 0.0;

				for (int l = 0; l < m; l++)
					sum += A[i*m + l]*matrix[l*m + j];
				product[i*m + j] = sum;
			}
		memcpy(matrix, product, mm*sizeof *A);
	}
	return 0;
}

/* Newton's method for x = P^period x. Returns 0 where it converged. */
static int newton(struct hawser__orbiter *orbiter, double *x, double *matrix, int period)
{
	int m = orbiter->m;
	double *end = malloc(((size_t)m + (size_t)m*(size_t)m)*sizeof *end);
	double *J = hawser__behind(end, (size_t)m);
	lapack_int *pivot = malloc((size_t)m*sizeof *pivot);
	int failed = 1;

	for (int i = 0; end && pivot && i < ITERATIONS && failed; i++) {
		memcpy(end, x, (size_t)m*sizeof *x);
		if (derive(orbiter, end, matrix, period))
			break;
		for (int j = 0; j < m*m; j++)
			J[j] = matrix[j] - (j/m == j%m ? 1.0 : 0.0);
		for (int j = 0; j < m; j++)
			end[j] = x[j] - end[j];
		if (LAPACKE_dgesv(LAPACK_ROW_MAJOR, m, 1, J, m, pivot, end, 1))
			break;
		for (int j = 0; j < m; j++)
			x[j] += end[j];
		failed = !(hawser__orbiter_size(orbiter, end) <=
		           CONVERGED*hawser__orbiter_size(orbiter, x));
	}
	free(end);
	free(pivot);
	return failed;
}

/* The largest modulus of the eigenvalues of matrix [m][m]; infinite where they are not found. */
static double spectral_radius(const double *matrix, int m)
{
	double *copy = malloc(((size_t)m*(size_t)m + 2*(size_t)m)*sizeof *copy), *re, *im, most = 0.0;

	if (!copy)
		return INFINITY;
	re = copy + m*m;
	im = re + m;
	memcpy(copy, matrix, (size_t)m*(size_t)m*sizeof *copy);
	if (LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', m, copy, m, re, im, NULL, 1, NULL, 1))
		most = INFINITY;
	for (int i = 0; i < m; i++)
		most = fmax(most, hypot(re[i], im[i]));
	free(copy);
	return most;
}

/* C = A B, or A' B; all [m][m]. */
static void multiply(double *C, const double *A, const double *B, int m, int transposed)
{
	for (int i = 0; i < m; i++)
		for (int j = 0; j < m; j++) {
			double sum = 0.0;

			for (int k = 0; k < m; k++)
				sum += (transposed ? A[k*m + i] : A[i*m + k])*B[k*m + j];
			C[i*m + j] = sum;
		}
}

static double weight(const struct hawser__orbiter *orbiter, int i)
{
	return i < orbiter->m/2 ? 1.0 : 1.0/(orbiter->omega*orbiter->omega);
}

/* V = W + M' V M by doubling: the sum of the first 2^k terms, then those times M^(2^k). */
static int lyapunov(double *V, const struct hawser__orbiter *orbiter, const double *matrix)
{
	int m = orbiter->m;
	size_t mm = (size_t)m*(size_t)m;
	double *A = malloc(3*mm*sizeof *A), *B = hawser__behind(A, mm), *C = hawser__behind(B, mm);
	double change = 1.0, size;

	if (!A)
		return 1;
	memcpy(A, matrix, mm*sizeof *A);
	for (size_t i = 0; i < mm; i++)
		V[i] = i/(size_t)m == i%(size_t)m ? weight(orbiter, (int)(i%(size_t)m)) : 0.0;
	for (int k = 0; k < DOUBLINGS && change > 1e-16; k++) {
		multiply(B, V, A, m, 0);
		multiply(C, A, B, m, 1);
		change = size = 0.0;
		for (size_t i = 0; i < mm; i++) {
			V[i] += C[i];
			change = fmax(change, fabs(C[i]));
			size = fmax(size, fabs(V[i]));
		}
		change /= size;
		multiply(B, A, A, m, 0);
		memcpy(A, B, mm*sizeof *A);
	}
	free(A);
	return !(change <= 1e-16);
}

static double form_of(const double *V, const double *z, int m)
{
	double sum = 0.0;

	for (int i = 0; i < m; i++)
		for (int j = 0; j < m; j++)
			sum += z[i]*V[i*m + j]*z[j];
	return sum;
}

/* 1 - 1/lambda, lambda the largest eigenvalue of W^-1/2 V W^-1/2. */
static double contraction(const struct hawser__orbiter *orbiter, const double *V)
{
	int m = orbiter->m;
	double *copy = malloc(((size_t)m*(size_t)m + (size_t)m)*sizeof *copy), q = 1.0;

	if (!copy)
		return 1.0;
	for (int i = 0; i < m*m; i++)
		copy[i] = V[i]/sqrt(weight(orbiter, i/m)*weight(orbiter, i%m));
	if (!LAPACKE_dsyev(LAPACK_ROW_MAJOR, 'N', 'U', m, copy, m, copy + m*m))
		q = 1.0 - 1.0/copy[m*m + m - 1];
	free(copy);
	return q;
}

/* Direction `which` of the ellipsoid z' V z = 1: along its axes, then others that depend on `which`
 * only. axes [m][m] eigenvectors in columns, value [m]. */
static void direction(double *z, const double *axes, const double *value, int m, int which)
{
	unsigned long bits = 2654435761UL*(unsigned long)(which + 1);
	double length = 0.0;
	double e[2*HAWSER_ROM_MAX];

	for (int k = 0; k < m; k++) {
		bits = (bits*6364136223846793005UL + 1442695040888963407UL) & 0xffffffffffffffffUL;
		e[k] = which < 2*m ? (which/2 == k)*(which%2 ? -1.0 : 1.0)
		                   : (double)(bits >> 11)/4503599627370496.0 - 1.0;
		length += e[k]*e[k];
	}
	for (int i = 0; i < m; i++) {
		z[i] = 0.0;
		for (int k = 0; k < m; k++)
			z[i] += axes[i*m + k]*e[k]/sqrt(length*value[k]);
	}
}

/* Whether the form decays everywhere on the ellipsoid of this radius (square root of the form). */
static int decays(struct hawser__orbiter *orbiter, const struct hawser__attractor *attractor, int at,
                  const double *axes, const double *value, double radius)
{
	int m = orbiter->m;
	size_t mm = (size_t)m*(size_t)m;
	const double *from = attractor->state + (size_t)at*(size_t)m, *V = attractor->form + (size_t)at*mm;
	double x[2*HAWSER_ROM_MAX], z[2*HAWSER_ROM_MAX];
	double most = 0.5*(1.0 + attractor->q)*radius*radius;
	int periods = attractor->about.period*attractor->turns;

	for (int d = 0; d < 2*m + FURTHER; d++) {
		direction(z, axes, value, m, d);
		for (int i = 0; i < m; i++)
			x[i] = from[i] + radius*z[i];
		for (int k = 0; k < periods; k++)
			if (hawser__orbiter_map(orbiter, x) != HAWSER__MOVES)
				return 0;
		for (int i = 0; i < m; i++)
			z[i] = x[i] - from[i];
		if (!(form_of(V, z, m) <= most))
			return 0;
	}
	return 1;
}

/* The neighbourhood, the same limit for each state of the response. *found: 0: there is none. */
static enum hawser_status neighbourhood(struct hawser__attractor *attractor, int *found,
                                        struct hawser__orbiter *orbiter, struct hawser_report *report)
{
	int m = orbiter->m;
	size_t mm = (size_t)m*(size_t)m;
	double *axes = malloc((mm + (size_t)m)*sizeof *axes), *value = hawser__behind(axes, mm);
	double size = fmax(hawser__orbiter_size(orbiter, attractor->state), 1e-3*orbiter->size);
	double limit = INFINITY;
	enum hawser_status status = axes ? HAWSER_OK : hawser__no_memory(report, "map");

	*found = 1;
	for (int at = 0; at < attractor->about.period && !status && *found; at++) {
		double radius, least;
		int row = 0;

		memcpy(axes, attractor->form + (size_t)at*mm, mm*sizeof *axes);
		if (LAPACKE_dsyev(LAPACK_ROW_MAJOR, 'V', 'U', m, axes, m, value)) {
			*found = 0;
			break;
		}
		radius = FIRST*size*sqrt(value[m - 1]);
		least = LAST*size*sqrt(value[m - 1]);
		for (; row < IN_A_ROW && radius > least; radius *= 0.5)
			row = decays(orbiter, attractor, at, axes, value, radius) ? row + 1 : 0;
		*found = row == IN_A_ROW;
		/* the last three passed; `radius` is half of the smallest */
		limit = fmin(limit, 64.0*radius*radius);
		attractor->about.radius = sqrt(limit/value[m - 1])/size;
	}
	attractor->limit = limit;
	free(axes);
	return status;
}

/* The forms at all states, each from the derivative that begins there. 1: there is none. */
static int forms(struct hawser__attractor *attractor, struct hawser__orbiter *orbiter)
{
	int m = orbiter->m;
	size_t mm = (size_t)m*(size_t)m;
	double x[2*HAWSER_ROM_MAX];

	attractor->q = 0.0;
	for (int at = 0; at < attractor->about.period; at++) {
		double *state = attractor->state + (size_t)at*(size_t)m;

		memcpy(x, state, (size_t)m*sizeof *x);
		if (derive(orbiter, x, orbiter->matrix, attractor->about.period) ||
		    lyapunov(attractor->form + (size_t)at*mm, orbiter, orbiter->matrix))
			return 1;
		attractor->q = fmax(attractor->q, contraction(orbiter, attractor->form + (size_t)at*mm));
		if (at + 1 < attractor->about.period) {
			memcpy(state + m, state, (size_t)m*sizeof *x);
			if (hawser__orbiter_map(orbiter, state + m) != HAWSER__MOVES)
				return 1;
		}
	}
	if (!(attractor->q < 1.0))
		return 1;
	attractor->turns = (int)fmin(MOST_TURNS, ceil(log(0.5)/log(attractor->about.multiplier)));
	attractor->turns = attractor->turns < 1 ? 1 : attractor->turns;
	attractor->q = pow(attractor->q, attractor->turns);
	return 0;
}

/* Peak and least tension over all periods, from the samples of the flow. */
static enum hawser_status measure(struct hawser__attractor *attractor, struct hawser__orbiter *orbiter,
                                  struct hawser_report *report)
{
	const struct hawser_rom *rom = orbiter->rom;
	int n = rom->n, m = 2*n, period = attractor->about.period, steps = 4*orbiter->steps, count;
	int probes = rom->shapes.points;
	double *samples = malloc(((size_t)(steps*period)*(size_t)n + (size_t)n + 3*(size_t)probes)*
	                         sizeof *samples), *peak, extreme[2] = {NAN, NAN}, x[2*HAWSER_ROM_MAX];
	const struct hawser__stretch stretch = {0.0, 2.0*M_PI/steps, steps, 1, 0.0};
	int failed;

	if (!samples)
		return hawser__no_memory(report, "map");
	peak = samples + (size_t)(steps*period)*(size_t)n;
	memcpy(x, attractor->state, (size_t)m*sizeof *x);
	for (int k = 0; k < period; k++)
		(void)hawser__flow_map(&orbiter->flow, x, samples + (size_t)(k*steps)*(size_t)n, &stretch,
		                       orbiter->omega);
	failed = hawser__amplitude_find(orbiter->amplitude, peak, peak + n, samples, steps*period,
	                                orbiter->omega/period);
	if (!failed)
		failed = hawser__amplitude_tension(orbiter->amplitude, extreme, samples, steps*period,
		                                   orbiter->omega/period) > 0;
	count = probes > 0 ? 3*probes : n;
	attractor->about.amplitude = 0.0;
	for (int i = 0; i < count; i++)
		attractor->about.amplitude = fmax(attractor->about.amplitude, peak[(probes > 0)*n + i]);
	attractor->about.amplitude *= rom->scaled ? rom->length : 1.0;
	attractor->about.tension = extreme[0];
	free(samples);
	return failed ? hawser__no_memory(report, "map") : HAWSER_OK;
}

/* Whether the state returns after fewer periods: a part of `period`. */
static int shorter(struct hawser__orbiter *orbiter, const double *state, int period)
{
	double x[2*HAWSER_ROM_MAX], z[2*HAWSER_ROM_MAX];

	memcpy(x, state, (size_t)orbiter->m*sizeof *x);
	for (int k = 1; k < period; k++) {
		if (hawser__orbiter_map(orbiter, x) != HAWSER__MOVES)
			return 1;
		for (int i = 0; i < orbiter->m; i++)
			z[i] = x[i] - state[i];
		if (period%k == 0 && hawser__orbiter_size(orbiter, z) <=
		                             1e-6*hawser__orbiter_size(orbiter, state))
			return 1;
	}
	return 0;
}

enum hawser_status hawser__attractor_find(struct hawser__attractor *attractor, int *found,
                                          struct hawser__orbiter *orbiter, const double *x, int period,
                                          struct hawser_report *report)
{
	size_t m = (size_t)orbiter->m;
	enum hawser_status status = HAWSER_OK;

	*found = 0;
	*attractor = (struct hawser__attractor){.about = {.period = period}};
	attractor->state = malloc((size_t)period*m*sizeof *attractor->state);
	attractor->form = malloc((size_t)period*m*m*sizeof *attractor->form);
	if (!attractor->state || !attractor->form)
		return hawser__no_memory(report, "map");
	memcpy(attractor->state, x, m*sizeof *x);
	if (newton(orbiter, attractor->state, orbiter->matrix, period))
		return HAWSER_OK;
	attractor->about.multiplier = spectral_radius(orbiter->matrix, orbiter->m);
	if (!(attractor->about.multiplier < 1.0 - NEUTRAL) || shorter(orbiter, attractor->state, period) ||
	    forms(attractor, orbiter))
		return HAWSER_OK;
	status = neighbourhood(attractor, found, orbiter, report);
	return status || !*found ? status : measure(attractor, orbiter, report);
}

void hawser__attractor_clear(struct hawser__attractor *attractor)
{
	free(attractor->state);
	free(attractor->form);
	*attractor = (struct hawser__attractor){.state = NULL};
}

int hawser__attractor_has(const struct hawser__attractor *attractor, const double *x, int m,
                          double *form)
{
	size_t mm = (size_t)m*(size_t)m;
	double z[2*HAWSER_ROM_MAX];

	for (int at = 0; at < attractor->about.period; at++) {
		for (int i = 0; i < m; i++)
			z[i] = x[i] - attractor->state[(size_t)at*(size_t)m + (size_t)i];
		*form = form_of(attractor->form + (size_t)at*mm, z, m)/attractor->limit;
		if (*form <= 1.0)
			return at;
	}
	return -1;
}
