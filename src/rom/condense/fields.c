/* rom/condense/fields.c - see fields.h. The products of the fields' signals are sums of harmonics, the
 * constant one among them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/grow.h"
#include "core/report.h"
#include "rom/build/model.h"
#include "rom/condense/fields.h"
#include "rom/terms/history.h"

enum { TOP = 3*HAWSER__SUPPORT_TOP };

static void share_clear(struct hawser__fields_share *share)
{
	free(share->f);
	free(share->K);
	free(share->Q);
}

void hawser__fields_clear(struct hawser__fields *fields)
{
	for (int i = 0; i < HAWSER__FIELDS_MOST; i++)
		share_clear(&fields->one[i]);
	for (int i = 0; i < HAWSER__FIELDS_PAIRS; i++)
		share_clear(&fields->two[i]);
	for (int i = 0; i < HAWSER__FIELDS_TRIPLES; i++)
		share_clear(&fields->three[i]);
}

/* --- products of fields --- */

/* Index of the product of two (i <= j) or three fields. */
static int pair_of(int i, int j)
{
	return j*(j + 1)/2 + i;
}

static int triple_of(int i, int j, int k)
{
	return k*(k + 1)*(k + 2)/6 + pair_of(i, j);
}

/* Coordinate of the model of index `at` of the tensors; -1 - i for field i. */
static int coordinate(const struct hawser__fields *fields, int at)
{
	if (at < fields->moving)
		return at;
	return at < fields->moving + fields->count ? fields->moving - at - 1 : at - fields->count;
}

static double *room(double **array, size_t count)
{
	if (!*array)
		*array = calloc(count, sizeof **array);
	return *array;
}

/* A monomial value*product of equation e, `count` factors index[] of the tensors in ascending order.
 * Returns 0 when out of memory. */
static int sort_in(struct hawser__fields *fields, int e, const int *index, int count, double value)
{
	int equation = coordinate(fields, e), field[3], known = 0, u[3], us = 0, n = fields->size;
	struct hawser__fields_share *share;

	for (int i = 0; i < count; i++) {
		int at = coordinate(fields, index[i]);

		if (at < 0)
			field[known++] = -1 - at;
		else
			u[us++] = at;
	}
	if (equation < 0 || known == 0)
		return 1;
	share = known == 1 ? &fields->one[field[0]] : known == 2 ? &fields->two[pair_of(field[0], field[1])]
	        : &fields->three[triple_of(field[0], field[1], field[2])];
	if (us == 2) {
		if (hawser__more(&share->Q, share->quads, sizeof *share->Q))
			return 0;
		share->Q[share->quads++] = (struct hawser_quad){equation, u[0], u[1], value};
		return 1;
	}
	if (!room(us ? &share->K : &share->f, us ? (size_t)n*(size_t)n : (size_t)n))
		return 0;
	if (us && known == 1 && field[0] >= fields->ends)
		return 1; /* that of the load has been added */
	if (us)
		share->K[equation*n + u[0]] += value;
	else
		share->f[equation] -= value; /* on the right side */
	return 1;
}

enum hawser_status hawser__fields_sort(struct hawser__fields *fields, const struct hawser_rom *tensors,
                                       struct hawser_report *report)
{
	int good = 1;

	for (int i = 0; good && i < tensors->quads; i++) {
		const struct hawser_quad *q = &tensors->Q[i];

		good = sort_in(fields, q->j, (int[]){q->k, q->l}, 2, q->value);
	}
	for (int i = 0; good && i < tensors->cubics; i++) {
		const struct hawser_cubic *c = &tensors->C[i];

		good = sort_in(fields, c->j, (int[]){c->k, c->l, c->m}, 3, c->value);
	}
	return good ? HAWSER_OK : hawser__no_memory(report, "rom");
}

/* --- products of signals --- */

static void multiply(struct hawser__signal *out, const struct hawser__signal *a,
                     const struct hawser__signal *b)
{
	struct hawser__signal sum = {{0.0}, {0.0}};

	for (int k = 0; k <= TOP; k++)
		for (int l = 0; l <= TOP - k; l++) {
			int d = abs(k - l), sign = k > l ? 1 : -1;

			sum.c[k + l] += 0.5*(a->c[k]*b->c[l] - a->s[k]*b->s[l]);
			sum.c[d] += 0.5*(a->c[k]*b->c[l] + a->s[k]*b->s[l]);
			sum.s[k + l] += 0.5*(a->c[k]*b->s[l] + a->s[k]*b->c[l]);
			sum.s[d] += 0.5*sign*(a->s[k]*b->c[l] - a->c[k]*b->s[l]);
		}
	sum.s[0] = 0.0;
	*out = sum;
}

/* The harmonic of the model from `first` on with these properties, appended if there is none. */
static struct hawser_harmonic *find(struct hawser_rom *rom, int first, int k, enum hawser_phase phase,
                                    int power)
{
	struct hawser_harmonic *h;

	for (int i = first; i < rom->harmonics; i++)
		if (rom->harmonic[i].k == k && rom->harmonic[i].phase == phase &&
		    rom->harmonic[i].load_power == power)
			return &rom->harmonic[i];
	h = hawser__rom_harmonic(rom, k, phase);
	if (h)
		h->load_power = power;
	return h;
}

/* Add factor * share to a harmonic. Returns 0 when out of memory. */
static int put(struct hawser_harmonic *h, const struct hawser__fields_share *share, double factor,
               size_t n)
{
	if (!h)
		return 0;
	if (share->f && !room(&h->f, n))
		return 0;
	if (share->K && !room(&h->K, n*n))
		return 0;
	for (size_t i = 0; share->f && i < n; i++)
		h->f[i] += factor*share->f[i];
	for (size_t i = 0; share->K && i < n*n; i++)
		h->K[i] += factor*share->K[i];
	if (share->quads > 0) {
		size_t count = (size_t)h->quads + (size_t)share->quads;
		struct hawser_quad *Q = realloc(h->Q, count*sizeof *Q);

		if (!Q)
			return 0;
		h->Q = Q;
		for (int i = 0; i < share->quads; i++) {
			Q[h->quads] = share->Q[i];
			Q[h->quads++].value *= factor;
		}
	}
	return 1;
}

static int spread(struct hawser_rom *rom, int first, const struct hawser__fields_share *share,
                  const struct hawser__signal *signal, int power)
{
	size_t n = (size_t)rom->n;
	double largest = 0.0;

	if (!share->f && !share->K && !share->quads)
		return 1;
	for (int k = 0; k <= TOP; k++)
		largest = fmax(largest, fmax(fabs(signal->c[k]), fabs(signal->s[k])));
	for (int k = 0; k <= TOP; k++) {
		/* what cancels but for round-off is left out */
		if (fabs(signal->c[k]) > 1e-15*largest &&
		    !put(find(rom, first, k, HAWSER_COS, power), share, signal->c[k], n))
			return 0;
		if (fabs(signal->s[k]) > 1e-15*largest &&
		    !put(find(rom, first, k, HAWSER_SIN, power), share, signal->s[k], n))
			return 0;
	}
	return 1;
}

/* The share as a term of the history, with the product of `count` of the shapes. */
static enum hawser_status give(struct hawser_rom *rom, const int *number,
                               struct hawser__fields_share *share, int count, const int field[3],
                               struct hawser_report *report)
{
	struct hawser_history_factor factor = {.count = count};
	struct hawser_ramp_term *term;

	if (!share->f && !share->K && !share->quads)
		return HAWSER_OK;
	for (int i = 0; i < count; i++)
		factor.signal[i] = number[field[i]];
	term = hawser__history_term(rom, &factor);
	if (!term)
		return hawser__no_memory(report, "rom");
	*term = (struct hawser_ramp_term){.f = share->f, .K = share->K, .quads = share->quads,
		.Q = share->Q};
	*share = (struct hawser__fields_share){.quads = 0};
	rom->history->motions = rom->history->terms;
	return HAWSER_OK;
}

enum hawser_status hawser__fields_give(struct hawser_rom *rom, struct hawser__fields *fields,
                                       const int *number, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int k = 0; !status && k < fields->count; k++) {
		status = give(rom, number, &fields->one[k], 1, (int[3]){k}, report);
		for (int j = 0; !status && j <= k; j++) {
			status = give(rom, number, &fields->two[pair_of(j, k)], 2, (int[3]){j, k}, report);
			for (int i = 0; !status && i <= j; i++)
				status = give(rom, number, &fields->three[triple_of(i, j, k)], 3,
				              (int[3]){i, j, k}, report);
		}
	}
	return status;
}

enum hawser_status hawser__fields_spread(struct hawser_rom *rom, const struct hawser__fields *fields,
                                         struct hawser_report *report)
{
	int first = rom->harmonics, good = 1;

	for (int k = 0; good && k < fields->count; k++) {
		good = spread(rom, first, &fields->one[k], &fields->signal[k], 1);
		for (int j = 0; good && j <= k; j++) {
			struct hawser__signal two, three;

			multiply(&two, &fields->signal[j], &fields->signal[k]);
			good = spread(rom, first, &fields->two[pair_of(j, k)], &two, 2);
			for (int i = 0; good && i <= j; i++) {
				multiply(&three, &two, &fields->signal[i]);
				good = spread(rom, first, &fields->three[triple_of(i, j, k)], &three, 3);
			}
		}
	}
	return good ? HAWSER_OK : hawser__no_memory(report, "rom");
}
