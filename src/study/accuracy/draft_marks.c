/* study/accuracy/draft_marks.c - what the next bases move the marks of a draft by: see accuracy_full.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "study/accuracy/draft.h"

#define ABOUT 4 /* marks before and behind the one that is moved farthest; chosen */

/* The first of the few marks about the one that the next basis moves farthest, *count of them. */
static enum hawser_status find_farthest(int *first, int *count, const struct hawser__traced *traced,
                                        const struct hawser__drawn_curve *chosen,
                                        const struct hawser__drawn_curve *next, double moved,
                                        struct hawser_report *report)
{
	struct hawser__drawn_curve so_far = *next;
	int less = 0, whole = next->points;
	enum hawser_status status = HAWSER_OK;

	while (!status && whole - less > 1) {
		double most;

		so_far.points = (less + whole)/2;
		status = hawser__curve_points_distance(&most, &traced->curve, traced->mark, chosen, &so_far,
		                                       0, report);
		*(most < moved ? &less : &whole) = so_far.points;
	}
	*first = whole - ABOUT > 0 ? whole - ABOUT : 0;
	*count = whole + ABOUT < next->points ? whole + ABOUT - *first : next->points - *first;
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
	double away = INFINITY, beyond = INFINITY;
	int first = 0;
	enum hawser_status status = hawser_accuracy_basis(&last.rom, &functions, of, next->rom.n, report);

	last.functions = functions;
	if (!status)
		status = find_farthest(&first, &few.marks, traced, own, &next->curve, moved, report);
	few.mark += first;
	there.value += (size_t)first*((size_t)there.width + 1);
	there.arc += first;
	there.points = few.marks;
	if (!status && last.rom.n > 0)
		status = hawser__draft_carry(&last, &away, &few, a, settled, 0.0, report);
	for (int k = 0; k < 2; k++) {
		if (!status && k)
			status = hawser__curve_points_distance(&moved, curve, traced->mark, own, &next->curve,
			                                       k, report);
		if (!status && isfinite(away))
			status = hawser__curve_points_distance(&beyond, curve, few.mark, &there, &last.curve, k,
			                                       report);
		error[k] = fmin(HAWSER__SAFETY_BASIS*moved, HAWSER__MARGIN*moved + HAWSER__SAFETY_BASIS*beyond);
	}
	hawser__draft_clear(&last);
	return status;
}

enum hawser_status hawser__marks_shorten(double *moved, struct hawser__traced *traced,
                                  struct hawser_accuracy *a, struct hawser__draft *next,
                                  const struct hawser__drawn_curve *chosen, double enough,
                                  const struct hawser_frf_options *frf, struct hawser_report *report)
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
