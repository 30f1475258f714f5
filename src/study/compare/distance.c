/* study/compare/distance.c - the distance of two responses of a scene.
 *
 * It is the larger of two numbers. The first is the largest difference of matched folds and peaks
 * (match.c), which are located far more accurately than the curve between the points. The second is
 * the distance of the whole curves (curve.c): it detects parts that only one response has, and
 * differences of responses without landmarks. A landmark without a partner adds nothing by itself;
 * its distance from the other curve is part of the second number.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "hawser/accuracy.h"
#include "study/compare/distance.h"
#include "study/accuracy/landmark.h"

static const struct hawser_landmark_options strong = {
	.smallest = 0.2, .faintest = 0.5, .prominence = 0.1};
static const double faint = 0.4; /* smallest component that may have partners, relative; chosen */
static const struct hawser_landmark_options weak = {.smallest = 0.15, .prominence = 0.02};

static int same(const struct hawser_landmark *a, const struct hawser_landmark *b)
{
	return a->kind == b->kind && a->probe == b->probe && a->axis == b->axis && a->arc == b->arc;
}

/* Select the landmarks that count. Both lists are of one response; the peaks are not yet
 * sharpened. */
static enum hawser_status mark_strong(struct hawser__marks *marks, const struct hawser_frf *frf,
                                      struct hawser_report *report)
{
	struct hawser_landmark *list, largest[2];
	int count;
	enum hawser_status status = hawser_landmarks(&list, &count, frf, &strong, report);

	if (status)
		return status;
	marks->strong = calloc((size_t)marks->count + 1, 1);
	for (int i = 0; marks->strong && i < marks->count; i++)
		for (int k = 0; k < count; k++)
			if (same(&marks->item[i], &list[k]))
				marks->strong[i] = 1;
	hawser__largest_peaks(largest, frf, marks->item, marks->count);
	for (int i = 0; marks->strong && i < marks->count; i++)
		marks->strong[i] |= same(&marks->item[i], &largest[0]) || same(&marks->item[i], &largest[1]);
	free(list);
	return marks->strong ? HAWSER_OK : hawser__no_memory(report, "accuracy");
}

/* Without peaks of faint components. */
static void drop_faint(struct hawser__marks *marks)
{
	int count = 0;

	for (int i = 0; i < marks->count; i++) {
		const struct hawser_landmark *item = &marks->item[i];

		if (item->probe < 0 ||
		    hawser__curve_reaches(&marks->curve, 1 + hawser__peak_column(item), faint))
			marks->item[count++] = *item;
	}
	marks->count = count;
}

enum hawser_status hawser__marks_find(struct hawser__marks *marks, const struct hawser_frf *frf,
                                      const struct hawser_rom *rom,
                                      const struct hawser_frf_options *options, double wanted,
                                      struct hawser_report *report)
{
	enum hawser_status status;

	*marks = (struct hawser__marks){0};
	status = hawser__curve_copy(&marks->curve, frf, report);
	if (!status)
		status = hawser_landmarks(&marks->item, &marks->count, frf, &weak, report);
	if (!status) {
		drop_faint(marks);
		status = mark_strong(marks, frf, report);
	}
	if (!status && rom) {
		/* a shallow copy: the response stays with the caller */
		struct hawser_study_curve curve = {.frf = *frf, .landmark = marks->item,
			.landmarks = marks->count};
		const struct hawser__sharpening how = {.wanted = wanted, .known = wanted};

		status = hawser__study_sharpen(&curve, rom, options, &how, report);
	}
	if (status)
		hawser__marks_clear(marks);
	return status;
}

enum hawser_status hawser__marks_of(struct hawser__marks *marks,
                                    const struct hawser_study_curve *curve,
                                    struct hawser_report *report)
{
	enum hawser_status status;

	*marks = (struct hawser__marks){0};
	status = hawser__curve_copy(&marks->curve, &curve->frf, report);
	/* as they were before they were located: which ones count is decided there; then the located
	 * ones, which are the same in number and order */
	if (!status)
		status = hawser_landmarks(&marks->item, &marks->count, &curve->frf, NULL, report);
	if (!status)
		status = mark_strong(marks, &curve->frf, report);
	if (!status && marks->count == curve->landmarks && curve->landmarks > 0)
		memcpy(marks->item, curve->landmark, (size_t)marks->count*sizeof *marks->item);
	if (status)
		hawser__marks_clear(marks);
	return status;
}

double hawser__marks_located(const struct hawser__marks *marks)
{
	double most = 0.0;

	/* The errors of the orbits are not counted: tolerances are far below the accuracy, and the
	 * error that harmonic balance states near the resonance of an omitted harmonic is some hundred
	 * times the true one, which would exceed the accuracy. Folds are located by bracketing, far
	 * more accurately. */
	for (int i = 0; i < marks->count; i++) {
		const struct hawser_landmark *peak = &marks->item[i];

		if (marks->strong[i] && peak->kind == HAWSER_LANDMARK_PEAK)
			most = fmax(most, fmax(peak->omega_error - peak->omega_orbits,
			                       peak->size_error - peak->size_orbits));
	}
	return most;
}

void hawser__marks_clear(struct hawser__marks *marks)
{
	free(marks->item);
	free(marks->strong);
	hawser__curve_clear(&marks->curve);
	*marks = (struct hawser__marks){0};
}

static double distance_of(const struct hawser_landmark *own, const struct hawser_landmark *its)
{
	double omega = fabs(own->omega/its->omega - 1.0), size = fabs(own->size/its->size - 1.0);

	return own->kind == HAWSER_LANDMARK_FOLD ? omega : fmax(omega, size);
}

/* Largest difference between the strong landmarks of a and their partners among all landmarks of
 * b. */
static enum hawser_status one_way(double *distance, const struct hawser__marks *a,
                                  const struct hawser__marks *b, struct hawser_report *report)
{
	int *partner = malloc(((size_t)a->count + 1)*sizeof *partner);
	enum hawser_status status;

	if (!partner)
		return hawser__no_memory(report, "accuracy");
	status = hawser_landmarks_match(partner, a->item, a->count, b->item, b->count, NULL, report);
	for (int i = 0; !status && i < a->count; i++)
		if (a->strong[i] && partner[i] >= 0)
			*distance = fmax(*distance, distance_of(&a->item[i], &b->item[partner[i]]));
	free(partner);
	return status;
}

enum hawser_status hawser__marks_distance(double *distance, const struct hawser__marks *a,
                                          const struct hawser__marks *b,
                                          struct hawser_report *report)
{
	enum hawser_status status;

	status = hawser__curve_distance(distance, &a->curve, &b->curve, report);
	if (!status)
		status = one_way(distance, a, b, report);
	return status ? status : one_way(distance, b, a, report);
}

enum hawser_status hawser_accuracy_distance(double *distance, const struct hawser_frf *a,
                                            const struct hawser_rom *rom_a,
                                            const struct hawser_frf *b,
                                            const struct hawser_rom *rom_b, double wanted,
                                            struct hawser_report *report)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser__marks own = {0}, other = {0};
	enum hawser_status status;

	*distance = NAN;
	status = hawser__marks_find(&own, a, rom_a, &options, wanted, report);
	if (!status)
		status = hawser__marks_find(&other, b, rom_b, &options, wanted, report);
	if (!status)
		status = hawser__marks_distance(distance, &own, &other, report);
	hawser__marks_clear(&own);
	hawser__marks_clear(&other);
	return status;
}
