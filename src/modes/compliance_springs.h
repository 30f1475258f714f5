/* modes/compliance_springs.h - internal to compliance: forces that springs and the fixed ends exert.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_COMPLIANCE_SPRINGS_H
#define HAWSER_MODES_COMPLIANCE_SPRINGS_H

#include "modes/compliance.h"

enum { HAWSER__MAX_FORCES = HAWSER__MAX_D + HAWSER__MAX_SPRINGS }; /* most constants z */

/* Solve A z = b, z and b [D + springs]. */
void hawser__spring_solve(double *z, const double *b, const struct hawser__plane *plane,
                          const struct hawser_grid *grid);

/* b[D + springs] = <phi, force>, force [D][points], at the joints of ends A and B: end. */
void hawser__spring_work(double *b, const double *force, double end[2][HAWSER__MAX_D],
                         const struct hawser__plane *plane, const struct hawser_grid *grid);

/* force [D][points] and end [2] += factor times the sum of z_a phi_a. */
void hawser__spring_force(double *force, double end[2][HAWSER__MAX_D], const double *z, double factor,
                          const struct hawser__plane *plane, const struct hawser_grid *grid);

#endif
