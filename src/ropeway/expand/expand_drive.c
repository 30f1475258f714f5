/* ropeway/expand/expand_drive.c - ends of the rope that are moved along it.
 *
 *   F_s     force of mode s along the rope at the end; S = 1 at end B, -1 at end A
 *   r       motion of the end of each lane, towards end B
 *   Z       static response of the whole rope to it
 *
 * The coordinate of Z along mode s is - sum S F_s r/omega_s^2 over the lanes, by reciprocity, so that
 * the motion is the force - sum S F_s r on it, and the modes that are not kept follow with Z + sum S
 * F_s r/omega_s^2 Phi_s.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "ropeway/expand/expand.h"

/* Whether the segment is at the end of a lane that moves. */
static int moves(const struct hawser__lmode_segment *s, const struct hawser__lmode *rope,
                 const struct hawser__lexpand_force *force)
{
	int lane = s->piece->lane;

	return s->piece->piece == (force->end ? rope->lane[lane]->pieces - 1 : 0) &&
	       force->motion[lane] != 0.0;
}

/* Displacements of the ends of segments; 0: none moves. */
static int lift_ends(double (*lift)[HAWSER__ENDS][2], const struct hawser__lmode *rope,
                     const struct hawser__lmode_system *system,
                     const struct hawser__lexpand_force *force)
{
	int end = force->end, any = 0;

	for (int k = 0; system->plane == HAWSER_IN_PLANE && k < system->segments; k++) {
		const struct hawser__lmode_segment *s = &system->segment[k];
		double angle = s->piece->angle[end] - atan2(s->piece->reference[1], s->piece->reference[0]);

		if (!moves(s, rope, force))
			continue;
		lift[k][end][0] = force->motion[s->piece->lane]*cos(angle);
		lift[k][end][1] = force->motion[s->piece->lane]*sin(angle);
		any = 1;
	}
	return any;
}

/* Sum of S F_s r of a mode. */
static double pull_of(const struct hawser__lexpand_shape *mode, const struct hawser__lmode *rope,
                      const struct hawser__lexpand_force *force)
{
	const struct hawser__lmode_system *system = &rope->system[mode->system];
	double sum = 0.0;

	for (int k = 0; system->plane == HAWSER_IN_PLANE && k < system->segments; k++) {
		const struct hawser__lmode_segment *s = &system->segment[k];
		double strain, sign = force->end ? 1.0 : -1.0;

		if (!moves(s, rope, force))
			continue;
		hawser__grid_at(&strain, &s->grid, mode->strain + s->strain, 1, 1,
		                force->end ? s->grid.edge[s->grid.elements] : 0.0);
		sum += sign*force->motion[s->piece->lane]*strain/s->sa;
	}
	return sum;
}

static enum hawser_status check(const struct hawser__lmode *rope,
                                const struct hawser__lexpand_force *force,
                                struct hawser_report *report)
{
	for (int lane = 0; lane < rope->lanes; lane++) {
		const struct hawser_line_statics *st = rope->lane[lane];

		if (st->piece[force->end ? st->pieces - 1 : 0].sheave >= 0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line rom", "the end that the drive moves "
			                    "is on a sheave: let the line end in a span, before the drive's wheel");
	}
	return HAWSER_OK;
}

enum hawser_status hawser__lexpand_drive(double *row, double *pull,
                                         const struct hawser__lexpand_modes *t,
                                         const struct hawser__lexpand_force *force,
                                         struct hawser_report *report)
{
	const struct hawser__lmode *rope = &t->rope;
	enum hawser_status status = check(rope, force, report);

	for (int i = 0; i < rope->systems && !status; i++) {
		struct hawser__lmode_system *system = &rope->system[i];
		struct hawser__lexpand_part part = hawser__lexpand_part(rope, row, i);
		double (*lift)[HAWSER__ENDS][2] = calloc((size_t)system->segments + 1, sizeof *lift);
		double *load = hawser__numbers((size_t)system->size, 1);
		const struct hawser__lmode_given given = {
			.lift = (const double (*)[HAWSER__ENDS][2])lift};

		if (!lift || !load)
			status = hawser__no_memory(report, "line rom");
		else if (lift_ends(lift, rope, system, force))
			hawser__lmode_static_given(part.x, part.strain, system, load, &given);
		for (int j = 0; j < t->search.n && !status; j++) {
			const struct hawser__lexpand_shape *mode = &t->shape[j];

			if (mode->system != i)
				continue;
			pull[j] = pull_of(mode, rope, force);
			cblas_daxpy(system->size, pull[j]/(mode->omega*mode->omega), mode->x, 1, part.x, 1);
			cblas_daxpy(system->strains, pull[j]/(mode->omega*mode->omega), mode->strain, 1,
			            part.strain, 1);
		}
		free(lift);
		free(load);
	}
	return status;
}
