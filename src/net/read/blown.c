/* net/read/blown.c - `wind` of a net's scene, and the sections of its cables. The air is a water
 * without buoyancy, everywhere, that flows past sections with drag and lift.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <hawser/scene.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/read/read.h"
#include "scene/tree.h"

/* The flow over the height. */
static enum hawser_status blow(struct hawser_water *air, const struct hawser_wind *wind,
                               struct hawser_report *report)
{
	double per = wind->speed/hawser__norm(wind->direction);

	air->air = 1;
	air->density = wind->density;
	air->surface = INFINITY;
	air->levels = wind->profiles ? wind->profiles : 1;
	air->current = calloc((size_t)air->levels, sizeof *air->current);
	if (!air->current)
		return hawser__no_memory(report, "scene");
	for (int i = 0; i < air->levels; i++) {
		air->current[i].y = wind->profiles ? wind->profile[i][0] : 0.0;
		for (int k = 0; k < 3; k++)
			air->current[i].u[k] = per*wind->direction[k]*(wind->profiles ? wind->profile[i][1] : 1.0);
	}
	return HAWSER_OK;
}

enum hawser_status hawser__net_wind(struct hawser__reader *reader, struct hawser_net *net,
                                    const struct hawser__tree *tree)
{
	struct hawser_wind *wind = net->wind = calloc((size_t)net->cables + 1, sizeof *net->wind);
	enum hawser_status status;

	if (!wind)
		return hawser__no_memory(reader->report, "scene");
	net->winds = 1;
	if (net->water.density > 0.0)
		return hawser__reader_fail(reader, &tree->at, "wind contradicts water: a net is in the air "
		                           "or in the water, remove one of them");
	if (hawser__tree_find(tree, "wake"))
		return hawser__reader_fail(reader, &hawser__tree_find(tree, "wake")->at,
		                           "nets have no wind.wake: remove it, or describe the cable that "
		                           "sheds vortices as a span, with its tension");
	status = hawser__tree_fill(reader, wind, tree, "wind", "net.wind");
	if (!status)
		status = hawser__wind_lists(reader, wind, tree, "wind", "net.wind");
	if (!status && hawser__norm(wind->direction) == 0.0)
		return hawser__reader_fail(reader, &hawser__tree_find(tree, "direction")->at,
		                           "wind.direction is [0, 0, 0]: give a direction, such as [0, 0, 1] "
		                           "along z");
	if (!status && wind->diameter > 0.0)
		status = hawser__wind_check(reader, wind, tree, "wind");
	wind->present = 1;
	return status ? status : blow(&net->water, wind, reader->report);
}

enum hawser_status hawser__net_section(struct hawser__reader *reader, struct hawser_net *net, int cable,
                                       const struct hawser__tree *tree, const char *what)
{
	const struct hawser__tree *own = hawser__tree_find(tree, "wind");
	char path[HAWSER_NET_NAME + 16];
	struct hawser_wind *wind;
	enum hawser_status status;

	if (net->winds && net->wind->diameter > 0.0)
		net->cable[cable].wind = net->wind;
	if (!own)
		return HAWSER_OK;
	if (!net->winds)
		return hawser__reader_fail(reader, &own->at, "%s has wind, and the scene has none: add wind: "
		                           "{speed: 8 m/s, density: 1.225 kg/m^3}", what);
	wind = &net->wind[net->winds++];
	*wind = *net->wind;
	snprintf(path, sizeof path, "cables.%s.wind", net->cable[cable].name);
	status = hawser__tree_fill(reader, wind, own, path, "net.cables[].wind");
	if (!status)
		status = hawser__wind_lists(reader, wind, own, path, "net.cables[].wind");
	if (!status && wind->diameter > 0.0)
		status = hawser__wind_check(reader, wind, own, path);
	net->cable[cable].wind = wind->diameter > 0.0 ? wind : NULL;
	return status;
}
