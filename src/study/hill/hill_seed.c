/* study/hill/hill_seed.c - starting points of boundaries: sign changes of a test function on a line
 * across the rectangle, and pairs of roots between two samples, where the modulus of the function
 * has a minimum. Roots are first found with the rough multipliers, then with the exact test
 * function of the boundary.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "study/hill/hill.h"

#define ROUND_OFF 1e-13 /* round-off of a test function that touches zero */
#define NUDGE 1e-6      /* increment for the gradient, relative to the rectangle; chosen */
#define NARROW 1e-9     /* narrowest tongue that is looked for, relative to the line; chosen */
#define BESIDE 1e-4     /* distance on the unstable side, relative to the rectangle; chosen */
#define CLOSE 1e-12     /* last step of a secant iteration, relative to the line; chosen */
enum { HALVINGS = 5, LOOKS = 60, SECANTS = 10 };
enum { MOST_HALVINGS = 12 };

static void place(double at[2], const struct hawser__hill_line *line, double s)
{
	at[0] = line->from[0] + s*line->along[0];
	at[1] = line->from[1] + s*line->along[1];
}

static double value(struct hawser__hill *hill, struct hawser__hill_track *track,
                    const struct hawser__hill_line *line, double s)
{
	double at[2];

	place(at, line, s);
	return hawser__hill_value(hill, track, at);
}

/* The test function by the multipliers, rough or strict. */
static double test(struct hawser__hill *hill, int kind, const struct hawser__hill_line *line, double s,
                   int rough)
{
	struct hawser__hill_worker *worker = hill->worker;
	double at[2];

	place(at, line, s);
	if (hill->status)
		return NAN;
	if (!hawser__hill_multipliers(hill, worker, at, rough))
		return hawser__hill_test(worker, kind);
	hill->status = worker->status;
	*hill->report = worker->report;
	return NAN;
}

/* *way becomes the direction of the boundary with g > 0 on its left. */
static int direction(struct hawser__hill *hill, struct hawser__hill_track *track, double way[2],
                     const double at[2])
{
	double slope[2], length;

	for (int k = 0; k < 2; k++) {
		double up[2] = {at[0], at[1]}, down[2] = {at[0], at[1]};

		up[k] += NUDGE;
		down[k] -= NUDGE;
		slope[k] = hawser__hill_value(hill, track, up) - hawser__hill_value(hill, track, down);
	}
	length = hypot(slope[0], slope[1]);
	way[0] = slope[1]/length;
	way[1] = -slope[0]/length;
	track->rise = 0.5*length/NUDGE;
	return length > 0.0 && !hill->status;
}

/* Whether the multipliers of a torus boundary are a complex pair on the unit circle: the product of
 * two real ones may also be 1. */
static int genuine(struct hawser__hill *hill, const struct hawser__hill_track *track,
                   const double at[2])
{
	const struct hawser__hill_worker *worker = hill->worker;

	if (track->kind != HAWSER_HILL_TORUS || track->by != HAWSER__BY_MULTIPLIERS)
		return 1;
	if (hawser__hill_multipliers(hill, hill->worker, at, 0)) {
		hill->status = worker->status;
		*hill->report = worker->report;
	}
	for (int i = 0; i < worker->m && !hill->status; i++)
		if (fabs(worker->log_modulus[i]) < 1e-5 && fabs(sin(worker->argument[i])) > 1e-3)
			return 1;
	return 0;
}

static void reverse(struct hawser_hill_boundary *boundary)
{
	for (int i = 0, j = boundary->points - 1; i < j; i++, j--)
		for (int k = 0; k < 2; k++) {
			double keep = boundary->at[2*i + k];

			boundary->at[2*i + k] = boundary->at[2*j + k];
			boundary->at[2*j + k] = keep;
		}
}

/* Bisect a sign change of the rough multipliers until the pair that causes it is known: it is outside
 * at *more. Returns 0 if no complex pair leaves the circle, since the product of two real multipliers
 * becomes 1. */
static int narrow(struct hawser__hill *hill, int kind, const struct hawser__hill_line *line, double *lo,
                  double *hi, double *more)
{
	double g_lo = test(hill, kind, line, *lo, 1), g_hi;
	int left = hawser__hill_outside(hill->worker), right, alone = hawser__hill_alone(hill->worker);

	g_hi = test(hill, kind, line, *hi, 1);
	right = hawser__hill_outside(hill->worker);
	alone = right > left ? hawser__hill_alone(hill->worker) : alone;
	for (int i = 0; (i < HALVINGS || (i < MOST_HALVINGS && !alone)) && !hill->status &&
	                (g_lo < 0.0) != (g_hi < 0.0); i++) {
		double middle = 0.5*(*lo + *hi), g = test(hill, kind, line, middle, 1);

		if ((g < 0.0) == (g_lo < 0.0)) {
			*lo = middle;
			left = hawser__hill_outside(hill->worker);
			alone = left > right ? hawser__hill_alone(hill->worker) : alone;
		} else {
			*hi = middle;
			right = hawser__hill_outside(hill->worker);
			alone = right > left ? hawser__hill_alone(hill->worker) : alone;
		}
	}
	*more = left > right ? *lo : *hi;
	return left != right;
}

/* The root *s of the exact function between lo and hi; returns 0 if it has the same sign at both. */
static int root(struct hawser__hill *hill, struct hawser__hill_track *track, double *s,
                const struct hawser__hill_line *line, double lo, double hi)
{
	struct hawser__bracketed in = {.a = lo, .b = hi};

	in.fa = value(hill, track, line, lo);
	in.fb = value(hill, track, line, hi);
	if (hill->status || !(in.fa*in.fb <= 0.0))
		return 0;
	*s = hawser__hill_root(hill, track, line->from, line->along, in);
	return isfinite(*s) && !hill->status;
}

/* The root *s near lo and hi by secants: it may be outside, since rough multipliers are not exact.
 * Returns 0 if it is more than a sample away. */
static int beside(struct hawser__hill *hill, struct hawser__hill_track *track, double *s,
                  const struct hawser__hill_line *line, double lo, double hi)
{
	double before = lo, now = hi, middle = 0.5*(lo + hi);
	double g_before = value(hill, track, line, before), g = value(hill, track, line, now);

	for (int i = 0; i < SECANTS && !hill->status; i++) {
		double next = now - g*(now - before)/(g - g_before);

		if (!(fabs(next - middle)*line->samples < 1.0))
			return 0;
		before = now;
		g_before = g;
		now = next;
		if (fabs(now - before) <= CLOSE) {
			*s = now;
			return 1;
		}
		g = value(hill, track, line, now);
	}
	return 0;
}

/* The root of the exact function of a boundary in the part of the model with coordinate `part`, near a
 * place of the line on its unstable side. */
static int find_in(struct hawser__hill *hill, struct hawser__hill_track *track, double *s, int part,
                   const struct hawser__hill_line *line, const double bracket[3])
{
	double at[2], half = 0.5/line->samples;
	struct hawser__hill_track keep;

	place(at, line, bracket[2]);
	if (!hawser__hill_choose(hill, track, track->kind, part, at) ||
	    track->by == HAWSER__BY_MULTIPLIERS)
		return 0;
	keep = *track;
	if (root(hill, track, s, line, bracket[0], bracket[1]))
		return 1;
	*track = keep;
	if (!hill->status && beside(hill, track, s, line, bracket[0], bracket[1]))
		return 1;
	*track = keep;
	return !hill->status &&
	       root(hill, track, s, line, fmax(0.0, bracket[0] - half), bracket[1] + half);
}

/* The root of the exact function of a boundary; of the strict multipliers if it has none and could
 * not be computed, or if the field has no models. */
static int find(struct hawser__hill *hill, struct hawser__hill_track *track, double *s, int kind,
                const struct hawser__hill_line *line, double lo, double hi)
{
	double bracket[3] = {lo, hi, 0.5*(lo + hi)}, at[2];
	int lost = kind == HAWSER_HILL_TORUS || !hill->worker->linear;

	if (kind == HAWSER_HILL_TORUS && hill->worker->linear &&
	    !narrow(hill, kind, line, &bracket[0], &bracket[1], &bracket[2]))
		return 0;
	for (int part = 0; part < hill->field->m/2 && hill->worker->linear && !hill->status; part++) {
		place(at, line, bracket[2]);
		if (!hawser__hill_is_first(hill, part, at))
			continue;
		*track = (struct hawser__hill_track){.kind = kind};
		if (find_in(hill, track, s, part, line, bracket))
			return 1;
		lost |= track->by == HAWSER__BY_MULTIPLIERS;
	}
	*track = (struct hawser__hill_track){.kind = kind, .by = HAWSER__BY_MULTIPLIERS};
	return lost && !hill->status && root(hill, track, s, line, lo, hi);
}

/* Follow a boundary from a point in the middle. First it is followed in reverse to one end, with
 * the sign of the function changed so that g > 0 is on the left; from that end it is followed as a
 * whole. */
static void follow_from(struct hawser__hill *hill, const struct hawser__hill_track *track,
                        const double at[2], const double way[2])
{
	struct hawser_hill_chart *chart = hill->chart;
	struct hawser_hill_boundary *boundary, back = {.kind = track->kind};
	struct hawser__hill_track own = *track;
	double ahead[2] = {way[0], way[1]}, behind[2] = {-way[0], -way[1]};

	if (hawser__more(&chart->boundary, chart->boundaries, sizeof *chart->boundary)) {
		hill->status = hawser__no_memory(hill->report, "hill");
		return;
	}
	boundary = &chart->boundary[chart->boundaries];
	*boundary = (struct hawser_hill_boundary){.kind = track->kind};
	back.at = malloc(2*sizeof *back.at);
	if (!back.at) {
		hill->status = hawser__no_memory(hill->report, "hill");
		return;
	}
	back.points = back.capacity = 1;
	memcpy(back.at, at, 2*sizeof *at);
	hill->backwards = 1;
	hawser__hill_follow(hill, &back, &own, behind);
	hill->backwards = 0;
	reverse(&back);
	*boundary = back;
	chart->boundaries++;
	own = *track;
	if (!hill->status && !chart->interrupted)
		hawser__hill_follow(hill, boundary, &own, ahead);
	if (boundary->points < 2) { /* the two sides of a tongue that is narrower than round-off */
		free(boundary->at);
		chart->boundaries--;
	}
}

/* Follow the boundary through a root, unless it is known. */
static void start(struct hawser__hill *hill, struct hawser__hill_track *track,
                  const struct hawser__hill_line *line, double s)
{
	double at[2], way[2];

	place(at, line, s);
	if (direction(hill, track, way, at) && !hawser__hill_known(hill, track->kind, at, way) &&
	    genuine(hill, track, at) && hawser__hill_real(hill, track, at, way, BESIDE))
		follow_from(hill, track, at, way);
}

void hawser__hill_try(struct hawser__hill *hill, int kind, const struct hawser__hill_line *line,
                      double lo, double hi)
{
	struct hawser__hill_track track;
	double s;

	if (find(hill, &track, &s, kind, line, lo, hi))
		start(hill, &track, line, s);
}

int hawser__hill_side(struct hawser__hill *hill, int kind, int part, const double lambda[2],
                      const struct hawser__hill_line *line, double s, double out)
{
	struct hawser__hill_track track = {.kind = kind, .part = part, .by = kind != HAWSER_HILL_TORUS ?
	                              HAWSER__BY_DETERMINANT : hawser__hill_undamped(hill->worker)
	                              ? HAWSER__BY_EXTREMUM : HAWSER__BY_GROWTH};
	double at;

	if (kind == HAWSER_HILL_TORUS) {
		track.lambda[0] = track.by == HAWSER__BY_GROWTH ? lambda[0] : 0.0;
		track.lambda[1] = lambda[1];
	}
	if (!root(hill, &track, &at, line, fmin(s, out), fmax(s, out)))
		return 0;
	start(hill, &track, line, at);
	return 1;
}

/* --- minima --- */

/* The function to be minimised: sign times the test function of the multipliers. */
struct minimum {
	int kind;
	double sign;
};

static double modulus(struct hawser__hill *hill, const struct minimum *of,
                      const struct hawser__hill_line *line, double s)
{
	return of->sign*test(hill, of->kind, line, s, 0);
}

/* Position of the minimum of the parabola through three points; NAN if it has none. */
static double vertex(const double s[3], const double g[3])
{
	double left = (g[1] - g[0])/(s[1] - s[0]), right = (g[2] - g[1])/(s[2] - s[1]);
	double bend = (right - left)/(s[2] - s[0]);

	return bend > 0.0 ? 0.5*(s[0] + s[1]) - 0.5*left/bend : NAN;
}

/* The minimum between s[0] and s[2], with s[1] below both, by parabolas and golden sections, until
 * a value is negative or none can be expected to be. g[1] becomes the smallest value. */
static void descend(struct hawser__hill *hill, const struct minimum *of,
                    const struct hawser__hill_line *line, double s[3], double g[3])
{
	const double golden = 0.3819660112501051;

	for (int i = 0; i < LOOKS && !hill->status && g[1] > 0.0 && s[2] - s[0] > NARROW; i++) {
		double wide = s[2] - s[0], next = vertex(s, g), value;

		if (i%3 == 2 || !(next > s[0] + 0.01*wide && next < s[2] - 0.01*wide)) {
			next = s[2] - s[1] > s[1] - s[0] ? s[1] + golden*(s[2] - s[1])
			                                 : s[1] - golden*(s[1] - s[0]);
		} else {
			double lowest = g[1] - (s[1] - next)*(s[1] - next)*fabs((g[2] - g[1])/(s[2] - s[1]) -
				(g[1] - g[0])/(s[1] - s[0]))/wide;

			/* a value barely below the previous ones will not become negative */
			if (i > 2 && lowest > 0.7*g[1])
				return;
			if (fabs(next - s[1]) < 0.01*wide)
				next = s[1] + (s[2] - s[1] > s[1] - s[0] ? 0.02 : -0.02)*wide;
		}
		value = modulus(hill, of, line, next);
		if (!isfinite(value))
			return;
		if (value < g[1]) {
			int side = next > s[1] ? 0 : 2;

			s[side] = s[1];
			g[side] = g[1];
			s[1] = next;
			g[1] = value;
		} else {
			int side = next > s[1] ? 2 : 0;

			s[side] = next;
			g[side] = value;
		}
	}
}

void hawser__hill_between(struct hawser__hill *hill, int kind, const struct hawser__hill_line *line,
                          double lo, double hi, double sign)
{
	double s[3] = {lo, 0.5*(lo + hi), hi}, g[3];
	const struct minimum of = {kind, sign};

	for (int k = 0; k < 3; k++)
		g[k] = modulus(hill, &of, line, s[k]);
	if (hill->status || !(g[1] < fmin(g[0], g[2])))
		return;
	descend(hill, &of, line, s, g);
	if (!hill->status && g[1] < -ROUND_OFF) {
		hawser__hill_try(hill, kind, line, lo, s[1]);
		hawser__hill_try(hill, kind, line, s[1], hi);
	}
}
