/* tow/trajectory.h - internal to trajectories: polynomials of a piece, and ramps.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TOW_TRAJECTORY_H
#define HAWSER_TOW_TRAJECTORY_H

#include <hawser/trajectory.h>

enum { HAWSER__TRAJECTORY_DEGREE = 2*HAWSER_PATH_GIVEN - 1 }; /* largest of a piece */

/* row[degree+1]: factors of the coefficients in the derivative of this order by tau. */
void hawser__trajectory_row(double *row, int degree, int order, double tau);

/* trajectory_solve.c: the pieces that minimise the derivative of order m, one banded solution. */
enum hawser_status hawser__trajectory_solve(struct hawser_path *of,
                                            const struct hawser_waypoint *point, int m,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;
/* trajectory_pieces.c: each piece by the derivatives at its ends. */
enum hawser_status hawser__trajectory_pieces(struct hawser_path *of,
                                             const struct hawser_waypoint *point,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;
/* Derivatives that are given at a waypoint without a gap, with the position: 1 to 7. */
int hawser__waypoint_orders(const struct hawser_waypoint *point);

/* trajectory_flight.c: s[0] the way in units of speed times ramp time, s[1] the part of the speed,
 * s[2..4] its derivatives by x = t/T >= 0. */
void hawser__ramp(double s[HAWSER_PATH_ORDERS], enum hawser_path_ramp ramp, double x);

/* Read the waypoints t x y z (s, m) of a text file: a line each, separated by blanks or tabs; "#"
 * begins a comment. A first line of names (t_s x_m y_m z_m, and more columns, which are not read)
 * is that of hawser trajectory. *point [*count] is owned by the caller, who frees it. Failures name
 * the line. */
enum hawser_status hawser__path_read(struct hawser_waypoint **point, int *count, const char *path,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
