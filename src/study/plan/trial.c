/* study/plan/trial.c - the cost of a response, from a part of it that is computed.
 *
 *    t   processor time of a point of the run: median of the last ones
 *    c   the same of a coarse trace
 *    e   processor time of locating an event, in points
 *
 * The number of points of a response and the time of a point depend on its folds, on the number of
 * harmonics or steps of its orbits, on events, and on repeated steps. No formula predicts them.
 * Therefore the response itself is started, with the same model, method, tolerance and steps. If it
 * ends within the time allowed, its time is measured. Otherwise it is interrupted, and the rest of
 * the curve, from the last point on, is traced coarsely: with the tolerance `coarse_tolerance`, and
 * without locating events. The coarse trace has the same number of points, since the step control
 * depends on the curve and not on the tolerance. Its time, multiplied by t/c, is that of the rest
 * of the run. Events are recognised by changes of the number of unstable multipliers and of the
 * direction; each adds e points.
 *
 * If the coarse trace is interrupted as well, the rest is estimated by a formula for the number of
 * points. This requires that the curve is stable and not past a fold at the interruption, and that
 * no resonance in the rest bends far or is in resonance with another mode. Otherwise a curve may
 * have up to 26 times as many points as the formula predicts (bench/plan-times), and no estimate is
 * made. A lower bound is stated instead: the traced points, and the points that the longest step
 * requires for the rest, each with the smallest time of a point so far.
 *
 * The median is used since some of the points include the time of events or of repeated steps,
 * which is counted separately.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "study/plan/trial.h"

enum { RECENT = sizeof((struct hawser__trial *)0)->recent/sizeof(double) };
enum { ENOUGH = 16 };     /* number of points whose median is the time of a point; chosen */
enum { WARM = 4 };        /* first points of a trace, which are not counted: no derivatives are
                           * known there */
enum { FEWEST = 12, LEAST = 4 }; /* points of a curve before it is interrupted, if they take less
                                  * than */
static const double patience_secs = 0.3; /* this time and more is allowed to the row; and otherwise;
                                          * all chosen */
static const double longest_beginning_secs = 3.0; /* but no more than this; chosen */
/* Time of a coarse trace if otherwise only a bound could be stated; chosen. */
static const double hard_secs = 1.0;
/* With a tolerance of 1e-4 the trace leaves the branch of the chairlift with 10 coordinates. With
 * 1e-5 it has 254 points instead of 224, with this one 229. */
static const double coarse_tolerance = 1e-6;
/* Points that an event costs: measured 2.7 s for 15 events, with 6.6 ms per point (the same span,
 * harmonic balance). Shooting needs fewer orbits to locate an event, since its multipliers are
 * exact. */
static const double event_balance = 27.0, event_shooting = 12.0;
static const double largest_ratio = 30.0;
/* With more events, the coarse trace may change to another branch than the run (in one scene it had
 * 20000 points instead of 650). Its cost without events is then stated as a lower bound. */
enum { many_events = 6 };

void hawser__trial_begin(struct hawser__trial *trial, struct hawser__allowance *allowance,
                         const struct hawser_frf_options *options, double expected)
{
	double now = hawser__processor_seconds();

	*trial = (struct hawser__trial){
		.options = options, .expected = expected, .start = now, .part = 0.5,
		.end = now + fmax(0.0, allowance->left)/(allowance->rows > 0 ? allowance->rows : 1),
		.share = allowance->share, .most = fmin(allowance->most, fmax(0.0, allowance->extra))};
}

void hawser__trial_end(const struct hawser__trial *trial, struct hawser__allowance *allowance)
{
	double took = hawser__processor_seconds() - trial->start, own = trial->end - trial->start;

	/* time beyond the row's own share was granted from its estimated time, and is not taken from
	 * other rows */
	allowance->left -= fmin(took, own);
	allowance->extra -= fmax(0.0, took - own);
	allowance->rows--;
}

/* Whether the time is over at `now`, if the estimate of the row is `seconds` so far. part: fraction
 * of the time allowed; least: lower limit of it. */
static int is_over(const struct hawser__trial *trial, double now, double seconds, double part,
                   double least)
{
	double allowed = fmax(trial->end - trial->start,
	                      fmin(fmax(least, trial->share*seconds), trial->most));

	return now - trial->start > part*allowed;
}

static int ascending(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

static double median(const double *recent, int count)
{
	double sorted[RECENT];
	int warm = count < RECENT ? count/2 < WARM ? count/2 : WARM : 0;

	if (count < 1)
		return NAN;
	count -= warm;
	memcpy(sorted, recent + warm, (size_t)count*sizeof *sorted);
	qsort(sorted, (size_t)count, sizeof *sorted, ascending);
	return 0.5*(sorted[count/2] + sorted[(count - 1)/2]);
}

double hawser__trial_point(const struct hawser__trial *trial)
{
	int count = trial->points - 1;

	return median(trial->recent, count < RECENT ? count : RECENT);
}

/* Whether it is the response, and not a window about a peak that is traced again. */
static int is_response(const struct hawser__trial *trial, const struct hawser_frf *frf)
{
	return fabs(frf->point[0].omega/trial->options->from - 1.0) < 1e-9;
}

static void note_point(struct hawser__trial *trial, const struct hawser_frf *frf, double now)
{
	if (frf->points == 0 || !is_response(trial, frf))
		return;
	if (frf->points == 1 || frf->points < trial->points) {
		trial->before = trial->points;
		trial->curve++;
		trial->began = now;
	} else if (frf->points > trial->points) {
		trial->recent[(frf->points - 2)%RECENT] = now - trial->last;
	}
	trial->points = frf->points;
	trial->last = now;
}

int hawser__trial_watch(void *data, const struct hawser_progress_state *state)
{
	struct hawser__trial *trial = data;
	double now = hawser__processor_seconds(), points, seconds;

	if (trial->stopped) /* after an interruption, no further curve is started */
		return 1;
	note_point(trial, state->frf, now);
	if (trial->points < LEAST || (trial->points < FEWEST && now - trial->began < patience_secs &&
	                              (trial->most > 0.0 || now < trial->end))) {
		trial->stopped = now - trial->start > longest_beginning_secs;
		return trial->stopped;
	}
	points = fmax(trial->before > 0 ? trial->before : trial->expected, trial->points);
	seconds = trial->began - trial->start + (now - trial->began)*points/trial->points;
	trial->stopped = is_over(trial, now, seconds, trial->part, 0.0);
	return trial->stopped;
}

/* --- the coarse trace --- */

struct coarse {
	struct hawser__trial *trial;
	const struct hawser__trial_cost *before;
	double point;      /* time of a point of the run */
	double per_event;  /* s */
	double began, last, early[ENOUGH];
	int points;        /* number of points so far, */
	int events;        /* number of events among them */
	int slack;
	const struct hawser__outlook *outlook;
	double from, to;
	int hard;          /* 1: the last point is on an unstable part or past a fold */
};

static int is_event(const struct hawser_frf_point *a, const struct hawser_frf_point *b)
{
	return a->unstable != b->unstable || a->direction != b->direction;
}

static double ratio(const struct coarse *coarse)
{
	int count = coarse->points - 1 < ENOUGH ? coarse->points - 1 : ENOUGH;
	double point = median(coarse->early, count > 0 ? count : 0);

	return point > 0.0 ? fmin(fmax(coarse->point/point, 1.0), largest_ratio) : 1.0;
}

static double estimate(const struct coarse *coarse)
{
	return (coarse->last - coarse->began)*ratio(coarse) + coarse->events*coarse->per_event;
}

static double formula(const struct coarse *coarse, double from, double to)
{
	return coarse->outlook->points(coarse->outlook->context, from, to);
}

/* Remaining points from omega on: by the formula, corrected by the factor by which it was too small
 * up to there. */
static double left_over(const struct coarse *coarse, double omega)
{
	double traced = coarse->before->points + coarse->points, so_far = 1.0;

	if ((omega - coarse->from)*(coarse->to - coarse->from) > 0.0)
		so_far = fmax(1.0, formula(coarse, coarse->from, omega));
	return formula(coarse, omega, coarse->to)*fmax(1.0, fmin(traced/so_far, 5.0));
}

/* Whether the formula is valid from the last point on, at omega. */
static int is_known(const struct coarse *coarse, double omega)
{
	const struct hawser__outlook *outlook = coarse->outlook;

	return !coarse->hard && outlook->smooth(outlook->context, omega, coarse->to);
}

static double whole(const struct coarse *coarse, double omega)
{
	double seen = coarse->before->seconds + estimate(coarse);

	return seen*(1.0 + left_over(coarse, omega)/(coarse->before->points + coarse->points));
}

static int watch_coarse(void *data, const struct hawser_progress_state *state)
{
	const struct hawser_frf *frf = state->frf;
	struct coarse *coarse = data;
	double now = hawser__processor_seconds(), omega;

	if (frf->points == 0) /* on the way to the first point */
		return is_over(coarse->trial, now, 0.0, 1.0, 0.0);
	if (coarse->points == 0)
		coarse->began = now;
	else if (frf->points > coarse->points && coarse->points <= ENOUGH)
		coarse->early[coarse->points - 1] = now - coarse->last;
	for (; coarse->points < frf->points; coarse->points++) {
		int p = coarse->points;

		coarse->events += p > 0 && is_event(&frf->point[p - 1], &frf->point[p]);
		coarse->slack += frf->tension && frf->tension[2*p] < 0.0;
	}
	coarse->last = now;
	coarse->hard = frf->point[frf->points - 1].unstable > 0 ||
	               (frf->point[frf->points - 1].direction > 0) != (coarse->to > coarse->from);
	omega = frf->point[frf->points - 1].omega;
	return is_over(coarse->trial, now, whole(coarse, omega), 1.0,
	               is_known(coarse, omega) ? 0.0 : hard_secs);
}

/* Number of points of `frf` with negative tension. */
static int count_slack(const struct hawser_frf *frf)
{
	int count = 0;

	for (int p = 0; frf->tension && p < frf->points; p++)
		count += frf->tension[2*p] < 0.0;
	return count;
}

/* Add the part after the interruption of the coarse trace at omega. */
static void add_rest(struct hawser__trial_cost *cost, const struct coarse *coarse, double omega)
{
	const struct hawser__outlook *outlook = coarse->outlook;
	double each = cost->seconds/cost->points, more = left_over(coarse, omega);

	cost->omega = omega;
	cost->bound |= !is_known(coarse, omega);
	if (cost->bound) {
		each = fmin(each, coarse->point);
		more = outlook->least(outlook->context, omega, coarse->to);
	}
	cost->seconds += each*more;
	cost->points += more;
}

void hawser__trial_finish(struct hawser__trial_cost *cost, struct hawser_frf *left,
                          struct hawser__trial *trial, const struct hawser_rom *rom,
                          const struct hawser_frf *frf, const struct hawser__outlook *outlook)
{
	int last = frf->points - 1, balance = strcmp(frf->method, "shooting") != 0;
	double point = hawser__trial_point(trial), omega = frf->point[last].omega;
	struct hawser_frf_options options = *trial->options;
	struct coarse coarse = {.trial = trial, .before = cost, .point = point,
		.per_event = point*(balance ? event_balance : event_shooting), .outlook = outlook,
		.from = options.from, .to = options.to};
	enum hawser_status status;

	*left = (struct hawser_frf){.n = 0};
	*cost = (struct hawser__trial_cost){.seconds = trial->last - trial->start, .points = frf->points,
	                                    .traced = frf->points, .slack = count_slack(frf), .omega = NAN};
	options.method = frf->method;
	options.tolerance = fmax(coarse_tolerance, options.tolerance);
	options.skip_events = 1;
	options.samples = HAWSER_NONE;
	options.begin = omega;
	options.start = frf->state + (size_t)last*2*(size_t)rom->n;
	options.direction = frf->point[last].direction;
	options.max_points -= last;
	options.progress = (struct hawser_progress){watch_coarse, &coarse};
	status = hawser_frf_trace(left, rom, &options, NULL);
	cost->complete = !status && left->end != HAWSER_END_INTERRUPTED;
	if (left->points > 0)
		omega = left->point[left->points - 1].omega;
	cost->bound = coarse.events > many_events;
	if (cost->bound)
		coarse.per_event = 0.0;
	cost->seconds += estimate(&coarse);
	cost->points += coarse.points > 0 ? coarse.points - 1 : 0;
	cost->traced = (int)cost->points;
	cost->slack += coarse.slack;
	cost->seen = cost->seconds;
	if (!cost->complete)
		add_rest(cost, &coarse, omega);
	cost->limited = cost->points > trial->options->max_points;
	if (cost->limited) {
		cost->seconds *= trial->options->max_points/cost->points;
		cost->seconds = fmax(cost->seconds, cost->seen);
		cost->points = trial->options->max_points;
	}
}

static int few(void *data, const struct hawser_progress_state *state)
{
	note_point(data, state->frf, hawser__processor_seconds());
	return 0;
}

enum hawser_status hawser__trial_points(struct hawser__trial_cost *cost, struct hawser_frf *frf,
                                        struct hawser__trial *trial, const struct hawser_rom *rom,
                                        const struct hawser_frf_options *options, int points,
                                        struct hawser_report *report)
{
	struct hawser_frf_options first = *options;
	double now = hawser__processor_seconds();
	enum hawser_status status;

	/* a trial of its own, with the same time */
	trial->end += now - trial->start;
	trial->start = now;
	trial->options = options;
	trial->curve = trial->points = trial->before = trial->stopped = 0;
	first.max_points = points;
	first.samples = HAWSER_NONE;
	first.progress = (struct hawser_progress){few, trial};
	status = hawser_frf_trace(frf, rom, &first, report);
	*cost = (struct hawser__trial_cost){
		.seconds = trial->last - now, .seen = trial->last - now, .points = frf->points,
		.complete = frf->end != HAWSER_END_MAX_POINTS, .slack = count_slack(frf),
		.traced = frf->points, .omega = NAN};
	return status;
}

enum hawser_status hawser__trial_curve(struct hawser__trial_cost *cost, struct hawser__trial *trial,
                                       const struct hawser_rom *rom,
                                       const struct hawser_frf_options *options, int points,
                                       const struct hawser__outlook *outlook,
                                       struct hawser_report *report)
{
	struct hawser_frf frf = {.n = 0}, left = {.n = 0};
	enum hawser_status status = hawser__trial_points(cost, &frf, trial, rom, options, points,
	                                                 report);

	if (!status && !cost->complete)
		hawser__trial_finish(cost, &left, trial, rom, &frf, outlook);
	hawser_frf_clear(&left);
	hawser_frf_clear(&frf);
	return status;
}
