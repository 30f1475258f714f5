/* Nets that touch obstacles in time: order of convergence, 2 where nothing jumps and 1 through impacts;
 * the period of a bead in a pipe; many steps without drift (HAWSER_LONG).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net_motion.h>

#include "tests/tap.h"

static const double pi = 3.14159265358979323846;

/* The last row of a scene; 0 if it fails. */
static int last(struct hawser_net_motion *motion, const char *scene, const char *const *set,
                size_t sets, const struct hawser_net_motion_options *options)
{
	const struct hawser_net_probe at = {.node = 1, .cable = -1};
	struct hawser_net_motion_options with = *options;
	struct hawser_report report;
	struct hawser_net net;
	const char *path = source_file("notebooks-data/scenes/%s.yaml", scene);
	enum hawser_status status;

	with.probe = &at;
	with.probes = 1;
	with.every = with.every > 0.0 ? with.every : with.until;
	status = hawser_net_open(&net, path, set, sets, &report);
	if (!status)
		status = hawser_net_integrate(motion, &net, &with, &report);
	hawser_net_clear(&net);
	if (status)
		ok(0, "%s: %s", scene, report.message);
	return !status;
}

/* A bead in a pipe of radius R without friction is a pendulum: released at 60 degrees, it passes the
 * bottom after a quarter of 2*pi*sqrt(R/g)/agm(1, cos(30 degrees)), at the speed sqrt(g*R). */
static void bead(void)
{
	static const char *const set[] = {
		"nodes.B=[0.86602540378443864676 m, -0.5 m, 0]", "nodes.A=[0, 0, 0]", "contact.restitution=0",
		"obstacles=[{circle: {centre: [0, 0], radius: 1}, side: inside, friction: 0}]"};
	struct hawser_net_motion motion;
	struct hawser_net_motion_options options = {.step = 0.0};
	double a = 1.0, b = cos(pi/6.0), x[3];

	for (int i = 0; i < 6; i++) {
		double mean = 0.5*(a + b);

		b = sqrt(a*b);
		a = mean;
	}
	options.until = 0.5*pi*sqrt(1.0/9.81)/a;
	for (int i = 0; i < 3; i++) {
		options.step = options.until/(40 << i);
		if (!last(&motion, "net-impact", set, 4, &options))
			return;
		x[i] = fabs(motion.x[1][0]);
		close_to(hypot(motion.x[1][0], motion.x[1][1]), 1.0, 1e-13, "the bead is on the pipe");
		if (i == 2)
			close_to(motion.kinetic[1], 0.5*2.0*9.81, 2e-4, "energy at the bottom, J");
		hawser_net_motion_clear(&motion);
	}
	ok(x[2] < 1e-3 && fabs(log2(x[0]/x[1]) - 2.0) < 0.1 && fabs(log2(x[1]/x[2]) - 2.0) < 0.1,
	   "place after a quarter of a period to %.1e m, orders %.2f and %.2f", x[2], log2(x[0]/x[1]),
	   log2(x[1]/x[2]));
}

/* A mass on a slope in space, thrown across it by a surface that moves: it slides along a curve. */
static void curve(void)
{
	static const char slope[] = "obstacles=[{plane: {point: [0, 0, 0], normal: [-0.4, 1, 0]}, "
		"friction: 0.25, velocity: [0, 0, 1.3 m/s]}]";
	static const char *const set[] = {"nodes.B=[0, 0, 0]", "contact.restitution=0", slope};
	struct hawser_net_motion motion;
	struct hawser_net_motion_options options = {.until = 0.8};
	double x[4][3], difference[3];

	for (int i = 0; i < 4; i++) {
		options.step = 0.04/(1 << i);
		if (!last(&motion, "net-impact", set, 3, &options))
			return;
		memcpy(x[i], motion.x[1], sizeof x[i]);
		hawser_net_motion_clear(&motion);
	}
	for (int i = 0; i < 3; i++)
		difference[i] = hypot(x[i][0] - x[i + 1][0], x[i][2] - x[i + 1][2]);
	ok(fabs(x[3][0]) > 0.3 && fabs(x[3][2]) > 0.1 && log2(difference[1]/difference[2]) > 1.8,
	   "sliding along a curve: differences %.1e, %.1e, %.1e m, orders %.2f and %.2f", difference[0],
	   difference[1], difference[2], log2(difference[0]/difference[1]),
	   log2(difference[1]/difference[2]));
}

/* Heights after two bounces with e = 0.7: the error is some steps times the velocity, so that it falls
 * with the step, not monotonously. */
static void bounces(void)
{
	const double fall = sqrt(2.0/9.81), v = 9.81*fall*0.49, t = 1.3 - fall*(1.0 + 2.0*0.7);
	const double exact = v*t - 0.5*9.81*t*t;
	struct hawser_net_motion motion;
	struct hawser_net_motion_options options = {.until = 1.3};
	double most[2] = {0.0};

	for (int i = 0; i < 8; i++) {
		options.step = 1.3/(i < 4 ? 301 + 37*i : 16*(301 + 37*(i - 4)));
		if (!last(&motion, "net-impact", NULL, 0, &options))
			return;
		most[i/4] = fmax(most[i/4], fabs(motion.x[1][1] - exact));
		hawser_net_motion_clear(&motion);
	}
	ok(most[0] < 0.03 && most[1] < 0.14*most[0], "through impacts: errors %.1e m, %.1e m with steps a "
	   "16th, order %.2f", most[0], most[1], log2(most[0]/most[1])/4.0);
}

/* 1e5 steps of a chain on a floor that moves under it. */
static void steps(void)
{
	static const char *const set[] = {"cables.c.elements=24"};
	struct hawser_net_motion motion;
	const struct hawser_net_motion_options options = {.until = 100.0, .every = 10.0, .step = 1e-3};
	double apart = 0.0;

	if (!getenv("HAWSER_LONG") || !last(&motion, "net-drag", set, 1, &options))
		return;
	for (int i = 0; i < motion.rows; i++)
		apart = fmax(apart, motion.apart[i]);
	ok(motion.steps >= 100000 && apart < 1e-12 && motion.closure < 1e-9, "%ld steps: gaps to %.1e m, "
	   "ledger to %.1e", motion.steps, apart, motion.closure);
	hawser_net_motion_clear(&motion);
}

CASE(property_net_impact_order)
{
	bead();
	curve();
	bounces();
	steps();
	return done_testing();
}
