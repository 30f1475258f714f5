/* bench/estimates-beam.c - hawser beam: the error of any discretisation (estimates.h), against
 * twice as many functions of the default one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <stdlib.h>

#include "bench/estimates.h"

enum { MOST = 6 };

static const struct hawser_beam_method *any_method(struct chance *chance)
{
	int count = 0;

	while (hawser_beam_method(count))
		count++;
	return hawser_beam_method(chance_int(chance, 0, count - 1));
}

static int eigenvalues(struct hawser_beam_eigenvalue *value, const struct hawser_beam_method *method,
                       const struct hawser_beam *beam, int size, int count)
{
	struct hawser_beam_integrals is;
	int found = 0, failed;

	if (method->fill(&is, beam->ends, size, NULL))
		return 1;
	failed = hawser_beam_eigenvalues(value, NULL, &found, &is, beam, count, NULL) != HAWSER_OK;
	hawser_beam_integrals_clear(&is);
	return failed || found < count;
}

int estimate_beam(struct tally *tally, struct chance *chance)
{
	int size, modes = chance_int(chance, 1, 4);
	const struct hawser_beam_method *method = any_method(chance);
	struct hawser_beam beam = {
		.theta = chance_unit(chance) < 0.1 ? 0.0 : chance_log(chance, 1e-3, 10.0), .tension = 1.0,
		.weight = chance_unit(chance) < 0.5 ? 0.0 : chance_between(chance, 0.0, 0.9),
		.drag = chance_unit(chance) < 0.5 ? 0.0 : chance_log(chance, 1e-3, 1.0),
		.rotary = chance_unit(chance) < 0.5 ? 0.0 : chance_log(chance, 1e-6, 1e-3),
		.ends = chance_unit(chance) < 0.5 ? HAWSER_ENDS_SIMPLE : HAWSER_ENDS_CLAMPED};
	struct hawser_beam_eigenvalue got[MOST], right[MOST];
	double error, tolerance = chance_log(chance, 1e-10, 1e-3);

	if (beam.theta == 0.0)
		beam.ends = HAWSER_ENDS_SIMPLE;
	/* slower than waves in bars: else no discretisation settles (src/beam/critical.c) */
	beam.rotary = fmin(beam.rotary, 0.5*beam.theta);
	beam.speed = sqrt(1.0 - beam.weight)*chance_between(chance, 0.0, 0.95);
	if (hawser_beam_size(&size, &error, method, &beam, modes, tolerance, NULL) ||
	    eigenvalues(got, method, &beam, size, modes) ||
	    eigenvalues(right, hawser_beam_method(0), &beam, size > 50 ? 120 : 2*size + 20, MOST))
		return 1;
	for (int k = 0; k < modes; k++) {
		double complex l = got[k].re + I*got[k].im;
		double best = INFINITY;

		for (int j = 0; j < MOST; j++)
			best = fmin(best, cabs(right[j].re + I*right[j].im - l)/cabs(l));
		tally_note(tally, best, error, "%s, %d functions for %.1g: eigenvalue %d of %d, %.9g%+.9gi, "
		           "theta %.2g, weight %.2g, drag %.2g, rotary %.2g, speed %.4g, %s, condition %.1g",
		           method->name, size, tolerance, k + 1, modes, got[k].re, got[k].im,
		           beam.theta, beam.weight, beam.drag, beam.rotary, beam.speed,
		           beam.ends == HAWSER_ENDS_SIMPLE ? "simple" : "clamped", got[k].condition);
	}
	return 0;
}
