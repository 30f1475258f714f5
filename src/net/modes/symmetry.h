/* net/modes/symmetry.h - planes and turns that map the equilibrium of a mesh onto itself, and
 * what modes are with respect to them. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_SYMMETRY_H
#define HAWSER_NET_SYMMETRY_H

#include <hawser/net_modes.h>

#include "core/hold.h"
#include "net/modes/eigen.h"
#include "net/net.h"

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

/* --- symmetry-map.c: whether a rotation or reflection maps the equilibrium of a mesh onto
 * itself --- */

/* Most that a node's image may be off its partner, over the size of the net. */
#define HAWSER__MAP_PLACES 1e-4

struct hawser__map_try {
	const struct hawser__mesh *mesh;
	const double *T;       /* [elements] N */
	int nodes;             /* of the scene */
	unsigned char *used;   /* [mesh->nodes] 1: a cable ends or runs there, or it can move */
	double centre[3], size; /* of the net: set by the caller, before hawser__map_sort */
	int *partner;          /* [mesh->nodes] of the last map that held */
	struct hawser__map_key *key; /* [nodes] places along one direction, ascending */
	int keys;
	int *first, *incident; /* [nodes + 1], [2*cables] the cables at each node of the scene */
	unsigned char *taken;  /* [cables] */
	double noise;          /* N, round-off of a tension */
	struct hawser__hold hold;
};
enum hawser_status hawser__map_open(struct hawser__map_try *try, const struct hawser__mesh *mesh,
                                    const double *T, int nodes, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void hawser__map_sort(struct hawser__map_try *try);
void hawser__map_clear(struct hawser__map_try *try);
/* 1 if x - centre -> map*(x - centre) holds; *places (m) and *elements say how well. */
int hawser__map_holds(struct hawser__map_try *try, const double map[3][3], double *places,
                      double *elements);

#endif
