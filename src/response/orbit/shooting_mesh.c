/* response/orbit/shooting_mesh.c - the numbers of segments and steps of an orbit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/report.h"
#include "response/orbit/shooting.h"

#define STEP_ANGLE 1.0         /* initial mesh: rad of the fastest mode per step; chosen, refined by
                                * the error */
#define REST_FINER 4           /* times as many steps at rest, where no error of the orbit refines
                                * them: multipliers of 1 rad per step are wrong by up to 1e-6 */
#define STEP_DECAY 3.0         /* e-folds of the strongest damping per step: within the stability
                                * limit */
#define DEFAULT_SEGMENTS 4 /* default number of segments, which divide the growth of unstable
                            * orbits; chosen */
#define MAX_MESH 4000          /* largest number of steps per segment; chosen */

static double fastest(const struct hawser_rom *rom, double omega)
{
	double top = 0.0;

	for (int j = 0; j < rom->n; j++)
		top = fmax(top, rom->K[j*rom->n + j]);
	for (int h = 0; h < rom->harmonics; h++)
		top = fmax(top, pow(rom->harmonic[h].k*omega, 2));
	return sqrt(top);
}

static double strongest(const struct hawser_rom *rom)
{
	double top = 0.0;

	for (int j = 0; j < rom->n; j++)
		top = fmax(top, fabs(rom->D[j*rom->n + j]));
	return top;
}

/* At least one segment for every five e-folds of damping in a period, so that the transition
 * matrices are well conditioned. */
int hawser__shooting_segments(const struct hawser_rom *rom, double omega)
{
	return (int)fmin(HAWSER_MAX_SEGMENTS,
	                 fmax(DEFAULT_SEGMENTS, ceil(strongest(rom)*2.0*M_PI/omega/5.0)));
}

int hawser__shooting_steps(const struct hawser_rom *rom, double omega, int segments)
{
	double rate = fmax(fastest(rom, omega)/STEP_ANGLE, strongest(rom)/STEP_DECAY);

	return (int)fmin(MAX_MESH, fmax(3.0, ceil(2.0*M_PI*rate/omega/segments)));
}

/* The mesh with which the estimated error is half the tolerance; the estimate falls about with
 * h^7. */
static int better_mesh(const struct hawser__shooting *shooting, double tolerance)
{
	double mesh = shooting->base.mesh/shooting->base.X;
	double ratio = pow(fmax(mesh, 1e-300)/(0.5*tolerance), 1.0/7.0);

	return (int)ceil(shooting->steps*fmin(2.0, fmax(0.85, ratio)));
}

/* At rest the mesh is that of the multipliers. */
static enum hawser_status refine_at_rest(struct hawser__shooting *shooting, int *again, double omega,
                                         struct hawser_report *report)
{
	int steps = (int)fmin(MAX_MESH, REST_FINER*hawser__shooting_steps(shooting->base.rom, omega,
	                                                                 shooting->segments));

	*again = shooting->steps < steps;
	return *again ? hawser__shooting_remesh(shooting, steps, report) : HAWSER_OK;
}

/* Fails if the mesh would have to be finer than MAX_MESH. */
enum hawser_status hawser__shooting_refine(struct hawser__orbit *orbit, int *again,
                                           double tolerance, double omega,
                                           struct hawser_report *report)
{
	struct hawser__shooting *shooting = (struct hawser__shooting *)orbit;
	double mesh = orbit->mesh/orbit->X;
	int steps;

	if (orbit->mesh == 0.0)
		return refine_at_rest(shooting, again, omega, report);
	*again = mesh > tolerance;
	if (!*again)
		return HAWSER_OK;
	steps = better_mesh(shooting, tolerance);
	if (steps > MAX_MESH)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "frf", 0, mesh,
		                       "the orbit at Omega %.9g%s needs more than %d integration steps "
		                       "a period for tolerance %.1g (estimated error %.2g): loosen "
		                       "--tolerance", HAWSER_SHOWN(orbit->rom, omega),
		                       MAX_MESH*shooting->segments, tolerance, mesh);
	return hawser__shooting_remesh(shooting, steps, report);
}

enum hawser_status hawser__shooting_relax(struct hawser__orbit *orbit, double tolerance,
                                          struct hawser_report *report)
{
	struct hawser__shooting *shooting = (struct hawser__shooting *)orbit;
	int steps = better_mesh(shooting, tolerance);

	if (steps >= shooting->steps || steps < 3 || shooting->base.mesh == 0.0)
		return HAWSER_OK;
	return hawser__shooting_remesh(shooting, steps, report);
}

enum hawser_status hawser__shooting_enrich(struct hawser__orbit *orbit, int most,
                                           struct hawser_report *report)
{
	struct hawser__shooting *shooting = (struct hawser__shooting *)orbit;

	(void)most;
	return hawser__shooting_remesh(shooting, 2*shooting->steps, report);
}

/* The error falls about with the seventh power of the step. */
enum hawser_status hawser__shooting_sharpen(struct hawser__orbit *orbit, int on,
                                            struct hawser_report *report)
{
	struct hawser__shooting *shooting = (struct hawser__shooting *)orbit;
	int steps = on ? 2*shooting->steps : shooting->coarse;

	shooting->coarse = on ? shooting->steps : 0;
	return hawser__shooting_remesh(shooting, steps, report);
}
