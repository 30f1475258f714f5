/* hawser/linear.h - linear stability of a reduced model about rest, without and with parametric
 * excitation.
 *
 *   u'' + D u' + K u = 0                                        growth, natural frequencies
 *   u'' + (D + D_h(Omega t)) u' + (K + K_h(Omega t)) u = 0      Floquet multipliers (Hill's
 *                                                               equation)
 *
 * Only K, D and the matrices of the harmonics are read; Q, C and f are not, with one exception. If the
 * last coordinates are second-order shapes (rom.inertia.shapes), which represent condensed modes, they
 * respond statically to f, and Q turns this response into a part of K_h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_LINEAR_H
#define HAWSER_LINEAR_H

#include <hawser/orbit.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A workspace for models of n coordinates. Threads must not share it. The results of a call do not
 * depend on previous calls. */
struct hawser_linear;
enum hawser_status hawser_linear_open(struct hawser_linear **linear, int n,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_linear_free(struct hawser_linear *linear);
/* From now on, multiply the number of steps per period by `finer`; the error is divided by its 16th
 * power. */
void hawser_linear_refine(struct hawser_linear *linear, int finer);

/* Eigenvalues. *growth becomes the largest real part, scaled; if it is below 1e-13 of the largest
 * modulus, it is round-off and set to 0. *growing becomes the number of growing modes: of eigenvalues
 * whose real part exceeds 1e-8 of the largest modulus, a conjugate pair counted once. frequency [n]:
 * the imaginary parts >= 0, ascending, one for each coordinate (0 if it does not oscillate).
 * HAWSER_ERR_CONVERGENCE, HAWSER_ERR_NAN. */
enum hawser_status hawser_linear_growth(struct hawser_linear *linear, double *growth, int *growing,
                                        double *frequency, const struct hawser_rom *rom,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* Floquet multipliers about rest with the period 2 pi/omega: log_modulus and argument [2n], by falling
 * modulus (hawser_floquet_product); logarithms below -1e5 become -1e5. *error becomes the estimated
 * error of the logarithms, absolute up to a modulus of 1 of the logarithm and relative above. It is
 * twice the largest change of the logarithms if the number of steps is increased (by three quarters at
 * most) or omega is changed by two units of round-off. At a double multiplier, such as on a stability
 * boundary, the error is the square root of its value elsewhere. error may be NULL, which takes a
 * fifth of the time. If a model has many coordinates and some are much faster than omega, these are
 * condensed: *error is then at least 1e-4 and refers to the moduli only, and the arguments of fast
 * coordinates follow from their mean stiffness. HAWSER_ERR_ARGUMENT (omega; a parametrically excited
 * model with the exact energy), HAWSER_ERR_CONVERGENCE (coordinates too fast to integrate that cannot
 * be condensed), HAWSER_ERR_NAN. */
enum hawser_status hawser_linear_multipliers(struct hawser_linear *linear, double *log_modulus,
                                             double *argument, double *error,
                                             const struct hawser_rom *rom, double omega,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- any linear system with periodic coefficients, x' = A(t) x --- */

/* `matrix` computes A(t) in A [m][m], row-major; A may be discontinuous at multiples of an eighth of
 * the period. log_modulus and argument [m] of the multipliers over the period, by falling modulus.
 * *error becomes the change of the logarithms when the steps were halved for the last time, relative
 * if the logarithm exceeds 1.
 * HAWSER_ERR_ARGUMENT, HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_periodic_multipliers(double *log_modulus, double *argument, double *error,
                                               void (*matrix)(void *context, double *A, double t),
                                               void *context, int m, double period,
                                               struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
