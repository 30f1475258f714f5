/* ropeway/read/read.h - reading a scene of kind `ropeway`: its parts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_READ_H
#define HAWSER_ROPEWAY_READ_H

#include <hawser/ropeway.h>
#include "scene/tree.h"

enum { HAWSER__CALLED = 96 }; /* size of "towers.NAME.sheaves.KEY" */

/* The number section.key of the mapping; unchanged if it is not given and not required. */
enum hawser_status hawser__ropeway_number(struct hawser__reader *reader, double *value,
                                          const struct hawser__tree *tree, const char *section,
                                          const char *key, const char *unit,
                                          enum hawser__tree_range range, int required)
	HAWSER_MUST_CHECK;
/* The place section.at, [x, y]. */
enum hawser_status hawser__ropeway_place(struct hawser__reader *reader, double at[2],
                                         const struct hawser__tree *tree, const char *section)
	HAWSER_MUST_CHECK;
/* towers.c: the list of towers; the stations are known. */
enum hawser_status hawser__ropeway_towers(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                          const struct hawser__tree *tree) HAWSER_MUST_CHECK;
/* The drive, top.drive. */
enum hawser_status hawser__ropeway_drive(struct hawser__reader *reader, struct hawser_ropeway *rw,
                                         const struct hawser__tree *tree);

#endif
