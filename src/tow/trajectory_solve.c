/* tow/trajectory_solve.c - the path of least snap, jerk or acceleration: one banded system.
 *
 *   m      order of the derivative that is minimised; pieces have degree 2m-1
 *   c      coefficients of powers of tau in [-1, 1], 2m a piece, for each axis (a right-hand side)
 *
 * The first variation of the integral of |u^(m)|^2 gives u^(2m) = 0 within the pieces, all derivatives
 * up to 2m-2 continuous at a waypoint, and at a free end u^(2m-1-k) = 0 for each derivative
 * k = 1 .. m-1 that is not given. Where derivative k is given at an inner waypoint, both sides have it,
 * and derivative 2m-1-k may jump. The conditions in the order of time give a band of 3m-2 on either
 * side. The equations of the least integral for the derivatives at the waypoints (Bry, Richter and Roy
 * 2015) are half as many, but contain the durations to the power 1-2m: with durations of 1 and 0.01 s
 * beside each other the soft parts would lose all digits to the stiff ones.
 *
 * The unknowns are x = c (H/h)^k with the longest duration H: then the conditions of continuity have
 * factors of order 1 on both sides whatever the durations, and no number depends on the unit of time.
 * LAPACK factors the band, and the solution is refined with residuals of more digits (long double); its
 * error is stated by the last correction.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <string.h>

#include <lapacke.h>

#include "core/hold.h"
#include "core/report.h"
#include "tow/trajectory.h"

enum { AXES = 3, REFINEMENTS = 8 /* at most: each gains the digits that the matrix leaves, of 16 */ };

struct system {
	int m, n, size, band, rows; /* n = 2m unknowns a piece; rows written so far */
	int ld, lu_ld;              /* 2*band + 1, 3*band + 1 */
	double *ab, *lu;            /* [size][ld] column by column, entry (i, j) at band + i - j; factors */
	double *b, *x, *r;          /* [AXES][size] right-hand sides, solutions, residuals */
	lapack_int *pivot;          /* [size] */
	const double *time;
	const double *origin;
	double longest;             /* H */
	struct hawser__hold hold;
};

static double half(const struct system *s, int piece)
{
	return 0.5*(s->time[piece + 1] - s->time[piece]);
}

/* x of power p of a piece times this is c. */
static double scale(const struct system *s, int piece, int p)
{
	return pow(2.0*half(s, piece)/s->longest, p);
}

/* Add sign times derivative `order` by t, in units of (H/2)^-order, of a piece at its end tau to the
 * current row. */
static void add(struct system *s, int piece, int order, double tau, double sign)
{
	double row[HAWSER__TRAJECTORY_DEGREE + 1];

	hawser__trajectory_row(row, s->n - 1, order, tau);
	for (int p = order; p < s->n; p++) {
		int column = piece*s->n + p;

		s->ab[(size_t)column*(size_t)s->ld + (size_t)(s->band + s->rows - column)] =
			sign*row[p]*scale(s, piece, p - order);
	}
}

/* Derivative `order` of a piece at its end tau is that of the waypoint, or with NULL zero. */
static void given(struct system *s, const struct hawser_waypoint *point, int piece, int order,
                  double tau)
{
	add(s, piece, order, tau, 1.0);
	for (int axis = 0; axis < AXES && point; axis++)
		s->b[axis*s->size + s->rows] = (point->at[order][axis] - (order ? 0.0 : s->origin[axis]))*
		                               pow(0.5*s->longest, order);
	s->rows++;
}

static void end(struct system *s, const struct hawser_waypoint *point, int piece, double tau)
{
	given(s, point, piece, 0, tau);
	for (int k = 1; k < s->m; k++)
		if (point->given[k])
			given(s, point, piece, k, tau);
		else
			given(s, NULL, piece, 2*s->m - 1 - k, tau);
}

/* Piece i - 1 and i at the waypoint between them: first what is of the earlier piece alone. */
static void between(struct system *s, const struct hawser_waypoint *point, int i)
{
	given(s, point, i - 1, 0, 1.0);
	for (int k = 1; k < s->m; k++)
		if (point->given[k])
			given(s, point, i - 1, k, 1.0);
	for (int k = 1; k < 2*s->m - 1; k++) {
		if (point->given[k < s->m ? k : 2*s->m - 1 - k])
			continue;
		add(s, i - 1, k, 1.0, 1.0);
		add(s, i, k, -1.0, -1.0);
		s->rows++;
	}
	for (int k = s->m - 1; k >= 0; k--)
		if (!k || point->given[k])
			given(s, point, i, k, -1.0);
}

/* r = b - A x, summed in more digits. */
static void residual(struct system *s)
{
	for (int axis = 0; axis < AXES; axis++)
		for (int i = 0; i < s->size; i++) {
			int first = i > s->band ? i - s->band : 0;
			int last = i + s->band < s->size ? i + s->band : s->size - 1;
			long double sum = s->b[axis*s->size + i];

			for (int j = first; j <= last; j++)
				sum -= (long double)s->ab[(size_t)j*(size_t)s->ld + (size_t)(s->band + i - j)]*
				       s->x[axis*s->size + j];
			s->r[axis*s->size + i] = (double)sum;
		}
}

/* Add the correction r to x. Returns its largest part of the coefficients of a piece. */
static double correct(struct system *s, int pieces)
{
	double worst = 0.0;

	for (int axis = 0; axis < AXES; axis++)
		for (int i = 0; i < pieces; i++) {
			double *x = &s->x[axis*s->size + i*s->n], *r = &s->r[axis*s->size + i*s->n];
			double change = 0.0, size = 0.0;

			for (int p = 0; p < s->n; p++) {
				change = fmax(change, fabs(r[p])*scale(s, i, p));
				x[p] += r[p];
				size = fmax(size, fabs(x[p])*scale(s, i, p));
			}
			if (!(change <= worst*size)) /* a NaN stays */
				worst = change/size;
		}
	return worst;
}

/* Solve and refine until corrections no longer become smaller. */
static enum hawser_status solve(struct hawser_path *of, struct system *s,
                                struct hawser_report *report)
{
	double before = INFINITY, change;
	lapack_int info;

	for (int j = 0; j < s->size; j++)
		memcpy(&s->lu[(size_t)j*(size_t)s->lu_ld + (size_t)s->band],
		       &s->ab[(size_t)j*(size_t)s->ld], (size_t)s->ld*sizeof *s->ab);
	info = LAPACKE_dgbtrf(LAPACK_COL_MAJOR, s->size, s->size, s->band, s->band, s->lu, s->lu_ld,
	                      s->pivot);
	if (hawser__lapack_starved((int)info))
		return hawser__no_memory(report, "trajectory");
	for (int i = 0; i < REFINEMENTS && !info; i++) {
		residual(s);
		info = LAPACKE_dgbtrs(LAPACK_COL_MAJOR, 'N', s->size, s->band, s->band, AXES, s->lu, s->lu_ld,
		                      s->pivot, s->r, s->size);
		change = correct(s, of->pieces);
		if (i && !(change < 0.5*before))
			break;
		before = i ? change : 1.0;
	}
	/* a singular matrix, or one of which the factors leave no digit to refine */
	if (info != 0 || !(before < 1.0))
		return hawser__fail_at(report, HAWSER_ERR_ARGUMENT, "trajectory", -1, 0.0, "the given "
		                       "derivatives and times do not determine the path in double precision: "
		                       "give the velocity where an acceleration or a jerk is given, more "
		                       "waypoints, or leave out some that are close together");
	of->error = before + DBL_EPSILON; /* by which coefficients are rounded */
	for (int axis = 0; axis < AXES; axis++)
		for (int i = 0; i < s->size; i++)
			of->coefficient[(AXES*(i/s->n) + axis)*s->n + i%s->n] =
				s->x[axis*s->size + i]*scale(s, i/s->n, i%s->n);
	return HAWSER_OK;
}

static int system_open(struct system *s)
{
	size_t size = (size_t)s->size;

	s->ab = hawser__hold(&s->hold, size*(size_t)s->ld, sizeof *s->ab);
	s->lu = hawser__hold(&s->hold, size*(size_t)s->lu_ld, sizeof *s->lu);
	s->b = hawser__hold(&s->hold, AXES*size, sizeof *s->b);
	s->x = hawser__hold(&s->hold, AXES*size, sizeof *s->x);
	s->r = hawser__hold(&s->hold, AXES*size, sizeof *s->r);
	s->pivot = hawser__hold(&s->hold, size, sizeof *s->pivot);
	return !s->hold.short_of_memory;
}

static void system_clear(struct system *s)
{
	hawser__hold_clear(&s->hold);
}

enum hawser_status hawser__trajectory_solve(struct hawser_path *of,
                                            const struct hawser_waypoint *point, int m,
                                            struct hawser_report *report)
{
	struct system s = {.m = m, .n = 2*m, .size = 2*m*of->pieces, .band = 3*m - 2,
	                   .ld = 2*(3*m - 2) + 1, .lu_ld = 3*(3*m - 2) + 1, .time = of->time,
	                   .origin = of->origin};
	enum hawser_status status;

	for (int i = 0; i < of->pieces; i++)
		s.longest = fmax(s.longest, of->time[i + 1] - of->time[i]);
	if (!system_open(&s)) {
		status = hawser__no_memory(report, "trajectory");
		goto done;
	}
	end(&s, &point[0], 0, -1.0);
	for (int i = 1; i < of->pieces; i++)
		between(&s, &point[i], i);
	end(&s, &point[of->pieces], of->pieces - 1, 1.0);
	status = solve(of, &s, report);
done:
	system_clear(&s);
	return status;
}
