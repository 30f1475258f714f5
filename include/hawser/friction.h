/* hawser/friction.h - contact with Coulomb friction in one time step.
 *
 * Given nodes with velocities u [nodes][3], a symmetric positive definite matrix M of 3x3 blocks, a
 * right side p and contacts, find velocities and impulses r with
 *   M u = p + sum over contacts of H^T r,   H u = components of u in the contact's frame (n, t1, t2),
 *   w = H (u - surface), w_N shifted by the contact's `gap_rate` or by restitution,
 *   0 <= w_N, r_N;  w_N r_N = 0;  |r_T| <= mu r_N;  r_T = -mu r_N w_T/|w_T| where w_T is not 0.
 * This is the complementarity of De Saxce: K* contains w + mu |w_T| n, orthogonal to r in Coulomb's
 * cone K. What M is, is the caller's affair: M + h theta C + h^2 theta^2 K of a time step, with
 * impulses r in N s; or a stiffness, with displacements u and forces r.
 *
 * Links are the pairs of nodes whose block of M is not zero. Where the links form chains, a solution
 * costs time in proportion to the number of nodes; else SuiteSparse KLU factors the matrix, and a node
 * may have one contact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_FRICTION_H
#define HAWSER_FRICTION_H

#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Open: r = 0. Stick: w = 0. Slip: w_N = 0 and |r_T| = mu r_N (so everywhere without friction). */
enum hawser_contact_state {HAWSER_CONTACT_OPEN, HAWSER_CONTACT_STICK, HAWSER_CONTACT_SLIP};
const char *hawser_contact_state_name(enum hawser_contact_state state); /* "open", "stick", "slip" */

/* A node at an obstacle. A node may have several contacts, at most HAWSER_CONTACTS_AT_NODE. */
struct hawser_contact {
	int node;
	double normal[3];     /* unit vector out of the obstacle */
	double tangent[2][3]; /* unit vectors, orthogonal to the normal and to each other */
	double friction;      /* mu, Coulomb's coefficient; 0 or more */
	double restitution;   /* Newton's coefficient e, 0 to 1 */
	double gap_rate;      /* m/s: gap over the length of the step. w_N = u_N + gap_rate, which leaves no
	                       * overlap at the end of the step; 0 for the law in velocities */
	double before;        /* m/s: relative normal velocity before the step. Where it is negative and
	                       * brings the node to the obstacle in the step (before + gap_rate <= 0), and
	                       * e > 0: w_N = u_N + e*before */
	double surface[3];    /* m/s, velocity of the obstacle's surface */
};
enum {HAWSER_CONTACTS_AT_NODE = 4};

/* Fill normal and tangents from a vector of any length: t2 is along z where the normal is in the
 * plane of x and y, and t1 = n x t2 reversed, so that t1 is along x above a floor. Returns 0, and
 * changes nothing, where the vector is zero or not finite. */
int hawser_contact_frame(struct hawser_contact *contact, const double normal[3]);

/* What is at a contact. With the option `warm`, also where the iteration starts. */
struct hawser_contact_reply {
	enum hawser_contact_state state;
	double impulse[3];  /* N, T1, T2; on the node. In the unit of M u: N s */
	double velocity[3]; /* m/s: w in the same frame, without gap_rate and restitution: that of the node
	                     * relative to the surface */
};

/* The matrix, right side and contacts of a step. Blocks are row-major. */
struct hawser_friction_problem {
	const double (*diagonal)[9]; /* [nodes] */
	const double (*off)[9];      /* [links] rows of link[0], columns of link[1] */
	const double (*back)[9];     /* [links] rows of link[1], columns of link[0]; NULL: the transposes of
	                              * off, M is symmetric. Else M is the tangent of a scheme of which the
	                              * caller knows that its steps have one solution */
	const double (*right)[3];    /* [nodes] p; at a held direction the velocity itself */
	const unsigned char *held;   /* [nodes] bit k: direction k is held; NULL: none */
	const struct hawser_contact *contact; /* [contacts] */
	int contacts;
};

struct hawser_friction_options {
	double tolerance;    /* of the complementarity, relative (see residual); 0: 1e-10 */
	int most;            /* iterations; 0: 400 */
	int warm;            /* 1: start from what the replies hold, as of the step before */
};
void hawser_friction_options_settle(struct hawser_friction_options *options);

struct hawser_friction_counts {
	int iterations;   /* of Newton's method */
	int open, stick, slip;
	double residual;  /* of the laws: largest |r - P(r - rho w)| of a contact over the largest |r| or
	                   * rho |w|, rho = 1/(n.M^-1 n), or n.M n of the block of the node where
	                   * the start `warm` of an M with `back` leads to the solution.
	                   * P(z): p = max(z_N, 0), and z_T cut to the length mu p. r = P(r - rho w)
	                   * where the laws hold, and only there */
	double balance;   /* largest |M u - p - H^T r| over the largest of its terms */
	double power;     /* sum of -r_T.w_T, the work of friction: 0 or more, J */
};

/* Work space for a mesh; a solution on chains allocates nothing. */
struct hawser_friction;
/* HAWSER_ERR_ARGUMENT: a link outside the nodes, or counts that are
 * negative; HAWSER_ERR_MEMORY. */
enum hawser_status hawser_friction_open(struct hawser_friction **solver, int nodes,
                                        const int (*link)[2] /* [links] */, int links,
                                        int most_contacts,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_friction_clear(struct hawser_friction *solver);

/* Solve. u [nodes][3] and reply [contacts] are results; with options->warm the replies are read too. An
 * answer is returned only where residual and balance are within the tolerance (or what round-off of M u
 * permits).
 * HAWSER_ERR_ARGUMENT: an impossible contact or option; HAWSER_ERR_NAN: not a number, which is
 * named; HAWSER_ERR_NO_SOLUTION: M is not positive definite, or contacts of a node contradict each
 * other; HAWSER_ERR_CONVERGENCE: not solved, with the residual. */
enum hawser_status hawser_friction_solve(struct hawser_friction *solver, double (*u)[3],
                                         struct hawser_contact_reply *reply,
                                         struct hawser_friction_counts *counts,
                                         const struct hawser_friction_problem *problem,
                                         const struct hawser_friction_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
