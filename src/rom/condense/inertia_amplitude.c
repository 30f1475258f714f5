/* rom/condense/inertia_amplitude.c - how far a mode moves at most, for the weights of inertia.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "rom/condense/inertia.h"

/* Mean square of the slopes of mode j. */
static double turning(const struct hawser_modes *modes, int j)
{
	const double *slope = modes->slope + (size_t)j*3*(size_t)modes->grid.points;
	double sum = 0.0;

	for (int p = 0; p < modes->grid.points; p++)
		sum += modes->grid.weight[p]*(slope[3*p + 1]*slope[3*p + 1] +
		                              slope[3*p + 2]*slope[3*p + 2]);
	return sum/modes->statics.l;
}

/* The amplitude of the linear resonance, limited to that up to which the fourth-order energy is
 * valid. */
double hawser__inertia_amplitude(const struct hawser_modes *modes, int j, double load,
                                 double damping)
{
	double most = HAWSER__INERTIA_SLOPE/sqrt(turning(modes, j)), resonance = fabs(load);

	if (!(resonance > 0.0))
		return 0.0;
	resonance /= damping*modes->mode[j].omega;
	return resonance < most ? resonance : most;
}

double hawser__inertia_allowed(const struct hawser_scene *scene)
{
	const double usual = 2e-4, part = 0.02;

	return scene->model.modes == HAWSER_MODES_AUTO && scene->model.accuracy > 0.0
	       ? fmin(usual, part*scene->model.accuracy) : usual;
}
