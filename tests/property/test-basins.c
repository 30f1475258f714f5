/* Basins of attraction: of a Duffing oscillator against brute integration by GSL, which shares no code;
 * of a linear oscillator, of one with two wells and a symmetric excitation, and of a response of two
 * periods.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <hawser/hawser.h>

#include "rom/build/model.h"
#include "tests/tap.h"

enum { N = 13 };

/* u'' + d u' + (k + e cos Omega t) u + q u^2 + c u^3 = f cos Omega t */
struct oscillator {
	double d, k, e, q, c, f, omega;
};

static int model(struct hawser_rom *rom, const struct oscillator *of)
{
	if (hawser__rom_init(rom, 1, NULL))
		return 1;
	rom->K[0] = of->k;
	rom->D[0] = of->d;
	rom->Q = calloc(1, sizeof *rom->Q);
	rom->Q[0] = (struct hawser_quad){0, 0, 0, of->q};
	rom->quads = of->q != 0.0;
	rom->C = calloc(1, sizeof *rom->C);
	rom->C[0] = (struct hawser_cubic){0, 0, 0, 0, of->c};
	rom->cubics = of->c != 0.0;
	rom->harmonics = 1;
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	rom->harmonic[0] = (struct hawser_harmonic){.k = 1};
	if (of->f != 0.0)
		*(rom->harmonic[0].f = calloc(1, sizeof(double))) = of->f;
	if (of->e != 0.0) /* on the right side, with a minus */
		*(rom->harmonic[0].K = calloc(1, sizeof(double))) = of->e;
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

static enum hawser_status trace(struct hawser_map *map, struct hawser_basins *basins,
                                const struct oscillator *of, double reach, int points, int coarse,
                                struct hawser_report *report)
{
	struct hawser_map_source source = {.key = {"u1", "v1"}, .from = {-reach, -reach},
		.to = {reach, reach}, .omega = of->omega, .quantity = "basin"};
	struct hawser_map_options options = {.from = {-reach, -reach}, .to = {reach, reach},
		.points = {points, points}, .coarse = coarse, .tolerance = 0.1, .threads = 2};
	struct hawser_map_field field;
	struct hawser_rom rom;
	enum hawser_status status;

	*map = (struct hawser_map){.nx = 0};
	*basins = (struct hawser_basins){.n = 0};
	if (model(&rom, of))
		return HAWSER_ERR_MEMORY;
	source.rom = &rom;
	status = hawser_map_basin_open(&field, &source, report);
	if (!status)
		status = hawser_map_trace(map, &field, &options, report);
	if (!status)
		status = hawser_basins_count(basins, &field, map, report);
	hawser_map_basin_close(&field);
	hawser_rom_clear(&rom);
	return status;
}

static int motion(double t, const double x[], double rate[], void *context)
{
	const struct oscillator *of = context;

	rate[0] = x[1];
	rate[1] = (of->f - of->e*x[0])*cos(of->omega*t) - of->d*x[1] - of->k*x[0] - of->q*x[0]*x[0] -
	          of->c*x[0]*x[0]*x[0];
	return GSL_SUCCESS;
}

/* Number of the response at which x is after many periods, by the nearest state; 0: at none. */
static int brute(const struct oscillator *of, const struct hawser_basins *basins, double u, double v)
{
	struct oscillator copy = *of;
	gsl_odeiv2_system system = {motion, NULL, 2, &copy};
	gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-2,
	                                                          1e-9, 1e-9);
	double x[2] = {u, v}, t = 0.0;
	int end = 0;

	if (gsl_odeiv2_driver_apply(driver, &t, 90.0*2.0*M_PI/of->omega, x) == GSL_SUCCESS)
		for (int a = 0; a < basins->count; a++)
			if (hypot(x[0] - basins->state[2*a], x[1] - basins->state[2*a + 1]) < 1e-2)
				end = a + 1;
	gsl_odeiv2_driver_free(driver);
	return end;
}

static void duffing(void)
{
	const struct oscillator of = {.d = 0.063, .k = 1.0, .q = 0.29, .c = 0.41, .f = 0.21, .omega = 1.31};
	struct hawser_report report = {.status = HAWSER_OK};
	struct hawser_basins basins;
	struct hawser_map map;
	int differ = 0, number[3] = {0};

	if (trace(&map, &basins, &of, 2.3, N, 1, &report)) {
		ok(0, "basins of a Duffing oscillator: %s", report.message);
		return;
	}
	ok(basins.count == 2 && basins.basin[0].followed && basins.basin[1].followed,
	   "a Duffing oscillator has %d stable responses, both on its curves", basins.count);
	for (int j = 0; j < N; j++)
		for (int i = 0; i < N; i++) {
			int end = map.point[j*N + i].sample.number;

			number[end >= 0 && end < 3 ? end : 0]++;
			differ += end != brute(&of, &basins, map.x[i], map.y[j]);
		}
	ok(number[0] == 0 && number[1] > 30 && number[2] > 30,
	   "%d motions end at the one, %d at the other", number[1], number[2]);
	ok(differ == 0, "each at the one at which the integration by GSL ends (%d do not)", differ);
	close_to(basins.basin[0].share + basins.basin[1].share, 1.0, 1e-12, "the sum of the shares");
	ok(basins.basin[0].error > 0.0 && basins.basin[0].error < 0.5 && basins.boundary_entropy > 0.1 &&
	   basins.entropy <= basins.boundary_entropy && basins.boundary_entropy < log(2.0),
	   "error %.3f, entropies %.3f and %.3f", basins.basin[0].error, basins.entropy,
	   basins.boundary_entropy);
	hawser_basins_clear(&basins);
	hawser_map_clear(&map);
}

/* A refined map has the numbers of the full one at every point that it computes. */
static void refined(void)
{
	const struct oscillator of = {.d = 0.09, .k = 1.0, .q = 0.29, .c = 0.41, .f = 0.21, .omega = 1.31};
	struct hawser_report report = {.status = HAWSER_OK};
	struct hawser_basins all, some;
	struct hawser_map full, map;
	int differ = 0;

	if (trace(&full, &all, &of, 1.4, 25, 1, &report) || trace(&map, &some, &of, 1.4, 25, 4, &report)) {
		ok(0, "a refined map: %s", report.message);
		return;
	}
	for (int p = 0; p < 25*25; p++)
		differ += map.point[p].computed &&
		          map.point[p].sample.number != full.point[p].sample.number;
	ok(differ == 0 && all.count == 2 && map.visited < full.visited,
	   "a map that is refined at boundaries has the same numbers, with %ld points instead of %ld",
	   map.visited, full.visited);
	ok(fabs(all.basin[0].share - some.basin[0].share) <= all.basin[0].error,
	   "and the shares are the same within the error");
	hawser_basins_clear(&all);
	hawser_basins_clear(&some);
	hawser_map_clear(&full);
	hawser_map_clear(&map);
}

static void linear(void)
{
	const struct oscillator of = {.d = 0.17, .k = 1.3, .f = 0.4, .omega = 0.93};
	const double w = of.omega, a = of.k - w*w, b = of.d*w, size = of.f/(a*a + b*b);
	struct hawser_report report = {.status = HAWSER_OK};
	struct hawser_basins basins;
	struct hawser_map map;

	if (trace(&map, &basins, &of, 3.1, 9, 4, &report)) {
		ok(0, "the basin of a linear oscillator: %s", report.message);
		return;
	}
	ok(basins.count == 1 && basins.basin[0].share > 1.0 - 1e-12 && basins.basin[0].error == 0.0,
	   "a linear oscillator has one basin, all of the plane");
	close_to(basins.state[0], size*a, 1e-8, "its displacement at phase 0");
	close_to(basins.state[1], size*b*w, 1e-8, "its velocity at phase 0");
	close_to(basins.basin[0].amplitude, size*sqrt(a*a + b*b), 1e-8, "its amplitude");
	close_to(basins.basin[0].multiplier, exp(-of.d*M_PI/w), 1e-8, "the modulus of its multipliers");
	hawser_basins_clear(&basins);
	hawser_map_clear(&map);
}

/* The excitation is of the stiffness, so that -u is a motion if u is. */
static void two_wells(void)
{
	const struct oscillator of = {.d = 0.23, .k = -1.0, .e = 0.08, .c = 1.0, .omega = 1.07};
	struct hawser_report report = {.status = HAWSER_OK};
	struct hawser_basins basins;
	struct hawser_map map;
	int differ = 0;

	if (trace(&map, &basins, &of, 1.9, 20, 1, &report)) {
		ok(0, "the basins of two wells: %s", report.message);
		return;
	}
	ok(basins.count == 2 && fabs(basins.state[0] + basins.state[2]) < 1e-7 &&
	   fabs(basins.basin[0].amplitude - basins.basin[1].amplitude) < 1e-7,
	   "two wells have two responses, at %.6f and %.6f", basins.state[0], basins.state[2]);
	for (int p = 0; p < 400; p++)
		differ += map.point[p].sample.number != 3 - map.point[399 - p].sample.number;
	ok(differ == 0, "whose basins are symmetric to each other in every point (%d are not)", differ);
	close_to(basins.basin[0].share, 0.5, 1e-12, "the share of one of them");
	hawser_basins_clear(&basins);
	hawser_map_clear(&map);
}

/* Principal parametric resonance: rest is unstable, and the response has two periods. */
static void two_periods(void)
{
	const struct oscillator of = {.d = 0.13, .k = 1.0, .e = 0.5, .c = 0.6, .omega = 2.11};
	struct hawser_report report = {.status = HAWSER_OK};
	struct hawser_basins basins;
	struct hawser_map map;

	if (trace(&map, &basins, &of, 1.3, 8, 1, &report)) {
		ok(0, "a response of two periods: %s", report.message);
		return;
	}
	ok(basins.count == 1 && basins.basin[0].period == 2 && basins.basin[0].share > 1.0 - 1e-12,
	   "in parametric resonance all motions end at one response of %d periods (of %d; %.3f)",
	   basins.basin[0].period, basins.count, basins.basin[0].share);
	hawser_basins_clear(&basins);
	hawser_map_clear(&map);
}

static void refused(void)
{
	const struct oscillator of = {.d = 0.0, .k = 1.0, .c = 0.6, .f = 0.1, .omega = 1.3};
	struct hawser_report report = {.status = HAWSER_OK};
	struct hawser_basins basins;
	struct hawser_map map;

	ok(trace(&map, &basins, &of, 1.0, 5, 1, &report) == HAWSER_ERR_NO_SOLUTION &&
	   strstr(report.message, "no stable periodic response was found"),
	   "without damping nothing is an end: %s", report.message);
}

CASE(property_basins)
{
	gsl_set_error_handler_off();
	duffing();
	refined();
	linear();
	two_wells();
	two_periods();
	refused();
	return done_testing();
}
