/* net/net.h - the mesh of a net: every cable is a chain of straight elements between nodes.
 *
 * Energy, with d = q[end1] - q[end0], l = |d|, k = EA/length0 and p = max(l - length0, 0):
 * Pi(q) = sum of k*p^2/2 - force.q over all nodes. It is convex in q for any graph, so that every
 * equilibrium is a least one; the tensions T = k*p of the elements are unique.
 *
 * The first nodes of the mesh are those of the scene, in their order; then come the inner nodes of
 * cable 0, from its end `from` to its end `to`, of cable 1, and so on. The elements of a cable are
 * consecutive, in the same direction.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_NET_H
#define HAWSER_NET_NET_H

#include <hawser/net_modes.h>

#include "core/hold.h"

struct hawser__mesh {
	int nodes, elements, cables, unknowns;
	int *first;            /* [cables + 1] first element of each cable; the last entry is `elements` */
	int *inner;            /* [cables] mesh node after the end `from`; -1 if the cable is one element */
	int (*end)[2];         /* [elements] nodes of each element */
	int *cable;            /* [elements] the cable it is of */
	double *length0;       /* [elements] m */
	double *EA;            /* [elements] N */
	double *offset;        /* [elements] strain at which the present piece of the law of the cable
	                        * has no tension: length0 and EA are of it, rho*length0 is the mass */
	double *stored;        /* [elements] J: energy of the law beyond that of this piece */
	double *density;       /* [elements] N/m; positive only within form finding, where the tension
	                        * of the element is density*l */
	double *rho;           /* [elements] kg/m per unstretched length */
	double *axial;         /* [elements] s: T = EA*(strain + axial*its rate) */
	double (*q)[3];        /* [nodes] positions: of supports as given; of the others as last solved */
	int (*unknown)[3];     /* [nodes] index of the unknown of each direction; -1 if it is held */
	double (*frame)[3][3]; /* [nodes] rows: these directions, unit vectors at right angles to each
	                        * other; NULL: the axes. Set for modes alone (hawser__touch_hold) */
	int *rigid;            /* [nodes] 1 + number of the body it is of, which holds it; 0: none */
	struct hawser__mesh_body {
		int first, motions;     /* unknowns */
		double motion[6][6], about[3]; /* columns: displacement and turn of each, about a place */
		double turned[6][6];    /* of K: as the arms of the forces at rest turn */
	} *body;               /* [bodies] their motions as unknowns, after all others; NULL: they are held.
	                        * Set for modes and linear responses alone (hawser__bodies_release) */
	int body_unknowns;
	double *mass;          /* [nodes] point masses, kg, without the cables */
	double (*damper)[3], (*spring)[3]; /* [nodes] N s/m, N/m: to the ground */
	double (*force)[3];    /* [nodes] weight (of cables, half to each end, and point masses) and
	                        * constant loads, N */
	struct hawser__mesh_wave *wave; /* [waves] harmonic loads, at mesh nodes */
	struct hawser__mesh_wave *motion; /* [motions] harmonic displacements of held directions */
	int waves, motions;
	double g, alpha;       /* as in struct hawser_net */
	struct hawser__touch *touch; /* [touches] each node that can move, with each obstacle */
	int touches;
	unsigned char *stands; /* [nodes of the net] 1: of a body, and no hinge. With it, `touch` has nodes
	                        * of bodies with planes that give way, too; NULL: while statics looks
	                        * for the equilibrium of the lines */
	int surfaces_rest;     /* 1: the surfaces of obstacles do not move: before a motion */
	struct hawser__mesh_rotor {
		int unknown, surface;
		double mass;       /* kg: inertia/radius^2 */
	} *rotor;              /* [rotors] circles that turn with what sticks to them: the unknown of all
	                        * these nodes is the motion of the rim, counterclockwise. As edge */
	int rotors;
	struct hawser__mesh_edge {
		int element, touch;
	} *edge;               /* [edges] an element that leaves a curved obstacle, with the touch of
	                        * the end that is on it. Set for modes alone (hawser__touch_hold) */
	int edges;
	struct hawser__mesh_absorber {
		int node, at, axis; /* of the mesh: its node, and the one whose direction `axis`, the nearest
		                     * to its own, is its stroke, with that spring and damper */
		double mass, e[3];  /* kg; unit vector */
	} *absorber;           /* [absorbers] */
	int absorbers;
	struct hawser__mesh_water *water; /* NULL: none; net/water/water.h */
	const struct hawser_net *net; /* it is of; used for the laws of its cables alone */
	int around;            /* 1: an obstacle has cables around it: they begin straight between the
	                        * places of nodes, and supports need not hold them */
	struct hawser__hold hold;
};

/* A node that may touch an obstacle. Its force on the node is r*n + friction, and `aside` along z; r
 * is 0 unless it touches. */
struct hawser__touch {
	const struct hawser_surface *surface; /* of the net */
	int number;            /* of that surface */
	int node, element, end; /* the node is this end of this element; element -1: a body's, of none */
	int other;             /* another element of the node; -1: there is none */
	double give;           /* m/N: how far the obstacle gives way; 0: rigid */
	int curved;            /* 1: the matrix has the second derivatives of the gap */
	double g, n[3], H[3][3]; /* gap, its gradient and second derivatives, at mesh->q */
	double r, t;           /* N; m: slack of the interior point, g + give*r at its end */
	double friction[3];    /* N */
	double aside;          /* N: along z, of a groove */
	int slides;            /* 1: friction is at its bound, against the slip */
	double from[3];        /* m: the place where the node stuck or slid from */
	double stiff, hold;    /* N/m, of the linear equations: along the normal; along the surface */
	double block[3][3], push[3]; /* what it gives to the matrix, and to the right side */
	double drag[3];        /* friction of one that slides over r: follows r within a step */
	double turn[3][3];     /* N/m: the derivative of its direction by the place, times friction*r */
};

/* Springs along a plane that gives way over that across it, by which friction holds: the slip before it
 * slides is this part of mu times the depth, of which the friction of moorings feels nothing. */
#define HAWSER__STIFFER_ALONG 10.0

/* value*cos(Omega*t + phase) at a node: a force, N, or a displacement, m. */
struct hawser__mesh_wave {
	int node, multiple; /* as in struct hawser_net_load */
	double value[3], Omega, phase;
};

/* The mesh of a net. Cables whose unstretched length is not given have length0 = 0 in their elements
 * and no weight or load, until form finding has set it (hawser__mesh_load). */
enum hawser_status hawser__mesh_build(struct hawser__mesh *mesh, const struct hawser_net *net,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Fail if cables have tables of tensions or dashpots, which `what` cannot use. */
enum hawser_status hawser__mesh_lawless(const struct hawser_net *net, const char *what,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* 1 if cables have a dashpot in line with a spring. */
int hawser__mesh_creeps(const struct hawser_net *net);
/* Take the pieces of the laws that the elements at mesh->q are on; returns how many are new, beyond
 * round-off of the tensions. */
int hawser__mesh_follow(struct hawser__mesh *mesh);
/* Go back from mesh->q towards `from` [nodes][3] to where the energy is least; `d` is work space. */
void hawser__mesh_descend(struct hawser__mesh *mesh, double (*from)[3], double (*d)[3]);
/* Unstretched length of an element. */
double hawser__mesh_length(const struct hawser__mesh *mesh, int element);
/* Recompute force and the amplitudes of waves from the unstretched lengths of the elements. */
void hawser__mesh_load(struct hawser__mesh *mesh, const struct hawser_net *net);
/* Length of an element whose load of its cable acts on its end `side`. */
double hawser__mesh_carried(const struct hawser__mesh *mesh, const struct hawser_net_load *load,
                            int element, int side);
/* Hold or release the directions of a node: counts the unknowns anew. */
void hawser__mesh_hold(struct hawser__mesh *mesh, int node, const unsigned char held[3]);
/* Hold all nodes in the directions that are not in `along` (bit k: direction k). */
void hawser__mesh_along(struct hawser__mesh *mesh, unsigned along);
/* Count the unknowns anew, after mesh->unknown has been set to -1 (held) or 0. */
void hawser__mesh_number(struct hawser__mesh *mesh);
/* The direction k of a node: a row of its frame. */
void hawser__mesh_axis(double axis[3], const struct hawser__mesh *mesh, int node, int k);
/* absorbers.c: list the absorbers of the net, whose strokes are held: statics has none; and release
 * those along directions (bit k: direction k). */
void hawser__absorbers_open(struct hawser__mesh *mesh, const struct hawser_net *net, int first);
void hawser__absorbers_release(struct hawser__mesh *mesh, unsigned along);
/* What their motion adds to the mass matrix beside the masses of their nodes: entry j of direction
 * `axis` of a node and `other_axis` of another, kg; 0: there are no more. */
struct hawser__mesh_pair {
	int node, axis, other, other_axis;
	double mass;
};
int hawser__absorbers_mass(struct hawser__mesh_pair *pair, const struct hawser__mesh *mesh, int j);
/* Hold all nodes along axis k, at one place (m). */
void hawser__mesh_flatten(struct hawser__mesh *mesh, int k, double place);
void hawser__mesh_clear(struct hawser__mesh *mesh);

/* residual [nodes][3] = gradient of Pi at mesh->q: also in held directions, where it is minus
 * the force of the support on the net. T [elements] gets the tensions, if not NULL. */
void hawser__mesh_gradient(double (*residual)[3], double *T, const struct hawser__mesh *mesh);
/* Bound of the round-off of this gradient: EA*ulp(position)/length0, largest over the nodes, N. */
double hawser__mesh_floor(const struct hawser__mesh *mesh);
/* The unknowns of the two ends of an element; -1: held. */
static inline void hawser__mesh_unknowns(int u[6], const struct hawser__mesh *mesh, int element)
{
	for (int k = 0; k < 6; k++)
		u[k] = mesh->unknown[mesh->end[element][k/3]][k%3];
}
/* Length of an element, and unit vector along it (zero if the length is 0). */
double hawser__mesh_direction(double e[3], const struct hawser__mesh *mesh, int element);

/* touch.c: list the touches of the net's obstacles, after the nodes are numbered. */
enum hawser_status hawser__touch_open(struct hawser__mesh *mesh, const struct hawser_net *net,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* List them anew after nodes were held or released; forces r stay. */
enum hawser_status hawser__touch_again(struct hawser__mesh *mesh, const struct hawser_net *net,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* 1 if cables go around an obstacle, as belts. */
int hawser__touch_around(const struct hawser_net *net);
/* mesh-error.c: m, the longest element, over which beds are rounded. */
double hawser__net_rounding(const struct hawser_net *net);
/* Gaps and their derivatives at mesh->q. */
void hawser__touch_measure(struct hawser__mesh *mesh);
/* Fail for a net with obstacles or water, which `command` does not know. */
enum hawser_status hawser__touch_none(const struct hawser_net *net, const char *command,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* Symmetric sparse matrices over the unknowns, sums of a 3x3 block for each element as
 * [B, -B; -B, B], and their Cholesky factors (SuiteSparse CHOLMOD). The pattern is analysed once. */
struct hawser__sparse;
enum hawser_status hawser__sparse_open(struct hawser__sparse **sparse,
                                       const struct hawser__mesh *mesh,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__sparse_clear(struct hawser__sparse *sparse);
void hawser__sparse_zero(struct hawser__sparse *sparse);
/* Add a*I + b*e*e' for an element; add to the diagonal of an unknown. */
void hawser__sparse_add(struct hawser__sparse *sparse, int element, double a, double b,
                        const double e[3]);
/* Add a symmetric block B for an element. */
void hawser__sparse_block(struct hawser__sparse *sparse, int element, const double block[3][3]);
/* Add the lower triangle of a symmetric block over both ends of an element, whose unknowns may be the
 * same (rotors). */
void hawser__sparse_ends(struct hawser__sparse *sparse, int element, const double block[6][6]);
/* Add a symmetric block at the node that is end 0 or 1 of an element. */
void hawser__sparse_node(struct hawser__sparse *sparse, int element, int end, const double block[3][3]);
void hawser__sparse_diagonal(struct hawser__sparse *sparse, int unknown, double value);
/* Add to two unknowns, of an absorber and its node. */
void hawser__sparse_pair(struct hawser__sparse *sparse, int unknown, int other, double value);
/* Factor; *definite is 0 if the matrix is not positive definite (then the factors are not usable). */
enum hawser_status hawser__sparse_factor(struct hawser__sparse *sparse, int *definite,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same for a matrix that is not definite; its factors L*D*L' are made without pivoting. */
enum hawser_status hawser__sparse_open_indefinite(struct hawser__sparse **sparse,
                                                  const struct hawser__mesh *mesh,
                                                  struct hawser_report *report) HAWSER_MUST_CHECK;
/* Factor, and count the negative eigenvalues; *done 0: a pivot is zero. */
enum hawser_status hawser__sparse_inertia(int *negative, int *done, struct hawser__sparse *sparse,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
/* Memory of matrix and factors, bytes. */
double hawser__sparse_bytes(const struct hawser__sparse *sparse);
/* Solve for a right side [unknowns], in place. */
enum hawser_status hawser__sparse_solve(double *x, struct hawser__sparse *sparse,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* A part of the net that no support holds in one direction: it has no equilibrium, or one at any place.
 * *lost is its first node, -1 if there is none; part [nodes] gets the first node of each part. */
enum hawser_status hawser__mesh_loose(int *lost, int *direction, const struct hawser__mesh *mesh,
                                      int *part, struct hawser_report *report) HAWSER_MUST_CHECK;

/* hawser_net_modes_solve for motions in the directions `axes` only (bit k: direction k), as modes of
 * one plane of a net that is plane. */
enum { HAWSER__NET_SPACE = 7 };
enum hawser_status hawser__net_modes(struct hawser_net_modes *modes, const struct hawser_net *net,
                                     int n, unsigned axes, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* What statics found. */
struct hawser__equilibrium {
	double energy;     /* J, Pi */
	double gap;        /* J: Pi is at most this above its least value */
	double residual;   /* N, largest component of the force that is not balanced */
	double floor;      /* N, what round-off allows */
	const char *method;
	int iterations;
	double apart;      /* m: largest penetration of an obstacle, or gap of a node that touches */
};
struct hawser__mesh_options {
	const struct hawser__net_method *method; /* NULL: the first row */
	double tolerance;   /* of the residual over the weight and load; 0: 1e-10 */
	int iterations;     /* most; 0: the method's own */
	int keep_start;     /* begin at mesh->q instead of at the force-density start */
	const double *N;    /* [elements] tensions of that start; NULL: a part of the loads */
	int rubs;           /* 1: obstacles rub; with keep_start */
};
/* Solve for mesh->q, and the tensions T [elements]. Fails with HAWSER_ERR_NO_SOLUTION where parts have
 * no support, and with HAWSER_ERR_CONVERGENCE. */
enum hawser_status hawser__mesh_statics(struct hawser__mesh *mesh, double *T,
                                        struct hawser__equilibrium *found,
                                        const struct hawser__mesh_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same for a net whose cables may have tension, force_density or sag: finds the shape, then the
 * unstretched lengths of the elements, and solves with these. */
enum hawser_status hawser__mesh_form(struct hawser__mesh *mesh, double *T,
                                     struct hawser__equilibrium *found, const struct hawser_net *net,
                                     const struct hawser__mesh_options *options,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
