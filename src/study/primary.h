/* study/primary.h - hawser/primary.h within the stage.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_PRIMARY_H
#define HAWSER_STUDY_PRIMARY_H

#include <hawser/primary.h>

/* Of the one mode's modulation equations: a third of the coefficient of A^2 conj(A). */
double hawser__primary_cubic(const struct hawser_modulation *modulation);

#endif
