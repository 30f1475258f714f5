/* modes/complex/wind.c - a flow along a cable with modes.
 *
 *   e1, e2   unit vectors normal to the static cable: along the flow, and upwards across it
 *   w_ij     Phi_j.e_i in m/s per unit of u_j': the mode times d/time unit
 *   f_i      force along e_i on a section that moves at v_i = sum of u_j' w_ij (statics/wind.c)
 *   F_j      d/H integral of f_i w_ij ds over the velocity unit, scaled
 *   D_jk     - d/H integral of w_ij (df_i/dv_l) w_lk ds at rest
 *
 * Local axes e, n, z: with the flow's normal part (0, c, s), e1 = (0, c, s) and e2 = +-(0, s, -c). The
 * motion along the cable does not matter.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "modes/complex/wind.h"
#include "modes/label.h"
#include "statics/frame.h"

/* Without a speed across the cable e1 is n. */
double hawser__flow_axes(double axis[2][2], const struct hawser_statics *st, double s,
                         const struct hawser_wind *wind)
{
	struct hawser_frame_point at = hawser_statics_frame(st, s);
	double blow[3], local[3], up[3], size = 0.0, across;

	hawser_statics_from_global(st, blow, wind->direction);
	hawser__frame_in(local, &at, blow);
	for (int c = 0; c < 3; c++)
		size += blow[c]*blow[c];
	across = hypot(local[1], local[2]);
	axis[0][0] = across > 0.0 ? local[1]/across : 1.0;
	axis[0][1] = across > 0.0 ? local[2]/across : 0.0;
	hawser__frame_out(up, &at, (double[3]){0.0, axis[0][1], -axis[0][0]});
	hawser_statics_to_global(st, up, up);
	axis[1][0] = up[1] < 0.0 ? -axis[0][1] : axis[0][1];
	axis[1][1] = up[1] < 0.0 ? axis[0][0] : -axis[0][0];
	return size > 0.0 ? wind->speed*across/sqrt(size)*hawser__wind_profile(wind, s/st->l) : 0.0;
}

int hawser__flow_points(struct hawser__flow_points *flow, const struct hawser_modes *modes,
                        const struct hawser_scene *scene)
{
	const struct hawser_grid *grid = &modes->grid;
	const struct hawser_statics *st = &modes->statics;
	size_t n = (size_t)modes->n, points = (size_t)grid->points;

	*flow = (struct hawser__flow_points){.n = modes->n, .points = grid->points,
	                                     .unit = st->span.d/modes->time_unit};
	flow->weight = hawser__hold(&flow->hold, points, sizeof(double));
	flow->speed = hawser__hold(&flow->hold, points, sizeof(double));
	flow->shape = hawser__hold(&flow->hold, points*2*n + 1, sizeof(double));
	flow->section = hawser__hold(&flow->hold, 1, sizeof *flow->section);
	flow->at = hawser__hold(&flow->hold, points, sizeof *flow->at);
	if (flow->hold.short_of_memory)
		return 0;
	if (scene->wind.present)
		hawser__section_make(flow->section, &scene->wind);
	for (size_t i = 0; i < points; i++) {
		double axis[2][2];

		flow->at[i] = flow->section;
		flow->speed[i] = hawser__flow_axes(axis, st, grid->s[i], &scene->wind);
		flow->weight[i] = grid->weight[i]*st->span.d/st->H/flow->unit;
		for (size_t j = 0; j < n; j++) {
			const double *at = modes->shape + j*hawser__modes_row(modes) + 3*i;

			for (size_t c = 0; c < 2; c++)
				flow->shape[(2*i + c)*n + j] =
					flow->unit*(axis[c][0]*at[1] + axis[c][1]*at[2]);
		}
	}
	return 1;
}

void hawser__flow_points_clear(struct hawser__flow_points *flow)
{
	hawser__hold_clear(&flow->hold);
}

void hawser__flow_damping(double *D, const struct hawser__flow_points *flow)
{
	static const double rest[2] = {0.0};
	size_t n = (size_t)flow->n;

	for (size_t i = 0; i < (size_t)flow->points; i++) {
		const double *along = flow->shape + 2*i*n, *across = along + n;
		double f[2], by_v[2][2];

		hawser__section_force(f, by_v, flow->at[i], flow->speed[i], rest);
		for (size_t j = 0; j < n; j++) {
			double first = flow->weight[i]*(along[j]*by_v[0][0] + across[j]*by_v[1][0]);
			double second = flow->weight[i]*(along[j]*by_v[0][1] + across[j]*by_v[1][1]);

			for (size_t k = 0; k < n; k++)
				D[j*n + k] -= first*along[k] + second*across[k];
		}
	}
}

double *hawser__wind_damping(int *failed, const struct hawser_modes *modes,
                             const struct hawser_scene *scene)
{
	struct hawser__flow_points flow;
	double *D;

	*failed = 0;
	if (!scene || !scene->wind.present)
		return NULL;
	D = hawser__numbers((size_t)modes->n, (size_t)modes->n);
	*failed = !hawser__flow_points(&flow, modes, scene) || !D;
	if (!*failed)
		hawser__flow_damping(D, &flow);
	hawser__flow_points_clear(&flow);
	return D;
}
