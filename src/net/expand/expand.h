/* net/expand/expand.h - the energy of a net to fourth order in given shapes, the rest of it following
 * statically (doc/theory-rom.md, "Nets"). SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_EXPAND_H
#define HAWSER_NET_EXPAND_H

#include "core/hold.h"
#include "modes/pairing.h"
#include "net/modes/eigen.h"

/* Units are m, and `energy` for energies. A displacement is a row of the mesh's unknowns; one of the
 * supports, a row of its nodes. */
struct hawser__nexpand {
	const struct hawser__mesh *mesh;
	struct hawser__sparse *sparse; /* the factors of K */
	double energy;           /* J */
	int n, modes, pairs;     /* shapes, of which the first are modes, along which nothing follows */
	const double *omega2;    /* [modes] their stiffness, in `energy` */
	const double *mode;      /* [modes][unknowns] m, the same as shapes */
	double (*shape)[3];      /* [n][nodes] m, displacements */
	double *weight, *strain; /* [elements] EA L0 over `energy`; g - 1, of stretch g */
	double (*axes)[3][3];    /* [elements] tangent, and two normals */
	double (*slope)[3];      /* [n][elements] a, b, c along these */
	double *third;           /* [n][n][n] third derivatives of the energy */
	double *pairing;         /* [pairs][pairs]: the part of fourth derivatives that one way to pair four
	                          * indices gives */
	double *second;          /* [pairs][unknowns] m: 1/2 sum u_j u_k w_jk follows */
	struct hawser__hold hold;
};

/* The elements, and room for n shapes, of which the caller fills `shape`, omega2 and mode. All elements
 * that move are taut. Clear it, on failure too. */
enum hawser_status hawser__nexpand_open(struct hawser__nexpand *t,
                                        const struct hawser__net_modal *modal, double energy, int n,
                                        int modes, struct hawser_report *report) HAWSER_MUST_CHECK;
/* The slopes of the shapes, third derivatives, and what follows; then `pairing`, which is right for a
 * part of what follows, too, if the rest of it is orthogonal to that part in stiffness. */
enum hawser_status hawser__nexpand_follow(struct hawser__nexpand *t,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__nexpand_pairs(struct hawser__nexpand *t,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__nexpand_clear(struct hawser__nexpand *t);

/* Fourth derivative of the energy by four times shape j, after _follow. */
double hawser__nexpand_own(const struct hawser__nexpand *t, int j);
/* a, b, c at an element of displacements [nodes][3] or of a row of unknowns. */
void hawser__nexpand_slope(double slope[3], const struct hawser__nexpand *t, int element,
                           const double (*shape)[3]);
void hawser__nexpand_row_slope(double slope[3], const struct hawser__nexpand *t, int element,
                               const double *row);
/* Third derivative by shapes j and k and a field with the slopes [elements][3]. */
double hawser__nexpand_third(const struct hawser__nexpand *t, int j, int k, const double (*field)[3]);

#endif
