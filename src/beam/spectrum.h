/* beam/spectrum.h - eigenvalues with right and left vectors, and properties of a beam's equation.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BEAM_SPECTRUM_H
#define HAWSER_BEAM_SPECTRUM_H

#include <hawser/beam.h>

/* As hawser_beam_eigenvalues, with the left vectors in left [count][2][n]; left may be NULL. */
enum hawser_status hawser__beam_eigen(struct hawser_beam_eigenvalue *value, double *vector,
                                      double *left, int *found,
                                      const struct hawser_beam_integrals *integrals,
                                      const struct hawser_beam *beam, int count,
                                      struct hawser_report *report);

/* HAWSER_ERR_ARGUMENT if a quantity of the beam is out of its range. */
enum hawser_status hawser__beam_check(const struct hawser_beam *beam, struct hawser_report *report);

/* The first frequency of a level beam at rest with simple ends: the scale of the lowest
 * frequencies. */
double hawser__beam_rest_frequency(const struct hawser_beam *beam);

/* 1: the flux of rotary momentum through the supports is not balanced (simple ends, free
 * moments). */
int hawser__beam_flux(const struct hawser_beam *beam);

/* 1: C is skew-symmetric and K symmetric. */
int hawser__beam_gyroscopic(const struct hawser_beam *beam);

#endif
