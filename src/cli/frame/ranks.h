/* cli/frame/ranks.h - the ranks among which a command shares its work: processes that mpirun or srun
 * started.
 *
 * A command that shares its work has its name in the list of ranks.c. It calls cli_ranks_open
 * first, then prepares the same in all ranks; a worker calls hawser__ranks_serve in place of the
 * computation, and writes nothing:
 *
 *    status = cli_ranks_open(&ranks, "sweep", report);
 *    ... read the input, fill `tasks` ...
 *    if (ranks && ranks->rank > 0)
 *        hawser__ranks_serve(ranks, &tasks, status, report);
 *    else if (!status)
 *        status = hawser__ranks_run(ranks, &stopped, &tasks, count, report);
 *    cli_ranks_close(ranks, &tasks);
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_RANKS_H
#define HAWSER_CLI_RANKS_H

#include "core/ranks.h"

/* Called with the name of the command before anything is printed: if it shares its work, and the
 * environment says that this process is not the first of several ranks, it prints nothing. */
void cli_ranks_silence(const char *command);
int cli_ranks_silent(void);

/* *ranks: those that mpirun or srun started, or NULL: this process alone. In a worker SIGINT,
 * SIGTERM and SIGHUP are ignored from here on: rank 0 ends it. Programs that are started later are
 * no ranks. HAWSER_ERR_PROGRAM: this program is built without MPI, or the MPI library can't be
 * loaded. */
enum hawser_status cli_ranks_open(struct hawser__ranks **ranks, const char *command,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
/* In a worker that could not prepare its work: tell rank 0 why. In others, and after
 * hawser__ranks_serve: nothing. */
void cli_ranks_fail(struct hawser__ranks *ranks, enum hawser_status status,
                    const struct hawser_report *why);
/* End the workers, and MPI. `tasks` as of hawser__ranks_end; may be NULL. If a rank is lost, MPI is
 * left as it is, since it would wait for that rank. */
void cli_ranks_close(struct hawser__ranks *ranks, const struct hawser__tasks *tasks);
/* Threads of each rank: `wanted`, or OMP_NUM_THREADS, or 1 with several ranks, which the starter of
 * ranks places on processors of their own. 0: as one process. */
int cli_ranks_threads(const struct hawser__ranks *ranks, int wanted);

/* mpi.c: the transport by Open MPI, rank and count. HAWSER_ERR_PROGRAM as above. */
enum hawser_status cli_mpi_open(struct hawser__ranks *ranks, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* in_order: 0: leave MPI as it is. */
void cli_mpi_close(struct hawser__ranks *ranks, int in_order);

#endif
