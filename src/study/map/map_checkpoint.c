/* study/map/map_checkpoint.c - the file that stores the points of a map.
 *
 * Each point is a line of text with a checksum, after a header that identifies the map. Lines are
 * only appended, many of them by one write(2). If the process is killed, the last line may be
 * incomplete; it is ignored. Numbers are written as the bits of a double, so that neither the
 * locale nor rounding affects them.
 *
 * flock(2) is used, not fcntl(2), since it also locks against another map of the same process.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/report.h"
#include "study/map/map.h"

static const char magic[] = "hawser-map-1";

static enum hawser_status fail_io(const struct hawser__map_checkpoint *checkpoint,
                                  const char *doing, struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_IO, "map", "cannot %s the checkpoint %s: %s", doing,
	                    checkpoint->path, strerror(errno));
}

/* The FNV-1a hash of Fowler, Noll and Vo. */
static uint64_t hash(const char *text, size_t length)
{
	uint64_t sum = UINT64_C(14695981039346656037);

	for (size_t i = 0; i < length; i++)
		sum = (sum ^ (unsigned char)text[i])*UINT64_C(1099511628211);
	return sum;
}

static uint32_t short_hash(const char *text, size_t length)
{
	uint64_t sum = hash(text, length);

	return (uint32_t)(sum ^ sum >> 32);
}

static enum hawser_status reserve(struct hawser__map_checkpoint *checkpoint, size_t more,
                                  struct hawser_report *report)
{
	size_t need = checkpoint->used + more;
	char *larger;

	if (need <= checkpoint->room)
		return HAWSER_OK;
	larger = realloc(checkpoint->text, 2*need);
	if (!larger)
		return hawser__no_memory(report, "map");
	checkpoint->text = larger;
	checkpoint->room = 2*need;
	return HAWSER_OK;
}

/* Append the checksum to the line that begins at `from`. */
static void seal(struct hawser__map_checkpoint *checkpoint, size_t from)
{
	char *line = checkpoint->text + from;
	size_t length = checkpoint->used - from;

	checkpoint->used += (size_t)sprintf(line + length, " %08" PRIx32 "\n", short_hash(line, length));
}

static void put_number(struct hawser__map_checkpoint *checkpoint, double number)
{
	uint64_t bits;

	memcpy(&bits, &number, sizeof bits);
	checkpoint->used += (size_t)sprintf(checkpoint->text + checkpoint->used, " %016" PRIx64, bits);
}

enum hawser_status hawser__map_checkpoint_add(struct hawser__map_checkpoint *checkpoint,
                                              const struct hawser__map_record *record,
                                              const double *marks, struct hawser_report *report)
{
	size_t from = checkpoint->used;
	enum hawser_status status;

	if (checkpoint->fd < 0)
		return HAWSER_OK;
	status = reserve(checkpoint, 128 + 17*(size_t)checkpoint->marks, report);
	if (status)
		return status;
	checkpoint->used += (size_t)sprintf(checkpoint->text + from, "%d %d",
	                                    (int)record->sample.code, record->sample.number);
	put_number(checkpoint, record->x);
	put_number(checkpoint, record->y);
	put_number(checkpoint, record->sample.value);
	for (int k = 0; k < checkpoint->marks; k++)
		put_number(checkpoint, marks[k]);
	seal(checkpoint, from);
	return HAWSER_OK;
}

enum hawser_status hawser__map_checkpoint_flush(struct hawser__map_checkpoint *checkpoint,
                                                struct hawser_report *report)
{
	size_t done = 0;

	while (checkpoint->fd >= 0 && done < checkpoint->used) {
		ssize_t put = write(checkpoint->fd, checkpoint->text + done, checkpoint->used - done);

		if (put < 0 && errno != EINTR)
			return fail_io(checkpoint, "write", report);
		done += put > 0 ? (size_t)put : 0;
	}
	checkpoint->used = 0;
	return HAWSER_OK;
}

/* --- reading --- */

/* Check the checksum of a line without its newline; returns 0 if it is wrong. *length becomes that
 * without the checksum. */
static int sound(const char *line, size_t *length)
{
	char *end;
	unsigned long sum;

	if (*length < 10 || line[*length - 9] != ' ')
		return 0;
	*length -= 9;
	sum = strtoul(line + *length + 1, &end, 16);
	return *end == '\0' && sum == short_hash(line, *length);
}

int hawser__map_checkpoint_is_sound(const char *line)
{
	size_t length = strlen(line);
	char *end;

	if (length < 11 || line[length - 1] != '\n' || line[length - 10] != ' ')
		return 0;
	return strtoul(line + length - 9, &end, 16) == short_hash(line, length - 10) && *end == '\n';
}

int hawser__map_checkpoint_is_head(const char *line)
{
	return strncmp(line, magic, sizeof magic - 1) == 0 && hawser__map_checkpoint_is_sound(line);
}

/* A blank and the sixteen digits of a number, as written by put_number. *at is moved behind them,
 * or becomes NULL if they are missing. */
static double number(const char **at)
{
	char *end = NULL;
	uint64_t bits = 0;
	double value;

	if (*at && **at == ' ' && isxdigit((unsigned char)(*at)[1]))
		bits = strtoull(*at + 1, &end, 16);
	*at = end && end - *at == 17 ? end : NULL;
	memcpy(&value, &bits, sizeof value);
	return value;
}

/* Finite coordinates, other than -0: points are identified by their bits. */
static int is_place(double x)
{
	return isfinite(x) && !(x == 0.0 && signbit(x));
}

/* Returns 0 if the line is not a record written by hawser__map_checkpoint_add. */
static int read_record(struct hawser__map_record *record, double *marks, int count,
                       const char *line)
{
	const char *at;
	char *end;
	long code = strtol(line, &end, 10), instabilities = strtol(end, &end, 10);

	memset(record, 0, sizeof *record);
	if (code < 0 || code >= HAWSER_MAP_CODES || instabilities < INT_MIN || instabilities > INT_MAX)
		return 0;
	record->ready = 1;
	record->sample.code = (enum hawser_map_code)code;
	record->sample.number = (int)instabilities;
	at = end;
	record->x = number(&at);
	record->y = number(&at);
	record->sample.value = number(&at);
	for (int k = 0; k < count; k++)
		marks[k] = number(&at);
	return at && !*at && is_place(record->x) && is_place(record->y);
}

/* Write the header without its checksum to text [size]. */
static void head_of(char *text, size_t size, const char *identity, const char *settings, int marks)
{
	snprintf(text, size, "%s scene %016" PRIx64 " settings %016" PRIx64 " marks %d", magic,
	         hash(identity, strlen(identity)), hash(settings, strlen(settings)), marks);
}

static enum hawser_status compare_heads(const struct hawser__map_checkpoint *checkpoint,
                                        const char *found, const char *wanted,
                                        struct hawser_report *report)
{
	const char *a = strstr(found, " settings"), *b = strstr(wanted, " settings");
	int same_scene;

	if (strcmp(found, wanted) == 0)
		return HAWSER_OK;
	if (strncmp(found, magic, sizeof magic - 1) != 0 || !a)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "%s is no checkpoint of a map: name another file",
		                    checkpoint->path);
	same_scene = a - found == b - wanted && strncmp(found, wanted, (size_t)(a - found)) == 0;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
	                    "the checkpoint %s belongs to another map, of %s: name another file, or "
	                    "remove it", checkpoint->path,
	                    same_scene ? "other ranges or settings"
	                               : "another scene, quantity or pair of axes");
}

static enum hawser_status damaged(const struct hawser__map_checkpoint *checkpoint, long line,
                                  struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_IO, "map",
	                    "the checkpoint %s is damaged in line %ld: remove it", checkpoint->path,
	                    line);
}

/* Read the lines after the header; *good becomes the length of the file up to the last valid line. */
static enum hawser_status read_records(struct hawser__map_checkpoint *checkpoint, off_t *good,
                                       FILE *stream, char **line, size_t *room, double *marks,
                                       const struct hawser__map_taker *taker,
                                       struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	struct hawser__map_record record;
	ssize_t got;
	long at = 1, bad = 0;

	while (!status && (got = getline(line, room, stream)) > 0) {
		size_t length = (size_t)got - 1;

		at++;
		if (bad)
			return damaged(checkpoint, bad, report);
		if ((*line)[length] != '\n' || ((*line)[length] = '\0', !sound(*line, &length))) {
			bad = at;
			continue;
		}
		(*line)[length] = '\0';
		if (!read_record(&record, marks, checkpoint->marks, *line))
			return damaged(checkpoint, at, report);
		*good += got;
		status = taker->take(taker->context, &record, marks, report);
	}
	if (!status && ferror(stream))
		status = fail_io(checkpoint, "read", report);
	return status;
}

static enum hawser_status read_all(struct hawser__map_checkpoint *checkpoint, FILE *stream,
                                   const char *head, const struct hawser__map_taker *taker,
                                   struct hawser_report *report)
{
	double *marks = malloc(((size_t)checkpoint->marks + 1)*sizeof *marks);
	char *line = NULL;
	size_t room = 0, length;
	ssize_t got = marks ? getline(&line, &room, stream) : -1;
	off_t good = got > 0 ? got : 0;
	enum hawser_status status = HAWSER_OK;

	if (!marks) {
		status = hawser__no_memory(report, "map");
	} else if (got > 0 && line[got - 1] != '\n' && strncmp(line, head, (size_t)got) == 0) {
		got = good = 0; /* the process was killed before it wrote a point */
	} else if (got > 0) {
		length = (size_t)got - (line[got - 1] == '\n');
		line[length] = '\0';
		if (!sound(line, &length))
			length = 0; /* not a header: comparison fails */
		line[length] = '\0';
		status = compare_heads(checkpoint, line, head, report);
	}
	if (!status && got > 0)
		status = read_records(checkpoint, &good, stream, &line, &room, marks, taker, report);
	/* remove an incomplete last line */
	if (!status && ftruncate(checkpoint->fd, good) != 0)
		status = fail_io(checkpoint, "write", report);
	if (!status && good == 0) {
		status = reserve(checkpoint, strlen(head) + 32, report);
		if (!status) {
			checkpoint->used = (size_t)sprintf(checkpoint->text, "%s", head);
			seal(checkpoint, 0);
			status = hawser__map_checkpoint_flush(checkpoint, report);
		}
	}
	free(line);
	free(marks);
	return status;
}

enum hawser_status hawser__map_checkpoint_open(struct hawser__map_checkpoint *checkpoint,
                                               const char *path, const char *identity,
                                               const char *settings, int marks,
                                               const struct hawser__map_taker *taker,
                                               struct hawser_report *report)
{
	enum hawser_status status;
	FILE *stream = NULL;
	struct stat info;
	char head[160];
	int copy;

	*checkpoint = (struct hawser__map_checkpoint){.fd = -1, .path = path, .marks = marks};
	if (!path)
		return HAWSER_OK;
	checkpoint->fd = open(path, O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
	if (checkpoint->fd < 0)
		return fail_io(checkpoint, "open", report);
	if (fstat(checkpoint->fd, &info) != 0 || !S_ISREG(info.st_mode))
		return hawser__fail(report, HAWSER_ERR_IO, "map",
		                    "the checkpoint %s is no regular file, which a map could be continued "
		                    "from", path);
	if (flock(checkpoint->fd, LOCK_EX | LOCK_NB) != 0)
		return errno != EWOULDBLOCK ? fail_io(checkpoint, "lock", report)
			: hawser__fail(report, HAWSER_ERR_IO, "map",
			               "the checkpoint %s is in use by another map that is being "
			               "computed: wait for it, or name another file", path);
	copy = dup(checkpoint->fd);
	stream = copy < 0 ? NULL : fdopen(copy, "r");
	if (!stream) {
		status = fail_io(checkpoint, "read", report);
		if (copy >= 0)
			close(copy);
		return status;
	}
	head_of(head, sizeof head, identity, settings, marks);
	status = read_all(checkpoint, stream, head, taker, report);
	fclose(stream);
	return status;
}

void hawser__map_checkpoint_close(struct hawser__map_checkpoint *checkpoint)
{
	if (checkpoint->fd >= 0)
		close(checkpoint->fd);
	free(checkpoint->text);
	*checkpoint = (struct hawser__map_checkpoint){.fd = -1};
}
