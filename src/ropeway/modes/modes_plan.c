/* ropeway/modes/modes_plan.c - what can move in a rope over sheaves: pieces, nodes, and independent
 * systems.
 *
 *   run      the free rope between two sheaves or ends, with the masses on it
 *   chain    pieces and nodes between two points that do not move
 *   system   chains that share a border, such as the carriage that carries both lanes: one eigenproblem
 *
 * A point on a circle moves along it. Its second-order displacement, -u^2/(2R) along the outward
 * normal, does work against the contact force N of a mass that is carried there: a stiffness -N/R, the
 * curvature term of the constraint. For the weight of the rope on an arc it is -w n_y/R per length
 * (modes_grid.c), and for a sheave of radius 0 its limit, w (sin a_out - sin a_in)/g with the stretch
 * g.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "ropeway/modes/modes.h"

/* Arcs shorter than this part of the unit of length are points. */
static const double shortest = 1e-12;
enum kind { FIXED, NODE, BORDER };

/* The point at which the rope is on its way from A to B. */
struct place {
	enum kind kind;
	int index;            /* of the node or border */
};

static const struct hawser_line_sheave *sheave_of(const struct hawser__lmode *rope, int lane,
                                                  int sheave)
{
	return &rope->lane[lane]->line->sheave[sheave];
}

/* --- what moves --- */

/* Does the sheave turn with two parts of the rope that are not joined on it? */
static int divided(const struct hawser__lmode *rope, int lane, int sheave)
{
	const struct hawser_line_statics *st = rope->lane[lane];
	int groups = 0, on = 0;

	for (int i = 1; i < st->pieces; i++) {
		int here = hawser__lmode_joint(rope, lane, i).sheave == sheave;

		groups += here && !on;
		on = here && st->piece[i].sheave == sheave;
	}
	return groups > 1;
}

static int border_of(struct hawser__lmode_draft *t, int freedom, int lane, int sheave)
{
	for (int i = 0; i < t->borders; i++)
		if (t->border[i].freedom == freedom && t->border[i].sheave == sheave &&
		    (freedom >= 0 || t->border[i].lane == lane))
			return i;
	t->border[t->borders] = (struct hawser__lmode_border){.freedom = freedom, .lane = lane,
	                                                     .sheave = sheave};
	return t->borders++;
}

/* rho d: the unit of mass. */
static double unit_mass(const struct hawser__lmode *rope)
{
	return rope->lane[0]->line->rho*rope->length;
}

static double turning(const struct hawser__lmode *rope, int lane, int sheave)
{
	const struct hawser_line_sheave *at = sheave_of(rope, lane, sheave);

	return at->radius > 0.0 ? at->inertia/(at->radius*at->radius)/unit_mass(rope) : 0.0;
}

static struct place new_node(struct hawser__lmode_draft *t, int dofs)
{
	t->node[t->nodes] = (struct hawser__lmode_node){.dofs = dofs};
	t->node_chain[t->nodes] = t->chains;
	return (struct place){NODE, t->nodes++};
}

/* What the joint moves with. */
static struct place place_of(struct hawser__lmode_draft *t, const struct hawser__lmode_joint *joint,
                             int lane)
{
	const struct hawser__lmode *rope = t->rope;
	struct place place = {FIXED, -1};

	if (joint->sheave < 0)
		return new_node(t, t->plane == HAWSER_IN_PLANE ? 2 : 1);
	if (t->plane == HAWSER_OUT_OF_PLANE)
		return rope->options.loose ? new_node(t, 1) : place;
	if (rope->options.contact == HAWSER_LINE_STICK)
		return place;
	if (rope->options.contact == HAWSER_LINE_SLIP)
		return new_node(t, 1);
	if (divided(rope, lane, joint->sheave)) {
		int known = t->borders;

		place = (struct place){BORDER, border_of(t, -1, lane, joint->sheave)};
		if (t->borders > known)
			t->border[place.index].mass = turning(rope, lane, joint->sheave);
		return place;
	}
	place = new_node(t, 1);
	t->node[place.index].mass[0][0] = turning(rope, lane, joint->sheave);
	return place;
}

static void add_to(struct hawser__lmode_draft *t, struct place place, double mass, double stiffness)
{
	if (place.kind == NODE) {
		t->node[place.index].mass[0][0] += mass;
		t->node[place.index].stiffness[0][0] += stiffness;
	} else if (place.kind == BORDER) {
		t->border[place.index].mass += mass;
		t->border[place.index].stiffness += stiffness;
	}
}

/* x[2] and y[2]: the horizontal and the vertical displacement per value of the place. */
static void axes_of(double x[2], double y[2], const struct hawser__lmode_draft *t,
                    const struct hawser__lmode_joint *joint,
                    const struct hawser__lmode_piece *behind)
{
	double angle = joint->sheave >= 0 ? joint->tangent[1]
		: atan2(behind->reference[1], behind->reference[0]);

	if (t->plane == HAWSER_OUT_OF_PLANE) {
		x[0] = 1.0; /* along z */
		x[1] = y[0] = y[1] = 0.0;
	} else {
		x[0] = y[1] = cos(angle);
		y[0] = sin(angle);
		x[1] = -y[0];
		if (joint->sheave >= 0)
			x[1] = y[1] = 0.0;
	}
}

/* Along one axis, on which the point moves by along[2] per value of the place. */
static void add_pendulum(struct hawser__lmode_draft *t, struct place place,
                         const struct hawser__lmode_pendulum *like, const double along[2], double soft)
{
	struct hawser__lmode_pendulum *to = &t->pendulum[t->pendulums++];

	*to = *like;
	to->node = place.kind == NODE ? place.index : -1;
	to->border = place.kind == BORDER ? place.index : -1;
	to->along[0] = along[0];
	to->along[1] = along[1];
	to->vertical = soft > 0.0;
	to->compliance = like->length/like->weight*(soft > 0.0 ? soft/(1.0 + soft) : 1.0);
}

static void add_mass(struct hawser__lmode_draft *t, struct place place,
                     const struct hawser__lmode_joint *joint, int lane,
                     const struct hawser__lmode_piece *behind)
{
	const struct hawser_line *line = t->rope->lane[lane]->line;
	const struct hawser_line_mass *mass = &line->mass[joint->mass];
	double m = (mass->mass + mass->body)/unit_mass(t->rope), x[2], y[2], soft = t->rope->soft;
	const struct hawser__lmode_pendulum like = {.mass = m,
		.length = mass->hanger/t->rope->length,
		.weight = (mass->mass*line->g + mass->hung)/t->rope->force,
		.carrier = hawser__lmode_carrier(t->rope, lane, joint->mass)};
	int hangs = like.length > 0.0 && like.weight > 0.0 && !(soft > 0.0 && joint->sheave >= 0);

	if (place.kind == FIXED || !(m > 0.0))
		return;
	axes_of(x, y, t, joint, behind);
	for (int i = 0; i < 2; i++)
		for (int j = 0; j < 2; j++) {
			double share = m*((hangs && soft > 0.0 ? 0.0 : y[i]*y[j]) + (hangs ? 0.0 : x[i]*x[j]));

			if (place.kind == NODE)
				t->node[place.index].mass[i][j] += share;
			else if (i == 0 && j == 0)
				t->border[place.index].mass += share;
		}
	if (hangs)
		add_pendulum(t, place, &like, x, 0.0);
	if (hangs && soft > 0.0 && t->plane == HAWSER_IN_PLANE)
		add_pendulum(t, place, &like, y, soft);
}

/* Stiffness of what is carried at the joint itself. */
static enum hawser_status add_contact(struct hawser__lmode_draft *t, struct place place,
                                      const struct hawser__lmode_joint *joint,
                                      int lane, struct hawser_report *report)
{
	const struct hawser__lmode *rope = t->rope;
	const struct hawser_line_sheave *sheave = sheave_of(rope, lane, joint->sheave);
	const struct hawser_line_statics *st = rope->lane[lane];

	if (t->plane == HAWSER_OUT_OF_PLANE || place.kind == FIXED)
		return HAWSER_OK;
	if (sheave->radius > 0.0) {
		if (joint->mass >= 0 && !rope->options.printed)
			add_to(t, place, 0.0, -st->carrier[joint->mass].carried*rope->length/
			                      (sheave->radius*rope->force));
		return HAWSER_OK;
	}
	if (joint->mass >= 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line modes", "a mass is on sheave %s, whose "
		                    "radius is 0: no rope can carry it around such a point, give the sheave a "
		                    "radius", sheave->name);
	if (rope->options.printed)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line modes", "sheave %s has the radius 0: "
		                    "without the curvature term of the constraint its stiffness is infinite",
		                    sheave->name);
	add_to(t, place, 0.0, hawser__lmode_delta(rope, lane)*
	                      (sin(joint->tangent[1]) - sin(joint->tangent[0]))/
	                      (1.0 + st->contact[joint->sheave].T_in/st->line->EA));
	return HAWSER_OK;
}

/* A rigid arc: the rope on it, which turns with its sheave. */
static void add_arc(struct hawser__lmode_draft *t, struct place place,
                    const struct hawser__lmode_piece *piece)
{
	const struct hawser_line_sheave *sheave = sheave_of(t->rope, piece->lane, piece->sheave);
	double mean = piece->angle[0] == piece->angle[1] ? cos(piece->angle[0])
		: (sin(piece->angle[1]) - sin(piece->angle[0]))/(piece->angle[1] - piece->angle[0]);

	add_to(t, place, piece->length, t->rope->options.printed ? 0.0
	       : -piece->delta*sheave->side*mean*t->rope->length/sheave->radius*piece->length);
}

/* The displacement of an end of a segment by a unit of the joint's value. */
static void map_to(double map[2], const struct hawser__lmode_draft *t,
                   const struct hawser__lmode_piece *piece,
                   int arc, int end, const struct hawser__lmode_joint *joint)
{
	double V = piece->V + (end ? piece->delta*piece->length : 0.0), T = hypot(piece->H, V);
	double bent = piece->bent + (end ? piece->delta*piece->length : 0.0);
	double Tr = hypot(piece->reference[0], piece->reference[1]);
	double turn = joint->tangent[!end] - piece->angle[end], c, s;

	map[0] = 1.0;
	map[1] = 0.0;
	if (arc || t->plane == HAWSER_OUT_OF_PLANE)
		return;
	c = (piece->H*piece->reference[0] + V*piece->reference[1])/(T*Tr);
	s = piece->reference[0]*bent/(T*Tr);
	map[0] = c*cos(turn) - s*sin(turn);
	map[1] = s*cos(turn) + c*sin(turn);
}

static double *border_at(struct hawser__lmode_draft *t, int segment, int end, int component)
{
	return t->border_map + ((segment*HAWSER__ENDS + end)*2 + component)*t->borders_most;
}

/* Join an end of a segment to a place at a joint. */
static void attach(struct hawser__lmode_draft *t, int segment, int end, struct place place,
                   const struct hawser__lmode_joint *joint)
{
	struct hawser__lmode_segment *to = &t->segment[segment];
	double map[2];

	to->node[end] = place.kind == NODE ? place.index : -1;
	if (place.kind == FIXED)
		return;
	map_to(map, t, to->piece, to->arc, end, joint);
	if (place.kind == BORDER) {
		for (int c = 0; c < to->D; c++)
			border_at(t, segment, end, c)[place.index] += map[c];
	} else if (joint->sheave >= 0 || t->plane == HAWSER_OUT_OF_PLANE) {
		to->map[end][0][0] = map[0];
		to->map[end][1][0] = map[1];
	} else {
		to->map[end][0][0] = to->map[end][1][1] = 1.0;
	}
}

/* Join an end of a lane to its freedoms. */
static void attach_freedoms(struct hawser__lmode_draft *t, int segment, int end)
{
	const struct hawser_line_modes_options *o = &t->rope->options;
	struct hawser__lmode_segment *to = &t->segment[segment];
	const double *reference = to->piece->reference;
	double length = hypot(reference[0], reference[1]), c = reference[0]/length, s = reference[1]/length;

	for (int i = 0; i < o->freedoms; i++) {
		const double *u = o->freedom[i].end[to->piece->lane][end];
		int border;

		if (t->plane == HAWSER_OUT_OF_PLANE ? u[2] == 0.0 : u[0] == 0.0 && u[1] == 0.0)
			continue;
		border = border_of(t, i, -1, -1);
		t->border[border].mass = o->freedom[i].mass/unit_mass(t->rope);
		t->border[border].stiffness = o->freedom[i].stiffness*t->rope->length/t->rope->force;
		if (t->plane == HAWSER_OUT_OF_PLANE) {
			border_at(t, segment, end, 0)[border] += u[2];
		} else if (to->arc) {
			border_at(t, segment, end, 0)[border] += u[0]*cos(to->piece->angle[end]) +
			                                         u[1]*sin(to->piece->angle[end]);
		} else {
			border_at(t, segment, end, 0)[border] += c*u[0] + s*u[1];
			border_at(t, segment, end, 1)[border] += c*u[1] - s*u[0];
		}
	}
}

/* 1 if an arc does not deform: it is no segment. */
static int rigid(const struct hawser__lmode_draft *t, const struct hawser__lmode_piece *piece)
{
	const struct hawser_line_modes_options *o = &t->rope->options;

	if (piece->sheave < 0)
		return 0;
	if (piece->length < shortest)
		return 1;
	return t->plane == HAWSER_OUT_OF_PLANE ? !o->loose : o->contact != HAWSER_LINE_SLIP;
}

static int add_segment(struct hawser__lmode_draft *t, const struct hawser__lmode_piece *piece)
{
	int arc = piece->sheave >= 0;

	t->segment[t->segments] = (struct hawser__lmode_segment){
		.piece = piece, .index = (int)(piece - t->rope->piece), .arc = arc, .chain = t->chains,
		.D = !arc && t->plane == HAWSER_IN_PLANE ? 2 : 1, .node = {-1, -1}};
	return t->segments++;
}

static enum hawser_status walk(struct hawser__lmode_draft *t, int lane,
                               const struct hawser__lmode_piece *piece,
                               struct hawser_report *report)
{
	int count = t->rope->lane[lane]->pieces;
	struct place here = {FIXED, -1};
	struct hawser__lmode_joint joint = {.sheave = -1, .mass = -1};
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < count && !status; i++) {
		int still = rigid(t, &piece[i]), segment = still ? -1 : add_segment(t, &piece[i]);

		if (!still && i == 0)
			attach_freedoms(t, segment, 0);
		if (!still && i > 0)
			attach(t, segment, 0, here, &joint);
		if (still && t->plane == HAWSER_IN_PLANE && piece[i].length >= shortest)
			add_arc(t, here, &piece[i]);
		if (i + 1 == count) {
			if (!still)
				attach_freedoms(t, segment, 1);
			break;
		}
		joint = hawser__lmode_joint(t->rope, lane, i + 1);
		if (!still)
			here = place_of(t, &joint, lane);
		if (!still)
			attach(t, segment, 1, here, &joint);
		if (joint.mass >= 0)
			add_mass(t, here, &joint, lane, &piece[i + 1]);
		if (joint.sheave >= 0)
			status = add_contact(t, here, &joint, lane, report);
		if (here.kind != NODE)
			t->chains++;
	}
	t->chains++;
	return status;
}

static enum hawser_status draft_plane(struct hawser__lmode *rope, enum hawser_plane plane,
                                      struct hawser_report *report)
{
	size_t pieces = (size_t)rope->pieces + 1;
	struct hawser__lmode_draft t = {.rope = rope, .plane = plane,
	                                .borders_most = rope->options.freedoms + 1};
	struct hawser__hold hold = {.last = NULL};
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < rope->lanes; i++)
		t.borders_most += rope->lane[i]->line->sheaves;
	t.segment = hawser__hold(&hold, pieces, sizeof *t.segment);
	t.border_map = hawser__hold(&hold, 4*pieces*(size_t)t.borders_most, sizeof *t.border_map);
	t.node = hawser__hold(&hold, pieces, sizeof *t.node);
	t.node_chain = hawser__hold(&hold, pieces, sizeof *t.node_chain);
	t.root = hawser__hold(&hold, 2*pieces + 2, sizeof *t.root);
	t.pendulum = hawser__hold(&hold, 2*pieces, sizeof *t.pendulum);
	t.border = hawser__hold(&hold, (size_t)t.borders_most, sizeof *t.border);
	if (hold.short_of_memory)
		status = hawser__no_memory(report, "line modes");
	for (int lane = 0, at = 0; lane < rope->lanes && !status; at += rope->lane[lane++]->pieces)
		status = walk(&t, lane, rope->piece + at, report);
	if (!status)
		status = hawser__lmode_divide(&t, report);
	hawser__hold_clear(&hold);
	return status;
}

/* --- open --- */

static enum hawser_status check(const struct hawser__lmode *rope, struct hawser_report *report)
{
	const struct hawser_line *first = rope->lane[0]->line;

	for (int i = 1; i < rope->lanes; i++) {
		const struct hawser_line *line = rope->lane[i]->line;

		if (line->EA != first->EA || line->rho != first->rho ||
		    fabs(line->speed) != fabs(first->speed))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line modes", "the lanes differ in EA, "
			                    "rho or speed: they are parts of one rope");
	}
	for (int i = 0; i < rope->options.freedoms; i++) {
		const struct hawser_line_freedom *freedom = &rope->options.freedom[i];
		int in = 0, out = 0;

		for (int k = 0; k < HAWSER_LINE_LANES*HAWSER__ENDS; k++) {
			const double *u = freedom->end[k/2][k%2];

			in |= u[0] != 0.0 || u[1] != 0.0;
			out |= u[2] != 0.0;
		}
		if ((in && out) || !(freedom->mass >= 0.0 && isfinite(freedom->mass)) ||
		    !isfinite(freedom->stiffness))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line modes", "the freedom %s has a mass "
			                    "of %g kg, a stiffness of %g N/m and moves its ends %s: give a mass of "
			                    "0 or more, a finite stiffness, and motions in the plane or out of it",
			                    freedom->name, freedom->mass, freedom->stiffness,
			                    in && out ? "in both planes" : "in one plane");
	}
	for (int i = 0; i < rope->pieces; i++)
		if (rope->piece[i].sheave < 0 && !(hypot(rope->piece[i].H, rope->piece[i].V) > 0.0))
			return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "line modes", "the tension of the rope "
			                    "is not positive in piece %d, so that there are no modes", i + 1);
	return HAWSER_OK;
}

enum hawser_status hawser__lmode_open(struct hawser__lmode *rope,
                                     const struct hawser_line_statics *const *lane, int lanes,
                                     const struct hawser_line_modes_options *options, double soft,
                                     struct hawser_report *report)
{
	const struct hawser_line *line = lane[0]->line;
	double across = lane[0]->T_A*cos(lane[0]->angle_A);
	enum hawser_status status;

	*rope = (struct hawser__lmode){.lane = lane, .lanes = lanes, .options = *options, .soft = soft};
	rope->length = fabs(line->B[0] - line->A[0]);
	if (!(rope->length > 1e-3*lane[0]->length0))
		rope->length = lane[0]->length0;
	rope->force = across > 1e-3*lane[0]->T_A ? across : lane[0]->T_A;
	rope->epsilon = rope->force/line->EA;
	rope->nu = line->speed*sqrt(line->rho/rope->force);
	if (!(rope->epsilon*rope->nu*rope->nu < 1.0))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "line modes", "the rope runs at %g m/s, "
		                    "faster than its longitudinal waves", line->speed);
	for (int i = 0; i < lanes; i++) {
		rope->pieces += lane[i]->pieces;
		rope->masses += lane[i]->line->masses;
	}
	rope->piece = calloc((size_t)rope->pieces, sizeof *rope->piece);
	if (!rope->piece)
		return hawser__no_memory(report, "line modes");
	hawser__lmode_pieces(rope);
	status = check(rope, report);
	if (!status)
		status = draft_plane(rope, HAWSER_IN_PLANE, report);
	return status ? status : draft_plane(rope, HAWSER_OUT_OF_PLANE, report);
}

void hawser__lmode_clear(struct hawser__lmode *rope)
{
	for (int i = 0; i < rope->systems; i++)
		hawser__lmode_system_clear(&rope->system[i]);
	free(rope->system);
	free(rope->piece);
	*rope = (struct hawser__lmode){0};
}
