/* response/locus/locus_second.c - derivatives of the condition g, and normal forms; see locus.h.
 *
 *   D_x T    derivative of the tangent along the signal x, from a central difference, which is exact
 *            for the cubic model
 *   q        (D_v T)^T conj(w): since f'' is symmetric, the gradient of - g by the orbit
 *
 * The derivatives by Omega and the parameter are central differences of the defects and of w^H H v
 * between two models. They are needed for the Jacobian only: the points do not depend on them. By Omega
 * all terms are polynomials of low degree.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "core/determinant.h"
#include "response/locus/locus.h"
#include "rom/energy/kernel.h"

#define DIFFERENCE 1e-2 /* increment of the orbit, relative; chosen for models with the exact energy */
#define NUDGE 1e-4      /* of the parameters, relative to their ranges; chosen */
#define NEAR 8.0        /* a value of the parameter for which models are kept, in nudges; chosen */

static double largest(const double *x, int count)
{
	return fabs(x[cblas_idamax(count, x, 1)]);
}

double hawser__locus_both_sides(struct hawser__locus *locus, const double *x, int imaginary)
{
	int count = locus->rows*locus->n;
	double size = largest(x, count), h;
	double own = largest(locus->u, count);

	if (!(size > 0.0))
		return 0.0;
	h = DIFFERENCE*(own > 0.0 ? own : 1.0)/size;
	for (int sign = 1; sign >= -1; sign -= 2) {
		double *tangent = sign > 0 ? locus->plus : locus->minus;

		memcpy(locus->shifted, locus->u, (size_t)count*sizeof(double));
		cblas_daxpy(count, sign*h, x, 1, locus->shifted, 1);
		hawser__rom_tangents(locus->rom, locus->force, tangent, locus->shifted, locus->rows,
		                     locus->work);
		for (int k = 0; locus->more && k < count; k++)
			locus->shifted_v[k] = locus->du[k] + sign*h*(imaginary ? cimag(locus->dv[k])
			                                             : creal(locus->dv[k]));
		hawser__locus_terms(locus, tangent, sign > 0 ? locus->plus_v : locus->minus_v,
		                    locus->shifted, locus->shifted_v);
	}
	return h;
}

/* q += factor (D_x T)^T conj(w), with x the real or the imaginary part of v. */
static void add_part(struct hawser__locus *locus, int imaginary, double complex factor)
{
	int n = locus->n, rows = locus->rows;
	double *x = locus->force + (size_t)rows*n; /* behind the forces */
	double h;

	for (int k = 0; k < rows*n; k++)
		x[k] = imaginary ? cimag(locus->vt[k]) : creal(locus->vt[k]);
	h = hawser__locus_both_sides(locus, x, imaginary);
	if (h > 0.0)
		hawser__locus_by_velocities(locus, factor, h);
	for (int r = 0; h > 0.0 && r < rows; r++)
		for (int j = 0; j < n; j++) {
			const double *p = locus->plus + ((size_t)r*n + j)*n;
			const double *m = locus->minus + ((size_t)r*n + j)*n;
			double complex w = factor*conj(locus->wt[(size_t)r*n + j])/(2.0*h);

			for (int k = 0; k < n; k++)
				locus->q[(size_t)r*n + k] += (p[k] - m[k])*w;
		}
}

/* g_y, and w f''(v, v). */
static void by_orbit(struct hawser__locus *locus)
{
	int n = locus->n, rows = locus->rows, columns = 2*locus->width + 1;

	memset(locus->q, 0, (size_t)rows*n*sizeof *locus->q);
	memset(locus->q_v, 0, (size_t)rows*n*sizeof *locus->q_v);
	memset(locus->g_y, 0, (size_t)locus->coefficients*sizeof *locus->g_y);
	add_part(locus, 0, 1.0);
	if (locus->kind == HAWSER_TORUS)
		add_part(locus, 1, I);
	for (int r = 0; r < rows; r++)
		for (int h = 0; h < 2*locus->order + 1; h++) {
			double s = -locus->basis[(size_t)r*columns + h];

			for (int j = 0; j < n; j++)
				locus->g_y[h*n + j] += s*locus->q[(size_t)r*n + j];
		}
	locus->second = 0.0;
	for (int k = 0; k < rows*n; k++)
		locus->second += creal(locus->q[k]*locus->vt[k] + locus->q_v[k]*locus->dv[k]);
}

/* w^H H v with the present fields, or - G of a resonance. */
static double complex form(struct hawser__locus *locus, const double *z)
{
	int n = locus->n;
	double complex sum = 0.0;

	if (locus->kind == HAWSER_RESONANCE)
		return -hawser__locus_in_phase(locus, z);
	for (int r = 0; r < locus->rows; r++)
		for (int i = 0; i < n; i++) {
			size_t at = (size_t)r*n + i;
			const double *T = locus->tangent + at*n, *D = locus->damping + at*n;
			double complex x = locus->omega*locus->omega*locus->ddv[at];

			for (int j = 0; j < n; j++)
				x += T[j]*locus->vt[(size_t)r*n + j] + locus->omega*D[j]*locus->dv[(size_t)r*n + j];
			sum += conj(locus->wt[at])*x;
		}
	return sum;
}

/* The derivative of g by kappa: - w^H (i omega D v + 2 i omega^2 v'). Divided by i omega it is that of
 * the eigenvalue, which vanishes at a double multiplier. */
static double complex by_kappa(const struct hawser__locus *locus)
{
	int n = locus->n;
	double complex sum = 0.0;

	for (int r = 0; r < locus->rows; r++)
		for (int i = 0; i < n; i++) {
			size_t at = (size_t)r*n + i;
			const double *D = locus->damping + at*n;
			double complex x = 2.0*locus->omega*locus->dv[at];

			for (int j = 0; j < n; j++)
				x += D[j]*locus->vt[(size_t)r*n + j];
			sum += conj(locus->wt[at])*x;
		}
	return -I*locus->omega*sum;
}

/* by[k] and g_p[k], k Omega or the parameter. Where there is no model on one side, from the other. The
 * models of other values of the parameter, which may have to be made from a scene, stay the same while
 * the parameter is near. */
static enum hawser_status by_parameter(struct hawser__locus *locus, int k, const double *z,
                                       double complex here)
{
	double h = NUDGE*locus->extent[k], at[2] = {z[0], z[1]}, place[2] = {z[k], z[k]};
	int made = locus->plane || k == LOCUS_PARAMETER;
	double complex value[2] = {here, here};
	enum hawser_status status;

	for (int i = locus->plane ? 0 : 1; made && i < 2; i++) {
		if (!(fabs(z[i] - locus->centre[i]) <= NEAR*NUDGE*locus->extent[i]))
			locus->centre[i] = z[i];
		at[i] = locus->centre[i];
	}
	for (int side = 0; side < 2; side++) {
		at[k] = (made ? locus->centre[k] : z[k]) + (side ? h : -h);
		if (hawser__locus_place(locus, at[0], at[1])) {
			memcpy(locus->other[side], locus->F,
			       (2*(size_t)locus->width + 1)*locus->n*sizeof(double));
			continue;
		}
		hawser__locus_fields(locus, locus->other[side], z, locus->kind != HAWSER_RESONANCE);
		value[side] = form(locus, z);
		place[side] = at[k];
	}
	if ((status = hawser__locus_place(locus, z[0], z[1])))
		return status;
	for (int i = 0; i < locus->coefficients; i++)
		locus->by[k][i] = (locus->other[1][i] - locus->other[0][i])/(place[1] - place[0]);
	locus->g_p[k] = -(value[1] - value[0])/(place[1] - place[0]);
	return HAWSER_OK;
}

enum hawser_status hawser__locus_differentiate(struct hawser__locus *locus, const double *z)
{
	double complex here = form(locus, z);
	enum hawser_status status;

	if (locus->kind != HAWSER_RESONANCE)
		locus->g_kappa = by_kappa(locus);
	status = by_parameter(locus, 0, z, here);
	if (!status)
		status = by_parameter(locus, 1, z, here);
	if (!status && locus->kind != HAWSER_RESONANCE)
		by_orbit(locus);
	return status;
}

void hawser__locus_transform(const struct hawser__locus *locus, double *out, const double *x)
{
	int n = locus->n, columns = 2*locus->width + 1;

	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, 2*locus->order + 1, n, locus->rows,
	            2.0/locus->rows, locus->basis, columns, x, n, 0.0, out, n);
	cblas_dscal(n, 0.5, out, 1);
}

/* J_factors: J. Returns the sign of the determinant, 0 if singular. */
static double factor(struct hawser__locus *locus, double *size_log)
{
	int row = locus->coefficients;
	double sign;

	*size_log = 0.0;
	memcpy(locus->J_factors, locus->J, (size_t)row*row*sizeof(double));
	if (LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, row, row, locus->J_factors, row, locus->pivot) != 0)
		return 0.0;
	locus->solves++;
	*size_log = hawser__determinant(&sign, locus->J_factors, locus->pivot, row);
	return sign;
}

double hawser__locus_normal_form(struct hawser__locus *locus, double *sign, double *size_log)
{
	int n = locus->n, rows = locus->rows, row = locus->coefficients, columns = 2*locus->width + 1;
	double *x = locus->force + (size_t)rows*n, *answer = locus->rhs, h, third = 0.0, cross = 0.0;
	double size = 0.0;

	*sign = factor(locus, size_log);
	if (*sign == 0.0)
		return NAN;
	if (locus->kind == HAWSER_RESONANCE)
		return NAN;
	if (locus->kind == HAWSER_TORUS)
		return hawser__locus_lyapunov(locus);
	for (int k = 0; k < rows*n; k++) {
		x[k] = creal(locus->vt[k]);
		size += x[k]*x[k];
	}
	/* the tangent at the orbit itself, in locus->tangent */
	hawser__rom_tangents(locus->rom, locus->force, locus->tangent, locus->u, rows, locus->work);
	hawser__locus_terms(locus, locus->tangent, locus->slope, locus->u, locus->du);
	if (!((h = hawser__locus_both_sides(locus, x, 0)) > 0.0))
		return NAN;
	for (int r = 0; r < rows; r++)
		for (int i = 0; i < n; i++) {
			size_t at = (size_t)r*n + i;
			double two = 0.0, three = 0.0;

			for (int j = 0; j < n; j++) {
				double p = locus->plus[at*n + j], m = locus->minus[at*n + j];

				two += (p - m)*x[(size_t)r*n + j];
				three += (p + m - 2.0*locus->tangent[at*n + j])*x[(size_t)r*n + j];
			}
			for (int j = 0; locus->more && j < n; j++) {
				double p = locus->plus_v[at*n + j], m = locus->minus_v[at*n + j];
				double y = locus->omega*creal(locus->dv[(size_t)r*n + j]);

				two += (p - m)*y;
				three += (p + m - 2.0*locus->slope[at*n + j])*y;
			}
			locus->shifted[at] = -two/(2.0*h);
			third += creal(locus->wt[at])*three/(h*h);
		}
	hawser__locus_transform(locus, answer, locus->shifted);
	for (int i = 0; i < row; i++)
		answer[i] *= !hawser__locus_is_barred(locus, i);
	LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', row, 1, locus->J_factors, row, locus->pivot, answer,
	                    row);
	for (int r = 0; r < rows; r++)
		for (int k = 0; k < 2*locus->order + 1; k++)
			for (int j = 0; j < n; j++)
				cross += creal(locus->q[(size_t)r*n + j])*answer[k*n + j]*
				         locus->basis[(size_t)r*columns + k];
	cross += creal(hawser__locus_through_velocities(locus, answer));
	return (third + 3.0*cross)/size;
}
