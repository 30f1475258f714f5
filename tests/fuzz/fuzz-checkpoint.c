/* tests/fuzz/fuzz-checkpoint.c - any bytes as the checkpoint of a map. The result must be an error
 * that names the file, or a map after which the file is a checkpoint from which the same map
 * follows without computation.
 *
 * The first byte selects changes of the other bytes, since a mutation would hardly ever produce a
 * correct checksum:
 *
 *   bit 0   each line gets its correct checksum
 *   bit 1   the correct first line of this map is put in front
 *   bit 2   the map with lines and marks, else the one without
 *
 * Without bit 0 an accepted checkpoint cannot be forged, so that the map must be the one without a
 * checkpoint.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <inttypes.h>
#include <sys/mman.h>
#include <unistd.h>

#include "tests/fuzz/fuzz.h"
#include "tests/map-fields.h"

enum { SEALED = 1, HEADED = 2, MARKED = 4, KINDS = 2 };

/* A file in memory, and its name. */
static int file;
static char path[64];
/* For both maps: the first line of a checkpoint, and the map computed without one. */
static char head[KINDS][256];
static struct hawser_map plain[KINDS];

static enum hawser_status trace(struct hawser_map *map, int marked, const char *checkpoint,
                                struct hawser_report *report)
{
	struct hawser_map_field field = marked ? wedge() : circle();
	struct hawser_map_options options = square(9, 9);

	options.coarse = 4;
	options.tolerance = 0.02;
	options.threads = 1;
	options.checkpoint = checkpoint;
	return hawser_map_trace(map, &field, &options, report);
}

static void fill(const char *text, size_t size)
{
	demand(ftruncate(file, 0) == 0 && pwrite(file, text, size, 0) == (ssize_t)size,
	       "a file in memory takes everything", path);
}

static void begin(void)
{
	struct hawser_map map;
	ssize_t got;

	file = memfd_create("checkpoint", 0);
	snprintf(path, sizeof path, "/proc/self/fd/%d", file);
	for (int k = 0; k < KINDS; k++) {
		fill("", 0);
		demand(!trace(&plain[k], k, NULL, NULL) && !trace(&map, k, path, NULL), "a map", "");
		got = pread(file, head[k], sizeof head[k] - 1, 0);
		head[k][got > 0 ? got : 0] = '\0';
		head[k][strcspn(head[k], "\n")] = '\0';
		hawser_map_clear(&map);
	}
}

/* Hash of Fowler, Noll and Vo, variant 1a, folded. */
static uint32_t sum_of(const char *text, size_t length)
{
	uint64_t sum = UINT64_C(14695981039346656037);

	for (size_t i = 0; i < length; i++)
		sum = (sum ^ (unsigned char)text[i])*UINT64_C(1099511628211);
	return (uint32_t)(sum ^ sum >> 32);
}

/* Replace the checksum of every complete line; *size is the new size. */
static char *seal(const char *text, size_t *size)
{
	char *sealed = malloc(10*(*size + 1)), *to = sealed;
	const char *line = text, *end;

	while ((end = memchr(line, '\n', *size - (size_t)(line - text)))) {
		size_t length = (size_t)(end - line);

		memcpy(to, line, length);
		to += length;
		to += sprintf(to, " %08" PRIx32 "\n", sum_of(line, length));
		line = end + 1;
	}
	*size = (size_t)(to - sealed);
	return sealed;
}

static void put(const uint8_t *data, size_t size, unsigned how)
{
	const char *first = head[(how & MARKED) != 0];
	size_t headed = how & HEADED ? strlen(first) + 1 : 0, sealed = size;
	char *body = how & SEALED ? seal((const char *)data, &sealed) : NULL;
	char *text = malloc(headed + sealed + 1);

	if (headed)
		sprintf(text, "%s\n", first);
	memcpy(text + headed, body ? body : (const char *)data, sealed);
	fill(text, headed + sealed);
	free(text);
	free(body);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct hawser_report report = {.message = ""};
	struct hawser_map map, again;
	unsigned how = size ? data[0] : 0;
	int kind = (how & MARKED) != 0;
	enum hawser_status status;

	if (!file)
		begin();
	put(data + (size > 0), size - (size > 0), how);
	status = trace(&map, kind, path, &report);
	if (status) {
		demand((status == HAWSER_ERR_ARGUMENT || status == HAWSER_ERR_IO) &&
		       strstr(report.message, path) && is_message(report.message),
		       "an error of a checkpoint names the file", report.message);
	} else {
		demand((how & SEALED) || same_maps(&map, &plain[kind]),
		       "a checkpoint changes nothing", "");
		status = trace(&again, kind, path, &report);
		demand(!status, "the checkpoint of a map is one", report.message);
		demand(again.restored == again.visited, "everything is in it", "");
		demand(same_maps(&map, &again), "and makes the same map", "");
		hawser_map_clear(&again);
	}
	hawser_map_clear(&map);
	return 0;
}
