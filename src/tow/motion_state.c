/* tow/motion_state.c - the state of a towed body in a file (scene/state_file.h): that of the rod, then
 * the phase of vortex shedding of each element. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rod/run.h"
#include "scene/state_file.h"
#include "tow/motion.h"

static const char where[] = "tow", kind[] = "hawser tow state 1";

enum hawser_status hawser__tow_state_save(double **state, int *states,
                                          const struct hawser__tow_run *run, double h,
                                          struct hawser_report *report)
{
	int size = hawser__rod_state_size(run->motion.mesh);

	*states = size + run->rod.last;
	*state = calloc((size_t)*states, sizeof **state);
	if (!*state)
		return hawser__no_memory(report, where);
	hawser__rod_state_give(*state, &run->motion, h, 0.0);
	memcpy(*state + size, run->phase, (size_t)run->rod.last*sizeof **state);
	return HAWSER_OK;
}

enum hawser_status hawser__tow_state_read(struct hawser__tow_run *run, double *h, const char *path,
                                          struct hawser_report *report)
{
	int size = hawser__rod_state_size(run->motion.mesh);
	double *state, none, length;
	enum hawser_status status = hawser__state_read(&state, size + run->rod.last, kind, path, where,
	                                               report);
	const int good = state && hawser__rod_state_take(&run->motion, h, &none, state);

	if (good)
		memcpy(run->phase, state + size, (size_t)run->rod.last*sizeof *state);
	free(state);
	if (status)
		return status;
	if (!good)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "%s is no state of this cable with %d "
		                    "elements: give a file that a run of this scene has written with --state",
		                    path, run->rod.last);
	run->at = run->motion.t;
	length = run->motion.winch.length;
	hawser__rod_motion_factors(&run->motion, run->motion.t, 0);
	hawser__tow_shed(run);
	return hawser__rod_winch_same(&run->motion, length, path, report);
}

enum hawser_status hawser_tow_state_write(const struct hawser_tow_motion *motion, const char *path,
                                          struct hawser_report *report)
{
	return hawser__state_write(motion->state, motion->states, kind, path, report);
}
