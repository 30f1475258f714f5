/* rom/condense/inertia.c - second-order shapes as coordinates.
 *
 *    w_jk   static displacement of the modes that are not kept by kept modes j and k (condense.h)
 *    r_jk   its part beyond the lowest modes
 *    A_j    largest expected amplitude of mode j
 *    weight of a pair: |r_jk| weight = d/a, the ratio of the amplitudes of the condensed and of the
 *           kept motion; without inertia, resonance frequencies are too high by the fraction (d/a)^2
 *
 * Condensed modes move and thus have the kinetic energy 1/2 |sum w_jk u_j u_k'|^2. It is of fourth
 * order, like the energy that results from their condensation. In a sagging cable, most of it
 * belongs to longitudinal modes, which no reasonable number of kept modes includes. Therefore a few
 * shapes that represent their motion become coordinates q: vibration modes of the cable in the
 * space of all r_jk, as many as necessary, mostly one or two that are nearly longitudinal modes.
 * They are orthogonal with respect to mass and stiffness, and so is the omitted remainder.
 * (Principal axes of the r_jk would be orthogonal with respect to mass only; a small part of a
 * stiff mode would change the stiffness much.)
 *
 * In the potential, V(u) + 1/2 K (q - q_static(u))^2, q counts as second order, so that the last
 * term is T_jk u_j u_k q. The potential is then bounded if the condensed one is, however stiff the
 * cable is. With terms u^2 q^2 it would not be: at the size 1/eps they require the terms of sixth
 * order in u.
 *
 * The part of w along the lowest modes remains condensed: these modes are kept or not according to
 * their dynamics (choose.h), which a single shape with one frequency represents badly.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/grid.h"
#include "modes/label.h"
#include "rom/condense/bend.h"
#include "rom/condense/inertia.h"
#include "rom/condense/inertia_choice.h"
#include "rom/condense/inertia_field.h"

enum { MOST = HAWSER__INERTIA_MOST, PAIRS = HAWSER__INERTIA_PAIRS };

struct work {
	const struct hawser_modes *modes;
	const struct hawser__condensed *condensed;
	int width;        /* of the rows of inertia_field.h */
	int count;        /* number of relevant pairs */
	int *pair;        /* [count] */
	double *factor;   /* [count] weight of the pair */
	int rows;         /* initial number of pairs: shapes are stored behind them */
	double *rest;     /* [rows + MOST][width] P, Q, B of the condensed motion, weighted; shapes */
	double *strain, *root; /* [rows + MOST][width] a, b, c, likewise; [width] roots of the weights */
	double *stiff;    /* [width] and of weight times stiffness against a, b, c */
	double *scratch;  /* [2*width] */
	double *square;   /* [rows] mean square of a pair: its (d/a)^2 */
	double *scaled;   /* [PAIRS][width] */
	double *gram;     /* [2][PAIRS][PAIRS] */
	double *combination; /* [MOST][count] */
	struct hawser__bend *bend; /* or NULL */
	double *bent;        /* [PAIRS] rows of bend.h */
	double omega[MOST];
	struct hawser__hold hold;
};

static void work_clear(struct work *work)
{
	hawser__hold_clear(&work->hold);
	hawser__bend_free(work->bend);
	free(work->bent);
}

static int work_make(struct work *work)
{
	size_t count = (size_t)work->condensed->pairs, width = (size_t)work->width;

	work->rows = (int)count;
	work->pair = hawser__hold(&work->hold, count, sizeof *work->pair);
	work->factor = hawser__hold(&work->hold, count, sizeof *work->factor);
	work->rest = hawser__hold(&work->hold, (count + MOST)*width, sizeof *work->rest);
	work->strain = hawser__hold(&work->hold, (count + MOST)*width, sizeof *work->strain);
	work->root = hawser__hold(&work->hold, width, sizeof *work->root);
	work->stiff = hawser__hold(&work->hold, width, sizeof *work->stiff);
	work->scratch = hawser__hold(&work->hold, 2*width, sizeof *work->scratch);
	work->square = hawser__hold(&work->hold, count, sizeof *work->square);
	work->scaled = hawser__hold(&work->hold, PAIRS*width, sizeof *work->scaled);
	work->gram = hawser__hold(&work->hold, 2*PAIRS*PAIRS, sizeof *work->gram);
	work->combination = hawser__hold(&work->hold, MOST*PAIRS, sizeof *work->combination);
	return !work->hold.short_of_memory;
}

/* --- amplitudes --- */

static void choose_pairs(struct work *work, const double *load, const double *damping)
{
	const struct hawser_modes *modes = work->modes;

	for (int k = 0; k < modes->n; k++)
		for (int j = 0; j <= k; j++) {
			double a = hawser__inertia_amplitude(modes, j, load[j], damping[j]);
			double b = hawser__inertia_amplitude(modes, k, load[k], damping[k]);

			if (!(a*b > 0.0))
				continue;
			work->pair[work->count] = k*(k + 1)/2 + j;
			work->factor[work->count++] = j == k ? 0.5*a : a*b/hypot(a, b);
		}
}

/* --- condensed motion --- */

static enum hawser_status take_pairs(struct work *work, struct hawser_report *report)
{
	const struct hawser_grid *grid = &work->modes->grid;
	size_t width = (size_t)work->width;
	struct hawser__reference reference;
	enum hawser_status status = hawser__reference_init(&reference, grid, grid->order - 1, report);

	for (int x = 0; !status && x < work->count; x++) {
		double *strain = work->strain + (size_t)x*width, *shape = work->rest + (size_t)x*width;

		memcpy(strain, work->condensed->strain + (size_t)work->pair[x]*3*(size_t)grid->points,
		       3*(size_t)grid->points*sizeof *strain);
		hawser__inertia_displacement(shape, work->modes, &reference, strain,
		                             work->condensed, work->pair[x], work->scratch);
		for (size_t p = 3*(size_t)grid->points; p < width; p++)
			strain[p] = shape[p];
		cblas_dscal(work->width, work->factor[x], strain, 1);
		cblas_dscal(work->width, work->factor[x], shape, 1);
	}
	if (!status)
		hawser__reference_clear(&reference);
	return status;
}

/* The integral of the product of two rows of displacements. */
static double product(const struct work *work, const double *x, const double *y)
{
	double sum = 0.0;

	for (int p = 0; p < work->width; p++)
		/* all of width is filled */
		/* NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult) */
		sum += work->root[p]*work->root[p]*x[p]*y[p];
	return sum;
}

/* Whether the inertia of any pair matters, with all modes that are not kept. */
static int counts(const struct work *work, double allowed)
{
	int any = 0;

	for (int x = 0; x < work->count; x++) {
		const double *row = work->rest + (size_t)x*(size_t)work->width;

		any |= product(work, row, row) > allowed;
	}
	return any;
}

/* Remove the part along one mode, given by its fields at the points of the grid, from every pair. */
static void remove_mode(struct work *work, const double *shape, const double *slope)
{
	for (int x = 0; x < work->count; x++) {
		size_t row = (size_t)x*(size_t)work->width;
		double part = -product(work, work->rest + row, shape);

		cblas_daxpy(work->width, part, shape, 1, work->rest + row, 1);
		cblas_daxpy(work->width, part, slope, 1, work->strain + row, 1);
	}
}

/* The part of the pairs beyond the lowest modes; nothing if these cannot be computed. */
static enum hawser_status remove_lowest(struct work *work, struct hawser_report *report)
{
	const struct hawser_modes_options options = {.n = HAWSER__LOWEST};
	size_t width = (size_t)work->width;
	double *field = calloc(2*width, sizeof *field);
	enum hawser_status status;
	struct hawser_modes lowest;

	if (!field)
		return hawser__no_memory(report, "rom");
	status = hawser_modes_solve(&lowest, &work->modes->statics, &options, NULL);
	if (status) {
		work->count = 0;
		free(field);
		return status == HAWSER_ERR_MEMORY ? hawser__no_memory(report, "rom") : HAWSER_OK;
	}
	for (int s = 0; s < lowest.n; s++) {
		for (int p = 0; p < work->modes->grid.points; p++)
			hawser_modes_at(&lowest, field + 3*p, field + width + 3*p, s,
			                work->modes->grid.s[p]);
		for (int i = 0; i < hawser__points(&lowest.statics); i++)
			hawser__modes_attached(field + 3*(work->modes->grid.points + i), &lowest, s, i);
		hawser__inertia_absorbers(field, work->modes, lowest.stroke
		                          ? lowest.stroke + s*lowest.statics.attachments : NULL);
		for (size_t p = 3*(size_t)work->modes->grid.points; p < width; p++)
			field[width + p] = field[p];
		remove_mode(work, field, field + width);
	}
	hawser_modes_clear(&lowest);
	free(field);
	return HAWSER_OK;
}

/* Move the relevant pairs with the largest weights to the first rows. */
static void shorten(struct work *work, double least)
{
	size_t width = (size_t)work->width;
	int kept = 0;

	for (int x = 0; x < work->count; x++)
		work->square[x] = product(work, work->rest + (size_t)x*width,
		                          work->rest + (size_t)x*width);
	for (; kept < PAIRS; kept++) {
		int best = kept;

		for (int x = kept; x < work->count; x++)
			if (work->square[x] > work->square[best])
				best = x;
		if (kept >= work->count || !(work->square[best] > least))
			break;
		cblas_dswap(work->width, work->rest + (size_t)kept*width, 1,
		            work->rest + (size_t)best*width, 1);
		cblas_dswap(work->width, work->strain + (size_t)kept*width, 1,
		            work->strain + (size_t)best*width, 1);
		cblas_dswap(1, work->square + kept, 1, work->square + best, 1);
	}
	work->count = kept;
}

/* --- shapes --- */

/* gram [count][count] = products of rows, times root squared. Springs act on displacements. */
static void products(double *gram, const struct work *work, const double *rows, const double *root)
{
	size_t width = (size_t)work->width, own = 3*(size_t)work->modes->grid.points;

	for (size_t i = 0; i < (size_t)work->count*width; i++)
		work->scaled[i] = root[i%width]*(i%width < own ? rows : work->rest)[i];
	cblas_dsyrk(CblasRowMajor, CblasLower, CblasNoTrans, work->count, work->width, 1.0,
	            work->scaled, work->width, 0.0, gram, work->count);
}

/* to[width] = combination i of the rows. */
static void combine(double *to, const struct work *work, const double *rows, int i)
{
	cblas_dgemv(CblasRowMajor, CblasTrans, work->count, work->width, 1.0, rows, work->width,
	            work->combination + i*work->count, 1, 0.0, to, 1);
}

/* Their displacements are stored behind the rows of `rest`, their strains behind those of `strain`. */
static enum hawser_status find_shapes(struct hawser_rom_inertia *inertia, struct work *work,
                                      double allowed, struct hawser_report *report)
{
	double *mass = work->gram, *K = mass + PAIRS*PAIRS;
	size_t width = (size_t)work->width;
	enum hawser_status status;

	shorten(work, HAWSER__INERTIA_TRIFLE*allowed);
	for (int x = 0; x < work->count; x++)
		inertia->shift = inertia->left = fmax(inertia->left, work->square[x]);
	if (!(inertia->left > allowed))
		return HAWSER_OK;
	products(mass, work, work->rest, work->root);
	products(K, work, work->strain, work->stiff);
	hawser__bend_gram(K, work->bend, work->bent, work->strain, work->width, work->count);
	status = hawser__inertia_choose(inertia, work->combination, work->omega, work->square, mass, mass,
	                                K, work->count, allowed, report);
	for (int i = 0; i < inertia->shapes && !status; i++) {
		combine(work->rest + (size_t)(work->rows + i)*width, work, work->rest, i);
		combine(work->strain + (size_t)(work->rows + i)*width, work, work->strain, i);
	}
	return status;
}

/* Append behind the others, ascending. */
static void place_shapes(struct hawser_modes *with, const struct work *work, int shapes)
{
	size_t width = (size_t)work->width, row = 3*(size_t)work->modes->grid.points;
	int n = work->modes->n;

	for (int i = 0; i < shapes; i++) {
		int k = n;

		for (int j = 0; j < shapes; j++)
			k += work->omega[j] < work->omega[i];
		memcpy(with->shape + (size_t)k*row, work->rest + (size_t)(work->rows + i)*width,
		       row*sizeof *with->shape);
		memcpy(with->slope + (size_t)k*row, work->strain + (size_t)(work->rows + i)*width,
		       row*sizeof *with->slope);
		for (int a = 0; with->stroke && a < with->statics.attachments; a++)
			with->stroke[k*with->statics.attachments + a] =
				work->rest[(size_t)(work->rows + i)*width + hawser__inertia_stroke(with, a)];
		with->mode[k].omega = work->omega[i];
		with->mode[k].place = k + 1;
		(void)hawser__mode_label(with, k);
		with->mode[k].plane = with->mode[k].out_of_plane_share > 0.5 ? HAWSER_OUT_OF_PLANE
		                                                             : HAWSER_IN_PLANE;
	}
}

enum hawser_status hawser__inertia_extend(struct hawser_modes *with,
                                          struct hawser_rom_inertia *inertia,
                                          const struct hawser_modes *modes,
                                          const struct hawser__condensed *condensed,
                                          const double *load, const double *damping,
                                          double allowed, struct hawser_report *report)
{
	struct work work = {.modes = modes, .condensed = condensed,
	                    .width = hawser__inertia_width(modes)};
	enum hawser_status status = HAWSER_OK;

	*with = (struct hawser_modes){.n = 0};
	*inertia = (struct hawser_rom_inertia){.shapes = 0};
	if (!work_make(&work)) {
		status = hawser__no_memory(report, "rom");
		goto done;
	}
	hawser__inertia_roots(work.root, work.stiff, modes);
	choose_pairs(&work, load, damping);
	status = hawser__bend_of(&work.bend, modes, report);
	if (!status && work.bend) {
		work.bent = malloc(PAIRS*(size_t)hawser__bend_width(work.bend)*sizeof *work.bent);
		status = work.bent ? HAWSER_OK : hawser__no_memory(report, "rom");
	}
	if (!status)
		status = take_pairs(&work, report);
	if (status || !counts(&work, allowed))
		goto done;
	status = remove_lowest(&work, report);
	if (!status)
		status = find_shapes(inertia, &work, allowed, report);
	if (status || inertia->shapes == 0)
		goto done;
	status = hawser__modes_extend(with, modes, inertia->shapes, report);
	if (!status)
		place_shapes(with, &work, inertia->shapes);
done:
	work_clear(&work);
	if (status)
		hawser_modes_clear(with);
	return status;
}
