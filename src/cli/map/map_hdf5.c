/* cli/map/map_hdf5.c - a map as HDF5: the tables of points and boundaries, and what map they are of.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "cli/frame/hdf5.h"
#include "cli/map/map_part.h"
#include "cli/report/report.h"
#include "cli/frame/view.h"
#include "core/report.h"
#include "output/report/sha256.h"

/* Of the scene's file; "" if it cannot be read again, as standard input. */
static void digest_of(char digest[HAWSER__SHA256_SIZE], const struct cli_common *common)
{
	const struct hawser_document *document;

	*digest = '\0';
	if (!common->library && !cli_document(&document, common, NULL))
		hawser__sha256(digest, document->text, document->length);
}

static void points_of(struct hawser__table *points, const struct cli_map_result *result)
{
	struct cli_head head = cli_map_showing.head(result);

	cli_echo_table(points, result->common, head.command, head.scene, head.method);
	cli_map_showing.comments(points, result);
	hawser__fields_table(points, cli_map_showing.rows, result, &head.view);
}

enum hawser_status cli_map_hdf5(const char *path, const struct cli_map_result *result,
                                const struct hawser__table *boundaries,
                                struct hawser_report *report)
{
	const struct hawser_map_options *o = &result->options;
	char digest[HAWSER__SHA256_SIZE],
		*command = cli_report_command("map", result->common->words, result->common->word);
	const struct cli_hdf5_fact fact[] = {
		{"version", hawser_version(), 0.0}, {"command", command, 0.0},
		{"scene", result->common->input, 0.0}, {"scene.sha256", digest, 0.0},
		{"quantity", result->quantity->name, 0.0}, {"unit", cli_map_value_unit(result), 0.0},
		{"x.key", result->key[0], 0.0}, {"x.unit", result->unit[0], 0.0},
		{"x.from", NULL, o->from[0]}, {"x.to", NULL, o->to[0]}, {"x.points", NULL, o->points[0]},
		{"y.key", result->key[1], 0.0}, {"y.unit", result->unit[1], 0.0},
		{"y.from", NULL, o->from[1]}, {"y.to", NULL, o->to[1]}, {"y.points", NULL, o->points[1]},
		{"Omega", NULL, result->omega}};
	struct hawser__table points = {0};
	const struct cli_hdf5_table tables[] = {{"points", &points, cli_map_listing[0].field},
	                                        {"boundaries", boundaries, cli_map_listing[1].field}};
	enum hawser_status status;

	if (!command)
		return hawser__no_memory(report, "map");
	digest_of(digest, result->common);
	points_of(&points, result);
	/* without Omega, the last, where the frequency is an axis or there is none */
	status = cli_hdf5_write(path, tables, 2, fact,
	                        (int)(sizeof fact/sizeof *fact) - !(result->omega > 0.0), report);
	hawser__table_clear(&points);
	free(command);
	if (!status)
		cli_written(path);
	return status;
}
