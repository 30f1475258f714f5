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
 * indices. Each is computed for the sorted multi-index alone and belongs to every equation in which it
 * occurs (rom/build/expanded.c). The model thus has a potential to the last bit, whatever the error
 * of the quadrature is. Projection of the equation of motion, as in Bertrand (2022) 4.76-4.78,
 * takes one integral for each equation and monomial, and its symmetry depends on round-off and on
 * the boundary terms.
 *
 * Entries that are zero by symmetry are not computed: the terms of the energy are even in c and,
 * for a level span, even under reflection about mid-span.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/pairing.h"
#include "rom/build/expanded.h"
#include "rom/energy/kernel.h"
#include "rom/energy/project.h"
#include "rom/terms/absorbers.h"

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

static double stretch_at(const struct hawser_modes *modes, int p)
{
	return 1.0 + hawser_statics_frame(&modes->statics, modes->grid.s[p]).strain;
}

/* --- pairings --- */

enum { AT_ONCE = 64 }; /* points */

/* sigma, and w (sigma/2 - 2 aa) with w = weight/(g^3 eps), of all pairs at `count` points. */
static void fill_block(double *sigma, double *rest, const struct hawser_modes *modes, int n, int first,
                       int count)
{
	size_t points = (size_t)modes->grid.points;

	for (int p = 0; p < count; p++) {
		double g = stretch_at(modes, first + p);
		double w = modes->grid.weight[first + p]/(g*g*g*modes->statics.epsilon);
		const double *at = modes->slope + 3*(size_t)(first + p);
		size_t to = (size_t)p;

		for (int k = 0; k < n; k++)
			for (int j = 0; j <= k; j++, to += AT_ONCE) {
				const double *x = at + 3*points*(size_t)j, *y = at + 3*points*(size_t)k;

				sigma[to] = x[1]*y[1] + x[2]*y[2];
				rest[to] = w*(0.5*sigma[to] - 2.0*x[0]*y[0]);
			}
	}
}

enum hawser_status hawser__rom_pairing(double *pairing, const struct hawser_modes *modes, int n,
                                       struct hawser_report *report)
{
	int pairs = n*(n + 1)/2, points = modes->grid.points;
	double *sigma = hawser__numbers((size_t)pairs, 2*AT_ONCE);
	double *rest = hawser__behind(sigma, (size_t)pairs*AT_ONCE);

	if (!sigma)
		return hawser__no_memory(report, "rom");
	for (int first = 0; first < points; first += AT_ONCE) {
		int count = points - first < AT_ONCE ? points - first : AT_ONCE;

		fill_block(sigma, rest, modes, n, first, count);
		cblas_dsyr2k(CblasRowMajor, CblasLower, CblasNoTrans, pairs, count, 1.0, sigma, AT_ONCE, rest,
		             AT_ONCE, 1.0, pairing, pairs);
	}
	for (int x = 0; x < pairs; x++)
		for (int y = 0; y < x; y++)
			pairing[(size_t)y*(size_t)pairs + (size_t)x] = pairing[(size_t)x*(size_t)pairs + (size_t)y];
	free(sigma);
	return HAWSER_OK;
}

/* --- derivatives --- */

struct source {
	const struct hawser_modes *modes;
	int moving;     /* number of modes; the rest are second-order shapes (inertia.h) */
	int out[HAWSER_ROM_MAX];  /* [n] 1 for an out-of-plane mode */
	int anti[HAWSER_ROM_MAX]; /* [n] 1 for a mode that is antisymmetric about mid-span, if this
	                           * symmetry exists */
	const double *pairing;    /* [pairs][pairs] of the modes */
	const double *weight;     /* [points] over g^2 eps */
};

static int vanishes(const struct source *t, const int *index, int count)
{
	int out = 0, anti = 0;

	for (int i = 0; i < count; i++) {
		/* NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign): index has `count` */
		out += t->out[index[i]];
		anti += t->anti[index[i]];
	}
	return out%2 || anti%2;
}

/* A shape counts as second order: two of them are beyond the fourth order. j <= k <= l. */
static double third(const void *of, int j, int k, int l)
{
	const struct source *t = of;
	const struct hawser_modes *modes = t->modes;
	size_t row = 3*(size_t)modes->grid.points;
	const double *x = modes->slope + row*(size_t)j, *y = modes->slope + row*(size_t)k;
	const double *z = modes->slope + row*(size_t)l;
	double sum = 0.0;

	if (k >= t->moving || vanishes(t, (int[]){j, k, l}, 3))
		return 0.0;
	for (int p = 0; p < modes->grid.points; p++, x += 3, y += 3, z += 3)
		sum += t->weight[p]*hawser__third_at(x, y, z);
	return sum;
}

static int even(const void *of, const int index[4])
{
	const struct source *t = of;
	int moving = 1;

	for (int i = 0; i < 4; i++)
		moving = moving && index[i] < t->moving;
	return moving && !vanishes(t, index, 4);
}

/* With the cubic springs of absorbers. */
static double fourth(const void *of, const int index[4])
{
	const struct source *t = of;

	return hawser__pairings(t->pairing, t->moving*(t->moving + 1)/2, index) +
	       hawser__absorbers_fourth(t->modes, index);
}

static enum hawser_status tensors(struct hawser_rom *rom, const struct source *t, double *derivatives,
                                  struct hawser_report *report)
{
	int n = t->modes->n;
	const struct hawser__expanded e = {.of = t, .n = n, .equations = n, .third = derivatives,
	                                   .fourth = fourth, .even = even};
	enum hawser_status status = hawser__third_fill(derivatives, n, third, t, "rom", report);

	return status ? status : hawser__expanded_tensors(rom, &e, n, 0, report);
}

enum hawser_status hawser__rom_tensors(struct hawser_rom *rom, const struct hawser_modes *modes,
                                       const struct hawser__condensed *condensed,
                                       struct hawser_report *report)
{
	size_t n = (size_t)modes->n, pairs = n*(n + 1)/2;
	struct source t = {.modes = modes, .moving = condensed ? condensed->n : modes->n};
	double *derivatives = hawser__numbers(n*n, n), *own = NULL;
	double *weight = hawser__numbers((size_t)modes->grid.points, 1);
	enum hawser_status status = derivatives && weight ? HAWSER_OK : hawser__no_memory(report, "rom");

	for (int p = 0; weight && p < modes->grid.points; p++)
		weight[p] = modes->grid.weight[p]/(pow(stretch_at(modes, p), 2)*modes->statics.epsilon);
	t.weight = weight;
	for (int j = 0; j < modes->n; j++)
		t.out[j] = !modes->statics.space && modes->mode[j].plane == HAWSER_OUT_OF_PLANE;
	hawser__rom_mirror(t.anti, modes);
	if (!status && !condensed) {
		own = hawser__numbers(pairs, pairs);
		status = own ? hawser__rom_pairing(own, modes, modes->n, report)
		             : hawser__no_memory(report, "rom");
	}
	t.pairing = condensed ? condensed->pairing : own;
	if (!status)
		status = tensors(rom, &t, derivatives, report);
	free(own);
	free(weight);
	free(derivatives);
	return status;
}
