/* modes/grid.c - the composite Gauss-Legendre grid of struct hawser_grid.
 *
 *   x_i, w_i   Gauss nodes and weights on [-1, 1]
 *   l_k        Lagrange polynomial of node k: l_k(x_i) = 1 where i = k
 *   I_ik       integral of l_k from -1 to x_i: the running integral of what is known at the nodes
 *
 * I is computed from the Legendre expansion of l_k, which is integrated term by term. It is as
 * accurate as the nodes; differences of Lagrange polynomials would not be.
 * Barycentric weights of Gauss nodes: J.-P. Berrut, L. N. Trefethen, SIAM Rev. 46 (2004) 501.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/order.h"
#include "core/report.h"
#include "modes/grid.h"

/* P_n and P_n' at x, |x| < 1. */
static double legendre(double *derivative, int n, double x)
{
	double below = 1.0, value = x;

	for (int j = 2; j <= n; j++) {
		double next = ((2*j - 1)*x*value - (j - 1)*below)/j;

		below = value;
		value = next;
	}
	*derivative = n*(below - x*value)/((1.0 - x)*(1.0 + x));
	return value;
}

/* Newton's method from the asymptotic nodes. One half is mirrored so that the rule is exactly
 * symmetric. */
static void gauss(double *node, double *weight, int n)
{
	for (int i = 0; i < (n + 1)/2; i++) {
		double x = cos(M_PI*(i + 0.75)/(n + 0.5)), slope = 1.0;

		if (2*i + 1 == n)
			x = 0.0;
		for (int k = 0; k < 8; k++) {
			double step = legendre(&slope, n, x)/slope;

			x -= step;
			if (fabs(step) < 1e-15)
				break;
		}
		legendre(&slope, n, x);
		node[n - 1 - i] = x;
		node[i] = -x;
		weight[i] = weight[n - 1 - i] = 2.0/((1.0 - x)*(1.0 + x)*slope*slope);
	}
}

void hawser__grid_clear(struct hawser_grid *grid)
{
	free(grid->edge);
	free(grid->s);
	free(grid->weight);
	free(grid->node);
	free(grid->bary);
	*grid = (struct hawser_grid){0};
}

enum hawser_status hawser__grid_init(struct hawser_grid *grid, int elements, int order,
                                     const double *edge, const double *length,
                                     struct hawser_report *report)
{
	size_t points = (size_t)elements*(size_t)order;
	double *weight = malloc((size_t)order*sizeof *weight);

	*grid = (struct hawser_grid){.elements = elements, .order = order, .points = (int)points};
	grid->edge = malloc(((size_t)elements + 1)*sizeof *grid->edge);
	grid->s = malloc(points*sizeof *grid->s);
	grid->weight = malloc(points*sizeof *grid->weight);
	grid->node = malloc((size_t)order*sizeof *grid->node);
	grid->bary = malloc((size_t)order*sizeof *grid->bary);
	if (!weight || !grid->edge || !grid->s || !grid->weight || !grid->node || !grid->bary) {
		free(weight);
		hawser__grid_clear(grid);
		return hawser__no_memory(report, "modes");
	}
	gauss(grid->node, weight, order);
	for (int i = 0; i < order; i++) {
		/* NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign): gauss() filled it */
		double x = grid->node[i];

		grid->bary[i] = (i%2 ? -1.0 : 1.0)*sqrt((1.0 - x)*(1.0 + x)*weight[i]);
	}
	for (int e = 0; e <= elements; e++)
		grid->edge[e] = edge[e];
	for (int e = 0; e < elements; e++) {
		double half = 0.5*(length ? length[e] : edge[e + 1] - edge[e]);

		for (int i = 0; i < order; i++) {
			grid->s[e*order + i] = edge[e] + half*(1.0 + grid->node[i]);
			grid->weight[e*order + i] = half*weight[i];
		}
	}
	free(weight);
	return HAWSER_OK;
}

void hawser__reference_clear(struct hawser__reference *reference)
{
	free(reference->legendre);
	free(reference->running);
	free(reference->weight);
	free(reference->half);
	*reference = (struct hawser__reference){0};
}

/* table[j][i] = P_j(x_i), j = 0..degree. */
static void tabulate(double *table, int degree, const double *x, int m)
{
	for (int i = 0; i < m; i++) {
		double below = 1.0, value = x[i];

		table[i] = below;
		for (int j = 1; j <= degree; j++) {
			double next = ((2*j + 1)*x[i]*value - j*below)/(j + 1);

			table[j*m + i] = value;
			below = value;
			value = next;
		}
	}
}

/* I = sum over j < m of [integral of P_j to x_i] * (2j+1)/2 P_j(x_k) w_k, where the integral is
 * (P_{j+1} - P_{j-1})/(2j+1), and 1 + x for j = 0. P_m vanishes at the nodes. */
static void integrals(double *running, double *left, const struct hawser__reference *reference,
                      const double *x)
{
	const double *P = reference->legendre;
	int m = reference->order;

	for (int i = 0; i < m; i++) {
		left[i] = 1.0 + x[i];
		for (int j = 1; j < m; j++)
			left[j*m + i] = (j + 1 < m ? P[(j + 1)*m + i] : 0.0) - P[(j - 1)*m + i];
	}
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, m, m, m, 0.5, left, m, P, m, 0.0,
	            running, m);
	for (int i = 0; i < m; i++)
		for (int k = 0; k < m; k++)
			/* NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign): cblas_dgemm filled it */
			running[i*m + k] *= reference->weight[k];
}

enum hawser_status hawser__reference_init(struct hawser__reference *reference,
                                          const struct hawser_grid *grid, int degree,
                                          struct hawser_report *report)
{
	int m = grid->order, top = degree > m - 1 ? degree : m - 1;
	size_t square = (size_t)m*(size_t)m;
	double *left = calloc(square, sizeof *left);

	*reference = (struct hawser__reference){.order = m, .degree = top};
	reference->legendre = calloc(((size_t)top + 1)*(size_t)m, sizeof *reference->legendre);
	reference->running = calloc(square, sizeof *reference->running);
	reference->weight = malloc((size_t)m*sizeof *reference->weight);
	reference->half = calloc((size_t)grid->elements, sizeof *reference->half);
	if (!left || !reference->legendre || !reference->running || !reference->weight ||
	    !reference->half) {
		free(left);
		hawser__reference_clear(reference);
		return hawser__no_memory(report, "modes");
	}
	for (int i = 0; i < grid->points; i++)
		reference->half[i/m] += 0.5*grid->weight[i];
	for (int i = 0; i < m; i++)
		reference->weight[i] = grid->weight[i]/reference->half[0];
	tabulate(reference->legendre, top, grid->node, m);
	integrals(reference->running, left, reference, grid->node);
	free(left);
	return HAWSER_OK;
}

double hawser__grid_running(double *out, const struct hawser_grid *grid,
                            const struct hawser__reference *reference, const double *in)
{
	int m = grid->order;
	double base = 0.0;

	for (int e = 0; e < grid->elements; e++) {
		for (int i = 0; i < m; i++)
			out[e*m + i] = base;
		cblas_dgemv(CblasRowMajor, CblasNoTrans, m, m, reference->half[e], reference->running, m,
		            in + e*m, 1, 1.0, out + e*m, 1);
		base += cblas_ddot(m, grid->weight + e*m, 1, in + e*m, 1);
	}
	return base;
}

int hawser__grid_weights(double *weight, const struct hawser_grid *grid, double s)
{
	int m = grid->order, e = hawser__interval(grid->edge, grid->elements, s);
	double a = grid->edge[e], b = grid->edge[e + 1], x = ((s - a) - (b - s))/(b - a), sum = 0.0;

	for (int i = 0; i < m; i++) {
		double distance = x - grid->node[i];

		if (distance == 0.0) {
			for (int k = 0; k < m; k++)
				weight[k] = k == i;
			return e;
		}
		weight[i] = grid->bary[i]/distance;
		sum += weight[i];
	}
	for (int i = 0; i < m; i++)
		weight[i] /= sum;
	return e;
}

void hawser__grid_at(double *out, const struct hawser_grid *grid, const double *in, int stride,
                     int fields, double s)
{
	int m = grid->order, e = hawser__interval(grid->edge, grid->elements, s);
	double a = grid->edge[e], b = grid->edge[e + 1], x = ((s - a) - (b - s))/(b - a), sum = 0.0;
	const double *value = in + (size_t)e*(size_t)m*(size_t)stride;

	for (int f = 0; f < fields; f++)
		out[f] = 0.0;
	for (int i = 0; i < m; i++) {
		double distance = x - grid->node[i], weight = grid->bary[i]/distance;

		if (distance == 0.0) {
			for (int f = 0; f < fields; f++)
				out[f] = value[i*stride + f];
			return;
		}
		sum += weight;
		for (int f = 0; f < fields; f++)
			out[f] += weight*value[i*stride + f];
	}
	for (int f = 0; f < fields; f++)
		out[f] /= sum;
}
