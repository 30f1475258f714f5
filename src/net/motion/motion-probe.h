/* net/motion/motion-probe.h - places, velocities and tensions at the probes of a motion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_MOTION_PROBE_H
#define HAWSER_NET_MOTION_PROBE_H

#include "net/motion/motion-ode.h"
#include "net/statics/tension.h"

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
