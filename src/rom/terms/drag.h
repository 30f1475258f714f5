/* rom/terms/drag.h - quadratic drag of air at rest, and the exact force of a wind. See drag.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_DRAG_H
#define HAWSER_ROM_DRAG_H

#include <complex.h>

#include <hawser/modes.h>
#include <hawser/rom.h>

#include "modes/complex/wind.h"

struct hawser_rom_drag {
	struct hawser__flow_points flow;
	double *still;  /* [points][2] force on the cable at rest, N/m, which is part of the statics */
	double wind;    /* m/s; 0: air at rest */
};

/* Fill rom->drag from the scene; nothing if it has neither drag nor a wind of exact form.
 * HAWSER_ERR_ARGUMENT (drag and a cable that travels, moving supports, a static wind),
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser__drag_make(struct hawser_rom *rom, const struct hawser_modes *modes,
                                     const struct hawser_scene *scene,
                                     struct hawser_report *report);
/* The same of a flow with this speed, m/s, which the model takes over. */
enum hawser_status hawser__drag_take(struct hawser_rom *rom, struct hawser__flow_points *flow,
                                     double wind, struct hawser_report *report);
void hawser__drag_free(struct hawser_rom_drag *drag);

/* force [count][n] += the force at the velocities v [count][n]; and unless NULL matrix [count][n][n] +=
 * sign times minus the derivative of that force by v. */
void hawser__drag_add(const struct hawser_rom_drag *drag, double *force, double *matrix, double sign,
                      const double *v, int count);
/* out [n] += the derivative of order `count`, 2 or 3, of the force of a wind on the cable at rest,
 * along the velocities v [count][n]. */
void hawser__drag_form(const struct hawser_rom_drag *drag, double complex *out,
                       const double complex *const v[], int count);
/* 1: that of a wind at all points, which is smooth unlike |v| v. */
int hawser__drag_smooth(const struct hawser_rom_drag *drag);
/* 1: the model has drag that is not smooth, of air at rest or of water. */
int hawser__drag_rough(const struct hawser_rom *rom);

/* 1 if the scene has drag and no other damping of high modes, but for that of attachments. */
int hawser__drag_alone(const struct hawser_scene *scene);

/* The linear damping (scaled; diagonal entry of D) that has the amplitude of mode j at its resonance
 * under the modal load `load` with the drag of the scene besides the linear damping `damping`: the
 * describing function of drag. Without drag: `damping`. */
double hawser__drag_equal(const struct hawser_modes *modes, const struct hawser_scene *scene, int j,
                          double load, double damping);

/* HAWSER_ERR_ARGUMENT if the model has drag (rom NULL: it has), which `what` does not take. */
enum hawser_status hawser__drag_refuse(const struct hawser_rom *rom, const char *what,
                                       struct hawser_report *report);

#endif
