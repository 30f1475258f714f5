/* study/map/map_ranks.c - the points of a map as tasks of the threads and of other processes.
 *
 * The question of a task is x and y; the answer is the sample, the marks, and the reason where
 * there is no value. Rank 0 has the cells and the checkpoint; workers have the field only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "study/map/map.h"

/* Least expected wall time of points for which other ranks are asked: some messages; chosen. */
#define ASKED_SECS 1e-3
/* The same for which threads are started: ten times the time of starting one. */
#define THREADED_SECS 3e-4
enum { LARGEST = 4096 }; /* points of a message, at most: half a megabyte; chosen */

static enum hawser_status ask(void *context, struct hawser__bytes *question, long number,
                              struct hawser_report *report)
{
	const struct hawser__map_memo *memo = context;
	const struct hawser__map_record *record = &memo->record[memo->asked[number]];

	(void)report;
	hawser__bytes_add_double(question, record->x);
	hawser__bytes_add_double(question, record->y);
	return HAWSER_OK;
}

static enum hawser_status prepare(void *context, const struct hawser__task *task, int count,
                                  struct hawser_report *report)
{
	const struct hawser__map_memo *memo = context;
	double *x = malloc(2*(size_t)count*sizeof *x), *y = hawser__behind(x, (size_t)count);
	enum hawser_status status = HAWSER_OK;

	if (!x)
		return hawser__no_memory(report, "map");
	for (int k = 0; k < count; k++) {
		struct hawser__extract question = task[k].question;

		x[k] = hawser__extract_double(&question);
		y[k] = hawser__extract_double(&question);
	}
	if (memo->field->prepare)
		status = memo->field->prepare(memo->field->context, x, y, count, memo->threads, report);
	free(x);
	return status;
}

static enum hawser_status work(void *context, struct hawser__bytes *answer,
                               const struct hawser__task *task, int worker,
                               struct hawser_report *report)
{
	const struct hawser__map_memo *memo = context;
	const struct hawser_map_field *field = memo->field;
	double *marks = memo->marks > 0 ? memo->scratch + (size_t)worker*(size_t)field->marks : NULL;
	struct hawser__extract question = task->question;
	double x = hawser__extract_double(&question), y = hawser__extract_double(&question);
	struct hawser_map_sample sample = {.value = 0.0};
	struct hawser_report local = {.status = HAWSER_OK};
	enum hawser_status status = field->point(memo->worker[worker], &sample, marks, x, y, &local);

	if (status) {
		*report = local;
		return status;
	}
	hawser__bytes_add(answer, &sample, sizeof sample);
	hawser__bytes_add(answer, marks, (size_t)memo->marks*sizeof *marks);
	hawser__bytes_add_text(answer, hawser_map_uncomputed(sample.code) ? local.message : NULL);
	return HAWSER_OK;
}

static enum hawser_status take(void *context, long number, struct hawser__extract *answer,
                               struct hawser_report *report)
{
	struct hawser__map_memo *memo = context;
	long index = memo->asked[number];
	struct hawser__map_record *record = &memo->record[index];
	double *marks = memo->mark + index*memo->marks;
	struct hawser_report local = {.status = HAWSER_OK};
	enum hawser_status status;

	hawser__extract_read(&record->sample, answer, sizeof record->sample);
	hawser__extract_read(marks, answer, (size_t)memo->marks*sizeof *marks);
	hawser__extract_text(local.message, sizeof local.message, answer);
	record->ready = 1;
	memo->fresh++;
	memo->waiting--;
	status = hawser__map_checkpoint_add(&memo->checkpoint, record, marks, report);
	if (!status)
		status = hawser__map_refuse(memo, &local, record);
	if (status == HAWSER_ERR_CONVERGENCE)
		*report = local;
	return status;
}

/* A failure to write is told by the last flush. */
static int watch(void *context, long done)
{
	struct hawser__map_memo *memo = context;
	int failed = hawser__map_checkpoint_flush(&memo->checkpoint, NULL) != HAWSER_OK;

	(void)done;
	return hawser__map_told_to_stop(memo, memo->stage, memo->waiting + memo->later) || failed;
}

static void close_workers(struct hawser__map_memo *memo)
{
	for (int t = 0; memo->worker && t < memo->threads; t++) {
		memo->field->close(memo->worker[t]);
		memo->worker[t] = NULL;
	}
}

static void leave(void *context, struct hawser__bytes *last)
{
	struct hawser__map_memo *memo = context;

	close_workers(memo);
	if (memo->field->condensed)
		hawser__bytes_add(last, memo->field->condensed, sizeof *memo->field->condensed);
}

static void take_last(void *context, struct hawser__extract *last)
{
	struct hawser__map_memo *memo = context;
	struct hawser_map_condensed part;

	hawser__extract_read(&part, last, sizeof part);
	hawser__map_condensed_merge(&memo->others, &part);
}

void hawser__map_condensed_merge(struct hawser_map_condensed *all,
                                 const struct hawser_map_condensed *part)
{
	if (part->points == 0)
		return;
	all->kept = all->points && all->kept < part->kept ? all->kept : part->kept;
	all->neglected = fmax(all->neglected, part->neglected);
	all->points += part->points;
}

char *hawser__map_ranks_identity(const char *identity, const char *settings)
{
	size_t size = strlen(identity) + strlen(settings) + 40;
	char *text = malloc(size);

	if (text)
		snprintf(text, size, "%s\n%s\n%s", hawser_version(), settings, identity);
	return text;
}

int hawser__map_part_of(int a, int b, int columns, int rows, int parts)
{
	/* square tiles, about eight for each part: large ones share few points with their
	 * neighbours, many sample the map evenly. Each row of tiles begins with another part. */
	double each = (double)columns*rows/(8.0*parts);
	int size = each > 1.0 ? (int)sqrt(each) : 1;

	return (a/size + b/size*(2*parts/5 + 1))%parts + 1;
}

enum hawser_status hawser__map_ranks_open(struct hawser__map_memo *memo, const char *settings,
                                          struct hawser_report *report)
{
	memo->identity = hawser__map_ranks_identity(memo->field->identity, settings);
	if (!memo->identity)
		return hawser__no_memory(report, "map");
	memo->tasks = (struct hawser__tasks){.context = memo, .threads = memo->threads,
		.largest = LARGEST, .what = "map", .identity = memo->identity, .ask = ask,
		.prepare = prepare, .work = work, .take = take, .watch = watch, .leave = leave,
		.take_last = take_last};
	return HAWSER_OK;
}

enum hawser_status hawser__map_ranks_run(struct hawser__map_memo *memo, const long *pending, long count,
                                         struct hawser_report *report)
{
	double secs = memo->cost*(double)count;
	enum hawser_status status, written;
	int stopped = 0;

	memo->asked = pending;
	memo->tasks.brief = secs > 0.0 && secs < THREADED_SECS;
	status = hawser__ranks_run(secs >= ASKED_SECS ? memo->options->ranks : NULL, &stopped, &memo->tasks,
	                           count, report);
	written = hawser__map_checkpoint_flush(&memo->checkpoint, status ? NULL : report);
	memo->interrupted |= stopped;
	return status ? status : written;
}

void hawser__map_ranks_serve(struct hawser__map_memo *memo)
{
	hawser__ranks_serve(memo->options->ranks, &memo->tasks, HAWSER_OK, NULL);
}

void hawser__map_ranks_end(struct hawser__map_memo *memo)
{
	if (memo->options && memo->options->ranks)
		hawser__ranks_end(memo->options->ranks, &memo->tasks);
}
