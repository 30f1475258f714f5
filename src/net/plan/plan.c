/* net/plan/plan.c - hawser_net_plan_make: sizes, time scales, and the order of the parts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/progress.h"
#include "core/report.h"
#include "net/motion/motion.h"
#include "net/plan/plan.h"

enum { PERIODS = 10, SECONDS = 10, MODES = 6, DEFAULT_ROWS = 200 };

const char *hawser_net_basis_name(enum hawser_net_basis basis)
{
	return basis == HAWSER_NET_BASIS_RUN ? "run" : basis == HAWSER_NET_BASIS_ESTIMATE ? "estimate" : "";
}

void hawser_net_plan_clear(struct hawser_net_plan *plan)
{
	if (!plan)
		return;
	free(plan->decision);
	free(plan->warning);
	free(plan->cable);
	memset(plan, 0, sizeof *plan);
}

static void clear(struct hawser__net_planner *planner)
{
	hawser__mesh_clear(&planner->mesh);
	hawser_net_statics_clear(&planner->st);
	hawser_net_modes_clear(&planner->modes);
	hawser_net_motion_clear(&planner->motion);
}

static void count(struct hawser__net_planner *planner)
{
	struct hawser_net_plan *plan = planner->plan;
	const struct hawser_net *net = planner->net;

	plan->nodes = net->nodes;
	plan->cables = net->cables;
	plan->elements = planner->mesh.elements;
	plan->mesh_nodes = planner->mesh.nodes;
	plan->unknowns = planner->mesh.unknowns;
	plan->until = planner->options.motion.until;
	plan->step = plan->first = plan->axial = plan->resolved = NAN;
	for (int i = 0; i < net->nodes; i++) {
		plan->supports += net->node[i].support;
		for (int k = 0; k < 3; k++)
			plan->joint_unknowns += !net->node[i].held[k];
	}
}

/* Frequencies of loads and of the motion of supports. */
static void frequencies(struct hawser__net_planner *planner)
{
	struct hawser_net_plan *plan = planner->plan;
	const struct hawser_net *net = planner->net;
	double low = INFINITY, high = 0.0;

	for (int i = 0; i < net->loads + net->motions; i++) {
		const struct hawser_net_load *load = i < net->loads ? &net->load[i]
		                                                    : &net->motion[i - net->loads];

		if (!load->harmonic)
			continue;
		low = fmin(low, load->Omega);
		high = fmax(high, load->Omega);
	}
	plan->slowest = high > 0.0 ? low : 0.0;
	plan->fastest = high;
}

/* What the mesh can show: its fastest axial vibration, and elements in a wave of the fastest load. */
static void waves(struct hawser__net_planner *planner)
{
	struct hawser_net_plan *plan = planner->plan;
	const struct hawser_net *net = planner->net;

	for (int c = 0; c < plan->cables && planner->st.x; c++) {
		const struct hawser_net_plan_cable *cable = &plan->cable[c];
		double l = cable->length0/cable->elements, EA = net->cable[c].EA, rho = net->cable[c].rho;
		double T = 0.5*(cable->T_min + cable->T_max);

		if (rho > 0.0)
			plan->axial = fmax(plan->axial, 2.0*sqrt(EA/rho)/l);
		if (rho > 0.0 && plan->fastest > 0.0)
			plan->resolved = fmin(plan->resolved, 2.0*M_PI*sqrt(T/rho)/(plan->fastest*l));
	}
}

/* Long enough to see what the loads do: ten periods of the slowest one; ten seconds where nothing is
 * known. */
static void duration(struct hawser__net_planner *planner)
{
	struct hawser_net_plan *plan = planner->plan;
	double omega = plan->slowest > 0.0 ? plan->slowest : plan->first;

	if (!(plan->until > 0.0))
		plan->until = fmin(omega > 0.0 ? PERIODS*2.0*M_PI/omega : SECONDS, planner->table_end);
	plan->every = planner->options.motion.every > 0.0 ? planner->options.motion.every
	                                                  : plan->until/DEFAULT_ROWS;
	planner->options.motion.until = plan->until;
	planner->options.motion.every = plan->every;
}

static enum hawser_status settle(struct hawser__net_planner *planner, struct hawser_report *report)
{
	struct hawser_net_plan_options *options = &planner->options;
	enum hawser_status status;

	options->modes = options->modes > 0 ? options->modes : MODES;
	options->seconds = options->seconds > 0.0 ? options->seconds : 0.2;
	if (options->motion.until < 0.0 || !isfinite(options->motion.until))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "the end of the motion must be a "
		                    "positive time, not %g s", options->motion.until);
	status = hawser__mesh_lawless(planner->net, "the plan", report);
	return status ? status : hawser__mesh_build(&planner->mesh, planner->net, report);
}

/* Directions without motion, and the end of the tables that move supports. A table that cannot be
 * read is found again when the motion begins. */
static enum hawser_status look(struct hawser__net_planner *planner, struct hawser_report *report)
{
	const struct hawser_net *net = planner->net;
	struct hawser__support_table *table = calloc((size_t)net->nodes + 1, sizeof *table);
	int tables = 0, other = net->dynamics.from || planner->options.motion.initial;
	struct hawser_report unused = {0};
	double place;

	if (!table)
		return hawser__no_memory(report, "net");
	planner->table_end = INFINITY;
	for (int i = 0; i < net->nodes; i++) {
		if (!net->node[i].table)
			continue;
		if (hawser__support_read(&table[tables], net->node[i].table, &unused))
			other = 1;
		else
			planner->table_end = fmin(planner->table_end, table[tables].t[table[tables].rows - 1]);
		tables++;
	}
	for (int k = 0; k < 3; k++)
		planner->still[k] = !other && hawser__net_still(&place, net, k, table, tables);
	for (int i = 0; i < tables; i++)
		hawser__support_clear(&table[i]);
	free(table);
	return HAWSER_OK;
}

static enum hawser_status make(struct hawser__net_planner *planner, struct hawser_report *report)
{
	enum hawser_status status = settle(planner, report);

	if (status)
		return status;
	count(planner);
	frequencies(planner);
	planner->plan->cable = calloc((size_t)planner->net->cables + 1, sizeof *planner->plan->cable);
	if (!planner->plan->cable)
		return hawser__no_memory(report, "net");
	status = look(planner, report);
	if (!status)
		status = hawser__plan_statics(planner, report);
	if (!status)
		status = hawser__plan_mesh(planner, report);
	if (!status)
		status = hawser__plan_modes(planner, report);
	waves(planner);
	duration(planner);
	if (!status)
		status = hawser__plan_motion(planner, report);
	return status ? status : hawser__plan_words(planner, report);
}

enum hawser_status hawser_net_plan_make(struct hawser_net_plan *plan, const struct hawser_net *net,
                                        const struct hawser_net_plan_options *options,
                                        struct hawser_report *report)
{
	struct hawser__net_planner *planner = calloc(1, sizeof *planner);
	double began = hawser__processor_seconds();
	enum hawser_status status;

	memset(plan, 0, sizeof *plan);
	if (!planner)
		return hawser__no_memory(report, "net");
	planner->plan = plan;
	planner->net = net;
	if (options)
		planner->options = *options;
	status = make(planner, report);
	plan->seconds = hawser__processor_seconds() - began;
	clear(planner);
	free(planner);
	if (status)
		hawser_net_plan_clear(plan);
	return status;
}
