/* cli/frame/mesh_net.c - see mesh_net.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "cli/frame/mesh_net.h"
#include "core/report.h"

/* Relative error of tensions above which standard error says so. */
static const double LARGE = 0.1;

enum hawser_status cli_mesh_open(struct hawser_net *net, const struct cli_common *common,
                                 struct hawser_report *report)
{
	enum hawser_status status = cli_read_net(net, common, report);

	return status ? status : hawser_net_refine(net, report);
}

static const char *from_of(const struct hawser_net_mesh_error *error)
{
	return error->exact ? "exact catenaries" : "meshes with fewer elements";
}

void cli_mesh_comment(struct hawser__table *table, const struct hawser_net *net,
                      const struct hawser_net_mesh_error *error)
{
	if (isnan(error->tension))
		hawser__table_comment(table, "error of the mesh: not known");
	else if (error->cable < 0)
		hawser__table_comment(table, "error of the mesh: none, by %s", from_of(error));
	else
		hawser__table_comment(table, "error of the mesh: tensions to %.1e (most in %s, of %d "
		                      "elements), by %s", error->tension, net->cable[error->cable].name,
		                      net->cable[error->cable].elements, from_of(error));
}

void cli_mesh_json(struct hawser__json *json, json_t *into, const struct hawser_net *net,
                   const struct hawser_net_mesh_error *error)
{
	json_t *to = hawser__json_object(json, into, "mesh_error");

	if (isnan(error->tension))
		hawser__json_null(json, to, "tension");
	else
		hawser__json_number(json, to, "tension", error->tension);
	if (error->cable < 0)
		hawser__json_null(json, to, "cable");
	else
		hawser__json_text(json, to, "cable", net->cable[error->cable].name);
	if (isnan(error->tension))
		hawser__json_null(json, to, "from");
	else
		hawser__json_text(json, to, "from", from_of(error));
}

void cli_mesh_warning(char *text, const struct hawser_net *net,
                      const struct hawser_net_mesh_error *error)
{
	const struct hawser_net_cable *cable = &net->cable[error->cable < 0 ? 0 : error->cable];

	*text = '\0';
	if (error->tension > LARGE)
		snprintf(text, CLI_WARNING_SIZE, "the mesh is coarse: tensions of cable %s are wrong by about "
		         "%.0f %%; give it more elements than %d", cable->name, 100.0*error->tension,
		         cable->elements);
}
