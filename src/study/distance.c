/* study/distance.c - one number for how far two responses of a scene are apart: folds and peaks.
 *
 * Landmarks are matched along the branch (match.c). What is near the limit of being one (a small peak, a
 * fold with its partner close by) is in one response and not in the other for nothing: peaks are
 * looked for among those of the other that are half as prominent, and folds that have no partner count by
 * how far the curve turns back between the two.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "hawser/accuracy.h"
#include "study/distance.h"

const struct hawser_landmark_options hawser__landmarks_strong = {
	.smallest = 0.2, .faintest = 0.5, .prominence = 0.1};
static const struct hawser_landmark_options weak = {
	.smallest = 0.1, .faintest = 0.3, .prominence = 0.005};

struct list {
	struct hawser_landmark *item;
	int count, *partner; /* [count] */
};

static enum hawser_status find(struct list *list, const struct hawser_frf *frf,
                               const struct hawser_landmark_options *options,
                               struct hawser_report *report)
{
	enum hawser_status status = hawser_landmarks(&list->item, &list->count, frf, options, report);

	if (status)
		return status;
	list->partner = calloc((size_t)list->count + 1, sizeof *list->partner);
	return list->partner ? HAWSER_OK : hawser__no_memory(report, "accuracy");
}

static void drop(struct list *list)
{
	free(list->item);
	free(list->partner);
	*list = (struct list){0};
}

/* A fold without partner: by how much Omega goes back and forth between it and a neighbour that has none
 * either. */
static double turned_back(const struct list *list, int i)
{
	double least = 1.0;

	for (int k = i - 1; k <= i + 1; k += 2) {
		if (k < 0 || k >= list->count || list->item[k].kind != HAWSER_LANDMARK_FOLD ||
		    list->partner[k] >= 0)
			continue;
		least = fmin(least, fabs(log(list->item[k].omega/list->item[i].omega)));
	}
	return least;
}

static double distance_of(const struct list *list, int i, const struct list *other)
{
	const struct hawser_landmark *own = &list->item[i], *its;
	double omega, size;

	if (list->partner[i] < 0)
		return own->kind == HAWSER_LANDMARK_FOLD ? turned_back(list, i) : 1.0;
	its = &other->item[list->partner[i]];
	omega = fabs(own->omega/its->omega - 1.0);
	size = fabs(own->size/its->size - 1.0);
	return own->kind == HAWSER_LANDMARK_FOLD ? omega : fmax(omega, size);
}

/* The strong landmarks of a among the weak ones of b. */
static enum hawser_status one_way(double *distance, const struct hawser_frf *a,
                                  const struct hawser_frf *b, struct hawser_report *report)
{
	struct list own = {0}, other = {0};
	enum hawser_status status = find(&own, a, &hawser__landmarks_strong, report);

	if (!status)
		status = find(&other, b, &weak, report);
	if (!status)
		status = hawser_landmarks_match(own.partner, own.item, own.count, other.item, other.count,
		                                NULL, report);
	for (int i = 0; !status && i < own.count; i++)
		*distance = fmax(*distance, distance_of(&own, i, &other));
	drop(&own);
	drop(&other);
	return status;
}

enum hawser_status hawser_accuracy_distance(double *distance, const struct hawser_frf *a,
                                            const struct hawser_frf *b,
                                            struct hawser_report *report)
{
	enum hawser_status status;

	*distance = 0.0;
	status = one_way(distance, a, b, report);
	return status ? status : one_way(distance, b, a, report);
}
