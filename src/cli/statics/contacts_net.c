/* cli/statics/contacts_net.c - see statics_kinds.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "cli/statics/statics_kinds.h"
#include "core/report.h"
#include "output/report/vtk.h"

static double rubs(const struct hawser_net_contact *contact)
{
	const double *f = contact->friction;

	return sqrt(f[0]*f[0] + f[1]*f[1] + f[2]*f[2]);
}

static void comment(struct hawser__table *table, const struct hawser_net *net,
                    const struct hawser_net_statics *st, int surface)
{
	double length = 0.0, r = 0.0, friction = 0.0;
	int count = 0, stick = 0;

	for (int i = 0; i < st->contacts; i++) {
		const struct hawser_net_contact *contact = &st->contact[i];

		if (contact->surface != surface)
			continue;
		count++;
		stick += contact->sticks;
		length += contact->length0;
		r += contact->r;
		friction += rubs(contact);
	}
	if (count == 0)
		hawser__table_comment(table, "%s is not touched", net->surface[surface].name);
	else if (!(net->surface[surface].friction > 0.0))
		hawser__table_comment(table, "%s: %d nodes touch, %.9g m of unstretched length, normal forces "
		                      "%.9g N", net->surface[surface].name, count, length, r);
	else
		hawser__table_comment(table, "%s: %d nodes touch, %.9g m of unstretched length, normal forces "
		                      "%.9g N, friction %.9g N; %d stick, %d slide", net->surface[surface].name,
		                      count, length, r, friction, stick, count - stick);
}

void cli_contacts_comments(struct hawser__table *table, const struct hawser_net *net,
                           const struct hawser_net_statics *st)
{
	int at_rest = 0;
	double most = 0.0;

	if (!net->surfaces)
		return;
	for (int i = 0; i < st->contacts; i++)
		most = fmax(most, rubs(&st->contact[i]));
	for (int i = 0; i < net->surfaces; i++) {
		at_rest += net->surface[i].friction > 0.0;
		comment(table, net, st, i);
	}
	if (at_rest && !net->contact.history && most == 0.0)
		hawser__table_comment(table, "no friction: at rest it depends on the way here%s", net->bodies
		                      ? ", which is not known of bodies" : ": give it by contact.sliding: "
		                        "history and contact.path");
	hawser__table_comment(table, "contacts: penetration, and gap of what touches, at most %.1e m",
	                      st->apart);
}

static const char *state(const struct hawser_net_contact *contact)
{
	return !contact ? "open" : contact->sticks ? "stick" : "slip";
}

struct row {
	const char *obstacle, *node, *cable;
	double S;
	struct hawser_net_contact of;
};

HAWSER__OF(state_of, const char *, struct row, state(&of->of))

#define OF(member) HAWSER__AT(struct row, member)
static const struct hawser__field contact_field[] = {
	{"obstacle", NULL, "which is touched", OF(obstacle)},
	{"node", NULL, "the node of the net", OF(node), .flags = HAWSER__OMIT},
	{"cable", NULL, "or the cable", OF(cable), .flags = HAWSER__OMIT},
	{"S", NULL, "unstretched length there", OF(S), .unit = HAWSER__METRE, .flags = HAWSER__OMIT},
	{"position", NULL, "the place", OF(of.x), .unit = HAWSER__METRE},
	{"r_N", NULL, "force of the obstacle along its normal", OF(of.r), .unit = HAWSER__NEWTON},
	{"r_T", NULL, "its force along the surface", OF(of.friction), .unit = HAWSER__NEWTON},
	{"state", NULL, "stick or slip", HAWSER__TEXT_BY(state_of)},
	HAWSER__END,
};
#undef OF

static const void *contact_row(void *to, const void *parent, size_t i)
{
	const struct cli_contacts *all = parent;
	const struct hawser_net_contact *of = &all->contact[i];
	struct row *row = to;

	*row = (struct row){.obstacle = all->net->surface[of->surface].name, .of = *of,
	                    .S = of->node < 0 ? of->S : NAN};
	if (of->node >= 0)
		row->node = all->net->node[of->node].name;
	else
		row->cable = all->net->cable[of->cable].name;
	return row;
}
static const struct hawser__list contact_list = HAWSER__MADE_ROWS(
	struct row, contact_field, struct cli_contacts, contacts, contact_row);

const struct hawser__field cli_contacts_field[] = {
	{"contacts", NULL, "with obstacles: nodes that touch", HAWSER__OBJECTS_OF(contact_list)},
	HAWSER__END,
};
const struct hawser__field cli_apart_field[] = {
	{"", NULL, "", HAWSER__OBJECT_OF(cli_contacts_field)},
	{"complementarity", NULL, "largest penetration of an obstacle, or gap of what touches",
	 HAWSER__AT(struct cli_contacts, apart), .unit = HAWSER__METRE},
	HAWSER__END,
};

/* The first contact of the node of the mesh at a point, or NULL. Those along cables are in the order of
 * cables and S; those of nodes of the net come first, in the order of nodes. */
static const struct hawser_net_contact *contact_of(const struct hawser_net *net,
                                                   const struct hawser_net_statics *st,
                                                   const struct hawser_net_point *point)
{
	const struct hawser_net_cable *cable = &net->cable[point->cable];
	double step = st->member[point->cable].length0/cable->elements;
	int node = point->S < 0.5*step ? cable->from
	           : point->S > st->member[point->cable].length0 - 0.5*step ? cable->to : -1;
	int low = 0, high = st->contacts;

	while (low < high) {
		int mid = low + (high - low)/2;
		const struct hawser_net_contact *of = &st->contact[mid];
		int before = node >= 0 ? of->node >= 0 && of->node < node
			: of->node >= 0 || of->cable < point->cable ||
			  (of->cable == point->cable && of->S < point->S - 0.5*step);

		low = before ? mid + 1 : low;
		high = before ? high : mid;
	}
	if (low == st->contacts)
		return NULL;
	if (node >= 0)
		return st->contact[low].node == node ? &st->contact[low] : NULL;
	return st->contact[low].cable == point->cable && st->contact[low].S < point->S + 0.5*step
		? &st->contact[low] : NULL;
}

struct cli_touch cli_contacts_at(const struct hawser_net *net, const struct hawser_net_statics *st,
                                 const struct hawser_net_point *point)
{
	const struct hawser_net_contact *contact = net->surfaces ? contact_of(net, st, point) : NULL;

	return (struct cli_touch){contact ? net->surface[contact->surface].name : "-", state(contact),
	                          contact ? contact->r : 0.0, contact ? rubs(contact) : 0.0};
}

enum hawser_status cli_contacts_vtk(const char *path, const struct hawser_net *net,
                                    const struct hawser_net_statics *st, struct hawser_report *report)
{
	size_t points = (size_t)st->points + 1;
	int (*end)[2] = malloc(points*sizeof *end), lines = 0;
	double (*x)[3] = malloc(points*sizeof *x), *value = calloc(4*points, sizeof *value);
	double *T = value, *touch = T + points, *r = touch + points, *cable = r + points;
	const struct hawser__vtk_scalar scalar = {"cable", cable},
	                                mark[] = {{"tension_N", T}, {"contact", touch}, {"r_N", r}};
	enum hawser_status status = end && x && value ? HAWSER_OK : hawser__no_memory(report, "statics");

	for (int p = 0; p < st->points && !status; p++) {
		const struct hawser_net_point *point = &st->point[p];
		const struct hawser_net_contact *contact = net->surfaces ? contact_of(net, st, point) : NULL;

		for (int k = 0; k < 3; k++)
			x[p][k] = point->x[k];
		T[p] = point->T;
		touch[p] = !contact ? HAWSER_NET_OPEN : contact->sticks ? HAWSER_NET_STICK : HAWSER_NET_SLIP;
		r[p] = contact ? contact->r : 0.0;
		if (p == 0 || point->cable != point[-1].cable)
			continue;
		end[lines][0] = p - 1;
		end[lines][1] = p;
		cable[lines++] = point->cable + 1;
	}
	if (!status)
		status = hawser__vtk_write(path, &(struct hawser__vtk){
			.title = "hawser statics: a net in equilibrium", .points = st->points, .lines = lines,
			.x = (const double (*)[3])x, .end = (const int (*)[2])end, .scalars = 1, .scalar = &scalar,
			.marks = net->surfaces ? 3 : 1, .mark = mark}, report);
	free(end);
	free(x);
	free(value);
	return status;
}
