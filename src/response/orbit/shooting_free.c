/* response/orbit/shooting_free.c - the multipliers of a cycle without the one that is 1.
 *
 *    A_i     transition matrix of a segment; of equations of first order, on their own manifold: u'
 *            = g(u) is kept by the relaxation, so that du alone, with du' = g' du, is a state
 *    f_i     change of node i along the motion: A_i f_i = f_{i+1}
 *    H_i     reflection that turns f_i into a multiple of the first unit vector
 *
 * H_{i+1} A_i H_i has a first column that is a multiple of that vector. Their product has the
 * multiplier of f in the first place, and the product of what is left without first rows and
 * columns has the others: none is chosen by its value, which near folds is not far from another's.
 * What the first columns have elsewhere, and the product of their heads, tell how far the first
 * multiplier is from 1.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

#include "response/orbit/shooting.h"

/* w [m]: H = 1 - w w' turns f into a multiple of the first unit vector. */
static void reflection(double *w, const double *f, int m)
{
	double length = cblas_dnrm2(m, f, 1), scale;

	memcpy(w, f, (size_t)m*sizeof *w);
	w[0] += f[0] < 0.0 ? -length : length;
	scale = sqrt(length*(length + fabs(f[0])));
	cblas_dscal(m, scale > 0.0 ? 1.0/scale : 0.0, w, 1);
}

/* a [n][n]: the part of A [2n][2n] for u alone, at a node with g' = slope [n][n]. */
static void restrict_to_first(double *a, const double *A, const double *slope, int n)
{
	int m = 2*n;

	for (int j = 0; j < n; j++)
		memcpy(a + (size_t)j*n, A + (size_t)j*m, (size_t)n*sizeof *a);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, n, n, n, 1.0, A + n, m, slope, n, 1.0, a, n);
}

/* a [m][m] becomes H' a H, with the reflections by `to` and `from`. */
static void reflect(double *a, double *work, const double *to, const double *from, int m)
{
	cblas_dgemv(CblasRowMajor, CblasNoTrans, m, m, 1.0, a, m, from, 1, 0.0, work, 1);
	cblas_dger(CblasRowMajor, m, m, -1.0, work, 1, from, 1, a, m);
	cblas_dgemv(CblasRowMajor, CblasTrans, m, m, 1.0, a, m, to, 1, 0.0, work, 1);
	cblas_dger(CblasRowMajor, m, m, -1.0, to, 1, work, 1, a, m);
}

int hawser__shooting_reduce(struct hawser__shooting *shooting)
{
	struct hawser__orbit *orbit = &shooting->base;
	const struct hawser_rom *first = orbit->rom->first;
	int n = orbit->n, m = orbit->m, order = first ? n : m, S = shooting->segments;
	double *work = shooting->reduced, *from = work + m, *to = from + m, *slope = to + m;
	double *a = slope + m*m, *by_v = a + m*m;
	double head = 1.0, leak = 0.0, *out = shooting->schur;

	for (int i = 0; i < S; i++, out += (order - 1)*(order - 1)) {
		const double *A = shooting->A + (size_t)i*m*m, *next = shooting->rates + ((i + 1)%S)*m;

		if (first) {
			const double *u = shooting->node + i*m;

			hawser_rom_acceleration_jacobian(first, work, slope, by_v, from, u, u + n, 0.0, 1.0);
			restrict_to_first(a, A, slope, n);
		} else {
			memcpy(a, A, (size_t)m*m*sizeof *a);
		}
		reflection(from, shooting->rates + i*m, order);
		reflection(to, next, order);
		reflect(a, work, to, from, order);
		head *= fabs(a[0]);
		for (int j = 1; j < order; j++) {
			leak = fmax(leak, fabs(a[j*order]/a[0]));
			memcpy(out + (j - 1)*(order - 1), a + j*order + 1, (size_t)(order - 1)*sizeof *out);
		}
	}
	orbit->trivial = fmax(fabs(head - 1.0), leak);
	return order - 1;
}
