/* Multipliers of a linear equation with periodic coefficients: fast coordinates condensed or
 * integrated, overdamped coordinates, damping matrices that oscillate or grow with Omega.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdint.h>
#include <stdlib.h>

#include "response/floquet/monodromy.h"
#include "rom/energy/exact.h"
#include "rom/build/model.h"
#include "tests/tap.h"

/* Two coordinates and a stiff third one: with steps that resolve all of them, and with the third
 * one condensed. */
static void check_condensed(void)
{
	double log_modulus[2][6], argument[2][6], omega = 2.17, T[5*9] = {0.0};
	struct hawser__monodromy monodromy;
	struct hawser_rom rom;
	const double follow[2] = {INFINITY, 20.0}, w = 57.0;
	int steps[2];

	if (hawser__rom_init(&rom, 3, NULL) || hawser__monodromy_init(&monodromy, 3, NULL))
		return;
	for (int j = 0; j < 3; j++)
		rom.D[4*j] = 0.04;
	for (int i = 0; i < 2; i++) {
		double *mean = T, *cosine = T + 9, *sine = T + 2*9;

		mean[0] = 2.0*1.21;
		mean[4] = 2.0*4.3;
		mean[8] = 2.0*w*w;
		mean[1] = mean[3] = 0.2;
		cosine[0] = 0.3;
		cosine[4] = -0.4;
		cosine[1] = cosine[3] = 0.25;
		sine[4] = 0.2;
		mean[2] = mean[6] = 8.0;
		cosine[5] = cosine[7] = 60.0;
		sine[8] = 200.0;
		monodromy.steps = 2;
		monodromy.follow = follow[i];
		if (!ok(!hawser__monodromy_multipliers(&monodromy, log_modulus[i], argument[i], &rom,
		                                       T, 2, omega, NULL), "%s",
		        i ? "condensed" : "followed"))
			return;
		steps[i] = monodromy.steps;
	}
	ok(steps[1] < steps[0]/3, "%d steps, condensed %d", steps[0], steps[1]);
	for (int i = 0; i < 2; i++) {
		double sum = 0.0;

		for (int j = 0; j < 6; j++)
			sum += log_modulus[i][j];
		ok(fabs(sum + 0.12*2.0*M_PI/omega) < (i ? 1e-7 : 1e-11), "Liouville's sum: %.1e",
		   sum + 0.12*2.0*M_PI/omega);
	}
	ok(log_modulus[0][0] > 0.01, "unstable: %g", log_modulus[0][0]);
	for (int j = 0; j < 6; j++)
		ok(fabs(log_modulus[0][j] - log_modulus[1][j]) < 1e-5, "modulus %d: %g, condensed "
		   "%+.1e", j, log_modulus[0][j], log_modulus[1][j] - log_modulus[0][j]);
	hawser__monodromy_release(&monodromy);
	hawser_rom_clear(&rom);
}

static uint64_t chance = 2611;

static double between(double low, double high)
{
	chance = chance*6364136223846793005u + 1442695040888963407u;
	return low + (high - low)*(double)(chance >> 11)/9007199254740992.0;
}

enum { N = 5, HARMONICS = 3 };

/* Three slow coordinates and two that are 15 to 60 times faster, with couplings between slow and fast
 * ones that vary in time and reach the static response 0.5. */
static void random_system(double *T)
{
	const double w[N] = {between(0.5, 1.0), between(1.2, 2.0), between(2.2, 3.0), between(45.0, 80.0),
		between(100.0, 180.0)};

	for (int r = 0; r <= 2*HARMONICS; r++)
		for (int i = 0; i < N; i++)
			for (int j = 0; j <= i; j++) {
				double size = i < 3 ? 0.3 : j < 3 ? 0.1*w[i]*w[i] : 0.03*w[j]*w[j];

				T[(r*N + i)*N + j] = T[(r*N + j)*N + i] = between(-size, size)/
					(r + 1);
			}
	for (int i = 0; i < N; i++)
		T[i*N + i] = 2.0*w[i]*w[i];
}

/* Multipliers of the slow coordinates agree with those of all coordinates to the stated error. */
static void check_slow_manifold(void)
{
	enum { SYSTEMS = 20 };
	double log_modulus[2][2*N], argument[2][2*N], T[(2*HARMONICS + 1)*N*N], worst = 0.0;
	struct hawser__monodromy monodromy[2];
	struct hawser_rom rom;
	int condensed = 0, wrong = 0;

	if (hawser__rom_init(&rom, N, NULL) || hawser__monodromy_init(&monodromy[0], N, NULL) ||
	    hawser__monodromy_init(&monodromy[1], N, NULL))
		return;
	for (int j = 0; j < N; j++)
		rom.D[j*(N + 1)] = 0.02;
	monodromy[0].follow = INFINITY;
	for (int k = 0; k < SYSTEMS; k++) {
		random_system(T);
		for (int side = 0; side < 2; side++)
			if (hawser__monodromy_multipliers(&monodromy[side], log_modulus[side],
			                                  argument[side], &rom, T, HARMONICS, 1.0, NULL))
				wrong++;
		condensed += monodromy[1].kept == 3;
		for (int j = 0; j < 6 && monodromy[1].kept == 3; j++) {
			double least = INFINITY;

			for (int i = 0; i < 2*N; i++)
				least = fmin(least, fabs(log_modulus[0][i] - log_modulus[1][j]));
			worst = fmax(worst, least/(monodromy[1].spread + 1e-8));
		}
	}
	ok(wrong == 0 && condensed > SYSTEMS/2, "%d of %d condensed", condensed, SYSTEMS);
	ok(worst < 1.0, "largest ratio of true and stated error: %g", worst);
	hawser__monodromy_release(&monodromy[0]);
	hawser__monodromy_release(&monodromy[1]);
	hawser_rom_clear(&rom);
}

/* Odd harmonics couple the even coordinates with the odd ones, and even harmonics the others: half a
 * period is enough. A coefficient far below the errors that breaks this has all of it computed. */
static void check_halves(void)
{
	enum { SYSTEMS = 20 };
	double log_modulus[2][2*N], argument[2][2*N], T[(2*HARMONICS + 1)*N*N], worst = 0.0, most = 0.0;
	struct hawser_rom_exact exact = {.n = N};
	struct hawser__monodromy monodromy;
	struct hawser_rom rom;
	int wrong = 0;

	if (hawser__rom_init(&rom, N, NULL) || hawser__monodromy_init(&monodromy, N, NULL))
		return;
	for (int j = 0; j < N; j++)
		rom.D[j*(N + 1)] = 0.02;
	for (int k = 0; k < SYSTEMS; k++) {
		random_system(T);
		for (int e = 0; e < (2*HARMONICS + 1)*N*N; e++)
			T[e] *= ((e/(N*N) + 1)/2 + e/N%N + e%N)%2 == 0;
		for (int j = 0; j < N; j++)
			rom.K[j*(N + 1)] = 0.5*T[j*(N + 1)];
		rom.exact = &exact; /* coordinates are modes at rest */
		for (int side = 0; side < 2; side++) {
			T[N*N] = 1e-9*side;
			wrong += hawser__monodromy_multipliers(&monodromy, log_modulus[side], argument[side],
			                                       &rom, T, HARMONICS, 1.0, NULL) ||
			         monodromy.kept != 3;
		}
		for (int i = 0; i < 2*N; i++) {
			double least = INFINITY;

			for (int j = 0; j < 2*N; j++)
				least = fmin(least, hypot(log_modulus[0][i] - log_modulus[1][j],
				                          argument[0][i] - argument[1][j]));
			worst = fmax(worst, least);
		}
		most = fmax(most, log_modulus[0][0]);
	}
	rom.exact = NULL;
	ok(wrong == 0 && most > 0.1, "growth to %g", most);
	ok(worst < 1e-5, "half a period: multipliers off by %.1e", worst);
	hawser__monodromy_release(&monodromy);
	hawser_rom_clear(&rom);
}

/* A cable that turns: K = diag w^2 + EA g g', g = (phi_1, phi_2, phi_3, 1), phi = c cos t +
 * d sin t, the strain by the motion along and by the angle of the motion across. The mean of K has
 * a frequency of up to 21 for the coordinate of frequency 1.3, and at every phase the last
 * coordinate cancels EA. It and the third one are condensed, and the multipliers are those of all
 * coordinates to the stated error. */
#define ACROSS 3
#define TURNED (ACROSS + 1)
static void turning_cable(double *T, double *rest, double EA)
{
	const double w[TURNED] = {1.3, 2.7, 11.0, 0.0};
	double c[ACROSS], d[ACROSS];

	for (int i = 0; i < ACROSS; i++) {
		c[i] = between(-0.3, 0.3);
		d[i] = between(-0.3, 0.3);
	}
	for (int e = 0; e < 5*TURNED*TURNED; e++)
		T[e] = 0.0;
	for (int i = 0; i < TURNED; i++)
		for (int j = 0; j < TURNED; j++) {
			double *at = T + i*TURNED + j;
			int along = (i == ACROSS) + (j == ACROSS), p = i < j ? i : j;
			int row = TURNED*TURNED;

			rest[i*TURNED + j] = i == j ? w[i]*w[i] + (along ? EA : 0.0) : 0.0;
			at[0] = i == j ? 2.0*w[i]*w[i] : 0.0;
			if (along == 2)
				at[0] += 2.0*EA;
			else if (along == 1) {
				at[row] = EA*c[p];
				at[2*row] = EA*d[p];
			} else {
				at[0] += EA*(c[i]*c[j] + d[i]*d[j]);
				at[3*row] = 0.5*EA*(c[i]*c[j] - d[i]*d[j]);
				at[4*row] = 0.5*EA*(c[i]*d[j] + d[i]*c[j]);
			}
		}
}

static void check_turning(void)
{
	enum { CABLES = 12 };
	double log_modulus[2][2*TURNED], argument[2][2*TURNED], T[5*TURNED*TURNED], worst = 0.0;
	struct hawser_rom_exact exact = {.n = TURNED};
	struct hawser__monodromy monodromy[2];
	struct hawser_rom rom;
	int condensed = 0, wrong = 0;

	if (hawser__rom_init(&rom, TURNED, NULL) ||
	    hawser__monodromy_init(&monodromy[0], TURNED, NULL) ||
	    hawser__monodromy_init(&monodromy[1], TURNED, NULL))
		return;
	for (int j = 0; j < TURNED; j++)
		rom.D[j*(TURNED + 1)] = 0.04;
	monodromy[0].follow = INFINITY;
	rom.exact = &exact; /* coordinates are modes at rest */
	for (int k = 0; k < CABLES; k++) {
		turning_cable(T, rom.K, 1e4);
		for (int side = 0; side < 2; side++)
			if (hawser__monodromy_multipliers(&monodromy[side], log_modulus[side],
			                                  argument[side], &rom, T, 2, 1.0, NULL))
				wrong++;
		condensed += monodromy[1].kept == 2;
		for (int j = 0; j < 4 && monodromy[1].kept == 2; j++) {
			double least = INFINITY;

			for (int i = 0; i < 2*TURNED; i++)
				least = fmin(least, fabs(log_modulus[0][i] - log_modulus[1][j]));
			worst = fmax(worst, least/(monodromy[1].spread + 1e-8));
		}
	}
	rom.exact = NULL;
	ok(wrong == 0 && condensed > CABLES/2, "%d of %d cables that turn condensed", condensed,
	   CABLES);
	ok(worst < 1.0, "largest ratio of true and stated error: %g", worst);
	hawser__monodromy_release(&monodromy[0]);
	hawser__monodromy_release(&monodromy[1]);
	hawser_rom_clear(&rom);
}

/* u'' + (24 + 10 sin t) u' + 10 cos t u = 0 has the exponents 0 and -24: u' + (24 + 10 sin t) u is
 * constant. */
static void check_overdamped(void)
{
	struct hawser__monodromy monodromy;
	struct hawser_rom rom;
	double log_modulus[2], argument[2], T[3] = {0.0, 10.0, 0.0};

	if (hawser__rom_init(&rom, 1, NULL) || hawser__monodromy_init(&monodromy, 1, NULL))
		return;
	rom.D[0] = 24.0;
	rom.harmonics = 1;
	rom.harmonic = calloc(1, sizeof *rom.harmonic);
	rom.harmonic[0] = (struct hawser_harmonic){.k = 1, .phase = HAWSER_SIN,
		.D = calloc(1, sizeof(double))};
	rom.harmonic[0].D[0] = 10.0;
	ok(!hawser__monodromy_multipliers(&monodromy, log_modulus, argument, &rom, T, 1, 1.0, NULL),
	   "multipliers in %d steps", monodromy.steps);
	ok(fabs(log_modulus[0]) < 1e-9 && argument[0] == 0.0, "exponent 0: %.1e", log_modulus[0]);
	ok(fabs(log_modulus[1]/(2.0*M_PI) + 24.0) < 1e-9, "exponent -24: %.12g",
	   log_modulus[1]/(2.0*M_PI));
	hawser__monodromy_release(&monodromy);
	hawser_rom_clear(&rom);
}

/* Damping by stiffness, as that of a full-order model, whose fast coordinates decay within a step but
 * whose motions are not fast enough to be condensed: the slow multipliers are those of a strict
 * computation, which resolves everything. */
static void check_decaying(void)
{
	double log_modulus[2][2*N], argument[2][2*N], T[(2*HARMONICS + 1)*N*N];
	struct hawser__monodromy monodromy[2] = {{.n = 0}};
	struct hawser_rom rom;
	int failed = hawser__rom_init(&rom, N, NULL) || hawser__monodromy_init(&monodromy[0], N, NULL) ||
	             hawser__monodromy_init(&monodromy[1], N, NULL);

	ok(!failed, "memory");
	monodromy[1].finer = 1;
	for (int k = 0; k < 4 && !failed; k++) {
		double worst = 0.0, bound;

		random_system(T);
		for (int e = 0; e < (2*HARMONICS + 1)*N*N; e++)
			T[e] *= (e/N%N < 3) == (e%N < 3) ? 1.0 : 0.1;
		for (int e = 0; e < N*N; e++)
			rom.D[e] = 0.02*T[e] + between(-0.05, 0.05);
		for (int side = 0; side < 2; side++)
			failed |= !ok(!hawser__monodromy_multipliers(&monodromy[side], log_modulus[side],
			                                             argument[side], &rom, T, HARMONICS, 1.0, NULL),
			              "%s computation, %d steps", side ? "strict" : "usual",
			              monodromy[side].steps);
		if (failed)
			break;
		bound = fmax(monodromy[0].spread, 1e-9);
		for (int j = 0; j < 6; j++) {
			double apart = fabs(argument[0][j]) - fabs(argument[1][j]);

			worst = fmax(worst, hypot(log_modulus[0][j] - log_modulus[1][j], apart));
		}
		ok(monodromy[0].steps < monodromy[1].steps/10 && worst < fmin(bound, 1e-9) && bound < 1e-2,
		   "fast decay: slow multipliers differ by %.1e, stated %.1e", worst, monodromy[0].spread);
	}
	for (int side = 0; side < 2; side++)
		hawser__monodromy_release(&monodromy[side]);
	hawser_rom_clear(&rom);
}

/* A damping that is proportional to a power of Omega, as the Coriolis forces of a rope that runs with
 * the load: the multipliers are those of the model whose constant D has that damping. */
static void check_constant(void)
{
	double log_modulus[2][6], argument[2][6], T[5*9] = {0.0}, worst = 0.0, liouville = 0.0;
	const double omega = 1.37, constant[9] = {0.11, 0.8, -0.3, -0.7, 0.05, 0.4, 0.3, -0.4, 0.02};
	struct hawser__monodromy monodromy;
	struct hawser_rom rom;

	if (hawser__rom_init(&rom, 3, NULL) || hawser__monodromy_init(&monodromy, 3, NULL))
		return;
	rom.harmonics = 2;
	rom.harmonic = calloc(2, sizeof *rom.harmonic);
	rom.harmonic[0] = (struct hawser_harmonic){.omega_power = 2, .D = calloc(9, sizeof(double))};
	rom.harmonic[1] = (struct hawser_harmonic){.k = 2, .phase = HAWSER_COS,
		.D = calloc(9, sizeof(double))};
	for (int e = 0; e < 9; e++) {
		rom.D[e] = 0.01*(e%4 == 0);
		rom.harmonic[0].D[e] = constant[e]/(omega*omega);
		rom.harmonic[1].D[e] = 0.2*constant[8 - e];
		T[e] = e%4 == 0 ? 2.0*(1.0 + e) : 0.1;
		T[9 + e] = e%4 == 0 ? 0.3 : 0.05;
	}
	for (int i = 0; i < 2; i++) {
		if (!ok(!hawser__monodromy_multipliers(&monodromy, log_modulus[i], argument[i], &rom, T, 2,
		                                       omega, NULL), "%s", i ? "in D" : "as a harmonic"))
			return;
		for (int e = 0; e < 9; e++) {
			rom.D[e] += constant[e];
			rom.harmonic[0].D[e] = 0.0;
		}
	}
	for (int i = 0; i < 6; i++) {
		worst = fmax(worst, fabs(log_modulus[0][i] - log_modulus[1][i]));
		worst = fmax(worst, fabs(fabs(argument[0][i]) - fabs(argument[1][i])));
		liouville += log_modulus[0][i];
	}
	liouville += 2.0*M_PI/omega*(0.03 + 0.11 + 0.05 + 0.02);
	ok(worst < 1e-10 && fabs(liouville) < 1e-11 && fabs(argument[0][0]) > 0.1,
	   "constant damping times Omega^2: multipliers to %.1e, Liouville's sum %.1e", worst, liouville);
	hawser__monodromy_release(&monodromy);
	hawser_rom_clear(&rom);
}

CASE(unit_monodromy)
{
	check_condensed();
	check_slow_manifold();
	check_halves();
	check_turning();
	check_overdamped();
	check_decaying();
	check_constant();
	return done_testing();
}
