/* study/accuracy/primary.h - internal functions of hawser/primary.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_PRIMARY_H
#define HAWSER_STUDY_PRIMARY_H

#include <hawser/primary.h>

/* A third of the coefficient of A^2 conj(A) in the modulation equations of one mode. */
double hawser__primary_cubic(const struct hawser_modulation *modulation);
/* Number of modes that the motion with the amplitude a at the scaled frequency W excites at half of it,
 * by a resonance of two to one: it is not stable then. */
int hawser__primary_excites(const struct hawser_primary *primary, double W, double a);

#endif
