/* The scenes of the sources' tables: every number of the tables, in SI, is that of the scene files.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/scene.h>
#include "tests/tap.h"

/* Bertrand (2022), Tables 4.1 to 4.6 and 5.1 to 5.4. NAN: not given in the table, so that the scene
 * may have any value. */
static const struct {
	const char *file;
	double EA, rho, d, h;
	enum hawser_given given;
	double tension, alpha, load;
	enum hawser_frame frame;
} table[] = {
	{"b-table-4.1-case-1", 235e6, 12.94, 100, NAN, HAWSER_GIVEN_H, NAN, 0, 0, 0},
	{"b-table-4.1-case-2", 40e6, 6, 100, NAN, HAWSER_GIVEN_H, NAN, 0, 0, 0},
	{"b-table-4.1-case-3", 1e6, 3, 100, NAN, HAWSER_GIVEN_H, NAN, 0, 0, 0},
	{"b-table-4.2", 400e6, 6, 250, 10, HAWSER_GIVEN_T0, 80e3, 0.08, 0.8, HAWSER_FRAME_LOCAL},
	{"b-table-4.3-line-1", 400e6, 5.56, 300, 10, HAWSER_GIVEN_T0, 111.58e3, 0.08, 0.0001,
	 HAWSER_FRAME_GLOBAL},
	{"b-table-4.3-line-2", 100e6, 5.56, 300, 15, HAWSER_GIVEN_T0, 80e3, 0.08, 0.8,
	 HAWSER_FRAME_GLOBAL},
	{"b-table-4.4-line-1", 400e6, 5.56, 300, 10, HAWSER_GIVEN_T0, 111.58e3, 0.2, 0.0001,
	 HAWSER_FRAME_GLOBAL},
	{"b-table-4.4-line-2", 100e6, 5.56, 300, 15, HAWSER_GIVEN_T0, 80e3, 0.2, 0.8,
	 HAWSER_FRAME_GLOBAL},
	{"b-table-4.5", 400e6, 5, 300, 10, HAWSER_GIVEN_H, 100e3, 0.08, 0.3, HAWSER_FRAME_LOCAL},
	{"b-table-4.6-in-plane", 400e6, 5, 300, 10, HAWSER_GIVEN_H, 100e3, 0.08, 0.3,
	 HAWSER_FRAME_LOCAL},
	{"b-table-4.6-out-of-plane", 400e6, 5, 300, 10, HAWSER_GIVEN_H, 100e3, 0.08, 0.3,
	 HAWSER_FRAME_LOCAL},
	{"b-table-5.1-ropeway", 235e6, 12.94, 100, NAN, HAWSER_GIVEN_H, NAN, 0, 0, 0},
	{"b-table-5.1-hauling-rope", 40e6, 6, 100, NAN, HAWSER_GIVEN_H, NAN, 0, 0, 0},
	{"b-table-5.1-fictitious", 1e6, 3, 100, NAN, HAWSER_GIVEN_H, NAN, 0, 0, 0},
	{"b-table-5.2", 100e6, 5, 100, 5, HAWSER_GIVEN_T0, 85e3, 0, 0, 0},
	{"b-table-5.3", 100e6, 5, 100, 5, HAWSER_GIVEN_T0, 85e3, 0, 0, 0},
	{"b-table-5.4-at-rest", 100e6, 5, 80, 5, HAWSER_GIVEN_H, 80e3, 0.2, NAN, HAWSER_FRAME_GLOBAL},
	{"b-table-5.4", 100e6, 5, 80, 5, HAWSER_GIVEN_H, 80e3, 0.2, 0, 0},
	{"b-table-5.5", 100e6, 5, 80, 5, HAWSER_GIVEN_H, 80e3, 0, 0, 0},
	{"b-table-5.6", 40e6, 4, 80, 5, HAWSER_GIVEN_H, 84e3, 0, -490.5, HAWSER_FRAME_GLOBAL},
};

static int is(double got, double want)
{
	return isnan(want) ? isfinite(got) : fabs(got - want) <= 4e-16*fabs(want);
}

/* Every component of the load is zero or that of the table, and at least one is not zero. */
static int load_is(const struct hawser_scene *scene, double want)
{
	int some = 0;

	for (int i = 0; i < 3; i++) {
		if (scene->load.per_length[i] != 0.0 && !is(scene->load.per_length[i], want))
			return 0;
		some |= scene->load.per_length[i] != 0.0;
	}
	return scene->load.present ? some : want == 0.0;
}

static void check(int i)
{
	struct hawser_report report = {.message = ""};
	struct hawser_scene scene;
	const char *path = source_file("notebooks-data/scenes/%s.yaml", table[i].file);

	if (!ok(hawser_scene_open(&scene, path, NULL, 0, &report) == HAWSER_OK, "%s%s%s",
	        table[i].file, *report.message ? ": " : "", report.message))
		return;
	ok(is(scene.cable.EA, table[i].EA) && is(scene.cable.rho, table[i].rho), "cable");
	ok(is(scene.span.d, table[i].d) && is(scene.span.h, table[i].h), "span");
	ok(scene.tension.given == table[i].given && is(scene.tension.value, table[i].tension),
	   "tension");
	ok(is(scene.damping.alpha, table[i].alpha), "damping");
	ok(load_is(&scene, table[i].load) && scene.load.frame == table[i].frame, "load");
	ok(scene.g == 9.81, "g");
	hawser_scene_clear(&scene);
}

CASE(unit_scene_files)
{
	for (int i = 0; i < (int)(sizeof table/sizeof *table); i++)
		check(i);
	return done_testing();
}
