/* study/accuracy/scales.c - see scales.h.
 *
 *    u'' + c u' + omega^2 u + beta u^2 + gamma u^3 + 2 sum_s beta_s u u_s = f cos(Omega t)
 *    u_s'' + omega_s^2 u_s + beta_s u^2 = 0
 *
 * With u = a cos(Omega t + phi) + ... small, u_s has a constant part and one at 2 omega:
 *
 *    u_s = -(beta_s a^2/2) [1/omega_s^2 + cos(2 omega t + 2 phi)/(omega_s^2 - 4 omega^2)]
 *
 * The part of 2 beta_s u u_s at omega is -beta_s^2 a^3 [1/omega_s^2 + 1/(2(omega_s^2 - 4
 * omega^2))], that of gamma u^3 is 3/4 gamma a^3. Mode s therefore contributes -(4/3) beta_s^2
 * [...] to gamma, or -2 beta_s^2/omega_s^2 if it responds statically. For the term beta u^2 of the
 * mode itself, with beta_s = beta and omega_s = omega (2 beta u u_2, u_2 the second-order part of
 * u), the contribution is -(10/9) beta^2/omega^2.
 *
 * Near the resonance, with sigma = Omega - omega, delta = c/2, Gamma = 3 gamma/(8 omega) and F =
 * f/(2 omega), the amplitude of the steady state satisfies
 *
 *    a^2 [delta^2 + (sigma - Gamma a^2)^2] = F^2
 *
 * (Bertrand 2022, 4.110, where the exponent of a inside the bracket is missing; Nayfeh and Mook,
 * Nonlinear Oscillations, 4.1.1). Peak: a = F/delta at sigma = Gamma a^2. At a fold d sigma/d a =
 * 0. With x = sigma - Gamma a^2 this gives a^2 = (delta^2 + x^2)/(2 Gamma x), and y = x/delta is a
 * root of
 *
 *    (1 + y^2)^2/y = 2 Gamma F^2/delta^3,   y of the sign of Gamma.
 *
 * The left side has its minimum 16/(3 sqrt 3) at y = 1/sqrt 3. There are thus two folds or none;
 * the minimum separates them, and both are bracketed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "study/accuracy/scales.h"

double hawser__returned(double beta, double omega_s, double omega)
{
	double w = omega_s*omega_s;

	return -4.0/3.0*beta*beta*(1.0/w + 0.5/(w - 4.0*omega*omega));
}

double hawser__returned_static(double beta, double omega_s)
{
	return -2.0*beta*beta/(omega_s*omega_s);
}

/* Amplitude of the load at the forcing frequency itself. */
static double load_on(const struct hawser_rom *rom, int j, double omega)
{
	double part[2] = {0.0, 0.0};

	for (int i = 0; i < rom->harmonics; i++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[i];

		if (harmonic->k == 1 && harmonic->f)
			part[harmonic->phase == HAWSER_SIN] += harmonic->f[j]*
			                                       pow(omega, harmonic->omega_power);
	}
	return hypot(part[0], part[1]);
}

struct hawser__resonance hawser__resonance_of(const struct hawser_rom *rom, int j)
{
	struct hawser__resonance resonance = {
		.omega = sqrt(rom->K[(size_t)j*rom->n + j]),
		.c = rom->D[(size_t)j*rom->n + j],
	};

	resonance.f = load_on(rom, j, resonance.omega);
	for (int i = 0; i < rom->cubics; i++) {
		const struct hawser_cubic *entry = &rom->C[i];

		if (entry->j == j && entry->k == j && entry->l == j && entry->m == j)
			resonance.cubic += entry->value;
	}
	for (int i = 0; i < rom->quads; i++) {
		const struct hawser_quad *entry = &rom->Q[i];
		size_t s = (size_t)entry->j;

		if (entry->k == j && entry->l == j)
			resonance.cubic += hawser__returned(entry->value, sqrt(rom->K[s*rom->n + s]),
			                                    resonance.omega);
	}
	return resonance;
}

/* The root of (1 + y^2)^2 = ratio*y between low and high, where the difference changes its sign
 * once. */
static double root(double ratio, double low, double high)
{
	int rising = (1.0 + low*low)*(1.0 + low*low) < ratio*low;

	for (int i = 0; i < 200 && high - low > 1e-15*high; i++) {
		double y = 0.5*(low + high), square = (1.0 + y*y)*(1.0 + y*y);

		if ((square < ratio*y) == rising)
			low = y;
		else
			high = y;
	}
	return 0.5*(low + high);
}

struct hawser__scales hawser__scales_solve(const struct hawser__resonance *resonance)
{
	struct hawser__scales answer = {.folds = 0};
	double delta = 0.5*resonance->c, Gamma = 0.375*resonance->cubic/resonance->omega;
	double F = 0.5*resonance->f/resonance->omega, sign = Gamma < 0.0 ? -1.0 : 1.0;
	double ratio = 2.0*fabs(Gamma)*F*F/(delta*delta*delta), least = 1.0/sqrt(3.0);

	answer.peak = F/delta;
	answer.peak_omega = resonance->omega + Gamma*answer.peak*answer.peak;
	if (!(ratio > 16.0*least/3.0) || !isfinite(ratio))
		return answer;
	answer.folds = 2;
	for (int i = 0; i < 2; i++) {
		/* (1 + y^2)^2/y exceeds 1/y and y^3, and thus the ratio at both outer ends */
		double y = i == 0 ? root(ratio, 0.5/ratio, least) : root(ratio, least, 2.0*cbrt(ratio));
		double x = sign*y*delta, square = (delta*delta + x*x)/(2.0*Gamma*x);

		answer.fold[i] = sqrt(square);
		answer.fold_omega[i] = resonance->omega + x + Gamma*square;
	}
	return answer;
}
