/* response/locus_hill.c - Hill's matrix, its null vectors, and the Jacobian of the orbit; see locus.h.
 *
 * Rows and columns are divided by the scales of hill_matrix.c, so that the borders are of the size of
 * the matrix. The Jacobian follows from the blocks of kappa = 0, since cos and sin are sums of two
 * exponentials.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "response/locus.h"

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
}

/* Entry e of the complex coefficient d of a series. */
static double complex coefficient(const double *series, int width, int n2, int d, int e)
{
	int k = d < 0 ? -d : d;
	double im;

	if (k > width)
		return 0.0;
	if (k == 0)
		return 0.5*series[e];
	im = 0.5*series[(size_t)2*k*n2 + e];
	return 0.5*series[(size_t)(2*k - 1)*n2 + e] + (d > 0 ? -I : I)*im;
}

static double complex entry(const struct hawser__locus *locus, int m, int l, int i, int j, double kappa)
{
	int n = locus->n, n2 = n*n, e = i*n + j, d = m - l;
	double lk = l + kappa;
	double complex x = coefficient(locus->T, locus->width, n2, d, e);

	if (d == 0 || locus->varying_damping)
		x += I*locus->omega*lk*coefficient(locus->D, locus->width, n2, d, e);
	if (d == 0 && i == j)
		x -= lk*lk*locus->omega*locus->omega;
	return x;
}

static void set_scale(struct hawser__locus *locus, int low, int blocks, double kappa)
{
	int n = locus->n;
	double least = locus->omega*locus->omega;

	for (int k = 0; k < blocks; k++)
		for (int j = 0; j < n; j++) {
			double own = 0.5*fabs(locus->T[(size_t)j*(n + 1)]), q = (low + k + kappa)*locus->omega;

			locus->scale[k*n + j] = 1.0/sqrt(fmax(own, least) + q*q);
		}
}

int hawser__locus_hill(struct hawser__locus *locus, double kappa, int bordered)
{
	int half = kappa == 0.5 && (!bordered || locus->kind == HAWSER_PERIOD_DOUBLING);
	int n = locus->n, low = -locus->order - half;
	int blocks = 2*locus->order + 1 + half, wide = blocks*n, row = wide + bordered;

	set_scale(locus, low, blocks, kappa);
	for (int l = 0; l < blocks; l++)
		for (int j = 0; j < n; j++) {
			double complex *column = locus->A + (size_t)(l*n + j)*row;

			for (int k = 0; k < wide; k++)
				column[k] = locus->scale[k]*locus->scale[l*n + j]*
				            entry(locus, low + k/n, low + l, k%n, j, kappa);
			if (bordered)
				column[wide] = conj(locus->c[l*n + j]);
		}
	for (int k = 0; bordered && k < wide; k++)
		locus->A[(size_t)wide*row + k] = locus->b[k];
	if (bordered)
		locus->A[(size_t)wide*row + wide] = 0.0;
	return row;
}

double hawser__locus_determinant(struct hawser__locus *locus, double kappa, double *sign)
{
	int row = hawser__locus_hill(locus, kappa, 0);
	double complex phase = 1.0;
	double size = 0.0;

	if (LAPACKE_zgetrf_work(LAPACK_COL_MAJOR, row, row, locus->A, row, locus->pivot) < 0)
		return NAN;
	locus->solves++;
	for (int k = 0; k < row; k++) {
		double complex x = locus->A[(size_t)k*row + k];

		size += log(cabs(x));
		phase *= x/cabs(x)*(locus->pivot[k] != k + 1 ? -1.0 : 1.0);
	}
	*sign = creal(phase) < 0.0 ? -1.0 : 1.0;
	return size;
}

void hawser__locus_jacobian(struct hawser__locus *locus)
{
	int n = locus->n, P = locus->coefficients, H = locus->order;

	for (int l = 0; l <= H; l++)
		for (int h = 0; h <= H; h++)
			for (int e = 0; e < n*n; e++) {
				int i = e/n, j = e%n;
				double complex a = entry(locus, h, l, i, j, 0.0);
				double complex b = l ? entry(locus, h, -l, i, j, 0.0) : 0.0;
				double part = h ? 1.0 : 0.5;
				double complex even = part*(l ? a + b : 2.0*a), odd = part*(a - b);
				double *column = locus->J + (size_t)((l ? 2*l - 1 : 0)*n + j)*P;
				double *next = locus->J + (size_t)(2*l*n + j)*P;

				column[(h ? 2*h - 1 : 0)*n + i] = creal(even);
				if (h)
					column[2*h*n + i] = -cimag(even);
				if (l)
					next[(h ? 2*h - 1 : 0)*n + i] = cimag(odd);
				if (l && h)
					next[2*h*n + i] = creal(odd);
			}
	for (int i = 0; i < P; i++)
		for (int j = 0; hawser__locus_is_barred(locus, i) && j < P; j++)
			locus->J[(size_t)j*P + i] = i == j;
}

/* exp(i (m + kappa) tau) at the samples. */
static void exponentials(struct hawser__locus *locus)
{
	for (int r = 0; r < locus->rows; r++) {
		double tau = 2.0*M_PI*r/locus->rows;

		for (int k = 0; k < locus->blocks; k++)
			locus->exponential[(size_t)r*locus->blocks + k] =
				cexp(I*fmod((locus->low + k + locus->kappa)*tau, 2.0*M_PI));
	}
}

/* x [rows][n] = signal of the coefficients [wide]. */
static void signal(const struct hawser__locus *locus, double complex *x, const double complex *wave)
{
	const double complex one = 1.0, none = 0.0;

	cblas_zgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, locus->rows, locus->n, locus->blocks, &one,
	            locus->exponential, locus->blocks, wave, locus->n, &none, x, locus->n);
}

int hawser__locus_vectors(struct hawser__locus *locus)
{
	int wide = locus->wide, n = locus->n, row = hawser__locus_hill(locus, locus->kappa, 1);

	if (LAPACKE_zgetrf_work(LAPACK_COL_MAJOR, row, row, locus->A, row, locus->pivot) != 0)
		return 1;
	locus->solves++;
	memset(locus->v, 0, (size_t)row*sizeof *locus->v);
	memset(locus->w, 0, (size_t)row*sizeof *locus->w);
	locus->v[wide] = locus->w[wide] = 1.0;
	LAPACKE_zgetrs_work(LAPACK_COL_MAJOR, 'N', row, 1, locus->A, row, locus->pivot, locus->v, row);
	LAPACKE_zgetrs_work(LAPACK_COL_MAJOR, 'C', row, 1, locus->A, row, locus->pivot, locus->w, row);
	locus->g = locus->v[wide];
	if (locus->kind != HAWSER_TORUS)
		locus->g = creal(locus->g);
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
