/* Fidelities of a scene: the table, and what its rows build.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>

#include <hawser/study.h>

#include "tests/tap.h"

/* A row makes a model of the modes that it was asked for. */
static void check_row(const struct hawser_fidelity *row, const struct hawser_statics *statics,
                      const struct hawser_scene *scene)
{
	struct hawser_report report = {.message = ""};
	struct hawser_rom rom;

	if (!ok(!row->build(&rom, statics, scene, 5, &report), "%s builds %s", row->name,
	        report.message))
		return;
	ok(rom.n == 5 && rom.cubics > 0, "%s: %d modes, %d cubic entries", row->name, rom.n,
	   rom.cubics);
	hawser_rom_clear(&rom);
}

int main(void)
{
	struct hawser_report report = {.message = ""};
	struct hawser_scene scene;
	struct hawser_statics statics;
	char path[4096];
	int count;
	const struct hawser_fidelity *row = hawser_fidelities(&count);

	ok(count >= 2, "%d fidelities", count);
	snprintf(path, sizeof path, "%s/notebooks-data/scenes/b-table-4.2.yaml",
	         getenv("SRCDIR") ? getenv("SRCDIR") : ".");
	if (!ok(!hawser_scene_open(&scene, path, NULL, 0, &report) &&
	        !hawser_statics_scene(&statics, &scene, &report), "the scene %s", report.message))
		return done_testing();
	for (int i = 0; i < count; i++)
		check_row(&row[i], &statics, &scene);
	hawser_scene_clear(&scene);
	return done_testing();
}
