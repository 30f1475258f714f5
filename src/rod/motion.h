/* rod/motion.h - time steps of a mesh: generalised-alpha on places and rotations (motion.c).
 *
 * The state is mesh->node (place x, quaternion q) and, per node, six velocities: v in the axes of the
 * scene, and the spin (angular velocity) in those of the section. Forces and moments have the same
 * order: six a node, force in the axes of the scene, moment in those of the section. A turn is one in
 * the section's axes, R exp(turn).
 *
 * An end of the mesh that is held (mesh->held) may move as a `guide` says. Loads that are not in the
 * scene, such as drag, are a function with its derivatives. Rigid bodies are at nodes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROD_STEPS_H
#define HAWSER_ROD_STEPS_H

#include "core/hold.h"
#include "rod/mesh.h"

/* --- winch.c: a rod whose first segment lengthens at its start: length in time, mesh, inertia
 * ---
 *
 * The elements of the segment have constant shares of its length l(t), so that nodes move
 * through the material. Material is at the distance s from the start, s' = l'; a node at s = l
 * sigma, s' = l' sigma. The velocity of the material at a node is that of the node and (1 -
 * sigma) l' dx/ds. */

struct hawser__rod_motion;

struct hawser__rod_winch {
	const struct hawser_rod_winch *as; /* NULL: there is none, and nothing else is set */
	int elements;              /* of the first segment */
	double *part;              /* [elements] of the segment */
	double *left;              /* [elements+1] of the segment, beyond each of its nodes: 1 - sigma */
	double *curve;             /* [rows] of lengths: second derivatives; of speeds: length there */
	double from, first;        /* s, m: when the motion begins (0), and the length then */
	double length, speed, rate; /* l, l', l'' of the state: m, m/s, m/s2 */
	double (*slip)[6], (*slip0)[6]; /* [nodes] m/s: velocity of the material less that of the node;
	                            * N m: the spin that comes in, d(J)/dt w; 0: before the step */
	double power, store;       /* W, J: of the ledger, see motion_winch.c */
	double over;               /* m, paid out or in faster than waves run, so far without a break */
	struct hawser__hold hold;
};

/* Memory, and the length at the time `from`, that of the mesh; fails if the length is too short before
 * `until`. */
enum hawser_status hawser__rod_winch_open(struct hawser__rod_winch *winch,
                                          const struct hawser__rod_mesh *mesh, double from,
                                          double until, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* After a state is read, which had this length: fails if the winch has another one then. */
enum hawser_status hawser__rod_winch_same(const struct hawser__rod_motion *motion, double length,
                                          const char *path, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void hawser__rod_winch_clear(struct hawser__rod_winch *winch);
/* l, l', l'' at time t. */
void hawser__rod_winch_at(double l[3], const struct hawser__rod_winch *winch, double t);
/* Lengths of the elements, places s and masses of the nodes at time t. */
void hawser__rod_winch_set(struct hawser__rod_motion *motion, double t);
/* Add to the velocities those with which the state at t = 0 lengthens: of the rod at rest, or of its
 * equilibrium. 1: the latter is not determined. */
int hawser__rod_winch_begin(struct hawser__rod_motion *motion, int rest);

/* --- motion_winch.c --- */

/* slip, of the state. */
void hawser__rod_winch_slip(struct hawser__rod_motion *motion);
/* Subtract from mesh->r the inertia that the nodes' own masses leave out; and its derivatives. */
void hawser__rod_winch_form(struct hawser__rod_motion *motion, int tangent);
/* Kinetic energy that is not of the masses of the nodes with the mean velocity of their material. */
double hawser__rod_winch_kinetic(const struct hawser__rod_motion *motion);
/* power and store, of the state. */
void hawser__rod_winch_power(struct hawser__rod_motion *motion);
/* After a step: 1 if the rod has been paid out or in for too long faster than waves run. */
int hawser__rod_winch_watch(struct hawser__rod_motion *motion);
/* m/s: of the material through the middle of element e. */
double hawser__rod_winch_through(const struct hawser__rod_motion *motion, int e);

/* Where an end is, and how it moves there. What is not held is ignored. */
struct hawser__rod_guide {
	double x[3], v[3], a[3];       /* m, m/s, m/s^2, in the axes of the scene */
	double q[4], spin[3], rate[3]; /* axes; rad/s and rad/s^2, in the section's axes */
};

/* A rigid body in a node; its centre of mass is at `offset` in the section's axes. It has weight. */
struct hawser__rod_body {
	int node;
	double mass, offset[3], inertia[9]; /* kg; m; kg m^2 about the centre, in the section's axes */
};

struct hawser__rod_motion;
/* Loads at time t, of the state: calls hawser__rod_push, and hawser__rod_push_tangent if `tangent`.
 * Returns 0, or a number that ends the run and that hawser__rod_motion_step leaves in
 * motion->refused. */
typedef int hawser__rod_loading(void *data, struct hawser__rod_motion *motion, double t,
                                int tangent);

/* J; but for the first three since the beginning. */
struct hawser__rod_energy {
	double kinetic, strain, height;  /* height: of the weight, counted from y = 0 */
	double work;                     /* of the loads of the scene */
	double pushed;                   /* of the loads of the function */
	double support;                  /* of the ends that are held */
	double damped;                   /* taken by mass-proportional damping */
	double winch;                    /* of the winch, with that of the material that comes in */
};

struct hawser__rod_momentum {
	double linear[3], angular[3];    /* N s, N m s: of the motion, angular about the origin */
	double force[3], moment[3];      /* the same, of all loads and supports since the beginning */
};

struct hawser__rod_motion {
	/* set by the caller before hawser__rod_motion_begin */
	struct hawser__rod_mesh *mesh;
	double t;                        /* s */
	double rho_inf;                  /* 0 to 1 */
	double alpha;                    /* 1/s, mass-proportional damping of the rod */
	hawser__rod_loading *loading;    /* NULL: none but the scene's */
	void *data;
	void (*guide[2])(void *data, struct hawser__rod_guide *to, double t); /* of start and end; NULL:
	                                  * it stays where it is */
	void *guide_data[2];
	struct hawser__rod_body *body;   /* [bodies], at different nodes */
	int bodies;
	double (*velocity)[6];           /* [nodes] of the state */
	struct hawser__rod_winch winch;  /* opened by the caller, if the rod has one */

	/* the state */
	double (*rate)[6];               /* [nodes] derivatives of the velocities */
	double (*mean)[6];               /* [nodes] the scheme's `a` */
	double (*added)[9];              /* [nodes] kg: added mass of the loads of the function */
	double (*mass)[4], (*mass0)[4];  /* [nodes] kg, kg m^2 about e1, e2, e3, of the rod; 0: before
	                                  * the step */
	double *factor;                  /* [loads] of the scene's loads at this time */
	struct hawser__rod_energy energy;
	struct hawser__rod_momentum momentum;
	double start_energy, start[6];   /* J; N s, N m s at the beginning */
	double most_energy;              /* J, largest term of the ledger so far */
	double most_momentum, most_angular; /* N s, N m s */
	double energy_lost;              /* J: what the loads have done less what is there, so far: of the
	                                  * scheme */
	double momentum_gap, angular_gap; /* N s, N m s: largest so far */

	/* of a step */
	double h;                        /* s, of the last step */
	double (*step)[6];               /* [nodes] m, rad: moved and turned in this step */
	double (*past)[6], (*past2)[6];  /* [nodes] the same of the last two steps */
	double past_h, past2_h;          /* their lengths; 0: there was none */
	struct hawser__rod_node *node0;  /* [nodes] the state before the step */
	double (*velocity0)[6], (*rate0)[6], (*mean0)[6];
	double (*applied)[6], (*applied0)[6]; /* [nodes] loads of the scene, without weight */
	double (*pushed)[6], (*pushed0)[6];   /* of the function */
	double (*reaction)[6], (*reaction0)[6]; /* of what holds the ends */
	double (*Ji)[9];                 /* [nodes] Ji of the turn of the step */
	double to_velocity, to_rate;     /* derivatives of velocities and rates by the step's increments */
	double by_place;                 /* 1: derivatives by places are wanted; 0: they are not */
	double factor_h;                 /* s: step of the factors; 0: there are none */
	double (*factor_q)[4];           /* [nodes] axes of the state of the factors */
	double contraction;              /* of an increment to the next one, with these factors */
	double error;                    /* m, of this step: the local error */
	double drift;                    /* m, sum of the local errors */
	double increment;                /* last one of Newton's method, in lengths of the rod and rad */
	int bent;                        /* element that turned by pi or more in the last try; -1: none */
	int spun;                        /* node that turned by more than the limit in it; -1: none */
	int undefined;                   /* 1: something was not a number */
	int refused;                     /* of the function */
	long steps, iterations, factored, rejected, splits;
	struct hawser__hold hold;
};

/* Memory for the motion of the mesh, whose state is kept; then the caller sets what is above. */
enum hawser_status hawser__rod_motion_open(struct hawser__rod_motion *motion,
                                           struct hawser__rod_mesh *mesh,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__rod_motion_clear(struct hawser__rod_motion *motion);
/* After a change of the state, or of loads at once: rates anew. `first`: the ledgers begin. */
enum hawser_status hawser__rod_motion_begin(struct hawser__rod_motion *motion, int first,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;
/* One step of length h, in halves where Newton's method fails. */
enum hawser_status hawser__rod_motion_step(struct hawser__rod_motion *motion, double h,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
/* One step of at most *h whose local error is at most `tolerance` (m), and not beyond `end`; *h is the
 * next one. */
enum hawser_status hawser__rod_motion_adapt(struct hawser__rod_motion *motion, double *h, double end,
                                            double tolerance, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* --- for the function of loads --- */

/* Add force and moment, f [6], on a node. */
void hawser__rod_push(struct hawser__rod_motion *motion, int node, const double f[6]);
/* Its part -M a, which is in f, of the added mass M (kg) and the acceleration a of the node. */
void hawser__rod_push_mass(struct hawser__rod_motion *motion, int node, const double (*M)[3]);
/* Add the derivatives of the load of node i by place and turn (at [6][6]), and by velocity and spin
 * (by [6][6], or NULL), of node j; |i - j| <= 1. */
void hawser__rod_push_tangent(struct hawser__rod_motion *motion, int i, int j, const double at[36],
                              const double by[36]);

/* --- motion_form.c --- */

/* Loads, inertia and internal forces of the state: mesh->r is what is not balanced, and with
 * `tangent` the band its derivative, negative, by increments of the step. 0, or 1: an element turns
 * by pi or more, or the function refuses. */
int hawser__rod_motion_form(struct hawser__rod_motion *motion, double t, int tangent);
/* Rates from the forces of the state; 0, or 1 as above. */
int hawser__rod_motion_rates(struct hawser__rod_motion *motion, double t);
/* Ends that are held, at time t: places, velocities, rates. */
void hawser__rod_motion_hold(struct hawser__rod_motion *motion, double t);
/* Masses of the nodes, from the lengths of the elements. */
void hawser__rod_motion_masses(struct hawser__rod_motion *motion);
/* Length and factors of the scene's loads at time t, before (0) or after (1) a jump at that time. */
void hawser__rod_motion_factors(struct hawser__rod_motion *motion, double t, int after);

/* --- motion_newton.c --- */

enum { HAWSER__ROD_ITERATIONS = 12 }; /* of a step: those that converge take 2 to 5 */
#define HAWSER__ROD_SPUN 2.0 /* rad, of a node in a step: Ji is singular at 2 pi */

/* Of a step, see motion_newton.c; c: of the local error c h^3 x''''. */
struct hawser__rod_scheme {
	double am, af, g, b, c;
};
struct hawser__rod_scheme hawser__rod_scheme_of(double rho_inf);
/* First increments of a step. */
void hawser__rod_motion_predict(struct hawser__rod_motion *motion, double h);
/* The step from these: the state at its end; 1: it has converged. */
int hawser__rod_motion_newton(struct hawser__rod_motion *motion, const struct hawser__rod_scheme *s,
                              double h);

/* --- motion_ledger.c --- */

/* Energies and momenta of the state. */
void hawser__rod_motion_sum(struct hawser__rod_motion *motion);
/* After a step of length h. */
void hawser__rod_motion_account(struct hawser__rod_motion *motion, double h);

#endif
