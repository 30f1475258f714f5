/* scene/state_file.h - the state of a motion in a file of numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_STATE_FILE_H
#define HAWSER_SCENE_STATE_FILE_H

#include <hawser/status.h>

/* `kind` begins the file, such as "hawser net state 2"; the count and one number a line follow, with 17
 * digits, so that a run goes on bit by bit. HAWSER_ERR_IO: the file cannot be written, and is as
 * before. */
enum hawser_status hawser__state_write(const double *state /* [count] */, int count,
                                       const char *kind, const char *path,
                                       struct hawser_report *report);
/* stage: of the report. *state [count] is the caller's; NULL with HAWSER_OK if the file is none of this
 * kind and count. HAWSER_ERR_IO or HAWSER_ERR_ARGUMENT: it cannot be read; HAWSER_ERR_MEMORY. */
enum hawser_status hawser__state_read(double **state, int count, const char *kind, const char *path,
                                      const char *stage, struct hawser_report *report);

#endif
