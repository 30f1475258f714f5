/* cli/sweep/sweep_ranks.c - the variations of a sweep among the ranks of mpirun or srun: each
 * computes one at a time, rank 0 keeps the results and writes. See sweep_run.c and core/ranks.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "cli/frame/ranks.h"
#include "cli/sweep/sweep.h"
#include "core/report.h"

enum { PACKET = 64 }; /* variations of a packet; chosen: those of a millisecond go together */

/* What the tasks are about: in a worker `sweep` alone. */
struct sharing {
	struct cli_study *sweep;
	struct cli_sweep_run *run;
	long *pending; /* [tasks] variations that are to be computed */
};

static enum hawser_status ask(void *context, struct hawser__bytes *question, long number,
                              struct hawser_report *report)
{
	const struct sharing *sharing = context;

	(void)report;
	hawser__bytes_add_long(question, sharing->pending[number]);
	return HAWSER_OK;
}

static enum hawser_status work(void *context, struct hawser__bytes *answer,
                               const struct hawser__task *task, int worker,
                               struct hawser_report *report)
{
	const struct sharing *sharing = context;
	struct hawser__extract question = task->question;
	long variation = hawser__extract_long(&question);
	struct cli_sweep_packed packed;
	enum hawser_status status = cli_sweep_compute(&packed, sharing->sweep, variation, report);

	(void)worker;
	if (status)
		return status;
	hawser__bytes_add(answer, packed.text, packed.size);
	free(packed.text);
	return answer->short_of_memory ? hawser__no_memory(report, "sweep") : HAWSER_OK;
}

static enum hawser_status take(void *context, long number, struct hawser__extract *answer,
                               struct hawser_report *report)
{
	const struct sharing *sharing = context;
	struct cli_sweep_packed packed = {malloc(answer->left + 1), answer->left};

	if (!packed.text)
		return hawser__no_memory(report, "sweep");
	memcpy(packed.text, answer->at, packed.size);
	packed.text[packed.size] = '\0';
	return cli_sweep_finish(sharing->run, sharing->pending[number], packed, report);
}

static int watch(void *context, long done)
{
	const struct sharing *sharing = context;

	(void)done;
	return cli_sweep_watch(sharing->run);
}

static struct hawser__tasks tasks_of(struct sharing *sharing, const char *identity)
{
	return (struct hawser__tasks){.context = sharing, .threads = 1, .largest = PACKET,
		.what = "sweep", .identity = identity, .ask = ask, .work = work, .take = take,
		.watch = watch};
}

enum hawser_status cli_sweep_among(struct cli_sweep_run *run, struct hawser_report *report)
{
	char identity[CLI_SWEEP_IDENTITY];
	struct sharing sharing = {.sweep = run->sweep, .run = run};
	struct hawser__tasks tasks = tasks_of(&sharing, identity);
	long count = 0, variation;
	int stopped = 0;
	enum hawser_status status = cli_sweep_identity(identity, run->sweep, report);

	sharing.pending = malloc(((size_t)run->sweep->plan.count + 1)*sizeof *sharing.pending);
	if (!status && !sharing.pending)
		status = hawser__no_memory(report, "sweep");
	while (!status && (variation = cli_sweep_next(run)) < run->sweep->plan.count)
		sharing.pending[count++] = variation;
	if (!status)
		status = hawser__ranks_run(run->sweep->ranks, &stopped, &tasks, count, report);
	if (!status && stopped)
		status = cli_sweep_interrupted(run, report);
	free(sharing.pending);
	return status;
}

int cli_sweep_is_worker(const struct cli_study *sweep)
{
	return sweep->ranks && sweep->ranks->rank > 0;
}

enum hawser_status cli_sweep_serve(struct cli_study *sweep, struct hawser_report *report)
{
	char identity[CLI_SWEEP_IDENTITY];
	struct sharing sharing = {.sweep = sweep};
	struct hawser__tasks tasks = tasks_of(&sharing, identity);
	enum hawser_status status = cli_sweep_identity(identity, sweep, report);

	if (!status)
		hawser__ranks_serve(sweep->ranks, &tasks, status, report);
	return status;
}

enum hawser_status cli_sweep_ranks_open(struct cli_study *sweep, int threads,
                                        struct hawser_report *report)
{
	enum hawser_status status = cli_ranks_open(&sweep->ranks, "sweep", report);

	if (!status && sweep->ranks && threads > 1)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep", "--threads %d: each rank computes "
		                      "one variation at a time: start as many ranks as there are processors",
		                      threads);
	return status;
}

enum hawser_status cli_sweep_ranks_close(struct cli_study *sweep, enum hawser_status status,
                                         struct hawser_report *report)
{
	if (status) {
		size_t used = strlen(report->message);

		cli_ranks_fail(sweep->ranks, status, report);
		if (sweep->ranks && sweep->ranks->rank == 0 && sweep->ranks->lost)
			snprintf(report->message + used, sizeof report->message - used, "%s",
			         sweep->checkpoint ? "; the checkpoint has the results so far"
			                           : "; --checkpoint FILE would keep the results so far");
	}
	/* rank 0 tells of it; mpirun would end that rank as soon as another one fails */
	if (cli_sweep_is_worker(sweep))
		status = HAWSER_OK;
	cli_ranks_close(sweep->ranks, NULL);
	return status;
}
