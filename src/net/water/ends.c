/* net/water/ends.c - loads of the water on the elements and buoys of a mesh.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "net/water/water.h"

static struct hawser__morison element(const struct hawser__mesh *mesh, int e)
{
	return (struct hawser__morison){mesh->water->line[e], mesh->water->of->density, mesh->g,
	                                hawser__mesh_length(mesh, e), mesh->water->band};
}

void hawser__water_ends(struct hawser__water_end end[2], const struct hawser__mesh *mesh, int e,
                        const double d[3], const struct hawser__water_past past[2], int slopes)
{
	const struct hawser__morison of = element(mesh, e);

	if (mesh->water->section)
		hawser__wind_ends(end, mesh, e, d, past, slopes);
	else
		hawser__morison_ends(end, &of, d, past, slopes);
}

double hawser__water_carried(const struct hawser__mesh *mesh, int e, const double d[3],
                             const double height[2], const double *const v[2])
{
	const struct hawser__morison of = element(mesh, e);

	return mesh->water->section ? 0.0 : hawser__morison_carried(&of, d, height, v);
}

void hawser__water_buoy(struct hawser__water_end *end, const struct hawser__mesh *mesh,
                        const struct hawser_water_buoy *buoy, const struct hawser__water_past *past)
{
	hawser__morison_buoy(end, buoy, mesh->water->of->density, mesh->g, mesh->water->band, past);
}
