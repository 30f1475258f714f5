/* hawser/net_motion.h - motion of a net: time integration through slack and taut.
 *
 * It begins at the equilibrium, at rest, with moving supports where they are at t = 0; supports that
 * the scene's `dynamics.release` names let go then. It can also begin at the state that another run
 * has written, and then goes on bit by bit as that run would have.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_MOTION_H
#define HAWSER_NET_MOTION_H

#include <hawser/net.h>
#include <hawser/progress.h>
#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A scheme of time integration. */
struct hawser_net_scheme {
	const char *name, *summary, *source;
	int order; /* 0: chosen by the scheme from step to step */
};
const struct hawser_net_scheme *hawser_net_scheme(int index); /* NULL beyond the last */

/* A place whose motion is kept: a node, or the point of a cable at a part of its unstretched length
 * from its end `from`, 0 to 1 (linear between the nodes of the mesh). */
struct hawser_net_probe {
	int node, cable; /* one of them; the other is -1 */
	double part;
};

/* The whole net at one time; valid during the call only. */
struct hawser_net_frame {
	double t;
	int row, nodes, elements;
	const double (*x)[3]; /* [nodes] of the mesh: those of the scene, then inner nodes cable by cable */
	const int (*end)[2];  /* [elements] nodes of each element */
	const double *T;      /* [elements] N */
	/* With obstacles; NULL without. Of a node at several, the one with the largest force. */
	const unsigned char *state; /* [nodes] enum hawser_contact_state: 0 open, 1 sticks, 2 slips */
	const double *r_N, *r_T; /* [nodes] N: force of the obstacle along its normal, its surface */
};

struct hawser_net_motion_options {
	double until;        /* s, end */
	double every;        /* s, between rows; 0: until/200 */
	double step;         /* s, at most; 0: the scene's; negative, or 0 in both: by the local error */
	double tolerance;    /* of the local error of a position in a step, over the unstretched length of
	                      * the longest cable; 0: 1e-7 */
	const char *scheme;  /* row of hawser_net_scheme; NULL: the scene's, or the first */
	double rho_inf;      /* of the scheme alpha; 0: the scene's, or 0.9; HAWSER_NONE: 0 */
	const char *initial; /* file of a state; NULL: the scene's, or the equilibrium */
	const struct hawser_net_probe *probe; /* [probes] */
	int probes;
	int check;           /* 1: the motion again with steps twice as long, for its error */
	/* Called for each row; not 0 ends the run. May be NULL. */
	int (*frame)(void *data, const struct hawser_net_frame *frame);
	void *data;
	struct hawser_progress progress;
};

/* What failures and winches of the scene have come to. */
struct hawser_net_parted {
	int cable;
	double time, tension; /* s, N: when it parted, and its tension then; NAN: it did not */
};
struct hawser_net_wound {
	int cable;
	double length0;       /* m, at the end */
};

struct hawser_net_motion {
	int rows, probes, interrupted;
	double *time;        /* [rows] s */
	double (*x)[3];      /* [rows*probes] m, row by row */
	double (*v)[3];      /* [rows*probes] m/s */
	double *T;           /* [rows*probes] N: largest tension of the elements there */
	double (*pull)[3];   /* [rows*probes] N: of the cables on a node that a support holds; else 0 */
	/* J; since the beginning, the potential energy (of strain, weight and constant loads) too: it is
	 * counted from the equilibrium. work: of harmonic loads, moving supports and surfaces, winches and
	 * water.
	 * dissipated: by damping, and by friction and impacts at obstacles. */
	double *kinetic, *potential, *work, *dissipated; /* [rows] */
	int *slack;          /* [rows] number of elements without tension */
	/* With obstacles: */
	int *touching, *sliding; /* [rows] number of contacts; of these, those that slip */
	double *friction, *impacts; /* [rows] J: parts of dissipated */
	double *apart;       /* [rows] m: largest penetration, or gap of what touches, since the last row */
	double laws;         /* largest relative residual of the laws of contact and friction of a step */
	struct hawser_net_contact *contact; /* [contacts] of the last state, with the mean forces of its
	                      * step: nodes of the net, then along cables */
	int contacts;
	struct hawser_net_parted *failure; /* [failures] */
	struct hawser_net_wound *winch;    /* [winches] */
	int failures, winches;
	/* Over all steps: the least tension and its time, and the first element without tension: time (s;
	 * NAN: there is none), its cable, and the part of its unstretched length at its middle. */
	double least, least_at, slack_at, slack_part; /* N, s, s, 0 to 1 */
	int slack_cable;
	double closure;      /* largest error of kinetic + potential - work + dissipated, over the largest
	                      * of these; what a scheme damps is an error here */
	/* m, estimated error of positions: the sum of the local errors of all steps, which takes it that
	 * errors do not grow; or, with the option check, that of the probes, from another run. */
	double error;
	int checked;         /* 1: from another run */
	/* Of a net that lets go of supports without damping.axial, and becomes slack. A front behind which
	 * the cable is slack loses energy, which a mesh without damping keeps as vibration of its elements,
	 * however fine it is. So the motion has the damping `front_axial` (s), half the time in which a
	 * wave passes an element, unless the scene has damping.axial: 0 s. shock: m, how far the probes
	 * are from where they are with `shock_axial` (s), that time; NAN: not computed. */
	double shock, shock_axial, front_axial;
	int unknowns;        /* of the positions */
	int still[3];        /* 1: nothing moves the net along this axis,
	so that the model has no motion there */
	double reached;      /* s: less than options.until if interrupted, perhaps after the last row */
	const char *scheme;
	long steps, iterations, splits, rejected, switches; /* switches: of elements, slack to taut and
	                                                     * back; splits: steps made in halves since
	                                                     * Newton's method failed */
	double *state;       /* [states] for hawser_net_state_write */
	void *held; /* memory of the arrays of rows */
	int states;
	int unbalanced;      /* 1: on beds that give way, where cables lie in part, no equilibrium was found
	                      * near that of statics, so that the motion begins out of balance */
};
enum hawser_status hawser_net_integrate(struct hawser_net_motion *motion,
                                        const struct hawser_net *net,
                                        const struct hawser_net_motion_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_net_motion_clear(struct hawser_net_motion *motion);
/* Write the last state to a file, from which another run can go on. */
enum hawser_status hawser_net_state_write(const struct hawser_net_motion *motion, const char *path,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
