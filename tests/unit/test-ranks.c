/* Tasks handed out to ranks: here threads that exchange messages by lists. Results are the same for any
 * number of ranks and threads; failures, stops, ranks that end or have other settings.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <pthread.h>
#include <stdlib.h>

#include "core/ranks.h"
#include "core/report.h"
#include "tests/tap.h"

enum { MOST = 5, TASKS = 700 };

/* --- messages between threads --- */

struct letter {
	struct letter *next;
	int from;
	size_t length;
	unsigned char text[];
};
static struct letter *box[MOST];
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static int dead;

static enum hawser_status post(void *context, int to, const void *message, size_t length,
                               struct hawser_report *report)
{
	struct letter *letter = malloc(sizeof *letter + length), **at;

	if (!letter)
		return hawser__no_memory(report, "test");
	*letter = (struct letter){.from = *(int *)context, .length = length};
	memcpy(letter->text, message, length);
	pthread_mutex_lock(&lock);
	for (at = &box[to]; *at; at = &(*at)->next)
		;
	*at = letter;
	pthread_mutex_unlock(&lock);
	return HAWSER_OK;
}

static int collect(void *context, int *from, struct hawser__bytes *message)
{
	struct letter *letter;

	pthread_mutex_lock(&lock);
	letter = box[*(int *)context];
	if (letter)
		box[*(int *)context] = letter->next;
	pthread_mutex_unlock(&lock);
	if (!letter)
		return 0;
	*from = letter->from;
	message->used = 0;
	hawser__bytes_add(message, letter->text, letter->length);
	free(letter);
	return 1;
}

static int lost(void *context, int rank, char *name, size_t size)
{
	(void)context;
	snprintf(name, size, "process 4711");
	return rank == dead;
}

/* --- tasks: squares of what is asked --- */

struct work {
	double result[TASKS];
	int taken[TASKS];
	long prepared, last, fails, stop_at;
};

static enum hawser_status ask(void *context, struct hawser__bytes *question, long number,
                              struct hawser_report *report)
{
	(void)context, (void)report;
	hawser__bytes_add_double(question, 0.5*(double)number);
	return HAWSER_OK;
}

static enum hawser_status prepare(void *context, const struct hawser__task *task, int count,
                                  struct hawser_report *report)
{
	struct work *work = context;

	(void)task, (void)report;
	pthread_mutex_lock(&lock);
	work->prepared += count;
	pthread_mutex_unlock(&lock);
	return HAWSER_OK;
}

static enum hawser_status work_on(void *context, struct hawser__bytes *answer,
                                  const struct hawser__task *task, int worker,
                                  struct hawser_report *report)
{
	struct work *work = context;
	struct hawser__extract question = task->question;
	double x = hawser__extract_double(&question);

	if (work->fails && task->number >= work->fails && task->number % 10 == 0)
		return hawser__fail(report, HAWSER_ERR_NAN, "test", "task %ld failed", task->number);
	hawser__bytes_add_double(answer, x*x);
	hawser__bytes_add_text(answer, worker >= 0 && worker < MOST ? "ok" : "wrong worker");
	return HAWSER_OK;
}

static enum hawser_status take(void *context, long number, struct hawser__extract *answer,
                               struct hawser_report *report)
{
	struct work *work = context;
	char text[20];

	work->result[number] = hawser__extract_double(answer);
	hawser__extract_text(text, sizeof text, answer);
	work->taken[number]++;
	return strcmp(text, "ok") == 0 ? HAWSER_OK
	       : hawser__fail(report, HAWSER_ERR_ARGUMENT, "test", "%s", text);
}

static int watch(void *context, long done)
{
	const struct work *work = context;

	return work->stop_at && done >= work->stop_at;
}

static void leave(void *context, struct hawser__bytes *last)
{
	(void)context;
	hawser__bytes_add_long(last, 1);
}

static void take_last(void *context, struct hawser__extract *last)
{
	((struct work *)context)->last += hawser__extract_long(last);
}

static struct work works;
static const struct hawser__tasks usual = {
	.context = &works, .threads = 1, .largest = 50, .what = "test", .identity = "the same", .ask = ask,
	.prepare = prepare, .work = work_on, .take = take, .watch = watch, .leave = leave,
	.take_last = take_last,
};

struct rank {
	pthread_t thread;
	int number, count;
	struct hawser__tasks tasks;
	enum hawser_status status;
};

static void *serve(void *of)
{
	struct rank *rank = of;
	struct hawser__ranks ranks = {.rank = rank->number, .count = rank->count,
		.by = {&rank->number, post, collect, lost}};
	struct hawser_report report = {.message = "no scene here"};

	hawser__ranks_serve(&ranks, &rank->tasks, rank->status, &report);
	return NULL;
}

/* Two runs with so many ranks and threads. The status of the second, and its report. */
static enum hawser_status run(int count, int threads, int with_prepare, const char *identity,
                              enum hawser_status first, int *stopped, struct hawser_report *report)
{
	struct rank rank[MOST] = {{.number = 0}};
	int zero = 0;
	struct hawser__ranks ranks = {.count = count, .by = {&zero, post, collect, lost}};
	struct hawser__tasks tasks = usual;
	enum hawser_status status;

	tasks.threads = threads;
	tasks.prepare = with_prepare ? prepare : NULL;
	for (int r = 1; r < count; r++) {
		rank[r] = (struct rank){.number = r, .count = count, .tasks = tasks, .status = first};
		rank[r].tasks.identity = identity;
		pthread_create(&rank[r].thread, NULL, serve, &rank[r]);
	}
	status = hawser__ranks_open(&ranks, report);
	for (int again = 0; again < 2 && !status; again++)
		status = hawser__ranks_run(count > 1 ? &ranks : NULL, stopped, &tasks,
		                           again ? TASKS : 3, report);
	for (int all = dead ? 0 : 1000; status && all > 0; all--) {
		const struct timespec while_ready = {.tv_nsec = 100000};

		nanosleep(&while_ready, NULL); /* the others may be slow to start */
	}
	if (ranks.lost) /* here the thread lives */
		ranks.lost = 0;
	hawser__ranks_end(&ranks, &tasks);
	for (int r = 1; r < count; r++)
		pthread_join(rank[r].thread, NULL);
	hawser__ranks_clear(&ranks);
	return status;
}

static void is_complete(int count, int threads, int with_prepare)
{
	struct hawser_report report = {.status = HAWSER_OK};
	int stopped, wrong = 0;
	enum hawser_status status;

	memset(&works, 0, sizeof works);
	status = run(count, threads, with_prepare, "the same", HAWSER_OK, &stopped, &report);
	for (int k = 0; k < TASKS; k++)
		wrong += works.result[k] != 0.25*k*k || works.taken[k] != (k < 3 ? 2 : 1);
	ok(!status && !stopped && wrong == 0 && works.last == count - 1 &&
	   works.prepared == (with_prepare ? TASKS + 3 : 0),
	   "%d ranks, %d threads, %s: %d answers wrong %s", count, threads,
	   with_prepare ? "prepared" : "each", wrong, report.message);
}

/* Behind what did not find room nothing is added: what follows would be read in its place. */
static void gap(void)
{
	struct hawser__bytes bytes = {.at = NULL};

	hawser__bytes_add_long(&bytes, 7);
	bytes.short_of_memory = 1;
	hawser__bytes_add_long(&bytes, 8);
	ok(bytes.used == sizeof(long) && bytes.short_of_memory, "nothing is added behind a gap");
	hawser__bytes_empty(&bytes);
	hawser__bytes_add_long(&bytes, 9);
	ok(bytes.used == sizeof(long) && !bytes.short_of_memory, "an emptied sequence is filled again");
	hawser__bytes_clear(&bytes);
}

CASE(unit_ranks)
{
	struct hawser_report report = {.status = HAWSER_OK};
	int stopped;
	enum hawser_status status;

	for (int count = 1; count <= MOST; count += 2)
		for (int threads = 1; threads <= 3; threads += 2)
			for (int with = 0; with < 2; with++)
				is_complete(count, threads, with);

	memset(&works, 0, sizeof works);
	works.fails = 205;
	for (int count = 1; count <= 3; count += 2) {
		status = run(count, 2, 1, "the same", HAWSER_OK, &stopped, &report);
		ok(status == HAWSER_ERR_NAN && strcmp(report.message, "task 210 failed") == 0,
		   "the first of several failures, %d ranks: %s", count, report.message);
	}
	memset(&works, 0, sizeof works);
	works.stop_at = 1;
	status = run(3, 1, 1, "the same", HAWSER_OK, &stopped, &report);
	ok(!status && stopped, "stopped by watch");
	works.stop_at = 0;
	status = run(3, 1, 1, "another", HAWSER_OK, &stopped, &report);
	ok(!status || strstr(report.message, "another version, scene or settings than rank 0"),
	   "other settings: %s", report.message);
	status = run(3, 1, 1, "the same", HAWSER_ERR_SCENE, &stopped, &report);
	ok(!status || (status == HAWSER_ERR_SCENE && strstr(report.message, ": no scene here")),
	   "a worker without the scene: %s", report.message);
	gap();
	return done_testing();
}
