/* rom/build/net_wind.c - the force of the wind on a net's model: a flow (modes/complex/wind.h) past the
 * middles of the elements.
 *
 *   w_ij     velocity of coordinate j along e_i there, m/s per unit of u_j': the shape over the unit of
 *            time
 *   F_j      L0 f.w_j time/(the energy's unit over the unit of time)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include <hawser/scene.h>

#include "core/report.h"
#include "core/vec3.h"
#include "modes/complex/wind.h"
#include "net/water/water.h"
#include "rom/build/net.h"
#include "rom/terms/drag.h"
#include "rom/terms/wind.h"
#include "water/water.h"

/* Point p of the flow: element e with its section, in axes e1 and e2. */
static void point(struct hawser__flow_points *flow, double axis[2][3], int p, int e,
                  const struct hawser__net_source *source)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;
	const struct hawser_net *net = source->net;
	const double *a = mesh->q[mesh->end[e][0]], *b = mesh->q[mesh->end[e][1]];
	double t[3], U[3], unused[3];

	hawser__mesh_direction(t, mesh, e);
	hawser__water_current(U, unused, &net->water, 0.5*(a[1] + b[1]));
	flow->speed[p] = hawser__flow_frame(axis, U, t);
	flow->weight[p] = hawser__mesh_length(mesh, e)*pow(source->time, 3.0)/hawser__net_unit(source);
	flow->at[p] = flow->section + (net->cable[mesh->cable[e]].wind - net->wind);
}

static int open_flow(struct hawser__flow_points *flow, const struct hawser__net_source *source, int n)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;
	size_t points = 0;

	for (int e = 0; e < mesh->elements; e++)
		points += mesh->water->section[e] != NULL;
	*flow = (struct hawser__flow_points){.n = n, .points = (int)points, .unit = 1.0/source->time};
	flow->weight = hawser__hold(&flow->hold, points + 1, sizeof(double));
	flow->speed = hawser__hold(&flow->hold, points + 1, sizeof(double));
	flow->at = hawser__hold(&flow->hold, points + 1, sizeof *flow->at);
	flow->section = hawser__hold(&flow->hold, (size_t)source->net->winds, sizeof *flow->section);
	flow->shape = hawser__hold(&flow->hold, points*2*(size_t)n + 1, sizeof(double));
	if (!flow->hold.short_of_memory)
		for (int i = 0; i < source->net->winds; i++)
			hawser__section_make(&flow->section[i], &source->net->wind[i]);
	return !flow->hold.short_of_memory;
}

static enum hawser_status make(struct hawser__flow_points *flow,
                               const struct hawser__net_source *source, int n,
                               struct hawser_report *report)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;
	double (*shape)[3] = calloc((size_t)mesh->nodes + 1, sizeof *shape);
	double (*axis)[2][3] = calloc((size_t)mesh->elements + 1, sizeof *axis);
	int good = open_flow(flow, source, n) && shape && axis;

	for (int e = 0, p = 0; e < mesh->elements && good; e++)
		if (mesh->water->section[e])
			point(flow, axis[e], p++, e, source);
	for (int j = 0; j < n && good; j++) {
		hawser__net_spread(shape, source, hawser__net_row(source, j));
		for (int e = 0, p = 0; e < mesh->elements; e++) {
			const double *a = shape[mesh->end[e][0]], *b = shape[mesh->end[e][1]];

			for (int i = 0; i < 2 && mesh->water->section[e]; i++)
				flow->shape[(2*p + i)*n + j] = 0.5*flow->unit*(hawser__dot(axis[e][i], a) +
				                                               hawser__dot(axis[e][i], b));
			p += mesh->water->section[e] != NULL;
		}
	}
	free(shape);
	free(axis);
	return good ? HAWSER_OK : hawser__no_memory(report, "net rom");
}

enum hawser_status hawser__net_wind_fill(struct hawser_rom *rom,
                                         const struct hawser__net_source *source, int whole,
                                         struct hawser_report *report)
{
	const struct hawser_net *net = source->net;
	struct hawser__flow_points flow = {.n = 0};
	enum hawser_status status;

	if (!net->winds)
		return HAWSER_OK;
	status = make(&flow, source, rom->n, report);
	if (!status)
		return whole && net->wind->form == HAWSER_WIND_EXACT
		       ? hawser__drag_take(rom, &flow, net->wind->speed, report)
		       : hawser__wind_take(rom, &flow, whole, report);
	hawser__flow_points_clear(&flow);
	return status;
}
