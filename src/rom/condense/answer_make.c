/* rom/condense/answer_make.c - response of the condensed modes to the forces of a model.
 *
 *    f     a force of the model, distributed along the cable: the load, or the force of a changing
 *          travel speed (travel.c)
 *    z_0   static displacement of the condensed modes by f (follow.h)
 *    z_1   their static displacement by z_0 as a force (the mass per length is 1; point masses add
 *          forces at their points)
 *
 * At the frequency W of the force the response of a condensed mode s is f_s/(omega_s^2 - W^2), so
 * that the response of all of them is z_0 + W^2 z_1 + O((W/omega_s)^4): stiffness, and first-order
 * inertia. No condensed mode has to be computed. Their damping, a fraction 2 zeta W/omega_s, is
 * neglected.
 *
 * Of the strains of z only a changes the tension to first order. b and c change it in products with
 * the strains of the kept modes. In a nearly inextensible cable, the displacement that these
 * products cause cancels most of that change. As z does not contain that displacement, b and c
 * would add spurious tension.
 *
 * The displacement z_0 results from its strains by integration along the cable, in global axes, on
 * the grid of the modes; elements are divided where a load begins and ends, and at forces at points.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/grid.h"
#include "modes/label.h"
#include "rom/condense/answer.h"
#include "rom/build/build.h"
#include "rom/build/model.h"
#include "rom/condense/follow.h"
#include "rom/energy/kernel.h"
#include "rom/condense/support.h"
#include "rom/terms/travel.h"
#include "statics/frame.h"

enum { ORDERS = 2 }; /* z_0 and z_1 */

struct work {
	const struct hawser_rom *rom;
	struct hawser__stations stations;
	struct hawser_grid grid; /* its points are the stations */
	struct hawser__reference reference;
	double *global, *along;  /* [3][stations] */
	double *shape, *line;    /* [ORDERS][points][4] and [ORDERS][line points] of the last force */
};

static void work_clear(struct work *work)
{
	hawser__stations_clear(&work->stations);
	hawser__grid_clear(&work->grid);
	hawser__reference_clear(&work->reference);
	free(work->global);
	free(work->along);
	free(work->shape);
	free(work->line);
}

/* The stations, divided at cut [cuts], and a grid of them. */
static enum hawser_status work_make(struct work *work, const struct hawser_modes *modes, int moving,
                                    const double *cut, int cuts, struct hawser_report *report)
{
	enum hawser_status status = hawser__stations_make(&work->stations, modes, moving, cut, cuts,
	                                                  report);
	size_t count = (size_t)work->stations.count;

	if (!status)
		status = hawser__grid_init(&work->grid, work->stations.parts, modes->grid.order,
		                           work->stations.edge, NULL, report);
	if (!status)
		status = hawser__reference_init(&work->reference, &work->grid, work->grid.order - 1,
		                                report);
	if (status)
		return status;
	work->global = malloc(3*count*sizeof *work->global);
	work->along = malloc(3*count*sizeof *work->along);
	work->shape = malloc((HAWSER__ANSWER(work->rom) + 1)*sizeof *work->shape);
	work->line = malloc((HAWSER__ANSWER_LINE(work->rom) + 1)*sizeof *work->line);
	return work->global && work->along && work->shape && work->line ? HAWSER_OK
	       : hawser__no_memory(report, "rom");
}

/* along = displacement of z. */
static void integrate(struct work *work)
{
	hawser__displacement(work->along, &work->grid, &work->reference, &work->stations.modes->statics,
	                     work->stations.z, work->stations.start, work->global);
}

/* Displacement and strain of z at the shape points, strain on the line; along is the displacement. */
static void note(struct work *work, int order)
{
	const struct hawser_rom_shapes *shapes = &work->rom->shapes;
	const struct hawser_rom_line *line = &work->rom->line;

	for (int p = 0; p < shapes->points; p++) {
		double *out = work->shape + 4*((size_t)order*(size_t)shapes->points + (size_t)p);

		hawser__displaced_at(out, work->rom, &work->stations.modes->statics, &work->grid, work->along,
		                  work->stations.stroke, p);
		hawser__grid_at(out + 3, &work->grid, work->stations.z, 3, 1, shapes->s[p]);
	}
	for (int p = 0; p < line->points; p++)
		hawser__grid_at(work->line + (size_t)order*(size_t)line->points + (size_t)p,
		                &work->grid, work->stations.z, 3, 1, line->s[p]);
}

/* Add to the running integral of component `axis` of a displacement, which is in work->global, the
 * point masses times it, and to the forces on strokes those of absorbers. */
static void add_masses(struct work *work, double *along, double *beyond, int axis)
{
	const struct hawser_statics *st = &work->stations.modes->statics;

	for (int i = 0; i < hawser__points(st); i++) {
		struct hawser__point point = hawser__point(st, i);
		double u, force, own = hawser__point_absorber(st, i);

		hawser__grid_at(&u, &work->grid, work->global, 1, 1, point.s);
		force = point.m*u;
		if (own > 0.0) {
			double a = st->attached[i].absorber_axis[axis], moved = a*work->stations.stroke[i];

			force += own*moved;
			work->stations.load[i] += own*a*(u + moved);
		}
		for (int p = 0; p < work->stations.count; p++)
			if (work->stations.s[p] > point.s)
				along[p] += force;
		*beyond += force;
	}
}

/* p of the force per length in `along`. Its work on a displacement is that of minus its running
 * integral on the derivative, and of the whole force on the displacement of end B. `masses`: point
 * masses count as well; `point` [hawser__points][3]: further forces at these points, `stroke`
 * [attachments]: on the strokes of absorbers, or NULL. */
static void pull_of(struct work *work, int masses, const double *point, const double *stroke)
{
	const struct hawser_statics *st = &work->stations.modes->statics;
	int count = work->stations.count;

	for (int i = 0; i < st->attachments; i++)
		work->stations.load[i] = stroke ? stroke[i] : 0.0;

	for (int axis = 0; axis < 3; axis++) {
		memcpy(work->global, work->along + axis*count, (size_t)count*sizeof(double));
		work->stations.beyond[axis] = hawser__grid_running(work->along + axis*count, &work->grid,
		                                                   &work->reference, work->global);
		if (masses)
			add_masses(work, work->along + axis*count, &work->stations.beyond[axis], axis);
		for (int i = 0; point && i < hawser__points(st); i++) {
			work->stations.beyond[axis] += point[3*i + axis];
			for (int p = 0; p < count; p++)
				if (work->stations.s[p] > hawser__point(st, i).s)
					work->along[axis*count + p] += point[3*i + axis];
		}
	}
	for (int i = 0; i < count; i++) {
		struct hawser_frame_point at = hawser_statics_frame(st, work->stations.s[i]);
		double global[3];

		for (int axis = 0; axis < 3; axis++)
			global[axis] = -work->along[axis*count + i];
		hawser__frame_in(work->stations.p + 3*(size_t)i, &at, global);
	}
}

/* The responses to the force p of the stations: the displacement z_0 is the force that causes z_1. */
static void solve(struct work *work)
{

	for (int order = 0; order < ORDERS; order++) {
		hawser__follow(&work->stations);
		integrate(work);
		note(work, order);
		if (order + 1 == ORDERS)
			break;
		pull_of(work, 1, NULL, NULL);
	}
}

/* *to [count] += factor * from; *to is allocated if NULL. Returns whether memory sufficed. */
static int add(double **to, double factor, const double *from, size_t count)
{
	if (!*to && factor != 0.0)
		*to = calloc(count + 1, sizeof **to);
	for (size_t i = 0; *to && factor != 0.0 && i < count; i++)
		(*to)[i] += factor*from[i];
	return factor == 0.0 || *to;
}

static int add_harmonic(struct hawser_harmonic *h, double factor, const struct work *work)
{
	return add(&h->answer, factor, work->shape, HAWSER__ANSWER(work->rom)) &&
	       add(&h->answer_line, factor, work->line, HAWSER__ANSWER_LINE(work->rom));
}

/* The static response only, which is stored first. */
static int add_term(struct hawser_ramp_term *term, double factor, const struct work *work)
{
	return add(&term->answer, factor, work->shape, HAWSER__ANSWER(work->rom)/ORDERS) &&
	       add(&term->answer_line, factor, work->line, HAWSER__ANSWER_LINE(work->rom)/ORDERS);
}

static enum hawser_status answer_load(struct hawser_rom *rom, const struct hawser_modes *modes,
                                      int moving, const struct hawser_scene *scene,
                                      struct hawser_report *report)
{
	struct hawser__loads loads;
	struct work work = {.rom = rom};
	enum hawser_status status = hawser__loads_make(&loads, &modes->statics, scene, report);

	if (!status)
		status = work_make(&work, modes, moving, loads.cut, loads.cuts, report);
	for (int h = 0; !status && h < loads.harmonics; h++) {
		memset(work.stations.load, 0, sizeof work.stations.load);
		hawser__load_pull(&work.stations, &loads, h);
		solve(&work);
		status = add_harmonic(&rom->harmonic[h], 1.0, &work) ? HAWSER_OK
		         : hawser__no_memory(report, "rom");
	}
	work_clear(&work);
	hawser__loads_clear(&loads);
	return status;
}

/* The last three harmonics and the ramp, whose terms travel.c made. */
static int share_speed(struct hawser_rom *rom, const struct hawser_modes *modes,
                       const struct hawser_scene *scene, const struct work *work, int squared)
{
	double nu = modes->statics.motion.nu, V = modes->statics.motion.swing, change;
	int good = 1;

	if (V > 0.0) {
		struct hawser_harmonic *h = rom->harmonic + rom->harmonics - 3;

		good = squared ? add_harmonic(&h[0], 2.0*nu*V, work) &&
		                 add_harmonic(&h[2], -0.5*V*V, work)
		       : add_harmonic(&h[1], -V, work);
	}
	if (good && rom->ramp) {
		struct hawser_ramp_term *term = rom->ramp->term;

		change = hawser__travel_change(modes, scene);
		good = squared ? add_term(&term[HAWSER_RAMP_LINEAR], 2.0*nu*change, work) &&
		                 add_term(&term[HAWSER_RAMP_SQUARE], change*change, work)
		       : add_term(&term[HAWSER_RAMP_RATE], -change, work);
	}
	return good;
}

static enum hawser_status answer_speed(struct hawser_rom *rom, const struct hawser_modes *modes,
                                       int moving, const struct hawser_scene *scene,
                                       struct hawser_report *report)
{
	struct work work = {.rom = rom};
	enum hawser_status status = work_make(&work, modes, moving, NULL, 0, report);

	for (int squared = 0; !status && squared < 2; squared++) {
		hawser__speed_pull(&work.stations, squared);
		solve(&work);
		if (!share_speed(rom, modes, scene, &work, squared))
			status = hawser__no_memory(report, "rom");
	}
	work_clear(&work);
	return status;
}

enum hawser_status hawser__rom_answers(struct hawser_rom *rom, const struct hawser_modes *modes,
                                       int moving, const struct hawser_scene *scene,
                                       struct hawser_report *report)
{
	enum hawser_status status = hawser__loaded(scene) ? answer_load(rom, modes, moving, scene, report)
	                            : HAWSER_OK;

	if (!status && (rom->ramp || modes->statics.motion.swing > 0.0))
		status = answer_speed(rom, modes, moving, scene, report);
	return status;
}

enum hawser_status hawser__rom_answer_field(struct hawser_rom *rom, int harmonic,
                                            const struct hawser_modes *modes, int moving,
                                            const double *field, const double *point,
                                            const double *stroke, struct hawser_report *report)
{
	size_t n2 = (size_t)rom->n*(size_t)rom->n;
	struct hawser_harmonic *h = &rom->harmonic[harmonic];
	struct work work = {.rom = rom};
	enum hawser_status status = work_make(&work, modes, modes->n, NULL, 0, report);
	double *T = malloc(n2*sizeof *T);

	if (!status && !T)
		status = hawser__no_memory(report, "rom");
	if (!status) {
		memcpy(work.along, field, 3*(size_t)work.stations.count*sizeof *field);
		pull_of(&work, 0, point, stroke);
		solve(&work);
		status = add_harmonic(h, 1.0, &work) ? HAWSER_OK : hawser__no_memory(report, "rom");
	}
	if (!status) {
		hawser__stations_clear(&work.stations);
		status = hawser__stations_make(&work.stations, modes, moving, NULL, 0, report);
	}
	if (!status) {
		memcpy(work.along, field, 3*(size_t)work.stations.count*sizeof *field);
		pull_of(&work, 0, point, stroke);
		hawser__follow(&work.stations);
		if (hawser__follow_stiffness(T, &work.stations)) {
			/* second-order shapes respond to the force as coordinates: their part of z counts
			 * twice otherwise */
			hawser__rom_held(T, rom, h->f, -1.0);
			h->K = T;
			T = NULL;
		}
	}
	work_clear(&work);
	free(T);
	return status;
}

/* --- inertia of what follows a change of speed --- */

/* T [n][n] of z_1 (follow.h). */
static void lag(double *T, struct work *work, int squared)
{
	hawser__speed_pull(&work->stations, squared);
	hawser__follow(&work->stations);
	integrate(work);
	pull_of(work, 1, NULL, NULL);
	hawser__follow(&work->stations);
	(void)hawser__follow_stiffness(T, &work->stations);
}

enum hawser_status hawser__rom_travel_lag(struct hawser_rom *rom, const struct hawser_modes *modes,
                                          struct hawser_report *report)
{
	const double nu = modes->statics.motion.nu, V = modes->statics.motion.swing;
	/* travel.c, times k^2 */
	const double factor[] = {2.0*nu*V, -V, -2.0*V*V};
	size_t n2 = (size_t)rom->n*(size_t)rom->n;
	struct work work = {.rom = rom};
	enum hawser_status status;

	if (V == 0.0)
		return HAWSER_OK;
	status = work_make(&work, modes, modes->n, NULL, 0, report);
	for (int i = 0; !status && i < 3; i++) {
		struct hawser_harmonic *h = hawser__rom_harmonic(rom, i == 2 ? 2 : 1, i == 0 ? HAWSER_SIN
		                                                                             : HAWSER_COS);

		if (h)
			h->K = hawser__numbers(n2, 1);
		if (!h || !h->K) {
			status = hawser__no_memory(report, "rom");
			break;
		}
		h->omega_power = i == 1 ? 3 : 2;
		lag(h->K, &work, i != 1);
		cblas_dscal((int)n2, factor[i], h->K, 1);
	}
	work_clear(&work);
	return status;
}
