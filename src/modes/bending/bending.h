/* modes/bending/bending.h - rotations, changes of curvature and end moments of modes with
 * bending stiffness. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_BENDING_H
#define HAWSER_MODES_BENDING_H

#include "modes/grid.h"

/* Width of the boundary layer at s, sqrt(EI/T), scaled. */
double hawser__layer_at(const struct hawser_statics *st, double s);

/* Modes of a cable with bending.EI > 0. */
enum hawser_status hawser__flexure_solve(struct hawser_modes *modes, const struct hawser_statics *st,
                                         const struct hawser_modes_options *options,
                                         struct hawser_report *report);

/* All Galerkin modes of a cable with bending.EI > 0, for functions of degree[plane] in each element; 0:
 * none. `waves`: half waves of the highest mode that is wanted. Statuses: _MEMORY, _NAN, _ARGUMENT. */
enum hawser_status hawser__flexure_basis(struct hawser_modes *modes, const struct hawser_statics *st,
                                         const int degree[2], double waves,
                                         struct hawser_report *report);

/* degree [2] for about so many functions per component, functions[plane]. Status: _MEMORY. */
enum hawser_status hawser__flexure_functions(int degree[2], const struct hawser_statics *st,
                                             const int functions[2],
                                             struct hawser_report *report);

/* Derivative by s of the rotations of the tangent in the plane and out of it, curvature[points][2], for
 * strains [points][3]; of ends (NULL: not wanted) its values at ends A and B, [2][2]. */
enum hawser_status hawser__curvature(double *curvature, double *ends, const struct hawser_statics *st,
                                     const struct hawser_grid *grid, const double *strain,
                                     struct hawser_report *report);

/* Fill moment[] of all modes. */
enum hawser_status hawser__modes_moments(struct hawser_modes *modes, struct hawser_report *report);

#endif
