/* rom/build/line.h - the loads of a model of a rope over sheaves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_LINE_H
#define HAWSER_ROM_LINE_H

#include <hawser/line_rom.h>

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

/* `answer` of the harmonics of a load and the known motions. line_answer.c. */
enum hawser_status hawser__line_answers(struct hawser_rom *rom, const struct hawser__lexpand *t,
                                        const struct hawser__lexpand_modes *own,
                                        const struct hawser_line_modes *modes,
                                        const struct hawser_line_rom_options *options,
                                        struct hawser_report *report);
/* rom->contacts: the arcs on which the rope lies. line_lift.c. */
enum hawser_status hawser__line_contacts(struct hawser_rom *rom, const struct hawser_line_modes *modes,
                                         struct hawser_report *report);

#endif
