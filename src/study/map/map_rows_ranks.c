/* study/map/map_rows_ranks.c - the rows of a map as tasks of the threads and of other processes.
 *
 * The question of a task is the number of the row; the answer is what the row has: answers, turns,
 * and the reasons. Rows of which a part is in the checkpoint are computed whole.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "core/report.h"
#include "study/map/map_rows.h"

enum { TEXT = 640 }; /* characters of a reason, as of a report */

static enum hawser_status ask(void *context, struct hawser__bytes *question, long number,
                              struct hawser_report *report)
{
	const struct hawser__rows_mapper *mapper = context;

	(void)report;
	hawser__bytes_add_long(question, mapper->pending[number]);
	return HAWSER_OK;
}

static enum hawser_status prepare(void *context, const struct hawser__task *task, int count,
                                  struct hawser_report *report)
{
	struct hawser__rows_mapper *mapper = context;

	for (int k = 0; k < count; k++) {
		struct hawser__extract question = task[k].question;
		double fixed = mapper->row[hawser__extract_long(&question)].fixed;

		mapper->x[k] = mapper->along == 0 ? mapper->map->x[0] : fixed;
		mapper->y[k] = mapper->along == 1 ? mapper->map->y[0] : fixed;
	}
	return !mapper->field->prepare ? HAWSER_OK
	       : mapper->field->prepare(mapper->field->context, mapper->x, mapper->y, count,
	                                mapper->threads, report);
}

static void write_row(struct hawser__bytes *to, const struct hawser__map_row *row)
{
	hawser__bytes_add_long(to, row->ready);
	hawser__bytes_add_long(to, row->incomplete);
	hawser__bytes_add_long(to, row->turns);
	hawser__bytes_add(to, row->answer, (size_t)row->count*sizeof *row->answer);
	hawser__bytes_add(to, row->turn, (size_t)row->turns*sizeof *row->turn);
	for (int k = 0; k < HAWSER_MAP_CODES; k++) {
		hawser__bytes_add_long(to, row->why[k] != NULL);
		hawser__bytes_add_text(to, row->why[k]);
	}
	hawser__bytes_add_text(to, row->broken);
}

static enum hawser_status read_row(struct hawser__map_row *row, struct hawser__extract *from,
                                   struct hawser_report *report)
{
	char text[TEXT];

	row->ready = (int)hawser__extract_long(from);
	row->incomplete = (int)hawser__extract_long(from);
	row->turns = (int)hawser__extract_long(from);
	free(row->answer);
	free(row->turn);
	row->answer = malloc((size_t)row->count*sizeof *row->answer);
	row->turn = malloc(((size_t)row->turns + 1)*sizeof *row->turn);
	if (!row->answer || !row->turn) {
		row->turns = row->ready = 0;
		return hawser__no_memory(report, "map");
	}
	hawser__extract_read(row->answer, from, (size_t)row->count*sizeof *row->answer);
	hawser__extract_read(row->turn, from, (size_t)row->turns*sizeof *row->turn);
	for (int k = 0; k < HAWSER_MAP_CODES; k++) {
		long is_there = hawser__extract_long(from);

		hawser__extract_text(text, sizeof text, from);
		if (is_there)
			hawser__map_note(&row->why[k], text);
	}
	hawser__extract_text(text, sizeof text, from);
	if (*text)
		hawser__map_note(&row->broken, text);
	return HAWSER_OK;
}

static int stopped(void *data, const struct hawser_progress_state *state)
{
	struct hawser__rows_mapper *mapper = data;

	(void)state;
	return atomic_load(&mapper->stop);
}

/* Rows of the mapper have their results in rank 0; so a row is computed in a copy. */
static enum hawser_status work(void *context, struct hawser__bytes *answer,
                               const struct hawser__task *task, int worker,
                               struct hawser_report *report)
{
	struct hawser__rows_mapper *mapper = context;
	const struct hawser_progress progress = {stopped, mapper};
	struct hawser__extract question = task->question;
	const struct hawser__map_row *asked = &mapper->row[hawser__extract_long(&question)];
	struct hawser__map_row row = {.at = asked->at, .count = asked->count, .fixed = asked->fixed,
		.only_stable = asked->only_stable, .seed = asked->seed, .seeds = asked->seeds,
		.progress = &progress};
	enum hawser_status status = mapper->field->row(mapper->worker[worker], &row, report);

	if (!status && !row.answer) { /* interrupted before its first curve */
		row.answer = calloc((size_t)row.count, sizeof *row.answer);
		row.ready = 0;
	}
	if (!status && !row.answer)
		status = hawser__no_memory(report, "map");
	if (!status)
		write_row(answer, &row);
	hawser__map_row_clear(&row);
	return status;
}

static enum hawser_status take(void *context, long number, struct hawser__extract *answer,
                               struct hawser_report *report)
{
	struct hawser__rows_mapper *mapper = context;
	struct hawser__map_row *row = &mapper->row[mapper->pending[number]];
	enum hawser_status status = read_row(row, answer, report);

	if (status || !row->ready)
		return status;
	mapper->done++;
	mapper->fresh++;
	status = hawser__map_rows_file_add(&mapper->file, row, report);
	return status ? status : hawser__rows_refuse(mapper, row, report);
}

static int watch(void *context, long done)
{
	struct hawser__rows_mapper *mapper = context;
	int failed = hawser__map_checkpoint_flush(&mapper->file.checkpoint, NULL) != HAWSER_OK;

	(void)done;
	return hawser__rows_told_to_stop(mapper) || failed;
}

static enum hawser_status run(struct hawser__rows_mapper *mapper, const struct hawser__tasks *tasks,
                              struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK, written;
	int ended, parts = mapper->options->parts;

	mapper->pending = calloc((size_t)mapper->rows + 1, sizeof *mapper->pending);
	if (!mapper->pending)
		return hawser__no_memory(report, "map");
	for (int j = 0; j < mapper->rows; j++) {
		if (mapper->row[j].ready) {
			mapper->done++;
			mapper->map->restored += mapper->row[j].count;
		} else if (parts == 0 || j%parts == mapper->options->part - 1) {
			mapper->pending[mapper->all++] = j;
		}
	}
	ended = hawser__rows_told_to_stop(mapper);
	if (!ended && mapper->all > 0)
		status = hawser__rows_across(mapper, report);
	if (!ended && !status)
		status = hawser__ranks_run(mapper->options->ranks, &ended, tasks, mapper->all, report);
	written = hawser__map_checkpoint_flush(&mapper->file.checkpoint, status ? NULL : report);
	mapper->map->interrupted = ended;
	if (mapper->options->ranks)
		hawser__ranks_end(mapper->options->ranks, tasks);
	return status ? status : written;
}

enum hawser_status hawser__rows_compute(struct hawser__rows_mapper *mapper, const char *settings,
                                        struct hawser_report *report)
{
	char *identity = hawser__map_ranks_identity(mapper->field->identity, settings);
	const struct hawser__tasks tasks = {.context = mapper, .threads = mapper->threads,
		.largest = mapper->threads, .what = "map", .identity = identity, .ask = ask,
		.prepare = prepare, .work = work, .take = take, .watch = watch};
	enum hawser_status status = HAWSER_OK;

	if (!identity)
		return hawser__no_memory(report, "map");
	if (mapper->options->ranks && mapper->options->ranks->rank > 0) {
		status = hawser__rows_across(mapper, report);
		hawser__ranks_serve(mapper->options->ranks, &tasks, status, report);
	} else {
		status = run(mapper, &tasks, report);
	}
	free(identity);
	return status;
}
