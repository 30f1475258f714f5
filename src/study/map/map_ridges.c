/* study/map/map_ridges.c - parametric instabilities that the corners of cells do not show.
 *
 * A tongue may be narrower than a cell, with stable corners on both sides. Where it can be follows
 * from the frequencies at rest: on each edge of the first cells a ridge (ridge.h) is searched at
 * every sum and difference of two frequencies that is a multiple of Omega. A tongue that is found
 * and is narrower than the smallest cells is then followed from each line of the grid to the next,
 * as far as it is narrow. The cells that it crosses are split by map_tree.c.
 *
 *    line    the nodes with the same index along one axis
 *    t       position on a line, in nodes
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/grow.h"
#include "core/report.h"
#include "study/map/map.h"
#include "study/map/ridge.h"

#define NARROW 1.5 /* half of the width, in cells, up to which a tongue is followed: wider ones have
                    * nodes in them; chosen */
#define BESIDE 2.0 /* least half of the range, in cells, in which it is searched on the next line;
                    * chosen */
#define WINDOW 0.04 /* distance from its resonance at rest at which a tongue is looked for, relative
                     * to the range: a fluctuation displaces it, however fine the grid is; that of
                     * the first cells at the default resolution; chosen */
#define CORNER_NEAR 0.1 /* second point at a node, by which multipliers have rates, in cells; chosen */
#define GAP 2.0    /* widest gap between two tongues, in cells, in which no node may be; chosen */
enum { MOST_SEEN = 12 };

struct search {
	struct hawser__ridge ridge;
	int along, line, turn;    /* turn: +-1: follows a tongue; 0: begins at a resonance */
	int done;
	double last;              /* turn: t on the line before */
	int seen, best;           /* best: the least stable of its unstable points, or -1 */
	double growth, angle;     /* there */
	double t[MOST_SEEN];      /* its points, and their records */
	long index[MOST_SEEN];
};

struct searches {
	struct search *item;
	size_t count, active; /* item [active..count] are not done */
	struct hawser__mapper *mapper;
	struct search next;         /* what hawser__ridge_find completes */
	int from, length;           /* of the edge */
	int nears;                  /* 1: the points near nodes are computed */
};

static enum hawser_status push(struct searches *list, const struct search *item,
                               struct hawser_report *report)
{
	if (hawser__more(&list->item, (long)list->count, sizeof *list->item))
		return hawser__no_memory(report, "map");
	list->item[list->count++] = *item;
	return HAWSER_OK;
}

static int nodes(const struct hawser__mapper *mapper, int along)
{
	return along == 0 ? mapper->nx : mapper->ny;
}

/* The node and the part of a cell beyond it. */
static int node_of(double *part, const struct hawser__mapper *mapper, int along, double t)
{
	int node = (int)fmin(fmax(floor(t), 0.0), nodes(mapper, along) - 2);

	*part = t - node;
	return node;
}

static enum hawser_status want(struct hawser__mapper *mapper, struct search *item,
                               struct hawser_report *report)
{
	double part;
	int node = node_of(&part, mapper, item->along, item->ridge.at);
	int i = item->along == 0 ? node : item->line, j = item->along == 0 ? item->line : node;

	item->t[item->seen] = item->ridge.at;
	return hawser__map_want_on(mapper, &item->index[item->seen], i, j, item->along, 1, part, report);
}

/* --- what is found --- */

/* The points of a search that has found an instability become points of the smallest edges. */
static enum hawser_status keep(struct hawser__mapper *mapper, const struct search *item,
                               struct hawser_report *report)
{
	for (int k = 0; k < item->seen; k++) {
		double part;
		long node = node_of(&part, mapper, item->along, item->t[k]), nx = mapper->nx;
		long place = item->along == 0 ? item->line*nx + node : node*nx + item->line;

		if (hawser__more(&mapper->probe, (long)mapper->probes, sizeof *mapper->probe))
			return hawser__no_memory(report, "map");
		mapper->probe[mapper->probes++] =
			(struct hawser__map_probe){2*place + item->along, part, item->index[k]};
		if (k == item->best)
			mapper->hot[place] |= (unsigned char)(1 << item->along);
	}
	return HAWSER_OK;
}

static int same(const struct hawser__combination *a, const struct hawser__combination *b)
{
	return a->j == b->j && a->k == b->k && a->sign == b->sign && a->m == b->m;
}

/* Whether the tongue is known on this line near t. */
static int known(const struct searches *list, const struct search *item)
{
	for (size_t c = 0; c < list->active; c++) {
		const struct search *other = &list->item[c];

		if (other->turn == 0 && other->done > 1 && other->along == item->along &&
		    other->line == item->line && same(&other->ridge.of, &item->ridge.of) &&
		    fabs(other->t[other->best] - item->ridge.at) < BESIDE)
			return 1;
	}
	return 0;
}

/* Search on the next line, where the tongue is expected to go on in the same direction. */
static enum hawser_status follow(struct searches *list, const struct search *from, int turn,
                                 struct hawser_report *report)
{
	const struct hawser__mapper *mapper = list->mapper;
	double here = from->t[from->best], step = from->turn ? here - from->last : 0.0, reach;
	struct search item = {.along = from->along, .line = from->line + turn, .turn = turn,
		.last = here, .best = -1};

	if (item.line < 0 || item.line >= nodes(mapper, 1 - item.along))
		return HAWSER_OK;
	reach = fmax(BESIDE, 2.0*fabs(step));
	item.ridge.of = from->ridge.of;
	item.ridge.of.angle = from->angle;
	item.ridge.slope = from->ridge.slope;
	item.ridge.low = fmax(0.0, here - reach);
	item.ridge.high = fmin(nodes(mapper, item.along) - 1, here + reach);
	item.ridge.at = fmin(fmax(here + step, item.ridge.low), item.ridge.high);
	return known(list, &item) ? HAWSER_OK : push(list, &item, report);
}

static enum hawser_status judge(struct searches *list, size_t c, struct hawser_report *report)
{
	struct hawser__mapper *mapper = list->mapper;
	struct search item = list->item[c];
	const struct hawser_map_sample *sample = hawser__map_sample(mapper, item.index[item.seen]);
	const double *marks = hawser__map_marks(mapper, item.index[item.seen]);
	enum hawser__ridge_state state = HAWSER__RIDGE_LOST;
	enum hawser_status status = HAWSER_OK;

	if (sample->code == HAWSER_MAP_OK)
		state = hawser__ridge_take(&item.ridge, marks + HAWSER__MARGINS, mapper->field->exponents);
	if (sample->code == HAWSER_MAP_OK && sample->number > 0 && item.ridge.growth > 0.0 &&
	    (item.best < 0 || item.ridge.growth > item.growth)) {
		item.best = item.seen;
		item.growth = item.ridge.growth;
		item.angle = item.ridge.angle;
	}
	item.seen++;
	if (state != HAWSER__RIDGE_GOES_ON || item.seen == MOST_SEEN)
		item.done = item.best >= 0 ? 2 : 1;
	list->item[c] = item;
	if (item.done > 1 || (item.done && state == HAWSER__RIDGE_UNRESOLVED)) {
		const struct hawser__map_record *record = &mapper->memo.record[item.index[item.seen - 1]];
		const double at[2] = {record->x, record->y};

		status = hawser__ridge_note(&mapper->tongues, &item.ridge.of, item.done > 1, at, report);
	}
	if (item.done > 1 && !status) {
		double half = hawser__ridge_half(&item.ridge);
		int turns = half < NARROW ? 2 : 0;

		status = keep(mapper, &item, report);
		for (int k = 0; k < turns && !status; k++)
			if (item.turn == 0 || item.turn == 1 - 2*k)
				status = follow(list, &item, 1 - 2*k, report);
	}
	return status;
}

/* --- where to search --- */

static enum hawser_status begin(void *context, const struct hawser__combination *of, double t,
                                double slope, struct hawser_report *report)
{
	struct searches *list = context;
	struct search item = list->next;
	int last = nodes(list->mapper, item.along) - 1;
	double reach = list->length;
	enum hawser_status status;

	item.ridge = (struct hawser__ridge){.of = hawser__combination_on(of, list->length),
		.slope = slope/list->length,
		.at = list->from + t*list->length, .low = fmax(0.0, list->from - reach),
		.high = fmin(last, list->from + list->length + reach)};
	status = push(list, &item, report);
	if (status || reach >= WINDOW*last)
		return status;
	/* on a fine grid farther away too; others may be near */
	reach = WINDOW*last;
	item.ridge.low = fmax(0.0, list->from - reach);
	item.ridge.high = fmin(last, list->from + list->length + reach);
	return push(list, &item, report);
}

/* The point near a node, on the edge from it or, at the end of the line, to it. */
static enum hawser_status want_near(long *index, double *step, struct hawser__mapper *mapper, int i,
                                    int j, int along, struct hawser_report *report)
{
	int back = (along == 0 ? i : j) == nodes(mapper, along) - 1;

	*step = back ? -CORNER_NEAR : CORNER_NEAR;
	return hawser__map_want_on(mapper, index, along == 0 ? i - back : i, along == 0 ? j : j - back,
	                           along, 1, back ? 1.0 - CORNER_NEAR : CORNER_NEAR, report);
}

/* What is known at the two ends of an edge; *complete: 0 if an end has no result. */
static enum hawser_status ends(struct hawser__ridge_edge *ends, int *complete, struct searches *list,
                               const int at[2][2], struct hawser_report *report)
{
	struct hawser__mapper *mapper = list->mapper;
	int along = list->next.along;
	long node[2], near[2];
	enum hawser_status status = HAWSER_OK;

	*ends = (struct hawser__ridge_edge){.n = mapper->field->exponents};
	*complete = 1;
	for (int k = 0; k < 2; k++) {
		node[k] = mapper->node[(long)at[k][1]*mapper->nx + at[k][0]];
		*complete &= hawser__map_sample(mapper, node[k])->code == HAWSER_MAP_OK;
	}
	for (int k = 0; k < 2 && !status && *complete; k++) {
		status = want_near(&near[k], &ends->step[k], mapper, at[k][0], at[k][1], along, report);
		ends->step[k] /= list->length;
	}
	/* marks move in memory while points are wanted */
	for (int k = 0; k < 2 && !status && *complete && list->nears; k++) {
		ends->end[k] = hawser__map_marks(mapper, node[k]) + HAWSER__MARGINS;
		if (hawser__map_sample(mapper, near[k])->code == HAWSER_MAP_OK)
			ends->near[k] = hawser__map_marks(mapper, near[k]) + HAWSER__MARGINS;
	}
	return status;
}

static enum hawser_status edge(struct searches *list, int i, int j, int along, int length,
                               struct hawser_report *report)
{
	const struct hawser__ridge_taker taker = {begin, list};
	const int at[2][2] = {{i, j}, {along == 0 ? i + length : i, along == 0 ? j : j + length}};
	struct hawser__ridge_edge of;
	enum hawser_status status;
	int complete;

	list->next = (struct search){.along = along, .line = along == 0 ? j : i,
		.best = -1};
	list->from = along == 0 ? i : j;
	list->length = length;
	status = ends(&of, &complete, list, at, report);
	if (status || !complete || !list->nears)
		return status;
	return hawser__ridge_find(&of, &list->mapper->tongues.above, &taker, report);
}

static enum hawser_status edges(struct searches *list, const struct hawser__map_cells *cells,
                                struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (size_t c = 0; c < cells->count && !status; c++) {
		const struct hawser__map_cell *cell = &cells->cell[c];
		int wide = cell->i1 - cell->i0, high = cell->j1 - cell->j0;

		if ((status = edge(list, cell->i0, cell->j0, 0, wide, report)) ||
		    (status = edge(list, cell->i0, cell->j0, 1, high, report)))
			break;
		/* a part has no cell beyond some of its own */
		if (list->mapper->options->parts > 0 || cell->j1 == list->mapper->ny - 1)
			status = edge(list, cell->i0, cell->j1, 0, wide, report);
		if (!status && (list->mapper->options->parts > 0 || cell->i1 == list->mapper->nx - 1))
			status = edge(list, cell->i1, cell->j0, 1, high, report);
	}
	return status;
}

/* Move searches that are done before the others. */
static void sort_out(struct searches *list)
{
	for (size_t c = list->active; c < list->count; c++)
		if (list->item[c].done) {
			struct search keep = list->item[c];

			list->item[c] = list->item[list->active];
			list->item[list->active++] = keep;
		}
}

/* --- stable gaps between them --- */

static double start_of(const struct search *item)
{
	return item->ridge.centre - hawser__ridge_half(&item->ridge);
}

/* Those that are found by line and from left to right, then the others. */
static int by_start(const void *a, const void *b)
{
	const struct search *x = a, *y = b;
	double from = start_of(x), to = start_of(y);

	if ((x->done > 1) != (y->done > 1))
		return x->done > 1 ? -1 : 1;
	if (x->along != y->along)
		return x->along - y->along;
	return x->line != y->line ? x->line - y->line : (from > to) - (from < to);
}

/* The points between two tongues in which no node may be: two of one kind would be one. */
static enum hawser_status gaps(struct searches *list, struct hawser_report *report)
{
	struct hawser__mapper *mapper = list->mapper;
	size_t count = list->count;
	enum hawser_status status = HAWSER_OK;
	double end = 0.0;

	if (count > 0)
		qsort(list->item, count, sizeof *list->item, by_start);
	for (size_t c = 0; c < count && !status && list->item[c].done > 1; c++) {
		const struct search *item = &list->item[c], *last = &list->item[c > 0 ? c - 1 : 0];
		struct search gap = {.along = item->along, .line = item->line};
		double start = start_of(item);

		if (c == 0 || item->along != last->along || item->line != last->line)
			end = INFINITY;
		gap.ridge.at = 0.5*(start + end);
		end = fmax(isfinite(end) ? end : start, 2.0*item->ridge.centre - start);
		if (!(gap.ridge.at < start && start - gap.ridge.at < 0.5*GAP))
			continue;
		if (!(status = push(list, &gap, report)))
			status = want(mapper, &list->item[list->count - 1], report);
	}
	if (!status)
		status = hawser__map_run(&mapper->memo, "map: tongues", mapper->later, report);
	for (size_t c = count; c < list->count && !status && !mapper->memo.interrupted; c++) {
		list->item[c].seen = 1;
		status = keep(mapper, &list->item[c], report);
	}
	return status;
}

enum hawser_status hawser__map_ridges(struct hawser__mapper *mapper,
                                      const struct hawser__map_cells *cells,
                                      struct hawser_report *report)
{
	struct searches list = {.mapper = mapper};
	enum hawser_status status = HAWSER_OK;

	if (mapper->field->exponents == 0 || mapper->options->coarse == 1)
		return HAWSER_OK;
	if (!(status = edges(&list, cells, report)))
		status = hawser__map_run(&mapper->memo, "map: tongues", mapper->later, report);
	list.nears = 1;
	if (!status && !mapper->memo.interrupted)
		status = edges(&list, cells, report);
	while (list.active < list.count && !status && !mapper->memo.interrupted) {
		size_t count = list.count;

		for (size_t c = list.active; c < count && !status; c++)
			status = want(mapper, &list.item[c], report);
		if (!status)
			status = hawser__map_run(&mapper->memo, "map: tongues", mapper->later, report);
		for (size_t c = list.active; c < count && !status && !mapper->memo.interrupted; c++)
			status = judge(&list, c, report);
		sort_out(&list);
	}
	if (!status && !mapper->memo.interrupted)
		status = gaps(&list, report);
	free(list.item);
	return status;
}
