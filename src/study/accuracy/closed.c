/* study/accuracy/closed.c - landmarks by the method of multiple scales: the primary resonance of every
 * single mode.
 *
 * A mode responds near its own frequency as if no other mode were excited there, and moves the
 * probes in its own shape. Neglected are the contributions of other modes to the motion, the
 * second-order motion, and the exchange of energy between modes with nearly commensurable
 * frequencies. The landmarks are ordered by frequency, and within one resonance along its bent
 * curve.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/build/model.h"
#include "study/accuracy/respond.h"
#include "study/accuracy/scales.h"

/* The peak of a component, or a fold, of the resonance of one mode. */
struct place {
	double omega, amplitude;
	int turn; /* 0: peak */
};

/* Displacement of a probe along an axis (x, y, z) per unit of the coordinate of mode j. */
static double shape_along(const struct hawser_rom *rom, int j, int probe, int axis)
{
	const struct hawser_rom_shapes *shapes = &rom->shapes;
	const double *phi = shapes->shape + ((size_t)j*shapes->points + probe)*3;
	double xyz[3];

	hawser__shapes_global(xyz, shapes, probe, phi);
	return fabs(xyz[axis]);
}

static double size_of(const struct hawser_rom *rom, int j, double amplitude)
{
	double sum = 0.0;

	for (int i = 0; i < 3*rom->shapes.points; i++)
		sum += pow(amplitude*shape_along(rom, j, i/3, i % 3), 2);
	return sqrt(sum);
}

/* List peak and folds in the order of a branch with increasing Omega. A hardening resonance has its
 * peak first, then the fold at the peak, then the other fold; a softening one has the reverse
 * order. Returns their number. */
static int places_of(struct place place[3], const struct hawser__scales *scales, int forward)
{
	int hardening = scales->folds && scales->fold_omega[0] > scales->fold_omega[1];
	int count = 1 + scales->folds;

	for (int i = 0; i < count; i++) {
		int k = hardening == forward ? i : count - 1 - i;

		place[i] = k == 0 ? (struct place){scales->peak_omega, scales->peak, 0}
		           : (struct place){scales->fold_omega[k - 1], scales->fold[k - 1], 1};
		if (k > 0)
			place[i].turn = (k == 1) == hardening ? 1 : -1;
	}
	return count;
}

/* Add the peak of each component that is not too small. */
static int peaks_at(struct hawser_landmark *list, const struct hawser_rom *rom, int j,
                    const struct hawser_landmark *here, double amplitude)
{
	struct hawser_landmark_options choice = {.smallest = 0.0};
	double most = 0.0;
	int count = 0;

	hawser_landmark_settle(&choice);
	for (int i = 0; i < 3*rom->shapes.points; i++)
		most = fmax(most, shape_along(rom, j, i/3, i % 3));
	for (int i = 0; i < 3*rom->shapes.points; i++) {
		double share = shape_along(rom, j, i/3, i % 3);

		if (!(share > choice.smallest*most))
			continue;
		list[count] = *here;
		list[count].kind = HAWSER_LANDMARK_PEAK;
		list[count].probe = i/3;
		list[count].axis = i % 3;
		list[count++].size = amplitude*share;
	}
	return count;
}

/* Add the landmarks of mode j that are inside the range; `list` is large enough. */
static int add_mode(struct hawser_landmark *list, int *order, const struct hawser_rom *rom, int j,
                    const struct hawser_frf_options *options)
{
	struct hawser__resonance resonance = hawser__resonance_of(rom, j);
	struct hawser__scales scales = hawser__scales_solve(&resonance);
	double low = fmin(options->from, options->to), high = fmax(options->from, options->to);
	struct place place[3];
	int count = 0, places = places_of(place, &scales, options->from < options->to);

	if (!(scales.peak > 0.0) || !isfinite(scales.peak_omega))
		return 0;
	for (int i = 0; i < places; i++) {
		struct hawser_landmark here = {.probe = -1, .axis = -1, .omega = place[i].omega,
		                               .arc = ++*order, .turn = place[i].turn};

		if (!(here.omega > low) || !(here.omega < high))
			continue;
		if (here.turn) {
			here.size = size_of(rom, j, place[i].amplitude);
			list[count++] = here;
		} else {
			count += peaks_at(list + count, rom, j, &here, place[i].amplitude);
		}
	}
	return count;
}

enum hawser_status hawser__study_scales(struct hawser_study_curve *curve,
                                        struct hawser_rom *rom,
                                        const struct hawser_statics *statics,
                                        const struct hawser_scene *scene,
                                        const struct hawser_frf_options *options,
                                        struct hawser_report *report)
{
	size_t room = (size_t)rom->n*(3*(size_t)rom->shapes.points + 2);
	int order = 0, forward = options->from < options->to;

	(void)statics;
	(void)scene;
	curve->landmark = calloc(room + 1, sizeof *curve->landmark);
	if (!curve->landmark)
		return hawser__no_memory(report, "study");
	for (int i = 0; i < rom->n; i++) {
		int j = forward ? i : rom->n - 1 - i;

		if (hawser__resonance_of(rom, j).c <= 0.0)
			return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "study",
			                    "multiple scales: mode %d has no damping, so its peak has no "
			                    "height: give the scene a damping", j + 1);
		curve->landmarks += add_mode(curve->landmark + curve->landmarks, &order, rom, j,
		                             options);
	}
	return HAWSER_OK;
}
