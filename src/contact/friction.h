/* contact/friction.h - the parts of the solver of one time step with contact and friction.
 *
 * u    velocities, [nodes][3]; M, p: matrix and right side of the problem
 * s    force of the obstacles on a node, M u - p
 * H    rows n, t1, t2 of a contact; r = H s impulse, w = H (u - surface) + shift of w_N
 * rho  scale of a contact, force over velocity
 * z    r - rho w, which the law of the contact projects
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CONTACT_FRICTION_H
#define HAWSER_CONTACT_FRICTION_H

#include <hawser/friction.h>

#include "core/hold.h"

/* A contact while it is solved. Matrices are row-major. Small, as each iteration passes over all. */
struct hawser__friction_touch {
	int node, next;      /* next: contact of the same node; -1: none */
	unsigned fixed;      /* bit k: tangent k (1, 2) is a held direction */
	double H[9];
	double mu, offset[3]; /* w = H u + offset */
	double rho;
	double r[3], w[3];   /* at u */
};

/* What only a second contact of a node has, whose impulse is an unknown. */
struct hawser__touch_second {
	double back[9], least[3]; /* dr = least - back*du of the next node of the chain */
	double dr[3];             /* of Newton's step */
	double kept[3];           /* r of a point to which the iteration may return */
};

/* The rows of the law in a step: residual G, derivatives by r and w, and by H^T r and u. */
struct hawser__touch_rows {
	double G[3], Cr[9], Cu[9], CrH[9], CuH[9];
};

/* Where the iteration is. */
struct hawser__friction_where {
	double sum;   /* of F^2 with smoothing */
	double error; /* largest |F| of a contact without */
	double scale; /* the largest force, |r| or rho |w|; 1 where there is none */
};

struct hawser__contact_chain;
struct hawser__contact_net;

struct hawser_friction {
	int nodes, links, most;
	int corners;                 /* 1: a node of the problem has several contacts */
	int (*link)[2];
	struct hawser__contact_chain *chain; /* NULL: a net */
	struct hawser__contact_net *net; /* NULL: chains */
	int *first;                  /* [nodes] first contact; -1: none */
	struct hawser__friction_touch *touch; /* [most] */
	struct hawser__touch_second *second; /* [most] */
	double (*from)[6];           /* [most] r and w at which the law of a first warm step is taken */
	double (*R)[3], (*du)[3];    /* [nodes] R = p - M u; at held directions p - u */
	double (*free)[3];           /* [nodes] u without contact */
	double (*kept)[3];           /* [nodes] u of a point to which the iteration may return */
	double norm;                 /* largest entry of the blocks of nodes */
	double (*inverse)[9];        /* [nodes] diagonal blocks of the inverse of M */
	const struct hawser_friction_problem *of; /* while it is solved */
	struct hawser__hold hold; /* its arrays */
};

/* friction-check.c: numbers, frames and held directions, which set touch->fixed; and then whether the
 * contacts of a node contradict each other. */
enum hawser_status hawser__friction_check(struct hawser_friction *solver,
                                          const struct hawser_friction_problem *problem,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__friction_room(const struct hawser_friction *solver, int node,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* friction-law.c: F at r and w; sigma >= 0 smooths the law. Returns |F|^2. */
double hawser__touch_law(double F[3], const struct hawser__friction_touch *touch, double sigma);
/* The rows of a step from the touch's r and w, where the law is taken there, or at `from` (r, w). */
void hawser__touch_linearise(struct hawser__touch_rows *rows,
                             const struct hawser__friction_touch *touch,
                             double sigma, const double *from /* [6], or NULL */);
enum hawser_contact_state hawser__touch_state(const struct hawser__friction_touch *touch);

/* The law of a Newton step. */
struct hawser__step_law {
	double sigma;
	int elsewhere; /* 1: the law is taken at the solver's `from` */
};
/* `from` of a contact, or NULL: */
const double *hawser__step_from(const struct hawser__step_law *law, const struct hawser_friction *of,
                                int contact);

/* friction-chain.c. *made is NULL where the links form no chains. */
enum hawser_status hawser__contact_chain_open(struct hawser__contact_chain **made, int nodes,
                                      const int (*link)[2] /* [links] */, int links,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__contact_chain_clear(struct hawser__contact_chain *chain);
/* du [nodes][3]: Newton's step, or without a law (NULL) M du = R. Returns 0 if the matrix is singular,
 * or M not positive definite. */
int hawser__contact_chain_solve(double (*du)[3], struct hawser_friction *of,
                                const struct hawser__step_law *law);
/* of->inverse, after a solution without the law. */
void hawser__contact_chain_inverse(struct hawser_friction *of);

/* friction-net.c: the same for any graph. The inverse is that of the blocks of nodes. */
enum hawser_status hawser__contact_net_open(struct hawser__contact_net **made, int nodes,
                                            const int (*link)[2] /* [links] */, int links,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__contact_net_clear(struct hawser__contact_net *net);
int hawser__contact_net_solve(double (*du)[3], struct hawser_friction *of,
                              const struct hawser__step_law *law);
void hawser__contact_net_inverse(struct hawser_friction *of);

/* friction-start.c: either of them; du goes to of->du. */
int hawser__friction_step(struct hawser_friction *of, const struct hawser__step_law *law);

/* friction-corner.c: rows of [next | y] of a node with several contacts, the first of them `first`, of
 * [S | y] and [U | y]. Returns 0 if they are singular. */
struct hawser__rows;
int hawser__corner(struct hawser__rows *factor, struct hawser_friction *of, int first,
                   const struct hawser__rows *S, const struct hawser__rows *U,
                   const struct hawser__step_law *law);

/* friction-state.c. R at u: */
void hawser__friction_defect(struct hawser_friction *of, const double (*u)[3] /* [nodes][3] */);
/* The largest component of M u - p - sum of H^T r, of the R at u, which it changes; size: the
 * largest of the terms p and D u. */
double hawser__friction_balance(double *size, struct hawser_friction *of,
                                const double (*u)[3] /* [nodes][3] */);
/* r and w of all contacts at u and R; the impulses of second contacts stay. */
void hawser__friction_follow(struct hawser_friction *of, const double (*u)[3] /* [nodes][3] */);
/* R, r and w at u, and what the laws say of them: */
struct hawser__friction_where hawser__friction_arrive(struct hawser_friction *of, double sigma,
                                                      const double (*u)[3] /* [nodes][3] */);
struct hawser__friction_where hawser__friction_look(const struct hawser_friction *of, double sigma);
/* A part of the step: */
void hawser__friction_move(struct hawser_friction *of, double (*u)[3] /* [nodes][3] */, double by);

/* friction-newton.c: from any u to u, r and w with contact by full steps, the first of them with
 * the laws at the solver's `from`; 0 if they do not arrive, and u as before. */
int hawser__friction_warm(struct hawser_friction *of, double (*u)[3] /* [nodes][3] */,
                          struct hawser_friction_counts *counts,
                          const struct hawser_friction_options *options);
/* From u, w and rho without contact (hawser__friction_free) to those with it. */
enum hawser_status hawser__friction_newton(struct hawser_friction *of,
                                           double (*u)[3] /* [nodes][3] */,
                                           struct hawser_friction_counts *counts,
                                           const struct hawser_friction_options *options,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

/* friction-start.c: no velocities, R, and rho of the blocks of nodes. */
void hawser__friction_still(struct hawser_friction *of, double (*u)[3] /* [nodes][3] */);
/* Velocities without contact, R, and rho of the inverse of M; 0 if M is not positive definite. */
int hawser__friction_free(struct hawser_friction *of, double (*u)[3] /* [nodes][3] */);
/* The round-off of forces at u. */
double hawser__friction_roundoff(const struct hawser_friction *of,
                                 const double (*u)[3] /* [nodes][3] */);

#endif
