/* beam/boundary_follow.h - continuation of one piece of a stability boundary.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BEAM_BOUNDARY_FOLLOW_H
#define HAWSER_BEAM_BOUNDARY_FOLLOW_H

#include "beam/boundary.h"

struct hawser__boundary_work {
	struct hawser_beam_boundary *boundary;
	const struct hawser_beam_integrals *is;
	const struct hawser_beam_family *family;
	const struct hawser_beam_boundary_options *options;
	struct hawser__onset_equation equation;
	double range, longest; /* width of the parameter range; longest relative step */
	double low, high; /* parameter range of the current piece */
	int most;         /* largest number of points */
};

/* Why a piece ends. */
enum hawser__boundary_end {
	HAWSER__GOES_ON = 0, /* it does not end here */
	HAWSER__RANGE_ENDS,  /* end of the parameter range */
	HAWSER__SPEED_ENDS,  /* speed 0 */
	HAWSER__PIECE_LOST,  /* the corrector failed at the smallest step */
	HAWSER__OVERTAKEN    /* another mode becomes unstable at a lower speed */
};

/* Unit vectors of the parameter and of the speed. */
extern const double hawser__along_parameter[3], hawser__along_speed[3];

/* Append a point. HAWSER_ERR_CONVERGENCE if the boundary already has work->most points. */
enum hawser_status hawser__boundary_keep(struct hawser__boundary_work *work,
                                         const struct hawser_beam_boundary_point *point,
                                         struct hawser_report *report);

/* The point at u. *good is 1 if no mode grows just below it and at least one grows just above. */
enum hawser_status hawser__boundary_point(struct hawser_beam_boundary_point *point, int *good,
                                          struct hawser__boundary_work *work, const double *u,
                                          struct hawser_report *report);

/* Follow the boundary from the point `start`. The parameter first increases (sign 1) or decreases
 * (sign -1). Points are appended in the order of the continuation. *reached is the last parameter
 * at which the piece is known. */
enum hawser_status hawser__boundary_follow(enum hawser__boundary_end *end, double *reached,
                                           struct hawser__boundary_work *work, const double *start,
                                           double sign, struct hawser_report *report);

#endif
