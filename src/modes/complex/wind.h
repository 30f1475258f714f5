/* modes/complex/wind.h - a flow along a cable with modes. See wind.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_WIND_H
#define HAWSER_MODES_WIND_H

#include <hawser/modes.h>

#include "core/hold.h"
#include "statics/wind.h"

struct hawser__flow_points {
	int n, points;
	double *weight; /* [points] of the quadrature: force per length in N/m to scaled forces */
	double *speed;  /* [points] of the flow across the cable, m/s */
	double *shape;  /* [points][2][n] of each mode along the flow and across it, times unit: velocity
	                 * in m/s */
	double unit;    /* of velocities, m/s */
	struct hawser__section *section; /* one, or all that the points have */
	const struct hawser__section **at; /* [points] */
	struct hawser__hold hold;
};

/* In the wind of the scene, or in still air if it has none; the caller sets the section then. Returns
 * 0 if memory is short. */
int hawser__flow_points(struct hawser__flow_points *flow, const struct hawser_modes *modes,
                        const struct hawser_scene *scene);
/* Along n and z of the point at s: e1 and e2 (wind.c). Returns the speed across the cable, m/s. */
double hawser__flow_axes(double axis[2][2], const struct hawser_statics *st, double s,
                         const struct hawser_wind *wind);
void hawser__flow_points_clear(struct hawser__flow_points *flow);

/* D [n][n] += the linear damping by the flow, scaled. It is not symmetric. */
void hawser__flow_damping(double *D, const struct hawser__flow_points *flow);
/* The same of the wind of the scene, which the caller frees; NULL: it has none. *failed: 1 if memory is
 * short. */
double *hawser__wind_damping(int *failed, const struct hawser_modes *modes,
                             const struct hawser_scene *scene);

#endif
