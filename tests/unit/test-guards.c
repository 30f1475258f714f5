/* Errors of library functions that the program never causes: statuses and messages.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/beam.h>
#include <hawser/hill.h>
#include <hawser/primary.h>

#include "tests/map-fields.h"
#include "tests/tap.h"

static struct hawser_report report;

static void refused(enum hawser_status got, enum hawser_status want, const char *message)
{
	ok(got == want && report.status == want && strstr(report.message, message), "%s: %s",
	   hawser_status_name(got), report.message);
	report = (struct hawser_report){.status = HAWSER_OK};
}

static const enum hawser_status argument = HAWSER_ERR_ARGUMENT;

/* --- beams --- */

static struct hawser_beam plain(void)
{
	return (struct hawser_beam){.theta = 1.0, .tension = 1.0};
}

static void discretisations(void)
{
	struct hawser_beam_integrals is;

	for (int k = 0; hawser_beam_method(k); k++) {
		enum hawser_status status = hawser_beam_method(k)->fill(&is, plain().ends, 0, &report);

		refused(status, argument, ": give at least ");
	}
}

static void spectra(const struct hawser_beam_integrals *is)
{
	struct hawser_beam beam = plain(), wrong = plain(), string = plain();
	struct hawser_beam_eigenvalue value[4];
	struct hawser_beam_limits limits;
	struct hawser_beam_sweep sweep;
	struct hawser_beam_sweep_options range = {.from = 0.0, .to = 1.0, .points = 1, .branches = 2};
	double speed[64], error;
	int found, buckled;
	const struct hawser_beam_method *method = hawser_beam_method(0);

	wrong.drag = -1.0;
	string.theta = 0.0;
	refused(hawser_beam_eigenvalues(value, NULL, &found, is, &beam, 0, &report), argument,
	        "0 eigenvalues: at least 1");
	refused(hawser_beam_eigenvalues(value, NULL, &found, is, &wrong, 2, &report), argument,
	        "drag -1");
	refused(hawser_beam_static_speeds(speed, &found, &buckled, is, &string, &report), argument,
	        "has no discrete static speeds");
	refused(hawser_beam_limits(&limits, is, &beam, 0, &report), argument, "0 modes: at least 1");
	refused(hawser_beam_size(&found, &error, method, &beam, 0, 1e-6, &report), argument,
	        "0 modes: at least 1");
	refused(hawser_beam_sweep(&sweep, is, &beam, &range, &report), argument,
	        "give 2 points or more");
	hawser_beam_sweep_clear(&sweep);
}

static enum hawser_status at_tension(struct hawser_beam *beam, void *context, double parameter,
                                     struct hawser_report *why)
{
	(void)context;
	(void)why;
	*beam = plain();
	beam->tension = parameter;
	return HAWSER_OK;
}

static void boundaries(const struct hawser_beam_integrals *is)
{
	struct hawser_beam_family family = {at_tension, NULL};
	struct hawser_beam_boundary_options options = {.from = 2.0, .to = 1.0, .modes = 2};
	struct hawser_beam_boundary boundary;

	refused(hawser_beam_boundary(&boundary, is, &family, &options, &report), argument,
	        "give the smaller end first");
	hawser_beam_boundary_clear(&boundary);
}

/* --- maps and boundaries --- */

static void maps(void)
{
	struct hawser_map_field field = circle();
	struct hawser_map_options options = square(9, 9), other = options;
	struct hawser_map map;
	struct hawser_map_source of = {.rom = NULL};

	other.to[0] = NAN;
	refused(hawser_map_trace(&map, &field, &other, &report), argument,
	        "both ends must be finite and different");
	hawser_map_clear(&map);
	other = options, other.points[1] = 1;
	refused(hawser_map_trace(&map, &field, &other, &report), argument, "1 points along y");
	hawser_map_clear(&map);
	other = options, other.threads = -1;
	refused(hawser_map_trace(&map, &field, &other, &report), argument, "one is out of range");
	hawser_map_clear(&map);
	of.quantity = "beauty";
	refused(hawser_map_cable_open(&field, &of, &report), argument, "there is no quantity \"beauty\"");
}

static void charts(void)
{
	struct hawser_hill_options options = {.lines = 0};
	struct hawser_hill_field field;
	struct hawser_hill_chart chart;
	double delta;

	if (!ok(hawser_mathieu_open(&field, 0.0, &report) == HAWSER_OK, "Mathieu's equation"))
		return;
	options.from[0] = options.from[1] = 1.0;
	refused(hawser_hill_trace(&chart, &field, &options, &report), argument,
	        "give the smaller end first");
	hawser_hill_clear(&chart);
	options.from[0] = options.from[1] = 0.0;
	options.to[0] = options.to[1] = 1.0;
	options.lines = -1;
	refused(hawser_hill_trace(&chart, &field, &options, &report), argument,
	        "-1 lines of 240 samples");
	hawser_hill_clear(&chart);
	hawser_mathieu_close(&field);
	refused(hawser_mathieu_value(&delta, 0, 1, 0.5, &report), argument, "orders go from 1 to");
}

static void closed_forms(void)
{
	double D[1] = {0.05}, K[1] = {1.0}, f[1] = {0.18};
	struct hawser_harmonic harmonic = {.k = 1, .phase = HAWSER_COS, .f = f};
	struct hawser_cubic C = {0, 0, 0, 0, 0.1};
	struct hawser_rom rom = {.n = 1, .D = D, .K = K, .cubics = 1, .C = &C, .harmonics = 1,
		.harmonic = &harmonic, .length = 1.0, .time = 1.0, .force = 1.0};
	struct hawser_primary primary;
	struct hawser_primary_curve curve;
	double gamma;

	if (!ok(hawser_rom_compile(&rom, &report) == HAWSER_OK, "a model: %s", report.message))
		return;
	refused(hawser_primary_derive(&primary, &rom, 1, &report), argument, "the model has modes 1 to 1");
	hawser_primary_clear(&primary);
	refused(hawser_primary_backbone(&curve, &gamma, &rom, 0, 1.0, 1, &report), argument,
	        "give an amplitude and 2 points");
	hawser_primary_curve_clear(&curve);
	if (ok(hawser_primary_derive(&primary, &rom, 0, &report) == HAWSER_OK, "its resonance"))
		refused(hawser_primary_trace(&curve, &primary, 1.0, 1.0, 2, &report), argument,
		        "give at least 2, and a range");
	hawser_primary_curve_clear(&curve);
	hawser_primary_clear(&primary);
	rom = (struct hawser_rom){.kernel = rom.kernel};
	hawser_rom_clear(&rom);
}

CASE(unit_guards)
{
	struct hawser_beam_integrals is;

	discretisations();
	if (!ok(hawser_beam_method(0)->fill(&is, plain().ends, 8, &report) == HAWSER_OK,
	        "integrals"))
		return done_testing();
	spectra(&is);
	boundaries(&is);
	hawser_beam_integrals_clear(&is);
	maps();
	charts();
	closed_forms();
	return done_testing();
}
