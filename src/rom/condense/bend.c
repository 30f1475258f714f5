/* rom/condense/bend.c - bending stiffness in the static response of condensed modes.
 *
 *   phi        rotation b/g (in the plane) or c/g; f a force against b or c
 *   T, g       tension, static stretch: k = T/g of struct hawser__place
 *   beta, kappa   scaled bending stiffness; that of the rotation of an end
 *
 * Without conditions on the displacement the strains of a cable are independent: a = eps f_a. Without
 * bending stiffness b = f/k, point by point (condense.c). With it phi minimises
 *
 *     1/2 integral of T g phi^2 + beta phi'^2, plus kappa phi^2/2 at the ends, minus that of f g phi
 *
 * with phi = 0 at clamped ends: the string's answer f/k, smoothed over the width sqrt(EI/T). It is
 * the same operator in both planes and for every force, symmetric and positive, and takes the place of
 * 1/k wherever the closed forms have it; the conditions that the ends and springs make are the same
 * small systems as without (ties.c).
 *
 * phi is continuous, a polynomial of degree order - 2 in each part, by integrated Legendre
 * polynomials between the edges' linear functions; the matrix is a band, factored once. The parts
 * resolve the layers, as those of the modes do (modes/bending/flexure_solve.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/grid.h"
#include "rom/condense/bend.h"

void hawser__bend_free(struct hawser__bend *bend)
{
	if (!bend)
		return;
	hawser__hold_clear(&bend->hold);
	free(bend);
}

static int allocate(struct hawser__bend *t)
{
	size_t order = (size_t)t->order, points = (size_t)t->points, size = (size_t)t->size;

	t->K = hawser__hold(&t->hold, size*((size_t)t->band + 1), sizeof *t->K);
	t->phi = hawser__hold(&t->hold, ((size_t)t->degree + 1)*order, sizeof *t->phi);
	t->turn = hawser__hold(&t->hold, order*order, sizeof *t->turn);
	t->edge = hawser__hold(&t->hold, 2*order, sizeof *t->edge);
	t->g = hawser__hold(&t->hold, points, sizeof *t->g);
	t->weight = hawser__hold(&t->hold, points, sizeof *t->weight);
	t->half = hawser__hold(&t->hold, (size_t)t->parts, sizeof *t->half);
	t->y = hawser__hold(&t->hold, size, sizeof *t->y);
	t->f = hawser__hold(&t->hold, points, sizeof *t->f);
	return !t->hold.short_of_memory;
}

/* --- functions --- */

/* P_j at x for j = 0 to degree. */
static void legendre(double *P, int degree, double x)
{
	P[0] = 1.0;
	P[1] = x;
	for (int j = 1; j < degree; j++)
		P[j + 1] = ((2*j + 1)*x*P[j] - j*P[j - 1])/(j + 1);
}

/* Row 0: (1 - x)/2; row j: (P_(j+1) - P_(j-1))/sqrt(2(2j+1)), 0 at both edges; the last: (1 + x)/2. P
 * [order] is work space. */
static void fill_functions(struct hawser__bend *t, const double *node, double *P)
{
	int m = t->order, p = t->degree;

	for (int i = 0; i < m; i++) {
		legendre(P, m - 1, node[i]);
		t->phi[i] = 0.5*(1.0 - node[i]);
		t->phi[p*m + i] = 0.5*(1.0 + node[i]);
		for (int j = 1; j < p; j++)
			t->phi[j*m + i] = (P[j + 1] - P[j - 1])/sqrt(2.0*(2*j + 1));
	}
}

/* Barycentric interpolation at the nodes of a Gauss rule. */
static void fill_derivative(struct hawser__bend *t, const double *node, double *scale)
{
	int m = t->order;

	for (int i = 0; i < m; i++) {
		scale[i] = 1.0;
		for (int j = 0; j < m; j++)
			scale[i] /= j == i ? 1.0 : 2.0*(node[i] - node[j]);
	}
	for (int i = 0; i < m; i++) {
		double sum = 0.0;

		for (int j = 0; j < m; j++) {
			if (j == i)
				continue;
			t->turn[i*m + j] = scale[j]/scale[i]/(node[i] - node[j]);
			sum += t->turn[i*m + j];
		}
		t->turn[i*m + i] = -sum; /* a constant has none */
	}
	for (int end = 0; end < 2; end++) {
		double sum = 0.0;

		for (int j = 0; j < m; j++) {
			t->edge[end*m + j] = scale[j]/((end ? 1.0 : -1.0) - node[j]);
			sum += t->edge[end*m + j];
		}
		cblas_dscal(m, 1.0/sum, t->edge + end*m, 1);
	}
}

/* --- matrix --- */

/* Unknown of function j in part e, or -1. */
static int unknown(const struct hawser__bend *t, int e, int j)
{
	int at = e*t->degree + j - t->held[0];

	return at < 0 || at >= t->size ? -1 : at;
}

static void add_part(struct hawser__bend *t, const struct hawser__place *place, int e)
{
	int m = t->order, p = t->degree;
	double h = t->half[e];

	for (int i = 0; i <= p; i++)
		for (int j = 0; j <= i; j++) {
			int row = unknown(t, e, i), column = unknown(t, e, j);
			double sum = 0.0;

			if (row < 0 || column < 0)
				continue;
			for (int q = 0; q < m; q++)
				sum += place[q].weight*place[q].k*place[q].g2*t->phi[i*m + q]*t->phi[j*m + q];
			/* derivatives of bubbles are orthonormal, and orthogonal to those of the edges' */
			if (i == j)
				sum += i == 0 || i == p ? 0.5*t->beta/h : t->beta/h;
			else if (j == 0 && i == p)
				sum -= 0.5*t->beta/h;
			t->K[column*(t->band + 1) + row - column] += sum;
		}
}

static enum hawser_status factor(struct hawser__bend *t, const struct hawser__place *place,
                                 struct hawser_report *report)
{
	int info;

	for (int e = 0; e < t->parts; e++)
		add_part(t, place + e*t->order, e);
	if (!t->held[0])
		t->K[0] += t->spring[0];
	if (!t->held[1])
		t->K[(t->size - 1)*(t->band + 1)] += t->spring[1];
	info = LAPACKE_dpbtrf(LAPACK_COL_MAJOR, 'L', t->size, t->band, t->K, t->band + 1);
	if (info)
		return hawser__lapack_starved(info) ? hawser__no_memory(report, "rom")
			: hawser__fail(report, HAWSER_ERR_NAN, "rom",
			               "the response of the cable with cable.EI came out as not finite: check "
			               "EA, EI, rho, d and the tension of the span");
	return HAWSER_OK;
}

static void fill(struct hawser__bend *t, const struct hawser_statics *st, const double *edge,
                 const struct hawser__place *place)
{
	t->beta = st->bending.EI/(st->H*st->span.d*st->span.d);
	for (int end = 0; end < 2; end++)
		t->spring[end] = t->held[end] ? 0.0 : st->bending.rotation[end]/(st->H*st->span.d);
	for (int i = 0; i < t->points; i++) {
		t->g[i] = sqrt(place[i].g2);
		t->weight[i] = place[i].weight;
	}
	for (int e = 0; e < t->parts; e++)
		t->half[e] = 0.5*(edge[e + 1] - edge[e]);
}

enum hawser_status hawser__bend_make(struct hawser__bend **bend, const struct hawser_statics *st,
                                     const double *edge, int parts, int order,
                                     const struct hawser__place *place,
                                     struct hawser_report *report)
{
	static const double unit[] = {-1.0, 1.0};
	struct hawser_grid rule = {0};
	struct hawser__bend *t;
	enum hawser_status status;

	*bend = NULL;
	if (!(st->bending.EI > 0.0))
		return HAWSER_OK;
	t = calloc(1, sizeof *t);
	if (!t)
		return hawser__no_memory(report, "rom");
	t->parts = parts;
	t->order = order;
	t->degree = t->band = order - 2;
	t->points = parts*order;
	for (int end = 0; end < 2; end++)
		t->held[end] = isinf(st->bending.rotation[end]) != 0;
	t->size = parts*t->degree + 1 - t->held[0] - t->held[1];
	status = allocate(t) ? hawser__grid_init(&rule, 1, order, unit, NULL, report)
	                     : hawser__no_memory(report, "rom");
	if (!status) {
		fill_functions(t, rule.node, t->f);
		fill_derivative(t, rule.node, t->f);
		fill(t, st, edge, place);
		status = factor(t, place, report);
	}
	hawser__grid_clear(&rule);
	if (status)
		hawser__bend_free(t);
	else
		*bend = t;
	return status;
}

/* --- use --- */

/* x [points] with the stride 3: from a force to the strain. */
static void answer(const struct hawser__bend *t, double *x)
{
	int m = t->order, p = t->degree;

	memset(t->y, 0, (size_t)t->size*sizeof *t->y);
	for (int e = 0; e < t->parts; e++) {
		for (int q = 0; q < m; q++)
			t->f[q] = t->weight[e*m + q]*t->g[e*m + q]*x[3*(e*m + q)];
		for (int j = 0; j <= p; j++)
			if (unknown(t, e, j) >= 0)
				t->y[unknown(t, e, j)] += cblas_ddot(m, t->phi + j*m, 1, t->f, 1);
	}
	cblas_dtbsv(CblasColMajor, CblasLower, CblasNoTrans, CblasNonUnit, t->size, t->band, t->K,
	            t->band + 1, t->y, 1);
	cblas_dtbsv(CblasColMajor, CblasLower, CblasTrans, CblasNonUnit, t->size, t->band, t->K,
	            t->band + 1, t->y, 1);
	for (int e = 0; e < t->parts; e++) {
		memset(t->f, 0, (size_t)m*sizeof *t->f);
		for (int j = 0; j <= p; j++)
			if (unknown(t, e, j) >= 0)
				cblas_daxpy(m, t->y[unknown(t, e, j)], t->phi + j*m, 1, t->f, 1);
		for (int q = 0; q < m; q++)
			x[3*(e*m + q)] = t->g[e*m + q]*t->f[q];
	}
}

void hawser__comply(const struct hawser__bend *bend, double *x, const struct hawser__place *place,
                    int points)
{
	for (int i = 0; i < points; i++) {
		x[3*i] *= place[i].eps;
		if (bend)
			continue;
		x[3*i + 1] /= place[i].k;
		x[3*i + 2] /= place[i].k;
	}
	if (!bend)
		return;
	answer(bend, x + 1);
	answer(bend, x + 2);
}

void hawser__bend_rows(double *rows, const struct hawser__bend *t, const double *strain)
{
	int m = t->order;
	double *ends = rows + 2*t->points;

	for (int f = 0; f < 2; f++)
		for (int e = 0; e < t->parts; e++) {
			for (int q = 0; q < m; q++)
				t->f[q] = strain[3*(e*m + q) + 1 + f]/t->g[e*m + q];
			for (int q = 0; q < m; q++)
				rows[2*(e*m + q) + f] = sqrt(t->beta*t->weight[e*m + q])/t->half[e]*
				                        cblas_ddot(m, t->turn + q*m, 1, t->f, 1);
			if (e == 0)
				ends[f] = sqrt(t->spring[0])*cblas_ddot(m, t->edge, 1, t->f, 1);
			if (e == t->parts - 1)
				ends[2 + f] = sqrt(t->spring[1])*cblas_ddot(m, t->edge + m, 1, t->f, 1);
		}
}

void hawser__bend_gram(double *gram, const struct hawser__bend *bend, double *rows,
                       const double *strain, int stride, int count)
{
	int wide = hawser__bend_width(bend);

	if (!bend)
		return;
	for (int x = 0; x < count; x++)
		hawser__bend_rows(rows + (size_t)x*(size_t)wide, bend, strain + (size_t)x*(size_t)stride);
	cblas_dsyrk(CblasRowMajor, CblasLower, CblasNoTrans, count, wide, 1.0, rows, wide, 1.0, gram,
	            count);
}
