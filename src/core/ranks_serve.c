/* core/ranks_serve.c - the workers' side of ranks.c, and the end of both.
 *
 * Nobody waits inside MPI, which would keep a processor busy: who has nothing to do sleeps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <time.h>

#include "core/progress.h"
#include "core/ranks_packet.h"
#include "core/report.h"

#define LOOK_SECS 1.0 /* between two looks whether rank 0 is there; chosen */
#define HURRIED_SECS 0.05 /* the same after a stop: the program is ended 0.6 s after a signal */
#define END_SECS 60.0 /* the longest wait for the workers' last message; chosen */
enum { FIRST_PAUSE_US = 50, LAST_PAUSE_US = 1000 }; /* sleep with nothing to do, us; as in ranks.c */

static void nap(long us)
{
	const struct timespec time = {.tv_nsec = us*1000};

	nanosleep(&time, NULL);
}

/* Wait for a message of any rank, at most `secs`; 0: none came. */
static int await(struct hawser__ranks *ranks, int *from, struct hawser__bytes *message, double secs)
{
	double began = hawser__wall_seconds();
	long pause = FIRST_PAUSE_US;

	while (!ranks->by.receive(ranks->by.context, from, message)) {
		if (hawser__wall_seconds() - began > secs)
			return 0;
		nap(pause);
		pause = 2*pause < LAST_PAUSE_US ? 2*pause : LAST_PAUSE_US;
	}
	ranks->messages++;
	return 1;
}

static void answer(struct hawser__ranks *ranks, const struct hawser__bytes *message)
{
	struct hawser_report report; /* rank 0 finds out that this rank has ended */

	ranks->messages++;
	if (ranks->by.send(ranks->by.context, 0, message->at, message->used, &report))
		ranks->lost = 1;
}

void hawser__ranks_serve(struct hawser__ranks *ranks, const struct hawser__tasks *tasks,
                         enum hawser_status status, const struct hawser_report *report)
{
	struct hawser__bytes message = {.at = NULL}, answers = {.at = NULL};
	long kind = HAWSER__WORK;
	char name[200];
	int from;

	hawser__bytes_add_long(&answers, HAWSER__READY);
	hawser__bytes_add_long(&answers, (long)status);
	hawser__bytes_add_text(&answers, status ? report->message : tasks->identity);
	answer(ranks, &answers);
	while (kind != HAWSER__END && !ranks->lost) {
		struct hawser__extract view;

		if (!await(ranks, &from, &message, LOOK_SECS)) {
			ranks->lost = ranks->by.lost && ranks->by.lost(ranks->by.context, 0, name, sizeof name);
			continue;
		}
		view = (struct hawser__extract){message.at, message.used, 0};
		kind = hawser__extract_long(&view);
		if (kind != HAWSER__WORK)
			continue;
		hawser__packet_work(&answers, &message, tasks, tasks->threads, 0);
		answer(ranks, &answers);
	}
	hawser__bytes_empty(&answers);
	hawser__bytes_add_long(&answers, HAWSER__LAST_PACKET);
	if (!status && tasks->leave)
		tasks->leave(tasks->context, &answers);
	answer(ranks, &answers);
	ranks->ended = 1;
	hawser__bytes_clear(&message);
	hawser__bytes_clear(&answers);
}

void hawser__ranks_end(struct hawser__ranks *ranks, const struct hawser__tasks *tasks)
{
	struct hawser__bytes message = {.at = NULL};
	struct hawser_report report;
	int from, left = ranks->count - 1;

	if (ranks->rank != 0 || ranks->ended || ranks->lost)
		return;
	ranks->ended = 1;
	hawser__bytes_add_long(&message, HAWSER__END);
	for (int r = 1; r < ranks->count; r++)
		if (ranks->by.send(ranks->by.context, r, message.at, message.used, &report))
			ranks->lost = 1;
	while (left > 0 && !ranks->lost) {
		struct hawser__extract view;

		if (!await(ranks, &from, &message, ranks->hurried ? HURRIED_SECS : END_SECS))
			ranks->lost = 1;
		view = (struct hawser__extract){message.at, message.used, 0};
		if (ranks->lost || hawser__extract_long(&view) != HAWSER__LAST_PACKET)
			continue;
		left--;
		if (tasks && tasks->take_last && view.left > 0)
			tasks->take_last(tasks->context, &view);
	}
	hawser__bytes_clear(&message);
}

enum hawser_status hawser__ranks_open(struct hawser__ranks *ranks, struct hawser_report *report)
{
	ranks->waiting = malloc((size_t)ranks->count*sizeof *ranks->waiting);
	if (!ranks->waiting)
		return hawser__no_memory(report, "ranks");
	for (int r = 0; r < ranks->count; r++)
		ranks->waiting[r] = -1;
	return HAWSER_OK;
}

void hawser__ranks_clear(struct hawser__ranks *ranks)
{
	free(ranks->waiting);
	ranks->waiting = NULL;
}
