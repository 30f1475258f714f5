/* rom/history.c - forces with a given history (struct hawser_rom_history).
 *
 *    p(t)    value of a term: the cubic spline through its values p_i at t_i
 *    M_i     its second derivatives there
 *    h_i     t_(i+1) - t_i
 *
 *    h_(i-1) M_(i-1) + 2 (h_(i-1) + h_i) M_i + h_i M_(i+1)
 *        = 6 [(p_(i+1) - p_i)/h_i - (p_i - p_(i-1))/h_(i-1)]
 *
 * Near the ends the third derivative is continuous ("not a knot"; de Boor 1978, chapter IV), which
 * keeps the fourth order. With r = h_0/h_1, M_0 = (1 + r) M_1 - r M_2 is eliminated, and the last one
 * likewise. With three values the curvature at the ends is 0; two values give a line.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include "core/report.h"
#include "rom/history.h"

static const char where[] = "history";

/* --- the spline --- */

/* M [rows] of the values p [rows]; work [3 rows]. */
static enum hawser_status bend(double *M, const double *p, const double *t, int rows, double *work,
                               struct hawser_report *report)
{
	int inner = rows - 2, info;
	double *low = work, *mid = work + rows, *high = work + 2*rows, *right = M + 1;
	double r, q;

	M[0] = M[rows - 1] = 0.0;
	for (int i = 1; i <= inner; i++) {
		double before = t[i] - t[i - 1], after = t[i + 1] - t[i];

		low[i - 1] = before; /* low[0] is not read by the solver: below the diagonal from row 2 on */
		mid[i - 1] = 2.0*(before + after);
		high[i - 1] = after;
		right[i - 1] = 6.0*((p[i + 1] - p[i])/after - (p[i] - p[i - 1])/before);
	}
	if (inner < 1)
		return HAWSER_OK;
	r = (t[1] - t[0])/(t[2] - t[1]);
	q = (t[rows - 1] - t[rows - 2])/(t[rows - 2] - t[rows - 3]);
	if (inner > 1) {
		mid[0] += (1.0 + r)*(t[1] - t[0]);
		high[0] -= r*(t[1] - t[0]);
		mid[inner - 1] += (1.0 + q)*(t[rows - 1] - t[rows - 2]);
		low[inner - 1] -= q*(t[rows - 1] - t[rows - 2]);
	}
	info = LAPACKE_dgtsv(LAPACK_COL_MAJOR, inner, 1, low + 1, mid, high, right, inner);
	if (info)
		return hawser__lapack_starved(info)
		       ? hawser__no_memory(report, where)
		       : hawser__fail(report, HAWSER_ERR_NAN, where, "a value of the history is not finite");
	if (inner > 1) {
		M[0] = (1.0 + r)*M[1] - r*M[2];
		M[rows - 1] = (1.0 + q)*M[rows - 2] - q*M[rows - 3];
	}
	return HAWSER_OK;
}

/* Last row whose time is not after t; at most the last but one. */
static int interval(const struct hawser_rom_history *history, double t)
{
	int low = 0, high = history->rows - 1;

	while (high - low > 1) {
		int middle = low + (high - low)/2;

		if (history->time[middle] <= t)
			low = middle;
		else
			high = middle;
	}
	return low;
}

double hawser__history_value(const struct hawser_rom_history *history, int term, double t, int rate)
{
	int i = interval(history, t);
	const double *p = history->value + (size_t)term*(size_t)history->rows + i;
	const double *M = history->bend + (size_t)term*(size_t)history->rows + i;
	double h = history->time[i + 1] - history->time[i], b = (t - history->time[i])/h, a = 1.0 - b;

	if (rate)
		return (p[1] - p[0])/h + h/6.0*((3.0*b*b - 1.0)*M[1] - (3.0*a*a - 1.0)*M[0]);
	return a*p[0] + b*p[1] + h*h/6.0*((a*a*a - a)*M[0] + (b*b*b - b)*M[1]);
}

double hawser__history_spacing(const struct hawser_rom_history *history)
{
	double least = INFINITY;

	for (int i = 1; i < history->rows; i++)
		least = fmin(least, history->time[i] - history->time[i - 1]);
	return least;
}

/* --- the forces --- */

void hawser__rom_history(const struct hawser_rom *rom, double *acceleration, double *by_u,
                         double *by_v, const double *u, const double *v, double t)
{
	const struct hawser_rom_history *history = rom->history;

	for (int i = 0; i < history->terms; i++)
		hawser__rom_term(&history->term[i], hawser__history_value(history, i, t, 0), acceleration,
		                 by_u, by_v, u, v, rom->n);
}

/* --- made and freed --- */

static enum hawser_status check(const struct hawser_rom *const *unit, int terms, const double *time,
                                const double *value, int rows, const struct hawser_rom *rom,
                                struct hawser_report *report)
{
	if (terms < 1 || rows < 2)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "a history of %d loads at %d times: give at least one load and two times",
		                    terms, rows);
	for (int i = 0; i < terms; i++)
		if (unit[i]->n != rom->n || unit[i]->harmonics != 1 ||
		    unit[i]->shapes.points != rom->shapes.points ||
		    unit[i]->line.points != rom->line.points)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "the history needs models of the same modes with one load each; "
			                    "number %d has %d coordinates and %d harmonics", i + 1, unit[i]->n,
			                    unit[i]->harmonics);
	for (int i = 0; i < rows; i++) {
		if (!isfinite(time[i]) || (i > 0 && !(time[i] > time[i - 1])))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "the history has the time %g in row %d: times must ascend",
			                    time[i]*rom->time, i + 1);
		for (int k = 0; k < terms; k++)
			if (!isfinite(value[(size_t)k*(size_t)rows + (size_t)i]))
				return hawser__fail(report, HAWSER_ERR_NAN, where,
				                    "a load in row %d of the history is not finite", i + 1);
	}
	return HAWSER_OK;
}

/* A copy of from [count], or NULL if that is NULL; *failed: there is no memory. */
static double *copied(const double *from, size_t count, int *failed)
{
	double *to = from ? malloc(count*sizeof *to) : NULL;

	if (to)
		memcpy(to, from, count*sizeof *to);
	*failed |= from && !to;
	return to;
}

static int take(struct hawser_ramp_term *term, const struct hawser_rom *unit)
{
	const struct hawser_harmonic *from = unit->harmonic;
	size_t n = (size_t)unit->n;
	int failed = 0;

	term->f = copied(from->f, n, &failed);
	term->D = copied(from->D, n*n, &failed);
	term->K = copied(from->K, n*n, &failed);
	/* the static part: a history has no frequency of which the correction could be */
	term->answer = copied(from->answer, 4*(size_t)unit->shapes.points, &failed);
	term->answer_line = copied(from->answer_line, (size_t)unit->line.points, &failed);
	return failed;
}

enum hawser_status hawser_rom_history_set(struct hawser_rom *rom,
                                          const struct hawser_rom *const *unit, int terms,
                                          const double *time, const double *value, int rows,
                                          struct hawser_report *report)
{
	struct hawser_rom_history *history;
	size_t size = (size_t)(rows > 0 ? rows : 0);
	double *work;
	int failed = 0;
	enum hawser_status status = check(unit, terms, time, value, rows, rom, report);

	if (status)
		return status;
	hawser__rom_history_clear(rom);
	history = rom->history = calloc(1, sizeof *history);
	if (!history)
		return hawser__no_memory(report, where);
	history->term = calloc((size_t)terms, sizeof *history->term);
	history->time = copied(time, size, &failed);
	history->value = copied(value, size*(size_t)terms, &failed);
	history->bend = malloc(size*(size_t)terms*sizeof *history->bend);
	work = malloc(3*size*sizeof *work);
	history->rows = rows;
	if (failed || !history->term || !history->bend || !work)
		status = hawser__no_memory(report, where);
	for (int i = 0; i < terms && !status; i++) {
		size_t at = (size_t)i*size;

		history->terms = i + 1;
		status = take(&history->term[i], unit[i])
		         ? hawser__no_memory(report, where)
		         : bend(history->bend + at, history->value + at, time, rows, work, report);
	}
	free(work);
	if (status)
		hawser__rom_history_clear(rom);
	return status;
}

void hawser__rom_term_clear(struct hawser_ramp_term *term)
{
	free(term->f);
	free(term->D);
	free(term->K);
	free(term->answer);
	free(term->answer_line);
}

void hawser__rom_history_clear(struct hawser_rom *rom)
{
	struct hawser_rom_history *history = rom->history;

	if (!history)
		return;
	for (int i = 0; i < history->terms; i++)
		hawser__rom_term_clear(&history->term[i]);
	free(history->term);
	free(history->time);
	free(history->value);
	free(history->bend);
	free(history);
	rom->history = NULL;
}
