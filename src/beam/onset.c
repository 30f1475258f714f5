/* beam/onset.c - the equations of a stability boundary, as a bordered system:
 *
 *   [ Q(l; v, p)  b ] [x]   [0]          Q = l^2 M + l C + K
 *   [ c*          0 ] [g] = [1]
 *
 * The bordered matrix is regular where Q is singular, and g = 0 if and only if Q is singular. The
 * derivative is dg/dl = -y* Q_l x, where y solves the adjoint system. The boundary is therefore
 * the zero set of one or two smooth real functions of two or three unknowns, independent of the
 * number of modes. Reference for minimally augmented systems: Griewank and Reddien 1984;
 * Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, SIAM 2000. The Jacobian
 * of g is computed by central differences. Its error affects the rate of convergence only; g
 * itself is accurate to round-off.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define lapack_complex_double double complex
#include <cblas.h>
#include <lapacke.h>

#include "beam/boundary.h"
#include "core/report.h"

enum { ITERATIONS = 12 }; /* of Newton's method */
#define DIFFERENCE 1e-5   /* relative step of the central differences */
#define ENOUGH 1e-12      /* relative Newton step at which the iteration has converged */

enum hawser_status hawser__onset_open(struct hawser__onset_equation *e, enum hawser__onset onset,
                                      const struct hawser_beam_integrals *is,
                                      const struct hawser_beam_family *family,
                                      struct hawser_report *report)
{
	size_t n = (size_t)is->n, m = n + 1;

	*e = (struct hawser__onset_equation){.onset = onset, .is = is, .family = family, .n = is->n,
	                                     .unknowns = onset == HAWSER__STATIC ? 2 : 3,
	                                     .scale = {1.0, 1.0, 1.0}};
	e->M = malloc(3*n*n*sizeof *e->M);
	e->A = malloc((m*m + 4*m)*sizeof *e->A);
	e->pivot = malloc(m*sizeof *e->pivot);
	if (!e->M || !e->A || !e->pivot) {
		hawser__onset_clear(e);
		return hawser__no_memory(report, "beam");
	}
	e->b = e->A + m*m;
	e->c = e->b + m;
	e->x = e->c + m;
	e->y = e->x + m;
	return HAWSER_OK;
}

void hawser__onset_clear(struct hawser__onset_equation *e)
{
	free(e->M);
	free(e->A);
	free(e->pivot);
	memset(e, 0, sizeof *e);
}

void hawser__onset_border(struct hawser__onset_equation *e,
                          const struct hawser__beam_sample *sample, double complex l)
{
	int best = 0, n = e->n;
	double least = INFINITY;

	for (int i = 0; i < sample->found; i++) {
		double off = cabs(sample->value[i].re + I*sample->value[i].im - l);

		if (off < least) {
			least = off;
			best = i;
		}
	}
	for (int i = 0; i < n; i++) {
		const double *right = sample->right + (size_t)best*2*(size_t)n;
		const double *left = sample->left + (size_t)best*2*(size_t)n;

		e->c[i] = right[i] + I*right[n + i];
		e->b[i] = left[i] + I*left[n + i];
	}
}

static double complex eigenvalue(const struct hawser__onset_equation *e, const double *u)
{
	if (e->onset == HAWSER__STATIC)
		return 0.0;
	return e->onset == HAWSER__AXIS ? I*u[2]*e->scale[2] : u[2]*e->scale[2];
}

/* y* (2 l M + C) x */
static double complex by_l(const struct hawser__onset_equation *e, double complex l)
{
	size_t n = (size_t)e->n;
	double complex sum = 0.0;

	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < n; k++)
			sum += conj(e->y[i])*(2.0*l*e->M[i*n + k] + e->M[n*n + i*n + k])*e->x[k];
	return sum;
}

/* Residuals r [unknowns - 1] at u. Leaves x and y, from which update_borders() takes the new
 * borders. */
static enum hawser_status residual(double *r, struct hawser__onset_equation *e, const double *u,
                                   struct hawser_report *report)
{
	size_t n = (size_t)e->n, m = n + 1, square = n*n;
	double complex l = eigenvalue(e, u);
	struct hawser_beam beam;
	enum hawser_status status = e->family->at(&beam, e->family->context, u[0]*e->scale[0], report);

	if (status)
		return status;
	beam.speed = u[1]*e->scale[1];
	hawser_beam_matrices(e->M, e->M + square, e->M + 2*square, e->is, &beam);
	for (size_t i = 0; i < n; i++) {
		for (size_t k = 0; k < n; k++) {
			size_t at = i*n + k;

			e->A[k*m + i] = l*(l*e->M[at] + e->M[square + at]) + e->M[2*square + at];
		}
		e->A[n*m + i] = e->b[i];
		e->A[i*m + n] = conj(e->c[i]);
		e->x[i] = e->y[i] = 0.0;
	}
	e->A[n*m + n] = 0.0;
	e->x[n] = e->y[n] = 1.0;
	if (LAPACKE_zgetrf_work(LAPACK_COL_MAJOR, (int)m, (int)m, e->A, (int)m, e->pivot) != 0)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "beam",
		                    "the boundary's equation is singular at %.10g", u[0]*e->scale[0]);
	LAPACKE_zgetrs_work(LAPACK_COL_MAJOR, 'N', (int)m, 1, e->A, (int)m, e->pivot, e->x, (int)m);
	LAPACKE_zgetrs_work(LAPACK_COL_MAJOR, 'C', (int)m, 1, e->A, (int)m, e->pivot, e->y, (int)m);
	r[0] = creal(e->x[n]);
	if (e->onset == HAWSER__AXIS)
		r[1] = cimag(e->x[n]);
	else if (e->onset == HAWSER__DOUBLE)
		r[1] = -creal(by_l(e, l));
	return HAWSER_OK;
}

/* J [unknowns - 1][3] by central differences. */
static enum hawser_status jacobian(double J[2][3], struct hawser__onset_equation *e, const double *u,
                                   struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int k = 0; !status && k < e->unknowns; k++) {
		double at[3] = {u[0], u[1], u[2]}, h = DIFFERENCE*fmax(fabs(u[k]), 0.1);
		double up[2] = {0.0}, down[2] = {0.0};

		at[k] = u[k] + h;
		status = residual(up, e, at, report);
		at[k] = u[k] - h;
		if (!status && residual(down, e, at, NULL) == HAWSER_OK)
			h *= 2.0;
		else if (!status) /* end of the parameter's range: one-sided difference */
			status = residual(down, e, u, report);
		for (int i = 0; !status && i < e->unknowns - 1; i++)
			J[i][k] = (up[i] - down[i])/h;
	}
	return status;
}

/* Solve A z = r of order m <= 3 by LU after scaling of the rows. Returns 0 if A is singular. */
static int solve_small(double *z, const double A[3][3], const double *r, int m)
{
	double copy[9], right[3];
	int pivot[3];

	for (int i = 0; i < m; i++) {
		double size = 0.0;

		for (int k = 0; k < m; k++)
			size = fmax(size, fabs(A[i][k]));
		if (!(size > 0.0))
			return 0;
		for (int k = 0; k < m; k++)
			copy[k*m + i] = A[i][k]/size;
		right[i] = r[i]/size;
	}
	if (LAPACKE_dgesv_work(LAPACK_COL_MAJOR, m, 1, copy, m, pivot, right, m) != 0)
		return 0;
	memcpy(z, right, (size_t)m*sizeof *z);
	return 1;
}

static void update_borders(struct hawser__onset_equation *e)
{
	double a = cblas_dznrm2(e->n, e->x, 1), b = cblas_dznrm2(e->n, e->y, 1);

	for (int i = 0; i < e->n; i++) {
		e->c[i] = e->x[i]/a;
		e->b[i] = e->y[i]/b;
	}
}

enum hawser_status hawser__onset_correct(struct hawser__onset_equation *e, double *u,
                                         const double *normal, int *iterations,
                                         struct hawser_report *report)
{
	double size = INFINITY;
	enum hawser_status status = HAWSER_OK;

	for (*iterations = 0; *iterations < ITERATIONS; ++*iterations) {
		double J[2][3], A[3][3], r[3] = {0.0}, z[3], before = size;
		int m = e->unknowns;

		status = jacobian(J, e, u, report);
		if (!status)
			status = residual(r, e, u, report);
		if (status)
			return status;
		r[m - 1] = 0.0;
		for (int k = 0; k < m; k++) {
			for (int i = 0; i < m - 1; i++)
				A[i][k] = J[i][k];
			A[m - 1][k] = normal[k];
		}
		if (!solve_small(z, (const double (*)[3])A, r, m))
			break;
		size = 0.0;
		for (int k = 0; k < m; k++) {
			u[k] -= normal[k] == 1.0 ? 0.0 : z[k]; /* a held unknown keeps its exact value */
			size = fmax(size, fabs(z[k])/(0.01 + fabs(u[k])));
		}
		if (!isfinite(size) || size > 0.5)
			break;
		if (size < ENOUGH || (size < 1e-9 && size > 0.3*before)) {
			status = residual(r, e, u, report);
			if (!status)
				update_borders(e);
			return status;
		}
	}
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "beam", *iterations, size,
	                       "the boundary was lost near the parameter %.10g, speed %.10g",
	                       u[0]*e->scale[0], u[1]*e->scale[1]);
}

enum hawser_status hawser__onset_tangent(struct hawser__onset_equation *e, double *tangent,
                                         const double *u, struct hawser_report *report)
{
	double J[2][3] = {{0.0}}, size = 0.0;
	enum hawser_status status = jacobian(J, e, u, report);

	if (status)
		return status;
	if (e->unknowns == 2) {
		tangent[0] = -J[0][1];
		tangent[1] = J[0][0];
		tangent[2] = 0.0;
	} else {
		tangent[0] = J[0][1]*J[1][2] - J[0][2]*J[1][1];
		tangent[1] = J[0][2]*J[1][0] - J[0][0]*J[1][2];
		tangent[2] = J[0][0]*J[1][1] - J[0][1]*J[1][0];
	}
	for (int k = 0; k < 3; k++)
		size = hypot(size, tangent[k]);
	if (!(size > 0.0 && isfinite(size)))
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "beam",
		                    "the boundary has no unique tangent at the parameter %.10g, speed %.10g",
		                    u[0]*e->scale[0], u[1]*e->scale[1]);
	for (int k = 0; k < 3; k++)
		tangent[k] /= size;
	return HAWSER_OK;
}
