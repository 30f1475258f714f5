/* The 200 spans of statics-spans.tsv, computed with 60 digits by other formulas
 * (make-statics-spans.py), solved from each of the five given quantities.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "tests/statics-draw.h"
#include "tests/tap.h"

enum { NAMES = 8 };
static const char *const names[NAMES] = {"T0", "T1", "V0", "length0", "length", "sag", "irvine",
                                         "irvine_source"};
static const char *const givens[] = {"", "H", "T0", "T1", "length0", "sag"};
static double worst[NAMES], worst_given[6], worst_H[6];

struct row {
	struct hawser_span span;
	double H, want[NAMES];
};

static int read_row(FILE *file, struct row *row)
{
	double *at[5] = {&row->span.EA, &row->span.rho, &row->span.d, &row->span.h, &row->H};

	for (int i = 0; i < 5; i++)
		if (fscanf(file, "%lf", at[i]) != 1)
			return 0;
	for (int i = 0; i < NAMES; i++)
		if (fscanf(file, "%lf", &row->want[i]) != 1)
			return 0;
	row->span.g = 9.81;
	return 1;
}

static double relative(double got, double want, double scale)
{
	if (got == want)
		return 0.0;
	return fabs(got - want)/fabs(scale);
}

/* All results for given H against the table. */
static int compare(const struct row *row, struct hawser_statics *st)
{
	if (hawser_statics_solve(st, &row->span, HAWSER_GIVEN_H, row->H, HAWSER_BRANCH_TAUT, NULL))
		return 0;

	const double got[NAMES] = {st->T0, st->T1, st->V0, st->length0, st->length, st->sag, st->irvine,
	                           st->irvine_source};

	for (int i = 0; i < NAMES; i++) {
		double scale = i == 2 ? row->want[0] : row->want[i]; /* V0 may be nearly zero */
		double e = relative(got[i], row->want[i], scale);

		worst[i] = e <= worst[i] ? worst[i] : e;
	}
	return 1;
}

/* H for the printed value of a given quantity, with a tolerance for the rounding of that value. */
static int invert(const struct row *row, const struct hawser_statics *st, enum hawser_given given)
{
	const double table[] = {0.0, row->H, row->want[0], row->want[1], row->want[3], row->want[5]};
	double value = table[given], step = 1e-3, cond, e;
	struct hawser_statics next, back;

	if (given == HAWSER_GIVEN_LENGTH0 && value <= hypot(row->span.d, row->span.h) &&
	    isinf(row->span.EA)) /* its printed length0 equals the chord */
		return hawser_statics_solve(&back, &row->span, given, value, HAWSER_BRANCH_TAUT, NULL) ==
		       HAWSER_ERR_NO_SOLUTION;
	if (hawser_statics_solve(&next, &row->span, HAWSER_GIVEN_H, row->H*(1.0 + step),
	                         HAWSER_BRANCH_TAUT, NULL) ||
	    hawser_statics_solve(&back, &row->span, given, value, branch_of(st, given), NULL))
		return 0;
	cond = fabs(value_of(&next, given)/value - 1.0)/step; /* d ln value/d ln H */
	e = relative(value_of(&back, given), value, value);
	worst_given[given] = fmax(worst_given[given], e);
	worst_H[given] = fmax(worst_H[given], relative(back.H, row->H, row->H)*fmin(1.0, cond));
	return 1;
}

CASE(reference_statics_spans)
{
	char line[512];
	const char *path = source_file("tests/reference/statics-spans.tsv");
	struct hawser_statics st;
	struct row row;
	FILE *file;
	int rows = 0, failed = 0;

	file = fopen(path, "r");
	if (!ok(file != NULL, "%s opens", path))
		return done_testing();
	for (int i = 0; i < 2; i++)
		if (!fgets(line, sizeof line, file))
			rows = -1000;
	for (; read_row(file, &row); rows++) {
		failed += !compare(&row, &st);
		for (int given = HAWSER_GIVEN_H; given <= HAWSER_GIVEN_SAG; given++)
			failed += !invert(&row, &st, (enum hawser_given)given);
	}
	fclose(file);
	ok(rows == 200, "%d rows", rows);
	ok(failed == 0, "every span solved from every given: %d failed", failed);
	/* irvine (row 6) is ill-conditioned if a steep end is nearly perpendicular to the chord */
	for (int i = 0; i < NAMES; i++)
		ok(worst[i] < (i == 6 ? 1e-12 : 2e-14),
		   "%s from H against 60 digits: worst relative error %.1e", names[i], worst[i]);
	for (int given = HAWSER_GIVEN_H; given <= HAWSER_GIVEN_SAG; given++)
		ok(worst_given[given] < 2e-14 && worst_H[given] < 1e-13,
		   "from %s: given met to %.1e, H to %.1e of what its rounding allows", givens[given],
		   worst_given[given], worst_H[given]);
	return done_testing();
}
