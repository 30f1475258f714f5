/* beam/spectrum.h - eigenvalues with both their vectors, and what a beam is by its nature.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BEAM_SPECTRUM_H
#define HAWSER_BEAM_SPECTRUM_H

#include <hawser/beam.h>

/* hawser_beam_eigenvalues with the left vectors in left [count][2][n], or NULL. */
enum hawser_status hawser__beam_eigen(struct hawser_beam_eigenvalue *value, double *vector,
                                      double *left, int *found,
                                      const struct hawser_beam_integrals *integrals,
                                      const struct hawser_beam *beam, int count,
                                      struct hawser_report *report);

/* Quantities in their ranges, or HAWSER_ERR_ARGUMENT. */
enum hawser_status hawser__beam_check(const struct hawser_beam *beam, struct hawser_report *report);

/* The first frequency of a level beam at rest: the scale of the lowest ones. */
double hawser__beam_rest_frequency(const struct hawser_beam *beam);

/* Rotary momentum flows through the supports. */
int hawser__beam_flux(const struct hawser_beam *beam);

/* C is skew and K symmetric. */
int hawser__beam_gyroscopic(const struct hawser_beam *beam);

#endif
