/* net/statics/solution.c - statics of a net as its user sees it: positions and tensions by name.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/append.h"
#include "core/report.h"
#include "core/vec3.h"
#include "net/body.h"
#include "net/statics/dual.h"
#include "net/statics/solve.h"
#include "net/touch/touch.h"
#include "net/water/water.h"

void hawser_net_statics_clear(struct hawser_net_statics *st)
{
	if (!st)
		return;
	free(st->x);
	free(st->reaction);
	free(st->member);
	free(st->point);
	free(st->contact);
	free(st->body);
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

	for (int i = 0; lost >= 0 && i < net->nodes; i++)
		if (part[i] == lost && ++count <= 4)
			hawser__append(names, sizeof names, ", ", "%s", net->node[i].name);
	free(part);
	if (status || lost < 0)
		return status;
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net",
	                    "%s: the part of the net with the node%s %s%s has no support in direction "
	                    "%c, so that it has no equilibrium: add one of its nodes to supports",
	                    net->name,
	                    count == 1 ? "" : "s", names, count > 4 ? ", ..." : "", "xyz"[direction]);
}

static void member(struct hawser_net_statics *st, int c, const struct hawser__tensions *of)
{
	const struct hawser__mesh *mesh = of->mesh;
	struct hawser_net_member *m = &st->member[c];
	int first = mesh->first[c], n = mesh->first[c + 1] - first, rod = of->net->cable[c].rod;

	*m = (struct hawser_net_member){.T_min = INFINITY, .T_max = -INFINITY};
	for (int i = 0; i <= n; i++) {
		struct hawser_net_point *point = &st->point[st->points++];
		double e[3], l = i < n ? hawser__mesh_direction(e, mesh, first + i) : 0.0;

		*point = (struct hawser_net_point){.cable = c, .S = m->length0,
		                                   .T = rod ? 0.0 : hawser__tension_at(of, c, i)};
		memcpy(point->x, mesh->q[i < n ? mesh->end[first + i][0] : mesh->end[first + n - 1][1]],
		       sizeof point->x);
		m->T_from = i == 0 ? point->T : m->T_from;
		m->T_to = point->T;
		m->T_max = fmax(m->T_max, point->T);
		if (i < n)
			m->T_min = rod ? 0.0 : fmin(m->T_min, hawser__tension_least(of, c, i));
		m->wet += i < n && mesh->water ? mesh->water->wet[first + i] : 0.0;
		m->slack += i < n && !rod && l < mesh->length0[first + i];
		m->length0 += i < n ? hawser__mesh_length(mesh, first + i) : 0.0;
		m->length += l;
	}
}

enum hawser_status hawser__net_statics_open(struct hawser_net_statics *st, size_t elements,
                                            struct hawser_report *report)
{
	size_t nodes = (size_t)st->nodes, cables = (size_t)st->cables;

	st->x = calloc(nodes, sizeof *st->x);
	st->reaction = calloc(nodes, sizeof *st->reaction);
	st->member = calloc(cables, sizeof *st->member);
	st->body = calloc((size_t)st->bodies + 1, sizeof *st->body);
	st->point = calloc(elements + cables, sizeof *st->point);
	return st->x && st->reaction && st->member && st->body && st->point
		? HAWSER_OK : hawser__no_memory(report, "net");
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

/* Bodies as they are, with the forces of all their nodes at their first hinge, and none without. */
static void bodies(struct hawser_net_statics *st, const struct hawser__mesh *mesh,
                   const struct hawser_net *net)
{
	for (int b = 0; b < net->bodies; b++) {
		const struct hawser_net_body *body = &net->body[b];
		double force[3] = {0.0};
		int at = -1;

		st->body[b] = *body;
		st->body[b].node = NULL;
		for (int i = 0; i < mesh->nodes; i++)
			for (int k = 0; k < 3 && mesh->rigid[i] == b + 1; k++)
				force[k] += i < st->nodes ? st->reaction[i][k] : -mesh->force[i][k];
		for (int i = 0; i < mesh->touches; i++) {
			const struct hawser__touch *touch = &mesh->touch[i];

			if (mesh->rigid[touch->node] != b + 1)
				continue;
			for (int k = 0; k < 3; k++)
				force[k] -= touch->r*touch->n[k] + touch->friction[k];
			st->energy += 0.5*touch->give*touch->r*touch->r;
		}
		for (int i = body->nodes - 1; i >= 0; i--) {
			memset(st->reaction[body->node[i]], 0, sizeof *st->reaction);
			at = net->node[body->node[i]].support ? body->node[i] : at;
		}
		if (at >= 0)
			memcpy(st->reaction[at], force, sizeof force);
	}
}

/* Of its bound: friction that is less holds by itself. */
static const double SLIDES = 1e-9;

/* Supports on obstacles: what the obstacle carries is a contact, and not of the support. */
static void rests(struct hawser_net_statics *st, const struct hawser__tensions *of)
{
	for (int i = 0; i < st->nodes; i++) {
		struct hawser_net_contact *contact = &st->contact[st->contacts];
		double f[3], H[3][3], n[3], length0;
		int surface = hawser__tension_rests(f, &length0, of, i);

		if (surface < 0)
			continue;
		hawser_surface_gap(n, H, &of->net->surface[surface], st->x[i]);
		*contact = (struct hawser_net_contact){
			.surface = surface, .node = i, .cable = -1, .length0 = length0,
			.r = f[0]*n[0] + f[1]*n[1] + f[2]*n[2]};
		memcpy(contact->x, st->x[i], sizeof contact->x);
		for (int k = 0; k < 3; k++) {
			contact->friction[k] = f[k] - contact->r*n[k];
			st->reaction[i][k] -= f[k];
		}
		contact->sticks = !(of->net->surface[surface].axial > 0.0) &&
		                  hawser__norm(contact->friction) <
		                  of->net->surface[surface].friction*contact->r*(1.0 - SLIDES);
		st->contacts++;
	}
}

static enum hawser_status fill(struct hawser_net_statics *st, const struct hawser__mesh *mesh,
                               const struct hawser_net *net, const double *T,
                               struct hawser_report *report)
{
	double (*obstacle)[3] = calloc((size_t)mesh->nodes + 1, sizeof *obstacle);
	const struct hawser__tensions of = {.mesh = mesh, .net = net, .T = T,
	                                    .x = (const double (*)[3])mesh->q,
	                                    .obstacle = mesh->touches ? (const double (*)[3])obstacle
	                                                              : NULL};
	enum hawser_status status = obstacle ? hawser__net_statics_open(st, (size_t)mesh->elements, report)
	                                     : hawser__no_memory(report, "net");

	if (!status)
		status = hawser__touch_list(&st->contact, &st->contacts, mesh, st->nodes, report);
	if (!status) {
		hawser__tension_obstacles(obstacle, mesh);
		for (int i = 0; i < st->nodes; i++)
			memcpy(st->x[i], mesh->q[i], sizeof st->x[i]);
		reactions(st, mesh, T);
		rests(st, &of);
		bodies(st, mesh, net);
		for (int c = 0; c < st->cables; c++)
			member(st, c, &of);
	}
	free(obstacle);
	return status;
}

static enum hawser_status of_mesh(struct hawser_net_statics *st, const struct hawser_net *net,
                                  const struct hawser__net_method *method,
                                  const struct hawser_net_options *options,
                                  struct hawser_report *report)
{
	struct hawser__mesh_options settings = {.method = method, .tolerance = options->tolerance,
	                                        .iterations = options->iterations};
	struct hawser__mesh mesh = {0};
	struct hawser__equilibrium found;
	double *T = NULL;
	enum hawser_status status;

	status = hawser__mesh_build(&mesh, net, report);
	if (!status)
		status = hawser__net_supported(&mesh, net, report);
	if (!status && !(T = calloc((size_t)mesh.elements, sizeof *T)))
		status = hawser__no_memory(report, "net");
	if (!status && !mesh.touches && !mesh.water && !net->bodies && method == hawser__net_method(0) &&
	    hawser__exact_start(&mesh, T, net)) {
		settings.keep_start = 1;
		settings.N = T;
	}
	if (!status)
		status = net->contact.history ? hawser__net_history(&mesh, T, &found, net, &settings, report)
		                              : hawser__mesh_form(&mesh, T, &found, net, &settings, report);
	if (!status)
		status = hawser__touch_sides(&mesh, net, report);
	if (!status)
		status = hawser__bodies_land(&mesh, net, report);
	if (!status) {
		*st = (struct hawser_net_statics){
			.nodes = net->nodes, .cables = net->cables,
			.bodies = net->bodies, .unknowns = mesh.unknowns,
			.energy = found.energy, .gap = found.gap, .residual = found.residual,
			.floor = found.floor, .method = found.method, .iterations = found.iterations,
			.apart = found.apart};
		status = fill(st, &mesh, net, T, report);
	}
	free(T);
	hawser__mesh_clear(&mesh);
	return status;
}

enum hawser_status hawser__net_solve_by(struct hawser_net_statics *st, const struct hawser_net *net,
                                        const struct hawser__net_method *method,
                                        const struct hawser_net_options *options,
                                        struct hawser_report *report)
{
	struct hawser_net seated;
	double rest;
	enum hawser_status status;

	memset(st, 0, sizeof *st);
	if (net->surfaces && !method->obstacles)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: the method %s does not know "
		                    "obstacles: give automatic, or leave it out", net->name,
		                    method->shown.name);
	if (net->water.density > 0.0 && !method->solve)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: the method %s does not know "
		                    "%s: give automatic, or leave it out", net->name, method->shown.name,
		                    net->winds ? "wind" : "water");
	status = method->solve ? hawser__bodies_seat(&seated, &rest, net, 0, report)
	                       : hawser__bodies_none(net, "the method catenary", report);
	if (!status)
		status = method->solve ? of_mesh(st, &seated, method, options, report)
		                       : hawser__exact_statics(st, net, options, report);
	if (!status && method->solve)
		st->residual = fmax(st->residual, rest);
	if (method->solve)
		hawser__bodies_unseat(&seated, net);
	if (status)
		hawser_net_statics_clear(st);
	return status;
}

enum hawser_status hawser_net_solve(struct hawser_net_statics *st, const struct hawser_net *net,
                                    const struct hawser_net_options *options,
                                    struct hawser_report *report)
{
	static const struct hawser_net_options defaults = {0};
	const struct hawser__net_method *method = hawser__net_method(0);

	if (!options)
		options = &defaults;
	for (int i = 0; options->method && method && strcmp(method->shown.name, options->method) != 0; i++)
		method = hawser__net_method(i + 1);
	if (method)
		return hawser__net_solve_by(st, net, method, options, report);
	memset(st, 0, sizeof *st);
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "there is no method %.40s",
	                    options->method);
}
