/* cli/frame/ranks.c - the ranks among which a command shares its work; how they are found.
 *
 * MPI is started only where the environment says that there are several ranks, so that other calls do
 * not pay for it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "cli/frame/ranks.h"
#include "core/report.h"

/* Names of the numbers of ranks and of the own rank: of Open MPI's mpirun, of PMI (srun and others),
 * and of srun --mpi=pmix. */
static const char *const names[][2] = {
	{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"},
	{"PMI_SIZE", "PMI_RANK"},
	{"SLURM_NTASKS", "PMIX_RANK"},
};
enum { NAMES = sizeof names/sizeof *names };

/* Commands that share their work; the copies of others are separate. */
static const char *const sharing[] = {"map", "sweep", NULL};

static int silent;

static long number(const char *name)
{
	const char *text = getenv(name);

	return text ? strtol(text, NULL, 10) : -1;
}

/* The number of ranks, and the own one; 1 and 0: alone. */
static long find(long *rank)
{
	for (int k = 0; k < NAMES; k++) {
		*rank = number(names[k][1]);
		if (*rank >= 0 && number(names[k][0]) > 1)
			return number(names[k][0]);
	}
	*rank = 0;
	return 1;
}

static void forget(void)
{
	for (int k = 0; k < NAMES; k++) {
		unsetenv(names[k][1]);
		if (k < 2)
			unsetenv(names[k][0]);
	}
}

void cli_ranks_silence(const char *command)
{
	long rank;

	for (int k = 0; sharing[k]; k++)
		if (strcmp(command, sharing[k]) == 0 && find(&rank) > 1 && rank > 0)
			silent = 1;
}

int cli_ranks_silent(void)
{
	return silent;
}

enum hawser_status cli_ranks_open(struct hawser__ranks **to, const char *command,
                                  struct hawser_report *report)
{
	struct hawser__ranks *ranks;
	enum hawser_status status;
	long rank, count = find(&rank);

	*to = NULL;
	if (count < 2)
		return HAWSER_OK;
	ranks = calloc(1, sizeof *ranks);
	if (!ranks)
		return hawser__no_memory(report, command);
	status = cli_mpi_open(ranks, report);
	forget();
	if (!status)
		status = hawser__ranks_open(ranks, report);
	if (status) {
		free(ranks);
		return status;
	}
	if (ranks->rank > 0) {
		(void)signal(SIGINT, SIG_IGN);
		(void)signal(SIGTERM, SIG_IGN);
		(void)signal(SIGHUP, SIG_IGN);
	}
	*to = ranks;
	return HAWSER_OK;
}

void cli_ranks_fail(struct hawser__ranks *ranks, enum hawser_status status,
                    const struct hawser_report *why)
{
	const struct hawser__tasks none = {.threads = 1, .what = "ranks", .identity = ""};

	if (ranks && ranks->rank > 0 && !ranks->ended && status)
		hawser__ranks_serve(ranks, &none, status, why);
}

void cli_ranks_close(struct hawser__ranks *ranks, const struct hawser__tasks *tasks)
{
	if (!ranks)
		return;
	hawser__ranks_end(ranks, tasks);
	cli_mpi_close(ranks, !ranks->lost);
	hawser__ranks_clear(ranks);
	free(ranks);
}

int cli_ranks_threads(const struct hawser__ranks *ranks, int wanted)
{
	return wanted > 0 || !ranks || getenv("OMP_NUM_THREADS") ? wanted : 1;
}
