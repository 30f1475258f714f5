/* cli/sweep_file.c - the checkpoint of a sweep: a line that says which sweep it is, then for
 * each result a line with the number of its variation, its size and its checksum, and its text.
 * Results are only appended. If the program is killed, the last one may be incomplete: it is
 * cut off.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/report.h"
#include "cli/sweep.h"
#include "core/report.h"
#include "output/sha256.h"

static const char magic[] = "hawser-sweep-1";
enum { HEAD = 160, CHECK = 8 }; /* size of a line; digits of a checksum */

static enum hawser_status fail_io(const struct cli_sweep_file *file, const char *doing,
                                  struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_IO, "sweep", "cannot %s the checkpoint %s: %s", doing,
	                    file->path, strerror(errno));
}

/* --- which sweep it is --- */

/* The digest of a file, if the word names one. */
static void put_file(FILE *to, const char *word)
{
	char digest[HAWSER__SHA256_SIZE], *text;
	struct stat info;
	size_t size;

	if (stat(word, &info) != 0 || !S_ISREG(info.st_mode) ||
	    cli_report_text(&text, &size, word, NULL) != HAWSER_OK)
		return;
	hawser__sha256(digest, text, size);
	fprintf(to, " %s", digest);
	free(text);
}

/* What the results depend on: version, command line with the files that it names, variations,
 * columns. */
static void put_identity(FILE *to, const struct cli_study *sweep)
{
	const struct cli_sweep_choice *choice = &sweep->choice;
	char set[CLI_SWEEP_SET];

	fprintf(to, "%s %s %d %s", hawser_version(), choice->rows, (int)choice->pick,
	        choice->by ? choice->by : "");
	for (int k = 0; k < choice->keeps; k++)
		fprintf(to, "\t%s", choice->keep[k]);
	for (int i = 0; i < sweep->words; i++) {
		fprintf(to, "\n%s", sweep->word[i]);
		put_file(to, sweep->word[i]);
	}
	for (long i = 0; i < sweep->plan.count; i++)
		for (int k = 0; k < sweep->plan.keys; k++) {
			cli_sweep_set(set, &sweep->plan, k, i);
			fprintf(to, "\n%s", set);
		}
}

static enum hawser_status identify(char head[HEAD], const struct cli_study *sweep,
                                   struct hawser_report *report)
{
	char digest[HAWSER__SHA256_SIZE], *text = NULL;
	size_t size = 0;
	FILE *to = open_memstream(&text, &size);

	if (!to)
		return hawser__no_memory(report, "sweep");
	put_identity(to, sweep);
	if (fclose(to) != 0) {
		free(text);
		return hawser__no_memory(report, "sweep");
	}
	hawser__sha256(digest, text, size);
	free(text);
	snprintf(head, HEAD, "%s %s %ld\n", magic, digest, sweep->plan.count);
	return HAWSER_OK;
}

/* --- reading --- */

static void checksum(char check[CHECK + 1], const char *text, size_t size)
{
	char digest[HAWSER__SHA256_SIZE];

	hawser__sha256(digest, text, size);
	snprintf(check, CHECK + 1, "%.*s", CHECK, digest);
}

/* One result at text [size]; returns its length, 0 if it is incomplete, -1 without memory. */
static long read_one(struct cli_study *sweep, const char *text, size_t size)
{
	const char *end = memchr(text, '\n', size < HEAD ? size : HEAD);
	char check[CHECK + 1], line[HEAD], was[CHECK + 1];
	size_t length, head = end ? (size_t)(end - text) + 1 : 0;
	struct cli_sweep_packed *packed;
	long variation;

	snprintf(line, sizeof line, "%.*s", (int)head, text);
	if (!head || sscanf(line, "%ld %zu %8s", &variation, &length, was) != 3 || variation < 0 ||
	    variation >= sweep->plan.count || length > size - head)
		return 0;
	checksum(check, text + head, length);
	if (strcmp(check, was) != 0)
		return 0;
	packed = &sweep->packed[variation];
	free(packed->text);
	packed->text = malloc(length + 1);
	if (!packed->text)
		return -1;
	memcpy(packed->text, text + head, length);
	packed->text[length] = '\0';
	packed->size = length;
	return (long)(head + length);
}

static enum hawser_status read_all(struct cli_sweep_file *file, struct cli_study *sweep,
                                   const char *head, const char *text, size_t size,
                                   struct hawser_report *report)
{
	size_t at = strlen(head);
	long length = 1;

	if (size < at || strncmp(text, head, at) != 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
		                    "the checkpoint %s is %s: remove it, "
		                    "or name another file", file->path,
		                    strncmp(text, magic, strlen(magic)) == 0
		                    ? "of another sweep: scene, command, variations or columns differ"
		                    : "no checkpoint of a sweep");
	for (; at < size && length > 0; at += length > 0 ? (size_t)length : 0)
		length = read_one(sweep, text + at, size - at);
	if (length < 0)
		return hawser__no_memory(report, "sweep");
	if (ftruncate(file->fd, (off_t)at) != 0 || lseek(file->fd, 0, SEEK_END) < 0)
		return fail_io(file, "continue", report);
	return HAWSER_OK;
}

static enum hawser_status slurp(char **text, size_t *size, const struct cli_sweep_file *file,
                                struct hawser_report *report)
{
	struct stat info;
	ssize_t got = 1;

	*size = 0;
	if (fstat(file->fd, &info) != 0 || !S_ISREG(info.st_mode))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
		                    "the checkpoint %s is no regular file",
		                    file->path);
	*text = malloc((size_t)info.st_size + 1);
	if (!*text)
		return hawser__no_memory(report, "sweep");
	while (*size < (size_t)info.st_size && got > 0) {
		got = read(file->fd, *text + *size, (size_t)info.st_size - *size);
		*size += got > 0 ? (size_t)got : 0;
	}
	(*text)[*size] = '\0';
	return got < 0 ? fail_io(file, "read", report) : HAWSER_OK;
}

static enum hawser_status put_all(const struct cli_sweep_file *file, const char *text, size_t size,
                                  struct hawser_report *report)
{
	while (size > 0) {
		ssize_t put = write(file->fd, text, size);

		if (put < 0 && errno != EINTR)
			return fail_io(file, "write", report);
		text += put > 0 ? put : 0;
		size -= put > 0 ? (size_t)put : 0;
	}
	return HAWSER_OK;
}

enum hawser_status cli_sweep_file_open(struct cli_sweep_file *file, struct cli_study *sweep,
                                       struct hawser_report *report)
{
	char head[HEAD], *text = NULL;
	size_t size;
	enum hawser_status status = identify(head, sweep, report);

	file->path = sweep->checkpoint;
	if (status)
		return status;
	file->fd = open(file->path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
	if (file->fd < 0)
		return fail_io(file, "open", report);
	if (flock(file->fd, LOCK_EX | LOCK_NB) != 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
		                    "the checkpoint %s is in use by another "
		                    "sweep", file->path);
	status = slurp(&text, &size, file, report);
	if (!status)
		status = size > 0 ? read_all(file, sweep, head, text, size, report)
		                  : put_all(file, head, strlen(head), report);
	free(text);
	return status;
}

enum hawser_status cli_sweep_file_add(struct cli_sweep_file *file, long variation,
                                      const struct cli_sweep_packed *packed,
                                      struct hawser_report *report)
{
	char check[CHECK + 1], head[HEAD];
	enum hawser_status status;

	if (file->fd < 0)
		return HAWSER_OK;
	checksum(check, packed->text, packed->size);
	snprintf(head, sizeof head, "%ld %zu %s\n", variation, packed->size, check);
	status = put_all(file, head, strlen(head), report);
	return status ? status : put_all(file, packed->text, packed->size, report);
}

void cli_sweep_file_close(struct cli_sweep_file *file)
{
	if (file->fd >= 0)
		close(file->fd);
	file->fd = -1;
}
