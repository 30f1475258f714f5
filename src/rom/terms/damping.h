/* rom/terms/damping.h - the damping ratios of a scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_DAMPING_H
#define HAWSER_ROM_DAMPING_H

#include <hawser/modes.h>

/* The ratio of a mode; a shape that is no mode (number 0) has the last one. */
double hawser__damping_ratio(const struct hawser_scene *scene, const struct hawser_mode *mode);

#endif
