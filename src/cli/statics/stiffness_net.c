/* cli/statics/stiffness_net.c - hawser statics --stiffness: the force by which nodes of a net resist
 * motions, as they are asked for, in comments, tables and JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "cli/statics/statics_kinds.h"
#include "core/report.h"

static const char *const motions[] = {"x", "y", "z", "rx", "ry", "rz"};
/* Above this K is not symmetric; round-off is far below. */
static const double ROUND = 1e-6;

struct row {
	const char *motion;
	double force[3], moment[3];
};
#define OF(member) HAWSER__AT(struct row, member)
const struct hawser__field cli_stiffness_field[] = {
	{"motion", "motion", "of the nodes: by 1 m along x, y, z, or 1 rad about them: rx, ry, rz",
	 OF(motion)},
	{"force_x", "F_x", "change of the force on the nodes that holds them", OF(force[0]),
	 .unit = HAWSER__NEWTON},
	{"force_y", "F_y", "the same along y", OF(force[1]), .unit = HAWSER__NEWTON},
	{"force_z", "F_z", "the same along z", OF(force[2]), .unit = HAWSER__NEWTON},
	{"moment_x", "M_x", "with --about: change of the moment", OF(moment[0]),
	 .unit = HAWSER__NEWTON_METRE, .when = CLI_STIFFNESS_TURNS},
	{"moment_y", "M_y", "the same about y", OF(moment[1]), .unit = HAWSER__NEWTON_METRE,
	 .when = CLI_STIFFNESS_TURNS},
	{"moment_z", "M_z", "the same about z", OF(moment[2]), .unit = HAWSER__NEWTON_METRE,
	 .when = CLI_STIFFNESS_TURNS},
	HAWSER__END,
};
#undef OF

static const void *row_of(void *to, const void *parent, size_t i)
{
	const struct hawser_net_stiffness *of = &((const struct cli_stiffness *)parent)->of;
	struct row *row = to;

	row->motion = motions[i];
	for (int k = 0; k < 3; k++) {
		row->force[k] = of->K[k][i];
		row->moment[k] = of->K[3 + k][i];
	}
	return row;
}
const struct hawser__list cli_stiffness_list = HAWSER__MADE_ROWS(
	struct row, cli_stiffness_field, struct cli_stiffness, rows, row_of);

#define OF(member) HAWSER__AT(struct cli_stiffness, of.member)
static const struct hawser__field part_field[] = {
	{"about", NULL, "place of the axes of turns", OF(about), .unit = HAWSER__METRE,
	 .when = CLI_STIFFNESS_TURNS},
	{"force", NULL, "force (N) and moment (N m) on the nodes in the equilibrium", OF(force)},
	{"asymmetry", NULL, "largest difference of K_ij and K_ji, relative", OF(asymmetry)},
	{"rows", NULL, "one a motion", HAWSER__OBJECTS_OF(cli_stiffness_list)},
	HAWSER__END,
};
#undef OF
const struct hawser__field cli_stiffness_member[] = {
	{"stiffness", NULL, "with --stiffness", HAWSER__OBJECT_OF(part_field), .when = CLI_STIFFNESS},
	HAWSER__END,
};

void cli_stiffness_comments(struct hawser__table *table, const struct cli_stiffness *stiffness)
{
	const struct hawser_net_stiffness *of = &stiffness->of;

	if (!stiffness->rows)
		return;
	hawser__table_comment(table, "stiffness: change of the force that holds the nodes by a unit "
	                      "motion, which all other nodes that are free follow");
	hawser__table_comment(table, "they are held by (%.9g, %.9g, %.9g) N", of->force[0], of->force[1],
	                      of->force[2]);
	if (of->size == 6)
		hawser__table_comment(table, "and, about (%.9g, %.9g, %.9g) m, by (%.9g, %.9g, %.9g) N m",
		                      of->about[0], of->about[1], of->about[2], of->force[3], of->force[4],
		                      of->force[5]);
	if (of->asymmetry > ROUND)
		hawser__table_comment(table, "the matrix is not symmetric, by %.2g: friction that slides, "
		                      "drag and moments have no potential", of->asymmetry);
}

/* A node, of a body its first one. */
static int node_of(const struct hawser_net *net, const char *name, size_t length)
{
	for (int i = 0; i < net->bodies; i++)
		if (strlen(net->body[i].name) == length && !strncmp(net->body[i].name, name, length))
			return net->body[i].node[0];
	for (int i = 0; i < net->nodes; i++)
		if (strlen(net->node[i].name) == length && !strncmp(net->node[i].name, name, length))
			return i;
	return -1;
}

static enum hawser_status nodes_of(int *node, int *count, const struct hawser_net *net,
                                   const char *text, struct hawser_report *report)
{
	for (const char *at = text; at; at = strchr(at, ',') ? strchr(at, ',') + 1 : NULL) {
		size_t length = strcspn(at, ",");
		int i = node_of(net, at, length);

		for (int j = 0; j < *count && i >= 0; j++)
			if (node[j] == i)
				return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics", "--stiffness: node %s is "
				                    "there twice", net->node[i].name);
		if (i < 0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics", "--stiffness: %s has no node "
			                    "%.*s: give names of nodes, with a comma between them", net->name,
			                    (int)(length > 40 ? 40 : length), at);
		node[(*count)++] = i;
	}
	return HAWSER_OK;
}

static enum hawser_status place_of(double x[3], const char *text, struct hawser_report *report)
{
	char part[64];
	enum hawser_status status = HAWSER_OK;

	for (int k = 0; k < 3 && !status; k++) {
		size_t length = strcspn(text, ",");

		if (length >= sizeof part || (text[length] == ',') != (k < 2))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics", "--about must be three lengths "
			                    "with a comma between them, such as 0,-14,0");
		memcpy(part, text, length);
		part[length] = '\0';
		status = cli_quantity(&x[k], part, "m", CLI_ANY, "statics", "about", report);
		text += length + 1;
	}
	return status;
}

enum hawser_status cli_stiffness_fill(struct cli_stiffness *stiffness, const struct hawser_net *net,
                                      const char *nodes, const char *about,
                                      struct hawser_report *report)
{
	double x[3];
	int count = 0, *node;
	enum hawser_status status = about ? place_of(x, about, report) : HAWSER_OK;

	if (status || !nodes)
		return status;
	node = malloc(((size_t)net->nodes + 1)*sizeof *node);
	status = node ? nodes_of(node, &count, net, nodes, report) : hawser__no_memory(report, "statics");
	if (!status)
		status = hawser_net_stiffness_of(&stiffness->of, net, node, count, about ? x : NULL, report);
	stiffness->rows = stiffness->of.size;
	free(node);
	return status;
}
