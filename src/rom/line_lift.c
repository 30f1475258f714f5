/* rom/line_lift.c - the amplitude at which a mode takes the rope off a sheave.
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
#include "config.h"

#include <math.h>

#include <hawser/line_rom.h>

#include "modes/grid.h"

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

/* 1 if pieces i and i + 1 are parts of one arc. */
static int continues(const struct hawser_line_modes *modes, int i)
{
	return i + 1 < modes->pieces && modes->piece[i + 1].lane == modes->piece[i].lane &&
	       modes->piece[i + 1].sheave == modes->piece[i].sheave;
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
	double beta = 0.0;
	int first = 0;

	*lift = (struct hawser_line_lift){.lane = -1, .sheave = -1, .amplitude = INFINITY,
	                                  .motion = INFINITY};
	for (int i = 1; i + 1 < modes->pieces; i++) {
		const struct hawser_line_modes_piece *on = &modes->piece[i];
		const struct hawser_line_statics *st = modes->lane[on->lane];
		double amplitude;

		if (on->sheave < 0)
			continue;
		if (modes->piece[i - 1].sheave != on->sheave || modes->piece[i - 1].lane != on->lane) {
			first = i;
			beta = 0.0;
		}
		beta += fabs(st->piece[on->piece].angle1 - st->piece[on->piece].angle0);
		if (continues(modes, i))
			continue;
		amplitude = beta/fabs(slope_at(modes, k, first - 1, 1) - slope_at(modes, k, i + 1, 0));
		if (amplitude < lift->amplitude) {
			lift->lane = on->lane;
			lift->sheave = on->sheave;
			lift->force = hypot(st->contact[on->sheave].force[0], st->contact[on->sheave].force[1]);
			lift->amplitude = amplitude;
			lift->motion = amplitude*largest(modes, k)*modes->length_unit;
		}
	}
}
