/* net/modes/symmetry.h - planes and turns that map the equilibrium of a mesh onto itself, and
 * what modes are with respect to them. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_SYMMETRY_H
#define HAWSER_NET_SYMMETRY_H

#include <hawser/net_modes.h>

#include "net/modes/eigen.h"

/* One map of the mesh onto itself: a node goes to its partner, a vector to map*vector. */
struct hawser__net_map {
	double map[3][3];
	int *partner; /* [nodes] of the mesh */
};

/* Those of a mesh: of its own plane, of the mirror planes, and the turn by 2*pi/turns. */
struct hawser__net_maps {
	struct hawser_net_symmetry found;
	struct hawser__net_map plane, mirror[HAWSER_NET_MIRRORS], turn; /* partner NULL: none */
};
/* nodes: those of the scene, the first of the mesh. */
enum hawser_status hawser__net_maps_open(struct hawser__net_maps *maps, const struct hawser__mesh *mesh,
                                         const double *T, int nodes, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void hawser__net_maps_clear(struct hawser__net_maps *maps);

/* modes-label.c: choose the vectors of equal frequencies, and say what each is: parity, waves and pair
 * of `modes`, whose n and symmetry are set and which are allocated. */
enum hawser_status hawser__net_modes_label(struct hawser_net_modes *modes, struct hawser__eigen *eigen,
                                           const struct hawser__net_maps *maps,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
