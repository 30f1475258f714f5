/* beam/spectrum.c - the eigenvalues of a travelling beam.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "beam/sample.h"
#include "core/report.h"
#include "modes/complex/quadratic.h"

static const double pi = 3.14159265358979323846;

enum hawser_status hawser__beam_check(const struct hawser_beam *beam, struct hawser_report *report)
{
	if (!(beam->theta >= 0.0) || !(beam->tension > 0.0) || !(beam->drag >= 0.0) ||
	    !(beam->rotary >= 0.0) || !isfinite(beam->theta + beam->tension + beam->drag + beam->rotary +
	                                        beam->weight + beam->speed))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "beam",
		                    "theta %g, drag %g, rotary inertia %g (none negative), tension %g "
		                    "(positive), weight %g, speed %g: one is out of range", beam->theta,
		                    beam->drag, beam->rotary, beam->tension, beam->weight, beam->speed);
	return HAWSER_OK;
}

double hawser__beam_rest_frequency(const struct hawser_beam *beam)
{
	double k = beam->theta*pow(pi, 4.0) + beam->tension*pi*pi;

	return sqrt(k/(1.0 + beam->rotary*pi*pi));
}

int hawser__beam_flux(const struct hawser_beam *beam)
{
	return beam->rotary > 0.0 && beam->ends == HAWSER_ENDS_SIMPLE &&
	       beam->moment == HAWSER_MOMENT_FREE;
}

int hawser__beam_gyroscopic(const struct hawser_beam *beam)
{
	return beam->drag == 0.0 && (!hawser__beam_flux(beam) || beam->speed == 0.0);
}

enum hawser_status hawser_beam_eigenvalues(struct hawser_beam_eigenvalue *value, double *vector,
                                           int *found, const struct hawser_beam_integrals *is,
                                           const struct hawser_beam *beam, int count,
                                           struct hawser_report *report)
{
	return hawser__beam_eigen(value, vector, NULL, found, is, beam, count, report);
}

enum hawser_status hawser__beam_eigen(struct hawser_beam_eigenvalue *value, double *vector,
                                      double *left, int *found,
                                      const struct hawser_beam_integrals *is,
                                      const struct hawser_beam *beam, int count,
                                      struct hawser_report *report)
{
	size_t square = (size_t)is->n*(size_t)is->n;
	double *M = NULL, shift;
	struct hawser__eigenvalue *got = NULL;
	struct hawser__quadratic system = {.n = is->n, .gyroscopic = hawser__beam_gyroscopic(beam)};
	enum hawser_status status = hawser__beam_check(beam, report);

	*found = 0;
	if (status)
		return status;
	shift = 0.61803*hawser__beam_rest_frequency(beam); /* far from simple multiples of it */
	if (!isfinite(shift))
		return hawser__fail(report, HAWSER_ERR_NAN, "beam",
		                    "theta %g and tension %g make frequencies beyond double precision",
		                    beam->theta, beam->tension);
	if (count < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "beam", "%d eigenvalues: at least 1", count);
	M = malloc(3*square*sizeof *M);
	got = malloc((size_t)count*sizeof *got);
	if (!M || !got) {
		status = hawser__no_memory(report, "beam");
		goto done;
	}
	hawser_beam_matrices(M, M + square, M + 2*square, is, beam);
	system.M = M;
	system.C = M + square;
	system.K = M + 2*square;
	status = hawser__quadratic_eigen(got, vector, left, found, &system, shift, count, report);
	if (status == HAWSER_ERR_CONVERGENCE) /* the shift may coincide with a real eigenvalue */
		status = hawser__quadratic_eigen(got, vector, left, found, &system, 1.37*shift, count,
		                                 report);
	for (int i = 0; i < *found; i++)
		value[i] = (struct hawser_beam_eigenvalue){got[i].re, got[i].im, got[i].residual,
		                                           got[i].condition};
done:
	free(M);
	free(got);
	return status;
}
