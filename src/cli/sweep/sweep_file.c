/* cli/sweep/sweep_file.c - the checkpoint of a sweep: a line that says which sweep it is, then for
 * each result a line with the number of its variation, its size and its checksum, and its text.
 * Results are only appended. If the program is killed, the last one may be incomplete: it is
 * cut off.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/report/report.h"
#include "cli/sweep/sweep.h"
#include "core/file.h"
#include "core/report.h"
#include "output/report/sha256.h"

static const char magic[] = "hawser-sweep-1";
enum { HEAD = CLI_SWEEP_IDENTITY, CHECK = 8 }; /* size of a line; digits of a checksum */

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

enum hawser_status cli_sweep_identity(char head[CLI_SWEEP_IDENTITY], const struct cli_study *sweep,
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

/* One result at text [size]: its place is *at, *length long. Returns what it takes, 0 if it is
 * incomplete or not a result. */
static size_t find_one(long *variation, const char **at, size_t *length, const char *text,
                       size_t size)
{
	const char *end = memchr(text, '\n', size < HEAD ? size : HEAD);
	char check[CHECK + 1], line[HEAD], was[CHECK + 1];
	size_t head = end ? (size_t)(end - text) + 1 : 0;

	*variation = -1;
	snprintf(line, sizeof line, "%.*s", (int)head, text);
	/* NOLINTNEXTLINE(cert-err34-c): overflow has another check sum */
	if (!head || sscanf(line, "%ld %zu %8s", variation, length, was) != 3 || *variation < 0 ||
	    *length < sizeof "S 0" || *length > size - head)
		return 0;
	checksum(check, text + head, *length);
	*at = text + head;
	return strcmp(check, was) == 0 && strncmp(*at, "S ", 2) == 0 ? head + *length : 0;
}

/* Whether a result stands anywhere behind the first line of text [size], which is none: so it is not
 * the last one, of a program that was killed, but damaged. */
static int goes_on(const char *text, size_t size)
{
	const char *end, *found;
	size_t length;
	long variation;

	for (; (end = memchr(text, '\n', size)); text = end + 1) {
		size -= (size_t)(end - text) + 1;
		if (find_one(&variation, &found, &length, end + 1, size) > 0)
			return 1;
	}
	return 0;
}

static enum hawser_status damaged(const char *command, const char *path, size_t at,
                                  struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_IO, command, "the checkpoint %s is damaged at byte %zu, and "
	                    "has results behind it: remove it, or cut it off there to keep those before",
	                    path, at);
}

/* 1 if there is no result because of the system (a crash, no memory): it is computed again. */
static int is_to_repeat(const char *text)
{
	return hawser_status_exit(cli_sweep_status(text)) == 4;
}

/* Returns 0 without memory. */
static int keep_one(struct cli_study *sweep, long variation, const char *at, size_t length)
{
	struct cli_sweep_packed *packed = &sweep->packed[variation];

	free(packed->text);
	packed->text = malloc(length + 1);
	if (!packed->text)
		return 0;
	memcpy(packed->text, at, length);
	packed->text[length] = '\0';
	packed->size = length;
	return 1;
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

static enum hawser_status read_all(struct cli_sweep_file *file, struct cli_study *sweep,
                                   const char *head, const char *text, size_t size,
                                   struct hawser_report *report)
{
	size_t at = strlen(head), taken = 1, length;
	const char *found;
	long variation;

	if (size < at && strncmp(text, head, size) == 0) /* killed before the first result */
		return ftruncate(file->fd, 0) != 0 || lseek(file->fd, 0, SEEK_SET) < 0
			? fail_io(file, "continue", report) : put_all(file, head, at, report);
	if (size < at || strncmp(text, head, at) != 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep", "the checkpoint %s is %s: remove "
		                    "it, or name another file", file->path,
		                    strncmp(text, magic, strlen(magic)) == 0
		                    ? "of another sweep: scene, command, variations or columns differ"
		                    : "no checkpoint of a sweep");
	while (taken > 0 && at < size) {
		taken = find_one(&variation, &found, &length, text + at, size - at);
		if (taken > 0 && variation >= sweep->plan.count)
			taken = 0;
		if (taken > 0 && !is_to_repeat(found) && !keep_one(sweep, variation, found, length))
			return hawser__no_memory(report, "sweep");
		at += taken;
	}
	if (at < size && goes_on(text + at, size - at))
		return damaged("sweep", file->path, at, report);
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

enum hawser_status cli_sweep_file_open(struct cli_sweep_file *file, struct cli_study *sweep,
                                       struct hawser_report *report)
{
	char head[HEAD], *text = NULL;
	size_t size;
	enum hawser_status status = cli_sweep_identity(head, sweep, report);

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

/* --- joining parts --- */

int cli_sweep_file_is(const char *path)
{
	char begin[sizeof magic] = "";
	FILE *stream = fopen(path, "r");

	if (!stream)
		return 0;
	begin[fread(begin, 1, sizeof magic - 1, stream)] = '\0';
	fclose(stream);
	return strcmp(begin, magic) == 0;
}

struct join {
	FILE *to;
	char head[HEAD]; /* of the first file; "": none yet */
	char *seen;      /* [count] 1: this result is there */
	long count, results;
};

/* Append the results in text [size] that are not yet there. */
static enum hawser_status join(struct join *join, const char *text, size_t size, const char *path,
                               struct hawser_report *report)
{
	size_t at = strlen(join->head), taken = 1, length;
	const char *found;
	long variation;

	while (taken > 0 && at < size) {
		taken = find_one(&variation, &found, &length, text + at, size - at);
		if (taken > 0 && variation < join->count && !join->seen[variation] && !is_to_repeat(found)) {
			fwrite(text + at, 1, taken, join->to);
			join->seen[variation] = 1;
			join->results++;
		}
		at += taken;
	}
	return at < size && goes_on(text + at, size - at) ? damaged("merge", path, at, report)
	                                                  : HAWSER_OK;
}

/* The first line of the text must be that of the first file; it has the number of variations. */
static enum hawser_status join_head(struct join *join, const char *text, const char *path,
                                    struct hawser_report *report)
{
	char digest[HAWSER__SHA256_SIZE], own[HEAD];
	size_t length = strcspn(text, "\n");
	long count = 0;

	snprintf(own, sizeof own, "%.*s\n", (int)(length < HEAD ? length : 0), text);
	if (text[length] != '\n' || strncmp(own, magic, strlen(magic)) != 0 ||
	    /* NOLINTNEXTLINE(cert-err34-c): overflow is beyond the most */
	    sscanf(own + strlen(magic), " %64s %ld", digest, &count) != 2 || count < 1 ||
	    count > CLI_SWEEP_MOST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "merge", "%s is no checkpoint of a sweep%s",
		                    path, *join->head ? ", as the first file is"
		                                      : ": its first line is damaged");
	if (*join->head)
		return strcmp(own, join->head) == 0 ? HAWSER_OK
			: hawser__fail(report, HAWSER_ERR_ARGUMENT, "merge", "%s is the checkpoint of another "
			               "sweep than the first file: scene, command, variations or columns differ",
			               path);
	strcpy(join->head, own);
	fputs(own, join->to);
	join->count = count;
	join->seen = calloc((size_t)count, 1);
	return join->seen ? HAWSER_OK : hawser__no_memory(report, "merge");
}

static enum hawser_status join_file(struct join *to, const char *path, struct hawser_report *report)
{
	struct cli_sweep_file file = {open(path, O_RDONLY | O_CLOEXEC), path};
	char *text = NULL;
	size_t size;
	enum hawser_status status;

	if (file.fd < 0)
		return hawser__fail(report, hawser__unreadable(errno), "merge",
		                    "cannot open the checkpoint %s: %s", path, strerror(errno));
	if (flock(file.fd, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "merge", "the checkpoint %s is in use by a "
		                      "sweep that is being computed: wait for it", path);
	else
		status = slurp(&text, &size, &file, report);
	if (!status)
		status = join_head(to, text, path, report);
	if (!status)
		status = join(to, text, size, path, report);
	free(text);
	close(file.fd);
	return status;
}

enum hawser_status cli_sweep_merge(long *results, const char *to, const char *const *from, int count,
                                   struct hawser_report *report)
{
	struct hawser__file file;
	struct join join = {.count = 0};
	enum hawser_status status;

	*results = 0;
	if (access(to, F_OK) == 0) /* the results of another sweep, or one of the parts */
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
		                    "the checkpoint %s exists: name a new file, or remove it", to);
	status = hawser__file_begin(&file, to, report);
	if (status)
		return status;
	join.to = file.stream;
	for (int k = 0; k < count && !status; k++)
		status = join_file(&join, from[k], report);
	free(join.seen);
	*results = join.results;
	if (!status)
		return hawser__file_commit(&file, report);
	hawser__file_abort(&file);
	return status;
}
