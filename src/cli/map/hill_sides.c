/* cli/map/hill_sides.c - the unstable parts of a plane of two parameters, and those without a response,
 * for the picture of hill.
 *
 * The number of unstable multipliers is computed on rows of the plane: at equidistant samples, and
 * in the middle between adjacent crossings of the row with the traced boundaries, so that a traced
 * tongue is found however narrow it is. If stability differs between two neighbouring samples, the
 * change is placed at the crossing between them. Without a crossing (a boundary that the search
 * missed) it is located by bisection. The boxes of a row end at these points.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "cli/map/hill_result.h"
#include "core/grow.h"
#include "core/order.h"
#include "core/report.h"

enum { ROWS = 100, CELLS = 24, HALVINGS = 8 };
static const double overlap = 0.1;  /* of the height of a row, so that no gap shows between two
                                     * rows */

struct plane {
	struct hawser_hill_counter *counter;
	const struct hawser_hill_chart *chart;
	double *crossing; /* [crossings] of the row with the traced boundaries, ascending */
	double *sample;   /* [samples] abscissas of the row, ascending */
	int crossings, samples;
	double *height;   /* [samples] multipliers outside the unit circle */
	int *unstable;    /* [samples] multipliers there */
	double from[2], to[2];
	struct cli_hill_boxes boxes[2]; /* UNSTABLE, SILENT */
};

enum { STABLE = -1, UNSTABLE = 0, SILENT = 1 };

static int side(int unstable)
{
	return unstable < 0 ? SILENT : unstable > 0 ? UNSTABLE : STABLE;
}

static enum hawser_status ask(int *unstable, struct plane *plane, double x, double y,
                              struct hawser_report *report)
{
	return hawser_hill_count(plane->counter, unstable, &x, &y, 1, report);
}

/* Bisect for the change between two neighbouring samples; `left` is the side of `low`. */
static enum hawser_status change(double *at, struct plane *plane, double low, double high, double y,
                                 int left, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int k = 0; !status && k < HALVINGS; k++) {
		int unstable;

		*at = 0.5*(low + high);
		status = ask(&unstable, plane, *at, y, report);
		if (side(unstable) == left)
			low = *at;
		else
			high = *at;
	}
	return status;
}

static enum hawser_status add(struct plane *plane, int of, double from, double to, double y,
                              struct hawser_report *report)
{
	double half = (0.5 + overlap)*(plane->to[1] - plane->from[1])/ROWS, *box;
	struct cli_hill_boxes *boxes = &plane->boxes[of];

	if (hawser__more(&boxes->box, boxes->count, 4*sizeof *boxes->box))
		return hawser__no_memory(report, "hill");
	box = boxes->box + 4*(size_t)boxes->count++;
	box[0] = from;
	box[1] = y - half < plane->from[1] ? plane->from[1] : y - half;
	box[2] = to;
	box[3] = y + half > plane->to[1] ? plane->to[1] : y + half;
	return HAWSER_OK;
}

/* Crossings of the row at y with the boundaries, inside the plane. */
static void cross(struct plane *plane, double y)
{
	plane->crossings = 0;
	for (int b = 0; b < plane->chart->boundaries; b++) {
		const struct hawser_hill_boundary *line = &plane->chart->boundary[b];

		for (int i = 0; i + 1 < line->points; i++) {
			const double *p = line->at + 2*i, *q = p + 2;
			double x;

			if ((p[1] <= y) == (q[1] <= y))
				continue;
			x = p[0] + (q[0] - p[0])*(y - p[1])/(q[1] - p[1]);
			if (x > plane->from[0] && x < plane->to[0])
				plane->crossing[plane->crossings++] = x;
		}
	}
	qsort(plane->crossing, (size_t)plane->crossings, sizeof(double), hawser__ascending);
}

static void choose_samples(struct plane *plane)
{
	double wide = plane->to[0] - plane->from[0];

	plane->samples = 0;
	for (int i = 0; i <= CELLS; i++)
		plane->sample[plane->samples++] = plane->from[0] + wide*i/CELLS;
	for (int k = 0; k + 1 < plane->crossings; k++)
		plane->sample[plane->samples++] = 0.5*(plane->crossing[k] + plane->crossing[k + 1]);
	qsort(plane->sample, (size_t)plane->samples, sizeof(double), hawser__ascending);
}

/* *at is the crossing with a traced boundary in [low, high]. Returns 0 if there is none, or more
 * than one. */
static int traced(double *at, const struct plane *plane, double low, double high)
{
	int found = 0;

	for (int k = 0; k < plane->crossings; k++)
		if (plane->crossing[k] >= low && plane->crossing[k] <= high) {
			*at = plane->crossing[k];
			found++;
		}
	return found == 1;
}

static enum hawser_status row(struct plane *plane, double y, struct hawser_report *report)
{
	double begin = plane->from[0], at = begin;
	int before;
	enum hawser_status status;

	cross(plane, y);
	choose_samples(plane);
	for (int i = 0; i < plane->samples; i++)
		plane->height[i] = y;
	status = hawser_hill_count(plane->counter, plane->unstable, plane->sample, plane->height,
	                           plane->samples, report);
	before = status ? STABLE : side(plane->unstable[0]);
	for (int i = 1; !status && i < plane->samples; i++) {
		double last = plane->sample[i - 1], x = plane->sample[i];
		int now = side(plane->unstable[i]);

		if (now != before) {
			if (!traced(&at, plane, last, x))
				status = change(&at, plane, last, x, y, before, report);
			if (!status && before != STABLE)
				status = add(plane, before, begin, at, y, report);
			begin = at;
		}
		before = now;
	}
	if (!status && before != STABLE)
		status = add(plane, before, begin, plane->to[0], y, report);
	return status;
}

/* Largest number of crossings of a row. */
static size_t most_crossings(const struct hawser_hill_chart *chart)
{
	size_t most = 0;

	for (int b = 0; b < chart->boundaries; b++)
		most += (size_t)chart->boundary[b].points;
	return most;
}

enum hawser_status cli_hill_unstable(struct cli_hill_boxes boxes[2],
                                     const struct cli_hill_result *result,
                                     struct hawser_report *report)
{
	struct plane plane = {.chart = &result->chart};
	size_t most = most_crossings(&result->chart), samples = CELLS + 1 + most;
	enum hawser_status status = hawser_hill_counter_open(&plane.counter, result->field, report);

	for (int k = 0; k < 2; k++) {
		plane.from[k] = result->axis[k].from;
		plane.to[k] = result->axis[k].to;
	}
	plane.crossing = malloc((most + 2*samples)*sizeof(double));
	plane.unstable = malloc(samples*sizeof *plane.unstable);
	if (!status && (!plane.crossing || !plane.unstable))
		status = hawser__no_memory(report, "hill");
	if (!status) {
		plane.sample = plane.crossing + most;
		plane.height = plane.sample + samples;
	}
	for (int j = 0; !status && j < ROWS; j++)
		status = row(&plane, plane.from[1] + (plane.to[1] - plane.from[1])*(j + 0.5)/ROWS, report);
	free(plane.crossing);
	free(plane.unstable);
	hawser_hill_counter_free(plane.counter);
	memcpy(boxes, plane.boxes, sizeof plane.boxes);
	return status;
}
