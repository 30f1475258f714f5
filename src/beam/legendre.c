/* beam/legendre.c - Galerkin's method with polynomials whose second derivatives are orthonormal.
 *
 * With z = 2x - 1 and Legendre polynomials P_k: s_k'' = sqrt(2k + 1) P_k(z). Two integrations,
 * with s_k = 0 at both ends, give
 *
 *   s_k' = sqrt(2k + 1)/2 * (P_{k+1} - P_{k-1})/(2k + 1)          (without P_0)
 *   s_k  = sqrt(2k + 1)/4 * [(P_{k+2} - P_k)/(2k + 3) - (P_k - P_{k-2})/(2k - 1)]/(2k + 1)
 *
 * with P_i = 0 for i < 0. For k < 2 the second quotient is left out. For k >= 2 the slope s_k'
 * also vanishes at both ends; the functions of a clamped beam are those with k >= 2.
 *
 * Every function is a sum of at most three Legendre terms, so each integral is a short exact sum.
 * The matrices are banded, s_j'' s_k'' is the identity, and no digits are lost. The error falls
 * faster than any power of 1/n. Boundary layers of width of order 1/n^2 are resolved, because the
 * zeros of the polynomials lie that close together near the ends. Reference for such bases: Shen,
 * SIAM J. Sci. Comput. 15 (1994) 1489.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stddef.h>

#include "beam/sample.h"
#include "core/report.h"

/* A sum of at most three Legendre terms, of degrees first, first + 2 and first + 4. */
struct series {
	int first, terms;
	double value[3];
};

static struct series second(int k)
{
	return (struct series){k, 1, {sqrt(2.0*k + 1.0), 0.0, 0.0}};
}

static struct series slope(int k)
{
	double scale = 0.5/sqrt(2.0*k + 1.0);

	if (k < 2)
		return (struct series){k + 1, 1, {scale, 0.0, 0.0}};
	return (struct series){k - 1, 2, {-scale, scale, 0.0}};
}

static struct series value(int k)
{
	double scale = 0.25/sqrt(2.0*k + 1.0), up = scale/(2.0*k + 3.0), down = scale/(2.0*k - 1.0);

	if (k < 2)
		return (struct series){k, 2, {-up, up, 0.0}};
	return (struct series){k - 2, 3, {down, -up - down, up}};
}

/* Integral over [0, 1] of the product of two series. The integral of P_i^2 is 1/(2i + 1). */
static double product(struct series a, struct series b)
{
	double sum = 0.0;

	for (int i = 0; i < a.terms; i++)
		for (int j = 0; j < b.terms; j++)
			if (a.first + 2*i == b.first + 2*j)
				sum += a.value[i]*b.value[j]/(2.0*(a.first + 2*i) + 1.0);
	return sum;
}

/* The same with the weight z = 2x - 1: z P_j = [(j + 1) P_{j+1} + j P_{j-1}]/(2j + 1). */
static double weighted(struct series a, struct series b)
{
	double sum = 0.0;

	for (int i = 0; i < a.terms; i++)
		for (int j = 0; j < b.terms; j++) {
			int p = a.first + 2*i, q = b.first + 2*j, top = p > q ? p : q;

			if (p - q == 1 || q - p == 1)
				sum += a.value[i]*b.value[j]*top/((2.0*p + 1.0)*(2.0*q + 1.0));
		}
	return sum;
}

static int first_of(enum hawser_beam_ends ends)
{
	return ends == HAWSER_ENDS_CLAMPED ? 2 : 0;
}

static enum hawser_status fill(struct hawser_beam_integrals *is, enum hawser_beam_ends ends, int n,
                               struct hawser_report *report)
{
	enum { BAND = 4 };
	int first = first_of(ends);
	enum hawser_status status;

	if (n < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "beam",
		                    "%d functions: give at least 1", n);
	status = hawser__beam_integrals_init(is, n, BAND, report);
	for (int j = 0; !status && j < n; j++)
		for (int k = j > BAND ? j - BAND : 0; k < n && k <= j + BAND; k++) {
			size_t x = (size_t)j*(size_t)n + (size_t)k;
			struct series slope_j = slope(first + j), slope_k = slope(first + k);

			is->ss[x] = product(value(first + j), value(first + k));
			is->s1s1[x] = product(slope_j, slope_k);
			is->s2s2[x] = j == k ? 1.0 : 0.0;
			is->xs1s1[x] = 0.5*(is->s1s1[x] + weighted(slope_j, slope_k));
			is->ss1[x] = product(value(first + j), slope_k);
			is->s1s2[x] = product(slope_j, second(first + k));
		}
	return status;
}

static double legendre(int i, double z)
{
	double before = 0.0, p = 1.0, next;

	if (i < 0)
		return 0.0;
	for (int k = 0; k < i; k++) {
		next = ((2.0*k + 1.0)*z*p - k*before)/(k + 1.0);
		before = p;
		p = next;
	}
	return p;
}

/* dP_i/dz = (2i - 1) P_{i-1} + (2i - 5) P_{i-3} + ... */
static double legendre_slope(int i, double z)
{
	double sum = 0.0;

	for (int k = i - 1; k >= 0; k -= 2)
		sum += (2.0*k + 1.0)*legendre(k, z);
	return sum;
}

static void at(double *s, enum hawser_beam_ends ends, int n, int derivative, double x)
{
	int first = first_of(ends);

	for (int k = 0; k < n && derivative == 3; k++)
		s[k] = 2.0*sqrt(2.0*(first + k) + 1.0)*legendre_slope(first + k, 2.0*x - 1.0);
	if (derivative == 3)
		return;
	for (int k = 0; k < n; k++) {
		struct series it = derivative == 0 ? value(first + k)
		                   : derivative == 1 ? slope(first + k) : second(first + k);

		s[k] = 0.0;
		for (int i = 0; i < it.terms; i++)
			s[k] += it.value[i]*legendre(it.first + 2*i, 2.0*x - 1.0);
	}
}

const struct hawser_beam_method hawser__beam_legendre = {
	"legendre", "Galerkin's method with polynomials of orthonormal curvature", "Shen 1994", fill, at,
};
