/* response/locus/locus_sample.c - forces and tangents at samples of the period, see locus.h; the
 * numbers of a point, see locus_walk.h.
 *
 * With rows >= 5 order + 8 samples, no product of three harmonics is aliased to harmonics up to
 * 2 order, which the defect needs: its harmonics beyond `order` estimate the truncation error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <string.h>

#include "response/locus/locus_walk.h"
#include "rom/energy/kernel.h"

enum hawser_status hawser__locus_place(struct hawser__locus *locus, double omega, double parameter)
{
	const struct hawser_rom_plane *plane = locus->plane;
	const double p[2] = {omega, parameter};
	enum hawser_status status = plane ? plane->model(plane->context, &locus->rom, p, locus->report)
		: locus->family->model(locus->family->context, &locus->rom, parameter, locus->report);

	if (!status)
		locus->omega = plane ? plane->omega*locus->rom->time : omega*locus->rom->time/locus->time;
	return status;
}

void hawser__locus_orbit(struct hawser__locus *locus, const double *z)
{
	const double *y = z + LOCUS_FIRST;
	int n = locus->n, columns = 2*locus->width + 1;

	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, locus->rows, n, 2*locus->order + 1, 1.0,
	            locus->basis, columns, y, n, 0.0, locus->u, n);
	memset(locus->du, 0, (size_t)locus->rows*n*sizeof(double));
	for (int h = 1; h <= locus->order; h++)
		for (int r = 0; r < locus->rows; r++) {
			const double *at = locus->basis + (size_t)r*columns + 2*h - 1;

			for (int j = 0; j < n; j++)
				locus->du[(size_t)r*n + j] +=
					h*(y[2*h*n + j]*at[0] - y[(2*h - 1)*n + j]*at[1]);
		}
}

static void multiply(double *out, const double *matrix, const double *x, double factor, int n)
{
	cblas_dgemv(CblasRowMajor, CblasNoTrans, n, n, factor, matrix, n, x, 1, 1.0, out, 1);
}

/* The terms of a harmonic at sample r. */
static void add_harmonic(struct hawser__locus *locus, const struct hawser_harmonic *harmonic, int r,
                         int derive)
{
	int n = locus->n, n2 = n*n;
	double tau = 2.0*M_PI*((double)((long)r*harmonic->k%locus->rows)/locus->rows);
	double s = pow(locus->omega, harmonic->omega_power)*
	           (harmonic->phase == HAWSER_COS ? cos(tau) : sin(tau));
	double *force = locus->force + (size_t)r*n;

	if (harmonic->f)
		cblas_daxpy(n, -s, harmonic->f, 1, force, 1);
	if (harmonic->K)
		multiply(force, harmonic->K, locus->u + (size_t)r*n, s, n);
	if (harmonic->D)
		multiply(force, harmonic->D, locus->du + (size_t)r*n, s*locus->omega, n);
	if (derive && harmonic->K)
		cblas_daxpy(n2, s, harmonic->K, 1, locus->tangent + (size_t)r*n2, 1);
	if (harmonic->D && locus->varying_damping)
		cblas_daxpy(n2, s, harmonic->D, 1, locus->damping + (size_t)r*n2, 1);
}

void hawser__locus_fields(struct hawser__locus *locus, double *F, const double *z, int derive)
{
	const struct hawser_rom *rom = locus->rom;
	const double *y = z + LOCUS_FIRST;
	int n = locus->n, n2 = n*n, rows = locus->rows, columns = 2*locus->width + 1;

	hawser__rom_tangents(rom, locus->force, derive ? locus->tangent : NULL, locus->u, rows,
	                     locus->work);
	hawser__locus_terms(locus, derive ? locus->tangent : NULL, locus->slope, locus->u, locus->du);
	for (int r = 0; r < rows; r++) {
		memcpy(locus->damping + (size_t)r*n2, rom->D, (size_t)n2*sizeof(double));
		multiply(locus->force + (size_t)r*n, rom->D, locus->du + (size_t)r*n, locus->omega, n);
		for (int p = 0; p < rom->harmonics; p++)
			add_harmonic(locus, &rom->harmonic[p], r, derive);
		if (locus->more)
			cblas_daxpy(n2, 1.0, locus->slope + (size_t)r*n2, 1, locus->damping + (size_t)r*n2, 1);
	}
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, columns, n, rows, 2.0/rows, locus->basis,
	            columns, locus->force, n, 0.0, F, n);
	cblas_dscal(n, 0.5, F, 1);
	for (int h = 1; h <= locus->order; h++)
		cblas_daxpy(2*n, -h*h*locus->omega*locus->omega, y + (2*h - 1)*n, 1, F + (2*h - 1)*n, 1);
}

void hawser__locus_describe(struct hawser__locus_walk *walk, struct hawser__locus_station *station)
{
	const struct hawser__locus *locus = walk->locus;
	int n = locus->n, R = locus->rows;

	hawser__locus_orbit(walk->locus, station->z);
	for (int j = 0; j < n; j++) {
		double most = 0.0;

		for (int r = 0; r < R; r++) {
			double a = fabs(locus->u[(size_t)r*n + j]);
			double b = fabs(locus->u[(size_t)((r + 1)%R)*n + j]);
			double c = fabs(locus->u[(size_t)((r + R - 1)%R)*n + j]), bend = 2.0*a - b - c;

			if (a >= b && a >= c)
				most = fmax(most, a + (bend > 0.0 ? 0.125*(b - c)*(b - c)/bend : 0.0));
		}
		station->coordinate[j] = most;
		station->state[j] = locus->u[j];
		station->state[n + j] = locus->omega*locus->du[j];
	}
	station->point = (struct hawser_locus_point){
		.omega = station->z[LOCUS_OMEGA], .parameter = station->z[LOCUS_PARAMETER],
		.angle = 2.0*M_PI*station->z[LOCUS_KAPPA], .arc = station->arc,
		.residual = station->correction.residual, .mesh = locus->mesh,
		.harmonics = locus->order, .iterations = station->correction.iterations,
		.unstable = station->point.unstable};
	if (locus->kind == HAWSER_RESONANCE)
		hawser__locus_phase(walk->locus, &station->point, station->z);
}

double hawser__locus_turn(const struct hawser__locus_walk *walk, const double complex *from,
                          const double complex *to)
{
	int shift = (walk->next.order - walk->here.order)*walk->locus->n;
	double product = 0.0, one = 0.0, other = 0.0;

	for (int k = 0; k < walk->locus->wide; k++) {
		double complex before = k >= shift ? from[k - shift] : 0.0;

		product += creal(conj(before)*to[k]);
		one += creal(conj(before)*before);
		other += creal(conj(to[k])*to[k]);
	}
	return acos(fmax(-1.0, fmin(1.0, product/sqrt(one*other))));
}
