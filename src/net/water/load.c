/* net/water/load.c - loads of still water and of a current on a mesh at rest, and their
 * derivatives.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/motion/motion.h"
#include "net/water/water.h"
#include "water/water.h"

static enum hawser_status allocate(struct hawser__mesh *mesh, int buoys, int failures,
                                   struct hawser_report *report)
{
	size_t elements = (size_t)mesh->elements, nodes = (size_t)(mesh->nodes + failures);
	struct hawser__mesh_water *water = hawser__hold(&mesh->hold, 1, sizeof *water);

	mesh->water = water;
	if (!water)
		return hawser__no_memory(report, "net");
	water->line = hawser__hold(&mesh->hold, elements, sizeof *water->line);
	water->dead = hawser__hold(&mesh->hold, nodes, sizeof *water->dead);
	water->load = hawser__hold(&mesh->hold, elements, sizeof *water->load);
	water->wet = hawser__hold(&mesh->hold, elements, sizeof *water->wet);
	water->mass = hawser__hold(&mesh->hold, elements, sizeof *water->mass);
	water->spring = hawser__hold(&mesh->hold, elements, sizeof *water->spring);
	water->slope = hawser__hold(&mesh->hold, elements, sizeof *water->slope);
	water->buoy = hawser__hold(&mesh->hold, (size_t)buoys + 1, sizeof *water->buoy);
	return mesh->hold.short_of_memory ? hawser__no_memory(report, "net") : HAWSER_OK;
}

static int is_buoy(const struct hawser_water_buoy *buoy)
{
	return buoy->volume > 0.0 || buoy->CdA > 0.0;
}

/* Those at nodes of bodies where no element ends. A body holds its nodes: their element is not asked
 * for. */
static void list_bare(struct hawser__mesh_water *water, const struct hawser_net *net)
{
	for (int node = 0; node < net->nodes; node++) {
		int known = !net->node[node].body || !is_buoy(&net->node[node].buoy);

		for (int i = 0; i < water->buoys && !known; i++)
			known = water->buoy[i].node == node;
		if (!known)
			water->buoy[water->buoys++] = (struct hawser__mesh_buoy){
				.node = node, .of = &net->node[node].buoy};
	}
}

enum hawser_status hawser__water_open(struct hawser__mesh *mesh, const struct hawser_net *net,
                                      struct hawser_report *report)
{
	enum hawser_status status;
	int buoys = 0;

	if (!(net->water.density > 0.0))
		return HAWSER_OK;
	for (int i = 0; i < net->nodes; i++)
		buoys += is_buoy(&net->node[i].buoy);
	status = allocate(mesh, buoys, net->failures, report);
	if (status)
		return status;
	if (net->winds)
		status = hawser__wind_open(mesh, net, report);
	mesh->water->of = &net->water;
	mesh->water->part = 1.0;
	mesh->water->least = INFINITY;
	for (int e = 0; e < mesh->elements; e++) {
		const struct hawser_water_line *line = &net->cable[mesh->cable[e]].line;

		mesh->water->line[e] = line;
		if (line->diameter > 0.0)
			mesh->water->least = fmin(mesh->water->least, HAWSER__WATER_BAND*line->diameter);
	}
	for (int i = 0; i < net->nodes; i++)
		if (net->node[i].buoy.volume > 0.0)
			mesh->water->least = fmin(mesh->water->least, cbrt(net->node[i].buoy.volume));
	for (int k = 2*mesh->elements - 1; k >= 0; k--) {
		int node = mesh->end[k/2][k%2], known = 0;
		struct hawser__mesh_water *water = mesh->water;

		if (node >= net->nodes || !is_buoy(&net->node[node].buoy))
			continue;
		for (int i = 0; i < water->buoys; i++)
			known |= water->buoy[i].node == node;
		if (!known)
			water->buoy[water->buoys++] = (struct hawser__mesh_buoy){
				.node = node, .element = k/2, .end = k%2, .of = &net->node[node].buoy};
	}
	list_bare(mesh->water, net);
	return status;
}

/* The current at a height, and its derivative by that. */
static void current(struct hawser__water_past *past, double u_y[3],
                    const struct hawser__mesh_water *water, double y)
{
	hawser__water_current(past->r, u_y, water->of, y);
	past->height = y - water->of->surface;
	for (int k = 0; k < 3; k++) {
		past->u[k] = past->r[k] *= water->part;
		u_y[k] *= water->part;
	}
}

static void element(struct hawser__mesh *mesh, int e)
{
	struct hawser__mesh_water *water = mesh->water;
	const double *a = mesh->q[mesh->end[e][0]], *b = mesh->q[mesh->end[e][1]];
	const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
	struct hawser__water_past past[2] = {{.height = 0.0}};
	struct hawser__water_end end[2];
	double u_y[2][3];

	for (int i = 0; i < 2; i++)
		current(&past[i], u_y[i], water, i ? b[1] : a[1]);
	hawser__water_ends(end, mesh, e, d, past, 1);
	water->wet[e] = end[0].wet + end[1].wet;
	for (int i = 0; i < 2; i++) {
		memcpy(water->mass[e][i], end[i].mass, sizeof end[i].mass);
		memcpy(water->spring[e][i], end[i].spring, sizeof end[i].spring);
		for (int k = 0; k < 3; k++) {
			double *row = water->slope[e][3*i + k];

			water->load[e][i][k] = end[i].load[k];
			for (int j = 0; j < 3; j++) {
				row[j] = -end[i].by_d[k][j];
				row[3 + j] = end[i].by_d[k][j];
			}
			row[1] += end[i].by_y[0][k];
			row[4] += end[i].by_y[1][k];
			row[3*i + 1] += hawser__dot(end[i].by_r[k], u_y[i]);
		}
	}
}

static void buoy(struct hawser__mesh_buoy *buoy, const struct hawser__mesh *mesh)
{
	struct hawser__water_past past = {.height = 0.0};
	struct hawser__water_end end;
	double u_y[3];

	current(&past, u_y, mesh->water, mesh->q[buoy->node][1]);
	hawser__water_buoy(&end, mesh, buoy->of, &past);
	memcpy(buoy->mass, end.mass, sizeof end.mass);
	buoy->spring = end.spring[0];
	memset(buoy->slope, 0, sizeof buoy->slope);
	for (int k = 0; k < 3; k++) {
		buoy->load[k] = end.load[k];
		buoy->slope[k][1] = end.by_y[0][k] + hawser__dot(end.by_r[k], u_y);
	}
}

void hawser__water_load(struct hawser__mesh *mesh)
{
	struct hawser__mesh_water *water = mesh->water;

	memcpy(mesh->force, water->dead, (size_t)mesh->nodes*sizeof *mesh->force);
	for (int e = 0; e < mesh->elements; e++) {
		element(mesh, e);
		for (int i = 0; i < 2; i++)
			for (int k = 0; k < 3; k++)
				mesh->force[mesh->end[e][i]][k] += water->load[e][i][k];
	}
	for (int i = 0; i < water->buoys; i++) {
		buoy(&water->buoy[i], mesh);
		for (int k = 0; k < 3; k++)
			mesh->force[water->buoy[i].node][k] += water->buoy[i].load[k];
	}
}

void hawser__water_matrix(struct hawser__klu *klu, const struct hawser__mesh *mesh)
{
	const struct hawser__mesh_water *water = mesh->water;

	for (int e = 0; e < mesh->elements; e++)
		hawser__klu_ends(klu, e, (const double (*)[6])water->slope[e], -1.0);
	for (int i = 0; i < water->buoys; i++) {
		double block[3][3];

		if (mesh->rigid[water->buoy[i].node])
			continue;
		for (int k = 0; k < 9; k++)
			block[k/3][k%3] = -water->buoy[i].slope[k/3][k%3];
		hawser__klu_node(klu, water->buoy[i].element, water->buoy[i].end, (const double (*)[3])block);
	}
}

void hawser__water_spread(double (*force)[3], const struct hawser__mesh *mesh, const double (*u)[3])
{
	const struct hawser__mesh_water *water = mesh->water;

	for (int k = 0; k < 36*mesh->elements; k++) {
		const int *end = mesh->end[k/36], row = k%36/6, column = k%6;

		force[end[row/3]][row%3] -= water->slope[k/36][row][column]*u[end[column/3]][column%3];
	}
	for (int i = 0; i < water->buoys; i++)
		for (int k = 0; k < 3; k++)
			force[water->buoy[i].node][k] -= hawser__dot(water->buoy[i].slope[k],
			                                             u[water->buoy[i].node]);
}

int hawser__water_mass(struct hawser__water_mass *at, const struct hawser__mesh *mesh, int j)
{
	const struct hawser__mesh_water *water = mesh->water;
	int buoy = j - 2*mesh->elements;

	if (!water || buoy >= water->buoys)
		return 0;
	if (buoy < 0)
		*at = (struct hawser__water_mass){mesh->end[j/2][j%2], j/2, j%2,
		                                  (const double (*)[3])water->mass[j/2][j%2]};
	else
		*at = (struct hawser__water_mass){water->buoy[buoy].node, water->buoy[buoy].element,
		                                  water->buoy[buoy].end,
		                                  (const double (*)[3])water->buoy[buoy].mass};
	return 1;
}

int hawser__water_spring(struct hawser__water_spring *at, const struct hawser__mesh *mesh, int j)
{
	const struct hawser__mesh_water *water = mesh->water;
	int buoy = j - mesh->elements;

	if (!water || buoy >= water->buoys)
		return 0;
	*at = (struct hawser__water_spring){.element = buoy < 0 ? j : water->buoy[buoy].element};
	for (int i = 0; i < 2; i++)
		at->node[i] = buoy < 0 ? mesh->end[j][i] : water->buoy[buoy].node;
	for (int i = 0; i < 4; i++)
		at->k[i/2][i%2] = buoy < 0 ? -water->spring[j][i/2][i%2] : 0.0;
	if (buoy >= 0)
		at->k[water->buoy[buoy].end][water->buoy[buoy].end] = -water->buoy[buoy].spring;
	return 1;
}

int hawser__water_flows(const struct hawser__mesh *mesh)
{
	const struct hawser_water *of = mesh->water ? mesh->water->of : NULL;

	for (int i = 0; of && i < of->levels; i++)
		if (hawser__dot(of->current[i].u, of->current[i].u) > 0.0)
			return 1;
	return 0;
}
