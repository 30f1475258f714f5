/* rom/drag.c - quadratic drag of air at rest.
 *
 *   c      kg/m^2: force per unstretched length over the square of the velocity; density, drag
 *          coefficient and diameter of the cable multiplied, over 2
 *   v(s)   velocity normal to the static cable: sum of u_k' (Q_k, B_k), in two components
 *   force  -c |v| v per length; that along the cable, the friction of the surface, is some hundredths
 *          of it and is left out (Morison's formula)
 *
 *   F_j = -c' integral of |v| (v . Phi_j) ds,   c' = c d/rho   (scaled)
 *   dF_j/du_k' = -c' integral of [ |v| Phi_j . Phi_k + (v . Phi_j) (v . Phi_k)/|v| ] ds
 *
 * The integral is a sum over the Gauss points of the modes. |v| v has a continuous first derivative but
 * no second one where v changes its sign, so that the sum is not exact: its relative error is some 5e-4
 * if six modes move at random, and 1e-14 if the velocity has one sign (tests/property/test-drag). The
 * velocity of modes that are not kept is left out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/drag.h"
#include "rom/support.h"

static enum hawser_status check(const struct hawser_scene *scene, struct hawser_report *report)
{
	if (scene->travel.present)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "damping.drag = %g kg/m^2 is for a cable that does not travel: remove "
		                    "travel, or give damping.alpha instead", scene->damping.drag);
	if (hawser__support_moves(scene))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "damping.drag = %g kg/m^2 is for a cable with supports at rest: remove "
		                    "the motion of the supports, or give damping.alpha instead",
		                    scene->damping.drag);
	return HAWSER_OK;
}

enum hawser_status hawser__drag_make(struct hawser_rom *rom, const struct hawser_modes *modes,
                                     const struct hawser_scene *scene, struct hawser_report *report)
{
	const struct hawser_grid *grid = &modes->grid;
	size_t n = (size_t)modes->n, points = (size_t)grid->points;
	struct hawser_rom_drag *drag;
	enum hawser_status status;

	if (!scene || !(scene->damping.drag > 0.0))
		return HAWSER_OK;
	status = check(scene, report);
	if (status)
		return status;
	drag = rom->drag = calloc(1, sizeof *drag);
	if (!drag)
		return hawser__no_memory(report, "rom");
	drag->n = modes->n;
	drag->points = grid->points;
	drag->weight = malloc(points*sizeof *drag->weight);
	drag->shape = malloc(points*2*n*sizeof *drag->shape);
	if (!drag->weight || !drag->shape)
		return hawser__no_memory(report, "rom");
	for (size_t i = 0; i < points; i++) {
		drag->weight[i] = grid->weight[i]*scene->damping.drag*rom->length/modes->statics.span.rho;
		for (size_t j = 0; j < n; j++) {
			double at[3];

			hawser_modes_at(modes, at, NULL, (int)j, grid->s[i]);
			drag->shape[(2*i)*n + j] = at[1];
			drag->shape[(2*i + 1)*n + j] = at[2];
		}
	}
	return HAWSER_OK;
}

void hawser__drag_free(struct hawser_rom_drag *drag)
{
	if (!drag)
		return;
	free(drag->weight);
	free(drag->shape);
	free(drag);
}

/* The velocity at a point. */
static double speed_at(double *vq, double *vb, const double *Q, const double *B, const double *v,
                       int n, int stride)
{
	double q = 0.0, b = 0.0;

	for (int k = 0; k < n; k++) {
		q += Q[k]*v[k*stride];
		b += B[k]*v[k*stride];
	}
	*vq = q;
	*vb = b;
	return hypot(q, b);
}

void hawser__drag_add(const struct hawser_rom_drag *drag, double *force, const double *v, int stride)
{
	int n = drag->n;

	for (int i = 0; i < drag->points; i++) {
		const double *Q = drag->shape + (size_t)2*i*n, *B = Q + n;
		double q, b, w = drag->weight[i]*speed_at(&q, &b, Q, B, v, n, stride);

		for (int j = 0; j < n; j++)
			force[j*stride] -= w*(q*Q[j] + b*B[j]);
	}
}

void hawser__drag_slope(const struct hawser_rom_drag *drag, double sign, double *matrix,
                        const double *v, int stride)
{
	int n = drag->n;

	for (int i = 0; i < drag->points; i++) {
		const double *Q = drag->shape + (size_t)2*i*n, *B = Q + n;
		double q, b, speed = speed_at(&q, &b, Q, B, v, n, stride), w = sign*drag->weight[i];

		if (speed == 0.0)
			continue; /* the derivative is 0 */
		q /= speed;
		b /= speed;
		for (int j = 0; j < n; j++) {
			double normal = w*speed*(Q[j] + q*(q*Q[j] + b*B[j]));
			double binormal = w*speed*(B[j] + b*(q*Q[j] + b*B[j]));

			for (int k = 0; k < n; k++)
				matrix[(j*n + k)*stride] += normal*Q[k] + binormal*B[k];
		}
	}
}

enum hawser_status hawser__drag_refuse(const struct hawser_rom *rom, const char *what,
                                       struct hawser_report *report)
{
	if (rom && !rom->drag)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
	                    "%s has no quadratic drag, which only hawser integrate and hawser frf have "
	                    "(by shooting): set damping.drag=0, and give a linear damping with the same "
	                    "loss at the amplitude of interest", what);
}
