/* study/map/map_memo.c - the points of a map: each is computed once, many at a time.
 *
 * Points are identified by the bits of their coordinates. The point function of a field is pure, so
 * that neither the thread nor the run that computes a point matters. A checkpoint is this table in
 * a file. A map that is continued requests the same points in the same order and finds them here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/progress.h"
#include "core/report.h"
#include "core/share.h"
#include "study/map/map.h"

enum { FIRST_CHUNK = 16 };

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

/* *index becomes that of the record at x, y, which is created if necessary. */
static enum hawser_status enter(struct hawser__map_memo *memo, long *index, double x, double y,
                                struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	long *slot;

	if (2*(memo->count + 1) > memo->slots)
		status = grow_hash(memo, report);
	if (!status && (hawser__more(&memo->record, memo->count, sizeof *memo->record) ||
	                hawser__more(&memo->mark, memo->count, (size_t)memo->marks*sizeof *memo->mark)))
		status = hawser__no_memory(report, "map");
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

/* Take over a record of the checkpoint. */
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

enum hawser_status hawser__map_memo_open(struct hawser__map_memo *memo,
                                         const struct hawser_map_field *field,
                                         const struct hawser_map_options *options,
                                         const char *settings, struct hawser_report *report)
{
	struct hawser__map_taker taker = {restore, memo};
	enum hawser_status status;

	*memo = (struct hawser__map_memo){.field = field, .options = options,
		.began = hawser__wall_seconds(),
		.threads = options->threads > 0 ? options->threads : hawser__processors(),
		.marks = field->exponents > 0 && options->coarse > 1 ? field->marks
		         : field->margins ? HAWSER__MARGINS : 0,
		.checkpoint = {.fd = -1}};
	memo->worker = calloc((size_t)memo->threads, sizeof *memo->worker);
	memo->scratch = calloc((size_t)memo->threads*(size_t)field->marks + 1, sizeof(double));
	if (!memo->worker || !memo->scratch)
		return hawser__no_memory(report, "map");
	status = hawser__map_ranks_open(memo, settings, report);
	if (!status && (!options->ranks || options->ranks->rank == 0))
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
	free(memo->identity);
	hawser__map_checkpoint_close(&memo->checkpoint);
	*memo = (struct hawser__map_memo){.checkpoint = {.fd = -1}};
}

/* Whether the failure of this point ends a strict map. */
static int is_refused(const struct hawser__map_memo *memo, const struct hawser__map_record *record)
{
	return memo->options->strict && hawser_map_uncomputed(record->sample.code);
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
	/* a point that failed is computed again, since the checkpoint does not store the reason */
	if (record->ready && !is_refused(memo, record))
		return HAWSER_OK;
	if (hawser__more(&memo->pending, memo->waiting, sizeof *memo->pending))
		return hawser__no_memory(report, "map");
	memo->pending[memo->waiting++] = *index;
	return HAWSER_OK;
}

enum hawser_status hawser__map_refuse(const struct hawser__map_memo *memo, struct hawser_report *report,
                                      const struct hawser__map_record *record)
{
	const char *code = hawser_map_code_name(record->sample.code);
	char reason[400];

	if (!is_refused(memo, record))
		return HAWSER_OK;
	snprintf(reason, sizeof reason, "%.399s", report->message);
	return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "map",
	                    "the point x = %.9g, y = %.9g could not be computed (%s%s%s)", record->x,
	                    record->y, code, *reason ? ": " : "", reason);
}

int hawser__map_told_to_stop(const struct hawser__map_memo *memo, const char *stage, long left)
{
	struct hawser_progress_state state =
		hawser__progress_state(stage, "points", memo->visited - memo->waiting, memo->began);

	state.expected = state.done + left;
	state.fresh = memo->fresh;
	return hawser__told_to_stop(&memo->options->progress, &state);
}

enum hawser_status hawser__map_run(struct hawser__map_memo *memo, const char *stage, long later,
                                   struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	long at = 0, all = memo->waiting;

	memo->stage = stage;
	memo->later = later;
	while (at < all && !status && !memo->interrupted) {
		/* the first ones tell what a point costs */
		long count = memo->cost > 0.0 || all - at < FIRST_CHUNK ? all - at : FIRST_CHUNK;
		double began = hawser__wall_seconds();

		memo->interrupted = hawser__map_told_to_stop(memo, stage, memo->waiting + later);
		if (memo->interrupted)
			break;
		status = hawser__map_ranks_run(memo, memo->pending + at, count, report);
		at += count;
		memo->cost = (hawser__wall_seconds() - began)/(double)count;
	}
	memo->waiting = 0;
	return status;
}
