/* rom/energy/exact_make.c - the tables of exact.h, from modes on a grid by any method. Slopes are
 * interpolated from the grid of the modes to the quadrature points of the energy.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/grid.h"
#include "modes/label.h"
#include "rom/terms/absorbers.h"
#include "rom/terms/dampers.h"
#include "rom/energy/exact.h"

void hawser__exact_free(struct hawser_rom_exact *exact)
{
	if (!exact)
		return;
	hawser__grid_clear(&exact->grid);
	hawser__hold_clear(&exact->hold);
	free(exact);
}

static double *array(int a, int b)
{
	return calloc((size_t)a*b + 1, sizeof(double));
}

static double *keep(struct hawser_rom_exact *exact, int a, int b)
{
	return hawser__hold(&exact->hold, (size_t)a*(size_t)b, sizeof(double));
}

/* A Gauss rule of `order` points in each element of `grid`. The length of an element is the sum of
 * its weights: the difference of its ends is less accurate for short elements. */
static int make_grid(struct hawser_grid *rule, const struct hawser_grid *grid, int order)
{
	double *length = array(grid->elements, 1);
	int failed = !length;

	for (int i = 0; !failed && i < grid->points; i++)
		length[i/grid->order] += grid->weight[i];
	if (!failed)
		failed = hawser__grid_init(rule, grid->elements, order, grid->edge, length, NULL);
	free(length);
	return failed;
}

static struct hawser_rom_exact *allocate(const struct hawser_modes *modes, int order)
{
	struct hawser_rom_exact *exact = calloc(1, sizeof *exact);
	int points = modes->grid.elements*order, in = 0, out;

	if (!exact)
		return NULL;
	if (make_grid(&exact->grid, &modes->grid, order)) {
		free(exact);
		return NULL;
	}
	for (int j = 0; j < modes->n; j++)
		in += modes->mode[j].plane == HAWSER_IN_PLANE;
	out = modes->n - in;
	if (modes->statics.space)
		in = out = modes->n;
	exact->n = modes->n;
	exact->in = in;
	exact->out = out;
	exact->other = modes->statics.space ? 0 : in;
	exact->points = points;
	exact->collocated = order < modes->grid.order;
	exact->index = hawser__hold(&exact->hold, (size_t)modes->n, sizeof *exact->index);
	exact->weight = keep(exact, points, 1);
	exact->strain = keep(exact, points, 1);
	exact->slope = keep(exact, points, 2*in);
	exact->slope_z = keep(exact, points, out);
	exact->pairs_in = keep(exact, points, 3*in*(in + 1)/2);
	exact->pairs_out = keep(exact, points, out*(out + 1)/2);
	exact->mixed = keep(exact, points, 2*in*out);
	if (!exact->hold.short_of_memory)
		return exact;
	hawser__exact_free(exact);
	return NULL;
}

/* The tables of products, at point p. */
static void multiply(struct hawser_rom_exact *exact, int p)
{
	int in = exact->in, out = exact->out, at = 0, many = in*(in + 1)/2;
	const double *a = exact->slope + (size_t)p*2*in, *b = a + in;
	const double *c = exact->slope_z + (size_t)p*out;
	double *pair = exact->pairs_in + (size_t)p*3*many, *mixed = exact->mixed + (size_t)p*2*in*out;
	double *pair_z = exact->pairs_out + (size_t)p*(out*(out + 1)/2);

	for (int k = 0; k < in; k++)
		for (int j = 0; j <= k; j++, at++) {
			pair[at] = a[j]*a[k];
			pair[many + at] = a[j]*b[k] + b[j]*a[k];
			pair[2*many + at] = b[j]*b[k];
		}
	for (int k = 0; k < out; k++)
		for (int j = 0; j <= k; j++)
			*pair_z++ = c[j]*c[k];
	for (int j = 0; j < in; j++)
		for (int k = 0; k < out; k++) {
			mixed[j*out + k] = a[j]*c[k];
			mixed[(in + j)*out + k] = b[j]*c[k];
		}
}

/* Square root of the stiffness against rotation: the energy of a rotation by b or c is strain/(1 +
 * strain)/eps times b^2/2. The slopes of the modes times this root are polynomials, for which
 * interpolation is exact, so that the tangent at rest remains K. With bending stiffness the rotations
 * b/g and c/g are the polynomials. */
static double stiffness(const struct hawser_modes *modes, double s)
{
	double strain = hawser_statics_frame(&modes->statics, s).strain;

	return modes->statics.bending.EI > 0.0 ? 1.0/(1.0 + strain) : sqrt(strain/(1.0 + strain));
}

/* Slopes of coordinate i, in the exact order, at the quadrature points. scaled: [points of the modes'
 * grid][3]; root, rule_root: `stiffness` on that grid and at the quadrature points. */
static void set_slopes(struct hawser_rom_exact *exact, const struct hawser_modes *modes, int i,
                       double *scaled, const double *root, const double *rule_root)
{
	int points = modes->grid.points, in = exact->in, out = exact->out;
	const double *slope = modes->slope + (size_t)exact->index[i]*(size_t)points*3;
	double at[3];

	for (int k = 0; k < points; k++) {
		scaled[3*k] = slope[3*k];
		scaled[3*k + 1] = slope[3*k + 1]*root[k];
		scaled[3*k + 2] = slope[3*k + 2]*root[k];
	}
	for (int p = 0; p < exact->points; p++) {
		hawser__grid_at(at, &modes->grid, scaled, 3, 3, exact->grid.s[p]);
		if (i < in) {
			exact->slope[(size_t)p*2*in + i] = at[0];
			exact->slope[((size_t)p*2 + 1)*in + i] = at[1]/rule_root[p];
		}
		if (i >= exact->other)
			exact->slope_z[(size_t)p*out + i - exact->other] = at[2]/rule_root[p];
	}
}

static int fill(struct hawser_rom_exact *exact, const struct hawser_modes *modes)
{
	int points = modes->grid.points;
	double *scaled = array(points, 3), *root = array(points, 1);
	double *rule_root = array(exact->points, 1);
	int failed = !scaled || !root || !rule_root;

	for (int k = 0; !failed && k < points; k++)
		root[k] = stiffness(modes, modes->grid.s[k]);
	for (int p = 0; !failed && p < exact->points; p++) {
		rule_root[p] = stiffness(modes, exact->grid.s[p]);
		exact->weight[p] = exact->grid.weight[p]/modes->statics.epsilon;
		exact->strain[p] = hawser_statics_frame(&modes->statics, exact->grid.s[p]).strain;
	}
	for (int i = 0; !failed && i < exact->n; i++)
		set_slopes(exact, modes, i, scaled, root, rule_root);
	for (int p = 0; !failed && p < exact->points; p++)
		multiply(exact, p);
	free(scaled);
	free(root);
	free(rule_root);
	return failed;
}

static int add_cubics(struct hawser_rom_exact *exact, const struct hawser_modes *modes)
{
	const struct hawser_statics *st = &modes->statics;
	size_t n = (size_t)exact->n;

	if (!hawser__has_cubic(st))
		return 0;
	exact->cubic = keep(exact, st->attachments, 1);
	exact->stroke = keep(exact, st->attachments, exact->n);
	for (int i = 0; exact->cubic && exact->stroke && i < st->attachments; i++) {
		if (!(hawser__absorber_cubic(st, i) > 0.0))
			continue;
		exact->cubic[exact->cubics] = hawser__absorber_cubic(st, i);
		for (size_t j = 0; j < n; j++)
			exact->stroke[(size_t)exact->cubics*n + j] = hawser__stroke(modes, (int)j, i);
		exact->cubics++;
	}
	return !exact->cubic || !exact->stroke;
}

static enum hawser_status add_springs(struct hawser_rom_exact *exact, const struct hawser_modes *modes,
                                      struct hawser_report *report)
{
	const struct hawser_statics *st = &modes->statics;

	if (!hawser__has_springs(st) && !st->elastic && !modes->stroke && !(st->bending.EI > 0.0))
		return HAWSER_OK;
	exact->springs = keep(exact, exact->n, exact->n);
	if (exact->springs)
		hawser__springs_add(exact->springs, modes);
	if (exact->springs && modes->stroke)
		hawser__absorbers_stiffen(exact->springs, modes);
	if (!exact->springs || add_cubics(exact, modes))
		return hawser__no_memory(report, "rom");
	return hawser__exact_bend(exact->springs, exact, modes, report);
}

enum hawser_status hawser__exact_new(struct hawser_rom_exact **made, const struct hawser_modes *modes,
                                     int order, struct hawser_report *report)
{
	struct hawser_rom_exact *exact = allocate(modes, order);
	enum hawser_status status;
	int next = 0, next_z;

	*made = exact;
	if (!exact)
		return hawser__no_memory(report, "rom");
	next_z = exact->other;
	for (int j = 0; j < modes->n; j++)
		exact->index[modes->statics.space || modes->mode[j].plane == HAWSER_IN_PLANE ? next++
		                                                                             : next_z++] = j;
	status = fill(exact, modes) ? hawser__no_memory(report, "rom") : add_springs(exact, modes, report);
	if (status) {
		hawser__exact_free(exact);
		*made = NULL;
	}
	return status;
}
