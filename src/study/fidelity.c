/* study/fidelity.c - the table of fidelities, and how each makes its model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "hawser/study.h"

static enum hawser_status build(struct hawser_rom *rom, const struct hawser_statics *statics,
                                const struct hawser_scene *scene, int n,
                                enum hawser_condensation condense, struct hawser_report *report)
{
	struct hawser_scene changed = *scene; /* the name stays the caller's */
	struct hawser_modes_options options = {.n = n, .basis = scene->model.basis};
	struct hawser_modes modes;
	enum hawser_status status;

	changed.model.condense = condense;
	if (hawser_scene_written(scene, "model.tolerance"))
		options.tolerance = scene->model.tolerance;
	status = hawser_modes_solve(&modes, statics, &options, report);
	if (status)
		return status;
	status = hawser_rom_build(rom, &modes, &changed, report);
	hawser_modes_clear(&modes);
	return status;
}

static enum hawser_status build_raw(struct hawser_rom *rom, const struct hawser_statics *statics,
                                    const struct hawser_scene *scene, int n,
                                    struct hawser_report *report)
{
	return build(rom, statics, scene, n, HAWSER_CONDENSE_NONE, report);
}

static enum hawser_status build_condensed(struct hawser_rom *rom,
                                          const struct hawser_statics *statics,
                                          const struct hawser_scene *scene, int n,
                                          struct hawser_report *report)
{
	return build(rom, statics, scene, n, HAWSER_CONDENSE_STATIC, report);
}

static const struct hawser_fidelity rows[] = {
	{"raw", "the first N modes, all others at rest", "Bertrand 2022, 4.2", 1, build_raw},
	{"condensed", "the first N modes, all others following them statically",
	 "doc/theory-rom.md, Condensation", 1, build_condensed},
};

const struct hawser_fidelity *hawser_fidelities(int *count)
{
	*count = (int)(sizeof rows/sizeof *rows);
	return rows;
}
