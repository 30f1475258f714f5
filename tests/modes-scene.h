/* tests/modes-scene.h - spans of the source's example cables (B Table 4.1) for tests of the modes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_MODES_SCENE_H
#define HAWSER_TESTS_MODES_SCENE_H

#include <hawser/modes.h>
#include <stdio.h>
#include <stdlib.h>

#include "tests/tap.h"

/* The same span at a horizontal tension of ratio*EA. */
static inline int tighten(struct hawser_statics *st, double ratio)
{
	struct hawser_span span = st->span;
	struct hawser_report report;

	if (!hawser_statics_solve(st, &span, HAWSER_GIVEN_H, ratio*span.EA, HAWSER_BRANCH_TAUT,
	                          &report))
		return 1;
	printf("# %s\n", report.message);
	st->span = span;
	return 0;
}

/* Cable `which` (1..3) of B Table 4.1 with slope h/d and a horizontal tension of ratio*EA. Zero if
 * the scene cannot be read. */
static inline int table_4_1(struct hawser_statics *st, int which, double slope, double ratio)
{
	struct hawser_report report;
	struct hawser_scene scene;
	const char *path = source_file("notebooks-data/scenes/b-table-4.1-case-%d.yaml", which);

	if (hawser_scene_open(&scene, path, NULL, 0, &report)) {
		printf("# %s\n", report.message);
		return 0;
	}
	st->span = (struct hawser_span){scene.cable.EA, scene.cable.rho, scene.g, scene.span.d,
	                                slope*scene.span.d};
	hawser_scene_clear(&scene);
	return tighten(st, ratio);
}

#endif
