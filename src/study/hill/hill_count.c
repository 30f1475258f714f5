/* study/hill/hill_count.c - numbers of unstable multipliers at points of a plane, computed by several
 * threads.
 *
 * Rough multipliers suffice if the largest is clearly inside or outside the unit circle. Without
 * damping, condensation and long steps change phases but not moduli, so that they suffice nearly
 * everywhere. Elsewhere the strict multipliers are compared with their errors
 * (response/torus/circle.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "core/report.h"
#include "core/share.h"
#include "response/floquet/linear_margin.h"
#include "study/hill/hill.h"

#define CLEAR 1e-3     /* largest error of the logarithms of the moduli of rough multipliers; chosen
                        * with a margin */
#define UNDAMPED 1e-6  /* the same without damping: only round-off of the integration remains;
                        * chosen */
#define ALONE 1e-6     /* threshold for a field without models, whose errors are not known; chosen */

struct hawser_hill_counter {
	struct hawser__hill hill;
	struct hawser_hill_options options;
};

struct counting {
	struct hawser__hill *hill;
	int *unstable;
	const double *x, *y;
};

enum hawser_status hawser_hill_counter_open(struct hawser_hill_counter **to,
                                            const struct hawser_hill_field *field,
                                            struct hawser_report *report)
{
	struct hawser_hill_counter *counter = calloc(1, sizeof *counter);
	enum hawser_status status;

	*to = NULL;
	if (!counter)
		return hawser__no_memory(report, "hill");
	/* points in units of the caller, not scaled to the rectangle */
	counter->options = (struct hawser_hill_options){.to = {1.0, 1.0}};
	counter->hill = (struct hawser__hill){.field = field, .options = &counter->options,
		.report = report};
	status = hawser__hill_open(&counter->hill);
	if (status)
		hawser_hill_counter_free(counter);
	else
		*to = counter;
	return status;
}

void hawser_hill_counter_free(struct hawser_hill_counter *counter)
{
	if (!counter)
		return;
	hawser__hill_close(&counter->hill);
	free(counter);
}

static int beyond(const struct hawser__hill_worker *worker, double limit)
{
	int count = 0;

	for (int i = 0; i < worker->m; i++)
		count += worker->log_modulus[i] > limit;
	return count;
}

/* If the rough multipliers are far enough from the circle, set *count and return 1. */
static int rough(int *count, struct hawser__hill *hill, struct hawser__hill_worker *worker,
                 const double at[2])
{
	if (!worker->linear || hawser__hill_multipliers(hill, worker, at, 1))
		return 0;
	if (hawser__hill_undamped(worker)) {
		*count = beyond(worker, UNDAMPED);
		return *count == 0 || beyond(worker, CLEAR) == *count;
	}
	*count = beyond(worker, 0.0);
	return beyond(worker, -CLEAR) == beyond(worker, CLEAR);
}

static int strict(struct hawser__hill *hill, struct hawser__hill_worker *worker, const double at[2])
{
	const struct hawser_rom *rom;
	double omega;

	if (worker->status)
		return 0;
	if (!worker->linear)
		return !hawser__hill_multipliers(hill, worker, at, 0) ? beyond(worker, ALONE)
		       : worker->status ? 0 : -1;
	worker->status = hill->field->model(hill->field->context, &rom, &omega, worker->number, at[0],
	                                    at[1], &worker->report);
	if (worker->status == HAWSER_ERR_CONVERGENCE && hill->field->responds) {
		worker->status = HAWSER_OK; /* no response there */
		return -1;
	}
	if (!worker->status)
		worker->status = hawser_linear_multipliers(worker->linear, worker->log_modulus,
		                                           worker->argument, NULL, rom, omega,
		                                           &worker->report);
	return worker->status ? 0 : hawser__linear_circle(worker->linear).unstable;
}

static void count_one(void *context, long i, int number)
{
	struct counting *counting = context;
	struct hawser__hill_worker *worker = &counting->hill->worker[number];
	const double at[2] = {counting->x[i], counting->y[i]};

	if (!rough(&counting->unstable[i], counting->hill, worker, at))
		counting->unstable[i] = strict(counting->hill, worker, at);
}

enum hawser_status hawser_hill_count(struct hawser_hill_counter *counter, int *unstable,
                                     const double *x, const double *y, int count,
                                     struct hawser_report *report)
{
	struct hawser__hill *hill = &counter->hill;
	struct counting counting = {hill, unstable, x, y};
	enum hawser_status status = HAWSER_OK;

	if (hill->field->prepare)
		status = hill->field->prepare(hill->field->context, x, y, count, hill->threads, report);
	if (status)
		return status;
	for (int t = 0; t < hill->threads; t++)
		hill->worker[t].status = HAWSER_OK;
	hawser__share(count, hill->threads, count_one, &counting);
	for (int t = 0; t < hill->threads && !status; t++)
		if ((status = hill->worker[t].status) && report)
			*report = hill->worker[t].report;
	return status;
}
