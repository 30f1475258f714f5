/* net/motion/motion-result.c - memory of the result of a motion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "net/motion/motion.h"

void hawser_net_motion_clear(struct hawser_net_motion *motion)
{
	if (!motion)
		return;
	hawser__hold_clear(&(struct hawser__hold){.last = motion->held});
	free(motion->contact);
	free(motion->failure);
	free(motion->winch);
	free(motion->state);
	memset(motion, 0, sizeof *motion);
}

enum hawser_status hawser__motion_rows(struct hawser_net_motion *to, size_t rows, size_t probes,
                                       struct hawser_report *report)
{
	struct hawser__hold hold = {0};

	to->time = hawser__hold(&hold, rows, sizeof *to->time);
	to->x = hawser__hold(&hold, rows*probes + 1, sizeof *to->x);
	to->v = hawser__hold(&hold, rows*probes + 1, sizeof *to->v);
	to->T = hawser__hold(&hold, rows*probes + 1, sizeof *to->T);
	to->pull = hawser__hold(&hold, rows*probes + 1, sizeof *to->pull);
	to->kinetic = hawser__hold(&hold, rows, sizeof *to->kinetic);
	to->potential = hawser__hold(&hold, rows, sizeof *to->potential);
	to->work = hawser__hold(&hold, rows, sizeof *to->work);
	to->dissipated = hawser__hold(&hold, rows, sizeof *to->dissipated);
	to->slack = hawser__hold(&hold, rows, sizeof *to->slack);
	to->touching = hawser__hold(&hold, rows, sizeof *to->touching);
	to->sliding = hawser__hold(&hold, rows, sizeof *to->sliding);
	to->friction = hawser__hold(&hold, rows, sizeof *to->friction);
	to->impacts = hawser__hold(&hold, rows, sizeof *to->impacts);
	to->apart = hawser__hold(&hold, rows, sizeof *to->apart);
	to->held = hold.last;
	return hold.short_of_memory ? hawser__no_memory(report, "net") : HAWSER_OK;
}
