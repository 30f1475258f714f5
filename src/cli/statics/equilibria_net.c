/* cli/statics/equilibria_net.c - hawser statics --equilibria: the equilibria of a net of bars.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <hawser/net_equilibria.h>

#include "cli/frame/mesh_net.h"
#include "cli/statics/statics_net.h"
#include "core/report.h"
#include "output/structures/plot_equilibria.h"

struct result {
	const struct cli_common *common;
	struct hawser_net net;
	struct hawser_net_equilibria found;
};

static void row(struct hawser__table *row, const void *of, size_t i)
{
	const struct result *result = of;
	const struct hawser_net_equilibrium *one = &result->found.list[i];

	hawser__table_number(row, (double)i + 1.0);
	hawser__table_number(row, one->energy);
	hawser__table_number(row, one->unstable);
	hawser__table_number(row, one->compressed);
	hawser__table_number(row, one->T_min);
	hawser__table_number(row, one->T_max);
	hawser__table_number(row, one->stiffness);
	hawser__table_number(row, one->residual);
	for (int j = 0; j < result->net.nodes; j++)
		for (int k = 0; k < 3 && !result->net.node[j].support; k++)
			hawser__table_number(row, one->x[j][k]);
}

static void table(struct hawser__table *table, const void *of)
{
	static const char *const name[] = {"index", "energy_J", "unstable", "compressed", "T_min_N",
	                                   "T_max_N", "stiffness_N_m", "residual_N"};
	const struct result *result = of;
	const struct hawser_net_equilibria *found = &result->found;

	cli_echo_table(table, result->common, "statics", NULL, "equilibria");
	hawser__table_comment(table, "bars in place of cables: %d bars that also carry compression, "
	                      "%d unknowns", found->bars, found->unknowns);
	hawser__table_comment(table, "%d equilibria from %d random starts, the last one by start %d; "
	                      "there may be more", found->count, found->starts, found->last);
	if (found->failed > 0)
		hawser__table_comment(table, "%d starts without convergence", found->failed);
	if (found->degenerate > 0)
		hawser__table_comment(table, "%d starts ended where the tangent stiffness is singular, so "
		                      "that the equilibrium is not isolated; these are left out",
		                      found->degenerate);
	hawser__table_comment(table,
	                      "cables have one equilibrium only: statics without --equilibria finds it");
	for (size_t i = 0; i < sizeof name/sizeof *name; i++)
		hawser__table_column(table, "%s", name[i]);
	for (int j = 0; j < result->net.nodes; j++)
		for (int k = 0; k < 3 && !result->net.node[j].support; k++)
			hawser__table_column(table, "%s_%c_m", result->net.node[j].name, "xyz"[k]);
	hawser__table_rows(table, (size_t)found->count, row, result);
}

static void json(struct hawser__json *json, const void *of)
{
	const struct result *result = of;
	const struct hawser_net_equilibria *found = &result->found;
	json_t *list;

	cli_echo_json(json, result->common, "statics", NULL);
	hawser__json_integer(json, json->root, "bars", found->bars);
	hawser__json_integer(json, json->root, "unknowns", found->unknowns);
	hawser__json_integer(json, json->root, "starts", found->starts);
	hawser__json_integer(json, json->root, "last", found->last);
	hawser__json_integer(json, json->root, "failed", found->failed);
	hawser__json_integer(json, json->root, "degenerate", found->degenerate);
	list = hawser__json_array(json, json->root, "equilibria");
	for (int i = 0; i < found->count; i++) {
		const struct hawser_net_equilibrium *one = &found->list[i];
		json_t *into = hawser__json_object(json, list, NULL), *nodes;

		hawser__json_number(json, into, "energy", one->energy);
		hawser__json_integer(json, into, "unstable", one->unstable);
		hawser__json_integer(json, into, "compressed", one->compressed);
		hawser__json_number(json, into, "T_min", one->T_min);
		hawser__json_number(json, into, "T_max", one->T_max);
		hawser__json_number(json, into, "stiffness", one->stiffness);
		hawser__json_number(json, into, "residual", one->residual);
		nodes = hawser__json_object(json, into, "nodes");
		for (int j = 0; j < result->net.nodes; j++)
			hawser__json_numbers(json, nodes, result->net.node[j].name, one->x[j], 3, 1.0);
	}
	cli_stats_json(json, result->common);
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct result *result = of;

	return hawser__plot_equilibria(path, &result->net, &result->found, report);
}

static const struct cli_showing showing = {.table = table, .json = json, .draw = draw};

enum hawser_status cli_equilibria_net(const struct cli_common *common, int starts,
                                      struct hawser_report *report)
{
	struct result result = {.common = common};
	struct hawser_net_equilibria_options options = {.starts = starts};
	enum hawser_status status = cli_mesh_open(&result.net, common, report);

	if (!status)
		status = hawser_net_equilibria_find(&result.found, &result.net, &options, report);
	if (!status)
		status = cli_show(common, &showing, &result, report);
	hawser_net_equilibria_clear(&result.found);
	hawser_net_clear(&result.net);
	return status;
}
