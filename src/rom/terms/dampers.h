/* rom/terms/dampers.h - attachments in a reduced model: damping, and shapes of dampers as coordinates.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_DAMPERS_H
#define HAWSER_ROM_DAMPERS_H

#include <hawser/rom.h>

#include "rom/file/read.h"

/* 1 if an attachment has a damper, or a spring. */
int hawser__has_dampers(const struct hawser_statics *statics);
int hawser__has_springs(const struct hawser_statics *statics);

/* Add to D [n][n], n = modes->n, the dampers of the attachments and, with the viscous force per
 * length `alpha` (scaled), what the point masses take from its diagonal: the modes are orthonormal
 * with the masses, on which alpha does not act. */
void hawser__dampers_add(double *D, const struct hawser_modes *modes, double alpha);

/* Stiffness [n][n] of the springs in these modes. */
void hawser__springs_add(double *K, const struct hawser_modes *modes);

/* --- contacts.c: the angles by which the rope of a model lies on its sheaves --- */

/* Allocate, all zero. */
enum hawser_status hawser__rom_init_contacts(struct hawser_rom *rom, int count,
                                             struct hawser_report *report);
void hawser__rom_contacts_clear(struct hawser_rom_contacts *contacts);
/* The member `contacts` of a reduced-model file. */
enum hawser_status hawser__read_contacts(const struct hawser__parser *reader, struct hawser_rom *rom,
                                         json_t *object);

#endif
