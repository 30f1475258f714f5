/* study/map/map_rows_lines.c - the boundaries of a map by rows, and the lines through them.
 *
 * A row has the events of its curves, each located on its curve. A line joins events of one kind of
 * neighbouring rows if each is the other's nearest. Two folds of a row that open to each other, and
 * have no partner in the next row, meet in a cusp before it and are joined.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/grow.h"
#include "core/report.h"
#include "study/map/map_rows.h"

#define FARTHEST 0.25 /* largest distance of joined events, as a part of the range; chosen */

struct lines {
	struct hawser_map *map;
	int along;
};

static enum hawser_status add_boundary(struct lines *lines, const struct hawser__map_row *row, int i,
                                       double at, double width, const char *event,
                                       struct hawser_report *report)
{
	struct hawser_map *map = lines->map;
	int backwards = row->at[0] > row->at[row->count - 1];
	const struct hawser__map_answer *low = &row->answer[backwards ? i + 1 : i];
	const struct hawser__map_answer *high = &row->answer[backwards ? i : i + 1];
	double place[2];

	if (hawser__more(&map->boundary, map->boundaries, sizeof *map->boundary))
		return hawser__no_memory(report, "map");
	place[lines->along] = at;
	place[1 - lines->along] = row->fixed;
	map->boundary[map->boundaries++] = (struct hawser_map_boundary){
		.x = place[0], .y = place[1], .width = width, .along = lines->along,
		.number = {low->sample.number, high->sample.number},
		.code = {low->sample.code, high->sample.code}, .event = event,
		.branches = {low->branches, high->branches}};
	return HAWSER_OK;
}

static int differ(const struct hawser__map_answer *a, const struct hawser__map_answer *b)
{
	return a->sample.code != b->sample.code || a->sample.number != b->sample.number ||
	       a->branches != b->branches || a->stable != b->stable;
}

/* The boundaries between the cells i and i + 1 of a row. */
static enum hawser_status between(struct lines *lines, const struct hawser__map_row *row, int i,
                                  struct hawser_report *report)
{
	double lo = fmin(row->at[i], row->at[i + 1]), hi = fmax(row->at[i], row->at[i + 1]);
	double first = fmin(row->at[0], row->at[row->count - 1]);
	int any = 0;
	enum hawser_status status = HAWSER_OK;

	for (int k = 0; k < row->turns && !status; k++) {
		const struct hawser__map_turn *turn = &row->turn[k];

		if (!((turn->at > lo || (turn->at == lo && lo == first)) && turn->at <= hi))
			continue;
		any = 1;
		status = add_boundary(lines, row, i, turn->at, 2.0*turn->error,
		                      hawser_event_name(turn->kind), report);
	}
	if (!status && !any && differ(&row->answer[i], &row->answer[i + 1]))
		status = add_boundary(lines, row, i, 0.5*(lo + hi), hi - lo, "", report);
	return status;
}

static enum hawser_status add_segment(struct lines *lines, double a, double fixed_a, double b,
                                      double fixed_b, struct hawser_report *report)
{
	struct hawser_map *map = lines->map;
	double *to;

	if (hawser__more(&map->segment, map->segments, 4*sizeof *map->segment))
		return hawser__no_memory(report, "map");
	to = map->segment + 4*(size_t)map->segments++;
	to[lines->along] = a;
	to[1 - lines->along] = fixed_a;
	to[2 + lines->along] = b;
	to[3 - lines->along] = fixed_b;
	return HAWSER_OK;
}

/* The event of `row` that is nearest to `turn`, of the same kind and side; -1: none. */
static int nearest(const struct hawser__map_row *row, const struct hawser__map_turn *turn)
{
	double least = FARTHEST*fabs(row->at[row->count - 1] - row->at[0]);
	int best = -1;

	for (int k = 0; k < row->turns; k++)
		if (row->turn[k].kind == turn->kind && row->turn[k].side == turn->side &&
		    fabs(row->turn[k].at - turn->at) < least) {
			least = fabs(row->turn[k].at - turn->at);
			best = k;
		}
	return best;
}

/* The event of `to` to which event k of `from` is joined, or -1. */
static int partner(const struct hawser__map_row *from, int k, const struct hawser__map_row *to)
{
	int other = nearest(to, &from->turn[k]);

	return other >= 0 && nearest(from, &to->turn[other]) == k ? other : -1;
}

static enum hawser_status join_rows(struct lines *lines, const struct hawser__map_row *row,
                                    const struct hawser__map_row *next, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int k = 0; k < row->turns && !status; k++) {
		int other = partner(row, k, next);

		if (other >= 0)
			status = add_segment(lines, row->turn[k].at, row->fixed, next->turn[other].at,
			                     next->fixed, report);
	}
	return status;
}

static enum hawser_status close_cusps(struct lines *lines, const struct hawser__map_row *row,
                                      const struct hawser__map_row *next,
                                      struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int k = 0; k + 1 < row->turns && !status; k++) {
		const struct hawser__map_turn *a = &row->turn[k], *b = a + 1;

		if (a->kind == HAWSER_FOLD && b->kind == HAWSER_FOLD && a->side == 1 && b->side == -1 &&
		    partner(row, k, next) < 0 && partner(row, k + 1, next) < 0)
			status = add_segment(lines, a->at, row->fixed, b->at, row->fixed, report);
	}
	return status;
}

enum hawser_status hawser__map_rows_lines(struct hawser_map *map, const struct hawser__map_row *row,
                                          int rows, int along, struct hawser_report *report)
{
	struct lines lines = {.map = map, .along = along};
	enum hawser_status status = HAWSER_OK;

	for (int j = 0; j < rows; j++) {
		for (int i = 0; row[j].ready && i + 1 < row[j].count && !status; i++)
			status = between(&lines, &row[j], i, report);
		if (j + 1 == rows || !row[j].ready || !row[j + 1].ready)
			continue;
		if (!status)
			status = join_rows(&lines, &row[j], &row[j + 1], report);
		if (!status)
			status = close_cusps(&lines, &row[j], &row[j + 1], report);
		if (!status)
			status = close_cusps(&lines, &row[j + 1], &row[j], report);
	}
	return status;
}
