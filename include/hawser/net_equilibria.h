/* hawser/net_equilibria.h - the equilibria of a few bars, which also carry compression.
 *
 * A cable carries tension only: its net has one equilibrium, which hawser_net_solve finds. With the
 * two-sided law T = EA*(l/length0 - 1), of bars, the energy is not convex, and the same net has
 * several equilibria, some of them unstable (B 2.2.5). This search shows them. It begins at random
 * places, so that it may miss some: `last` tells at which start the last one was found.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_EQUILIBRIA_H
#define HAWSER_NET_EQUILIBRIA_H

#include <hawser/net.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HAWSER_NET_EQUILIBRIA_UNKNOWNS = 90 }; /* most unknowns: the matrices are dense */

struct hawser_net_equilibrium {
	double (*x)[3];     /* [nodes] of the net, m */
	double energy;      /* J: strain energy minus loads times positions */
	double T_min, T_max; /* N: of the bars; negative: compression */
	double residual;    /* N: largest component of a force that is not balanced */
	double stiffness;   /* N/m: least eigenvalue of the tangent stiffness */
	int compressed;     /* number of bars under compression */
	int unstable;       /* number of negative eigenvalues; 0: stable */
};

struct hawser_net_equilibria {
	struct hawser_net_equilibrium *list; /* [count] by rising energy */
	int count, nodes, bars, unknowns;
	int starts;      /* done */
	int last;        /* number of the start, from 1, that found the last new one; 0: none was found */
	int failed;      /* starts from which Newton's method did not converge */
	int degenerate;  /* starts that ended where the tangent stiffness is singular: not in the list */
};

struct hawser_net_equilibria_options {
	int starts;      /* 0: 2000 */
	unsigned seed;   /* of the random places; 0: 1 */
};

/* Newton's method with the whole tangent from random places. Bars are the elements of the mesh. */
enum hawser_status hawser_net_equilibria_find(struct hawser_net_equilibria *found,
                                              const struct hawser_net *net,
                                              const struct hawser_net_equilibria_options *options,
                                              struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_net_equilibria_clear(struct hawser_net_equilibria *found);

#ifdef __cplusplus
}
#endif
#endif
