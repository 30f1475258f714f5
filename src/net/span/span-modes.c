/* net/span/span-modes.c - modes of a span by its mesh, with their errors; see hawser/net_span.h.
 *
 *   N, M    elements of the mesh and of a second one with half as many
 *   u       displacement of a node; between nodes the polynomial through the nearest six
 *
 * A cable that hangs in one plane has modes in it and across it. They are computed one plane at a
 * time: of modes with equal frequencies no method could tell the planes.
 *
 * Error of omega_N: |omega_N - omega_M|/((N/M)^2 - 1), as at order 2. The mean of both mass
 * matrices makes the part of a taut string's error of order 4, for which this is too much.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/grid.h"
#include "modes/halving.h"
#include "modes/label.h"
#include "net/net.h"
#include "net/span/span.h"
#include "statics/frame.h"

enum { ORDER = 4, PLANES = 2 }; /* nodes of the grid on an element */
/* Of the estimate, so that it exceeds the true error where order 2 has not been reached. */
static const double SAFETY = 2.0;
static const double ROUND_OFF = 1e-14;

static void turned(double v[3], const struct hawser_statics *st)
{
	hawser_statics_from_global(st, v, v);
}

static void weigh(struct hawser_net *net, int node, int cable, double weight,
                  const struct hawser_statics *st)
{
	struct hawser_net_load *load = &net->load[net->loads++];

	*load = (struct hawser_net_load){.node = node, .cable = cable, .value = {0.0, -weight, 0.0}};
	turned(load->value, st);
}

/* Turn a span's net that has only constant loads into the axes of its statics, so that it hangs in
 * the plane of the first two; the weights become loads. */
static void net_span_turn(struct hawser_net *net, const struct hawser_statics *st)
{
	for (int i = 0; i < net->nodes; i++)
		turned(net->node[i].x, st);
	for (int i = 0; i < net->loads; i++)
		turned(net->load[i].value, st);
	for (int c = 0; c < net->cables; c++)
		weigh(net, -1, c, net->cable[c].rho*net->g, st);
	for (int i = 0; i < net->nodes; i++)
		if (net->node[i].mass > 0.0)
			weigh(net, i, -1, net->node[i].mass*net->g, st);
	net->g = 0.0;
}

/* --- one mesh --- */

/* Modes in and across the plane or, in space, all of them in `part` 0. */
struct level {
	struct hawser_net net;
	struct hawser_net_modes part[PLANES];
	int parts, elements;
};

static void clear(struct level *level)
{
	for (int q = 0; q < PLANES; q++)
		hawser_net_modes_clear(&level->part[q]);
	hawser_net_clear(&level->net);
}

static enum hawser_status solve(struct level *level, const struct hawser_scene *scene,
                                const struct hawser_statics *st, int elements, int halved, int n,
                                struct hawser_report *report)
{
	static const unsigned along[PLANES] = {3U, 4U};
	const struct hawser_net_span_options options = {.elements = elements, .still = 1};
	enum hawser_status status = hawser__net_span(&level->net, scene, st, &options, 1, halved, report);

	level->parts = st->space ? 1 : PLANES;
	if (!status)
		net_span_turn(&level->net, st);
	for (int c = 0; c < level->net.cables; c++)
		level->elements += level->net.cable[c].elements;
	for (int q = 0; q < level->parts && !status; q++)
		status = hawser__net_modes(&level->part[q], &level->net, n,
		                           st->space ? HAWSER__NET_SPACE : along[q], report);
	return status;
}

/* --- shapes --- */

/* Values of a mode at the points of one cable: displacement and derivative by s, at a part of it. */
static void between(double u[3], double slope[3], const double (*value)[3], int elements, double part,
                    double length)
{
	for (int k = 0; k < 3; k++) {
		u[k] = hawser__six_points(&slope[k], value[0] + k, elements, 3, part*elements);
		slope[k] *= elements/length;
	}
}

static void fill(struct hawser_modes *modes, int k, const struct level *level, int q, int j)
{
	const struct hawser_statics *st = &modes->statics;
	const struct hawser_net_modes *from = &level->part[q];
	const double (*value)[3] = (const double (*)[3])from->point + (size_t)j*(size_t)from->points;
	double *shape = modes->shape + 3*(size_t)k*(size_t)modes->grid.points;
	double *slope = modes->slope + 3*(size_t)k*(size_t)modes->grid.points;
	double begin = 0.0;
	int c = 0;

	modes->mode[k].plane = q ? HAWSER_OUT_OF_PLANE : HAWSER_IN_PLANE;
	modes->mode[k].omega = from->omega[j]*modes->time_unit;
	for (int i = 0; i < modes->grid.points; i++, shape += 3, slope += 3) {
		double s = modes->grid.s[i], length, u[3], by_s[3];
		struct hawser_frame_point at = hawser_statics_frame(st, s);

		while (c < level->net.cables - 1 && s > begin + level->net.cable[c].value/st->span.d) {
			begin += level->net.cable[c].value/st->span.d;
			value += level->net.cable[c++].elements + 1;
		}
		length = level->net.cable[c].value/st->span.d;
		between(u, by_s, value, level->net.cable[c].elements, (s - begin)/length, length);
		hawser__frame_in(shape, &at, u);
		hawser__frame_in(slope, &at, by_s);
	}
}

/* Error of mode j of a part, by the second mesh; 0 for a mode that is not there. */
static double estimate(const struct level *fine, const struct level *coarse, int q, int j)
{
	const struct hawser_net_modes *a = &fine->part[q], *b = &coarse->part[q];
	double ratio = (double)fine->elements/coarse->elements;

	if (j < 0 || j >= a->n)
		return 0.0;
	return fabs(a->omega[j] - b->omega[j])/a->omega[j]/(ratio*ratio - 1.0);
}

/* The error changes its sign between coarse and fine meshes, at different ones for neighbouring modes:
 * theirs count too. */
static double error_of(const struct level *fine, const struct level *coarse, int q, int j)
{
	double own = estimate(fine, coarse, q, j);
	double next = fmax(estimate(fine, coarse, q, j - 1), estimate(fine, coarse, q, j + 1));

	return SAFETY*fmax(own, 0.5*next) + ROUND_OFF;
}

/* The n lowest of both planes. */
static void merge(struct hawser_modes *modes, const struct level *fine, const struct level *coarse)
{
	int next[PLANES] = {0};

	for (int k = 0; k < modes->n; k++) {
		int q = 0;

		if (fine->parts > 1 && (next[0] == fine->part[0].n || (next[1] < fine->part[1].n &&
		    fine->part[1].omega[next[1]] < fine->part[0].omega[next[0]])))
			q = 1;
		fill(modes, k, fine, q, next[q]);
		modes->mode[k].residual = error_of(fine, coarse, q, next[q]);
		next[q]++;
	}
}

static enum hawser_status grid(struct hawser_modes *modes, const struct level *level,
                               struct hawser_report *report)
{
	double *edge = calloc((size_t)level->elements + 1, sizeof *edge), begin = 0.0;
	enum hawser_status status = edge ? HAWSER_OK : hawser__no_memory(report, "net");
	int e = 0;

	for (int c = 0; c < level->net.cables && !status; c++) {
		double length = level->net.cable[c].value/modes->statics.span.d;

		for (int i = 1; i <= level->net.cable[c].elements; i++)
			edge[++e] = begin + length*i/level->net.cable[c].elements;
		begin += length;
	}
	if (!status) {
		edge[e] = modes->statics.l;
		status = hawser__grid_init(&modes->grid, level->elements, ORDER, edge, NULL, report);
	}
	free(edge);
	return status;
}

static enum hawser_status make(struct hawser_modes *modes, const struct hawser_statics *st, int n,
                               const struct level *fine, const struct level *coarse,
                               struct hawser_report *report)
{
	enum hawser_status status;

	*modes = (struct hawser_modes){.statics = *st, .method = "fe", .basis = fine->elements,
		.time_unit = st->span.d*sqrt(st->span.rho/st->H)};
	status = grid(modes, fine, report);
	if (!status)
		status = hawser__modes_allocate(modes, n, modes->grid.points, report);
	if (!status) {
		merge(modes, fine, coarse);
		status = hawser__modes_label(modes, report);
	}
	if (status)
		hawser_modes_clear(modes);
	return status;
}

enum hawser_status hawser_net_span_modes(struct hawser_modes *modes, const struct hawser_scene *scene,
                                         const struct hawser_statics *st, int n, int elements,
                                         struct hawser_report *report)
{
	struct hawser_net_span_options options = {.elements = elements};
	struct level fine = {.parts = 0}, coarse = {.parts = 0};
	int least = 2*(n + 1); /* so that the second mesh has as many modes in each plane */
	enum hawser_status status = HAWSER_OK;

	*modes = (struct hawser_modes){.n = 0};
	hawser_net_span_settle(&options);
	if (n < 1 || options.elements < least)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%d modes of a mesh of %d elements: "
		                      "ask for 1 to %d, or give %d elements or more", n, options.elements,
		                      options.elements/2 - 1, least);
	if (!status)
		status = solve(&fine, scene, st, options.elements, 0, n, report);
	if (!status)
		status = solve(&coarse, scene, st, options.elements, 1, n, report);
	if (!status)
		status = make(modes, st, n, &fine, &coarse, report);
	clear(&fine);
	clear(&coarse);
	return status;
}
