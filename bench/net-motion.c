/* bench/net-motion - a time step of a mesh: processor time over the number of elements, of a single
 * cable (block elimination along it), of one whose end is let go, through slack and taut, and of a fan
 * of three (KLU), and of a cable that is dragged over a floor with friction; the error of the energy
 * beside it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <hawser/net_motion.h>

#include "bench/clock.h"

/* A span of 300 m, or a fan of three, under a load that swings it out of plane; or the span whose end
 * falls. Best of three. */
static int run(int cables, int elements, int falls)
{
	static int end = 1;
	static struct hawser_net_node node[4];
	static struct hawser_net_cable cable[3];
	static char name[] = "fan";
	struct hawser_net_load load = {.node = -1, .cable = 0, .value = {0.0, 0.0, 0.8}, .harmonic = 1,
	                               .Omega = 2.25};
	struct hawser_net net = {.name = name, .g = 9.81, .node = node, .cable = cable, .load = &load,
	                         .nodes = cables + 1, .cables = cables, .loads = 1,
	                         .dynamics = {.release = &end, .releases = falls}};
	struct hawser_net_motion_options options = {.until = 10.0, .every = 10.0, .step = 0.005};
	struct hawser_net_motion motion;
	struct hawser_report report = {0};
	double best = HUGE_VAL, began;
	int good;

	for (int i = 0; i <= cables; i++)
		node[i] = (struct hawser_net_node){.placed = 1, .x = {i ? 300.0 : 0.0, 0.0, 120.0*(i - 1)},
		                                   .held = {i > 0, i > 0, i > 0}, .support = i > 0};
	node[0].x[2] = 0.0;
	memset(node[0].held, cables == 1, 3);
	for (int i = 0; i < cables; i++)
		cable[i] = (struct hawser_net_cable){.from = 0, .to = i + 1, .EA = 1e8, .rho = 5.56,
		                                     .value = 302.0, .elements = elements};
	if (cables == 3)
		node[2].x[0] = -300.0;
	for (int again = 0; again < 3; again++) {
		if (again)
			hawser_net_motion_clear(&motion);
		began = cpu_secs();
		if (hawser_net_integrate(&motion, &net, &options, &report)) {
			printf("%s\n", report.message);
			return 1;
		}
		best = fmin(best, cpu_secs() - began);
	}
	printf("%d cable%s of %4d elements%s: %7.2f us a step, %.2f iterations, %ld switches, closure "
	       "%.1e\n", cables, cables == 1 ? " " : "s", elements, falls ? " falls" : "",
	       1e6*best/(double)motion.steps, (double)motion.iterations/(double)motion.steps,
	       motion.switches, motion.closure);
	good = motion.closure <= 1e-9;
	hawser_net_motion_clear(&motion);
	return !good;
}

/* The cable of B Table 3.2 on a floor that moves under it. */
static int dragged(int elements)
{
	struct hawser_net_node node[2] = {{.name = "A"},
	                                  {.name = "B", .placed = 1, .x = {0.0, 0.04, 0.0},
	                                   .held = {1, 1, 1}, .support = 1}};
	struct hawser_net_cable cable = {.from = 0, .to = 1, .EA = 30400.0, .rho = 0.15, .value = 1.2,
	                                 .elements = elements};
	struct hawser_surface floor = {.name = "floor", .normal = {0.0, 1.0, 0.0}, .friction = 1.0,
	                               .velocity = {-0.5, 0.0, 0.0}};
	static char name[] = "chain";
	struct hawser_net net = {.name = name, .g = 9.81, .node = node, .cable = &cable, .nodes = 2,
	                         .cables = 1, .surface = &floor, .surfaces = 1, .axial = 1e-4};
	struct hawser_net_motion_options options = {.until = 0.5, .every = 0.1, .step = 1e-3};
	struct hawser_net_motion motion;
	struct hawser_report report = {0};
	double began = cpu_secs();
	int good;

	if (hawser_net_integrate(&motion, &net, &options, &report)) {
		printf("%s\n", report.message);
		return 1;
	}
	began = cpu_secs() - began;
	printf("dragged, %4d elements, %4d contacts: %7.2f us a step, %.2f iterations, closure %.1e, laws "
	       "%.1e\n", elements, motion.touching[motion.rows - 1], 1e6*began/(double)motion.steps,
	       (double)motion.iterations/(double)motion.steps, motion.closure, motion.laws);
	good = motion.closure <= 1e-9 && motion.laws <= 1e-9;
	hawser_net_motion_clear(&motion);
	return !good;
}

int main(void)
{
	int failed = 0;

	for (int n = 25; n <= 1600; n *= 2)
		failed += run(1, n, 0);
	failed += run(1, 100, 1);
	for (int n = 25; n <= 400; n *= 4)
		failed += run(3, n, 0);
	for (int n = 25; n <= 800; n *= 2)
		failed += dragged(n);
	return failed != 0;
}
