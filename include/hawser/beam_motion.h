/* hawser/beam_motion.h - a travelling beam as a reduced model, and its free motion with an energy
 * balance.
 *
 * E is the energy of the deflection between the supports; the constant energy of the travel is
 * left out:
 *
 *   E = 1/2 int [ (Dy)^2 + r^2 (Dy')^2 + theta y''^2 + T y'^2 ] dx,    D = d/dt + v d/dx
 *
 * dE/dt is the sum of the powers at the supports, of the weight and of the drag
 * (doc/theory-beam.md).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BEAM_MOTION_H
#define HAWSER_BEAM_MOTION_H

#include <hawser/beam.h>
#include <hawser/integrate.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The linear model u'' + D u' + K u = 0 of a beam, with b = B u and B^T M B = 1. Its coordinates
 * are the first `modes` modes at rest; modes = 0: as many as there are functions. B [n][modes or
 * n]. The model is scaled as the beam, and has the beam's units if the beam has any. Release with
 * hawser_rom_clear. HAWSER_ERR_CONVERGENCE (M is not positive definite to double precision),
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser_rom_from_beam(struct hawser_rom *rom, double *B, int modes,
                                        const struct hawser_beam_integrals *integrals,
                                        const struct hawser_beam *beam,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

struct hawser_beam_motion_options {
	double until, every; /* scaled */
	double x;            /* where the deflection is reported; 0: 0.5 */
	/* Deflection y and local rate dy/dt at t = 0: values [points] at equidistant x from 0 to 1,
	 * linearly interpolated. deflection NULL: `amplitude` times sin(pi x), or times sin(pi x)^2
	 * for clamped ends. rate NULL: 0. */
	int points;
	const double *deflection, *rate; /* [points] */
	double amplitude;    /* 0: 0.01 */
	int modes;           /* number of modes at rest used as coordinates; 0: all */
	const char *method;  /* name of a hawser_integrate_method; NULL: "adams" (CVODE) */
	double rtol;         /* 0: 1e-11 */
};

struct hawser_beam_motion {
	int rows;
	double *time;    /* [rows] scaled, as are all following arrays */
	double *y;       /* [rows] deflection at x */
	double *energy;  /* [rows] E */
	double *change;  /* [rows] dE/dt from the matrices of the equation of motion */
	double *ends;    /* [rows] power at the supports */
	double *weight;  /* [rows] power of the weight, (v rho/2) int y'^2 */
	double *drag;    /* [rows] power of the drag, negative */
	double *jacobi;  /* [rows] Jacobi's energy, changed by drag and by the flux of rotary momentum:
	                  * 1/2 int [y_t^2 + r^2 y_t'^2 + theta y''^2 + T y'^2
	                  *          - v^2 (y'^2 + r^2 y''^2)] */
	double *leaves;  /* [rows] rate of `jacobi`: -c int y_t Dy - r^2 v [y_t'^2], the second term for
	                  * free moments only */
	double *material; /* [rows] rate of energy of the material that is now between the supports,
	                   * D (9.5.1): dE/dt plus the energy that the material carries out */
	const char *method; /* static */
	long steps;
};

/* Integrate the free motion. Release with hawser_beam_motion_clear. HAWSER_ERR_ARGUMENT, and the
 * statuses of hawser_rom_from_beam and hawser_integrate. */
enum hawser_status hawser_beam_motion(struct hawser_beam_motion *motion,
                                      const struct hawser_beam_method *method, int size,
                                      const struct hawser_beam *beam,
                                      const struct hawser_beam_motion_options *options,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_beam_motion_clear(struct hawser_beam_motion *motion);

#ifdef __cplusplus
}
#endif
#endif
