/* Floquet multipliers of products: known spectra, products whose formation would fail, and the
 * order of the result.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/orbit.h>

#include "response/floquet/monodromy.h"
#include "response/orbit/shooting.h"
#include "rom/build/model.h"
#include "tests/tap.h"

static double uniform(void)
{
	return 2.0*rand()/RAND_MAX - 1.0;
}

static void multiply(double *c, const double *a, const double *b, int m)
{
	for (int i = 0; i < m; i++)
		for (int j = 0; j < m; j++) {
			double sum = 0.0;

			for (int k = 0; k < m; k++)
				sum += a[i*m + k]*b[k*m + j];
			c[i*m + j] = sum;
		}
}

static double determinant3(const double *a)
{
	return a[0]*(a[4]*a[8] - a[5]*a[7]) - a[1]*(a[3]*a[8] - a[5]*a[6]) +
	       a[2]*(a[3]*a[7] - a[4]*a[6]);
}

/* Trace and determinant of the formed product, for random 3 by 3 factors: the result must have the
 * characteristic polynomial of the product. */
static void check_random(int segments)
{
	enum { m = 3 };
	double segment[9*16], product[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, next[9], lm[m], arg[m];
	double trace = 0.0, log_det = 0.0;

	for (int i = 0; i < segments*m*m; i++)
		segment[i] = uniform();
	for (int s = 0; s < segments; s++) {
		multiply(next, segment + s*m*m, product, m);
		memcpy(product, next, sizeof product);
	}
	ok(!hawser_floquet_product(lm, arg, segment, segments, m, NULL), "%d factors", segments);
	for (int i = 0; i < m; i++) {
		trace += exp(lm[i])*cos(arg[i]);
		log_det += lm[i];
	}
	close_to(trace, product[0] + product[4] + product[8], 1e-11, "trace of the product");
	close_to(log_det, log(fabs(determinant3(product))), 1e-9, "log of its determinant");
	ok(lm[0] >= lm[1] && lm[1] >= lm[2], "sorted by falling modulus");
}

/* Diagonal factors of very different size, turned by the same rotation. */
static void check_graded(void)
{
	double c = cos(0.7), s = sin(0.7), segment[4*40], lm[2], arg[2];

	for (int i = 0; i < 40; i++) {
		double a = 1.5, b = -1e-4;
		double *A = segment + 4*i;

		A[0] = a*c*c + b*s*s;
		A[1] = A[2] = (a - b)*c*s;
		A[3] = a*s*s + b*c*c;
	}
	ok(!hawser_floquet_product(lm, arg, segment, 40, 2, NULL), "graded product of 40 factors");
	close_to(lm[0], 40*log(1.5), 1e-12, "large multiplier");
	close_to(lm[1], 40*log(1e-4), 1e-12, "small multiplier, 1e-160 against 1e7");
	ok(arg[0] == 0.0 && arg[1] == 0.0, "an even number of negative factors: positive");
}

/* u'' + (24 + 10 sin t) u' + 10 cos t u = 0 has Floquet exponents 0 and -24 (Fairgrieve and Jepson,
 * SIAM J. Numer. Anal. 28 (1991), 1446); the monodromy matrix as one product gives -6. */
static void check_stress(void)
{
	struct hawser_rom rom;
	struct hawser__shooting shooting;
	double y[2*40 + 1] = {0};

	if (hawser__rom_init(&rom, 1, NULL))
		return;
	rom.D[0] = 24.0;
	rom.harmonics = 2;
	rom.harmonic = calloc(2, sizeof *rom.harmonic);
	rom.harmonic[0] = (struct hawser_harmonic){.k = 1, .phase = HAWSER_SIN,
		.D = calloc(1, sizeof(double))};
	rom.harmonic[1] = (struct hawser_harmonic){.k = 1, .phase = HAWSER_COS,
		.K = calloc(1, sizeof(double))};
	rom.harmonic[0].D[0] = rom.harmonic[1].K[0] = 10.0;
	ok(!hawser_rom_compile(&rom, NULL) && !hawser__shooting_init(&shooting, &rom, 40, 20, NULL),
	   "stress test in 40 segments");
	y[80] = 1.0;
	shooting.base.ops->defects(&shooting.base, y, 1);
	ok(!shooting.base.ops->multipliers(&shooting.base, NULL), "multipliers");
	ok(fabs(shooting.base.log_modulus[0]/(2*M_PI)) < 1e-10, "exponent 0: %.2e",
	   shooting.base.log_modulus[0]/(2*M_PI));
	close_to(shooting.base.log_modulus[1]/(2*M_PI), -24.0, 1e-10, "exponent -24");
	hawser__shooting_release(&shooting);
	hawser_rom_clear(&rom);
}

/* The kinds of the multipliers of a parametric model at rest: by the product of the segments
 * and by that of the steps. A damping that is not symmetric leaves none. */
static void check_kinds(void)
{
	enum { N = 3, M = 2*N, S = 4 };
	const double K[N*N] = {1.3, 0.1, 0.0, 0.1, 4.1, 0.2, 0.0, 0.2, 9.7}, omega = 2.93;
	double T[3*N*N] = {0.0}, log_modulus[M], argument[M], y[S*M + 1] = {0}, worst = 0.0, least = 2.0;
	struct hawser__shooting shooting;
	struct hawser__monodromy monodromy;
	struct hawser_rom rom;

	if (hawser__rom_init(&rom, N, NULL) || hawser__monodromy_init(&monodromy, N, NULL))
		return;
	rom.harmonics = 1;
	rom.harmonic = calloc(1, sizeof *rom.harmonic);
	rom.harmonic[0] = (struct hawser_harmonic){.k = 1, .phase = HAWSER_COS,
		.K = calloc(N*N, sizeof(double))};
	for (int e = 0; e < N*N; e++) {
		rom.K[e] = K[e];
		rom.D[e] = e%(N + 1) ? 0.0 : 0.03;
		T[e] = 2.0*K[e];
		T[N*N + e] = rom.harmonic[0].K[e] = 0.3*K[e];
	}
	y[S*M] = omega;
	ok(!hawser_rom_compile(&rom, NULL) && !hawser__shooting_init(&shooting, &rom, S, 40, NULL) &&
	   !hawser__monodromy_multipliers(&monodromy, log_modulus, argument, &rom, T, 1, omega, NULL),
	   "three coordinates");
	shooting.base.ops->defects(&shooting.base, y, 1);
	ok(!shooting.base.ops->multipliers(&shooting.base, NULL), "multipliers");
	for (int i = 0; i < M; i++)
		for (int j = 0; j < M; j++)
			if (fabs(shooting.base.argument[i] - argument[j]) < 1e-6) {
				worst = fmax(worst, fabs(shooting.base.kind[i] - monodromy.kind[j]));
				least = fmin(least, fabs(monodromy.kind[j]));
			}
	ok(worst < 1e-2 && least > 0.5 && least < 1.0, "kinds from %.4f on differ by %.1e", least, worst);
	rom.D[1] += 0.01;
	(void)shooting.base.ops->multipliers(&shooting.base, NULL);
	ok(shooting.base.kind[0] == 0.0, "damping that is not symmetric: kind %g", shooting.base.kind[0]);
	hawser__shooting_release(&shooting);
	hawser__monodromy_release(&monodromy);
	hawser_rom_clear(&rom);
}

/* Two complex pairs, exp(g) and exp(-g) per factor with the angles 0.7 and 1.9, in coordinates
 * mixed by a reflection. For 16 factors and more another routine of SLICOT, MB03WD, returns two
 * real multipliers for the smaller pair, and its logarithms are wrong in the second digit. */
static void check_mixed_pairs(int segments, double g)
{
	const double v[4] = {1.0, 2.0, 1.0, 2.0}, turn[2] = {0.7, 1.9};
	double A[16] = {0.0}, *segment = malloc((size_t)segments*sizeof A), lm[4], arg[4], worst = 0.0;

	for (int pair = 0; pair < 2; pair++) {
		double size = exp(pair ? -g : g), *B = A + 10*pair;

		B[0] = B[5] = size*cos(turn[pair]);
		B[1] = size*sin(turn[pair]);
		B[4] = -B[1];
	}
	for (int side = 0; side < 2; side++)
		for (int j = 0; j < 4; j++) {
			int from = side ? j : 4*j, by = side ? 4 : 1;
			double sum = 0.0;

			for (int k = 0; k < 4; k++)
				sum += v[k]*A[from + k*by];
			for (int k = 0; k < 4; k++)
				A[from + k*by] -= 0.2*sum*v[k];
		}
	for (int i = 0; i < segments; i++)
		memcpy(segment + 16*i, A, sizeof A);
	ok(!hawser_floquet_product(lm, arg, segment, segments, 4, NULL), "pairs of %d factors", segments);
	for (int i = 0; i < 4; i++) {
		double want = fabs(remainder(segments*turn[i/2], 2.0*M_PI));

		worst = fmax(worst, fabs(lm[i] - (i < 2 ? g : -g)*segments));
		worst = fmax(worst, fabs(fabs(arg[i]) - want));
	}
	ok(worst < 1e-10, "two complex pairs of %d factors, %g e-folds each: %.1e", segments, g, worst);
	free(segment);
}

/* Two complex pairs of moduli exp(-600) and exp(-20), in 60 factors: the square of the first
 * underflows. */
static void check_tiny_pairs(void)
{
	double segment[16*60] = {0.0}, lm[4], arg[4];

	for (int i = 0; i < 60; i++)
		for (int pair = 0; pair < 2; pair++) {
			double r = exp((pair ? -20.0 : -600.0)/60.0), a = pair ? 0.02 : 0.031;
			double *A = segment + 16*i + 10*pair;

			A[0] = A[5] = r*cos(a);
			A[1] = -r*sin(a);
			A[4] = r*sin(a);
		}
	ok(!hawser_floquet_product(lm, arg, segment, 60, 4, NULL), "tiny complex pairs");
	close_to(lm[0], -20.0, 1e-12, "larger modulus");
	close_to(lm[2], -600.0, 1e-12, "smaller modulus, whose square is no number");
	close_to(fabs(arg[0]), 1.2, 1e-10, "angle");
	close_to(fabs(arg[2]), 1.86, 1e-10, "angle of the smaller");
}

/* A damped oscillator over one period in thousands of steps: every factor is nearly the identity,
 * and the product is known. */
static void check_many(int segments)
{
	double zeta = 0.05, period = 7.0, h = period/segments, wd = sqrt(1.0 - zeta*zeta);
	double e = exp(-zeta*h), c = cos(wd*h), s = sin(wd*h)/wd, lm[2], arg[2];
	double *segment = malloc((size_t)segments*4*sizeof *segment);

	for (int i = 0; segment && i < segments; i++) {
		double A[4] = {e*(c + zeta*s), e*s, -e*s, e*(c - zeta*s)};

		memcpy(segment + 4*i, A, sizeof A);
	}
	ok(segment && !hawser_floquet_product(lm, arg, segment, segments, 2, NULL),
	   "%d factors near the identity", segments);
	close_to(lm[0], -zeta*period, 1e-11, "modulus");
	close_to(lm[1], -zeta*period, 1e-11, "of both");
	close_to(cos(arg[0]), cos(wd*period), 1e-11, "argument");
	free(segment);
}

static void check_errors(void)
{
	struct hawser_report report = {.message = ""};
	double a[4] = {1, 0, 0, NAN}, lm[2], arg[2];

	ok(hawser_floquet_product(lm, arg, a, 0, 2, &report) == HAWSER_ERR_ARGUMENT, "%s",
	   report.message);
	ok(hawser_floquet_product(lm, arg, a, 1, 2, &report) == HAWSER_ERR_NAN, "%s",
	   report.message);
}

CASE(unit_floquet)
{
	double turn[4] = {0.6, -0.8, 0.8, 0.6}, lm[2], arg[2];

	srand(2385);
	for (int segments = 1; segments <= 16; segments += 5)
		check_random(segments);
	ok(!hawser_floquet_product(lm, arg, turn, 1, 2, NULL), "a rotation");
	ok(fabs(lm[0]) < 1e-15 && arg[0] > 0.0 && arg[1] == -arg[0], "pair on the unit circle");
	close_to(arg[0], atan2(0.8, 0.6), 1e-14, "its angle");
	check_graded();
	check_stress();
	check_mixed_pairs(3, 2.0);
	check_mixed_pairs(16, 2.0);
	check_mixed_pairs(64, 0.5);
	check_mixed_pairs(64, 3.0);
	check_tiny_pairs();
	check_many(64);
	check_many(65);
	check_many(1000);
	check_many(4096);
	check_errors();
	check_kinds();
	return done_testing();
}
