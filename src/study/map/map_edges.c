/* study/map/map_edges.c - boundaries, bracketed on the edges of the finest cells.
 *
 * If the ends of an edge differ, the boundary between them is bracketed to a tolerance by the ITP
 * method (Oliveira and Takahashi 2020). It needs at most one step more than bisection, and far
 * fewer if the value crosses its threshold smoothly. All brackets take a step together, so that
 * their points are computed in parallel.
 *
 *    t    position along an edge, 0 to 1
 *    g    value minus threshold; its sign identifies the side if one side has no instability
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/grow.h"
#include "core/report.h"
#include "study/map/map.h"

double hawser__map_between(double a, double b, double t)
{
	return a + t*(b - a);
}

enum hawser_status hawser__map_want_on(struct hawser__mapper *mapper, long *index, int i, int j,
                                  int along, int length, double t, struct hawser_report *report)
{
	double x = mapper->x[i], y = mapper->y[j];

	if (along == 0)
		x = hawser__map_between(x, mapper->x[i + length], t);
	else
		y = hawser__map_between(y, mapper->y[j + length], t);
	return hawser__map_want(&mapper->memo, index, x, y, report);
}

enum { MOST_STEPS = 60 };
#define VAGUE 15.0 /* brackets where the response ends are wider by this factor: a response is followed
                    * to a thousandth of its excitation only (response/orbit/start.c); chosen, a quarter
                    * of a cell by default */

static enum hawser_status add_bracket(const struct hawser__mapper *mapper,
                                      struct hawser__map_brackets *list, long edge, double ta,
                                      double tb, long a, long b, struct hawser_report *report)
{
	if (hawser__more(&list->item, (long)list->count, sizeof *list->item))
		return hawser__no_memory(report, "map");
	list->item[list->count++] = (struct hawser__map_bracket){.edge = edge, .t = {ta, tb},
		.index = {a, b}, .width0 = tb - ta};
	hawser__map_doubt(mapper, &list->item[list->count - 1], 1);
	return HAWSER_OK;
}

static int by_edge(const void *a, const void *b)
{
	const struct hawser__map_probe *x = a, *y = b;

	if (x->edge != y->edge)
		return x->edge < y->edge ? -1 : 1;
	return (x->t > y->t) - (x->t < y->t);
}

static size_t first_probe(const struct hawser__mapper *mapper, long edge)
{
	size_t low = 0, high = mapper->probes;

	while (low < high) {
		size_t middle = (low + high)/2;

		if (mapper->probe[middle].edge < edge)
			low = middle + 1;
		else
			high = middle;
	}
	return low;
}

/* Brackets between successive points of an edge that differ. */
static enum hawser_status bracket_edge(const struct hawser__mapper *mapper,
                                       struct hawser__map_brackets *list, int i, int j, int along,
                                       struct hawser_report *report)
{
	long place = (long)j*mapper->nx + i, edge = 2*place + along;
	long a = mapper->node[place], last = mapper->node[along == 0 ? place + 1 : place + mapper->nx];
	double t = 0.0;
	enum hawser_status status = HAWSER_OK;

	for (size_t p = first_probe(mapper, edge); !status; p++) {
		int more = p < mapper->probes && mapper->probe[p].edge == edge;
		long b = more ? mapper->probe[p].index : last;
		double next = more ? mapper->probe[p].t : 1.0;

		if (next > t &&
		    hawser__map_differ(mapper, a, b))
			status = add_bracket(mapper, list, edge, t, next, a, b, report);
		if (!more)
			break;
		t = next;
		a = b;
	}
	return status;
}

static enum hawser_status all_edges(struct hawser__mapper *mapper, struct hawser__map_brackets *list,
                                    struct hawser_report *report)
{
	size_t nodes = (size_t)mapper->nx*(size_t)mapper->ny;
	unsigned char *seen = calloc(nodes, 1);
	enum hawser_status status = seen ? HAWSER_OK : hawser__no_memory(report, "map");

	for (size_t c = 0; c < mapper->leaf.count && !status; c++) {
		const struct hawser__map_cell *cell = &mapper->leaf.cell[c];
		const int i[4] = {cell->i0, cell->i0, cell->i0, cell->i1};
		const int j[4] = {cell->j0, cell->j1, cell->j0, cell->j0};

		if (cell->i1 - cell->i0 != 1 || cell->j1 - cell->j0 != 1)
			continue;
		for (int k = 0; k < 4 && !status; k++) {
			size_t place = (size_t)j[k]*(size_t)mapper->nx + (size_t)i[k];
			unsigned char bit = k < 2 ? 1 : 2;

			if (!(seen[place] & bit))
				status = bracket_edge(mapper, list, i[k], j[k], k < 2 ? 0 : 1, report);
			seen[place] |= bit;
		}
	}
	free(seen);
	return status;
}

/* Value minus threshold if its sign identifies the side; otherwise 0. */
static double side(const struct hawser__mapper *mapper, const struct hawser_map_sample *sample)
{
	double g = sample->value - mapper->field->threshold;

	if (sample->code != HAWSER_MAP_OK)
		return 0.0;
	return sample->number > 0 ? fmax(g, 1e-300) : fmin(g, -1e-300);
}

/* The point of Oliveira and Takahashi, with kappa_1 = 0.2/width0, kappa_2 = 2, n_0 = 1. */
static double next_place(const struct hawser__mapper *mapper, const struct hawser__map_bracket *item,
                         double tolerance)
{
	double a = item->t[0], b = item->t[1], half = 0.5*(a + b), r, delta, x;
	double ga = side(mapper, hawser__map_sample(mapper, item->index[0]));
	double gb = side(mapper, hawser__map_sample(mapper, item->index[1]));

	if (!(ga*gb < 0.0) || !isfinite(ga - gb))
		return half;
	r = 0.5*tolerance*exp2(ceil(log2(item->width0/tolerance)) + 1.0 - item->steps) - 0.5*(b - a);
	x = a + (b - a)*ga/(ga - gb);
	delta = 0.2/item->width0*(b - a)*(b - a);
	x = delta <= fabs(half - x) ? x + copysign(delta, half - x) : half;
	if (fabs(x - half) > fmax(r, 0.0))
		x = half - copysign(fmax(r, 0.0), half - x);
	return x > a && x < b ? x : half;
}

/* The width of a bracket on an edge, in cells, with which it is done. */
static double enough(const struct hawser__mapper *mapper, const struct hawser__map_bracket *item)
{
	int points = item->edge%2 == 0 ? mapper->nx : mapper->ny;
	int vague = hawser__map_sample(mapper, item->index[0])->code == HAWSER_MAP_NO_RESPONSE ||
	            hawser__map_sample(mapper, item->index[1])->code == HAWSER_MAP_NO_RESPONSE;

	return mapper->options->tolerance*(points - 1)*(vague ? VAGUE : 1.0);
}

static enum hawser_status step(struct hawser__mapper *mapper, struct hawser__map_brackets *list,
                               long *active, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	*active = 0;
	for (size_t c = 0; c < list->count && !status; c++) {
		struct hawser__map_bracket *item = &list->item[c];
		long place = item->edge/2;
		int along = (int)(item->edge%2);
		double tolerance = enough(mapper, item);

		item->done |= item->t[1] - item->t[0] <= tolerance || item->steps >= MOST_STEPS;
		if (item->done)
			continue;
		item->at = next_place(mapper, item, tolerance);
		item->steps++;
		status = hawser__map_want_on(mapper, &item->middle, (int)(place%mapper->nx),
		                 (int)(place/mapper->nx), along, 1, item->at, report);
		*active += 1;
	}
	return status;
}

/* if the point belongs to neither side, it is in a third region, between two boundaries */
static enum hawser_status narrow(struct hawser__mapper *mapper, struct hawser__map_brackets *list,
                                 struct hawser_report *report)
{
	size_t count = list->count;
	enum hawser_status status = HAWSER_OK;

	for (size_t c = 0; c < count && !status; c++) {
		struct hawser__map_bracket *item = &list->item[c];
		int first, second;

		if (item->done)
			continue;
		first = hawser__map_differ(mapper, item->middle, item->index[0]);
		second = hawser__map_differ(mapper, item->middle, item->index[1]);
		if (first && second) {
			struct hawser__map_bracket old = *item;

			status = add_bracket(mapper, list, old.edge, old.at, old.t[1], old.middle,
			                     old.index[1], report);
			item = &list->item[c];
		}
		item->t[first ? 1 : 0] = item->at;
		item->index[first ? 1 : 0] = item->middle;
		hawser__map_doubt(mapper, item, first && second);
	}
	return status;
}

static int by_place(const void *a, const void *b)
{
	const struct hawser__map_bracket *x = a, *y = b;

	if (x->edge != y->edge)
		return x->edge < y->edge ? -1 : 1;
	return (x->t[0] > y->t[0]) - (x->t[0] < y->t[0]);
}

/* Only the kind of the instabilities changes there: no boundary. */
static void drop_equal(const struct hawser__mapper *mapper, struct hawser__map_brackets *list)
{
	size_t kept = 0;

	for (size_t c = 0; c < list->count; c++) {
		const struct hawser_map_sample *a = hawser__map_sample(mapper, list->item[c].index[0]);
		const struct hawser_map_sample *b = hawser__map_sample(mapper, list->item[c].index[1]);

		if (a->code != b->code || a->number != b->number)
			list->item[kept++] = list->item[c];
	}
	list->count = kept;
}

enum hawser_status hawser__map_boundaries(struct hawser_map *map, struct hawser__mapper *mapper,
                                          struct hawser_report *report)
{
	struct hawser__map_brackets list = {0};
	enum hawser_status status;
	long active = 1;

	if (mapper->probes > 0)
		qsort(mapper->probe, mapper->probes, sizeof *mapper->probe, by_edge);
	status = all_edges(mapper, &list, report);
	while (!status && active > 0 && !mapper->memo.interrupted) {
		status = step(mapper, &list, &active, report);
		if (!status && active > 0)
			status = hawser__map_run(&mapper->memo, "map: boundaries", 3*active, report);
		if (!status && active > 0 && !mapper->memo.interrupted)
			status = narrow(mapper, &list, report);
	}
	drop_equal(mapper, &list);
	if (!status && list.count > 0)
		qsort(list.item, list.count, sizeof *list.item, by_place);
	if (!status)
		status = hawser__map_lines(map, mapper, &list, report);
	free(list.item);
	return status;
}
