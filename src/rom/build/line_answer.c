/* rom/build/line_answer.c - what the modes that a model of a rope over sheaves does not keep do under
 * its load (ropeway/expand/expand_answer.c), at the shape points and along the line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/energy/kernel.h"
#include "rom/condense/known.h"
#include "rom/build/line.h"

enum { ORDERS = 2 }; /* static response, first correction for inertia */

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

enum hawser_status hawser__line_answers(struct hawser_rom *rom, const struct hawser__lexpand *t,
                                        const struct hawser__lexpand_modes *own,
                                        const struct hawser_line_modes *modes,
                                        const struct hawser_line_rom_options *o,
                                        struct hawser_report *report)
{
	const struct target to = {rom, t};
	int passing = o->load == HAWSER_LINE_LOAD_PASSING, count = passing ? 2*o->harmonics : 1, all = 0;
	double factor = passing ? 1.0 : o->amplitude/modes->length_unit, reach = INFINITY;
	struct hawser__lexpand_answer *answer = calloc((size_t)count, sizeof *answer);
	enum hawser_status status = answer ? HAWSER_OK : hawser__no_memory(report, "line rom");

	if (o->load == HAWSER_LINE_LOAD_NONE)
		count = 0;
	for (int i = 0; i < count && !status; i++) {
		struct hawser__line_wave wave = passing ? hawser__line_wave(modes, o, i)
		                                        : (struct hawser__line_wave){.sine = 0};

		status = hawser__lexpand_answer(&answer[i], own, passing ? hawser__line_pull : NULL, &wave,
		                                o->lane, report);
		all += answer[i].known;
		reach = fmin(reach, answer[i].reach);
	}
	if (!status && count > 0)
		status = hawser__rom_known_make(rom, all, report);
	all = 0;
	for (int i = 0; i < count && !status; i++) {
		status = set_harmonic(&to, &rom->harmonic[i], &answer[i], factor, report);
		if (!status)
			status = set_known(&to, &rom->harmonic[i], all, &answer[i], factor, o->ratio, report);
		all += answer[i].known;
	}
	if (!status && count > 0)
		rom->known.reach = reach;
	for (int i = 0; answer && i < count; i++)
		hawser__lexpand_answer_clear(&answer[i]);
	free(answer);
	return status;
}
