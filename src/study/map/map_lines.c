/* study/map/map_lines.c - boundary points, and the line segments between them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "study/map/map.h"

#define SAME_SIDE 100.0 /* penalty, larger than any length around a cell */

static void place_of(double xy[2], const struct hawser__mapper *mapper,
                     const struct hawser__map_bracket *item)
{
	long place = item->edge/2;
	int i = (int)(place%mapper->nx), j = (int)(place/mapper->nx);
	double t = 0.5*(item->reach[0] + item->reach[1]);

	xy[0] = item->edge%2 == 0 ? hawser__map_between(mapper->x[i], mapper->x[i + 1], t) : mapper->x[i];
	xy[1] = item->edge%2 == 1 ? hawser__map_between(mapper->y[j], mapper->y[j + 1], t) : mapper->y[j];
}

static enum hawser_status store_points(struct hawser_map *map, const struct hawser__mapper *mapper,
                                       const struct hawser__map_brackets *list,
                                       struct hawser_report *report)
{
	map->boundary = calloc(list->count + 1, sizeof *map->boundary);
	if (!map->boundary)
		return hawser__no_memory(report, "map");
	for (size_t c = 0; c < list->count; c++) {
		const struct hawser__map_bracket *item = &list->item[c];
		struct hawser_map_boundary *to = &map->boundary[c];
		long place = item->edge/2;
		int i = (int)(place%mapper->nx), j = (int)(place/mapper->nx);
		double xy[2];

		place_of(xy, mapper, item);
		to->x = xy[0];
		to->y = xy[1];
		to->along = (int)(item->edge%2);
		to->width = fabs(item->reach[1] - item->reach[0])*
		            (to->along == 0 ? fabs(mapper->x[i + 1] - mapper->x[i])
		                            : fabs(mapper->y[j + 1] - mapper->y[j]));
		for (int k = 0; k < 2; k++) {
			to->number[k] = hawser__map_sample(mapper, item->index[k])->number;
			to->code[k] = hawser__map_sample(mapper, item->index[k])->code;
		}
	}
	map->boundaries = (int)list->count;
	return HAWSER_OK;
}

/* The boundary points of a small cell, anticlockwise from its first corner: positions in xy
 * [most][2], sides of the cell in side [most]. */
enum { MOST_AROUND = 32 };
static int around(double (*xy)[2], int *side, const struct hawser__mapper *mapper,
                  const struct hawser__map_brackets *list, const struct hawser__map_cell *cell)
{
	long nx = mapper->nx, place = (long)cell->j0*nx + cell->i0;
	const long edge[4] = {2*place, 2*(place + 1) + 1, 2*(place + nx), 2*place + 1};
	int count = 0;

	for (int k = 0; k < 4; k++) {
		size_t low = 0, high = list->count, end;

		while (low < high) {
			size_t middle = (low + high)/2;

			if (list->item[middle].edge < edge[k])
				low = middle + 1;
			else
				high = middle;
		}
		for (end = low; end < list->count && list->item[end].edge == edge[k]; end++)
			;
		for (size_t c = 0; c < end - low && count < MOST_AROUND; c++) {
			side[count] = k;
			place_of(xy[count++], mapper, &list->item[k < 2 ? low + c : end - 1 - c]);
		}
	}
	return count;
}

static double length(const struct hawser__mapper *mapper, const double *a, const double *b)
{
	double wide = mapper->x[mapper->nx - 1] - mapper->x[0];
	double high = mapper->y[mapper->ny - 1] - mapper->y[0];

	return hypot((a[0] - b[0])/wide, (a[1] - b[1])/high);
}

static enum hawser_status add_segment(struct hawser_map *map, const double *a, const double *b,
                                      struct hawser_report *report)
{
	double *to;

	if (hawser__more(&map->segment, map->segments, 4*sizeof *map->segment))
		return hawser__no_memory(report, "map");
	to = map->segment + 4*(size_t)map->segments++;
	memcpy(to, a, 2*sizeof *to);
	memcpy(to + 2, b, 2*sizeof *to);
	return HAWSER_OK;
}

/* Connect the points. Two points form a segment. An even number is connected in pairs of neighbours
 * around the cell; of the two possible ways, the one that connects fewer points of the same side
 * (since a narrow tongue passes through the cell and does not end in it), or else the shorter. With
 * an odd number, several regions meet inside the cell. */
static enum hawser_status join(struct hawser_map *map, const struct hawser__mapper *mapper,
                               double (*xy)[2], const int *side, int count,
                               struct hawser_report *report)
{
	double middle[2] = {0.0, 0.0}, sum[2] = {0.0, 0.0};
	enum hawser_status status = HAWSER_OK;
	int shift;

	for (int k = 0; k < count; k++) {
		int next = (k + 1)%count;

		middle[0] += xy[k][0]/count;
		middle[1] += xy[k][1]/count;
		sum[k%2] += length(mapper, xy[k], xy[next]) + (side[k] == side[next] ? SAME_SIDE : 0.0);
	}
	if (count%2 == 1) {
		for (int k = 0; k < count && count > 1 && !status; k++)
			status = add_segment(map, xy[k], middle, report);
		return status;
	}
	shift = sum[1] < sum[0];
	for (int k = shift; k < count + shift && !status; k += 2)
		status = add_segment(map, xy[k%count], xy[(k + 1)%count], report);
	return status;
}

static enum hawser_status draw(struct hawser_map *map, const struct hawser__mapper *mapper,
                               const struct hawser__map_brackets *list, struct hawser_report *report)
{
	double xy[MOST_AROUND][2];
	int side[MOST_AROUND], count;
	enum hawser_status status = HAWSER_OK;

	for (size_t c = 0; c < mapper->leaf.count && !status; c++) {
		const struct hawser__map_cell *cell = &mapper->leaf.cell[c];

		if (cell->i1 - cell->i0 != 1 || cell->j1 - cell->j0 != 1)
			continue;
		count = around(xy, side, mapper, list, cell);
		status = join(map, mapper, xy, side, count, report);
	}
	return status;
}

enum hawser_status hawser__map_lines(struct hawser_map *map, const struct hawser__mapper *mapper,
                                     const struct hawser__map_brackets *list,
                                     struct hawser_report *report)
{
	enum hawser_status status = store_points(map, mapper, list, report);

	return status ? status : draw(map, mapper, list, report);
}
