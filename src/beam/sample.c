/* beam/sample.c - the eigenvalues of a beam at one speed, sorted into pairs.
 *
 * Real eigenvalues are paired by size: the smallest with the largest, the second smallest with the
 * second largest, and so on, because the sum of a pair changes little when the pair leaves the
 * real axis. Pairs are sorted by the square root of the product of their two eigenvalues. For a
 * conjugate pair that is the modulus.
 *
 * A pair is growing if its real part exceeds a round-off threshold. For a gyroscopic system the
 * solver returns a real part of exactly 0 on the imaginary axis (modes/complex/quadratic.h). For a
 * reversible system (invariant under x -> 1 - x, t -> -t) the threshold is of the order of the
 * square root of the round-off, which is the error of two eigenvalues that nearly coincide.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "beam/sample.h"
#include "core/report.h"
#include "modes/complex/quadratic.h"

static double modulus(const struct hawser__beam_pair *pair)
{
	return pair->im > 0.0 ? hypot(pair->re[0], pair->im) : sqrt(fabs(pair->re[0]*pair->re[1]));
}

static int by_modulus(const void *left, const void *right)
{
	double d = modulus(left) - modulus(right);

	return (d > 0.0) - (d < 0.0);
}

static int by_real(const void *left, const void *right)
{
	const struct hawser__beam_pair *a = left, *b = right;

	return (a->re[0] > b->re[0]) - (a->re[0] < b->re[0]);
}

/* Largest real part that is round-off. The spectrum of a reversible beam is symmetric about the
 * imaginary axis. */
static double threshold(const struct hawser_beam *beam, const struct hawser_beam_eigenvalue *value)
{
	int reversible = beam->drag == 0.0 && (!hawser__beam_flux(beam) || beam->weight == 0.0);
	double size = hypot(value->re, value->im);

	if (reversible)
		return 1e-7*size;
	return fmin(4.0*DBL_EPSILON*value->condition, 1e-7)*size;
}

static struct hawser__beam_pair single(const struct hawser__beam_sample *sample, int i,
                                       const struct hawser_beam *beam)
{
	const struct hawser_beam_eigenvalue *value = &sample->value[i];
	double growth = value->re - threshold(beam, value);

	return (struct hawser__beam_pair){.re = {value->re, value->re}, .im = value->im, .first = i,
	                                  .second = i, .residual = value->residual,
	                                  .condition = value->condition,
	                                  .growth = growth, .growing = growth > 0.0};
}

static void join(struct hawser__beam_pair *high, const struct hawser__beam_pair *low)
{
	high->re[1] = low->re[0];
	high->second = low->first;
	high->residual = fmax(high->residual, low->residual);
	high->condition = fmax(high->condition, low->condition);
}

static void pair_up(struct hawser__beam_sample *sample, const struct hawser_beam *beam)
{
	struct hawser__beam_pair *pair = sample->pair;
	int reals = 0, all = 0;

	for (int i = 0; i < sample->found; i++)
		if (sample->value[i].im == 0.0)
			pair[reals++] = single(sample, i, beam);
	qsort(pair, (size_t)reals, sizeof *pair, by_real);
	for (int low = 0, high = reals - 1; low <= high; low++, high--) {
		struct hawser__beam_pair outer = pair[low];

		if (low == high)
			continue;
		join(&pair[high], &outer);
	}
	for (int i = reals/2; i < reals; i++)
		pair[all++] = pair[i];
	for (int i = 0; i < sample->found; i++)
		if (sample->value[i].im > 0.0)
			pair[all++] = single(sample, i, beam);
	qsort(pair, (size_t)all, sizeof *pair, by_modulus);
	sample->pairs = all;
}

static void load(double complex *q, const double *from, int n)
{
	for (int i = 0; i < n; i++)
		q[i] = from[i] + I*from[n + i];
}

/* y* A x, with A x in `room` [n]. */
static double complex product(const double complex *y, const double *A, const double complex *x, int n,
                              double complex *room)
{
	hawser__quadratic_apply(room, A, x, n);
	return hawser__quadratic_dot(y, room, n);
}

static double complex eigenvalue(const struct hawser__beam_sample *sample, int i)
{
	return sample->value[i].re + I*sample->value[i].im;
}

/* dl/dv = -y* (l dC/dv + dK/dv) x/(y* (2 l M + C) x). C is affine in v and K is quadratic, so
 * central differences are exact except for round-off. `room` is [5][n][n], x is [3][n]. */
static void slopes(struct hawser__beam_sample *sample, const struct hawser_beam_integrals *is,
                   const struct hawser_beam *beam, double *room, double complex *x)
{
	size_t n = (size_t)is->n, square = n*n;
	double *M = room, *C = M + square, *K = C + square, *dC = K + square, *dK = dC + square;
	double h = 0.25*(1.0 + fabs(sample->speed));
	double complex *y = x + n, *Ax = y + n;
	struct hawser_beam at = *beam;
	int gyroscopic;

	at.speed = sample->speed + h;
	hawser_beam_matrices(M, dC, dK, is, &at);
	at.speed = sample->speed - h;
	hawser_beam_matrices(M, C, K, is, &at);
	for (size_t i = 0; i < square; i++) {
		dC[i] = (dC[i] - C[i])/(2.0*h);
		dK[i] = (dK[i] - K[i])/(2.0*h);
	}
	at.speed = sample->speed;
	gyroscopic = hawser__beam_gyroscopic(&at);
	hawser_beam_matrices(M, C, K, is, &at);
	for (int p = 0; p < sample->pairs; p++) {
		struct hawser__beam_pair *pair = &sample->pair[p];
		double complex l = eigenvalue(sample, pair->first), slope, metric;

		load(x, sample->right + (size_t)pair->first*2*n, is->n);
		load(y, sample->left + (size_t)pair->first*2*n, is->n);
		metric = 2.0*l*product(y, M, x, is->n, Ax) + product(y, C, x, is->n, Ax);
		slope = -(l*product(y, dC, x, is->n, Ax) + product(y, dK, x, is->n, Ax))/metric;
		pair->slope_re = creal(slope);
		pair->slope_im = cimag(slope);
		if (gyroscopic && creal(l) == 0.0 && cimag(l) > 0.0) {
			metric = 2.0*l*product(x, M, x, is->n, Ax) + product(x, C, x, is->n, Ax);
			pair->energy = cimag(metric) > 0.0 ? 1 : -1;
		}
	}
}

/* Number of eigenvalues to compute. One eigenvalue of an overdamped pair may have a large modulus,
 * so a strongly damped beam needs all of them. */
static int eigenvalues_needed(const struct hawser_beam_integrals *is,
                              const struct hawser_beam *beam, int watched)
{
	double first = 9.8696*sqrt((beam->theta + 0.1*beam->tension)/(1.0 + 9.87*beam->rotary));
	int all = 2*is->n, some = 2*watched + 4;

	return beam->drag > first || some > all ? all : some;
}

static enum hawser_status allocate(struct hawser__beam_sample *sample, int ask,
                                   struct hawser_report *report)
{
	size_t many = (size_t)ask, vector = 2*(size_t)sample->n;

	sample->value = malloc(many*sizeof *sample->value);
	sample->right = malloc(many*vector*sizeof *sample->right);
	sample->left = malloc(many*vector*sizeof *sample->left);
	sample->pair = malloc(many*sizeof *sample->pair);
	return sample->value && sample->right && sample->left && sample->pair ? HAWSER_OK
	                                                             : hawser__no_memory(report, "beam");
}

enum hawser_status hawser__beam_sample(struct hawser__beam_sample *sample,
                                       const struct hawser_beam_integrals *is,
                                       const struct hawser_beam *beam, double speed, int watched,
                                       struct hawser_report *report)
{
	size_t n = (size_t)is->n;
	double *room = malloc(5*n*n*sizeof *room);
	double complex *x = malloc(3*n*sizeof *x);
	struct hawser_beam at = *beam;
	int ask = eigenvalues_needed(is, beam, watched);
	enum hawser_status status;

	*sample = (struct hawser__beam_sample){.speed = speed, .n = is->n};
	at.speed = speed;
	status = room && x ? allocate(sample, ask, report) : hawser__no_memory(report, "beam");
	if (!status)
		status = hawser__beam_eigen(sample->value, sample->right, sample->left, &sample->found, is,
		                            &at, ask, report);
	if (status) {
		hawser__beam_sample_clear(sample);
		goto done;
	}
	pair_up(sample, &at);
	slopes(sample, is, beam, room, x);
	for (int p = 0; p < sample->pairs && p < watched; p++) {
		sample->growing += sample->pair[p].growing;
		sample->real += sample->pair[p].im == 0.0;
	}
done:
	free(room);
	free(x);
	return status;
}

void hawser__beam_sample_clear(struct hawser__beam_sample *sample)
{
	free(sample->value);
	free(sample->right);
	free(sample->left);
	free(sample->pair);
	memset(sample, 0, sizeof *sample);
}

/* M x and C x of all right vectors of a sample, [found][2][n]. `room` is [3][n][n], x is [n]. */
static void apply(double complex *applied, const struct hawser__beam_sample *sample,
                  const struct hawser_beam_integrals *is, const struct hawser_beam *beam, double *room,
                  double complex *x)
{
	size_t n = (size_t)sample->n, square = n*n;

	hawser_beam_matrices(room, room + square, room + 2*square, is, beam);
	for (int i = 0; i < sample->found; i++) {
		load(x, sample->right + (size_t)i*2*n, sample->n);
		for (size_t which = 0; which < 2; which++)
			hawser__quadratic_apply(applied + (2*(size_t)i + which)*n, room + which*square, x,
			                        sample->n);
	}
}

/* Squared modulus of the largest product between an eigenvalue of pa and an eigenvalue of pb. */
static double pair_product(const struct hawser__beam_sample *a, const struct hawser__beam_pair *pa,
                           const struct hawser__beam_sample *b, const struct hawser__beam_pair *pb,
                           const double complex *applied, double complex *y)
{
	size_t n = (size_t)a->n;
	double most = 0.0;

	for (int i = 0; i < 1 + (pa->second != pa->first); i++) {
		int from = i ? pa->second : pa->first;

		load(y, a->left + (size_t)from*2*n, a->n);
		for (int k = 0; k < 1 + (pb->second != pb->first); k++) {
			int to = k ? pb->second : pb->first;
			const double complex *Mx = applied + (size_t)to*2*n, *Cx = Mx + n;
			double complex sum = eigenvalue(a, from) + eigenvalue(b, to);

			most = fmax(most, cabs(sum*hawser__quadratic_dot(y, Mx, a->n)
			                       + hawser__quadratic_dot(y, Cx, a->n)));
		}
	}
	return most*most;
}

enum hawser_status hawser__beam_correlate(double *share, const struct hawser__beam_sample *a,
                                          const struct hawser__beam_sample *b,
                                          const struct hawser_beam_integrals *is,
                                          const struct hawser_beam *beam,
                                          struct hawser_report *report)
{
	size_t n = (size_t)is->n;
	double *room = malloc(3*n*n*sizeof *room);
	double complex *applied = malloc((2*(size_t)b->found + 1)*n*sizeof *applied);
	struct hawser_beam middle = *beam;
	enum hawser_status status = room && applied ? HAWSER_OK : hawser__no_memory(report, "beam");
	double complex *x;

	if (status)
		goto done;
	x = applied + 2*(size_t)b->found*n;
	middle.speed = 0.5*(a->speed + b->speed);
	apply(applied, b, is, &middle, room, x);
	for (int i = 0; i < a->pairs; i++) {
		double *row = share + (size_t)i*(size_t)b->pairs, sum = 0.0;

		for (int k = 0; k < b->pairs; k++) {
			row[k] = pair_product(a, &a->pair[i], b, &b->pair[k], applied, x);
			sum += row[k];
		}
		for (int k = 0; k < b->pairs; k++)
			row[k] = sum > 0.0 ? row[k]/sum : 0.0;
	}
done:
	free(room);
	free(applied);
	return status;
}
