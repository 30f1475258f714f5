/* study/map_probes.c - instabilities that the corners of cells do not show.
 *
 * Near the tip of a tongue of instability, or without damping, the tongue is narrower than a cell,
 * and all corners are stable. Its possible location is known, however: where one of the lines of
 * the field (a resonance condition of the frequencies) changes its sign along an edge. The crossing
 * is found by the secant method, which is cheap since lines are nearly straight, and the point
 * there is computed. If it differs from the corners, the cell is split.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "study/map.h"

#define SECANTS 3 /* secant steps for a crossing; chosen */
#define ON_LINE 1e-7 /* largest value of a line at a probe, relative to those at the ends; chosen */

/* A line that crosses an edge of a cell of any size. */
struct crossing {
	long cell, end[2], index; /* indices of the records of the ends and of the probe */
	int i, j, along, length;  /* first node, and length of the edge in nodes */
	int line, found;
	double t[2], f[2], at;    /* bracket: positions (0 to 1 along the whole edge), and values of the
	                           * line */
};

struct crossings {
	struct crossing *item;
	size_t count, room;
};

static enum hawser_status cross_edge(struct hawser__mapper *mapper, struct crossings *list, long cell,
                                     int i, int j, int along, int length,
                                     struct hawser_report *report)
{
	const struct hawser_map_field *field = mapper->field;
	long nx = mapper->nx, a = mapper->node[j*nx + i];
	long b = mapper->node[along == 0 ? j*nx + i + length : (j + length)*nx + i];
	const struct hawser_map_sample *from = hawser__map_sample(mapper, a);

	if (from->code != HAWSER_MAP_OK || hawser__map_differ(from, hawser__map_sample(mapper, b)))
		return HAWSER_OK;
	for (int k = 0; k < field->lines; k++) {
		struct crossing item = {.cell = cell, .end = {a, b}, .i = i, .j = j, .along = along,
			.length = length, .line = k, .t = {0.0, 1.0}};
		void *larger;

		item.f[0] = field->line(field->context, k, hawser__map_marks(mapper, a));
		item.f[1] = field->line(field->context, k, hawser__map_marks(mapper, b));
		if (!(item.f[0]*item.f[1] < 0.0))
			continue;
		larger = hawser__map_room(list->item, &list->room, list->count, sizeof *list->item);
		if (!larger)
			return hawser__no_memory(report, "map");
		list->item = larger;
		list->item[list->count++] = item;
	}
	return HAWSER_OK;
}

/* One secant step for each crossing that needs it; returns 0 if none does. */
static enum hawser_status secant(struct hawser__mapper *mapper, struct crossings *list, int *steps,
                                 struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	*steps = 0;
	for (size_t c = 0; c < list->count && !status; c++) {
		struct crossing *item = &list->item[c];
		double whole;

		if (item->found)
			continue;
		whole = item->f[0] - item->f[1]; /* if it is not finite, the middle is used */
		item->at = hawser__map_between(item->t[0], item->t[1],
		                               isfinite(whole) ? item->f[0]/whole : 0.5);
		status = hawser__map_want_on(mapper, &item->index, item->i, item->j, item->along, item->length,
		                 item->at, report);
		*steps += 1;
	}
	return status;
}

/* After the points are computed: accept the probe, or narrow the bracket. */
static void judge(const struct hawser__mapper *mapper, struct crossings *list)
{
	for (size_t c = 0; c < list->count; c++) {
		struct crossing *item = &list->item[c];
		const struct hawser_map_sample *here;
		double f;

		if (item->found)
			continue;
		here = hawser__map_sample(mapper, item->index);
		item->found = 1;
		if (here->code != HAWSER_MAP_OK ||
		    hawser__map_differ(here, hawser__map_sample(mapper, item->end[0])))
			continue;
		f = mapper->field->line(mapper->field->context, item->line,
		                        hawser__map_marks(mapper, item->index));
		item->found = fabs(f) <= ON_LINE*(fabs(item->f[0]) + fabs(item->f[1]));
		item->t[f*item->f[0] > 0.0 ? 0 : 1] = item->at;
		item->f[f*item->f[0] > 0.0 ? 0 : 1] = f;
	}
}

static enum hawser_status keep_probe(struct hawser__mapper *mapper, const struct crossing *item,
                                     struct hawser_report *report)
{
	void *larger = hawser__map_room(mapper->probe, &mapper->probe_room, mapper->probes,
	                                sizeof *mapper->probe);
	long place = (long)item->j*mapper->nx + item->i;

	if (!larger)
		return hawser__no_memory(report, "map");
	mapper->probe = larger;
	mapper->hot[place] |= (unsigned char)(1 << item->along);
	mapper->probe[mapper->probes++] = (struct hawser__map_probe){2*place + item->along, item->at,
		item->index};
	return HAWSER_OK;
}

static enum hawser_status cross_cells(struct hawser__mapper *mapper, struct crossings *list,
                                      const struct hawser__map_cells *cells,
                                      struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (size_t c = 0; c < cells->count && !status; c++) {
		const struct hawser__map_cell *cell = &cells->cell[c];
		int wide = cell->i1 - cell->i0, high = cell->j1 - cell->j0;
		long n = (long)c;

		if ((status = cross_edge(mapper, list, n, cell->i0, cell->j0, 0, wide, report)) ||
		    (status = cross_edge(mapper, list, n, cell->i0, cell->j1, 0, wide, report)) ||
		    (status = cross_edge(mapper, list, n, cell->i0, cell->j0, 1, high, report)) ||
		    (status = cross_edge(mapper, list, n, cell->i1, cell->j0, 1, high, report)))
			break;
	}
	return status;
}

enum hawser_status hawser__map_probes(struct hawser__mapper *mapper, unsigned char *hot,
                                      const struct hawser__map_cells *cells,
                                      struct hawser_report *report)
{
	struct crossings list = {0};
	enum hawser_status status = HAWSER_OK;
	int steps = 1;

	if (mapper->field->lines == 0 || mapper->options->coarse == 1)
		return HAWSER_OK;
	status = cross_cells(mapper, &list, cells, report);
	for (int k = 0; k < SECANTS && steps > 0 && !status && !mapper->memo.interrupted; k++) {
		status = secant(mapper, &list, &steps, report);
		if (!status)
			status = hawser__map_run(&mapper->memo, "map: probes", 0, report);
		if (!status && !mapper->memo.interrupted)
			judge(mapper, &list);
	}
	for (size_t c = 0; c < list.count && !status && !mapper->memo.interrupted; c++) {
		const struct crossing *item = &list.item[c];

		if (!hawser__map_differ(hawser__map_sample(mapper, item->index),
		                        hawser__map_sample(mapper, item->end[0])))
			continue;
		hot[item->cell] = 1;
		if (item->length == 1)
			status = keep_probe(mapper, item, report);
	}
	free(list.item);
	return status;
}
