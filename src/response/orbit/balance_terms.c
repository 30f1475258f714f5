/* response/orbit/balance_terms.c - terms of any degree in coordinates and velocities (rom.h) in
 * harmonic balance.
 *
 *   d, k   highest degree of a term, highest harmonic that multiplies one
 *   v      Omega du/dtau at the samples
 *   p, P   force of the terms on the left side of the equations; P_u, P_v its derivatives
 *
 * A product of d coordinates and velocities of harmonics up to H, times harmonic k, reaches d H + k. Of
 * R >= d H + k + reach + 1 samples none is aliased to a defect, and the Fourier coefficients are exact.
 * The derivatives reach s = (d - 1) H + k. Their series are exact up to there with R >= 2 s + 1, and
 * none of their harmonics is left out of the multipliers.
 *
 * The change of P by the orbit is P_u du + P_v dv, and by Omega P_v v/Omega and that of the factor
 * Omega^omega_power.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <float.h>
#include <math.h>
#include <string.h>

#include "response/orbit/balance.h"
#include "rom/terms/terms.h"

static int highest(const struct hawser_term *term, int terms, int most)
{
	for (int i = 0; i < terms; i++)
		most = term[i].factors > most ? term[i].factors : most;
	return most;
}

void hawser__balance_reach(const struct hawser__balance *balance, int *samples, int *spread)
{
	const struct hawser_rom *rom = balance->base.rom;
	int d = highest(rom->term, rom->terms, 3), k = 0, H = balance->order, least;

	for (int p = 0; p < rom->harmonics; p++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[p];

		d = highest(harmonic->term, harmonic->terms, d);
		k = harmonic->terms > 0 && harmonic->k > k ? harmonic->k : k;
	}
	if (!balance->more)
		return;
	*spread = (d - 1)*H + k > *spread ? (d - 1)*H + k : *spread;
	least = d*H + k + balance->reach + 1;
	*samples = least > *samples ? least : *samples;
	*samples = 2**spread + 1 > *samples ? 2**spread + 1 : *samples;
}

/* v [R][n] of the coefficients y [2 order + 1][n]. */
static void set_rates(struct hawser__balance *balance, const double *y, double omega)
{
	int n = balance->base.n, columns = 2*balance->width + 1;

	memset(balance->wave, 0, (size_t)n*sizeof(double));
	for (int h = 1; h <= balance->order; h++) {
		int c = hawser__cos(n, h, 0), s = hawser__sin(n, h, 0);

		for (int j = 0; j < n; j++) {
			balance->wave[c + j] = h*omega*y[s + j];
			balance->wave[s + j] = -h*omega*y[c + j];
		}
	}
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, balance->base.rows, n,
	            2*balance->order + 1, 1.0, balance->basis, columns, balance->wave, n, 0.0,
	            balance->rates, n);
}

/* The derivative of the force by Omega at sample r, on the left side: shift [n] has the part of the
 * factors of Omega, on the right side. */
static void finish_shift(double *shift, const double *slope, const double *v, double omega, int n)
{
	for (int j = 0; j < n; j++) {
		shift[j] = -shift[j];
		for (int k = 0; k < n; k++)
			shift[j] += slope[j*n + k]*v[k]/omega;
	}
}

void hawser__balance_terms(struct hawser__balance *balance, double omega, int derive)
{
	const struct hawser_rom *rom = balance->base.rom;
	int rows = balance->base.rows;
	size_t n = (size_t)rom->n;
	const struct hawser__more to = {.force = balance->force, .by_u = derive ? balance->tangent : NULL,
		.by_v = derive ? balance->slope : NULL, .by_omega = derive ? balance->shift : NULL,
		.sign = -1.0, .stride = 1};

	set_rates(balance, balance->at, omega);
	if (derive) {
		memset(balance->slope, 0, (size_t)rows*n*n*sizeof(double));
		memset(balance->shift, 0, (size_t)rows*n*sizeof(double));
	}
	hawser__rom_more_left(rom, &to, balance->base.samples, balance->rates, rows, omega);
	for (int r = 0; derive && r < rows; r++)
		finish_shift(balance->shift + r*n, balance->slope + r*n*n, balance->rates + r*n, omega,
		             (int)n);
}

int hawser__balance_resists(const struct hawser__balance *balance, int row)
{
	size_t n2 = (size_t)balance->base.n*(size_t)balance->base.n;

	for (size_t e = 0; e < n2; e++)
		if (fabs(balance->resist[(size_t)row*n2 + e]) > balance->resist_floor)
			return 1;
	return 0;
}

/* Harmonics of the resistance above this one are round-off. */
static int highest_resistance(struct hawser__balance *balance)
{
	size_t n2 = (size_t)balance->base.n*(size_t)balance->base.n;
	int k = balance->spread;
	double most = 0.0;

	for (size_t e = 0; e < (2*(size_t)balance->spread + 1)*n2; e++)
		most = fmax(most, fabs(balance->resist[e]));
	balance->resist_floor = DBL_EPSILON*most;
	while (k > 0 && !hawser__balance_resists(balance, 2*k - 1) &&
	       !hawser__balance_resists(balance, 2*k))
		k--;
	return k;
}

void hawser__balance_terms_transform(struct hawser__balance *balance, double omega)
{
	int n = balance->base.n, n2 = n*n, rows = balance->base.rows, columns = 2*balance->width + 1;
	double *wave = balance->image, trace = 0.0;

	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, 2*balance->reach + 1, n, rows, 2.0/rows,
	            balance->basis, columns, balance->shift, n, 0.0, wave, n);
	cblas_dscal(n, 0.5, wave, 1);
	cblas_daxpy((2*balance->reach + 1)*n, 1.0, wave, 1, balance->by_omega, 1);
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, 2*balance->spread + 1, n2, rows, 2.0/rows,
	            balance->basis, columns, balance->slope, n2, 0.0, balance->resist, n2);
	for (int j = 0; j < n; j++)
		trace += 0.5*balance->resist[j*(n + 1)];
	balance->base.drained = trace*2.0*M_PI/omega;
	balance->monodromy.resist_order = highest_resistance(balance);
	hawser__balance_set_damping(balance);
}

void hawser__balance_terms_product(struct hawser__balance *balance, double *force, double omega)
{
	size_t n = (size_t)balance->base.n;

	set_rates(balance, balance->direction, omega);
	for (int r = 0; r < balance->base.rows; r++)
		cblas_dgemv(CblasRowMajor, CblasNoTrans, (int)n, (int)n, 1.0, balance->slope + r*n*n,
		            (int)n, balance->rates + r*n, 1, 1.0, force + r*n, 1);
}

void hawser__balance_set_damping(struct hawser__balance *balance)
{
	int n = balance->base.n;

	for (int j = 0; j < n; j++) {
		double more = balance->resist ? 0.5*balance->resist[j*(n + 1)] : 0.0;

		balance->damping[j] = fabs(balance->base.rom->D[j*(n + 1)] + more);
	}
}
