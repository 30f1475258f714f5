/* ropeway/expand/expand_drive.c - an end of the rope that is moved along it.
 *
 *   F_s     force of mode s along the rope at the end; S = 1 at end B, -1 at end A
 *   Z       static response of the whole rope to a unit motion of the end
 *
 * The coordinate of Z along mode s is -S F_s/omega_s^2, by reciprocity, so that a motion r(t) of
 * the end is the force -S F_s r on it, and the modes that are not kept follow with Z + sum S
 * F_s/omega_s^2 Phi_s.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "ropeway/expand/expand_modes.h"

/* The segment in the plane at the end of a lane; its system. */
static const struct hawser__lmode_segment *find(const struct hawser__lmode *rope, int lane, int end,
                                                int *system)
{
	int piece = end ? rope->lane[lane]->pieces - 1 : 0;

	for (int i = 0; i < rope->systems; i++)
		for (int k = 0; rope->system[i].plane == HAWSER_IN_PLANE && k < rope->system[i].segments; k++)
			if (rope->system[i].segment[k].piece->lane == lane &&
			    rope->system[i].segment[k].piece->piece == piece) {
				*system = i;
				return &rope->system[i].segment[k];
			}
	return NULL;
}

enum hawser_status hawser__lexpand_drive(struct hawser__lexpand_modes *t, double *pull, int lane,
                                         int end, struct hawser_report *report)
{
	struct hawser__lmode *rope = &t->rope;
	int own = -1, n = t->search.n;
	const struct hawser__lmode_segment *s = find(rope, lane, end, &own);
	struct hawser__lmode_system *system;
	struct hawser__lmode_given given = {NULL, NULL};
	double (*lift)[HAWSER__ENDS][2], *load, angle, sign = end ? 1.0 : -1.0;

	if (!s || s->arc)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line rom", "the end that the drive moves is "
		                    "on a sheave: let the line end in a span, before the drive's wheel");
	system = &rope->system[own];
	lift = calloc((size_t)system->segments, sizeof *lift);
	load = calloc((size_t)system->size, sizeof *load);
	t->end_x = calloc((size_t)system->size, sizeof *t->end_x);
	t->end_strain = calloc((size_t)system->strains, sizeof *t->end_strain);
	if (!lift || !load || !t->end_x || !t->end_strain) {
		free(lift);
		free(load);
		return hawser__no_memory(report, "line rom");
	}
	angle = s->piece->angle[end] - atan2(s->piece->reference[1], s->piece->reference[0]);
	lift[s - system->segment][end][0] = cos(angle);
	lift[s - system->segment][end][1] = sin(angle);
	given.lift = (const double (*)[HAWSER__ENDS][2])lift;
	hawser__lmode_static_given(t->end_x, t->end_strain, system, load, &given);
	for (int j = 0; j < n; j++) {
		const struct hawser__lexpand_shape *mode = &t->shape[j];
		double strain, omega2 = mode->omega*mode->omega;

		pull[j] = 0.0;
		if (mode->system != own)
			continue;
		hawser__grid_at(&strain, &s->grid, mode->strain + s->strain, 1, 1,
		                end ? s->grid.edge[s->grid.elements] : 0.0);
		pull[j] = sign*strain/s->sa;
		cblas_daxpy(system->size, pull[j]/omega2, mode->x, 1, t->end_x, 1);
		cblas_daxpy(system->strains, pull[j]/omega2, mode->strain, 1, t->end_strain, 1);
	}
	t->shape[n] = (struct hawser__lexpand_shape){.system = own, .x = t->end_x,
	                                             .strain = t->end_strain};
	free(lift);
	free(load);
	return HAWSER_OK;
}
