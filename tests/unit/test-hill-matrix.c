/* Determinants of Hill matrices against the characteristic polynomial of the monodromy matrix. Both
 * are the same function of the multiplier up to a positive factor: their signs at +1 and -1 agree,
 * and the determinant vanishes at a Floquet exponent. Random models: any damping and gyroscopic
 * matrix, stiffness and damping that vary with several harmonics, one coordinate or many.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <stdint.h>
#include <stdlib.h>

#include <hawser/linear.h>

#include "response/floquet/hill_matrix.h"
#include "response/floquet/linear_margin.h"
#include "rom/build/model.h"
#include "tests/tap.h"

enum { MOST = 6, MODELS = 60 };

static uint64_t chance = 2385;

static double between(double low, double high)
{
	chance = chance*6364136223846793005u + 1442695040888963407u;
	return low + (high - low)*(double)(chance >> 11)/9007199254740992.0;
}

/* Kinds: 0 symmetric with constant damping, 1 gyroscopic and varying damping, 2 undamped. */
static int model(struct hawser_rom *rom, int n, int kind)
{
	int p = 1 + (int)between(0.0, 2.99);

	if (hawser__rom_init(rom, n, NULL))
		return 1;
	rom->harmonic = calloc((size_t)p*2, sizeof *rom->harmonic);
	rom->harmonics = 2*p;
	for (int h = 0; h < 2*p; h++)
		rom->harmonic[h] = (struct hawser_harmonic){.k = h/2 + 1,
			.phase = h%2 ? HAWSER_SIN : HAWSER_COS,
			.K = calloc((size_t)n*(size_t)n, sizeof(double)),
			.D = kind == 1 ? calloc((size_t)n*(size_t)n, sizeof(double)) : NULL};
	for (int j = 0; j < n; j++) {
		double w = j ? between(0.5, 6.0) : 1.0;

		rom->K[j*n + j] = w*w;
		rom->D[j*n + j] = kind == 2 ? 0.0 : between(0.01, 0.1)*w;
		for (int k = 0; k < j; k++)
			if (kind == 1) {
				rom->D[j*n + k] += between(-0.5, 0.5);
				rom->D[k*n + j] -= rom->D[j*n + k];
			}
		for (int k = 0; k <= j; k++)
			for (int h = 0; h < 2*p; h++) {
				double *K = rom->harmonic[h].K, *D = rom->harmonic[h].D;

				K[j*n + k] = between(-0.4, 0.4);
				K[k*n + j] = kind == 1 ? between(-0.4, 0.4) : K[j*n + k];
				if (D) {
					D[j*n + k] = between(-0.1, 0.1);
					D[k*n + j] = between(-0.1, 0.1);
				}
			}
	}
	return 0;
}

/* Sign of the product of (mu_i - by), or 0 if a multiplier is too near. */
static int sign_of(const double *log_modulus, const double *argument, int m, double by)
{
	double complex product = 1.0;

	for (int i = 0; i < m; i++) {
		double complex mu = cexp(log_modulus[i] + I*argument[i]);

		if (cabs(mu - by) < 1e-7)
			return 0;
		product *= (mu - by)/(1.0 + cabs(mu));
	}
	return creal(product) > 0.0 ? 1 : -1;
}

struct found {
	int signs, wrong, exponents;
	double real, zero; /* largest imaginary part at +-1; largest value at an exponent */
};

static double determinant(double value[3], int *exponent, struct hawser__hill_matrix *matrix,
                          const struct hawser__variational *system, double re, double im, int more)
{
	const double lambda[2] = {re, im};
	int harmonics = hawser__hill_harmonics(system, lambda), p = system->order;

	p = system->order_d > p ? system->order_d : p;
	if (!harmonics || hawser__hill_determinant(value, exponent, matrix, system, lambda,
	                                           harmonics + more*p, NULL))
		return NAN;
	return hypot(value[0], value[1]);
}

static void compare(struct found *found, struct hawser__hill_matrix *matrix,
                    const struct hawser__variational *system, const double *log_modulus,
                    const double *argument)
{
	double period = 2.0*M_PI/system->omega, value[3], beside[3];
	int m = 2*system->n, exponent, other;

	for (int half = 0; half < 2; half++) {
		int sign = sign_of(log_modulus, argument, m, half ? -1.0 : 1.0);
		double size = determinant(value, &exponent, matrix, system, 0.0,
		                          half ? 0.5*system->omega : 0.0, 0);

		if (sign == 0)
			continue;
		found->signs++;
		found->wrong += !(sign*value[0] > 0.0);
		found->real = fmax(found->real, fabs(value[1])/size);
	}
	/* value at an exponent over the value at a distance of a thousandth of Omega */
	for (int i = 0; i < m; i++) {
		double re = log_modulus[i]/period, im = argument[i]/period, apart = INFINITY, size, away;

		for (int k = 0; k < m; k++)
			if (k != i)
				apart = fmin(apart, hypot(log_modulus[i] - log_modulus[k],
				                          remainder(argument[i] - argument[k], 2.0*M_PI)));
		if (apart < 0.05)
			continue;
		size = determinant(value, &exponent, matrix, system, re, im, 0);
		away = determinant(beside, &other, matrix, system, re + 1e-3*system->omega, im, 0);
		found->exponents++;
		found->zero = fmax(found->zero, 1e-3*ldexp(size/away, exponent - other));
	}
}

static void random_models(void)
{
	struct hawser__hill_matrix matrix = {.room = 0};
	struct found found = {.signs = 0};
	int failed = 0;

	for (int i = 0; i < MODELS; i++) {
		int n = 1 + i%MOST;
		double omega = pow(10.0, between(-0.5, 1.0)), log_modulus[2*MOST], argument[2*MOST];
		struct hawser__variational system;
		struct hawser_linear *linear = NULL;
		struct hawser_rom rom = {.n = 0};

		failed += model(&rom, n, i/MOST%3) || hawser_linear_open(&linear, n, NULL);
		hawser_linear_refine(linear, 2);
		failed += hawser_linear_multipliers(linear, log_modulus, argument, NULL, &rom, omega,
		                                    NULL) != HAWSER_OK;
		failed += hawser__linear_series(linear, &system, &rom, omega, NULL) != HAWSER_OK;
		compare(&found, &matrix, &system, log_modulus, argument);
		hawser_linear_free(linear);
		hawser_rom_clear(&rom);
	}
	hawser__hill_matrix_release(&matrix);
	ok(failed == 0 && found.signs > 100 && found.exponents > 200, "%d models: %d signs at +1 and -1, "
	   "%d exponents, %d failed", MODELS, found.signs, found.exponents, failed);
	ok(found.wrong == 0, "%d signs differ from those of the monodromy matrix", found.wrong);
	ok(found.real < 1e-9, "real at +1 and -1 within %.1e", found.real);
	ok(found.zero < 1e-10, "zeros are exponents within %.1e Omega", found.zero);
}

CASE(unit_hill_matrix)
{
	random_models();
	return done_testing();
}
