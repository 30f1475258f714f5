/* study/hill/hill.c - stability boundaries by continuation.
 *
 *    g       test function of the boundary (hill_track.c)
 *    (p, q)  the parameters scaled to the rectangle, 0 to 1
 *
 * A boundary is followed with g < 0 on its right and g > 0 on its left. A root on the normal
 * through the predicted point is accepted only if g increases to the left. The two sides of a
 * tongue are therefore not exchanged, however near they are.
 *
 * The slope of g across the boundary at the previous point starts a secant iteration, so that a
 * point takes two or three values of g. If it finds no root with the right sign of the slope, a
 * root is bracketed.
 *
 * If a new value of one parameter requires new statics and modes, points are corrected along the
 * other parameter, unless the boundary is nearly parallel to it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/grow.h"
#include "core/names.h"
#include "core/progress.h"
#include "core/report.h"
#include "core/settle.h"
#include "study/hill/hill.h"

#define SMALLEST_STEP 1e-6 /* relative to the rectangle; where a shorter step is needed, the
                            * boundary has a cusp or an end; chosen */
#define TURN 0.15     /* largest angle between successive steps, rad; chosen */
#define SLANT 0.2     /* smallest component of the normal along the cheap parameter for a correction
                       * along it; chosen */
#define SMALL_PART 1e-2 /* first increment for a slope, relative to the reach; chosen */
#define NOISE 1e-10   /* increments below this, relative to the rectangle, give a slope that is
                       * mostly round-off: multipliers have errors of about 1e-10 */
#define LEAST_NOISE 1e-13 /* the same for a determinant, whose round-off is known and smaller */
#define PROBE 1e-8    /* shortest first step of a secant iteration, relative to the rectangle: the
                       * square root of round-off */
#define UNSURE 1e-11  /* error by round-off, relative to the rectangle, above which a boundary ends:
                       * there it merges with another one; chosen */
#define BESIDE 0.05   /* distance on the unstable side, in steps, at which stability is checked;
                       * chosen */
#define BOTH_SIDES 1e-7 /* distance from a point on an edge, relative to the rectangle, at which the
                         * sign of g is taken; chosen */
#define LESS 0.1      /* largest ratio of successive values in a secant iteration that counts as
                       * convergent; chosen */
enum { SECANTS = 12 };
#define APART 1e-3 /* largest round-off relative to the dip between two roots that are told apart;
                    * chosen */
#define FIRST 1e-2  /* distance of the first points, relative to the reach; chosen */
#define SEPARATE 1e-3 /* distance, in steps, below which a point is on a boundary that is already
                       * known; chosen */

void hawser_hill_settle(struct hawser_hill_options *options)
{
	hawser__settle_count(&options->lines, 9);
	hawser__settle_count(&options->samples, 240);
	hawser__settle(&options->step, 0.01);
	hawser__settle(&options->tolerance, 1e-14);
	hawser__settle_count(&options->max_points, (int)fmax(2000.0, fmin(20.0/options->step, 1e9)));
}

HAWSER__NAMES(hawser_hill_kind_name, enum hawser_hill_kind, "plus", "minus", "torus")

int hawser__hill_told_to_stop(const struct hawser_hill_options *options, int boundaries, int points,
                              struct hawser__span *span)
{
	struct hawser_progress_state state;
	char stage[32];

	if (!hawser__is_watched(&options->progress))
		return 0;
	snprintf(stage, sizeof stage, "boundary %d", boundaries + 1);
	state = hawser__progress_state(stage, "points", points, span->began);
	if (span->to > 0.0)
		hawser__span_foretell(span, &state);
	return hawser__told_to_stop(&options->progress, &state);
}

static double value_at(struct hawser__hill *hill, struct hawser__hill_track *track,
                       const double from[2],
                       const double along[2], double s)
{
	const double at[2] = {from[0] + s*along[0], from[1] + s*along[1]};

	return hawser__hill_value(hill, track, at);
}

/* The root of g on from + s*along in a bracket of s. */
double hawser__hill_root(struct hawser__hill *hill, struct hawser__hill_track *track,
                         const double from[2], const double along[2], struct hawser__bracketed in)
{
	for (int i = 0; i < 100 && !hill->status && in.b - in.a > hill->options->tolerance; i++) {
		double s = hawser__false_position(&in, i), g;

		if (s == in.a || s == in.b)
			return s;
		g = value_at(hill, track, from, along, s);
		if (g == 0.0)
			return s;
		if (!isfinite(g))
			return NAN;
		hawser__false_position_take(&in, s, g);
	}
	return 0.5*(in.a + in.b);
}

enum hawser_status hawser__hill_append(struct hawser_hill_boundary *boundary, const double at[2],
                                       struct hawser_report *report)
{
	if (boundary->points == boundary->capacity) {
		int more = boundary->capacity ? 2*boundary->capacity : 64;

		if (hawser__resize(&boundary->at, 2*(size_t)more, sizeof(double)))
			return hawser__no_memory(report, "hill");
		boundary->capacity = more;
	}
	memcpy(boundary->at + 2*(size_t)boundary->points++, at, 2*sizeof *at);
	return HAWSER_OK;
}

/* --- a step --- */

static int inside(const double at[2])
{
	return at[0] >= 0.0 && at[0] <= 1.0 && at[1] >= 0.0 && at[1] <= 1.0;
}

/* The root *s on from + s*along within `reach` at which g increases, by secants; returns 0 if none
 * is found. */
static int secant(struct hawser__hill *hill, struct hawser__hill_track *track, double *s,
                  const double from[2], const double along[2], double reach)
{
	double before = 0.0, g_before = value_at(hill, track, from, along, 0.0), slope = track->rise;
	double now = slope > 0.0 ? -g_before/slope : SMALL_PART*reach, last;
	double least = fabs(g_before);

	if (fabs(now) < PROBE) /* the slope is computed anew, not taken from the previous point */
		now = now < 0.0 ? -PROBE : PROBE;
	last = fabs(now);
	for (int i = 0; i < SECANTS && fabs(now) <= reach && !hill->status; i++) {
		double g = value_at(hill, track, from, along, now), change = 1.0, step, floor;

		if (!isfinite(g))
			return 0;
		floor = track->by == HAWSER__BY_DETERMINANT || track->by == HAWSER__BY_EXTREMUM
		        ? fmax(LEAST_NOISE, slope > 0.0 ? 4.0*track->noise/slope : 0.0) : NOISE;
		if (fabs(now - before) > floor) {
			double next = (g - g_before)/(now - before);

			change = slope > 0.0 ? fmin(1.0, fabs(next/slope - 1.0)) : 1.0;
			slope = next;
		}
		if (!(slope > 0.0))
			return 0;
		step = -g/slope;
		before = now;
		g_before = g;
		now += step;
		/* the next correction would be smaller by the relative change of the slope, or by about the
		 * step itself; or it is round-off */
		if (fabs(now) <= reach && (fabs(g) <= LESS*least || fabs(step) < floor) &&
		    (fabs(step)*fmax(change, fabs(step)) <= hill->options->tolerance ||
		     (fabs(step) < floor && fabs(step) >= 0.5*last))) {
			track->rise = slope;
			*s = now;
			return track->noise <= UNSURE*slope;
		}
		last = fabs(step);
		least = fmin(least, fabs(g));
	}
	return 0;
}

/* The root of the parabola through three points at which it increases, its slope there, and the
 * round-off relative to its dip between two roots; without roots its vertex, and 0. */
static double increasing(double *slope, double *doubt, const double s[3], const double g[3],
                         double noise)
{
	double left = (g[1] - g[0])/(s[1] - s[0]), right = (g[2] - g[1])/(s[2] - s[1]);
	double bend = (right - left)/(s[2] - s[0]);
	double tilt = left + bend*(s[0] - s[1]), square = tilt*tilt - 4.0*bend*g[0];

	/* g = g[0] + tilt (t - s[0]) + bend (t - s[0])^2 */
	*slope = sqrt(fmax(square, 0.0));
	*doubt = square > 0.0 ? fabs(bend)*noise/square : INFINITY;
	return s[0] + (tilt > 0.0 ? -2.0*g[0]/(tilt + *slope) : (*slope - tilt)/(2.0*bend));
}

/* The same in a narrow tongue, whose other side is a root as well, at which g decreases: by the
 * parabola through three points (Muller's method). */
static int beside_other(struct hawser__hill *hill, struct hawser__hill_track *track, double *s,
                        const double from[2], const double along[2], double reach)
{
	double at[3] = {-FIRST*reach, FIRST*reach, 0.0}, g[3], last = INFINITY, slope, doubt;

	for (int k = 0; k < 3; k++)
		g[k] = value_at(hill, track, from, along, at[k]);
	for (int i = 0; i < SECANTS && !hill->status; i++) {
		/* the latest point comes last */
		double next = increasing(&slope, &doubt, (double[]){at[2], at[1], at[0]},
		                         (double[]){g[2], g[1], g[0]}, track->noise);
		double step = fabs(next - at[2]);
		double floor = fmax(track->by == HAWSER__BY_MULTIPLIERS ? NOISE : LEAST_NOISE,
		                    slope > 0.0 ? 4.0*track->noise/slope : 0.0);

		if (!(fabs(next) <= reach))
			return 0;
		if (i > 0 && slope > 0.0 && (step*fmin(1.0, step/last) <= hill->options->tolerance ||
		                    (step < floor && step >= 0.5*last))) {
			track->rise = slope;
			*s = next;
			return track->noise <= UNSURE*slope && doubt < APART;
		}
		last = step;
		memmove(at, at + 1, 2*sizeof *at);
		memmove(g, g + 1, 2*sizeof *g);
		at[2] = next;
		g[2] = value_at(hill, track, from, along, next);
	}
	return 0;
}

/* The same by bracketing with increasing width. */
static int bracketed(struct hawser__hill *hill, struct hawser__hill_track *track, double *s,
                     const double from[2], const double along[2], double reach)
{
	for (double w = fmax(1e-3*reach, 1e-9); w <= reach && !hill->status; w *= 4.0) {
		double low = value_at(hill, track, from, along, -w);
		double high = value_at(hill, track, from, along, w);

		if (!(low < 0.0 && high > 0.0))
			continue;
		*s = hawser__hill_root(hill, track, from, along,
		                       (struct hawser__bracketed){-w, w, low, high, 0});
		track->rise = 0.0;
		return isfinite(*s) && track->noise <= UNSURE*0.5*(high - low)/w && !hill->status;
	}
	return 0;
}

/* The root near `at` at which g increases to the left of `way`, on the normal or along the cheap
 * parameter; returns 0 if there is none within `reach`. */
static int correct(struct hawser__hill *hill, struct hawser__hill_track *track, double at[2],
                   const double way[2], double reach)
{
	double sense = hill->backwards ? -1.0 : 1.0, s;
	double along[2] = {-sense*way[1], sense*way[0]};
	int cheap = hill->field->cheap - 1;

	if (cheap >= 0 && fabs(along[cheap]) > SLANT) {
		along[cheap] = along[cheap] > 0.0 ? 1.0 : -1.0;
		along[1 - cheap] = 0.0;
	}
	track->harmonics = 0;
	if (!hawser__hill_newton(hill, track, &s, at, along, reach) &&
	    !secant(hill, track, &s, at, along, reach) &&
	    !beside_other(hill, track, &s, at, along, reach) &&
	    !bracketed(hill, track, &s, at, along, reach))
		return 0;
	at[0] += s*along[0];
	at[1] += s*along[1];
	return !hill->status;
}

int hawser__hill_real(struct hawser__hill *hill, const struct hawser__hill_track *track,
                      const double at[2], const double way[2], double beside)
{
	struct hawser__hill_worker *worker = hill->worker;
	double sense = hill->backwards ? -1.0 : 1.0;
	const double right[2] = {at[0] + sense*beside*way[1], at[1] - sense*beside*way[0]};

	if (track->kind != HAWSER_HILL_TORUS || track->by != HAWSER__BY_MULTIPLIERS ||
	    !hawser__hill_undamped(worker))
		return 1;
	if (hawser__hill_multipliers(hill, worker, right, 0)) {
		hill->status = worker->status;
		*hill->report = worker->report;
		return 0;
	}
	return hawser__hill_outside(worker) > 0;
}

/* Whether g changes sign at a point of an edge, along axis k. Where two boundaries end at the same
 * point of an edge, g has a double root there, which does not count. */
static int crosses(struct hawser__hill *hill, struct hawser__hill_track *track, const double at[2],
                   int k)
{
	const double along[2] = {k == 0, k == 1};

	return value_at(hill, track, at, along, -BOTH_SIDES)*
	       value_at(hill, track, at, along, BOTH_SIDES) < 0.0;
}

/* The end of the boundary on an edge of the rectangle: the root on the edge near the point at which
 * the step crosses it. Returns 0 if there is none. */
static int finish(struct hawser__hill *hill, struct hawser_hill_boundary *boundary,
                  struct hawser__hill_track *track, const double from[2], const double way[2])
{
	double reach = INFINITY, at[2], out[2] = {0.0, 0.0}; /* where the step leaves the rectangle */
	int side = 0;

	for (int k = 0; k < 2; k++) {
		double s = way[k] > 0.0 ? (1.0 - from[k])/way[k] : way[k] < 0.0 ?
		        -from[k]/way[k] : INFINITY;

		if (s < reach) {
			reach = s;
			side = k;
		}
	}
	if (!(reach > 1e-12))
		return 1;
	for (int k = 0; k < 2; k++)
		at[k] = from[k] + reach*way[k];
	at[side] = way[side] > 0.0 ? 1.0 : 0.0;
	out[side] = way[side] > 0.0 ? 1.0 : -1.0;
	track->rise = track->ahead = 0.0; /* slope along the edge, not across the boundary */
	if (!correct(hill, track, at, out, 0.5*reach) || !crosses(hill, track, at, 1 - side))
		return 0;
	if (inside(at))
		hill->status = hawser__hill_append(boundary, at, hill->report);
	return 1;
}

/* Step from the last point of the boundary in the direction `way`. */
void hawser__hill_follow(struct hawser__hill *hill, struct hawser_hill_boundary *boundary,
                         struct hawser__hill_track *track, double way[2])
{
	double step = 0.3*hill->options->step;
	struct hawser__hill_track keep;

	while (boundary->points < hill->options->max_points && !hill->status && step > SMALLEST_STEP) {
		const double *last = boundary->at + 2*(size_t)(boundary->points - 1);
		double from[2] = {last[0], last[1]}, next[2], turned, length, chord[2];

		next[0] = from[0] + step*way[0];
		next[1] = from[1] + step*way[1];
		if (!inside(next)) {
			if (finish(hill, boundary, track, from, way))
				return;
			step *= 0.5; /* without excitation two boundaries meet there */
			continue;
		}
		keep = *track;
		track->ahead = step*track->turn;
		if (!correct(hill, track, next, way, 0.5*step) ||
		    !hawser__hill_real(hill, track, next, way, BESIDE*step)) {
			*track = keep;
			step *= 0.5;
			continue;
		}
		chord[0] = next[0] - from[0];
		chord[1] = next[1] - from[1];
		length = hypot(chord[0], chord[1]);
		track->turn = (track->lambda[1] - keep.lambda[1])/length;
		turned = acos(fmin(1.0, (chord[0]*way[0] + chord[1]*way[1])/length));
		if (turned > TURN) {
			*track = keep;
			step *= 0.5;
			continue;
		}
		if (!inside(next)) {
			(void)finish(hill, boundary, track, from, way);
			return;
		}
		hill->status = hawser__hill_append(boundary, next, hill->report);
		/* extrapolates the direction: the tangent at the end is the chord turned further by the
		 * same angle */
		for (int k = 0; k < 2; k++)
			way[k] = 2.0*chord[k]/length - way[k];
		length = hypot(way[0], way[1]);
		way[0] /= length;
		way[1] /= length;
		if (turned < 0.3*TURN)
			step = fmin(1.5*step, hill->options->step);
		if (hawser__hill_told_to_stop(hill->options, hill->chart->boundaries, boundary->points,
		                              &hill->span)) {
			hill->chart->interrupted = 1;
			return;
		}
		if (boundary->points > 8 && hypot(next[0] - boundary->at[0],
		                                  next[1] - boundary->at[1]) < 0.6*step)
			return; /* the boundary is closed */
	}
	boundary->limited |= boundary->points >= hill->options->max_points;
}

/* Whether a point lies on a boundary of this kind that is already known: near it, and with the same
 * direction. */
int hawser__hill_known(const struct hawser__hill *hill, int kind, const double at[2],
                       const double way[2])
{
	for (int b = 0; b < hill->chart->boundaries; b++) {
		const struct hawser_hill_boundary *boundary = &hill->chart->boundary[b];

		for (int i = 0; (int)boundary->kind == kind && i + 1 < boundary->points; i++) {
			const double *p = boundary->at + 2*(size_t)i, *q = p + 2;
			double d[2] = {q[0] - p[0], q[1] - p[1]}, r[2] = {at[0] - p[0], at[1] - p[1]};
			double square = d[0]*d[0] + d[1]*d[1], s = (r[0]*d[0] + r[1]*d[1])/square;
			double off = fabs(r[0]*d[1] - r[1]*d[0])/sqrt(square);

			if (s > -1e-3 && s < 1.001 && off < 0.02*sqrt(square) + SEPARATE*hill->options->step &&
			    d[0]*way[0] + d[1]*way[1] > 0.0)
				return 1;
		}
	}
	return 0;
}
