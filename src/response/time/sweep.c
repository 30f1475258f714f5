/* response/time/sweep.c - time integration until the motion is periodic, at a series of frequencies,
 * each started from the final state of the previous one. It shows what a shaker test would show,
 * including jumps and hysteresis. The flow is that of the continuation (flow.h), so that both use
 * the same model; nothing is corrected.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/frf.h>

#include "core/progress.h"
#include "core/grow.h"
#include "core/report.h"
#include "core/settle.h"
#include "response/branch/amplitude.h"
#include "response/time/flow.h"

#define STEP_ANGLE 0.8      /* initial step, rad of the fastest mode; chosen, refined by the error */
#define MESH_ERROR 1e-8     /* estimated error per period, relative to the state; chosen */
#define MAX_STEPS 20000     /* largest number of steps per period; chosen */
#define WATCH 20            /* periods over which a response that does not settle is observed;
                             * chosen */

struct sweep {
	const struct hawser_rom *rom;
	struct hawser__flow flow;
	struct hawser__amplitude *amplitude;
	int steps, capacity;
	double *x, *before, *samples, *watched;
	double omega;
	double began; /* s, hawser__wall_seconds */
};

static double norm(const double *x, int m)
{
	double sum = 0.0;

	for (int i = 0; i < m; i++)
		sum += x[i]*x[i];
	return sqrt(sum);
}

static int make_room(struct sweep *sweep)
{
	if (sweep->steps <= sweep->capacity)
		return 0;
	if (hawser__resize(&sweep->samples, (size_t)sweep->steps*(size_t)sweep->rom->n, sizeof(double)))
		return 1;
	sweep->capacity = sweep->steps;
	return 0;
}

static enum hawser_status too_fine(const struct sweep *sweep, double size, double error,
                                   struct hawser_report *report)
{
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "sweep", sweep->steps, error,
	                       isfinite(size) ? "the sweep at Omega %.9g%s needs more than %d "
	                                        "integration steps a period"
	                                      : "the motion at Omega %.9g%s grows without "
	                                        "bound, even with %d steps a period",
	                       HAWSER_SHOWN(sweep->rom, sweep->omega), sweep->steps);
}

/* One period from sweep->x, on a mesh that is fine enough for it; *change becomes |x after - x
 * before|, relative. */
static enum hawser_status one_period(struct sweep *sweep, double *change,
                                     struct hawser_report *report)
{
	int m = 2*sweep->rom->n;

	memcpy(sweep->before, sweep->x, (size_t)m*sizeof(double));
	for (;;) {
		struct hawser__stretch stretch = {.h = 2.0*M_PI/sweep->steps, .steps = sweep->steps,
			.count = 1};
		double error, size, far = 0.0;

		if (make_room(sweep))
			return hawser__no_memory(report, "sweep");
		error = hawser__flow_map(&sweep->flow, sweep->x, sweep->samples, &stretch,
		                         sweep->omega);
		size = norm(sweep->x, m);
		for (int i = 0; i < m; i++)
			far += pow(sweep->x[i] - sweep->before[i], 2);
		*change = sqrt(far)/fmax(size, 1e-300);
		if (error <= MESH_ERROR*size)
			return HAWSER_OK;
		if (2*sweep->steps > MAX_STEPS)
			return too_fine(sweep, size, error, report);
		sweep->steps *= 2;
		memcpy(sweep->x, sweep->before, (size_t)m*sizeof(double));
	}
}

static void keep_larger(double *into, const double *from, int count)
{
	for (int i = 0; i < count; i++)
		into[i] = fmax(into[i], from[i]);
}

/* Amplitudes of the last period, or over WATCH periods if the motion is not periodic. */
static enum hawser_status measure(struct hawser_sweep *result, struct sweep *sweep, int settled,
                                  struct hawser_report *report)
{
	int n = result->n, probes = 3*result->probes, p = result->points;
	double *coordinate = result->coordinate + (size_t)p*n;
	double *probe = result->probe + (size_t)p*probes, change;
	enum hawser_status status;

	memset(coordinate, 0, (size_t)n*sizeof *coordinate);
	memset(probe, 0, (size_t)probes*sizeof *probe);
	for (int i = 0; i < (settled ? 1 : WATCH); i++) {
		if (i > 0 && (status = one_period(sweep, &change, report)))
			return status;
		if (hawser__amplitude_find(sweep->amplitude, sweep->watched, sweep->watched + n,
		                           sweep->samples, sweep->steps, sweep->omega))
			return hawser__no_memory(report, "sweep");
		keep_larger(coordinate, sweep->watched, n);
		keep_larger(probe, sweep->watched + n, probes);
	}
	return HAWSER_OK;
}

static double fastest(const struct hawser_rom *rom)
{
	double top = 1e-300;

	for (int j = 0; j < rom->n; j++)
		top = fmax(top, rom->K[j*rom->n + j]);
	return sqrt(top);
}

static enum hawser_status visit(struct hawser_sweep *result, struct sweep *sweep,
                                const struct hawser_sweep_options *options,
                                struct hawser_report *report)
{
	double change = INFINITY;
	enum hawser_status status;
	int period;

	sweep->steps = (int)fmin(MAX_STEPS, fmax(16.0, ceil(2.0*M_PI*fastest(sweep->rom)/
	                                                    sweep->omega/STEP_ANGLE)));
	for (period = 0; period < options->max_periods && change > options->settle; period++)
		if ((status = one_period(sweep, &change, report)))
			return status;
	if ((status = measure(result, sweep, change <= options->settle, report)))
		return status;
	result->omega[result->points] = sweep->omega*hawser__rom_periods(sweep->rom);
	result->residual[result->points++] = change;
	return HAWSER_OK;
}

static enum hawser_status check(const struct hawser_sweep_options *options,
                                struct hawser_report *report)
{
	if (!(options->from > 0.0) || !(options->to > 0.0) || options->count < 2 ||
	    !(options->settle > 0.0) || options->max_periods < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
		                    "sweep from %g to %g with %d frequencies, settle %g, at most %d "
		                    "periods: frequencies and settle must be positive, with 2 "
		                    "frequencies and 1 period or more", options->from, options->to,
		                    options->count, options->settle, options->max_periods);
	return HAWSER_OK;
}

static enum hawser_status allocate(struct hawser_sweep *result, struct sweep *sweep, int count,
                                   struct hawser_report *report)
{
	size_t rows = (size_t)count, n = (size_t)result->n, probes = 3*(size_t)result->probes;

	result->omega = calloc(rows, sizeof(double));
	result->residual = calloc(rows, sizeof(double));
	result->coordinate = calloc(rows*n, sizeof(double));
	result->probe = calloc(rows*probes + 1, sizeof(double));
	sweep->x = calloc(2*n, sizeof(double));
	sweep->before = calloc(2*n, sizeof(double));
	sweep->watched = calloc(n + probes, sizeof(double));
	sweep->amplitude = hawser__amplitude_new(sweep->rom);
	if (!result->omega || !result->residual || !result->coordinate || !result->probe ||
	    !sweep->x || !sweep->before || !sweep->watched || !sweep->amplitude)
		return hawser__no_memory(report, "sweep");
	return hawser__flow_init(&sweep->flow, sweep->rom, report);
}

void hawser_sweep_settle(struct hawser_sweep_options *options)
{
	hawser__settle(&options->settle, 1e-6);
	hawser__settle_count(&options->max_periods, 2000);
}

/* Called before frequency `i`. */
static int told_to_stop(const struct sweep *sweep, const struct hawser_sweep_options *options, int i)
{
	struct hawser_progress_state state;

	if (!hawser__is_watched(&options->progress))
		return 0;
	state = hawser__progress_state("sweep", "frequencies", i, sweep->began);
	state.expected = options->count;
	if (i > 0)
		state.omega = sweep->omega*hawser__rom_periods(sweep->rom)/sweep->rom->time;
	return hawser__told_to_stop(&options->progress, &state);
}

enum hawser_status hawser_sweep_run(struct hawser_sweep *result, const struct hawser_rom *rom,
                                    const struct hawser_sweep_options *options,
                                    struct hawser_report *report)
{
	struct hawser_sweep_options settled = *options;
	struct sweep sweep = {.rom = rom, .began = hawser__wall_seconds()};
	int periods = hawser__rom_periods(rom);
	enum hawser_status status;

	*result = (struct hawser_sweep){.n = rom->n, .probes = rom->shapes.points};
	hawser_sweep_settle(&settled);
	options = &settled;
	if ((status = check(options, report)))
		return status;
	if ((status = allocate(result, &sweep, options->count, report)))
		goto done;
	for (int i = 0; i < options->count; i++) {
		double s = (double)i/(options->count - 1);

		if (told_to_stop(&sweep, options, i)) {
			result->interrupted = 1;
			break;
		}
		sweep.omega = ((1.0 - s)*options->from + s*options->to)/periods;
		if ((status = visit(result, &sweep, options, report)))
			break;
	}
done:
	hawser__flow_clear(&sweep.flow);
	hawser__amplitude_free(sweep.amplitude);
	free(sweep.x);
	free(sweep.before);
	free(sweep.samples);
	free(sweep.watched);
	return status;
}

void hawser_sweep_clear(struct hawser_sweep *sweep)
{
	if (!sweep)
		return;
	free(sweep->omega);
	free(sweep->coordinate);
	free(sweep->probe);
	free(sweep->residual);
	memset(sweep, 0, sizeof *sweep);
}
