/* cli/hill_sides.c - which parts of a plane of two parameters are unstable, for the picture of hill.
 *
 * The multipliers are asked for on rows of the plane; where stability changes between two neighbours of
 * a row, the place is bisected, so that a row's boxes end on the boundary.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>

#include "cli/hill_result.h"
#include "core/report.h"

enum { ROWS = 100, CELLS = 120, HALVINGS = 8 };
static const double outside = 1e-6; /* logarithm of a modulus: above the round-off of a double one */
static const double overlap = 0.1;  /* of a row, so that no seam shows between two */

struct plane {
	const struct hawser_hill_field *field;
	double *log_modulus, *argument; /* [m] */
	double from[2], to[2];
	double *box; /* [boxes][4] */
	int boxes;
};

static enum hawser_status ask(int *unstable, struct plane *plane, double x, double y,
                              struct hawser_report *report)
{
	const struct hawser_hill_field *field = plane->field;
	enum hawser_status status = field->multipliers(field->context, plane->log_modulus,
	                                               plane->argument, x, y, report);

	*unstable = 0;
	for (int i = 0; !status && i < field->m; i++)
		*unstable |= plane->log_modulus[i] > outside;
	return status;
}

/* Between two neighbours, `low` as unstable as `left` says and `high` not so, or the reverse. */
static enum hawser_status change(double *at, struct plane *plane, double low, double high, double y,
                                 int left, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int k = 0; !status && k < HALVINGS; k++) {
		int unstable;

		*at = 0.5*(low + high);
		status = ask(&unstable, plane, *at, y, report);
		if (unstable == left)
			low = *at;
		else
			high = *at;
	}
	return status;
}

static void add(struct plane *plane, double from, double to, double y)
{
	double half = (0.5 + overlap)*(plane->to[1] - plane->from[1])/ROWS;
	double *box = plane->box + 4*(size_t)plane->boxes++;

	box[0] = from;
	box[1] = y - half < plane->from[1] ? plane->from[1] : y - half;
	box[2] = to;
	box[3] = y + half > plane->to[1] ? plane->to[1] : y + half;
}

static enum hawser_status row(struct plane *plane, double y, struct hawser_report *report)
{
	double wide = plane->to[0] - plane->from[0], begin = plane->from[0], last = begin, at = begin;
	int now, before;
	enum hawser_status status = ask(&before, plane, last, y, report);

	for (int i = 1; !status && i <= CELLS; i++) {
		double x = plane->from[0] + wide*i/CELLS;

		status = ask(&now, plane, x, y, report);
		if (!status && now != before) {
			status = change(&at, plane, last, x, y, before, report);
			if (before)
				add(plane, begin, at, y);
			begin = at;
		}
		before = now;
		last = x;
	}
	if (!status && before)
		add(plane, begin, plane->to[0], y);
	return status;
}

enum hawser_status cli_hill_unstable(double **box, int *boxes, const struct cli_hill_result *result,
                                     struct hawser_report *report)
{
	struct plane plane = {.field = result->field};
	size_t m = (size_t)result->field->m;
	enum hawser_status status = HAWSER_OK;

	for (int k = 0; k < 2; k++) {
		plane.from[k] = result->axis[k].from;
		plane.to[k] = result->axis[k].to;
	}
	plane.log_modulus = malloc(2*m*sizeof(double));
	plane.argument = plane.log_modulus ? plane.log_modulus + m : NULL;
	*box = plane.box = malloc((size_t)ROWS*(CELLS/2 + 1)*4*sizeof(double));
	if (!plane.log_modulus || !plane.box)
		status = hawser__no_memory(report, "hill");
	for (int j = 0; !status && j < ROWS; j++)
		status = row(&plane, plane.from[1] + (plane.to[1] - plane.from[1])*(j + 0.5)/ROWS, report);
	free(plane.log_modulus);
	*boxes = plane.boxes;
	return status;
}
