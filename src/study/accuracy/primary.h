/* study/accuracy/primary.h - internal functions of hawser/primary.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_PRIMARY_H
#define HAWSER_STUDY_PRIMARY_H

#include <hawser/primary.h>

/* A third of the coefficient of A^2 conj(A) in the modulation equations of one mode. */
double hawser__primary_cubic(const struct hawser_modulation *modulation);

#endif
