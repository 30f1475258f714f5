/* rom/energy/law_range.c - amplitude up to which each mode of a model is right.
 *
 *   e(a)      relative error of the model's force at the displacement a, at rest or of inertia or
 *             damping in a motion of this amplitude, the larger one of both directions; INFINITY if the
 *             model has no equilibrium
 *   low       e(low) <= LIMIT, 0 at first;  high  e(high) > LIMIT, or the cable is slack there
 *
 * e grows with a power of a, which two errors give, so that interpolation in the logarithms of both
 * finds e = LIMIT in a few steps; where e is not finite, the interval is halved. The first guess is
 * the largest amplitude, where most models of taut cables are right, and then twice the range of the
 * mode before, since ranges fall with the frequency.
 * What is found with one basis is confirmed with the next one, or sought again with that.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/label.h"
#include "rom/energy/law.h"

#define LIMIT HAWSER_LAW_LIMIT
#define LESS 0.25    /* factor on the amplitude until an error is below the limit; chosen */
#define MORE 2.0     /* the same until it is above; chosen */
#define CLOSE 1.03   /* high/low at the end: the range is known to 3 %; chosen */
#define SURE 0.2     /* part of the limit that the exact law may move with a larger basis; chosen */
#define LEAST 1e-6   /* smallest amplitude that is tried, of the largest one; chosen */
enum { TRIES = 40,   /* more than the intervals above allow */
       DIGITS = 3 };

/* Largest displacement of mode j along the cable: its square at the points of the grid, and near the
 * largest one a parabola, since the points are off the true largest by up to half their distance. */
static double largest(const struct hawser_modes *modes, int j)
{
	int points = modes->grid.points, at = 0;
	const double *shape = modes->shape + (size_t)j*(size_t)points*3, *s = modes->grid.s;
	double y[3], left, right, slope, bend;

#define SQUARE(p) (pow(shape[3*(p)], 2) + pow(shape[3*(p) + 1], 2) + pow(shape[3*(p) + 2], 2))
	for (int p = 1; p < points; p++)
		at = SQUARE(p) > SQUARE(at) ? p : at;
	if (at == 0 || at == points - 1)
		return sqrt(SQUARE(at));
	for (int k = 0; k < 3; k++)
		y[k] = SQUARE(at - 1 + k);
#undef SQUARE
	left = (y[1] - y[0])/(s[at] - s[at - 1]);
	right = (y[2] - y[1])/(s[at + 1] - s[at]);
	bend = (right - left)/(s[at + 1] - s[at - 1]);
	slope = left + bend*(s[at] - s[at - 1]);
	return sqrt(bend < 0.0 ? y[1] - slope*slope/(4.0*bend) : y[1]);
}

/* Largest stroke of an absorber: where one moves by itself, the cable hardly does. */
static double stroke(const struct hawser_modes *modes, int j)
{
	double most = 0.0;

	for (int i = 0; modes->stroke && i < modes->statics.attachments; i++)
		most = fmax(most, fabs(hawser__stroke(modes, j, i)));
	return most;
}

enum hawser_status hawser__range_make(struct hawser_rom *rom, const struct hawser_modes *modes,
                                      struct hawser_report *report)
{
	rom->range = calloc((size_t)rom->n, sizeof *rom->range);
	if (!rom->range)
		return hawser__no_memory(report, "rom");
	for (int j = 0; j < rom->n; j++)
		if (modes->mode[j].number > 0)
			rom->range[j].largest = rom->length*fmax(largest(modes, j), stroke(modes, j));
	return HAWSER_OK;
}

/* One amplitude tried. */
struct trial {
	double a, error, exact; /* exact: law in the direction of the larger error */
	int sign;               /* of that direction */
	enum hawser_law_end end;
};

/* A peak is lower by what is dissipated more, and by what the frequency falls. */
static double error_of(const struct hawser_law_point *point)
{
	if (point->end == HAWSER_LAW_NO_MODEL)
		return INFINITY;
	return fmax(fabs(point->model - point->exact)/fmax(fabs(1.0 + point->exact), 1.0),
	            fmax(point->inertia, point->damping + 0.5*point->inertia));
}

static struct trial try(struct hawser__law *law, double a)
{
	struct trial worst = {.a = a, .error = -1.0};

	for (int sign = 1; sign >= (hawser__law_even(law) ? 1 : -1); sign -= 2) {
		struct hawser_law_point point = {.amplitude = sign*a};
		double error;

		hawser__law_at(law, &point);
		error = error_of(&point);
		if (point.end == HAWSER_LAW_SLACK || point.end == HAWSER_LAW_NO_EXACT)
			return (struct trial){.a = a, .error = NAN, .sign = sign, .end = point.end};
		if (error > worst.error)
			worst = (struct trial){a, error, point.exact, sign, point.end};
	}
	return worst;
}

static int within(const struct trial *trial)
{
	return trial->error <= LIMIT; /* not if it is no number */
}

/* The next amplitude between two tried ones. */
static double between(const struct trial *low, const struct trial *high)
{
	double middle = 0.5*(log(low->a) + log(high->a)), width = log(high->a/low->a), at;

	if (!isfinite(high->error) || !(low->error > 0.0))
		return exp(middle);
	at = log(low->a) + width*log(LIMIT/low->error)/log(high->error/low->error);
	/* off the crossing by less than the width that ends the search, so that both sides close in */
	at += at < middle ? 0.4*log(CLOSE) : -0.4*log(CLOSE);
	return exp(fmin(fmax(at, log(low->a) + 0.05*width), log(high->a) - 0.05*width));
}

/* The range up to `most`, with the present basis, from a guess on: *low is the last trial within the
 * limit. */
static struct trial search(struct trial *low, struct hawser__law *law, double most, double guess)
{
	struct trial next = try(law, guess), high = next;

	*low = within(&next) ? next : (struct trial){.a = 0.0};
	while (within(&high) && high.a < most) {
		*low = high;
		high = try(law, fmin(MORE*high.a, most));
	}
	while (low->a == 0.0 && high.a > LEAST*most) {
		next = try(law, LESS*high.a);
		*(within(&next) ? low : &high) = next;
	}
	for (int i = 0; !within(&high) && low->a > 0.0 && high.a > CLOSE*low->a && i < TRIES; i++) {
		next = try(law, between(low, &high));
		*(within(&next) ? low : &high) = next;
	}
	if (within(&high))
		*low = high;
	return high;
}

/* 1: a larger basis gives the same exact law at the end of the range. */
static int confirmed(struct hawser__law *law, const struct trial *low)
{
	struct hawser_law_point point = {.u = low->sign*low->a/law->rom->range[law->j].largest};

	hawser__law_exact(law, &point);
	return point.end == HAWSER_LAW_FOUND &&
	       fabs(point.exact - low->exact) <= SURE*LIMIT*fmax(fabs(1.0 + point.exact), 1.0);
}

static enum hawser_range_end end_of(const struct trial *low, const struct trial *high)
{
	if (low->a == 0.0)
		return HAWSER_RANGE_UNKNOWN;
	if (high->end == HAWSER_LAW_SLACK)
		return HAWSER_RANGE_SLACK;
	return within(high) || high->end == HAWSER_LAW_NO_EXACT ? HAWSER_RANGE_AT_LEAST
	                                                         : HAWSER_RANGE_FORCE;
}

/* Two laws that share nothing but the cable agree well: no larger basis is needed. */
static int clear_of_limit(const struct trial *high)
{
	return within(high) && high->error < SURE*LIMIT;
}

/* Down to DIGITS significant digits, so that round-off, which is that of the processor, is not told. */
static double rounded(double a)
{
	double unit = pow(10.0, floor(log10(a)) - (DIGITS - 1));

	return unit*floor(a/unit);
}

static enum hawser_status find(struct hawser_rom_range *range, struct hawser__law *law, int j,
                               double most, double guess, struct hawser_report *report)
{
	struct trial low = {.a = 0.0}, high = low;
	enum hawser_status status;
	int found;

	status = hawser__law_hold(law, &found, j, 0, report);
	if (status || !found)
		return status;
	high = search(&low, law, most, guess);
	while (low.a > 0.0 && !clear_of_limit(&high) && law->basis + 1 < HAWSER__LAW_BASES) {
		status = hawser__law_hold(law, &found, j, law->basis + 1, report);
		if (status || !found || confirmed(law, &low))
			break;
		high = search(&low, law, most, low.a);
	}
	range->end = found ? end_of(&low, &high) : HAWSER_RANGE_UNKNOWN;
	range->amplitude = range->end ? low.a : 0.0;
	if (range->end == HAWSER_RANGE_FORCE || range->end == HAWSER_RANGE_SLACK)
		range->amplitude = rounded(low.a);
	return status;
}

enum hawser_status hawser_law_range(struct hawser_rom *rom, const struct hawser_statics *statics,
                                    const double *reached, struct hawser_report *report)
{
	double most = fmax(0.5*statics->sag, 0.05*statics->span.d), guess = most;
	struct hawser__law law;
	enum hawser_status status = hawser__law_open(&law, rom, statics, report);

	for (int j = 0; !status && j < rom->n; j++) {
		struct hawser_rom_range *range = &rom->range[j];

		range->amplitude = 0.0;
		range->end = HAWSER_RANGE_UNKNOWN;
		if (reached)
			most = fabs(reached[j])*range->largest;
		if (most > 0.0 && hawser__law_is_mode(rom, j))
			status = find(range, &law, j, most, reached ? most : fmin(guess, most), report);
		if (range->end)
			guess = MORE*range->amplitude;
	}
	hawser__law_close(&law);
	return status;
}

int hawser_law_exceeded(const struct hawser_rom *rom, const double *reached)
{
	double worst = 1.0;
	int which = -1;

	for (int j = 0; rom->range && j < rom->n; j++) {
		const struct hawser_rom_range *range = &rom->range[j];
		double times = fabs(reached[j])*range->largest/range->amplitude;

		if (range->end != HAWSER_RANGE_FORCE || !(times > worst))
			continue;
		worst = times;
		which = j;
	}
	return which;
}
