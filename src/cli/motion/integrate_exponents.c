/* cli/motion/integrate_exponents.c - the settled part of a run: the transient before it,
 * Lyapunov exponents, and whether its rows are a stroboscopic section.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/motion/integrate_result.h"
#include "core/report.h"

enum hawser_status cli_integrate_settle(double **state, struct hawser_integrate_options *choice,
                                        double after, const struct hawser_rom *rom,
                                        struct hawser_report *report)
{
	size_t size = 2*(size_t)rom->n*sizeof **state;
	struct hawser_integrate_options before = *choice;
	struct hawser_trajectory run = {0};
	double *reached;
	enum hawser_status status;

	if (!(after > choice->begin) || !(after < choice->until))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate",
		                    "--after is %.9g%s: it must be after the beginning of the run and before "
		                    "its end, --until", after*rom->time, rom->scaled ? " s" : "");
	before.until = after;
	before.every = after - choice->begin;
	status = hawser_integrate(&run, rom, &before, report);
	if (!status && run.interrupted && run.time[run.rows - 1] < before.until)
		status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "integrate",
		                      "interrupted before --after: nothing is known");
	reached = status ? NULL : malloc(size);
	if (!status && !reached)
		status = hawser__no_memory(report, "integrate");
	if (!status) {
		memcpy(reached, run.state + (size_t)(run.rows - 1)*2*(size_t)rom->n, size);
		free(*state);
		*state = reached;
		choice->initial = reached;
		choice->begin = after;
	}
	hawser_trajectory_clear(&run);
	return status;
}

enum hawser_status cli_integrate_exponents(struct cli_integrate_result *result, int half,
                                           const struct hawser_integrate_options *choice,
                                           struct hawser_report *report)
{
	const struct hawser_trajectory *run = &result->run;
	const struct hawser_rom *rom = &result->model->rom;
	double omega = 2.0*M_PI/result->period, from = run->time[0], until = run->time[run->rows - 1];
	struct hawser_lyapunov_options options = {.omega = omega, .progress = choice->progress,
	                                          .rtol = choice->rtol};
	size_t row = 0;

	while (half && row + 2 < (size_t)run->rows && run->time[row] < 0.5*(from + until))
		row++;
	options.begin = run->time[row];
	options.initial = run->state + row*2*(size_t)run->n;
	options.periods = lround(floor((until - options.begin)/result->period + 1e-6));
	return hawser_lyapunov_find(&result->lyapunov, rom, &options, report);
}

/* Whether the interval of the rows is a whole number of periods. */
int cli_integrate_section(const struct cli_integrate_result *result)
{
	double periods = result->every/result->period;

	return result->omega > 0.0 && result->forcing.omega_to == 0.0 && periods > 0.5 &&
	       fabs(periods - round(periods)) < 1e-9*periods;
}
