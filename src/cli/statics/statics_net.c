/* cli/statics/statics_net.c - hawser statics of a scene of kind `net`: positions, tensions, reactions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include <hawser/net.h>

#include "cli/statics/contacts_net.h"
#include "cli/frame/mesh_net.h"
#include "cli/statics/statics_net.h"
#include "core/report.h"
#include "output/structures/plot_net.h"

enum { SHOWN = 40 }; /* names and places in the comments */

struct result {
	const struct cli_common *common;
	int profile;
	struct hawser_net net;
	struct hawser_net_statics st;
	struct hawser_net_mesh_error error;
	char warning[CLI_WARNING_SIZE]; /* "": none */
};

/* A cable that is stretched to more than this part of its length has its length0, EA or ends
 * wrong, or a law that is not linear: 1.5, where a chord between supports is refused (hawser-
 * scene(5)). */
static const double FAR = 1.5;
/* Part of a given tension below which a cable does not have it: tensions of form finding are right to
 * 1e-6 then (net/statics/form.c). */
static const double LESS = 1.0 - 1e-4;

static void warn_of_strain(struct result *result)
{
	const struct hawser_net_member *most = NULL;
	int count = 0;

	for (int c = 0; c < result->st.cables; c++) {
		const struct hawser_net_member *m = &result->st.member[c];

		if (m->length <= FAR*m->length0)
			continue;
		count++;
		if (!most || m->length/m->length0 > most->length/most->length0)
			most = m;
	}
	if (most)
		snprintf(result->warning, sizeof result->warning,
		         "%d cable%s stretched by more than %.0f %%, most of all %s, by %.0f %%: the tension "
		         "EA (length/length0 - 1) holds for small strains; check length0, EA and its unit, and "
		         "the places of the nodes", count, count == 1 ? " is" : "s are", 100.0*(FAR - 1.0),
		         result->net.cable[most - result->st.member].name,
		         100.0*(most->length/most->length0 - 1.0));
}

/* Cables of given tension whose ends came to one place: they hold less there. */
static void warn_of_nothing(struct result *result)
{
	const struct hawser_net *net = &result->net;
	int count = 0, first = 0;

	for (int c = 0; c < result->st.cables; c++) {
		const struct hawser_net_member *m = &result->st.member[c];

		if (net->cable[c].given != HAWSER_NET_TENSION || m->T_max >= LESS*net->cable[c].value)
			continue;
		first = count++ ? first : c;
	}
	if (count > 0)
		snprintf(result->warning, sizeof result->warning, "%d cable%s with a given tension ha%s no "
		         "length in this shape, first %s: its ends %s and %s come to one place, where it "
		         "holds %.6g N of %.6g N; make them one node, or give less tension", count,
		         count == 1 ? "" : "s", count == 1 ? "s" : "ve", net->cable[first].name,
		         net->node[net->cable[first].from].name, net->node[net->cable[first].to].name,
		         result->st.member[first].T_max, net->cable[first].value);
}

/* A method with the law of bars has found compressed elements; or cables are much too short. */
static void warn(struct result *result)
{
	int elements = result->st.points - result->st.cables, count = result->st.compressed;

	if (count == 0)
		warn_of_strain(result);
	if (count == 0 && !*result->warning)
		warn_of_nothing(result);
	if (count == 0 && !*result->warning)
		cli_mesh_warning(result->warning, &result->net, &result->error);
	if (count > 0)
		snprintf(result->warning, sizeof result->warning,
		         "%d of %d elements %s compressed: the method %s has found an equilibrium of bars, "
		         "not of cables, and there is no certificate; --method automatic finds that of the "
		         "cables", count, elements, count == 1 ? "is" : "are", result->st.method);
}

static void member_row(struct hawser__table *row, const void *of, size_t c)
{
	const struct result *result = of;
	const struct hawser_net_member *m = &result->st.member[c];

	hawser__table_word(row, result->net.cable[c].name);
	hawser__table_number(row, m->T_min);
	hawser__table_number(row, m->T_max);
	hawser__table_number(row, m->T_from);
	hawser__table_number(row, m->T_to);
	hawser__table_number(row, m->length0);
	hawser__table_number(row, m->length);
	hawser__table_number(row, m->slack);
}

static void point_row(struct hawser__table *row, const void *of, size_t i)
{
	const struct result *result = of;
	const struct hawser_net_point *point = &result->st.point[i];

	hawser__table_word(row, result->net.cable[point->cable].name);
	hawser__table_number(row, point->S);
	for (int k = 0; k < 3; k++)
		hawser__table_number(row, point->x[k]);
	hawser__table_number(row, point->T);
	if (result->net.surfaces)
		cli_contacts_row(row, &result->net, &result->st, point);
}

static void slack_comment(struct hawser__table *table, const struct result *result)
{
	char names[400] = "";
	int count = 0;

	for (int c = 0; c < result->st.cables; c++) {
		size_t used = strlen(names);

		if (result->st.member[c].slack > 0 && count++ < SHOWN)
			snprintf(names + used, sizeof names - used, "%s%s", used ? ", " : "",
			         result->net.cable[c].name);
	}
	if (count > 0)
		hawser__table_comment(table, "%d cable%s with elements without tension: %s%s", count,
		                      count == 1 ? "" : "s", names, count > SHOWN ? ", ..." : "");
}

static void comments(struct hawser__table *table, const struct result *result)
{
	const struct hawser_net_statics *st = &result->st;
	int shown = 0;

	hawser__table_comment(table, "%d nodes, %d cables, %d unknowns; %d iterations", st->nodes,
	                      st->cables, st->unknowns, st->iterations);
	if (st->compressed > 0)
		hawser__table_comment(table, "energy of bars = %.12g J", st->energy);
	else if (!isfinite(st->gap))
		hawser__table_comment(table, "energy = %.12g J; around obstacles that are not planes there "
		                      "may be other equilibria", st->energy);
	else
		hawser__table_comment(table, "energy = %.12g J, at most %.1e J above the least one", st->energy,
		                      st->gap);
	hawser__table_comment(table, "forces balance to %.1e N; round-off allows %.1e N", st->residual,
	                      st->floor);
	cli_mesh_comment(table, &result->net, &result->error);
	cli_contacts_comments(table, &result->net, st);
	if (*result->warning)
		hawser__table_comment(table, "%s", result->warning);
	if (st->compressed == 0)
		slack_comment(table, result);
	for (int i = 0; i < st->nodes; i++) {
		const struct hawser_net_node *node = &result->net.node[i];
		const double *x = st->x[i], *f = st->reaction[i];

		if (shown++ >= SHOWN)
			continue;
		if (node->support)
			hawser__table_comment(table, "%s = (%.9g, %.9g, %.9g) m, force of the support "
			                      "(%.9g, %.9g, %.9g) N", node->name, x[0], x[1], x[2], f[0], f[1],
			                      f[2]);
		else
			hawser__table_comment(table, "%s = (%.9g, %.9g, %.9g) m", node->name, x[0], x[1], x[2]);
	}
	if (shown > SHOWN)
		hawser__table_comment(table, "the places of %d more nodes are in JSON", shown - SHOWN);
}

static void table(struct hawser__table *table, const void *of)
{
	static const char *const member[] = {"cable", "T_min_N", "T_max_N", "T_from_N", "T_to_N",
	                                     "length0_m", "length_m", "slack"};
	static const char *const point[] = {"cable", "S_m", "x_m", "y_m", "z_m", "T_N", "obstacle", "r_N_N",
	                                    "r_T_N", "contact"};
	const struct result *result = of;
	size_t columns = !result->profile ? sizeof member/sizeof *member
	                 : result->net.surfaces ? sizeof point/sizeof *point : 6;

	cli_echo_table(table, result->common, "statics", NULL, result->st.method);
	comments(table, result);
	for (size_t i = 0; i < columns; i++)
		hawser__table_column(table, "%s", result->profile ? point[i] : member[i]);
	if (result->profile)
		hawser__table_rows(table, (size_t)result->st.points, point_row, result);
	else
		hawser__table_rows(table, (size_t)result->st.cables, member_row, result);
}

static void members_json(struct hawser__json *json, const struct result *result)
{
	json_t *list = hawser__json_array(json, json->root, "cables");

	for (int c = 0; c < result->st.cables; c++) {
		const struct hawser_net_member *m = &result->st.member[c];
		json_t *one = hawser__json_object(json, list, NULL);

		hawser__json_text(json, one, "name", result->net.cable[c].name);
		hawser__json_number(json, one, "T_min", m->T_min);
		hawser__json_number(json, one, "T_max", m->T_max);
		hawser__json_number(json, one, "T_from", m->T_from);
		hawser__json_number(json, one, "T_to", m->T_to);
		hawser__json_number(json, one, "length0", m->length0);
		hawser__json_number(json, one, "length", m->length);
		hawser__json_integer(json, one, "slack", m->slack);
	}
}

static void profile_json(struct hawser__json *json, const struct result *result)
{
	json_t *into = hawser__json_object(json, json->root, "profile"), *list = NULL;

	for (int i = 0, last = -1; i < result->st.points; i++) {
		const struct hawser_net_point *p = &result->st.point[i];
		const double row[] = {p->S, p->x[0], p->x[1], p->x[2], p->T};

		if (p->cable != last)
			list = hawser__json_array(json, into, result->net.cable[p->cable].name);
		last = p->cable;
		hawser__json_numbers(json, list, NULL, row, 5, 1.0);
	}
}

static void json(struct hawser__json *json, const void *of)
{
	const struct result *result = of;
	const struct hawser_net_statics *st = &result->st;
	json_t *into;

	cli_echo_json(json, result->common, "statics", NULL);
	hawser__json_text(json, json->root, "method", st->method);
	into = hawser__json_object(json, json->root, "nodes");
	for (int i = 0; i < st->nodes; i++)
		hawser__json_numbers(json, into, result->net.node[i].name, st->x[i], 3, 1.0);
	members_json(json, result);
	into = hawser__json_object(json, json->root, "reactions");
	for (int i = 0; i < st->nodes; i++)
		if (result->net.node[i].support)
			hawser__json_numbers(json, into, result->net.node[i].name, st->reaction[i], 3, 1.0);
	hawser__json_number(json, json->root, "energy", st->energy);
	if (!isfinite(st->gap))
		hawser__json_null(json, json->root, "gap");
	else
		hawser__json_number(json, json->root, "gap", st->gap);
	hawser__json_integer(json, json->root, "compressed", st->compressed);
	hawser__json_number(json, json->root, "residual", st->residual);
	hawser__json_number(json, json->root, "floor", st->floor);
	cli_mesh_json(json, json->root, &result->net, &result->error);
	hawser__json_integer(json, json->root, "unknowns", st->unknowns);
	hawser__json_integer(json, json->root, "iterations", st->iterations);
	cli_contacts_json(json, &result->net, st);
	if (result->profile)
		profile_json(json, result);
	cli_warnings_json(json, *result->warning ? result->warning : NULL);
	cli_stats_json(json, result->common);
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct result *result = of;

	return hawser__plot_net(path, &result->net, &result->st, report);
}

static const struct cli_showing showing = {.table = table, .json = json, .draw = draw};

static enum hawser_status method_of(const char *name, struct hawser_report *report)
{
	const char *names[16];
	int count = 0, chosen;

	while (count < 16 && hawser_net_method(count)) {
		names[count] = hawser_net_method(count)->name;
		count++;
	}
	return name ? cli_choose(&chosen, "statics", "method", name, names, count, report) : HAWSER_OK;
}

enum hawser_status cli_statics_net(const struct cli_common *common, const char *method, int profile,
                                   const char *vtk, struct hawser_report *report)
{
	struct result result = {.common = common, .profile = profile};
	struct hawser_net_options options = {.method = method};
	enum hawser_status status = method_of(method, report);

	if (!status)
		status = cli_vtk_check(vtk, "statics", report);
	if (!status)
		status = cli_mesh_open(&result.net, common, report);
	if (!status)
		status = hawser_net_solve(&result.st, &result.net, &options, report);
	if (!status)
		status = hawser_net_mesh_error(&result.error, &result.net, &result.st, report);
	if (!status)
		warn(&result);
	if (!status && vtk)
		status = cli_contacts_vtk(vtk, &result.net, &result.st, report);
	if (!status)
		status = cli_show(common, &showing, &result, report);
	if (!status && *result.warning)
		cli_warn(result.warning);
	hawser_net_statics_clear(&result.st);
	hawser_net_clear(&result.net);
	return status;
}
