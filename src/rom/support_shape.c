/* rom/support_shape.c - quasi-static displacements by a displacement of end B.
 *
 *   Delta        displacement of end B; end A is fixed
 *   a, b, c      derivative of the displacement along e, n, z
 *   M            compliance of the cable against a force at its end (struct hawser__ties)
 *
 * Without a load on the cable the change lambda of the end force is constant, so that a = -eps
 * lambda.e, b = -lambda.n/k, c = -lambda_z/k as in condense.c. The integral of the strains along the
 * cable is -M lambda = Delta. This is the linearised elastic catenary; M^-1 is the stiffness of the
 * cable at its end, in the direction of the chord of a shallow one (EA/L)/(1 + lambda^2/12) with the
 * Irvine parameter lambda^2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/grid.h"
#include "rom/condense.h"
#include "rom/support.h"

/* strain [points][3] for a unit displacement of end B along `axis`. */
static void set_strain(double *strain, const struct hawser_modes *modes,
                       const struct hawser__ties *ties, int axis)
{
	const struct hawser_grid *grid = &modes->grid;
	double chord = hypot(1.0, modes->statics.hs), c = 1.0/chord, s = modes->statics.hs/chord;
	/* in the axes of `ties`, along and across the chord */
	const double r[3] = {axis == 0 ? -c : axis == 1 ? -s : 0.0,
		axis == 0 ? s : axis == 1 ? -c : 0.0, axis == 2 ? -1.0 : 0.0};
	double lambda[3];

	hawser__ties_solve(lambda, ties, r);
	for (int p = 0; p < grid->points; p++) {
		struct hawser__place at = hawser__place_at(modes, grid->s[p], grid->weight[p]);

		strain[3*p] = -at.eps*(lambda[0]*at.ex + lambda[1]*at.ey);
		strain[3*p + 1] = -(lambda[1]*at.ex - lambda[0]*at.ey)/at.k;
		strain[3*p + 2] = -lambda[2]/at.k;
	}
}

/* shape [3][points] = the integral of the strains from end A, in global axes; `work` is [points]. */
static void integrate(double *shape, const double *strain, const struct hawser_modes *modes,
                      const struct hawser__reference *reference, double *work)
{
	const struct hawser_grid *grid = &modes->grid;

	for (int axis = 0; axis < 3; axis++) {
		for (int p = 0; p < grid->points; p++) {
			struct hawser_frame_point at = hawser_statics_frame(&modes->statics, grid->s[p]);
			const double *x = strain + 3*p;

			work[p] = axis == 0 ? x[0]*at.ex - x[1]*at.ey
			          : axis == 1 ? x[0]*at.ey + x[1]*at.ex : x[2];
		}
		hawser__grid_running(shape + (size_t)axis*(size_t)grid->points, grid, reference, work);
	}
}

enum hawser_status hawser__support_shapes_make(struct hawser__support_shapes *shapes,
                                               const struct hawser_modes *modes,
                                               struct hawser_report *report)
{
	const struct hawser_grid *grid = &modes->grid;
	size_t points = (size_t)grid->points, each = 3*points;
	struct hawser__ties ties = {{0.0}, 0.0};
	struct hawser__reference reference;
	double *work = malloc(points*sizeof *work);
	enum hawser_status status = hawser__reference_init(&reference, grid, grid->order - 1, report);

	*shapes = (struct hawser__support_shapes){.points = grid->points};
	shapes->strain = malloc(HAWSER__AXES*each*sizeof *shapes->strain);
	shapes->shape = malloc(HAWSER__AXES*each*sizeof *shapes->shape);
	if (!status && (!work || !shapes->strain || !shapes->shape)) {
		hawser__reference_clear(&reference);
		status = hawser__no_memory(report, "rom");
	}
	for (size_t p = 0; !status && p < points; p++) {
		struct hawser__place at = hawser__place_at(modes, grid->s[p], grid->weight[p]);

		hawser__ties_add(&ties, &at);
	}
	for (int axis = 0; !status && axis < HAWSER__AXES; axis++) {
		set_strain(shapes->strain + (size_t)axis*each, modes, &ties, axis);
		integrate(shapes->shape + (size_t)axis*each, shapes->strain + (size_t)axis*each, modes,
		          &reference, work);
	}
	if (!status)
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
	*shapes = (struct hawser__support_shapes){.points = 0};
}
