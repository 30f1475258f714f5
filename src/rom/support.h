/* rom/support.h - terms of the model of a cable whose supports move. See support.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_SUPPORT_H
#define HAWSER_ROM_SUPPORT_H

#include <hawser/rom.h>

enum { HAWSER__AXES = 3, HAWSER__SUPPORT_TOP = 20 /* highest harmonic of a motion */ };

/* Quasi-static displacements of the cable by unit displacements of end B along x, y and z, with end A
 * fixed, on the grid of the modes. Those of end A are a translation minus these. */
struct hawser__support_shapes {
	int points;
	double *strain; /* [HAWSER__AXES][points][3] a, b, c */
	double *shape;  /* [HAWSER__AXES][3][points] displacement along x, y, z */
};
enum hawser_status hawser__support_shapes_make(struct hawser__support_shapes *shapes,
                                               const struct hawser_modes *modes,
                                               struct hawser_report *report);
void hawser__support_shapes_clear(struct hawser__support_shapes *shapes);

/* A periodic function of the phase: sum of c[k] cos(k tau) + s[k] sin(k tau). */
struct hawser__signal {
	double c[3*HAWSER__SUPPORT_TOP + 1], s[3*HAWSER__SUPPORT_TOP + 1];
};

/* Displacement of `end` (0: A, 1: B), or with end 2 of B relative to A, along `axis`, scaled. */
void hawser__support_signal(struct hawser__signal *signal, const struct hawser_scene *scene, int end,
                            int axis, double length);
int hawser__support_moves(const struct hawser_scene *scene);

/* Add the inertia and damping of the quasi-static displacement to the harmonics of the model, with the
 * displacement and strain at its shape points and line; and, of the first `moving` modes, the response
 * of the condensed modes, if `condensed` is not 0. */
enum hawser_status hawser__support_forces(struct hawser_rom *rom, const struct hawser_modes *modes,
                                          int moving, int condensed,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report);

/* Add the terms of the strain energy. After the forces. */
enum hawser_status hawser__support_energy(struct hawser_rom *rom, const struct hawser_modes *modes,
                                          int moving, int condensed,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report);

/* answer_make.c: the response of the condensed modes to the force field [3][points], along x, y, z at
 * the points of the modes' grid, is added to `harmonic` of the model: displacement, strain and the
 * stiffness of the first `moving` modes. */
enum hawser_status hawser__rom_answer_field(struct hawser_rom *rom, int harmonic,
                                            const struct hawser_modes *modes, int moving,
                                            const double *field, struct hawser_report *report);

#endif
