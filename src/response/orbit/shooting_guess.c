/* response/orbit/shooting_guess.c - transition matrices near a prediction, extrapolated from earlier
 * orbits.
 *
 *    s       position of an orbit along the plane's normal, 0 at the prediction
 *    weight  of a stored orbit: Lagrange's polynomial through their s, at 0
 *
 * The derivatives of the flow cost several times as much as the flow, and they are smooth along a
 * branch. A polynomial through those of the last orbits predicts them to three or four digits at
 * the next orbit, which is enough for the corrector. Only the corrected orbit, whose tangent and
 * multipliers are results, gets its own derivatives.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "response/orbit/shooting.h"

#define NODES 4              /* largest number of nodes of the polynomial; chosen */
#define FARTHEST 1.0         /* largest distance of an orbit in the metric; a step is at most 0.4;
                              * chosen */
#define APART 0.1            /* least distance of two nodes, relative to that from the prediction;
                              * chosen */
#define LARGEST_WEIGHT 40.0  /* larger weights amplify the errors of the matrices too much; chosen */

enum { REMEMBERED = 8 }; /* orbits */

static double *record_of(const struct hawser__orbit *orbit, int kept)
{
	return orbit->memory + (size_t)(kept%REMEMBERED)*(orbit->derivatives + (size_t)orbit->size);
}

int hawser__orbit_remember(struct hawser__orbit *orbit, double *derived, size_t derivatives)
{
	orbit->derived = derived;
	orbit->derivatives = derivatives;
	orbit->memory = calloc(REMEMBERED*(derivatives + (size_t)orbit->size), sizeof(double));
	return !orbit->memory;
}

void hawser__orbit_keep(struct hawser__orbit *orbit, const double *y)
{
	size_t size = (size_t)orbit->size;
	double *record = record_of(orbit, orbit->kept++);

	memcpy(record, y, size*sizeof *record);
	memcpy(record + size, orbit->derived, orbit->derivatives*sizeof *record);
}

/* A stored orbit. */
struct node {
	double s, weight;
	const double *record;
};

/* Insert by falling distance; if the list is full, the farthest orbit is removed. */
static int insert(struct node *node, int count, struct node new)
{
	int at;

	for (int i = 0; i < count; i++)
		if (fabs(node[i].s - new.s) < APART*(fabs(node[i].s) + fabs(new.s)))
			return count;
	if (count == NODES && fabs(new.s) >= fabs(node[NODES - 1].s))
		return count;
	at = count < NODES ? count++ : NODES - 1;
	for (; at > 0 && fabs(node[at - 1].s) > fabs(new.s); at--)
		node[at] = node[at - 1];
	node[at] = new;
	return count;
}

/* The nearest orbits, latest first: of two that coincide the later one is used. */
static int choose(struct node *node, const struct hawser__orbit *orbit, const double *y,
                  const double *row)
{
	const struct hawser__metric metric = hawser__orbit_metric(orbit);
	int kept = orbit->kept < REMEMBERED ? orbit->kept : REMEMBERED, count = 0;

	for (int i = 1; i <= kept; i++) {
		const double *record = record_of(orbit, orbit->kept - i);
		double s = hawser__metric_dot(&metric, row, record) -
		           hawser__metric_dot(&metric, row, y);
		double distance2 = hawser__metric_distance2(&metric, record, y);

		/* far from the normal, so that it is on another part of the branch */
		if (distance2 < FARTHEST*FARTHEST && distance2 < 4.0*s*s)
			count = insert(node, count, (struct node){s, 0.0, record});
	}
	return count;
}

/* Lagrange's weights; returns the sum of their magnitudes. */
static double weigh(struct node *node, int count)
{
	double sum = 0.0;

	for (int k = 0; k < count; k++) {
		node[k].weight = 1.0;
		for (int i = 0; i < count; i++)
			if (i != k)
				node[k].weight *= node[i].s/(node[i].s - node[k].s);
		sum += fabs(node[k].weight);
	}
	return sum;
}

int hawser__orbit_guess(struct hawser__orbit *orbit, const double *y, const double *row)
{
	struct node node[NODES];
	int count = choose(node, orbit, y, row);

	while (count > 1 && weigh(node, count) > LARGEST_WEIGHT)
		count--;
	if (count < 2)
		return 0;
	memset(orbit->derived, 0, orbit->derivatives*sizeof *orbit->derived);
	for (int k = 0; k < count; k++)
		cblas_daxpy((int)orbit->derivatives, node[k].weight, node[k].record + orbit->size, 1,
		            orbit->derived, 1);
	return 1;
}

void hawser__shooting_add_wave(struct hawser__orbit *orbit, double *y, const double *pq, int k,
                               double omega)
{
	int n = orbit->n, m = orbit->m, S = ((struct hawser__shooting *)orbit)->segments;

	for (int i = 0; i < S; i++) {
		double tau = k*i*2.0*M_PI/S, c = cos(tau), s = sin(tau);

		for (int j = 0; j < n; j++) {
			y[i*m + j] += pq[j]*c + pq[n + j]*s;
			y[i*m + n + j] += k*omega*(pq[n + j]*c - pq[j]*s);
		}
	}
}

/* The states at all nodes, by integration from phase 0. */
enum hawser_status hawser__shooting_from_state(struct hawser__orbit *orbit, double *y, const double *x,
                                               double omega, struct hawser_report *report)
{
	struct hawser__shooting *shooting = (struct hawser__shooting *)orbit;
	int m = orbit->m, S = shooting->segments;

	(void)report;
	(void)hawser__flow_place(&shooting->flow, orbit->rom);
	memcpy(y, x, (size_t)m*sizeof *y);
	for (int i = 0; i + 1 < S; i++) {
		struct hawser__stretch stretch = {.tau = i*(2.0*M_PI/S), .steps = shooting->steps,
			.h = 2.0*M_PI/S/shooting->steps, .count = 1};

		memcpy(y + (i + 1)*m, y + i*m, (size_t)m*sizeof *y);
		hawser__flow_map(&shooting->flow, y + (i + 1)*m, NULL, &stretch, omega);
	}
	return HAWSER_OK;
}
