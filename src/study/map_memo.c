/* study/map_memo.c - the points of a map: each is computed once, many at a time.
 *
 * Points are told apart by the bits of their coordinates. Since a field's point function is pure, it
 * does not matter who computes a point, when, or in which run: a checkpoint is this table in a file,
 * and a map that is continued asks for the same points in the same order and finds them here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifdef _OPENMP
#include <omp.h>
#endif

#include "core/report.h"
#include "study/map.h"

/* Points between two looks at the caller's progress: so many that they take about this long. */
#define LEAST_SECS 0.1
#define MOST_SECS 0.5
enum { MOST_CHUNK = 4096, FIRST_CHUNK = 16 };

static uint64_t mix(double x, double y)
{
	uint64_t a, b;

	memcpy(&a, &x, sizeof a);
	memcpy(&b, &y, sizeof b);
	a = (a ^ a >> 31)*UINT64_C(0x9e3779b97f4a7c15);
	a ^= (b ^ b >> 29)*UINT64_C(0xbf58476d1ce4e5b9);
	return (a ^ a >> 27)*UINT64_C(0x94d049bb133111eb) >> 20;
}

static long *find(const struct hawser__map_memo *memo, double x, double y)
{
	uint64_t at = mix(x, y);

	for (;; at++) {
		long *slot = &memo->slot[at & (uint64_t)(memo->slots - 1)];
		const struct hawser__map_record *record = memo->record + *slot - 1;

		if (!*slot || (record->x == x && record->y == y))
			return slot;
	}
}

static enum hawser_status grow_hash(struct hawser__map_memo *memo, struct hawser_report *report)
{
	long *old = memo->slot;

	memo->slots = memo->slots ? 2*memo->slots : 1024;
	memo->slot = calloc((size_t)memo->slots, sizeof *memo->slot);
	free(old);
	if (!memo->slot) {
		memo->slots = 0;
		return hawser__no_memory(report, "map");
	}
	for (long i = 0; i < memo->count; i++)
		*find(memo, memo->record[i].x, memo->record[i].y) = i + 1;
	return HAWSER_OK;
}

static enum hawser_status grow_records(struct hawser__map_memo *memo, struct hawser_report *report)
{
	long capacity = memo->capacity ? 2*memo->capacity : 512;
	size_t marks = (size_t)capacity*(size_t)memo->marks;
	struct hawser__map_record *record = realloc(memo->record, (size_t)capacity*sizeof *record);
	double *mark;

	if (!record)
		return hawser__no_memory(report, "map");
	memo->record = record;
	mark = realloc(memo->mark, (marks + 1)*sizeof *mark);
	if (!mark)
		return hawser__no_memory(report, "map");
	memo->mark = mark;
	memo->capacity = capacity;
	return HAWSER_OK;
}

/* *index of the record at x, y, made where there is none. */
static enum hawser_status enter(struct hawser__map_memo *memo, long *index, double x, double y,
                                struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	long *slot;

	if (2*(memo->count + 1) > memo->slots)
		status = grow_hash(memo, report);
	if (!status && memo->count == memo->capacity)
		status = grow_records(memo, report);
	if (status)
		return status;
	slot = find(memo, x, y);
	if (!*slot) {
		memo->record[memo->count] = (struct hawser__map_record){.x = x, .y = y};
		*slot = ++memo->count;
	}
	*index = *slot - 1;
	return HAWSER_OK;
}

/* A record of the checkpoint. */
static enum hawser_status restore(void *context, const struct hawser__map_record *record,
                                  const double *marks, struct hawser_report *report)
{
	struct hawser__map_memo *memo = context;
	long index;
	enum hawser_status status = enter(memo, &index, record->x, record->y, report);

	if (status)
		return status;
	memo->record[index] = *record;
	if (memo->marks > 0)
		memcpy(memo->mark + index*memo->marks, marks, (size_t)memo->marks*sizeof *marks);
	return HAWSER_OK;
}

static int thread_count(int asked)
{
#ifdef _OPENMP
	return asked > 0 ? asked : omp_get_max_threads();
#else
	(void)asked;
	return 1;
#endif
}

static int thread_number(void)
{
#ifdef _OPENMP
	return omp_get_thread_num();
#else
	return 0;
#endif
}

enum hawser_status hawser__map_memo_open(struct hawser__map_memo *memo,
                                         const struct hawser_map_field *field,
                                         const struct hawser_map_options *options,
                                         const char *settings, struct hawser_report *report)
{
	struct hawser__map_taker taker = {restore, memo};
	enum hawser_status status = HAWSER_OK;

	*memo = (struct hawser__map_memo){.field = field, .options = options,
		.threads = thread_count(options->threads), .chunk = FIRST_CHUNK,
		.marks = field->lines > 0 && options->coarse > 1 ? field->marks
		         : field->margins ? HAWSER__MARGINS : 0,
		.checkpoint = {.fd = -1}};
	memo->worker = calloc((size_t)memo->threads, sizeof *memo->worker);
	memo->scratch = calloc((size_t)memo->threads*(size_t)field->marks + 1, sizeof(double));
	if (!memo->worker || !memo->scratch)
		return hawser__no_memory(report, "map");
	status = hawser__map_checkpoint_open(&memo->checkpoint, options->checkpoint, field->identity,
	                                     settings, memo->marks, &taker, report);
	for (int t = 0; t < memo->threads && !status; t++)
		status = field->open(&memo->worker[t], field->context, report);
	return status;
}

void hawser__map_memo_close(struct hawser__map_memo *memo)
{
	for (int t = 0; memo->worker && t < memo->threads; t++)
		memo->field->close(memo->worker[t]);
	free(memo->worker);
	free(memo->scratch);
	free(memo->record);
	free(memo->mark);
	free(memo->slot);
	free(memo->pending);
	hawser__map_checkpoint_close(&memo->checkpoint);
	*memo = (struct hawser__map_memo){.checkpoint = {.fd = -1}};
}

enum hawser_status hawser__map_want(struct hawser__map_memo *memo, long *index, double x, double y,
                                    struct hawser_report *report)
{
	enum hawser_status status = enter(memo, index, x + 0.0, y + 0.0, report);
	struct hawser__map_record *record;

	if (status)
		return status;
	record = &memo->record[*index];
	if (record->visited)
		return HAWSER_OK;
	record->visited = 1;
	memo->visited++;
	memo->restored += record->ready;
	if (record->ready)
		return HAWSER_OK;
	if (memo->waiting == memo->room) {
		long room = memo->room ? 2*memo->room : 512;
		long *pending = realloc(memo->pending, (size_t)room*sizeof *pending);

		if (!pending)
			return hawser__no_memory(report, "map");
		memo->pending = pending;
		memo->room = room;
	}
	memo->pending[memo->waiting++] = *index;
	return HAWSER_OK;
}

/* The failure of the first point is told, whichever thread met one first. */
struct failure {
	enum hawser_status status;
	int at;
	struct hawser_report report;
};

static void one_point(struct hawser__map_memo *memo, struct failure *failure, const long *pending,
                      int i)
{
	const struct hawser_map_field *field = memo->field;
	struct hawser__map_record *record = &memo->record[pending[i]];
	int thread = thread_number();
	double *marks = memo->marks > 0 ? memo->scratch + (size_t)thread*(size_t)field->marks : NULL;
	struct hawser_report local = {.status = HAWSER_OK};
	enum hawser_status status = field->point(memo->worker[thread], &record->sample, marks, record->x,
	                                         record->y, &local);

	if (marks)
		memcpy(memo->mark + pending[i]*memo->marks, marks,
		       (size_t)memo->marks*sizeof *marks);
	record->ready = !status;
	if (!status)
		return;
#ifdef _OPENMP
#pragma omp critical(hawser_map)
#endif
	if (!failure->status || i < failure->at)
		*failure = (struct failure){status, i, local};
}

static enum hawser_status prepare(struct hawser__map_memo *memo, const long *pending, int count,
                                  struct hawser_report *report)
{
	const struct hawser_map_field *field = memo->field;
	double *x = malloc(2*(size_t)count*sizeof *x), *y;
	enum hawser_status status = HAWSER_OK;

	if (!x)
		return hawser__no_memory(report, "map");
	y = x + count;
	for (int i = 0; i < count; i++) {
		x[i] = memo->record[pending[i]].x;
		y[i] = memo->record[pending[i]].y;
	}
	if (field->prepare)
		status = field->prepare(field->context, x, y, count, memo->threads, report);
	free(x);
	return status;
}

static enum hawser_status run_chunk(struct hawser__map_memo *memo, const long *pending, int count,
                                    struct hawser_report *report)
{
	struct failure failure = {.status = HAWSER_OK};
	enum hawser_status status = prepare(memo, pending, count, report);

	if (status)
		return status;
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic) num_threads(memo->threads)
#endif
	for (int i = 0; i < count; i++)
		one_point(memo, &failure, pending, i);
	if (failure.status) {
		if (report)
			*report = failure.report;
		return failure.status;
	}
	memo->fresh += count;
	for (int i = 0; i < count && !status; i++)
		status = hawser__map_checkpoint_add(&memo->checkpoint, &memo->record[pending[i]],
		                                    memo->mark + pending[i]*memo->marks, report);
	return status ? status : hawser__map_checkpoint_flush(&memo->checkpoint, report);
}

static double seconds(void)
{
	struct timespec now;

	clock_gettime(CLOCK_MONOTONIC, &now);
	return (double)now.tv_sec + 1e-9*(double)now.tv_nsec;
}

static int told_to_stop(const struct hawser__map_memo *memo, const char *stage, long left)
{
	const struct hawser_map_options *options = memo->options;
	long done = memo->visited - memo->waiting;

	return options->progress && options->progress(options->progress_context, stage, done,
	                                              done + left, memo->fresh);
}

enum hawser_status hawser__map_run(struct hawser__map_memo *memo, const char *stage, long later,
                                   struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	long at = 0, all = memo->waiting;

	while (at < all && !status) {
		int count = (int)(all - at < memo->chunk ? all - at : memo->chunk);
		double began = seconds(), took;

		if (told_to_stop(memo, stage, memo->waiting + later)) {
			memo->interrupted = 1;
			break;
		}
		status = run_chunk(memo, memo->pending + at, count, report);
		at += count;
		memo->waiting -= count;
		took = seconds() - began;
		if (took < LEAST_SECS && memo->chunk < MOST_CHUNK)
			memo->chunk *= 2;
		else if (took > MOST_SECS && memo->chunk > memo->threads)
			memo->chunk /= 2;
	}
	memo->waiting = 0;
	return status;
}
