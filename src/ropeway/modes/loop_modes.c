/* ropeway/modes/loop_modes.c - the modes of a ropeway: its lanes and what joins them, as a line with
 * freedoms.
 *
 *   J, R    moment of inertia of a bullwheel, its radius: J/R^2 moves with the rope
 *   m       mass of the carriage; it moves the ends of both lanes along x
 *
 * A bullwheel that turns moves the end of one lane along the rope and that of the other lane back.
 * The half circle of rope on it, rho pi R, moves with it. Its weight is the stiffness (w/g) (sin out -
 * sin in) of doc/theory-ropeway-modes.md: rope that runs down into the bottom station and up again is
 * stable there, at the top station it is not, and both together let a bare loop circulate freely.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>

#include <hawser/ropeway_modes.h>

#include "core/report.h"

#define PI 3.14159265358979323846 /* to the digits of a double */

enum { END_A, END_B };

enum hawser_line_contact_kind hawser_ropeway_holds(const struct hawser_ropeway_statics *st)
{
	enum hawser_ropeway_hold hold = st->ropeway->hold;

	if (hold == HAWSER_ROPEWAY_HOLD_AUTO)
		return st->lane[0].line->speed > 0.0 ? HAWSER_LINE_SLIP : HAWSER_LINE_STICK;
	return (enum hawser_line_contact_kind)(hold - 1);
}

/* Mass of the rope on a bullwheel and of the wheel, kg. */
static double wheel_mass(const struct hawser_ropeway *rw, double radius, double inertia)
{
	return rw->rho*PI*radius + (inertia > 0.0 ? inertia/(radius*radius) : 0.0);
}

static void turn(struct hawser_line_freedom *freedom, const struct hawser_ropeway_statics *st, int end,
                 const char *name, double mass)
{
	*freedom = (struct hawser_line_freedom){.mass = mass};
	snprintf(freedom->name, sizeof freedom->name, "%s", name);
	for (int i = 0; i < HAWSER_ROPEWAY_LANES; i++) {
		const struct hawser_line_statics *line = &st->lane[i].st;
		double angle = end == END_A ? line->angle_A : line->angle_B;
		double T = end == END_A ? line->T_A : line->T_B, way = i == HAWSER_ROPEWAY_UP ? 1.0 : -1.0;
		double weight = st->ropeway->rho*st->ropeway->g/(1.0 + T/line->line->EA);

		freedom->stiffness += (end == END_A ? weight : -weight)*sin(angle);
		freedom->end[i][end][0] = way*cos(angle);
		freedom->end[i][end][1] = way*sin(angle);
	}
}

int hawser_ropeway_freedoms(struct hawser_line_freedom freedom[HAWSER_ROPEWAY_FREEDOMS],
                            const struct hawser_ropeway_statics *st)
{
	const struct hawser_ropeway *rw = st->ropeway;
	int count = 0, loop = st->lanes == HAWSER_ROPEWAY_LANES;

	if (rw->carriage > 0.0 && rw->tension <= HAWSER_ROPEWAY_T0) {
		struct hawser_line_freedom *to = &freedom[count++];

		*to = (struct hawser_line_freedom){
			.name = "carriage", .mass = loop ? rw->carriage + rw->rho*PI*rw->bottom_radius
			                                 : 0.5*rw->carriage};
		for (int i = 0; i < st->lanes; i++)
			to->end[i][END_A][0] = 1.0;
	}
	if (loop)
		turn(&freedom[count++], st, END_A, "bottom bullwheel",
		     wheel_mass(rw, rw->bottom_radius, rw->bottom_inertia));
	if (loop && rw->coasts)
		turn(&freedom[count++], st, END_B, "drive bullwheel",
		     wheel_mass(rw, rw->top_radius, rw->top_inertia));
	return count;
}

enum hawser_status hawser_ropeway_modes_solve(struct hawser_line_modes *modes,
                                              const struct hawser_ropeway_statics *st,
                                              const struct hawser_ropeway_modes_options *options,
                                              struct hawser_report *report)
{
	struct hawser_line_freedom freedom[HAWSER_ROPEWAY_FREEDOMS];
	const struct hawser_line_statics *lane[HAWSER_ROPEWAY_LANES] = {&st->lane[0].st, &st->lane[1].st};
	int reverse = st->ropeway->sliding == HAWSER_ROPEWAY_REVERSE;
	const struct hawser_line_modes_options o = {
		.n = options->n, .tolerance = options->tolerance, .printed = options->printed,
		.contact = hawser_ropeway_holds(st), .backward = {reverse, !reverse}, .freedom = freedom,
		.freedoms = hawser_ropeway_freedoms(freedom, st)};
	double speed = st->lane[0].line->speed;

	*modes = (struct hawser_line_modes){.n = 0};
	if (speed > 0.0 && o.contact == HAWSER_LINE_STICK)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes", "contact.modes is stick, but the "
		                    "rope runs at %.9g m/s (ropeway.top.drive.speed), so that it does not "
		                    "stick to its sheaves: choose slip or roll, or ropeway.sliding: rest",
		                    speed);
	return speed > 0.0 ? hawser_line_modes_running(modes, lane, st->lanes, &o, report)
	                   : hawser_line_modes_solve(modes, lane, st->lanes, &o, report);
}

/* The tower of a sheave. */
static int tower_of(const struct hawser_ropeway_statics *st, int lane, int sheave)
{
	int t = 0;

	while (t + 1 < st->ropeway->towers && st->lane[lane].first[t + 1] <= sheave)
		t++;
	return t;
}

/* The tower of the next contact from this piece on, in its lane; the number of towers: the top. */
static int next_tower(const struct hawser_line_modes *modes, const struct hawser_ropeway_statics *st,
                      int i)
{
	int lane = modes->piece[i].lane;

	for (; i < modes->pieces && modes->piece[i].lane == lane; i++)
		if (modes->piece[i].sheave >= 0)
			return tower_of(st, lane, modes->piece[i].sheave);
	return st->ropeway->towers;
}

void hawser_ropeway_modes_spans(int *of, const struct hawser_line_modes *modes,
                                const struct hawser_ropeway_statics *st)
{
	int last = -1;

	for (int i = 0; i < modes->pieces; i++) {
		const struct hawser_line_modes_piece *piece = &modes->piece[i];

		if (i == 0 || piece->lane != modes->piece[i - 1].lane)
			last = -1;
		if (piece->sheave >= 0)
			last = tower_of(st, piece->lane, piece->sheave);
		else if (piece->span >= 0)
			of[piece->span] = next_tower(modes, st, i) == last
				? -1 : piece->lane*(st->ropeway->towers + 1) + last + 1;
	}
}
