/* net/statics/exact.h - statics of a net whose cables are exact catenaries: the method `catenary`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_EXACT_H
#define HAWSER_NET_EXACT_H

#include "net/statics/dual.h"

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

#endif
