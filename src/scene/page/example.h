/* scene/page/example.h - the complete scene that hawser-scene(5) shows; a test reads it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_EXAMPLE_H
#define HAWSER_SCENE_EXAMPLE_H

extern const char hawser__scene_example[];
/* manpage_net_obstacles.c, manpage_obstacles.c, manpage_ropeway.c, manpage_rod.c,
 * manpage_tow.c: parts of hawser-scene(5). */
extern const char hawser__manpage_net_obstacles[];
extern const char hawser__manpage_obstacles[];
extern const char hawser__manpage_ropeways[];
extern const char hawser__manpage_tow[];
extern const char hawser__manpage_rods[];

#endif
