/* rom/file/entries.c - the entries of Q and C that a file or a program gives: they are checked, sorted
 * with k <= l (<= m), repeated entries are added, and zeros removed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/file/entries.h"
#include "rom/energy/kernel.h"
#include "rom/terms/terms.h"

#define HIGHEST_HARMONIC 1000 /* the mesh of an orbit must resolve it */

static int compare_ints(const int *a, const int *b, int count)
{
	for (int i = 0; i < count; i++)
		if (a[i] != b[i])
			return a[i] < b[i] ? -1 : 1;
	return 0;
}

/* --- entries of either list --- */

static size_t size_of(int indices)
{
	return indices == 3 ? sizeof(struct hawser_quad) : sizeof(struct hawser_cubic);
}

void *hawser__entries_room(int indices, size_t count)
{
	return malloc((count + 1)*size_of(indices));
}

struct hawser__entry hawser__entry(const void *list, int indices, int at)
{
	const struct hawser_quad *q = list;
	const struct hawser_cubic *c = list;

	return indices == 3 ? (struct hawser__entry){{q[at].j, q[at].k, q[at].l, 0}, q[at].value}
	                    : (struct hawser__entry){{c[at].j, c[at].k, c[at].l, c[at].m}, c[at].value};
}

void hawser__entry_put(void *list, int indices, int at, struct hawser__entry entry)
{
	const int *x = entry.index;

	if (indices == 3)
		((struct hawser_quad *)list)[at] = (struct hawser_quad){x[0], x[1], x[2], entry.value};
	else
		((struct hawser_cubic *)list)[at] = (struct hawser_cubic){x[0], x[1], x[2], x[3], entry.value};
}

static int by_quad(const void *left, const void *right)
{
	struct hawser__entry a = hawser__entry(left, 3, 0), b = hawser__entry(right, 3, 0);

	return compare_ints(a.index, b.index, 3);
}

static int by_cubic(const void *left, const void *right)
{
	struct hawser__entry a = hawser__entry(left, 4, 0), b = hawser__entry(right, 4, 0);

	return compare_ints(a.index, b.index, 4);
}

static void swap_if(int *a, int *b)
{
	if (*a > *b) {
		int t = *a;

		*a = *b;
		*b = t;
	}
}

/* The tensors that hawser builds are already sorted. */
static int in_order(const void *entry, int count, size_t size,
                    int (*compare)(const void *, const void *))
{
	const char *at = entry;

	for (int i = 1; i < count; i++, at += size)
		if (compare(at, at + size) > 0)
			return 0;
	return 1;
}

/* Returns how many are left. */
static int merge(void *list, int indices, int count)
{
	int (*compare)(const void *, const void *) = indices == 3 ? by_quad : by_cubic;
	struct hawser__entry last = {{0}, 0.0};
	int kept = 0;

	for (int i = 0; i < count; i++) {
		struct hawser__entry entry = hawser__entry(list, indices, i);

		swap_if(&entry.index[1], &entry.index[2]);
		if (indices == 4) {
			swap_if(&entry.index[2], &entry.index[3]);
			swap_if(&entry.index[1], &entry.index[2]);
		}
		hawser__entry_put(list, indices, i, entry);
	}
	if (!in_order(list, count, size_of(indices), compare))
		qsort(list, (size_t)count, size_of(indices), compare);
	for (int i = 0; i <= count; i++) {
		struct hawser__entry entry = i < count ? hawser__entry(list, indices, i) : last;

		if (i > 0 && i < count && !compare_ints(entry.index, last.index, indices)) {
			last.value += entry.value;
			continue;
		}
		if (i > 0 && last.value != 0.0)
			hawser__entry_put(list, indices, kept++, last);
		last = entry;
	}
	return kept;
}

static int outside(int index, int n)
{
	return index < 0 || index >= n;
}

/* A list of numbers or, if columns > 0, a matrix with that number of columns. */
static enum hawser_status check_finite(const double *value, int count, int columns, const char *what,
                                       enum hawser_status kind, struct hawser_report *report)
{
	for (int i = 0; value && i < count; i++) {
		if (isfinite(value[i]))
			continue;
		if (columns)
			return hawser__fail(report, kind, "rom",
			                    "entry %d, %d of the model's %s is %g: it must be finite",
			                    i/columns, i%columns, what, value[i]);
		return hawser__fail(report, kind, "rom",
		                    "entry %d of the model's %s is %g: it must be finite", i, what,
		                    value[i]);
	}
	return HAWSER_OK;
}

/* `of`: "", or the harmonic to which the entries belong. */
static enum hawser_status check_quads(const struct hawser_quad *Q, int count, int n, const char *of,
                                      struct hawser_report *report)
{
	for (int i = 0; i < count; i++) {
		const struct hawser_quad *q = &Q[i];

		if (outside(q->j, n) || outside(q->k, n) || outside(q->l, n) || !isfinite(q->value))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
			                    "%sQ: entry %d is [%d, %d, %d, %g]; indices must be 0 "
			                    "to %d and the value finite", of, i, q->j, q->k, q->l,
			                    q->value, n - 1);
	}
	return HAWSER_OK;
}

static enum hawser_status check_tensors(const struct hawser_rom *rom, struct hawser_report *report)
{
	int n = rom->n;
	enum hawser_status status = check_quads(rom->Q, rom->quads, n, "", report);

	if (status)
		return status;
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

/* f, D and K of a harmonic or of a term of a ramp, if present. */
static enum hawser_status check_term(const double *f, const double *D, const double *K, int n,
                                     const char *of, enum hawser_status kind,
                                     struct hawser_report *report)
{
	enum hawser_status status;
	char what[48];

	snprintf(what, sizeof what, "load (f of %s)", of);
	if ((status = check_finite(f, n, 0, what, kind, report)))
		return status;
	snprintf(what, sizeof what, "damping (D of %s)", of);
	if ((status = check_finite(D, n*n, n, what, kind, report)))
		return status;
	snprintf(what, sizeof what, "stiffness (K of %s)", of);
	return check_finite(K, n*n, n, what, kind, report);
}

enum hawser_status hawser__numbers_check(const struct hawser_rom *rom, enum hawser_status kind,
                                         struct hawser_report *report)
{
	int n = rom->n;
	enum hawser_status status = check_finite(rom->K, n*n, n, "stiffness K", kind, report);

	if (!status)
		status = check_finite(rom->D, n*n, n, "damping D", kind, report);
	for (int h = 0; !status && h < rom->harmonics; h++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[h];
		char of[32];

		snprintf(of, sizeof of, "harmonics[%d]", h);
		status = check_term(harmonic->f, harmonic->D, harmonic->K, n, of, kind, report);
	}
	for (int p = 0; !status && rom->ramp && p < HAWSER_RAMP_TERMS; p++)
		status = check_term(rom->ramp->term[p].f, rom->ramp->term[p].D, rom->ramp->term[p].K, n,
		                    "the ramp", kind, report);
	return status;
}

static enum hawser_status check_harmonic(const struct hawser_harmonic *harmonic, int h, int n,
                                         struct hawser_report *report)
{
	char of[32];

	if (harmonic->k < 0 || harmonic->k > HIGHEST_HARMONIC || harmonic->omega_power < 0 ||
	    harmonic->omega_power > 3 || harmonic->load_power < 0 || harmonic->load_power > 9)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "harmonic %d: k is %d, omega_power %d and load_power %d; k must "
		                    "be 0 to %d, omega_power 0 to 3 and load_power 0 to 9", h,
		                    harmonic->k, harmonic->omega_power, harmonic->load_power,
		                    HIGHEST_HARMONIC);
	if (harmonic->k == 0 &&
	    (harmonic->phase != HAWSER_COS || (harmonic->D && harmonic->omega_power == 0)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "harmonic %d: a constant term (k = 0) has the phase cos, and no D without "
		                    "a power of Omega; constant damping belongs to the D of the model", h);
	if (harmonic->quads > 0 && harmonic->omega_power != 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "harmonic %d: a Q with omega_power %d; it must be 0", h,
		                    harmonic->omega_power);
	snprintf(of, sizeof of, "harmonics[%d], ", h);
	return check_quads(harmonic->Q, harmonic->quads, n, of, report);
}

enum hawser_status hawser__entries_check(const struct hawser_rom *rom, struct hawser_report *report)
{
	enum hawser_status status;

	if (rom->n < 1 || rom->n > HAWSER_ROM_MOST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "a model of %d coordinates: it must have 1 to %d", rom->n,
		                    HAWSER_ROM_MOST);
	if ((status = hawser__numbers_check(rom, HAWSER_ERR_ARGUMENT, report)) ||
	    (status = check_tensors(rom, report)) || (status = hawser__terms_check(rom, report)))
		return status;
	for (int h = 0; !status && h < rom->harmonics; h++)
		status = check_harmonic(&rom->harmonic[h], h, rom->n, report);
	if (status)
		return status;
	if (rom->ramp && (!(rom->ramp->time > 0.0) || !isfinite(rom->ramp->time)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "the ramp takes the time %g: it must be positive and finite",
		                    rom->ramp->time);
	return HAWSER_OK;
}

static enum hawser_status check_sums(const struct hawser_quad *Q, int count,
                                     struct hawser_report *report)
{
	for (int i = 0; i < count; i++) {
		const struct hawser_quad *q = &Q[i];

		if (!isfinite(q->value))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
			                    "Q: the entries [%d, %d, %d] add up to %g; their sum must "
			                    "be finite", q->j, q->k, q->l, q->value);
	}
	return HAWSER_OK;
}

enum hawser_status hawser__entries_merge(struct hawser_rom *rom, struct hawser_report *report)
{
	enum hawser_status status;

	rom->quads = merge(rom->Q, 3, rom->quads);
	rom->cubics = merge(rom->C, 4, rom->cubics);
	for (int h = 0; h < rom->harmonics; h++)
		rom->harmonic[h].quads = merge(rom->harmonic[h].Q, 3, rom->harmonic[h].quads);
	if ((status = check_sums(rom->Q, rom->quads, report)))
		return status;
	for (int h = 0; h < rom->harmonics; h++)
		if ((status = check_sums(rom->harmonic[h].Q, rom->harmonic[h].quads, report)))
			return status;
	for (int i = 0; i < rom->cubics; i++) {
		const struct hawser_cubic *c = &rom->C[i];

		if (!isfinite(c->value))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
			                    "C: the entries [%d, %d, %d, %d] add up to %g; their sum "
			                    "must be finite", c->j, c->k, c->l, c->m, c->value);
	}
	return HAWSER_OK;
}
