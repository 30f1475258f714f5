/* rom/condense/answer.h - response of the condensed modes to the forces of a model, at the shape
 * points and along the line, for displacement and tension. See answer_make.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_ANSWER_H
#define HAWSER_ROM_ANSWER_H

#include <hawser/rom.h>

/* Fill `answer` and `answer_line` of a model's harmonics and ramp: the response of all modes but the
 * first `moving` of `modes`. The model must have its load, travelling terms, shape points and line. */
enum hawser_status hawser__rom_answers(struct hawser_rom *rom, const struct hawser_modes *modes,
                                       int moving, const struct hawser_scene *scene,
                                       struct hawser_report *report);

/* A model whose answers are those at one frequency, for displacements and tensions at many instants of
 * that frequency: it has no other forces. The rom itself if it has no known modes; NULL when out
 * of memory. It is valid until the next call, and refers to the rom. answer_freeze.c. */
struct hawser__frozen {
	struct hawser_rom rom;
	struct hawser_harmonic *harmonic; /* [2 highest] */
	double *memory;
	size_t room;
	int highest;
};
const struct hawser_rom *hawser__rom_freeze(struct hawser__frozen *frozen, const struct hawser_rom *rom,
                                            double omega);
void hawser__rom_frozen_release(struct hawser__frozen *frozen);

/* Add to the K of a model whose speed fluctuates the first correction for the inertia of what follows
 * the change of speed, W^2 times the stiffness that z_1 adds (answer_make.c), as three harmonics with
 * powers of Omega. `modes` are all that move. */
enum hawser_status hawser__rom_travel_lag(struct hawser_rom *rom, const struct hawser_modes *modes,
                                          struct hawser_report *report);

#endif
