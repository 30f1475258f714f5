/* cli/sweep/sweep_run.c - compute the variations of a sweep: alone, by several processes
 * (sweep_processes.c) or among ranks (sweep_ranks.c). See sweep.h.
 *
 * A result depends on its variation alone, and is kept by its number: so the table has the same
 * bytes whoever computes them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "cli/sweep/sweep.h"
#include "core/progress.h"
#include "core/report.h"

/* --- one variation --- */

/* Cut off what a message begins with if it is of this variation, "--set KEY=VALUE: ": all
 * places where it is shown name the variation. */
static void shorten(struct cli_sweep_packed *packed, const struct cli_study *sweep, long variation)
{
	static const char begins[] = "\nM --set ";
	char set[CLI_SWEEP_SET], *at = strstr(packed->text, begins);

	for (int k = 0; k < sweep->plan.keys && at; k++) {
		char *text = at + sizeof begins - 1;
		size_t length;

		cli_sweep_set(set, &sweep->plan, k, variation);
		length = strlen(set);
		if (strncmp(text, set, length) != 0 || strncmp(text + length, ": ", 2) != 0)
			continue;
		length += 2 + (size_t)(text - (at + 3));
		memmove(at + 3, at + 3 + length, strlen(at + 3 + length) + 1);
		packed->size -= length;
		return;
	}
}

enum hawser_status cli_sweep_compute(struct cli_sweep_packed *packed, const struct cli_study *sweep,
                                     long variation, struct hawser_report *report)
{
	const struct cli_sweep_plan *plan = &sweep->plan;
	int count = sweep->words + 2*plan->keys, words = sweep->words;
	char **word = calloc((size_t)count + 1, sizeof *word);
	char (*set)[CLI_SWEEP_SET] = malloc(((size_t)plan->keys + 1)*sizeof *set);
	static char option[] = "--set";
	enum hawser_status status = word && set ? HAWSER_OK : hawser__no_memory(report, "sweep");

	if (!status) {
		memcpy(word, sweep->word, (size_t)words*sizeof *word);
		for (int k = 0; k < plan->keys; k++) {
			cli_sweep_set(set[k], plan, k, variation);
			word[words++] = option;
			word[words++] = set[k];
		}
		status = cli_sweep_pack(packed, &sweep->choice, words, word, report);
	}
	if (!status)
		shorten(packed, sweep, variation);
	free(word);
	free(set);
	return status;
}

/* --- what is common to all ways --- */

/* 1 if it belongs to the part that is computed. */
static int is_mine(const struct cli_study *sweep, long variation)
{
	return sweep->parts == 0 || variation % sweep->parts == sweep->part - 1;
}

/* The first variation that has a result must have what is asked for. */
static enum hawser_status check_first(struct cli_sweep_run *run, struct hawser_report *report)
{
	const struct cli_study *sweep = run->sweep;

	for (; !run->checked && run->first < sweep->plan.count; run->first++) {
		const char *text = sweep->packed[run->first].text, *missing;

		if (!text && is_mine(sweep, run->first))
			break;
		missing = text ? strstr(text, "\nX ") : NULL;
		run->checked = text && text[2] == '0';
		if (run->checked && missing)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep", "%.*s",
			                    (int)strcspn(missing + 3, "\n"), missing + 3);
	}
	return HAWSER_OK;
}

enum hawser_status cli_sweep_finish(struct cli_sweep_run *run, long variation,
                                    struct cli_sweep_packed packed, struct hawser_report *report)
{
	enum hawser_status status = cli_sweep_file_add(&run->file, variation, &packed, report);

	run->sweep->packed[variation] = packed;
	run->done++;
	run->fresh++;
	return status ? status : check_first(run, report);
}

long cli_sweep_next(struct cli_sweep_run *run)
{
	const struct cli_study *sweep = run->sweep;

	while (run->next < sweep->plan.count &&
	       (sweep->packed[run->next].text || !is_mine(sweep, run->next)))
		run->next++;
	return run->next < sweep->plan.count ? run->next++ : run->next;
}

int cli_sweep_watch(struct cli_sweep_run *run)
{
	struct hawser_progress_state state = hawser__progress_state("sweep", "variations", run->done,
	                                                            run->began);

	state.expected = run->count;
	state.fresh = run->fresh;
	return hawser__told_to_stop(&(struct hawser_progress){cli_watch, &run->watch}, &state);
}

enum hawser_status cli_sweep_interrupted(const struct cli_sweep_run *run,
                                         struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "sweep", "interrupted after %ld of %ld "
	                    "variations: no result is written%s", run->done, run->count,
	                    run->sweep->checkpoint ? "; the same command continues from the checkpoint"
	                                           : " (--checkpoint FILE would keep them)");
}

static enum hawser_status alone(struct cli_sweep_run *run, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	long variation;

	while (!status && (variation = cli_sweep_next(run)) < run->sweep->plan.count) {
		struct cli_sweep_packed packed;

		if (cli_sweep_watch(run))
			return cli_sweep_interrupted(run, report);
		status = cli_sweep_compute(&packed, run->sweep, variation, report);
		if (cli_interrupted()) {
			if (!status)
				free(packed.text);
			return cli_sweep_interrupted(run, report);
		}
		if (!status)
			status = cli_sweep_finish(run, variation, packed, report);
	}
	return status;
}

static enum hawser_status compute(struct cli_sweep_run *run, struct hawser_report *report)
{
	long left = run->count - run->done, count = run->sweep->processes;

	count = count < left ? count : left;
	count = count < CLI_SWEEP_PROCESSES ? count : CLI_SWEEP_PROCESSES;
	if (run->sweep->ranks)
		return cli_sweep_among(run, report);
	return count > 1 ? cli_sweep_together(run, (int)count, report) : alone(run, report);
}

enum hawser_status cli_sweep_run(struct cli_study *sweep, struct hawser_report *report)
{
	struct cli_sweep_run run = {.sweep = sweep, .file = {.fd = -1}, .began = hawser__wall_seconds(),
	                            .watch = {.progress = {.quiet = sweep->common->quiet}}};
	enum hawser_status status = HAWSER_OK;

	sweep->packed = calloc((size_t)sweep->plan.count, sizeof *sweep->packed);
	if (!sweep->packed)
		return hawser__no_memory(report, "sweep");
	if (sweep->checkpoint)
		status = cli_sweep_file_open(&run.file, sweep, report);
	for (long i = 0; i < sweep->plan.count; i++) {
		run.count += is_mine(sweep, i);
		run.done += is_mine(sweep, i) && sweep->packed[i].text;
	}
	if (!status)
		status = check_first(&run, report);
	if (!status)
		status = compute(&run, report);
	sweep->done = run.done;
	cli_progress_end(&run.watch.progress);
	cli_sweep_file_close(&run.file);
	return status;
}
