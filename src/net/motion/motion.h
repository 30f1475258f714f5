/* net/motion/motion.h - time steps of a mesh.
 *
 * u      displacement of a node from the reference, [nodes][3]; the reference is the initial state
 * x      its increment in the step, the unknown
 * D, d   vector along an element in the reference, and now; l = |d|
 * p      l - length0; T = k*max(p, 0), k = EA/length0
 *
 * The stretch is p = p_ref + (2D + delta).delta/(l + l_ref), delta the difference of u over the
 * element: its round-off is that of u, not that of the positions. The internal force is counted
 * from the reference's, so that an equilibrium stays at rest exactly.
 *
 * The discrete gradient (Gonzalez): with d0, d1 at the ends of the step the force on an element's
 * end is sigma*(d0 + d1)/(l0 + l1), sigma = (W1 - W0)/(l1 - l0). Its work over the step is the
 * change of the strain energy W, whatever the step; it has no moment about any point, so that
 * both energy and angular momentum are kept while elements get slack and taut. Its tangent is
 * unsymmetric.
 *
 * Mass and viscous damping: mean of the consistent and the lumped matrix.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_STEPS_H
#define HAWSER_NET_STEPS_H

#include <lapacke.h>

#include <hawser/net_motion.h>

#include "net/body.h"
#include "net/net.h"

struct hawser__motion_element {
	int a, b;                 /* nodes */
	int rod;                  /* 1: of a rigid body, without tension: neither slack nor taut */
	double D[3], l_ref, p_ref, F_ref[3]; /* F_ref: force of the reference, N */
	double k, c, m, drag;     /* N/m; N s/m (Kelvin-Voigt); kg; kg/s */
	double creep, loss, rest; /* N/m, N s/m of what is in line with k: a spring and a dashpot; 0: none;
	                           * m, its stretch in the reference */
	const struct hawser_net_cable *law; /* with a table, or NULL */
	double offset, length;    /* of this: strain at p = 0; m, unstretched */
	double zero;              /* m: stretch at which the tension ends, 0 without a table */
	double lag, lag1;         /* m: its stretch beyond that, at both ends of the step; p is of k */
	double d[3], delta[3], l, p; /* at the beginning of the step */
	double l1, p1, T1;        /* at its end; T1 is the mean of the step if the scheme keeps energy */
	double d1[3], inverse, inverse1; /* at its end: vector; 1/(l + l1) and 1/l1, 0 for length 0 */
};

/* How a scheme makes a step of length h. With v, a at its beginning:
 *   0 = M*(m[0]*x + m[1]*v + m[2]*a) + C*(c[0]*x + c[1]*v + c[2]*a)
 *       + weight*(f_int - load)(end) + (1 - weight)*(f_int - load)(beginning),
 * or, if weight is negative, the discrete gradient and the load at the middle. At the end the
 * velocity is to_v[0]*x + to_v[1]*v + to_v[2]*a and the acceleration to_a likewise. */
struct hawser__motion_rule {
	double m[3], c[3], to_v[3], to_a[3], weight;
};

struct hawser__motion;
struct hawser__motion_scheme {
	struct hawser_net_scheme shown;
	void (*rule)(struct hawser__motion_rule *rule, double h, double rho_inf); /* NULL: see advance */
	/* A scheme with steps of its own, at most `longest` (0: any): to time `end`, with local errors
	 * of at most `tolerance` (m). NULL: steps by the rule. */
	enum hawser_status (*advance)(struct hawser__motion *motion, double end, double tolerance,
	                              double longest, struct hawser_report *report);
};
const struct hawser__motion_scheme *hawser__motion_scheme(int index); /* NULL beyond the last */

/* J; work and dissipated since the beginning. */
struct hawser__motion_energy {
	double kinetic, potential, work, dissipated;
};

/* Matrices over the nodes, sums for each element of [B, -B; -O, O] + [near, far; far, near]
 * (times the unit matrix), and of a multiple of it and a block at nodes. The rows of held
 * directions are those of the unit matrix. */
struct hawser__blocks_matrix {
	const double (*B)[9];     /* [elements] */
	const double (*other)[9]; /* [elements] O; NULL: B */
	const double (*mass)[2];  /* [elements] near, far */
	const double *point;      /* [nodes] */
	const double (*block)[9]; /* [nodes]; NULL: 0 */
};
struct hawser__blocks;
enum hawser_status hawser__blocks_open(struct hawser__blocks **blocks, const struct hawser__mesh *mesh,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__blocks_clear(struct hawser__blocks *blocks);
/* Solve for r [nodes][3], in place; *good is 0 if the matrix is singular. */
enum hawser_status hawser__blocks_solve(double (*r)[3], int *good, struct hawser__blocks *blocks,
                                        const struct hawser__blocks_matrix *matrix,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* Memory for the motion of a mesh: states, elements, factors; *chain as the next function. */
enum hawser_status hawser__blocks_bytes(double *bytes, int *chain, const struct hawser__mesh *mesh,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* 1 if this is the elimination along chains. */
int hawser__blocks_chain(const struct hawser__blocks *blocks);

/* The same by a sparse LU factorization (SuiteSparse KLU), for any graph. */
struct hawser__klu;
enum hawser_status hawser__klu_open(struct hawser__klu **klu, const struct hawser__mesh *mesh,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__klu_clear(struct hawser__klu *klu);
double hawser__klu_bytes(const struct hawser__klu *klu); /* with the factors to come, about */
/* Choose new pivots for the next matrix: the pivots of a matrix serve others that differ little. */
void hawser__klu_forget(struct hawser__klu *klu);
/* A matrix by its parts: blocks [B, -B; -B, B] with near and far masses of elements, and blocks at
 * the node that is end 0 or 1 of an element. _divide: factors, and x [unknowns] becomes the
 * solution; *good is 0 where the matrix is singular. */
void hawser__klu_zero(struct hawser__klu *klu);
void hawser__klu_element(struct hawser__klu *klu, int element, const double B[9], const double mass[2]);
/* Add a multiple of a block over both ends of an element. */
void hawser__klu_ends(struct hawser__klu *klu, int element, const double block[6][6], double factor);
void hawser__klu_node(struct hawser__klu *klu, int element, int end, const double block[3][3]);
enum hawser_status hawser__klu_divide(double *x, int *good, struct hawser__klu *klu,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same with the matrix re + i im of the same mesh; x [2 unknowns], real and imaginary parts in
 * turn. */
enum hawser_status hawser__klu_divide_complex(double *x, int *good, struct hawser__klu *re,
                                              const struct hawser__klu *im,
                                              struct hawser_report *report) HAWSER_MUST_CHECK;
/* Once more with that matrix. */
enum hawser_status hawser__klu_again_complex(double *x, struct hawser__klu *re,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__klu_solve(double (*r)[3], int *good, struct hawser__klu *klu,
                                     const struct hawser__blocks_matrix *matrix,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* Displacement and velocity of a support from a table of times, by a natural cubic spline. */
struct hawser__support_table {
	int node, rows;
	double *t;              /* [rows] s */
	double (*x)[3], (*curve)[3]; /* [rows] m; second derivatives, m/s2 */
	double from[3];         /* m: displacement of the reference */
};
enum hawser_status hawser__support_read(struct hawser__support_table *table, const char *path,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Those of all nodes of a net: table [*tables], which have to reach from 0 to until, s; *tables is 0
 * before. To be released by hawser__support_clear each, and by free. HAWSER_ERR_ARGUMENT. */
enum hawser_status hawser__supports_read(struct hawser__support_table **table, int *tables,
                                         const struct hawser_net *net, double until,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* Supports of q [nodes of the net or more] where they are at t = 0. */
void hawser__supports_begin(double (*q)[3], const struct hawser_net *net,
                            struct hawser__support_table *table /* [tables] */, int tables);
void hawser__support_at(double x[3], double v[3], const struct hawser__support_table *table, double t);
/* As at the ends of the table beyond it. */
void hawser__support_within(double x[3], double v[3], const struct hawser__support_table *table,
                            double t);
void hawser__support_acceleration(double a[3], const struct hawser__support_table *table, double t);
void hawser__support_clear(struct hawser__support_table *table);

/* plane.c: 1 if nothing moves the net along axis k, which all its supports hold at *place (m). */
int hawser__net_still(double *place, const struct hawser_net *net, int k,
                      const struct hawser__support_table *table /* [tables] */, int tables);
/* 1 if supports, loads and motions are in one vertical plane, whose unit normal is `normal`; 2 if
 * they are on a vertical line; 0 else, and where tables move supports. */
int hawser__net_plane(double normal[3], const struct hawser_net *net);

struct hawser__motion {
	struct hawser__mesh *mesh;
	const struct hawser__motion_scheme *scheme;
	double rho_inf;
	double far;                  /* of the mass of an element, what couples its ends: 1/12 is the
	                              * mean of the consistent (1/6) and the lumped matrix (0) */
	double t;
	int nodes, elements;
	struct hawser__motion_element *element; /* [elements] */
	double (*reference)[3];      /* [nodes] m */
	double (*base)[3];           /* [nodes] constant load minus internal force of the reference, N */
	double (*u)[3], (*v)[3], (*a)[3]; /* [nodes] the state */
	double (*u0)[3], (*v0)[3], (*a0)[3]; /* [nodes] kept, for a step that is taken again */
	double (*x)[3];              /* [nodes] increment */
	double (*acc)[3], (*vel)[3]; /* [nodes] what M and C multiply */
	double (*load)[3];           /* [nodes] constant part of the step's right side, N */
	double (*wave)[3];           /* [nodes] harmonic loads of the step, N */
	double (*r)[3];              /* [nodes] residual, then correction */
	double (*move)[3];           /* [nodes] m, the last correction */
	double (*past)[3], (*past2)[3]; /* [nodes] increments of the last two steps */
	double past_h, past2_h;      /* their lengths; 0: there was none */
	double (*B)[9], (*mass)[2], *point; /* the matrix */
	int attached;                /* 1: springs, dampers or absorbers; net/motion/motion-attached.c */
	double (*stroke)[2];         /* [absorbers] of the matrix: of the stroke; with its node */
	double (*springs)[9];        /* [nodes] `block`, if these alone need it; or NULL */
	struct hawser__bed *bed;     /* NULL: no planes that give way; net/motion/motion-bed.c */
	double (*other)[9], (*block)[9]; /* of it, or NULL; see struct hawser__blocks_matrix */
	struct hawser__motion_bodies *bodies; /* NULL: none; net/motion/motion-body.c */
	struct hawser__water_motion *water; /* NULL: none; net/water/water-motion.c */
	struct hawser__blocks *blocks;
	struct hawser__cvode *cvode; /* of that scheme, or NULL */
	struct hawser__motion_contact *contact; /* NULL: no obstacles; see net/motion/motion-contact.h */
	struct hawser__motion_events *events; /* NULL: none; see net/motion/motion-events.h */
	struct hawser__support_table *table; /* [tables] */
	int tables;
	double scale;                /* N, of the terms of the residual */
	double damps, reach;         /* N s/m, largest c of an element; m, largest displacement */
	struct hawser__motion_energy energy;
	double start_energy;         /* J */
	double added;                /* J, kinetic energy of the water that moves with the net */
	double most_energy;          /* J, largest of the ledger's terms */
	double least_energy;         /* J, below which it is round-off */
	double closure;              /* J, largest error of the ledger */
	double error;                /* m, local error of the last step that was tried */
	/* Asked after each step: not 0 ends hawser__motion_adapt and a scheme's own steps. May be NULL.
	 * */
	int (*stop)(void *data);
	void *data;
	int stopped;
	int singular;                /* of the last step: 1, its first equations had no solution */
	int undefined;               /* 1: its first residual is not a number */
	double drift;                /* m, sum of the local errors of all steps */
	double least, least_at;      /* N, s: least tension of an element so far */
	double slack_at;             /* s: when an element first had none; NAN: never */
	int slack_element;           /* that element */
	long steps, iterations, splits, rejected, switches; /* switches: slack to taut and back */
};

/* Begin at mesh->q, at rest, with the supports where they are at time t. `balanced` is 1 if this
 * is an equilibrium: what is not balanced is then round-off, except at nodes marked in loose
 * [nodes] (or NULL). */
enum hawser_status hawser__motion_open(struct hawser__motion *motion, struct hawser__mesh *mesh,
                                       const char *scheme, double rho_inf, int balanced,
                                       const unsigned char *loose, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void hawser__motion_clear(struct hawser__motion *motion);
/* motion-settle.c: an equilibrium of statics on planes that give way to that of motions: mesh->q and
 * the forces of the planes; *found is 0 where none was found. _seat: the net with its bodies in that
 * equilibrium, with the supports as they are at t = 0, as hawser__bodies_seat. */
enum hawser_status hawser__motion_settle(struct hawser__mesh *mesh, int *found,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__motion_seat(struct hawser_net *seated, const struct hawser_net *net,
                                       struct hawser__support_table *table, int tables,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* The state as numbers, bit by bit: what the next step needs, its length h too. _read allocates
 * *state. */
int hawser__motion_states(const struct hawser__motion *motion);
void hawser__motion_save(double *state /* [states] */, const struct hawser__motion *motion, double h);
void hawser__motion_restore(struct hawser__motion *motion, double *h,
                            const double *state /* [states] */);
/* 1 if a state moves along axis k. */
int hawser__motion_moves(const double *state /* [states] */, int nodes, int k);
const double *hawser__motion_place(const double *state /* [states] */, int node);
enum hawser_status hawser__motion_read(double **state /* [states] */, const char *path,
                                       const struct hawser__mesh *mesh, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* Tensions T [elements] of the state, with damping; returns the number of elements without. */
int hawser__motion_tensions(double *T, const struct hawser__motion *motion);
/* That of an element at the stretch p (m), without damping. */
double hawser__elastic_tension(const struct hawser__motion_element *el, double p);
/* With damping, of an element with the vector d (m) and the stretch p (m), and the velocities of the
 * state. */
double hawser__motion_tension(const struct hawser__motion *motion, int element, const double d[3],
                              double p);
/* After a change of u, v or t by the caller: energies and accelerations anew. */
enum hawser_status hawser__motion_begin(struct hawser__motion *motion, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* After the nodes of the mesh have changed: the next steps are as the first ones. */
enum hawser_status hawser__motion_restart(struct hawser__motion *motion, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* Note the least tension and the first slack element: d and p of an element at time t. */
void hawser__motion_watch(struct hawser__motion *motion, int element, const double d[3], double p,
                          double t);
/* One step of length h; it is split where Newton's method fails. */
enum hawser_status hawser__motion_step(struct hawser__motion *motion, double h,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* Whether the caller's `stop` ends the run. */
int hawser__motion_asked(struct hawser__motion *motion);
/* Steps to time `end`, their lengths from *h on chosen so that the local error of a position is
 * at most `tolerance` (m); *h is the next one. */
enum hawser_status hawser__motion_adapt(struct hawser__motion *motion, double *h, double end,
                                        double tolerance, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* Where a correction leaves less than this of the residual, the next one is made with its matrix: near
 * the solution of a step, it leaves nearly as little. */
#define HAWSER__KEEPS 0.01
/* motion-law.c: residual r of the step for motion->x; the matrix too if `tangent`. */
void hawser__motion_residual(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                             double h, int tangent);
/* motion.c: the increment of the step by Newton's method, from motion->x on; *done is 0 if it fails. */
enum hawser_status hawser__motion_solve(struct hawser__motion *motion, int *done,
                                        const struct hawser__motion_rule *rule, double h,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* motion-table.c: tension at the stretch p of an element with a table, and the mean of those from p0 to
 * p1, with its derivative by p1. */
double hawser__table_tension(const struct hawser__motion_element *el, double p);
double hawser__table_mean(double *slope, const struct hawser__motion_element *el, double p0, double p1);
/* An element of the unstretched length L0 of a rope that is stiffer when it is quick; T: its tension
 * in the reference. Nothing of another cable, or of NULL. */
void hawser__motion_in_line(struct hawser__motion_element *el, const struct hawser_net_cable *cable,
                            double L0, double T);
/* What does not change within the step: vectors of the elements, loads, motion of supports. */
void hawser__motion_prepare(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                            double h);
/* Kinetic and potential energy of the state. */
void hawser__motion_energies(struct hawser__motion *motion);
/* The error of the ledger: sets energies and closure. */
void hawser__motion_balance(struct hawser__motion *motion);
/* The ledger after a step from (u0, v0) to (u, v). */
void hawser__motion_account(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                            double h);
/* motion-result.c: room for rows. */
enum hawser_status hawser__motion_rows(struct hawser_net_motion *to, size_t rows, size_t probes,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* integrate.c: hawser_net_integrate without the error by another run; the default of its tolerance.
 * */
enum hawser_status hawser__net_integrate(struct hawser_net_motion *motion,
                                         const struct hawser_net *net,
                                         const struct hawser_net_motion_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
extern const double hawser__motion_tolerance;

/* motion-attached.c: springs, dampers and absorbers of nodes: whether there are any; their part of the
 * residual and of the matrix, which returns the largest force; strokes out of the right side, and
 * after it is solved their solution; of the energies, and the loss of a step, J. */
enum hawser_status hawser__attached_open(struct hawser__motion *motion, struct hawser_report *report)
	HAWSER_MUST_CHECK;
double hawser__attached_residual(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                                 int tangent);
void hawser__attached_eliminate(struct hawser__motion *motion, int solved);
void hawser__attached_energies(double *kinetic, double *potential, const struct hawser__motion *motion);
double hawser__attached_loss(const struct hawser__motion *motion, double h);
/* motion-body.c: rigid bodies. Memory, with the supports that have gone (loose [nodes]) and the axes
 * along which nothing moves; the increments of their nodes from those in motion->x; the larger of
 * `most` and what is not balanced, N; a correction, whose linear equations with the right side
 * -motion->r `solve` solves, with columns for a new matrix if `fresh`; to go a part of it; and the end
 * of the step. */
typedef enum hawser_status hawser__motion_solver(struct hawser__motion *motion, int *good,
                                                 struct hawser_report *report);
enum hawser_status hawser__bodies_start(struct hawser__motion *motion, const struct hawser_net *net,
                                        const unsigned char *loose, const int still[3],
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__bodies_close(struct hawser__motion_bodies *bodies);
void hawser__bodies_predict(struct hawser__motion *motion, double h);
double hawser__bodies_rest(struct hawser__motion *motion, double most);
enum hawser_status hawser__bodies_correct(struct hawser__motion *motion, int *good, int fresh,
                                          hawser__motion_solver *solve, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void hawser__bodies_move(struct hawser__motion *motion, double part);
void hawser__bodies_finish(struct hawser__motion *motion);
/* motion-bed.c: planes that give way: whether there are any, after motion-open.c has the elements;
 * after a cable has parted and the touches are listed anew, with a part of the area and the
 * friction of the node `from` at the node `to`; what does not change within a step; their part of
 * the residual and of the matrix, which returns the largest force; of the energy, J; and of the
 * ledger. */
enum hawser_status hawser__bed_open(struct hawser__motion *motion, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void hawser__bed_part(struct hawser__motion *motion, int from, int to);
void hawser__bed_clear(struct hawser__bed *bed);
void hawser__bed_prepare(struct hawser__motion *motion);
double hawser__bed_residual(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                            double h, int tangent);
double hawser__bed_energy(const struct hawser__motion *motion);
void hawser__bed_account(struct hawser__motion *motion, double h);
/* net/water/water-motion.c: in water. The flow of a step, for motion->x as expected; its part of the
 * residual and of the matrix, which returns the largest force; of the energies and the ledger; and
 * the loads of the mesh in the state with accelerations a [nodes], for tensions. */
enum hawser_status hawser__water_motion_open(struct hawser__motion *motion,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__water_motion_clear(struct hawser__water_motion *water);
/* After lengths or ends of elements have changed: the loads at rest at the reference, which mesh->force
 * has then. */
void hawser__water_still(struct hawser__motion *motion);
void hawser__water_prepare(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                           double h);
double hawser__water_residual(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                              int tangent);
double hawser__water_kinetic(struct hawser__motion *motion);
void hawser__water_account(struct hawser__motion *motion, double h);
void hawser__water_row(struct hawser__motion *motion, const double (*a)[3]);

/* motion-cvode.c */
struct hawser__cvode;
enum hawser_status hawser__cvode_advance(struct hawser__motion *motion, double end, double tolerance,
                                         double longest, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void hawser__cvode_clear(struct hawser__cvode *cvode);
/* motion-support.c: displacement and velocity of the held directions of all supports at time t. */
void hawser__motion_supports(double (*x)[3], double (*v)[3], const struct hawser__motion *motion,
                             double t);
/* The same for their accelerations; 0 for all other directions. */
void hawser__motion_support_accelerations(double (*a)[3], const struct hawser__motion *motion,
                                          double t);
/* Harmonic loads at time t, times `factor`, added to wave [nodes][3]. */
void hawser__motion_waves(double (*wave)[3], const struct hawser__mesh *mesh, double t, double factor);

/* --- motion-body.c: rigid bodies in a step --- */

struct hawser__motion_body {
	int motions, node;     /* its motions; its hinge, -1: none */
	int along;             /* its farthest node, if all are on a line with its place; else -1 */
	double motion[6][6];   /* columns: displacement, turn */
	double X[3], w[3];     /* m; of the step */
	double by[6];          /* the last correction: displacement, small turn */
	double reach;          /* m, the longest arm */
};

struct hawser__motion_bodies {
	struct hawser__motion_body *body; /* [bodies] */
	int bodies, motions;   /* motions: of all */
	double h;              /* s, of the step */
	double (*r0)[3], (*r1)[3]; /* [nodes] m: arms of nodes of bodies, at both ends of the step */
	double (*F)[3], (*answer)[3]; /* [nodes] N: the residual; work space */
	double (*column)[3];   /* [motions][nodes] answers of all nodes to the motions */
	double *S, *sum;       /* [motions][motions] column by column; [motions] */
	lapack_int *pivot;     /* [motions] */
	struct hawser__hold hold;
};

/* --- flow.c: how the water flows at the places of a motion: a current over the height and over
 * time, waves --- */

struct hawser__near;
struct hawser__water_flow {
	const struct hawser_water *of;
	struct hawser__near *near;           /* of a sea, else NULL */
	struct hawser__support_table series; /* of the current over time; rows 0: none */
	double t, later[3], rate[3];         /* s; m/s, m/s^2: of that current, beyond that of t = 0 */
};
/* At a place. */
struct hawser__water_there {
	double u[3], du[3]; /* m/s, m/s^2 */
	double surface;     /* m */
};

/* For so many places; to be released also after a failure. */
enum hawser_status hawser__water_flow_open(struct hawser__water_flow *flow,
                                           const struct hawser_water *of, int places,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__water_flow_clear(struct hawser__water_flow *flow);
/* The time of what is asked for next. */
void hawser__water_flow_time(struct hawser__water_flow *flow, double t);
/* At x [3] (m). place: one of a motion, which moves little, or -1: waves exactly, so that nothing
 * which comes later depends on this call. */
void hawser__water_flow_at(struct hawser__water_there *at, const struct hawser__water_flow *flow,
                           int place, const double x[3]);

#endif
