/* net/motion/motion-chain.c - block elimination along chains, and the choice between it and KLU.
 *
 * A graph whose parts are paths is ordered along them: the matrix is then block tridiagonal with
 * 3x3 blocks, and elimination without fill costs some 200 operations a node. They are done by rows of
 * [block | right side], which are registers of four numbers, and from both ends of a path at once: each
 * node waits for its neighbour, so that one chain of operations leaves most of a processor idle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/paths.h"
#include "core/report.h"
#include "core/vec3.h"
#include "net/motion/motion.h"

struct hawser__blocks {
	int nodes;
	const int (*end)[2]; /* [elements] of the mesh */
	int *node;        /* [nodes] in their order along the paths */
	int *link;        /* [nodes] element from this place to the next; -1: a path ends here */
	unsigned char *held; /* [nodes] by place; bit k: direction k is held */
	struct hawser__rows *factor; /* [nodes] by place: rows of [next | y], x = y - next*(that of the
	                              * neighbour) */
	struct hawser__klu *klu; /* NULL for chains */
};

void hawser__blocks_clear(struct hawser__blocks *blocks)
{
	if (!blocks)
		return;
	free(blocks->node);
	free(blocks->link);
	free(blocks->held);
	free(blocks->factor);
	hawser__klu_clear(blocks->klu);
	free(blocks);
}

int hawser__blocks_chain(const struct hawser__blocks *blocks)
{
	return !blocks->klu;
}

enum hawser_status hawser__blocks_bytes(double *bytes, int *chain, const struct hawser__mesh *mesh,
                                        struct hawser_report *report)
{
	struct hawser__blocks *blocks;
	enum hawser_status status = hawser__blocks_open(&blocks, mesh, report);
	double nodes = mesh->nodes, elements = mesh->elements;

	if (status)
		return status;
	*chain = hawser__blocks_chain(blocks);
	*bytes = nodes*(16.0*sizeof *mesh->q + 8.0) + nodes*(sizeof *blocks->factor + 9.0) +
	         elements*(sizeof(struct hawser__motion_element) + 11.0*8.0) +
	         (blocks->klu ? hawser__klu_bytes(blocks->klu) : 0.0);
	hawser__blocks_clear(blocks);
	return HAWSER_OK;
}

static int arrange(struct hawser__blocks *blocks, int (*touch)[2], const struct hawser__mesh *mesh)
{
	if (!hawser__paths(blocks->node, blocks->link, touch, mesh->nodes, (const int (*)[2])mesh->end,
	                   mesh->elements))
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
		blocks->end = (const int (*)[2])mesh->end;
		blocks->node = calloc(n, sizeof *blocks->node);
		blocks->link = calloc(n, sizeof *blocks->link);
		blocks->held = calloc(n, 1);
		blocks->factor = calloc(n, sizeof *blocks->factor);
	}
	if (!blocks || !touch || !blocks->node || !blocks->link || !blocks->held || !blocks->factor)
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

struct problem {
	struct hawser__blocks *blocks;
	double (*r)[3];
	const struct hawser__blocks_matrix *of;
};

/* Add the block of a node. */
HAWSER_PART void add(struct hawser__rows *to, const struct problem *of, int node)
{
	const double *A = of->of->block[node];

	to->x += (hawser__vec){A[0], A[1], A[2], 0.0};
	to->y += (hawser__vec){A[3], A[4], A[5], 0.0};
	to->z += (hawser__vec){A[6], A[7], A[8], 0.0};
}

/* The rows of `at` of held directions are those of the unit matrix, with r beside them. */
HAWSER_PART void hold(struct hawser__rows *at, unsigned char held, const double *r)
{
	if (held & 1U)
		at->x = (hawser__vec){1.0, 0.0, 0.0, r[0]};
	if (held & 2U)
		at->y = (hawser__vec){0.0, 1.0, 0.0, r[1]};
	if (held & 4U)
		at->z = (hawser__vec){0.0, 0.0, 1.0, r[2]};
}

/* Eliminate the node at a place, whose neighbour is across element e: rest is what the nodes before
 * have left to it, and then what is left to the neighbour. Returns the determinant. */
HAWSER_PART double step(struct hawser__rows *rest, const struct problem *of, int place, int e)
{
	const struct hawser__blocks *blocks = of->blocks;
	const int node = blocks->node[place];
	const double near = of->of->mass[e][0], far = of->of->mass[e][1];
	const double *r = of->r[node], *B = of->of->B[e], *O = of->of->other ? of->of->other[e] : B;
	const double own = near + of->of->point[node];
	struct hawser__rows here, off, factor;
	double c[9], det, inverse;

	if (of->of->other && blocks->end[e][0] != node) {
		const double *swap = B;

		B = O;
		O = swap;
	}
	here.x = rest->x + (hawser__vec){B[0] + own, B[1], B[2], r[0]};
	here.y = rest->y + (hawser__vec){B[3], B[4] + own, B[5], r[1]};
	here.z = rest->z + (hawser__vec){B[6], B[7], B[8] + own, r[2]};
	if (of->of->block)
		add(&here, of, node);
	if (blocks->held[place])
		hold(&here, blocks->held[place], r);
	off.x = (hawser__vec){far, 0.0, 0.0, here.x[3]} - (hawser__vec){B[0], B[1], B[2], 0.0};
	off.y = (hawser__vec){0.0, far, 0.0, here.y[3]} - (hawser__vec){B[3], B[4], B[5], 0.0};
	off.z = (hawser__vec){0.0, 0.0, far, here.z[3]} - (hawser__vec){B[6], B[7], B[8], 0.0};
	if (blocks->held[place] & 1U)
		off.x = (hawser__vec){0.0, 0.0, 0.0, r[0]};
	if (blocks->held[place] & 2U)
		off.y = (hawser__vec){0.0, 0.0, 0.0, r[1]};
	if (blocks->held[place] & 4U)
		off.z = (hawser__vec){0.0, 0.0, 0.0, r[2]};
	det = hawser__rows_adjugate(c, &here);
	inverse = 1.0/det;
	hawser__rows_times(&factor, c, inverse, &off);
	blocks->factor[place] = factor;
	rest->x = (hawser__vec){O[0] + near, O[1], O[2], 0.0} +
	          ((O[0] - far)*factor.x + O[1]*factor.y + O[2]*factor.z);
	rest->y = (hawser__vec){O[3], O[4] + near, O[5], 0.0} +
	          (O[3]*factor.x + (O[4] - far)*factor.y + O[5]*factor.z);
	rest->z = (hawser__vec){O[6], O[7], O[8] + near, 0.0} +
	          (O[6]*factor.x + O[7]*factor.y + (O[8] - far)*factor.z);
	return det;
}

/* The middle of a path: x = its displacement. */
HAWSER_PART double middle(const struct hawser__rows *one, const struct hawser__rows *other,
                          const struct problem *of, int place)
{
	const int node = of->blocks->node[place];
	const double own = of->of->point[node];
	double *x = of->r[node], c[9], det, right[3];
	struct hawser__rows here;

	here.x = one->x + other->x + (hawser__vec){own, 0.0, 0.0, x[0]};
	here.y = one->y + other->y + (hawser__vec){0.0, own, 0.0, x[1]};
	here.z = one->z + other->z + (hawser__vec){0.0, 0.0, own, x[2]};
	if (of->of->block)
		add(&here, of, node);
	if (of->blocks->held[place])
		hold(&here, of->blocks->held[place], x);
	det = hawser__rows_adjugate(c, &here);
	right[0] = here.x[3]/det;
	right[1] = here.y[3]/det;
	right[2] = here.z[3]/det;
	for (int k = 0; k < 3; k++)
		x[k] = c[3*k]*right[0] + c[3*k + 1]*right[1] + c[3*k + 2]*right[2];
	return det;
}

static int usable(double det)
{
	return isfinite(1.0/det) && det != 0.0;
}

/* A path from both its ends to its middle: two chains of operations that do not wait for each other. */
HAWSER_HOT
static int eliminate(const struct problem *of, int first, int last)
{
	const struct hawser__blocks *blocks = of->blocks;
	const int half = first + (last - first)/2;
	const hawser__vec zero = {0.0};
	struct hawser__rows low = {zero, zero, zero}, high = low;
	int good = 1;

	for (int i = first, j = last; i < half || j > half; i++, j--) {
		if (i < half)
			good &= usable(step(&low, of, i, blocks->link[i]));
		if (j > half)
			good &= usable(step(&high, of, j, blocks->link[j - 1]));
	}
	good &= usable(middle(&low, &high, of, half));
	for (int i = half - 1, j = half + 1; i >= first || j <= last; i--, j++) {
		if (i >= first)
			hawser__rows_back(of->r[blocks->node[i]], &blocks->factor[i], of->r[blocks->node[i + 1]]);
		if (j <= last)
			hawser__rows_back(of->r[blocks->node[j]], &blocks->factor[j], of->r[blocks->node[j - 1]]);
	}
	return good;
}

enum hawser_status hawser__blocks_solve(double (*r)[3], int *good, struct hawser__blocks *blocks,
                                        const struct hawser__blocks_matrix *matrix,
                                        struct hawser_report *report)
{
	const struct problem of = {.blocks = blocks, .r = r, .of = matrix};

	if (blocks->klu)
		return hawser__klu_solve(r, good, blocks->klu, matrix, report);
	*good = 1;
	for (int first = 0, last; first < blocks->nodes && *good; first = last + 1) {
		for (last = first; blocks->link[last] >= 0;)
			last++;
		*good = eliminate(&of, first, last);
	}
	return HAWSER_OK;
}
