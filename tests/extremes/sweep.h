/* tests/extremes/sweep.h - parameters varied up to their limits, two at a time, each point
 * checked.
 *
 * A test program has a table of axes and a function that solves one point and classifies the
 * result by an independent check. A point is right if its error is within the error that the
 * library states, or refused if the library returns a status with a reason. Every other point is
 * wrong. A stated bound must hold. A stated estimate may be exceeded by a factor of ten at most;
 * points that exceed it are counted.
 *
 * With HAWSER_LONG in the environment the axes have more values. With HAWSER_VALIDITY=FILE one
 * row per point is appended to FILE, from which doc/figures-validity.sh draws where each method
 * is valid.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_SWEEP_H
#define HAWSER_TESTS_SWEEP_H

#include <stdlib.h>

#include <hawser/status.h>

#include "tests/tap.h"

enum { SWEEP_AXES = 8, SWEEP_VALUES = 400, SWEEP_SHOWN = 6 };

struct sweep_axis {
	const char *name;    /* of one word */
	double usual;        /* value while other axes vary */
	const double *value; /* [count] ascending */
	int count;
	int between; /* with HAWSER_LONG, number of additional values between neighbours: in geometric
	              * progression if both are positive, otherwise equidistant */
};

/* Result of a point; all zero on entry. */
struct sweep_point {
	enum hawser_status status;
	struct hawser_report report;
	double error;  /* true error; NAN: the point is wrong */
	double stated; /* error stated by the library */
	int bound;     /* 1: `stated` is a bound, which must hold; 0: an estimate */
	int skip;      /* 1: this combination of values is not tested */
};
typedef void sweep_function(struct sweep_point *point, const double *x, void *context);

struct sweep_tally {
	int points, right, refused, wrong;
	int beyond;   /* number of right points with a true error above the stated one */
	double worst; /* largest ratio of true to stated error of the right points */
};

static inline int sweep_long(void)
{
	return getenv("HAWSER_LONG") != NULL;
}

static int sweep_every; /* 1: all points are tested */
static int sweep_thins; /* 1: the table's function leaves out points itself */

/* 1: skip this point. One point of `few` is tested; with HAWSER_LONG, one of `many`. */
static inline int sweep_left_out(int few, int many)
{
	static int count;

	sweep_thins = 1;
	return !sweep_every && ++count % (sweep_long() ? many : few);
}

/* Add one of several numbers of a point: keeps the one with the largest ratio of error to stated. */
static inline void sweep_keep(struct sweep_point *point, double error, double stated)
{
	if (isnan(error) || point->stated == 0.0 || error*point->stated > point->error*stated) {
		point->error = error;
		point->stated = stated;
	}
}

/* Values of an axis, with the additional ones, in [SWEEP_VALUES]. Returns their number. */
static inline int sweep_values(double *value, const struct sweep_axis *axis)
{
	int more = sweep_long() ? axis->between : 0, n = 0;

	for (int i = 0; i < axis->count; i++) {
		value[n++] = axis->value[i];
		for (int k = 1; i + 1 < axis->count && k <= more && n < SWEEP_VALUES - 1; k++) {
			double a = axis->value[i], b = axis->value[i + 1], t = (double)k/(more + 1);

			value[n++] = a > 0.0 ? a*pow(b/a, t) : a + t*(b - a);
		}
	}
	return n;
}

/* "right", "refused" or "wrong". */
static inline const char *sweep_judge(struct sweep_tally *tally, const struct sweep_point *point)
{
	double ratio = point->error == 0.0 ? 0.0 : point->error/point->stated;

	tally->points++;
	if (point->status) {
		int reason = strlen(point->report.message) > 20 && point->status == point->report.status &&
		             point->status != HAWSER_ERR_MEMORY;

		*(reason ? &tally->refused : &tally->wrong) += 1;
		return reason ? "refused" : "wrong";
	}
	if (!(ratio >= 0.0 && ratio <= (point->bound ? 1.0 : 10.0)) || !isfinite(point->stated)) {
		tally->wrong++;
		return "wrong";
	}
	tally->right++;
	tally->beyond += ratio > 1.0;
	tally->worst = fmax(tally->worst, ratio);
	return "right";
}

/* A point that was wrong once: always tested. */
static inline void sweep_again(const char *what, sweep_function *solve, const double *x,
                               void *context)
{
	struct sweep_point point = {.report = {.message = ""}};
	struct sweep_tally tally = {0};

	sweep_every = 1;
	solve(&point, x, context);
	sweep_every = 0;
	ok(strcmp(sweep_judge(&tally, &point), "right") == 0, "%s: true error %.1e, stated %.1e %s", what,
	   point.error, point.stated, point.report.message);
}

static inline void sweep_show(const struct sweep_axis *axis, int axes, const double *x,
                              const struct sweep_point *point)
{
	printf("# wrong:");
	for (int k = 0; k < axes; k++)
		printf(" %s %.17g", axis[k].name, x[k]);
	printf(": true error %.3e, stated %.3e %s %s\n", point->error, point->stated,
	       hawser_status_name(point->status), point->report.message);
}

/* One check: two axes vary over all their values, the others have their usual ones. */
static inline struct sweep_tally sweep_pair(const char *stage, const struct sweep_axis *axis,
                                            int axes, int i, int j, sweep_function *solve,
                                            void *context)
{
	static double first[SWEEP_VALUES], second[SWEEP_VALUES];
	const char *name = getenv("HAWSER_VALIDITY");
	FILE *rows = name ? fopen(name, "a") : NULL;
	struct sweep_tally tally = {0};
	double x[SWEEP_AXES] = {0.0};
	int n = sweep_values(first, axis + i), m = sweep_values(second, axis + j);

	for (int k = 0; k < axes; k++)
		x[k] = axis[k].usual;
	for (int p = 0; p < n*m; p++) {
		struct sweep_point point = {.report = {.message = ""}};
		const char *outcome;

		/* every second point, as the fields of a chessboard, so that each value of an axis is tested */
		if (!sweep_long() && !sweep_thins && n > 2 && m > 2 && (p/m + p % m) % 2)
			continue;
		x[i] = first[p/m];
		x[j] = second[p % m];
		solve(&point, x, context);
		if (point.skip)
			continue;
		outcome = sweep_judge(&tally, &point);
		if (outcome[0] == 'w' && tally.wrong <= SWEEP_SHOWN)
			sweep_show(axis, axes, x, &point);
		if (rows)
			fprintf(rows, "%s\t%s\t%.17g\t%s\t%.17g\t%s\t%.3e\t%.3e\n", stage, axis[i].name, x[i],
			        axis[j].name, x[j], outcome, point.error, point.stated);
	}
	if (rows)
		fclose(rows);
	ok(tally.wrong == 0 && tally.points > 0 && (rows || !name),
	   "%s, %s and %s: %d points, %d right (%d beyond the statement, worst ratio %.2g), %d refused, "
	   "%d wrong", stage, axis[i].name, axis[j].name, tally.points, tally.right, tally.beyond,
	   tally.worst, tally.refused, tally.wrong);
	return tally;
}

/* Every pair of axes of the table. */
static inline struct sweep_tally sweep_pairs(const char *stage, const struct sweep_axis *axis,
                                             int axes, sweep_function *solve, void *context)
{
	struct sweep_tally sum = {0};

	for (int i = 0; i < axes; i++)
		for (int j = i + 1; j < axes; j++) {
			struct sweep_tally one = sweep_pair(stage, axis, axes, i, j, solve, context);

			sum.points += one.points;
			sum.right += one.right;
			sum.refused += one.refused;
			sum.wrong += one.wrong;
			sum.beyond += one.beyond;
			sum.worst = fmax(sum.worst, one.worst);
		}
	return sum;
}

#endif
