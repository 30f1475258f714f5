/* response/torus/circle.h - multipliers that are certainly inside or outside the unit circle.
 *
 * The multipliers of an undamped model lie on the unit circle. Their computed moduli differ from 1
 * by the errors of the integration over the period, of condensation and of round-off, the more, the
 * nearer two multipliers are to each other. The sign of this difference is arbitrary. A multiplier
 * counts as outside (or inside) if the logarithm of its modulus exceeds its error bound; otherwise
 * it is undecided.
 *
 * The bound does not include the error of the orbit. That error shifts the point at which a
 * multiplier crosses the circle, which is part of the error of the event, and it varies smoothly
 * from orbit to orbit. The variational equations of an undamped model along any periodic function
 * are Hamiltonian, so that an error of the orbit does not move a multiplier off the circle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_CIRCLE_H
#define HAWSER_RESPONSE_CIRCLE_H

struct hawser__circle {
	int unstable;  /* multipliers outside */
	int undecided; /* number of multipliers neither outside nor inside */
	int at_one;    /* number of these that may be real and positive */
};

/* Compute bound [m] (or NULL), the error of the logarithm of each modulus, and the counts. `loss`
 * is the error of the matrix whose eigenvalues the multipliers are; `beside` is a further error of
 * the logarithms. */
struct hawser__circle hawser__circle_count(double *bound, const double *log_modulus,
                                           const double *argument, int m, double loss, double beside);

#endif
