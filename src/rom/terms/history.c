/* rom/terms/history.c - forces with a given history (struct hawser_rom_history).
 *
 *    p(t)    signal: the cubic spline through its values p_i at t_i
 *    M_i     its second derivatives there
 *    h_i     t_(i+1) - t_i
 *    d       its first derivative at an end
 *
 *    h_(i-1) M_(i-1) + 2 (h_(i-1) + h_i) M_i + h_i M_(i+1)
 *        = 6 [(p_(i+1) - p_i)/h_i - (p_i - p_(i-1))/h_(i-1)]
 *    2 h_0 M_0 + h_0 M_1 = 6 [(p_1 - p_0)/h_0 - d], and likewise at the last row
 *
 * d is that of the polynomial through the first or last five rows. The spline with given d is of fourth
 * order (de Boor 1978, chapter V), and d too. Not so that of the usual condition, a continuous third
 * derivative at the second row ("not a knot"): its d is of third order, and with inertia loads by p''
 * an error of d is one of the initial velocity.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include "core/grow.h"
#include "core/order.h"
#include "core/report.h"
#include "rom/terms/ends.h"
#include "rom/energy/exact.h"
#include "rom/terms/history.h"
#include "rom/energy/kernel.h"

static const char where[] = "history";

/* --- the spline --- */

/* d of the polynomial through `count` rows, at row `at` of them. */
static double slope_at(const double *p, const double *t, int count, int at)
{
	double sum = 0.0;

	/* the derivative of Lagrange's polynomials, for differences from the value there */
	for (int i = 0; i < count; i++) {
		double w = 1.0;

		for (int k = 0; k < count; k++)
			if (k != i && k != at)
				w *= (t[at] - t[k])/(t[i] - t[k]);
		if (i != at)
			sum += w*(p[i] - p[at])/(t[i] - t[at]);
	}
	return sum;
}

/* M [rows] of the values p [rows]; work [3 rows]. */
static enum hawser_status bend(double *M, const double *p, const double *t, int rows, double *work,
                               struct hawser_report *report)
{
	enum { NEAR = 5 };
	int near = rows < NEAR ? rows : NEAR, last = rows - 1, info;
	double *low = work, *mid = work + rows, *high = work + 2*rows;
	double first = t[1] - t[0], end = t[last] - t[last - 1];

	mid[0] = 2.0*first;
	M[0] = 6.0*((p[1] - p[0])/first - slope_at(p, t, near, 0));
	mid[last] = 2.0*end;
	M[last] = 6.0*(slope_at(p + rows - near, t + rows - near, near, near - 1) -
	               (p[last] - p[last - 1])/end);
	for (int i = 0; i < last; i++)
		low[i] = high[i] = t[i + 1] - t[i];
	for (int i = 1; i < last; i++) {
		mid[i] = 2.0*(low[i - 1] + high[i]);
		M[i] = 6.0*((p[i + 1] - p[i])/high[i] - (p[i] - p[i - 1])/low[i - 1]);
	}
	info = LAPACKE_dgtsv(LAPACK_COL_MAJOR, rows, 1, low, mid, high, M, rows);
	return !info ? HAWSER_OK : hawser__lapack_starved(info) ? hawser__no_memory(report, where)
	       : hawser__fail(report, HAWSER_ERR_NAN, where, "a value of the history is not finite");
}

double hawser__history_value(const struct hawser_rom_history *history, int number, double t, int rate)
{
	const struct hawser_history_signal *signal = &history->signal[number];
	int i = signal->rows > 0 ? hawser__interval(signal->time, signal->rows - 1, t) : 0;
	const double *p = signal->value + i, *M = signal->bend + i;
	double h, a, b;

	if (signal->rows == 0)
		return 0.0;
	h = signal->time[i + 1] - signal->time[i];
	b = (t - signal->time[i])/h;
	a = 1.0 - b;
	if (rate > 1)
		return rate == 2 ? a*M[0] + b*M[1] : (M[1] - M[0])/h;
	if (rate)
		return (p[1] - p[0])/h + h/6.0*((3.0*b*b - 1.0)*M[1] - (3.0*a*a - 1.0)*M[0]);
	return a*p[0] + b*p[1] + h*h/6.0*((a*a*a - a)*M[0] + (b*b*b - b)*M[1]);
}

double hawser__history_factor(const struct hawser_rom_history *history, int term, double t, int rate)
{
	const struct hawser_history_factor *factor = &history->factor[term];
	double product = 1.0, sum = 0.0;

	if (factor->count == 1)
		return hawser__history_value(history, factor->signal[0], t, factor->rate + rate);
	for (int i = 0; i < factor->count; i++) {
		double value = hawser__history_value(history, factor->signal[i], t, 0);

		if (rate)
			sum = sum*value + product*hawser__history_value(history, factor->signal[i], t, 1);
		product *= value;
	}
	return rate ? sum : product;
}

double hawser__history_spacing(const struct hawser_rom_history *history)
{
	double least = INFINITY;

	for (int k = 0; k < history->signals; k++)
		for (int i = 1; i < history->signal[k].rows; i++)
			least = fmin(least, history->signal[k].time[i] - history->signal[k].time[i - 1]);
	return least;
}

enum hawser_status hawser__history_covers(const struct hawser_rom *rom, double begin, double until,
                                          struct hawser_report *report)
{
	const struct hawser_rom_history *history = rom->history;
	const char *unit = rom->scaled ? " s" : "";
	int moved = !history->moves;

	for (int k = 0; k < history->signals; k++) {
		const struct hawser_history_signal *s = &history->signal[k];

		if (s->rows == 0)
			continue;
		moved |= k < HAWSER_MOTION_SIGNALS;
		if (begin < s->time[0] || until > s->time[s->rows - 1])
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate",
			                    "the run is from t = %.6g to %.6g%s, and the history of the %s from "
			                    "%.6g to %.6g%s: end the run before it, or extend the history",
			                    begin*rom->time, until*rom->time, unit,
			                    history->moves && k < HAWSER_MOTION_SIGNALS ? "ends" : "load",
			                    s->time[0]*rom->time, s->time[s->rows - 1]*rom->time, unit);
	}
	return moved ? HAWSER_OK
	       : hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate",
	                      "the ends of the model move as a table says, which it does not have: give it "
	                      "with hawser_rom_motion_set");
}

/* --- the forces --- */

/* The strain energy without expansion, moved by the ends: as in vary.c. */
static void add_exact(const struct hawser_rom *rom, double *acceleration, double *by_u,
                      const double *u, double t)
{
	double s[HAWSER__SUPPORT_MOST], force[HAWSER_ROM_MAX] = {0.0};
	double T[HAWSER_ROM_MAX*HAWSER_ROM_MAX];
	int n = rom->n;

	for (int i = 0; by_u && i < n*n; i++)
		T[i] = 0.0;
	hawser__ends_at(rom, s, &(struct hawser_rom_moment){.time = t});
	hawser__exact_vary(rom->exact, force, by_u ? T : NULL, u, s);
	for (int j = 0; j < n; j++)
		acceleration[j] -= force[j];
	for (int i = 0; by_u && i < n*n; i++)
		by_u[i] -= T[i];
}

void hawser__rom_history(const struct hawser_rom *rom, double *acceleration, double *by_u,
                         double *by_v, const double *u, const double *v, double t)
{
	const struct hawser_rom_history *history = rom->history;

	if (rom->exact && history->moves)
		add_exact(rom, acceleration, by_u, u, t);
	for (int i = 0; i < history->terms; i++)
		hawser__rom_term(&history->term[i], hawser__history_factor(history, i, t, 0), acceleration,
		                 by_u, by_v, u, v, rom->n);
}

/* --- made and freed --- */

static enum hawser_status check(const struct hawser_rom *const *unit, int terms, int rows,
                                const struct hawser_rom *rom, struct hawser_report *report)
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
	return HAWSER_OK;
}

static enum hawser_status check_rows(const struct hawser_rom *rom, const double *time,
                                     const double *value, int rows, struct hawser_report *report)
{
	for (int i = 0; i < rows; i++) {
		if (!isfinite(time[i]) || (i > 0 && !(time[i] > time[i - 1])))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "the history has the time %g in row %d: times must ascend",
			                    time[i]*rom->time, i + 1);
		if (!isfinite(value[i]))
			return hawser__fail(report, HAWSER_ERR_NAN, where,
			                    "a value in row %d of the history is not finite", i + 1);
	}
	return HAWSER_OK;
}

/* A copy of from [count], or NULL if that is NULL; *failed: there is no memory. */
static double *copied(const double *from, size_t count, int *failed)
{
	double *to = from ? malloc((count + 1)*sizeof *to) : NULL;

	if (to && count > 0)
		memcpy(to, from, count*sizeof *to);
	*failed |= from && !to;
	return to;
}

static void clear_signal(struct hawser_history_signal *signal)
{
	free(signal->time);
	free(signal->value);
	free(signal->bend);
	*signal = (struct hawser_history_signal){.rows = 0};
}

enum hawser_status hawser__history_signal(struct hawser_rom *rom, int number, const double *time,
                                          const double *value, int rows,
                                          struct hawser_report *report)
{
	struct hawser_rom_history *history = rom->history;
	struct hawser_history_signal made = {.rows = rows};
	double *work;
	int failed = 0;
	enum hawser_status status = check_rows(rom, time, value, rows, report);

	if (status)
		return status;
	if (number >= history->signals) {
		if (hawser__resize(&history->signal, (size_t)number + 1, sizeof *history->signal))
			return hawser__no_memory(report, where);
		while (history->signals <= number)
			history->signal[history->signals++] = (struct hawser_history_signal){.rows = 0};
	}
	made.time = copied(time, (size_t)rows, &failed);
	made.value = copied(value, (size_t)rows, &failed);
	made.bend = malloc((size_t)rows*sizeof *made.bend);
	work = malloc(3*(size_t)rows*sizeof *work);
	status = failed || !made.bend || !work ? hawser__no_memory(report, where)
	         : bend(made.bend, value, time, rows, work, report);
	free(work);
	if (status) {
		clear_signal(&made);
		return status;
	}
	clear_signal(&history->signal[number]);
	history->signal[number] = made;
	return HAWSER_OK;
}

struct hawser_ramp_term *hawser__history_term(struct hawser_rom *rom,
                                              const struct hawser_history_factor *factor)
{
	struct hawser_rom_history *history = rom->history;
	size_t count = (size_t)history->terms + 1;
	struct hawser_ramp_term *term;

	if (hawser__resize(&history->term, count, sizeof *history->term) ||
	    hawser__resize(&history->factor, count, sizeof *history->factor))
		return NULL;
	history->factor[history->terms] = *factor;
	term = history->term + history->terms++;
	*term = (struct hawser_ramp_term){.quads = 0};
	return term;
}

static enum hawser_status add_unit(struct hawser_rom *rom, const struct hawser_rom *unit, int number,
                                   struct hawser_report *report)
{
	const struct hawser_harmonic *from = unit->harmonic;
	struct hawser_ramp_term *term = hawser__history_term(rom, &(struct hawser_history_factor){
		1, {number}, 0});
	size_t n = (size_t)unit->n;
	int failed = !term;

	if (failed)
		return hawser__no_memory(report, where);
	term->f = copied(from->f, n, &failed);
	term->D = copied(from->D, n*n, &failed);
	term->K = copied(from->K, n*n, &failed);
	/* the static part: a history has no frequency of which the correction could be */
	term->answer = copied(from->answer, 4*(size_t)unit->shapes.points, &failed);
	term->answer_line = copied(from->answer_line, (size_t)unit->line.points, &failed);
	return failed ? hawser__no_memory(report, where) : HAWSER_OK;
}

enum hawser_status hawser_rom_history_set(struct hawser_rom *rom,
                                          const struct hawser_rom *const *unit, int terms,
                                          const double *time, const double *value, int rows,
                                          struct hawser_report *report)
{
	enum hawser_status status = check(unit, terms, rows, rom, report);
	int first;

	if (status)
		return status;
	if (!rom->history)
		rom->history = calloc(1, sizeof *rom->history);
	if (!rom->history)
		return hawser__no_memory(report, where);
	first = rom->history->moves ? HAWSER_MOTION_SIGNALS : 0;
	hawser__history_cut(rom->history, rom->history->motions, first);
	for (int i = 0; i < terms && !status; i++) {
		status = hawser__history_signal(rom, first + i, time, value + (size_t)i*(size_t)rows, rows,
		                                report);
		if (!status)
			status = add_unit(rom, unit[i], first + i, report);
	}
	if (status)
		hawser__history_cut(rom->history, rom->history->motions, first);
	if (status && !rom->history->moves)
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
	free(term->Q);
}

void hawser__history_cut(struct hawser_rom_history *history, int terms, int signals)
{
	while (history->terms > terms)
		hawser__rom_term_clear(&history->term[--history->terms]);
	while (history->signals > signals)
		clear_signal(&history->signal[--history->signals]);
}

void hawser__rom_history_clear(struct hawser_rom *rom)
{
	struct hawser_rom_history *history = rom->history;

	if (!history)
		return;
	hawser__history_cut(history, 0, 0);
	free(history->term);
	free(history->factor);
	free(history->signal);
	free(history);
	rom->history = NULL;
}
