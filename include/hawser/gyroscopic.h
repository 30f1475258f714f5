/* hawser/gyroscopic.h - linear modes of a travelling cable about its steady state.
 *
 * With q the coordinates of the resting modes of the apparent cable (struct hawser_motion), whose K
 * is diag(omega^2) and positive,
 *
 *   q'' + 2 nu G q' + K q = 0,    G skew (hawser_modes_convection)
 *
 * and (K^1/2 q, q') turns by a real skew matrix: its eigenvalues are +-i omega, with no real part
 * by construction. The shapes are complex; a motion is the real part of (shape) exp(i omega t).
 *
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
	double residual;  /* relative error of the eigenvalue as the method estimates it */
	double condition; /* by how much a relative error of the matrices can grow in the eigenvalue */
	enum hawser_plane plane;
	int place, number; /* from 1, by im: among all modes, and among those of its plane */
	/* Shares of the integral of |Phi|^2: along the cable, across it, out of its plane. Sum 1. */
	double axial_share, normal_share, out_of_plane_share;
	/* Share of the true kinetic energy, that of particles as they move past the supports, in the
	 * waves that run with the cable, 0 to 1: 1/2 at rest, and less the faster a cable travels, as
	 * the waves against the travel are the slow and steep ones */
	double downstream;
};

struct hawser_complex_modes {
	struct hawser_statics statics;
	const char *method;
	int n;            /* ascending im, both planes together */
	int basis;        /* functions a component */
	double time_unit; /* s */
	struct hawser_complex_mode *mode; /* [n] */
	struct hawser_grid grid;
	double *shape;    /* [n][2][points][3] real and imaginary parts of P, Q, B; the integral of
	                   * |Phi|^2 is 1, and its largest component is real and positive at its largest */
	double *slope;    /* [n][2][points][3] those of a, b, c */
};

/* A method is a row, as for the modes at rest (struct hawser_modes_method). */
struct hawser_complex_modes_method {
	const char *name, *summary, *source;
	double tolerance; /* default; INFINITY: any error is taken, and stated */
	enum hawser_status (*solve)(struct hawser_complex_modes *modes,
	                            const struct hawser_statics *statics,
	                            const struct hawser_modes_options *options,
	                            struct hawser_report *report);
};
/* The rows, *count of them. Static storage. */
const struct hawser_complex_modes_method *hawser_complex_modes_methods(int *count);

/* Settings as for the modes at rest: options->method NULL is "spectral". Statuses of
 * hawser_modes_solve. At speed 0 the row "spectral" gives the frequencies and shapes of the resting
 * row of that name, to the last bit (shapes to a sign). Release with hawser_complex_modes_clear. */
enum hawser_status hawser_complex_modes_solve(struct hawser_complex_modes *modes,
                                              const struct hawser_statics *statics,
                                              const struct hawser_modes_options *options,
                                              struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_complex_modes_clear(struct hawser_complex_modes *modes);

/* Shape and local-frame derivative of mode k at scaled arclength s: shape[6] is the real P, Q, B
 * and the imaginary ones, slope[6] those of a, b, c; slope may be NULL. */
void hawser_complex_modes_at(const struct hawser_complex_modes *modes, double *shape, double *slope,
                             int k, double s);

/* The parts of the shape of mode k at s that run with the cable and against it, by the local speeds
 * of waves: downstream[6] and upstream[6], real and imaginary, whose sum is the shape. */
void hawser_complex_modes_waves(const struct hawser_complex_modes *modes, double *downstream,
                                double *upstream, int k, double s);

/* error [modes->n], as hawser_modes_compare: `frequency` is the distance of the eigenvalues over
 * the modulus of the reference's, `shape` the smallest distance of any phase. Statuses as there. */
enum hawser_status hawser_complex_modes_compare(struct hawser_modes_error *error,
                                                const struct hawser_complex_modes *modes,
                                                const struct hawser_complex_modes *reference,
                                                struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
