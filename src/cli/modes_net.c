/* cli/modes_net.c - hawser modes of a scene of kind `net`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "cli/modes_net.h"
#include "core/report.h"

struct result {
	const struct cli_common *common;
	struct hawser_net net;
	struct hawser_net_modes modes;
	int shapes;
};

static void fill_row(struct hawser__table *row, const void *of, size_t j)
{
	const struct hawser_net_modes *modes = &((const struct result *)of)->modes;

	hawser__table_number(row, (double)j + 1.0);
	hawser__table_number(row, modes->omega[j]);
	hawser__table_number(row, modes->omega[j]/(2.0*M_PI));
	hawser__table_number(row, modes->mass[j]);
	for (int k = 0; k < 3; k++)
		hawser__table_number(row, modes->share[j][k]);
	hawser__table_number(row, modes->residual[j]);
}

static void table(struct hawser__table *table, const void *of)
{
	static const char *const column[] = {"index", "omega_rad_s", "frequency_Hz", "mass_kg", "share_x",
	                                     "share_y", "share_z", "residual"};
	const struct result *result = of;

	cli_echo_table(table, result->common, "modes", NULL, "subspace iteration");
	hawser__table_comment(table, "%d unknowns; mass: of a shape whose largest displacement is 1",
	                      result->modes.unknowns);
	for (size_t i = 0; i < sizeof column/sizeof *column; i++)
		hawser__table_column(table, "%s", column[i]);
	hawser__table_rows(table, (size_t)result->modes.n, fill_row, result);
}

/* Arrays along the cables: S and, of mode j, the displacements. */
static void along(struct hawser__json *json, json_t *into, const struct result *result, int j)
{
	const struct hawser_net_modes *modes = &result->modes;
	json_t *list = NULL;

	for (int p = 0; p < modes->points; p++) {
		if (p == 0 || modes->cable[p] != modes->cable[p - 1])
			list = hawser__json_array(json, into, result->net.cable[modes->cable[p]].name);
		if (j < 0)
			hawser__json_number(json, list, NULL, modes->S[p]);
		else
			hawser__json_numbers(json, list, NULL,
			                     modes->point[(size_t)j*(size_t)modes->points + (size_t)p], 3, 1.0);
	}
}

static void json(struct hawser__json *json, const void *of)
{
	const struct result *result = of;
	const struct hawser_net_modes *modes = &result->modes;
	json_t *list, *stats;

	cli_echo_json(json, result->common, "modes", NULL);
	hawser__json_text(json, json->root, "method", "subspace iteration");
	if (result->shapes)
		along(json, hawser__json_object(json, json->root, "S"), result, -1);
	list = hawser__json_array(json, json->root, "modes");
	for (int j = 0; j < modes->n; j++) {
		json_t *one = hawser__json_object(json, list, NULL), *nodes;

		hawser__json_integer(json, one, "index", j + 1);
		hawser__json_number(json, one, "omega", modes->omega[j]);
		hawser__json_number(json, one, "frequency", modes->omega[j]/(2.0*M_PI));
		hawser__json_number(json, one, "mass", modes->mass[j]);
		hawser__json_numbers(json, one, "share", modes->share[j], 3, 1.0);
		hawser__json_number(json, one, "residual", modes->residual[j]);
		nodes = hawser__json_object(json, one, "nodes");
		for (int i = 0; i < modes->nodes; i++)
			hawser__json_numbers(json, nodes, result->net.node[i].name,
			                     modes->shape[j*modes->nodes + i], 3, 1.0);
		if (result->shapes)
			along(json, hawser__json_object(json, one, "shape"), result, j);
	}
	stats = cli_stats_json(json, result->common);
	hawser__json_integer(json, stats, "unknowns", modes->unknowns);
	hawser__json_integer(json, stats, "iterations", modes->iterations);
}

static const struct cli_showing showing = {.table = table, .json = json};

enum hawser_status cli_modes_net(const struct cli_common *common, int n, int shapes,
                                 struct hawser_report *report)
{
	struct result *result = calloc(1, sizeof *result);
	enum hawser_status status;

	if (!result)
		return hawser__no_memory(report, "modes");
	result->common = common;
	result->shapes = shapes;
	if (common->plot)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes", "modes of nets have no picture: "
		                      "use --json with --shapes");
	else
		status = hawser_net_open(&result->net, common->input, common->set, (size_t)common->sets,
		                         report);
	if (!status)
		status = hawser_net_modes_solve(&result->modes, &result->net, n > 0 ? n : 0, report);
	if (!status)
		status = cli_show(common, &showing, result, report);
	hawser_net_modes_clear(&result->modes);
	hawser_net_clear(&result->net);
	free(result);
	return status;
}
