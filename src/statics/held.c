/* statics/held.c - elastic supports of a solved span, whose ends are where they are in equilibrium
 * (yield.c): the preload of the springs is the static force of the cable.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/report.h"
#include <hawser/statics.h>

static const char where[] = "statics";

static enum hawser_status check(const struct hawser_held *held, char end, struct hawser_report *report)
{
	int springs = 0;

	for (int axis = 0; axis < 3; axis++) {
		springs += isfinite(held->stiffness[axis]);
		if (!(held->stiffness[axis] > 0.0))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "support.%c.stiffness[%d] = %g N/m: give a positive number, or .inf "
			                    "for a rigid support", end, axis, held->stiffness[axis]);
	}
	if (!(held->mass >= 0.0 && isfinite(held->mass)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "support.%c.mass = %g kg: give a finite number, 0 or more", end,
		                    held->mass);
	if (held->mass > 0.0 && !springs)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "support.%c.mass = %g kg at an end that is rigid: give "
		                    "support.%c.stiffness, or leave the mass out", end, held->mass, end);
	return HAWSER_OK;
}

int hawser_statics_held(struct hawser_held *held, const struct hawser_scene *scene)
{
	int elastic = 0;

	for (int end = 0; end < 2; end++) {
		held[end] = (struct hawser_held){{INFINITY, INFINITY, INFINITY}, 0.0, 0.0};
		if (!scene->support[end].present)
			continue;
		held[end].mass = scene->support[end].mass;
		for (int axis = 0; axis < 3; axis++) {
			held[end].stiffness[axis] = scene->support[end].stiffness[axis];
			elastic |= isfinite(held[end].stiffness[axis]);
		}
	}
	return elastic;
}

enum hawser_status hawser_statics_hold(struct hawser_statics *st, const struct hawser_held *held,
                                       struct hawser_report *report)
{
	st->elastic = 0;
	for (int end = 0; end < 2; end++) {
		enum hawser_status status = check(&held[end], "AB"[end], report);

		if (status)
			return status;
		st->held[end] = held[end];
		st->held[end].m = held[end].mass/(st->span.rho*st->span.d);
		for (int axis = 0; axis < 3; axis++)
			st->elastic |= isfinite(held[end].stiffness[axis]);
	}
	if (st->elastic && st->turned && !st->space) { /* springs along x, y, z couple its planes */
		st->space = 1;
		st->azimuth[0] = 1.0;
		st->azimuth[1] = 0.0;
	}
	if (!st->elastic || st->motion.nu == 0.0)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
	                    "support.A.stiffness and support.B.stiffness contradict travel: elastic "
	                    "supports of a cable that travels are not modelled, remove one of them");
}
