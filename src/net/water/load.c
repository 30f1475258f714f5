/* net/water/load.c - loads of still water and of a current on a mesh at rest, and their
 * derivatives.
 *
 * d, t   vector along an element, its direction
 * wet    parts of an element in the water, at its ends (water/water.h)
 *
 * An end of an element has the buoyancy and the drag of what of its half is wet, with the current
 * at its place and the direction of the element.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include <hawser/drag.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/water/water.h"
#include "water/water.h"

/* Of the diameter: the height over which a line comes out of the water. With all of it a line that
 * ends at the surface would lack the drag of the last half. */
static const double BAND = 0.01;

static enum hawser_status allocate(struct hawser__mesh *mesh, int buoys, struct hawser_report *report)
{
	size_t elements = (size_t)mesh->elements;
	struct hawser__mesh_water *water = hawser__hold(&mesh->hold, 1, sizeof *water);

	mesh->water = water;
	if (!water)
		return hawser__no_memory(report, "net");
	water->line = hawser__hold(&mesh->hold, elements, sizeof *water->line);
	water->dead = hawser__hold(&mesh->hold, (size_t)mesh->nodes, sizeof *water->dead);
	water->load = hawser__hold(&mesh->hold, elements, sizeof *water->load);
	water->slope = hawser__hold(&mesh->hold, elements, sizeof *water->slope);
	water->buoy = hawser__hold(&mesh->hold, (size_t)buoys + 1, sizeof *water->buoy);
	return mesh->hold.short_of_memory ? hawser__no_memory(report, "net") : HAWSER_OK;
}

static int is_buoy(const struct hawser_water_buoy *buoy)
{
	return buoy->volume > 0.0 || buoy->CdA > 0.0;
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
	status = allocate(mesh, buoys, report);
	if (status)
		return status;
	mesh->water->of = &net->water;
	mesh->water->part = 1.0;
	for (int e = 0; e < mesh->elements; e++)
		mesh->water->line[e] = &net->cable[mesh->cable[e]].line;
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
	return HAWSER_OK;
}

/* The current at a height, and its derivative. */
static void current(double u[3], double u_y[3], const struct hawser__mesh_water *water, double y)
{
	hawser__water_current(u, u_y, water->of, y);
	for (int k = 0; k < 3; k++) {
		u[k] *= water->part;
		u_y[k] *= water->part;
	}
}

static void element(struct hawser__mesh *mesh, int e)
{
	struct hawser__mesh_water *water = mesh->water;
	const struct hawser_water_line *line = water->line[e];
	const struct hawser_drag drag = {water->of->density, 0.5*line->diameter, line->normal,
	                                 line->tangential};
	const double *x[2] = {mesh->q[mesh->end[e][0]], mesh->q[mesh->end[e][1]]};
	const double lift = water->of->density*M_PI*drag.radius*drag.radius*mesh->g, L = mesh->length0[e];
	double d[3] = {x[1][0] - x[0][0], x[1][1] - x[0][1], x[1][2] - x[0][2]};
	struct hawser__wet wet;

	memset(water->load[e], 0, sizeof water->load[e]);
	memset(water->slope[e], 0, sizeof water->slope[e]);
	if (!(line->diameter > 0.0))
		return;
	hawser__wet_line(&wet, water->of->surface, fmax(BAND*line->diameter, water->band),
	                 (const double[2]){x[0][1], x[1][1]});
	for (int i = 0; i < 2; i++) {
		double u[3], u_y[3], f[3] = {0.0}, f_u[3][3] = {{0.0}}, f_x[3][3] = {{0.0}};

		current(u, u_y, water, x[i][1]);
		if (hawser__dot(d, d) > 0.0)
			hawser_drag_line(f, f_u, f_x, &drag, u, d);
		f[1] += lift;
		for (int k = 0; k < 3; k++) {
			double *row = water->slope[e][3*i + k];

			water->load[e][i][k] = L*wet.part[i]*f[k];
			for (int j = 0; j < 3; j++) {
				row[j] -= L*wet.part[i]*f_x[k][j];
				row[3 + j] += L*wet.part[i]*f_x[k][j];
			}
			row[1] += L*wet.by[i][0]*f[k];
			row[4] += L*wet.by[i][1]*f[k];
			row[3*i + 1] += L*wet.part[i]*hawser__dot(f_u[k], u_y);
		}
	}
}

static void buoy(struct hawser__mesh_buoy *buoy, const struct hawser__mesh *mesh)
{
	const struct hawser__mesh_water *water = mesh->water;
	const double y = mesh->q[buoy->node][1], density = water->of->density;
	double by, wet = hawser__wet_sphere(&by, water->of->surface, buoy->of->volume, y);
	double part = buoy->of->volume > 0.0 ? wet/buoy->of->volume : y < water->of->surface;
	double slope = buoy->of->volume > 0.0 ? by/buoy->of->volume : 0.0;
	double u[3], u_y[3], f[3], f_u[3][3];

	current(u, u_y, water, y);
	hawser_drag_body(f, f_u, 0.5*density*buoy->of->CdA, u);
	memset(buoy->slope, 0, sizeof buoy->slope);
	for (int k = 0; k < 3; k++) {
		buoy->load[k] = part*f[k] + (k == 1 ? density*wet*mesh->g : 0.0);
		buoy->slope[k][1] = part*hawser__dot(f_u[k], u_y) + slope*f[k] +
		                    (k == 1 ? density*by*mesh->g : 0.0);
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

int hawser__water_flows(const struct hawser__mesh *mesh)
{
	const struct hawser_water *of = mesh->water ? mesh->water->of : NULL;

	for (int i = 0; of && i < of->levels; i++)
		if (hawser__dot(of->current[i].u, of->current[i].u) > 0.0)
			return 1;
	return 0;
}
