/* ropeway/modes/modes.c - the lowest modes of all systems of a rope over sheaves together: real
 * ones at rest, complex ones where it runs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/names.h"
#include "core/report.h"
#include "core/settle.h"
#include "ropeway/modes/modes.h"

enum { DEFAULT = 6, MODES_MOST = 500, GUARD = 2, ROUNDS = 30 };
/* Modes at rest that are the start of those of a running rope beyond those asked for; tries with more
 * of them; largest number of nodes more in an element than at first. */
enum { MORE = 4, TRIES = 6, EXTRA_MOST = 60 };
static const double default_tolerance = 1e-9;
/* Modes up to this multiple of the highest one asked for are refined: two may change their order. */
static const double margin = 1.05;

HAWSER__NAMES(hawser_line_contact_name, enum hawser_line_contact_kind, "slip", "stick", "roll")

/* --- how many modes of each system --- */

/* count[systems] such that the estimates of all systems below one frequency are some n. */
static void share_out(int *count, const struct hawser__lmode_search *t)
{
	const struct hawser__lmode *rope = t->rope;
	double low = 0.0, high = 1.0;
	int sum = 0;

	for (int i = 0; i < 200 && sum < t->n; i++, high *= 2.0) {
		sum = 0;
		for (int k = 0; k < rope->systems; k++)
			sum += hawser__lmode_count(&rope->system[k], rope, high);
	}
	for (int i = 0; i < 60; i++) {
		double middle = 0.5*(low + high);

		sum = 0;
		for (int k = 0; k < rope->systems; k++)
			sum += hawser__lmode_count(&rope->system[k], rope, middle);
		if (sum >= t->n)
			high = middle;
		else
			low = middle;
	}
	for (int k = 0; k < rope->systems; k++) {
		count[k] = hawser__lmode_count(&rope->system[k], rope, high) + GUARD;
		count[k] = count[k] < t->n ? count[k] : t->n;
	}
}

/* The n lowest of all pairs; returns how many there are, at most n. */
static int choose(struct hawser__lmode_search *t)
{
	const struct hawser__lmode *rope = t->rope;
	int k = 0;

	for (double last = -1.0; k < t->n; k++) {
		struct hawser__lmode_choice best = {-1, -1};
		double least = HUGE_VAL;

		for (int i = 0; i < rope->systems; i++)
			for (int j = 0; j < t->pairs[i].n; j++) {
				int taken = 0;

				if (t->pairs[i].omega[j] < last || t->pairs[i].omega[j] >= least)
					continue;
				for (int q = 0; q < k; q++)
					taken |= t->choice[q].system == i && t->choice[q].pair == j;
				if (!taken) {
					least = t->pairs[i].omega[j];
					best = (struct hawser__lmode_choice){i, j};
				}
			}
		if (best.system < 0)
			break;
		last = least;
		t->choice[k] = best;
	}
	return k;
}

static double omega_of(const struct hawser__lmode_search *t, int k)
{
	return t->pairs[t->choice[k].system].omega[t->choice[k].pair];
}

enum hawser_status hawser__lmode_find(struct hawser__lmode_search *t, struct hawser_report *report)
{
	struct hawser__lmode *rope = t->rope;
	int *count = calloc((size_t)rope->systems, sizeof *count), more = 1;
	enum hawser_status status = HAWSER_OK;

	if (!count)
		return hawser__no_memory(report, "line modes");
	share_out(count, t);
	for (int round = 0; round < ROUNDS && more && !status; round++) {
		int known;

		more = 0;
		for (int i = 0; i < rope->systems && !status; i++) {
			if (t->pairs[i].n == count[i])
				continue;
			hawser__lmode_pairs_clear(&t->pairs[i]);
			status = hawser__lmode_pairs(&t->pairs[i], &rope->system[i], rope, count[i], report);
		}
		if (status)
			break;
		known = choose(t);
		for (int i = 0; i < rope->systems; i++) {
			int own = count[i];

			if (own == t->n || (known == t->n && t->pairs[i].omega[own - 1] > omega_of(t, t->n - 1)))
				continue;
			count[i] = 2*own < t->n ? 2*own : t->n;
			more = 1;
		}
	}
	free(count);
	if (!status && choose(t) < t->n)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "line modes", "%d modes asked of a rope "
		                      "whose grids have fewer: ask for fewer", t->n);
	return status;
}

enum hawser_status hawser__lmode_refine_all(double *omega, struct hawser__lmode_search *t, double wider,
                                            double least, struct hawser_report *report)
{
	struct hawser__lmode *rope = t->rope;
	enum hawser_status status = HAWSER_OK;
	double most = margin*omega_of(t, t->n - 1);

	*omega = fmax(wider*most, least);
	for (int i = 0; i < rope->systems && !status; i++) {
		struct hawser__lmode_pairs *pairs = &t->pairs[i];

		while (pairs->parts == 1 && pairs->n > 0 && pairs->omega[pairs->n - 1] > most)
			pairs->n--;
		status = pairs->parts > 1
		             ? hawser__lmode_running_refine(pairs, &rope->system[i], rope, *omega, report)
		             : hawser__lmode_refine(pairs, &rope->system[i], rope, *omega, report);
	}
	(void)choose(t);
	return status;
}

double hawser__lmode_worst(const struct hawser__lmode_search *t)
{
	double worst = 0.0;

	for (int k = 0; k < t->n; k++)
		worst = fmax(worst, t->pairs[t->choice[k].system].error[t->choice[k].pair]);
	return worst;
}

static void forget(struct hawser__lmode_search *t)
{
	for (int i = 0; t->pairs && i < t->rope->systems; i++)
		hawser__lmode_pairs_clear(&t->pairs[i]);
}

enum hawser_status hawser__lmode_search_open(struct hawser__lmode_search *t, struct hawser__lmode *rope,
                                             int n, struct hawser_report *report)
{
	*t = (struct hawser__lmode_search){.rope = rope, .n = n};
	t->pairs = calloc((size_t)rope->systems + 1, sizeof *t->pairs);
	t->choice = calloc((size_t)n, sizeof *t->choice);
	return t->pairs && t->choice ? HAWSER_OK : hawser__no_memory(report, "line modes");
}

void hawser__lmode_search_clear(struct hawser__lmode_search *t)
{
	forget(t);
	free(t->pairs);
	free(t->choice);
	*t = (struct hawser__lmode_search){.n = 0};
}

/* Complex modes on the first grids, such that the n lowest are among them: all those of a system but
 * the last two have converged. `resting`: modes at rest, at first some more. */
static enum hawser_status find_running(struct hawser__lmode_search *t,
                                       struct hawser__lmode_search *resting,
                                       struct hawser_report *report)
{
	struct hawser__lmode *rope = t->rope;

	for (int tries = 1;; tries++) {
		enum hawser_status status = hawser__lmode_find(resting, report);
		int enough, n = resting->n;

		for (int i = 0; i < rope->systems && !status; i++)
			status = hawser__lmode_running(&t->pairs[i], &rope->system[i], rope, &resting->pairs[i],
			                               report);
		if (status)
			return status;
		enough = choose(t) == t->n;
		for (int k = 0; k < t->n && enough; k++)
			enough = t->choice[k].pair + 2 < t->pairs[t->choice[k].system].n;
		if (enough || tries == TRIES)
			return HAWSER_OK;
		forget(t);
		hawser__lmode_search_clear(resting);
		status = hawser__lmode_search_open(resting, rope, n + t->n/2 + MORE, report);
		if (status)
			return status;
	}
}

/* Find and refine, with more nodes until the errors are within the tolerance. resting: NULL, or of a
 * rope that runs. */
static enum hawser_status solve(struct hawser_line_modes *modes, struct hawser__lmode_search *t,
                                struct hawser__lmode_search *resting, struct hawser_report *report)
{
	struct hawser__lmode *rope = t->rope;
	int first = rope->options.extra;
	double omega, worst = HUGE_VAL;

	while (rope->options.extra <= first + EXTRA_MOST) {
		enum hawser_status status = resting ? find_running(t, resting, report)
		                                    : hawser__lmode_find(t, report);

		if (!status)
			status = hawser__lmode_refine_all(&omega, t, 1.0, 0.0, report);
		if (status)
			return status;
		worst = hawser__lmode_worst(t);
		if (worst <= rope->options.tolerance)
			return hawser__lmode_fill(modes, t, omega, report);
		rope->options.extra += 4 + rope->options.extra/2;
		forget(t);
		if (resting)
			forget(resting);
	}
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "line modes", 0, worst, "the first %d "
	                       "frequencies%s have an estimated relative error of %.1e where %.1e was "
	                       "asked: ask for fewer modes, or for a larger tolerance (round-off allows "
	                       "some 1e-12)", t->n, resting ? " of the running rope" : "", worst,
	                       rope->options.tolerance);
}

enum hawser_status hawser__lmode_settle(struct hawser_line_modes_options *o,
                                        const struct hawser_line_statics *const *lane, int lanes,
                                        struct hawser_report *report)
{
	int any = lanes >= 1 && lanes <= HAWSER_LINE_LANES && lane;

	hawser__settle_count(&o->n, DEFAULT);
	hawser__settle(&o->tolerance, default_tolerance);
	for (int i = 0; i < lanes && any; i++)
		any = lane[i] && lane[i]->line && lane[i]->pieces > 0;
	if (!any)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line modes", "give the solved statics of one "
		                    "lane or two");
	if (o->n < 1 || o->n > MODES_MOST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line modes", "%d modes asked: ask for 1 to "
		                    "%d",
		                    o->n, MODES_MOST);
	if (!(o->tolerance > 0.0 && o->tolerance < 1.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line modes", "a tolerance of %g: give one "
		                    "between 0 and 1, or 0 for %g", o->tolerance, default_tolerance);
	if ((unsigned)o->contact > HAWSER_LINE_ROLL || o->freedoms < 0 ||
	    (o->freedoms > 0 && !o->freedom) ||
	    o->extra < 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "line modes", "an option is out of its range: "
		                    "contact, freedoms or extra");
	return HAWSER_OK;
}

/* With options that were settled. */
static enum hawser_status lowest(struct hawser_line_modes *modes,
                                 const struct hawser_line_statics *const *lane, int lanes,
                                 const struct hawser_line_modes_options *o, int runs,
                                 struct hawser_report *report)
{
	struct hawser__lmode rope = {.systems = 0};
	struct hawser__lmode_search t = {.n = 0}, resting = {.n = 0};
	enum hawser_status status = hawser__lmode_open(&rope, lane, lanes, o, 0.0, report);

	if (!status)
		status = hawser__lmode_search_open(&t, &rope, o->n, report);
	if (!status && runs)
		status = hawser__lmode_search_open(&resting, &rope, o->n + o->n/4 + MORE, report);
	if (!status)
		status = solve(modes, &t, runs ? &resting : NULL, report);
	hawser__lmode_search_clear(&t);
	hawser__lmode_search_clear(&resting);
	hawser__lmode_clear(&rope);
	return status;
}

enum hawser_status hawser_line_modes_solve(struct hawser_line_modes *modes,
                                           const struct hawser_line_statics *const *lane, int lanes,
                                           const struct hawser_line_modes_options *options,
                                           struct hawser_report *report)
{
	struct hawser_line_modes_options o = *options;
	enum hawser_status status = hawser__lmode_settle(&o, lane, lanes, report);

	*modes = (struct hawser_line_modes){.n = 0};
	if (!status)
		status = lowest(modes, lane, lanes, &o, 0, report);
	if (status)
		hawser_line_modes_clear(modes);
	return status;
}

enum hawser_status hawser_line_modes_running(struct hawser_line_modes *modes,
                                             const struct hawser_line_statics *const *lane, int lanes,
                                             const struct hawser_line_modes_options *options,
                                             struct hawser_report *report)
{
	struct hawser_line_modes_options o = *options;
	enum hawser_status status = hawser__lmode_settle(&o, lane, lanes, report);
	int runs = !status && lane[0]->line->speed != 0.0;

	*modes = (struct hawser_line_modes){.n = 0};
	if (runs && o.contact == HAWSER_LINE_STICK)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "line modes", "the rope runs at %g m/s, "
		                      "so that it does not stick to its sheaves: choose slip or roll, or the "
		                      "speed 0", lane[0]->line->speed);
	if (!status)
		status = lowest(modes, lane, lanes, &o, runs, report);
	if (!status && !runs)
		status = hawser__lmode_add_parts(modes, report);
	if (status)
		hawser_line_modes_clear(modes);
	return status;
}
