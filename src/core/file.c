/* core/file.c - a file that is written completely or not at all.
 *
 * The data is written to a temporary file in the folder of the destination (rename(2) is atomic
 * only within a file system), which is renamed when it is complete. Interrupts, and the timer by
 * which the program ends itself after one, are blocked in between, so that no temporary file is
 * left behind.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/file.h"
#include "core/report.h"

static int is_stdout(const char *path)
{
	return strcmp(path, "-") == 0;
}

/* Fail with the name that the user gave; `file->path` may be a resolved link. */
static enum hawser_status refuse(struct hawser_report *report, const char *path, int error)
{
	return hawser__fail(report, HAWSER_ERR_IO, "file", "cannot write %s: %s",
	                    is_stdout(path) ? "standard output" : path, strerror(error));
}

static void hold_signals(struct hawser__file *file)
{
	static const int number[] = {SIGINT, SIGTERM, SIGHUP, SIGALRM};
	sigset_t hold;

	sigemptyset(&hold);
	for (size_t i = 0; i < sizeof number/sizeof *number; i++)
		sigaddset(&hold, number[i]);
	file->blocked = pthread_sigmask(SIG_BLOCK, &hold, &file->signals) == 0;
}

static void release(struct hawser__file *file)
{
	free(file->path);
	free(file->temporary);
	if (file->blocked)
		pthread_sigmask(SIG_SETMASK, &file->signals, NULL);
	memset(file, 0, sizeof *file);
}

/* A rename would replace a symbolic link, not what it points to. */
static char *resolve(const char *path)
{
	char *real = realpath(path, NULL);

	return real ? real : strdup(path);
}

/* The permissions that open(2) would give the file; mkstemp(3) makes it private. */
static mode_t wanted_mode(const char *path)
{
	struct stat info;
	mode_t mask;

	if (stat(path, &info) == 0)
		return info.st_mode & 07777;
	mask = umask(0);
	umask(mask);
	return 0666 & ~mask;
}

/* 1 if the destination exists and is not a regular file; it must not be replaced by one. */
static int is_special(const char *path)
{
	struct stat info;

	return stat(path, &info) == 0 && !S_ISREG(info.st_mode);
}

static enum hawser_status open_temporary(struct hawser__file *file, const char *path,
                                         struct hawser_report *report)
{
	size_t size = strlen(file->path) + sizeof ".XXXXXX";
	int fd, error;

	/* a read-only file in a writable folder must not be replaced */
	if (access(file->path, F_OK) == 0 && access(file->path, W_OK) != 0)
		return refuse(report, path, errno);
	file->temporary = malloc(size);
	if (!file->temporary)
		return hawser__no_memory(report, "file");
	snprintf(file->temporary, size, "%s.XXXXXX", file->path);
	hold_signals(file);
	fd = mkstemp(file->temporary);
	if (fd < 0)
		return refuse(report, path, errno);
	file->stream = fdopen(fd, "w+");
	if (!file->stream || fchmod(fd, wanted_mode(file->path)) != 0) {
		error = errno;
		if (!file->stream)
			close(fd);
		unlink(file->temporary);
		return refuse(report, path, error);
	}
	return HAWSER_OK;
}

enum hawser_status hawser__file_begin(struct hawser__file *file, const char *path,
                                      struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	*file = (struct hawser__file){.name = path};
	file->path = is_stdout(path) ? strdup(path) : resolve(path);
	if (!file->path)
		return hawser__no_memory(report, "file");
	if (is_stdout(path)) {
		file->stream = stdout;
	} else if (is_special(file->path)) {
		file->stream = fopen(file->path, "w");
		if (!file->stream)
			status = refuse(report, path, errno);
	} else {
		status = open_temporary(file, path, report);
	}
	if (status && file->stream)
		fclose(file->stream);
	if (status)
		release(file);
	return status;
}

/* Why an earlier write failed. The stream keeps that one did, not why, and where it went past the
 * buffer nothing is left that fflush(3) would try again: so a line end is tried, which a file that
 * is incomplete already can bear. */
static int reason_of_failure(FILE *stream)
{
	return write(fileno(stream), "\n", 1) < 0 ? errno : EIO;
}

enum hawser_status hawser__file_commit(struct hawser__file *file, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int bad = ferror(file->stream), error = 0;

	if (fflush(file->stream) != 0) {
		bad = 1;
		error = errno;
	} else if (bad) {
		error = reason_of_failure(file->stream);
	}
	if (file->stream != stdout && fclose(file->stream) != 0 && !bad) {
		bad = 1;
		error = errno;
	}
	if (!bad && file->temporary && rename(file->temporary, file->path) != 0) {
		bad = 1;
		error = errno;
	}
	if (bad) {
		status = refuse(report, file->name, error);
		if (file->temporary)
			unlink(file->temporary);
	}
	release(file);
	return status;
}

void hawser__file_abort(struct hawser__file *file)
{
	if (!file->stream)
		return;
	if (file->stream != stdout)
		fclose(file->stream);
	if (file->temporary)
		unlink(file->temporary);
	release(file);
}

enum hawser_status hawser__file_check(const char *path, struct hawser_report *report)
{
	struct hawser__file file;
	enum hawser_status status;

	/* only regular files are opened: opening a pipe could block, or end its reader */
	if (!path || is_stdout(path))
		return HAWSER_OK;
	if (is_special(path))
		return access(path, W_OK) == 0 ? HAWSER_OK : refuse(report, path, errno);
	status = hawser__file_begin(&file, path, report);
	if (!status)
		hawser__file_abort(&file);
	/* NOLINTNEXTLINE(clang-analyzer-unix.Malloc): _begin or _abort has freed it */
	return status;
}

const char *hawser__file_name(const char *path)
{
	const char *slash = strrchr(path, '/');

	return slash ? slash + 1 : path;
}

enum hawser_status hawser__file_put(const char *path, const char *text, size_t size,
                                    struct hawser_report *report)
{
	struct hawser__file file;
	enum hawser_status status = hawser__file_begin(&file, path, report);

	if (status)
		return status;
	/* the stream records a short write; the commit reports it */
	(void)!fwrite(text, 1, size, file.stream);
	return hawser__file_commit(&file, report);
}

int hawser__temporary_folder(char *folder, size_t size)
{
	const char *parent = getenv("TMPDIR");
	int length = snprintf(folder, size, "%s/hawser-XXXXXX", parent && *parent ? parent : "/tmp");

	if (length < 0 || (size_t)length >= size)
		errno = ENAMETOOLONG;
	else if (mkdtemp(folder))
		return 1;
	*folder = '\0';
	return 0;
}
