/* tow/read.h - reading the scene of a towed body: its parts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TOW_READ_H
#define HAWSER_TOW_READ_H

#include <hawser/tow.h>
#include "scene/tree.h"

enum { HAWSER__TOW_WHAT = 96 }; /* size of "tow.waypoints[999999].velocity" */

/* The section `tow` but for waypoints: what the path is made of. */
struct hawser__tow_flight {
	double velocity[3], start[3];   /* of straight flight */
	double radius, speed, centre[3]; /* of an orbit */
	double ramp;
	int law, minimise, clamped;     /* enum hawser_path_ramp, enum hawser_minimise */
};

/* read_cable.c: the other sections; NULL: the scene does not have it. */
enum hawser_status hawser__tow_cable(struct hawser__reader *reader, struct hawser_tow *tow,
                                     const struct hawser__tree *tree) HAWSER_MUST_CHECK;
enum hawser_status hawser__tow_air(struct hawser__reader *reader, struct hawser_tow *tow,
                                   const struct hawser__tree *tree) HAWSER_MUST_CHECK;
enum hawser_status hawser__tow_body(struct hawser__reader *reader, struct hawser_tow *tow,
                                    const struct hawser__tree *tree) HAWSER_MUST_CHECK;
/* read_path.c: lines of time and three numbers of a file, found beside the scene. */
enum hawser_status hawser__tow_file(struct hawser__reader *reader, struct hawser_waypoint **point,
                                    int *count, const struct hawser__tree *one, const char *key)
	HAWSER_MUST_CHECK;
/* read_path.c: the section `tow`. */
enum hawser_status hawser__tow_path(struct hawser__reader *reader, struct hawser_tow *tow,
                                    const struct hawser__tree *tree) HAWSER_MUST_CHECK;
/* read_waypoints.c: the waypoints of a scene, a list; what the section says of the ends. */
enum hawser_status hawser__tow_waypoints(struct hawser__reader *reader, struct hawser_tow *tow,
                                         const struct hawser__tree *list) HAWSER_MUST_CHECK;
enum hawser_status hawser__tow_ends(struct hawser__reader *reader, struct hawser_tow *tow,
                                    const struct hawser__tree *ends) HAWSER_MUST_CHECK;

#endif
