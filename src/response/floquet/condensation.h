/* response/floquet/condensation.h - variational equations while their fast coordinates are condensed:
 * see monodromy_condense.c. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_CONDENSATION_H
#define HAWSER_RESPONSE_CONDENSATION_H

#include "response/floquet/monodromy.h"

/* The coordinates of all matrices are ordered: the slow ones first, by blocks. */
struct hawser__condensation {
	int n, ns, nf, rows, order; /* order of the result */
	int columns;                /* of the basis, for all harmonics of K and D too */
	int symmetric;              /* 1: K is, and D is constant */
	int apart;                  /* 1: D is constant, and couples no coordinates */
	int singular;               /* 1: K_ff was, at a phase, in a try */
	int blocks;
	struct hawser__block *block;        /* [n] */
	size_t wide_F, wide_N;      /* of a row */
	int *pivot;                 /* [n] */
	double *basis;              /* [rows][columns] */
	double *turn;               /* [rows][rows] derivative by the phase */
	double *sorted;             /* [columns][n][n] coefficients of K or D */
	double *K, *D;              /* [rows][n][n]; D: [1][n][n] if it is constant */
	size_t next_D;              /* n^2, or 0 if D is constant */
	double *F, *F1, *rate;      /* [rows][blocks][nf][2 ns]; rate: time derivative of one of them */
	double *N, *before;         /* [rows][blocks][ns][2 ns] of this and the last iteration */
	double *inverse;            /* [rows][nf][nf] of K_ff */
	double *part;               /* [nf] */
	double *series;             /* [2 order + 1][blocks][ns][2 ns] of N */
	double *result[2];          /* [2 order + 1][ns][ns] K and D of the slow coordinates */
	double last;                /* size of the last harmonic of N, relative as in reduce() */
};

/* The inverse of K_ff of a block at one phase; 1 if K_ff is singular, or symmetric and not positive. */
int hawser__condense_invert(const struct hawser__condensation *work,
                            const struct hawser__monodromy *monodromy,
                            const struct hawser__block *block, int row);
/* Iterates F from the static response, until N changes by less than `goal` or no longer less; returns
 * the last change of N. */
double hawser__condense_settle(const struct hawser__condensation *work,
                               const struct hawser__monodromy *monodromy, double omega,
                               double goal);

#endif
