/* cli/frame/mesh_net.c - see mesh_net.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/frame/mesh_net.h"

/* Relative error of tensions above which standard error says so. */
static const double LARGE = 0.1;

enum hawser_status cli_mesh_open(struct hawser_net *net, const struct cli_common *common,
                                 struct hawser_report *report)
{
	enum hawser_status status = cli_read_net(net, common, report);

	return status ? status : hawser_net_refine(net, report);
}

/* --- its error --- */

static const char *from_of(const void *of)
{
	const struct cli_mesh *mesh = of;

	return isnan(mesh->error.tension) ? NULL
	       : mesh->error.exact ? "exact catenaries" : "meshes with fewer elements";
}

HAWSER__OF(cable_of, const char *, struct cli_mesh,
	of->error.cable < 0 ? NULL : of->net.cable[of->error.cable].name)

void cli_mesh_comment(struct hawser__table *table, const struct cli_mesh *mesh)
{
	if (!from_of(mesh))
		hawser__table_comment(table, "error of the mesh: not known");
	else if (!cable_of(mesh))
		hawser__table_comment(table, "error of the mesh: none, by %s", from_of(mesh));
	else
		hawser__table_comment(table, "error of the mesh: tensions to %.1e (most in %s, of %d "
		                      "elements), by %s", mesh->error.tension, cable_of(mesh),
		                      mesh->net.cable[mesh->error.cable].elements, from_of(mesh));
}

const struct hawser__field cli_mesh_field[] = {
	{"mesh_error.tension", NULL, "relative error of the tensions of the equilibrium by the mesh; null: "
	 "not known", HAWSER__AT(struct cli_mesh, error.tension), .flags = HAWSER__NULL},
	{"mesh_error.cable", NULL, "the cable with the largest one", HAWSER__TEXT_BY(cable_of),
	 .flags = HAWSER__NULL},
	{"mesh_error.from", NULL, "what it is compared with", HAWSER__TEXT_BY(from_of),
	 .flags = HAWSER__NULL},
	HAWSER__END,
};

void cli_mesh_warning(char *text, const struct cli_mesh *mesh)
{
	const struct hawser_net_cable *cable = &mesh->net.cable[cable_of(mesh) ? mesh->error.cable : 0];

	*text = '\0';
	if (mesh->error.tension > LARGE)
		snprintf(text, CLI_WARNING_SIZE, "the mesh is coarse: tensions of cable %s are wrong by about "
		         "%.0f %%; give it more elements than %d", cable->name, 100.0*mesh->error.tension,
		         cable->elements);
}

/* --- nodes by name --- */

HAWSER__OF(numbers, int, struct hawser_net, 3*of->nodes)

static void node_name(char *text, size_t size, const void *context, int k)
{
	snprintf(text, size, "%s\n", ((const struct hawser_net *)context)->node[k/3].name);
}

static void support_name(char *text, size_t size, const void *context, int k)
{
	*text = '\0';
	if (((const struct hawser_net *)context)->node[k/3].support)
		node_name(text, size, context, k);
}

const struct hawser__vector cli_nodes = {.count = numbers, .name = node_name, .object = 1};
const struct hawser__vector cli_supports = {.count = numbers, .name = support_name, .object = 1};
