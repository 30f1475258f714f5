/* response/branch/return_map.h - the map of states over a period, or of a section across a cycle of an
 * autonomous model onto itself, and its normal form.
 *
 *    x        the motion's state at the phase 0: u, v/Omega [m]
 *    Q        [m][m] column-major, orthogonal: `gone` columns along the motion of a cycle (and along
 *             the rotation that leaves the model as it is), then those of the section. 1 if none
 *    M        [size][size] column-major: the derivative of the map, whose eigenvalues mu are the
 *             multipliers without those that are 1 along the motion
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_RETURN_MAP_H
#define HAWSER_RESPONSE_RETURN_MAP_H

#include <complex.h>

#include <hawser/normal_form.h>

#include "core/hold.h"
#include "response/time/flow.h"

struct hawser__return {
	const struct hawser_rom *rom;
	double omega, extent;       /* extent: norm of x; 1 at rest */
	double *x, *Q, *M;
	int m, gone, size;
	double complex *mu;         /* [size] */
	double *left, *right;       /* [size][size] eigenvectors as LAPACK has them */
	struct hawser__stretch period;
	struct hawser__flow flow;
	struct hawser__hold hold;
};

/* Of the motion with the state x [2n], u and v, over `period` periods of the frequency omega, in steps
 * of which `steps` make a period; 0: as many as an error of 1e-12 needs, at most 4000, else
 * HAWSER_ERR_NO_SOLUTION. */
enum hawser_status hawser__return_open(struct hawser__return *section, const struct hawser_rom *rom,
                                       const double *x, double omega, int period, int steps,
                                       struct hawser_report *report);
void hawser__return_close(struct hawser__return *section);

/* Whether the direction [m] of the rotation is not that of the motion. */
int hawser__apart(const double *rotation, const double *motion, int m);

/* *c: the coefficient of the normal form (hawser/normal_form.h) of the multiplier `which`, by
 * differences over the amplitude a; NAN where it has a pole, and where the model can be turned. */
enum hawser_status hawser__return_form(struct hawser__return *section, double *c, int which,
                                       enum hawser_event_kind kind, double a,
                                       struct hawser_report *report);

#endif
