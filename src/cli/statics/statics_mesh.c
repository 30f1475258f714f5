/* cli/statics/statics_mesh.c - see statics_kinds.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "cli/statics/statics_kinds.h"
#include "core/report.h"

#define OF(member) HAWSER__AT(struct hawser_net_span_statics, member)
const struct hawser__field cli_statics_mesh_field[] = {
	{"mesh.elements", NULL, "with --model fe", OF(elements)},
	{"mesh.method", NULL, "by which its equilibrium is found", OF(method)},
	{"mesh.residual", NULL, "largest force on a node that is not balanced", OF(residual),
	 .unit = HAWSER__NEWTON},
	{"mesh.floor", NULL, "what round-off allows of it", OF(floor), .unit = HAWSER__NEWTON},
	{"mesh.error.H", NULL, "error against the elastic catenary of the same length, relative",
	 OF(error.H)},
	{"mesh.error.T0", NULL, "the same of T0", OF(error.T0)},
	{"mesh.error.T1", NULL, "the same of T1", OF(error.T1)},
	{"mesh.error.length", NULL, "the same of the stretched length", OF(error.length)},
	{"mesh.error.sag", NULL, "the same of the sag", OF(error.sag)},
	{"mesh.error.place", NULL, "largest distance of a node from its place on the catenary",
	 OF(error.place), .unit = HAWSER__METRE},
	HAWSER__END,
};
#undef OF

void cli_statics_mesh_comments(struct hawser__table *table,
                               const struct hawser_net_span_statics *mesh)
{
	const struct hawser_net_span_error *error = &mesh->error;

	hawser__table_comment(table, "mesh of %d elements: forces balance to %.1e N; round-off allows "
	                      "%.1e N", mesh->elements, mesh->residual, mesh->floor);
	hawser__table_comment(table, "errors of the mesh against the elastic catenary of the same length: "
	                      "H %.1e, T0 %.1e, T1 %.1e, sag %.1e; places %.2g m", error->H, error->T0,
	                      error->T1, error->sag, error->place);
}

enum hawser_status cli_statics_mesh_check(const char *model, int points, int usual,
                                          struct hawser_report *report)
{
	int fe = model && strcmp(model, "fe") == 0;

	return !fe || points == usual ? HAWSER_OK
		: hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics",
		               "--points %d: the profile of --model fe is that of its nodes; give "
		               "--elements", points);
}

enum hawser_status cli_statics_mesh(struct hawser__spot **profile,
                                    struct hawser_net_span_statics *mesh,
                                    const struct hawser_scene *scene,
                                    const struct hawser_statics *statics, int elements,
                                    struct hawser_report *report)
{
	enum hawser_status status = hawser_net_span_solve(mesh, scene, statics, elements, report);

	if (status)
		return status;
	*profile = calloc((size_t)mesh->points, sizeof **profile);
	if (!*profile)
		return hawser__no_memory(report, "statics");
	for (int i = 0; i < mesh->points; i++)
		(*profile)[i] = cli_place(statics, &mesh->point[i]);
	return HAWSER_OK;
}
