/* core/file.h - a file that is written completely or not at all; see file.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_FILE_H
#define HAWSER_CORE_FILE_H

#include <signal.h>
#include <stdio.h>

#include <hawser/status.h>

/* A file being written, as a temporary file in the same folder that is renamed when complete.
 * Devices and pipes are written directly. "-" is standard output. */
struct hawser__file {
	FILE *stream;
	const char *name; /* name for messages; owned by the caller */
	char *path;      /* destination, symbolic links resolved; owned */
	char *temporary; /* NULL when the stream is the destination itself; owned */
	sigset_t signals; /* signal mask to restore; interrupts are blocked while the temporary file
	                   * exists */
	int blocked;
};
enum hawser_status hawser__file_begin(struct hawser__file *file, const char *path,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Flush, check, rename. On failure no file is left. *file must not be used afterwards, as after
 * _abort. */
enum hawser_status hawser__file_commit(struct hawser__file *file,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__file_abort(struct hawser__file *file);
/* Check, before a long computation, that `path` can be written. NULL and "-" are legal. */
enum hawser_status hawser__file_check(const char *path,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* The last part of a path. */
const char *hawser__file_name(const char *path);

/* Begin, write text [size], commit: HAWSER_ERR_IO names the file and the cause. */
enum hawser_status hawser__file_put(const char *path, const char *text, size_t size,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* Make a new folder for temporary files, below TMPDIR or /tmp; its path is in folder [size]. 0: errno
 * says why there is none, and folder is "". */
int hawser__temporary_folder(char *folder, size_t size);

#endif
