/* rom/condense/support_shape.c - quasi-static displacements by displacements of the ends.
 *
 *   Delta        displacement of end B, or of its foundation if it is on springs; A is fixed
 *   N            change of the force in the cable, constant between springs of attachments
 *   a, b, c      derivative of the displacement along e, n, z
 *   C            compliance of a part of the cable between springs (struct hawser__ties)
 *   K_i, q_i     stiffness of the springs at a point, its displacement
 *
 * With bending stiffness the compliance is not that of points, and the system is that of ties.c, whose
 * force answers a displacement of the ends in place of a load. A clamp moves without turning.
 *
 * Without a load on the cable a = eps N.e, b = N.n/k, c = N_z/k as in condense.c. The integral of these
 * strains is the displacement, Delta at end B, and N changes by K_i q_i at the springs: a linear system
 * for N in all parts. This is the linearised elastic catenary; without springs C^-1 is the stiffness of
 * the cable at its end, in the direction of the chord of a shallow one (EA/L)/(1 + lambda^2/12) with
 * the Irvine parameter lambda^2. A translation of both ends changes N by K_i (q_i + 1). The springs of
 * an elastic support are a compliance in series with the part of the cable at that end, which moves
 * towards the other one by N/k relative to its foundation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/grid.h"
#include "modes/label.h"
#include "rom/condense/bend.h"
#include "rom/condense/condense.h"
#include "rom/condense/support.h"
#include "rom/terms/ties.h"

/* Parts between the points with springs, in axes along and across the chord, in which the matrix of a
 * straight cable is graded. */
struct parts {
	double c, s;      /* direction of the chord */
	int count;        /* at most HAWSER_ATTACH_MAX + 1 */
	int spring[HAWSER_ATTACH_MAX + 1];        /* [count - 1] the attachment behind a part */
	struct hawser__ties ties[HAWSER_ATTACH_MAX + 1];
	double N[HAWSER__AXES][HAWSER_ATTACH_MAX + 1]; /* along, across, z */
};

static int part_of(const struct parts *parts, const struct hawser_statics *st, double s)
{
	int part = 0;

	while (part < parts->count - 1 && s > st->attached[parts->spring[part]].s)
		part++;
	return part;
}

/* Compliance of the spring of end `end` along `axis`, 0 if it is rigid; h: the axis along and across
 * the chord. */
static double joint(double h[2], const struct parts *parts, const struct hawser_statics *st, int end,
                    int axis)
{
	h[0] = axis == 0 ? parts->c : axis == 1 ? parts->s : 0.0;
	h[1] = axis == 0 ? -parts->s : axis == 1 ? parts->c : 0.0;
	return st->elastic ? st->H/(st->held[end].stiffness[axis]*st->span.d) : 0.0;
}

static void add_joints(struct parts *parts, const struct hawser_statics *st)
{
	for (int end = 0; end < 2; end++)
		for (int axis = 0; axis < 3; axis++) {
			struct hawser__ties *ties = &parts->ties[end ? parts->count - 1 : 0];
			double h[2], give = joint(h, parts, st, end, axis);

			ties->m[0] += give*h[0]*h[0];
			ties->m[1] += give*h[0]*h[1];
			ties->m[2] += give*h[1]*h[1];
			ties->mz += axis == 2 ? give : 0.0;
		}
}

static void divide(struct parts *parts, const struct hawser_modes *modes)
{
	const struct hawser_statics *st = &modes->statics;
	double chord = hypot(1.0, st->hs);

	*parts = (struct parts){.c = 1.0/chord, .s = st->hs/chord, .count = 1};
	for (int i = 0; i < st->attachments; i++) {
		const double *k = st->attached[i].spring;

		if (k[0] > 0.0 || k[1] > 0.0 || k[2] > 0.0)
			parts->spring[parts->count++ - 1] = i;
	}
	for (int p = 0; p < modes->grid.points; p++) {
		struct hawser__place at = hawser__place_at(modes, modes->grid.s[p], modes->grid.weight[p]);

		hawser__ties_add(&parts->ties[part_of(parts, st, modes->grid.s[p])], &at);
	}
	add_joints(parts, st);
}

/* C [dims][dims] of a part, and K of the springs behind it, in the plane or across it. */
static void matrices(double *C, double *K, const struct parts *parts, int part, int dims,
                     const struct hawser_statics *st)
{
	const struct hawser__ties *ties = &parts->ties[part];
	double c = parts->c, s = parts->s, scale = st->span.d/st->H, k[3] = {0.0};

	for (int i = 0; part < parts->count - 1 && i < 3; i++)
		k[i] = scale*st->attached[parts->spring[part]].spring[i];
	if (dims == 1) {
		C[0] = ties->mz;
		K[0] = k[2];
		return;
	}
	memcpy(C, (double[]){ties->m[0], ties->m[1], ties->m[1], ties->m[2]}, 4*sizeof *C);
	memcpy(K, (double[]){c*c*k[0] + s*s*k[1], c*s*(k[1] - k[0]), c*s*(k[1] - k[0]),
	                     s*s*k[0] + c*c*k[1]}, 4*sizeof *K);
}

/* The system of the forces N [parts][dims]; `unit` [dims] is the translation of both ends (`common`)
 * or the displacement of end B. Rows are scaled, since springs may be stiff. */
static void assemble(double *A, double *b, const struct parts *parts, int dims, const double *unit,
                     int common, const struct hawser_statics *st)
{
	int size = parts->count*dims;

	memset(A, 0, (size_t)size*(size_t)size*sizeof *A);
	memset(b, 0, (size_t)size*sizeof *b);
	for (int row = 0; row < parts->count; row++)
		for (int i = 0; i < dims; i++) {
			double C[4], K[4], unused[4], *to = A + (size_t)(row*dims + i)*(size_t)size, most;
			int last = row == parts->count - 1;

			matrices(unused, K, parts, row, dims, st);
			for (int part = 0; part <= row; part++) {
				matrices(C, unused, parts, part, dims, st);
				for (int j = 0; j < dims; j++)
					for (int l = 0; l < dims; l++)
						to[part*dims + j] -= last ? (i == l ? -C[l*dims + j] : 0.0)
						                     : K[i*dims + l]*C[l*dims + j];
			}
			if (last)
				b[row*dims + i] = common ? 0.0 : unit[i];
			else
				to[(row + 1)*dims + i] += 1.0;
			to[row*dims + i] -= last ? 0.0 : 1.0;
			for (int l = 0; !last && common && l < dims; l++)
				b[row*dims + i] += K[i*dims + l]*unit[l];
			most = fabs(to[cblas_idamax(size, to, 1)]);
			cblas_dscal(size, 1.0/most, to, 1);
			b[row*dims + i] /= most;
		}
}

static enum hawser_status forces(struct parts *parts, int axis, int common,
                                 const struct hawser_statics *st, struct hawser_report *report)
{
	const double unit[2] = {axis == 0 ? parts->c : axis == 1 ? parts->s : 1.0,
		axis == 0 ? -parts->s : parts->c};
	int dims = axis == 2 ? 1 : 2, size = parts->count*dims, failed;
	double *A = malloc(((size_t)size + 1)*(size_t)size*sizeof *A), *b = A + (size_t)size*size;
	lapack_int pivot[2*(HAWSER_ATTACH_MAX + 1)];

	if (!A)
		return hawser__no_memory(report, "rom");
	assemble(A, b, parts, dims, unit, common, st);
	failed = (int)LAPACKE_dgesv(LAPACK_ROW_MAJOR, size, 1, A, size, pivot, b, 1);
	memset(parts->N, 0, sizeof parts->N);
	for (int i = 0; i < size; i++)
		parts->N[axis == 2 ? 2 : i%2][i/dims] = b[i];
	free(A);
	if (hawser__lapack_starved(failed))
		return hawser__no_memory(report, "rom");
	return !failed ? HAWSER_OK
	       : hawser__fail(report, HAWSER_ERR_NAN, "rom", "the quasi-static shape of the cable with "
	                      "moving ends is not finite: give springs (attach) of a smaller stiffness");
}

/* strain [points][3] of the forces. */
static void set_strain(double *strain, const struct hawser_modes *modes, const struct parts *parts)
{
	const struct hawser_grid *grid = &modes->grid;

	for (int p = 0; p < grid->points; p++) {
		struct hawser__place at = hawser__place_at(modes, grid->s[p], grid->weight[p]);
		int part = part_of(parts, &modes->statics, grid->s[p]);
		double N0 = parts->N[0][part], N1 = parts->N[1][part];

		strain[3*p] = at.eps*(N0*at.ex + N1*at.ey);
		strain[3*p + 1] = (N1*at.ex - N0*at.ey)/at.k;
		strain[3*p + 2] = parts->N[2][part]/at.k;
	}
}

/* Displacement of end B along axis, or (common) of both ends, in axes along and across the chord. */
static void unit_of(double unit[3], const struct parts *parts, int axis)
{
	unit[0] = axis == 0 ? parts->c : axis == 1 ? parts->s : 0.0;
	unit[1] = axis == 0 ? -parts->s : axis == 1 ? parts->c : 0.0;
	unit[2] = axis == 2;
}

/* strain [count][points][3] of all shapes with bending stiffness. */
static enum hawser_status bent_strains(struct hawser__support_shapes *shapes,
                                       const struct hawser_modes *modes, const struct parts *parts,
                                       struct hawser_report *report)
{
	const struct hawser_grid *grid = &modes->grid;
	size_t each = 3*(size_t)grid->points;
	struct hawser__bend *bend = NULL;
	struct hawser__springs *springs = NULL;
	struct hawser__place *place = malloc((size_t)grid->points*sizeof *place);
	enum hawser_status status = place ? hawser__springs_make(&springs, modes, report)
	                                  : hawser__no_memory(report, "rom");

	for (int p = 0; place && p < grid->points; p++)
		place[p] = hawser__place_at(modes, grid->s[p], grid->weight[p]);
	if (!status)
		status = hawser__bend_of(&bend, modes, report);
	if (!status)
		status = hawser__springs_assemble(springs, bend, place, grid->s, grid->points, report);
	for (int i = 0; !status && i < shapes->count; i++) {
		double unit[3];

		unit_of(unit, parts, i%HAWSER__AXES);
		memset(springs->z, 0, sizeof springs->z);
		for (int a = 0; a < springs->size; a++)
			springs->z[a] = i < HAWSER__AXES ? (a < 3 ? -unit[a] : 0.0)
			                : a < 3 ? 0.0 : cblas_ddot(3, springs->spring[a - 3].h, 1, unit, 1);
		hawser__springs_solve(springs);
		memset(shapes->strain + (size_t)i*each, 0, each*sizeof *shapes->strain);
		hawser__springs_release(shapes->strain + (size_t)i*each, springs, bend, place, grid->s,
		                        grid->points);
	}
	free(place);
	hawser__springs_free(springs);
	hawser__bend_free(bend);
	return status;
}

/* Displacement of end A along axis by the forces. */
static double start(const struct parts *parts, const struct hawser_statics *st, int axis)
{
	double h[2], give = joint(h, parts, st, 0, axis);

	return give*(axis == 2 ? parts->N[2][0] : h[0]*parts->N[0][0] + h[1]*parts->N[1][0]);
}

/* shape [3][points] = the integral of the strains from end A, in global axes, with the displacement of
 * that end; `work` is [points]. */
static void integrate(double *shape, const double *strain, const struct hawser_modes *modes,
                      const struct hawser__reference *reference, const struct parts *parts,
                      double *work)
{
	const struct hawser_grid *grid = &modes->grid;

	for (int axis = 0; axis < 3; axis++) {
		double *along = shape + (size_t)axis*(size_t)grid->points;
		double from = start(parts, &modes->statics, axis);

		for (int p = 0; p < grid->points; p++) {
			struct hawser_frame_point at = hawser_statics_frame(&modes->statics, grid->s[p]);
			const double *x = strain + 3*p;

			work[p] = axis == 0 ? x[0]*at.ex - x[1]*at.ey
			          : axis == 1 ? x[0]*at.ey + x[1]*at.ex : x[2];
		}
		hawser__grid_running(along, grid, reference, work);
		for (int p = 0; p < grid->points; p++)
			along[p] += from;
	}
}

enum hawser_status hawser__support_shapes_make(struct hawser__support_shapes *shapes,
                                               const struct hawser_modes *modes,
                                               struct hawser_report *report)
{
	const struct hawser_grid *grid = &modes->grid;
	const struct hawser_statics *st = &modes->statics;
	size_t points = (size_t)grid->points, each = 3*points, marks = (size_t)hawser__points(st);
	struct parts parts;
	struct hawser__reference reference = {0};
	double *work = malloc(points*sizeof *work);
	enum hawser_status status = hawser__reference_init(&reference, grid, grid->order - 1, report);

	divide(&parts, modes);
	*shapes = (struct hawser__support_shapes){.points = grid->points,
		.count = parts.count > 1 ? HAWSER__SUPPORT_MOST : HAWSER__AXES};
	shapes->strain = malloc((size_t)shapes->count*each*sizeof *shapes->strain);
	shapes->shape = malloc((size_t)shapes->count*each*sizeof *shapes->shape);
	shapes->at = malloc(((size_t)shapes->count*3*marks + 1)*sizeof *shapes->at);
	if (!work || !shapes->strain || !shapes->shape || !shapes->at)
		status = hawser__no_memory(report, "rom");
	if (!status && st->bending.EI > 0.0)
		status = bent_strains(shapes, modes, &parts, report);
	for (int i = 0; !status && i < shapes->count; i++) {
		double *strain = shapes->strain + (size_t)i*each, *shape = shapes->shape + (size_t)i*each;

		if (!(st->bending.EI > 0.0)) {
			status = forces(&parts, i%HAWSER__AXES, i >= HAWSER__AXES, st, report);
			set_strain(strain, modes, &parts);
		}
		if (status)
			break;
		integrate(shape, strain, modes, &reference, &parts, work);
		for (size_t m = 0; m < 3*marks; m++)
			hawser__grid_at(shapes->at + (size_t)i*3*marks + m, grid, shape + m%3*points, 1, 1,
			                hawser__point(st, (int)(m/3)).s);
	}
	hawser__reference_clear(&reference);
	free(work);
	if (status)
		hawser__support_shapes_clear(shapes);
	return status;
}

void hawser__support_shapes_clear(struct hawser__support_shapes *shapes)
{
	free(shapes->strain);
	free(shapes->shape);
	free(shapes->at);
	*shapes = (struct hawser__support_shapes){.points = 0};
}
