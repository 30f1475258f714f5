/* ropeway/expand/expand_modes.h - modes as the shapes of an expansion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_EXPAND_MODES_H
#define HAWSER_ROPEWAY_EXPAND_MODES_H

#include "modes/driven.h"
#include "ropeway/expand/expand.h"

enum { HAWSER__LEXPAND_MORE = 6 };

/* A force that oscillates: along y per length, at the scaled arclength s of a lane; or, with pull NULL,
 * the motion of end B (or A: end 0) of each lane along the rope. */
struct hawser__lexpand_force {
	double (*pull)(const void *wave, int lane, double s);
	const void *wave;
	int end;
	double motion[HAWSER_LINE_LANES]; /* scaled */
};

struct hawser__lexpand_modes {
	struct hawser__lmode rope;
	struct hawser__lmode_search search;    /* which refers to rope: the structure must not be moved */
	struct hawser__lexpand_shape *shape;   /* [search.n + HAWSER__LEXPAND_MORE]: the modes, and room for
	                                        * more */
};

/* The lowest modes, and the same in the public structure, on grids that also resolve a wave of the
 * number `wave` (1/m) along the rope. Both are to be cleared after a failure too. */
enum hawser_status hawser__lexpand_modes_open(struct hawser__lexpand_modes *t,
                                              struct hawser_line_modes *modes,
                                              const struct hawser_line_statics *const *lane, int lanes,
                                              const struct hawser_line_modes_options *options,
                                              double wave,
                                              struct hawser_report *report);
/* Drop all but the modes kept[count], ascending indices, of both. */
void hawser__lexpand_modes_keep(struct hawser__lexpand_modes *t, struct hawser_line_modes *modes,
                                const int *kept, int count);
void hawser__lexpand_modes_clear(struct hawser__lexpand_modes *t);

/* expand_drive.c: the static response of the modes that are not kept to a motion of ends of the rope,
 * added to a row; pull[n] is minus the force of this motion on the modes. */
enum hawser_status hawser__lexpand_drive(double *row, double *pull,
                                         const struct hawser__lexpand_modes *t,
                                         const struct hawser__lexpand_force *force,
                                         struct hawser_report *report);
/* expand_at.c: displacement P, Q, B and slopes a, b, c of shape i at s from the beginning of a piece
 * where the rope has the slope `angle`; slope may be NULL. */
void hawser__lexpand_shape_at(double shape[3], double slope[3], const struct hawser__lexpand *t, int i,
                              int piece, double s, double angle);
/* The same of a displacement of the whole rope. */
void hawser__lexpand_field_at(double shape[3], double slope[3], const struct hawser__lmode *rope,
                              const double *row, int piece, double s, double angle);

/* expand_answer.c: products in mass and in stiffness, and P K^-1 M, of displacements of the whole rope,
 * beside the modes of t. Release `load`. */
struct hawser__lexpand_work {
	const struct hawser__lmode *rope;
	const struct hawser__lexpand_modes *modes;
	double *load;          /* [size of a system] */
};
double hawser__lexpand_stiffness(const void *work, const double *x, const double *y);
enum hawser_status hawser__lexpand_by(struct hawser__driven_by *by, struct hawser__lexpand_work *w,
                                      const struct hawser__lexpand_modes *t,
                                      struct hawser_report *report);
/* What the modes that are not kept do under a force; pull: as above, of a motion. */
enum hawser_status hawser__lexpand_answer(struct hawser__driven *answer, double *pull,
                                          const struct hawser__lexpand_modes *t,
                                          const struct hawser__lexpand_force *force,
                                          struct hawser_report *report);

#endif
