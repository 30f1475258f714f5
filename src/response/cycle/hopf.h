/* response/cycle/hopf.h - a Hopf point: eigenvectors and normal form.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_HOPF_H
#define HAWSER_RESPONSE_HOPF_H

#include <hawser/frf.h>

/* With hopf->turning given, at the equilibrium u [n] of the family at p, where the pair of eigenvalues
 * nearest to i guess (0: that nearest to the axis) is critical: *hopf and *rate, its growth rate, in
 * the scaled time of the model at p, and wave [2n], the cos (first n) and sin coefficients, with
 * the norm of the eigenvector. hopf->l1 is NAN of a model whose second and third derivatives are not
 * known. HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser__hopf(struct hawser_hopf *hopf, double *rate, double *wave,
                                const struct hawser_rom_family *family, const double *u, double p,
                                double guess, double extent, struct hawser_report *report);

/* An equilibrium of the model from the guess u [n]; the guess may be anything if `far`.
 * HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser__equilibrium_find(double *u, const struct hawser_rom *rom, int far,
                                            struct hawser_report *report);

/* The Hopf point near the equilibrium u [n] at *p, both of which are changed, of the pair near i
 * guess. HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser__hopf_near(struct hawser_hopf *hopf, double *wave, double *u, double *p,
                                     const struct hawser_rom_family *family, double guess,
                                     double extent, struct hawser_report *report);

#endif
