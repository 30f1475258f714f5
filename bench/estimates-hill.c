/* bench/estimates-hill.c - multipliers of hawser hill, and boundaries of hawser map (estimates.h).
 *
 * For one coordinate, x'' + c x' + (k + p cos t + q cos 2t) x = 0 with t = Omega time, the
 * monodromy matrix is integrated by extrapolation in extended precision. Its trace and its
 * determinant, which is exp(-c T), give the multipliers in closed form. For more coordinates the
 * reference has eight times as many steps; their error decreases with the 16th power of the number.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <stdlib.h>
#include <string.h>

#include "bench/estimates.h"
#include "rom/build/model.h"

enum { MOST = 4, COLUMNS = 8, TRIED = 6 };
typedef long double real;

static int hill_model(struct hawser_rom *rom, struct chance *chance, int n)
{
	double damping = chance_log(chance, 1e-4, 0.3), depth = chance_log(chance, 1e-3, 2.0);

	if (hawser__rom_init(rom, n, NULL))
		return 1;
	rom->harmonic = calloc(2, sizeof *rom->harmonic);
	if (!rom->harmonic)
		return 1;
	rom->harmonics = 2;
	for (int h = 0; h < 2; h++) {
		rom->harmonic[h] = (struct hawser_harmonic){.k = h + 1,
			.K = calloc((size_t)n*(size_t)n, sizeof(double))};
		if (!rom->harmonic[h].K)
			return 1;
	}
	for (int j = 0; j < n; j++) {
		double omega = j ? chance_between(chance, 0.5, 6.0) : 1.0;

		rom->K[j*n + j] = omega*omega;
		rom->D[j*n + j] = 2.0*damping*omega;
		for (int k = 0; k <= j; k++)
			for (int h = 0; h < 2; h++)
				rom->harmonic[h].K[j*n + k] = rom->harmonic[h].K[k*n + j] =
					depth*chance_between(chance, -1.0, 1.0)/(h + 1);
	}
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

/* x' and x'' of two columns of x, x' at phase t. */
static void rate_of(real *rate, const struct hawser_rom *rom, const real *y, real t, real omega)
{
	real k = rom->K[0];

	for (int h = 0; h < rom->harmonics; h++)
		k += rom->harmonic[h].K[0]*cosl(rom->harmonic[h].k*t);
	for (int c = 0; c < 4; c += 2) {
		rate[c] = y[c + 1]/omega;
		rate[c + 1] = (-k*y[c] - rom->D[0]*y[c + 1])/omega;
	}
}

static void midpoint(real *out, const struct hawser_rom *rom, const real *y, real t, real H,
                     int steps, real omega)
{
	real h = H/steps, rate[4], old[4], now[4];

	rate_of(rate, rom, y, t, omega);
	for (int i = 0; i < 4; i++) {
		old[i] = y[i];
		now[i] = y[i] + h*rate[i];
	}
	for (int k = 1; k < steps; k++) {
		rate_of(rate, rom, now, t + k*h, omega);
		for (int i = 0; i < 4; i++) {
			real next = old[i] + 2.0L*h*rate[i];

			old[i] = now[i];
			now[i] = next;
		}
	}
	rate_of(rate, rom, now, t + H, omega);
	for (int i = 0; i < 4; i++)
		out[i] = 0.5L*(now[i] + old[i] + h*rate[i]);
}

/* Logarithms of the two moduli over a period, the larger first. */
static void closed_form(double *log_modulus, const struct hawser_rom *rom, real omega)
{
	real y[4] = {1.0L, 0.0L, 0.0L, 1.0L}, turn = 2.0L*acosl(-1.0L), table[COLUMNS][4];
	real top = rom->K[0] + fabs(rom->harmonic[0].K[0]) + fabs(rom->harmonic[1].K[0]);
	int steps = (int)ceill(turn*fmaxl(sqrtl(top)/omega, 2.0L)/0.4L);
	real half, det, root;

	for (int s = 0; s < steps; s++) {
		for (int j = 0; j < COLUMNS; j++) {
			midpoint(table[j], rom, y, turn*s/steps, turn/steps, 2*(j + 1), omega);
			for (int k = j - 1; k >= 0; k--) {
				real ratio = (real)((j + 1)*(j + 1))/((k + 1)*(k + 1)) - 1.0L;

				for (int i = 0; i < 4; i++)
					table[k][i] = table[k + 1][i] + (table[k + 1][i] - table[k][i])/ratio;
			}
		}
		memcpy(y, table[0], sizeof y);
	}
	half = 0.5L*(y[0] + y[3]);
	det = -rom->D[0]*turn/omega;
	root = half*half - expl(det);
	if (root <= 0.0L) {
		log_modulus[0] = log_modulus[1] = (double)(0.5L*det);
	} else {
		log_modulus[0] = (double)logl(fabsl(half) + sqrtl(root));
		log_modulus[1] = (double)(det - logl(fabsl(half) + sqrtl(root)));
	}
}

static int multipliers(double *log_modulus, double *error, const struct hawser_rom *rom, double omega,
                       int finer)
{
	struct hawser_linear *linear;
	double argument[2*MOST];
	int failed;

	if (hawser_linear_open(&linear, rom->n, NULL))
		return 1;
	if (finer > 1)
		hawser_linear_refine(linear, finer);
	failed = hawser_linear_multipliers(linear, log_modulus, argument, error, rom, omega, NULL) !=
	         HAWSER_OK;
	hawser_linear_free(linear);
	return failed;
}

int estimate_hill(struct tally *tally, struct chance *chance)
{
	int n = chance_unit(chance) < 0.5 ? 1 : chance_int(chance, 2, MOST);
	double omega = chance_log(chance, 0.1, 10.0), got[2*MOST], right[2*MOST], error, unused;
	struct hawser_rom rom;
	int refused;

	if (hill_model(&rom, chance, n))
		return 1;
	refused = multipliers(got, &error, &rom, omega, 1);
	if (n == 1)
		closed_form(right, &rom, omega);
	else
		refused = refused || multipliers(right, &unused, &rom, omega, 8);
	for (int i = 0; !refused && i < 2*n; i++)
		tally_note(tally, fabs(got[i] - right[i]), error,
		           "multiplier %d of %d coordinates, Omega %.6g: log %.9g", i + 1, n, omega,
		           right[i]);
	hawser_rom_clear(&rom);
	return refused;
}

/* --- maps --- */

static int grows(const struct hawser_rom *rom, double omega)
{
	double log_modulus[2];

	closed_form(log_modulus, rom, omega);
	return log_modulus[0] > 0.0;
}

/* A boundary along Omega at its load factor, where the ends of the bracket differ in stability. It
 * is bisected to 1e-13 and compared with the map. The ends of the bracket are among the samples:
 * between the next samples outside the bracket a narrow tongue with both its sides could be
 * missed. */
static double off(const struct hawser_rom *rom, const struct hawser_map_boundary *at)
{
	struct hawser_rom scaled = *rom;
	struct hawser_harmonic harmonic[2] = {rom->harmonic[0], rom->harmonic[1]};
	double K[2] = {at->y*rom->harmonic[0].K[0], at->y*rom->harmonic[1].K[0]};
	double low = at->x - 20.5*at->width, best = INFINITY;
	enum { CUTS = 41 };

	scaled.harmonic = harmonic;
	for (int h = 0; h < 2; h++)
		harmonic[h].K = &K[h];
	for (int c = 0; c < CUTS; c++) {
		double a = low + at->width*c, b = low + at->width*(c + 1);
		int left = grows(&scaled, a);

		if (left == grows(&scaled, b))
			continue;
		while (b - a > 1e-13*b) {
			double middle = 0.5*(a + b);

			*(grows(&scaled, middle) == left ? &a : &b) = middle;
		}
		best = fmin(best, fabs(0.5*(a + b) - at->x));
	}
	return best;
}

int estimate_map(struct tally *tally, struct chance *chance)
{
	struct hawser_map_options options = {.coarse = 0};
	struct hawser_map_source source = {.quantity = "multiplier", .key = {"Omega", "factor.load"}};
	struct hawser_map_field field;
	struct hawser_map map;
	struct hawser_rom rom;
	int refused;

	if (hill_model(&rom, chance, 1))
		return 1;
	source.rom = &rom;
	source.from[0] = options.from[0] = chance_between(chance, 0.6, 1.2);
	source.to[0] = options.to[0] = options.from[0] + chance_between(chance, 0.5, 1.5);
	source.from[1] = options.from[1] = 0.1;
	source.to[1] = options.to[1] = 2.0;
	options.points[0] = 25;
	options.points[1] = 9;
	options.threads = 1;
	/* growth counts beyond 1e-8 in the logarithm: a much narrower bracket encloses this limit */
	options.tolerance = chance_log(chance, 1e-6, 1e-3);
	if (hawser_map_cable_open(&field, &source, NULL)) {
		hawser_rom_clear(&rom);
		return 1;
	}
	refused = hawser_map_trace(&map, &field, &options, NULL) != HAWSER_OK;
	for (int b = 0, tried = 0; !refused && b < map.boundaries && tried < TRIED; b++)
		if (map.boundary[b].along == 0 && ++tried)
			tally_note(tally, off(&rom, &map.boundary[b]), map.boundary[b].width,
			           "boundary at Omega %.9g, load %.6g", map.boundary[b].x,
			           map.boundary[b].y);
	hawser_map_clear(&map);
	hawser_map_cable_close(&field);
	hawser_rom_clear(&rom);
	return refused;
}
