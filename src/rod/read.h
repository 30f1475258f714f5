/* rod/read.h - reading a scene of kind `rod`: its parts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROD_READ_H
#define HAWSER_ROD_READ_H

#include <hawser/rod.h>
#include "scene/tree.h"

enum { HAWSER__ROD_CALLED = 96 }; /* size of "loads.i12.moment" */

/* read_winch.c: `winch`, whose keys are those of the mapping `of`, such as "rod.start.winch". */
enum hawser_status hawser__rod_read_winch(struct hawser__reader *reader, struct hawser_rod_winch *winch,
                                          const struct hawser__tree *tree, const char *section,
                                          const char *of) HAWSER_MUST_CHECK;
/* read_loads.c: `loads`; the length of the rod is known. */
enum hawser_status hawser__rod_read_loads(struct hawser__reader *reader, struct hawser_rod *rod,
                                          const struct hawser__tree *tree) HAWSER_MUST_CHECK;

#endif
