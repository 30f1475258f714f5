/* study/map/map_guide.c - responses of a map start from those of near places.
 *
 * The response of a point is the one that grows out of rest as its load is raised. On the way there it
 * passes orbits (response/orbit/start.h) that differ little from those of a near point, from which
 * they are corrected in a few steps: the loads on the way remain, so that what is found is what is
 * found from rest. Ways are computed at the places of a lattice over the ranges of the map, first
 * coarse ones, then finer ones from these around points whose cell is not calm:
 *
 *    place   indices (i, j), 0 to PLACES, of the finest lattice
 *    level   0: every SPACING-th index; the next one has half the distance
 *    cell    of a level: four places next to each other
 *
 * A cell is calm if its four places have responses, of which three differ little from the first, that
 * at the lowest indices. A fold over the load between the four is then unlikely, and points start at
 * the whole load, from the orbit interpolated between them. In other cells points start from the way of
 * the nearest place of the finest cell: started at the whole load, some of them end on the motion
 * behind a fold beside the cell (conductor.yaml).
 *
 * A place needs only places of lower levels, and a point only the cells that contain it down to the
 * first calm one, so that values depend on x and y alone. Only what a point needs is computed, before
 * its points.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "core/share.h"
#include "study/map/map_cable.h"

enum { PLACES = 96, SPACING = 8, ACROSS = PLACES + 1 };
#define CALM 0.2 /* largest distance from the first orbit of a calm cell, in parts of it; chosen */

struct hawser__map_guides {
	struct hawser__way way[ACROSS*ACROSS];
	unsigned char known[ACROSS*ACROSS], wanted[ACROSS*ACROSS];
};

static double value_at(const struct hawser__map_cable *cable, int k, int index)
{
	const struct hawser_map_source *source = &cable->source;

	return index == PLACES ? source->to[k]
	                       : source->from[k] + (source->to[k] - source->from[k])*index/PLACES;
}

/* Distance of the places of the level of (i, j). */
static int spacing_of(int i, int j)
{
	int spacing = SPACING;

	while (i%spacing || j%spacing)
		spacing /= 2;
	return spacing;
}

/* The place from which (i, j) starts, a corner of the cell of the level before; -1: from rest. */
static int parent(int place)
{
	int i = place%ACROSS, j = place/ACROSS, spacing = 2*spacing_of(i, j);

	return spacing > SPACING ? -1 : j/spacing*spacing*ACROSS + i/spacing*spacing;
}

/* The cell that contains a point. */
struct cell {
	int corner[4];
	double weight[4]; /* of the corners, linear along both axes */
};

static struct cell cell_of(const struct hawser__map_cable *cable, double x, double y, int spacing)
{
	const struct hawser_map_source *source = &cable->source;
	const double value[2] = {x, y};
	struct cell cell;
	double part[2];
	int low[2];

	for (int k = 0; k < 2; k++) {
		double at = (value[k] - source->from[k])/(source->to[k] - source->from[k])*PLACES/spacing;

		low[k] = at > 0.0 ? (int)fmin(PLACES/spacing - 1, floor(at)) : 0;
		part[k] = fmin(fmax(at - low[k], 0.0), 1.0);
	}
	for (int c = 0; c < 4; c++) {
		cell.corner[c] = spacing*((low[1] + c/2)*ACROSS + low[0] + c%2);
		cell.weight[c] = (c%2 ? part[0] : 1.0 - part[0])*(c/2 ? part[1] : 1.0 - part[1]);
	}
	return cell;
}

/* Whether the response was found from the linear one, or not at all: near by none needs a guide. */
static int is_plain(const struct hawser__way *way)
{
	return way->count == 0 || way->passed[0].load == 1.0;
}

/* The last orbit of a way that leads to the whole load, or NULL. */
static const struct hawser__passed *whole(const struct hawser__way *way)
{
	const struct hawser__passed *last = way->count > 0 ? way->passed + way->count - 1 : NULL;

	return last && last->load == 1.0 ? last : NULL;
}

/* Whether the cell is calm; its corners are known. */
static int is_calm(const struct hawser__map_guides *guides, const struct cell *cell)
{
	const struct hawser__passed *first = whole(&guides->way[cell->corner[0]]);

	for (int c = 0; c < 4; c++) {
		const struct hawser__way *way = &guides->way[cell->corner[c]];
		const struct hawser__passed *last = whole(way);

		if (!first || !last || !(hawser__orbit_distance(last->y, last->length, first->y, first->length,
		                                                way->n, way->rough) <= CALM))
			return 0;
	}
	return 1;
}

static int is_known(const struct hawser__map_guides *guides, const struct cell *cell)
{
	int known = 1;

	for (int c = 0; c < 4; c++)
		known &= guides->known[cell->corner[c]];
	return known;
}

/* The largest calm cell that contains the point, or the finest cell. Returns 0: not all of its corners
 * are known. */
static int cell_at(struct cell *cell, const struct hawser__map_cable *cable, double x, double y)
{
	for (int spacing = SPACING; spacing > 0; spacing /= 2) {
		*cell = cell_of(cable, x, y, spacing);
		if (!is_known(cable->guides, cell))
			return 0;
		if (is_calm(cable->guides, cell))
			break;
	}
	return 1;
}

/* The orbit at the whole load, interpolated between those of the corners. */
static enum hawser_status foretell(struct hawser__way *to, const struct hawser__map_guides *guides,
                                   const struct cell *cell)
{
	const struct hawser__passed *corner[4];
	double *y;
	int length = 0, failed;

	for (int c = 0; c < 4; c++) {
		corner[c] = whole(&guides->way[cell->corner[c]]);
		length = corner[c]->length > length ? corner[c]->length : length;
	}
	y = calloc((size_t)length + 1, sizeof *y);
	for (int c = 0; c < 4 && y; c++)
		for (int i = 0; i < corner[c]->length; i++)
			y[i] += cell->weight[c]*corner[c]->y[i];
	failed = !y || hawser__way_add(to, 1.0, y, length);
	free(y);
	return failed ? HAWSER_ERR_MEMORY : HAWSER_OK;
}

enum hawser_status hawser__map_guide(const struct hawser__way **guide, struct hawser__way *own,
                                     const struct hawser__map_cable *cable, double x, double y)
{
	struct cell cell;
	int nearest = 0;

	*guide = NULL;
	hawser__way_clear(own);
	if (!cable->guides || !cell_at(&cell, cable, x, y))
		return HAWSER_OK;
	if (is_calm(cable->guides, &cell)) {
		*guide = own;
		return foretell(own, cable->guides, &cell);
	}
	for (int c = 1; c < 4; c++)
		nearest = cell.weight[c] > cell.weight[nearest] ? c : nearest;
	*guide = &cable->guides->way[cell.corner[nearest]];
	if (is_plain(*guide))
		*guide = NULL;
	return HAWSER_OK;
}

int hawser__map_guided(const struct hawser__map_cable *cable, double x, double y)
{
	struct cell cell;

	return !cable->guides || cell_at(&cell, cable, x, y);
}

/* List the places of a level that the points need and that were not listed before. */
static int want(int *place, struct hawser__map_cable *cable, const double *x, const double *y,
                int count, int spacing)
{
	struct hawser__map_guides *guides = cable->guides;
	struct cell cell;
	int found = 0;

	for (int p = 0; p < count; p++) {
		if (cell_at(&cell, cable, x[p], y[p]))
			continue;
		cell = cell_of(cable, x[p], y[p], spacing);
		for (int c = 0; c < 4; c++)
			if (!guides->wanted[cell.corner[c]]) {
				guides->wanted[cell.corner[c]] = 1;
				place[found++] = cell.corner[c];
			}
	}
	return found;
}

struct guiding {
	struct hawser__map_cable *cable;
	const int *place;   /* [count] of one level */
	void **worker;      /* [threads] */
	enum hawser_status *status; /* [threads] */
};

static void guide(void *context, long item, int worker)
{
	const struct guiding *g = context;
	struct hawser__map_guides *guides = g->cable->guides;
	int place = g->place[item], from = parent(place);
	const struct hawser__way *start = from < 0 || is_plain(&guides->way[from]) ? NULL
	                                                                           : &guides->way[from];
	enum hawser_status status = hawser__map_worker_way(g->worker[worker], &guides->way[place], start,
	                                                   value_at(g->cable, 0, place%ACROSS),
	                                                   value_at(g->cable, 1, place/ACROSS));

	guides->known[place] = 1;
	if (status)
		g->status[worker] = status;
}

/* The places that the points need, level by level. */
static enum hawser_status guide_all(struct hawser__map_cable *cable, const double *x, const double *y,
                                    int count, int threads, struct hawser_report *report)
{
	int *place = malloc(ACROSS*ACROSS*sizeof *place);
	struct guiding g = {cable, place, calloc((size_t)threads, sizeof *g.worker),
	                    calloc((size_t)threads, sizeof *g.status)};
	enum hawser_status status = place && g.worker && g.status ? HAWSER_OK
	                                                          : hawser__no_memory(report, "map");

	for (int t = 0; t < threads && !status; t++)
		status = hawser__map_worker_open(&g.worker[t], cable, report);
	for (int spacing = SPACING; spacing > 0 && !status; spacing /= 2) {
		hawser__share(want(place, cable, x, y, count, spacing), threads, guide, &g);
		for (int t = 0; t < threads; t++)
			status = g.status[t] ? g.status[t] : status;
	}
	for (int t = 0; t < threads && g.worker; t++)
		hawser__map_worker_close(g.worker[t]);
	free(g.status);
	free(g.worker);
	free(place);
	return status;
}

/* hawser_map_field.prepare: the structures of the points, or where all have the same model, their
 * guides. */
enum hawser_status hawser__map_prepare(void *context, const double *x, const double *y, int count,
                                       int threads, struct hawser_report *report)
{
	struct hawser__map_cable *cable = context;

	if (!cable->moves || cable->varies >= 0 || cable->models)
		return hawser__structure_prepare(context, x, y, count, threads, report);
	if (!cable->guides)
		cable->guides = calloc(1, sizeof *cable->guides);
	return cable->guides ? guide_all(cable, x, y, count, threads, report)
	                     : hawser__no_memory(report, "map");
}

void hawser__map_guides_free(struct hawser__map_guides *guides)
{
	for (int place = 0; guides && place < ACROSS*ACROSS; place++)
		hawser__way_clear(&guides->way[place]);
	free(guides);
}
