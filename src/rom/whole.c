/* rom/whole.c - write text to a temporary file beside its destination, then rename.
 *
 * Symbolic links are followed first, for a rename would replace the link; a destination that is no
 * regular file (a device, a pipe) is written in place, for a rename would replace the device.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/report.h"
#include "rom/whole.h"

static enum hawser_status refuse(const char *path, int error, struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_IO, "rom", "cannot write %s: %s",
	                    strcmp(path, "-") ? path : "standard output", strerror(error));
}

/* Write, flush and close; 0 or errno. */
static int fill(FILE *stream, const char *text, size_t size)
{
	int error = 0;

	errno = 0;
	if (fwrite(text, 1, size, stream) != size || fflush(stream) != 0)
		error = errno ? errno : EIO;
	if (stream != stdout && fclose(stream) != 0 && !error)
		error = errno ? errno : EIO;
	return error;
}

/* A new file beside `real`, with the mode that open(2) gives or that the file to be replaced has.
 * */
static FILE *open_beside(char *temporary, size_t size, const char *real, const struct stat *old)
{
	FILE *stream = NULL;
	int fd = -1;

	for (int i = 0; fd < 0 && i < 1000; i++) {
		snprintf(temporary, size, "%s.%ld-%d", real, (long)getpid(), i);
		fd = open(temporary, O_WRONLY | O_CREAT | O_EXCL, 0666);
		if (fd < 0 && errno != EEXIST)
			return NULL;
	}
	if (fd >= 0 && (!old || !fchmod(fd, old->st_mode & 07777)))
		stream = fdopen(fd, "w");
	if (!stream && fd >= 0) {
		int error = errno;

		close(fd);
		unlink(temporary);
		errno = error;
	}
	return stream;
}

static int replace(const char *real, const struct stat *old, const char *text, size_t size)
{
	size_t room = strlen(real) + 40;
	char *temporary = malloc(room);
	FILE *stream;
	int error;

	if (!temporary)
		return ENOMEM;
	stream = open_beside(temporary, room, real, old);
	error = stream ? fill(stream, text, size) : errno;
	if (stream && !error && rename(temporary, real) != 0)
		error = errno;
	if (stream && error)
		unlink(temporary);
	free(temporary);
	return error;
}

enum hawser_status hawser__write_whole(const char *path, const char *text, size_t size,
                                       struct hawser_report *report)
{
	struct stat info;
	int there = strcmp(path, "-") && stat(path, &info) == 0, error;

	if (!strcmp(path, "-")) {
		error = fill(stdout, text, size);
	} else if (there && !S_ISREG(info.st_mode)) {
		FILE *stream = fopen(path, "w");

		error = stream ? fill(stream, text, size) : errno;
	} else if (there && access(path, W_OK) != 0) {
		error = errno; /* a read-only file: it shall be left alone */
	} else {
		char *real = there ? realpath(path, NULL) : strdup(path);

		error = real ? replace(real, there ? &info : NULL, text, size) : errno;
		free(real);
	}
	return error ? refuse(path, error, report) : HAWSER_OK;
}
