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
#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/label.h"
#include "rom/condense/inertia.h"
#include "rom/condense/basis.h"

enum { MOST = HAWSER__INERTIA_MOST, PAIRS = HAWSER__INERTIA_PAIRS };

struct work {
	const struct hawser_modes *modes;
	const struct hawser__condensed *condensed;
	struct hawser__basis basis; /* the relevant pairs, weighted; shapes behind all pairs */
	int count;        /* number of relevant pairs */
	int *pair;        /* [count] */
	double *factor;   /* [count] weight of the pair */
	double *square;   /* [count] mean square of a pair: its (d/a)^2 */
	double *gram;     /* [2][PAIRS][PAIRS] */
	double *combination; /* [MOST][count] */
	double omega[MOST];
	struct hawser__hold hold;
};

static void work_clear(struct work *work)
{
	hawser__hold_clear(&work->hold);
	hawser__basis_clear(&work->basis);
}

static int work_make(struct work *work)
{
	size_t count = (size_t)work->condensed->pairs;

	work->pair = hawser__hold(&work->hold, count, sizeof *work->pair);
	work->factor = hawser__hold(&work->hold, count, sizeof *work->factor);
	work->square = hawser__hold(&work->hold, count, sizeof *work->square);
	work->gram = hawser__hold(&work->hold, 2*PAIRS*PAIRS, sizeof *work->gram);
	work->combination = hawser__hold(&work->hold, MOST*PAIRS, sizeof *work->combination);
	return !work->hold.short_of_memory;
}

/* The row of a pair, or of a shape behind all of them. */
static double *row_of(const struct work *work, int x)
{
	return work->basis.row + (size_t)x*(size_t)work->basis.width;
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

static void take_pairs(struct work *work)
{
	const struct hawser__condensed *condensed = work->condensed;
	int strokes = work->modes->statics.attachments;

	for (int x = 0; x < work->count; x++) {
		size_t pair = (size_t)work->pair[x];

		hawser__basis_put(&work->basis, row_of(work, x),
		                    condensed->strain + pair*3*(size_t)condensed->points,
		                    condensed->start + 3*pair,
		                    condensed->stroke ? condensed->stroke + (int)pair*strokes : NULL);
		cblas_dscal(work->basis.width, work->factor[x], row_of(work, x), 1);
	}
}

static double square_of(const struct work *work, int x)
{
	return hawser__basis_product(&work->basis, row_of(work, x), row_of(work, x));
}

/* Whether the inertia of any pair matters, with all modes that are not kept. */
static int counts(const struct work *work, double allowed)
{
	int any = 0;

	for (int x = 0; x < work->count; x++)
		any |= square_of(work, x) > allowed;
	return any;
}

/* The part of the pairs beyond the lowest modes; nothing if these cannot be computed. */
static enum hawser_status remove_lowest(struct work *work, struct hawser_report *report)
{
	const struct hawser_modes_options options = {.n = HAWSER__LOWEST};
	int width = work->basis.width;
	double *mode = hawser__numbers((size_t)width, 1);
	enum hawser_status status;
	struct hawser_modes lowest;

	if (!mode)
		return hawser__no_memory(report, "rom");
	status = hawser_modes_solve(&lowest, &work->modes->statics, &options, NULL);
	if (status) {
		work->count = 0;
		free(mode);
		return status == HAWSER_ERR_MEMORY ? hawser__no_memory(report, "rom") : HAWSER_OK;
	}
	for (int s = 0; s < lowest.n; s++) {
		hawser__basis_mode(&work->basis, mode, &lowest, s);
		for (int x = 0; x < work->count; x++) {
			double *row = row_of(work, x);

			cblas_daxpy(width, -hawser__basis_product(&work->basis, row, mode), mode, 1, row, 1);
		}
	}
	hawser_modes_clear(&lowest);
	free(mode);
	return HAWSER_OK;
}

/* Move the relevant pairs with the largest weights to the first rows. */
static void shorten(struct work *work, double least)
{
	int kept = 0;

	for (int x = 0; x < work->count; x++)
		work->square[x] = square_of(work, x);
	for (; kept < PAIRS; kept++) {
		int best = kept;

		for (int x = kept; x < work->count; x++)
			if (work->square[x] > work->square[best])
				best = x;
		if (kept >= work->count || !(work->square[best] > least))
			break;
		cblas_dswap(work->basis.width, row_of(work, kept), 1, row_of(work, best), 1);
		cblas_dswap(1, work->square + kept, 1, work->square + best, 1);
	}
	work->count = kept;
}

/* --- shapes --- */

/* Their rows are stored behind those of all pairs. */
static enum hawser_status find_shapes(struct hawser_rom_inertia *inertia, struct work *work,
                                      double allowed, struct hawser_report *report)
{
	double *mass = work->gram, *K = mass + PAIRS*PAIRS;
	int width = work->basis.width;
	enum hawser_status status;

	shorten(work, HAWSER__INERTIA_TRIFLE*allowed);
	for (int x = 0; x < work->count; x++)
		inertia->shift = inertia->left = fmax(inertia->left, work->square[x]);
	if (!(inertia->left > allowed))
		return HAWSER_OK;
	status = hawser__basis_products(mass, K, &work->basis, work->count, report);
	if (!status)
		status = hawser__inertia_choose(inertia, work->combination, work->omega, work->square, mass,
		                                mass, K, work->count, allowed, report);
	for (int i = 0; i < inertia->shapes && !status; i++)
		cblas_dgemv(CblasRowMajor, CblasTrans, work->count, width, 1.0, work->basis.row, width,
		            work->combination + i*work->count, 1, 0.0,
		            row_of(work, work->condensed->pairs + i), 1);
	return status;
}

/* Append behind the others, ascending. */
static void place_shapes(struct hawser_modes *with, const struct work *work, int shapes)
{
	for (int i = 0; i < shapes; i++) {
		int k = work->modes->n;

		for (int j = 0; j < shapes; j++)
			k += work->omega[j] < work->omega[i];
		hawser__basis_take(with, k, &work->basis, row_of(work, work->condensed->pairs + i),
		                     work->omega[i]);
	}
}

enum hawser_status hawser__inertia_extend(struct hawser_modes *with,
                                          struct hawser_rom_inertia *inertia,
                                          const struct hawser_modes *modes,
                                          const struct hawser__condensed *condensed,
                                          const double *load, const double *damping,
                                          double allowed, struct hawser_report *report)
{
	struct work work = {.modes = modes, .condensed = condensed};
	enum hawser_status status = hawser__basis_make(&work.basis, modes, condensed->pairs + MOST,
	                                                 report);

	*with = (struct hawser_modes){.n = 0};
	*inertia = (struct hawser_rom_inertia){.shapes = 0};
	if (!status && !work_make(&work))
		status = hawser__no_memory(report, "rom");
	if (status)
		goto done;
	choose_pairs(&work, load, damping);
	take_pairs(&work);
	if (!counts(&work, allowed))
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
