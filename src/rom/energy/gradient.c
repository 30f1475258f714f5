/* rom/energy/gradient.c - the potential of a kernel as a quadratic form, for forces without tangents.
 *
 *    z    [n + n(n+1)/2] the coordinates, then the products u_l u_m, l <= m, at n + m(m+1)/2 + l
 *    M    symmetric: V = z' M z/2, so that the force is y = M z by the chain rule of z
 *    part of an entry of M: which of its two triangles, and the degree of its monomial
 *
 * Every monomial of V is stored in M once (and once transposed): u_j u_k u_l u_m, j <= k <= l <= m,
 * as u_j u_k times u_l u_m. The rows of the kernel contain it in every possible division. The
 * quadratic form takes about a third of the work, and rows with the same u_k have the same columns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/hot.h"
#include "rom/energy/kernel.h"

struct item {
	int part, row, col;
	int from;     /* index of the kernel's value, of which it is this share */
	double share;
};

struct items {
	int count;
	struct item *item;
};

static int by_row(const void *left, const void *right)
{
	const struct item *a = left, *b = right;

	if (a->part != b->part)
		return a->part - b->part;
	return a->row != b->row ? a->row - b->row : a->col - b->col;
}

static void put(struct items *items, int part, int row, int col, int from, double share)
{
	items->item[items->count++] = (struct item){part, row, col, from, share};
	items->item[items->count++] = (struct item){part + 1, col, row, from, share};
}

/* 4!/(multiplicities!) of sorted indices; 3! with the first one -1. */
static double orders(int a, int b, int c, int d)
{
	const int index[4] = {a, b, c, d};
	double total = 1.0;
	int run = 0, count = 0;

	for (int i = a < 0; i < 4; i++) {
		run = i > 0 && index[i] == index[i - 1] ? run + 1 : 1;
		total *= (double)++count/run;
	}
	return total;
}

static int place(int n, int l, int m)
{
	return n + m*(m + 1)/2 + l;
}

/* The entries of row (j, k), k <= j, of A and B that represent their monomial: no index but k is
 * below j. */
static void take_row(struct items *items, const struct hawser_rom_kernel *kernel,
                     const struct hawser__kernel_row *row, int n)
{
	int j = row->j, k = row->k, constant = kernel->values + (int)(row - kernel->row);

	if (row->constant != 0.0) {
		items->item[items->count++] = (struct item){4, j, k, constant, 1.0};
		if (j != k)
			items->item[items->count++] = (struct item){4, k, j, constant, 1.0};
	}
	for (int r = row->a; r < row->b_end; r++) {
		const struct hawser__run *run = &kernel->run[r];

		for (int i = 0; i < HAWSER_BLOCK*run->blocks; i++) {
			int from = run->at + i, l, m;

			if (kernel->from[from] < 0)
				continue;
			l = r < row->a_end ? kernel->single[run->col + i] : kernel->pair_l[run->col + i];
			if (l < j)
				continue;
			if (r < row->a_end) {
				put(items, 2, place(n, j, l), k, from, orders(-1, k, j, l)/3.0);
				continue;
			}
			m = kernel->pair_m[run->col + i];
			put(items, 0, place(n, k, j), place(n, l, m), from,
			    orders(k, j, l, m)/(l == m ? 4.0 : 8.0));
		}
	}
}

/* Whether the rows that begin at items a and b have the same columns. */
static int alike(const struct items *items, int a, int b)
{
	const struct item *left = &items->item[a], *right = &items->item[b];
	int i = 0;

	for (;; i++) {
		int left_on = a + i < items->count && left[i].part == left->part &&
		              left[i].row == left->row;
		int right_on = b + i < items->count && right[i].part == right->part &&
		               right[i].row == right->row;

		if (!left_on || !right_on)
			return left_on == right_on;
		if (left[i].col != right[i].col)
			return 0;
	}
}

static int length(const struct items *items, int a)
{
	int i = a;

	while (i < items->count && items->item[i].part == items->item[a].part &&
	       items->item[i].row == items->item[a].row)
		i++;
	return i - a;
}

/* Panels of up to four rows. The row number of a row in a panel is made negative. */
static void fill(struct hawser__kernel_panels *panels, struct items *items)
{
	int next = 0;

	for (int a = 0, size; a < items->count; a += size) {
		struct hawser__panel *panel = &panels->panel[panels->count];

		size = length(items, a);
		if (items->item[a].col < 0)
			continue;
		*panel = (struct hawser__panel){.a = next, .a_end = next, .b = next,
			.b_end = next + size};
		for (int i = 0; i < size; i++)
			panels->column[next + i] = items->item[a + i].col;
		for (int b = a, step; b < items->count && panel->rows < 4 &&
		     items->item[b].part == items->item[a].part; b += step) {
			step = length(items, b);
			if (b != a && !alike(items, a, b))
				continue;
			panel->j[panel->rows] = items->item[b].row;
			for (int i = 0; i < size; i++) {
				panels->from[4*(next + i) + panel->rows] = items->item[b + i].from;
				panels->share[4*(next + i) + panel->rows] = items->item[b + i].share;
			}
			panel->rows++;
			if (b != a)
				items->item[b].col = -1;
		}
		next += size;
		panels->count++;
	}
}

struct hawser__kernel_panels *hawser__gradient_new(const struct hawser_rom_kernel *kernel, int n)
{
	size_t most = 2*(size_t)kernel->values + 2*(size_t)kernel->rows + 1;
	struct hawser__kernel_panels *panels = calloc(1, sizeof *panels);
	struct items items = {0, malloc(most*sizeof *items.item)};
	int good = 0;

	if (!panels || !items.item)
		goto done;
	for (int r = 0; r < kernel->rows; r++)
		take_row(&items, kernel, &kernel->row[r], n);
	qsort(items.item, (size_t)items.count, sizeof *items.item, by_row);
	panels->share = hawser__numbers(4, (size_t)items.count);
	if (!hawser__panels_room(panels, items.count, items.count) || !panels->share)
		goto done;
	fill(panels, &items);
	hawser__panels_fill(panels, kernel);
	good = 1;
done:
	free(items.item);
	if (good)
		return panels;
	hawser__panels_free(panels);
	return NULL;
}
