/* rom/answer.h - response of the condensed modes to the forces of a model, at the shape points and
 * along the line, for displacement and tension. See answer_make.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_ANSWER_H
#define HAWSER_ROM_ANSWER_H

#include <hawser/rom.h>

/* Fill `answer` and `answer_line` of a model's harmonics and ramp: the response of all modes but the
 * first `moving` of `modes`. The model must have its load, travelling terms, shape points and line. */
enum hawser_status hawser__rom_answers(struct hawser_rom *rom, const struct hawser_modes *modes,
                                       int moving, const struct hawser_scene *scene,
                                       struct hawser_report *report);

#endif
