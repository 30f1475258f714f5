/* beam/integrals.h - rows of the table of discretisations, and the memory of their integrals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BEAM_INTEGRALS_H
#define HAWSER_BEAM_INTEGRALS_H

#include <hawser/beam.h>

extern const struct hawser_beam_method hawser__beam_legendre, hawser__beam_sine, hawser__beam_hermite;

/* Allocate the integrals of n functions, all zero. */
enum hawser_status hawser__beam_integrals_init(struct hawser_beam_integrals *integrals, int n,
                                               int band, struct hawser_report *report);

#endif
