/* net/modes/symmetry-map.h - whether a rotation or reflection maps the equilibrium of a mesh
 * onto itself. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_SYMMETRY_MAP_H
#define HAWSER_NET_SYMMETRY_MAP_H

#include "core/hold.h"
#include "net/net.h"

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
