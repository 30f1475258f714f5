/* Responses of published models: reads frf-cases.txt, traces each curve in both directions with
 * every method, and compares events.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/frf.h>

#include "tests/tap.h"

static const char *method;

struct curve {
	char name[128];
	struct hawser_rom rom;
	struct hawser_frf frf;
	int open;
};

static const struct hawser_frf_event *nearest(const struct hawser_frf *frf, const char *kind,
                                              double omega)
{
	const struct hawser_frf_event *best = NULL;

	for (int i = 0; i < frf->events; i++) {
		const struct hawser_frf_event *event = &frf->event[i];

		if (!strcmp(hawser_event_name(event->kind), kind) &&
		    (!best || fabs(event->omega - omega) < fabs(best->omega - omega)))
			best = event;
	}
	return best;
}

/* Back from the last orbit, which may differ from the one that continues the linear response there:
 * the same events in reverse order, and the first orbit at the end. */
static void check_retrace(const struct curve *curve, const struct hawser_frf_options *options)
{
	struct hawser_frf_options back = *options;
	struct hawser_frf frf;
	double worst = 0.0;

	back.from = options->to;
	back.to = options->from;
	back.start = curve->frf.state + (size_t)(curve->frf.points - 1)*2*curve->frf.n;
	if (!ok(!hawser_frf_trace(&frf, &curve->rom, &back, NULL), "%s: traced back", curve->name))
		return;
	ok(frf.events == curve->frf.events, "%s: %d events both ways (%d back)", curve->name,
	   curve->frf.events, frf.events);
	for (int i = 0; i < frf.events && i < curve->frf.events; i++)
		worst = fmax(worst, fabs(frf.event[i].omega/
		                         curve->frf.event[curve->frf.events - 1 - i].omega - 1.0));
	ok(worst < 1e-9, "%s: the same Omega both ways: %.1e", curve->name, worst);
	for (int j = 0; j < frf.n; j++) {
		double end = frf.coordinate[(size_t)(frf.points - 1)*frf.n + j];

		ok(fabs(end/curve->frf.coordinate[j] - 1.0) < 1e-7, "%s: coordinate %d ends where "
		   "it began: %.12g, %.12g", curve->name, j, curve->frf.coordinate[j], end);
	}
	hawser_frf_clear(&frf);
}

/* From a scene file to its model. */
static enum hawser_status from_scene(struct hawser_rom *rom, const char *path,
                                     struct hawser_report *report)
{
	struct hawser_scene scene = {.name = NULL};
	struct hawser_statics statics;
	struct hawser_modes modes = {.n = 0};
	enum hawser_status status = hawser_scene_open(&scene, path, NULL, 0, report);
	struct hawser_modes_options options = {.tolerance = 1e-11};

	options.n = scene.model.modes;
	if (!status)
		status = hawser_statics_scene(&statics, &scene, report);
	if (!status)
		status = hawser_modes_solve(&modes, &statics, &options, report);
	if (!status)
		status = hawser_rom_build(rom, &modes, &scene, report);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
	return status;
}

/* The range of a model file is in its own units, that of a scene in multiples of the first
 * frequency. */
static void trace(struct curve *curve, const char *name, int is_scene, double from, double to)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_report report = {.message = ""};
	const char *path = source_file("%s/%s", is_scene ? "notebooks-data/scenes" : "tests/reference",
	                               name);
	double residual = 0.0, liouville = 0.0, unit;

	snprintf(curve->name, sizeof curve->name, "%s", name);
	if (!ok(!(is_scene ? from_scene(&curve->rom, path, &report)
	                   : hawser_rom_open(&curve->rom, path, &report)), "%s %s", name,
	        report.message))
		return;
	unit = is_scene ? sqrt(curve->rom.K[0]) : 1.0;
	options.from = from*unit;
	options.to = to*unit;
	options.tolerance = 1e-10;
	options.method = method;
	options.samples = HAWSER_NONE; /* every method has its turn */
	curve->open = ok(!hawser_frf_trace(&curve->frf, &curve->rom, &options, &report), "%s %s",
	                 name, report.message);
	if (!curve->open)
		return;
	for (int i = 0; i < curve->frf.points; i++) {
		residual = fmax(residual, curve->frf.point[i].residual);
		liouville = fmax(liouville, curve->frf.point[i].liouville);
	}
	ok(residual <= 1e-10 && liouville < 1e-6, "%s: %d points, residual %.1e, Liouville gap %.1e",
	   name, curve->frf.points, residual, liouville);
	for (int i = 0; i < curve->frf.events; i++)
		ok(!curve->frf.event[i].suspected, "%s: event at %.9f is confirmed by the "
		   "multipliers", name, curve->frf.event[i].omega);
	/* models in a second; scenes back by shooting, by all methods with HAWSER_LONG */
	if (!is_scene || !strcmp(method, "shooting") || getenv("HAWSER_LONG"))
		check_retrace(curve, &options);
}

static void finish(struct curve *curve)
{
	hawser_frf_clear(&curve->frf);
	hawser_rom_clear(&curve->rom);
	memset(curve, 0, sizeof *curve);
}

static void obey(struct curve *curve, const char *line)
{
	char word[64], kind[64];
	double from, to, omega;
	int digits, total;

	if (sscanf(line, "model %63s %lf %lf", word, &from, &to) == 3) {
		finish(curve);
		trace(curve, word, 0, from, to);
	} else if (sscanf(line, "scene %63s %lf %lf", word, &from, &to) == 3) {
		finish(curve);
		trace(curve, word, 1, from, to);
	} else if (sscanf(line, "event %63s %lf %d", kind, &omega, &digits) == 3 && curve->open) {
		const struct hawser_frf_event *event = nearest(&curve->frf, kind, omega);

		ok(event && fabs(event->omega - omega) <= 0.51*pow(10, -digits),
		   "%s: %s at %.*f (found %.12f)", curve->name, kind, digits, omega,
		   event ? event->omega : NAN);
	} else if (sscanf(line, "total %d", &total) == 1 && curve->open) {
		ok(curve->frf.events == total, "%s: %d events in all (found %d)", curve->name, total,
		   curve->frf.events);
	} else if (line[0] != '#' && line[0] != '\n' && strncmp(line, "source", 6)) {
		ok(0, "understood: %s", line);
	}
}

static void check_cases(void)
{
	struct curve curve = {.name = ""};
	const char *path = source_file("tests/reference/frf-cases.txt");
	FILE *cases = fopen(path, "r");
	char line[512];

	if (ok(cases != NULL, "%s is there", path)) {
		while (fgets(line, sizeof line, cases))
			obey(&curve, line);
		fclose(cases);
	}
	finish(&curve);
}

CASE(reference_frf_published)
{
	for (int i = 0; hawser_frf_method(i); i++) {
		if (hawser_frf_method(i)->approximate)
			continue;
		method = hawser_frf_method(i)->name;
		printf("# %s\n", method);
		check_cases();
	}
	return done_testing();
}
