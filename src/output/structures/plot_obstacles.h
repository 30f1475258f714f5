/* output/structures/plot_obstacles.h - a span over obstacles: the rope with the circles and the
 * same rope without them; tensions, with the limits of friction.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_OBSTACLES_H
#define HAWSER_OUTPUT_PLOT_OBSTACLES_H

#include <hawser/obstacles.h>

#include "output/drawing/figure.h"
#include "output/output.h"

/* Heights (0) or tensions (1) of a rope, at so many points of each piece. */
void hawser__plot_rope(struct hawser__figure *figure, const struct hawser_line_statics *st, int tension,
                       int points);

enum hawser_status hawser__plot_obstacles(const char *path, const struct hawser_obstacles *scene,
                                          const struct hawser_obstacles_statics *st,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
