/* cli/statics/equilibria_net.c - hawser statics --equilibria: the equilibria of a net of bars.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/net_equilibria.h>

#include "cli/frame/mesh_net.h"
#include "cli/statics/statics_kinds.h"
#include "output/drawing/figure.h"

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

static int kind_of(const struct hawser_net_equilibrium *one)
{
	return one->compressed == 0 ? 0 : one->unstable == 0 ? 1 : 2;
}

static void put_cables(struct hawser__figure *figure, const struct hawser_net *net,
                       const struct hawser_net_equilibrium *one)
{
	for (int c = 0; c < net->cables; c++) {
		const double *a = one->x[net->cable[c].from], *b = one->x[net->cable[c].to];

		hawser__figure_put(figure, a[0], a[1]);
		hawser__figure_put(figure, b[0], b[1]);
		hawser__figure_gap(figure);
	}
}

/* Stable ones are solid, unstable ones dashed; that of the cables, without compression, is wide. */
static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct hawser_net *net = &((const struct result *)of)->net;
	const struct hawser_net_equilibria *found = &((const struct result *)of)->found;
	static const struct {
		const char *title, *style;
	} kind[] = {{"without compression, as cables", "lw 3 lc rgb '#4575B4'"},
	            {"compressed, stable", "lw 1.5 lc rgb '#D73027'"},
	            {"compressed, unstable", "lw 0.8 lc rgb '#FC8D59' " HAWSER__UNSTABLE_DASH}};
	const double width = 16.0, height = 9.5; /* cm */
	const struct hawser__axis x = hawser__axis_of("{/:Italic x}", "m", 0.0);
	const struct hawser__axis y = hawser__axis_of("{/:Italic y}", "m", 0.0);
	struct hawser__panel_frame at = {0.13, 0.96, HAWSER__LEGEND_CM/height, 0.96, .x = {&x, .tics = 8},
	                                 .y = {&y, .tics = 6}};
	struct hawser__box box = {.any = 0};
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, width, height, report);

	if (status)
		return status;
	for (int i = 0; i < found->count; i++)
		for (int n = 0; n < net->nodes; n++)
			hawser__box_add(&box, found->list[i].x[n], 2);
	for (int n = 0; n < net->nodes; n++)
		hawser__box_add(&box, net->node[n].x, net->node[n].support ? 2 : 0);
	hawser__panel_even(&at, &box, 1, (at.right - at.left)*width, (at.top - at.bottom)*height);
	hawser__figure_panel(&figure, &at);
	for (int k = 2; k >= 0; k--) {
		for (int i = 0; i < found->count; i++)
			if (kind_of(&found->list[i]) == k)
				put_cables(&figure, net, &found->list[i]);
		hawser__figure_draw(&figure, NULL, "with linespoints pt 7 ps 0.4 %s", kind[k].style);
		hawser__figure_again(&figure, kind[k].title, "using (NaN):1 with lines %s", kind[k].style);
	}
	for (int i = 0; i < net->nodes; i++)
		if (net->node[i].support)
			hawser__figure_put(&figure, net->node[i].x[0], net->node[i].x[1]);
	hawser__figure_draw(&figure, "supports", "with points pt 9 ps 1.2 lc rgb 'black'");
	return hawser__figure_finish(&figure, report);
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
