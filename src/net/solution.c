/* net/solution.c - statics of a net as its user sees it: positions and tensions by name.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/exact.h"
#include "net/solution.h"
#include "net/touch.h"

void hawser_net_statics_clear(struct hawser_net_statics *st)
{
	if (!st)
		return;
	free(st->x);
	free(st->reaction);
	free(st->member);
	free(st->point);
	free(st->contact);
	memset(st, 0, sizeof *st);
}

enum hawser_status hawser__net_supported(const struct hawser__mesh *mesh, const struct hawser_net *net,
                                         struct hawser_report *report)
{
	int *part = malloc((size_t)mesh->nodes*sizeof *part), lost = -1, direction = 0, count = 0;
	enum hawser_status status = part ? hawser__mesh_loose(&lost, &direction, mesh, part, report)
	                                 : hawser__no_memory(report, "net");
	char names[160] = "";

	if (mesh->around)
		lost = -1; /* an obstacle holds it */

	for (int i = 0; lost >= 0 && i < net->nodes; i++) {
		size_t used = strlen(names);

		if (part[i] == lost && ++count <= 4)
			snprintf(names + used, sizeof names - used, "%s%s", count > 1 ? ", " : "",
			         net->node[i].name);
	}
	free(part);
	if (status || lost < 0)
		return status;
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net",
	                    "%s: the part of the net with the node%s %s%s has no support in direction "
	                    "%c, so that it has no equilibrium: add one of its nodes to supports",
	                    net->name,
	                    count == 1 ? "" : "s", names, count > 4 ? ", ..." : "", "xyz"[direction]);
}

static void member(struct hawser_net_statics *st, int c, const struct hawser__mesh *mesh,
                   const double *T)
{
	struct hawser_net_member *m = &st->member[c];
	int first = mesh->first[c], last = mesh->first[c + 1] - 1;

	*m = (struct hawser_net_member){.T_min = INFINITY, .T_from = T[first], .T_to = T[last]};
	for (int i = first; i <= last; i++) {
		struct hawser_net_point *point = &st->point[st->points++];
		double e[3], l = hawser__mesh_direction(e, mesh, i);

		point->cable = c;
		point->S = m->length0;
		memcpy(point->x, mesh->q[mesh->end[i][0]], sizeof point->x);
		point->T = (T[i] + T[i > first ? i - 1 : i])/2.0;
		m->T_min = fmin(m->T_min, T[i]);
		m->T_max = fmax(m->T_max, T[i]);
		m->slack += l < mesh->length0[i];
		m->length0 += mesh->length0[i];
		m->length += l;
	}
	st->point[st->points] = (struct hawser_net_point){.cable = c, .S = m->length0, .T = T[last]};
	memcpy(st->point[st->points++].x, mesh->q[mesh->end[last][1]], sizeof st->point->x);
}

enum hawser_status hawser__net_statics_open(struct hawser_net_statics *st, size_t elements,
                                            struct hawser_report *report)
{
	size_t nodes = (size_t)st->nodes, cables = (size_t)st->cables;

	st->x = calloc(nodes, sizeof *st->x);
	st->reaction = calloc(nodes, sizeof *st->reaction);
	st->member = calloc(cables, sizeof *st->member);
	st->point = calloc(elements + cables, sizeof *st->point);
	return st->x && st->reaction && st->member && st->point ? HAWSER_OK
	                                                        : hawser__no_memory(report, "net");
}

/* Forces of the supports on the net, from the tensions, whatever their law. */
static void reactions(struct hawser_net_statics *st, const struct hawser__mesh *mesh, const double *T)
{
	for (int i = 0; i < st->nodes; i++)
		for (int k = 0; k < 3; k++)
			st->reaction[i][k] = mesh->unknown[i][k] < 0 ? -mesh->force[i][k] : 0.0;
	for (int i = 0; i < mesh->elements; i++) {
		double e[3];

		hawser__mesh_direction(e, mesh, i);
		for (int k = 0; k < 3; k++) {
			int a = mesh->end[i][0], b = mesh->end[i][1];

			if (a < st->nodes && mesh->unknown[a][k] < 0)
				st->reaction[a][k] -= T[i]*e[k];
			if (b < st->nodes && mesh->unknown[b][k] < 0)
				st->reaction[b][k] += T[i]*e[k];
		}
	}
}

static enum hawser_status fill(struct hawser_net_statics *st, const struct hawser__mesh *mesh,
                               const double *T, struct hawser_report *report)
{
	enum hawser_status status = hawser__net_statics_open(st, (size_t)mesh->elements, report);

	if (status)
		return status;
	for (int i = 0; i < st->nodes; i++)
		memcpy(st->x[i], mesh->q[i], sizeof st->x[i]);
	reactions(st, mesh, T);
	for (int c = 0; c < st->cables; c++)
		member(st, c, mesh, T);
	return HAWSER_OK;
}

static enum hawser_status of_mesh(struct hawser_net_statics *st, const struct hawser_net *net,
                                  const struct hawser_net_options *options,
                                  struct hawser_report *report)
{
	struct hawser__mesh_options settings = {.method = options->method, .tolerance = options->tolerance,
	                                        .iterations = options->iterations,
	                                        .start = options->start, .noise = options->noise,
	                                        .seed = options->seed};
	struct hawser__mesh mesh = {0};
	struct hawser__equilibrium found;
	double *T = NULL;
	enum hawser_status status;

	status = hawser__mesh_build(&mesh, net, report);
	if (!status)
		status = hawser__net_supported(&mesh, net, report);
	if (!status && !(T = calloc((size_t)mesh.elements, sizeof *T)))
		status = hawser__no_memory(report, "net");
	if (!status && !mesh.touches && (!options->method || !strcmp(options->method, "automatic")) &&
	    hawser__exact_start(&mesh, T, net)) {
		settings.keep_start = 1;
		settings.N = T;
	}
	if (!status)
		status = net->contact.history ? hawser__net_history(&mesh, T, &found, net, &settings, report)
		                              : hawser__mesh_form(&mesh, T, &found, net, &settings, report);
	if (!status)
		status = hawser__touch_sides(&mesh, net, report);
	if (!status) {
		*st = (struct hawser_net_statics){
			.nodes = net->nodes, .cables = net->cables, .unknowns = mesh.unknowns,
			.energy = found.energy, .gap = found.gap, .residual = found.residual,
			.floor = found.floor, .method = found.method, .iterations = found.iterations,
			.compressed = found.compressed, .apart = found.apart};
		status = fill(st, &mesh, T, report);
		if (!status)
			status = hawser__touch_list(&st->contact, &st->contacts, &mesh, st->nodes, report);
	}
	free(T);
	hawser__mesh_clear(&mesh);
	return status;
}

enum hawser_status hawser_net_solve(struct hawser_net_statics *st, const struct hawser_net *net,
                                    const struct hawser_net_options *options,
                                    struct hawser_report *report)
{
	static const struct hawser_net_options defaults = {0};
	const struct hawser__net_method *row = NULL;
	enum hawser_status status;

	if (!options)
		options = &defaults;
	for (int i = 0; options->method && (row = hawser__net_method(i)); i++)
		if (!strcmp(row->shown.name, options->method))
			break;
	memset(st, 0, sizeof *st);
	if (row && net->surfaces && !row->obstacles)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: the method %s does not know "
		                    "obstacles: give automatic, or leave it out", net->name,
		                    row->shown.name);
	status = row && !row->solve ? hawser__exact_statics(st, net, options, report)
	                            : of_mesh(st, net, options, report);
	if (status)
		hawser_net_statics_clear(st);
	return status;
}
