/* response/locus/own_section.h - the map of a section across a limit cycle onto itself.
 *
 *    x        the cycle's state [m] at the phase 0
 *    Q        [m][m] column-major, orthogonal: `gone` columns along the motion (and along the rotation
 *             that leaves the model as it is), then those of the section
 *    M        [size][size] column-major: the derivative of the map, whose eigenvalues mu are the
 *             multipliers without those that are 1 along the motion
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_OWN_SECTION_H
#define HAWSER_RESPONSE_OWN_SECTION_H

#include <complex.h>

#include "core/hold.h"
#include "response/locus/locus_own.h"
#include "response/time/flow.h"

struct hawser__own_section {
	const struct hawser_rom *rom;
	double omega, extent;       /* extent: size of the motion */
	double *x, *Q, *M;
	int m, gone, size;
	double complex *mu;         /* [size] */
	double *left, *right;       /* [size][size] eigenvectors as LAPACK has them */
	struct hawser__stretch period;
	struct hawser__flow flow;
	struct hawser__hold hold;
};

enum hawser_status hawser__own_section_open(struct hawser__own_section *section,
                                            const struct hawser_rom *rom, const double *x,
                                            double omega, int steps, struct hawser_report *report);
void hawser__own_section_close(struct hawser__own_section *section);

/* Whether the direction [m] of the rotation is not that of the motion. */
int hawser__own_apart(const double *rotation, const double *motion, int m);

/* *third: the coefficient of the normal form of the multiplier `which`, its real part over mu, which is
 * negative where what is born is stable; NAN where it has a pole, and for a rotation besides. */
enum hawser_status hawser__own_third(struct hawser__own_section *section, double *third, int which,
                                     struct hawser_report *report);

#endif
