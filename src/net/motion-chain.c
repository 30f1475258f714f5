/* net/motion-chain.c - block elimination along chains, and the choice between it and KLU.
 *
 * A graph whose parts are paths is ordered along them: the matrix is then block tridiagonal with
 * 3x3 blocks, and elimination without fill costs some 200 operations a node.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/motion.h"

struct hawser__blocks {
	int nodes;
	int *node;        /* [nodes] in their order along the paths */
	int *link;        /* [nodes] element from this place to the next; -1: a path ends here */
	unsigned char *held; /* [nodes] by place; bit k: direction k is held */
	double (*diagonal)[9], (*next)[9]; /* [nodes] factors, by place */
	double (*y)[3];   /* [nodes] */
	struct hawser__klu *klu; /* NULL for chains */
};

void hawser__blocks_clear(struct hawser__blocks *blocks)
{
	if (!blocks)
		return;
	free(blocks->node);
	free(blocks->link);
	free(blocks->held);
	free(blocks->diagonal);
	free(blocks->next);
	free(blocks->y);
	hawser__klu_clear(blocks->klu);
	free(blocks);
}

int hawser__blocks_chain(const struct hawser__blocks *blocks)
{
	return !blocks->klu;
}

/* Elements at each node, at most 2: touch [nodes][2]; 0 if a node has more. */
static int neighbours(int (*touch)[2], const struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->nodes; i++)
		touch[i][0] = touch[i][1] = -1;
	for (int e = 0; e < mesh->elements; e++)
		for (int end = 0; end < 2; end++) {
			int *at = touch[mesh->end[e][end]];

			if (at[1] >= 0)
				return 0;
			at[at[0] >= 0] = e;
		}
	return 1;
}

/* Order the nodes along paths; 0 if a part is a ring. */
static int order(struct hawser__blocks *blocks, int (*touch)[2], const struct hawser__mesh *mesh)
{
	int count = 0;

	for (int i = 0; i < mesh->nodes; i++) {
		int node = i, from = -1;

		if (touch[i][1] >= 0 || touch[i][0] == -2)
			continue; /* inside a path, or the end of one that was taken */
		for (int more = 1; more; count++) {
			int link = touch[node][0] != from ? touch[node][0] : touch[node][1];

			more = link >= 0;
			blocks->node[count] = node;
			blocks->link[count] = more ? link : -1;
			if (!more || touch[node][1] < 0)
				touch[node][0] = -2;
			from = link;
			if (more)
				node = mesh->end[link][mesh->end[link][0] == node];
		}
	}
	return count == mesh->nodes;
}

static int arrange(struct hawser__blocks *blocks, int (*touch)[2], const struct hawser__mesh *mesh)
{
	if (!neighbours(touch, mesh) || !order(blocks, touch, mesh))
		return 0;
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[blocks->node[i]][k] < 0)
				blocks->held[i] |= (unsigned char)(1U << k);
	return 1;
}

enum hawser_status hawser__blocks_open(struct hawser__blocks **made, const struct hawser__mesh *mesh,
                                       struct hawser_report *report)
{
	struct hawser__blocks *blocks = calloc(1, sizeof *blocks);
	size_t n = (size_t)mesh->nodes + 1;
	int (*touch)[2] = malloc(n*sizeof *touch);
	enum hawser_status status = HAWSER_OK;

	*made = blocks;
	if (blocks) {
		blocks->nodes = mesh->nodes;
		blocks->node = calloc(n, sizeof *blocks->node);
		blocks->link = calloc(n, sizeof *blocks->link);
		blocks->held = calloc(n, 1);
		blocks->diagonal = calloc(n, sizeof *blocks->diagonal);
		blocks->next = calloc(n, sizeof *blocks->next);
		blocks->y = calloc(n, sizeof *blocks->y);
	}
	if (!blocks || !touch || !blocks->node || !blocks->link || !blocks->held || !blocks->diagonal ||
	    !blocks->next || !blocks->y)
		status = hawser__no_memory(report, "net");
	else if (!arrange(blocks, touch, mesh))
		status = hawser__klu_open(&blocks->klu, mesh, report);
	free(touch);
	if (status) {
		hawser__blocks_clear(blocks);
		*made = NULL;
	}
	return status;
}

/* inverse = 1/m, by cofactors; 0 if m is singular. */
static int invert(double inverse[9], const double m[9])
{
	double a = m[4]*m[8] - m[5]*m[7], b = m[5]*m[6] - m[3]*m[8], c = m[3]*m[7] - m[4]*m[6];
	double det = m[0]*a + m[1]*b + m[2]*c, f = 1.0/det;

	inverse[0] = a*f;
	inverse[3] = b*f;
	inverse[6] = c*f;
	inverse[1] = (m[2]*m[7] - m[1]*m[8])*f;
	inverse[4] = (m[0]*m[8] - m[2]*m[6])*f;
	inverse[7] = (m[1]*m[6] - m[0]*m[7])*f;
	inverse[2] = (m[1]*m[5] - m[2]*m[4])*f;
	inverse[5] = (m[2]*m[3] - m[0]*m[5])*f;
	inverse[8] = (m[0]*m[4] - m[1]*m[3])*f;
	return isfinite(f) && det != 0.0;
}

static inline void multiply(double out[9], const double a[9], const double b[9])
{
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			out[3*i + j] = a[3*i]*b[j] + a[3*i + 1]*b[3 + j] + a[3*i + 2]*b[6 + j];
}

static inline void apply(double out[3], const double a[9], const double x[3])
{
	for (int i = 0; i < 3; i++)
		out[i] = a[3*i]*x[0] + a[3*i + 1]*x[1] + a[3*i + 2]*x[2];
}

/* Rows of held directions: those of the unit matrix, or zero beside it. */
static void mask(double m[9], unsigned char held, double one)
{
	for (int k = 0; k < 3; k++)
		for (int j = 0; held & (1U << k) && j < 3; j++)
			m[3*k + j] = j == k ? one : 0.0;
}

/* Add the share of element e to the blocks at both its ends; off gets what couples them. */
static inline void share(double here[9], double there[9], double off[9], const double B[9],
                         const double mass[2])
{
	for (int k = 0; k < 9; k++) {
		here[k] += B[k];
		there[k] = B[k];
		off[k] = -B[k];
	}
	for (int k = 0; k < 9; k += 4) {
		here[k] += mass[0];
		there[k] += mass[0];
		off[k] += mass[1];
	}
}

static void back(double (*r)[3], const struct hawser__blocks *blocks)
{
	for (int i = blocks->nodes - 1; i >= 0; i--) {
		double *x = r[blocks->node[i]], before[3];

		for (int k = 0; k < 3; k++)
			x[k] = blocks->y[i][k];
		if (blocks->link[i] < 0)
			continue;
		apply(before, blocks->next[i], r[blocks->node[i + 1]]);
		for (int k = 0; k < 3; k++)
			x[k] -= before[k];
	}
}

static int eliminate(double (*r)[3], struct hawser__blocks *blocks, const double (*B)[9],
                     const double (*mass)[2], const double *point)
{
	double here[9] = {0}, there[9] = {0}, right[3] = {0};
	int linked = 0;

	for (int i = 0; i < blocks->nodes; i++) {
		const int node = blocks->node[i], e = blocks->link[i];
		double off[9], lower[9], product[9], less[3];

		for (int k = 0; k < 9; k++)
			here[k] = linked ? there[k] : 0.0;
		for (int k = 0; k < 3; k++) {
			here[4*k] += point[node];
			right[k] = r[node][k] - (linked ? right[k] : 0.0);
		}
		if (e >= 0)
			share(here, there, off, B[e], mass[e]);
		if (linked) /* less what the elimination of the node before has left */
			for (int k = 0; k < 9; k++)
				here[k] -= blocks->diagonal[i][k];
		if (blocks->held[i])
			mask(here, blocks->held[i], 1.0);
		if (!invert(product, here))
			return 0;
		apply(blocks->y[i], product, right);
		linked = e >= 0;
		if (!linked)
			continue;
		memcpy(lower, off, sizeof lower);
		if (blocks->held[i])
			mask(off, blocks->held[i], 0.0);
		if (blocks->held[i + 1])
			mask(lower, blocks->held[i + 1], 0.0);
		multiply(blocks->next[i], product, off);
		multiply(blocks->diagonal[i + 1], lower, blocks->next[i]);
		apply(less, lower, blocks->y[i]);
		memcpy(right, less, sizeof right);
	}
	back(r, blocks);
	return 1;
}

enum hawser_status hawser__blocks_solve(double (*r)[3], int *good, struct hawser__blocks *blocks,
                                        const double (*B)[9], const double (*mass)[2],
                                        const double *point,
                                        struct hawser_report *report)
{
	if (blocks->klu)
		return hawser__klu_solve(r, good, blocks->klu, B, mass, point, report);
	*good = eliminate(r, blocks, B, mass, point);
	return HAWSER_OK;
}
