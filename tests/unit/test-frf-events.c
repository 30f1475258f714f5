/* Several events in one step of the curve. Each model has a driven linear oscillator, which
 * determines the orbit, and oscillators at rest whose stiffness varies with the forcing. They are
 * not coupled, so that the events of the model are those of each oscillator alone.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/frf.h>
#include <hawser/rom.h>

#include "core/order.h"
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

enum { MOST = 16 };

static const char *method;

static struct hawser_frf_options options_of(double from, double to)
{
	struct hawser_frf_options options = {.method = NULL};

	options.from = from;
	options.to = to;
	options.method = method;
	options.samples = HAWSER_NONE;
	return options;
}

/* Oscillator j of `count`: w[j], modulated by depth cos(Omega t). */
static void parametric(struct hawser_rom *rom, const double *w, int count, double damping, double depth)
{
	int n = count + 1;

	*rom = (struct hawser_rom){.n = n, .time = 1.0, .length = 1.0, .harmonics = 2};
	rom->D = calloc((size_t)n*n, sizeof(double));
	rom->K = calloc((size_t)n*n, sizeof(double));
	rom->harmonic = calloc(2, sizeof *rom->harmonic);
	rom->harmonic[0].k = rom->harmonic[1].k = 1;
	rom->harmonic[0].f = calloc((size_t)n, sizeof(double));
	rom->harmonic[1].K = calloc((size_t)n*n, sizeof(double));
	rom->D[0] = 0.1;
	rom->K[0] = 1.0;
	rom->harmonic[0].f[0] = 0.1;
	for (int j = 1; j < n; j++) {
		int at = j*(n + 1);

		rom->D[at] = damping;
		rom->K[at] = w[j - 1]*w[j - 1];
		rom->harmonic[1].K[at] = depth;
	}
	ok(!hawser_rom_compile(rom, NULL), "compiled");
}

/* 1 if the events agree with the counts at the points. */
static void check_counts(const struct hawser_frf *frf, const char *name)
{
	int unexplained = 0, contradictions = 0;

	for (int p = 0, e = 0; p + 1 < frf->points; p++) {
		int change = frf->point[p + 1].unstable - frf->point[p].unstable, least = 0, most = 0;

		for (; e < frf->events && frf->event[e].after == p; e++) {
			int width = frf->event[e].kind == HAWSER_TORUS ? 2 : 1;

			unexplained += frf->event[e].kind == HAWSER_UNEXPLAINED ||
			               frf->event[e].suspected || !frf->event[e].located;
			least -= width;
			most += width;
		}
		contradictions += change < least || change > most || (change - most)%2 != 0;
	}
	ok(unexplained == 0 && contradictions == 0, "%s, %s: every change of stability is explained "
	   "(%d, %d are not)", name, method, unexplained, contradictions);
}

/* The events of one oscillator alone added to omega[*count]. */
static void alone(double *omega, int *count, double w, double damping, double depth,
                  const struct hawser_frf_options *options)
{
	struct hawser_rom rom;
	struct hawser_frf frf;

	parametric(&rom, &w, 1, damping, depth);
	if (ok(!hawser_frf_trace(&frf, &rom, options, NULL), "traced alone"))
		for (int e = 0; e < frf.events && *count < MOST; e++)
			omega[(*count)++] = frf.event[e].omega;
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

static void check_union(const char *name, const double *w, int count, double damping, double depth,
                        double from, double to)
{
	struct hawser_frf_options options = options_of(from, to);
	struct hawser_rom rom;
	struct hawser_frf frf;
	double expected[MOST], worst = 0.0;
	int events = 0;

	for (int j = 0; j < count; j++)
		alone(expected, &events, w[j], damping, depth, &options);
	qsort(expected, (size_t)events, sizeof *expected, hawser__ascending);
	parametric(&rom, w, count, damping, depth);
	if (ok(!hawser_frf_trace(&frf, &rom, &options, NULL), "%s, %s: traced", name, method)) {
		ok(events == 2*count && frf.events == events, "%s, %s: %d events as alone (%d)", name,
		   method, frf.events, events);
		for (int e = 0; e < events && e < frf.events; e++)
			worst = fmax(worst, fabs(frf.event[to > from ? e : events - 1 - e].omega/
			                         expected[e] - 1.0)/
			                    (2.0*frf.event[e].error + 1e-9));
		ok(worst <= 1.0, "%s, %s: where they are alone: %.2g of the errors", name, method, worst);
		check_counts(&frf, name);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* Two oscillators whose coupling is depth times cos(Omega t): a torus point where Omega enters the
 * resonance at w1 + w2, and one where it leaves it. */
static void coupled(struct hawser_rom *rom, const double *w, double damping, double depth)
{
	parametric(rom, w, 2, damping, 0.0);
	rom->harmonic[1].K[1*3 + 2] = rom->harmonic[1].K[2*3 + 1] = depth;
	ok(!hawser_rom_compile(rom, NULL), "compiled anew");
}

/* The unstable range is shorter than a step: the events must be those found with short steps. */
static void check_collision(const double *w, double damping, double depth, double from, double to)
{
	struct hawser_frf_options options = options_of(from, to), fine = options;
	struct hawser_rom rom;
	struct hawser_frf frf, reference;
	double worst = 0.0;

	fine.from = w[0] + w[1] - 0.01;
	fine.to = w[0] + w[1] + 0.01;
	fine.step_max = 0.005;
	coupled(&rom, w, damping, depth);
	if (ok(!hawser_frf_trace(&frf, &rom, &options, NULL) &&
	       !hawser_frf_trace(&reference, &rom, &fine, NULL), "a collision, %s: traced", method)) {
		ok(reference.events == 2 && frf.events == 2, "a collision, %s: two torus points (%d, %d "
		   "by short steps)", method, frf.events, reference.events);
		for (int e = 0; e < frf.events && e < reference.events; e++)
			worst = fmax(worst, fabs(frf.event[e].omega/reference.event[e].omega - 1.0)/
			                    (2.0*frf.event[e].error));
		ok(worst <= 1.0, "a collision, %s: where short steps find them: %.2g of the errors",
		   method, worst);
		check_counts(&frf, "a collision");
	}
	hawser_frf_clear(&frf);
	hawser_frf_clear(&reference);
	hawser_rom_clear(&rom);
}

/* A short span whose response nearly touches a closed curve: a long step would jump to it and
 * follow it without end. The events with long steps must be those with short steps. */
static void check_jump(void)
{
	static const char text[] =
		"cable: {EA: 90 kN, rho: 4 g/m}\n"
		"span: {d: 0.5 m, h: 0.04 m}\n"
		"tension: {T1: 30 N}\n"
		"damping: {ratio: 0.4 %}\n"
		"load: {frame: local, per_length: [0, 0.03, 0.02]}\n";
	static const double step[] = {0.02, 0.005};
	struct hawser_report report = {0};
	struct hawser_modes_options two = {.n = 2};
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes modes;
	struct hawser_rom rom;
	struct hawser_frf frf[2];
	double worst = 0.0;

	if (!ok(!read_text(&scene, text, NULL, &report) &&
	        !hawser_statics_scene(&statics, &scene, &report) &&
	        !hawser_modes_solve(&modes, &statics, &two, &report) &&
	        !hawser_rom_build(&rom, &modes, &scene, &report), "a short span %s", report.message))
		return;
	for (int i = 0; i < 2; i++) {
		double first = modes.mode[0].omega;
		struct hawser_frf_options options = options_of(0.85*first, 1.2*first);
		enum hawser_status status;

		options.step_max = step[i];
		status = hawser_frf_trace(&frf[i], &rom, &options, &report);
		ok(!status && frf[i].end == HAWSER_END_RANGE, "steps up to %g: %d points, %d events %s",
		   step[i], frf[i].points, frf[i].events, report.message);
	}
	ok(frf[0].events == frf[1].events && frf[0].events == 6, "as many events");
	for (int e = 0; e < frf[0].events && e < frf[1].events; e++)
		worst = fmax(worst, fabs(frf[0].event[e].omega/frf[1].event[e].omega - 1.0));
	ok(worst < 1e-6, "in the same places, %.1e", worst);
	for (int i = 0; i < 2; i++)
		hawser_frf_clear(&frf[i]);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

CASE(unit_frf_events)
{
	const double near[] = {1.0, 1.00001}, nearer[] = {1.0, 1.0000001}, three[] = {1.0, 1.0007, 1.004};
	const double meet[] = {1.10071, 1.697124};

	for (int i = 0; hawser_frf_method(i); i++) {
		if (hawser_frf_method(i)->approximate)
			continue;
		method = hawser_frf_method(i)->name;
		check_union("two the same way", near, 2, 0.02, 0.2, 1.8, 2.2);
		check_union("two the same way, backwards", near, 2, 0.02, 0.2, 2.2, 1.8);
		check_union("two that coincide nearly", nearer, 2, 0.02, 0.2, 1.8, 2.2);
		check_union("three the same way", three, 3, 0.02, 0.2, 1.8, 2.2);
		check_collision(meet, 0.00017922494884511117, 0.0008016371804981937, 2.23827, 3.3574);
		check_collision(meet, 0.00017922494884511117, 0.0008016371804981937, 2.23827, 3.3);
	}
	method = NULL;
	check_jump();
	return done_testing();
}
