/* net/statics/dual.h - equilibrium from forces that are in balance: see net/statics/dual.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_DUAL_H
#define HAWSER_NET_DUAL_H

#include "net/statics/catenary.h"
#include "net/net.h"

struct hawser__dual {
	struct hawser__mesh *mesh;
	struct hawser__sparse *sparse;  /* of the mesh; NULL if every node is held */
	struct hawser__net_catenary *cable; /* [elements] */
	double (*F)[3], (*step)[3];     /* [elements] */
	double *x;                      /* [unknowns] */
	double weight;                  /* N, sum of the forces on the nodes */
	int started;                    /* 1 after the step that has the force densities */
	double open;                    /* largest part of an element's length that its chord is off */
	int iterations;
};

/* Elements without weight of their own; the caller sets `sparse`, which stays his. */
enum hawser_status hawser__dual_open(struct hawser__dual *dual, struct hawser__mesh *mesh,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__dual_clear(struct hawser__dual *dual);
/* Solve for mesh->q and F; the tolerance is relative to the weight. *done is 1 if it was reached. */
enum hawser_status hawser__dual_solve(struct hawser__dual *dual, int *done, double *residual,
                                      double tolerance, int most, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* Stiffness of an element, and what its chord has beyond that of its force. */
void hawser__dual_linear(double K[3][3], double gap[3], const struct hawser__dual *dual, int element);

#endif
