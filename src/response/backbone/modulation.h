/* response/backbone/modulation.h - internal functions of the modulation equations: complex numbers are
 * stored as pairs of doubles, so that the public header needs no complex type.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_MODULATION_H
#define HAWSER_RESPONSE_MODULATION_H

#include <complex.h>

#include <hawser/scales.h>

static inline double complex *hawser__complex(double *field)
{
	return (double complex *)field;
}

static inline double hawser__stiffness(const struct hawser_rom *rom, int s)
{
	return rom->K[(size_t)s*((size_t)rom->n + 1)];
}

/* Complex amplitude of the load at harmonic k on mode s at `omega`, and its derivative. */
double complex hawser__load(double complex *by_omega, const struct hawser_rom *rom, int s, int k,
                            double omega);

/* Add value times the product of the amplitudes `given` to an equation. */
enum hawser_status hawser__monomial_add(struct hawser_modulation *m, int equation,
                                        const int given[3], double complex value,
                                        struct hawser_report *report);

/* Refuse a model whose K is not diagonal. */
enum hawser_status hawser__modal(const struct hawser_rom *rom, const char *function,
                                 struct hawser_report *report);

/* Remove monomials that are zero to round-off, and sort the others. */
void hawser__monomials_tidy(struct hawser_modulation *m);

#endif
