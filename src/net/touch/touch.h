/* net/touch/touch.h - nodes that touch obstacles, in the equations of statics.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_TOUCH_H
#define HAWSER_NET_TOUCH_H

#include "net/statics/solve.h"

/* residual [nodes][3] less the forces of the obstacles. */
void hawser__touch_forces(double (*residual)[3], const struct hawser__mesh *mesh);
/* Blocks and right sides of all touches, where these are set; x [unknowns]. */
void hawser__touch_matrix(struct hawser__sparse *sparse, const struct hawser__mesh *mesh);
void hawser__touch_right(double *x, const struct hawser__mesh *mesh);
/* touching.c: a step of Newton's method for positions and forces, with work->damp; *definite 0: none,
 * *descends 1: without a part of the curvature of obstacles. Whether its result is the equilibrium. */
enum hawser_status hawser__touch_step(struct hawser__net_work *work, int *definite, int *descends,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
int hawser__touch_done(struct hawser__net_work *work);
/* Newton's method from places, forces of elements and of contacts that are near. */
enum hawser_status hawser__touch_newton(struct hawser__net_work *work, int *done,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* touch-flow.c: a damped motion from the positions and forces that there are. */
enum hawser_status hawser__touch_flow(struct hawser__net_work *work, int *done,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* touch-drag.c: work->x, a right side, becomes the step. Without friction that slides the factors of
 * hawser__net_factor are used; with it the matrix is not symmetric, and is made and factored here.
 * *good is 0 if it is singular. */
enum hawser_status hawser__touch_divide(struct hawser__net_work *work, int *good,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* touch-oval.c: D = friction over r of a plane with two coefficients that moves at v; and what follows
 * from the direction of the elements, in the matrix. */
void hawser__touch_oval(double D[3], const struct hawser__mesh *mesh, const struct hawser__touch *touch,
                        const double v[3]);
struct hawser__klu;
void hawser__touch_oval_matrix(struct hawser__klu *klu, const struct hawser__mesh *mesh,
                               const struct hawser__touch *touch);
/* No blocks; the right sides are the forces as they are. */
void hawser__touch_fixed(struct hawser__mesh *mesh);
/* 1 if the obstacles leave a convex space. */
int hawser__touch_convex(const struct hawser__mesh *mesh);
/* Bring the nodes of a start to the free side of all obstacles. */
enum hawser_status hawser__touch_start(struct hawser__mesh *mesh,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* The interior point: r*t = mu, t = g. _begin: from a mean of the products; _mean: adds the products
 * and their number; _interior: blocks and right sides; _limit: *step so that r and t stay positive;
 * _advance. */
void hawser__touch_begin(struct hawser__mesh *mesh, double product, double force);
void hawser__touch_mean(double *sum, int *count, const struct hawser__mesh *mesh);
void hawser__touch_interior(struct hawser__mesh *mesh, double mu);
void hawser__touch_limit(double *step, const struct hawser__net_work *work, double mu);
/* Gaps as the slacks of circles and segments: a gap is a convex function, at least what a step makes of
 * its linear part, so that nodes that begin on the free side stay there. */
void hawser__touch_follow(struct hawser__mesh *mesh);
void hawser__touch_advance(const struct hawser__net_work *work, double mu, double step);

/* Newton's method with contact: r = max(0, r - stiff*g), and friction; the equations of the next step
 * with a part of the curvature of the obstacles, then the forces after it, for the step work->x. */
void hawser__touch_linear(struct hawser__net_work *work, double curved);
void hawser__touch_after(struct hawser__net_work *work);
/* 1 if r and gaps, friction and slips agree. *gap: largest penetration or gap of what touches, m. */
int hawser__touch_settled(double *gap, const struct hawser__net_work *work);

/* history.c: statics along the way of the supports, with friction. */
enum hawser_status hawser__net_history(struct hawser__mesh *mesh, double *T,
                                       struct hawser__equilibrium *found, const struct hawser_net *net,
                                       const struct hawser__mesh_options *options,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* The equilibrium as hawser statics has it: at mesh->q, with the tensions T [elements]. */
enum hawser_status hawser__net_equilibrium(struct hawser__mesh *mesh, double *T,
                                           const struct hawser_net *net,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
/* touched.c: fail where the net passes a circle on the other side than the scene says, or cuts a
 * segment. */
enum hawser_status hawser__touch_sides(const struct hawser__mesh *mesh, const struct hawser_net *net,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* Fail without an equilibrium: mesh->q gets the state nearest to balance, which the message tells
 * about; found its residual. */
enum hawser_status hawser__touch_lost(struct hawser__equilibrium *found, struct hawser__net_work *work,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Fail for a touch at the place x, beyond the points of its bed; t: s, or NaN. */
enum hawser_status hawser__touch_beyond(const struct hawser__mesh *mesh,
                                        const struct hawser__touch *touch, const double x[3], double t,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same of a node or, NULL, of a cable. */
enum hawser_status hawser__net_beyond(const struct hawser_net *net, const struct hawser_net_node *node,
                                      const char *cable, const struct hawser_surface *bed,
                                      const double x[3], double t,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Fail for an element that passes through what rises of a bed with heights between its nodes, which are
 * at q; t: s, or NaN. */
enum hawser_status hawser__touch_passes(const struct hawser__mesh *mesh, const double (*q)[3],
                                        double t, struct hawser_report *report) HAWSER_MUST_CHECK;
/* Coefficient of friction, 0 of a circle that turns freely: it takes no moment. */
double hawser__touch_friction(const struct hawser__touch *touch);
/* 1 if friction holds the node where it is; of a node that touches. */
int hawser__touch_sticks(const struct hawser__touch *touch);

/* touch-hold.c: leave to the nodes that touch only the directions along the obstacles, or none
 * where they stick (mesh->frame), for modes about this state: HAWSER_NET_MODES_STATICS: as the
 * statics has it. state [nodes] gets one of enum hawser_net_contact_state. */
enum hawser_status hawser__touch_hold(unsigned char *state, struct hawser__mesh *mesh,
                                      const struct hawser_net *net, enum hawser_net_contact_modes how,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Number of touches without gap and without force, as far as round-off tells; *node: the first.
 * They are open from then on. */
int hawser__touch_doubtful(int *node, struct hawser__mesh *mesh, const double *T);
/* The contacts of a result: list [*count], of a net with so many nodes, with room for one more each. */
enum hawser_status hawser__touch_list(struct hawser_net_contact **list, int *count,
                                      const struct hawser__mesh *mesh, int nodes,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
