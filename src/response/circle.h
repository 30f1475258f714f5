/* response/circle.h - on which side of the unit circle multipliers certainly are.
 *
 * The multipliers of an undamped model lie on the unit circle. Their computed moduli differ from 1
 * by what the integration of the period, coordinates that are left out and round-off contribute, and
 * by more the nearer two multipliers are to each other. The sign of this difference is arbitrary. A
 * multiplier is outside (or inside) where the logarithm of its modulus exceeds its error bound, and
 * undecided where it does not.
 *
 * The error of the orbit is not part of the bound. It moves the place at which a multiplier crosses the
 * circle, which the error of an event includes, and moves it smoothly from orbit to orbit. Along any
 * periodic function the variational equations of an undamped model are Hamiltonian, so that this
 * error moves no multiplier off the circle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_CIRCLE_H
#define HAWSER_RESPONSE_CIRCLE_H

struct hawser__circle {
	int unstable;  /* multipliers outside */
	int undecided; /* neither outside nor inside */
	int at_one;    /* of these, the ones that may be real and positive */
};

/* Set bound [m] (or NULL), the error of each logarithm of a modulus, and count. `loss` is the error of
 * the matrix whose eigenvalues the multipliers are; `beside` is an error of the logarithms besides. */
struct hawser__circle hawser__circle_count(double *bound, const double *log_modulus,
                                           const double *argument, int m, double loss, double beside);

#endif
