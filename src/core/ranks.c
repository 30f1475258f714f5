/* core/ranks.c - numbered tasks, handed out to the threads of this process and to other processes.
 *
 * Rank 0's main thread receives, hands out and takes answers; its own threads take packets from the
 * same counter. A packet is about PACKET_SECS of work, and at most a part of what is left for each
 * that computes, so that all end at about the same time. A worker whose packets are short has one
 * more packet waiting, so that it does not wait for the next message.
 *
 * Nobody waits inside MPI, which would keep a processor busy (Open MPI polls): who has nothing to
 * do sleeps, first briefly, then longer.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/progress.h"
#include "core/ranks_packet.h"
#include "core/report.h"
#include "core/share.h"

#define PACKET_SECS 0.05   /* work of a packet; chosen: a message takes 25 us (bench/ranks), and on a
                            * busy machine a process may wait for milliseconds before it runs */
#define AHEAD_SECS 0.05    /* packets up to this work are sent one ahead; chosen */
#define WATCH_SECS 0.1     /* between two calls of `watch` */
#define LOST_SECS 0.5      /* between two looks at the other processes; chosen */
#define STOP_SECS 0.5      /* after a stop, the longest wait for answers; mpirun kills after 1 s */
/* Sleep with nothing to do, us; chosen: short beside a packet. Without other ranks the
 * threads wake this one. */
enum { FIRST_PAUSE_US = 50, LAST_PAUSE_US = 1000, ALONE_PAUSE_US = 50000 };

struct arrived {
	struct arrived *next;
	struct hawser__bytes message;
};

struct run {
	struct hawser__ranks *ranks;
	const struct hawser__tasks *tasks;
	long count, next, done;      /* tasks: all, handed out, taken */
	long out;                    /* handed out to threads here and not yet computed */
	int computers;               /* this rank's threads and other ranks that compute */
	double cost;                 /* s of a task; 0: unknown */
	int stopped;
	long failed;                 /* the lowest number that failed */
	enum hawser_status status;
	struct hawser_report report;
	pthread_mutex_t lock;        /* protects next, out, status, stopped and the list */
	pthread_cond_t news;
	struct arrived *first, **last;
};

struct thread {
	struct run *run;
	pthread_t thread;
	int number;
};

static void fail(struct run *run, long number, enum hawser_status status,
                 const struct hawser_report *report)
{
	if (run->status && number >= run->failed)
		return;
	run->status = status;
	run->failed = number;
	run->report = *report;
}

/* The number of tasks of the next packet. */
static int size_of(const struct run *run, int threads)
{
	double wanted = run->cost > 0.0 ? PACKET_SECS/run->cost : 1.0;
	long left = run->count - run->next, part = left/(2L*run->computers);
	long size = wanted < (double)run->tasks->largest ? (long)wanted : run->tasks->largest;

	size = size < part ? size : part;
	size = size > threads ? size : threads;
	size = size < run->tasks->largest ? size : run->tasks->largest;
	return (int)(size < left ? size : left);
}

/* Put the next packet into *message; 0 if there is none. Call it with the lock. */
static int next_packet(struct run *run, struct hawser__bytes *message, int threads)
{
	struct hawser_report report = {.status = HAWSER_OK};
	enum hawser_status status;
	int count;

	if (run->next >= run->count || run->status || run->stopped)
		return 0;
	count = size_of(run, threads);
	status = hawser__packet_ask(message, run->tasks, run->next, count, &report);
	if (status)
		fail(run, run->next, status, &report);
	run->next += status ? 0 : count;
	return status ? 0 : count;
}

/* --- the threads of rank 0 --- */

static void deliver(struct run *run, struct hawser__bytes *message)
{
	struct arrived *arrived = malloc(sizeof *arrived);
	struct hawser_report report = {.status = HAWSER_OK};

	if (!arrived) {
		fail(run, 0, hawser__no_memory(&report, run->tasks->what), &report);
		hawser__bytes_clear(message);
		return;
	}
	*arrived = (struct arrived){.message = *message};
	*run->last = arrived;
	run->last = &arrived->next;
	*message = (struct hawser__bytes){.at = NULL};
}

static void *compute(void *of)
{
	struct thread *thread = of;
	struct run *run = thread->run;
	int threads = run->tasks->prepare ? run->tasks->threads : 1, count;
	struct hawser__bytes packet = {.at = NULL}, answers = {.at = NULL};

	pthread_mutex_lock(&run->lock);
	while ((count = next_packet(run, &packet, threads)) > 0) {
		run->out += count;
		pthread_mutex_unlock(&run->lock);
		hawser__packet_work(&answers, &packet, run->tasks, threads, thread->number);
		pthread_mutex_lock(&run->lock);
		deliver(run, &answers);
		run->out -= count;
		pthread_cond_signal(&run->news);
	}
	pthread_mutex_unlock(&run->lock);
	hawser__bytes_clear(&packet);
	return NULL;
}

static int start(struct thread *thread, int most, struct run *run)
{
	int count = 0;

	for (; count < most; count++) {
		thread[count] = (struct thread){.run = run, .number = count};
		if (!hawser__thread_start(&thread[count].thread, compute, &thread[count]))
			break;
	}
	return count;
}

/* --- messages --- */

/* Take the answers of a message; with the lock. */
static void take(struct run *run, const struct hawser__bytes *message)
{
	struct hawser__extract view = {message->at, message->used, 0};
	long kind = hawser__extract_long(&view), first = hawser__extract_long(&view);
	long count = hawser__extract_long(&view);
	double secs = hawser__extract_double(&view)/(double)(count > 0 ? count : 1);
	struct hawser_report report = {.status = HAWSER_OK};

	(void)kind;
	if (view.bad) /* which tasks it was about is not known */
		fail(run, 0, hawser__no_memory(&report, run->tasks->what), &report);
	run->cost = run->cost > 0.0 ? 0.5*(run->cost + secs) : secs;
	for (long k = first; k < first + count; k++) {
		struct hawser__extract answer = hawser__extract_part(&view);
		enum hawser_status status = (enum hawser_status)hawser__extract_long(&answer);

		if (view.bad || answer.bad)
			status = hawser__no_memory(&report, run->tasks->what);
		else if (status)
			hawser__extract_text(report.message, sizeof report.message, &answer);
		else
			status = run->tasks->take(run->tasks->context, k, &answer, &report);
		report.status = status;
		report.where = run->tasks->what;
		if (status)
			fail(run, k, status, &report);
		run->done++;
	}
}

/* A worker's first message: its identity, or why it can't work. */
static void welcome(struct run *run, int from, const struct hawser__bytes *message)
{
	struct hawser__extract view = {message->at, message->used, 0};
	long kind = hawser__extract_long(&view);
	enum hawser_status status = (enum hawser_status)hawser__extract_long(&view);
	struct hawser__extract text = hawser__extract_part(&view);
	const char *identity = run->tasks->identity;
	struct hawser_report report = {.status = HAWSER_OK};
	int length = (int)(text.left < 400 ? text.left : 400);

	(void)kind;
	run->ranks->waiting[from] = 0;
	if (status) {
		status = hawser__fail(&report, status, run->tasks->what, "rank %d: %.*s", from, length,
		                      (const char *)text.at);
	} else if (view.bad || text.left != strlen(identity) ||
	           memcmp(text.at, identity, text.left) != 0) {
		status = hawser__fail(&report, HAWSER_ERR_PROGRAM, run->tasks->what,
		                      "rank %d has another version, scene or settings than rank 0: start the "
		                      "same program with the same files on all machines", from);
	}
	if (status)
		fail(run, 0, status, &report);
}

static int receive_all(struct run *run, struct hawser__bytes *message)
{
	struct hawser__ranks *ranks = run->ranks;
	int from, any = 0;

	while (ranks && ranks->by.receive(ranks->by.context, &from, message)) {
		struct hawser__extract view = {message->at, message->used, 0};
		long kind = hawser__extract_long(&view);

		any = 1;
		ranks->messages++;
		pthread_mutex_lock(&run->lock);
		if (kind == HAWSER__READY)
			welcome(run, from, message);
		if (kind == HAWSER__ANSWER) {
			ranks->waiting[from]--;
			take(run, message);
		}
		pthread_mutex_unlock(&run->lock);
	}
	return any;
}

static int take_local(struct run *run)
{
	int any = 0;

	pthread_mutex_lock(&run->lock);
	while (run->first) {
		struct arrived *arrived = run->first;

		take(run, &arrived->message);
		run->first = arrived->next;
		hawser__bytes_clear(&arrived->message);
		free(arrived);
		any = 1;
	}
	run->last = &run->first;
	pthread_mutex_unlock(&run->lock);
	return any;
}

static int hand_out(struct run *run, struct hawser__bytes *message)
{
	struct hawser__ranks *ranks = run->ranks;
	struct hawser_report report = {.status = HAWSER_OK};
	int any = 0;

	for (int r = 1; ranks && r < ranks->count; r++) {
		int most = run->cost > 0.0 && run->cost*run->tasks->threads < AHEAD_SECS ? 2 : 1;

		while (ranks->waiting[r] >= 0 && ranks->waiting[r] < most) {
			enum hawser_status status;
			int count;

			pthread_mutex_lock(&run->lock);
			count = next_packet(run, message, run->tasks->threads);
			pthread_mutex_unlock(&run->lock);
			if (count == 0)
				return any;
			any = 1;
			ranks->waiting[r]++;
			ranks->messages++;
			status = ranks->by.send(ranks->by.context, r, message->at, message->used, &report);
			if (status) {
				pthread_mutex_lock(&run->lock);
				fail(run, 0, status, &report);
				pthread_mutex_unlock(&run->lock);
				return any;
			}
		}
	}
	return any;
}

/* --- the main thread of rank 0 --- */

/* 1 while answers are missing. */
static int is_open(struct run *run)
{
	int open;

	pthread_mutex_lock(&run->lock);
	open = run->out > 0 || run->first || (run->next < run->count && !run->status && !run->stopped);
	for (int r = 1; run->ranks && r < run->ranks->count && !open; r++)
		open = run->ranks->waiting[r] > 0;
	pthread_mutex_unlock(&run->lock);
	return open;
}

static void wait_for_news(struct run *run, long us)
{
	struct timespec until;

	clock_gettime(CLOCK_MONOTONIC, &until);
	until.tv_nsec += us*1000;
	until.tv_sec += until.tv_nsec/1000000000;
	until.tv_nsec %= 1000000000;
	pthread_mutex_lock(&run->lock);
	if (!run->first)
		pthread_cond_timedwait(&run->news, &run->lock, &until);
	pthread_mutex_unlock(&run->lock);
}

/* Whether another process has ended, which ends the run. */
static void look_for_lost(struct run *run)
{
	struct hawser__ranks *ranks = run->ranks;
	struct hawser_report report = {.status = HAWSER_OK};
	char name[200];

	for (int r = 1; ranks && ranks->by.lost && r < ranks->count && !ranks->lost; r++) {
		enum hawser_status status;

		if (!ranks->by.lost(ranks->by.context, r, name, sizeof name))
			continue;
		ranks->lost = 1;
		status = hawser__fail(&report, HAWSER_ERR_PROGRAM, run->tasks->what,
		                      "rank %d (%s) has ended before its work was done; %ld of %ld tasks were "
		                      "done", r, name, run->done, run->count);
		pthread_mutex_lock(&run->lock);
		fail(run, -1, status, &report);
		pthread_mutex_unlock(&run->lock);
	}
}

struct clock {
	double watched, looked, stopped; /* s, of the last time; stopped: 0: not yet */
};

/* 0: the wait for answers is over. */
static int keep_watch(struct run *run, struct clock *clock)
{
	double now = hawser__wall_seconds();

	if (now - clock->watched >= WATCH_SECS && run->tasks->watch) {
		clock->watched = now;
		if (run->tasks->watch(run->tasks->context, run->done) && !run->stopped) {
			pthread_mutex_lock(&run->lock);
			run->stopped = 1;
			pthread_mutex_unlock(&run->lock);
			clock->stopped = now;
			clock->looked = 0.0; /* a signal may have come because another rank ended */
		}
	}
	if (now - clock->looked >= LOST_SECS) {
		clock->looked = now;
		look_for_lost(run);
	}
	if (run->ranks && run->ranks->lost)
		return 0;
	return !(clock->stopped > 0.0) || now - clock->stopped < STOP_SECS;
}

static void lead(struct run *run)
{
	struct clock clock = {.watched = hawser__wall_seconds()};
	struct hawser__bytes message = {.at = NULL};
	long pause = FIRST_PAUSE_US;

	clock.looked = clock.watched;
	while (is_open(run)) {
		int any = take_local(run);

		any |= receive_all(run, &message);
		any |= hand_out(run, &message);
		if (!keep_watch(run, &clock))
			break;
		pause = any ? FIRST_PAUSE_US : 2*pause < LAST_PAUSE_US ? 2*pause : LAST_PAUSE_US;
		if (!any)
			wait_for_news(run, run->ranks ? pause : ALONE_PAUSE_US);
	}
	hawser__bytes_clear(&message);
}

/* Without any thread, this one computes; then the answers wait in the list for all of the run. */
static enum hawser_status work_and_lead(struct run *run, struct hawser_report *report)
{
	int wanted = run->tasks->prepare ? 1 : run->tasks->threads, started;
	struct thread *thread = malloc((size_t)wanted*sizeof *thread);

	if (!thread)
		return hawser__no_memory(report, run->tasks->what);
	started = run->tasks->brief ? 0 : start(thread, wanted, run);
	if (started == 0) {
		thread[0] = (struct thread){.run = run};
		compute(&thread[0]);
	}
	lead(run);
	for (int t = 0; t < started; t++)
		pthread_join(thread[t].thread, NULL);
	take_local(run);
	free(thread);
	return HAWSER_OK;
}

enum hawser_status hawser__ranks_run(struct hawser__ranks *ranks, int *stopped,
                                     const struct hawser__tasks *tasks, long count,
                                     struct hawser_report *report)
{
	struct run run = {.ranks = ranks, .tasks = tasks, .count = count,
		.cost = ranks ? ranks->cost : 0.0, .lock = PTHREAD_MUTEX_INITIALIZER};
	pthread_condattr_t monotonic;
	enum hawser_status status;

	run.last = &run.first;
	run.computers = (tasks->prepare ? 1 : tasks->threads) + (ranks ? ranks->count - 1 : 0);
	pthread_condattr_init(&monotonic);
	pthread_condattr_setclock(&monotonic, CLOCK_MONOTONIC);
	pthread_cond_init(&run.news, &monotonic);
	status = work_and_lead(&run, report);
	if (!status && tasks->watch && tasks->watch(tasks->context, run.done))
		run.stopped = 1;
	if (!status && run.status) {
		status = run.status;
		if (report)
			*report = run.report;
	}
	*stopped = run.stopped;
	if (ranks) {
		ranks->cost = run.cost;
		ranks->hurried |= run.stopped;
	}
	pthread_cond_destroy(&run.news);
	pthread_condattr_destroy(&monotonic);
	pthread_mutex_destroy(&run.lock);
	return status;
}
