/* hawser/beam.h - a beam or string that travels along itself between two supports, upright, level or
 * inclined: its eigenvalues, the speeds at which it becomes unstable, its free motion.
 *
 * Scaled (doc/theory-beam.md), x from the lower end 0 to the upper end 1, small deflections y(x, t):
 *
 *   theta y'''' - (T y')' + c Dy + (1 - r^2 d^2/dx^2) DDy = 0,    T(x) = tension - rho (1 - x),
 *   D = d/dt + v d/dx,   DDy = d2y/dt2 + 2 v d2y/dxdt + v^2 y''
 *
 * D (8.3.1) has theta = 1 and tension = mu^2, D (8.3.4) theta = 0 (string) and D (9.3.1) tension = 1.
 * References: Dehadrai 2018 (D), chapters 8 and 9; Wickert and Mote 1990.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BEAM_H
#define HAWSER_BEAM_H

#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_beam_ends {
	HAWSER_ENDS_SIMPLE = 0, /* y = 0 and no moment */
	HAWSER_ENDS_CLAMPED     /* y = 0 and y' = 0 */
};

/* What the moment at a simple end does with the rotary momentum that the cable carries through it. */
enum hawser_beam_moment {
	HAWSER_MOMENT_FREE = 0, /* theta y'' = 0, as D: the momentum is fed in and taken out by the supports */
	HAWSER_MOMENT_BALANCED  /* theta y'' = r^2 v Dy': nothing but the flux of momentum */
};

struct hawser_beam {
	double theta;   /* bending rigidity, >= 0 */
	double tension; /* at x = 1, > 0 */
	double weight;  /* rho: by how much the tension falls from x = 1 to x = 0 */
	double drag;    /* c >= 0 */
	double rotary;  /* r^2 = 1/S_R^2 of D (8.3.1), S_R^2 of D (9.3.1) */
	double speed;   /* v, from x = 0 to x = 1 */
	enum hawser_beam_ends ends;
	enum hawser_beam_moment moment; /* simple ends only */
	double length, time; /* units, m and s; 0 where the beam was given without dimensions */
};

/* What a discretisation makes of y = sum of b_k s_k(x): integrals over [0, 1] that no parameter of the
 * beam enters, each [n][n] row-major, zero where |j - k| > band. */
struct hawser_beam_integrals {
	int n, band;
	double *ss, *s1s1, *s2s2; /* s_j s_k, s_j' s_k', s_j'' s_k'' */
	double *xs1s1;            /* x s_j' s_k' */
	double *ss1, *s1s2;       /* s_j s_k', s_j' s_k'' */
};

/* A discretisation is a row. `size` functions, or elements; fill() makes *integrals, which
 * hawser_beam_integrals_clear releases. Statuses: _ARGUMENT (size < 1, or fewer than a clamped beam
 * needs), _MEMORY. */
struct hawser_beam_method {
	const char *name, *summary, *source;
	enum hawser_status (*fill)(struct hawser_beam_integrals *integrals, enum hawser_beam_ends ends,
	                           int size, struct hawser_report *report);
	/* s [n] the functions' values at x, or their derivatives by the order 0 to 2 */
	void (*at)(double *s, enum hawser_beam_ends ends, int size, int derivative, double x);
};
/* The rows, *count of them, the default first. Static storage. */
const struct hawser_beam_method *hawser_beam_methods(int *count);
void hawser_beam_integrals_clear(struct hawser_beam_integrals *integrals);

/* M b'' + C b' + K b = 0; M, C, K [n][n] row-major, given by the caller. */
void hawser_beam_matrices(double *M, double *C, double *K,
                          const struct hawser_beam_integrals *integrals,
                          const struct hawser_beam *beam);

/* An eigenvalue of the beam: y = Re[shape exp(l t)]. */
struct hawser_beam_eigenvalue {
	double re, im;    /* scaled, im >= 0: of a pair, the one above the real axis */
	double residual;  /* backward error: |(l^2 M + l C + K) b| over the norms' sum */
	double condition; /* by how much relative errors of M, C and K can grow in l */
};

/* The `count` eigenvalues of least modulus, ascending, in value [count], and the coefficients' vectors in
 * vector [count][2][n] (real and imaginary parts), or NULL. An undamped beam's eigenvalue on the imaginary
 * axis has re = 0 exactly. *found may be less than count. HAWSER_ERR_ARGUMENT (count, beam: theta,
 * tension, drag or rotary out of range), HAWSER_ERR_CONVERGENCE, HAWSER_ERR_NAN, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_beam_eigenvalues(struct hawser_beam_eigenvalue *value, double *vector,
                                           int *found, const struct hawser_beam_integrals *integrals,
                                           const struct hawser_beam *beam, int count,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
