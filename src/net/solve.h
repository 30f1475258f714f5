/* net/solve.h - what the methods of statics share: mesh, matrix, and state of the iteration.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_SOLVE_H
#define HAWSER_NET_SOLVE_H

#include "net/net.h"

struct hawser__net_work {
	struct hawser__mesh *mesh;
	struct hawser__sparse *sparse;
	double *N, *s;           /* [elements] force and slack of the interior point; mixed Newton: force */
	double *a, *b;           /* [elements] the blocks a*I + b*e*e' of the last matrix */
	double *T;               /* [elements] */
	double *x;               /* [unknowns] right side, then the step */
	double (*residual)[3];   /* [nodes] */
	double (*start)[3];      /* [nodes] positions of the start */
	const double *first;     /* [elements] tensions of the start, or NULL */
	double weight;           /* W: sum of the forces on the nodes, N */
	double reach;            /* m: sum of the unstretched lengths */
	double left;             /* N: residual of a law that is not one-sided */
	double tolerance;        /* N, of the residual */
	int most;                /* iterations; 0: the method's own */
	int iterations;          /* done */
	int factored;            /* 1 if the factors are of a and b */
};

/* A method: iterates from mesh->q; *done is 1 if the residual is within the tolerance. NULL: the method
 * has elements of its own (net/exact.h). */
struct hawser__net_method {
	struct hawser_net_method shown;
	enum hawser_status (*solve)(struct hawser__net_work *work, int *done,
	                            struct hawser_report *report);
	int one_sided; /* 1 if what it finds has no compressed element */
	enum hawser_net_start start; /* where it begins */
};
const struct hawser__net_method *hawser__net_method(int index); /* NULL beyond the last */

enum hawser_status hawser__net_interior(struct hawser__net_work *work, int *done,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_mixed(struct hawser__net_work *work, int *done,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_dual(struct hawser__net_work *work, int *done,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_two_sided(struct hawser__net_work *work, int *done,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_regularised(struct hawser__net_work *work, int *done,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_descent(struct hawser__net_work *work, int *done,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_relaxation(struct hawser__net_work *work, int *done,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_automatic(struct hawser__net_work *work, int *done,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* start.c: positions and forces N of the start, also kept in work->start. */
enum hawser_status hawser__net_begin(struct hawser__net_work *work,
                                     const struct hawser__net_method *method,
                                     const struct hawser__mesh_options *options,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
/* Its forces N alone. */
void hawser__net_start_forces(struct hawser__net_work *work);

/* Assemble a*I + b*e*e' of all elements at mesh->q, and factor. */
enum hawser_status hawser__net_factor(struct hawser__net_work *work, int *definite,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Largest component over the unknowns of a residual [nodes][3] of the true law, now at mesh->q; sets
 * work->residual and work->T. Not a number if one is. */
double hawser__net_residual(struct hawser__net_work *work);
/* Add factor*x to the positions. */
void hawser__net_move(struct hawser__net_work *work, double factor);
/* Difference of the step x between the ends of an element. */
void hawser__net_stretch(double d[3], const struct hawser__net_work *work, int element);
/* x = loads minus the sum over elements of force[e]*e; those of form finding with their true force. */
void hawser__net_right(struct hawser__net_work *work, const double *force /* [elements] */);

#endif
