/* response/branch/signs.c - see signs.h.
 *
 * With u_j -> s_j u_j the term Q_jkl u_k u_l of equation j is multiplied by s_j s_k s_l, so that the
 * model stays the same if this is 1 for each of its terms. Reversed in time, the velocities change
 * their sign too: the same, but s_j s_k = -1 for each entry of the skew matrix G of the velocities.
 * With s = (-1)^x these are linear equations for x modulo 2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/branch/signs.h"
#include "rom/energy/exact.h"

#define TINY 1e-12 /* of the largest entry of a kind: round-off */
#define SAME 1e-10 /* relative difference of energies that are the same but for round-off */

static size_t width(const struct hawser__signs *signs)
{
	return (size_t)signs->n + 1;
}

/* Take the equation `row` [n + 1], which is overwritten. */
static void take(struct hawser__signs *signs, unsigned char *row)
{
	for (int p = 0; p < signs->n; p++) {
		unsigned char *own = signs->row + (size_t)p*width(signs);

		if (!row[p])
			continue;
		if (!signs->used[p]) {
			memcpy(own, row, width(signs));
			signs->used[p] = 1;
			return;
		}
		for (size_t q = (size_t)p; q < width(signs); q++)
			row[q] ^= own[q];
	}
	signs->never |= row[signs->n];
}

/* x_j + x_k + ... = right, for `count` indices. */
static void equation(struct hawser__signs *signs, unsigned char *row, const int *index, int count,
                     int right)
{
	memset(row, 0, width(signs));
	for (int i = 0; i < count; i++)
		row[index[i]] ^= 1;
	row[signs->n] = (unsigned char)right;
	take(signs, row);
}

/* x [n]: where no row is, as given. `reversal` 0: right sides are 0. */
static void solve(const struct hawser__signs *signs, unsigned char *x, int reversal)
{
	for (int p = signs->n - 1; p >= 0; p--) {
		const unsigned char *row = signs->row + (size_t)p*width(signs);

		if (!signs->used[p])
			continue;
		x[p] = reversal ? row[signs->n] : 0;
		for (int q = p + 1; q < signs->n; q++)
			x[p] ^= row[q] & x[q];
	}
}

/* Whether the energy is the same with the other coordinates out of the plane; at fixed
 * displacements. */
static int is_even_out(const struct hawser_rom_exact *exact, double *u)
{
	if (exact->in + exact->out != exact->n)
		return 0;
	for (int trial = 1; trial <= 3; trial++) {
		double here, there;

		for (int i = 0; i < exact->n; i++)
			u[exact->index[i]] = 1e-3*trial*sin(1.7*trial + 2.3*i);
		here = hawser__exact_potential(exact, u);
		for (int i = exact->in; i < exact->n; i++)
			u[exact->index[i]] = -u[exact->index[i]];
		there = hawser__exact_potential(exact, u);
		if (!(fabs(here - there) <= SAME*fabs(here)))
			return 0;
	}
	return 1;
}

/* The model with the exact energy has no list of terms. Its coordinates out of the plane may change
 * their signs together, if the energy says so. */
static void take_exact(struct hawser__signs *signs, const struct hawser_rom_exact *exact, double *u,
                       unsigned char *row)
{
	int even = is_even_out(exact, u), last = -1;

	for (int i = 0; i < exact->n; i++) {
		int pair[2] = {exact->index[i], last}, out = even && i >= exact->in;

		if (!out || last >= 0)
			equation(signs, row, pair, out ? 2 : 1, 0);
		last = out ? exact->index[i] : -1;
	}
}

static void take_terms(struct hawser__signs *signs, const struct hawser_rom *rom, unsigned char *row)
{
	double largest = 0.0;

	for (int i = 0; i < rom->quads; i++)
		largest = fmax(largest, fabs(rom->Q[i].value));
	for (int i = 0; i < rom->quads; i++)
		if (fabs(rom->Q[i].value) > TINY*largest)
			equation(signs, row, (const int[]){rom->Q[i].j, rom->Q[i].k, rom->Q[i].l}, 3, 0);
	largest = 0.0;
	for (int i = 0; i < rom->cubics; i++)
		largest = fmax(largest, fabs(rom->C[i].value));
	for (int i = 0; i < rom->cubics; i++) {
		const struct hawser_cubic *c = &rom->C[i];

		if (fabs(c->value) > TINY*largest)
			equation(signs, row, (const int[]){c->j, c->k, c->l, c->m}, 4, 0);
	}
}

enum hawser_status hawser__signs_init(struct hawser__signs *signs, const struct hawser_rom *rom,
                                      const double *G, struct hawser_report *report)
{
	size_t n = (size_t)rom->n;
	unsigned char *row = calloc(n + 1, 1);
	double *u = calloc(n, sizeof *u);

	*signs = (struct hawser__signs){.n = rom->n, .row = calloc(n*(n + 1), 1), .used = calloc(n, 1)};
	if (!row || !u || !signs->row || !signs->used) {
		free(row);
		free(u);
		return hawser__no_memory(report, "backbone");
	}
	if (rom->exact)
		take_exact(signs, rom->exact, u, row);
	else
		take_terms(signs, rom, row);
	for (int j = 0; j < rom->n; j++)
		for (int k = 0; k < j; k++)
			if (G[(size_t)j*n + (size_t)k] != 0.0)
				equation(signs, row, (const int[]){j, k}, 2, 1);
	free(row);
	free(u);
	return HAWSER_OK;
}

void hawser__signs_free(struct hawser__signs *signs)
{
	free(signs->row);
	free(signs->used);
	*signs = (struct hawser__signs){.n = 0};
}

int hawser__signs_reversal(const struct hawser__signs *signs, int *sign)
{
	unsigned char *x = calloc((size_t)signs->n, 1);

	if (!x || signs->never) {
		free(x);
		return 1;
	}
	solve(signs, x, 1);
	for (int j = 0; j < signs->n; j++)
		sign[j] = x[j] ? -1 : 1;
	free(x);
	return 0;
}

/* A copy, with the equations x_j = 0 of the members. */
static enum hawser_status restrict_to(struct hawser__signs *to, const struct hawser__signs *signs,
                                      const unsigned char *member, struct hawser_report *report)
{
	size_t n = (size_t)signs->n;
	unsigned char *row = calloc(n + 1, 1);

	*to = (struct hawser__signs){.n = signs->n, .row = calloc(n*(n + 1), 1), .used = calloc(n, 1)};
	if (!row || !to->row || !to->used) {
		free(row);
		return hawser__no_memory(report, "backbone");
	}
	memcpy(to->row, signs->row, n*(n + 1));
	memcpy(to->used, signs->used, n);
	for (size_t j = 0; j < n; j++) /* reflections: the right sides are 0 */
		to->row[j*(n + 1) + n] = 0;
	for (int j = 0; j < signs->n; j++)
		if (member[j])
			equation(to, row, &j, 1, 0);
	free(row);
	return HAWSER_OK;
}

enum hawser_status hawser__signs_flip(const struct hawser__signs *signs, const unsigned char *member,
                                      int j, int *flip, int *none, struct hawser_report *report)
{
	struct hawser__signs rest;
	unsigned char *x = calloc((size_t)signs->n + 1, 1);
	enum hawser_status status = restrict_to(&rest, signs, member, report);

	if (!status && !x)
		status = hawser__no_memory(report, "backbone");
	if (!status) {
		equation(&rest, x, &j, 1, 1);
		*none = rest.never;
		memset(x, 0, (size_t)signs->n + 1);
		solve(&rest, x, 1);
		for (int k = 0; k < signs->n; k++)
			flip[k] = x[k] ? -1 : 1;
	}
	free(x);
	hawser__signs_free(&rest);
	return status;
}

/* Part the classes where x differs; class 0 keeps its coordinates with x = 0. */
static void part(int *class_of, int *classes, int *moved, const unsigned char *x, int n)
{
	int before = *classes;

	for (int c = 0; c < before; c++)
		moved[c] = -1;
	for (int j = 0; j < n; j++)
		if (x[j]) {
			int *to = &moved[class_of[j]];

			if (*to < 0)
				*to = (*classes)++;
			class_of[j] = *to;
		}
}

/* Number the classes that have coordinates, class 0 first. */
static void number(int *class_of, int *classes, int *moved, int n)
{
	int count = 1;

	for (int c = 0; c < *classes; c++)
		moved[c] = c == 0 ? 0 : -1;
	for (int j = 0; j < n; j++) {
		if (moved[class_of[j]] < 0)
			moved[class_of[j]] = count++;
		class_of[j] = moved[class_of[j]];
	}
	*classes = count;
}

enum hawser_status hawser__signs_classes(const struct hawser__signs *signs,
                                         const unsigned char *member, int *class_of, int *classes,
                                         struct hawser_report *report)
{
	struct hawser__signs rest;
	size_t n = (size_t)signs->n;
	unsigned char *x = calloc(n + 1, 1);
	int *moved = calloc(2*n + 2, sizeof *moved);
	enum hawser_status status = restrict_to(&rest, signs, member, report);

	if (!status && (!x || !moved))
		status = hawser__no_memory(report, "backbone");
	*classes = 1;
	memset(class_of, 0, n*sizeof *class_of);
	for (int free_one = 0; !status && free_one < signs->n; free_one++) {
		if (rest.used[free_one])
			continue;
		memset(x, 0, n + 1);
		x[free_one] = 1;
		solve(&rest, x, 0);
		part(class_of, classes, moved, x, signs->n);
		number(class_of, classes, moved, signs->n);
	}
	free(x);
	free(moved);
	hawser__signs_free(&rest);
	return status;
}
