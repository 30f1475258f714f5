/* hawser/gyroscopic.h - linear modes of a travelling cable about its steady state.
 *
 * Let q be the coordinates of the modes of the apparent cable at rest (struct hawser_motion), whose
 * stiffness K = diag(omega^2) is positive. Then
 *
 *   q'' + 2 nu G q' + K q = 0,    G skew (hawser_modes_convection)
 *
 * and the state (K^1/2 q, q') satisfies a first-order system with a real skew matrix. Its
 * eigenvalues are +-i omega, with a real part of exactly 0. The shapes are complex; a motion is the
 * real part of (shape) exp(i omega t).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_GYROSCOPIC_H
#define HAWSER_GYROSCOPIC_H

#include <hawser/modes.h>

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_complex_mode {
	double re, im;    /* eigenvalue, scaled (modes.h); im >= 0, its conjugate is left out */
	double residual;  /* error estimate, not a residual: estimated relative error of the
	                   * eigenvalue */
	double condition; /* condition number: the largest ratio of the relative error of the eigenvalue
	                   * to that of the matrices */
	enum hawser_plane plane;
	int place, number; /* from 1, by im: among all modes, and among those of its plane */
	/* Shares of the integral of |Phi|^2: along the cable, across it, out of its plane. Sum 1. */
	double axial_share, normal_share, out_of_plane_share;
	/* Share, 0 to 1, of the kinetic energy of the particles, travel included, that belongs to the
	 * waves running downstream: 1/2 at rest. It decreases with the speed, since the waves running
	 * upstream are slower and steeper. */
	double downstream;
};

struct hawser_complex_modes {
	struct hawser_statics statics;
	const char *method;
	int n;            /* number of modes, by ascending im, both planes together */
	int basis;        /* functions per component */
	double time_unit; /* s */
	struct hawser_complex_mode *mode; /* [n] */
	struct hawser_grid grid;
	double *shape;    /* [n][2][points][3] real and imaginary parts of P, Q, B; the integral of
	                   * |Phi|^2 is 1, and the dominant component is real and positive where its
	                   * modulus is largest */
	double *slope;    /* [n][2][points][3] those of a, b, c */
};

/* A method, as struct hawser_modes_method is one for the modes at rest. */
struct hawser_complex_modes_method {
	const char *name, *summary, *source;
	double tolerance; /* default; INFINITY: any error estimate is accepted and reported */
	enum hawser_status (*solve)(struct hawser_complex_modes *modes,
	                            const struct hawser_statics *statics,
	                            const struct hawser_modes_options *options,
	                            struct hawser_report *report);
};
/* The table of methods, [*count]. Static storage. */
const struct hawser_complex_modes_method *hawser_complex_modes_methods(int *count);

/* Compute complex modes, with the settings and statuses of hawser_modes_solve; options->method NULL
 * is "spectral". At speed 0 the method "spectral" gives the same frequencies and shapes as the
 * method of that name for modes at rest, to the last bit (shapes up to a sign). Release with
 * hawser_complex_modes_clear. */
enum hawser_status hawser_complex_modes_solve(struct hawser_complex_modes *modes,
                                              const struct hawser_statics *statics,
                                              const struct hawser_modes_options *options,
                                              struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_complex_modes_clear(struct hawser_complex_modes *modes);

/* Shape and local-frame derivative of mode k at scaled arclength s: shape[6] has the real parts of
 * P, Q, B, then the imaginary parts; slope[6] has those of a, b, c and may be NULL. */
void hawser_complex_modes_at(const struct hawser_complex_modes *modes, double *shape, double *slope,
                             int k, double s);

/* The shape of mode k at s as the sum of a wave running downstream (with the cable) and a wave
 * running upstream, separated by the local wave speeds: downstream[6] and upstream[6], ordered as
 * shape[6]. */
void hawser_complex_modes_waves(const struct hawser_complex_modes *modes, double *downstream,
                                double *upstream, int k, double s);

/* error [modes->n], as for hawser_modes_compare: `frequency` is the distance of the eigenvalues
 * over the modulus of the reference eigenvalue, `shape` the distance of the shapes minimised over
 * the phase. Statuses of hawser_modes_compare. */
enum hawser_status hawser_complex_modes_compare(struct hawser_modes_error *error,
                                                const struct hawser_complex_modes *modes,
                                                const struct hawser_complex_modes *reference,
                                                struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
