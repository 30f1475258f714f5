/* ropeway/statics/given.c - the tension at end A that belongs to what is given, and
 * hawser_line_solve().
 *
 * The march needs the tension P at A. Given the tension at B, or the unstretched length, one
 * equation in ln P is left: T_B grows with P, but for places that scan() looks at, and the length
 * falls. It is solved by secant steps in a bracket. A rope that is longer than at the least
 * tension hangs slack in one span, that in which the tension was too low; there the length grows
 * with P.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "ropeway/statics/line.h"

static const char where[] = "line";
enum { ROUNDS = 300 };

void hawser__line_release(struct hawser_line_statics *st)
{
	free(st->piece);
	free(st->contact);
	free(st->carrier);
}

/* Lay the rope, beginning with the set of sheaves that was kept. */
static int lay_near(struct hawser__march *march, double P)
{
	memcpy(march->off, march->kept, (size_t)march->sheaves);
	for (int round = 0; round <= 2*march->sheaves; round++) {
		int worst;

		if (hawser__march(march, P)) {
			worst = hawser__march_clearances(march);
			if (worst < 0)
				return march->slack_behind < 0 || !march->off[march->slack_behind];
			march->off[worst] = 0;
		} else if (march->fault == HAWSER__FAULT_LOST) {
			march->off[march->to] = 1;
		} else {
			return 0;
		}
	}
	return 0;
}

/* Lay the rope, with the sheaves that it presses. 1: done; 0: march->fault says why not. */
static int lay(struct hawser__march *march, double P)
{
	if (march->slack_behind >= -1)
		return lay_near(march, P);
	memset(march->off, 0, (size_t)march->sheaves);
	if (hawser__march(march, P) && hawser__march_clearances(march) < 0)
		return 1;
	if (march->fault == HAWSER__FAULT_TOO_LOW || !hawser__march_ahead(march, P))
		return 0;
	if (hawser__march_clearances(march) < 0)
		return 1;
	march->fault = HAWSER__FAULT_LOST;
	return 0;
}

/* What is given, as the march has it, less the given value, over it; grows with P where the
 * rope is taut. */
static double excess(const struct hawser__march *march, double value)
{
	if (march->line->given == HAWSER_LINE_T_B)
		return hypot(march->end.P[0], march->end.P[1])/value - 1.0;
	return 1.0 - march->end.S/value;
}

/* A tension of the right size. */
static double first_guess(const struct hawser__march *march, double value)
{
	const struct hawser_line *line = march->line;
	double from[2] = {line->A[0], line->A[1]};
	double length = 0.0, sag = 0.0, weight = march->rope.w*value, stretched, P;

	if (line->given == HAWSER_LINE_T_B)
		return fmax(value - march->rope.w*(line->B[1] - line->A[1]), 1e-3*value);
	for (int i = 0; i < line->masses; i++)
		weight += march->rope.weight[i];
	for (int k = 0; k <= line->sheaves; k++) {
		double to[2] = {march->target[k].c[0], march->target[k].c[1] +
		                march->target[k].side*march->target[k].R};
		double dx = to[0] - from[0], chord = hypot(dx, to[1] - from[1]), part;

		part = weight/value*chord;
		length += chord;
		sag += part*part*dx/24.0*dx/chord;
		memcpy(from, to, sizeof from);
	}
	/* value (1 + P/EA) = length + sag/P^2 */
	stretched = isfinite(line->EA) ? fmax(line->EA*(length/value - 1.0), 0.0) : 0.0;
	P = sqrt(sag/fmax(value - length, 1e-9*value));
	if (isfinite(line->EA) && line->EA*1e-9 < P && value < length*(1.0 + 1e-3))
		for (int i = 0; i < 60; i++) {
			double miss = value*(1.0 + P/line->EA) - length - sag/(P*P);
			double step = miss/(value/line->EA + 2.0*sag/(P*P*P));

			P = fmax(P - step, 0.1*P);
		}
	return fmax(fmax(P, stretched), 1e-6*weight);
}

struct bracket {
	double lo, hi;         /* P; 0 and INFINITY while open */
	double f, f_hi;     /* NAN: not known */
};

/* Next P: a secant step between the ends, or between the last two places. */
static double next_of(const struct bracket *b, double P, double f, double P1, double f1)
{
	double x = log(P), step = NAN, next;

	if (isfinite(f) && isfinite(f1) && f != f1)
		step = -f*(x - log(P1))/(f - f1);
	if (!(b->lo > 0.0) || !(b->hi < INFINITY)) {
		double limit = isfinite(step) ? fmax(-2.0, fmin(2.0, step)) : b->lo > 0.0 ? 0.7 : -0.7;

		next = exp(x + limit);
		return next > b->lo && next < b->hi ? next : b->lo > 0.0 ? 2.0*b->lo : 0.5*b->hi;
	}
	next = exp(x + step);
	if (next > b->lo && next < b->hi)
		return next;
	return b->hi/b->lo < 1.0 + 1e-9 ? b->lo + (b->hi - b->lo)/2.0 : sqrt(b->lo)*sqrt(b->hi);
}

/* The rope is slack in one span: its length grows with P from the least tension on. */
static int slacken(struct hawser__march *march, double value, double lo, double P)
{
	struct bracket b = {lo, INFINITY, NAN, NAN};
	double P1 = P, f1 = NAN;

	for (int round = 0; round < ROUNDS; round++) {
		double f = lay(march, P) ? -excess(march, value) : NAN, next;

		if (fabs(f) <= 4.0*DBL_EPSILON)
			return 1;
		if (f > 0.0)
			b.hi = P;
		else
			b.lo = P;
		next = next_of(&b, P, f, P1, f1);
		P1 = P;
		f1 = f;
		if (!(next > b.lo && next < b.hi) || !(next < 1e30*lo))
			break;
		P = next;
	}
	return b.hi < INFINITY && lay(march, b.hi) && fabs(excess(march, value)) <= 1e-9;
}

/* The span in which the rope gets slack at the least tension, at a P just above it: both ropes that
 * belong to P, the taut one and that with this span slack, are of nearly the same length there. -2:
 * none. */
static int slack_span(struct hawser__march *march, double value, double P, double taut)
{
	double least = INFINITY;
	int best = -2;

	memcpy(march->kept, march->off, (size_t)march->sheaves);
	for (int k = -1; k < march->sheaves; k++) {
		double gap;

		march->slack_behind = k;
		if (!lay(march, P))
			continue;
		gap = fabs(taut - excess(march, value));
		if (gap < least) {
			least = gap;
			best = k;
		}
	}
	march->slack_behind = -2;
	return best;
}

/* Lay the rope of the given length with one span slack, if the length is above those of both ropes
 * that belong to P, which is just above the least tension `lo`. */
static int slack(struct hawser__march *march, double value, double lo, double P, double taut)
{
	march->slack_behind = slack_span(march, value, P, taut);
	if (march->slack_behind >= -1 && lay(march, P) && excess(march, value) >= 0.0 &&
	    slacken(march, value, lo, P))
		return 1;
	march->slack_behind = -2;
	return 0;
}

/* How near the least tension P has to be, over it, before slack ropes are tried. */
static const double near = 1e-2;

/* Factor from one P to the next that `scan` looks at, and how many: up to 1.02^700 = 1e6 times the
 * first. The change of sign that it is for is between the least tension and twice that. */
static const double ratio = 1.02;
enum { SCANNED = 700 };

/* T_B falls with P where more tension brings a mass, or friction, before another sheave: then the
 * bracket from above misses a place where it is met. Look for it from P on upwards. */
static int scan(struct hawser__march *march, double value, double P)
{
	double lo = NAN, hi = P, f = NAN;

	for (int i = 0; i < SCANNED && !(f < 0.0); i++) {
		lo = hi;
		hi = lo*ratio;
		f = lay(march, hi) ? excess(march, value) : NAN;
		if (isnan(f) && march->fault != HAWSER__FAULT_TOO_LOW)
			return 0;
	}
	if (!(f < 0.0))
		return 0;
	for (int i = 0; i < 100; i++) { /* f(lo) >= 0 > f(hi) */
		double middle = lo + (hi - lo)/2.0;

		if (!(middle > lo && middle < hi))
			break;
		f = lay(march, middle) ? excess(march, value) : NAN;
		if (fabs(f) <= 4.0*DBL_EPSILON)
			return 1;
		if (f < 0.0)
			hi = middle;
		else
			lo = middle;
	}
	return lay(march, hi) && fabs(excess(march, value)) <= 1e-9;
}

static int search(struct hawser__march *march, double value, double *least)
{
	struct bracket b = {0.0, INFINITY, NAN, NAN};
	double P = first_guess(march, value), P1 = NAN, f1 = NAN, best = NAN, best_P = P;
	int too_low = 0, slack_known = march->line->given == HAWSER_LINE_LENGTH0;

	*least = NAN;
	for (int round = 0; round < ROUNDS; round++) {
		int laid = lay(march, P);
		double f = laid ? excess(march, value) : NAN, next;

		if (!laid && march->fault != HAWSER__FAULT_TOO_LOW)
			return 0;
		if (fabs(f) <= 4.0*DBL_EPSILON)
			return 1;
		if (!laid)
			too_low = 1;
		if (f > 0.0)
			b.hi = P;
		else
			b.lo = P;
		if (!(fabs(f) > best) && laid) {
			best = fabs(f);
			best_P = P;
		}
		if (f > 0.0 && too_low)
			*least = P;
		if (f > 0.0 && slack_known && b.hi < (1.0 + (too_low ? near : 1e-6))*b.lo &&
		    slack(march, value, b.lo, P, f))
			return 1;
		next = next_of(&b, P, f, P1, f1);
		P1 = P;
		f1 = f;
		if (!(next > b.lo && next < b.hi && next < 1e300 && next > 1e-300))
			break;
		P = next;
	}
	if (best <= 1e-9)
		return lay(march, best_P);
	if (march->line->given == HAWSER_LINE_T_B && isfinite(*least) && scan(march, value, *least))
		return 1;
	march->fault = HAWSER__NO_FAULT;
	return 0;
}

/* The least P that is high enough, between a P that is not and one that is. */
static double least_of(struct hawser__march *march, double lo)
{
	double hi = 2.0*lo;

	while (hi < 1e30*lo && !lay(march, hi))
		hi *= 2.0;
	for (int i = 0; i < 60 && hi - lo > 1e-12*hi; i++) {
		double P = lo + (hi - lo)/2.0;

		if (lay(march, P))
			hi = P;
		else
			lo = P;
	}
	return hi;
}

static enum hawser_status too_low(struct hawser__march *march, double P, struct hawser_report *report)
{
	const struct hawser_line *line = march->line;
	char from[HAWSER__LINE_CALLED], to[HAWSER__LINE_CALLED];
	double least;

	hawser__line_name(from, line, march->from);
	hawser__line_name(to, line, march->to);
	least = (least_of(march, P) + march->rope.thrust)*march->rope.stretch;
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
	                    "the tension is too low: behind %s the rope sags so much that it does not "
	                    "come down to %s. "
	                    "The tension at end A has to be at least %.10g N", from, to, least);
}

/* With lift 0 each sheave has to be pressed. */
static enum hawser_status check_lift(const struct hawser__march *march, struct hawser_report *report)
{
	const struct hawser_line *line = march->line;
	char name[HAWSER__LINE_CALLED];
	int first = -1, count = 0;

	for (int k = 0; k < line->sheaves; k++) {
		count += march->off[k];
		if (first < 0 && march->off[k])
			first = k;
	}
	if (line->lift || !count)
		return HAWSER_OK;
	hawser__line_name(name, line, first);
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
	                    "the rope lifts off %s at (%g, %g) m: in equilibrium it passes %.6g m %s it "
	                    "(%d of %d "
	                    "sheaves without contact). Move the sheave, or change the tension", name,
	                    line->sheave[first].centre[0], line->sheave[first].centre[1],
	                    march->trace.st->contact[first].clearance,
	                    line->sheave[first].side > 0 ? "above" : "below", count, line->sheaves);
}

static enum hawser_status fail(struct hawser__march *march, double P, double least,
                               struct hawser_report *report)
{
	const struct hawser_line *line = march->line;
	char from[HAWSER__LINE_CALLED];

	if (march->fault == HAWSER__FAULT_TOO_LOW)
		return too_low(march, P, report);
	if (march->fault == HAWSER__FAULT_LOST)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, where, march->iterations, 0.0,
		                       "the sheaves that the rope presses were not found (behind %s)",
		                       hawser__line_name(from, line, march->from));
	if (line->given == HAWSER_LINE_T_B && isfinite(least))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "the tension of %g N at end B is too low: end A would need less than the "
		                    "least "
		                    "tension there, %.10g N", line->value,
		                    (least + march->rope.thrust)*march->rope.stretch);
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, where, march->iterations, 0.0,
	                       "no tension at end A belongs to %s %g %s", line->given == HAWSER_LINE_T_B
	                       ? "the tension at end B of" : "the unstretched length of", line->value,
	                       line->given == HAWSER_LINE_T_B ? "N" : "m");
}

static enum hawser_status solve(struct hawser__march *march, struct hawser_report *report)
{
	const struct hawser_line *line = march->line;
	double value = line->value, least = NAN;
	int done;

	if (line->given == HAWSER_LINE_LENGTH0) {
		value *= march->rope.stretch;
	} else {
		value = value/march->rope.stretch - march->rope.thrust;
		if (!(value > 0.0))
			return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
			                    "a rope that runs at %g m/s needs a tension above rho*speed^2 = %g N, "
			                    "and %g N is "
			                    "given", line->speed, march->rope.thrust*march->rope.stretch,
			                    line->value);
	}
	done = line->given == HAWSER_LINE_T_A ? lay(march, value) : search(march, value, &least);
	if (!done)
		return fail(march, value, least, report);
	return HAWSER_OK;
}

enum hawser_status hawser_line_solve(struct hawser_line_statics *st, const struct hawser_line *line,
                                     struct hawser_report *report)
{
	struct hawser__march march = {0};
	enum hawser_status status = hawser__line_check(line, report);

	memset(st, 0, sizeof *st);
	if (status)
		return status;
	status = hawser__march_open(&march, st, line, report);
	if (!status)
		status = solve(&march, report);
	if (!status)
		status = check_lift(&march, report);
	if (!status) {
		hawser__line_finish(st, &march);
		if (!isfinite(st->T_B) || !isfinite(st->length) || !isfinite(st->closure) ||
		    !isfinite(st->balance))
			status = hawser__fail(report, HAWSER_ERR_NAN, where,
			                      "the solution of the line is not a number (tension at end B %g N, "
			                      "length %g "
			                      "m)", st->T_B, st->length);
	}
	if (status)
		hawser_line_statics_clear(st);
	hawser__march_clear(&march);
	return status;
}
