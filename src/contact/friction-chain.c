/* contact/friction-chain.c - Newton's step along chains by block elimination.
 *
 * S, y  what elimination leaves of M and of the right side at a place
 * U     block of M from a place to the next
 * R     p - M u, so that at a contact s = -R is the force of the obstacle
 *
 * At a node without contact the step du solves S du + U du_next = R + y. At a node with one contact
 * the impulse is a function of the velocities, r = H (M u - p), and the rows are those of the law,
 *   F + Cu H du + Cr H (S du + U du_next - y) = 0:
 * the impulses are no unknowns, and the matrix is as sparse as M. At a node with more contacts the
 * impulses of the second and others are unknowns of that node, eliminated there with pivots.
 * Blocks are eliminated without pivots across nodes, as the matrix of a part of the chain is that of a
 * contact problem of its own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/friction.h"
#include "core/paths.h"
#include "core/report.h"
#include "core/vec3.h"

struct hawser__contact_chain {
	int nodes;
	int *node;                   /* [nodes] node at a place */
	int *link;                   /* [nodes] from a place to the next; -1: the chain ends */
	struct hawser__rows *factor; /* [nodes] rows of [next | y] */
	struct hawser__rows *rest;   /* [nodes] what the places before leave of M alone */
};

void hawser__contact_chain_clear(struct hawser__contact_chain *chain)
{
	if (!chain)
		return;
	free(chain->node);
	free(chain->link);
	free(chain->factor);
	free(chain->rest);
	free(chain);
}

enum hawser_status hawser__contact_chain_open(struct hawser__contact_chain **made, int nodes,
                                      const int (*link)[2], int links, struct hawser_report *report)
{
	struct hawser__contact_chain *chain = calloc(1, sizeof *chain);
	size_t n = (size_t)nodes + 1;
	int (*touch)[2] = malloc(n*sizeof *touch);
	int good = chain && touch, paths = 0;

	*made = NULL;
	if (good) {
		chain->nodes = nodes;
		chain->node = calloc(n, sizeof *chain->node);
		chain->link = calloc(n, sizeof *chain->link);
		chain->factor = calloc(n, sizeof *chain->factor);
		chain->rest = calloc(n, sizeof *chain->rest);
		good = chain->node && chain->link && chain->factor && chain->rest;
	}
	if (good)
		paths = hawser__paths(chain->node, chain->link, touch, nodes, link, links);
	free(touch);
	if (good && paths) {
		*made = chain;
		return HAWSER_OK;
	}
	hawser__contact_chain_clear(chain);
	return good ? HAWSER_OK : hawser__no_memory(report, "friction");
}

/* The block U of M from the node at a place to the next, rows of the former, and the transpose of the
 * block L with the rows of the latter: equal where M is symmetric. */
HAWSER_PART void across(double U[9], double L[9], const struct hawser_friction *of, int node, int link)
{
	const double *off = of->of->off[link], *back = of->of->back ? of->of->back[link] : NULL;
	const int along = of->link[link][0] == node;

	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++) {
			double up = off[3*i + j], down = back ? back[3*j + i] : up;
			int at = along ? 3*i + j : 3*j + i;

			U[at] = along ? up : down;
			L[at] = along ? down : up;
		}
}

HAWSER_PART void hold(struct hawser__rows *here, struct hawser__rows *off, unsigned held,
                      const double *R)
{
	if (held & 1U) {
		here->x = (hawser__vec){1.0, 0.0, 0.0, 0.0};
		off->x = (hawser__vec){0.0, 0.0, 0.0, R[0]};
	}
	if (held & 2U) {
		here->y = (hawser__vec){0.0, 1.0, 0.0, 0.0};
		off->y = (hawser__vec){0.0, 0.0, 0.0, R[1]};
	}
	if (held & 4U) {
		here->z = (hawser__vec){0.0, 0.0, 1.0, 0.0};
		off->z = (hawser__vec){0.0, 0.0, 0.0, R[2]};
	}
}

/* The rows of a node with one contact instead of those of M. here: [S | y], off: [U | y]. */
HAWSER_PART void law(struct hawser__rows *here, struct hawser__rows *off,
                     const struct hawser__touch_rows *rows)
{
	const double *b = rows->CuH, *a = rows->CrH, *F = rows->G;
	const struct hawser__rows S = *here, U = *off;

	here->x = (a[0]*S.x + a[1]*S.y + a[2]*S.z) + (hawser__vec){b[0], b[1], b[2], 0.0};
	here->y = (a[3]*S.x + a[4]*S.y + a[5]*S.z) + (hawser__vec){b[3], b[4], b[5], 0.0};
	here->z = (a[6]*S.x + a[7]*S.y + a[8]*S.z) + (hawser__vec){b[6], b[7], b[8], 0.0};
	off->x = (a[0]*U.x + a[1]*U.y + a[2]*U.z) - (hawser__vec){0.0, 0.0, 0.0, F[0]};
	off->y = (a[3]*U.x + a[4]*U.y + a[5]*U.z) - (hawser__vec){0.0, 0.0, 0.0, F[1]};
	off->z = (a[6]*U.x + a[7]*U.y + a[8]*U.z) - (hawser__vec){0.0, 0.0, 0.0, F[2]};
}

/* 1 if the leading minors are positive. */
HAWSER_PART int positive(const struct hawser__rows *m, double det)
{
	return m->x[0] > 0.0 && m->x[0]*m->y[1] - m->x[1]*m->y[0] > 0.0 && det > 0.0;
}

/* Eliminate a place; rest: what is left to it, and then to the next. Returns 0 if it is singular, or
 * for M alone not positive definite. */
HAWSER_PART int eliminate(struct hawser__rows *rest, struct hawser_friction *of, int place,
                          const struct hawser__step_law *by)
{
	struct hawser__contact_chain *chain = of->chain;
	const int node = chain->node[place], link = chain->link[place];
	const double *D = of->of->diagonal[node], *R = of->R[node];
	const unsigned held = of->of->held ? of->of->held[node] : 0U;
	const int first = by ? of->first[node] : -1;
	double U[9] = {0.0}, L[9] = {0.0}, c[9], det;
	struct hawser__rows here, off, *factor = &chain->factor[place];

	if (link >= 0)
		across(U, L, of, node, link);
	here.x = rest->x + (hawser__vec){D[0], D[1], D[2], 0.0};
	here.y = rest->y + (hawser__vec){D[3], D[4], D[5], 0.0};
	here.z = rest->z + (hawser__vec){D[6], D[7], D[8], 0.0};
	off.x = (hawser__vec){U[0], U[1], U[2], here.x[3]};
	off.y = (hawser__vec){U[3], U[4], U[5], here.y[3]};
	off.z = (hawser__vec){U[6], U[7], U[8], here.z[3]};
	if (first < 0) {
		off.x += (hawser__vec){0.0, 0.0, 0.0, R[0]};
		off.y += (hawser__vec){0.0, 0.0, 0.0, R[1]};
		off.z += (hawser__vec){0.0, 0.0, 0.0, R[2]};
		if (held)
			hold(&here, &off, held, R);
	} else if (of->touch[first].next < 0) {
		struct hawser__touch_rows rows;

		hawser__touch_linearise(&rows, &of->touch[first], by->sigma, hawser__step_from(by, of, first));
		law(&here, &off, &rows);
	}
	if (first >= 0 && of->touch[first].next >= 0) {
		if (!hawser__corner(factor, of, first, &here, &off, by))
			return 0;
	} else {
		det = hawser__rows_adjugate(c, &here);
		if (!by && !of->of->back && !positive(&here, det))
			return 0;
		if (det == 0.0 || !isfinite(1.0/det))
			return 0;
		hawser__rows_times(factor, c, 1.0/det, &off);
	}
	rest->x = -(L[0]*factor->x + L[3]*factor->y + L[6]*factor->z);
	rest->y = -(L[1]*factor->x + L[4]*factor->y + L[7]*factor->z);
	rest->z = -(L[2]*factor->x + L[5]*factor->y + L[8]*factor->z);
	return 1;
}

/* Steps of the impulses of second and other contacts at a node. */
static void corner(struct hawser_friction *of, int second, const double next[3])
{
	for (int c = second; c >= 0; c = of->touch[c].next)
		for (int k = 0; k < 3; k++) {
			const double *b = of->second[c].back + 3*k;

			of->second[c].dr[k] = of->second[c].least[k] -
			                      (b[0]*next[0] + b[1]*next[1] + b[2]*next[2]);
		}
}

HAWSER_HOT
int hawser__contact_chain_solve(double (*du)[3], struct hawser_friction *of,
                                const struct hawser__step_law *by)
{
	struct hawser__contact_chain *chain = of->chain;
	const hawser__vec zero = {0.0};
	struct hawser__rows rest = {zero, zero, zero};

	for (int place = 0; place < chain->nodes; place++) {
		if (!by)
			chain->rest[place] = rest;
		if (!eliminate(&rest, of, place, by))
			return 0;
		if (chain->link[place] < 0)
			rest = (struct hawser__rows){zero, zero, zero};
	}
	for (int place = chain->nodes - 1; place >= 0; place--) {
		static const double none[3] = {0.0};
		const double *next = chain->link[place] < 0 ? none : du[chain->node[place + 1]];

		hawser__rows_back(du[chain->node[place]], &chain->factor[place], next);
		if (by && of->corners && of->first[chain->node[place]] >= 0)
			corner(of, of->touch[of->first[chain->node[place]]].next, next);
	}
	return 1;
}

/* A block with the rows of held directions replaced. */
HAWSER_PART void block(struct hawser__rows *rows, const double D[9], const struct hawser__rows *rest,
                       unsigned held)
{
	static const double none[3] = {0.0};
	struct hawser__rows off;

	rows->x = rest->x + (hawser__vec){D[0], D[1], D[2], 0.0};
	rows->y = rest->y + (hawser__vec){D[3], D[4], D[5], 0.0};
	rows->z = rest->z + (hawser__vec){D[6], D[7], D[8], 0.0};
	off = *rows;
	if (held)
		hold(rows, &off, held, none);
}

/* What the places after this one leave to it: -U times the inverse of theirs times L^T. */
HAWSER_PART void from_next(struct hawser__rows *rest, const double U[9], const double L[9],
                           const struct hawser__rows *next)
{
	double c[9], product[9], inverse = 1.0/hawser__rows_adjugate(c, next);

	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			product[3*i + j] = -inverse*(c[3*i]*L[3*j] + c[3*i + 1]*L[3*j + 1] + c[3*i + 2]*L[3*j + 2]);
	for (int k = 0; k < 3; k++) {
		const hawser__vec row = {product[3*k], product[3*k + 1], product[3*k + 2], 0.0};

		if (k == 0) {
			rest->x = U[0]*row;
			rest->y = U[3]*row;
			rest->z = U[6]*row;
			continue;
		}
		rest->x += U[k]*row;
		rest->y += U[3 + k]*row;
		rest->z += U[6 + k]*row;
	}
}

HAWSER_HOT
void hawser__contact_chain_inverse(struct hawser_friction *of)
{
	const struct hawser__contact_chain *chain = of->chain;
	const hawser__vec zero = {0.0};
	struct hawser__rows rest = {zero, zero, zero}, both, next = rest;

	for (int place = chain->nodes - 1; place >= 0; place--) {
		const int node = chain->node[place], link = chain->link[place];
		const unsigned held = of->of->held ? of->of->held[node] : 0U;
		double U[9] = {0.0}, L[9] = {0.0}, c[9], det;

		if (link >= 0) {
			across(U, L, of, node, link);
			for (int k = 0; k < 9; k++) /* rows of held directions of the next place are 0 */
				if (of->of->held && of->of->held[chain->node[place + 1]] & 1U << k%3)
					U[k] = L[k] = 0.0;
			from_next(&rest, U, L, &next);
		} else {
			rest = (struct hawser__rows){zero, zero, zero};
		}
		block(&next, of->of->diagonal[node], &rest, held);
		both.x = rest.x + chain->rest[place].x;
		both.y = rest.y + chain->rest[place].y;
		both.z = rest.z + chain->rest[place].z;
		block(&both, of->of->diagonal[node], &both, held);
		det = hawser__rows_adjugate(c, &both);
		for (int k = 0; k < 9; k++)
			of->inverse[node][k] = c[k]/det;
	}
}
