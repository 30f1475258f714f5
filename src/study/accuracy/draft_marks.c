/* study/accuracy/draft_marks.c - what the next bases move the marks of a draft by: see accuracy_full.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "study/accuracy/draft.h"

#define ABOUT 4 /* marks before and behind the one that is moved farthest; chosen */

/* The mark that the next basis moves farthest, by `moved`. peaks: 1: only the components with the two
 * largest peaks count. */
static enum hawser_status find_farthest(int *farthest, const struct hawser__traced *traced,
                                        const struct hawser__drawn_curve *chosen,
                                        const struct hawser__drawn_curve *next, double moved,
                                        int peaks, struct hawser_report *report)
{
	struct hawser__drawn_curve so_far = *next;
	int less = 0, whole = next->points;
	enum hawser_status status = HAWSER_OK;

	while (!status && whole - less > 1) {
		double most;

		so_far.points = (less + whole)/2;
		status = hawser__curve_points_distance(&most, &traced->curve, traced->mark, chosen, &so_far,
		                                       peaks, report);
		*(most < moved ? &less : &whole) = so_far.points;
	}
	*farthest = whole - 1;
	return status;
}

enum hawser_status hawser__marks_error(double *error, struct hawser_accuracy *a,
                                       const struct hawser__traced *traced,
                                       const struct hawser__drawn_curve *chosen,
                                       const struct hawser__draft *next, double moved, int functions,
                                       const struct hawser_accuracy_bases *of,
                                       const struct hawser_frf_options *settled,
                                       struct hawser_report *report)
{
	const struct hawser__drawn_curve *curve = &traced->curve, *own = chosen->points ? chosen : NULL;
	struct hawser__drawn_curve there = next->curve;
	struct hawser__traced few = *traced;
	struct hawser__draft last = {.functions = 0};
	double away = INFINITY;
	int first, farthest = 0, end;
	enum hawser_status status = hawser_accuracy_basis(&last.rom, &functions, of, next->rom.n, report);

	last.functions = functions;
	if (!status)
		status = find_farthest(&farthest, traced, own, &next->curve, moved, 0, report);
	first = farthest > ABOUT ? farthest - ABOUT : 0;
	end = farthest + ABOUT < traced->marks ? farthest + ABOUT + 1 : traced->marks;
	few.mark += first;
	few.marks = there.points = end - first;
	there.value += (size_t)first*((size_t)there.width + 1);
	there.arc += first;
	if (!status && last.rom.n > 0)
		status = hawser__draft_carry(&last, &away, &few, a, NULL, settled, of->accuracy, 0.0,
		                             report);
	for (int k = 0; k < 2; k++) {
		double beyond = INFINITY;

		if (!status && k)
			status = hawser__curve_points_distance(&moved, curve, traced->mark, own, &next->curve,
			                                       k, report);
		if (!status && k)
			status = find_farthest(&farthest, traced, own, &next->curve, moved, k, report);
		if (!status && isfinite(away) && farthest >= first && farthest < end)
			status = hawser__curve_points_distance(&beyond, curve, few.mark, &there, &last.curve, k,
			                                       report);
		error[k] = fmin(HAWSER__SAFETY_BASIS*moved,
		                HAWSER__MARGIN*moved + HAWSER__SAFETY_BASIS*beyond);
	}
	hawser__draft_clear(&last);
	return status;
}

enum hawser_status hawser__marks_shorten(double *moved, struct hawser__traced *traced,
                                         struct hawser_accuracy *a, struct hawser__draft *next,
                                         const struct hawser__drawn_curve *chosen, double enough,
                                         const struct hawser_frf_options *frf,
                                         struct hawser_report *report)
{
	const struct hawser__drawn_curve *own = chosen->points ? chosen : NULL;
	int good = 0, bad = next->curve.points;
	double most = *moved;
	enum hawser_status status = HAWSER_OK;

	while (!status && bad - good > 1) {
		double so_far;

		next->curve.points = (good + bad)/2;
		status = hawser__curve_points_distance(&so_far, &traced->curve, traced->mark, own,
		                                       &next->curve, 0, report);
		if (so_far <= enough) {
			good = next->curve.points;
			most = so_far;
		} else {
			bad = next->curve.points;
		}
	}
	next->curve.points = traced->marks;
	if (!status && hawser__traced_part(traced, a, good, frf)) {
		next->curve.points = traced->marks;
		*moved = most;
	}
	return status;
}

int hawser__marks_partial(const struct hawser_accuracy_options *options,
                          const struct hawser__traced *traced, int own, int n, double work)
{
	double next = traced->work*pow((double)n/own, 3.0), last = next*pow((double)n/own, 3.0);

	return options->partial && traced->functions &&
	       work + next + last + hawser__draft_follows(options, n, traced->curve.points, next) >
	       HAWSER__A_PART*options->bearable;
}
