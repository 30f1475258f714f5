/* cli/statics/statics_net.c - hawser statics of a scene of kind `net`: positions, tensions, reactions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <hawser/net.h>

#include "cli/frame/mesh_net.h"
#include "cli/statics/statics_kinds.h"
#include "core/append.h"
#include "output/structures/structures.h"

enum { SHOWN = 40 }; /* names and places in the comments */

struct result {
	const struct cli_common *common;
	int profile;
	struct cli_mesh mesh;
	struct hawser_net_statics st;
	struct cli_contacts contacts;
	struct cli_stiffness stiffness;
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
		         result->mesh.net.cable[most - result->st.member].name,
		         100.0*(most->length/most->length0 - 1.0));
}

/* Cables of given tension whose ends came to one place: they hold less there. */
static void warn_of_nothing(struct result *result)
{
	const struct hawser_net *net = &result->mesh.net;
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

static void warn(struct result *result)
{
	warn_of_strain(result);
	if (!*result->warning)
		warn_of_nothing(result);
	if (!*result->warning)
		cli_mesh_warning(result->warning, &result->mesh);
}

static void slack_comment(struct hawser__table *table, const struct result *result)
{
	char names[400] = "";
	int count = 0;

	for (int c = 0; c < result->st.cables; c++)
		if (result->st.member[c].slack > 0 && count++ < SHOWN)
			hawser__append(names, sizeof names, ", ", "%s", result->mesh.net.cable[c].name);
	if (count > 0)
		hawser__table_comment(table, "%d cable%s with elements without tension: %s%s", count,
		                      count == 1 ? "" : "s", names, count > SHOWN ? ", ..." : "");
}

/* The turn of a body from the scene, as a vector, rad: its axes were those of the scene. */
static void turn_of(double turn[3], const struct hawser_net_body *body)
{
	const double (*a)[3] = body->axes;
	double sine;

	turn[0] = 0.5*(a[1][2] - a[2][1]);
	turn[1] = 0.5*(a[2][0] - a[0][2]);
	turn[2] = 0.5*(a[0][1] - a[1][0]);
	sine = sqrt(turn[0]*turn[0] + turn[1]*turn[1] + turn[2]*turn[2]);
	for (int k = 0; k < 3 && sine > 0.0; k++)
		turn[k] *= atan2(sine, 0.5*(a[0][0] + a[1][1] + a[2][2] - 1.0))/sine;
}

static void bodies_comment(struct hawser__table *table, const struct hawser_net_statics *st)
{
	for (int b = 0; b < st->bodies; b++) {
		double turn[3];

		turn_of(turn, &st->body[b]);
		hawser__table_comment(table, "%s: turned by (%.9g, %.9g, %.9g) rad from the scene",
		                      st->body[b].name, turn[0], turn[1], turn[2]);
	}
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	const struct hawser_net_statics *st = &result->st;
	int shown = 0;

	hawser__table_comment(table, "%d nodes, %d cables, %d unknowns; %d iterations", st->nodes,
	                      st->cables, st->unknowns, st->iterations);
	if (!isfinite(st->gap))
		hawser__table_comment(table, "energy = %.12g J; %s there may be other equilibria", st->energy,
		                      result->mesh.net.winds ? "in a wind"
		                      : result->mesh.net.water.levels ? "in a current"
		                                                      : "around obstacles that are not planes");
	else
		hawser__table_comment(table, "energy = %.12g J, at most %.1e J above the least one", st->energy,
		                      st->gap);
	hawser__table_comment(table, "forces balance to %.1e N; round-off allows %.1e N", st->residual,
	                      st->floor);
	cli_mesh_comment(table, &result->mesh);
	cli_contacts_comments(table, &result->mesh.net, st);
	cli_stiffness_comments(table, &result->stiffness);
	if (*result->warning)
		hawser__table_comment(table, "%s", result->warning);
	slack_comment(table, result);
	bodies_comment(table, st);
	for (int i = 0; i < st->nodes; i++) {
		const struct hawser_net_node *node = &result->mesh.net.node[i];
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

/* --- fields --- */

enum { SURFACES = 1, PROFILE = 2, WATER = 64, BODIES = 128 };
#define NEWTON .unit = HAWSER__NEWTON /* a force */
#define METRE .unit = HAWSER__METRE   /* a length */

#define OF(member) HAWSER__AT(struct hawser_net_member, member)
static const struct hawser__field member_field[] = {
	{"name", "cable", "name of the cable",
	 HAWSER__OUTER(struct result, mesh.net.cable, struct hawser_net_cable, name)},
	{"T_min", "T_min", "least tension", OF(T_min), NEWTON},
	{"T_max", "T_max", "largest tension", OF(T_max), NEWTON},
	{"T_from", "T_from", "tension at its end `from`", OF(T_from), NEWTON},
	{"T_to", "T_to", "tension at its end `to`", OF(T_to), NEWTON},
	{"length0", "length0", "unstretched length", OF(length0), METRE},
	{"length", "length", "stretched length", OF(length), METRE},
	{"wet", "wet", "in water: unstretched length in it", OF(wet), METRE, .when = WATER},
	{"slack", "slack", "number of elements without tension", OF(slack)},
	HAWSER__END,
};
#undef OF
static const struct hawser__list member_list =
	HAWSER__STORED_ROWS(struct result, st.member, st.cables, member_field);

struct row {
	const char *cable;
	struct hawser_net_point of;
	struct cli_touch touch;
};
#define OF(member) HAWSER__AT(struct row, member)
static const struct hawser__field point_field[] = {
	{NULL, "cable", "name of the cable", OF(cable)},
	{NULL, "S", "unstretched length from its end `from`", OF(of.S), METRE},
	{NULL, "", "place", OF(of.x), .vector = &cli_axes, METRE},
	{NULL, "T", "tension", OF(of.T), NEWTON},
	{NULL, "obstacle", "with obstacles: the one that is touched", OF(touch.obstacle), .when = SURFACES},
	{NULL, "r_N", "its force along its normal", OF(touch.r_N), NEWTON, .when = SURFACES},
	{NULL, "r_T", "its force along the surface", OF(touch.r_T), NEWTON, .when = SURFACES},
	{NULL, "contact", "open, stick or slip", OF(touch.state), .when = SURFACES},
	HAWSER__END,
};
#undef OF

static const void *point_row(void *to, const void *of, size_t i)
{
	const struct result *result = of;
	const struct hawser_net_point *point = &result->st.point[i];
	struct row *row = to;

	*row = (struct row){result->mesh.net.cable[point->cable].name, *point,
	                    cli_contacts_at(&result->mesh.net, &result->st, point)};
	return row;
}
static const struct hawser__list point_list = HAWSER__MADE_ROWS(
	struct row, point_field, struct result, st.points, point_row);

static void profile_json(struct hawser__json *json, json_t *to, const void *of)
{
	const struct result *result = of;
	json_t *into = hawser__json_object(json, to, "profile"), *list = NULL;

	for (int i = 0, last = -1; i < result->st.points; i++) {
		const struct hawser_net_point *p = &result->st.point[i];
		const double row[] = {p->S, p->x[0], p->x[1], p->x[2], p->T};

		if (p->cable != last)
			list = hawser__json_array(json, into, result->mesh.net.cable[p->cable].name);
		last = p->cable;
		hawser__json_numbers(json, list, NULL, row, 5, 1.0);
	}
}

struct body_row {
	const char *name;
	double turn[3];
};
static const struct hawser__field body_field[] = {
	{"name", NULL, "of the body", HAWSER__AT(struct body_row, name)},
	{"turn", NULL, "its turn from the scene: angle times axis, rad", HAWSER__AT(struct body_row, turn)},
	HAWSER__END,
};
static const void *body_row(void *to, const void *parent, size_t i)
{
	const struct hawser_net_body *body = &((const struct result *)parent)->st.body[i];
	struct body_row *row = to;

	row->name = body->name;
	turn_of(row->turn, body);
	return row;
}
static const struct hawser__list body_list = HAWSER__MADE_ROWS(
	struct body_row, body_field, struct result, st.bodies, body_row);

#define OF(member) HAWSER__AT(struct result, member)
static const struct hawser__field net_field[] = {
	{"method", NULL, "by which they are computed", OF(st.method)},
	{"nodes", NULL, "place of each node, by name", CLI_NODES_AT(struct result, st.x, cli_nodes), METRE},
	{"cables", NULL, "in the order of the scene", HAWSER__OBJECTS_OF(member_list)},
	{"reactions", NULL, "forces of the supports on the net, by name of the node",
	 CLI_NODES_AT(struct result, st.reaction, cli_supports), NEWTON},
	{"bodies", NULL, "rigid bodies", HAWSER__OBJECTS_OF(body_list), .when = BODIES},
	{"energy", NULL, "strain energy minus loads times places", OF(st.energy), .unit = HAWSER__J},
	{"gap", NULL, "the energy is at most this above the least one; null: not known", OF(st.gap),
	 .unit = HAWSER__J, .flags = HAWSER__NULL | HAWSER__INFINITE},
	{"residual", NULL, "largest force that is not balanced", OF(st.residual), NEWTON},
	{"floor", NULL, "what round-off allows", OF(st.floor), NEWTON},
	{"", NULL, "", HAWSER__PART_OF(struct result, mesh, cli_mesh_field)},
	{"unknowns", NULL, "of the mesh", OF(st.unknowns)},
	{"iterations", NULL, "of the method", OF(st.iterations)},
	{"", NULL, "", HAWSER__PART_OF(struct result, contacts, cli_apart_field), .when = SURFACES},
	{"", NULL, "", HAWSER__PART_OF(struct result, stiffness, cli_stiffness_member)},
	{"profile", NULL, "with --profile, of each cable: [S, x, y, z, T], m and N",
	 HAWSER__CALLS(profile_json), .when = PROFILE},
	HAWSER__END,
};
#undef OF

const struct cli_listing cli_statics_net_listing[] = {
	{"Columns of a net:", member_field, 0},
	{"Columns of a net with --profile:", point_field, 0},
	{"Columns of a net with --stiffness:", cli_stiffness_field, 0},
	{"Columns of a net with --equilibria:", cli_equilibria_net_field, 0},
	{"Keys of JSON of a net:", net_field, 1},
	{"Keys of JSON of a net with --equilibria:", cli_equilibria_net_member, 1},
	{NULL, NULL, 0},
};

static struct cli_head head(const void *of)
{
	const struct result *result = of;
	struct cli_head head = cli_si_head(
		result->common, "statics", result->st.method, &result->mesh.net,
		(result->mesh.net.surfaces ? SURFACES : 0u) |
		(result->mesh.net.water.density > 0.0 && !result->mesh.net.winds ? WATER : 0u) |
		(result->st.bodies ? BODIES : 0u) | (result->profile ? PROFILE : 0u) |
		(result->stiffness.rows ? CLI_STIFFNESS : 0u) |
		(result->stiffness.rows > 3 ? CLI_STIFFNESS_TURNS : 0u));

	head.rows = result->stiffness.rows ? &result->stiffness : NULL;
	head.list = result->stiffness.rows ? &cli_stiffness_list
		: result->profile ? &point_list : &member_list;
	return head;
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct result *result = of;

	return result->mesh.net.water.density > 0.0
		? hawser__plot_mooring(path, &result->mesh.net, &result->st, report)
		: hawser__plot_net(path, &result->mesh.net, &result->st, report);
}

static const struct cli_showing showing = {.head = head, .comments = comments,
                                           .fields = net_field, .draw = draw};

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

enum hawser_status cli_statics_net(const void *settings, struct hawser_report *report)
{
	const struct cli_statics_kinds *kinds = settings;
	struct result result = {.common = &kinds->common, .profile = kinds->profile};
	struct hawser_net_options options = {.method = kinds->method};
	enum hawser_status status;

	if (kinds->equilibria)
		return cli_equilibria_net(&kinds->common, kinds->equilibria, report);
	status = method_of(kinds->method, report);
	if (!status)
		status = cli_vtk_check(kinds->vtk, "statics", report);
	if (!status)
		status = cli_mesh_open(&result.mesh.net, &kinds->common, report);
	if (!status)
		status = hawser_net_solve(&result.st, &result.mesh.net, &options, report);
	if (!status)
		status = hawser_net_mesh_error(&result.mesh.error, &result.mesh.net, &result.st, report);
	if (!status)
		status = cli_stiffness_fill(&result.stiffness, &result.mesh.net, kinds->stiffness, kinds->about,
		                            report);
	result.contacts = (struct cli_contacts){&result.mesh.net, result.st.contact, result.st.contacts,
	                                        result.st.apart};
	if (!status)
		warn(&result);
	if (!status && kinds->vtk)
		status = cli_contacts_vtk(kinds->vtk, &result.mesh.net, &result.st, report);
	if (!status && *result.warning)
		cli_warn(result.warning);
	if (!status)
		status = cli_show(&kinds->common, &showing, &result, report);
	hawser_net_statics_clear(&result.st);
	hawser_net_clear(&result.mesh.net);
	return status;
}
