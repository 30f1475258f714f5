/* The driven belt of net-belt-driven.yaml: the ledger closes from the start on; in the steady state
 * (with HAWSER_LONG) creep, tensions and the arc of slip are those of the belt's theory. An argument is
 * the time of the run, 20 for 10^5 steps.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <hawser/net_motion.h>

#include "tests/tap.h"

static const double pi = 3.14159265358979323846;
static const double EA = 30400.0, rho = 0.096, mu = 0.5, speed[2] = {1.2, 1.189};

/* Angle over which the belt slips on a wheel, of nodes that slide each for its share of the arc. */
static double slip_arc(const struct hawser_net_motion *motion, int wheel)
{
	int all = 0, slide = 0;

	for (int i = 0; i < motion->contacts; i++) {
		const struct hawser_net_contact *one = &motion->contact[i];

		all += one->surface == wheel;
		slide += one->surface == wheel && !one->sticks;
	}
	return all ? pi*slide/all : 0.0;
}

/* A piece of belt has the mass flow rho*v/(1 + T/EA): the driver has the speed of the tight part, the
 * other wheel that of the slack one; to 1 %, as nodes come onto the wheels one by one, so that tensions
 * ripple. T_1/T_2 = exp(mu*arc), with T - rho v^2 for T (0.14 N of 217). */
static void steady(const struct hawser_net_motion *motion)
{
	const double *T = &motion->T[2*(size_t)(motion->rows - 1)];
	const double tight = fmax(T[0], T[1]), slack = fmin(T[0], T[1]), flow = rho*speed[1]*speed[1];
	const double arc = log((tight - flow)/(slack - flow))/mu;

	close_to((tight - slack)/(EA + slack), speed[0]/speed[1] - 1.0, 1e-2, "creep");
	ok(fabs(slip_arc(motion, 0) - arc) < 0.12, "arc of slip on the driver %.3f rad, %.3f by the "
	   "tensions (a node has 0.1 rad)", slip_arc(motion, 0), arc);
	ok(slip_arc(motion, 1) < arc + 0.12 && slip_arc(motion, 1) > 0.5*arc, "on the other %.3f rad",
	   slip_arc(motion, 1));
}

static void driven(double until)
{
	const struct hawser_net_probe at[] = {{.node = -1, .cable = 0, .part = 0.5},
	                                      {.node = -1, .cable = 3, .part = 0.5}};
	const struct hawser_net_motion_options options = {.until = until, .every = until/10.0, .probe = at,
	                                                  .probes = 2};
	struct hawser_net net;
	struct hawser_net_motion motion = {0};
	struct hawser_report report;
	const char *path = source_file("notebooks-data/scenes/net-belt-driven.yaml");
	enum hawser_status status;

	status = hawser_net_open(&net, path, NULL, 0, &report);
	if (!status)
		status = hawser_net_integrate(&motion, &net, &options, &report);
	if (ok(!status, "the belt runs for %g s: %s", until, status ? report.message : "good")) {
		int last = motion.rows - 1;

		ok(motion.closure <= 1e-8, "the ledger closes to %.1e", motion.closure);
		ok(motion.apart[last] <= 1e-9 && motion.laws <= 1e-9, "gaps to %.1e m, laws to %.1e",
		   motion.apart[last], motion.laws);
		ok(motion.friction[last] > 0.0 && motion.dissipated[last] >= motion.friction[last],
		   "friction takes %.3g J", motion.friction[last]);
		if (until > 1.0)
			steady(&motion);
	}
	hawser_net_motion_clear(&motion);
	hawser_net_clear(&net);
}

CASE(reference_net_belt)
{
	driven(getenv("HAWSER_LONG") ? 1.6 : 0.01);
	return done_testing();
}
