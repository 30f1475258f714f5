/* net/motion/motion-result.c - memory of the result of a motion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/motion/motion.h"

void hawser_net_motion_clear(struct hawser_net_motion *motion)
{
	if (!motion)
		return;
	free(motion->time);
	free(motion->x);
	free(motion->v);
	free(motion->T);
	free(motion->pull);
	free(motion->kinetic);
	free(motion->potential);
	free(motion->work);
	free(motion->dissipated);
	free(motion->slack);
	free(motion->touching);
	free(motion->sliding);
	free(motion->friction);
	free(motion->impacts);
	free(motion->apart);
	free(motion->contact);
	free(motion->failure);
	free(motion->winch);
	free(motion->state);
	memset(motion, 0, sizeof *motion);
}

enum hawser_status hawser__motion_rows(struct hawser_net_motion *to, size_t rows, size_t probes,
                                       struct hawser_report *report)
{
	to->time = calloc(rows, sizeof *to->time);
	to->x = calloc(rows*probes + 1, sizeof *to->x);
	to->v = calloc(rows*probes + 1, sizeof *to->v);
	to->T = calloc(rows*probes + 1, sizeof *to->T);
	to->pull = calloc(rows*probes + 1, sizeof *to->pull);
	to->kinetic = calloc(rows, sizeof *to->kinetic);
	to->potential = calloc(rows, sizeof *to->potential);
	to->work = calloc(rows, sizeof *to->work);
	to->dissipated = calloc(rows, sizeof *to->dissipated);
	to->slack = calloc(rows, sizeof *to->slack);
	to->touching = calloc(rows, sizeof *to->touching);
	to->sliding = calloc(rows, sizeof *to->sliding);
	to->friction = calloc(rows, sizeof *to->friction);
	to->impacts = calloc(rows, sizeof *to->impacts);
	to->apart = calloc(rows, sizeof *to->apart);
	return to->time && to->x && to->v && to->T && to->pull && to->kinetic && to->potential &&
	       to->work && to->dissipated && to->slack && to->touching && to->sliding && to->friction &&
	       to->impacts && to->apart ? HAWSER_OK : hawser__no_memory(report, "net");
}
