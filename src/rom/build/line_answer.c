/* rom/build/line_answer.c - what the modes that a model of a rope over sheaves does not keep do under
 * its load (ropeway/expand/expand_answer.c), at the shape points and along the line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/energy/kernel.h"
#include "rom/condense/known.h"
#include "rom/build/line.h"

enum { ORDERS = 2 }; /* static response, first correction for inertia */
_Static_assert((int)HAWSER__LEXPAND_MORE >= (int)HAWSER__LOAD_FIELDS,
               "room for the fields among the shapes");

struct target {
	struct hawser_rom *rom;
	const struct hawser__lexpand *t;
};

/* Displacement and strain of a field at the shape points, [points][4], and strain on the line. */
static void note(double *shape, double *line, const struct target *to,
                 const struct hawser__lexpand_field *field, double factor)
{
	struct hawser__line_place at;
	double slope[3], u[3];
	int next = 0;

	for (int p = 0; p < to->rom->shapes.points; p++, shape += 4) {
		at = hawser__line_shape_place(to->rom, to->t->rope, p);
		hawser__lexpand_field_at(shape, slope, to->t->rope, field, at.piece, at.s, at.angle);
		shape[3] = slope[0];
		for (int c = 0; c < 4; c++)
			shape[c] *= factor;
	}
	while (hawser__line_next_place(&at, &next, to->t)) {
		hawser__lexpand_field_at(u, slope, to->t->rope, field, at.piece, at.s, 0.0);
		*line++ = factor*slope[0];
	}
}

static enum hawser_status set_harmonic(const struct target *to, struct hawser_harmonic *h,
                                       const struct hawser__lexpand_answer *answer, double factor,
                                       struct hawser_report *report)
{
	size_t points = 4*(size_t)to->rom->shapes.points, line = (size_t)to->rom->line.points;

	h->answer = calloc(ORDERS*points + 1, sizeof *h->answer);
	h->answer_line = calloc(ORDERS*line + 1, sizeof *h->answer_line);
	if (!h->answer || !h->answer_line)
		return hawser__no_memory(report, "line rom");
	for (size_t i = 0; i < ORDERS; i++)
		note(h->answer + i*points, h->answer_line + i*line, to, &answer->field[i], factor);
	return HAWSER_OK;
}

/* The motions of harmonic h are the known ones from `first` on. */
static enum hawser_status set_known(const struct target *to, struct hawser_harmonic *h, int first,
                                    const struct hawser__lexpand_answer *answer, double factor,
                                    double ratio, struct hawser_report *report)
{
	struct hawser_rom_known *known = &to->rom->known;
	size_t points = 4*(size_t)to->rom->shapes.points, line = (size_t)to->rom->line.points;

	if (known->modes == 0)
		return HAWSER_OK;
	h->known = calloc((size_t)known->modes, sizeof *h->known);
	if (!h->known)
		return hawser__no_memory(report, "line rom");
	for (int s = 0; s < answer->known; s++) {
		size_t at = (size_t)(first + s);

		known->K[at] = answer->omega2[s];
		known->D[at] = 2.0*ratio*sqrt(answer->omega2[s]);
		h->known[at] = factor*answer->force[s];
		note(known->shape + at*points, known->line + at*line, to, &answer->field[2 + s], 1.0);
	}
	return HAWSER_OK;
}

/* --- the answers --- */

/* The static part in the systems of the rope that it moves, as shapes, while there is room. */
static void add_fields(struct hawser__line_answers *answers, struct hawser__lexpand_modes *own, int i)
{
	const struct hawser__lexpand_field *z = &answers->answer[i].field[0];
	const double *x = z->x, *strain = z->strain;

	for (int k = 0; k < own->rope.systems; k++) {
		const struct hawser__lmode_system *system = &own->rope.system[k];
		int moved = system->strains > 0 &&
		            strain[cblas_idamax(system->strains, strain, 1)] != 0.0;

		if (moved && answers->fields < HAWSER__LOAD_FIELDS) {
			own->shape[own->search.n + answers->fields] =
				(struct hawser__lexpand_shape){.system = k, .x = x, .strain = strain};
			answers->field[answers->fields++] =
				(struct hawser__line_field){i/2 + 1, i%2, answers->factor};
		}
		x += system->size;
		strain += system->strains;
	}
}

enum hawser_status hawser__line_answers_make(struct hawser__line_answers *answers,
                                             struct hawser__lexpand_modes *own,
                                             const struct hawser_line_modes *modes,
                                             const struct hawser_line_rom_options *o,
                                             struct hawser_report *report)
{
	int passing = o->load == HAWSER_LINE_LOAD_PASSING, count = passing ? 2*o->harmonics : 1;
	enum hawser_status status = HAWSER_OK;

	if (o->load == HAWSER_LINE_LOAD_NONE)
		return HAWSER_OK;
	answers->factor = passing ? 1.0 : o->amplitude/modes->length_unit;
	answers->answer = calloc((size_t)count, sizeof *answers->answer);
	if (!answers->answer)
		return hawser__no_memory(report, "line rom");
	while (answers->count < count && !status) {
		int i = answers->count++;
		struct hawser__line_wave wave = passing ? hawser__line_wave(modes, o, i)
		                                        : (struct hawser__line_wave){.sine = 0};

		status = hawser__lexpand_answer(&answers->answer[i], own, passing ? hawser__line_pull : NULL,
		                                &wave, o->lane, report);
	}
	for (int i = 0; i < count && !status; i++)
		add_fields(answers, own, i);
	return status;
}

void hawser__line_answers_clear(struct hawser__line_answers *answers)
{
	for (int i = 0; i < answers->count; i++)
		hawser__lexpand_answer_clear(&answers->answer[i]);
	free(answers->answer);
	*answers = (struct hawser__line_answers){.count = 0};
}

enum hawser_status hawser__line_answers_set(struct hawser_rom *rom, const struct hawser__lexpand *t,
                                            const struct hawser__line_answers *answers,
                                            const struct hawser_line_rom_options *o,
                                            struct hawser_report *report)
{
	const struct target to = {rom, t};
	double factor = answers->factor, reach = INFINITY;
	enum hawser_status status = HAWSER_OK;
	int all = 0;

	for (int i = 0; i < answers->count; i++) {
		all += answers->answer[i].known;
		reach = fmin(reach, answers->answer[i].reach);
	}
	if (answers->count > 0)
		status = hawser__rom_known_make(rom, all, report);
	all = 0;
	for (int i = 0; i < answers->count && !status; i++) {
		const struct hawser__lexpand_answer *answer = &answers->answer[i];

		status = set_harmonic(&to, &rom->harmonic[i], answer, factor, report);
		if (!status)
			status = set_known(&to, &rom->harmonic[i], all, answer, factor, o->ratio, report);
		all += answer->known;
	}
	if (!status && answers->count > 0)
		rom->known.reach = reach;
	return status;
}
