/* modes/bending/flexure.c - functions, stiffness and static response of a cable with bending stiffness.
 *
 *   a, b, c    derivative of the displacement in the local frame (e, n, z)
 *   n, phi     unknowns: n = a/sqrt(eps); phi = b/g or c/g, the rotation of the tangent
 *   g, T       1 + eps*T; sqrt(1+u^2), the tension over H
 *   beta       EI/(H d^2);  h  half length of an element, x in [-1,1]
 *
 * The energy of a small motion is half of the integral of n^2 + g T phi^2 + beta phi'^2, plus that of
 * rotational springs at the ends. n is a polynomial in each element; phi is one too, and continuous,
 * so that the displacement, their integral, is C1. Clamped ends have no function at the edge.
 * With these unknowns nothing is divided by eps, and the stiffness is nearly a unit matrix for any
 * tension: frequencies don't lose accuracy for stiff cables (compare compliance.c). The only
 * constraint, that end B is at rest, is removed by a Householder reflection.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/bending/flexure.h"

void hawser__flexure_axes(double *cosine, double *sine, const struct hawser_statics *st, double s)
{
	struct hawser_frame_point at = hawser_statics_frame(st, s);
	struct hawser_frame_point middle = hawser_statics_frame(st, 0.5*st->l);
	double bent = st->attachments > 0 ? at.u - middle.u : st->delta*(s - 0.5*st->l);

	*cosine = at.ex*middle.ex + at.ey*middle.ey;
	*sine = bent*at.ex*middle.ex;
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

/* stretch: P_j sqrt((2j+1)/2), j < p. rotation, for j >= 1: (P_(j+1) - P_(j-1))/sqrt(2(2j+1)), with
 * the derivative P_j sqrt((2j+1)/2) by x; then the two edges, (1 -+ x)/2. */
static enum hawser_status fill_table(struct hawser__flexure *t, struct hawser_report *report)
{
	int p = t->degree, m = t->grid->order, block = (p + 2)*m;
	double *P = malloc(((size_t)p + 2)*sizeof *P);
	double *n = t->table, *phi = n + block, *bend = phi + block;

	if (!P)
		return hawser__no_memory(report, "modes");
	for (int i = 0; i < m; i++) {
		double x = t->grid->node[i];

		legendre(P, p + 1, x);
		for (int j = 0; j < p; j++) {
			double root = sqrt(j + 0.5);

			n[j*m + i] = root*P[j];
			bend[j*m + i] = root*P[j];
			phi[j*m + i] = j > 0 ? (P[j + 1] - P[j - 1])*root/(2*j + 1) : 0.0;
		}
		phi[p*m + i] = 0.5*(1.0 - x);
		phi[(p + 1)*m + i] = 0.5*(1.0 + x);
		bend[p*m + i] = -0.5;
		bend[(p + 1)*m + i] = 0.5;
	}
	free(P);
	return HAWSER_OK;
}

/* Index of the rotation's function j of element e, or -1: bubbles 1 to p-1, then p and p+1, the
 * edges. */
static int rotation(const struct hawser__flexure *t, int e, int j)
{
	int stretches = t->D == 2 ? t->elements*t->degree : 0;

	return j < t->degree ? stretches + e*(t->degree - 1) + j - 1 : t->first[e + j - t->degree];
}

static void number_edges(struct hawser__flexure *t, const struct hawser_statics *st)
{
	int next = (t->D == 2 ? t->elements*t->degree : 0) + t->elements*(t->degree - 1);

	for (int e = 0; e <= t->elements; e++) {
		int end = e == 0 ? 0 : e == t->elements ? 1 : -1;

		t->first[e] = end >= 0 && isinf(st->bending.rotation[end]) ? -1 : next++;
	}
	t->functions = next;
	t->free = next - t->D;
}

/* --- stiffness --- */

static double product(const double *f, const double *g, const double *w, int m)
{
	double sum = 0.0;

	for (int i = 0; i < m; i++)
		sum += w[i]*f[i]*g[i];
	return sum;
}

static void stiffness_of(struct hawser__flexure *t, int e)
{
	int p = t->degree, m = t->grid->order, block = (p + 2)*m;
	const double *w = t->grid->weight + e*m, *k = t->k + e*m;
	const double *phi = t->table + block, *bend = phi + block;
	double h = t->half[e];
	size_t n = (size_t)t->functions;

	/* sqrt((2j+1)/2) P_j is orthonormal by x: the integral over the element has the factor h */
	for (int j = 0; t->D == 2 && j < p; j++)
		t->K[(size_t)(e*p + j)*(n + 1)] += h;
	for (int i = 1; i < p + 2; i++)
		for (int j = i; j < p + 2; j++) {
			int row = rotation(t, e, i), column = rotation(t, e, j), swap = row;
			double value;

			if (row < 0 || column < 0)
				continue;
			if (row > column) {
				row = column;
				column = swap;
			}
			value = product(phi + i*m, phi + j*m, k, m);
			if (i == j || (i >= p && j >= p)) /* bubbles are orthogonal to each other and edges */
				value += t->beta/(h*h)*product(bend + i*m, bend + j*m, w, m);
			t->K[(size_t)column*n + (size_t)row] += value;
		}
}

/* Springs to ground of attachments: their strain is a row of displacements. */
static void add_springs(struct hawser__flexure *t, const struct hawser_statics *st)
{
	struct hawser_frame_point middle = hawser_statics_frame(st, 0.5*st->l);
	const double axis[3][2] = {{middle.ex, -middle.ey}, {middle.ey, middle.ex}, {1.0, 0.0}};
	int n = t->functions;

	for (int i = 0; i < st->attachments; i++)
		for (int c = 0; c < 3; c++) {
			double k = st->attached[i].spring[c]*st->span.d/st->H;
			const double *X = t->x + t->D*t->points + t->D*i;

			if (k == 0.0 || (c == 2) != (t->plane == HAWSER_OUT_OF_PLANE))
				continue;
			for (int q = 0; q < n; q++)
				for (int r = 0; r <= q; r++) {
					double left = 0.0, right = 0.0;

					for (int f = 0; f < t->D; f++) {
						left += axis[c][f]*X[(size_t)q*(size_t)t->rows + (size_t)f];
						right += axis[c][f]*X[(size_t)r*(size_t)t->rows + (size_t)f];
					}
					t->K[(size_t)q*(size_t)n + (size_t)r] += k*left*right;
				}
		}
}

static void assemble(struct hawser__flexure *t, const struct hawser_statics *st)
{
	size_t n = (size_t)t->functions;

	for (int e = 0; e < t->elements; e++)
		stiffness_of(t, e);
	for (int end = 0; end < 2; end++) {
		int at = t->first[end ? t->elements : 0];

		if (at >= 0)
			t->K[(size_t)at*(n + 1)] += st->bending.rotation[end]/(st->H*st->span.d);
	}
	add_springs(t, st);
}

/* --- displacements --- */

/* Displacement by one function, from the gradient [D][points] that it gives in element e: running
 * integrals there, constant beyond. x is its column. */
static void displace(double *x, double *end, const struct hawser__flexure *t,
                     const struct hawser_statics *st, const struct hawser__reference *reference,
                     const double *gradient, int e)
{
	int m = t->grid->order, first = e*m;

	for (int c = 0; c < t->D; c++) {
		double *to = x + c*t->points, sum, base = end[c];
		const double *from = gradient + c*m;

		cblas_dgemv(CblasRowMajor, CblasNoTrans, m, m, reference->half[e], reference->running, m,
		            from, 1, 1.0, to + first, 1);
		sum = cblas_ddot(m, t->grid->weight + first, 1, from, 1);
		for (int i = first + m; i < t->points; i++)
			to[i] += sum;
		for (int a = 0; a < st->attachments; a++)
			if (st->attached[a].s >= t->grid->edge[e + 1])
				x[t->D*t->points + t->D*a + c] += sum;
		end[c] = base + sum;
	}
}

/* Add the displacement of `table` row, of stretch or rotation, in element e to the column of
 * `index`. */
static void add_function(struct hawser__flexure *t, const struct hawser_statics *st,
                         const struct hawser__reference *reference, double *gradient,
                         const double *axes, int index, int e, int turning, const double *row)
{
	int m = t->grid->order, rows = t->points;
	double *x, end[HAWSER__FLEX_D] = {0.0};

	if (index < 0)
		return;
	x = t->x + (size_t)index*(size_t)t->rows;
	for (int i = 0; i < m; i++) {
		int at = e*m + i;
		double f = row[i]*(turning ? t->b[at] : t->a[at]);

		gradient[i] = t->D == 1 ? f : f*(turning ? -axes[rows + at] : axes[at]);
		if (t->D == 2)
			gradient[m + i] = f*(turning ? axes[at] : axes[rows + at]);
	}
	displace(x, end, t, st, reference, gradient, e);
	for (int c = 0; c < t->D; c++)
		t->C[(size_t)c*(size_t)t->functions + (size_t)index] += end[c];
}

static enum hawser_status fill_displacements(struct hawser__flexure *t,
                                             const struct hawser_statics *st,
                                             struct hawser_report *report)
{
	int m = t->grid->order, p = t->degree, block = (p + 2)*m;
	double *axes = malloc((2*(size_t)t->points + 2*(size_t)m)*sizeof *axes);
	struct hawser__reference reference;
	enum hawser_status status = hawser__reference_init(&reference, t->grid, m - 1, report);

	if (status || !axes) {
		free(axes);
		if (!status)
			hawser__reference_clear(&reference);
		return status ? status : hawser__no_memory(report, "modes");
	}
	for (int i = 0; i < t->points; i++)
		hawser__flexure_axes(&axes[i], &axes[t->points + i], st, t->grid->s[i]);
	for (int e = 0; e < t->elements; e++) {
		for (int j = 0; t->D == 2 && j < p; j++)
			add_function(t, st, &reference, axes + 2*t->points, axes, e*p + j, e, 0,
			             t->table + j*m);
		for (int j = 1; j < p + 2; j++)
			add_function(t, st, &reference, axes + 2*t->points, axes, rotation(t, e, j), e, 1,
			             t->table + block + j*m);
	}
	hawser__reference_clear(&reference);
	free(axes);
	return HAWSER_OK;
}

static void fill_fields(struct hawser__flexure *t, const struct hawser_statics *st)
{
	const struct hawser_grid *grid = t->grid;

	for (int i = 0; i < t->points; i++) {
		struct hawser_frame_point at = hawser_statics_frame(st, grid->s[i]);

		t->a[i] = sqrt(st->epsilon);
		t->b[i] = 1.0 + at.strain;
		t->k[i] = grid->weight[i]*t->b[i]*hypot(1.0, at.u);
	}
	for (int e = 0; e < t->elements; e++) {
		t->half[e] = 0.0;
		for (int i = 0; i < grid->order; i++)
			t->half[e] += 0.5*grid->weight[e*grid->order + i];
	}
}

/* --- opening and closing --- */

void hawser__flexure_clear(struct hawser__flexure *t)
{
	hawser__hold_clear(&t->hold);
	*t = (struct hawser__flexure){0};
}

static int allocate(struct hawser__flexure *t, const struct hawser_statics *st)
{
	size_t n, points = (size_t)t->points, order = (size_t)t->grid->order;

	t->first = hawser__hold(&t->hold, (size_t)t->elements + 1, sizeof *t->first);
	if (t->hold.short_of_memory)
		return 0;
	number_edges(t, st);
	n = (size_t)t->functions;
	t->K = hawser__hold(&t->hold, n*n, sizeof *t->K);
	t->C = hawser__hold(&t->hold, n*(size_t)t->D, sizeof *t->C);
	t->end = hawser__hold(&t->hold, n*(size_t)t->D, sizeof *t->end);
	t->tau = hawser__hold(&t->hold, (size_t)t->D, sizeof *t->tau);
	t->table = hawser__hold(&t->hold, 3*((size_t)t->degree + 2)*order, sizeof *t->table);
	t->x = hawser__hold(&t->hold, n*(size_t)t->rows, sizeof *t->x);
	t->a = hawser__hold(&t->hold, points, sizeof *t->a);
	t->b = hawser__hold(&t->hold, points, sizeof *t->b);
	t->k = hawser__hold(&t->hold, points, sizeof *t->k);
	t->half = hawser__hold(&t->hold, (size_t)t->elements, sizeof *t->half);
	return !t->hold.short_of_memory;
}

/* K = R'R; with the displacement of end B, R^-T C = Q [r; 0], the coordinates are the last ones of
 * Q'Ry. */
static enum hawser_status factor(struct hawser__flexure *t, struct hawser_report *report)
{
	int n = t->functions;

	if (LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'U', n, t->K, n) != 0)
		return hawser__fail(report, HAWSER_ERR_NAN, "modes",
		                    "the stiffness of the cable with cable.EI came out as not positive: "
		                    "check EA, EI, rho, d and the tension of the span");
	memcpy(t->end, t->C, (size_t)n*(size_t)t->D*sizeof *t->end);
	cblas_dtrsm(CblasColMajor, CblasLeft, CblasUpper, CblasTrans, CblasNonUnit, n, t->D, 1.0, t->K, n,
	            t->C, n);
	return LAPACKE_dgeqrf(LAPACK_COL_MAJOR, n, t->D, t->C, n, t->tau) == 0
	       ? HAWSER_OK : hawser__no_memory(report, "modes");
}

enum hawser_status hawser__flexure_init(struct hawser__flexure *t, const struct hawser_statics *st,
                                        const struct hawser_grid *grid, int degree, int plane,
                                        struct hawser_report *report)
{
	enum hawser_status status;

	*t = (struct hawser__flexure){.plane = plane, .D = plane == HAWSER_IN_PLANE ? 2 : 1,
	                              .points = grid->points, .elements = grid->elements,
	                              .degree = degree, .grid = grid,
	                              .beta = st->bending.EI/(st->H*st->span.d*st->span.d)};
	t->rows = t->D*(t->points + st->attachments);
	if (!allocate(t, st))
		return hawser__no_memory(report, "modes");
	fill_fields(t, st);
	status = fill_table(t, report);
	if (!status)
		status = fill_displacements(t, st, report);
	if (status)
		return status;
	assemble(t, st);
	return factor(t, report);
}

/* --- use --- */

void hawser__flexure_strain(double *strain, const struct hawser__flexure *t, const double *y)
{
	int m = t->grid->order, p = t->degree, block = (p + 2)*m, across = t->D == 2 ? 1 : 2;

	for (int e = 0; e < t->elements; e++) {
		double *to = strain + 3*e*m;

		for (int j = 0; t->D == 2 && j < p; j++)
			for (int i = 0; i < m; i++)
				to[3*i] += t->a[e*m + i]*t->table[j*m + i]*y[e*p + j];
		for (int j = 1; j < p + 2; j++) {
			int at = rotation(t, e, j);

			for (int i = 0; at >= 0 && i < m; i++)
				to[3*i + across] += t->b[e*m + i]*t->table[block + j*m + i]*y[at];
		}
	}
}

/* y of all coordinates: first those of the displacement of end B. */
static enum hawser_status turn_back(double *y, const struct hawser__flexure *t,
                                    struct hawser_report *report)
{
	int n = t->functions;

	if (LAPACKE_dormqr(LAPACK_COL_MAJOR, 'L', 'N', n, 1, t->D, t->C, n, t->tau, y, n) != 0)
		return hawser__no_memory(report, "modes");
	cblas_dtrsv(CblasColMajor, CblasUpper, CblasNoTrans, CblasNonUnit, n, t->K, n, y, 1);
	return HAWSER_OK;
}

enum hawser_status hawser__flexure_expand(double *y, const struct hawser__flexure *t, const double *z,
                                          struct hawser_report *report)
{
	memset(y, 0, (size_t)t->D*sizeof *y);
	memcpy(y + t->D, z, (size_t)t->free*sizeof *y);
	return turn_back(y, t, report);
}

/* The displacement of end B is r'w, with w the first D coordinates and r the triangle in C. */
enum hawser_status hawser__flexure_hold(double *y, const struct hawser__flexure *t,
                                        struct hawser_report *report)
{
	int n = t->functions;
	double *part = calloc((size_t)n, sizeof *part);
	enum hawser_status status;

	if (!part)
		return hawser__no_memory(report, "modes");
	cblas_dgemv(CblasColMajor, CblasTrans, n, t->D, -1.0, t->end, n, y, 1, 0.0, part, 1);
	cblas_dtrsv(CblasColMajor, CblasUpper, CblasTrans, CblasNonUnit, t->D, t->C, n, part, 1);
	status = turn_back(part, t, report);
	if (!status)
		cblas_daxpy(n, 1.0, part, 1, y, 1);
	free(part);
	return status;
}

double hawser__flexure_tail(const struct hawser__flexure *t, const double *y)
{
	int p = t->degree, m = t->grid->order, block = (p + 2)*m;
	const double *phi = t->table + block, *bend = phi + block;
	double sum = 0.0;

	for (int e = 0; e < t->elements; e++)
		for (int j = p - 2; j < p; j++) {
			double h = t->half[e], turn = y[rotation(t, e, j)];

			if (t->D == 2)
				sum += h*y[e*p + j]*y[e*p + j];
			sum += turn*turn*(product(phi + j*m, phi + j*m, t->k + e*m, m) +
			                  t->beta/(h*h)*product(bend + j*m, bend + j*m,
			                                        t->grid->weight + e*m, m));
		}
	return sum;
}

enum hawser_status hawser__flexure_roots(double **root, const struct hawser__flexure *t,
                                         const struct hawser_statics *st,
                                         struct hawser_report *report)
{
	int n = t->functions, rows = t->rows;
	double *X = malloc((size_t)rows*(size_t)n*sizeof *X);

	*root = NULL;
	if (!X)
		return hawser__no_memory(report, "modes");
	memcpy(X, t->x, (size_t)rows*(size_t)n*sizeof *X);
	cblas_dtrsm(CblasColMajor, CblasRight, CblasUpper, CblasNoTrans, CblasNonUnit, rows, n, 1.0, t->K,
	            n, X, rows);
	if (LAPACKE_dormqr(LAPACK_COL_MAJOR, 'R', 'N', rows, n, t->D, t->C, n, t->tau, X, rows) != 0) {
		free(X);
		return hawser__no_memory(report, "modes");
	}
	memmove(X, X + (size_t)rows*(size_t)t->D, (size_t)rows*(size_t)t->free*sizeof *X);
	for (int j = 0; j < t->free; j++)
		for (int r = 0; r < rows; r++) {
			int mass = r >= t->D*t->points;
			double w = mass ? st->attached[(r - t->D*t->points)/t->D].m
			                : t->grid->weight[r%t->points];

			X[(size_t)j*(size_t)rows + (size_t)r] *= sqrt(w);
		}
	*root = X;
	return HAWSER_OK;
}
