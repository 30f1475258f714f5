/* study/map/map_merge.c - join the checkpoints of the parts of a map.
 *
 * A checkpoint is a header and records in any order, of which the last of a kind counts, so that
 * all records of all files behind one header are a checkpoint. An incomplete last line, of a part
 * that was killed, is left out. The order of the files does not matter for the map: a point depends
 * on its place only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

#include "core/file.h"
#include "core/report.h"
#include "study/map/map.h"

struct merge {
	FILE *to;
	char *head;   /* the first file's header, or NULL */
	const char *first;
	char *line;   /* the line that is read */
	size_t room;
	long points;
};

static enum hawser_status fail_io(const char *doing, const char *path, struct hawser_report *report)
{
	return hawser__fail(report, hawser__unreadable(errno), "merge", "cannot %s the checkpoint %s: %s",
	                    doing, path, strerror(errno));
}

static enum hawser_status take_head(struct merge *merge, const char *path, FILE *from,
                                    struct hawser_report *report)
{
	ssize_t got = getline(&merge->line, &merge->room, from);

	if (got <= 0 || !hawser__map_checkpoint_is_head(merge->line))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "merge",
		                    "%s is no checkpoint%s: name files that hawser map or sweep --checkpoint "
		                    "wrote", path, merge->head ? " of a map, as the first file is" : "");
	if (merge->head)
		return strcmp(merge->head, merge->line) == 0 ? HAWSER_OK
			: hawser__fail(report, HAWSER_ERR_ARGUMENT, "merge",
			               "%s belongs to another map than %s: another scene, quantity, "
			               "range or setting; name the parts of one map", path, merge->first);
	merge->head = strdup(merge->line);
	merge->first = path;
	if (!merge->head)
		return hawser__no_memory(report, "merge");
	fputs(merge->line, merge->to);
	return HAWSER_OK;
}

/* A line that is not sound may only be the last one. */
static enum hawser_status take_records(struct merge *merge, const char *path, FILE *from,
                                       struct hawser_report *report)
{
	long at = 1, bad = 0;

	while (getline(&merge->line, &merge->room, from) > 0) {
		at++;
		if (bad)
			return hawser__fail(report, HAWSER_ERR_IO, "merge",
			                    "the checkpoint %s is damaged in line %ld: compute this part again",
			                    path, bad);
		if (!hawser__map_checkpoint_is_sound(merge->line)) {
			bad = at;
			continue;
		}
		fputs(merge->line, merge->to);
		merge->points++;
	}
	return ferror(from) ? fail_io("read", path, report) : HAWSER_OK;
}

static enum hawser_status take_file(struct merge *merge, const char *path,
                                    struct hawser_report *report)
{
	FILE *from = fopen(path, "r");
	enum hawser_status status;

	if (!from)
		return fail_io("open", path, report);
	if (flock(fileno(from), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "merge",
		                      "the checkpoint %s is in use by a map that is being computed: wait for "
		                      "it", path);
	else
		status = take_head(merge, path, from, report);
	if (!status)
		status = take_records(merge, path, from, report);
	fclose(from);
	return status;
}

enum hawser_status hawser_map_merge(long *points, const char *to, const char *const *from, int count,
                                    struct hawser_report *report)
{
	struct merge merge = {.points = 0};
	struct hawser__file file;
	enum hawser_status status;

	if (access(to, F_OK) == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "merge",
		                    "the checkpoint %s exists: name a new file, or remove it", to);
	status = hawser__file_begin(&file, to, report);
	if (status)
		return status;
	merge.to = file.stream;
	for (int k = 0; k < count && !status; k++)
		status = take_file(&merge, from[k], report);
	if (status)
		hawser__file_abort(&file);
	else
		status = hawser__file_commit(&file, report);
	free(merge.head);
	free(merge.line);
	*points = merge.points;
	return status;
}
