/* rod/mesh.h - a rod as a mesh: elements, loads, the state, the equations of equilibrium.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROD_MESH_H
#define HAWSER_ROD_MESH_H

#include <hawser/rod.h>

#include "core/hold.h"
#include "rod/band.h"
#include "rod/element.h"
#include "rod/water.h"

/* Of a node, or of a unit length of an element. */
struct hawser__rod_force {
	double force[3], moment[3]; /* N, N m, in the axes of the scene */
	double follow[3], turn[3];  /* the same in those of the section */
};

struct hawser__rod_mesh {
	const struct hawser_rod *rod;
	int elements, nodes, n;            /* n: 6*nodes unknowns: place and turn of each node */
	double *s;                         /* [nodes] m */
	int *segment;                      /* [elements] */
	int *place;                        /* [loads][2] first and last node of each load */
	struct hawser__rod_element *element; /* [elements] */
	struct hawser__rod_strain *strain; /* [elements] of `node` */
	struct hawser__rod_node *rest, *node;      /* [nodes] at rest, the state */
	struct hawser__rod_node *kept, *found;     /* [nodes] to return to: before a step, a solution */
	struct hawser__rod_node goal[2];   /* of start and end under full load */
	int detour;                        /* 1: the end is moved there in a curve */
	struct hawser__rod_force *line, *point, *sum; /* [elements] per length, [nodes], [nodes] together */
	unsigned char *held;               /* [n] */
	double *r;                         /* [n] forces that are not balanced, then increments */
	double *work;                      /* [n][HAWSER__BAND_SIDE + 1] */
	struct hawser__band band;
	struct hawser__rod_water water;
	double spin[2];                    /* N m: held lightly, of the ends, see hawser__rod_tangent */
	struct hawser__hold hold;
};

enum hawser_status hawser__rod_mesh_open(struct hawser__rod_mesh *mesh, const struct hawser_rod *rod,
                                         int refine, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__rod_mesh_clear(struct hawser__rod_mesh *mesh);
/* Weight and loads, each load times factor [loads], all of it times `part`. */
void hawser__rod_loads(struct hawser__rod_mesh *mesh, const double *factor, double part);
void hawser__rod_force_add(struct hawser__rod_force *to, const struct hawser__rod_force *one,
                           double factor);
/* Loads of node i, force in the axes of the scene and moment in those of the section; and add what they
 * are to the matrix. */
void hawser__rod_load(double r[HAWSER__ROD_FREE], const struct hawser__rod_mesh *mesh, int i);
void hawser__rod_load_tangent(struct hawser__rod_mesh *mesh, int i);
/* Strains of the state. Returns -1, or the first element that turns by pi or more. */
int hawser__rod_strains(struct hawser__rod_mesh *mesh);
/* r: loads less internal forces, of the strains; 0 where held. */
void hawser__rod_residual(struct hawser__rod_mesh *mesh);
/* The same, and the matrix of derivatives of -r with respect to the unknowns. */
void hawser__rod_tangent(struct hawser__rod_mesh *mesh);
/* Move the state by `step` [n] times `part`. */
void hawser__rod_move(struct hawser__rod_mesh *mesh, const double *step, double part);
/* Set the positions of the nodes from that of the first, the rotations, and the w of each strain. */
void hawser__rod_place(struct hawser__rod_mesh *mesh);
/* Turn the nodes by `step` [n], and place them so that each w changes to first order in `step`. If
 * nodes were moved by `step` itself, w would also change by the square of the turns, and with a
 * large EA the forces of that exceed all others. The position of a held end is wrong by the same
 * square until the next step. The strains must be those of the state. */
void hawser__rod_follow(struct hawser__rod_mesh *mesh, const double *step);
/* J, of strain. */
double hawser__rod_strain_energy(const struct hawser__rod_mesh *mesh);

#endif
