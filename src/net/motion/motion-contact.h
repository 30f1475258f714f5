/* net/motion/motion-contact.h - nodes that touch obstacles, in the time steps of a mesh.
 *
 * A step has two parts. The mean part is the step of the scheme (discrete gradient), with mean forces f
 * of the obstacles that keep the gaps g1 at its end at 0 or above:
 *   0 <= f_N, g1;  f_N*g1 = 0;  f_N acts along the discrete gradient n of the gap, n.x = g1 - g0;
 *   |f_T| <= mu*f_N against the slip s = x_T - h*v_s, at nodes that touched before the step.
 * The work of f_N is -f_N*g0 <= 0 and that of f_T, relative to the surface, f_T.s <= 0.
 * The end part sets the velocities v of the end, node by node, since the masses are lumped, with what
 * the obstacle gave in the whole step, R >= 0, |R_T| <= mu*R_N. With the normal velocity c by which the
 * node would have come to the obstacle without its force, m*c^2/2 = m*v_N^2/2 + f_N*g0:
 *   v_N = max(e*c, v_N - h*f_N/m).
 * Neither part adds energy: see doc/theory-contact.md.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_MOTION_CONTACT_H
#define HAWSER_NET_MOTION_CONTACT_H

#include <hawser/friction.h>
#include "core/hold.h"
#include "net/motion/motion.h"

/* A node and an obstacle, which it may touch; in the order of mesh->touch. */
struct hawser__motion_touch {
	int candidate;            /* place in the list of the step; -1: not in it */
	int closed;               /* 1: it touched at the end of the step before, without bouncing */
	double g0, g1;            /* m, gaps at both ends of the step */
	double loss;              /* J, minus the work of f_N */
	struct hawser_contact_reply reply; /* impulse: f, N; velocity: relative displacement, m */
	enum hawser_contact_state state;   /* at the end of the step */
	double N, T[3];           /* N: what the obstacle gave, R/h */
	/* of the step that is tried: */
	int closes;
	enum hawser_contact_state becomes;
	double given, rubbed[3];
};

struct hawser__motion_contact {
	int touches, candidates;
	double restitution;
	double reach;                        /* m, longest element: scale of round-off beside places */
	struct hawser__motion_touch *touch;  /* [touches] */
	struct hawser_contact *contact;      /* [touches] of the list */
	struct hawser_contact_reply *reply;  /* [touches] of the list */
	int *which;                          /* [touches] of the list: its touch */
	double (*diagonal)[9], (*off)[9], (*back)[9]; /* [nodes], [elements] */
	double (*right)[3], (*dx)[3];        /* [nodes] */
	double (*jump)[3];                   /* [nodes] m/s, of the end part */
	double *weight, *added;              /* [nodes] kg; of that the water that moves with them */
	unsigned char *held, *recent;        /* [nodes]; recent: steps since a change, counted down */
	struct hawser_friction *solver;
	struct hawser_report refusal;        /* why a step had no solution; status 0: not by contact */
	double friction, impacts, surfaces;  /* J: dissipated, and work, since the beginning */
	double rubs, bounces, drives;        /* the same of the step that is tried */
	double apart, laws;                  /* m: penetration, or gap of what touches; relative residual of
	                                      * the laws: largest since they were set to 0 */
	double laws_now, apart_now;          /* of the step that is tried */
	double jump_error;                   /* m: largest way of a step with the velocity of a jump */
	int beyond;                          /* 1 + a touch that has been beyond the points of its bed */
	struct hawser__hold hold; /* its arrays */
};

/* For a motion whose mesh has touches: sets motion->contact; lumps the masses where one is rigid. */
enum hawser_status hawser__contact_open(struct hawser__motion *motion, double restitution,
                                        struct hawser_report *report)
	HAWSER_MUST_CHECK;
void hawser__contact_clear(struct hawser__motion_contact *contact);
/* The gap of a place, and its gradient. Of a segment that of its line: in motion a node leaves the
 * segment at its ends, where statics has the distance from the end. */
double hawser__contact_gap(double n[3], const struct hawser_surface *surface, const double at[3]);
/* motion-normal.c: the discrete gradient n of the gap of a bed with heights, which changes by `change`
 * between two places, and unless NULL its derivative by the second one. */
void hawser__mean_normal(double n[3], double (*by)[3], const struct hawser_surface *surface,
                         const double from[3], const double to[3], double change);
/* 1 if the node of a touch is beyond the points of its bed. */
int hawser__contact_outside(const struct hawser__motion *motion, int touch);
/* Fail where a node touched a bed beyond its points. */
enum hawser_status hawser__contact_beyond(const struct hawser__motion *motion,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
/* Which nodes touch at the state of the motion. */
void hawser__contact_begin(struct hawser__motion *motion);
/* The mean part of a step, for motion->x; *done is 0 if it has none. */
enum hawser_status hawser__contact_solve(struct hawser__motion *motion, int *done,
                                         const struct hawser__motion_rule *rule, double h,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* motion-wedge.c: set the refusal where no step has a solution, since a surface that moves draws a node
 * between two obstacles. */
void hawser__contact_wedged(struct hawser__motion *motion);
/* The end part: jumps of the velocities, and energies. */
void hawser__contact_jump(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                          double h);
/* Take them: the velocities of the end are in motion->v. */
void hawser__contact_finish(struct hawser__motion *motion);
/* Contacts of the state: numbers to save. */
enum { HAWSER__TOUCH_NUMBERS = 8, HAWSER__CONTACT_NUMBERS = 3 };
void hawser__contact_save(double *to, const struct hawser__motion_contact *contact);
void hawser__contact_restore(struct hawser__motion *motion, const double *from);

/* motion-touched.c: what nodes of the mesh have at obstacles, for a row. */
struct hawser__net_touched {
	unsigned char *state; /* [nodes] */
	double *r_N, *r_T;    /* [nodes] N */
};
enum hawser_status hawser__contact_room(struct hawser__net_touched *touched, int nodes,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* Row number `row` of a result, and what it touches. */
void hawser__contact_row(struct hawser_net_motion *to, int row, struct hawser__net_touched *touched,
                         struct hawser__motion *motion);
/* The contacts of the last state. It changes those of the mesh, and its positions. */
enum hawser_status hawser__contact_result(struct hawser_net_motion *to, const struct hawser_net *net,
                                          struct hawser__motion *motion,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
