/* hawser/net_plan.h - a study of a net before it is run: what its model contains and what it leaves
 * out, the error of the mesh, and the time and memory of statics, modes and motion.
 *
 * The statics are solved, unless that takes far longer than a plan may; the modes too, if they take
 * little; of the motion the beginning is computed. Times are processor times of this machine.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_PLAN_H
#define HAWSER_NET_PLAN_H

#include <hawser/net.h>
#include <hawser/net_motion.h>

#ifdef __cplusplus
extern "C" {
#endif

/* An effect, whether it is modelled, and the reason; a warning is one that the user should look at. */
struct hawser_net_decision {
	const char *subject; /* "bending, torsion"; static string */
	int modelled;
	char why[240];
};

enum { HAWSER_NET_WARNING = 320 };

/* A cable as its mesh has it. NAN where something is not known. */
struct hawser_net_plan_cable {
	int elements, slack;      /* slack: elements without tension in the equilibrium */
	double length0, sag;      /* m; sag: largest vertical distance from the chord */
	double reach;             /* m, what errors are compared with: the sag, or a tenth of the largest */
	double T_min, T_max;      /* N */
	double strain;            /* largest */
	double error;             /* m, of positions, against exact catenaries */
	double tension_error;     /* of tensions at nodes, over T_max */
	int wanted;               /* elements for an error of 1e-3 of the reach; 0: not known */
};

enum hawser_net_basis {
	HAWSER_NET_BASIS_NONE = 0, /* it cannot be done, or nothing is to be done */
	HAWSER_NET_BASIS_RUN,      /* it was done, and its time measured */
	HAWSER_NET_BASIS_ESTIMATE  /* from the time of a part, or from counts of operations */
};
const char *hawser_net_basis_name(enum hawser_net_basis basis); /* "run", "estimate"; "" */

struct hawser_net_plan_job {
	const char *name;      /* "statics", "modes", "integrate" */
	const char *method;    /* that is taken */
	char why[200];         /* why this method, or why it cannot be done */
	int unknowns;
	double count;          /* iterations, or steps; NAN: not known */
	const char *counted;   /* what is counted: "iterations", "steps" */
	double seconds, least, most; /* processor time,
	and the range in which it should be; NAN: not known */
	double bytes;          /* of memory, about */
	enum hawser_net_basis basis;
};

struct hawser_net_plan_options {
	struct hawser_net_motion_options motion; /* of the motion; until 0: ten periods of the slowest
	                                          * load or, without loads, of the first mode */
	int modes;      /* 0: 6 */
	double seconds; /* for the modes,
	and for the beginning of the motion; the statics may take ten times
	                 * as long; 0: 0.2 */
};

enum { HAWSER_NET_JOBS = 3 };
struct hawser_net_plan {
	int nodes, supports, cables, elements, mesh_nodes, unknowns, joint_unknowns; /* joint_unknowns: of
	                                            * the exact catenaries */
	int decisions, warnings;
	struct hawser_net_decision *decision; /* [decisions] */
	char (*warning)[HAWSER_NET_WARNING];  /* [warnings] */
	struct hawser_net_plan_cable *cable;  /* [cables] */
	struct hawser_net_plan_job job[HAWSER_NET_JOBS];
	double until, every;      /* s, of the motion */
	double step;              /* s, mean; NAN: not known */
	double first, axial;      /* rad/s: lowest mode; fastest axial vibration of the mesh */
	double slowest, fastest;  /* rad/s, of loads and moving supports; 0: none */
	double resolved;          /* elements in a wavelength of `fastest`, of the coarsest cable */
	double seconds;           /* that the plan took */
};
/* A net without equilibrium has a plan that says so: HAWSER_OK. HAWSER_ERR_ARGUMENT (options). */
enum hawser_status hawser_net_plan_make(struct hawser_net_plan *plan, const struct hawser_net *net,
                                        const struct hawser_net_plan_options *options /* or NULL */,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_net_plan_clear(struct hawser_net_plan *plan);

#ifdef __cplusplus
}
#endif
#endif
