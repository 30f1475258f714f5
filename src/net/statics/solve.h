/* net/statics/solve.h - what the methods of statics share: mesh, matrix, and state of the iteration.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_SOLVE_H
#define HAWSER_NET_SOLVE_H

#include <suitesparse/cholmod.h>

#include "core/hold.h"
#include "net/net.h"

/* Largest ratio of the stiffness along an element to that across it in the matrix of Newton's
 * method for positions and forces. An element that is stiffer takes a few iterations more: each
 * reduces the error of its length by this factor. Beyond it, round-off of the factors is felt. */
#define HAWSER__NET_RIGID 1e8

struct hawser__net_work {
	struct hawser__mesh *mesh;
	struct hawser__sparse *sparse;
	struct hawser__klu *klu; /* touch-drag.c: for friction; NULL: not needed yet */
	double *N;               /* [elements] forces, where the method has them beside the positions */
	double *s;               /* [elements] slack of the interior point */
	int own;                 /* 1: the result's tensions are N (finish.c), not of the positions */
	double *a, *b;           /* [elements] the blocks a*I + b*e*e' of the last matrix, */
	double (*e)[3];          /* [elements] with its e: the directions where it was made */
	double *T;               /* [elements] */
	double *x;               /* [unknowns] right side, then the step */
	double (*residual)[3];   /* [nodes] */
	double *bound;           /* [nodes] round-off of the forces N there, N */
	double (*start)[3];      /* [nodes] positions of the start */
	double (*near)[3];       /* [nodes] with obstacles: the positions nearest to balance so far, */
	double rest;             /* with residual/weight + apart/reach there, */
	double residual_near;    /* N, its largest force that is not balanced, */
	double apart_near;       /* m, and its largest penetration or gap of a node that touches */
	const double *first;     /* [elements] tensions of the start, or NULL */
	double weight;           /* W: sum of the forces on the nodes, N */
	double reach;            /* m: sum of the unstretched lengths */
	double damp;             /* N/m, of each node: in the matrix alone (touch-flow.c); usually 0 */
	double wanted;           /* N, of the residual: the tolerance that is asked for */
	double tolerance;        /* N, the same, at least what round-off allows for forces of positions */
	int most;                /* iterations; 0: the method's own */
	int iterations;          /* done */
	int rubs;                /* 1: friction of obstacles at rest, from touch->from; with `first` */
	int slides;              /* number of nodes that slide along an obstacle */
	int factored;            /* 1 if the factors are of a, b and e */
	struct hawser__hold hold;
};

/* A method: iterates from mesh->q; *done is 1 if the residual is within the tolerance. NULL: the
 * method has elements of its own (net/statics/dual.h). */
struct hawser__net_method {
	struct hawser_net_method shown;
	enum hawser_status (*solve)(struct hawser__net_work *work, int *done,
	                            struct hawser_report *report);
	int obstacles; /* 1 if it knows them */
};
const struct hawser__net_method *hawser__net_method(int index); /* NULL beyond the last */

enum hawser_status hawser__net_interior(struct hawser__net_work *work, int *done,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_touching(struct hawser__net_work *work, int *done,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_cone(struct hawser__net_work *work, int *done,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_dual(struct hawser__net_work *work, int *done,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_automatic(struct hawser__net_work *work, int *done,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* start.c: positions and forces N of the start, also kept in work->start. */
enum hawser_status hawser__net_begin(struct hawser__net_work *work,
                                     const struct hawser__mesh_options *options,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
/* Its forces N alone. */
void hawser__net_start_forces(struct hawser__net_work *work);

/* finish.c: the last iterations, from N and positions near the solution. */
enum hawser_status hawser__net_finish(struct hawser__net_work *work, int *done,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* a, b and T of an element for Newton's method: the block of the matrix, and the force that is
 * left of it for no step. After it is solved: the force N that goes with the step x. */
void hawser__net_linear(struct hawser__net_work *work, int element);
double hawser__net_force_after(const struct hawser__net_work *work, int element);
/* net/water/water-statics.c: the equilibrium in water, by a method for loads that do not depend on the
 * places. */
enum hawser_status hawser__water_statics(struct hawser__net_work *work,
                                         const struct hawser__net_method *method, int *done,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* The force next to N that an element of length l has by the law, if the error of positions may make
 * it shorter or longer. */
double hawser__net_lawful_force(const struct hawser__mesh *mesh, int element, double l, double N);
/* 1 if the forces N balance, and agree with the law at mesh->q. Sets T to them, or to the law for
 * forces within the tolerance; *most is the largest component that is not balanced, N, and *floor
 * what round-off allows it to be. */
int hawser__net_settled(struct hawser__net_work *work, double *most, double *floor);

/* 1 if the tensions by the law at mesh->q balance to the tolerance that is asked for: these are
 * then the result. So it is where next to nothing is taut, and N converges slowly. */
int hawser__net_lawful(struct hawser__net_work *work);

/* Assemble a*I + b*e*e' of all elements at mesh->q, and factor. */
enum hawser_status hawser__net_factor(struct hawser__net_work *work, int *definite,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Largest component over the unknowns of a residual [nodes][3] of the true law, now at mesh->q;
 * sets work->residual and work->T. Not a number if one is. */
double hawser__net_residual(struct hawser__net_work *work);
/* Add factor*x to the positions. */
void hawser__net_move(struct hawser__net_work *work, double factor);
/* Difference of the step x between the ends of an element. */
void hawser__net_stretch(double d[3], const struct hawser__net_work *work, int element);
/* x = loads. */
void hawser__net_right_loads(struct hawser__net_work *work);
/* x = loads minus the sum over elements of force[e]*e; those of form finding with their true
 * force. */
void hawser__net_right(struct hawser__net_work *work, const double *force /* [elements] */);

/* --- elimination.c: the order in which the unknowns of a mesh are eliminated --- */

/* permutation [unknowns]: few entries in the factors. 0 if there is not enough memory. */
int hawser__elimination(int *permutation, const struct hawser__mesh *mesh, cholmod_common *common);

/* --- tension.c: tensions at the nodes of a mesh, and what obstacles carry at supports --- */

struct hawser__tensions {
	const struct hawser__mesh *mesh;
	const struct hawser_net *net;
	const double (*x)[3];        /* [nodes] m */
	const double *T;             /* [elements] N */
	const double (*obstacle)[3]; /* [nodes] N: forces of obstacles; NULL: there are none */
	const double (*v)[3], (*a)[3]; /* [nodes] m/s, m/s^2; NULL: at rest, without harmonic loads */
	double t, far;               /* s; far as in struct hawser__motion */
};
/* Tension at node i of a cable, from its end `from` (0) on, N. */
double hawser__tension_at(const struct hawser__tensions *of, int cable, int i);
/* The vector of that tension, along the cable from its end `from` on. */
void hawser__tension_vector(double t[3], const struct hawser__tensions *of, int cable, int i);
/* The least tension between its nodes i and i + 1, N. */
double hawser__tension_least(const struct hawser__tensions *of, int cable, int i);
/* The forces of obstacles that touch, added to force [nodes][3]. */
void hawser__tension_obstacles(double (*force)[3], const struct hawser__mesh *mesh);
/* What an obstacle carries of the half elements at a node that a support holds on it, N; returns the
 * number of the obstacle, -1 if there is none. *length0: of these halves, m. */
int hawser__tension_rests(double force[3], double *length0, const struct hawser__tensions *of,
                          int node);

/* --- solution.c: what the solutions of meshes and of exact catenaries share --- */

/* Fail for a part without support, with the names of its nodes. */
enum hawser_status hawser__net_supported(const struct hawser__mesh *mesh, const struct hawser_net *net,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* The arrays of st, whose numbers of nodes and cables are set. */
enum hawser_status hawser__net_statics_open(struct hawser_net_statics *st, size_t elements,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;
/* hawser_net_solve by a method, which need not be a row of the table. */
enum hawser_status hawser__net_solve_by(struct hawser_net_statics *st, const struct hawser_net *net,
                                        const struct hawser__net_method *method,
                                        const struct hawser_net_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* The method `catenary`. */
enum hawser_status hawser__exact_statics(struct hawser_net_statics *st, const struct hawser_net *net,
                                         const struct hawser_net_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* By exact catenaries, with the unstretched lengths of `st`; *found is 0 if there is no solution, or if
 * there are obstacles. */
enum hawser_status hawser__net_exact(struct hawser_net_statics *exact, int *found,
                                     const struct hawser_net *net, const struct hawser_net_statics *st,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
