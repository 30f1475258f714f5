/* study/accuracy/scales.h - the primary resonance of one mode by the method of multiple scales:
 * effective cubic coefficients of a model, and closed forms of folds and peak.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_SCALES_H
#define HAWSER_STUDY_SCALES_H

#include <hawser/rom.h>

/* u'' + c u' + omega^2 u + cubic u^3 = f cos(Omega t), the reduction of a model near the resonance
 * of one of its modes. */
struct hawser__resonance {
	double omega, c, f;
	double cubic; /* effective coefficient: that of the model, and the contributions of all
	               * quadratic terms */
};

/* The oscillator of mode j of a model in modal coordinates (K diagonal). */
struct hawser__resonance hawser__resonance_of(const struct hawser_rom *rom, int j);

/* Contribution to the cubic coefficient of a mode by a mode s that it drives at 2 omega, omega_s^2
 * u_s = -beta u^2 ...: with inertia, and if mode s responds statically. */
double hawser__returned(double beta, double omega_s, double omega);
double hawser__returned_static(double beta, double omega_s);

/* Omega and amplitude of the peak and of the folds. */
struct hawser__scales {
	double peak_omega, peak;
	int folds;                       /* 0 or 2 */
	double fold_omega[2], fold[2];   /* the fold with the larger amplitude first */
};
struct hawser__scales hawser__scales_solve(const struct hawser__resonance *resonance);

#endif
