/* hawser/ropeway_modes.h - natural modes of a ropeway about its statics: both lanes, the carriage of
 * the bottom station with its counterweight, the bullwheels, the carriers.
 *
 * The carriage moves along x if the tension is given by a counterweight or as T0, and if it has a
 * mass; its bullwheel turns; that of the drive keeps its speed, or turns if drive.inertia is given.
 * The rope on a bullwheel moves with it and does not stretch. A ropeway of one lane has half of the
 * carriage, and no bullwheels. The theory is in doc/theory-ropeway-modes.md.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_MODES_H
#define HAWSER_ROPEWAY_MODES_H

#include <hawser/line_modes.h>
#include <hawser/ropeway.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HAWSER_ROPEWAY_FREEDOMS = 3 }; /* at most: carriage, bottom bullwheel, drive bullwheel */

struct hawser_ropeway_modes_options {
	int n;            /* number of modes of both planes together; 0: 6 */
	double tolerance; /* required relative error of each frequency, 0: 1e-9 */
	int printed;      /* as in struct hawser_line_modes_options */
};

/* What the rope does on its sheaves in the modes of this state: as the scene says, or by itself. */
enum hawser_line_contact_kind hawser_ropeway_holds(const struct hawser_ropeway_statics *st);
/* The bodies that move ends of the rope; returns their number. */
int hawser_ropeway_freedoms(struct hawser_line_freedom freedom[HAWSER_ROPEWAY_FREEDOMS],
                            const struct hawser_ropeway_statics *st);
/* Modes about a state: real ones at rest, complex ones (modes->gyroscopic) if the rope runs. *modes is
 * overwritten, and refers to *st; release it with hawser_line_modes_clear. Statuses: those of
 * hawser_line_modes_running. */
enum hawser_status hawser_ropeway_modes_solve(struct hawser_line_modes *modes,
                                              const struct hawser_ropeway_statics *st,
                                              const struct hawser_ropeway_modes_options *options,
                                              struct hawser_report *report) HAWSER_MUST_CHECK;

/* The span between two towers (or stations) of a lane to which each span of the modes belongs.
 * of [modes->spans]: lane*(towers + 1) + number, counted from the bottom station; -1: within the train
 * of sheaves of one tower. */
void hawser_ropeway_modes_spans(int *of, const struct hawser_line_modes *modes,
                                const struct hawser_ropeway_statics *st);

#ifdef __cplusplus
}
#endif
#endif
