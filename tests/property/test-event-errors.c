/* Stated errors of events: they must not be exceeded, and be at most a hundred times the true ones.
 * The true value is a closed form, the linear problem, or the same event with a tolerance 1e6 times
 * smaller.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/hawser.h>

#include "tests/tap.h"

#define MOST 100.0      /* largest ratio of stated to true error, for true errors above round-off */
#define ROUND_OFF 3e-12 /* relative: smaller true errors cannot be distinguished from errors of the
                         * reference */

static const char *const both[] = {"shooting", "balance"};

static void check_error(const struct hawser_frf_event *event, double right, const char *name,
                        const char *method)
{
	double off = fabs(event->omega/right - 1.0);

	ok(off <= event->error + 1e-14 && event->error <= MOST*(off + ROUND_OFF),
	   "%s, %s: %s at %.12g is off by %.1e, stated %.1e", name, method,
	   hawser_event_name(event->kind), event->omega, off, event->error);
}

static void *copy(const void *from, size_t size)
{
	void *to = malloc(size);

	if (!to)
		abort();
	return memcpy(to, from, size);
}

/* --- rest of two coupled Mathieu oscillators --- */

/* Product of (1 - mu)/(1 + |mu|) over the multipliers at rest. */
static double at_rest(const struct hawser_rom *rom, struct hawser_linear *linear, double omega)
{
	double log_modulus[4], argument[4], f = 1.0;

	if (hawser_linear_multipliers(linear, log_modulus, argument, NULL, rom, omega, NULL))
		return NAN;
	for (int i = 0; i < 4; i++)
		f *= argument[i] == 0.0 ? -tanh(0.5*log_modulus[i])
		                        : hypot(tanh(0.5*log_modulus[i]),
		                                sin(0.5*argument[i])/cosh(0.5*log_modulus[i]));
	return f;
}

static double branch_point(const struct hawser_rom *rom, double near)
{
	double a = near*(1.0 - 1e-4), b = near*(1.0 + 1e-4), fa;
	struct hawser_linear *linear = NULL;

	ok(!hawser_linear_open(&linear, 2, NULL), "linear problem");
	hawser_linear_refine(linear, 2);
	fa = at_rest(rom, linear, a);
	for (int i = 0; i < 45; i++) {
		double middle = 0.5*(a + b);

		if ((at_rest(rom, linear, middle) < 0.0) == (fa < 0.0))
			a = middle;
		else
			b = middle;
	}
	hawser_linear_free(linear);
	ok(isfinite(fa), "multipliers of rest");
	return 0.5*(a + b);
}

static void check_rest(const char *method, double tolerance)
{
	const double D[] = {0.02, 0.0, 0.0, 0.03}, K[] = {1.0, 0.0, 0.0, 2.25};
	const double varying[] = {0.15, 0.05, 0.05, 0.15};
	const struct hawser_cubic cubic[] = {{0, 0, 0, 0, 0.3}, {0, 0, 1, 1, 0.2}, {1, 0, 0, 1, 0.2},
		{1, 1, 1, 1, 0.4}};
	struct hawser_rom rom = {.n = 2, .time = 1.0, .length = 1.0, .harmonics = 1, .cubics = 4};
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_frf frf;

	rom.D = copy(D, sizeof D);
	rom.K = copy(K, sizeof K);
	rom.C = copy(cubic, sizeof cubic);
	rom.harmonic = calloc(1, sizeof *rom.harmonic);
	rom.harmonic[0].k = 2;
	rom.harmonic[0].K = copy(varying, sizeof varying);
	options.method = method;
	options.from = 1.3;
	options.to = 0.8;
	options.samples = HAWSER_NONE;
	options.tolerance = tolerance;
	ok(!hawser_rom_compile(&rom, NULL) && !hawser_frf_trace(&frf, &rom, &options, NULL) &&
	   frf.events == 2, "rest, %s: two branch points", method);
	for (int e = 0; e < frf.events; e++)
		check_error(&frf.event[e], branch_point(&rom, frf.event[e].omega), "rest", method);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* --- the same events at two tolerances --- */

static double nearest(const struct hawser_frf *frf, const struct hawser_frf_event *event)
{
	double best = INFINITY;

	for (int e = 0; e < frf->events; e++)
		if (frf->event[e].kind == event->kind &&
		    fabs(frf->event[e].omega - event->omega) < fabs(best - event->omega))
			best = frf->event[e].omega;
	return best;
}

static void compare(const struct hawser_rom *rom, struct hawser_frf_options options, const char *name,
                    int least)
{
	struct hawser_frf exact, frf;

	options.samples = HAWSER_NONE;
	options.tolerance = 1e-12;
	options.event_tolerance = 1e-13;
	options.method = "shooting";
	ok(!hawser_frf_trace(&exact, rom, &options, NULL), "%s", name);
	ok(exact.events >= least, "%s: %d events", name, exact.events);
	for (int m = 0; m < 2; m++) {
		options.method = both[m];
		options.tolerance = m ? 1e-9 : 1e-6;
		options.event_tolerance = 1e-10;
		ok(!hawser_frf_trace(&frf, rom, &options, NULL), "%s, %s", name, both[m]);
		ok(frf.events == exact.events, "%s, %s: as many (%d)", name, both[m], frf.events);
		for (int e = 0; e < frf.events; e++)
			if (!frf.event[e].suspected)
				check_error(&frf.event[e], nearest(&exact, &frf.event[e]), name, both[m]);
		hawser_frf_clear(&frf);
	}
	hawser_frf_clear(&exact);
}

/* A linear oscillator determines the orbit. Two others at rest, whose coupling varies in time, have
 * a combination resonance: two torus points. */
static void check_combination(void)
{
	const double D[] = {0.1, 0.0, 0.0, 0.0, 0.02, 0.0, 0.0, 0.0, 0.03};
	const double K[] = {1.0, 0.0, 0.0, 0.0, 1.2115, 0.0, 0.0, 0.0, 2.8802};
	const double varying[] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.3, 0.0, 0.3, 0.0};
	struct hawser_rom rom = {.n = 3, .time = 1.0, .length = 1.0, .harmonics = 2};
	struct hawser_frf_options options = {.method = NULL};

	rom.D = copy(D, sizeof D);
	rom.K = copy(K, sizeof K);
	rom.harmonic = calloc(2, sizeof *rom.harmonic);
	rom.harmonic[0].k = rom.harmonic[1].k = 1;
	rom.harmonic[0].f = calloc(3, sizeof(double));
	rom.harmonic[0].f[0] = 0.1;
	rom.harmonic[1].K = copy(varying, sizeof varying);
	options.from = 2.6;
	options.to = 3.0;
	ok(!hawser_rom_compile(&rom, NULL), "compiled");
	compare(&rom, options, "combination", 2);
	hawser_rom_clear(&rom);
}

/* A cable whose response has folds and torus points. */
static void check_cable(void)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_modes_options modes_options;
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes modes;
	struct hawser_report report = {0};
	struct hawser_rom rom;
	const char *path = source_file("notebooks-data/scenes/b-table-4.2.yaml");

	if (!ok(!hawser_scene_open(&scene, path, NULL, 0, &report), "scene %s", report.message))
		return;
	modes_options = (struct hawser_modes_options){.n = scene.model.modes};
	ok(!hawser_statics_scene(&statics, &scene, &report) &&
	   !hawser_modes_solve(&modes, &statics, &modes_options, &report) &&
	   !hawser_rom_build(&rom, &modes, &scene, &report), "model %s", report.message);
	options.from = (getenv("HAWSER_LONG") ? 0.6 : 1.6)*sqrt(rom.K[0]);
	options.to = (getenv("HAWSER_LONG") ? 3.3 : 2.4)*sqrt(rom.K[0]);
	compare(&rom, options, "cable", 3);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

CASE(property_event_errors)
{
	for (int m = 0; m < 2; m++) {
		check_rest(both[m], 1e-9);
		check_rest(both[m], 1e-6);
	}
	check_combination();
	check_cable();
	return done_testing();
}
