/* net/body.h - rigid bodies: nodes of a mesh that move together.
 *
 * A body holds its nodes, so that all else sees supports. What is left is the place of the body, by
 * at most six motions: three displacements and three turns, of which a hinge leaves the turns and an
 * axis one of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_BODY_H
#define HAWSER_NET_BODY_H

#include "net/net.h"

/* Points of its mass, with its moments of inertia: two on each axis. */
enum { HAWSER__BODY_POINTS = 6, HAWSER__BODY_MOTIONS = 6 };

/* The points, from this node on. */
void hawser__bodies_open(struct hawser__mesh *mesh, const struct hawser_net *net, int first);
/* The motions that supports leave to a body, as columns of `motion` (displacement, turn), about a
 * place; returns their number. Of nodes in `free` [nodes of the net] (or NULL) the support is gone. */
int hawser__body_motions(double motion[6][6], double about[3], const struct hawser_net *net,
                         const struct hawser_net_body *body, const unsigned char *free);
/* The motions of bodies as unknowns of a mesh in equilibrium; not that of a straight one about itself,
 * which nothing shows. */
enum hawser_status hawser__bodies_release(struct hawser__mesh *mesh, const struct hawser_net *net,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
/* What the motions z [motions] of the body of a rigid node displace there; and to z, the force v
 * there. */
void hawser__body_place(double x[3], const double *z, const struct hawser__mesh *mesh, int node);
void hawser__body_push(double *z, const struct hawser__mesh *mesh, int node, const double v[3]);
/* touch/touch-body.c: list the nodes of bodies among the touches too, without the hinges that are not
 * in loose [nodes of the net] (or NULL); _land: with the forces of the planes at mesh->q. */
enum hawser_status hawser__bodies_stand(struct hawser__mesh *mesh, const struct hawser_net *net,
                                        const unsigned char *loose,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__bodies_land(struct hawser__mesh *mesh, const struct hawser_net *net,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* Fail if a node of a body, at x [nodes of the net] or, NULL, where the net has it, is inside an
 * obstacle that is rigid, or on which it has no area, or in a bed beyond its points. t: s of a motion;
 * else NAN. */
enum hawser_status hawser__bodies_outside(const struct hawser_net *net, const double (*x)[3], double t,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
/* Fail if there are bodies, which `what` does not know. */
enum hawser_status hawser__bodies_none(const struct hawser_net *net, const char *what,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* statics/stiffness.c: of the bodies in the equilibrium of the lines at mesh->q with the tensions T:
 * force [6 bodies] of the outside that holds each about its place about [bodies], and its derivatives
 * K [6 bodies][6 bodies] by their motions. scale [bodies]: N, sum of the forces of its nodes. */
enum hawser_status hawser__bodies_tangent(double *K, double *force, double *scale,
                                          struct hawser__mesh *mesh, double *T,
                                          const struct hawser_net *net, const double (*about)[3],
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
/* statics/seat.c: the net with its bodies in their equilibrium, the largest force that is not
 * balanced, N, in *rest; moves 1: with lines that leave planes between nodes, as in motions. To be
 * released by hawser__bodies_unseat, also after a failure. */
enum hawser_status hawser__bodies_seat(struct hawser_net *seated, double *rest,
                                       const struct hawser_net *net, int moves,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__bodies_unseat(struct hawser_net *seated, const struct hawser_net *net);
/* Largest distance along an axis of a node of the net from its first, m; 1 if they are at one place. */
double hawser__net_extent(const struct hawser_net *net);

#endif
