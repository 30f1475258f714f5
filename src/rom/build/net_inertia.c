/* rom/build/net_inertia.c - second-order shapes as coordinates of a net's model
 * (rom/condense/inertia.c). A mass on a short cable swings up as far as the square of its amplitude,
 * and what it lifts follows: without their inertia its frequency rises where it falls.
 *
 *   w_jk     what follows the modes j and k
 *   A_j      expected amplitude of mode j: at its resonance, or a slope that the expansion bears
 *   psi      a vibration in the space of all w_jk, of the mass 1, of stiffness kappa^2
 *
 * psi is orthogonal to the modes in mass and stiffness, as the w_jk are, and w_jk then has no part
 * along it. The load is on what remains static, so that psi has the force - 1/2 T_jkpsi u_j u_k alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/build/net.h"

static const double allowed = 2e-4; /* relative error of resonance frequencies, as of spans; chosen */

static double *pair_row(const struct hawser__net_source *source, int pair)
{
	return source->t.second + (size_t)pair*(size_t)source->modal.mesh.unknowns;
}

/* --- amplitudes --- */

/* Largest mean square of the slopes of mode j on a cable. */
static double turning(const struct hawser__net_source *source, int j)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;
	double (*slope)[3] = source->t.slope + (size_t)j*(size_t)mesh->elements, most = 0.0;

	for (int c = 0; c < mesh->cables; c++) {
		double sum = 0.0;

		for (int e = mesh->first[c]; e < mesh->first[c + 1]; e++)
			sum += slope[e][1]*slope[e][1] + slope[e][2]*slope[e][2];
		most = fmax(most, sum/(mesh->first[c + 1] - mesh->first[c]));
	}
	return most;
}

/* Amplitude A at resonance, of a force over its damping: A Omega = size, with the frequency Omega^2 =
 * omega^2 + harder A^2 of the mode alone to the first order. */
static double resonance(const struct hawser__net_source *source, int j, double size)
{
	const struct hawser__nexpand *t = &source->t;
	double square = t->omega2[j], quad = 0.5*t->third[(j*t->n + j)*t->n + j];
	double harder = 0.75*hawser__nexpand_own(t, j)/6.0 - 5.0/6.0*quad*quad/square;

	if (!(harder*size*size > 1e-6*square*square))
		return size/sqrt(square);
	return sqrt((sqrt(square*square + 4.0*harder*size*size) - square)/(2.0*harder));
}

static double amplitude(const struct hawser__net_source *source, int j)
{
	int unknowns = source->modal.mesh.unknowns;
	const double *mode = source->mode + (size_t)j*(size_t)unknowns;
	double omega = sqrt(source->t.omega2[j]), force = 0.0, damping;

	for (int i = 0; i < source->waves; i++) {
		const struct hawser__net_wave *wave = &source->wave[i];
		double own = cblas_ddot(unknowns, mode, 1, wave->row, 1)*pow(omega/source->time, wave->power);

		force = fmax(force, fabs(own)/source->t.energy);
	}
	damping = hawser__net_damping(source, (const double (*)[3])source->t.shape +
	                              (size_t)j*(size_t)source->modal.mesh.nodes, mode)/
	          hawser__net_unit(source)*source->time + 2.0*source->net->ratio*omega;
	return force > 0.0 ? fmin(resonance(source, j, force/damping),
	                          HAWSER__INERTIA_SLOPE/sqrt(turning(source, j))) : 0.0;
}

/* --- the choice --- */

struct work {
	int count, pair[HAWSER__INERTIA_PAIRS];
	double factor[HAWSER__INERTIA_PAIRS], square[HAWSER__INERTIA_PAIRS];
	double mass[HAWSER__INERTIA_PAIRS*HAWSER__INERTIA_PAIRS],
		stiffness[HAWSER__INERTIA_PAIRS*HAWSER__INERTIA_PAIRS],
		combination[HAWSER__INERTIA_MOST*HAWSER__INERTIA_PAIRS];
};

/* Among the pairs that matter most. */
static void enter(struct work *w, int pair, double factor, double square)
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

static void find_pairs(struct work *w, const struct hawser__net_source *source)
{
	double A[HAWSER_NET_ROM_MODES];

	for (int k = 0; k < source->n; k++) {
		A[k] = amplitude(source, k);
		for (int j = 0; j <= k; j++) {
			int pair = hawser__pair(j, k);
			double factor = j == k ? 0.5*A[j] : A[j]*A[k]/hypot(A[j], A[k]), square;

			if (!(A[j]*A[k] > 0.0))
				continue;
			square = factor*factor*hawser__net_mass(source, pair_row(source, pair),
			                                        pair_row(source, pair))/hawser__net_unit(source);
			if (square > HAWSER__INERTIA_TRIFLE*allowed)
				enter(w, pair, factor, square);
		}
	}
}

/* M and K of the motions x and y of rows; a second row is needed for K. */
static void products(double *mass, double *stiffness, const struct hawser__net_source *source,
                     const double *x, const double *y)
{
	*mass = hawser__net_mass(source, x, y)/hawser__net_unit(source);
	hawser__eigen_stiffness(source->scratch, x, &source->modal.eigen);
	*stiffness = cblas_ddot(source->modal.mesh.unknowns, source->scratch, 1, y, 1)/source->t.energy;
}

static void fill_products(struct work *w, const struct hawser__net_source *source)
{
	for (int x = 0; x < w->count; x++)
		for (int y = 0; y <= x; y++) {
			double factor = w->factor[x]*w->factor[y], m, k;

			products(&m, &k, source, pair_row(source, w->pair[x]), pair_row(source, w->pair[y]));
			w->mass[x*w->count + y] = w->mass[y*w->count + x] = factor*m;
			w->stiffness[x*w->count + y] = w->stiffness[y*w->count + x] = factor*k;
		}
}

enum hawser_status hawser__net_inertia_find(struct hawser__net_source *source,
                                            struct hawser_report *report)
{
	struct hawser__net_inertia *of = &source->inertia;
	struct work *w = calloc(1, sizeof *w);
	double omega[HAWSER__INERTIA_MOST];
	enum hawser_status status = HAWSER_OK;

	of->pairs = source->t.pairs;
	of->by = hawser__hold(&source->hold, HAWSER__INERTIA_MOST*(size_t)of->pairs, sizeof *of->by);
	if (!w || !of->by) {
		free(w);
		return hawser__no_memory(report, "net rom");
	}
	find_pairs(w, source);
	fill_products(w, source);
	if (w->count > 0)
		status = hawser__inertia_choose(&of->found, w->combination, omega, w->mass, w->stiffness,
		                                w->count, allowed, report);
	for (int i = 0; i < of->found.shapes; i++)
		for (int x = 0; x < w->count; x++)
			of->by[i*of->pairs + w->pair[x]] = w->combination[i*w->count + x]*w->factor[x];
	free(w);
	return status;
}

/* --- the shapes --- */

/* Shapes of the mass 1 and orthogonal, from rows that are nearly so. */
static enum hawser_status orthogonalise(struct hawser__net_inertia *of,
                                        const struct hawser__net_source *source, const double *raw,
                                        struct hawser_report *report)
{
	double mass[HAWSER__INERTIA_MOST*HAWSER__INERTIA_MOST],
		stiffness[HAWSER__INERTIA_MOST*HAWSER__INERTIA_MOST];
	size_t unknowns = (size_t)source->modal.mesh.unknowns;
	int n = of->found.shapes;

	for (int x = 0; x < n; x++)
		for (int y = 0; y <= x; y++) {
			products(&mass[x*n + y], &stiffness[x*n + y], source, raw + (size_t)x*unknowns,
			         raw + (size_t)y*unknowns);
			mass[y*n + x] = mass[x*n + y];
			stiffness[y*n + x] = stiffness[x*n + y];
		}
	if (LAPACKE_dsygvd(LAPACK_ROW_MAJOR, 1, 'V', 'L', n, stiffness, n, mass, n, of->kappa2))
		return hawser__fail(report, HAWSER_ERR_NAN, "net rom", "%s: the second-order shapes are not "
		                    "independent", source->net->name);
	for (int i = 0; i < n; i++) {
		size_t most = cblas_idamax(n, stiffness + i, n)*(size_t)n + (size_t)i;
		double sign = stiffness[most] < 0.0 ? -1.0 : 1.0;

		for (int x = 0; x < n; x++)
			cblas_daxpy((int)unknowns, sign*stiffness[x*n + i], raw + (size_t)x*unknowns, 1,
			            of->row + (size_t)i*unknowns, 1);
	}
	return HAWSER_OK;
}

enum hawser_status hawser__net_inertia_make(struct hawser__net_source *source,
                                            struct hawser_report *report)
{
	struct hawser__net_inertia *of = &source->inertia;
	size_t unknowns = (size_t)source->modal.mesh.unknowns, shapes = (size_t)of->found.shapes,
	       elements = (size_t)source->modal.mesh.elements,
	       pairs = (size_t)(source->n*(source->n + 1)/2);
	double *raw;
	enum hawser_status status;

	if (shapes == 0)
		return HAWSER_OK;
	raw = hawser__numbers(shapes, unknowns);
	of->row = hawser__hold(&source->hold, shapes*unknowns, sizeof *of->row);
	of->third = hawser__hold(&source->hold, shapes*pairs, sizeof *of->third);
	of->slope = hawser__hold(&source->hold, shapes*elements, sizeof *of->slope);
	if (!raw || source->hold.short_of_memory) {
		free(raw);
		return hawser__no_memory(report, "net rom");
	}
	for (size_t i = 0; i < shapes; i++)
		for (size_t x = 0; x < pairs; x++)
			if (of->by[i*(size_t)of->pairs + x] != 0.0)
				cblas_daxpy((int)unknowns, of->by[i*(size_t)of->pairs + x],
				            pair_row(source, (int)x), 1, raw + i*unknowns, 1);
	status = orthogonalise(of, source, raw, report);
	free(raw);
	for (size_t i = 0; i < shapes && !status; i++) {
		const double *row = of->row + i*unknowns;
		double (*slope)[3] = of->slope + i*elements;

		for (size_t e = 0; e < elements; e++)
			hawser__nexpand_row_slope(slope[e], &source->t, (int)e, row);
		for (int k = 0; k < source->n; k++)
			for (int j = 0; j <= k; j++) {
				size_t pair = (size_t)hawser__pair(j, k);
				double third = hawser__nexpand_third(&source->t, j, k, (const double (*)[3])slope);

				of->third[i*pairs + pair] = third;
				cblas_daxpy((int)unknowns, third/of->kappa2[i], row, 1, pair_row(source, (int)pair), 1);
			}
	}
	return status;
}
