/* net/water/wind.c - the wind on the ends of an element: half of its length each, with the flow and the
 * velocity there and the direction of the element.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/water/water.h"
#include "statics/wind.h"

enum hawser_status hawser__wind_open(struct hawser__mesh *mesh, const struct hawser_net *net,
                                     struct hawser_report *report)
{
	struct hawser__section *section = hawser__hold(&mesh->hold, (size_t)net->winds, sizeof *section);

	mesh->water->section = hawser__hold(&mesh->hold, (size_t)mesh->elements,
	                                    sizeof *mesh->water->section);
	if (!section || !mesh->water->section)
		return hawser__no_memory(report, "net");
	for (int i = 0; i < net->winds; i++)
		hawser__section_make(&section[i], &net->wind[i]);
	for (int e = 0; e < mesh->elements; e++) {
		const struct hawser_wind *wind = net->cable[mesh->cable[e]].wind;

		mesh->water->section[e] = wind ? &section[wind - net->wind] : NULL;
	}
	return HAWSER_OK;
}

void hawser__wind_ends(struct hawser__water_end end[2], const struct hawser__mesh *mesh, int e,
                       const double d[3], const struct hawser__water_past past[2], int slopes)
{
	const struct hawser__section *section = mesh->water->section[e];
	const double half = 0.5*hawser__mesh_length(mesh, e), l = hawser__norm(d), inverse = 1.0/l;
	const double t[3] = {d[0]*inverse, d[1]*inverse, d[2]*inverse};

	memset(end, 0, 2*sizeof *end);
	for (int i = 0; i < 2 && section && l > 0.0; i++) {
		hawser__section_line(end[i].drag, slopes ? end[i].by_r : NULL, slopes ? end[i].by_d : NULL,
		                     section, past[i].u, past[i].r, t, inverse);
		for (int k = 0; k < 3; k++)
			end[i].load[k] = end[i].drag[k] *= half;
		for (int k = 0; k < 9; k++) {
			end[i].by_r[k/3][k%3] *= half;
			end[i].by_d[k/3][k%3] *= half;
		}
	}
}
