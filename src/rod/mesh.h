/* rod/mesh.h - a rod as a mesh: elements, loads, the state, the equations of equilibrium.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROD_MESH_H
#define HAWSER_ROD_MESH_H

#include <hawser/rod.h>
#include <hawser/status.h>

#include "core/hold.h"
#include "net/motion/motion.h"
#include "net/water/water.h"

/* --- water.c: the loads of the water on a rod, at rest and in motion --- */

struct hawser__rod_mesh;
struct hawser__rod_motion;

struct hawser__rod_water {
	const struct hawser_water *of;    /* NULL: none, and nothing else is set */
	double part;                      /* of all loads, in statics */
	double band;                      /* m: the rod comes out of the water over this height at least */
	double velocity[3], spin, lift;   /* of the axes in statics, m/s, rad/s about y; their height, m */
	double (*load)[2][3];             /* [elements] N: on both ends, as last found in statics */
	double wet;                       /* m, unstretched length in the water, then */
	struct hawser__water_flow flow;   /* of a motion */
	struct {
		int node;                     /* -1: none */
		struct hawser_water_buoy of;  /* its mass is not used */
	} buoy;                           /* a body at a node */
};

/* Loads on a mesh at rest into mesh->r and, with `tangent`, their derivatives into its matrix. */
void hawser__rod_water_load(struct hawser__rod_mesh *mesh, int tangent);
/* Those of a motion: a hawser__rod_loading, whose data is not used. */
int hawser__rod_water_push(void *data, struct hawser__rod_motion *motion, double t, int tangent);

/* --- element.c: the element of geometrically exact rods: two nodes, one point --- */

enum { HAWSER__ROD_FREE = 6, HAWSER__ROD_PAIR = 12 }; /* unknowns of a node, of an element */

struct hawser__rod_node {
	double x[3], q[4]; /* m; from the section's axes to those of the scene */
};

/* At the middle of an element, in the section's axes: along e1, e2, e3. */
struct hawser__rod_strain {
	double w[3], k[3];  /* Rm'x', 1/m: curvature and twist, those at rest too */
	double N[3], M[3];  /* N, N m */
	double psi[3];      /* rad, turn from one node to the other */
	double half[4];     /* exp(psi/2) */
	double R[9];        /* of the middle */
};

struct hawser__rod_element {
	double h;           /* m, unstretched length */
	double EA[3];       /* N: axial and shear stiffness, along e1, e2, e3 */
	double EI[3];       /* N m^2: torsion and bending, about e1, e2, e3 */
	double w0[3], k0[3]; /* w and k at rest */
};

/* w and k of the state. Returns 1 if the element turns by pi or more, else 0. */
int hawser__rod_strain(struct hawser__rod_strain *at, const struct hawser__rod_element *el,
                       const struct hawser__rod_node node[2]);
/* h, and w0 of a rod at rest with the curvature k0. */
void hawser__rod_stretch(struct hawser__rod_element *el, double h);
/* N and M of `at` become their derivatives by h, at the same nodes. */
void hawser__rod_strain_by_length(struct hawser__rod_strain *at, const struct hawser__rod_element *el);
/* N: derivative of the energy by h, at the same nodes. */
double hawser__rod_energy_by_length(const struct hawser__rod_element *el,
                                    const struct hawser__rod_strain *at);
/* J */
double hawser__rod_energy(const struct hawser__rod_element *el, const struct hawser__rod_strain *at);
/* f [HAWSER__ROD_PAIR]: derivative of the energy, of each node with respect to x (N) and to a turn in
 * the section's axes, R exp(theta) (N m). K [PAIR][PAIR]: derivative of f; may be NULL. */
void hawser__rod_forces(double *f, double *K, const struct hawser__rod_element *el,
                        const struct hawser__rod_strain *at);

/* --- band.c: the band matrix of a rod, unknowns in the order of the nodes, and its factors --- */

enum { HAWSER__BAND_SIDE = 11 }; /* diagonals on either side: two nodes of six unknowns */
/* Of a column: 2*SIDE above the diagonal, with fill by pivots, SIDE below, and two that stay 0. */
enum { HAWSER__BAND_ROWS = 3*HAWSER__BAND_SIDE + 3 };

struct hawser__band {
	int n;
	double *a;   /* [n][HAWSER__BAND_ROWS] columns */
	int *pivot;  /* [n] */
};
enum hawser_status hawser__band_open(struct hawser__band *band, int n, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void hawser__band_clear(struct hawser__band *band);
void hawser__band_zero(struct hawser__band *band);

static inline double *hawser__band_at(struct hawser__band *band, int i, int j)
{
	return band->a + (long)j*HAWSER__BAND_ROWS + 2*HAWSER__BAND_SIDE + i - j;
}

/* The equation of unknown i becomes x_i = its right side, multiplied by the factor returned. */
double hawser__band_hold(struct hawser__band *band, int i);
/* The number of negative eigenvalues of the symmetric part, by the signs of the pivots of LDL', and
 * `work` [n][HAWSER__BAND_SIDE + 1]. What is held must be held in both its row and its column. */
int hawser__band_negative(struct hawser__band *band, const unsigned char *held /* [n] */, double *work);
/* x [n]: the right side, then the solution. Returns 0, or 1 if the matrix is singular. */
int hawser__band_factor(struct hawser__band *band);
void hawser__band_solve(const struct hawser__band *band, double *x);

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

/* --- solve.c: statics of a mesh --- */

/* What a solution took. */
struct hawser__rod_effort {
	int steps, iterations, flow; /* flow: 1, by damped motion */
	double increment;            /* the last one */
	double jump, other;          /* see struct hawser_rod_statics */
	int bent;                    /* element that turned by pi or more when it failed last; -1: none */
};

/* Find the equilibrium under full load, each load times factor [loads] (NULL: 1), from the state,
 * which is one with none (`start` 0) or near that with full load (1). The last increment is at most
 * `tolerance`. */
enum hawser_status hawser__rod_equilibrium(struct hawser__rod_mesh *mesh,
                                           struct hawser__rod_effort *effort, int start, int steps,
                                           const double *factors, double tolerance,
                                           struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* The equilibrium under the full load, which is set, by a damped motion from rest; 1: found. */
int hawser__rod_flow(struct hawser__rod_mesh *mesh, struct hawser__rod_effort *effort,
                     double tolerance);
/* statics.c: whether the loads have a potential. */
int hawser__rod_potential(const struct hawser_rod *rod);

/* points.c: the state as points, the forces of the supports; *st's point is allocated. */
enum hawser_status hawser__rod_points(struct hawser_rod_statics *st, struct hawser__rod_mesh *mesh,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
