/* rom/build/line.h - the loads of a model of a rope over sheaves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_LINE_H
#define HAWSER_ROM_LINE_H

#include <hawser/line_rom.h>

#include "rom/condense/fields.h"
#include "ropeway/expand/expand_modes.h"

/* Add the harmonics of options->load. pull: as of hawser__lexpand_drive, whose shape is the last
 * one of t then. line_load.c. */
enum hawser_status hawser__line_load(struct hawser_rom *rom, const struct hawser__lexpand *t,
                                     const struct hawser_line_modes *modes,
                                     const struct hawser_line_rom_options *options, const double *pull,
                                     struct hawser_report *report);
/* The wave k of a passing load as a force along y per length, at the scaled arclength s; `wave` is a
 * struct hawser__line_wave. line_load.c. */
struct hawser__line_wave {
	double number;    /* scaled */
	int sine;
	double scale;
};
double hawser__line_pull(const void *wave, double s);
/* Wave i of options->load, of which there are two a harmonic: cosine and sine. */
struct hawser__line_wave hawser__line_wave(const struct hawser_line_modes *modes,
                                           const struct hawser_line_rom_options *options, int i);

/* Where a point of the model is: on a piece of the rope, at s from its beginning, where the rope has
 * the slope `angle`. line.c. */
struct hawser__line_place {
	int piece;
	double s, angle;
};
/* Of shape point p, and of the points of rom->line from that with the index *next = 0 on; 0: no
 * more. */
struct hawser__line_place hawser__line_shape_place(const struct hawser_rom *rom,
                                                   const struct hawser__lmode *rope, int p);
int hawser__line_next_place(struct hawser__line_place *place, int *next,
                            const struct hawser__lexpand *t);

/* Displacement and strains of `pairs` pairs of the expansion, from number `first` on, at the shape
 * points, [pairs][points][3], and strains along the line. line.c. */
void hawser__line_second(double *shape, double *slope, double *line, const struct hawser_rom *rom,
                         const struct hawser__lexpand *t, int first, int pairs);
/* What the modes that are not kept do under each wave of the load, or under the drive. */
struct hawser__line_field {
	int k, sine;   /* the shape has the factor factor*cos(k tau), or sine */
	double factor;
};
struct hawser__line_answers {
	int count;                                /* of waves; 1: the drive */
	struct hawser__lexpand_answer *answer;    /* [count] */
	double factor;                            /* of each */
	int fields;                               /* shapes of `own` behind the modes: the static parts */
	struct hawser__line_field field[HAWSER__LOAD_FIELDS];
};
/* line_answer.c. _make adds the static parts to the shapes of `own`, which are those of the answers.
 * Clear, on failure too. */
enum hawser_status hawser__line_answers_make(struct hawser__line_answers *answers,
                                             struct hawser__lexpand_modes *own,
                                             const struct hawser_line_modes *modes,
                                             const struct hawser_line_rom_options *options,
                                             struct hawser_report *report);
void hawser__line_answers_clear(struct hawser__line_answers *answers);
/* `answer` of the harmonics and the known motions. */
enum hawser_status hawser__line_answers_set(struct hawser_rom *rom, const struct hawser__lexpand *t,
                                            const struct hawser__line_answers *answers,
                                            const struct hawser_line_rom_options *options,
                                            struct hawser_report *report);
/* Terms of the energy with these shapes. line_fields.c. */
enum hawser_status hawser__line_fields(struct hawser_rom *rom, const struct hawser__lexpand *t,
                                       const struct hawser__line_answers *answers,
                                       struct hawser_report *report);
/* Entries of Q and C of the rom->n equations, in the first n shapes of which the last of an entry is at
 * least number `least`. line_tensors.c. */
enum hawser_status hawser__line_tensors(struct hawser_rom *rom, const struct hawser__lexpand *t, int n,
                                        int least, struct hawser_report *report);
/* rom->contacts: the arcs on which the rope lies. line_lift.c. */
enum hawser_status hawser__line_contacts(struct hawser_rom *rom, const struct hawser_line_modes *modes,
                                         struct hawser_report *report);

#endif
