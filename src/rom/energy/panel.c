/* rom/energy/panel.c - rows of a kernel with the same columns, combined in fours; see kernel.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/hot.h"
#include "rom/energy/kernel.h"

/* The nonzero entries of all rows, row by row; those of B follow those of A. */
struct lists {
	int *column;   /* [entries] coordinate, or index of the pair */
	int *from;     /* [entries] index of the kernel's value */
	int *a, *b;    /* [rows + 1] positions at which the entries of row r in A and B begin; b[r] ends
	                * A, a[r + 1] ends B */
	int *taken;    /* [rows] 1: already in a panel */
	struct hawser__hold hold;
};

static int take(struct lists *lists, int next, const struct hawser_rom_kernel *kernel, int begin,
                int end, int kind)
{
	for (int r = begin; r < end; r++) {
		const struct hawser__run *run = &kernel->run[r];

		for (int i = 0; i < HAWSER_BLOCK*run->blocks; i++) {
			int c = run->col + i, l, m;

			if (kernel->from[run->at + i] < 0)
				continue;
			l = kind ? kernel->pair_l[c] : 0;
			m = kind ? kernel->pair_m[c] : 0;
			lists->column[next] = kind ? m*(m + 1)/2 + l : kernel->single[c];
			lists->from[next++] = run->at + i;
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
		panel->row[r] = s;
		for (int i = 0; i < end - begin; i++)
			panels->from[4*(*next + i) + r] = lists->from[lists->a[s] + i];
		panel->rows++;
	}
	*next += end - begin;
}

static int list_new(struct lists *lists, const struct hawser_rom_kernel *kernel)
{
	size_t entries = (size_t)kernel->values, rows = (size_t)kernel->rows + 1;

	lists->column = hawser__hold(&lists->hold, entries, sizeof *lists->column);
	lists->from = hawser__hold(&lists->hold, entries, sizeof *lists->from);
	lists->a = hawser__hold(&lists->hold, rows, sizeof *lists->a);
	lists->b = hawser__hold(&lists->hold, rows, sizeof *lists->b);
	lists->taken = hawser__hold(&lists->hold, rows, sizeof *lists->taken);
	return !lists->hold.short_of_memory;
}

int hawser__panels_room(struct hawser__kernel_panels *panels, int rows, int columns)
{
	panels->values = 4*columns;
	panels->panel = calloc((size_t)rows + 1, sizeof *panels->panel);
	panels->column = malloc(((size_t)columns + 1)*sizeof *panels->column);
	panels->value = hawser__numbers(4, (size_t)columns);
	panels->from = malloc((4*(size_t)columns + 1)*sizeof *panels->from);
	for (int i = 0; panels->from && i < panels->values; i++)
		panels->from[i] = -1;
	return panels->panel && panels->column && panels->value && panels->from;
}

void hawser__panels_fill(struct hawser__kernel_panels *panels, const struct hawser_rom_kernel *kernel)
{
	for (int i = 0; i < panels->values; i++)
		if (panels->from[i] >= 0)
			panels->value[i] = (panels->share ? panels->share[i] : 1.0)*
			                   kernel->value[panels->from[i]];
	for (int p = 0; p < panels->count; p++)
		for (int r = 0; r < 4; r++)
			panels->panel[p].constant[r] = kernel->row[panels->panel[p].row[r]].constant;
}

struct hawser__kernel_panels *hawser__panels_new(const struct hawser_rom_kernel *kernel)
{
	struct hawser__kernel_panels *panels = calloc(1, sizeof *panels);
	struct lists lists = {0};
	int next = 0, good = 0;

	if (!panels || !list_new(&lists, kernel))
		goto done;
	list_rows(&lists, kernel);
	if (!hawser__panels_room(panels, kernel->rows, lists.a[kernel->rows]))
		goto done;
	for (int r = 0; r < kernel->rows; r++)
		if (!lists.taken[r])
			fill(panels, &next, &lists, kernel, r);
	hawser__panels_fill(panels, kernel);
	good = 1;
done:
	hawser__hold_clear(&lists.hold);
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
	free(panels->from);
	free(panels->share);
	free(panels);
}
