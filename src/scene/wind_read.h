/* scene/wind_read.h - the lists of a wind, and its rules. See wind_read.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_WIND_READ_H
#define HAWSER_SCENE_WIND_READ_H

#include <hawser/scene.h>

#include "scene/tree.h"

/* Drag, lift, profile and tables from `tree`, whose path in the table of keys is `of`, such as
 * "span.wind"; `what` names it in messages. The numbers are in *wind already. */
enum hawser_status hawser__wind_lists(struct hawser__reader *reader, struct hawser_wind *wind,
                                      const struct hawser__tree *tree, const char *what,
                                      const char *of) HAWSER_MUST_CHECK;
/* What of it is needed together, and what contradicts what. */
enum hawser_status hawser__wind_check(struct hawser__reader *reader, const struct hawser_wind *wind,
                                      const struct hawser__tree *tree, const char *what)
	HAWSER_MUST_CHECK;

#endif
