/* Parameters identified from synthetic frequencies: the right ones, intervals that hold at their level,
 * modes matched, what cannot be seen refused. HAWSER_LONG=1: 1000 runs for each level.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/identify-levels.h"
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

#include <stdlib.h>
#include <string.h>

#include <hawser/gyroscopic.h>
#include <hawser/identify.h>

enum { MOST = 12 };

/* A stay of 167 m at 29 degrees; `T0` and `EA` may be replaced. */
static void open_scene(struct hawser_scene *scene, const char *T0, const char *EA)
{
	static const char text[] = "cable: {EA: 1.37 GN, rho: 61.3 kg/m}\nspan: {d: 146 m, h: 81 m}\n"
	                           "tension: {T0: 3.85 MN}\n";
	const char *set[2] = {T0, EA};
	struct hawser_report report;

	if (read_bytes(scene, text, strlen(text), set, EA ? 2 : T0 ? 1 : 0, &report)) {
		printf("Bail out! %s\n", report.message);
		exit(1);
	}
}

/* The first `count` modes, their numbers left out if `named` is 0: 1 by place, 2 in their plane. */
static int measure(struct hawser_measured *measured, const struct hawser_scene *scene, int count,
                   int named)
{
	struct hawser_modes_options options = {.n = count, .tolerance = 1e-10};
	struct hawser_statics statics;
	struct hawser_modes modes;
	int failed = hawser_statics_scene(&statics, scene, NULL) ||
	             hawser_steady_modes_solve(&modes, &statics, &options, NULL);

	for (int k = 0; k < count && !failed; k++)
		measured[k] = (struct hawser_measured){
			modes.mode[k].omega/modes.time_unit, 0.0, named == 2 ? (int)modes.mode[k].plane : -1,
			named == 1 ? k + 1 : 0, named == 2 ? modes.mode[k].number : 0};
	if (!failed)
		hawser_modes_clear(&modes);
	return failed;
}

static void without_noise(void)
{
	static const char *const key[] = {"tension.T0", "cable.EA", "cable.rho"};
	struct hawser_identify_options options = {.key = key, .keys = 2};
	struct hawser_measured measured[MOST];
	struct hawser_identified found;
	struct hawser_scene truth, start;
	struct hawser_report report = {0};

	open_scene(&truth, NULL, NULL);
	open_scene(&start, "tension.T0=3.1 MN", "cable.EA=1.9 GN");
	ok(!measure(measured, &truth, 10, 2), "ten modes");
	ok(!hawser_identify(&found, &start, measured, 10, &options, &report), "identified: %s",
	   report.message);
	close_to(found.key[0].value, 3.85e6, 1e-6, "T0 from 3.1 MN");
	close_to(found.key[1].value, 1.37e9, 1e-6, "EA from 1.9 GN");
	ok(found.spread < 1e-9, "nothing is left: %g", found.spread);
	close_to(found.scene.tension.value, found.key[0].value, 1e-15, "the scene has the fitted value");
	hawser_identified_clear(&found);
	/* the same factor for all three changes no frequency */
	options.keys = 3;
	ok(hawser_identify(&found, &start, measured, 10, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "tension.T0 and cable.EA and cable.rho"), "not three: %s",
	   report.message);
	hawser_scene_clear(&truth);
	hawser_scene_clear(&start);
}

/* Starts far off, nothing known of the modes: each must find them. */
static void matched(void)
{
	static const char *const key[] = {"tension.T0"}, *const start_at[] = {"0.35 MN", "60 MN",
		"3.2 MN", "1.9 MN", "5.3 MN", "7.4 MN"};
	struct hawser_identify_options options = {.key = key, .keys = 1};
	struct hawser_scene truth;

	open_scene(&truth, NULL, NULL);
	for (int s = getenv("HAWSER_LONG") ? 0 : 1; s < (getenv("HAWSER_LONG") ? 6 : 3); s++) {
		struct hawser_measured measured[MOST];
		struct hawser_identified found;
		struct hawser_scene start;
		struct hawser_report report = {0};
		char set[64];
		int wrong = 0;

		snprintf(set, sizeof set, "tension.T0=%s", start_at[s]);
		open_scene(&start, set, NULL);
		ok(!measure(measured, &truth, 8, 0), "eight modes");
		measured[2] = measured[7]; /* the third is not measured, and the order is another one */
		ok(!hawser_identify(&found, &start, measured, 7, &options, &report), "from %s: %s",
		   start_at[s], report.message);
		close_to(found.key[0].value, 3.85e6, 1e-6, "T0");
		for (int i = 0; i < found.count; i++)
			wrong += found.mode[i].place != (i == 2 ? 8 : i + 1) || !found.mode[i].matched;
		ok(wrong == 0 && found.skipped == 1, "each measurement has its mode, one was not measured");
		ok(found.margin > 10.0, "no other assignment comes near: %g", found.margin);
		ok(found.doubt >= 0.0 && found.doubtful >= 0, "the most doubtful measurement: %d",
		   found.doubtful + 1);
		hawser_identified_clear(&found);
		hawser_scene_clear(&start);
	}
	hawser_scene_clear(&truth);
}

/* Intervals of frequencies with noise contain the true value as often as they say. `known`: the
 * deviation is given. */
static void levels(int runs, double confidence, int known)
{
	static const char *const key[] = {"tension.T0", "cable.EA"};
	struct hawser_measured exact[MOST];
	struct hawser_scene scene;

	open_scene(&scene, NULL, NULL);
	ok(!measure(exact, &scene, 8, 2), "eight modes");
	identify_levels(&scene, key, (const double [2]){3.85e6, 1.37e9}, exact, 8, runs, confidence, known,
	                2385 + (unsigned long long)known);
	hawser_scene_clear(&scene);
}

static void refused(void)
{
	static const char *const none[] = {"damping.alpha"}, *const unseen[] = {"tension.T0", "g"},
	                  *const word[] = {"tension.branch"}, *const both[] = {"cable.rho", "cable.rho"};
	struct hawser_measured measured[MOST];
	struct hawser_identified found;
	struct hawser_scene scene;
	struct hawser_report report;
	struct hawser_identify_options options = {.key = unseen, .keys = 1};

	open_scene(&scene, NULL, NULL);
	ok(!measure(measured, &scene, 6, 1), "six modes");
	options.key = none;
	ok(hawser_identify(&found, &scene, measured, 6, &options, &report) == HAWSER_ERR_ARGUMENT,
	   "no damping: %s", report.message);
	options.key = word;
	ok(hawser_identify(&found, &scene, measured, 6, &options, &report) == HAWSER_ERR_ARGUMENT,
	   "a word: %s", report.message);
	options.key = both;
	options.keys = 2;
	ok(hawser_identify(&found, &scene, measured, 6, &options, &report) == HAWSER_ERR_ARGUMENT,
	   "twice: %s", report.message);
	ok(hawser_identify(&found, &scene, measured, 1, &options, &report) == HAWSER_ERR_ARGUMENT,
	   "too few: %s", report.message);
	options.key = unseen;
	options.keys = 1;
	measured[3].deviation = 0.01;
	ok(hawser_identify(&found, &scene, measured, 6, &options, &report) == HAWSER_ERR_ARGUMENT,
	   "deviations of some: %s", report.message);
	measured[3].deviation = 0.0;
	measured[3].place = 3;
	ok(hawser_identify(&found, &scene, measured, 6, &options, &report) == HAWSER_ERR_ARGUMENT,
	   "one mode twice: %s", report.message);
	measured[3].omega = -1.0;
	ok(hawser_identify(&found, &scene, measured, 6, &options, &report) == HAWSER_ERR_ARGUMENT,
	   "a negative frequency: %s", report.message);
	hawser_identified_clear(NULL);
	hawser_scene_clear(&scene);
}

CASE(property_identify)
{
	int runs = getenv("HAWSER_LONG") ? 1000 : 16;

	without_noise();
	matched();
	levels(runs, 0.95, 0);
	levels(runs, 0.8, 1);
	refused();
	return done_testing();
}
