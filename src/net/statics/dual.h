/* net/statics/dual.h - equilibrium from forces that are in balance: see net/statics/dual.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_DUAL_H
#define HAWSER_NET_DUAL_H

#include "net/net.h"
#include "net/statics/catenary.h"

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

/* --- exact.c: statics of a net whose cables are exact catenaries: the method `catenary` --- */

struct hawser__exact {
	struct hawser__mesh mesh; /* of one element a cable: joints, loads, unknowns */
	struct hawser__dual dual;
};

/* Both fill or return with *exact to be cleared. Solve: mesh.q and dual.F. */
enum hawser_status hawser__exact_open(struct hawser__exact *exact, const struct hawser_net *net,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__exact_solve(struct hawser__exact *exact, struct hawser__equilibrium *found,
                                       double tolerance, int most, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* mesh->q of a mesh of the net, and tensions N [elements], on the catenaries: a start for its own
 * statics. 0 if there is none. */
int hawser__exact_start(struct hawser__mesh *mesh, double *N, const struct hawser_net *net);
void hawser__exact_clear(struct hawser__exact *exact);

/* --- form.c: form finding: the force densities of cables whose tension is given --- */

struct hawser__form {
	struct hawser__mesh *mesh;
	const struct hawser_net *net;
	struct hawser__mesh_options options; /* of the equilibria */
	struct hawser__equilibrium found;    /* the last one */
	struct hawser__sparse *sparse;       /* of the stiffness there */
	int count, *cable;                   /* [count] cables whose tension is given */
	double *T;                           /* [elements] N */
	double *x;                           /* [unknowns] */
	double *H, *step;                    /* [count][count], [count] */
	double *before;                      /* [count] N/m, densities before a step */
	unsigned char *gone;                 /* [cables] 1: it has no length in the shape */
	double damping;                      /* of Newton's method, 0 to 1 */
};
enum hawser_status hawser__form_open(struct hawser__form *form, struct hawser__mesh *mesh,
                                     const struct hawser_net *net,
                                     const struct hawser__mesh_options *options,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__form_clear(struct hawser__form *form);
/* The equilibrium with mesh->density and mesh->force as they are: form->T, form->found. */
enum hawser_status hawser__form_balance(struct hawser__form *form, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* From there, a step of the densities that lowers the convex function; with its equilibrium. */
enum hawser_status hawser__form_step(struct hawser__form *form, struct hawser_report *report)
	HAWSER_MUST_CHECK;

#endif
