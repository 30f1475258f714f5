/* hawser/primary.h - the primary resonance of one mode in closed form, by multiple scales. With the
 * detuning sigma = Omega - omega, the amplitude a of the mode's coordinate satisfies
 *
 *    a^2 [(c/2)^2 + (sigma - Gamma a^2)^2] = (f/(2 omega))^2,   Gamma = 3 cubic/(8 omega)
 *
 * where `cubic` is the effective cubic coefficient: that of the mode itself plus the contributions
 * of the quadratic terms through the second-order response of all modes (hawser/scales.h). Peak and
 * folds follow in closed form (doc/theory-scales.md). The displacement includes the second order: a
 * mean and a second harmonic.
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
	double own, cubic;          /* coefficient of u^3 in the model, and effective coefficient */
	double gamma;               /* Gamma: positive hardens, negative softens */
	double peak, peak_omega;
	int folds;                  /* 0 or 2 */
	double fold[2], fold_omega[2]; /* the larger amplitude first */
	struct hawser_modulation modulation; /* the expansion to second order */
};

/* Derive the resonance of a mode. Release with hawser_primary_clear. HAWSER_ERR_ARGUMENT (no such
 * mode, no damping, no load on it, K not diagonal), HAWSER_ERR_NO_SOLUTION (another mode is exactly
 * resonant), HAWSER_ERR_MEMORY. */
enum hawser_status hawser_primary_derive(struct hawser_primary *primary,
                                         const struct hawser_rom *rom,
                                         int mode, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_primary_clear(struct hawser_primary *primary);

/* Index of the mode that, at the peak, moves as much as the resonant one by a resonance of two to
 * one, which the closed form leaves out; -1: there is none. *strength: its second-order motion at 2
 * Omega over the amplitude, where its frequency is about twice the resonant one; the amplitude over
 * that from which on it is excited at Omega/2, where it is about half. */
int hawser_primary_rival(double *strength, const struct hawser_primary *primary,
                         const struct hawser_rom *rom);

/* Index of the mode that has the largest amplitude in the linear response; -1: no load drives a
 * mode. */
int hawser_primary_strongest(const struct hawser_rom *rom);

/* The response curve. In `frf` residuals and errors are 0, since no equation was solved; `arc` is
 * an index, and there are no multipliers and states. */
struct hawser_primary_curve {
	struct hawser_frf frf;
	double *amplitude; /* [points] a */
	double *part;      /* [points][probes][3][3] of x, y, z: mean, at Omega, at 2 Omega */
};
enum hawser_status hawser_primary_trace(struct hawser_primary_curve *curve,
                                        const struct hawser_primary *primary, double from,
                                        double to,
                                        int points, struct hawser_report *report) HAWSER_MUST_CHECK;
/* The backbone by the same expansion, Omega = omega + Gamma a^2, at `points` (>= 2) amplitudes a
 * from 0 to `size`. Load and damping of the model are not read. *gamma becomes Gamma. */
enum hawser_status hawser_primary_backbone(struct hawser_primary_curve *curve, double *gamma,
                                           const struct hawser_rom *rom, int mode, double size,
                                           int points,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_primary_curve_clear(struct hawser_primary_curve *curve);

#ifdef __cplusplus
}
#endif
#endif
