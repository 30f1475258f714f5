/* modes/sweep/campbell_range.c - the range of speeds of a Campbell diagram, and its stations.
 *
 * The steady state ends at a fold v*, where the taut and the slack solution meet. Near v* all
 * quantities vary like sqrt(v* - v). Stations that approach v* therefore reduce the distance v* - v
 * by a factor of 4 each, which halves the distance of the frequencies from their limits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/sweep/branches.h"

enum { POINTS = 100, POINTS_MOST = 1000000, BRANCHES = 10, BRANCHES_MOST = 500, APPROACH_MOST = 32 };
static const char where[] = "campbell";
static const double default_correlation = 0.9, default_crossing = 1e-10;
/* Distance of the last station from the limit, relative to the limit. */
static const double nearest = 1e-9;
/* A station closer to the limit than this multiple of that distance is taken as the last one. */
static const double apart = 1.25;

enum hawser_status hawser_campbell_range(double *to, double *limit, const struct hawser_scene *scene,
                                         struct hawser_report *report)
{
	struct hawser_equivalent equal = {.turned = 0};
	double V = scene->travel.fluctuation;
	struct hawser_statics rest;
	enum hawser_status status;

	if (!scene->travel.present)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "the scene has no travel, which states what is held as the speed "
		                    "changes: add travel: {speed: 1 m/s, hold: tension} (or hold: length)");
	status = hawser_statics_equivalent(&equal, scene, report);
	if (!status)
		status = hawser_statics_limit(limit, &equal.span, equal.given, equal.value,
		                              equal.branch, scene->travel.hold, report);
	if (!status)
		status = hawser_statics_solve(&rest, &equal.span, equal.given, equal.value,
		                              equal.branch, report);
	if (status)
		return status;
	*limit = sqrt(fmax(*limit**limit - 0.5*V*V, 0.0));
	*to = scene->travel.hold == HAWSER_HOLD_TENSION && equal.given != HAWSER_GIVEN_H
		? *limit : fmin(*limit, 2.0*sqrt(rest.T0/equal.span.rho));
	return HAWSER_OK;
}

static enum hawser_status check(const struct hawser_campbell_options *o, double limit,
                                struct hawser_report *report)
{
	if (o->n < 1 || o->n > BRANCHES_MOST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%d branches asked: ask for 1 to %d", o->n, BRANCHES_MOST);
	if (o->points < 2 || o->points > POINTS_MOST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "a sweep of %d points: ask for 2 to %d", o->points, POINTS_MOST);
	if (!(limit > 0.0))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "with this fluctuation the cable has no steady state at any speed: lower "
		                    "travel.fluctuation");
	if (o->from < limit && !(limit - o->from > apart*nearest*limit))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "%.12g m/s is too near to %.12g m/s, where the steady state ends: begin "
		                    "the sweep a few billionths of that below", o->from, limit);
	if (o->from >= limit)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "from %.10g m/s on the cable has no steady state, it has one up to "
		                    "%.10g m/s: begin the sweep below", o->from, limit);
	if (!(o->from >= 0.0 && o->from < o->to && isfinite(o->to)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "speeds from %.10g to %.10g m/s: give two that ascend, the first not "
		                    "negative", o->from, o->to);
	if (!(o->correlation > 0.5 && o->correlation < 1.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "a squared correlation of %g: give one in (0.5, 1), or 0 for %g",
		                    o->correlation, default_correlation);
	if (!(o->crossing > 0.0 && o->crossing < 1e-3))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "a gap of %g for crossings: give a relative gap in (0, 0.001), or 0 "
		                    "for %g", o->crossing, default_crossing);
	return HAWSER_OK;
}

enum hawser_status hawser__campbell_settle(struct hawser_campbell_options *o, double *limit,
                                           const struct hawser_scene *scene,
                                           struct hawser_report *report)
{
	double to;
	enum hawser_status status = hawser_campbell_range(&to, limit, scene, report);

	if (status)
		return status;
	o->to = o->to == 0.0 ? to : o->to;
	o->points = o->points == 0 ? POINTS : o->points;
	o->n = o->n == 0 ? BRANCHES : o->n;
	o->correlation = o->correlation == 0.0 ? default_correlation : o->correlation;
	o->crossing = o->crossing == 0.0 ? default_crossing : o->crossing;
	return check(o, *limit, report);
}

enum hawser_status hawser__campbell_place(double **x, int *count, int *asked,
                                          const struct hawser_campbell_options *o, double limit,
                                          struct hawser_report *report)
{
	double step = (fmin(o->to, limit) - o->from)/(o->points - 1), least = nearest*limit;
	double *speed = malloc(((size_t)o->points + APPROACH_MOST)*sizeof *speed);
	int n = 0;

	if (!speed)
		return hawser__no_memory(report, where);
	for (int i = 0; i < o->points; i++) {
		double v = i == o->points - 1 ? fmin(o->to, limit) : o->from + i*step;

		if (i == 0 || v <= limit - least)
			speed[n++] = v;
	}
	*asked = n;
	if (o->to > limit - least) {
		/* n >= 1: the loop always takes the first point */
		/* NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult) */
		for (double left = 0.25*(limit - speed[n - 1]);
		     left > least && n < o->points + APPROACH_MOST - 1; left *= 0.25)
			speed[n++] = limit - left;
		/* unless a requested station is already there */
		if (limit - speed[n - 1] > apart*least)
			speed[n++] = limit - least;
	}
	*x = speed;
	*count = n;
	return HAWSER_OK;
}
