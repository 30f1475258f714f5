/* rom/compile.c - check, sort and merge a model's entries, and make the kernel of kernel.h.
 *
 * A monomial c u_k u_l u_m of equation j is split evenly over the distinct orders of its indices
 * (1, 3 or 6 of them), so that the tensor of every equation is symmetric in k, l, m whoever wrote
 * the file; tangent = K + 2A + 3B holds for that form only. Symmetry between j and the others is a
 * property of the model (a potential), not of the splitting: it is measured here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/kernel.h"

/* Tensors that differ from their transposes by less than this, relative to the largest entry, are
 * taken to come from a potential: round-off of a projection is of order 1e-15. */
#define SYMMETRIC_WITHIN 1e-13

/* An entry of G: row (j, k), kind 0 for A and 1 for B, column. */
struct entry {
	int row, kind, col;
	double value;
};

struct builder {
	int n;
	int count, capacity;
	struct entry *entry;
};

static int pair_index(int l, int m)
{
	return l <= m ? m*(m + 1)/2 + l : l*(l + 1)/2 + m;
}

static void put(struct builder *builder, int j, int k, int kind, int col, double value)
{
	builder->entry[builder->count++] = (struct entry){j*builder->n + k, kind, col, value};
}

static void put_quad(struct builder *builder, const struct hawser_quad *q)
{
	if (q->k == q->l) {
		put(builder, q->j, q->k, 0, q->l, q->value);
		return;
	}
	put(builder, q->j, q->k, 0, q->l, q->value/2.0);
	put(builder, q->j, q->l, 0, q->k, q->value/2.0);
}

static void put_cubic(struct builder *builder, const struct hawser_cubic *c)
{
	int k = c->k, l = c->l, m = c->m;

	if (k == l && l == m) {
		put(builder, c->j, k, 1, pair_index(k, k), c->value);
	} else if (k == l || l == m) { /* sorted: twice `two`, once `one` */
		int two = l, one = k == l ? m : k;

		put(builder, c->j, two, 1, pair_index(two, one), c->value*2.0/3.0);
		put(builder, c->j, one, 1, pair_index(two, two), c->value/3.0);
	} else {
		put(builder, c->j, k, 1, pair_index(l, m), c->value/3.0);
		put(builder, c->j, l, 1, pair_index(k, m), c->value/3.0);
		put(builder, c->j, m, 1, pair_index(k, l), c->value/3.0);
	}
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

/* --- sorting and merging the listed entries --- */

static int compare_ints(const int *a, const int *b, int count)
{
	for (int i = 0; i < count; i++)
		if (a[i] != b[i])
			return a[i] < b[i] ? -1 : 1;
	return 0;
}

static int by_quad(const void *left, const void *right)
{
	const struct hawser_quad *a = left, *b = right;

	return compare_ints((int[]){a->j, a->k, a->l}, (int[]){b->j, b->k, b->l}, 3);
}

static int by_cubic(const void *left, const void *right)
{
	const struct hawser_cubic *a = left, *b = right;

	return compare_ints((int[]){a->j, a->k, a->l, a->m}, (int[]){b->j, b->k, b->l, b->m}, 4);
}

static void swap_if(int *a, int *b)
{
	if (*a > *b) {
		int t = *a;

		*a = *b;
		*b = t;
	}
}

static int merge_quads(struct hawser_quad *q, int count)
{
	int kept = 0;

	for (int i = 0; i < count; i++)
		swap_if(&q[i].k, &q[i].l);
	if (count)
		qsort(q, (size_t)count, sizeof *q, by_quad);
	for (int i = 0; i < count; i++) {
		if (kept && !by_quad(&q[kept - 1], &q[i]))
			q[kept - 1].value += q[i].value;
		else
			q[kept++] = q[i];
	}
	count = kept;
	kept = 0;
	for (int i = 0; i < count; i++)
		if (q[i].value != 0.0)
			q[kept++] = q[i];
	return kept;
}

static int merge_cubics(struct hawser_cubic *c, int count)
{
	int kept = 0;

	for (int i = 0; i < count; i++) {
		swap_if(&c[i].k, &c[i].l);
		swap_if(&c[i].l, &c[i].m);
		swap_if(&c[i].k, &c[i].l);
	}
	if (count)
		qsort(c, (size_t)count, sizeof *c, by_cubic);
	for (int i = 0; i < count; i++) {
		if (kept && !by_cubic(&c[kept - 1], &c[i]))
			c[kept - 1].value += c[i].value;
		else
			c[kept++] = c[i];
	}
	count = kept;
	kept = 0;
	for (int i = 0; i < count; i++)
		if (c[i].value != 0.0)
			c[kept++] = c[i];
	return kept;
}

/* --- checks --- */

static int outside(int index, int n)
{
	return index < 0 || index >= n;
}

static enum hawser_status check_finite(const double *value, int count, const char *what,
                                       struct hawser_report *report)
{
	for (int i = 0; value && i < count; i++)
		if (!isfinite(value[i]))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom", "%s: entry %d is %g",
			                    what, i, value[i]);
	return HAWSER_OK;
}

static enum hawser_status check_tensors(const struct hawser_rom *rom, struct hawser_report *report)
{
	int n = rom->n;

	for (int i = 0; i < rom->quads; i++) {
		const struct hawser_quad *q = &rom->Q[i];

		if (outside(q->j, n) || outside(q->k, n) || outside(q->l, n) || !isfinite(q->value))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
			                    "Q: entry %d is [%d, %d, %d, %g]; indices must be 0 to %d "
			                    "and the value finite", i, q->j, q->k, q->l, q->value,
			                    n - 1);
	}
	for (int i = 0; i < rom->cubics; i++) {
		const struct hawser_cubic *c = &rom->C[i];

		if (outside(c->j, n) || outside(c->k, n) || outside(c->l, n) || outside(c->m, n) ||
		    !isfinite(c->value))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
			                    "C: entry %d is [%d, %d, %d, %d, %g]; indices must be 0 "
			                    "to %d and the value finite", i, c->j, c->k, c->l, c->m,
			                    c->value, n - 1);
	}
	return HAWSER_OK;
}

static enum hawser_status check(const struct hawser_rom *rom, struct hawser_report *report)
{
	enum hawser_status status;
	int n = rom->n;

	if (n < 1 || n > HAWSER_ROM_MAX)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "a model of %d coordinates: it must have 1 to %d", n,
		                    HAWSER_ROM_MAX);
	if ((status = check_finite(rom->K, n*n, "K", report)) ||
	    (status = check_finite(rom->D, n*n, "D", report)) ||
	    (status = check_tensors(rom, report)))
		return status;
	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[h];

		if (harmonic->k < 1 || harmonic->omega_power < 0 || harmonic->omega_power > 2)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
			                    "harmonic %d: k is %d and omega_power %d; k must be 1 or "
			                    "more and omega_power 0, 1 or 2", h, harmonic->k,
			                    harmonic->omega_power);
		if ((status = check_finite(harmonic->f, n, "harmonic's f", report)) ||
		    (status = check_finite(harmonic->D, n*n, "harmonic's D", report)) ||
		    (status = check_finite(harmonic->K, n*n, "harmonic's K", report)))
			return status;
	}
	return HAWSER_OK;
}

/* --- assembly --- */

static int merge_entries(struct entry *entry, int count)
{
	int kept = 0;

	if (count)
		qsort(entry, (size_t)count, sizeof *entry, by_place);
	for (int i = 0; i < count; i++) {
		if (kept && !by_place(&entry[kept - 1], &entry[i]))
			entry[kept - 1].value += entry[i].value;
		else
			entry[kept++] = entry[i];
	}
	return kept;
}

static double lookup(const struct builder *builder, int row, int kind, int col)
{
	struct entry key = {row, kind, col, 0.0};
	const struct entry *found = builder->count ? bsearch(&key, builder->entry,
	                                                     (size_t)builder->count,
	                                                     sizeof key, by_place) : NULL;

	return found ? found->value : 0.0;
}

/* Largest difference between G_jk and G_kj, for K and for each kind of entry relative to the
 * largest entry of that kind. G symmetric and each equation symmetric in its own indices make the
 * whole tensor symmetric. */
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
		double other = lookup(builder, (e->row%n)*n + e->row/n, e->kind, e->col);

		largest[e->kind] = fmax(largest[e->kind], fabs(e->value));
		worst[e->kind] = fmax(worst[e->kind], fabs(e->value - other));
	}
	for (int kind = 0; kind < 3; kind++)
		if (largest[kind] > 0.0)
			result = fmax(result, worst[kind]/largest[kind]);
	return result;
}

static int take(struct hawser_rom_kernel *kernel, const struct builder *builder, int next, int row,
                int kind)
{
	while (next < builder->count && builder->entry[next].row == row &&
	       builder->entry[next].kind == kind) {
		kernel->col[next] = builder->entry[next].col;
		kernel->val[next] = builder->entry[next].value;
		next++;
	}
	return next;
}

static void fill_rows(struct hawser_rom_kernel *kernel, const struct hawser_rom *rom,
                      const struct builder *builder)
{
	int n = rom->n, next = 0;

	for (int place = 0; place < n*n; place++) {
		struct hawser__row row = {.j = place/n, .k = place%n, .constant = rom->K[place]};

		row.a = next;
		row.a_end = row.b = next = take(kernel, builder, next, place, 0);
		row.b_end = next = take(kernel, builder, next, place, 1);
		if (kernel->symmetric && row.k > row.j)
			continue;
		if (row.constant != 0.0 || row.b_end > row.a)
			kernel->row[kernel->rows++] = row;
	}
}

static void fill_damping(struct hawser_rom_kernel *kernel, const struct hawser_rom *rom)
{
	int n = rom->n;

	for (int i = 0; i < n*n; i++) {
		if (rom->D[i] == 0.0)
			continue;
		kernel->d_j[kernel->d_entries] = i/n;
		kernel->d_k[kernel->d_entries] = i%n;
		kernel->d_val[kernel->d_entries++] = rom->D[i];
	}
}

static struct hawser_rom_kernel *make_kernel(const struct hawser_rom *rom, struct builder *builder)
{
	struct hawser_rom_kernel *kernel = calloc(1, sizeof *kernel);
	size_t n2 = (size_t)rom->n*rom->n, count;

	if (!kernel)
		return NULL;
	for (int i = 0; i < rom->quads; i++)
		put_quad(builder, &rom->Q[i]);
	for (int i = 0; i < rom->cubics; i++)
		put_cubic(builder, &rom->C[i]);
	builder->count = merge_entries(builder->entry, builder->count);
	count = (size_t)builder->count + 1;
	kernel->row = calloc(n2, sizeof *kernel->row);
	kernel->col = malloc(count*sizeof *kernel->col);
	kernel->val = malloc(count*sizeof *kernel->val);
	kernel->d_j = malloc(n2*sizeof *kernel->d_j);
	kernel->d_k = malloc(n2*sizeof *kernel->d_k);
	kernel->d_val = malloc(n2*sizeof *kernel->d_val);
	if (!kernel->row || !kernel->col || !kernel->val || !kernel->d_j || !kernel->d_k ||
	    !kernel->d_val) {
		hawser__kernel_free(kernel);
		return NULL;
	}
	kernel->asymmetry = asymmetry(rom, builder);
	kernel->symmetric = kernel->asymmetry <= SYMMETRIC_WITHIN;
	fill_rows(kernel, rom, builder);
	fill_damping(kernel, rom);
	return kernel;
}

enum hawser_status hawser_rom_compile(struct hawser_rom *rom, struct hawser_report *report)
{
	struct builder builder = {.n = rom->n};
	struct hawser_rom_kernel *kernel;
	enum hawser_status status = check(rom, report);

	if (status)
		return status;
	rom->quads = merge_quads(rom->Q, rom->quads);
	rom->cubics = merge_cubics(rom->C, rom->cubics);
	builder.entry = malloc(((size_t)rom->quads*2 + (size_t)rom->cubics*3 + 1)*
	                       sizeof *builder.entry);
	if (!builder.entry)
		return hawser__no_memory(report, "rom");
	kernel = make_kernel(rom, &builder);
	free(builder.entry);
	if (!kernel)
		return hawser__no_memory(report, "rom");
	hawser__kernel_free(rom->kernel);
	rom->kernel = kernel;
	return HAWSER_OK;
}
