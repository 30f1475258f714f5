/* rom/answer.h - what the forces of a model do to the modes that it does not keep: at the shape
 * points and along the line, for displacement and tension. See answer_make.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_ANSWER_H
#define HAWSER_ROM_ANSWER_H

#include <hawser/rom.h>

/* Fill `answer` and `answer_line` of the harmonics and the ramp of a model of `modes` that has its
 * load, its travelling terms, its shape points and its line: the answers of all modes but the first
 * `moving` of these. */
enum hawser_status hawser__rom_answers(struct hawser_rom *rom, const struct hawser_modes *modes,
                                       int moving, const struct hawser_scene *scene,
                                       struct hawser_report *report);

#endif
