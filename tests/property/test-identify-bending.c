/* Tension and bending stiffness identified from synthetic frequencies of a clamped stay: the right
 * ones, intervals that hold at their level, and what frequencies of a pinned cable do not show.
 * HAWSER_LONG=1: 1000 runs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/identify-levels.h"
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

#include <stdlib.h>
#include <string.h>

#include <hawser/identify.h>

enum { MOST = 12, COUNT = 4 };
static const char *const both[] = {"tension.T0", "cable.EI"};
static const double truth[] = {2.35e6, 4.13e5};

static void open_scene(struct hawser_scene *scene, const char *T0, const char *EI, const char *ends)
{
	static const char text[] = "cable: {EA: 1.1 GN, rho: 47.3 kg/m, EI: 413 kN m2}\n"
	                           "span: {d: 61 m, h: 33 m}\ntension: {T0: 2.35 MN}\n";
	const char *set[4] = {ends, ends + strlen(ends) + 1, T0, EI};
	struct hawser_report report;

	if (read_bytes(scene, text, strlen(text), set, T0 ? 4 : 2, &report)) {
		printf("Bail out! %s\n", report.message);
		exit(1);
	}
}

static const char clamped[] = "ends.A=clamped\0ends.B=clamped",
                  pinned[] = "ends.A=pinned\0ends.B=pinned";

/* The lowest modes in the plane, as a sensor on the deck sees them. */
static int measure(struct hawser_measured *measured, const struct hawser_scene *scene, int count)
{
	struct hawser_modes_options options = {.n = 2*count, .tolerance = 1e-10};
	struct hawser_statics statics;
	struct hawser_modes modes;
	int failed = hawser_statics_scene(&statics, scene, NULL) ||
	             hawser_modes_solve(&modes, &statics, &options, NULL), at = 0;

	for (int k = 0; k < 2*count && !failed && at < count; k++)
		if (modes.mode[k].plane == HAWSER_IN_PLANE)
			measured[at++] = (struct hawser_measured){modes.mode[k].omega/modes.time_unit, 0.0,
				HAWSER_IN_PLANE, 0, modes.mode[k].number};
	if (!failed)
		hawser_modes_clear(&modes);
	return failed || at < count;
}

static void without_noise(void)
{
	struct hawser_identify_options options = {.key = both, .keys = 2};
	struct hawser_measured measured[MOST];
	struct hawser_identified found;
	struct hawser_scene scene, start;
	struct hawser_report report = {0};

	open_scene(&scene, NULL, NULL, clamped);
	open_scene(&start, "tension.T0=2.1 MN", "cable.EI=700 kN m2", clamped);
	ok(!measure(measured, &scene, COUNT), "modes");
	ok(!hawser_identify(&found, &start, measured, COUNT, &options, &report), "identified: %s",
	   report.message);
	close_to(found.key[0].value, truth[0], 1e-6, "T0 from 2.1 MN");
	close_to(found.key[1].value, truth[1], 1e-6, "EI from 700 kN m2");
	ok(found.spread < 1e-9, "nothing is left: %g", found.spread);
	ok(found.correlation[0][1] < -0.9, "tension and EI do about the same: correlation %g",
	   found.correlation[0][1]);
	hawser_identified_clear(&found);
	hawser_scene_clear(&scene);
	hawser_scene_clear(&start);
}

static void levels(int runs, double confidence)
{
	struct hawser_measured exact[MOST];
	struct hawser_scene scene;

	open_scene(&scene, NULL, NULL, clamped);
	ok(!measure(exact, &scene, COUNT), "modes");
	identify_levels(&scene, both, truth, exact, COUNT, runs, confidence, 1, 61);
	hawser_scene_clear(&scene);
}

/* Between pins a slender cable shows no bending stiffness; with some, its interval is wide. */
static void unseen(void)
{
	struct hawser_identify_options options = {.key = both, .keys = 2};
	struct hawser_measured measured[MOST];
	struct hawser_identified found;
	struct hawser_scene scene;
	struct hawser_report report = {0};

	open_scene(&scene, "tension.T0=2.35 MN", "cable.EI=1 N m2", pinned);
	ok(!measure(measured, &scene, 4), "modes");
	ok(hawser_identify(&found, &scene, measured, 4, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "cable.EI has no effect on these frequencies"), "not seen: %s",
	   report.message);
	hawser_identified_clear(&found);
	hawser_scene_clear(&scene);
}

CASE(property_identify_bending)
{
	int runs = getenv("HAWSER_LONG") ? 1000 : 0;

	without_noise();
	if (runs)
		levels(runs, 0.95);
	unseen();
	return done_testing();
}
