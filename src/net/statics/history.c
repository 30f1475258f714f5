/* net/statics/history.c - statics of a net with friction: the way of its supports in small steps.
 *
 * At rest friction leaves the tensions undetermined: they depend on how the net came to its place. Here
 * the supports go along the way that the scene gives, slowly, from an equilibrium without friction, in
 * which nodes whose places are given are held: a free end lies where it is put (but places of a belt
 * only say how it goes around). In each step a node
 * that touches sticks where it was, or slides against the friction; the law has no time, so that only
 * the way counts. A step without solution is halved.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/touch/touch.h"

enum { HALVES = 12 }; /* of a step: 1/4096 of it */

struct way {
	struct hawser__mesh *mesh;
	const struct hawser_net *net;
	double *T;               /* [elements] N */
	struct hawser__equilibrium *found;
	struct hawser__mesh_options options;
	double (*q)[3];          /* [nodes] of the last step, then what is kept of it */
	double *T0;              /* [elements] */
	struct hawser__touch *touch; /* [touches] */
	int iterations;
};

static const double *place_of(const struct way *way, int path, int point)
{
	const struct hawser_net_path *of = &way->net->contact.path[path];

	return point < of->points ? of->x[point] : way->net->node[of->node].x;
}

/* Supports at a part, 0 to 1, of the way from a point to the next one. */
static void move(struct way *way, int point, double part)
{
	for (int i = 0; i < way->net->contact.paths; i++) {
		const double *a = place_of(way, i, point);
		const double *b = place_of(way, i, part > 0.0 ? point + 1 : point);
		int node = way->net->contact.path[i].node;

		for (int k = 0; k < 3; k++)
			if (way->mesh->unknown[node][k] < 0)
				way->mesh->q[node][k] = part < 1.0 ? a[k] + part*(b[k] - a[k]) : b[k];
	}
}

static void keep(struct way *way, int back)
{
	struct hawser__mesh *mesh = way->mesh;
	size_t nodes = (size_t)mesh->nodes*sizeof *way->q, elements = (size_t)mesh->elements*sizeof *way->T;
	size_t touches = (size_t)mesh->touches*sizeof *way->touch;

	memcpy(back ? mesh->q : way->q, back ? way->q : mesh->q, nodes);
	memcpy(back ? way->T : way->T0, back ? way->T0 : way->T, elements);
	memcpy(back ? mesh->touch : way->touch, back ? way->touch : mesh->touch, touches);
}

/* From the part `from` to the part `to` of the way between two points. */
static enum hawser_status go(struct way *way, int point, double from, double to, int halves,
                             struct hawser_report *report)
{
	struct hawser__mesh *mesh = way->mesh;
	enum hawser_status status;

	keep(way, 0);
	for (int i = 0; i < mesh->touches; i++)
		memcpy(mesh->touch[i].from, mesh->q[mesh->touch[i].node], sizeof mesh->touch[i].from);
	move(way, point, to);
	status = hawser__mesh_statics(mesh, way->T, way->found, &way->options, report);
	way->iterations += way->found->iterations;
	if ((status != HAWSER_ERR_CONVERGENCE && status != HAWSER_ERR_NAN) || halves == 0)
		return status;
	keep(way, 1);
	status = go(way, point, from, (from + to)/2.0, halves - 1, report);
	return status ? status : go(way, point, (from + to)/2.0, to, halves - 1, report);
}

/* Hold the nodes that the scene gives a place and no support, or release them. */
static enum hawser_status hold(struct way *way, unsigned char held, struct hawser_report *report)
{
	int count = 0;

	for (int i = 0; i < way->net->nodes; i++)
		if (way->net->node[i].placed && !way->net->node[i].support && !way->mesh->around) {
			hawser__mesh_hold(way->mesh, i, (unsigned char[3]){held, held, held});
			count++;
		}
	return count ? hawser__touch_again(way->mesh, way->net, report) : HAWSER_OK;
}

/* The first equilibrium, without friction and with placed nodes where the scene has them. */
static enum hawser_status lay(struct way *way, struct hawser_report *report)
{
	enum hawser_status status = hold(way, 1, report);

	move(way, 0, 0.0);
	if (!status)
		status = hawser__mesh_statics(way->mesh, way->T, way->found, &way->options, report);
	return status ? status : hold(way, 0, report);
}

enum hawser_status hawser__net_history(struct hawser__mesh *mesh, double *T,
                                       struct hawser__equilibrium *found, const struct hawser_net *net,
                                       const struct hawser__mesh_options *options,
                                       struct hawser_report *report)
{
	struct way way = {.mesh = mesh, .net = net, .T = T, .found = found, .options = *options};
	int steps = net->contact.steps;
	enum hawser_status status = hawser__mesh_lawless(net, "friction of a way", report);

	if (status)
		return status;
	way.q = malloc(((size_t)mesh->nodes + 1)*sizeof *way.q);
	way.T0 = malloc(((size_t)mesh->elements + 1)*sizeof *way.T0);
	way.touch = malloc(((size_t)mesh->touches + 1)*sizeof *way.touch);
	if (!way.q || !way.T0 || !way.touch)
		status = hawser__no_memory(report, "net");
	if (!status)
		status = lay(&way, report);
	way.options.keep_start = way.options.rubs = 1;
	way.options.N = way.T;
	for (int point = 0; !status && point < net->contact.path[0].points; point++)
		for (int i = 0; !status && i < steps; i++)
			status = go(&way, point, (double)i/steps, (i + 1.0)/steps, HALVES, report);
	found->iterations = way.iterations;
	free(way.q);
	free(way.T0);
	free(way.touch);
	return status;
}

enum hawser_status hawser__net_equilibrium(struct hawser__mesh *mesh, double *T,
                                           const struct hawser_net *net, struct hawser_report *report)
{
	struct hawser__equilibrium equilibrium;
	struct hawser__mesh_options settings = {0};
	enum hawser_status status = net->contact.history
		? hawser__net_history(mesh, T, &equilibrium, net, &settings, report)
		: hawser__mesh_form(mesh, T, &equilibrium, net, &settings, report);

	return status ? status : hawser__touch_sides(mesh, net, report);
}
