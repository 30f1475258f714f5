/* cli/curves/frf_cover.c - further branches of a frequency response, for the parts of the range
 * that the first one does not cover: computing, reporting, and joining them for the picture.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "cli/curves/frf_cover.h"
#include "core/report.h"

enum hawser_status cli_cover_trace(struct cli_cover *cover, struct cli_frf_result *result,
                                   const struct hawser_frf_options *options,
                                   struct cli_progress *progress, cli_peaks_function *peaks,
                                   struct hawser_report *report)
{
	struct cli_watch watch = {*progress, "frf: the rest of the range"};
	struct hawser_frf_options choice = *options;
	enum hawser_status status;

	choice.progress = (struct hawser_progress){cli_watch, &watch};
	status = hawser_cover_trace(&cover->of, result->frf, &result->model->rom, &choice, report);
	*progress = watch.progress;
	result->costly = cover->of.costly;
	if (status || cover->of.branches + cover->of.gaps == 0)
		return status;
	cover->other = calloc((size_t)cover->of.branches + 1, sizeof *cover->other);
	if (!cover->other)
		return hawser__no_memory(report, "frf");
	for (int k = 0; k < cover->of.branches && !status; k++) {
		struct hawser_landmark *peak = NULL;

		cover->other[k] = *result;
		cover->other[k].frf = &cover->of.branch[k];
		status = peaks(&peak, &cover->other[k], progress, options,
		               cover->of.branch[k].end == HAWSER_END_FAILED, report);
		cover->other[k].peak = peak;
	}
	result->other = cover->other;
	result->others = cover->of.branches;
	result->gap = cover->of.gap;
	result->gaps = cover->of.gaps;
	return status;
}

void cli_cover_clear(struct cli_cover *cover)
{
	for (int k = 0; k < cover->of.branches + cover->borns && cover->other; k++)
		free((void *)cover->other[k].peak);
	for (int k = 0; k < cover->borns; k++) {
		hawser_frf_clear(cover->born[k]);
		free(cover->born[k]);
	}
	free(cover->born);
	free(cover->missed);
	free(cover->other);
	hawser_cover_clear(&cover->of);
}

/* --- one structure of all branches, for the picture --- */

static size_t append(double **to, size_t filled, const double *rows, int points, int width)
{
	size_t count = (size_t)points*(size_t)width;

	if (*to && rows)
		memcpy(*to + filled*(size_t)width, rows, count*sizeof *rows);
	return filled + (size_t)points;
}

static void append_branch(struct cli_joined *joined, const struct cli_frf_result *one)
{
	struct hawser_frf *all = &joined->frf;
	const struct hawser_frf *frf = one->frf;
	size_t filled = (size_t)all->points;

	memcpy(all->point + filled, frf->point, (size_t)frf->points*sizeof *frf->point);
	append(&all->probe, filled, frf->probe, frf->points, 3*frf->probes);
	append(&all->coordinate, filled, frf->coordinate, frf->points, frf->n);
	for (int e = 0; e < frf->events; e++) {
		all->event[all->events] = frf->event[e];
		all->event[all->events++].after += all->points;
	}
	for (int i = 0; i < frf->points; i++)
		joined->branch[all->points++] = frf->branch;
	if (one->peaks > 0)
		memcpy(joined->peak + joined->peaks, one->peak, (size_t)one->peaks*sizeof *one->peak);
	joined->peaks += one->peaks;
}

/* Row i of the branches: the first branch, then the others. */
static const struct cli_frf_result *nth(const struct cli_frf_result *result, int k)
{
	return k == 0 ? result : &result->other[k - 1];
}

int cli_frf_join(struct cli_joined *joined, const struct cli_frf_result *result)
{
	size_t points = 0, events = 0, peaks = 0;
	struct hawser_frf *all = &joined->frf;

	for (int k = 0; k <= result->others; k++) {
		points += (size_t)nth(result, k)->frf->points;
		events += (size_t)nth(result, k)->frf->events;
		peaks += (size_t)nth(result, k)->peaks;
	}
	*joined = (struct cli_joined){.frf = {.n = result->frf->n, .probes = result->frf->probes}};
	all->point = malloc((points + 1)*sizeof *all->point);
	all->probe = malloc((points*3*(size_t)all->probes + 1)*sizeof *all->probe);
	all->coordinate = malloc((points*(size_t)all->n + 1)*sizeof *all->coordinate);
	all->event = malloc((events + 1)*sizeof *all->event);
	joined->peak = malloc((peaks + 1)*sizeof *joined->peak);
	joined->branch = malloc((points + 1)*sizeof *joined->branch);
	if (!all->point || !all->probe || !all->coordinate || !all->event || !joined->peak ||
	    !joined->branch)
		return 1;
	for (int k = 0; k <= result->others; k++)
		append_branch(joined, nth(result, k));
	return 0;
}

void cli_joined_clear(struct cli_joined *joined)
{
	hawser_frf_clear(&joined->frf);
	free(joined->peak);
	free(joined->branch);
}
