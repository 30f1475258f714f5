/* rod/read.h - reading a scene of kind `rod`: its parts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROD_READ_H
#define HAWSER_ROD_READ_H

#include <hawser/rod.h>
#include "scene/tree.h"

enum { HAWSER__ROD_CALLED = 96 }; /* size of "loads.i12.moment" */

/* Three numbers for e1, e2, e3, or two for e2, e3, which may be one number. */
enum hawser_status hawser__rod_numbers(struct hawser__reader *reader, double *value, int count,
                                       const struct hawser__tree *tree, const char *what,
                                       const char *unit, enum hawser__tree_range range)
	HAWSER_MUST_CHECK;
/* A direction, which must not be 0. */
enum hawser_status hawser__rod_direction(struct hawser__reader *reader, double *to /* [3] */,
                                         const struct hawser__tree *tree, const char *what)
	HAWSER_MUST_CHECK;
/* read_dynamics.c: `damping` and `dynamics`; `spin` and `path` of the start (0) or end, if `tree` is
 * not NULL. */
enum hawser_status hawser__rod_read_dynamics(struct hawser__reader *reader, struct hawser_rod *rod,
                                             const struct hawser__tree *root) HAWSER_MUST_CHECK;
enum hawser_status hawser__rod_read_drive(struct hawser__reader *reader, struct hawser_rod *rod,
                                          int end, const struct hawser__tree *tree)
	HAWSER_MUST_CHECK;
/* read_winch.c: `winch`, whose keys are those of the mapping `of`, such as "rod.start.winch". */
enum hawser_status hawser__rod_read_winch(struct hawser__reader *reader, struct hawser_rod_winch *winch,
                                          const struct hawser__tree *tree, const char *section,
                                          const char *of) HAWSER_MUST_CHECK;
/* read_loads.c: `loads`; the length of the rod is known. */
enum hawser_status hawser__rod_read_loads(struct hawser__reader *reader, struct hawser_rod *rod,
                                          const struct hawser__tree *tree) HAWSER_MUST_CHECK;

#endif
