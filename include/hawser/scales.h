/* hawser/scales.h - the method of multiple scales, derived by program for any model of rom.h:
 * equations for the slowly varying amplitudes of a few nearly resonant modes under a harmonic load.
 *
 * A set R of modes responds near multiples of the forcing frequency, mode r near p_r Omega:
 *
 *    u_r = A_r exp(i p_r Omega t) + its conjugate + second order,
 *    2 i p_r Omega dA_r/dt = -G_r(A, Omega),
 *    G_r = (omega_r^2 - p_r^2 Omega^2) A_r + i p_r Omega sum D_rs A_s (s in R with p_s = p_r)
 *          + sum of monomials of first to third degree in A and its conjugate - F_r
 *
 * The monomials are the terms of Q and C at exp(i p_r Omega t): resonant products of two
 * amplitudes, products of three amplitudes, and products of an amplitude with the second-order
 * response of any mode, resonant or not, to two amplitudes. Terms are evaluated at the reference
 * frequency Omega_0. Parametric terms (D and K of a harmonic) count as second order, that is as
 * small as an amplitude. A load that is not near resonance with a mode of R at its own frequency
 * (super- and subharmonic resonance) acts through the direct response to it, which counts as first
 * order.
 *
 * Source: Nayfeh and Mook, Nonlinear Oscillations, 1979; Bertrand 2022, 4.3, corrected
 * (doc/theory-scales.md).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCALES_H
#define HAWSER_SCALES_H

#include <hawser/frf.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HAWSER_RESONANT_MOST = 8 };

/* The resonant modes, from hawser_resonance_find or chosen by the caller. */
struct hawser_resonance {
	int count;                        /* number of modes in R, 1 to HAWSER_RESONANT_MOST */
	int mode[HAWSER_RESONANT_MOST];   /* their indices, ascending */
	int order[HAWSER_RESONANT_MOST];  /* p, >= 1 */
	double omega0;                    /* scaled reference frequency Omega_0 */
};

/* A term of equation r: a coefficient times up to three amplitudes. A factor v < count is A_v, v >=
 * count is the conjugate of A_(v - count), -1 is none. */
struct hawser_monomial {
	int equation;
	int factor[3];
	double re, im;
};

/* A term of u at first order: an amplitude (or 1, for a direct response) times c exp(i h Omega t). */
struct hawser_carrier {
	int variable; /* a factor as in struct hawser_monomial */
	int h;
	double *c;    /* [n][2] */
};

/* A term of u at second order: the product of up to two amplitudes (-1: none), times c exp(i h
 * Omega t). */
struct hawser_answer {
	int factor[2];
	int h;
	double *c; /* [n][2] */
};

struct hawser_modulation {
	const struct hawser_rom *rom; /* not owned */
	struct hawser_resonance resonance;
	int monomials;
	struct hawser_monomial *monomial; /* [monomials] by equation, degree, factors */
	int carriers;
	struct hawser_carrier *carrier;   /* [carriers] */
	int answers;
	struct hawser_answer *answer;     /* [answers] of second order */
	/* The smallest |omega_s^2/(h Omega_0)^2 - 1| over modes s outside R and harmonics h of the
	 * second order. If it is small, s should be in R */
	double nearest;
	int nearest_mode, nearest_harmonic;
};

/* Find the modes that are near resonance at 1, 2 or 3 times a forcing frequency between the scaled
 * frequencies `from` and `to`. HAWSER_ERR_ARGUMENT (none, or more than HAWSER_RESONANT_MOST: the
 * message lists them; choose a narrower range, or name the modes). */
enum hawser_status hawser_resonance_find(struct hawser_resonance *resonance,
                                         const struct hawser_rom *rom, double from, double to,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* Derive the equations. Release with hawser_modulation_clear. HAWSER_ERR_ARGUMENT (indices, orders,
 * K not diagonal, a model with the exact energy), HAWSER_ERR_NO_SOLUTION (a mode outside R is
 * exactly resonant), HAWSER_ERR_MEMORY. */
enum hawser_status hawser_modulation_derive(struct hawser_modulation *modulation,
                                            const struct hawser_rom *rom,
                                            const struct hawser_resonance *resonance,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_modulation_clear(struct hawser_modulation *modulation);

/* G [2 count], real parts then imaginary parts, at x [2 count] (real and imaginary parts of A) and
 * Omega; its derivatives by_x [2 count][2 count] and by_omega [2 count], both or neither NULL. No
 * allocation. */
void hawser_modulation_equations(const struct hawser_modulation *modulation, double *G,
                                 double *by_x,
                                 double *by_omega, const double *x, double omega);

/* state [2n], u then du/dt, at phase 0, for x [2 count] as above. */
void hawser_modulation_state(const struct hawser_modulation *modulation, double *state,
                             const double *x, double omega);

/* u [n] (first and second order) at phase tau, for x [2 count]. */
void hawser_modulation_motion(const struct hawser_modulation *modulation, double *u,
                              const double *x,
                              double tau);

/* --- subharmonic resonance --- */

/* Make 1/b of the frequency of the load the base frequency of the model, in place: harmonics k
 * become k b, and Omega is then the frequency of the motion. HAWSER_ERR_ARGUMENT. */
enum hawser_status hawser_subharmonic_base(struct hawser_rom *rom, int b,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

/* Find a subharmonic or superharmonic motion of one resonant mode of order 1 under a load with k =
 * 2 or 3: amplitude x [2] and *omega at an end of the range, or within the range if it does not
 * exist at the ends. HAWSER_ERR_NO_SOLUTION: there is none. HAWSER_ERR_ARGUMENT: other terms, or
 * more than one mode. */
enum hawser_status hawser_subharmonic_start(const struct hawser_modulation *modulation, double *x,
                                            double *omega, double from, double to,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
