/* hawser/primary.h - the primary resonance of one mode in closed form, by multiple scales: with
 * the detuning sigma = Omega - omega, the amplitude a of the mode's coordinate obeys
 *
 *   a^2 [(c/2)^2 + (sigma - Gamma a^2)^2] = (f/(2 omega))^2,   Gamma = 3 cubic/(8 omega)
 *
 * where `cubic` is the effective coefficient: the mode's own, and what every quadratic term gives
 * back through the second-order response of every mode (hawser/scales.h). Peak and folds follow in
 * closed form (doc/theory-scales.md); the displacement holds the second order, its drift and its
 * second harmonic.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_PRIMARY_H
#define HAWSER_PRIMARY_H

#include <hawser/scales.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Scaled quantities throughout. */
struct hawser_primary {
	int mode;                   /* index */
	double omega, damping;      /* of the mode: natural frequency, c */
	double load[2];             /* complex amplitude f at Omega = omega: f = |load| */
	double own, cubic;          /* the coefficient of u^3 in the model, and the effective one */
	double gamma;               /* Gamma: positive hardens, negative softens */
	double peak, peak_omega;
	int folds;                  /* 0 or 2 */
	double fold[2], fold_omega[2]; /* the larger amplitude first */
	struct hawser_modulation modulation; /* for the second order */
};

/* HAWSER_ERR_ARGUMENT (no such mode, no damping, no load on it, K not diagonal),
 * HAWSER_ERR_NO_SOLUTION (another mode is exactly resonant), HAWSER_ERR_MEMORY. Release with
 * hawser_primary_clear. */
enum hawser_status hawser_primary_derive(struct hawser_primary *primary,
                                         const struct hawser_rom *rom,
                                         int mode, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_primary_clear(struct hawser_primary *primary);

/* Of the mode that its load drives the furthest in the linear response; -1 where there is none. */
int hawser_primary_strongest(const struct hawser_rom *rom);

/* The response curve. In `frf` residuals and errors are 0 (nothing was solved), `arc` is an index,
 * and there are no multipliers and states. */
struct hawser_primary_curve {
	struct hawser_frf frf;
	double *amplitude; /* [points] a */
	double *part;      /* [points][probes][3][3] of x, y, z: mean, at Omega, at 2 Omega */
};
enum hawser_status hawser_primary_trace(struct hawser_primary_curve *curve,
                                        const struct hawser_primary *primary, double from,
                                        double to,
                                        int points, struct hawser_report *report) HAWSER_MUST_CHECK;
/* The backbone by the same expansion, Omega = omega + Gamma a^2 for a from 0 to `size`, of a model
 * with or without load and damping; *gamma as above. `points` of them, 2 or more. */
enum hawser_status hawser_primary_backbone(struct hawser_primary_curve *curve, double *gamma,
                                           const struct hawser_rom *rom, int mode, double size,
                                           int points,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_primary_curve_clear(struct hawser_primary_curve *curve);

#ifdef __cplusplus
}
#endif
#endif
