/* rom/file/rows.c - see auto.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "rom/file/auto.h"

struct list {
	struct hawser__row *row; /* NULL: they are only counted */
	int rows, n;
};

static void add(struct list *to, struct hawser__row row)
{
	if (row.value == 0.0)
		return;
	if (to->row)
		to->row[to->rows] = row;
	to->rows++;
}

/* - matrix x; `from`: 0 for u, n for v. */
static void add_matrix(struct list *to, int h, const double *matrix, int from)
{
	int n = to->n;

	for (int i = 0; matrix && i < n*n; i++)
		add(to, (struct hawser__row){i/n, h, h == 0 && from > 0, 1, {from + i%n}, -matrix[i]});
}

static void add_terms(struct list *to, int h, const struct hawser_term *term, int terms)
{
	for (int e = 0; e < terms; e++) {
		struct hawser__row row = {.j = term[e].j, .h = h, .factors = term[e].factors,
			.value = -term[e].value};

		for (int i = 0; i < row.factors; i++)
			row.factor[i] = term[e].factor[i] + (i < row.factors - term[e].rates ? 0 : to->n);
		add(to, row);
	}
}

static void add_quads(struct list *to, int h, const struct hawser_quad *Q, int quads)
{
	for (int e = 0; e < quads; e++)
		add(to, (struct hawser__row){Q[e].j, h, 0, 2, {Q[e].k, Q[e].l}, -Q[e].value});
}

static void add_all(struct list *to, const struct hawser_rom *rom)
{
	add_matrix(to, 0, rom->K, 0);
	add_matrix(to, 0, rom->D, rom->n);
	add_quads(to, 0, rom->Q, rom->quads);
	for (int e = 0; e < rom->cubics; e++)
		add(to, (struct hawser__row){rom->C[e].j, 0, 0, 3, {rom->C[e].k, rom->C[e].l, rom->C[e].m},
			-rom->C[e].value});
	add_terms(to, 0, rom->term, rom->terms);
	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[h];

		for (int j = 0; harmonic->f && j < rom->n; j++)
			add(to, (struct hawser__row){.j = j, .h = h + 1, .value = harmonic->f[j]});
		add_matrix(to, h + 1, harmonic->K, 0);
		add_matrix(to, h + 1, harmonic->D, rom->n);
		add_quads(to, h + 1, harmonic->Q, harmonic->quads);
		add_terms(to, h + 1, harmonic->term, harmonic->terms);
	}
}

void hawser__rows(struct hawser__row **row, int *rows, const struct hawser_rom *rom)
{
	struct list list = {.n = rom->n};

	add_all(&list, rom);
	*rows = list.rows;
	*row = list.row = calloc((size_t)list.rows + 1, sizeof *list.row);
	list.rows = 0;
	if (list.row)
		add_all(&list, rom);
}
