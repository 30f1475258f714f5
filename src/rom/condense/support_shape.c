/* rom/condense/support_shape.c - quasi-static displacements by displacements of the ends.
 *
 *   Delta        displacement of end B, or of its foundation if it is on springs; A is fixed
 *   F            change of the force in the cable, constant between springs of attachments
 *
 * Without a load on the cable its strains are those of F, whose integral is the displacement, Delta at
 * end B. F solves the system of ties.c, with a displacement of the ends in the place of a load. This is
 * the linearised elastic catenary; without springs A^-1 is the stiffness of the cable at its end, in
 * the direction of the chord of a shallow one (EA/L)/(1 + lambda^2/12) with the Irvine parameter
 * lambda^2. A translation of both ends pulls at the springs of attachments. A clamp moves without
 * turning.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "core/vec3.h"
#include "modes/grid.h"
#include "modes/label.h"
#include "rom/condense/follow.h"
#include "rom/condense/support.h"

/* The right-hand side of shape i: a unit displacement of end B, or of both ends, along an axis. */
static void set_unit(struct hawser__ties *ties, int i, const struct hawser_statics *st)
{
	double chord = hypot(1.0, st->hs), c = 1.0/chord, s = st->hs/chord;
	const double along[3][3] = {{c, -s, 0.0}, {s, c, 0.0}, {0.0, 0.0, 1.0}};
	const double *unit = along[i%HAWSER__AXES];

	memset(ties->z, 0, sizeof ties->z);
	for (int a = 0; a < HAWSER__AXES && i < HAWSER__AXES; a++)
		ties->z[a] = -unit[a];
	for (int a = HAWSER__AXES; a < ties->size && i >= HAWSER__AXES; a++)
		ties->z[a] = hawser__dot(ties->spring[a - HAWSER__AXES].h, unit);
}

/* strain [points][3] of shape i, and the displacement of end A. */
static void follow_end(double *strain, double start[3], struct hawser__ties *ties, int i,
                    const struct hawser_statics *st)
{
	double stretch[HAWSER__TIE_SPRINGS];

	set_unit(ties, i, st);
	memset(strain, 0, 3*(size_t)ties->count*sizeof *strain);
	hawser__ties_settle(ties, strain);
	for (int m = 0; m < hawser__ties_springs(ties); m++)
		stretch[m] = hawser__ties_stretch(ties, m);
	hawser__ties_start(start, ties, stretch);
}

static enum hawser_status make(struct hawser__support_shapes *shapes, const struct hawser_modes *modes,
                               struct hawser__ties *ties, const struct hawser__reference *reference,
                               struct hawser_report *report)
{
	const struct hawser_grid *grid = &modes->grid;
	const struct hawser_statics *st = &modes->statics;
	size_t points = (size_t)grid->points, each = 3*points, marks = (size_t)hawser__points(st);
	double *work = malloc(each*sizeof *work);

	*shapes = (struct hawser__support_shapes){.points = grid->points,
		.count = ties->size > HAWSER__AXES ? HAWSER__SUPPORT_MOST : HAWSER__AXES};
	shapes->strain = hawser__numbers((size_t)shapes->count, each);
	shapes->shape = hawser__numbers((size_t)shapes->count, each);
	shapes->at = hawser__numbers((size_t)shapes->count, 3*marks);
	if (!work || !shapes->strain || !shapes->shape || !shapes->at) {
		free(work);
		return hawser__no_memory(report, "rom");
	}
	for (int i = 0; i < shapes->count; i++) {
		double *strain = shapes->strain + (size_t)i*each, *shape = shapes->shape + (size_t)i*each;
		double start[3];

		follow_end(strain, start, ties, i, st);
		hawser__displacement(shape, grid, reference, st, strain, start, work);
		for (size_t m = 0; m < 3*marks; m++)
			hawser__grid_at(shapes->at + (size_t)i*3*marks + m, grid, shape + m%3*points, 1, 1,
			                hawser__point(st, (int)(m/3)).s);
	}
	free(work);
	return HAWSER_OK;
}

enum hawser_status hawser__support_shapes_make(struct hawser__support_shapes *shapes,
                                               const struct hawser_modes *modes,
                                               struct hawser_report *report)
{
	struct hawser__stations stations;
	struct hawser__reference reference = {0};
	enum hawser_status status = hawser__stations_make(&stations, modes, 0, NULL, 0, report);

	*shapes = (struct hawser__support_shapes){.count = 0};
	if (!status)
		status = hawser__reference_init(&reference, &modes->grid, modes->grid.order - 1, report);
	if (!status)
		status = make(shapes, modes, stations.ties, &reference, report);
	hawser__reference_clear(&reference);
	hawser__stations_clear(&stations);
	if (status)
		hawser__support_shapes_clear(shapes);
	return status;
}

void hawser__support_shapes_clear(struct hawser__support_shapes *shapes)
{
	free(shapes->strain);
	free(shapes->shape);
	free(shapes->at);
	*shapes = (struct hawser__support_shapes){.points = 0};
}
