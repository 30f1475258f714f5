/* response/time/surge_run.c - a model integrated from rest, in step with the samples of surge.c.
 *
 * The integrator has output between its steps, so that closely spaced samples do not shorten them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "core/report.h"
#include "response/time/surge_parts.h"

/* Tolerances of a tension that is known to 0.1 % at best; chosen. */
static const double relative = 1e-8, absolute = 1e-12;

enum hawser_status hawser__surge_run_open(struct hawser__surge_run *run,
                                          const struct hawser_rom *rom, double omega, double end,
                                          struct hawser_report *report)
{
	const struct hawser_ramp *ramp = rom->ramp;

	*run = (struct hawser__surge_run){.rom = rom, .end = end};
	run->method = hawser__integrate_default(rom);
	run->problem = (struct hawser__stepper){.rom = rom, .omega = omega, .rtol = relative,
		.atol = absolute, .until = ramp && ramp->time < end ? ramp->time : end,
		.max_steps = HAWSER_DEFAULT_MAX_STEPS, .bad_coordinate = -1};
	run->y = calloc(2*(size_t)rom->n, sizeof *run->y);
	if (run->y)
		run->stepper = run->method->open(&run->problem, run->y);
	return run->stepper ? HAWSER_OK : hawser__no_memory(report, "surge");
}

/* At the end of the ramp the forces are discontinuous: no step extends across it. */
static enum hawser_status cross(struct hawser__surge_run *run, struct hawser_report *report)
{
	enum hawser_status status = run->method->advance(run->stepper, run->y, run->problem.until,
	                                                 report);

	if (status)
		return status;
	run->problem.begin = run->problem.until;
	run->problem.until = run->end;
	run->problem.over = 1;
	run->method->close(run->stepper);
	run->stepper = run->method->open(&run->problem, run->y);
	return run->stepper ? HAWSER_OK : hawser__no_memory(report, "surge");
}

enum hawser_status hawser__surge_run_at(struct hawser__surge_run *run, double t,
                                        struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	if (t > run->problem.until && run->problem.until < run->end)
		status = cross(run, report);
	return status ? status : run->method->advance(run->stepper, run->y, t, report);
}

void hawser__surge_run_clear(struct hawser__surge_run *run)
{
	if (run->stepper)
		run->method->close(run->stepper);
	free(run->y);
	*run = (struct hawser__surge_run){.rom = NULL};
}
