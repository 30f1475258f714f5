/* rom/energy/full_map.h - the motions of one full-order model in the coordinates of another: see
 * full_map.c. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_FULL_MAP_H
#define HAWSER_ROM_FULL_MAP_H

#include <hawser/rom.h>

/* map [*rows][*columns], allocated by malloc: the coordinates of the model with `to` functions per
 * component with which its shape is nearest to that of the model with `from` functions. */
enum hawser_status hawser__full_map(double **map, int *rows, int *columns,
                                    const struct hawser_statics *statics, int from, int to,
                                    struct hawser_report *report);

#endif
