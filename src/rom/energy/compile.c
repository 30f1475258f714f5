/* rom/energy/compile.c - the kernel of kernel.h from the entries of a model.
 *
 * A monomial c u_k u_l u_m of equation j is divided equally among the distinct orders of its
 * indices (1, 3 or 6), so that the tensor of every equation is symmetric in k, l, m. Only then
 * tangent = K + 2A + 3B. Symmetry between j and the other indices is a property of the model (it
 * has a potential) and not of this division; it is measured here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/hot.h"
#include "core/report.h"
#include "rom/file/entries.h"
#include "rom/energy/kernel.h"
#include "rom/terms/terms.h"

/* Largest relative asymmetry of tensors that count as derived from a potential: the round-off of a
 * projection is of order 1e-15. */
#define SYMMETRIC_WITHIN 1e-13

/* Number of coordinates from which forces alone are faster by the quadratic form of the potential
 * (gradient.c) than by the rows of G. Below it, the overhead of its many short sums exceeds the
 * work that it saves (measured by bench/kernel). */
#define FORM_FROM 12

/* An entry of G: row (j, k), kind 0 for A and 1 for B, column (first the index of the coordinate or
 * pair, later its position in the order of the kernel), index of the entry of Q or C that it is a share
 * of. No two have the same place, since the entries of Q and C are different monomials. */
struct entry {
	int row, kind, col, from;
};

struct builder {
	const struct hawser_rom *rom;
	int n, count;
	struct entry *entry, *spare; /* [count], and memory to sort them */
	int *first; /* [n*n + 1] the first entry of each row, after sort() */
	int *bin;   /* [n + pairs + 1] */
};

static int pair_index(int l, int m)
{
	return l <= m ? m*(m + 1)/2 + l : l*(l + 1)/2 + m;
}

static void put(struct builder *builder, int j, int k, int kind, int col, int from)
{
	builder->entry[builder->count++] = (struct entry){j*builder->n + k, kind, col, from};
}

static void put_quad(struct builder *builder, int i)
{
	const struct hawser_quad *q = &builder->rom->Q[i];

	put(builder, q->j, q->k, 0, q->l, i);
	if (q->k != q->l)
		put(builder, q->j, q->l, 0, q->k, i);
}

static void put_cubic(struct builder *builder, int i)
{
	const struct hawser_cubic *c = &builder->rom->C[i];

	put(builder, c->j, c->k, 1, pair_index(c->l, c->m), i);
	if (c->l != c->k)
		put(builder, c->j, c->l, 1, pair_index(c->k, c->m), i);
	if (c->m != c->l)
		put(builder, c->j, c->m, 1, pair_index(c->k, c->l), i);
}

/* The value of an entry of row (j, k): the share of those of its monomial's indices that are k. */
static double value_of(const struct hawser_rom *rom, int kind, int from, int k)
{
	const struct hawser_quad *q = &rom->Q[from];
	const struct hawser_cubic *c = &rom->C[from];

	return kind ? ((c->k == k) + (c->l == k) + (c->m == k))*c->value/3.0
	            : ((q->k == k) + (q->l == k))*q->value/2.0;
}

static int by_place(const void *left, const void *right)
{
	const struct entry *a = left, *b = right;

	if (a->row != b->row)
		return a->row < b->row ? -1 : 1;
	if (a->kind != b->kind)
		return a->kind < b->kind ? -1 : 1;
	return a->col < b->col ? -1 : a->col > b->col;
}

/* Stable sort by the key of each entry, in [0, keys); bin [keys + 1] becomes the position at which
 * each key begins. */
static void distribute(struct entry *to, const struct entry *from, const struct builder *builder,
                       int (*key)(const struct entry *entry, int n), int *bin, int keys)
{
	memset(bin, 0, ((size_t)keys + 1)*sizeof *bin);
	for (int i = 0; i < builder->count; i++)
		bin[key(&from[i], builder->n) + 1]++;
	for (int k = 0; k < keys; k++)
		bin[k + 1] += bin[k];
	for (int i = 0; i < builder->count; i++)
		to[bin[key(&from[i], builder->n)]++] = from[i];
	/* each bin ends where the next one began */
	memmove(bin + 1, bin, (size_t)keys*sizeof *bin);
	bin[0] = 0;
}

static int column_of(const struct entry *entry, int n)
{
	return entry->kind*n + entry->col;
}

static int row_of(const struct entry *entry, int n)
{
	(void)n;
	return entry->row;
}

/* Sort by row, kind and column in linear time: a model of 40 modes has 7e5 entries, and qsort took
 * most of the time of making it. */
static void sort(struct builder *builder)
{
	int n = builder->n;

	distribute(builder->spare, builder->entry, builder, column_of, builder->bin,
	           n + n*(n + 1)/2);
	distribute(builder->entry, builder->spare, builder, row_of, builder->first, n*n);
}

static double lookup(const struct builder *builder, int row, int kind, int col)
{
	struct entry key = {row, kind, col, 0};
	int first = builder->first[row], count = builder->first[row + 1] - first;
	const struct entry *found = count ? bsearch(&key, builder->entry + first, (size_t)count,
	                                            sizeof key, by_place) : NULL;

	return found ? value_of(builder->rom, kind, found->from, row%builder->n) : 0.0;
}

/* Largest difference between G_jk and G_kj, for K and for each kind of entry relative to the
 * largest entry of that kind. If G is symmetric, and each equation is symmetric in its own indices,
 * the whole tensor is symmetric. */
static double asymmetry(const struct hawser_rom *rom, const struct builder *builder)
{
	int n = rom->n;
	double worst[3] = {0.0}, largest[3] = {0.0}, result = 0.0;

	for (int i = 0; i < n*n; i++) {
		largest[2] = fmax(largest[2], fabs(rom->K[i]));
		worst[2] = fmax(worst[2], fabs(rom->K[i] - rom->K[(i%n)*n + i/n]));
	}
	for (int i = 0; i < builder->count; i++) {
		const struct entry *e = &builder->entry[i];
		double value = value_of(rom, e->kind, e->from, e->row%n);
		double other = lookup(builder, (e->row%n)*n + e->row/n, e->kind, e->col);

		largest[e->kind] = fmax(largest[e->kind], fabs(value));
		worst[e->kind] = fmax(worst[e->kind], fabs(value - other));
	}
	for (int kind = 0; kind < 3; kind++)
		if (largest[kind] > 0.0)
			result = fmax(result, worst[kind]/largest[kind]);
	return result;
}

/* --- order of the columns --- */

struct column {
	uint64_t rows; /* signature of the set of rows in which it appears */
	int index;
};

static int by_rows(const void *left, const void *right)
{
	const struct column *a = left, *b = right;

	if (a->rows != b->rows)
		return a->rows < b->rows ? -1 : 1;
	return a->index < b->index ? -1 : a->index > b->index;
}

/* A pseudo-random number for each row (splitmix64). */
static uint64_t scatter(uint64_t row)
{
	row = (row + 1)*0x9e3779b97f4a7c15u;
	row = (row ^ (row >> 30))*0xbf58476d1ce4e5b9u;
	row = (row ^ (row >> 27))*0x94d049bb133111ebu;
	return row ^ (row >> 31);
}

/* Order the `count` columns of a kind, and replace the entries' columns by their positions. */
static void order_columns(struct column *column, int *place, struct builder *builder, int kind,
                          int count)
{
	for (int c = 0; c < count; c++)
		column[c] = (struct column){0, c};
	for (int i = 0; i < builder->count; i++)
		if (builder->entry[i].kind == kind)
			column[builder->entry[i].col].rows +=
				scatter((uint64_t)builder->entry[i].row);
	qsort(column, (size_t)count, sizeof *column, by_rows);
	for (int c = 0; c < count; c++)
		place[column[c].index] = c;
	for (int i = 0; i < builder->count; i++)
		if (builder->entry[i].kind == kind)
			builder->entry[i].col = place[builder->entry[i].col];
}

static int set_columns(struct hawser_rom_kernel *kernel, struct builder *builder)
{
	int n = builder->n, pairs = n*(n + 1)/2, l = 0, m = 0, failed = 1;
	struct column *column = malloc((size_t)pairs*sizeof *column);
	int *place = malloc((size_t)pairs*sizeof *place);

	if (!column || !place)
		goto done;
	order_columns(column, place, builder, 0, n);
	for (int c = 0; c < n; c++)
		kernel->single[place[c]] = c;
	order_columns(column, place, builder, 1, pairs);
	for (int c = 0; c < pairs; c++) {
		kernel->pair_l[place[c]] = l;
		kernel->pair_m[place[c]] = m;
		if (l++ == m) {
			l = 0;
			m++;
		}
	}
	sort(builder);
	failed = 0;
done:
	free(column);
	free(place);
	return failed;
}

/* --- rows --- */

static void put_value(struct hawser_rom_kernel *kernel, int first_run, const struct entry *entry)
{
	struct hawser__run *run = kernel->runs > first_run ? &kernel->run[kernel->runs - 1] : NULL;

	if (!run || entry->col >= run->col + HAWSER_BLOCK*(run->blocks + 1)) {
		run = &kernel->run[kernel->runs++];
		*run = (struct hawser__run){entry->col, 0, kernel->values};
	}
	while (entry->col >= run->col + HAWSER_BLOCK*run->blocks) {
		for (int b = 0; b < HAWSER_BLOCK; b++)
			kernel->from[kernel->values++] = -1;
		run->blocks++;
	}
	kernel->from[run->at + entry->col - run->col] = entry->from;
}

/* The entries from `next` on that belong to (row, kind) become runs; returns the first that does
 * not. */
static int take(struct hawser_rom_kernel *kernel, const struct builder *builder, int next, int row,
                int kind)
{
	int first_run = kernel->runs;

	while (next < builder->count && builder->entry[next].row == row &&
	       builder->entry[next].kind == kind)
		put_value(kernel, first_run, &builder->entry[next++]);
	return next;
}

static void set_rows(struct hawser_rom_kernel *kernel, const struct hawser_rom *rom,
                     const struct builder *builder)
{
	int n = rom->n, next = 0;

	for (int place = 0; place < n*n; place++) {
		struct hawser__kernel_row row = {.j = place/n, .k = place%n, .constant = rom->K[place]};

		row.a = kernel->runs;
		next = take(kernel, builder, next, place, 0);
		row.a_end = row.b = kernel->runs;
		next = take(kernel, builder, next, place, 1);
		row.b_end = kernel->runs;
		if (kernel->symmetric && row.k > row.j)
			continue;
		if (row.constant != 0.0 || row.b_end > row.a)
			kernel->row[kernel->rows++] = row;
	}
}

/* The values of the rows. */
static void fill_rows(struct hawser_rom_kernel *kernel, const struct hawser_rom *rom)
{
	for (int r = 0; r < kernel->rows; r++) {
		struct hawser__kernel_row *row = &kernel->row[r];

		row->constant = kernel->value[kernel->values + r] = rom->K[row->j*rom->n + row->k];
		for (int i = row->a; i < row->b_end; i++)
			for (int at = kernel->run[i].at, b = 0; b < HAWSER_BLOCK*kernel->run[i].blocks; b++, at++)
				if (kernel->from[at] >= 0)
					kernel->value[at] = value_of(rom, i >= row->b, kernel->from[at], row->k);
	}
}

/* By columns: entries that follow each other change different accelerations, so none waits for
 * the one before. */
static void fill_damping(struct hawser_rom_kernel *kernel, const struct hawser_rom *rom)
{
	int n = rom->n;

	kernel->d_entries = 0;
	for (int i = 0; i < n*n; i++) {
		int j = i%n, k = i/n;

		if (rom->D[j*n + k] == 0.0)
			continue;
		kernel->d_j[kernel->d_entries] = j;
		kernel->d_k[kernel->d_entries] = k;
		kernel->d_val[kernel->d_entries++] = rom->D[j*n + k];
	}
}

/* memory for the worst case: every entry is a run of its own */
static struct hawser_rom_kernel *allocate(int n, int entries)
{
	struct hawser_rom_kernel *kernel = calloc(1, sizeof *kernel);
	size_t n2 = (size_t)n*n, pairs = n2/2 + (size_t)n, count = (size_t)entries + 1;

	if (!kernel)
		return NULL;
	kernel->row = hawser__hold(&kernel->hold, n2, sizeof *kernel->row);
	kernel->run = hawser__hold(&kernel->hold, count, sizeof *kernel->run);
	kernel->value = hawser__hold(&kernel->hold, HAWSER_BLOCK*count + n2, sizeof *kernel->value);
	kernel->from = hawser__hold(&kernel->hold, HAWSER_BLOCK*count, sizeof *kernel->from);
	kernel->single = hawser__hold(&kernel->hold, (size_t)n, sizeof *kernel->single);
	kernel->pair_l = hawser__hold(&kernel->hold, pairs, sizeof *kernel->pair_l);
	kernel->pair_m = hawser__hold(&kernel->hold, pairs, sizeof *kernel->pair_m);
	kernel->d_j = hawser__hold(&kernel->hold, n2, sizeof *kernel->d_j);
	kernel->d_k = hawser__hold(&kernel->hold, n2, sizeof *kernel->d_k);
	kernel->d_val = hawser__hold(&kernel->hold, n2, sizeof *kernel->d_val);
	if (!kernel->hold.short_of_memory)
		return kernel;
	hawser__kernel_free(kernel);
	return NULL;
}

static struct hawser_rom_kernel *make_kernel(const struct hawser_rom *rom, struct builder *builder)
{
	struct hawser_rom_kernel *kernel;
	int form;

	for (int i = 0; i < rom->quads; i++)
		put_quad(builder, i);
	for (int i = 0; i < rom->cubics; i++)
		put_cubic(builder, i);
	sort(builder);
	kernel = allocate(rom->n, builder->count);
	if (!kernel)
		return NULL;
	kernel->asymmetry = asymmetry(rom, builder);
	kernel->symmetric = kernel->asymmetry <= SYMMETRIC_WITHIN;
	if (set_columns(kernel, builder)) {
		hawser__kernel_free(kernel);
		return NULL;
	}
	set_rows(kernel, rom, builder);
	fill_rows(kernel, rom);
	fill_damping(kernel, rom);
	kernel->panels = hawser__panels_new(kernel);
	form = kernel->symmetric && rom->n >= FORM_FROM;
	if (form)
		kernel->gradient = hawser__gradient_new(kernel, rom->n);
	if (!kernel->panels || (form && !kernel->gradient)) {
		hawser__kernel_free(kernel);
		return NULL;
	}
	kernel->quads = rom->quads;
	kernel->cubics = rom->cubics;
	return kernel;
}

/* Whether the rows are those of the entries of Q and C and of the nonzero ones of K. */
static int fits(const struct hawser_rom_kernel *kernel, const struct hawser_rom *rom)
{
	int good = kernel && kernel->panels && kernel->quads == rom->quads &&
	           kernel->cubics == rom->cubics, n = rom->n, constants = 0;

	for (int i = 0; good && i < n*n; i++)
		constants += rom->K[i] != 0.0 && (!kernel->symmetric || i%n <= i/n);
	for (int r = 0; good && r < kernel->rows; r++) {
		const struct hawser__kernel_row *row = &kernel->row[r];

		good = (row->constant != 0.0) == (rom->K[row->j*n + row->k] != 0.0);
		constants -= row->constant != 0.0;
	}
	return good && constants == 0;
}

enum hawser_status hawser__rom_refill(struct hawser_rom *rom, struct hawser_report *report)
{
	struct hawser_rom_kernel *kernel = rom->kernel;

	if (!fits(kernel, rom))
		return hawser_rom_compile(rom, report);
	fill_rows(kernel, rom);
	fill_damping(kernel, rom);
	hawser__panels_fill(kernel->panels, kernel);
	if (kernel->gradient)
		hawser__panels_fill(kernel->gradient, kernel);
	if (kernel->rates)
		hawser__rates_fill(kernel->rates, rom);
	return HAWSER_OK;
}

/* A kernel for a model that is evaluated by function only. */
static struct hawser_rom_kernel *make_bare(const struct hawser_rom *rom)
{
	struct hawser_rom_kernel *kernel = allocate(rom->n, 0);

	if (!kernel)
		return NULL;
	kernel->symmetric = 1; /* the tensors are derivatives of a potential, entry by entry (project.c) */
	fill_damping(kernel, rom);
	return kernel;
}

static int same_indices(const struct hawser_harmonic *a, const struct hawser_harmonic *b)
{
	int i = 0;

	while (a->quads == b->quads && i < a->quads && a->Q[i].j == b->Q[i].j && a->Q[i].k == b->Q[i].k &&
	       a->Q[i].l == b->Q[i].l)
		i++;
	return a->quads == b->quads && i == a->quads;
}

/* Returns 0 when out of memory. */
static int find_alike(struct hawser_rom_kernel *kernel, const struct hawser_rom *rom)
{
	kernel->harmonics = rom->harmonics;
	kernel->alike = hawser__hold(&kernel->hold, (size_t)rom->harmonics + 1, sizeof *kernel->alike);
	for (int h = 0; kernel->alike && h < rom->harmonics; h++)
		while (!same_indices(&rom->harmonic[h], &rom->harmonic[kernel->alike[h]]))
			kernel->alike[h]++;
	return kernel->alike != NULL;
}

static int builder_make(struct builder *builder, const struct hawser_rom *rom)
{
	size_t n = (size_t)rom->n, entries = (size_t)rom->quads*2 + (size_t)rom->cubics*3 + 1;

	*builder = (struct builder){.rom = rom, .n = rom->n};
	builder->entry = malloc(entries*sizeof *builder->entry);
	builder->spare = malloc(entries*sizeof *builder->spare);
	builder->first = malloc((n*n + 1)*sizeof *builder->first);
	builder->bin = malloc((n + n*(n + 1)/2 + 1)*sizeof *builder->bin);
	return builder->entry && builder->spare && builder->first && builder->bin;
}

static void builder_clear(struct builder *builder)
{
	free(builder->entry);
	free(builder->spare);
	free(builder->first);
	free(builder->bin);
}

enum hawser_status hawser__rom_compile(struct hawser_rom *rom, int bare,
                                       struct hawser_report *report)
{
	struct builder builder = {0};
	struct hawser_rom_kernel *kernel = NULL;
	enum hawser_status status = hawser__entries_check(rom, report);

	if (!status)
		status = hawser__entries_merge(rom, report);
	if (status)
		return status;
	if (bare)
		kernel = make_bare(rom);
	else if (builder_make(&builder, rom))
		kernel = make_kernel(rom, &builder);
	builder_clear(&builder);
	if (!kernel || !find_alike(kernel, rom) || !hawser__rates_make(kernel, rom)) {
		hawser__kernel_free(kernel);
		return hawser__no_memory(report, "rom");
	}
	hawser__kernel_free(rom->kernel);
	rom->kernel = kernel;
	return HAWSER_OK;
}

enum hawser_status hawser_rom_compile(struct hawser_rom *rom, struct hawser_report *report)
{
	return hawser__rom_compile(rom, 0, report);
}
