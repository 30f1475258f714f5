/* study/map/map_tree.c - refinement of the cells.
 *
 * A cell is split if its corners differ (in number or code), if its value varies much, or if a
 * boundary or a narrow instability crosses one of its edges. It is split at the middle node of each
 * side; the halves need not be equal. Where its value varies along one axis only, as beside a
 * resonance that hardly moves with the other parameter, and is far from the threshold, only the sides
 * along this axis are divided. All cells of a level are split together, so that the criterion
 * for the variation, which is relative to all nodes so far, does not depend on the order.
 *
 * A boundary may then enter a large cell from a smaller neighbour without a difference of the
 * corners of the large cell. Such a cell is split as well, repeatedly, until no boundary ends at a
 * large cell. In this way a boundary is followed through the map from any point at which it was
 * found.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/grow.h"
#include "core/report.h"
#include "study/map/map.h"

#define REAL 1e-3     /* largest sine of the argument of a multiplier that counts as real; chosen */
#define ROUND_OFF 1e-9 /* variation over the map, relative to the values, that is round-off */

enum { ALONG_X = 1, ALONG_Y = 2 };

const struct hawser_map_sample *hawser__map_sample(const struct hawser__mapper *mapper, long index)
{
	return &mapper->memo.record[index].sample;
}

const double *hawser__map_marks(const struct hawser__mapper *mapper, long index)
{
	return mapper->memo.mark + index*mapper->memo.marks;
}

/* What the unstable multipliers of a point are: 64 p + q for p at +1 and q at -1; the rest are
 * complex. */
static int kinds(const struct hawser__mapper *mapper, long index)
{
	int n = mapper->field->exponents, number = hawser__map_sample(mapper, index)->number, found = 0;
	const double *modulus = hawser__map_marks(mapper, index) + HAWSER__MARGINS + 1 + 2*n;

	for (int i = 0; i < 2*n; i++) {
		double angle = fabs(modulus[2*n + i]);
		int larger = 0;

		for (int k = 0; k < 2*n; k++)
			larger += modulus[k] > modulus[i];
		if (larger < number && fabs(sin(angle)) < REAL)
			found += angle < 1.0 ? 64 : 1;
	}
	return found;
}

int hawser__map_differ(const struct hawser__mapper *mapper, long a, long b)
{
	const struct hawser_map_sample *s = hawser__map_sample(mapper, a);
	const struct hawser_map_sample *t = hawser__map_sample(mapper, b);

	if (s->code != t->code || (s->code == HAWSER_MAP_OK && s->number != t->number))
		return 1;
	return s->code == HAWSER_MAP_OK && s->number > 0 && mapper->field->exponents > 0 &&
	       mapper->memo.marks > HAWSER__MARGINS && kinds(mapper, a) != kinds(mapper, b);
}

static enum hawser_status push(struct hawser__map_cells *cells, int i0, int i1, int j0, int j1,
                               struct hawser_report *report)
{
	if (hawser__more(&cells->cell, (long)cells->count, sizeof *cells->cell))
		return hawser__no_memory(report, "map");
	cells->cell[cells->count++] = (struct hawser__map_cell){i0, i1, j0, j1};
	return HAWSER_OK;
}

/* The axes along which the cell has sides of several smallest cells. */
static int divisible(const struct hawser__map_cell *cell)
{
	return (cell->i1 - cell->i0 > 1 ? ALONG_X : 0) | (cell->j1 - cell->j0 > 1 ? ALONG_Y : 0);
}

/* Divide a range of `points` nodes into cells of about the coarse size. */
static int parts(int points, int coarse)
{
	return (points - 2)/coarse + 1;
}

static int cut(int part, int count, int points)
{
	return (int)((long)part*(points - 1)/count);
}

static enum hawser_status first_cells(struct hawser__map_cells *cells,
                                      const struct hawser__mapper *mapper,
                                      struct hawser_report *report)
{
	int nx = mapper->nx, ny = mapper->ny, coarse = mapper->options->coarse;
	int columns = parts(nx, coarse), rows = parts(ny, coarse);
	int part = mapper->options->part, each = mapper->options->parts;
	enum hawser_status status = HAWSER_OK;

	for (int b = 0; b < rows && !status; b++)
		for (int a = 0; a < columns && !status; a++) {
			if (each > 0 && hawser__map_part_of(a, b, columns, rows, each) != part)
				continue;
			status = push(cells, cut(a, columns, nx), cut(a + 1, columns, nx),
			              cut(b, rows, ny), cut(b + 1, rows, ny), report);
		}
	return status;
}

/* `axes`: which sides are divided. */
static enum hawser_status split(struct hawser__map_cells *into, const struct hawser__map_cell *cell,
                                int axes, struct hawser_report *report)
{
	int i[3] = {cell->i0, axes & ALONG_X ? (cell->i0 + cell->i1)/2 : cell->i0, cell->i1};
	int j[3] = {cell->j0, axes & ALONG_Y ? (cell->j0 + cell->j1)/2 : cell->j0, cell->j1};
	enum hawser_status status = HAWSER_OK;

	for (int b = 0; b < 2; b++)
		for (int a = 0; a < 2; a++)
			if (i[a] < i[a + 1] && j[b] < j[b + 1] && !status)
				status = push(into, i[a], i[a + 1], j[b], j[b + 1], report);
	return status;
}

static enum hawser_status want_node(struct hawser__mapper *mapper, int i, int j,
                                    struct hawser_report *report)
{
	long *node = &mapper->node[(long)j*mapper->nx + i];

	return *node >= 0 ? HAWSER_OK
	       : hawser__map_want(&mapper->memo, node, mapper->x[i], mapper->y[j], report);
}

static enum hawser_status want_corners(struct hawser__mapper *mapper,
                                       const struct hawser__map_cells *cells,
                                       struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (size_t c = 0; c < cells->count && !status; c++) {
		const struct hawser__map_cell *cell = &cells->cell[c];

		if ((status = want_node(mapper, cell->i0, cell->j0, report)) ||
		    (status = want_node(mapper, cell->i1, cell->j0, report)) ||
		    (status = want_node(mapper, cell->i0, cell->j1, report)) ||
		    (status = want_node(mapper, cell->i1, cell->j1, report)))
			break;
	}
	return status;
}

static long node_of(const struct hawser__mapper *mapper, int i, int j)
{
	return mapper->node[(long)j*mapper->nx + i];
}

static const struct hawser_map_sample *at(const struct hawser__mapper *mapper, int i, int j)
{
	return hawser__map_sample(mapper, node_of(mapper, i, j));
}

static double measure(const struct hawser__mapper *mapper, double value)
{
	return !mapper->field->logarithmic ? value : log(fmax(fabs(value), 1e-300));
}

/* Range of the values at the corners of the cells and of the previous range. */
static void widen(struct hawser__mapper *mapper, const struct hawser__map_cells *cells)
{
	for (size_t c = 0; c < cells->count; c++)
		for (int k = 0; k < 4; k++) {
			const struct hawser__map_cell *cell = &cells->cell[c];
			const struct hawser_map_sample *s = at(mapper, k & 1 ? cell->i1 : cell->i0,
			                                       k & 2 ? cell->j1 : cell->j0);

			if (s->code != HAWSER_MAP_OK)
				continue;
			mapper->low = fmin(mapper->low, measure(mapper, s->value));
			mapper->high = fmax(mapper->high, measure(mapper, s->value));
		}
}

/* Axes along which the values at the corners, whose numbers are the same, vary by more than allowed. */
static int steep(const struct hawser__mapper *mapper, const struct hawser_map_sample *const *corner)
{
	double most = fmax(mapper->options->jump*(mapper->high - mapper->low),
	                   ROUND_OFF*fmax(fabs(mapper->high), fabs(mapper->low)));
	double value[4], low = INFINITY, high = -INFINITY;
	double threshold = measure(mapper, mapper->field->threshold);

	for (int k = 0; k < 4; k++) {
		value[k] = measure(mapper, corner[k]->value);
		low = fmin(low, value[k]);
		high = fmax(high, value[k]);
	}
	if (!(high - low > most))
		return 0;
	if (fmax(low - threshold, threshold - high) < high - low) /* a boundary may be in it */
		return ALONG_X | ALONG_Y;
	return (fmax(fabs(value[1] - value[0]), fabs(value[3] - value[2])) > 0.5*most ? ALONG_X : 0) |
	       (fmax(fabs(value[2] - value[0]), fabs(value[3] - value[1])) > 0.5*most ? ALONG_Y : 0);
}

/* The axes along which the corners require smaller cells. */
static int varied(const struct hawser__mapper *mapper, const struct hawser__map_cell *cell)
{
	const struct hawser_map_sample *corner[4] = {
		at(mapper, cell->i0, cell->j0), at(mapper, cell->i1, cell->j0),
		at(mapper, cell->i0, cell->j1), at(mapper, cell->i1, cell->j1)};

	for (int k = 1; k < 4; k++)
		if (hawser__map_differ(mapper, node_of(mapper, cell->i0, cell->j0),
		                       node_of(mapper, k & 1 ? cell->i1 : cell->i0,
		                               k & 2 ? cell->j1 : cell->j0)))
			return ALONG_X | ALONG_Y;
	return corner[0]->code == HAWSER_MAP_OK && mapper->options->jump > 0.0 ? steep(mapper, corner) : 0;
}

/* Expected number of further points: at each level a boundary crosses twice as many cells, down to
 * those whose shorter side cannot be split, as tongues have them; the brackets of boundaries take about
 * as many as the last level. */
static long expect(const struct hawser__mapper *mapper, const struct hawser__map_cells *cells)
{
	const struct hawser__map_cell *cell = cells->cell;
	int size = cell->i1 - cell->i0 < cell->j1 - cell->j0 ? cell->i1 - cell->i0
	                                                     : cell->j1 - cell->j0;
	long waiting = mapper->memo.waiting, later = 0;

	for (; size > 1; size = (size + 1)/2)
		later += later + waiting;
	return later + (later + waiting);
}

/* Whether a node on the edge of the cell differs from its corner, or there is a narrow instability
 * beside it. */
static int stands_out(const struct hawser__mapper *mapper, const struct hawser__map_cell *cell, int i,
                      int j, int along)
{
	long place = (long)j*mapper->nx + i;

	return (mapper->hot[place] & (1 << along)) ||
	       (mapper->node[place] >= 0 &&
	        hawser__map_differ(mapper, node_of(mapper, cell->i0, cell->j0), node_of(mapper, i, j)));
}

static int entered(const struct hawser__mapper *mapper, const struct hawser__map_cell *cell)
{
	for (int i = cell->i0; i < cell->i1; i++)
		if (stands_out(mapper, cell, i, cell->j0, 0) || stands_out(mapper, cell, i, cell->j1, 0))
			return ALONG_X | ALONG_Y;
	for (int j = cell->j0; j < cell->j1; j++)
		if (stands_out(mapper, cell, cell->i0, j, 1) || stands_out(mapper, cell, cell->i1, j, 1))
			return ALONG_X | ALONG_Y;
	return 0;
}

static enum hawser_status level(struct hawser__mapper *mapper, struct hawser__map_cells *next,
                                const struct hawser__map_cells *cells, struct hawser_report *report)
{
	enum hawser_status status = want_corners(mapper, cells, report);

	mapper->later = expect(mapper, cells);
	if (!status)
		status = hawser__map_run(&mapper->memo, "map: cells", mapper->later, report);
	if (!status && !mapper->memo.interrupted) {
		widen(mapper, cells);
		if (!mapper->searched)
			status = hawser__map_ridges(mapper, cells, report);
		mapper->searched = 1;
	}
	for (size_t c = 0; c < cells->count && !status && !mapper->memo.interrupted; c++) {
		const struct hawser__map_cell *cell = &cells->cell[c];
		int axes = divisible(cell);

		if (axes)
			axes &= varied(mapper, cell) | entered(mapper, cell);
		if (axes)
			status = split(next, cell, axes, report);
		else
			status = push(&mapper->leaf, cell->i0, cell->i1, cell->j0, cell->j1, report);
	}
	return status;
}

static enum hawser_status descend(struct hawser__mapper *mapper, struct hawser__map_cells *cells,
                                  struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	while (cells->count > 0 && !status && !mapper->memo.interrupted) {
		struct hawser__map_cells next = {0};

		status = level(mapper, &next, cells, report);
		free(cells->cell);
		*cells = next;
	}
	return status;
}

/* Move the large cells that a boundary enters from the list to `cells`, to be split. */
static enum hawser_status reopen(struct hawser__mapper *mapper, struct hawser__map_cells *cells,
                                 struct hawser_report *report)
{
	struct hawser__map_cells *leaf = &mapper->leaf;
	enum hawser_status status = HAWSER_OK;
	size_t kept = 0;

	for (size_t c = 0; c < leaf->count && !status; c++) {
		struct hawser__map_cell cell = leaf->cell[c];

		if (divisible(&cell) && entered(mapper, &cell))
			status = split(cells, &cell, ALONG_X | ALONG_Y, report);
		else
			leaf->cell[kept++] = cell;
	}
	leaf->count = kept;
	return status;
}

enum hawser_status hawser__map_grow(struct hawser__mapper *mapper, struct hawser_report *report)
{
	struct hawser__map_cells cells = {0};
	enum hawser_status status = first_cells(&cells, mapper, report);

	while (cells.count > 0 && !status && !mapper->memo.interrupted) {
		status = descend(mapper, &cells, report);
		if (!status && !mapper->memo.interrupted)
			status = reopen(mapper, &cells, report);
	}
	free(cells.cell);
	return status;
}
