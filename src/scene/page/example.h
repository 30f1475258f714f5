/* scene/page/example.h - the complete scene that hawser-scene(5) shows; a test reads it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_EXAMPLE_H
#define HAWSER_SCENE_EXAMPLE_H

extern const char hawser__scene_example[];

#endif
