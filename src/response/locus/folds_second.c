/* response/locus/folds_second.c - gradient of the fold condition, in the time domain.
 *
 *    V, W   signals of the null vectors: V the variation of the orbit, W the weights of the equations,
 *           with the factors of the transform (1/R for the constant, 2/R for the others)
 *    T      tangent at the samples; D_V T its derivative along V
 *
 * The part of w^T J v that depends on the orbit is the sum of W^T T(u) V over the samples. Since
 * the second derivative of the restoring force is symmetric, its gradient is the transform of (D_V
 * T)^T W. T is a polynomial of second degree in u, so that its central difference is exact for any
 * increment. The increment is small for models whose energy is not a polynomial.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "response/locus/folds.h"
#include "rom/energy/kernel.h"

#define DIFFERENCE 1e-2 /* increment relative to the largest coordinate of the orbit; chosen for
                         * models with the exact energy */

/* time [R][n] = signal of wave [2 order + 1][n]. */
static void to_time(const struct hawser__balance *balance, double *time, const double *wave)
{
	int n = balance->base.n;

	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, balance->base.rows, n,
	            2*balance->order + 1, 1.0, balance->basis, 2*balance->width + 1, wave, n, 0.0,
	            time, n);
}

/* wave = its derivative with respect to the phase. */
static void derive(const struct hawser__balance *balance, double *wave)
{
	int n = balance->base.n;

	memset(wave, 0, (size_t)n*sizeof *wave);
	for (int h = 1; h <= balance->order; h++)
		for (int j = 0; j < n; j++) {
			double *a = wave + hawser__cos(n, h, j), *b = wave + hawser__sin(n, h, j);
			double keep = *a;

			*a = h**b;
			*b = -h*keep;
		}
}

/* Coefficients at the active unknowns, zero elsewhere. */
static void spread(const struct hawser__balance *balance, double *wave, const double *x,
                   const double *scale)
{
	memset(wave, 0, (size_t)(2*balance->order + 1)*balance->base.n*sizeof *wave);
	for (int i = 0; i < balance->unknowns; i++)
		wave[balance->slot[i]] = x[i]*scale[i];
}

/* The factors of the transform: 1/R for the constant, 2/R for the others. */
static void weigh(const struct hawser__balance *balance, double *wave)
{
	int n = balance->base.n;

	cblas_dscal((2*balance->order + 1)*n, 2.0/balance->base.rows, wave, 1);
	cblas_dscal(n, 0.5, wave, 1);
}

static double largest(const double *x, int count)
{
	return fabs(x[cblas_idamax(count, x, 1)]);
}

/* out [n] += factor * matrix x. */
static void multiply(double *out, const double *matrix, const double *x, double factor, int n)
{
	cblas_dgemv(CblasRowMajor, CblasNoTrans, n, n, factor, matrix, n, x, 1, 1.0, out, 1);
}

static double wave_at(const struct hawser_harmonic *harmonic, int r, int rows)
{
	double tau = 2.0*M_PI*r/rows;

	return harmonic->phase == HAWSER_COS ? cos(harmonic->k*tau) : sin(harmonic->k*tau);
}

static int parametric(const struct hawser_rom *rom)
{
	int found = 0;

	for (int p = 0; p < rom->harmonics; p++)
		found |= rom->harmonic[p].K || rom->harmonic[p].D || rom->harmonic[p].quads > 0;
	return found;
}

/* q [R][n] += (by_stiffness K x + by_damping D x') of the parametric terms, x in time_u and x' in
 * time_v. The factors are functions of Omega: K s and D s Omega with s = Omega^power cos|sin, or
 * their derivatives. With rom the full model, of all terms the derivatives by the load factor. */
static void parametric_terms(const struct hawser__fold *fold, double *q, const double *x,
                             const double *dx, int derivative, const struct hawser_rom *rom)
{
	double omega = fold->balance.at[fold->balance.base.size - 1];
	int n = rom->n, rows = fold->balance.base.rows;

	for (int p = 0; p < rom->harmonics; p++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[p];
		int power = harmonic->omega_power;
		double rate = rom == fold->load.full
		              ? hawser__load_rate(harmonic, fold->load.factor) : 1.0;
		double s = rate*pow(omega, power), stiff = derivative ? power*s/omega : s;
		double damp = derivative ? (power + 1)*s : s*omega;

		for (int r = 0; r < rows; r++) {
			double wave = wave_at(harmonic, r, rows);
			size_t at = (size_t)r*n;

			if (harmonic->K)
				multiply(q + at, harmonic->K, x + at, stiff*wave, n);
			if (harmonic->D)
				multiply(q + at, harmonic->D, dx + at, damp*wave, n);
		}
	}
}

/* q [R][n] += the derivative by the load factor of Q u u or, if x [R][n] is not NULL, of its
 * variation by x; u the orbit. */
static void varying_terms(const struct hawser__fold *fold, double *q, const double *x)
{
	const struct hawser_rom *full = fold->load.full;
	int n = full->n, rows = fold->balance.base.rows;

	for (int p = 0; p < full->harmonics; p++) {
		const struct hawser_harmonic *harmonic = &full->harmonic[p];
		double rate = hawser__load_rate(harmonic, fold->load.factor);

		for (int i = 0; i < harmonic->quads*rows; i++) {
			const struct hawser_quad *e = &harmonic->Q[i%harmonic->quads];
			int r = i/harmonic->quads;
			const double *u = fold->balance.base.samples + (size_t)r*n;
			const double *v = x ? x + (size_t)r*n : NULL;

			q[r*n + e->j] += rate*wave_at(harmonic, r, rows)*e->value*
			                 (x ? u[e->k]*v[e->l] + v[e->k]*u[e->l] : u[e->k]*u[e->l]);
		}
	}
}

static void by_orbit(struct hawser__fold *fold)
{
	struct hawser__balance *balance = &fold->balance;
	const struct hawser_rom *rom = &fold->load.rom;
	int n = rom->n, rows = balance->base.rows, count = rows*n;
	const double *u = balance->base.samples;
	double h = DIFFERENCE*largest(u, count)/largest(fold->time_v, count);

	for (int sign = 1; sign >= -1; sign -= 2) {
		memcpy(fold->time_u, u, (size_t)count*sizeof(double));
		cblas_daxpy(count, sign*h, fold->time_v, 1, fold->time_u, 1);
		hawser__rom_tangents(rom, fold->force, sign > 0 ? fold->plus : fold->minus,
		                     fold->time_u, rows, fold->work);
	}
	cblas_daxpy(count*n, -1.0, fold->minus, 1, fold->plus, 1);
	for (int r = 0; r < rows; r++)
		cblas_dgemv(CblasRowMajor, CblasTrans, n, n, 0.5/h, fold->plus + (size_t)r*n*n, n,
		            fold->time_w + (size_t)r*n, 1, 0.0, fold->time_q + (size_t)r*n, 1);
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, 2*balance->order + 1, n, rows, 1.0,
	            balance->basis, 2*balance->width + 1, fold->time_q, n, 0.0, fold->wave_g, n);
	for (int i = 0; i < balance->unknowns; i++)
		fold->g_y[i] = -balance->col_scale[i]*fold->wave_g[balance->slot[i]];
}

/* w^T (dJ/dOmega) v and w^T (dJ/dload) v: the part of J that is linear in the orbit. wave_v becomes
 * v'. */
static void by_parameters(struct hawser__fold *fold)
{
	struct hawser__balance *balance = &fold->balance;
	const struct hawser_rom *rom = &fold->load.rom;
	int n = rom->n, rows = balance->base.rows, count = rows*n;
	double omega = balance->at[balance->base.size - 1];
	double *v = fold->time_v, *dv = fold->time_u, *q = fold->time_q;

	derive(balance, fold->wave_v);
	to_time(balance, dv, fold->wave_v);
	derive(balance, fold->wave_v);
	to_time(balance, q, fold->wave_v);
	cblas_dscal(count, 2.0*omega, q, 1);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, rows, n, n, 1.0, dv, n, rom->D, n, 1.0, q,
	            n);
	fold->g_load = 0.0;
	if (parametric(rom))
		parametric_terms(fold, q, v, dv, 1, rom);
	fold->g_omega = -balance->base.W*cblas_ddot(count, fold->time_w, 1, q, 1);
	if (!parametric(rom))
		return;
	memset(q, 0, (size_t)count*sizeof *q);
	parametric_terms(fold, q, v, dv, 0, fold->load.full);
	varying_terms(fold, q, v);
	fold->g_load = -fold->L*cblas_ddot(count, fold->time_w, 1, q, 1);
}

void hawser__fold_differentiate(struct hawser__fold *fold)
{
	struct hawser__balance *balance = &fold->balance;
	int P = balance->unknowns;
	const double *v = fold->x + 3*((size_t)P + 1);

	spread(balance, fold->wave_v, v, balance->col_scale);
	spread(balance, fold->wave_w, fold->w, balance->row_scale);
	weigh(balance, fold->wave_w);
	to_time(balance, fold->time_v, fold->wave_v);
	to_time(balance, fold->time_w, fold->wave_w);
	by_orbit(fold);
	by_parameters(fold);
	fold->second = -cblas_ddot(P, fold->g_y, 1, v, 1);
}

void hawser__fold_by_load(struct hawser__fold *fold, double *by_load)
{
	struct hawser__balance *balance = &fold->balance;
	const struct hawser_rom *full = fold->load.full;
	int n = full->n, rows = balance->base.rows, count = rows*n;
	double omega = balance->at[balance->base.size - 1];

	memset(fold->time_q, 0, (size_t)count*sizeof(double));
	if (parametric(full)) {
		memcpy(fold->wave_v, balance->at, (size_t)(2*balance->order + 1)*n*sizeof(double));
		derive(balance, fold->wave_v);
		to_time(balance, fold->time_v, fold->wave_v);
		parametric_terms(fold, fold->time_q, balance->base.samples, fold->time_v, 0, full);
		varying_terms(fold, fold->time_q, NULL);
	}
	for (int p = 0; p < full->harmonics; p++) {
		const struct hawser_harmonic *harmonic = &full->harmonic[p];
		double s = pow(omega, harmonic->omega_power)*
		           hawser__load_rate(harmonic, fold->load.factor);

		for (int r = 0; harmonic->f && r < rows; r++)
			cblas_daxpy(n, -s*wave_at(harmonic, r, rows), harmonic->f, 1,
			            fold->time_q + (size_t)r*n, 1);
	}
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, 2*balance->order + 1, n, rows, 1.0,
	            balance->basis, 2*balance->width + 1, fold->time_q, n, 0.0, fold->wave_g, n);
	weigh(balance, fold->wave_g);
	for (int i = 0; i < balance->unknowns; i++)
		by_load[i] = balance->row_scale[i]*fold->wave_g[balance->slot[i]];
}
