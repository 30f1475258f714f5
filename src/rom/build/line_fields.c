/* rom/build/line_fields.c - terms of the energy that contain the static response to the load of the
 * modes that a model of a rope over sheaves does not keep (rom/condense/fields.h).
 *
 * The response Z to a wave of the load, or to a unit motion of the end (ropeway/expand/expand_drive.c),
 * is one more shape of the expansion, as psi and z of a span are. Its terms of degree 2 vanish, and
 * the stiffness by T_jkZ is in line_load.c. Displacements and tensions have its products with itself
 * and with the coordinates as those of a span have the products of moving ends (rom/terms/ends.h).
 * Where the slopes of all fields change the tension by less than HAWSER__FAINT_FIELD, this is left
 * out, as in rom/condense/load_fields.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/condense/fields.h"
#include "rom/terms/ends.h"
#include "rom/build/line.h"

/* Change of the tension by the slopes of a shape, relative, if they stretched its system alone. */
static double tightens(const struct hawser__lexpand *t, int shape)
{
	const double *slope = t->slope + 3*(size_t)t->points*(size_t)shape;
	const struct hawser__lmode_system *system = &t->rope->system[t->shape[shape].system];
	double longer = 0.0, stretch = 0.0;

	for (int i = 0; i < system->segments; i++) {
		const struct hawser__lmode_segment *s = &system->segment[i];
		int first = t->first[s->index];

		for (int p = first; first >= 0 && p < first + s->grid.points; p++) {
			const double *a = slope + 3*p;

			longer += 0.5*t->weight[p]*(a[1]*a[1] + a[2]*a[2])/t->stretch[p];
			stretch += t->weight[p]*t->tau[p]*t->rope->epsilon;
		}
	}
	return stretch > 0.0 ? longer/stretch : 0.0;
}

/* Slopes across the rope of field i at the shape points and on the line; the strain along the rope is
 * in `answer` of the harmonics. */
static void note_slopes(struct hawser_rom *rom, const struct hawser__lexpand *t, int i)
{
	double *slope = rom->ends->slope + 3*(size_t)i*(size_t)rom->shapes.points;
	double *line = rom->ends->line + 3*(size_t)i*(size_t)rom->line.points, u[3];
	struct hawser__line_place at;
	int next = 0;

	for (int p = 0; p < rom->shapes.points; p++, slope += 3) {
		at = hawser__line_shape_place(rom, t->rope, p);
		hawser__lexpand_shape_at(u, slope, t, rom->n + i, at.piece, at.s, 0.0);
		slope[0] = 0.0;
	}
	for (; hawser__line_next_place(&at, &next, t); line += 3) {
		hawser__lexpand_shape_at(u, line, t, rom->n + i, at.piece, at.s, 0.0);
		line[0] = 0.0;
	}
}

enum hawser_status hawser__line_fields(struct hawser_rom *rom, const struct hawser__lexpand *t,
                                       const struct hawser__line_answers *answers,
                                       struct hawser_report *report)
{
	struct hawser__fields fields = {.size = rom->n, .moving = rom->n, .count = answers->fields};
	struct hawser_rom tensors = {.n = rom->n};
	enum hawser_status status;
	int matter = 0;

	for (int i = 0; i < fields.count; i++) {
		const struct hawser__line_field *field = &answers->field[i];

		matter |= field->factor*field->factor*tightens(t, rom->n + i) >= HAWSER__FAINT_FIELD;
		*(field->sine ? &fields.signal[i].s[field->k] : &fields.signal[i].c[field->k]) = field->factor;
	}
	if (!matter)
		return HAWSER_OK;
	status = hawser__line_tensors(&tensors, t, t->n, rom->n, report);
	if (!status)
		status = hawser__fields_sort(&fields, &tensors, report);
	if (!status)
		status = hawser__fields_spread(rom, &fields, report);
	if (!status)
		status = hawser__ends_move(rom, fields.signal, fields.count, 1, report);
	for (int i = 0; i < fields.count && !status; i++)
		note_slopes(rom, t, i);
	if (!status)
		hawser__line_second(rom->ends->second_shape, rom->ends->second_slope,
		                    rom->ends->second_line, rom, t, rom->n*(rom->n + 1)/2,
		                    (int)hawser__ends_pairs(rom->ends));
	free(tensors.Q);
	free(tensors.C);
	hawser__fields_clear(&fields);
	return status;
}
