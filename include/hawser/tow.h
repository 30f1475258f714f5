/* hawser/tow.h - the scene of a towed body: so far the path of the towing point.
 *
 * A scene with the section `tow` (hawser-scene(5), TOW). Axes: x and z are horizontal, y is upwards.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TOW_H
#define HAWSER_TOW_H

#include <stddef.h>

#include <hawser/trajectory.h>

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_tow {
	char *name;                         /* file name; owned */
	struct hawser_path path;            /* of the towing point */
	struct hawser_waypoint *waypoint;   /* [waypoints] of the path, with what is given; owned */
	int waypoints;                      /* 0: straight flight or orbit */
};

/* 1 if this file is the scene of a towed body, by what its lines begin with. "-" and pipes, which can
 * be read once only, are none. */
int hawser_tow_is(const char *path);

/* Read the scene and apply `nset` overrides "path=value", such as "tow.orbit.radius=80". *tow is
 * overwritten; release it with hawser_tow_clear. On failure it is all zero. Statuses: as
 * hawser_scene_open, and those of the path. */
enum hawser_status hawser_tow_open(struct hawser_tow *tow, const char *path, const char *const *set,
                                   size_t nset, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_tow_clear(struct hawser_tow *tow);

#ifdef __cplusplus
}
#endif
#endif
