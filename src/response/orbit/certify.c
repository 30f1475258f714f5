/* response/orbit/certify.c - a sample of the orbits of a response, computed again by another method.
 *
 * Harmonic balance and shooting share only the force of the model. Harmonic balance uses Fourier
 * coefficients, and multipliers by collocation. Shooting uses an explicit Runge-Kutta flow and
 * multipliers from its exact derivative. Agreement at a few points is evidence that the
 * approximations of neither method affect the curve. The flow of a stiff model would take minutes;
 * its orbits are integrated over one period by an implicit method instead, and must return to their
 * start. With ROUGH times the tolerance its steps are still right to less than the gap that is
 * found (deep-sag.yaml, 42 coordinates: 7.6e-10 with 1e-11 and with 1e-6), since they are as short
 * as the load needs: a footbridge's return to 8e-10 with 1e-6, and to 5e-8 with ROUGHEST. With less
 * than what the orbits are good for, each step follows what the free vibration of stiff
 * coordinates is off by (111 steps in place of 19).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/integrate.h>

#include "core/report.h"
#include "response/orbit/certify.h"
#include "response/torus/circle.h"
#include "response/orbit/method.h"

#define ROUGH 1e3     /* see above; chosen */
#define ROUGHEST 1e-4 /* of steps of the load's own length; chosen */
#define STIFF 100.0        /* largest ratio of the highest frequency to Omega for which the flow is
                            * used; chosen by its cost */
#define NEAR_CIRCLE 1e-6   /* distance from the unit circle below which round-off decides the side
                            * of a multiplier */

static double fastest(const struct hawser_rom *rom)
{
	double top = 0.0;

	for (int j = 0; j < rom->n; j++)
		top = fmax(top, rom->K[j*rom->n + j]);
	return sqrt(top);
}

/* Whether round-off may change the number of unstable multipliers of point p. */
static int on_the_edge(const struct hawser_frf *frf, int p)
{
	const double *multiplier = frf->multiplier + (size_t)p*4*frf->n;

	for (int i = 0; i < 2*frf->n; i++)
		if (fabs(multiplier[2*i]) < NEAR_CIRCLE)
			return 1;
	return 0;
}

/* Whether the multipliers of the orbit differ from those of the point by more than undecided ones
 * explain. */
static int disagrees(const struct hawser__orbit *orbit, const struct hawser_frf_point *point)
{
	struct hawser__circle circle = hawser__circle_count(NULL, orbit->log_modulus,
	                                                    orbit->argument, orbit->m,
	                                                    orbit->product_error,
	                                                    orbit->multiplier_error);

	return circle.unstable > point->unstable + point->undecided ||
	       point->unstable > circle.unstable + circle.undecided;
}

/* Distance of states a and b [2n], relative to b. */
static double distance(const double *a, const double *b, int m)
{
	double gap = 0.0, size = 0.0;

	for (int i = 0; i < m; i++) {
		gap += (a[i] - b[i])*(a[i] - b[i]);
		size += b[i]*b[i];
	}
	return sqrt(gap/fmax(size, 1e-300));
}

/* Point p by shooting, at its Omega; both functions take its frequency and state in the units of its
 * model. */
static enum hawser_status shoot(struct hawser_frf *frf, const struct hawser_rom *rom, int p,
                                double omega, const double *state,
                                const struct hawser_frf_options *options,
                                struct hawser_report *report)
{
	struct hawser_frf_options choice = *options;
	struct hawser__correction correction;
	struct hawser__orbit *orbit = NULL;
	double *row = NULL, *y;
	int again = 1, failed = 0;
	enum hawser_status status;

	choice.begin = omega;
	choice.family = NULL;
	if ((status = hawser__shooting_method.open(&orbit, rom, &choice, report)))
		return status;
	row = calloc(2*(size_t)orbit->size, sizeof *row);
	y = row ? row + orbit->size : NULL;
	status = row ? orbit->ops->from_state(orbit, y, state, choice.begin, report)
	             : hawser__no_memory(report, "frf");
	while (!status && again && !failed) {
		y[orbit->size - 1] = choice.begin;
		orbit->ops->metric(orbit, y);
		row[orbit->size - 1] = orbit->W;
		failed = hawser__orbit_correct(orbit, y, &correction, row, options->tolerance);
		if (!failed)
			status = orbit->ops->refine(orbit, &again, options->tolerance,
			                            choice.begin, report);
	}
	if (!status && !failed)
		status = orbit->ops->multipliers(orbit, report);
	if (!status) {
		frf->sample_gap = fmax(frf->sample_gap,
		                       failed ? INFINITY : distance(y, state, orbit->m));
		frf->sample_disagreements += !failed && disagrees(orbit, &frf->point[p]) &&
		                             !on_the_edge(frf, p);
	}
	free(row);
	orbit->ops->clear(orbit);
	return status;
}

/* Point p integrated over a period. */
static enum hawser_status integrate(struct hawser_frf *frf, const struct hawser_rom *rom,
                                    double omega, const double *state,
                                    const struct hawser_frf_options *options,
                                    struct hawser_report *report)
{
	double period = 2.0*M_PI/omega;
	struct hawser_integrate_options choice = {.omega = omega, .until = period,
		.every = period, .rtol = fmin(ROUGHEST, ROUGH*options->tolerance), .initial = state,
		.method = "radau"};
	struct hawser_trajectory run;
	enum hawser_status status = hawser_integrate(&run, rom, &choice, report);

	if (!status)
		frf->sample_gap = fmax(frf->sample_gap,
		                       distance(run.state + (size_t)(run.rows - 1)*2*rom->n,
		                                state, rom->n));
	hawser_trajectory_clear(&run);
	return status;
}

/* Point p again, in the units of its model; state [2n] is workspace. */
static enum hawser_status certify_point(struct hawser_frf *frf, const struct hawser_rom *rom, int p,
                                        double *state, const struct hawser_frf_options *options,
                                        struct hawser_report *report)
{
	const struct hawser_rom_family *family = options->family;
	double omega, length, time;
	enum hawser_status status;

	if (family && (status = family->model(family->context, &rom, frf->point[p].parameter, report)))
		return status;
	length = frf->length/rom->length;
	time = frf->time/rom->time;
	omega = frf->point[p].omega/time;
	for (int i = 0; i < 2*rom->n; i++)
		state[i] = frf->state[(size_t)p*2*rom->n + i]*(i < rom->n ? length : length/time);
	return fastest(rom) > STIFF*omega ? integrate(frf, rom, omega, state, options, report)
	                                  : shoot(frf, rom, p, omega, state, options, report);
}

enum hawser_status hawser__certify(struct hawser_frf *frf, const struct hawser_rom *rom,
                                   const struct hawser_frf_options *options,
                                   struct hawser_report *report)
{
	int count = options->samples < frf->points ? options->samples : frf->points;
	double *state = malloc(2*(size_t)rom->n*sizeof *state);
	enum hawser_status status = state ? HAWSER_OK : hawser__no_memory(report, "frf");

	for (int i = 0; i < count && !status; i++) {
		int p = (int)((2*(long)i + 1)*frf->points/(2*count));

		status = certify_point(frf, rom, p, state, options, report);
		frf->sampled += !status;
	}
	free(state);
	return status;
}
