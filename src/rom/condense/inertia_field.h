/* rom/condense/inertia_field.h - internal to inertia.c: motions as rows of numbers.
 *
 * A row has P, Q, B or a, b, c at the points of the grid, [points][3], behind them the displacements
 * along x, y, z of the points of label.h, [.][3], and, with absorbers, for every attachment the
 * displacement along x, y, z of its absorber's mass and its stroke, [attachments][4]. Rows of
 * displacements and of strains are the same behind the points of the grid.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_INERTIA_FIELD_H
#define HAWSER_ROM_INERTIA_FIELD_H

#include "rom/condense/condense.h"

int hawser__inertia_width(const struct hawser_modes *modes);
/* Index of the stroke of the absorber at attachment i. */
size_t hawser__inertia_stroke(const struct hawser_modes *modes, int i);

/* Square roots of the masses, and of stiffness, of all numbers of a row, [width]. */
void hawser__inertia_roots(double *root, double *stiff, const struct hawser_modes *modes);

/* Fill the numbers of absorbers in a row from those of the points and stroke [attachments]; NULL
 * without absorbers. */
void hawser__inertia_absorbers(double *row, const struct hawser_modes *modes, const double *stroke);

/* The displacements [width] of the response to a pair, whose strains [points][3] are given; scratch
 * [6][points]. */
void hawser__inertia_displacement(double *shape, const struct hawser_modes *modes,
                                  const struct hawser__reference *reference, const double *strain,
                                  const struct hawser__condensed *condensed, int pair,
                                  double *scratch);

#endif
