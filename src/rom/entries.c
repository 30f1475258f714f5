/* rom/entries.c - the listed entries of Q and C as a file or a program gives them: checked, then
 * sorted with k <= l (<= m), repeats summed and zeros dropped.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/entries.h"
#include "rom/kernel.h"

#define HIGHEST_HARMONIC 1000 /* the mesh of an orbit must resolve it */

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

static enum hawser_status check_ramp(const struct hawser_ramp *ramp, int n,
                                     struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	if (!(ramp->time > 0.0) || !isfinite(ramp->time))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "the ramp takes the time %g: it must be positive and finite",
		                    ramp->time);
	for (int p = 0; !status && p < HAWSER_RAMP_TERMS; p++) {
		status = check_finite(ramp->term[p].f, n, "ramp's f", report);
		if (!status)
			status = check_finite(ramp->term[p].D, n*n, "ramp's D", report);
		if (!status)
			status = check_finite(ramp->term[p].K, n*n, "ramp's K", report);
	}
	return status;
}

enum hawser_status hawser__entries_check(const struct hawser_rom *rom, struct hawser_report *report)
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

		if (harmonic->k < 1 || harmonic->k > HIGHEST_HARMONIC || harmonic->omega_power < 0 ||
		    harmonic->omega_power > 2)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
			                    "harmonic %d: k is %d and omega_power %d; k must be 1 to %d "
			                    "and omega_power 0, 1 or 2", h, harmonic->k,
			                    harmonic->omega_power, HIGHEST_HARMONIC);
		if ((status = check_finite(harmonic->f, n, "harmonic's f", report)) ||
		    (status = check_finite(harmonic->D, n*n, "harmonic's D", report)) ||
		    (status = check_finite(harmonic->K, n*n, "harmonic's K", report)))
			return status;
	}
	return rom->ramp ? check_ramp(rom->ramp, n, report) : HAWSER_OK;
}

enum hawser_status hawser__entries_merge(struct hawser_rom *rom, struct hawser_report *report)
{
	rom->quads = merge_quads(rom->Q, rom->quads);
	rom->cubics = merge_cubics(rom->C, rom->cubics);
	for (int i = 0; i < rom->quads; i++) {
		const struct hawser_quad *q = &rom->Q[i];

		if (!isfinite(q->value))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
			                    "Q: the entries [%d, %d, %d] add up to %g; their sum must "
			                    "be finite", q->j, q->k, q->l, q->value);
	}
	for (int i = 0; i < rom->cubics; i++) {
		const struct hawser_cubic *c = &rom->C[i];

		if (!isfinite(c->value))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
			                    "C: the entries [%d, %d, %d, %d] add up to %g; their sum "
			                    "must be finite", c->j, c->k, c->l, c->m, c->value);
	}
	return HAWSER_OK;
}
