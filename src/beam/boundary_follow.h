/* beam/boundary_follow.h - points of a boundary of stability, and one piece of it.
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
	double range, longest;
	double low, high; /* of the parameter, for the present piece */
	int most;
};

/* Why a piece comes to an end. */
enum hawser__boundary_end {
	HAWSER__GOES_ON = 0,
	HAWSER__RANGE_ENDS, /* of the parameter */
	HAWSER__SPEED_ENDS, /* at speed 0 */
	HAWSER__PIECE_LOST, /* no step is short enough */
	HAWSER__OVERTAKEN   /* another mode grows below */
};

/* Directions of the parameter and of the speed. */
extern const double hawser__along_parameter[3], hawser__along_speed[3];

/* Append a point to the boundary. HAWSER_ERR_CONVERGENCE where it has as many as allowed. */
enum hawser_status hawser__boundary_keep(struct hawser__boundary_work *work,
                                         const struct hawser_beam_boundary_point *point,
                                         struct hawser_report *report);

/* The point at u; *good: nothing grows below it, something does above. */
enum hawser_status hawser__boundary_point(struct hawser_beam_boundary_point *point, int *good,
                                          struct hawser__boundary_work *work, const double *u,
                                          struct hawser_report *report);

/* Follow the boundary from the point `start` with the parameter growing (sign 1) or falling (-1) at
 * first. Points are appended in that order; *reached is the parameter up to which it is known. */
enum hawser_status hawser__boundary_follow(enum hawser__boundary_end *end, double *reached,
                                           struct hawser__boundary_work *work, const double *start,
                                           double sign, struct hawser_report *report);

#endif
