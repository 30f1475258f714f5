/* study/compare/match.c - which landmarks of two models are the same.
 *
 *    d(i,j)  |ln(Omega_i/Omega_j)|/omega + |ln(size_i/size_j)|/size; above 1, i and j are not the same
 *    E(i,j)  least cost of aligning the first i landmarks of one curve with the first j of the other
 *
 * A coarse model may lack landmarks or have additional ones, so that pairing each with the nearest
 * in Omega may fail: the nearest may be another landmark, and two may have the same nearest one.
 * The alignment of least cost keeps the order along the branch and charges 1/2 for every landmark
 * without a partner: E(i,j) is the smallest of E(i-1,j-1) + d(i,j), E(i-1,j) + 1/2 and E(i,j-1) +
 * 1/2 (S. Needleman, C. Wunsch, J. Mol. Biol. 48, 1970). Two landmarks within the limits are
 * therefore never both left without a partner if pairing them is possible.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "core/settle.h"
#include "hawser/study.h"

static const double gap = 0.5;

void hawser_match_settle(struct hawser_match_options *options)
{
	hawser__settle(&options->omega, 0.1);
	hawser__settle(&options->size, 1.0);
}

static double distance(const struct hawser_landmark *a, const struct hawser_landmark *b,
                       const struct hawser_match_options *options)
{
	double d;

	if (a->turn != b->turn)
		return INFINITY;
	d = fabs(log(a->omega/b->omega))/options->omega;
	if (a->size != b->size)
		d += fabs(log(a->size/b->size))/options->size;
	return d <= 1.0 ? d : INFINITY; /* false for NAN as well */
}

static int same_kind(const struct hawser_landmark *a, const struct hawser_landmark *b)
{
	return a->kind == b->kind && a->probe == b->probe && a->axis == b->axis;
}

/* The landmarks of one kind: their indices in both lists. */
struct group {
	const struct hawser_landmark *landmark, *reference;
	int *own, *other; /* [n], [m] */
	int n, m;
	double *cost; /* [n + 1][m + 1] */
};

static int members(int *index, const struct hawser_landmark *list, int count,
                   const struct hawser_landmark *kind)
{
	int n = 0;

	for (int i = 0; i < count; i++)
		if (same_kind(&list[i], kind))
			index[n++] = i;
	return n;
}

/* The least cost of the three possible last steps; d is the distance of the pair. */
static double least(const struct group *group, int i, int j, double d)
{
	int width = group->m + 1;
	const double *cost = group->cost;

	return fmin(cost[(i - 1)*width + j - 1] + d,
	            gap + fmin(cost[(i - 1)*width + j], cost[i*width + j - 1]));
}

static double pair(const struct group *group, int i, int j,
                   const struct hawser_match_options *options)
{
	return distance(&group->landmark[group->own[i - 1]], &group->reference[group->other[j - 1]],
	                options);
}

static void align(int *partner, struct group *group, const struct hawser_match_options *options)
{
	int width = group->m + 1, i, j;
	double *cost = group->cost;

	for (i = 0; i <= group->n; i++)
		for (j = 0; j <= group->m; j++)
			cost[i*width + j] = i == 0 || j == 0 ? gap*(i + j)
			                    : least(group, i, j, pair(group, i, j, options));
	for (i = group->n, j = group->m; i > 0 && j > 0;) {
		double d = pair(group, i, j, options);

		if (isfinite(d) && cost[i*width + j] == cost[(i - 1)*width + j - 1] + d) {
			partner[group->own[--i]] = group->other[--j];
		} else if (cost[i*width + j] == cost[(i - 1)*width + j] + gap) {
			i--;
		} else {
			j--;
		}
	}
}

/* Whether a previous landmark has the same kind: then the kind has been aligned. */
static int seen(const struct hawser_landmark *list, int i)
{
	for (int k = 0; k < i; k++)
		if (same_kind(&list[k], &list[i]))
			return 1;
	return 0;
}

enum hawser_status hawser_landmarks_match(int *partner, const struct hawser_landmark *landmark,
                                          int count, const struct hawser_landmark *reference,
                                          int references,
                                          const struct hawser_match_options *options,
                                          struct hawser_report *report)
{
	struct hawser_match_options choice = {.omega = 0.0};
	struct group group = {.landmark = landmark, .reference = reference};
	enum hawser_status status = HAWSER_OK;

	if (options)
		choice = *options;
	hawser_match_settle(&choice);
	for (int i = 0; i < count; i++)
		partner[i] = -1;
	group.own = calloc((size_t)count + 1, sizeof *group.own);
	group.other = calloc((size_t)references + 1, sizeof *group.other);
	group.cost = calloc(((size_t)count + 1)*((size_t)references + 1), sizeof *group.cost);
	if (!group.own || !group.other || !group.cost) {
		status = hawser__no_memory(report, "study");
		goto done;
	}
	for (int i = 0; i < count; i++) {
		if (seen(landmark, i))
			continue;
		group.n = members(group.own, landmark, count, &landmark[i]);
		group.m = members(group.other, reference, references, &landmark[i]);
		align(partner, &group, &choice);
	}
done:
	free(group.own);
	free(group.other);
	free(group.cost);
	return status;
}
