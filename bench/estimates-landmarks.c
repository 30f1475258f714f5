/* bench/estimates-landmarks.c - folds and peaks of a response by hawser compare: uncertainties of
 * Omega and size (estimates.h), against the same branch by shooting with a tolerance of 1e-12 in
 * shorter steps, with every peak refined again.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "bench/estimates.h"
#include "study/accuracy/landmark.h"

enum { POINTS = 800, MOST = 2 };
static const double wanted = 2e-6; /* of peaks, as in src/study/accuracy/run.c */
static const double sharp = 1e-13; /* tolerance of the reference's peaks: as small as possible */

static int landmarks_of(struct hawser_study_curve *curve, const struct hawser_rom *rom,
                        const struct hawser_frf_options *options, double known)
{
	struct hawser_frf_options again = *options;
	const struct hawser__sharpening how = {.wanted = known};

	*curve = (struct hawser_study_curve){.n = rom->n};
	if (hawser_frf_trace(&curve->frf, rom, options, NULL) ||
	    curve->frf.end == HAWSER_END_MAX_POINTS ||
	    hawser_landmarks(&curve->landmark, &curve->landmarks, &curve->frf, NULL, NULL))
		return 1;
	again.method = curve->frf.method;
	return hawser__study_sharpen(curve, rom, &again, &how, NULL) != HAWSER_OK;
}

static void note(struct tally *tally, const struct hawser_study_curve *curve,
                 const struct hawser_landmark *own, const struct hawser_landmark *right)
{
	const char *kind = own->kind == HAWSER_LANDMARK_FOLD ? "fold" : "peak";

	/* references with a larger uncertainty are not used */
	if (right->omega_error < 0.3*own->omega_error)
		tally_note(tally, fabs(own->omega/right->omega - 1.0), own->omega_error,
		           "%s by %s, n %d, of probe %d.%d: Omega %.9g (%.1g)", kind, curve->frf.method,
		           curve->n, own->probe, own->axis, own->omega, right->omega_error);
	if (right->size_error < 0.3*own->size_error)
		tally_note(tally, fabs(own->size/right->size - 1.0), own->size_error,
		           "%s by %s, n %d, of probe %d.%d: size %.6g at Omega %.9g (%.1g)", kind,
		           curve->frf.method, curve->n, own->probe, own->axis, own->size, own->omega,
		           right->size_error);
}

int estimate_landmarks(struct tally *tally, struct chance *chance)
{
	struct hawser_study_curve curve = {.n = 0}, right = {.n = 0};
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_rom rom;
	int *partner = NULL, strong = chance_unit(chance) < 0.5, refused;
	double first;

	/* a cable, since oscillators have no probes; a small one, to save time */
	while (estimate_model(&rom, chance, strong) || rom.shapes.points == 0 || rom.n > MOST)
		hawser_rom_clear(&rom);
	first = sqrt(rom.K[0]);
	options.from = first*chance_between(chance, 0.6, 0.95);
	options.to = first*chance_between(chance, 1.05, 1.4);
	options.max_points = POINTS;
	options.samples = HAWSER_NONE;
	refused = landmarks_of(&curve, &rom, &options, wanted);
	options.method = "shooting";
	options.tolerance = 1e-12;
	options.event_tolerance = 1e-13;
	options.step_max *= 0.4;
	options.max_points = 4*POINTS;
	refused = refused || landmarks_of(&right, &rom, &options, sharp);
	partner = calloc((size_t)curve.landmarks + 1, sizeof *partner);
	refused = refused || !partner ||
	          hawser_landmarks_match(partner, curve.landmark, curve.landmarks, right.landmark,
	                                 right.landmarks, NULL, NULL);
	for (int k = 0; !refused && k < curve.landmarks; k++)
		if (partner[k] >= 0)
			note(tally, &curve, &curve.landmark[k], &right.landmark[partner[k]]);
	free(partner);
	hawser_study_clear(&curve);
	hawser_study_clear(&right);
	hawser_rom_clear(&rom);
	return refused;
}
