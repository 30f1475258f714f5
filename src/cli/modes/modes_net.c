/* cli/modes/modes_net.c - hawser modes of a scene of kind `net`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/statics/statics_kinds.h"
#include "cli/frame/mesh_net.h"
#include "cli/modes/modes_result.h"
#include "cli/frame/view.h"
#include "core/report.h"
#include "output/structures/structures.h"
#include "output/report/vtk.h"

struct result {
	const struct cli_common *common;
	struct cli_mesh mesh;
	struct hawser_net_modes modes;
	struct cli_contacts contacts;
	const char *method;
	int shapes;
};

static const char *family_of(double along)
{
	return hawser_family_name(along > 0.5 ? HAWSER_LONGITUDINAL : HAWSER_TRANSVERSE);
}

/* --- comments --- */

static void plane_comment(struct hawser__table *table, const char *what,
                          const struct hawser_net_plane *plane)
{
	const double *x = plane->point, *n = plane->normal;

	hawser__table_comment(table, "%s through (%.6g, %.6g, %.6g) m with normal (%.6g, %.6g, %.6g): "
	                      "places within %.1e m, stiffness, tension and mass within %.1e", what, x[0],
	                      x[1], x[2], n[0] + 0.0, n[1] + 0.0, n[2] + 0.0, plane->places,
	                      plane->elements);
}

static void symmetry_comments(struct hawser__table *table, const struct hawser_net_symmetry *symmetry)
{
	const double *x = symmetry->centre, *a = symmetry->axis;

	if (symmetry->flat)
		plane_comment(table, symmetry->straight ? "the net lies on a line; plane"
		              : "the net lies in the plane", &symmetry->plane);
	for (int k = 0; k < symmetry->mirrors; k++) {
		char what[40];

		snprintf(what, sizeof what, "mirror plane %d", k + 1);
		plane_comment(table, what, &symmetry->mirror[k]);
	}
	if (symmetry->turns > 1)
		hawser__table_comment(table, "a turn by 1/%d about the axis through (%.6g, %.6g, %.6g) m along "
		                      "(%.6g, %.6g, %.6g) maps the net onto itself", symmetry->turns, x[0],
		                      x[1], x[2], a[0] + 0.0, a[1] + 0.0, a[2] + 0.0);
	if (!symmetry->flat && symmetry->mirrors == 0 && symmetry->turns == 1)
		hawser__table_comment(table, "no plane of symmetry");
}

static int count_of(const struct hawser_net_modes *modes, int sticks)
{
	int count = 0;

	for (int i = 0; i < modes->contacts; i++)
		count += modes->contact[i].sticks == sticks;
	return count;
}

static void contact_comments(struct hawser__table *table, const struct hawser_net_modes *modes)
{
	int free = 0;

	if (!modes->state)
		return;
	while (free < modes->n && modes->omega[free] == 0.0)
		free++;
	hawser__table_comment(table, "contact: %d node%s of the mesh slip along obstacles, %d stick%s",
	                      count_of(modes, 0), count_of(modes, 0) == 1 ? "" : "s", count_of(modes, 1),
	                      modes->how == HAWSER_NET_MODES_STATICS ? ", as in the statics" : "");
	if (free > 0)
		hawser__table_comment(table, "omega 0: %d motion%s without resistance", free,
		                      free == 1 ? "" : "s");
}

/* Modes that the corners of the mesh have changed by more than a hundredth. */
static void corner_comment(struct hawser__table *table, const struct hawser_net_modes *modes)
{
	int worst = -1;

	for (int j = 0; j < modes->n; j++)
		if (modes->omega[j] > 0.0 && modes->corners[j] > 0.15*modes->omega[j] &&
		    (worst < 0 || modes->corners[j] > modes->corners[worst]))
			worst = j;
	if (worst >= 0)
		hawser__table_comment(table, "mode %d slides over circles, where the corners of the mesh alone "
		                      "make a frequency of up to %.4g rad/s: more elements", worst + 1,
		                      modes->corners[worst]);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	const struct hawser_net_modes *modes = &result->modes;

	hawser__table_comment(table, "%d unknowns; mass: of a shape whose largest displacement is 1",
	                      modes->unknowns);
	if (modes->slack > 0)
		hawser__table_comment(table, "%d element%s without tension: no stiffness", modes->slack,
		                      modes->slack == 1 ? "" : "s");
	if (modes->below > 0.0)
		hawser__table_comment(table, "no mode is missed: K - omega^2 M at omega = %.10g rad/s has %d "
		                      "negative eigenvalue%s, as many as modes were found below",
		                      modes->below, modes->counted, modes->counted == 1 ? "" : "s");
	else if (modes->below < 0.0)
		hawser__table_comment(table, "round-off prevents a count of the modes below the last one");
	cli_mesh_comment(table, &result->mesh);
	contact_comments(table, modes);
	corner_comment(table, modes);
	symmetry_comments(table, &modes->symmetry);
}

/* --- fields --- */

enum { TWO = 1, THREE = 2, TURNS = 4, CONTACTS = 8, SHAPES = 16 };

struct row {
	const struct result *result;
	int index, waves, pair;
	double omega, mass, share[3], along, residual, corners;
	const char *plane, *family, *symmetry[HAWSER_NET_MIRRORS];
};

/* Displacements along the cables of mode j, or their S if it is negative. */
static void along(struct hawser__json *json, json_t *into, const struct result *result, int j)
{
	const struct hawser_net_modes *modes = &result->modes;
	json_t *list = NULL;

	for (int p = 0; p < modes->points; p++) {
		if (p == 0 || modes->cable[p] != modes->cable[p - 1])
			list = hawser__json_array(json, into, result->mesh.net.cable[modes->cable[p]].name);
		if (j < 0)
			hawser__json_number(json, list, NULL, modes->S[p]);
		else
			hawser__json_numbers(json, list, NULL,
			                     modes->point[(size_t)j*(size_t)modes->points + (size_t)p], 3, 1.0);
	}
}

static void parity_json(struct hawser__json *json, json_t *into, const void *of)
{
	const struct row *row = of;
	const struct hawser_net_modes *modes = &row->result->modes;
	const double *parity = modes->parity[row->index - 1];
	json_t *to = hawser__json_object(json, into, "parity");

	if (modes->symmetry.flat)
		hawser__json_number(json, to, "plane", parity[0]);
	else
		hawser__json_null(json, to, "plane");
	hawser__json_numbers(json, to, "mirrors", parity + 1, modes->symmetry.mirrors, 1.0);
}

static void shape_json(struct hawser__json *json, json_t *into, const void *of)
{
	const struct row *row = of;

	along(json, hawser__json_object(json, into, "shape"), row->result, row->index - 1);
}

#define OF(member) HAWSER__AT(struct row, member)
const struct hawser__field cli_modes_net_field[] = {
	{"index", "index", "from 1, by frequency", OF(index)},
	{"omega", "omega", "circular frequency", OF(omega), .unit = HAWSER__RADIAN_S},
	{"frequency", "frequency", "frequency", OF(omega), .unit = HAWSER__HERTZ},
	{"plane", "plane", "of a net that lies in a plane: in-plane or out-of-plane", OF(plane),
	 .flags = HAWSER__NULL},
	{"family", "family", "transverse or longitudinal, by the larger share of the kinetic energy",
	 OF(family)},
	{"symmetry", "symmetry", "to mirror plane 1: symmetric, antisymmetric or mixed", OF(symmetry[0]),
	 .flags = HAWSER__NULL},
	{"symmetry_2", "symmetry_2", "to mirror plane 2", OF(symmetry[1]), .flags = HAWSER__NULL,
	 .when = TWO | THREE},
	{"symmetry_3", "symmetry_3", "to mirror plane 3", OF(symmetry[2]), .flags = HAWSER__NULL,
	 .when = THREE},
	{"waves", "waves", "of a net that a turn by 1/n maps onto itself: waves around the axis, 0 to n/2",
	 OF(waves), .flags = HAWSER__NULL, .when = TURNS},
	{"pair", "pair", "index of the other mode of two with this frequency", OF(pair),
	 .flags = HAWSER__NULL},
	{"residual", "residual", "bound of the error of the frequency, relative, as that of the mesh",
	 OF(residual)},
	{"corners", NULL, "with obstacles: frequency whose square the corners of the mesh on circles may "
	 "add or take off (rad/s)", OF(corners)},
	{"mass", "mass", "modal mass, of a shape whose largest displacement is 1", OF(mass),
	 .unit = HAWSER__KILOGRAM},
	{"along", "along", "share of the kinetic energy of motion along the cables", OF(along)},
	{"share", "share_", "of the modal mass, that moves along an axis", OF(share),
	 .vector = &cli_axes},
	{"parity", NULL, "symmetric part of the kinetic energy minus the antisymmetric one: plane, and the "
	 "list mirrors", HAWSER__CALLS(parity_json)},
	{"nodes", NULL, "displacement of each node",
	 HAWSER__VECTOR_ALONG(struct result, modes.shape, cli_nodes)},
	{"shape", NULL, "with --shapes: along each cable", HAWSER__CALLS(shape_json), .when = SHAPES},
	HAWSER__END,
};
#undef OF

static const void *mode_row(void *to, const void *parent, size_t j)
{
	const struct result *result = parent;
	const struct hawser_net_modes *modes = &result->modes;
	struct row *row = to;

	*row = (struct row){
		.result = result, .index = (int)j + 1, .omega = modes->omega[j], .mass = modes->mass[j],
		.share = {modes->share[j][0], modes->share[j][1], modes->share[j][2]},
		.along = modes->along[j], .residual = modes->residual[j], .corners = modes->corners[j],
		.waves = modes->waves[j] < 0 ? HAWSER__NO_INTEGER : modes->waves[j],
		.pair = modes->pair[j] < 0 ? HAWSER__NO_INTEGER : modes->pair[j] + 1,
		.plane = hawser_net_plane_side(modes->parity[j][0]), .family = family_of(modes->along[j])};
	for (int k = 0; k < HAWSER_NET_MIRRORS; k++)
		row->symmetry[k] = hawser_net_side(modes->parity[j][1 + k]);
	return row;
}
static const struct hawser__list mode_list = HAWSER__MADE_ROWS(
	struct row, cli_modes_net_field, struct result, modes.n, mode_row);

#define OF(member) HAWSER__AT(struct hawser_net_plane, member)
static const struct hawser__field plane_field[] = {
	{"point", NULL, "of the plane", OF(point), .unit = HAWSER__METRE},
	{"normal", NULL, "its normal", OF(normal)},
	{"places", NULL, "how well it holds for places", OF(places), .unit = HAWSER__METRE},
	{"elements", NULL, "and for stiffness, tension and mass, relative", OF(elements)},
	HAWSER__END,
};
#undef OF

HAWSER__GIVEN(is_flat, struct hawser_net_symmetry, of->flat)

#define OF(member) HAWSER__AT(struct hawser_net_symmetry, member)
static const struct hawser__field symmetry_field[] = {
	{"plane", NULL, "in which the net lies, or null",
	 HAWSER__PART_OF(struct hawser_net_symmetry, plane, plane_field), .given = is_flat,
	 .flags = HAWSER__NULL},
	{"straight", NULL, "whether it lies on a line",
	 HAWSER__FLAG_AT(struct hawser_net_symmetry, straight)},
	{"mirrors", NULL, "planes of symmetry",
	 HAWSER__STORED_WITHIN(struct hawser_net_symmetry, mirror, mirrors, plane_field),
	 .flags = HAWSER__BRIEF},
	{"turns", NULL, "1/turns of a circle about axis maps the net onto itself", OF(turns)},
	{"axis", NULL, "its direction", OF(axis)},
	{"centre", NULL, "a point of it", OF(centre), .unit = HAWSER__METRE},
	HAWSER__END,
};
#undef OF

static double certified(const void *of)
{
	double below = ((const struct hawser_net_modes *)of)->below;

	return below > 0.0 ? below : NAN;
}

HAWSER__OF(complete, double, struct hawser_net_modes, of->below >= 0.0)

static const struct hawser__field certificate_field[] = {
	{"omega", NULL, "null: all of the mesh", HAWSER__BY(certified), .unit = HAWSER__RADIAN_S,
	 .flags = HAWSER__NULL},
	{"modes", NULL, "below it, by the inertia of K - omega^2 M",
	 HAWSER__AT(struct hawser_net_modes, counted)},
	{"complete", NULL, "none is missed", HAWSER__FLAG_BY(complete)},
	HAWSER__END,
};

static const char *how_of(const void *of)
{
	static const char *const names[] = {"statics", "slip", "stick"};
	const struct hawser_net_modes *modes = &((const struct result *)of)->modes;

	return modes->state ? names[modes->how] : NULL;
}

static void points_json(struct hawser__json *json, json_t *into, const void *of)
{
	along(json, hawser__json_object(json, into, "S"), of, -1);
}

const struct hawser__field cli_modes_net_member[] = {
	{"method", NULL, "by which they are computed", HAWSER__AT(struct result, method)},
	{"slack", NULL, "elements without tension, which have no stiffness",
	 HAWSER__AT(struct result, modes.slack)},
	{"certificate", NULL, "that no mode is missed",
	 HAWSER__PART_OF(struct result, modes, certificate_field)},
	{"", NULL, "", HAWSER__PART_OF(struct result, mesh, cli_mesh_field)},
	{"symmetry", NULL, "of the net",
	 HAWSER__PART_OF(struct result, modes.symmetry, symmetry_field)},
	{"contact", NULL, "with obstacles, about which state of contact: statics, slip or stick",
	 HAWSER__TEXT_BY(how_of), .flags = HAWSER__NULL},
	{"", NULL, "", HAWSER__PART_OF(struct result, contacts, cli_contacts_field), .when = CONTACTS},
	{"S", NULL, "with --shapes: unstretched length of the points of each cable",
	 HAWSER__CALLS(points_json), .when = SHAPES},
	{"modes", NULL, "by frequency", HAWSER__OBJECTS_OF(mode_list)},
	HAWSER__END,
};
static const struct hawser__field stats_field[] = {
	{"unknowns", NULL, "of the mesh", HAWSER__AT(struct result, modes.unknowns)},
	{"iterations", NULL, "solutions with the factors of K",
	 HAWSER__AT(struct result, modes.iterations)},
	HAWSER__END,
};

static struct cli_head head(const void *of)
{
	const struct result *result = of;
	const struct hawser_net_symmetry *symmetry = &result->modes.symmetry;
	int waves = symmetry->turns > 2 || (symmetry->turns == 2 && symmetry->mirrors == 0);

	return cli_si_head(result->common, "modes", result->method, &result->mesh.net,
	                   (waves ? TURNS : 0u) | (symmetry->mirrors == 2 ? TWO : 0u) |
	                   (symmetry->mirrors > 2 ? THREE : 0u) | (result->modes.state ? CONTACTS : 0u) |
	                   (result->shapes ? SHAPES : 0u));
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	return hawser__plot_net_modes(path, &((const struct result *)of)->modes, report);
}

static const struct cli_showing showing = {.head = head, .comments = comments, .rows = &mode_list,
                                           .fields = cli_modes_net_member, .stats = stats_field,
                                           .draw = draw};

/* --- VTK --- */

/* All shapes as vectors of the points in the equilibrium; the number of the cable of each line; with
 * obstacles 0, 1 or 2 at a point: open, slip or stick. */
static enum hawser_status write_vtk(const char *path, const struct result *result,
                                    struct hawser_report *report)
{
	const struct hawser_net_modes *modes = &result->modes;
	size_t points = (size_t)modes->points + 1;
	int (*end)[2] = malloc(points*sizeof *end), lines = 0;
	double *cable = malloc(points*sizeof *cable), *contact = calloc(points, sizeof *contact);
	const struct hawser__vtk_scalar scalar = {"cable", cable}, mark = {"contact", contact};
	enum hawser_status status = end && cable && contact ? HAWSER_OK
		: hawser__no_memory(report, "modes");

	for (int p = 0; p + 1 < modes->points && !status; p++) {
		if (modes->cable[p] != modes->cable[p + 1])
			continue;
		end[lines][0] = p;
		end[lines][1] = p + 1;
		cable[lines++] = modes->cable[p] + 1;
	}
	for (int p = 0; p < modes->points && modes->state && !status; p++)
		contact[p] = modes->state[p];
	if (!status)
		status = hawser__vtk_write(path, &(struct hawser__vtk){
			.title = "hawser modes: displacements of modes 1, 2, ... about the equilibrium",
			.points = modes->points, .lines = lines, .x = (const double (*)[3])modes->place,
			.end = (const int (*)[2])end, .scalars = 1, .scalar = &scalar,
			.marks = modes->state != NULL, .mark = &mark, .vectors = modes->n,
			.vector = "mode", .shape = (const double (*)[3])modes->point, .field = "omega_rad_s",
			.number = modes->omega}, report);
	free(end);
	free(cable);
	free(contact);
	return status;
}

/* --contact in place of the scene's contact.modes. */
static enum hawser_status choose(struct hawser_net *net, const char *contact,
                                 struct hawser_report *report)
{
	static const char *const name[] = {"statics", "slip", "stick"};
	int how = 0;
	enum hawser_status status;

	if (!contact)
		return HAWSER_OK;
	if (!net->surfaces)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes", "--contact: the scene %s has no "
		                    "obstacles: add them, or leave the option out", net->name);
	status = cli_choose(&how, "modes", "contact", contact, name, 3, report);
	net->contact.modes = (enum hawser_net_contact_modes)how;
	return status;
}

static void doubts(const struct result *result)
{
	const struct hawser_net_modes *modes = &result->modes;
	char text[CLI_WARNING_SIZE];

	cli_mesh_warning(text, &result->mesh);
	if (*text)
		cli_warn(text);
	if (modes->doubtful == 0)
		return;
	snprintf(text, sizeof text, "%s: %d node%s touch an obstacle without force (first: cable %s, S = "
	         "%.6g m): the modes are those with these nodes open; with them closed they are others, so "
	         "that small motions are not linear", result->mesh.net.name, modes->doubtful,
	         modes->doubtful == 1 ? "" : "s", result->mesh.net.cable[modes->cable[modes->barely]].name,
	         modes->S[modes->barely]);
	cli_warn(text);
}

enum hawser_status cli_modes_net(const struct cli_common *common, int n, int shapes, const char *vtk,
                                 const char *contact, struct hawser_report *report)
{
	struct result *result = calloc(1, sizeof *result);
	enum hawser_status status;

	if (!result)
		return hawser__no_memory(report, "modes");
	result->common = common;
	result->shapes = shapes;
	status = cli_vtk_check(vtk, "modes", report);
	if (!status)
		status = cli_mesh_open(&result->mesh.net, common, report);
	if (!status)
		status = choose(&result->mesh.net, contact, report);
	if (!status)
		status = hawser_net_modes_solve(&result->modes, &result->mesh.net, n > 0 ? n : 0, report);
	result->method = result->modes.method;
	result->contacts = (struct cli_contacts){&result->mesh.net, result->modes.contact,
	                                         result->modes.contacts, 0.0};
	if (!status)
		status = hawser_net_mesh_error(&result->mesh.error, &result->mesh.net, NULL, report);
	if (!status)
		doubts(result);
	if (!status && vtk)
		status = write_vtk(vtk, result, report);
	if (!status)
		status = cli_show(common, &showing, result, report);
	hawser_net_modes_clear(&result->modes);
	hawser_net_clear(&result->mesh.net);
	free(result);
	return status;
}
