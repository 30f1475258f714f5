/* hawser/linear.h - linear questions about a reduced model: is rest stable, and is it under
 * parametric excitation?
 *
 *   u'' + D u' + K u = 0                                        growth, natural frequencies
 *   u'' + (D + D_h(Omega t)) u' + (K + K_h(Omega t)) u = 0      Floquet multipliers (Hill's
 *                                                               equation)
 *
 * K, D and the harmonics' matrices of a model are all that is read: Q, C and f may be anything. But
 * where the last coordinates are second-order shapes (rom.inertia.shapes), which belong to what
 * follows the others, K_h has what Q makes of their static answer to f.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_LINEAR_H
#define HAWSER_LINEAR_H

#include <hawser/orbit.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Room for models of one number of coordinates; one a thread. No call below remembers anything
 * from one model to the next. */
struct hawser_linear;
enum hawser_status hawser_linear_open(struct hawser_linear **linear, int n,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_linear_free(struct hawser_linear *linear);
/* So many times the steps a period from here on; their error falls with the 16th power. */
void hawser_linear_refine(struct hawser_linear *linear, int finer);

/* Eigenvalues: *growth receives the largest real part (scaled; 0 within
 * 1e-13 of the largest modulus, which is round-off), *growing how many coordinates grow:
 * eigenvalues with a real part beyond 1e-8 of the largest modulus, a conjugate pair counted once;
 * frequency [n] the imaginary parts >= 0, ascending, one a coordinate (0 where it does not
 * oscillate). HAWSER_ERR_CONVERGENCE, HAWSER_ERR_NAN. */
enum hawser_status hawser_linear_growth(struct hawser_linear *linear, double *growth, int *growing,
                                        double *frequency, const struct hawser_rom *rom,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* Floquet multipliers about rest with period 2 pi/omega: log_modulus and argument [2n], by falling
 * modulus (hawser_floquet_product); below -1e5 a logarithm is -1e5. *error is the estimated error
 * of the logarithms, relative beyond 1: twice what up to three quarters more steps change, and a
 * change of omega by two round-offs; NULL, where it is not wanted, takes a fifth of the time. Where
 * two multipliers meet, as on a boundary of stability, it is the root of what it is elsewhere. A
 * model of many coordinates, some of them far faster than omega, is condensed: *error is then 1e-4 or
 * more and is that of the moduli; the arguments of fast coordinates are those of their mean
 * stiffness. What can neither be followed nor condensed is refused.
 * HAWSER_ERR_ARGUMENT (omega; an excited model with the exact energy, whose stiffness varies only
 * with its response), HAWSER_ERR_CONVERGENCE, HAWSER_ERR_NAN. */
enum hawser_status hawser_linear_multipliers(struct hawser_linear *linear, double *log_modulus,
                                             double *argument, double *error,
                                             const struct hawser_rom *rom, double omega,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- any linear system with periodic coefficients, x' = A(t) x --- */

/* `matrix` puts A(t) into A [m][m], row-major; it may jump at halves, quarters and eighths of the
 * period. log_modulus and argument [m] over the period, by falling modulus; *error is the change
 * of the logarithms when the steps were halved last, relative where they are beyond 1.
 * HAWSER_ERR_ARGUMENT, HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_periodic_multipliers(double *log_modulus, double *argument, double *error,
                                               void (*matrix)(void *context, double *A, double t),
                                               void *context, int m, double period,
                                               struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
