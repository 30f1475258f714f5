/* net/motion/motion-ode.h - the motion of a mesh as differential equations, M*u'' = f(t, u, u'), for
 * integrators that make their own steps. They use the elements and supports of struct hawser__motion,
 * and nothing of its steps.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_ODE_H
#define HAWSER_NET_ODE_H

#include "net/motion/motion.h"
#include "net/statics/solve.h"

struct hawser__ode {
	struct hawser__motion *motion;
	struct hawser__sparse *mass;        /* M and its Cholesky factors */
	double (*u)[3], (*v)[3], (*a)[3], (*f)[3]; /* [nodes] */
	double *right;                      /* [unknowns] */
};

/* HAWSER_ERR_ARGUMENT, with its name, where a node that moves has no mass. */
enum hawser_status hawser__ode_massive(const struct hawser__mesh *mesh, const struct hawser_net *net,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* Fails where a node has no mass: M has no inverse then. */
enum hawser_status hawser__ode_open(struct hawser__ode *ode, struct hawser__motion *motion,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__ode_clear(struct hawser__ode *ode);
/* u'' of the unknowns, from u and v = u'. */
enum hawser_status hawser__ode_accelerate(double *a /* [unknowns] */, struct hawser__ode *ode, double t,
                                          const double *u /* [unknowns] */,
                                          const double *v /* [unknowns] */,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
/* Solve (I - gamma*J)*(x, y) = (x, y) in place, J the derivative of (v, u'') by (u, v); *good is 0 if
 * the matrix is singular. */
enum hawser_status hawser__ode_newton(double *x /* [unknowns] */, double *y /* [unknowns] */, int *good,
                                      struct hawser__ode *ode, double gamma, double t,
                                      const double *u /* [unknowns] */,
                                      const double *v /* [unknowns] */,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Rates of the ledger, W: that of harmonic loads and moving supports, and what damping takes. */
enum hawser_status hawser__ode_power(double *work, double *lost, struct hawser__ode *ode, double t,
                                     const double *u /* [unknowns] */,
                                     const double *v /* [unknowns] */,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
/* Spread unknowns over u and v [nodes][3]; supports where they are at t. */
void hawser__ode_spread(double (*to_u)[3], double (*to_v)[3], const struct hawser__ode *ode, double t,
                        const double *u /* [unknowns] */, const double *v /* [unknowns] */);

/* --- motion-probe.c: places, velocities and tensions at the probes of a motion --- */

struct hawser__probes {
	struct hawser__motion *motion;
	struct hawser__ode ode;      /* of the scheme cvode, for accelerations */
	double (*a)[3];              /* [nodes] m/s^2 */
	double (*obstacle)[3];       /* [nodes] N */
	double *state;               /* [3*unknowns] u, v and u'' */
	struct hawser__tensions tensions;
};
/* x [nodes], T [elements]: of the state, which the caller keeps. */
enum hawser_status hawser__probes_open(struct hawser__probes *probes, struct hawser__motion *motion,
                                       const struct hawser_net *net, const double (*x)[3],
                                       const double *T, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void hawser__probes_clear(struct hawser__probes *probes);
/* After a change of the state. */
enum hawser_status hawser__probes_state(struct hawser__probes *probes, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* pull: of the cables on a node that a support holds, N. */
void hawser__probe(double x[3], double v[3], double *T, double pull[3],
                   const struct hawser__probes *probes, const struct hawser_net_probe *at);

#endif
