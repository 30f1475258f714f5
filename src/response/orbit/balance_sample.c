/* response/orbit/balance_sample.c - defects and their derivatives: alternating frequency and time.
 *
 * The transforms are products with a table of cosines and sines. At the lengths of a response (some
 * tens of samples) one matrix product for all coordinates is faster than many short fast
 * transforms, and any length is allowed. Terms that are linear in the orbit (inertia, damping,
 * parametric terms) are computed in the frequency domain. The product of the Jacobian with a vector
 * is computed in the same way from the sampled tangents.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "response/orbit/balance.h"
#include "rom/energy/kernel.h"

/* Add s * q [n] * cos or sin(h tau) to out [harmonics][n], up to harmonic `reach`, for h of either
 * sign. */
struct waves {
	double *out;
	int reach, n;
};

static void add_cos(const struct waves *waves, int h, double s, const double *q)
{
	if (abs(h) <= waves->reach)
		cblas_daxpy(waves->n, s, q, 1, waves->out + hawser__cos(waves->n, abs(h), 0), 1);
}

static void add_sin(const struct waves *waves, int h, double s, const double *q)
{
	if (h != 0 && abs(h) <= waves->reach)
		cblas_daxpy(waves->n, h < 0 ? -s : s, q, 1,
		            waves->out + hawser__sin(waves->n, abs(h), 0), 1);
}

/* Add s * cos|sin(k tau) * q(tau), with q [2 order + 1][n] by harmonics. */
static void add_product(const struct waves *waves, const struct hawser_harmonic *harmonic, double s,
                        const double *q, int order)
{
	int n = waves->n, k = harmonic->k;

	for (int h = 0; h <= order; h++) {
		const double *c = q + hawser__cos(n, h, 0), *d = q + hawser__sin(n, h, 0);

		if (harmonic->phase == HAWSER_COS) {
			add_cos(waves, h + k, 0.5*s, c);
			add_cos(waves, h - k, 0.5*s, c);
		} else {
			add_sin(waves, k + h, 0.5*s, c);
			add_sin(waves, k - h, 0.5*s, c);
		}
		if (h && harmonic->phase == HAWSER_COS) {
			add_sin(waves, h + k, 0.5*s, d);
			add_sin(waves, h - k, 0.5*s, d);
		} else if (h) {
			add_cos(waves, h - k, 0.5*s, d);
			add_cos(waves, h + k, -0.5*s, d);
		}
	}
}

/* wave [2 order + 1][n] = matrix u, or, if `velocity` is not 0, matrix times velocity*du/dtau. */
static void apply(struct hawser__balance *balance, const double *matrix, double velocity)
{
	int n = balance->base.n;

	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, 2*balance->order + 1, n, n,
	            velocity != 0.0 ? velocity : 1.0, balance->at, n, matrix, n, 0.0, balance->wave, n);
	if (velocity == 0.0)
		return;
	memset(balance->wave, 0, (size_t)n*sizeof *balance->wave);
	for (int h = 1; h <= balance->order; h++) {
		double *c = balance->wave + hawser__cos(n, h, 0), *d = balance->wave + hawser__sin(n, h, 0);

		cblas_dswap(n, c, 1, d, 1);
		cblas_dscal(n, h, c, 1);
		cblas_dscal(n, -h, d, 1);
	}
}

/* r += s cos|sin(k tau) (D v + K u - f), s = Omega^power; by_omega where derive. */
static void add_forcing(struct hawser__balance *balance, const struct hawser_harmonic *harmonic,
                        double omega, int derive)
{
	struct waves r = {balance->defect, balance->reach, balance->base.n};
	struct waves dr = {balance->by_omega, balance->reach, balance->base.n};
	double s = pow(omega, harmonic->omega_power), ds = harmonic->omega_power*s/omega;
	int order = balance->order;

	if (harmonic->f) {
		add_product(&r, harmonic, -s, harmonic->f, 0);
		if (derive)
			add_product(&dr, harmonic, -ds, harmonic->f, 0);
	}
	if (harmonic->K) {
		apply(balance, harmonic->K, 0.0);
		add_product(&r, harmonic, s, balance->wave, order);
		if (derive)
			add_product(&dr, harmonic, ds, balance->wave, order);
	}
	if (harmonic->D) {
		apply(balance, harmonic->D, omega);
		add_product(&r, harmonic, s, balance->wave, order);
		if (derive)
			add_product(&dr, harmonic, ds + s/omega, balance->wave, order);
	}
}

/* r += Omega^2 u'' + Omega D u'. */
static void add_motion(struct hawser__balance *balance, double omega, int derive)
{
	int n = balance->base.n, count = (2*balance->order + 1)*n;

	apply(balance, balance->base.rom->D, omega);
	cblas_daxpy(count, 1.0, balance->wave, 1, balance->defect, 1);
	if (derive)
		cblas_daxpy(count, 1.0/omega, balance->wave, 1, balance->by_omega, 1);
	for (int h = 1; h <= balance->order; h++) {
		int i = hawser__cos(n, h, 0);

		cblas_daxpy(2*n, -h*h*omega*omega, balance->at + i, 1, balance->defect + i, 1);
		if (derive)
			cblas_daxpy(2*n, -2.0*h*h*omega, balance->at + i, 1,
			            balance->by_omega + i, 1);
	}
}

/* r += the terms that are linear in the orbit: inertia, damping, parametric terms. */
static void add_linear(struct hawser__balance *balance, double omega)
{
	const struct hawser_rom *rom = balance->base.rom;

	add_motion(balance, omega, 0);
	for (int p = 0; p < rom->harmonics; p++) {
		struct hawser_harmonic unloaded = rom->harmonic[p];

		unloaded.f = NULL;
		add_forcing(balance, &unloaded, omega, 0);
	}
}

/* Means of the diagonals of the sampled tangents. */
static void set_stiffness(struct hawser__balance *balance)
{
	int n = balance->base.n, rows = balance->base.rows;

	for (int j = 0; j < n; j++) {
		balance->stiffness[j] = 0.0;
		for (int r = 0; r < rows; r++)
			balance->stiffness[j] += balance->tangent[((size_t)r*n + j)*n + j]/rows;
	}
}

void hawser__balance_transform(struct hawser__balance *balance)
{
	const struct hawser_rom *rom = balance->base.rom;
	int n2 = rom->n*rom->n, rows = balance->base.rows;
	double omega = balance->derived_at;

	if (balance->transformed)
		return;
	balance->transformed = 1;
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, 2*balance->spread + 1, n2, rows,
	            2.0/rows, balance->basis, 2*balance->width + 1, balance->tangent, n2, 0.0,
	            balance->T, n2);
	for (int p = 0; p < rom->harmonics; p++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[p];
		struct waves T = {balance->T, balance->spread, n2};
		/* the constant of T is twice the mean */
		double factor = harmonic->k ? 1.0 : 2.0;

		if (harmonic->K)
			add_product(&T, harmonic, factor*pow(omega, harmonic->omega_power),
			            harmonic->K, 0);
	}
}

/* given = y; at = y with inactive pairs 0. */
static void take(struct hawser__balance *balance, const double *y)
{
	int last = balance->base.size - 1;

	memcpy(balance->given, y, ((size_t)last + 1)*sizeof *y);
	memset(balance->at, 0, (size_t)last*sizeof *y);
	for (int i = 0; i < balance->unknowns; i++)
		balance->at[balance->slot[i]] = y[balance->slot[i]];
	balance->at[last] = y[last];
}

/* Defects at balance->at and, with derive, their derivatives. */
static void evaluate(struct hawser__balance *balance, int derive)
{
	const struct hawser_rom *rom = balance->base.rom;
	int n = rom->n, rows = balance->base.rows, columns = 2*balance->width + 1;
	double omega = hawser__orbit_omega(&balance->base, balance->at);

	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, n, 2*balance->order + 1, 1.0,
	            balance->basis, columns, balance->at, n, 0.0, balance->base.samples, n);
	hawser__rom_tangents(rom, balance->force, derive ? balance->tangent : NULL,
	                     balance->base.samples, rows, balance->work);
	if (balance->more)
		hawser__balance_terms(balance, omega, derive);
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, 2*balance->reach + 1, n, rows, 2.0/rows,
	            balance->basis, columns, balance->force, n, 0.0, balance->defect, n);
	cblas_dscal(n, 0.5, balance->defect, 1);
	if (derive)
		memset(balance->by_omega, 0, (2*(size_t)balance->reach + 1)*n*sizeof(double));
	if (derive && balance->more)
		hawser__balance_terms_transform(balance, omega);
	add_motion(balance, omega, derive);
	for (int p = 0; p < rom->harmonics; p++)
		add_forcing(balance, &rom->harmonic[p], omega, derive);
	if (derive)
		set_stiffness(balance);
	balance->transformed &= !derive;
}

static void swap(double **a, double **b)
{
	double *keep = *a;

	*a = *b;
	*b = keep;
}

/* The defects at the parameter p, in *defect; returns 1, and they are those of the present model, if
 * there is none at p. */
static int evaluate_at(struct hawser__balance *balance, double **defect, double p)
{
	struct hawser__orbit *orbit = &balance->base;
	int last = orbit->size - 1, failed;
	double own = balance->at[last];

	balance->at[last] = p;
	failed = hawser__orbit_place(orbit, p);
	if (failed) {
		balance->at[last] = own;
		(void)hawser__orbit_place(orbit, own);
	}
	swap(&balance->defect, defect);
	evaluate(balance, 0);
	swap(&balance->defect, defect);
	balance->at[last] = own;
	return failed;
}

/* by_omega becomes the derivative of the defects by the parameter of the family, from the models on
 * both sides of the present one (one side where the other has none). */
static void differentiate_family(struct hawser__balance *balance)
{
	struct hawser__orbit *orbit = &balance->base;
	int count = (2*balance->reach + 1)*orbit->n;
	double wide, middle = hawser__orbit_middle(orbit, &wide, balance->at), span = 2.0*wide;

	span -= evaluate_at(balance, &balance->image, middle - wide) ? wide : 0.0;
	span -= evaluate_at(balance, &balance->by_omega, middle + wide) ? wide : 0.0;
	(void)hawser__orbit_place(orbit, balance->at[orbit->size - 1]);
	for (int i = 0; i < count; i++)
		balance->by_omega[i] = (balance->by_omega[i] - balance->image[i])/span;
	hawser__balance_set_damping(balance);
}

void hawser__balance_evaluate(struct hawser__balance *balance, const double *y, int derive)
{
	take(balance, y);
	if (derive)
		balance->derived_at = hawser__orbit_omega(&balance->base, balance->at);
	evaluate(balance, derive);
	if (derive && balance->base.family)
		differentiate_family(balance);
}

void hawser__balance_defects(struct hawser__balance *balance, int order)
{
	int own = balance->order;

	balance->order = order;
	(void)hawser__orbit_place(&balance->base, balance->at[balance->base.size - 1]);
	evaluate(balance, 0);
	balance->order = own;
}

/* image = J direction for the coefficients balance->direction [2 order + 1][n], which are 0 below the
 * harmonic `from`, at fixed Omega: the sampled tangents times the sampled direction, and the linear
 * terms. */
static void differentiate(struct hawser__balance *balance, int from)
{
	int n = balance->base.n, rows = balance->base.rows, columns = 2*balance->width + 1;
	int first = from ? 2*from - 1 : 0, wide = 2*balance->order + 1 - first;
	double omega = balance->derived_at;
	double *moved = balance->moved, *force = balance->moved + (size_t)rows*n;

	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, n, wide, 1.0,
	            balance->basis + first, columns, balance->direction + (size_t)first*n, n, 0.0, moved,
	            n);
	for (int r = 0; r < rows; r++)
		cblas_dgemv(CblasRowMajor, CblasNoTrans, n, n, 1.0,
		            balance->tangent + (size_t)r*n*n, n, moved + (size_t)r*n, 1, 0.0,
		            force + (size_t)r*n, 1);
	if (balance->more)
		hawser__balance_terms_product(balance, force, omega);
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, 2*balance->reach + 1, n, rows, 2.0/rows,
	            balance->basis, columns, force, n, 0.0, balance->image, n);
	cblas_dscal(n, 0.5, balance->image, 1);
	swap(&balance->at, &balance->direction);
	swap(&balance->defect, &balance->image);
	add_linear(balance, omega);
	swap(&balance->at, &balance->direction);
	swap(&balance->defect, &balance->image);
}

void hawser__balance_product(struct hawser__balance *balance, double *out, const double *x, int from)
{
	int P = balance->unknowns, last = balance->base.size - 1;
	const double *border = balance->border;
	double W = balance->base.W, sum = border[P]*x[P];

	memset(balance->direction, 0, (size_t)last*sizeof *x);
	for (int i = 0; i < P; i++)
		balance->direction[balance->slot[i]] = x[i]*balance->col_scale[i];
	differentiate(balance, from);
	for (int i = 0; i < P; i++) {
		int at = balance->slot[i];

		out[i] = balance->row_scale[i]*(balance->image[at] + balance->by_omega[at]*W*x[P]);
		sum += border[i]*x[i];
	}
	out[P] = sum;
}
