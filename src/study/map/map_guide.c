/* study/map/map_guide.c - responses of a map start from those of near places.
 *
 * The response of a point is the one that grows out of rest as its load is raised. On the way there it
 * passes orbits (response/orbit/start.h) that differ little from those of a near point, from which
 * they are corrected in a few steps: the loads on the way remain, so that what is found is what is
 * found from rest. Ways are computed at the places of a lattice over the ranges of the map, first
 * coarse ones, then finer ones from these where the linear response does not lead to the whole load:
 *
 *    place   indices (i, j), 0 to PLACES, of the finest lattice
 *    level   0: every SPACING-th index; the next one has half the distance
 *
 * A place needs only places of lower levels, and is the same whatever else is computed, so that values
 * depend on x and y alone. Only what a point needs is computed, before its points.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "core/share.h"
#include "study/map/map_cable.h"

enum { PLACES = 96, SPACING = 8, ACROSS = PLACES + 1 };

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

/* The nearest index. */
static int index_of(const struct hawser__map_cable *cable, int k, double value)
{
	const struct hawser_map_source *source = &cable->source;
	double at = (value - source->from[k])/(source->to[k] - source->from[k])*PLACES;

	return at > 0.0 ? (int)fmin(PLACES, floor(at + 0.5)) : 0;
}

/* Distance of the places of the level of (i, j). */
static int spacing_of(int i, int j)
{
	int spacing = SPACING;

	while (i%spacing || j%spacing)
		spacing /= 2;
	return spacing;
}

/* The place from which (i, j) starts; -1: from rest. */
static int parent(int place)
{
	int i = place%ACROSS, j = place/ACROSS, spacing = 2*spacing_of(i, j);

	return spacing > SPACING ? -1 : j/spacing*spacing*ACROSS + i/spacing*spacing;
}

static int place_of(const struct hawser__map_cable *cable, double x, double y)
{
	return index_of(cable, 1, y)*ACROSS + index_of(cable, 0, x);
}

/* Whether the response was found from the linear one, or not at all: near by none needs a guide. */
static int is_plain(const struct hawser__way *way)
{
	return way->count == 0 || way->passed[0].load == 1.0;
}

const struct hawser__way *hawser__map_guide(const struct hawser__map_cable *cable, double x, double y)
{
	int place;

	if (!cable->guides)
		return NULL;
	place = place_of(cable, x, y);
	return is_plain(&cable->guides->way[place]) ? NULL : &cable->guides->way[place];
}

int hawser__map_guided(const struct hawser__map_cable *cable, double x, double y)
{
	return !cable->guides || cable->guides->known[place_of(cable, x, y)];
}

/* List the places that the points need and that are not known. */
static int want(int *place, struct hawser__map_cable *cable, const double *x, const double *y,
                int count)
{
	struct hawser__map_guides *guides = cable->guides;
	int found = 0;

	for (int p = 0; p < count; p++)
		for (int at = place_of(cable, x[p], y[p]); at >= 0; at = parent(at)) {
			if (guides->known[at] || guides->wanted[at])
				break;
			guides->wanted[at] = 1;
			place[found++] = at;
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
	enum hawser_status status = HAWSER_OK;

	if (from < 0 || !is_plain(&guides->way[from]))
		status = hawser__map_worker_way(g->worker[worker], &guides->way[place],
		                                from < 0 ? NULL : &guides->way[from],
		                                value_at(g->cable, 0, place%ACROSS),
		                                value_at(g->cable, 1, place/ACROSS));
	guides->known[place] = 1;
	if (status)
		g->status[worker] = status;
}

/* The places [count], level by level. */
static enum hawser_status guide_all(struct hawser__map_cable *cable, const int *place, int count,
                                    int threads, struct hawser_report *report)
{
	int *level = malloc((size_t)count*sizeof *level + 1);
	struct guiding g = {cable, level, calloc((size_t)threads, sizeof *g.worker),
	                    calloc((size_t)threads, sizeof *g.status)};
	enum hawser_status status = level && g.worker && g.status ? HAWSER_OK
	                                                          : hawser__no_memory(report, "map");

	for (int t = 0; t < threads && !status; t++)
		status = hawser__map_worker_open(&g.worker[t], cable, report);
	for (int spacing = SPACING; spacing > 0 && !status; spacing /= 2) {
		int here = 0;

		for (int p = 0; p < count; p++)
			if (spacing_of(place[p]%ACROSS, place[p]/ACROSS) == spacing)
				level[here++] = place[p];
		hawser__share(here, threads, guide, &g);
		for (int t = 0; t < threads; t++)
			status = g.status[t] ? g.status[t] : status;
	}
	for (int t = 0; t < threads && g.worker; t++)
		hawser__map_worker_close(g.worker[t]);
	free(g.status);
	free(g.worker);
	free(level);
	return status;
}

/* hawser_map_field.prepare: the structures of the points, or where all have the same model, their
 * guides. */
enum hawser_status hawser__map_prepare(void *context, const double *x, const double *y, int count,
                                       int threads, struct hawser_report *report)
{
	struct hawser__map_cable *cable = context;
	enum hawser_status status;
	int *place;

	if (!cable->moves || cable->varies >= 0 || cable->models)
		return hawser__structure_prepare(context, x, y, count, threads, report);
	if (!cable->guides)
		cable->guides = calloc(1, sizeof *cable->guides);
	place = malloc(ACROSS*ACROSS*sizeof *place);
	status = cable->guides && place ? guide_all(cable, place, want(place, cable, x, y, count), threads,
	                                            report)
	                                : hawser__no_memory(report, "map");
	free(place);
	return status;
}

void hawser__map_guides_free(struct hawser__map_guides *guides)
{
	for (int place = 0; guides && place < ACROSS*ACROSS; place++)
		hawser__way_clear(&guides->way[place]);
	free(guides);
}
