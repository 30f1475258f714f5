/* ropeway/modes/track.c - frequencies of a ropeway along a sweep: the samples, and the result.
 *
 * A step in which branches cannot be told apart is halved, up to HALVINGS times: shapes change fast
 * where a carrier passes a tower, and where two branches veer.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/grow.h"
#include "core/progress.h"
#include "core/report.h"
#include "core/settle.h"
#include "core/share.h"
#include "ropeway/modes/track.h"

/* Modes by default; more than the branches, since these go up and down along a sweep; halvings of a
 * step; samples in all. */
enum { DEFAULT = 6, MORE = 6, HALVINGS = 6, MOST = 20000 };
enum { BATCH = 8 }; /* values solved at once by several threads: little is lost where a sweep ends */
#define NEAR 0.05 /* relative gap below which a least one is a veering */

/* Add a sample to the sweep; it is used up. */
static enum hawser_status append(struct hawser__track *t, struct hawser__track_sample *sample,
                                 struct hawser_report *report)
{
	if (hawser__more(&t->sample, t->samples, sizeof *t->sample)) {
		hawser__track_sample_clear(sample);
		return hawser__no_memory(report, "track");
	}
	t->sample[t->samples++] = *sample;
	if (t->samples > 1) { /* shapes are compared with those of the last sample only */
		free(t->sample[t->samples - 2].shape);
		t->sample[t->samples - 2].shape = NULL;
	}
	*sample = (struct hawser__track_sample){.n = 0};
	return HAWSER_OK;
}

/* Continue the branches from the last sample to b, which is used up; halve the step where needed. */
static enum hawser_status step(struct hawser__track *t, struct hawser__track_sample *b, int halvings,
                               struct hawser_report *report)
{
	struct hawser__track_sample middle;
	int split;
	enum hawser_status status = hawser__track_match(&split, t, &t->sample[t->samples - 1], b,
	                                                halvings == 0 || t->samples >= MOST, report);

	if (!status && !split)
		return append(t, b, report);
	if (!status)
		status = hawser__track_sample(
			&middle, t, 0.5*(t->sample[t->samples - 1].at.value + b->at.value), report);
	if (!status) {
		middle.at.inserted = 1;
		status = step(t, &middle, halvings - 1, report);
	}
	if (!status)
		return step(t, b, halvings - 1, report);
	hawser__track_sample_clear(b);
	return status;
}

/* The lowest modes of the first sample are the branches. */
static void begin(struct hawser__track_sample *first, int n)
{
	for (int k = 0; k < first->n && k < n; k++)
		first->branch[k] = k;
}

static int mode_of(const struct hawser__track_sample *a, int branch)
{
	for (int k = 0; k < a->n; k++)
		if (a->branch[k] == branch)
			return k;
	return -1;
}

/* The relative gap of two branches at a sample, NAN if one is lost. */
static double gap_at(const struct hawser__track_sample *a, int p, int q)
{
	int i = mode_of(a, p), j = mode_of(a, q);

	return i < 0 || j < 0 || !hawser__track_coupled(a, i, j)
		? NAN : 2.0*fabs(a->omega[j] - a->omega[i])/(a->omega[j] + a->omega[i]);
}

/* 1 if a crossover of the branches p and q between the samples beside i is known. */
static int known_at(const struct hawser__track *t, int p, int q, int i)
{
	for (int c = 0; c < t->crossovers; c++) {
		const struct hawser_ropeway_track_crossover *at = &t->crossover[c];

		if ((at->below == p || at->above == p) && (at->below == q || at->above == q) &&
		    (at->value - t->sample[i - 1].at.value)*(at->value - t->sample[i + 1].at.value) <= 0.0)
			return 1;
	}
	return 0;
}

/* A veering of the modes k (below) and l at sample i, which are next to each other around it. */
static enum hawser_status veering(struct hawser__track *t, int i, int k, int l,
                                  struct hawser_report *report)
{
	const struct hawser__track_sample *a = t->sample + i;
	int place = hawser__track_place(a, k);
	struct hawser_ropeway_track_crossover at;
	enum hawser_status status;

	if (hawser__track_place(a, l) != place + 1)
		return HAWSER_OK;
	status = hawser__track_closest(&at, t, a - 1, a + 1, a->plane[k], place, report);
	at.below = a->branch[k];
	at.above = a->branch[l];
	return status ? status : hawser__track_crossover(t, &at, report);
}

/* Veerings that several samples resolve: least gaps of two branches of common spans. Those at which
 * the order changed are known. */
static enum hawser_status wide(struct hawser__track *t, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int p = 0; p < t->n && !status; p++)
		for (int q = p + 1; q < t->n && !status; q++)
			for (int i = 1; i + 1 < t->samples && !status; i++) {
				const struct hawser__track_sample *a = t->sample + i;
				double before = gap_at(a - 1, p, q), after = gap_at(a + 1, p, q);
				double here = gap_at(a, p, q);
				int k = mode_of(a, p), l = mode_of(a, q);

				if (a[-1].at.touched != a[1].at.touched)
					continue;
				if (here < before && here <= after && here < NEAR && !known_at(t, p, q, i))
					status = veering(t, i, k < l ? k : l, k < l ? l : k, report);
			}
	return status;
}

/* --- the result --- */

static void fill_point(struct hawser_ropeway_track_point *to, const struct hawser__track_sample *a,
                       int branch)
{
	int k = mode_of(a, branch);

	*to = (struct hawser_ropeway_track_point){NAN, NAN, NAN, -1};
	if (k < 0)
		return;
	*to = (struct hawser_ropeway_track_point){a->omega[k], a->residual[k], 0.0, 0};
	for (int i = 0; i < a->spans; i++)
		if (a->share[k*a->spans + i] > to->share) {
			to->share = a->share[k*a->spans + i];
			to->span = i;
		}
}

static enum hawser_status finish(struct hawser_ropeway_track *track, struct hawser__track *t,
                                 struct hawser_report *report)
{
	size_t samples = (size_t)t->samples, n;

	track->samples = t->samples;
	track->branches = t->n < t->sample[0].n ? t->n : t->sample[0].n;
	track->solves = t->solves;
	track->least_correlation = t->least;
	n = (size_t)track->branches;
	track->sample = calloc(samples, sizeof *track->sample);
	track->point = calloc(samples*n, sizeof *track->point);
	track->plane = calloc(n, sizeof *track->plane);
	if (!track->sample || !track->point || !track->plane)
		return hawser__no_memory(report, "track");
	for (int i = 0; i < t->samples; i++) {
		track->sample[i] = t->sample[i].at;
		for (int b = 0; b < track->branches; b++)
			fill_point(&track->point[i*track->branches + b], &t->sample[i], b);
	}
	for (int b = 0; b < track->branches; b++)
		track->plane[b] = t->sample[0].plane[b];
	track->crossover = t->crossover;
	track->crossovers = t->crossovers;
	t->crossover = NULL;
	return HAWSER_OK;
}

static int by_value(const void *a, const void *b)
{
	double x = ((const struct hawser_ropeway_track_crossover *)a)->value,
		y = ((const struct hawser_ropeway_track_crossover *)b)->value;

	return (x > y) - (x < y);
}

/* Samples at the next values: the scenes are opened one after the other, and solved by several
 * threads. */
struct batch {
	const struct hawser__track *t;
	struct hawser__track_scene scene[BATCH];
	struct hawser__track_sample sample[BATCH];
	struct hawser_report why[BATCH];
	enum hawser_status status[BATCH];
	int first, count;
};

static void solve_one(void *context, long item, int worker)
{
	struct batch *batch = context;

	(void)worker;
	if (!batch->status[item])
		batch->status[item] = hawser__track_solve(&batch->sample[item], batch->t, &batch->scene[item],
		                                          &batch->why[item]);
}

static void solve_batch(struct batch *batch, struct hawser__track *t, int first, int threads)
{
	int left = t->options->points - first, most = threads > 1 ? BATCH : 1;

	batch->t = t;
	batch->first = first;
	batch->count = left < most ? left : most;
	for (int k = 0; k < batch->count; k++) {
		batch->sample[k] = (struct hawser__track_sample){.n = 0};
		batch->status[k] = hawser__track_open(&batch->scene[k], t, t->options->value[first + k],
		                                      &batch->why[k]);
		t->solves += !batch->status[k];
	}
	hawser__share(batch->count, threads, solve_one, batch);
	for (int k = 0; k < batch->count; k++)
		hawser__track_scene_clear(&batch->scene[k]);
}

/* The caller's answer after `done` values: nonzero ends the sweep. */
static int told_to_stop(const struct hawser__track *t, int done, double began)
{
	struct hawser_progress_state state = hawser__progress_state("sweep", "values", done, began);

	state.expected = t->options->points;
	return hawser__told_to_stop(&t->options->progress, &state);
}

/* Continue the branches to the sample of value i, which is used up. */
static enum hawser_status advance(struct hawser_ropeway_track *track, struct hawser__track *t, int i,
                                  struct batch *batch, struct hawser_report *report)
{
	int k = i - batch->first;
	enum hawser_status status = batch->status[k];

	if (!status)
		status = step(t, &batch->sample[k], HALVINGS, &batch->why[k]);
	batch->sample[k] = (struct hawser__track_sample){.n = 0};
	if (status == HAWSER_ERR_MEMORY)
		return hawser__no_memory(report, "track");
	if (status) {
		track->ended = 1;
		track->end = t->options->value[i];
		track->why = batch->why[k];
	}
	return HAWSER_OK;
}

static enum hawser_status sweep(struct hawser_ropeway_track *track, struct hawser__track *t,
                                struct hawser_report *report)
{
	const struct hawser_ropeway_track_options *o = t->options;
	int threads = o->threads > 0 ? o->threads : hawser__processors();
	double began = hawser__wall_seconds();
	struct hawser__track_sample first;
	struct batch *batch = calloc(1, sizeof *batch);
	enum hawser_status status = batch ? hawser__track_sample(&first, t, o->value[0], report)
	                                  : hawser__no_memory(report, "track");

	if (!status) {
		begin(&first, t->n);
		status = append(t, &first, report);
	}
	for (int i = 1; i < o->points && !status && !track->ended && !track->interrupted; i++) {
		if (i >= batch->first + batch->count)
			solve_batch(batch, t, i, threads);
		status = advance(track, t, i, batch, report);
		track->interrupted = told_to_stop(t, i + 1, began);
	}
	for (int k = 0; batch && k < batch->count; k++)
		hawser__track_sample_clear(&batch->sample[k]);
	free(batch);
	return status;
}

enum hawser_status hawser_ropeway_track_solve(struct hawser_ropeway_track *track,
                                              const struct hawser_ropeway_track_options *options,
                                              struct hawser_report *report)
{
	struct hawser__track t = {.options = options, .n = options->n, .least = 1.0};
	struct hawser_report own = {.message = ""};
	enum hawser_status status;

	*track = (struct hawser_ropeway_track){.samples = 0};
	report = report ? report : &own;
	hawser__settle_count(&t.n, DEFAULT);
	if (!options->open == !options->open_obstacles)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "track", "options.open or "
		                    "options.open_obstacles must be given, and one of them only");
	if (options->points < 2 || t.n < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "track", "%d values and %d branches: give 2 "
		                    "values or more, and one branch or more", options->points, t.n);
	t.ask = t.n + MORE + t.n/4;
	status = sweep(track, &t, report);
	if (!status)
		status = wide(&t, report);
	if (!status)
		status = finish(track, &t, report);
	if (!status && track->crossovers > 0)
		qsort(track->crossover, (size_t)track->crossovers, sizeof *track->crossover, by_value);
	for (int i = 0; i < t.samples; i++)
		hawser__track_sample_clear(&t.sample[i]);
	free(t.sample);
	free(t.crossover);
	if (status)
		hawser_ropeway_track_clear(track);
	return status;
}

void hawser_ropeway_track_clear(struct hawser_ropeway_track *track)
{
	if (!track)
		return;
	free(track->sample);
	free(track->point);
	free(track->plane);
	free(track->crossover);
	*track = (struct hawser_ropeway_track){.samples = 0};
}
