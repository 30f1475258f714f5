/* net/statics/form.h - form finding: the force densities of cables whose tension is given.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_FORM_H
#define HAWSER_NET_FORM_H

#include "net/net.h"

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
