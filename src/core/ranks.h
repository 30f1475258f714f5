/* core/ranks.h - numbered tasks, handed out to the threads of this process and, where there are
 * some, to other processes (ranks, as MPI calls them).
 *
 *    task      number, and the question: the bytes by which a worker knows what to compute
 *    packet    consecutive tasks that are handed out together
 *    rank 0    hands out, computes too, and has all answers; the only one that writes files
 *    worker    a rank from 1 on; all ranks run the same command with the same arguments
 *
 * Rank 0 calls hawser__ranks_run, as often as it has tasks, and then hawser__ranks_end; each worker
 * calls hawser__ranks_serve, which returns after hawser__ranks_end. An answer depends on its
 * question only, and rank 0 puts it where its number belongs; so results do not depend on the
 * number of ranks and threads. With `ranks` NULL the tasks are computed by the threads of this
 * process. The library knows no MPI: how messages travel is a table of three functions
 * (src/cli/frame/mpi.c has that of MPI).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_RANKS_H
#define HAWSER_CORE_RANKS_H

#include <hawser/status.h>
#include "core/bytes.h"

struct hawser__task {
	long number;
	struct hawser__extract question;
};

/* What the tasks are. `ask` and `take` are called in rank 0, one call at a time; the others in each
 * rank. A status other than HAWSER_OK of any of them ends the run; if several tasks fail, the
 * report is that of the one with the lowest number. */
struct hawser__tasks {
	void *context;
	int threads;      /* of each rank, >= 1 */
	int largest;      /* most tasks of a packet; 1 for tasks of seconds */
	int brief;        /* 1: all of them are not worth a thread, and are computed in the caller's */
	const char *what; /* of progress and messages: "map", "sweep" */
	const char *identity; /* text that is the same in all ranks: version, scene, settings */
	/* Append the question of task `number`; NULL: its number says all. */
	enum hawser_status (*ask)(void *context, struct hawser__bytes *question, long number,
	                          struct hawser_report *report);
	/* Before the tasks [count] of a packet are computed; NULL: nothing. If there is one, a rank
	 * computes one packet at a time, by all its threads; else each thread of rank 0 takes
	 * packets of its own. */
	enum hawser_status (*prepare)(void *context, const struct hawser__task *task, int count,
	                              struct hawser_report *report);
	/* Compute, and append the answer. worker: 0 to threads - 1; calls with the same `worker` do
	 * not run at the same time. */
	enum hawser_status (*work)(void *context, struct hawser__bytes *answer,
	                           const struct hawser__task *task, int worker,
	                           struct hawser_report *report);
	/* Take the answer of a task; in any order. */
	enum hawser_status (*take)(void *context, long number, struct hawser__extract *answer,
	                           struct hawser_report *report);
	/* Called every 0.1 s in the caller's thread with the number of answers that were taken: for
	 * progress, and to write what has come. Not 0: hand out no more. NULL: nothing. */
	int (*watch)(void *context, long done);
	/* In a worker, after its last task: append what rank 0 is to know of all of them. In rank
	 * 0: take that. NULL: nothing. */
	void (*leave)(void *context, struct hawser__bytes *last);
	void (*take_last)(void *context, struct hawser__extract *last);
};

/* How messages travel. */
struct hawser__transport {
	void *context;
	/* Does not wait for the receiver; the message is copied. */
	enum hawser_status (*send)(void *context, int to, const void *message, size_t length,
	                           struct hawser_report *report);
	/* Does not wait: 1 if *message became one, of rank *from; 0 if there is none. */
	int (*receive)(void *context, int *from, struct hawser__bytes *message);
	/* 1 if rank `rank` is known to have ended, whose name (its process and machine) is then
	 * written to name [size]; called about twice a second. NULL: nothing is known. */
	int (*lost)(void *context, int rank, char *name, size_t size);
};

struct hawser__ranks {
	int rank, count;
	struct hawser__transport by;
	int *waiting; /* rank 0: [count] packets that were sent and not answered; -1: not ready yet */
	int hurried; /* 1: the last run was stopped */
	int ended; /* 1: the workers were told to end */
	int lost;  /* 1: a rank is lost, or does not answer: MPI can't be ended in order */
	double cost;  /* s of a task, last; 0: unknown */
	long messages; /* sent and received */
};
/* rank and count, and by, are set by the caller. Release with hawser__ranks_clear. */
enum hawser_status hawser__ranks_open(struct hawser__ranks *ranks, struct hawser_report *report);
void hawser__ranks_clear(struct hawser__ranks *ranks);

/* Compute tasks 0 to count - 1. *stopped becomes 1 if watch ended it; then answers may be missing.
 * Statuses of the functions of `tasks`; HAWSER_ERR_PROGRAM: a rank has ended or has another
 * version, scene or settings; HAWSER_ERR_MEMORY. */
enum hawser_status hawser__ranks_run(struct hawser__ranks *ranks, int *stopped,
                                     const struct hawser__tasks *tasks, long count,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
/* In a worker: compute what rank 0 hands out, until it ends. `status` and *report are those of what
 * came before, such as reading the scene: a failure is told to rank 0, and nothing is computed. */
void hawser__ranks_serve(struct hawser__ranks *ranks, const struct hawser__tasks *tasks,
                         enum hawser_status status, const struct hawser_report *report);
/* Rank 0: end the workers; without a call of hawser__ranks_run too. `tasks` may be NULL. */
void hawser__ranks_end(struct hawser__ranks *ranks, const struct hawser__tasks *tasks);

#endif
