/* beam/sample.h - the eigenvalues of a beam at one speed, sorted into pairs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BEAM_SAMPLE_H
#define HAWSER_BEAM_SAMPLE_H

#include "beam/spectrum.h"

/* A conjugate pair, or two real eigenvalues that come from a conjugate pair or may become one. */
struct hawser__beam_pair {
	double re[2], im;    /* im > 0: conjugate, re[0] = re[1]; im = 0: real, re[0] >= re[1] */
	int first, second;   /* indices into value, right and left of the sample */
	double slope_re, slope_im; /* derivative of the first eigenvalue with respect to the speed */
	double residual, condition; /* maximum over the two eigenvalues */
	double growth;       /* re[0] minus the round-off threshold; the pair grows if it is positive */
	int energy;          /* gyroscopic system: sign of the energy of the mode; otherwise 0 */
	int growing;         /* 1: growth > 0 */
};

struct hawser__beam_sample {
	double speed;
	int n, found, pairs;  /* pairs are sorted by modulus */
	int growing;          /* number of growing pairs among the first `watched` */
	int real;             /* number of real pairs among the first `watched` */
	int inserted;         /* 1: added by the refinement of a sweep */
	struct hawser_beam_eigenvalue *value; /* [found] */
	double *right, *left; /* [found][2][n] */
	struct hawser__beam_pair *pair; /* [pairs] */
};

/* Solve the eigenvalue problem at `speed` (beam->speed is ignored). The sample has at least
 * `watched` pairs, or all pairs if the discretisation has fewer. */
enum hawser_status hawser__beam_sample(struct hawser__beam_sample *sample,
                                       const struct hawser_beam_integrals *integrals,
                                       const struct hawser_beam *beam, double speed, int watched,
                                       struct hawser_report *report);
void hawser__beam_sample_clear(struct hawser__beam_sample *sample);

/* Correlation of the pairs of two samples: |y_a* [(l_a + l_b) M + C] x_b|^2, each row divided by
 * its sum, in share [a->pairs][b->pairs]. M and C are those at the mean of the two speeds. */
enum hawser_status hawser__beam_correlate(double *share, const struct hawser__beam_sample *a,
                                          const struct hawser__beam_sample *b,
                                          const struct hawser_beam_integrals *integrals,
                                          const struct hawser_beam *beam,
                                          struct hawser_report *report);

#endif
