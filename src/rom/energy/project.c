/* rom/energy/project.c - quadratic and cubic tensors from the exact strain energy.
 *
 *    g           static stretch |x'|
 *    a, b, c     derivative of the displacement in the local frame (e, n, z), sums of u_j a_j ...
 *    sigma       b^2 + c^2
 *    eps         H/EA
 *
 * The energy per unstretched length (|q'| - 1)^2/(2 eps), |q'|^2 = (g+a)^2 + sigma, has the terms
 *
 *    V2 = [a^2 + (g-1)/g sigma]/(2 eps)    V3 = a sigma/(2 g^2 eps)
 *    V4 = [sigma^2/8 - a^2 sigma/2]/(g^3 eps)
 *
 * (doc/theory-rom.md). Its third and fourth derivatives by the coordinates are symmetric in all
 * indices. Each is therefore integrated once for every sorted multi-index and added to every
 * equation in which it occurs. The model thus has a potential to the last bit, whatever the error
 * of the quadrature is. Projection of the equation of motion, as in Bertrand (2022) 4.76-4.78,
 * takes one integral for each equation and monomial, and its symmetry depends on round-off and on
 * the boundary terms.
 *
 * Entries that are zero by symmetry are not computed: the terms of the energy are even in c and,
 * for a level span, even under reflection about mid-span.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/hold.h"
#include "core/report.h"
#include "rom/terms/absorbers.h"
#include "rom/energy/kernel.h"
#include "rom/energy/project.h"

/* The integrands at the points of the grid, one contiguous row for each mode or pair of modes. */
struct table {
	int n, points;
	int moving;    /* number of modes; the rest are second-order shapes (inertia.h) */
	double *a;     /* [n][points] */
	double *sigma; /* [pairs][points] b_j b_k + c_j c_k */
	double *aa;    /* [pairs][points] a_j a_k */
	double *w3;    /* [points] weight/(g^2 eps) */
	double *w4;    /* [points] weight/(g^3 eps) */
	int *out;      /* [n] 1 for an out-of-plane mode */
	int *anti;     /* [n] 1 for a mode that is antisymmetric about mid-span, if this symmetry
	                * exists */
	const struct hawser_modes *modes;
	const double *gram; /* [pairs][pairs] of the condensed modes (condense.h), or NULL */
	struct hawser__hold hold;
};

/* Index of the pair (j, k), j <= k, and its row in sigma and aa. */
static size_t number(int j, int k)
{
	return (size_t)k*(k + 1)/2 + j;
}

static size_t pair(const struct table *t, int j, int k)
{
	return number(j, k)*t->points;
}

static void table_clear(struct table *t)
{
	hawser__hold_clear(&t->hold);
}

int hawser__rom_mirror(int *parity, const struct hawser_modes *modes)
{
	int level = modes->statics.hs == 0.0 && modes->statics.attachments == 0;

	for (int j = 0; j < modes->n; j++)
		level = level && modes->mode[j].symmetry != HAWSER_MIXED;
	/* The symmetry of a mode refers to its dominant component. The reflection reverses e, so that P
	 * has the opposite parity of Q and B in the same mode. */
	for (int j = 0; j < modes->n; j++)
		parity[j] = level && (modes->mode[j].symmetry == HAWSER_ANTISYMMETRIC) !=
		            (modes->mode[j].family == HAWSER_LONGITUDINAL);
	return level;
}

static double strain_at(const struct hawser_modes *modes, int p)
{
	return hawser_statics_frame(&modes->statics, modes->grid.s[p]).strain;
}

static void table_fill(struct table *t, const struct hawser_modes *modes)
{
	const size_t points = (size_t)t->points;
	const double *slope = modes->slope;

	for (int p = 0; p < t->points; p++) {
		double g = 1.0 + strain_at(modes, p), w = modes->grid.weight[p]/modes->statics.epsilon;

		t->w3[p] = w/(g*g);
		t->w4[p] = w/(g*g*g);
	}
	for (int j = 0; j < t->n; j++)
		for (size_t p = 0; p < points; p++)
			t->a[j*points + p] = slope[(j*points + p)*3];
	for (int k = 0; k < t->n; k++)
		for (int j = 0; j <= k; j++)
			for (size_t p = 0; p < points; p++) {
				const double *x = slope + (j*points + p)*3;
				const double *y = slope + (k*points + p)*3;

				t->aa[pair(t, j, k) + p] = x[0]*y[0];
				t->sigma[pair(t, j, k) + p] = x[1]*y[1] + x[2]*y[2];
			}
	for (int j = 0; j < t->n; j++)
		t->out[j] = !modes->statics.space && modes->mode[j].plane == HAWSER_OUT_OF_PLANE;
	hawser__rom_mirror(t->anti, modes);
}

static int table_make(struct table *t, const struct hawser_modes *modes)
{
	size_t n = (size_t)modes->n, points = (size_t)modes->grid.points;

	*t = (struct table){.n = modes->n, .points = modes->grid.points, .modes = modes};
	t->a = hawser__hold(&t->hold, n*points, sizeof *t->a);
	t->sigma = hawser__hold(&t->hold, n*(n + 1)/2*points, sizeof *t->sigma);
	t->aa = hawser__hold(&t->hold, n*(n + 1)/2*points, sizeof *t->aa);
	t->w3 = hawser__hold(&t->hold, points, sizeof *t->w3);
	t->w4 = hawser__hold(&t->hold, points, sizeof *t->w4);
	t->out = hawser__hold(&t->hold, n, sizeof *t->out);
	t->anti = hawser__hold(&t->hold, n, sizeof *t->anti);
	if (t->hold.short_of_memory)
		return 0;
	table_fill(t, modes);
	return 1;
}

/* --- integrals --- */

/* Third derivative of the integral of V3 by u_i, u_j, u_k; i <= j <= k. */
static double third(const struct table *t, int i, int j, int k)
{
	const size_t points = (size_t)t->points;
	const double *ai = t->a + i*points, *aj = t->a + j*points, *ak = t->a + k*points;
	const double *sij = t->sigma + pair(t, i, j), *sik = t->sigma + pair(t, i, k);
	const double *sjk = t->sigma + pair(t, j, k);
	double sum = 0.0;

	for (size_t p = 0; p < points; p++)
		sum += t->w3[p]*(ai[p]*sjk[p] + aj[p]*sik[p] + ak[p]*sij[p]);
	return sum;
}

/* One of the three ways to pair four indices: the integral of [sigma sigma' - 2 (aa sigma' + aa'
 * sigma)]/(g^3 eps), minus the contribution of the condensed modes. x and y are indices of pairs. */
static double pairing(const struct table *t, size_t x, size_t y)
{
	const double *s = t->sigma + x*t->points, *r = t->sigma + y*t->points;
	const double *a = t->aa + x*t->points, *b = t->aa + y*t->points;
	size_t pairs = number(0, t->moving);
	double sum = 0.0;

	for (int p = 0; p < t->points; p++)
		sum += t->w4[p]*(s[p]*(r[p] - 2.0*b[p]) - 2.0*a[p]*r[p]);
	return t->gram ? sum - t->gram[x*pairs + y] : sum;
}

/* Fourth derivative of the integral of V4, and of the cubic springs of absorbers; i <= j <= k <= l. */
static double fourth(const struct table *t, int i, int j, int k, int l)
{
	return pairing(t, number(i, j), number(k, l)) + pairing(t, number(i, k), number(j, l)) +
	       pairing(t, number(i, l), number(j, k)) +
	       hawser__absorbers_fourth(t->modes, (int[]){i, j, k, l});
}

void hawser__rom_stiffness(double *stiffness, const struct hawser_modes *modes)
{
	const size_t points = (size_t)modes->grid.points;
	int n = modes->n;

	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++) {
			const double *x = modes->slope + j*points*3, *y = modes->slope + k*points*3;
			double sum = 0.0;

			for (size_t p = 0; p < points; p++) {
				double strain = strain_at(modes, (int)p); /* not g - 1: eps may be 1e-12 */
				double sigma = x[3*p + 1]*y[3*p + 1] + x[3*p + 2]*y[3*p + 2];

				sum += modes->grid.weight[p]/modes->statics.epsilon*
				       (x[3*p]*y[3*p] + strain/(1.0 + strain)*sigma);
			}
			stiffness[j*n + k] = sum;
		}
}

/* --- from derivatives to monomials of equations --- */

/* Where the next entry of each equation belongs. Multi-indices are generated in ascending order, and
 * an index removed from all of them leaves the others in ascending order: the entries of an equation
 * are generated in the order that hawser__entries_merge wants, and needn't be sorted. */
struct places {
	int at[HAWSER_ROM_MAX];
};

/* Equations of a sorted multi-index, each once. */
static void count_equations(struct places *places, const int *index, int count)
{
	for (int e = 0; e < count; e++)
		places->at[index[e]] += e == 0 || index[e] != index[e - 1];
}

/* From numbers of entries to the places of the first ones; returns the number of all. */
static int places_begin(struct places *places, int n)
{
	int total = 0;

	for (int j = 0; j < n; j++) {
		int count = places->at[j];

		places->at[j] = total;
		total += count;
	}
	return total;
}

/* V = sum T_ijk u_i u_j u_k/6 gives equation e the term T_ekl u_k u_l/2: whole coefficient of the
 * monomial T for k < l and T/2 for k = l. */
static void put_third(struct hawser_rom *rom, struct places *places, double value,
                      const int index[3])
{
	for (int e = 0; e < 3; e++) {
		int k = index[e == 0], l = index[e == 2 ? 1 : 2];

		if (e > 0 && index[e] == index[e - 1])
			continue;
		rom->Q[places->at[index[e]]++] =
			(struct hawser_quad){index[e], k, l, k == l ? value/2.0 : value};
	}
}

/* The same for U_eklm u_k u_l u_m/6, of which 6, 3 or 1 are one monomial. */
static void put_fourth(struct hawser_rom *rom, struct places *places, double value,
                       const int index[4])
{
	for (int e = 0; e < 4; e++) {
		int rest[3], r = 0;
		double share;

		if (e > 0 && index[e] == index[e - 1])
			continue;
		for (int i = 0; i < 4; i++)
			if (i != e)
				rest[r++] = index[i];
		share = rest[0] == rest[2] ? 6.0 : rest[0] == rest[1] || rest[1] == rest[2] ? 2.0 : 1.0;
		rom->C[places->at[index[e]]++] = (struct hawser_cubic){
			index[e], rest[0], rest[1], rest[2], value/share};
	}
}

static int vanishes(const struct table *t, const int *index, int count)
{
	int out = 0, anti = 0;

	for (int i = 0; i < count; i++) {
		/* NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign): index has `count` */
		out += t->out[index[i]];
		anti += t->anti[index[i]];
	}
	return out%2 || anti%2;
}

static enum hawser_status not_finite(struct hawser_report *report, const char *name, double value,
                                     const int *index)
{
	return hawser__fail(report, HAWSER_ERR_NAN, "rom",
	                    "the tensor %s is %g for modes %d, %d, %d ...: their shapes are not finite",
	                    name, value, index[0] + 1, index[1] + 1, index[2] + 1);
}

/* A shape counts as second order: two of them are beyond the fourth order. */
static int third_exists(const struct table *t, const int index[3])
{
	return index[1] < t->moving && !vanishes(t, index, 3);
}

/* All third derivatives; with rom->Q NULL, their entries are counted. */
static enum hawser_status all_thirds(struct hawser_rom *rom, struct places *places,
                                     const struct table *t, struct hawser_report *report)
{
	for (int i = 0; i < t->n; i++)
		for (int j = i; j < t->n; j++)
			for (int k = j; k < t->n; k++) {
				const int index[3] = {i, j, k};
				double value;

				if (!third_exists(t, index))
					continue;
				if (!rom->Q) {
					count_equations(places, index, 3);
					continue;
				}
				value = third(t, i, j, k);
				if (!isfinite(value))
					return not_finite(report, "Q", value, index);
				put_third(rom, places, value, index);
			}
	return HAWSER_OK;
}

/* All fourth derivatives whose first indices are i, j; with rom->C NULL, their entries are counted. */
static enum hawser_status fourths_of(struct hawser_rom *rom, struct places *places,
                                     const struct table *t, int i, int j,
                                     struct hawser_report *report)
{
	for (int k = j; k < t->moving; k++)
		for (int l = k; l < t->moving; l++) {
			const int index[4] = {i, j, k, l};
			double value;

			if (vanishes(t, index, 4))
				continue;
			if (!rom->C) {
				count_equations(places, index, 4);
				continue;
			}
			value = fourth(t, i, j, k, l);
			if (!isfinite(value))
				return not_finite(report, "C", value, index);
			put_fourth(rom, places, value, index);
		}
	return HAWSER_OK;
}

static enum hawser_status all_fourths(struct hawser_rom *rom, struct places *places,
                                      const struct table *t, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; !status && i < t->moving; i++)
		for (int j = i; !status && j < t->moving; j++)
			status = fourths_of(rom, places, t, i, j, report);
	return status;
}

static enum hawser_status fill_tensors(struct hawser_rom *rom, const struct table *t,
                                       struct hawser_report *report)
{
	struct places quads = {{0}}, cubics = {{0}};
	enum hawser_status status = all_thirds(rom, &quads, t, report);

	if (!status)
		status = all_fourths(rom, &cubics, t, report);
	if (status)
		return status;
	rom->quads = places_begin(&quads, t->n);
	rom->cubics = places_begin(&cubics, t->n);
	rom->Q = malloc(((size_t)rom->quads + 1)*sizeof *rom->Q);
	rom->C = malloc(((size_t)rom->cubics + 1)*sizeof *rom->C);
	if (!rom->Q || !rom->C)
		return hawser__no_memory(report, "rom");
	status = all_thirds(rom, &quads, t, report);
	return status ? status : all_fourths(rom, &cubics, t, report);
}

enum hawser_status hawser__rom_tensors(struct hawser_rom *rom, const struct hawser_modes *modes,
                                       const struct hawser__condensed *condensed,
                                       struct hawser_report *report)
{
	enum hawser_status status;
	struct table t;

	if (!table_make(&t, modes)) {
		status = hawser__no_memory(report, "rom");
	} else {
		t.gram = condensed ? condensed->gram : NULL;
		t.moving = condensed ? condensed->n : t.n;
		status = fill_tensors(rom, &t, report);
	}
	table_clear(&t);
	return status;
}
