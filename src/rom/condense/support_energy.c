/* rom/condense/support_energy.c - terms of the strain energy that contain the motion of the
 * supports, or the static response to the load.
 *
 *    s_x    displacement of end B relative to end A along axis x, a periodic function of the phase; of
 *           a cable with springs, also that of end A
 *    psi_x  the quasi-static displacement that belongs to it (support_shape.c); only its strains count
 *           here
 *    u      coordinates of the model
 *
 * The energy is a function of s and u, and the psi_x are coordinates of it like the modes, with given
 * values. Third and fourth derivatives by all of them come from project.c, with the response of the
 * condensed modes to their products (fields.h). The terms of degree 2 vanish, since
 * psi_x is orthogonal in the stiffness to everything that vanishes at the ends (with springs: together
 * with theirs, which have no terms of higher degree).
 *
 * The static response of the condensed modes to a harmonic of the load (follow.h) is one more such
 * field, with the signal cos(k tau) or sin(k tau): what follows moves with the load, and the tension
 * that it causes acts on the modes. Its terms of degree 2 vanish as well: it is orthogonal in the
 * stiffness to the modes, and along the response to pairs the load does the work that it takes. Its
 * K (s u) is that of condense_load.c and is left out here. Its inertia is neglected.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/condense/condense.h"
#include "modes/grid.h"
#include "modes/label.h"
#include "rom/terms/ends.h"
#include "rom/energy/kernel.h"
#include "rom/condense/fields.h"
#include "rom/energy/project.h"
#include "rom/condense/support.h"

enum { ENDS = 1, LOAD = 2 }; /* fields */

struct work {
	int moving;                           /* modes without shapes */
	int number[HAWSER__SUPPORT_MOST];     /* of the shapes (support.h) of the supports */
	const struct hawser__load_fields *loads; /* the other fields; NULL: no modes are condensed */
	struct hawser__fields fields;
	struct hawser_modes wide;             /* the first `moving` modes, the fields, the other modes */
	struct hawser__condensed condensed;
	struct hawser_rom big;                /* tensors of `wide` */
};

static void work_clear(struct work *work)
{
	hawser__fields_clear(&work->fields);
	hawser__condensed_clear(&work->condensed);
	free(work->big.Q);
	free(work->big.C);
	hawser_modes_clear(&work->wide);
}

/* --- the tensors --- */

static void add_answer(struct work *work, int i)
{
	struct hawser_modes *wide = &work->wide;
	size_t each = 3*(size_t)wide->grid.points, at = (size_t)(work->moving + i);

	i -= work->fields.ends;
	memcpy(wide->slope + at*each, work->loads->strain + (size_t)i*each, each*sizeof(double));
	wide->mode[at] = (struct hawser_mode){.omega = INFINITY, .plane = work->loads->plane[i],
		.symmetry = HAWSER_MIXED};
}

static void add_psi(struct work *work, int i, const struct hawser__support_shapes *shapes)
{
	struct hawser_modes *wide = &work->wide;
	size_t each = 3*(size_t)wide->grid.points, at = (size_t)(work->moving + i);
	int axis = work->number[i]%HAWSER__AXES;

	memcpy(wide->slope + at*each, shapes->strain + (size_t)work->number[i]*each,
	       each*sizeof(double));
	/* infinite: nothing of a response is removed along psi. About mid-span, opposite displacements of
	 * the ends are symmetric along x and antisymmetric along y and z */
	wide->mode[at] = (struct hawser_mode){.omega = INFINITY,
		.plane = axis == 2 ? HAWSER_OUT_OF_PLANE : HAWSER_IN_PLANE,
		.symmetry = axis == 0 ? HAWSER_SYMMETRIC : HAWSER_ANTISYMMETRIC};
}

/* Rows from `first` on, of `rows`, move `by` rows back; zeros take their place. */
static void move_rows(void *array, size_t row, size_t first, size_t rows, size_t by)
{
	char *at = (char *)array + first*row;

	memmove(at + by*row, at, (rows - first)*row);
	memset(at, 0, by*row);
}

static enum hawser_status widen(struct work *work, const struct hawser_modes *modes,
                                const struct hawser__support_shapes *shapes,
                                struct hawser_report *report)
{
	struct hawser_modes *wide = &work->wide;
	size_t each = 3*(size_t)modes->grid.points, n = (size_t)modes->n, m = (size_t)work->fields.count;
	size_t moving = (size_t)work->moving, marks = (size_t)modes->statics.attachments;
	enum hawser_status status;

	if (modes->n + work->fields.count > HAWSER_ROM_MAX)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "%d modes of a cable whose supports move in %d ways: at most %d "
		                    "together are possible, keep fewer modes (model.modes)", modes->n,
		                    work->fields.count, HAWSER_ROM_MAX);
	status = hawser__modes_extend(wide, modes, work->fields.count, report);
	if (status)
		return status;
	move_rows(wide->mode, sizeof *wide->mode, moving, n, m);
	move_rows(wide->slope, each*sizeof *wide->slope, moving, n, m);
	move_rows(wide->shape, each*sizeof *wide->shape, moving, n, m);
	if (wide->stroke)
		move_rows(wide->stroke, marks*sizeof *wide->stroke, moving, n, m);
	for (int i = 0; i < work->fields.ends; i++)
		add_psi(work, i, shapes);
	for (int i = work->fields.ends; i < work->fields.count; i++)
		add_answer(work, i);
	return HAWSER_OK;
}

/* --- the fields --- */

/* The shapes that move. */
static enum hawser_status list_shapes(struct work *work, const struct hawser_modes *modes,
                                      const struct hawser_scene *scene,
                                      struct hawser__support_shapes *shapes,
                                      struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	if (!hawser__support_moves(scene))
		return HAWSER_OK;
	status = hawser__support_shapes_make(shapes, modes, report);
	for (int i = 0; !status && i < shapes->count; i++)
		if (hawser__support_factor(&work->fields.signal[work->fields.count], scene, i, &modes->statics))
			work->number[work->fields.count++] = i;
	work->fields.ends = work->fields.count;
	return status;
}

/* The responses to the load. */
static void list_answers(struct work *work)
{
	const struct hawser__load_fields *loads = work->loads;

	for (int i = 0; i < loads->count; i++, work->fields.count++) {
		work->fields.signal[work->fields.count] = (struct hawser__signal){{0.0}, {0.0}};
		*(loads->sine[i] ? &work->fields.signal[work->fields.count].s[loads->k[i]]
		  : &work->fields.signal[work->fields.count].c[loads->k[i]]) = 1.0;
	}
}

/* The second-order response to the load alone, where no support moves. The strain of the fields along
 * the cable is in `answer` of the harmonics. */
static enum hawser_status condensed_answers(struct hawser_rom *rom, const struct work *work,
                                            struct hawser_report *report)
{
	int points = rom->shapes.points, line = rom->line.points, count = work->fields.count;
	size_t each = 3*(size_t)work->wide.grid.points;
	enum hawser_status status = hawser__ends_move(rom, work->fields.signal, count, 1, report);

	if (status)
		return status;
	for (int i = 0; i < count; i++)
		for (int p = 0; p < points + line; p++) {
			double *slope = p < points ? rom->ends->slope + 3*(i*points + p)
			                : rom->ends->line + 3*(i*line + p - points);

			hawser__grid_at(slope, &work->wide.grid, work->loads->strain + (size_t)i*each, 3, 3,
			                p < points ? rom->shapes.s[p] : rom->line.s[p - points]);
			slope[0] = 0.0;
		}
	return hawser__ends_condensed(rom, &work->wide, &work->condensed, report);
}

/* Terms of some of the fields, of the first `moving` modes. */
static enum hawser_status add_fields(struct hawser_rom *rom, const struct hawser_modes *modes,
                                     int moving, const struct hawser__load_fields *loads, int fields,
                                     const struct hawser_scene *scene, struct hawser_report *report)
{
	struct work work = {.moving = moving, .loads = loads,
	                    .fields = {.size = rom->n, .moving = moving}};
	struct hawser__support_shapes shapes = {.count = 0};
	enum hawser_status status = HAWSER_OK;

	if (fields & ENDS)
		status = list_shapes(&work, modes, scene, &shapes, report);
	/* a table that moves the ends leaves no room for those of the load */
	if (!status && loads && (fields & LOAD) && !hawser__support_given(scene))
		list_answers(&work);
	if (status || work.fields.count == 0) {
		hawser__support_shapes_clear(&shapes);
		work_clear(&work);
		return status;
	}
	status = widen(&work, modes, &shapes, report);
	if (!status && loads)
		status = hawser__condense(&work.condensed, &work.wide, moving + work.fields.count, report);
	if (!status)
		status = hawser__rom_tensors(&work.big, &work.wide, loads ? &work.condensed : NULL,
		                             report);
	if (!status && loads && rom->shapes.second_slope && work.fields.ends > 0)
		status = hawser__ends_condensed(rom, &work.wide, &work.condensed, report);
	if (!status && loads && rom->shapes.second_slope && !rom->ends)
		status = condensed_answers(rom, &work, report);
	if (!status)
		status = hawser__fields_sort(&work.fields, &work.big, report);
	if (!status && hawser__support_given(scene))
		status = hawser__fields_give(rom, &work.fields, work.number, report);
	else if (!status)
		status = hawser__fields_spread(rom, &work.fields, report);
	hawser__support_shapes_clear(&shapes);
	work_clear(&work);
	return status;
}

enum hawser_status hawser__support_energy(struct hawser_rom *rom, const struct hawser_modes *modes,
                                          const struct hawser_modes *kept,
                                          const struct hawser__load_fields *loads,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report)
{
	int together = modes == kept;
	enum hawser_status status = add_fields(rom, modes, kept->n, loads,
	                                       together ? ENDS | LOAD : ENDS, scene, report);

	return status || together ? status
	       : add_fields(rom, kept, kept->n, loads, LOAD, scene, report);
}
