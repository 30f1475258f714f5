/* ropeway/modes/modes.c - real modes of a rope over sheaves: the lowest ones of all systems together.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/settle.h"
#include "ropeway/modes/modes.h"

enum { DEFAULT = 6, MODES_MOST = 500, GUARD = 2, ROUNDS = 30, EXTRA_MOST = 60 };
static const double default_tolerance = 1e-9;
/* Modes up to this multiple of the highest one asked for are refined: two may change their order. */
static const double margin = 1.05;

const char *hawser_line_contact_name(enum hawser_line_contact_kind kind)
{
	static const char *const names[] = {"slip", "stick", "roll"};

	return (unsigned)kind < sizeof names/sizeof *names ? names[kind] : "unknown";
}

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
	int *next = calloc((size_t)rope->systems, sizeof *next), k = 0;

	for (; next && k < t->n; k++) {
		int best = -1;

		for (int i = 0; i < rope->systems; i++)
			if (next[i] < t->pairs[i].n &&
			    (best < 0 || t->pairs[i].omega[next[i]] < t->pairs[best].omega[next[best]]))
				best = i;
		if (best < 0)
			break;
		t->choice[k] = (struct hawser__lmode_choice){best, next[best]++};
	}
	free(next);
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
		while (t->pairs[i].n > 0 && t->pairs[i].omega[t->pairs[i].n - 1] > most)
			t->pairs[i].n--;
		status = hawser__lmode_refine(&t->pairs[i], &rope->system[i], rope, *omega, report);
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
	for (int i = 0; i < t->rope->systems; i++)
		hawser__lmode_pairs_clear(&t->pairs[i]);
}

/* Find and refine, with more nodes until the errors are within the tolerance. */
static enum hawser_status solve(struct hawser_line_modes *modes, struct hawser__lmode_search *t,
                                struct hawser_report *report)
{
	struct hawser__lmode *rope = t->rope;
	int first = rope->options.extra;
	double omega, worst = HUGE_VAL;
	enum hawser_status status;

	for (;;) {
		status = hawser__lmode_find(t, report);
		if (!status)
			status = hawser__lmode_refine_all(&omega, t, 1.0, 0.0, report);
		if (status)
			return status;
		worst = hawser__lmode_worst(t);
		if (worst <= rope->options.tolerance)
			return hawser__lmode_fill(modes, rope, t->pairs, NULL, t->choice, t->n, omega, report);
		rope->options.extra += 4 + rope->options.extra/2;
		if (rope->options.extra > first + EXTRA_MOST)
			break;
		forget(t);
	}
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "line modes", 0, worst, "the first %d "
	                       "frequencies have an estimated relative error of %.1e where %.1e was asked: "
	                       "ask for fewer modes, or for a larger tolerance (round-off allows some "
	                       "1e-12)",
	                       t->n, worst, rope->options.tolerance);
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

enum hawser_status hawser_line_modes_solve(struct hawser_line_modes *modes,
                                           const struct hawser_line_statics *const *lane, int lanes,
                                           const struct hawser_line_modes_options *options,
                                           struct hawser_report *report)
{
	struct hawser_line_modes_options o = *options;
	struct hawser__lmode rope = {.systems = 0};
	struct hawser__lmode_search t = {.rope = &rope};
	enum hawser_status status;

	*modes = (struct hawser_line_modes){.n = 0};
	status = hawser__lmode_settle(&o, lane, lanes, report);
	t.n = o.n;
	if (!status)
		status = hawser__lmode_open(&rope, lane, lanes, &o, 0.0, report);
	if (!status) {
		t.pairs = calloc((size_t)rope.systems + 1, sizeof *t.pairs);
		t.choice = calloc((size_t)t.n, sizeof *t.choice);
		if (!t.pairs || !t.choice)
			status = hawser__no_memory(report, "line modes");
	}
	if (!status)
		status = solve(modes, &t, report);
	for (int i = 0; t.pairs && i < rope.systems; i++)
		hawser__lmode_pairs_clear(&t.pairs[i]);
	free(t.pairs);
	free(t.choice);
	hawser__lmode_clear(&rope);
	if (status)
		hawser_line_modes_clear(modes);
	return status;
}
