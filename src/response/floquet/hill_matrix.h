/* response/floquet/hill_matrix.h - the determinant of a Hill matrix.
 *
 * Of  x'' + D(t) x' + K(t) x = 0  with periodic D and K, a motion exp(lambda t) times a periodic
 * function has the harmonics
 *
 *     x = sum of x_m exp(l_m t),    l_m = lambda + i m Omega
 *
 * and its equation is a matrix with blocks (m, l)
 *
 *     delta_ml l_m^2 + l_l D_(m-l) + K_(m-l)
 *
 * of the complex Fourier coefficients. Its determinant vanishes where lambda is a Floquet
 * exponent. So a multiplier is +1 where it vanishes at lambda = 0, and -1 at lambda = i Omega/2;
 * at both it is real.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_HILL_MATRIX_H
#define HAWSER_RESPONSE_HILL_MATRIX_H

#include "response/floquet/monodromy.h"

struct hawser__hill_matrix {
	double *memory;
	size_t room;
};

void hawser__hill_matrix_release(struct hawser__hill_matrix *matrix);

/* Number of harmonics, counted from 0 upwards, beyond which the others change the zeros of the
 * determinant by less than round-off; 0 if so many are needed that multipliers are cheaper.
 * `lambda` is {real, imaginary}. */
int hawser__hill_harmonics(const struct hawser__variational *system, const double lambda[2]);

/* value {real, imaginary, round-off} times 2^*exponent: the determinant divided by the scales of
 * rows and columns, max(|K_jj|, Omega^2) + (nu + m Omega)^2, which are smooth in every parameter.
 * The round-off is an estimate: that of the smallest pivot times all others. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__hill_determinant(double value[3], int *exponent,
                                            struct hawser__hill_matrix *matrix,
                                            const struct hawser__variational *system,
                                            const double lambda[2], int harmonics,
                                            struct hawser_report *report);

#endif
