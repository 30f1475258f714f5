/* Multipliers of stiff models about rest: with the fast coordinates condensed statically, and with
 * all coordinates integrated. The models are beams whose frequencies grow with the square of the
 * mode number, under an axial load that varies in time and along the beam.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdint.h>
#include <stdlib.h>

#include <hawser/linear.h>

#include "response/floquet/linear_margin.h"
#include "rom/build/model.h"
#include "tests/tap.h"

enum { MOST = 9 };

static uint64_t chance = 2385;

static double between(double low, double high)
{
	chance = chance*6364136223846793005u + 1442695040888963407u;
	return low + (high - low)*(double)(chance >> 11)/9007199254740992.0;
}

static int beam(struct hawser_rom *rom, int n, double ratio, double stiffness)
{
	double load = between(0.05, 0.6), growth = between(0.0, 1.5), *K;

	if (hawser__rom_init(rom, n, NULL))
		return 1;
	rom->harmonics = 1;
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	rom->harmonic[0].k = 1;
	rom->harmonic[0].K = K = calloc((size_t)n*(size_t)n, sizeof *K);
	for (int i = 0; i < n; i++) {
		double a = i + 1, w = a*a;

		rom->K[i*n + i] = w*w;
		rom->D[i*n + i] = 2.0*ratio*w + stiffness*w*w;
		/* for a load that increases along the beam; only modes at odd distances are coupled */
		for (int j = 0; j < n; j++) {
			double b = j + 1, far = (a - b)*(a - b), sum = (a + b)*(a + b);

			if (i == j)
				K[i*n + j] = load*a*a;
			else if ((i - j)%2)
				K[i*n + j] = -load*growth*2.0*a*b/(M_PI*M_PI)*(1.0/far + 1.0/sum);
		}
	}
	return 0;
}

static int solve(double *log_modulus, int *kept, double *neglected, const struct hawser_rom *rom,
                 double omega, int haste)
{
	struct hawser_linear *linear = NULL;
	double argument[2*MOST];
	int failed = hawser_linear_open(&linear, rom->n, NULL) != HAWSER_OK;

	if (failed)
		return 1;
	hawser_linear_refine(linear, haste ? 1 : 2);
	hawser__linear_haste(linear, haste);
	failed = hawser_linear_multipliers(linear, log_modulus, argument, NULL, rom, omega, NULL) !=
	         HAWSER_OK;
	*kept = hawser__linear_kept(linear, neglected);
	hawser_linear_free(linear);
	return failed;
}

/* The two largest multipliers, which decide about stability. */
static void compare(void)
{
	double worst = 0.0, most = 0.0;
	int condensed = 0, failed = 0, unstable = 0;

	for (int i = 0; i < 24; i++) {
		int n = i%2 ? MOST : 8, kept[2];
		double ratio = pow(10.0, between(-4.0, -1.5));
		double stiffness = i%3 ? 0.0 : pow(10.0, between(-4.0, -1.3)), omega = between(0.8, 5.0);
		double log_modulus[2][2*MOST], neglected[2] = {0.0, 0.0};
		struct hawser_rom rom = {.n = 0};

		failed += beam(&rom, n, ratio, stiffness);
		for (int haste = 0; haste < 2; haste++)
			failed += solve(log_modulus[haste], &kept[haste], &neglected[haste], &rom, omega,
			                haste);
		failed += kept[0] != n || neglected[0] != 0.0;
		unstable += log_modulus[0][0] > 1e-6;
		if (kept[1] < n) {
			condensed++;
			most = fmax(most, neglected[1]);
			for (int k = 0; k < 2; k++)
				worst = fmax(worst, fabs(log_modulus[1][k] - log_modulus[0][k])/
				                    (neglected[1] + 1e-8));
		}
		hawser_rom_clear(&rom);
	}
	ok(failed == 0 && condensed > 12 && unstable > 1, "24 beams, %d condensed, %d unstable, %d failed",
	   condensed, unstable, failed);
	ok(worst < 1.0 && most < 1e-5, "the two largest multipliers within %.2g of what is stated, %.1e at "
	   "most", worst, most);
}

/* Damping proportional to the stiffness makes the fast modes overdamped: they are condensed too.
 * Steps that resolve their decay rates would be too many. */
static void creeping(void)
{
	struct hawser_rom rom = {.n = 0};
	double log_modulus[2*MOST], neglected = 0.0;
	int kept = 0;

	ok(!beam(&rom, MOST, 0.005, 0.04), "a beam whose fast modes creep");
	ok(!solve(log_modulus, &kept, &neglected, &rom, 0.15, 0) && kept < MOST, "at a low frequency %d of "
	   "%d modes are followed", kept, MOST);
	hawser_rom_clear(&rom);
}

CASE(property_linear_condensed)
{
	compare();
	creeping();
	return done_testing();
}
