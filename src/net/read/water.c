/* net/read/water.c - `water` and `buoys` of a net's scene, and what of cables needs them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/motion/motion.h"
#include "net/read/read.h"

#define ROUND_OFF 1e-9 /* of the depth, by which a node may be below the bed; chosen */

/* Rows [y, ux, uy, uz], in the order of the heights. */
static enum hawser_status table(struct hawser__reader *reader, struct hawser_water *water,
                                const struct hawser__tree *tree)
{
	enum hawser_status status = HAWSER_OK;

	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next) {
		struct hawser_water_level *level = &water->current[water->levels++];
		const struct hawser__tree *number = one->child;

		if (one->kind != HAWSER__SEQUENCE || one->children != 4)
			return hawser__reader_fail(reader, &one->at, "water.current.table: a row must be [y, ux, "
			                           "uy, uz], a height and the velocity there, such as [-20 m, 1 "
			                           "m/s, 0, 0]");
		for (int k = 0; k < 4 && !status; k++, number = number->next)
			status = hawser__tree_number(reader, k ? &level->u[k - 1] : &level->y, number,
			                             "water.current.table", k ? "m/s" : "m", HAWSER__TREE_ANY);
		if (!status && water->levels > 1 && level->y <= level[-1].y)
			status = hawser__reader_fail(reader, &one->at, "water.current.table: the height %g m is "
			                             "not above %g m, that of the row before: sort the rows "
			                             "upwards", level->y, level[-1].y);
	}
	return status;
}

static enum hawser_status over_time(struct hawser__reader *reader, struct hawser_water *water,
                                    const struct hawser__tree *tree)
{
	struct hawser__support_table table = {0};
	struct hawser_report why;
	const char *path = "";
	double rate[3];
	enum hawser_status status = hawser__tree_text(reader, &path, tree, "water.current.file");

	if (status)
		return status;
	if (hawser__support_read(&table, path, &why))
		return hawser__reader_fail(reader, &tree->at, "water.current.file: %s", why.message);
	water->current = calloc(1, sizeof *water->current);
	water->file = strdup(path);
	if (!water->current || !water->file) {
		hawser__support_clear(&table);
		return hawser__no_memory(reader->report, "scene");
	}
	water->levels = 1;
	hawser__support_within(water->current->u, rate, &table, 0.0);
	hawser__support_clear(&table);
	return HAWSER_OK;
}

static enum hawser_status waves(struct hawser__reader *reader, struct hawser_water *water, double g,
                                const struct hawser__tree *tree)
{
	struct hawser_report why;
	enum hawser_status status;

	if (!tree)
		return HAWSER_OK;
	if (hawser__tree_find(tree, "jonswap") &&
	    (hawser__tree_find(tree, "height") || hawser__tree_find(tree, "period")))
		return hawser__reader_fail(reader, &tree->at, "water.waves: height and period are of a regular "
		                           "wave, jonswap is a sea: give one of them");
	if (g == 0.0)
		return hawser__reader_fail(reader, &tree->at, "water.waves: without gravity (g: 0) there are "
		                           "no waves: give g, such as 9.81 m/s^2, or leave waves out");
	water->given.depth = water->depth;
	water->given.surface = water->surface;
	water->given.g = g;
	status = hawser_waves_make(&water->waves, &water->given, &why);
	return status == HAWSER_ERR_ARGUMENT
		? hawser__reader_fail(reader, &tree->at, "water.waves: %s", why.message)
		: status ? hawser__no_memory(reader->report, "scene") : HAWSER_OK;
}

enum hawser_status hawser__water_read(struct hawser__reader *reader, struct hawser_water *water,
                                      double g, const struct hawser__tree *tree)
{
	const struct hawser__tree *current = hawser__tree_find(tree, "current"), *rows;
	enum hawser_status status = waves(reader, water, g, hawser__tree_find(tree, "waves"));

	if (status || !current)
		return status;
	rows = hawser__tree_find(current, "table");
	if (!rows && hawser__tree_find(current, "file"))
		return over_time(reader, water, hawser__tree_find(current, "file"));
	if (current->kind == HAWSER__MAPPING && (!rows || rows->kind != HAWSER__SEQUENCE || !rows->child))
		return hawser__reader_fail(reader, &current->at, "water.current must be a velocity, such as "
		                           "[0.8 m/s, 0, 0.6 m/s], or {table: [[-200 m, 0.1 m/s, 0, 0], [0, "
		                           "1 m/s, 0, 0]]}, heights with velocities");
	water->current = calloc(rows ? (size_t)rows->children : 1, sizeof *water->current);
	if (!water->current)
		return hawser__no_memory(reader->report, "scene");
	if (rows)
		return table(reader, water, rows);
	status = hawser__tree_value(reader, water->current->u, current, "water.current",
	                            "net.water.current");
	water->levels = !status;
	return status;
}

enum hawser_status hawser__net_water(struct hawser__reader *reader, struct hawser_net *net,
                                     const struct hawser__tree *tree)
{
	return hawser__water_read(reader, &net->water, net->g, tree);
}

enum hawser_status hawser__net_buoys(struct hawser__reader *reader, struct hawser_net *net,
                                     const struct hawser__tree *tree)
{
	enum hawser_status status = hawser__net_of_nodes(reader, net, tree, "net.buoys",
	                                                 "{J: {mass: 3 t, volume: 8 m^3}}");

	if (!status && !(net->water.density > 0.0))
		return hawser__reader_fail(reader, &tree->at, "buoys are in water, and the scene has none: add "
		                           "water: {density: 1025 kg/m^3}, or give masses");
	for (int i = 0; i < net->nodes; i++)
		net->node[i].mass += net->node[i].buoy.mass;
	return status;
}

enum hawser_status hawser__net_wet(struct hawser__reader *reader, const struct hawser_water *water,
                                   const struct hawser__tree *tree, const char *what)
{
	static const char *const of_water[] = {"drag", "added_mass"};

	if (water->density > 0.0 && !water->air && !hawser__tree_find(tree, "diameter"))
		return hawser__reader_fail(reader, &tree->at, "%s has no diameter, which its buoyancy and its "
		                           "drag in the water need: add, for example, diameter: 0.1 m", what);
	if (water->density > 0.0 && !water->air)
		return HAWSER_OK;
	for (size_t i = 0; i < sizeof of_water/sizeof *of_water; i++)
		if (hawser__tree_find(tree, of_water[i]))
			return hawser__reader_fail(reader, &tree->at, "%s has %s, and the scene has no water: add "
			                           "water: {density: 1025 kg/m^3}", what, of_water[i]);
	return HAWSER_OK;
}

enum hawser_status hawser__water_bed(struct hawser__reader *reader, const struct hawser_water *water,
                                     double y, const struct hawser__tree *tree, const char *what)
{
	double bed = water->surface - water->depth;

	if (!(water->density > 0.0 && water->depth > 0.0 && y < bed - ROUND_OFF*water->depth))
		return HAWSER_OK;
	return hawser__reader_fail(reader, &tree->at, "%s is at y = %.9g m, below the bed of the water, "
	                           "surface - depth = %.9g m: give water.depth at its deepest place, or "
	                           "move %s", what, y, bed, what);
}

enum hawser_status hawser__net_bed(struct hawser__reader *reader, const struct hawser_net *net,
                                   const struct hawser__tree *nodes)
{
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < net->nodes && !status; i++) {
		const struct hawser_net_node *node = &net->node[i];
		const struct hawser__tree *at = hawser__tree_find(nodes, node->name);
		char what[sizeof node->name + 8];

		snprintf(what, sizeof what, "node %s", node->name);
		if (node->placed)
			status = hawser__water_bed(reader, &net->water, node->x[1], at ? at : nodes, what);
	}
	return status;
}
