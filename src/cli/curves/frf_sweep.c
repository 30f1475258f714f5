/* cli/curves/frf_sweep.c - see frf_sweep.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "cli/curves/frf_sweep.h"
#include "cli/frame/progress.h"

/* One sweep between the ends of the range. */
static enum hawser_status sweep(struct cli_sweep *sweep, int direction, int points,
                                const struct cli_frf_result *result, struct hawser_report *report)
{
	struct cli_watch watch = {{.quiet = result->common->quiet},
	                          direction > 0 ? "up-sweep" : "down-sweep"};
	struct hawser_sweep_options choice = {0};
	enum hawser_status status;

	choice.from = direction > 0 ? fmin(result->from, result->to) : fmax(result->from, result->to);
	choice.to = direction > 0 ? fmax(result->from, result->to) : fmin(result->from, result->to);
	choice.count = points;
	choice.progress = (struct hawser_progress){cli_watch, &watch};
	sweep->direction = direction;
	status = hawser_sweep_run(&sweep->run, &result->model->rom, &choice, report);
	cli_progress_end(&watch.progress);
	return status;
}

enum hawser_status cli_sweeps(struct cli_sweep *list, int *count, const char *which, int points,
                              const struct cli_frf_result *result, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int direction = 1; direction >= -1 && which && !status; direction -= 2) {
		if (cli_interrupted() ||
		    (strcmp(which, "both") != 0 && strcmp(which, direction > 0 ? "up" : "down") != 0))
			continue;
		status = sweep(&list[*count], direction, points, result, report);
		*count += !status;
	}
	return status;
}
