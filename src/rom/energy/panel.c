/* rom/energy/panel.c - rows of a kernel with the same columns, combined in fours; see kernel.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>
#include <string.h>

#include "core/hot.h"
#include "rom/energy/kernel.h"

/* The nonzero entries of all rows, row by row; those of B follow those of A. */
struct lists {
	int *column;   /* [entries] coordinate, or index of the pair */
	double *value; /* [entries] */
	int *a, *b;    /* [rows + 1] positions at which the entries of row r in A and B begin; b[r] ends
	                * A, a[r + 1] ends B */
	int *taken;    /* [rows] 1: already in a panel */
};

static int take(struct lists *lists, int next, const struct hawser_rom_kernel *kernel, int begin,
                int end, int kind)
{
	for (int r = begin; r < end; r++) {
		const struct hawser__run *run = &kernel->run[r];

		for (int i = 0; i < HAWSER_BLOCK*run->blocks; i++) {
			int c = run->col + i, l, m;

			if (kernel->value[run->at + i] == 0.0)
				continue;
			l = kind ? kernel->pair_l[c] : 0;
			m = kind ? kernel->pair_m[c] : 0;
			lists->column[next] = kind ? m*(m + 1)/2 + l : kernel->single[c];
			lists->value[next++] = kernel->value[run->at + i];
		}
	}
	return next;
}

static void list_rows(struct lists *lists, const struct hawser_rom_kernel *kernel)
{
	int next = 0;

	for (int r = 0; r < kernel->rows; r++) {
		const struct hawser__kernel_row *row = &kernel->row[r];

		lists->a[r] = next;
		next = take(lists, next, kernel, row->a, row->a_end, 0);
		lists->b[r] = next;
		next = take(lists, next, kernel, row->b, row->b_end, 1);
	}
	lists->a[kernel->rows] = next;
}

/* Whether two rows have the same columns, in A and in B. */
static int alike(const struct lists *lists, int r, int s)
{
	size_t count = (size_t)(lists->a[r + 1] - lists->a[r]);

	return lists->b[r] - lists->a[r] == lists->b[s] - lists->a[s] &&
	       lists->a[r + 1] - lists->a[r] == lists->a[s + 1] - lists->a[s] &&
	       !memcmp(lists->column + lists->a[r], lists->column + lists->a[s],
	               count*sizeof *lists->column);
}

/* The panel that begins with row `first`; *next is the first free entry. */
static void fill(struct hawser__kernel_panels *panels, int *next, struct lists *lists,
                 const struct hawser_rom_kernel *kernel, int first)
{
	struct hawser__panel *panel = &panels->panel[panels->count++];
	int begin = lists->a[first], split = lists->b[first], end = lists->a[first + 1];

	*panel = (struct hawser__panel){.a = *next, .a_end = *next + split - begin,
		.b = *next + split - begin, .b_end = *next + end - begin};
	memcpy(panels->column + *next, lists->column + begin,
	       (size_t)(end - begin)*sizeof *panels->column);
	for (int s = first; s < kernel->rows && panel->rows < 4; s++) {
		int r = panel->rows;

		if (lists->taken[s] || !alike(lists, first, s))
			continue;
		lists->taken[s] = 1;
		panel->j[r] = kernel->row[s].j;
		panel->k[r] = kernel->row[s].k;
		panel->constant[r] = kernel->row[s].constant;
		for (int i = 0; i < end - begin; i++)
			panels->value[4*(*next + i) + r] = lists->value[lists->a[s] + i];
		panel->rows++;
	}
	*next += end - begin;
}

static int list_new(struct lists *lists, const struct hawser_rom_kernel *kernel)
{
	size_t entries = (size_t)kernel->values + 1, rows = (size_t)kernel->rows + 1;

	*lists = (struct lists){malloc(entries*sizeof *lists->column),
		malloc(entries*sizeof *lists->value), malloc(rows*sizeof(int)),
		malloc(rows*sizeof(int)), calloc(rows, sizeof(int))};
	return lists->column && lists->value && lists->a && lists->b && lists->taken;
}

struct hawser__kernel_panels *hawser__panels_new(const struct hawser_rom_kernel *kernel)
{
	struct hawser__kernel_panels *panels = calloc(1, sizeof *panels);
	struct lists lists = {0};
	int next = 0, good = 0;

	if (!panels || !list_new(&lists, kernel))
		goto done;
	list_rows(&lists, kernel);
	panels->panel = malloc(((size_t)kernel->rows + 1)*sizeof *panels->panel);
	panels->column = malloc(((size_t)lists.a[kernel->rows] + 1)*sizeof *panels->column);
	panels->value = calloc(4*((size_t)lists.a[kernel->rows] + 1), sizeof *panels->value);
	if (!panels->panel || !panels->column || !panels->value)
		goto done;
	for (int r = 0; r < kernel->rows; r++)
		if (!lists.taken[r])
			fill(panels, &next, &lists, kernel, r);
	good = 1;
done:
	free(lists.column);
	free(lists.value);
	free(lists.a);
	free(lists.b);
	free(lists.taken);
	if (good)
		return panels;
	hawser__panels_free(panels);
	return NULL;
}

void hawser__panels_free(struct hawser__kernel_panels *panels)
{
	if (!panels)
		return;
	free(panels->panel);
	free(panels->column);
	free(panels->value);
	free(panels);
}
