/* rom/condense/support.h - terms of the model of a cable whose supports move. See support.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_SUPPORT_H
#define HAWSER_ROM_SUPPORT_H

#include <hawser/rom.h>

enum {
	HAWSER__AXES = 3,
	HAWSER__SUPPORT_MOST = 2*HAWSER__AXES,
	HAWSER__SUPPORT_TOP = 20 /* highest harmonic of a motion */
};

/* Quasi-static displacements of the cable along the axes of its plane, on the grid of the modes. 0 to
 * 2: by a unit displacement of end B (or of the foundation of its springs) along x, y and z, with end A
 * fixed. Of a cable with springs also 3
 * to 5: what the springs add to a unit translation of both ends. A displacement of end A is that
 * translation minus the displacement of end B. */
struct hawser__support_shapes {
	int count;      /* HAWSER__AXES, or with springs HAWSER__SUPPORT_MOST */
	int points;
	double *strain; /* [count][points][3] a, b, c */
	double *shape;  /* [count][3][points] displacement along x, y, z */
	double *at;     /* [count][hawser__points][3] the same at the points of modes/label.h */
};
enum hawser_status hawser__support_shapes_make(struct hawser__support_shapes *shapes,
                                               const struct hawser_modes *modes,
                                               struct hawser_report *report);
void hawser__support_shapes_clear(struct hawser__support_shapes *shapes);

/* A periodic function of the phase: sum of c[k] cos(k tau) + s[k] sin(k tau). */
struct hawser__signal {
	double c[3*HAWSER__SUPPORT_TOP + 1], s[3*HAWSER__SUPPORT_TOP + 1];
};

/* The factor of shape `number` (struct hawser__support_shapes); returns whether it is not 0. */
int hawser__support_factor(struct hawser__signal *signal, const struct hawser_scene *scene, int number,
                           const struct hawser_statics *statics);
int hawser__support_moves(const struct hawser_scene *scene);

/* Whether the ends move as a table says (struct hawser_rom_history). Then hawser__support_factor says
 * only whether the shape moves, and the signals of the history have the numbers of the shapes; all of
 * them are there, and those of end A move the whole cable along, too. */
int hawser__support_given(const struct hawser_scene *scene);
/* Displacement `number` of a unit displacement of `end` along the axis of the scene. */
double hawser__support_weight(int number, int end, int axis, const struct hawser_statics *statics);

/* Add the inertia and damping of the quasi-static displacement to the harmonics of the model, with the
 * displacement and strain at its shape points and line (ends.h); and, of the first `moving` modes, the
 * response of the condensed modes, if `condensed` is not 0. */
enum hawser_status hawser__support_forces(struct hawser_rom *rom, const struct hawser_modes *modes,
                                          int moving, int condensed,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report);

/* Add the terms of the strain energy by what moves in a known way: the supports, and the static
 * response to the load, `loads` (NULL if the other modes are not condensed); and the second-order
 * displacement and strain by the supports. After the forces. modes: the `kept` ones, then second-order
 * shapes; to the load these respond without their inertia, as in the linear model. */
struct hawser__load_fields;
enum hawser_status hawser__support_energy(struct hawser_rom *rom, const struct hawser_modes *modes,
                                          const struct hawser_modes *kept,
                                          const struct hawser__load_fields *loads,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report);

/* answer_make.c: the response of the condensed modes to the force field [3][points], along x, y, z at
 * the points of the modes' grid, `point` [hawser__points][3] at those of label.h and `stroke`
 * [attachments] on the strokes of absorbers, is added to `harmonic` of the model: displacement, strain
 * and the stiffness of the first `moving` modes. */
enum hawser_status hawser__rom_answer_field(struct hawser_rom *rom, int harmonic,
                                            const struct hawser_modes *modes, int moving,
                                            const double *field, const double *point,
                                            const double *stroke,
                                            struct hawser_report *report);

#endif
