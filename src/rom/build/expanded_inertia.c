/* rom/build/expanded_inertia.c - second-order shapes as coordinates of a model
 * (rom/condense/inertia.c). A mass on a short cable swings up as far as the square of its amplitude,
 * and what it lifts follows: without their inertia its frequency rises where it falls.
 *
 *   w_jk     what follows the modes j and k
 *   A_j      expected amplitude of mode j: at its resonance, or a slope that the expansion bears
 *   psi      a vibration in the space of all w_jk, or of the static responses to their inertia where
 *            the w_jk have moved ends that no vibration has; of the mass 1 and the stiffness kappa^2
 *   m_jk     part of w_jk along psi
 *
 * psi is orthogonal to the modes in mass and stiffness. With the displacement 1/2 sum u_j u_k
 * (w_jk - m_jk psi) + v psi the energy is that of the model without psi, which w_jk makes least, and
 *
 *    1/2 kappa^2 (v - 1/2 sum m_jk u_j u_k)^2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/pairing.h"
#include "rom/build/expanded.h"

static const double allowed = 2e-4; /* relative error of resonance frequencies, as of spans; chosen */

static double *pair_row(const struct hawser__inertia_by *by, int pair)
{
	return by->second + (size_t)pair*by->width;
}

static int pairs_of(const struct hawser__inertia_by *by)
{
	return by->n*(by->n + 1)/2;
}

/* Amplitude A at resonance: A Omega = size, with the frequency Omega^2 = omega^2 + harder A^2 of the
 * mode alone to the first order. */
static double resonance(double square, double quad, double own, double size)
{
	double harder = 0.75*own/6.0 - 5.0/6.0*quad*quad/square;

	if (!(harder*size*size > 1e-6*square*square))
		return size/sqrt(square);
	return sqrt((sqrt(square*square + 4.0*harder*size*size) - square)/(2.0*harder));
}

double hawser__inertia_expected(double omega2, double quad, double own, double size, double turning)
{
	double bears = HAWSER__INERTIA_SLOPE/sqrt(turning);

	return isfinite(size) ? fmin(resonance(omega2, quad, own, size), bears) : bears;
}

/* --- the choice --- */

struct entries {
	int count, pair[HAWSER__INERTIA_PAIRS];
	double factor[HAWSER__INERTIA_PAIRS], square[HAWSER__INERTIA_PAIRS];
	double mass[HAWSER__INERTIA_PAIRS*HAWSER__INERTIA_PAIRS],
		cross[HAWSER__INERTIA_PAIRS*HAWSER__INERTIA_PAIRS],
		stiffness[HAWSER__INERTIA_PAIRS*HAWSER__INERTIA_PAIRS],
		combination[HAWSER__INERTIA_MOST*HAWSER__INERTIA_PAIRS];
};

/* Among the pairs that matter most. */
static void enter(struct entries *w, int pair, double factor, double square)
{
	int at = w->count;

	if (at == HAWSER__INERTIA_PAIRS) {
		for (int x = at = 0; x < w->count; x++)
			at = w->square[x] < w->square[at] ? x : at;
		if (w->square[at] >= square)
			return;
	} else {
		w->count++;
	}
	w->pair[at] = pair;
	w->factor[at] = factor;
	w->square[at] = square;
}

static enum hawser_status find_pairs(struct entries *w, const struct hawser__inertia_by *by,
                                     struct hawser_report *report)
{
	double *A = hawser__numbers((size_t)by->n, 1);

	if (!A)
		return hawser__no_memory(report, "rom");
	for (int k = 0; k < by->n; k++) {
		A[k] = by->amplitude(by->of, k);
		for (int j = 0; j <= k; j++) {
			int pair = hawser__pair(j, k);
			double factor = j == k ? 0.5*A[j] : A[j]*A[k]/hypot(A[j], A[k]), square;

			if (!(A[j]*A[k] > 0.0))
				continue;
			square = factor*factor*by->mass(by->of, pair_row(by, pair), pair_row(by, pair));
			if (square > HAWSER__INERTIA_TRIFLE*allowed)
				enter(w, pair, factor, square);
		}
	}
	free(A);
	return HAWSER_OK;
}

/* Products of the motions and of the shapes that they vibrate in. */
static enum hawser_status fill_products(struct entries *w, const struct hawser__inertia_by *by,
                                        struct hawser_report *report)
{
	double *shape = by->vibrates ? hawser__numbers((size_t)w->count, by->width) : NULL;
	enum hawser_status status = by->vibrates && !shape ? hawser__no_memory(report, "rom") : HAWSER_OK;

	for (int x = 0; x < w->count && by->vibrates && !status; x++)
		status = by->vibrates(by->of, shape + (size_t)x*by->width, pair_row(by, w->pair[x]), report);
	for (int x = 0; x < w->count && !status; x++)
		for (int y = 0; y < w->count; y++) {
			const double *own = shape ? shape + (size_t)x*by->width : pair_row(by, w->pair[x]);
			const double *other = shape ? shape + (size_t)y*by->width : pair_row(by, w->pair[y]);
			double factor = w->factor[x]*w->factor[y];
			int at = x*w->count + y, mirror = y*w->count + x;

			if (shape)
				w->cross[at] = factor*by->mass(by->of, pair_row(by, w->pair[x]), other);
			if (y > x)
				continue;
			w->mass[at] = w->mass[mirror] = factor*by->mass(by->of, own, other);
			w->stiffness[at] = w->stiffness[mirror] = factor*by->stiffness(by->of, own, other);
		}
	if (!shape)
		memcpy(w->cross, w->mass, sizeof w->cross);
	free(shape);
	return status;
}

enum hawser_status hawser__inertia_find(struct hawser__inertia *of, struct hawser__hold *hold,
                                        const struct hawser__inertia_by *by,
                                        struct hawser_report *report)
{
	struct entries *w = calloc(1, sizeof *w);
	double omega[HAWSER__INERTIA_MOST];
	int pairs = pairs_of(by);
	enum hawser_status status;

	of->by = hawser__hold(hold, HAWSER__INERTIA_MOST*(size_t)pairs, sizeof *of->by);
	if (!w || !of->by) {
		free(w);
		return hawser__no_memory(report, "rom");
	}
	status = find_pairs(w, by, report);
	if (!status)
		status = fill_products(w, by, report);
	if (!status && w->count > 0)
		status = hawser__inertia_choose(&of->found, w->combination, omega, w->square, w->cross, w->mass,
		                                w->stiffness, w->count, allowed, report);
	for (int i = 0; i < of->found.shapes && !status; i++)
		for (int x = 0; x < w->count; x++)
			of->by[i*pairs + w->pair[x]] = w->combination[i*w->count + x]*w->factor[x];
	free(w);
	return status;
}

/* --- the shapes --- */

/* Shapes of the mass 1 and orthogonal, from rows that are nearly so. */
static enum hawser_status orthogonalise(struct hawser__inertia *of, const struct hawser__inertia_by *by,
                                        const double *raw, struct hawser_report *report)
{
	double mass[HAWSER__INERTIA_MOST*HAWSER__INERTIA_MOST],
		stiffness[HAWSER__INERTIA_MOST*HAWSER__INERTIA_MOST];
	int n = of->found.shapes;

	for (int x = 0; x < n; x++)
		for (int y = 0; y < n; y++) {
			mass[x*n + y] = by->mass(by->of, raw + (size_t)x*by->width, raw + (size_t)y*by->width);
			stiffness[x*n + y] = by->stiffness(by->of, raw + (size_t)x*by->width,
			                                   raw + (size_t)y*by->width);
		}
	if (LAPACKE_dsygvd(LAPACK_ROW_MAJOR, 1, 'V', 'L', n, stiffness, n, mass, n, of->kappa2))
		return hawser__fail(report, HAWSER_ERR_NAN, "rom", "the second-order shapes are not "
		                    "independent");
	for (int i = 0; i < n; i++) {
		size_t most = cblas_idamax(n, stiffness + i, n)*(size_t)n + (size_t)i;
		double sign = stiffness[most] < 0.0 ? -1.0 : 1.0;

		for (int x = 0; x < n; x++)
			cblas_daxpy((int)by->width, sign*stiffness[x*n + i], raw + (size_t)x*by->width, 1,
			            of->row + (size_t)i*by->width, 1);
	}
	return HAWSER_OK;
}

/* What the shapes are made of, before they are orthogonal: raw [shapes][width]. */
static enum hawser_status gather(double *raw, const struct hawser__inertia *of,
                                 const struct hawser__inertia_by *by, struct hawser_report *report)
{
	int pairs = pairs_of(by);
	double *sum = hawser__numbers(by->width, 1);
	enum hawser_status status = sum ? HAWSER_OK : hawser__no_memory(report, "rom");

	for (int i = 0; i < of->found.shapes && !status; i++) {
		double *row = raw + (size_t)i*by->width;

		memset(sum, 0, by->width*sizeof *sum);
		for (int x = 0; x < pairs; x++)
			if (of->by[i*pairs + x] != 0.0)
				cblas_daxpy((int)by->width, of->by[i*pairs + x], pair_row(by, x), 1, sum, 1);
		if (by->vibrates)
			status = by->vibrates(by->of, row, sum, report);
		else
			memcpy(row, sum, by->width*sizeof *row);
	}
	free(sum);
	return status;
}

enum hawser_status hawser__inertia_make(struct hawser__inertia *of, struct hawser__hold *hold,
                                        const struct hawser__inertia_by *by,
                                        struct hawser_report *report)
{
	int shapes = of->found.shapes, pairs = pairs_of(by);
	double *raw;
	enum hawser_status status;

	if (shapes == 0)
		return HAWSER_OK;
	raw = hawser__numbers((size_t)shapes, by->width);
	of->row = hawser__hold(hold, (size_t)shapes*by->width, sizeof *of->row);
	of->part = hawser__hold(hold, (size_t)shapes*(size_t)pairs, sizeof *of->part);
	status = raw && of->row && of->part ? gather(raw, of, by, report)
	                                    : hawser__no_memory(report, "rom");
	if (!status)
		status = orthogonalise(of, by, raw, report);
	free(raw);
	for (int i = 0; i < shapes && !status; i++) {
		const double *row = of->row + (size_t)i*by->width;

		for (int k = 0; k < by->n; k++)
			for (int j = 0; j <= k; j++) {
				int pair = hawser__pair(j, k);
				double part = by->part(by->of, j, k, row, of->kappa2[i]);

				of->part[i*pairs + pair] = part;
				cblas_daxpy((int)by->width, -part, row, 1, pair_row(by, pair), 1);
			}
	}
	return status;
}

enum hawser_status hawser__inertia_quads(struct hawser_rom *rom, const struct hawser__inertia *of,
                                         struct hawser_report *report)
{
	int shapes = rom->inertia.shapes, n = rom->n - shapes, pairs = n*(n + 1)/2;
	struct hawser_quad *Q = realloc(rom->Q, ((size_t)rom->quads + 3*(size_t)pairs*(size_t)shapes + 1)*
	                                        sizeof *Q);

	if (!Q)
		return hawser__no_memory(report, "rom");
	rom->Q = Q;
	for (int i = 0; i < shapes; i++)
		for (int k = 0; k < n; k++)
			for (int j = 0; j <= k; j++) {
				double value = -of->kappa2[i]*of->part[i*pairs + hawser__pair(j, k)];

				if (value == 0.0)
					continue;
				Q[rom->quads++] = (struct hawser_quad){n + i, j, k, j == k ? 0.5*value : value};
				Q[rom->quads++] = (struct hawser_quad){j, k, n + i, value};
				if (j < k)
					Q[rom->quads++] = (struct hawser_quad){k, j, n + i, value};
			}
	return HAWSER_OK;
}
