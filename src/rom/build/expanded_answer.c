/* rom/build/expanded_answer.c - what the modes that a model does not keep do under its load: at the
 * shape points and along the line, and as fields of the energy.
 *
 * The response Z to a wave of the load, or to a unit motion of the end (ropeway/expand/expand_drive.c),
 * is one more shape of the expansion, as psi and z of a span are. Its terms of degree 2 vanish, and
 * the stiffness by T_jkZ is in the harmonics of the load. Displacements and tensions have its products
 * with itself and with the coordinates as those of a span have the products of moving ends
 * (rom/terms/ends.h). Where the slopes of all fields change the tension by less than
 * HAWSER__FAINT_FIELD, this is left out, as in rom/condense/load_fields.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/hold.h"
#include "core/report.h"
#include "rom/build/expanded.h"
#include "rom/build/model.h"
#include "rom/condense/known.h"
#include "rom/terms/ends.h"

static int modes_of(const struct hawser_rom *rom)
{
	return rom->n - rom->inertia.shapes;
}

enum { ORDERS = 2 }; /* static response, first correction for inertia */

void hawser__answers_clear(struct hawser__answers *answers)
{
	for (int i = 0; i < answers->count; i++)
		hawser__driven_clear(&answers->driven[i]);
	free(answers->driven);
	*answers = (struct hawser__answers){.count = 0};
}

/* Displacement and strain of a row at the shape points, [points][4], and strain on the line. */
static void note(double *shape, double *line, const struct hawser_rom *rom,
                 const struct hawser__expanded *e, const double *row, double factor)
{
	int points = rom->shapes.points;
	double slope[3], u[3];

	for (int p = 0; p < points; p++, shape += 4) {
		e->field_at(u, slope, e->of, row, p);
		for (int c = 0; c < 3; c++)
			shape[c] = factor*u[c];
		shape[3] = factor*slope[0];
	}
	for (int p = points; p < points + rom->line.points; p++) {
		e->field_at(u, slope, e->of, row, p);
		*line++ = factor*slope[0];
	}
}

/* 0: all modes that the force drives are kept. */
static int answers_at_all(const struct hawser__driven *driven)
{
	for (size_t i = 0; i < driven->width; i++)
		if (driven->field[i] != 0.0)
			return 1;
	return 0;
}

static enum hawser_status set_harmonic(struct hawser_rom *rom, struct hawser_harmonic *h,
                                       const struct hawser__expanded *e,
                                       const struct hawser__driven *driven, double factor,
                                       struct hawser_report *report)
{
	size_t points = 4*(size_t)rom->shapes.points, line = (size_t)rom->line.points;

	if (!answers_at_all(driven))
		return HAWSER_OK;
	h->answer = calloc(ORDERS*points + 1, sizeof *h->answer);
	h->answer_line = calloc(ORDERS*line + 1, sizeof *h->answer_line);
	if (!h->answer || !h->answer_line)
		return hawser__no_memory(report, "line rom");
	for (int i = 0; i < ORDERS; i++)
		note(h->answer + (size_t)i*points, h->answer_line + (size_t)i*line, rom, e,
		     hawser__driven_field(driven, i), factor);
	return HAWSER_OK;
}

/* The motions of harmonic h are the known ones from `first` on. */
static enum hawser_status set_known(struct hawser_rom *rom, struct hawser_harmonic *h, int first,
                                    const struct hawser__expanded *e,
                                    const struct hawser__driven *driven, double factor,
                                    struct hawser_report *report)
{
	struct hawser_rom_known *known = &rom->known;
	size_t points = 4*(size_t)rom->shapes.points, line = (size_t)rom->line.points;

	if (known->modes == 0)
		return HAWSER_OK;
	h->known = calloc((size_t)known->modes, sizeof *h->known);
	if (!h->known)
		return hawser__no_memory(report, "line rom");
	for (int s = 0; s < driven->known; s++) {
		const double *row = hawser__driven_field(driven, 2 + s);
		size_t at = (size_t)(first + s);

		known->K[at] = driven->omega2[s];
		known->D[at] = e->damping(e->of, row, driven->omega2[s]);
		h->known[at] = factor*driven->force[s];
		note(known->shape + at*points, known->line + at*line, rom, e, row, 1.0);
	}
	return HAWSER_OK;
}

enum hawser_status hawser__expanded_answers(struct hawser_rom *rom, const struct hawser__expanded *e,
                                            const struct hawser__answers *answers,
                                            struct hawser_report *report)
{
	double factor = answers->factor, reach = INFINITY;
	enum hawser_status status = HAWSER_OK;
	int all = 0;

	for (int i = 0; i < answers->count; i++) {
		all += answers->driven[i].known;
		if (answers_at_all(&answers->driven[i]))
			reach = fmin(reach, answers->driven[i].reach);
	}
	if (isfinite(reach))
		status = hawser__rom_known_make(rom, all, report);
	all = 0;
	for (int i = 0; i < answers->count && !status; i++) {
		const struct hawser__driven *driven = &answers->driven[i];

		status = set_harmonic(rom, &rom->harmonic[i], e, driven, factor, report);
		if (!status)
			status = set_known(rom, &rom->harmonic[i], all, e, driven, factor, report);
		all += driven->known;
	}
	if (!status && isfinite(reach))
		rom->known.reach = reach;
	return status;
}

/* --- fields --- */

enum hawser_status hawser__expanded_lift(struct hawser_rom *rom, const struct hawser__expanded *e,
                                         const struct hawser__answers *answers, int i,
                                         struct hawser_report *report)
{
	size_t points = 4*(size_t)rom->shapes.points, line = (size_t)rom->line.points;
	struct hawser_harmonic *h = hawser__rom_harmonic(rom, answers->field[i].k, answers->field[i].sine
	                                                 ? HAWSER_SIN : HAWSER_COS);
	double slope[3];

	if (!h)
		return hawser__no_memory(report, "line rom");
	h->f = hawser__numbers((size_t)rom->n, 1); /* 0; a file asks for one */
	h->answer = hawser__numbers(ORDERS, points);
	h->answer_line = hawser__numbers(ORDERS, line);
	h->known = hawser__numbers((size_t)rom->known.modes, 1);
	if (!h->f || !h->answer || !h->answer_line || !h->known)
		return hawser__no_memory(report, "line rom");
	for (int p = 0; p < rom->shapes.points; p++) {
		e->shape_at(h->answer + 4*p, slope, e->of, modes_of(rom) + i, p);
		h->answer[4*p + 3] = slope[0];
	}
	for (int p = 0; p < rom->line.points; p++) {
		double u[3];

		e->shape_at(u, slope, e->of, modes_of(rom) + i, rom->shapes.points + p);
		h->answer_line[p] = slope[0];
	}
	return HAWSER_OK;
}

/* Slopes across the structure of field i at the shape points and on the line; the strain along it is in
 * `answer` of the harmonics. */
static void note_slopes(struct hawser_rom *rom, const struct hawser__expanded *e, int i)
{
	int points = rom->shapes.points;
	double *slope = rom->ends->slope + 3*(size_t)i*(size_t)points;
	double *line = rom->ends->line + 3*(size_t)i*(size_t)rom->line.points, u[3];

	for (int p = 0; p < points + rom->line.points; p++) {
		double *to = p < points ? slope + 3*p : line + 3*(p - points);

		e->shape_at(u, to, e->of, modes_of(rom) + i, p);
		to[0] = 0.0;
	}
}

enum hawser_status hawser__expanded_fields(struct hawser_rom *rom, const struct hawser__expanded *e,
                                           const struct hawser__answers *answers,
                                           struct hawser_report *report)
{
	int modes = modes_of(rom);
	struct hawser__fields fields = {.size = rom->n, .moving = modes, .count = answers->fields,
	                                .ends = answers->ends};
	struct hawser_rom tensors = {.n = modes};
	enum hawser_status status;
	int matter = answers->ends > 0;

	for (int i = 0; i < fields.count; i++) {
		double factor = answers->field[i].factor;
		int k = answers->field[i].k;

		matter |= factor*factor*e->tightens(e->of, modes + i) >= HAWSER__FAINT_FIELD;
		*(answers->field[i].sine ? &fields.signal[i].s[k] : &fields.signal[i].c[k]) = factor;
	}
	if (!matter)
		return HAWSER_OK;
	status = hawser__expanded_tensors(&tensors, e, e->n, modes, report);
	if (!status)
		status = hawser__fields_sort(&fields, &tensors, report);
	if (!status)
		status = hawser__fields_spread(rom, &fields, report);
	if (!status)
		status = hawser__ends_move(rom, fields.signal, fields.count, 1, report);
	for (int i = 0; i < fields.count && !status; i++)
		note_slopes(rom, e, i);
	if (!status)
		hawser__expanded_second(rom->ends->second_shape, rom->ends->second_slope,
		                        rom->ends->second_line, rom, e, modes*(modes + 1)/2,
		                        (int)hawser__ends_pairs(rom->ends));
	free(tensors.Q);
	free(tensors.C);
	hawser__fields_clear(&fields);
	return status;
}
