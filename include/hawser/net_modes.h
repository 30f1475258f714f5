/* hawser/net_modes.h - natural modes of a net about its equilibrium.
 *
 * K*phi = omega^2*M*phi over the nodes of the mesh: K is the second derivative of the energy at the
 * equilibrium, M the mean of the consistent and the lumped mass matrix. Supports stand still.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_MODES_H
#define HAWSER_NET_MODES_H

#include <hawser/net.h>
#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_net_modes {
	int n, nodes, points; /* modes; nodes of the scene; points: those of the mesh on cables, as in
	                       * struct hawser_net_statics */
	double *omega;        /* [n] rad/s, ascending */
	double *mass;         /* [n] kg, of a shape whose largest displacement of a node is 1 */
	double (*share)[3];   /* [n] of the mass, that moves along x, y, z; the sum is 1 */
	double *residual;     /* [n] largest component of K*phi - omega^2*M*phi over that of K*phi */
	double (*shape)[3];   /* [n*nodes] */
	double (*point)[3];   /* [n*points] */
	int *cable;           /* [points] */
	double *S;            /* [points] m, unstretched length from the end `from` of the cable */
	int unknowns, iterations;
};
/* The first n modes; 0: 6, or all if there are fewer. HAWSER_ERR_NO_SOLUTION if elements
 * are slack: there is no stiffness there. */
enum hawser_status hawser_net_modes_solve(struct hawser_net_modes *modes, const struct hawser_net *net,
                                          int n, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_net_modes_clear(struct hawser_net_modes *modes);

#ifdef __cplusplus
}
#endif
#endif
