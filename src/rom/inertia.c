/* rom/inertia.c - second-order shapes as coordinates.
 *
 *   w_jk   what the modes that are not kept do in answer to kept j and k (condense.h)
 *   r_jk   its part beyond the lowest modes
 *   A_j    largest amplitude expected of mode j
 *   weight of a pair: |r_jk| weight = d/a, the amplitude of what follows over that of what it follows;
 *          resonances come out too high by the part (d/a)^2 when it has no inertia
 *
 * Modes that follow statically move, so they have kinetic energy, 1/2 |sum w_jk u_j u_k'|^2, of the same
 * fourth order as the energy that condensing them gives back. Of a sagging cable that keeps its length
 * the longitudinal modes do most of it, which no number of kept modes reaches. In place of them a few
 * shapes that carry what they do become coordinates q: the principal axes of the motions r_jk A_j A_k.
 * In the potential, V(u) + 1/2 K (q - q_static(u))^2, they count as two orders, so that it ends with
 * T_jk u_j u_k q: it is bounded wherever the condensed one is, however stiff the cable. (With terms
 * u^2 q^2 it is not: at 1/eps they need those of the sixth order in u.)
 *
 * The part of w along the lowest modes is left as it is: those are kept, or not, for what they do
 * dynamically (choose.h), which one shape with one frequency does badly.
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
#include "rom/inertia.h"

#define LOWEST 32    /* modes whose inertia is left to the choice of modes */
#define SLOPE 0.15   /* no motion is expected to turn the cable by more (mean square) */
#define MOST 6       /* shapes */

struct work {
	const struct hawser_modes *modes;
	const struct hawser__condensed *condensed;
	int width;        /* 3*points */
	int count;        /* pairs that count */
	int *pair;        /* [count] */
	double *factor;   /* [count] weight of the pair */
	double *shape;    /* [count][width] P, Q, B of what follows, times its weight */
	double *strain;   /* [count][width] a, b, c, likewise */
	double *root;     /* [width] square roots of the grid's weights */
	double *stiff;    /* [width] and of weight times stiffness against a, b, c */
	double *scaled;   /* [count][width] */
	double *gram;     /* [count][count] */
	double *value;    /* [count] */
};

static void work_clear(struct work *work)
{
	free(work->pair);
	free(work->factor);
	free(work->shape);
	free(work->strain);
	free(work->root);
	free(work->stiff);
	free(work->scaled);
	free(work->gram);
	free(work->value);
}

static int work_make(struct work *work)
{
	size_t count = (size_t)work->condensed->pairs, width = (size_t)work->width;

	work->pair = malloc(count*sizeof *work->pair);
	work->factor = malloc(count*sizeof *work->factor);
	work->shape = malloc(count*width*sizeof *work->shape);
	work->strain = malloc(count*width*sizeof *work->strain);
	work->root = malloc(width*sizeof *work->root);
	work->stiff = malloc(width*sizeof *work->stiff);
	work->scaled = malloc(count*width*sizeof *work->scaled);
	work->gram = malloc(count*count*sizeof *work->gram);
	work->value = malloc(count*sizeof *work->value);
	return work->pair && work->factor && work->shape && work->strain && work->root &&
	       work->stiff && work->scaled && work->gram && work->value;
}

static void set_roots(struct work *work)
{
	const struct hawser_modes *modes = work->modes;

	for (int p = 0; p < modes->grid.points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(&modes->statics, modes->grid.s[p]);
		double weight = modes->grid.weight[p], k = sqrt(1.0 + at.u*at.u)/(1.0 + at.strain);

		for (int c = 0; c < 3; c++) {
			work->root[3*p + c] = sqrt(weight);
			work->stiff[3*p + c] = sqrt(weight*k);
		}
		work->stiff[3*p] = sqrt(weight/modes->statics.epsilon);
	}
}

/* --- amplitudes --- */

/* Mean square of the slopes that mode j turns the cable by. */
static double turning(const struct hawser_modes *modes, int j)
{
	const double *slope = modes->slope + (size_t)j*3*(size_t)modes->grid.points;
	double sum = 0.0;

	for (int p = 0; p < modes->grid.points; p++)
		sum += modes->grid.weight[p]*(slope[3*p + 1]*slope[3*p + 1] +
		                              slope[3*p + 2]*slope[3*p + 2]);
	return sum/modes->statics.l;
}

/* The resonance of the linear model, where it is no larger than the energy to fourth order holds. */
static double amplitude(const struct hawser_modes *modes, int j, double load, double damping)
{
	double most = SLOPE/sqrt(turning(modes, j)), resonance = fabs(load);

	if (!(resonance > 0.0))
		return 0.0;
	resonance /= damping*modes->mode[j].omega;
	return resonance < most ? resonance : most;
}

static void choose_pairs(struct work *work, const double *load, const double *damping)
{
	const struct hawser_modes *modes = work->modes;

	for (int k = 0; k < modes->n; k++)
		for (int j = 0; j <= k; j++) {
			double a = amplitude(modes, j, load[j], damping[j]);
			double b = amplitude(modes, k, load[k], damping[k]);

			if (!(a*b > 0.0))
				continue;
			work->pair[work->count] = k*(k + 1)/2 + j;
			work->factor[work->count++] = j == k ? 0.5*a : a*b/hypot(a, b);
		}
}

/* --- what follows --- */

/* Displacement [points][3] of the strains, which vanishes at end A and so at B. */
static void displacement(double *shape, const struct hawser_modes *modes,
                         const struct hawser__reference *reference, const double *strain,
                         double *scratch)
{
	int points = modes->grid.points;
	double *global = scratch, *along = scratch + 3*points;

	for (int p = 0; p < points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(&modes->statics, modes->grid.s[p]);
		const double *f = strain + 3*p;

		global[p] = f[0]*at.ex - f[1]*at.ey;
		global[points + p] = f[0]*at.ey + f[1]*at.ex;
		global[2*points + p] = f[2];
	}
	for (int axis = 0; axis < 3; axis++)
		(void)hawser__grid_running(along + axis*points, &modes->grid, reference,
		                           global + axis*points);
	for (int p = 0; p < points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(&modes->statics, modes->grid.s[p]);
		double x = along[p], y = along[points + p];

		shape[3*p] = x*at.ex + y*at.ey;
		shape[3*p + 1] = y*at.ex - x*at.ey;
		shape[3*p + 2] = along[2*points + p];
	}
}

static enum hawser_status take_pairs(struct work *work, struct hawser_report *report)
{
	const struct hawser_grid *grid = &work->modes->grid;
	size_t width = (size_t)work->width;
	double *scratch = malloc(2*width*sizeof *scratch);
	struct hawser__reference reference;
	enum hawser_status status;

	if (!scratch)
		return hawser__no_memory(report, "rom");
	status = hawser__reference_init(&reference, grid, grid->order - 1, report);
	for (int x = 0; !status && x < work->count; x++) {
		double *strain = work->strain + (size_t)x*width, *shape = work->shape + (size_t)x*width;

		memcpy(strain, work->condensed->strain + (size_t)work->pair[x]*width,
		       width*sizeof *strain);
		displacement(shape, work->modes, &reference, strain, scratch);
		cblas_dscal(work->width, work->factor[x], strain, 1);
		cblas_dscal(work->width, work->factor[x], shape, 1);
	}
	if (!status)
		hawser__reference_clear(&reference);
	free(scratch);
	return status;
}

/* gram [count][count] = products of rows of `field`, times root; returns its trace. */
static double products(struct work *work, const double *field, const double *root, int count)
{
	int width = work->width;
	double trace = 0.0;

	for (int x = 0; x < count; x++)
		for (int p = 0; p < width; p++)
			work->scaled[(size_t)x*(size_t)width + (size_t)p] =
				root[p]*field[(size_t)x*(size_t)width + (size_t)p];
	cblas_dsyrk(CblasRowMajor, CblasLower, CblasNoTrans, count, width, 1.0, work->scaled, width,
	            0.0, work->gram, count);
	for (int x = 0; x < count; x++)
		trace += work->gram[(size_t)x*(size_t)(count + 1)];
	return trace;
}

/* Take the part along one mode, given by its fields at the grid's points, out of every pair. */
static void remove_mode(struct work *work, const double *shape, const double *slope)
{
	for (int x = 0; x < work->count; x++) {
		double *to = work->shape + (size_t)x*(size_t)work->width, part = 0.0;

		for (int p = 0; p < work->width; p++)
			part += work->root[p]*work->root[p]*to[p]*shape[p];
		cblas_daxpy(work->width, -part, shape, 1, to, 1);
		cblas_daxpy(work->width, -part, slope, 1,
		            work->strain + (size_t)x*(size_t)work->width, 1);
	}
}

/* What is left of the pairs beyond the lowest modes. Where these can't be had it is nothing. */
static enum hawser_status remove_lowest(struct work *work, struct hawser_report *report)
{
	const struct hawser_modes_options options = {.n = LOWEST};
	size_t width = (size_t)work->width;
	double *field = malloc(2*width*sizeof *field);
	struct hawser_modes lowest;

	if (!field)
		return hawser__no_memory(report, "rom");
	if (hawser_modes_solve(&lowest, &work->modes->statics, &options, NULL)) {
		work->count = 0;
		free(field);
		return HAWSER_OK;
	}
	for (int s = 0; s < lowest.n; s++) {
		for (int p = 0; p < work->modes->grid.points; p++)
			hawser_modes_at(&lowest, field + 3*p, field + width + 3*p, s,
			                work->modes->grid.s[p]);
		remove_mode(work, field, field + width);
	}
	hawser_modes_clear(&lowest);
	free(field);
	return HAWSER_OK;
}

/* --- shapes --- */

static enum hawser_status decompose(struct work *work, int count, struct hawser_report *report)
{
	if (LAPACKE_dsyevd(LAPACK_ROW_MAJOR, 'V', 'L', count, work->gram, count, work->value) == 0)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_NAN, "rom",
	                    "the shapes of what follows the %d kept modes did not come out: check EA, "
	                    "rho and the tension of the span", work->modes->n);
}

/* Principal axes, the largest first, until what is left is allowed; their number. */
static int enough(const struct work *work, double allowed, double *left)
{
	int shapes = 0;

	*left = 0.0;
	for (int x = 0; x < work->count; x++)
		*left += fmax(work->value[x], 0.0);
	while (*left > allowed && shapes < MOST && shapes < work->count)
		*left -= work->value[work->count - ++shapes];
	*left = fmax(*left, 0.0);
	return shapes;
}

/* to[shapes][width] = the last `shapes` eigenvectors' combinations of from[count][width]. */
static void combine(double *to, const struct work *work, const double *from, int shapes)
{
	int count = work->count, width = work->width;

	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, shapes, width, count, 1.0,
	            work->gram + count - shapes, count, from, width, 0.0, to, width);
}

/* The new modes' rows: orthonormal in mass, diagonal in stiffness. work's fields are used up. */
static enum hawser_status set_shapes(struct hawser_modes *with, struct work *work, int shapes,
                                     struct hawser_report *report)
{
	size_t width = (size_t)work->width, first = (size_t)work->modes->n*width;
	double *shape = with->shape + first, *slope = with->slope + first;
	enum hawser_status status;

	combine(shape, work, work->shape, shapes);
	combine(slope, work, work->strain, shapes);
	for (int i = 0; i < shapes; i++) {
		double scale = 1.0/sqrt(work->value[work->count - shapes + i]);

		cblas_dscal(work->width, scale, shape + (size_t)i*width, 1);
		cblas_dscal(work->width, scale, slope + (size_t)i*width, 1);
	}
	(void)products(work, slope, work->stiff, shapes);
	status = decompose(work, shapes, report);
	if (status)
		return status;
	work->count = shapes;
	memcpy(work->shape, shape, (size_t)shapes*width*sizeof *shape);
	memcpy(work->strain, slope, (size_t)shapes*width*sizeof *slope);
	combine(shape, work, work->shape, shapes);
	combine(slope, work, work->strain, shapes);
	for (int i = 0; i < shapes; i++) {
		int k = work->modes->n + i;
		struct hawser_mode *mode = &with->mode[k];

		mode->omega = sqrt(work->value[i]);
		mode->place = k + 1;
		(void)hawser__mode_label(with, k);
		mode->plane = mode->out_of_plane_share > 0.5 ? HAWSER_OUT_OF_PLANE : HAWSER_IN_PLANE;
	}
	return HAWSER_OK;
}

enum hawser_status hawser__inertia_extend(struct hawser_modes *with,
                                          struct hawser_rom_inertia *inertia,
                                          const struct hawser_modes *modes,
                                          const struct hawser__condensed *condensed,
                                          const double *load, const double *damping,
                                          double allowed, struct hawser_report *report)
{
	struct work work = {.modes = modes, .condensed = condensed, .width = 3*modes->grid.points};
	enum hawser_status status = HAWSER_OK;
	double all;

	*with = (struct hawser_modes){.n = 0};
	*inertia = (struct hawser_rom_inertia){.shapes = 0};
	if (!work_make(&work)) {
		status = hawser__no_memory(report, "rom");
		goto done;
	}
	set_roots(&work);
	choose_pairs(&work, load, damping);
	status = take_pairs(&work, report);
	if (status || work.count == 0)
		goto done;
	all = products(&work, work.shape, work.root, work.count);
	if (all > allowed)
		status = remove_lowest(&work, report);
	if (status || !(all > allowed) || work.count == 0)
		goto done;
	inertia->shift = products(&work, work.shape, work.root, work.count);
	status = decompose(&work, work.count, report);
	if (status)
		goto done;
	inertia->shapes = enough(&work, allowed, &inertia->left);
	if (inertia->shapes > 0)
		status = hawser__modes_extend(with, modes, inertia->shapes, report);
	if (!status && inertia->shapes > 0)
		status = set_shapes(with, &work, inertia->shapes, report);
done:
	work_clear(&work);
	if (status)
		hawser_modes_clear(with);
	return status;
}
