/* ropeway/modes/modes_speed.c - complex modes of a rope that runs: the lowest ones of all
 * systems together. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "ropeway/modes/modes.h"

/* Modes at rest that are the start beyond those asked for; tries with more of them; largest number of
 * nodes more in an element than at first. */
enum { MORE = 4, TRIES = 6, EXTRA_MOST = 60 };
static const double margin = 1.05; /* as in modes.c */

struct search {
	struct hawser__lmode_search resting;
	struct hawser__lmode_running *pairs; /* [systems] */
	struct hawser__lmode_choice *choice; /* [n] */
	int n;
};

/* The n lowest of all complex modes; returns how many there are, at most n. */
static int choose(struct search *t)
{
	const struct hawser__lmode *rope = t->resting.rope;
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

static double omega_of(const struct search *t, int k)
{
	return t->pairs[t->choice[k].system].omega[t->choice[k].pair];
}

static void forget(struct search *t)
{
	for (int i = 0; i < t->resting.rope->systems; i++) {
		hawser__lmode_running_clear(&t->pairs[i]);
		hawser__lmode_pairs_clear(&t->resting.pairs[i]);
	}
}

/* Complex modes on the first grids, such that the n lowest are among them: all those of a system but
 * the last two have converged. */
static enum hawser_status find(struct search *t, struct hawser_report *report)
{
	struct hawser__lmode *rope = t->resting.rope;
	enum hawser_status status;

	for (int tries = 1;; tries++) {
		int enough = 1;

		free(t->resting.choice);
		t->resting.choice = calloc((size_t)t->resting.n, sizeof *t->resting.choice);
		if (!t->resting.choice)
			return hawser__no_memory(report, "line modes");
		status = hawser__lmode_find(&t->resting, report);
		for (int i = 0; i < rope->systems && !status; i++)
			status = hawser__lmode_running(&t->pairs[i], &rope->system[i], rope, &t->resting.pairs[i],
			                               report);
		if (status)
			return status;
		enough = choose(t) == t->n;
		for (int k = 0; k < t->n && enough; k++)
			enough = t->choice[k].pair + 2 < t->pairs[t->choice[k].system].n;
		if (enough || tries == TRIES)
			return HAWSER_OK;
		t->resting.n += t->n/2 + MORE;
		forget(t);
	}
}

static enum hawser_status refine(double *omega, struct search *t, struct hawser_report *report)
{
	struct hawser__lmode *rope = t->resting.rope;
	enum hawser_status status = HAWSER_OK;

	*omega = margin*omega_of(t, t->n - 1);
	for (int i = 0; i < rope->systems && !status; i++)
		status = hawser__lmode_running_refine(&t->pairs[i], &rope->system[i], rope, *omega, report);
	(void)choose(t);
	return status;
}

static enum hawser_status solve(struct hawser_line_modes *modes, struct search *t,
                                struct hawser_report *report)
{
	struct hawser__lmode *rope = t->resting.rope;
	int first = rope->options.extra;
	double omega, worst = HUGE_VAL;

	while (rope->options.extra <= first + EXTRA_MOST) {
		enum hawser_status status = find(t, report);

		if (!status)
			status = refine(&omega, t, report);
		if (status)
			return status;
		worst = 0.0;
		for (int k = 0; k < t->n; k++)
			worst = fmax(worst, t->pairs[t->choice[k].system].error[t->choice[k].pair]);
		if (worst <= rope->options.tolerance)
			return hawser__lmode_fill(modes, rope, NULL, t->pairs, t->choice, t->n, omega, report);
		rope->options.extra += 4 + rope->options.extra/2;
		forget(t);
	}
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "line modes", 0, worst, "the first %d "
	                       "frequencies of the running rope have an estimated relative error of %.1e "
	                       "where %.1e was asked: ask for fewer modes, or for a larger tolerance", t->n,
	                       worst,
	                       rope->options.tolerance);
}

/* Of a rope at rest. */
static enum hawser_status at_rest(struct hawser_line_modes *modes,
                                  const struct hawser_line_statics *const *lane, int lanes,
                                  const struct hawser_line_modes_options *o,
                                  struct hawser_report *report)
{
	enum hawser_status status = hawser_line_modes_solve(modes, lane, lanes, o, report);

	if (!status)
		status = hawser__lmode_add_parts(modes, report);
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
	struct hawser__lmode rope = {.systems = 0};
	struct search t = {.resting = {.rope = &rope}};
	enum hawser_status status;

	*modes = (struct hawser_line_modes){.n = 0};
	status = hawser__lmode_settle(&o, lane, lanes, report);
	if (!status && lane[0]->line->speed == 0.0)
		return at_rest(modes, lane, lanes, &o, report);
	if (!status && o.contact == HAWSER_LINE_STICK)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "line modes", "the rope runs at %g m/s, "
		                      "so that it does not stick to its sheaves: choose slip or roll, or the "
		                      "speed 0",
		                      lane[0]->line->speed);
	t.n = o.n;
	t.resting.n = o.n + o.n/4 + MORE;
	if (!status)
		status = hawser__lmode_open(&rope, lane, lanes, &o, 0.0, report);
	if (!status) {
		t.resting.pairs = calloc((size_t)rope.systems + 1, sizeof *t.resting.pairs);
		t.pairs = calloc((size_t)rope.systems + 1, sizeof *t.pairs);
		t.choice = calloc((size_t)t.n, sizeof *t.choice);
		if (!t.resting.pairs || !t.pairs || !t.choice)
			status = hawser__no_memory(report, "line modes");
	}
	if (!status)
		status = solve(modes, &t, report);
	if (t.resting.pairs && t.pairs)
		forget(&t);
	free(t.resting.pairs);
	free(t.resting.choice);
	free(t.pairs);
	free(t.choice);
	hawser__lmode_clear(&rope);
	if (status)
		hawser_line_modes_clear(modes);
	return status;
}
