/* study/identify/identify.c - see hawser/identify.h.
 *
 *    x      variables of the free parameters, 0 at the start (identify_modes.c)
 *    r      weighted residuals; J their derivatives by x
 *
 * Where modes must be matched, a fit begins with each assignment that a scale of the computed
 * frequencies between 1/2 and 2 gives, since a start that is 30 % off would assign the third mode to
 * the second measurement; after a fit modes are assigned again until nothing changes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "study/identify/identify.h"

#define LEAST_STEP 1e-9 /* of x; its derivatives have 8 digits, intervals are never that small */

enum { STEPS = 60, AGAIN = 5, MORE_MODES = 4, MOST_MODES = 100 };
enum { SCALES = 14, ATTEMPTS = 2*(2*SCALES + 1) }; /* scales of an octave, and all in both ranges */
static const char where[] = "identify";

void hawser_identify_settle(struct hawser_identify_options *options)
{
	if (options->confidence == 0.0)
		options->confidence = 0.95;
}

static enum hawser_status check(const struct hawser_measured *measured, int count,
                                const struct hawser_identify_options *options,
                                struct hawser_report *report)
{
	int known = 0;

	if (options->keys < 1 || options->keys > HAWSER_IDENTIFY_KEYS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%d free parameters: give 1 to %d", options->keys,
		                    HAWSER_IDENTIFY_KEYS);
	if (!(options->confidence > 0.0 && options->confidence < 1.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "a confidence of %g: give one between 0 and 1", options->confidence);
	if (count < options->keys)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%d measured frequencies for %d free parameters: give more of them, or "
		                    "free fewer", count, options->keys);
	for (int i = 0; i < count; i++) {
		if (!(measured[i].omega > 0.0) || !isfinite(measured[i].omega) ||
		    !(measured[i].deviation >= 0.0) || !isfinite(measured[i].deviation))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "measurement %d: a frequency must be positive, and its deviation "
			                    "must not be negative", i + 1);
		if (measured[i].number > 0 && measured[i].plane < 0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "measurement %d has a number in its plane, but no plane", i + 1);
		known += measured[i].deviation > 0.0;
	}
	if (known != 0 && known != count)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%d of %d measurements have a deviation: give it for all or for none",
		                    known, count);
	return HAWSER_OK;
}

/* Whether the range of the key is of positive numbers. */
static int positive(const char *path)
{
	for (int k = 0; hawser_scene_key(k); k++)
		if (strcmp(hawser_scene_key(k)->path, path) == 0)
			return strncmp(hawser_scene_key(k)->range, "> 0", 3) == 0;
	return 0;
}

static int larger(int a, int b)
{
	return a > b ? a : b;
}

static enum hawser_status begin(struct hawser__fit *fit, struct hawser_report *report)
{
	int free = 0;

	for (int k = 0; k < fit->keys; k++) {
		enum hawser_status status = hawser_scene_get(fit->scene, &fit->start[k], fit->key[k],
		                                             report);

		if (status)
			return status;
		if (fit->start[k] == 0.0 || !isfinite(fit->start[k]))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "%.60s is %g in the scene: give a finite start other than 0",
			                    fit->key[k], fit->start[k]);
		for (int before = 0; before < k; before++)
			if (strcmp(fit->key[k], fit->key[before]) == 0)
				return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
				                    "%.60s is free twice", fit->key[k]);
		/* a start of cable.EI is positive, and steps by its logarithm keep it so */
		fit->logarithmic[k] = positive(fit->key[k]) || strcmp(fit->key[k], "cable.EI") == 0;
	}
	fit->weight = malloc((size_t)fit->count*sizeof *fit->weight);
	fit->mate = calloc((size_t)fit->count, sizeof *fit->mate);
	if (!fit->weight || !fit->mate)
		return hawser__no_memory(report, where);
	for (int i = 0; i < fit->count; i++) {
		const struct hawser_measured *measured = &fit->measured[i];

		fit->weight[i] = measured->deviation > 0.0 ? measured->omega/measured->deviation
		                                           : 1.0/HAWSER_IDENTIFY_NOMINAL;
		fit->modes = larger(fit->modes, larger(measured->place, 2*measured->number));
		free += !hawser__fit_given(measured);
	}
	/* with those of the other plane, and some more: the order changes with the parameters */
	fit->modes = larger(fit->modes + fit->modes/2, free > 0 ? 2*fit->count : 0) + MORE_MODES;
	if (fit->modes > MOST_MODES)
		fit->modes = MOST_MODES;
	return HAWSER_OK;
}

/* --- one fit --- */

static enum hawser_status residuals(void *of, double *r, double *J, const double *x)
{
	struct hawser__fit *fit = of;

	return r ? hawser__fit_residuals(r, fit, x, &fit->report)
	         : hawser__fit_jacobian(J, fit, x, &fit->report);
}

/* Improve x [keys] with the modes as they are assigned; *chi2: the sum of squares. */
static enum hawser_status solve(double *x, double *chi2, struct hawser__fit *fit,
                                struct hawser_report *report)
{
	struct hawser__least_squares problem = {fit->keys, fit->count, residuals, fit, LEAST_STEP, STEPS};
	int steps;
	enum hawser_status status = hawser__least_squares(x, chi2, &steps, &problem);

	if (status == HAWSER_ERR_MEMORY)
		return hawser__no_memory(report, where);
	if (status && report)
		*report = fit->report;
	if (!status && steps == STEPS)
		status = hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, where, steps,
		                         sqrt(*chi2/fit->count),
		                         "the fit did not converge in %d steps: give other starting values, "
		                         "or free fewer parameters", steps);
	return status;
}

/* --- assignments --- */

static int all_given(const struct hawser__fit *fit)
{
	for (int i = 0; i < fit->count; i++)
		if (!hawser__fit_given(&fit->measured[i]))
			return 0;
	return 1;
}

static int same(const struct hawser__mate *a, const struct hawser__mate *b, int count)
{
	return memcmp(a, b, (size_t)count*sizeof *a) == 0;
}

/* Assign modes at x; *changed: other ones than before. More modes are computed if too few are above the
 * highest measurement. */
static enum hawser_status assign(struct hawser__fit *fit, int *skipped, int *changed,
                                 const double *x, double scale, struct hawser_report *report)
{
	struct hawser__mate *mate = calloc((size_t)fit->count, sizeof *mate);
	struct hawser_modes modes = {0};
	enum hawser_status status = mate ? hawser__fit_modes(&modes, fit, x, report)
	                                 : hawser__no_memory(report, where);

	if (!status)
		status = hawser__fit_match(mate, skipped, fit, &modes, scale, report);
	if (!status) {
		*changed = !same(mate, fit->mate, fit->count);
		memcpy(fit->mate, mate, (size_t)fit->count*sizeof *mate);
	}
	hawser_modes_clear(&modes);
	free(mate);
	return status;
}

/* Fit with the modes assigned now, assign again, until nothing changes. */
static enum hawser_status settle(struct hawser__identify_end *outcome, struct hawser__fit *fit,
                                 struct hawser_report *report)
{
	int changed = 1;
	enum hawser_status status = HAWSER_OK;

	memset(outcome->x, 0, sizeof outcome->x);
	for (int round = 0; round < AGAIN && changed && !status; round++) {
		status = solve(outcome->x, &outcome->chi2, fit, report);
		if (!status)
			status = assign(fit, &outcome->skipped, &changed, outcome->x, 1.0, report);
	}
	if (!status && changed)
		status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, where,
		                      "the assignment of modes changes with each fit: give the numbers of "
		                      "the modes");
	outcome->cost = outcome->chi2 + HAWSER_IDENTIFY_SKIP*outcome->skipped;
	return status;
}

/* Assignments with which a fit began or ended. */
struct tried {
	struct hawser__mate *mate; /* [ATTEMPTS][count] */
	int count;
};

static int known(const struct tried *tried, const struct hawser__fit *fit)
{
	for (int t = 0; t < tried->count; t++)
		if (same(tried->mate + (size_t)t*(size_t)fit->count, fit->mate, fit->count))
			return 1;
	return 0;
}

static void remember(struct tried *tried, const struct hawser__fit *fit)
{
	memcpy(tried->mate + (size_t)tried->count++*(size_t)fit->count, fit->mate,
	       (size_t)fit->count*sizeof *fit->mate);
}

/* The fit that begins with the assignment at this scale, if it is a new one and ends with a new one. */
static enum hawser_status attempt(struct hawser__identify_end *outcome, int *is_new,
                                  struct tried tried[2], struct hawser__fit *fit, double scale,
                                  struct hawser_report *report)
{
	static const double none[HAWSER_IDENTIFY_KEYS];
	int unused;
	enum hawser_status status = assign(fit, &outcome->skipped, &unused, none, scale, report);

	*is_new = 0;
	if (status || known(&tried[0], fit) || known(&tried[1], fit))
		return status;
	remember(&tried[0], fit);
	status = settle(outcome, fit, report);
	if (!status && !known(&tried[1], fit)) {
		remember(&tried[1], fit);
		*is_new = 1;
	}
	return status;
}

/* *octaves: log2 of the lowest measured frequency over the lowest computed one at the start. */
static enum hawser_status offset(double *octaves, struct hawser__fit *fit,
                                 struct hawser_report *report)
{
	static const double none[HAWSER_IDENTIFY_KEYS];
	double lowest = INFINITY;
	struct hawser_modes modes;
	enum hawser_status status = hawser__fit_modes(&modes, fit, none, report);

	for (int i = 0; i < fit->count; i++)
		lowest = fmin(lowest, fit->measured[i].omega);
	if (!status)
		*octaves = log2(lowest*modes.time_unit/modes.mode[0].omega);
	hawser_modes_clear(&modes);
	return status;
}

/* The best fit over all scales; its modes are then assigned. *margin: see the header. */
static enum hawser_status search(struct hawser__identify_end *best, double *margin,
                                 struct hawser__fit *fit, struct hawser_report *report)
{
	size_t size = (size_t)fit->count*sizeof *fit->mate;
	struct tried tried[2] = {{calloc(ATTEMPTS, size), 0}, {calloc(ATTEMPTS, size), 0}};
	struct hawser__mate *kept = calloc(1, size);
	struct hawser_report last = {0};
	enum hawser_status status = tried[0].mate && tried[1].mate && kept
	                            ? HAWSER_OK : hawser__no_memory(&last, where);
	double second = INFINITY, octaves = 0.0;
	int attempts = 2*SCALES + 1;

	best->cost = INFINITY;
	if (!status)
		status = offset(&octaves, fit, &last);
	if (fabs(octaves) > 1.0) /* a start that is far off: the same about the lowest frequency */
		attempts = ATTEMPTS;
	for (int a = 0; a < attempts && status != HAWSER_ERR_MEMORY; a++) {
		double scale = exp2((double)(a%(2*SCALES + 1) - SCALES)/SCALES +
		                    (a > 2*SCALES ? octaves : 0.0));
		struct hawser__identify_end outcome = {.chi2 = 0.0};
		int is_new;

		status = attempt(&outcome, &is_new, tried, fit, scale, &last);
		if (!is_new)
			continue;
		second = fmin(second, fmax(outcome.cost, best->cost));
		if (outcome.cost < best->cost) {
			*best = outcome;
			memcpy(kept, fit->mate, size);
		}
	}
	*margin = second - best->cost;
	if (status != HAWSER_ERR_MEMORY && isfinite(best->cost)) {
		memcpy(fit->mate, kept, size);
		status = HAWSER_OK;
	} else if (report) {
		*report = last;
	}
	free(tried[0].mate);
	free(tried[1].mate);
	free(kept);
	return status;
}

enum hawser_status hawser_identify(struct hawser_identified *identified,
                                   const struct hawser_scene *scene,
                                   const struct hawser_measured *measured, int count,
                                   const struct hawser_identify_options *options,
                                   struct hawser_report *report)
{
	struct hawser_identify_options chosen = *options;
	struct hawser__fit fit = {.scene = scene, .measured = measured, .count = count,
	                          .key = options->key, .keys = options->keys};
	struct hawser__identify_end best = {.chi2 = 0.0};
	static const double none[HAWSER_IDENTIFY_KEYS];
	enum hawser_status status;
	int unused;

	*identified = (struct hawser_identified){.margin = INFINITY};
	hawser_identify_settle(&chosen);
	status = check(measured, count, &chosen, report);
	if (!status)
		status = begin(&fit, report);
	/* also states what is wrong with the scene, or with the numbers given */
	if (!status)
		status = assign(&fit, &best.skipped, &unused, none, 1.0, report);
	if (!status)
		status = all_given(&fit) ? settle(&best, &fit, report)
		                         : search(&best, &identified->margin, &fit, report);
	if (!status)
		status = hawser__fit_finish(identified, &fit, &best, chosen.confidence, report);
	free(fit.weight);
	free(fit.mate);
	if (status)
		hawser_identified_clear(identified);
	return status;
}

void hawser_identified_clear(struct hawser_identified *identified)
{
	if (!identified)
		return;
	free(identified->mode);
	*identified = (struct hawser_identified){0};
}
