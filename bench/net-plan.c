/* bench/net-plan - times that a plan of a net estimates, over measured ones: statics and modes from one
 * factorization, the motion from its beginning; for three nets. The test of the program compares too.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <hawser/net_modes.h>
#include <hawser/net_plan.h>

#include "bench/clock.h"

/* A square cable roof of side^2 meshes of 4 m over supports along its edge, which rise and fall; one
 * joint is loaded. */
static void roof(struct hawser_net *net, int side, int elements)
{
	static struct hawser_net_load load = {.cable = -1, .value = {0.0, -2e3, 100.0}, .harmonic = 1,
	                                      .Omega = 2.1};
	static char name[] = "roof";
	int n = side + 1;

	*net = (struct hawser_net){.name = name, .g = 9.81, .nodes = n*n, .load = &load, .loads = 1,
	                           .alpha = 0.05, .axial = 1e-3};
	net->node = calloc((size_t)net->nodes, sizeof *net->node);
	net->cable = calloc(2*(size_t)net->nodes, sizeof *net->cable);
	net->order = calloc(3*(size_t)net->nodes, sizeof *net->order);
	load.node = n*(n/2) + n/2;
	for (int i = 0; i < net->nodes; i++) {
		int row = i/n, column = i%n, edge = row == 0 || column == 0 || row == side || column == side;
		double x = 4.0*column, z = 4.0*row;

		net->node[i] = (struct hawser_net_node){.placed = 1, .x = {x,
		                                                           edge ? 0.05*x*sin(0.2*z) : 0.0, z},
		                                        .held = {edge, edge, edge}, .support = edge};
		if (column < side && !(row == 0 || row == side))
			net->cable[net->cables++] = (struct hawser_net_cable){
				.from = i, .to = i + 1, .EA = 2e7, .rho = 1.2, .value = 4.02, .elements = elements};
		if (row < side && !(column == 0 || column == side))
			net->cable[net->cables++] = (struct hawser_net_cable){
				.from = i, .to = i + n, .EA = 2e7, .rho = 1.2, .value = 4.02, .elements = elements};
	}
}

static void row(const char *net, const struct hawser_net_plan_job *job, double measured)
{
	printf("%-22s %-10s %-9s %8d unknowns: estimated %9.3g s (%.2g to %.2g), measured %9.3g s, "
	       "ratio %5.2f\n",
	       net, job->name, hawser_net_basis_name(job->basis), job->unknowns, job->seconds, job->least,
	       job->most, measured, job->seconds/measured);
}

/* Estimates with next to no time, and with a twentieth of the time of the motion; then all of it. */
static int compare(const char *name, struct hawser_net *net, double until)
{
	struct hawser_net_plan_options options = {.motion = {.until = until}, .seconds = 1e-7};
	struct hawser_net_statics st;
	struct hawser_net_modes modes;
	struct hawser_net_motion motion;
	struct hawser_net_plan rough, plan;
	struct hawser_report report = {0};
	double time[3], began = cpu_secs();
	int wrong;

	if (hawser_net_solve(&st, net, NULL, &report))
		return printf("%s: %s\n", name, report.message);
	time[0] = cpu_secs() - began;
	began = cpu_secs();
	if (hawser_net_modes_solve(&modes, net, 0, &report))
		return printf("%s: %s\n", name, report.message);
	time[1] = cpu_secs() - began;
	began = cpu_secs();
	if (hawser_net_integrate(&motion, net, &options.motion, &report))
		return printf("%s: %s\n", name, report.message);
	time[2] = cpu_secs() - began;
	if (hawser_net_plan_make(&rough, net, &options, &report))
		return printf("%s: %s\n", name, report.message);
	options.seconds = fmax(0.05*time[2], 0.2*time[0]);
	if (hawser_net_plan_make(&plan, net, &options, &report))
		return printf("%s: %s\n", name, report.message);
	row(name, &rough.job[0], time[0]);
	row(name, &rough.job[1], time[1]);
	row(name, &plan.job[2], time[2]);
	printf("%-22s steps estimated %.0f, taken %ld; memory of statics %.0f MB\n", name,
	       plan.job[2].count,
	       motion.steps, plan.job[0].bytes/1e6);
	wrong = !(plan.job[2].least <= 1.2*time[2] && plan.job[2].most >= 0.8*time[2]);
	hawser_net_statics_clear(&st);
	hawser_net_modes_clear(&modes);
	hawser_net_motion_clear(&motion);
	hawser_net_plan_clear(&rough);
	hawser_net_plan_clear(&plan);
	return wrong;
}

/* The scene of a file, with a load on one joint. */
static int file(const char *path, double until)
{
	static struct hawser_net_load load = {.node = 12, .cable = -1, .value = {0.0, -20.0, 5.0},
	                                      .harmonic = 1,
	                                      .Omega = 2.1};
	struct hawser_net net;
	struct hawser_report report = {0};
	int wrong;

	if (hawser_net_open(&net, path, NULL, 0, &report))
		return printf("%s\n", report.message);
	net.load = &load;
	net.loads = 1;
	net.alpha = 0.05;
	net.axial = 1e-3;
	wrong = compare("B's Table 3.1", &net, until);
	net.load = NULL;
	net.loads = 0;
	hawser_net_clear(&net);
	return wrong;
}

static int span(double until)
{
	static char name[] = "span";
	struct hawser_net_node node[2] = {{.placed = 1, .held = {1, 1, 1}, .support = 1},
	                                  {.placed = 1, .x = {300.0, 15.0, 0.0}, .held = {1, 1, 1},
	                                   .support = 1}};
	struct hawser_net_cable cable = {.from = 0, .to = 1, .EA = 1e8, .rho = 5.56, .value = 302.0,
	                                 .elements = 100};
	struct hawser_net_load load = {.node = -1, .cable = 0, .value = {0.0, 0.5, 0.8}, .harmonic = 1,
	                               .Omega = 2.25};
	struct hawser_net net = {.name = name, .g = 9.81, .node = node, .cable = &cable, .nodes = 2,
	                         .cables = 1,
	                         .load = &load, .loads = 1, .alpha = 0.08};

	return compare("span, 100 elements", &net, until);
}

int main(int argc, char **argv)
{
	const char *path = argc > 1 ? argv[1] : "../notebooks-data/scenes/net-table-3-1.yaml";
	struct hawser_net net;
	int failed = span(300.0) + file(path, 10.0);

	roof(&net, 24, 8);
	failed += compare("roof, 24 x 24", &net, 0.2);
	free(net.node);
	free(net.cable);
	free(net.order);
	return failed != 0;
}
