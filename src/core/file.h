/* core/file.h - a file that appears whole or not at all; see file.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_FILE_H
#define HAWSER_CORE_FILE_H

#include <signal.h>
#include <stdio.h>

#include <hawser/status.h>

/* A file being written: into a temporary file beside it, renamed when complete. Devices and pipes
 * are written as they are. "-" is standard output. */
struct hawser__file {
	FILE *stream;
	const char *name; /* as the caller gave it, for messages; the caller's until the end */
	char *path;      /* where it goes, symbolic links resolved; owned */
	char *temporary; /* NULL when the stream is the destination itself; owned */
	sigset_t signals; /* mask to restore: an interrupt waits until the temporary file is gone */
	int blocked;
};
enum hawser_status hawser__file_begin(struct hawser__file *file, const char *path,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Flush, check, rename. On failure nothing is left. Ends the use of *file, as _abort does. */
enum hawser_status hawser__file_commit(struct hawser__file *file,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__file_abort(struct hawser__file *file);
/* Could `path` be written? Asked before a long computation. NULL and "-" are fine. */
enum hawser_status hawser__file_check(const char *path,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* Begin, write text [size], commit: HAWSER_ERR_IO names the file and the cause. */
enum hawser_status hawser__file_put(const char *path, const char *text, size_t size,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
