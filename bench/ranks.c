/* bench/ranks [TASKS [US [LARGEST]]] - the cost of handing out tasks to ranks.
 *
 * Tasks of US microseconds of work (default 0: none), 16 bytes of question and 200 of answer, as
 * points of maps have. All answers are verified. Without work, rank 0 sleeps through its own tasks,
 * so that its processor time is that of messages. Start it with mpirun -n N; without, threads of
 * one process.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "cli/frame/ranks.h"
#include "core/progress.h"

enum { ANSWER_DOUBLES = 25 };

struct work {
	double secs;
	long wrong;
	int sleeps;
};

static enum hawser_status ask(void *context, struct hawser__bytes *question, long number,
                              struct hawser_report *report)
{
	(void)context, (void)report;
	hawser__bytes_add_double(question, (double)number);
	hawser__bytes_add_double(question, 0.5);
	return HAWSER_OK;
}

static double thread_seconds(void)
{
	struct timespec now;

	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1e-9*(double)now.tv_nsec;
}

static enum hawser_status work_on(void *context, struct hawser__bytes *answer,
                                  const struct hawser__task *task, int worker,
                                  struct hawser_report *report)
{
	const struct work *work = context;
	struct hawser__extract question = task->question;
	double x = hawser__extract_double(&question), began = thread_seconds();

	(void)worker, (void)report;
	if (work->sleeps)
		nanosleep(&(struct timespec){.tv_nsec = 2000000}, NULL);
	while (thread_seconds() - began < work->secs)
		;
	for (int k = 0; k < ANSWER_DOUBLES; k++)
		hawser__bytes_add_double(answer, x + k);
	return HAWSER_OK;
}

static enum hawser_status take(void *context, long number, struct hawser__extract *answer,
                               struct hawser_report *report)
{
	struct work *work = context;

	(void)report;
	for (int k = 0; k < ANSWER_DOUBLES; k++)
		work->wrong += hawser__extract_double(answer) != (double)(number + k);
	return HAWSER_OK;
}

int main(int argc, char **argv)
{
	long count = argc > 1 ? atol(argv[1]) : 100000;
	struct work work = {.secs = argc > 2 ? 1e-6*atof(argv[2]) : 0.0};
	struct hawser__tasks tasks = {.context = &work, .threads = 1,
		.largest = argc > 3 ? atoi(argv[3]) : 4096, .what = "bench", .identity = "ranks", .ask = ask,
		.work = work_on, .take = take};
	struct hawser__ranks *ranks = NULL;
	struct hawser_report report = {.status = HAWSER_OK};
	double began = hawser__wall_seconds(), opened, wall, processor;
	int stopped = 0;
	enum hawser_status status = cli_ranks_open(&ranks, "bench", &report);

	opened = hawser__wall_seconds() - began;
	work.sleeps = ranks && ranks->rank == 0 && !(work.secs > 0.0);
	began = hawser__wall_seconds();
	processor = hawser__processor_seconds();
	if (!status && ranks && ranks->rank > 0)
		hawser__ranks_serve(ranks, &tasks, status, &report);
	else if (!status)
		status = hawser__ranks_run(ranks, &stopped, &tasks, count, &report);
	wall = hawser__wall_seconds() - began;
	processor = hawser__processor_seconds() - processor;
	if (!ranks || ranks->rank == 0)
		printf("%d rank%s, %ld tasks of %g us, %ld wrong%s%s; start %.3f s; %.3f s wall, %.3f s "
		       "processor of rank 0; %ld messages, %.1f us each\n",
		       ranks ? ranks->count : 1, ranks ? "s" : "", count, 1e6*work.secs, work.wrong,
		       status ? "; " : "", report.message, opened, wall, processor,
		       ranks ? ranks->messages : 0L,
		       ranks && ranks->messages ? 1e6*processor/(double)ranks->messages : 0.0);
	cli_ranks_close(ranks, &tasks);
	return status || work.wrong > 0;
}
