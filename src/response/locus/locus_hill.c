/* response/locus/locus_hill.c - Hill's matrix, its null vectors, and the Jacobian of the orbit; see
 * locus.h.
 *
 * Rows and columns are divided by the scales of hill_matrix.c, so that the borders are of the size of
 * the matrix. Of the real kinds H is brought to its real form, which is factorised in a quarter of the
 * time. The Jacobian of the orbit is the real form of kappa = 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/determinant.h"
#include "response/locus/locus.h"

/* Complex coefficients of a series, d >= 0 */
static void to_complex(double complex *out, const double *series, int width, int n2)
{
	for (int e = 0; e < n2; e++)
		out[e] = 0.5*series[e];
	for (int d = 1; d <= width; d++)
		for (int e = 0; e < n2; e++)
			out[(size_t)d*n2 + e] = 0.5*series[(size_t)(2*d - 1)*n2 + e] -
			                        0.5*I*series[(size_t)2*d*n2 + e];
}

void hawser__locus_series(struct hawser__locus *locus)
{
	int n2 = locus->n*locus->n, columns = 2*locus->width + 1;

	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, columns, n2, locus->rows, 2.0/locus->rows,
	            locus->basis, columns, locus->tangent, n2, 0.0, locus->T, n2);
	memset(locus->D, 0, (size_t)columns*n2*sizeof(double));
	if (locus->varying_damping)
		cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, columns, n2, locus->rows,
		            2.0/locus->rows, locus->basis, columns, locus->damping, n2, 0.0, locus->D, n2);
	else
		cblas_daxpy(n2, 2.0, locus->rom->D, 1, locus->D, 1);
	hawser__locus_resist(locus);
	to_complex(locus->T_c, locus->T, locus->width, n2);
	to_complex(locus->D_c, locus->D, locus->width, n2);
}

/* out [n][n] = block of the row m and the column l, from the coefficients m - l. */
static void block(const struct hawser__locus *locus, double complex *out, int m, int l, double kappa)
{
	int n = locus->n, n2 = n*n, d = m - l, k = abs(d);
	const double complex *T = locus->T_c + (size_t)k*n2, *D = locus->D_c + (size_t)k*n2;
	const double complex rate = d && !locus->varying_damping ? 0.0 : I*(locus->omega*(l + kappa));

	if (k > locus->width) {
		memset(out, 0, (size_t)n2*sizeof *out);
		return;
	}
	if (d < 0)
		for (int e = 0; e < n2; e++)
			out[e] = conj(T[e]) + rate*conj(D[e]);
	else
		for (int e = 0; e < n2; e++)
			out[e] = T[e] + rate*D[e];
	for (int i = 0; d == 0 && i < n; i++)
		out[i*(n + 1)] -= cimag(rate)*cimag(rate);
}

/* Where kappa is 0 or 1/2, harmonics m and -m - 2 kappa are a pair. In their cosines and sines,
 * (x_m + its partner)/sqrt(2) and i (x_m - its partner)/sqrt(2), H is real. */
static int single(int m, double kappa)
{
	return m == 0 && kappa == 0.0;
}
static int place_of(int m, double kappa, int n)
{
	return single(m, kappa) ? 0 : (2*m - (kappa == 0.0))*n;
}

/* The real form of H in `to`, column-major with `leading` rows; returns its size. */
static int real_form(struct hawser__locus *locus, double *to, int leading, double kappa)
{
	int n = locus->n, n2 = n*n, H = locus->order, partner = -(int)(2.0*kappa);
	double complex *e = locus->pair, *f = e + n2;

	for (int l = 0; l <= H; l++)
		for (int m = 0; m <= H; m++) {
			int one_m = single(m, kappa), one_l = single(l, kappa), row = place_of(m, kappa, n);
			double part = (one_m ? M_SQRT1_2 : 1.0)*(one_l ? M_SQRT1_2 : 1.0);

			block(locus, e, m, l, kappa);
			block(locus, f, m, partner - l, kappa);
			for (int j = 0; j < n; j++) {
				double *column = to + (size_t)(place_of(l, kappa, n) + j)*leading + row;
				double *next = column + (size_t)n*leading;

				for (int i = 0; i < n; i++) {
					double complex sum = part*(e[i*n + j] + f[i*n + j]);
					double complex gap = part*(e[i*n + j] - f[i*n + j]);

					column[i] = creal(sum);
					if (!one_m)
						column[n + i] = -cimag(sum);
					if (!one_l)
						next[i] = cimag(gap);
					if (!one_l && !one_m)
						next[n + i] = creal(gap);
				}
			}
		}
	return place_of(H, kappa, n) + (single(H, kappa) ? n : 2*n);
}

/* The real form x of complex coefficients with conjugate symmetry, and back. */
static void to_real(const struct hawser__locus *locus, double *x, const double complex *wave)
{
	int n = locus->n;

	for (int m = 0; m <= locus->order; m++)
		for (int j = 0; j < n; j++) {
			double complex at = wave[(m - locus->low)*n + j];
			double *to = x + place_of(m, locus->kappa, n) + j;

			if (single(m, locus->kappa)) {
				*to = creal(at);
				continue;
			}
			to[0] = M_SQRT2*creal(at);
			to[n] = -M_SQRT2*cimag(at);
		}
}
static void from_real(const struct hawser__locus *locus, double complex *wave, const double *x)
{
	int n = locus->n, partner = -(int)(2.0*locus->kappa);

	for (int m = 0; m <= locus->order; m++)
		for (int j = 0; j < n; j++) {
			const double *at = x + place_of(m, locus->kappa, n) + j;
			double complex value;

			value = single(m, locus->kappa) ? *at : M_SQRT1_2*(at[0] - I*at[n]);
			wave[(m - locus->low)*n + j] = value;
			wave[(partner - m - locus->low)*n + j] = conj(value);
		}
}

/* Its scales in the order of the real form. */
static void scale_real(const struct hawser__locus *locus, double *to, double kappa)
{
	int n = locus->n;
	double least = locus->omega*locus->omega;

	for (int m = 0; m <= locus->order; m++)
		for (int j = 0; j < n; j++) {
			double own = 0.5*fabs(locus->T[(size_t)j*(n + 1)]), q = (m + kappa)*locus->omega;
			double *at = to + place_of(m, kappa, n) + j;

			at[0] = 1.0/sqrt(fmax(own, least) + q*q);
			if (!single(m, kappa))
				at[n] = at[0];
		}
}

static int scaled_real(struct hawser__locus *locus, double kappa, int bordered)
{
	int wide = locus->n*(2*locus->order + 1 + (kappa != 0.0)), row = wide + bordered;

	real_form(locus, locus->R, row, kappa);
	scale_real(locus, locus->x, kappa);
	for (int j = 0; j < wide; j++)
		for (int i = 0; i < wide; i++)
			locus->R[(size_t)j*row + i] *= locus->x[j]*locus->x[i];
	return row;
}

static void set_scale(struct hawser__locus *locus, double kappa)
{
	int n = locus->n;
	double least = locus->omega*locus->omega;

	for (int k = 0; k < locus->wide; k++) {
		double own = 0.5*fabs(locus->T[(size_t)(k%n)*(n + 1)]);
		double q = (locus->low + k/n + kappa)*locus->omega;

		locus->scale[k] = 1.0/sqrt(fmax(own, least) + q*q);
	}
}

int hawser__locus_hill(struct hawser__locus *locus, double kappa, int bordered)
{
	int n = locus->n, blocks = locus->blocks, wide = locus->wide, row = wide + bordered;

	set_scale(locus, kappa);
	for (int l = 0; l < blocks; l++)
		for (int k = 0; k < blocks; k++) {
			block(locus, locus->pair, locus->low + k, locus->low + l, kappa);
			for (int j = 0; j < n; j++)
				for (int i = 0; i < n; i++)
					locus->A[(size_t)(l*n + j)*row + k*n + i] =
						locus->scale[k*n + i]*locus->scale[l*n + j]*locus->pair[i*n + j];
		}
	for (int k = 0; bordered && k < wide; k++) {
		locus->A[(size_t)k*row + wide] = conj(locus->c[k]);
		locus->A[(size_t)wide*row + k] = locus->b[k];
	}
	if (bordered)
		locus->A[(size_t)wide*row + wide] = 0.0;
	return row;
}

double hawser__locus_determinant(struct hawser__locus *locus, double kappa, double *sign)
{
	int row = scaled_real(locus, kappa, 0);

	if (LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, row, row, locus->R, row, locus->pivot) < 0)
		return NAN;
	locus->solves++;
	return hawser__determinant(sign, locus->R, locus->pivot, row);
}

void hawser__locus_jacobian(struct hawser__locus *locus)
{
	int n = locus->n, P = locus->coefficients;

	/* coefficients of the cosines are sqrt(2) times those of the real form, the constant is itself */
	real_form(locus, locus->J, P, 0.0);
	for (int j = 0; j < n; j++) {
		cblas_dscal(P - n, M_SQRT2, locus->J + (size_t)j*P + n, 1);
		cblas_dscal(P - n, M_SQRT1_2, locus->J + (size_t)n*P + j, P);
	}
	for (int i = 0; i < P; i++)
		for (int j = 0; hawser__locus_is_barred(locus, i) && j < P; j++)
			locus->J[(size_t)j*P + i] = i == j;
}

/* exp(i (m + kappa) tau) at the samples. */
static void exponentials(struct hawser__locus *locus)
{
	for (int r = 0; r < locus->rows; r++) {
		const double *at = locus->basis + (size_t)r*(2*locus->width + 1);
		double tau = 2.0*M_PI*r/locus->rows;
		double complex turn = cexp(I*locus->kappa*tau);

		for (int k = 0; k < locus->blocks; k++) {
			int m = locus->low + k, h = abs(m);
			double sine = m < 0 ? -at[2*h] : at[2*h];

			locus->exponential[(size_t)r*locus->blocks + k] =
				m ? turn*(at[2*h - 1] + I*sine) : turn;
		}
	}
}

/* x [rows][n] = signal of the coefficients [wide]. */
static void signal(const struct hawser__locus *locus, double complex *x, const double complex *wave)
{
	const double complex one = 1.0, none = 0.0;

	cblas_zgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, locus->rows, locus->n, locus->blocks, &one,
	            locus->exponential, locus->blocks, wave, locus->n, &none, x, locus->n);
}

static int solve_complex(struct hawser__locus *locus)
{
	int wide = locus->wide, row = hawser__locus_hill(locus, locus->kappa, 1);

	if (LAPACKE_zgetrf_work(LAPACK_COL_MAJOR, row, row, locus->A, row, locus->pivot) != 0)
		return 1;
	memset(locus->v, 0, (size_t)row*sizeof *locus->v);
	memset(locus->w, 0, (size_t)row*sizeof *locus->w);
	locus->v[wide] = locus->w[wide] = 1.0;
	LAPACKE_zgetrs_work(LAPACK_COL_MAJOR, 'N', row, 1, locus->A, row, locus->pivot, locus->v, row);
	LAPACKE_zgetrs_work(LAPACK_COL_MAJOR, 'C', row, 1, locus->A, row, locus->pivot, locus->w, row);
	locus->g = locus->v[wide];
	return 0;
}

static int solve_real(struct hawser__locus *locus)
{
	int wide = locus->wide, row = scaled_real(locus, locus->kappa, 1);
	double *R = locus->R, *x = locus->x;

	to_real(locus, R + (size_t)wide*row, locus->b);
	to_real(locus, x, locus->c);
	for (int k = 0; k < wide; k++)
		R[(size_t)k*row + wide] = x[k];
	R[(size_t)wide*row + wide] = 0.0;
	if (LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, row, row, R, row, locus->pivot) != 0)
		return 1;
	for (int adjoint = 0; adjoint < 2; adjoint++) {
		memset(x, 0, (size_t)row*sizeof *x);
		x[wide] = 1.0;
		LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, adjoint ? 'T' : 'N', row, 1, R, row, locus->pivot, x,
		                    row);
		from_real(locus, adjoint ? locus->w : locus->v, x);
		locus->g = x[wide];
	}
	return 0;
}

int hawser__locus_vectors(struct hawser__locus *locus)
{
	int wide = locus->wide, n = locus->n;

	set_scale(locus, locus->kappa);
	if (locus->kind == HAWSER_TORUS ? solve_complex(locus) : solve_real(locus))
		return 1;
	locus->solves++;
	locus->dense += (locus->kind == HAWSER_TORUS ? 8.0 : 2.0)/3.0*pow(wide, 3.0);
	exponentials(locus);
	for (int k = 0; k < wide; k++)
		locus->wave[k] = locus->scale[k]*locus->w[k]/locus->rows;
	signal(locus, locus->wt, locus->wave);
	for (int k = 0; k < wide; k++)
		locus->wave[k] = locus->scale[k]*locus->v[k];
	signal(locus, locus->vt, locus->wave);
	for (int k = 0; k < wide; k++)
		locus->wave[k] *= I*(locus->low + k/n + locus->kappa);
	signal(locus, locus->dv, locus->wave);
	for (int k = 0; k < wide; k++)
		locus->wave[k] *= I*(locus->low + k/n + locus->kappa);
	signal(locus, locus->ddv, locus->wave);
	return 0;
}
