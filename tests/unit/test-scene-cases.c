/* Load cases of a scene: what they take from it, that they are written and read again, and refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

#define WHOLE "cable: {EA: 4e8, rho: 6}\nspan: {d: 250, h: 10}\ntension: {T0: 8e4}\n"

static const struct {
	const char *text, *set, *message;
} refusals[] = {
	{WHOLE, "cases=3",
	 "--set cases=3: cases must be a list of mappings, such as [{name: ice, load: {static: {mass: 0.9 "
	 "kg/m}}}]"},
	{WHOLE, "cases=[3]",
	 "--set cases=[3]: cases[0] must be a mapping, such as {name: ice, load: {static: {mass: 0.9 "
	 "kg/m}}}"},
	{WHOLE, "cases=[{load: {static: {mass: 1}}}]",
	 "--set cases=[{load: {static: {mass: 1}}}]: cases[0] has no name: give it one, such as name: ice"},
	{WHOLE, "cases=[{name: a}, {name: a}]",
	 "--set cases=[{name: a}, {name: a}]: cases[0] and cases[1] have the same name a: give different "
	 "ones"},
	{WHOLE, "cases=[{name: a, name: b}]",
	 "--set cases=[{name: a, name: b}]: duplicate key name, already given in the same "
	 "override: keep one"},
	{WHOLE, "cases=[{name: 'a:b'}]",
	 "--set cases=[{name: 'a:b'}]: cases[0].name must be a word or a few, of at most 31 characters, "
	 "without quotes, tabs and \\ # { } [ ] , :"},
	{WHOLE, "cases=[{name: a, span: 3}]",
	 "--set cases=[{name: a, span: 3}]: unknown key cases[0].span: did you mean span at the top "
	 "level? cases[0] takes name, load, temperature, wind"},
	{WHOLE, "cases=[{name: a, load: {frame: local}}]",
	 "--set cases=[{name: a, load: {frame: local}}]: unknown key cases[0].load.frame: did you mean "
	 "frame under cases[].load.static? cases[0].load takes static"},
	{WHOLE, "cases=[{name: a, temperature: {}}]",
	 "--set cases=[{name: a, temperature: {}}]: cases[0].temperature.change is missing: give a "
	 "number in K (as temperature.change)"},
	{WHOLE, "cases=[{name: a, temperature: {change: 3}}]",
	 "--set cases=[{name: a, temperature: {change...: cases[0] (a) has no temperature.expansion, and "
	 "neither has the scene: give it in 1/K in one of them"},
	{WHOLE "cases: []\ncases: []\n", NULL,
	 "s.yaml:5:1: duplicate key cases, already given in line 4: keep one"},
};

static void refuse(void)
{
	for (size_t i = 0; i < sizeof refusals/sizeof *refusals; i++) {
		struct hawser_report report = {.message = ""};
		struct hawser_scene scene;

		ok(read_text(&scene, refusals[i].text, refusals[i].set, &report) == HAWSER_ERR_SCENE &&
		   !strcmp(report.message, refusals[i].message), "refused: %s", report.message);
	}
}

/* Load cases: what they take from the scene, and that they are written and read again. */
static void load_cases(void)
{
	static const char text[] = "cable: {EA: 25 MN, rho: 1.6}\nspan: {d: 400, h: 12}\n"
	                           "tension: {H: 28 kN}\ntemperature: {change: 7, expansion: 1.9e-5}\n"
	                           "load: {static: {mass: 0.3}}\ncases:\n  - {name: hot day, "
	                           "temperature: {change: 55 K}}\n  - {name: ice, load: {static: {mass: "
	                           "0.9, per_length: [0, -1, 2.385]}}}\n";
	struct hawser_report report = {.message = ""};
	struct hawser_scene scene, one, again;
	char *written = NULL;
	size_t size = 0;
	FILE *stream = open_memstream(&written, &size);

	if (!ok(stream && !read_text(&scene, text, NULL, &report), "cases %s", report.message))
		return;
	hawser_scene_case(&one, &scene, 0);
	ok(scene.cases == 2 && !strcmp(scene.load_case[0].name, "hot day") &&
	   one.temperature.change == 55.0 && one.temperature.expansion == 1.9e-5 &&
	   !one.static_load.present && one.static_load.mass == 0.0, "a case replaces load and change");
	hawser_scene_case(&one, &scene, 1);
	ok(!one.temperature.present && one.static_load.present && one.static_load.mass == 0.9 &&
	   one.static_load.per_length[2] == 2.385, "a case without temperature has no change of it");
	ok(!hawser_scene_write(&scene, stream, &report) && !fclose(stream), "written");
	if (ok(!read_text(&again, written, NULL, &report), "read again %s", report.message)) {
		ok(again.cases == 2 &&
		   !memcmp(again.load_case, scene.load_case, 2*sizeof *scene.load_case), "the same cases");
		hawser_scene_clear(&again);
	}
	free(written);
	hawser_scene_clear(&scene);
	if (!ok(!read_text(&again, text, "cases.ice.load.static.mass=0.7", &report),
	        "a key of a case is set %s", report.message))
		return;
	ok(again.load_case[1].mass == 0.7 && again.load_case[1].per_length[2] == 2.385 &&
	   !again.load_case[1].heated && again.load_case[0].change == 55.0, "and no other");
	hawser_scene_clear(&again);
}

CASE(unit_scene_cases)
{
	refuse();
	load_cases();
	return done_testing();
}
