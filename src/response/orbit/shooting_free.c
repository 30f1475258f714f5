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
 * multiplier is from 1. A model that may be rotated (cycle/turn.c) has a second one, of the vectors
 * g_i = (G u_i, G u_i'), which is removed in the same way. It would leave the bordered matrix singular,
 * to which the product g g' is added, relative to the length of g: then a correction has no part along
 * g.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <string.h>

#include "response/orbit/shooting.h"

#define INDEPENDENT 0.01 /* least part of g that is no motion along the orbit, relative; chosen */
#define TURNED 1e-6      /* square of the size of g, relative to the orbit, below which it is none;
                          * chosen */

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

/* The factors [S][order][order] in `schur` become those without the vectors f [S] of nodes, `stride`
 * apart; the vectors g [S][order] too. */
static void take_out(struct hawser__shooting *shooting, const double *f, int stride, double *g,
                     int order)
{
	struct hawser__orbit *orbit = &shooting->base;
	int S = shooting->segments, m = orbit->m, less = order - 1;
	double *work = shooting->reduced, *from = work + m, *to = from + m, *a = to + m;
	double head = 1.0, leak = 0.0, *out = shooting->schur;

	for (int i = 0; i < S; i++, out += less*less) {
		memcpy(a, shooting->schur + (size_t)i*order*order, (size_t)order*order*sizeof *a);
		reflection(from, f + i*stride, order);
		reflection(to, f + ((i + 1)%S)*stride, order);
		reflect(a, work, to, from, order);
		head *= fabs(a[0]);
		for (int j = 1; j < order; j++) {
			leak = fmax(leak, fabs(a[j*order]/a[0]));
			memcpy(out + (j - 1)*less, a + j*order + 1, (size_t)less*sizeof *out);
		}
		if (g) {
			cblas_daxpy(order, -cblas_ddot(order, from, 1, g + i*order, 1), from, 1, g + i*order, 1);
			memmove(g + i*less, g + i*order + 1, (size_t)less*sizeof *g);
		}
	}
	orbit->trivial = fmax(orbit->trivial, fmax(fabs(head - 1.0), leak));
}

/* g [S][order]: change of the nodes [S][m] by the rotation of the model. */
static void turn_nodes(double *g, const struct hawser__shooting *shooting, const double *node,
                       int order)
{
	const struct hawser__orbit *orbit = &shooting->base;
	int n = orbit->n, S = shooting->segments;

	for (int i = 0; i < S; i++)
		for (int part = 0; part < order/n; part++)
			cblas_dgemv(CblasRowMajor, CblasNoTrans, n, n, 1.0, orbit->turn, n,
			            node + i*orbit->m + part*n, 1, 0.0, g + i*order + part*n, 1);
}

/* g [S][m]: the rotation of the anchor, scaled and without its part along the motion, which the phase
 * holds. Returns the square of its length; 0: the rotation is the motion itself. */
static double free_turn(double *g, const struct hawser__shooting *shooting)
{
	const struct hawser__orbit *orbit = &shooting->base;
	int m = orbit->m, size = shooting->segments*m;
	double along = 0.0, motion = 0.0, whole = 0.0, square = 0.0;

	turn_nodes(g, shooting, orbit->anchor, m);
	for (int i = 0; i < size; i++) {
		double rate = shooting->rates[i]/shooting->scale[i%m];

		g[i] /= shooting->scale[i%m];
		whole += g[i]*g[i];
		along += g[i]*rate;
		motion += rate*rate;
	}
	for (int i = 0; i < size; i++) {
		g[i] -= along/motion*shooting->rates[i]/shooting->scale[i%m];
		square += g[i]*g[i];
	}
	return square > fmax(TURNED*size, INDEPENDENT*INDEPENDENT*whole) ? square : 0.0;
}

void hawser__shooting_border(struct hawser__shooting *shooting)
{
	int m = shooting->base.m, all = shooting->segments*m, size = shooting->base.size;
	double *g = shooting->finer, square = shooting->base.turn ? free_turn(g, shooting) : 0.0;

	for (int k = 0; square > 0.0 && k < all; k++)
		for (int i = 0; i < all; i++)
			shooting->matrix[(size_t)k*size + i] += g[(i + m)%all]*g[k]/square;
}

void hawser__shooting_hold(const struct hawser__shooting *shooting, double *dy)
{
	const struct hawser__orbit *orbit = &shooting->base;
	int m = orbit->m, all = shooting->segments*m;
	double *g = shooting->finer, turned = 0.0;
	double square = orbit->turn && orbit->held ? free_turn(g, shooting) : 0.0;

	for (int i = 0; square > 0.0 && i < all; i++)
		turned += g[i]*(shooting->node[i] - orbit->anchor[i])/shooting->scale[i%m];
	for (int i = 0; square > 0.0 && i < all; i++)
		dy[i] -= turned*g[(i + m)%all]/square;
}

int hawser__shooting_reduce(struct hawser__shooting *shooting)
{
	struct hawser__orbit *orbit = &shooting->base;
	const struct hawser_rom *first = orbit->rom->first;
	int n = orbit->n, m = orbit->m, order = first ? n : m, S = shooting->segments;
	double *work = shooting->reduced, *unused = work + m, *slope = unused + m, *by_v = slope + n*n;
	double *g = orbit->turn ? shooting->finer : NULL, whole = 0.0;

	orbit->trivial = 0.0;
	for (int i = 0; i < S; i++) {
		const double *A = shooting->A + (size_t)i*m*m, *u = shooting->node + i*m;
		double *a = shooting->schur + (size_t)i*order*order;

		if (first) {
			hawser_rom_acceleration_jacobian(first, work, slope, by_v, unused, u, u + n, 0.0, 1.0);
			restrict_to_first(a, A, slope, n);
		} else {
			memcpy(a, A, (size_t)m*m*sizeof *a);
		}
	}
	if (g) {
		turn_nodes(g, shooting, shooting->node, order);
		whole = cblas_dnrm2(S*order, g, 1);
	}
	take_out(shooting, shooting->rates, m, g, order);
	order--;
	/* not that of a rotation which is the motion itself */
	if (!g || cblas_dnrm2(S*order, g, 1) <= INDEPENDENT*whole)
		return order;
	take_out(shooting, g, order, NULL, order);
	return order - 1;
}
