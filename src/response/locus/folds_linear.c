/* response/locus/folds_linear.c - whether a response is nearly linear, so that no lower load has a
 * fold.
 *
 *   l_k   logarithms of the moduli of the multipliers of an orbit, in falling order
 *   L_k   those of the linear model, 2 pi Re(lambda_k)/Omega, in falling order
 *   x     state of an orbit at the start of a period, X that of the linear response there
 *
 * At a fold some l_k is 0. A response is called nearly linear if at every point |l_k - L_k| <= |L_k|/2,
 * so that each multiplier has moved at most half of the way to 1, and if |x - X| is at most half of the
 * largest |X|. At small loads both differences are proportional to the load or to its square, so they
 * are smaller at lower loads. The first condition alone would also hold at large loads, where the
 * resonance has been bent out of the range.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define lapack_complex_double double complex
#define lapack_complex_float float complex
#include <lapacke.h>

#include "core/report.h"
#include "response/locus/folds_search.h"

#define MARGIN 0.1 /* margin of the window on either side of the range, relative; chosen */
#define NEAR 0.3   /* relative distance of a natural frequency from the range within which the
                    * window includes it; chosen */
#define NEARLY_LINEAR 0.5 /* largest change of the logarithms of the multipliers, relative to their
                           * distance from 0 (the unit circle); see above */
#define FASTEST 30.0 /* |L_k| above this: a multiplier below 1e-13 is round-off */

static int falling(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x < y) - (x > y);
}

/* The window about the range: a margin on both sides. The resonance of a natural frequency near the
 * range may bend into the range; the window then extends to a margin beyond that frequency. */
static void set_window(struct hawser__fold_search *search, const double *natural, int count)
{
	double lo = fmin(search->options->from, search->options->to);
	double hi = fmax(search->options->from, search->options->to), below = lo, above = hi;

	for (int k = 0; k < count; k++) {
		if (natural[k] < lo && natural[k] > lo*(1.0 - NEAR) && (below == lo || natural[k] > below))
			below = natural[k];
		if (natural[k] > hi && natural[k] < hi*(1.0 + NEAR) && (above == hi || natural[k] < above))
			above = natural[k];
	}
	search->window[0] = below*(1.0 - MARGIN);
	search->window[1] = above*(1.0 + MARGIN);
}

enum hawser_status hawser__fold_decay(struct hawser__fold_search *search)
{
	const struct hawser_rom *rom = search->rom;
	int n = rom->n, m = 2*n;
	double *A = calloc((size_t)m*(size_t)m, sizeof *A), *imaginary = malloc((size_t)m*sizeof *A);
	enum hawser_status status = HAWSER_OK;
	lapack_int info;

	search->decay = malloc(2*(size_t)m*sizeof *search->decay);
	if (!A || !imaginary || !search->decay) {
		status = hawser__no_memory(search->report, "folds");
		goto done;
	}
	for (int j = 0; j < n; j++) {
		A[(size_t)j*(size_t)m + (size_t)(n + j)] = 1.0;
		for (int k = 0; k < n; k++) {
			A[(size_t)(n + j)*(size_t)m + (size_t)k] = -rom->K[j*n + k];
			A[(size_t)(n + j)*(size_t)m + (size_t)(n + k)] = -rom->D[j*n + k];
		}
	}
	info = LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', m, A, m, search->decay, imaginary, NULL, m,
	                     NULL, m);
	if (hawser__lapack_starved(info))
		status = hawser__no_memory(search->report, "folds");
	for (int k = 0; info && k < m; k++)
		search->decay[k] = 0.0; /* then no response counts as nearly linear, and all loads are
		                         * searched */
	set_window(search, imaginary, info ? 0 : m);
	qsort(search->decay, (size_t)m, sizeof(double), falling);
done:
	free(A);
	free(imaginary);
	return status;
}

/* Whether the multipliers at every point of the response are near those of the linear model. */
static int near_multipliers(const struct hawser__fold_search *search, const struct hawser_frf *frf)
{
	int m = 2*frf->n;
	double *l = search->decay + m;

	for (int p = 0; p < frf->points; p++) {
		double period = 2.0*M_PI/frf->point[p].omega;

		for (int k = 0; k < m; k++)
			l[k] = frf->multiplier[2*((size_t)p*(size_t)m + (size_t)k)];
		qsort(l, (size_t)m, sizeof *l, falling);
		for (int k = 0; k < m; k++) {
			double L = search->decay[k]*period;

			if (fabs(L) <= FASTEST && !(fabs(l[k] - L) <= NEARLY_LINEAR*fabs(L)))
				return 0;
		}
	}
	return 1;
}

/* X [2n] += the linear response to a harmonic; A [n][n] and U [n] are workspace. Returns 1 if the
 * response is infinite. */
static int add_linear(double *X, const struct hawser_rom *rom, const struct hawser_harmonic *harmonic,
                      double omega, double complex *A, double complex *U, lapack_int *pivot)
{
	double w = harmonic->k*omega;
	int n = rom->n;

	for (int j = 0; j < n; j++) {
		U[j] = harmonic->f[j]*pow(omega, harmonic->omega_power)*
		       (harmonic->phase == HAWSER_COS ? 1.0 : -I);
		for (int k = 0; k < n; k++)
			A[k*n + j] = rom->K[j*n + k] - (j == k ? w*w : 0.0) + I*w*rom->D[j*n + k];
	}
	if (LAPACKE_zgesv(LAPACK_COL_MAJOR, n, 1, A, n, pivot, U, n))
		return 1;
	for (int j = 0; j < n; j++) {
		X[j] += creal(U[j]);
		X[n + j] -= w*cimag(U[j]);
	}
	return 0;
}

/* Whether the states are near those of the linear response. */
static int near_states(const struct hawser_rom *rom, const struct hawser_frf *frf)
{
	size_t n = (size_t)rom->n, m = 2*n;
	double complex *A = malloc(n*(n + 1)*sizeof *A);
	lapack_int *pivot = malloc(n*sizeof *pivot);
	double *X = malloc(m*sizeof *X), gap = 0.0, largest = 0.0;
	int failed = !A || !pivot || !X;

	for (int p = 0; !failed && p < frf->points; p++) {
		const double *x = frf->state + (size_t)p*m;
		double apart = 0.0, size = 0.0;

		memset(X, 0, m*sizeof *X);
		for (int h = 0; !failed && h < rom->harmonics; h++)
			if (rom->harmonic[h].f)
				failed = add_linear(X, rom, &rom->harmonic[h], frf->point[p].omega, A, A + n*n,
				                    pivot);
		for (size_t i = 0; i < m; i++) {
			apart += (x[i] - X[i])*(x[i] - X[i]);
			size += X[i]*X[i];
		}
		gap = fmax(gap, sqrt(apart));
		largest = fmax(largest, sqrt(size));
	}
	free(A);
	free(pivot);
	free(X);
	return !failed && gap <= NEARLY_LINEAR*largest;
}

int hawser__fold_linear(const struct hawser__fold_search *search, const struct hawser__load *load,
                        const struct hawser_frf *frf)
{
	return frf->end == HAWSER_END_RANGE && near_multipliers(search, frf) &&
	       near_states(&load->rom, frf);
}
