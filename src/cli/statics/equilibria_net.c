/* cli/statics/equilibria_net.c - hawser statics --equilibria: the equilibria of a net of bars.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <hawser/net_equilibria.h>

#include "cli/frame/mesh_net.h"
#include "cli/statics/statics_net.h"
#include "output/structures/plot_equilibria.h"

struct result {
	const struct cli_common *common;
	struct hawser_net net;
	struct hawser_net_equilibria found;
};

static void comments(struct hawser__table *table, const void *of)
{
	const struct hawser_net_equilibria *found = &((const struct result *)of)->found;

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
}

/* The node that is not held with numbers k to k + 2 of a row. */
static int node_of(const struct hawser_net *net, int k)
{
	int node = 0;

	for (k /= 3; k > 0 || net->node[node].support; node++)
		k -= !net->node[node].support;
	return node;
}

static int free_count(const void *net)
{
	const struct hawser_net *of = net;
	int count = 0;

	for (int i = 0; i < of->nodes; i++)
		count += 3*!of->node[i].support;
	return count;
}

static void free_name(char *text, size_t size, const void *net, int k)
{
	const struct hawser_net *of = net;

	snprintf(text, size, "%s_%c", of->node[node_of(of, k)].name, "xyz"[k % 3]);
}

static double free_place(const void *net, const void *parent, size_t index, int k)
{
	return ((const struct result *)parent)->found.list[index].x[node_of(net, k)][k % 3];
}
static const struct hawser__vector free_nodes = {
	.shown = "NODE_AXIS", .count = free_count, .name = free_name, .number = free_place};

#define NEWTON .unit = HAWSER__NEWTON /* a force */
#define OF(member) HAWSER__AT(struct hawser_net_equilibrium, member)
const struct hawser__field cli_equilibria_net_field[] = {
	{NULL, "index", "from 1, by energy", .kind = HAWSER__INDEX},
	{"energy", "energy", "strain energy minus loads times places", OF(energy), .unit = HAWSER__J},
	{"unstable", "unstable", "number of negative eigenvalues; 0: stable", OF(unstable)},
	{"compressed", "compressed", "number of bars under compression", OF(compressed)},
	{"T_min", "T_min", "least force in a bar; negative: compression", OF(T_min), NEWTON},
	{"T_max", "T_max", "largest force in a bar", OF(T_max), NEWTON},
	{"stiffness", "stiffness", "least eigenvalue of the tangent stiffness", OF(stiffness),
	 .unit = HAWSER__NEWTON_M},
	{"residual", "residual", "largest force that is not balanced", OF(residual), NEWTON},
	{NULL, "", "place of each node that is not held", HAWSER__VECTOR_OF(free_nodes),
	 .unit = HAWSER__METRE},
	{"nodes", NULL, "place of each node, by name",
	 CLI_NODES_AT(struct hawser_net_equilibrium, x, cli_nodes), .unit = HAWSER__METRE},
	HAWSER__END,
};
#undef OF
static const struct hawser__list found_list =
	HAWSER__STORED_ROWS(struct result, found.list, found.count, cli_equilibria_net_field);

#define OF(member) HAWSER__AT(struct result, found.member)
const struct hawser__field cli_equilibria_net_member[] = {
	{"bars", NULL, "in place of the elements of cables", OF(bars)},
	{"unknowns", NULL, "of the mesh", OF(unknowns)},
	{"starts", NULL, "random places from which Newton's method began", OF(starts)},
	{"last", NULL, "number of the start, from 1, that found the last new one", OF(last)},
	{"failed", NULL, "starts without convergence", OF(failed)},
	{"degenerate", NULL, "starts that ended where the tangent stiffness is singular", OF(degenerate)},
	{"equilibria", NULL, "by energy", HAWSER__OBJECTS_OF(found_list)},
	HAWSER__END,
};
#undef OF

static struct cli_head head(const void *of)
{
	const struct result *result = of;

	return cli_si_head(result->common, "statics", "equilibria", &result->net, 0);
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct result *result = of;

	return hawser__plot_equilibria(path, &result->net, &result->found, report);
}

static const struct cli_showing showing = {.head = head, .comments = comments, .rows = &found_list,
                                           .fields = cli_equilibria_net_member, .draw = draw};

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
