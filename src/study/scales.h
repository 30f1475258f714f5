/* study/scales.h - the primary resonance of one mode by the method of multiple scales: a model's
 * effective cubic coefficients, and the closed forms of folds and peak.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_SCALES_H
#define HAWSER_STUDY_SCALES_H

#include <hawser/rom.h>

/* u'' + c u' + omega^2 u + cubic u^3 = f cos(Omega t), all that is left of a model near the resonance
 * of one of its modes. */
struct hawser__resonance {
	double omega, c, f;
	double cubic; /* effective: own coefficient, and what comes back from every quadratic term */
};

/* Of mode j of a model in modal coordinates (K diagonal). */
struct hawser__resonance hawser__resonance_of(const struct hawser_rom *rom, int j);

/* What a mode s with omega_s^2 u_s = -beta u^2 ... gives back to the cubic coefficient of the mode that
 * drives it at 2 omega: dynamically, and when it follows statically. */
double hawser__returned(double beta, double omega_s, double omega);
double hawser__returned_static(double beta, double omega_s);

/* Peak and folds, Omega and amplitude each. */
struct hawser__scales {
	double peak_omega, peak;
	int folds;                       /* 0 or 2 */
	double fold_omega[2], fold[2];   /* the one with the larger amplitude first */
};
struct hawser__scales hawser__scales_solve(const struct hawser__resonance *resonance);

#endif
