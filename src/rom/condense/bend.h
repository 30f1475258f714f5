/* rom/condense/bend.h - the static answer of a cable with bending stiffness to forces against
 * its slopes, and its energy. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_BEND_H
#define HAWSER_ROM_BEND_H

#include "core/hold.h"
#include "rom/condense/condense.h"

/* Nodes are those of Gauss rules of `order` points in `parts` parts of the cable. */
struct hawser__bend {
	int parts, order, degree, points;
	int size, band;  /* unknowns, band of the matrix */
	int held[2];     /* 1: the end has no rotation */
	double beta, spring[2]; /* EI/(H d^2); stiffness of the ends' rotation over H d */
	double *K;       /* [size][band + 1] Cholesky factor, lower band, a column contiguous */
	double *phi;     /* [degree + 1][order] functions of a part: left edge, bubbles, right edge */
	double *turn;    /* [order][order] derivative of a polynomial by x from its values at the nodes */
	double *edge;    /* [2][order] its values at both edges */
	double *g;       /* [points] static stretch */
	double *weight;  /* [points] */
	double *half;    /* [parts] half lengths */
	double *y, *f;   /* [size], [points] work space */
	struct hawser__hold hold; /* its arrays */
};

/* *bend is NULL without bending stiffness; else hawser__bend_free it. Parts have the edges
 * [parts + 1], the nodes lie at `place` [parts*order]. Statuses: _MEMORY, _NAN. */
enum hawser_status hawser__bend_make(struct hawser__bend **bend, const struct hawser_statics *st,
                                     const double *edge, int parts, int order,
                                     const struct hawser__place *place,
                                     struct hawser_report *report);
void hawser__bend_free(struct hawser__bend *bend);

/* Replace forces against the strains a, b, c, x [points][3], by the strains that answer them if no
 * condition holds the ends: pointwise eps and 1/k if bend is NULL. */
void hawser__comply(const struct hawser__bend *bend, double *x, const struct hawser__place *place,
                    int points);

/* Rows of what the energy has besides a^2/eps and k(b^2 + c^2): rows [points][2] and, behind them,
 * [4], so that the sum of the products of two strains' rows is twice the energy of both. */
void hawser__bend_rows(double *rows, const struct hawser__bend *bend, const double *strain);
/* Add that part of the energy to the lower triangle of gram [count][count] of `count` strains, each
 * `stride` behind the one before; rows [count][width] is work space. Nothing if bend is NULL. */
void hawser__bend_gram(double *gram, const struct hawser__bend *bend, double *rows,
                       const double *strain, int stride, int count);
static inline int hawser__bend_width(const struct hawser__bend *bend)
{
	return bend ? 2*bend->points + 4 : 0;
}

#endif
