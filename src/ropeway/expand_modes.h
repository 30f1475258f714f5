/* ropeway/expand_modes.h - modes as the shapes of an expansion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_EXPAND_MODES_H
#define HAWSER_ROPEWAY_EXPAND_MODES_H

#include "ropeway/expand.h"

struct hawser__lexpand_modes {
	struct hawser__lmode rope;
	struct hawser__lmode_search search;    /* which refers to rope: the structure must not be moved */
	struct hawser__lexpand_shape *shape;   /* [search.n + 1]: the modes; one more may be added */
	double *end_x, *end_strain;            /* of that one, or NULL */
};

/* The lowest modes, and the same in the public structure. Both are to be cleared after a failure
 * too. */
enum hawser_status hawser__lexpand_modes_open(struct hawser__lexpand_modes *t,
                                              struct hawser_line_modes *modes,
                                              const struct hawser_line_statics *const *lane, int lanes,
                                              const struct hawser_line_modes_options *options,
                                              struct hawser_report *report);
void hawser__lexpand_modes_clear(struct hawser__lexpand_modes *t);

/* expand_drive.c: add, as the last shape, the static response of the modes that are not kept to a
 * unit motion of an end of a lane along the rope; pull[n] are the forces along the rope that the
 * modes have there. */
enum hawser_status hawser__lexpand_drive(struct hawser__lexpand_modes *t, double *pull, int lane,
                                         int end, struct hawser_report *report);
/* expand_at.c: displacement P, Q, B and slopes a, b, c of the second-order displacement of a pair,
 * at s from the beginning of a piece where the rope has the slope `angle`; slope may be NULL. */
void hawser__lexpand_second_at(double shape[3], double slope[3], const struct hawser__lexpand *t,
                               int pair, int piece, double s, double angle);

#endif
