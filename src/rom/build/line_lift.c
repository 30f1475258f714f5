/* rom/build/line_lift.c - the amplitude at which a mode takes the rope off a sheave.
 *
 *   beta     angle of contact at rest, of one arc
 *   phi      change of slope of the free rope before and behind the arc, by a unit of the mode
 *
 * The force of the sheave on the rope is some T beta, and vanishes where the angle of contact
 * does, in one direction of the motion or the other: at beta/|phi_before - phi_behind|. (The force
 * itself, as a linear function of the amplitude, contains the change of the tension too, and its
 * zero is wrong by that.)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "modes/grid.h"
#include "rom/terms/dampers.h"
#include "rom/build/line.h"

/* Change of slope of the rope at an end of a piece. */
static double slope_at(const struct hawser_line_modes *modes, int k, int piece, int end)
{
	const struct hawser_line_modes_piece *on = &modes->piece[piece];
	const struct hawser_line_piece *st = &modes->lane[on->lane]->piece[on->piece];
	double slope[3], T = (end ? st->T1 : st->T0)/modes->force_unit;

	if (on->grid.points == 0)
		return 0.0;
	hawser__grid_at(slope, &on->grid, modes->slope + 3*((size_t)k*(size_t)modes->points +
	                (size_t)on->first), 3, 3, end ? on->grid.edge[on->grid.elements] : 0.0);
	return slope[1]/(1.0 + modes->epsilon*T);
}

/* An arc of the rope on a sheave. */
struct arc {
	int before, behind; /* the free pieces beside it */
	int lane, sheave;
	double angle;       /* by which the tangent turns along it, signed */
};

/* The first arc of which piece `from` or a later one is a part; 0 if there is none. */
static int arc_from(struct arc *arc, const struct hawser_line_modes *modes, int from)
{
	const struct hawser_line_modes_piece *piece = modes->piece;
	int i = from > 1 ? from : 1;

	while (i + 1 < modes->pieces && piece[i].sheave < 0)
		i++;
	if (i + 1 >= modes->pieces)
		return 0;
	*arc = (struct arc){.before = i - 1, .lane = piece[i].lane, .sheave = piece[i].sheave};
	for (; i + 1 < modes->pieces && piece[i].lane == arc->lane && piece[i].sheave == arc->sheave; i++) {
		const struct hawser_line_piece *on = &modes->lane[arc->lane]->piece[piece[i].piece];

		arc->angle += on->angle1 - on->angle0;
	}
	arc->behind = i;
	return 1;
}

/* Change of the angle, relative to it, by a unit of mode k. */
static double turn(const struct arc *arc, const struct hawser_line_modes *modes, int k)
{
	return (slope_at(modes, k, arc->behind, 0) - slope_at(modes, k, arc->before, 1))/arc->angle;
}

static double largest(const struct hawser_line_modes *modes, int k)
{
	double most = 0.0;

	for (int p = 0; p < modes->points; p++) {
		const double *u = modes->shape + 3*((size_t)k*(size_t)modes->points + (size_t)p);

		most = fmax(most, sqrt(u[0]*u[0] + u[1]*u[1] + u[2]*u[2]));
	}
	return most;
}

void hawser_line_rom_lift(struct hawser_line_lift *lift, const struct hawser_line_modes *modes,
                          int k)
{
	struct arc arc;

	*lift = (struct hawser_line_lift){.lane = -1, .sheave = -1, .amplitude = INFINITY,
	                                  .motion = INFINITY};
	for (int i = 0; arc_from(&arc, modes, i); i = arc.behind) {
		const struct hawser_line_statics *st = modes->lane[arc.lane];
		double amplitude = 1.0/fabs(turn(&arc, modes, k));

		if (amplitude < lift->amplitude) {
			lift->lane = arc.lane;
			lift->sheave = arc.sheave;
			lift->force = hypot(st->contact[arc.sheave].force[0], st->contact[arc.sheave].force[1]);
			lift->amplitude = amplitude;
			lift->motion = amplitude*largest(modes, k)*modes->length_unit;
		}
	}
}

enum hawser_status hawser__line_contacts(struct hawser_rom *rom, const struct hawser_line_modes *modes,
                                         struct hawser_report *report)
{
	struct arc arc;
	int count = 0;
	enum hawser_status status;

	for (int i = 0; arc_from(&arc, modes, i); i = arc.behind)
		count += arc.angle != 0.0;
	status = count > 0 ? hawser__rom_init_contacts(rom, count, report) : HAWSER_OK;
	count = 0;
	for (int i = 0; !status && arc_from(&arc, modes, i); i = arc.behind) {
		if (arc.angle == 0.0)
			continue;
		rom->contacts.name[count] = strdup(modes->lane[arc.lane]->line->sheave[arc.sheave].name);
		if (!rom->contacts.name[count])
			return hawser__no_memory(report, "line rom");
		for (int j = 0; j < modes->n; j++)
			rom->contacts.turn[j*rom->contacts.count + count] = turn(&arc, modes, j);
		count++;
	}
	return status;
}
