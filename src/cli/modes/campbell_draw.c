/* cli/modes/campbell_draw.c - the picture of a Campbell diagram: conversion of eigenvalues to the
 * requested unit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "cli/modes/campbell_result.h"
#include "core/report.h"

/* What the picture shows, in its units; [] as in struct hawser__campbell. */
struct arrays {
	double *speed, *re, *im, *mark_x, *mark_y;
	double per_speed, per; /* the units of speed and eigenvalues */
	int *veers;
};

/* Frequency at which a crossover is marked on the branch with that number: offset from the middle
 * of the gap by `part` of the gap. */
static double mark_on(const struct arrays *to, const struct cli_campbell_result *result,
                      const struct hawser_campbell_crossover *at, int number, double part)
{
	return number > result->campbell.in_plane
		? NAN : cli_campbell_in_unit(result, at->omega + part*at->gap)/to->per;
}

static void fill(struct arrays *to, const struct cli_campbell_result *result)
{
	const struct hawser_campbell *campbell = &result->campbell;
	int i;

	for (i = 0; i < campbell->stations; i++)
		to->speed[i] = campbell->station[i].speed/to->per_speed;
	for (i = 0; i < campbell->stations*campbell->branches; i++) {
		to->re[i] = cli_campbell_in_unit(result, campbell->re[i])/to->per;
		to->im[i] = cli_campbell_in_unit(result, campbell->im[i])/to->per;
	}
	for (i = 0; i < campbell->crossovers; i++) {
		const struct hawser_campbell_crossover *at = &campbell->crossover[i];

		to->mark_x[i] = at->speed/to->per_speed;
		to->mark_y[2*i] = mark_on(to, result, at, at->below, -0.5);
		to->mark_y[2*i + 1] = mark_on(to, result, at, at->above, 0.5);
		to->veers[i] = at->kind == HAWSER_VEERING;
	}
}

static enum hawser_status allocate(struct arrays *to, const struct hawser_campbell *campbell,
                                   struct hawser_report *report)
{
	size_t stations = (size_t)campbell->stations, marks = (size_t)campbell->crossovers;
	size_t size = stations*(size_t)campbell->branches;

	to->speed = calloc(stations, sizeof *to->speed);
	to->re = calloc(size, sizeof *to->re);
	to->im = calloc(size, sizeof *to->im);
	to->mark_x = calloc(marks + 1, sizeof *to->mark_x);
	to->mark_y = calloc(2*marks + 1, sizeof *to->mark_y);
	to->veers = calloc(marks + 1, sizeof *to->veers);
	if (to->speed && to->re && to->im && to->mark_x && to->mark_y && to->veers)
		return HAWSER_OK;
	return hawser__no_memory(report, "campbell");
}

enum hawser_status cli_campbell_draw(const char *path, const void *context,
                                     struct hawser_report *report)
{
	const struct cli_campbell_result *result = context;
	const struct hawser_campbell *campbell = &result->campbell;
	struct arrays to = {0};
	enum hawser_status status = allocate(&to, campbell, report);

	if (!status) {
		struct hawser__axis speed = cli_campbell_axis("speed", result);
		struct hawser__axis re = cli_campbell_axis("re", result), im = cli_campbell_axis("im", result);
		const struct hawser__campbell picture = {
			.stations = campbell->stations, .branches = campbell->branches,
			.in_plane = campbell->in_plane, .marks = campbell->crossovers,
			.harmonics = result->harmonics,
			.speed_title = speed.title, .re_title = re.title, .im_title = im.title,
			.speed = to.speed, .re = to.re, .im = to.im, .mark_x = to.mark_x,
			.mark_y = to.mark_y, .veers = to.veers,
			.slope = cli_campbell_in_unit(result, result->harmonics
				? 2.0*M_PI/result->spacing : 0.0)*speed.per/im.per,
			.limit = campbell->criticals ? campbell->limit/speed.per : NAN};

		to.per_speed = speed.per;
		to.per = im.per;
		fill(&to, result);
		status = hawser__plot_campbell(path, &picture, report);
	}
	free(to.speed);
	free(to.re);
	free(to.im);
	free(to.mark_x);
	free(to.mark_y);
	free(to.veers);
	return status;
}
