/* rom/terms/drag.c - quadratic drag of air at rest, and the exact force of a wind.
 *
 *   c      kg/m^2: force per unstretched length over the square of the velocity; density, drag
 *          coefficient and diameter of the cable multiplied, over 2
 *   v(s)   velocity normal to the static cable: sum of u_k' (Q_k, B_k), in two components
 *   force  -c |v| v per length; that along the cable, the friction of the surface, is some hundredths
 *          of it and is left out (Morison's formula)
 *
 *   F_j = -c' integral of |v| (v . Phi_j) ds,   c' = c d/rho   (scaled)
 *
 * This is a flow of speed 0 (modes/complex/wind.c), and what a wind adds to the force on the cable at
 * rest is summed by the same routine.
 *
 * In a cos(omega tau) of mode j alone it does the work of the linear damping
 * d = 8/(3 pi) c'' omega a, c'' = c' integral of |Phi_j|^3 ds (the describing function). At
 * resonance under the load f, with the linear damping d0 besides, (d0 + d) omega a = |f|, whose
 * positive root is the amplitude a.
 *
 * The integral is a sum over the Gauss points of the modes. |v| v has a continuous first derivative but
 * no second one where v changes its sign, so that the sum is not exact: its relative error is some 5e-4
 * if six modes move at random, and 1e-14 if the velocity has one sign (tests/property/test-drag). The
 * velocity of modes that are not kept is left out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/file/plug.h"
#include "rom/terms/drag.h"
#include "rom/condense/support.h"
#include "rom/energy/kernel.h"

enum { POINTS = 32, STATES = 32 }; /* that are evaluated together, on the stack */

/* A steady wind w adds c w^2 to the load, and to first order opposes motion by 2 c w v along itself and
 * c w v across: not the drag of air at rest. The vertical part of the load is taken for a weight. */
static enum hawser_status wind(const struct hawser_scene *scene, struct hawser_report *report)
{
	const double *p = scene->static_load.per_length, c = scene->damping.drag;
	double q = scene->static_load.present ? hypot(p[0], p[2]) : 0.0;

	if (q == 0.0)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
	                    "damping.drag = %g kg/m^2 is for air at rest, and the horizontal part of "
	                    "load.static.per_length, %g N/m, is a wind, whose damping is linear: give "
	                    "damping.alpha in place of damping.drag, from %.3g kg/m/s (across a wind of "
	                    "this force and drag) to %.3g kg/m/s (along it)", c, q, sqrt(c*q),
	                    2.0*sqrt(c*q));
}

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
	return wind(scene, report);
}

int hawser__drag_alone(const struct hawser_scene *scene)
{
	if (!(scene->damping.drag > 0.0))
		return 0;
	switch (scene->damping.kind) {
	case HAWSER_DAMPING_ALPHA:
		return scene->damping.alpha == 0.0;
	case HAWSER_DAMPING_RAYLEIGH:
		return scene->damping.mass == 0.0 && scene->damping.stiffness == 0.0;
	case HAWSER_DAMPING_RATIO:
		return (scene->damping.ratios > 1 ? scene->damping.ratio_next[scene->damping.ratios - 2]
		                                  : scene->damping.ratio) == 0.0;
	default:
		return 1;
	}
}

double hawser__drag_equal(const struct hawser_modes *modes, const struct hawser_scene *scene, int j,
                          double load, double damping)
{
	const struct hawser_grid *grid = &modes->grid;
	double cubed = 0.0, q;

	if (!(scene->damping.drag > 0.0) || load == 0.0)
		return damping;
	for (int i = 0; i < grid->points; i++) {
		double at[3];

		hawser_modes_at(modes, at, NULL, j, grid->s[i]);
		cubed += grid->weight[i]*pow(hypot(at[1], at[2]), 3.0);
	}
	q = 8.0/(3.0*M_PI)*scene->damping.drag*modes->statics.span.d/modes->statics.span.rho*cubed;
	return 0.5*(damping + sqrt(damping*damping + 4.0*q*fabs(load)));
}

enum hawser_status hawser__drag_make(struct hawser_rom *rom, const struct hawser_modes *modes,
                                     const struct hawser_scene *scene, struct hawser_report *report)
{
	struct hawser__flow_points flow = {.n = 0};
	enum hawser_status status;
	int wind = scene && scene->wind.present && scene->wind.form == HAWSER_WIND_EXACT;

	if (!scene || (!wind && !(scene->damping.drag > 0.0)))
		return HAWSER_OK;
	status = wind ? HAWSER_OK : check(scene, report);
	if (status)
		return status;
	if (!hawser__flow_points(&flow, modes, scene)) {
		hawser__flow_points_clear(&flow);
		return hawser__no_memory(report, "rom");
	}
	if (!wind)
		*flow.section = (struct hawser__section){
			.half = scene->damping.drag, .drag = {.powers = 1, .power = {1.0}}, .lift = {.powers = 1}};
	return hawser__drag_take(rom, &flow, scene->wind.speed, report);
}

enum hawser_status hawser__drag_take(struct hawser_rom *rom, struct hawser__flow_points *flow,
                                     double wind, struct hawser_report *report)
{
	static const double rest[2] = {0.0};
	struct hawser_rom_drag *drag = rom->drag = calloc(1, sizeof *drag);

	if (!drag) {
		hawser__flow_points_clear(flow);
		return hawser__no_memory(report, "rom");
	}
	drag->flow = *flow;
	drag->wind = wind;
	drag->still = hawser__hold(&drag->flow.hold, (size_t)drag->flow.points + 1, 2*sizeof(double));
	if (!drag->still)
		return hawser__no_memory(report, "rom");
	for (int i = 0; i < flow->points; i++)
		hawser__section_force(drag->still + 2*i, NULL, flow->at[i], flow->speed[i], rest);
	return HAWSER_OK;
}

void hawser__drag_free(struct hawser_rom_drag *drag)
{
	if (!drag)
		return;
	hawser__flow_points_clear(&drag->flow);
	free(drag);
}

int hawser__drag_smooth(const struct hawser_rom_drag *drag)
{
	int i = 0;

	while (i < drag->flow.points && drag->flow.speed[i] > 0.0)
		i++;
	return i == drag->flow.points;
}

int hawser__drag_rough(const struct hawser_rom *rom)
{
	return rom->drag ? !hawser__drag_smooth(rom->drag) : rom->plug && rom->plug->water;
}

/* Of the points from `first` on, at states. */
static void add_flow(const struct hawser_rom_drag *drag, double *force, double *matrix, double sign,
                       const double *v, int states, int first, int points)
{
	const struct hawser__flow_points *flow = &drag->flow;
	int n = flow->n, rows = 2*points;
	const double *shape = flow->shape + (size_t)2*first*n;
	double at[2*POINTS*STATES], slope[2*POINTS*HAWSER_ROM_MOST];

	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, states, rows, n, 1.0, v, n, shape, n, 0.0,
	            at, rows);
	for (int r = 0; r < states; r++) {
		for (int i = 0; i < points; i++) {
			double f[2], by_v[2][2], w = flow->weight[first + i], *own = at + (size_t)r*rows + 2*i;

			hawser__section_force(f, matrix ? by_v : NULL, flow->at[first + i],
			                      flow->speed[first + i], own);
			for (int c = 0; c < 2; c++) {
				const double *along = shape + (size_t)2*i*n, *across = along + n;

				own[c] = w*(f[c] - drag->still[2*(first + i) + c]);
				for (int k = 0; matrix && k < n; k++)
					slope[(2*i + c)*n + k] = w*(by_v[c][0]*along[k] + by_v[c][1]*across[k]);
			}
		}
		if (matrix)
			cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, n, n, rows, -sign, shape, n, slope,
			            n, 1.0, matrix + (size_t)r*n*n, n);
	}
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, states, n, rows, 1.0, at, rows, shape, n,
	            1.0, force, n);
}

void hawser__drag_add(const struct hawser_rom_drag *drag, double *force, double *matrix, double sign,
                      const double *v, int count)
{
	int points = drag->flow.points;
	size_t n = (size_t)drag->flow.n;

	for (int first = 0; first < points; first += POINTS)
		for (int r = 0; r < count; r += STATES)
			add_flow(drag, force + r*n, matrix ? matrix + r*n*n : NULL, sign, v + r*n,
			           count - r < STATES ? count - r : STATES, first,
			           points - first < POINTS ? points - first : POINTS);
}

void hawser__drag_form(const struct hawser_rom_drag *drag, double complex *out,
                       const double complex *const v[], int count)
{
	static const double orders[2][4] = {{2.0, 1.0, 2.0}, {6.0, 2.0, 2.0, 6.0}};
	const struct hawser__flow_points *flow = &drag->flow;
	int n = flow->n;

	for (int i = 0; i < flow->points; i++) {
		const double *shape = flow->shape + (size_t)2*i*n;
		double series[2][HAWSER__WIND_TERMS];
		double complex at[3][2] = {{0.0}}, f[2] = {0.0};

		hawser__section_series(series, flow->at[i], flow->speed[i]);
		for (int k = 0; k < count*2*n; k++)
			at[k/(2*n)][k/n%2] += shape[k%(2*n)]*v[k/(2*n)][k%n];
		for (int place = 0; place < 1 << count; place++) { /* bit c: vector c is across */
			int across = hawser__wind_across(place);
			double complex product = flow->weight[i]*orders[count - 2][across];

			for (int c = 0; c < count; c++)
				product *= at[c][place >> c & 1];
			for (int c = 0; c < 2; c++)
				f[c] += series[c][hawser__wind_term(count, across)]*product;
		}
		for (int j = 0; j < n; j++)
			out[j] += f[0]*shape[j] + f[1]*shape[n + j];
	}
}

enum hawser_status hawser__drag_refuse(const struct hawser_rom *rom, const char *what,
                                       struct hawser_report *report)
{
	if (rom && !rom->drag)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
	                    rom && rom->drag->wind > 0.0
	                    ? "%s has no exact force of the wind, which only hawser integrate and hawser "
	                      "frf have: set wind.form=cubic"
	                    : "%s has no quadratic drag, which only hawser integrate and hawser frf have "
	                      "(by shooting): set damping.drag=0, and give a linear damping with the same "
	                      "loss at the amplitude of interest", what);
}
