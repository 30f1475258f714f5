/* modes/fdm.c - second-order finite differences of B (4.55), on [0, l], as printed.
 *
 *   h       l/N; the unknowns are U, V (or W) at the N-1 inner points, U and V alternating
 *   kappa   curvature delta/(1+u^2), u = eta + delta*s
 *   e, r    strain epsilon*sqrt(1+u^2); r = e/(1+e). r/epsilon = T/g
 *   A       the matrix with A Y = omega^2 Y: banded (3 + 3 in the plane, 1 + 1 out of it)
 *
 * A is not symmetric, since B expands the derivatives of products before it discretises them; real
 * frequencies are therefore not guaranteed. The lowest frequencies are the largest eigenvalues of
 * A^-1, computed by one banded LU factorisation and krylov.c. This works for 40 000 unknowns,
 * whereas dense matrices are limited to about 2000. The relative round-off error of the LU solution
 * is about u*N^2/epsilon, where u is the unit round-off.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/methods.h"
#include "modes/halving.h"

struct band {
	int n, k, rows; /* k diagonals on either side; rows = 3k + 1 in LAPACK's band storage with
	                 * pivoting */
	double *a;      /* [n] columns of `rows` */
	lapack_int *pivot;
};

/* Coefficients at one point. */
struct point {
	double kappa, kappa1, r, r1, e; /* kappa1, r1: derivatives of kappa and r by s */
};

static struct point at(const struct hawser_statics *st, double s)
{
	double u = st->eta + st->delta*s, T = hypot(1.0, u);
	struct point p = {.kappa = st->delta/(T*T), .e = st->epsilon*T};

	p.kappa1 = -2.0*u*p.kappa*p.kappa;
	p.r = p.e/(1.0 + p.e);
	p.r1 = st->epsilon*u*st->delta/T/((1.0 + p.e)*(1.0 + p.e));
	return p;
}

static void add(struct band *b, int row, int column, double value)
{
	if (column >= 0 && column < b->n)
		b->a[(size_t)column*(size_t)b->rows + (size_t)(2*b->k + row - column)] += value;
}

/* Add the differences of -(second*f'' + first*f' + zeroth*f)/epsilon to `row`; f is the unknown at
 * `column`, its values at the neighbouring points are `step` columns away. */
static void differences(struct band *b, int row, int column, int step, const double *coefficient,
                        double h, double epsilon)
{
	double second = coefficient[2]/(h*h), first = 0.5*coefficient[1]/h;

	add(b, row, column - step, -(second - first)/epsilon);
	add(b, row, column, -(coefficient[0] - 2.0*second)/epsilon);
	add(b, row, column + step, -(second + first)/epsilon);
}

static void assemble(struct band *b, const struct hawser_statics *st, enum hawser_plane plane,
                     int N)
{
	double h = st->l/N, epsilon = st->epsilon;

	for (int i = 1; i < N; i++) {
		struct point p = at(st, i*h);
		double mixed = (1.0 + 2.0*p.e)/(1.0 + p.e)*p.kappa, kappa2 = p.kappa*p.kappa;
		int row = 2*(i - 1);

		if (plane == HAWSER_OUT_OF_PLANE) {
			differences(b, i - 1, i - 1, 1, (double[]){0.0, p.r1, p.r}, h, epsilon);
			continue;
		}
		differences(b, row, row, 2, (double[]){-p.r*kappa2, 0.0, 1.0}, h, epsilon);
		differences(b, row, row + 1, 2, (double[]){-p.kappa1, -mixed, 0.0}, h, epsilon);
		differences(b, row + 1, row + 1, 2, (double[]){-kappa2, p.r1, p.r}, h, epsilon);
		differences(b, row + 1, row, 2,
		            (double[]){p.r1*p.kappa + p.r*p.kappa1, mixed, 0.0}, h, epsilon);
	}
}

enum hawser_status hawser__fdm_dense(double *A, const struct hawser_statics *statics,
                                     enum hawser_plane plane, int N, struct hawser_report *report)
{
	int in_plane = plane == HAWSER_IN_PLANE, k = in_plane ? 3 : 1;
	struct band b = {.n = (in_plane ? 2 : 1)*(N - 1), .k = k, .rows = 3*k + 1};

	b.a = calloc((size_t)b.n*(size_t)b.rows, sizeof *b.a);
	if (!b.a)
		return hawser__no_memory(report, "modes");
	assemble(&b, statics, plane, N);
	for (int column = 0; column < b.n; column++)
		for (int row = column - k; row <= column + k; row++)
			if (row >= 0 && row < b.n)
				A[row*b.n + column] = b.a[column*b.rows + 2*k + row - column];
	free(b.a);
	return HAWSER_OK;
}

static void invert(double *y, const double *x, void *context)
{
	const struct band *b = context;

	memcpy(y, x, (size_t)b->n*sizeof *y);
	LAPACKE_dgbtrs(LAPACK_COL_MAJOR, 'N', b->n, b->k, b->k, 1, b->a, b->rows, b->pivot, y, b->n);
}

static enum hawser_status solve(struct hawser__ritz *ritz, const struct hawser_statics *statics,
                                enum hawser_plane plane, int N, int count,
                                struct hawser_report *report)
{
	int in_plane = plane == HAWSER_IN_PLANE, k = in_plane ? 3 : 1;
	struct band b = {.n = (in_plane ? 2 : 1)*(N - 1), .k = k, .rows = 3*k + 1};
	struct hawser__operator A = {.size = b.n, .apply = invert, .context = &b};
	enum hawser_status status = HAWSER_OK;

	b.a = calloc((size_t)b.n*(size_t)b.rows, sizeof *b.a);
	b.pivot = malloc((size_t)b.n*sizeof *b.pivot);
	if (!b.a || !b.pivot) {
		status = hawser__no_memory(report, "modes");
		goto done;
	}
	assemble(&b, statics, plane, N);
	if (LAPACKE_dgbtrf(LAPACK_COL_MAJOR, b.n, b.n, k, k, b.a, b.rows, b.pivot))
		status = hawser__fail(report, HAWSER_ERR_NAN, "modes",
		                      "the finite-difference matrix of %d points is singular or has "
		                      "a not-a-number: take another basis, or the method spectral",
		                      N - 1);
	if (!status)
		status = hawser__krylov(ritz, &A, count, report);
done:
	free(b.a);
	free(b.pivot);
	return status;
}

/* The slopes are derived from the shapes by interpolation, since this method has no strains. */
enum hawser_status hawser__fdm_sample(double *shape, double *slope, const struct hawser_grid *grid,
                                      const double *x, const struct hawser_statics *statics,
                                      enum hawser_plane plane, int N, struct hawser_report *report)
{
	int D = plane == HAWSER_IN_PLANE ? 2 : 1, first = plane == HAWSER_IN_PLANE ? 0 : 2;
	double *value = calloc((size_t)D*((size_t)N + 1), sizeof *value);

	if (!value)
		return hawser__no_memory(report, "modes");
	memcpy(value + D, x, (size_t)(D*(N - 1))*sizeof *value);
	for (int i = 0; i < grid->points; i++, shape += 3, slope += 3) {
		double t = grid->s[i]*N/statics->l, kappa = at(statics, grid->s[i]).kappa;

		for (int c = 0; c < D; c++) {
			shape[first + c] = hawser__six_points(&slope[first + c], value + c, N, D, t);
			slope[first + c] *= N/statics->l;
		}
		slope[0] -= kappa*shape[1];
		slope[1] += kappa*shape[0];
	}
	free(value);
	return HAWSER_OK;
}

enum hawser_status hawser__fdm_solve(struct hawser_modes *modes,
                                     const struct hawser_statics *statics,
                                     const struct hawser_modes_options *options,
                                     struct hawser_report *report)
{
	static const struct hawser__scheme scheme = {1, solve, hawser__fdm_sample};

	return hawser__halving_solve(modes, statics, options, &scheme, report);
}
