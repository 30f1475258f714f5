/* Condensation by other routes: subtraction, mode by mode, of the effect of the modes that are not
 * kept; the second-order displacement as a sum over those modes; independently computed ratios;
 * round trip through the model file.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <unistd.h>

#include <hawser/rom.h>

#include "tests/modes-span.h"
#include "tests/rom-condensed.h"
#include "tests/tap.h"

#define PAIRS (KEPT*(KEPT + 1)/2)

static void check_span(double epsilon, double delta, double hs, double tolerance)
{
	struct hawser_scene scene = {.model = {.condense = HAWSER_CONDENSE_STATIC}};
	struct hawser_statics st = span_of(epsilon, delta, hs);
	struct hawser_modes few, many;
	struct hawser_rom condensed, raw;
	double *T, left[3] = {0.0};

	if (!ok(modes_of(&few, &st, KEPT) && modes_of(&many, &st, 120) &&
	        !hawser_rom_build(&condensed, &few, &scene, NULL) &&
	        !hawser_rom_build(&raw, &few, NULL, NULL),
	        "epsilon %g, delta %g, hs %g: models", epsilon, delta, hs))
		return;
	T = all_thirds(&many);
	for (int i = 0; T && i < 3; i++)
		left[i] = rest(&condensed, &raw, T, &many, 30 << i);
	ok(T && left[2] < tolerance && left[2] <= left[0],
	   "condensed C against 30, 60, 120 modes: %.1e, %.1e, %.1e", left[0], left[1], left[2]);
	ok(T && rest_of_shape(&condensed, T, &many) < 10.0*tolerance,
	   "second-order displacement against 120 modes: %.1e", rest_of_shape(&condensed, T, &many));
	ok(hawser_rom_asymmetry(&condensed) < 1e-13, "still a potential: %.1e",
	   hawser_rom_asymmetry(&condensed));
	free(T);
	hawser_rom_clear(&condensed);
	hawser_rom_clear(&raw);
	hawser_modes_clear(&few);
	hawser_modes_clear(&many);
}

/* Effect of a load on a pair of kept modes through the condensed modes, cos(Omega t) K_jk, by
 * another route: K_jk is the sum over the condensed modes of f_s T_jks/omega_s^2. These include the
 * longitudinal modes, which a load along the cable drives. */
static void check_load(double hs, enum hawser_frame frame, const double extent[2],
                       const double *force, double tolerance)
{
	struct hawser_scene scene = {.model = {.condense = HAWSER_CONDENSE_STATIC,
		.inertia = HAWSER_INERTIA_NONE},
		.load = {.present = 1, .frame = frame}};
	struct hawser_statics st = span_of(0.05, 0.2, hs);
	struct hawser_modes few, many;
	struct hawser_rom condensed, raw;
	double *T, left[3] = {0.0}, largest = 0.0;
	int odd = 0;

	memcpy(scene.load.per_length, force, sizeof scene.load.per_length);
	memcpy(scene.load.extent, extent, sizeof scene.load.extent);
	if (!ok(modes_of(&few, &st, KEPT) && modes_of(&many, &st, 96) &&
	        !hawser_rom_build(&condensed, &few, &scene, NULL) &&
	        !hawser_rom_build_exact(&raw, &many, &scene, NULL), "load %g %g %g: models", force[0],
	        force[1], force[2]))
		return;
	T = all_thirds(&many);
	for (int i = 0; T && condensed.harmonic->K && i < 3; i++) {
		left[i] = 0.0;
		for (int x = 0; x < KEPT*KEPT; x++) {
			double sum = condensed.harmonic->K[x];

			largest = fmax(largest, fabs(sum));
			odd |= sum != condensed.harmonic->K[x%KEPT*KEPT + x/KEPT];
			for (int s = KEPT; s < 24 << i; s++)
				sum -= raw.harmonic->f[s]*T[(size_t)x*many.n + s]/
				       pow(many.mode[s].omega, 2);
			left[i] = fmax(left[i], fabs(sum));
		}
	}
	ok(T && largest > 0.0 && left[2] < tolerance*largest && left[2] <= left[0] && !odd,
	   "stiffness that the load varies, %.1e, against 24, 48, 96 modes: %.1e, %.1e, %.1e", largest,
	   left[0]/largest, left[1]/largest, left[2]/largest);
	free(T);
	hawser_rom_clear(&condensed);
	hawser_rom_clear(&raw);
	hawser_modes_clear(&few);
	hawser_modes_clear(&many);
}

static void check_loads(void)
{
	static const double whole[2] = {0.0, 1.0}, part[2] = {0.137, 0.61};
	static const double along[3] = {0.7, 0.0, 0.0}, oblique[3] = {0.7, -0.3, 0.4};

	check_load(0.3, HAWSER_FRAME_LOCAL, whole, along, 1e-4);
	check_load(0.3, HAWSER_FRAME_GLOBAL, whole, oblique, 1e-4);
	check_load(0.0, HAWSER_FRAME_LOCAL, part, oblique, 1e-4);
}

/* Ratio of the condensed to the raw cubic coefficient of the first out-of-plane mode, B Tables 4.5,
 * 4.2 and 4.4 (line 2); computed independently in high precision. Then a nearly inextensible
 * cable. */
static void check_ratio(double EA, double rho, double d, double h, enum hawser_given given,
                        double value, double want)
{
	const struct hawser_span span = {.EA = EA, .rho = rho, .g = 9.81, .d = d, .h = h};
	struct hawser_scene scene = {.model = {.condense = HAWSER_CONDENSE_STATIC}};
	struct hawser_statics st;
	struct hawser_modes modes;
	struct hawser_rom condensed, raw;

	if (!ok(!hawser_statics_solve(&st, &span, given, value, HAWSER_BRANCH_TAUT, NULL) &&
	        modes_of(&modes, &st, 1) && !hawser_rom_build(&condensed, &modes, &scene, NULL) &&
	        !hawser_rom_build(&raw, &modes, NULL, NULL), "EA %g, d %g: models", EA, d))
		return;
	ok(fabs(condensed.C[0].value/raw.C[0].value - want) < 6e-4, "ratio %.5f, wanted %.3f",
	   condensed.C[0].value/raw.C[0].value, want);
	hawser_rom_clear(&condensed);
	hawser_rom_clear(&raw);
	hawser_modes_clear(&modes);
}

static void check_file(void)
{
	struct hawser_scene scene = {.model = {.condense = HAWSER_CONDENSE_STATIC}};
	struct hawser_statics st = span_of(1e-3, 0.3, 0.1);
	struct hawser_modes modes;
	struct hawser_rom rom, back;
	char path[] = "condensed-XXXXXX";
	double u[KEPT] = {0.01, -0.02, 0.005, 0.013}, a[3], b[3];
	int fd = mkstemp(path);

	if (fd < 0 || !modes_of(&modes, &st, KEPT) || hawser_rom_build(&rom, &modes, &scene, NULL))
		return;
	close(fd);
	ok(!hawser_rom_save(&rom, path, NULL) && !hawser_rom_open(&back, path, NULL), "round trip");
	hawser_rom_displacement(&rom, a, 1, u);
	hawser_rom_displacement(&back, b, 1, u);
	ok(!memcmp(a, b, sizeof a) && hawser_rom_tension(&rom, 2, u) == hawser_rom_tension(&back, 2, u),
	   "the file keeps displacement and tension to the last bit");
	unlink(path);
	hawser_rom_clear(&rom);
	hawser_rom_clear(&back);
	hawser_modes_clear(&modes);
}

CASE(property_rom_condense)
{
	check_span(0.05, 0.2, 0.0, 1e-5);
	check_span(0.05, 0.2, 0.3, 1e-5);
	check_span(0.2, 1.5, 0.4, 1e-4);
	check_ratio(4e8, 5.0, 300.0, 10.0, HAWSER_GIVEN_H, 1e5, 0.082);
	check_ratio(4e8, 6.0, 250.0, 10.0, HAWSER_GIVEN_T0, 8e4, 0.044);
	check_ratio(1e8, 5.56, 300.0, 15.0, HAWSER_GIVEN_T0, 8e4, 0.125);
	check_loads();
	check_file();
	return done_testing();
}
