/* hawser/beam_motion.h - a travelling beam as a reduced model, and its free motion with its energy.
 *
 * E is the energy between the supports, of the deflection alone (constants of the travel left out):
 *
 *   E = 1/2 int [ (Dy)^2 + r^2 (Dy')^2 + theta y''^2 + T y'^2 ] dx,    D = d/dt + v d/dx
 *
 * It changes by what enters at the supports, by the weight, and by drag (doc/theory-beam.md).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BEAM_MOTION_H
#define HAWSER_BEAM_MOTION_H

#include <hawser/beam.h>
#include <hawser/integrate.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The linear model u'' + D u' + K u = 0 of a beam, b = B u with B^T M B = 1: of the first `modes` modes
 * at rest, or, with 0, of all functions. B [n][modes or n]. In the beam's scale, with its units
 * where it has any. Release with hawser_rom_clear. HAWSER_ERR_CONVERGENCE (M is not positive to double
 * precision), HAWSER_ERR_MEMORY. */
enum hawser_status hawser_rom_from_beam(struct hawser_rom *rom, double *B, int modes,
                                        const struct hawser_beam_integrals *integrals,
                                        const struct hawser_beam *beam,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

struct hawser_beam_motion_options {
	double until, every; /* scaled */
	double x;            /* where the deflection is told; 0 stands for 0.5 */
	/* Deflection and its local rate dy/dt at t = 0 over x, values [points] at equidistant x from 0 to 1
	 * with straight lines between them; deflection NULL: `amplitude` times sin(pi x) (its square for
	 * clamped ends), rate NULL: none. */
	int points;
	const double *deflection, *rate; /* [points] */
	double amplitude;    /* 0 stands for 0.01 */
	int modes;           /* coordinates: the first modes at rest; 0: all functions */
	const char *method;  /* of hawser_integrate_method; NULL: "adams", which is CVODE */
	double rtol;         /* 0: 1e-11 */
};

struct hawser_beam_motion {
	int rows;
	double *time;    /* [rows] scaled, as all that follows */
	double *y;       /* [rows] deflection at x */
	double *energy;  /* [rows] E */
	double *change;  /* [rows] dE/dt from the equation of motion's matrices */
	double *ends;    /* [rows] power that enters at the supports */
	double *weight;  /* [rows] power of the weight, (v rho/2) int y'^2 */
	double *drag;    /* [rows] power of the drag, negative */
	double *jacobi;  /* [rows] 1/2 int [y_t^2 + r^2 y_t'^2 + theta y''^2 + T y'^2 - v^2 (y'^2 + r^2
	                  * y''^2)],
	                  * which nothing but drag and the flux of rotary momentum changes */
	double *leaves;  /* [rows] its rate: -c int y_t Dy - r^2 v [y_t'^2], the latter with free moments */
	double *material; /* [rows] rate of the energy of the material that is between the supports now,
	                   * D (9.5.1): dE/dt and what leaves with it */
	const char *method; /* static */
	long steps;
};

/* Free motion. Release with hawser_beam_motion_clear. HAWSER_ERR_ARGUMENT, statuses of
 * hawser_rom_from_beam and hawser_integrate. */
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
