/* beam/stop.h - a beam's eigenvalues at one speed, as the pairs that belong together.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BEAM_STOP_H
#define HAWSER_BEAM_STOP_H

#include "beam/spectrum.h"

/* Conjugates, or two real eigenvalues that were a conjugate pair or may become one. */
struct hawser__beam_pair {
	double re[2], im;    /* im > 0: conjugates, re[0] = re[1]; im 0: real ones, re[0] >= re[1] */
	int first, second;   /* their places in the stop's lists */
	double slope_re, slope_im; /* of the first by the speed */
	double residual, condition; /* the larger ones of both */
	double growth;       /* re[0] less what round-off makes of zero; growing where it is positive */
	int energy;          /* sign of the energy of a gyroscopic system's motion, else 0 */
	int growing;
};

struct hawser__beam_stop {
	double speed;
	int n, found, pairs;  /* pairs by modulus */
	int growing;          /* among the watched ones, the first `watched` pairs */
	int real;             /* of those pairs, such as are two real eigenvalues */
	int inserted;
	struct hawser_beam_eigenvalue *value; /* [found] */
	double *right, *left; /* [found][2][n] */
	struct hawser__beam_pair *pair; /* [pairs] */
};

/* The beam at `speed` with at least `watched` pairs, fewer where there are no more. */
enum hawser_status hawser__beam_stop(struct hawser__beam_stop *stop,
                                     const struct hawser_beam_integrals *integrals,
                                     const struct hawser_beam *beam, double speed, int watched,
                                     struct hawser_report *report);
void hawser__beam_stop_clear(struct hawser__beam_stop *stop);

/* Bi-orthogonal products y_a* [(l_a + l_b) M + C] x_b of the pairs of two stops, their moduli
 * squared and
 * each row divided by its sum, in share [a->pairs][b->pairs]. */
enum hawser_status hawser__beam_correlate(double *share, const struct hawser__beam_stop *a,
                                          const struct hawser__beam_stop *b,
                                          const struct hawser_beam_integrals *integrals,
                                          const struct hawser_beam *beam,
                                          struct hawser_report *report);

#endif
