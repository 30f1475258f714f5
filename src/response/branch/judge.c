/* response/branch/judge.c - whether a step of the continuation is accepted.
 *
 * Two errors are possible. First, next may lie on another branch: bifurcations that a small load
 * has unfolded leave branches close to each other. Limits on the work of the corrector exclude
 * this. Second, two events in the step may cancel each other and be lost. This is excluded by
 * counting: the sign changes of the test functions must explain the change of the number of
 * unstable multipliers, with one event per step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>
#include <stdlib.h>

#include "response/branch/collide.h"
#include "response/branch/trace.h"
#include "response/floquet/floquet.h"

#define WORST_ANGLE 0.4        /* largest angle between successive tangents, rad; chosen */
#define WORST_DISTANCE 5e-2    /* largest distance of the prediction from the branch, relative to
                                * the orbit; chosen */
#define WORST_CONTRACTION 0.2 /* largest contraction of Newton's method: with a larger one the curve
                               * bends within the step; chosen */
#define WORST_ITERATIONS 5 /* more iterations mean that the prediction is too far from the curve;
                            * chosen */
#define SHALLOW 0.1             /* a minimum of more than this fraction of the values at the ends of
                                 * a step hides no crossing; chosen */
#define UNSURE 0.5              /* the same for a modulus, which bends sharply where two pairs pass each
                                 * other; chosen */
#define FEW 4                   /* multipliers of which the product may foresee an excursion although
                                 * each pair has been followed through four stations; chosen */
#define NEAR 0.3                /* distance from 1 or -1 below which multipliers are included;
                                 * chosen */

/* Whether the parabola through g at three stations crosses zero twice between the last two of them,
 * while g has the same sign at both: a sign of two crossings in one step. The stations follow one
 * another in either direction. */
static int hides_crossings(double s0, double g0, double s1, double g1, double s2, double g2)
{
	double d01 = (g1 - g0)/(s1 - s0), d12 = (g2 - g1)/(s2 - s1);
	double curvature = (d12 - d01)/(s2 - s0); /* half the second derivative */
	double slope = d12 - curvature*(s2 - s1); /* at s1 */
	double at = curvature != 0.0 ? -slope/(2.0*curvature) : 0.0; /* of the extreme, from s1 */

	if ((g1 < 0.0) != (g2 < 0.0) || at/(s2 - s1) <= 0.0 || at/(s2 - s1) >= 1.0)
		return 0;
	return (g1 + 0.5*slope*at < 0.0) != (g1 < 0.0);
}

/* The same of g less a fraction of its smaller value at b and c, by which the parabola may be
 * wrong. */
static int approaches_zero(const struct hawser__station *a, const struct hawser__station *b,
                           const struct hawser__station *c, const double g[3], double fraction)
{
	double below = fraction*(g[2] < 0.0 ? -1.0 : 1.0)*fmin(fabs(g[1]), fabs(g[2]));

	return (g[1] < 0.0) == (g[2] < 0.0) &&
	       hides_crossings(a->arc, g[0] - below, b->arc, g[1] - below, c->arc, g[2] - below);
}

/* For modulus i, which counts as outside only if it exceeds its error. If it does not at the ends
 * of the step, the parabola would be round-off, and nothing is concluded. */
static int hides_modulus(const struct hawser__station *a, const struct hawser__station *b,
                         const struct hawser__station *c, int i)
{
	double bound = fmax(a->bound[i], fmax(b->bound[i], c->bound[i]));
	double g[3] = {a->log_modulus[i] - bound, b->log_modulus[i] - bound, c->log_modulus[i] - bound};

	return (fabs(b->log_modulus[i]) > bound || fabs(c->log_modulus[i]) > bound) &&
	       approaches_zero(a, b, c, g, UNSURE);
}

/* Index of the multiplier nearest to the i-th of another station. */
static int matching(const struct hawser__station *station, const struct hawser__station *to, int i,
                    int m)
{
	double least = INFINITY;
	int best = 0;

	for (int k = 0; k < m; k++) {
		double gap = hypot(station->log_modulus[k] - to->log_modulus[i],
		                   station->argument[k] - to->argument[i]);

		if (gap < least) {
			least = gap;
			best = k;
		}
	}
	return best;
}

/* Whether more than one eigenvalue, or pair, of an equilibrium crosses the axis between b and c:
 * one may leave the half plane while another enters it, so that neither the count nor the test
 * function tells. They may pass each other in rank, but are apart in the plane. */
static int exchanges(const struct hawser__station *b, const struct hawser__station *c, int m)
{
	int crossings = 0;

	for (int i = 0; i < m; i++) {
		double before = b->log_modulus[matching(b, c, i, m)], after = c->log_modulus[i];

		crossings += c->argument[i] >= 0.0 && (before < 0.0) != (after < 0.0);
	}
	return crossings > 1;
}

static int is_near(const struct hawser__station *station, int i, double c)
{
	double r = exp(station->log_modulus[i]);

	return station->kind[i] != HAWSER__CONDENSED &&
	       1.0 - 2.0*c*r*cos(station->argument[i]) + r*r <= NEAR*NEAR;
}

/* Product of (1 - c mu), c = 1 or -1, over the multipliers near c; returns their number. It is
 * smooth along the branch, unlike the moduli, which have a kink where a pair meets on the real
 * axis. */
static int product_near(double *product, const struct hawser__station *station, int m, double c)
{
	int count = 0;

	*product = 1.0;
	for (int i = 0; i < m; i++) {
		double r = exp(station->log_modulus[i]), angle = station->argument[i];

		if (!is_near(station, i, c))
			continue;
		count++;
		if (angle == 0.0 || fabs(angle) >= M_PI)
			*product *= -expm1(station->log_modulus[i]);
		else if (angle > 0.0)
			*product *= 1.0 - 2.0*c*r*cos(angle) + r*r;
	}
	return count;
}

/* The same of (1 - mu nu) over all couples of multipliers near c, which is zero at a torus point
 * and as smooth. Two pairs that collide beside c, of which one has just met on the real axis, may
 * leave the unit circle and return; there, collide.c has not the same pairs at all stations.
 * Couples of which one is real are complex, and so are some of two pairs: each comes with its
 * conjugate. */
static int product_couples(double *product, const struct hawser__station *station, int m, double c)
{
	double complex all = 1.0;
	int count = 0;

	for (int i = 0; i < m; i++) {
		if (!is_near(station, i, c))
			continue;
		count++;
		for (int j = 0; j < i; j++)
			if (is_near(station, j, c))
				all *= 1.0 - cexp(station->log_modulus[i] + station->log_modulus[j] +
				                  I*(station->argument[i] + station->argument[j]));
	}
	*product = creal(all);
	return count > 2 ? count : 0;
}

/* A pair may meet on the real axis, leave the unit circle through `centre` and return within one
 * step; before that, its product approaches zero. A step towards a minimum is halved until its
 * parabola is reliable. Multipliers of high modes rotate past `centre` from station to station;
 * they are different ones each time and are not considered.
 * few: number of multipliers above which this is not looked at, as collide.c has followed each
 * pair and excludes it: where many pass the centre together, as those of a string at its frequency,
 * their product has a minimum that no parabola foresees. */
static int hides_excursion(const struct hawser__station *a, const struct hawser__station *b,
                           const struct hawser__station *c, int m, double centre, int few,
                           int product(double *, const struct hawser__station *, int, double))
{
	double g[3];
	int count = product(&g[0], a, m, centre);

	return count > 1 && count <= few && product(&g[1], b, m, centre) == count &&
	       product(&g[2], c, m, centre) == count && approaches_zero(a, b, c, g, SHALLOW);
}

/* Two crossings of the unit circle, or two folds, between b and c change neither the signs nor the
 * count; a is the station beyond b. few: see hides_excursion; of what collide.c has followed. */
static int hides(const struct hawser__trace *trace, const struct hawser__station *a,
                 const struct hawser__station *b, const struct hawser__station *c, int few,
                 int followed)
{
	int m = trace->orbit->m, last = trace->orbit->size - 1;

	for (int i = 0; i < m; i++)
		if (hides_modulus(a, b, c, i))
			return 1;
	if (trace->orbit->own == HAWSER__RESTS && exchanges(b, c, m))
		return 1;
	if (a->circle.undecided || b->circle.undecided || c->circle.undecided)
		followed = 0;
	else if (b->circle.unstable != c->circle.unstable) /* one event may hide others */
		followed &= HAWSER__ALONE;
	for (int centre = -1; centre <= 1; centre += 2)
		if (hides_excursion(a, b, c, m, centre, followed & HAWSER__ALONE ? few : m,
		                    product_near) ||
		    hides_excursion(a, b, c, m, centre, followed & HAWSER__TOGETHER ? few : m,
		                    product_couples))
			return 1;
	return hides_crossings(a->arc, a->t[last], b->arc, b->t[last], c->arc, c->t[last]);
}

/* Whether events between stations `step` and step + 1 of four (1 or 2), seen from the one beyond, may
 * not be separated; few: see hides_excursion; *followed: see collide.h. */
static int hides_in(const struct hawser__trace *trace, int *followed,
                    const struct hawser__station *const all[4], int step, int few)
{
	const struct hawser__station *beyond = all[step == 1 ? 3 : 1], *end = all[step == 1 ? 1 : 3];

	*followed = 0;
	return (trace->known > 2 &&
	        hawser__collide(followed, all, step, trace->orbit->m, trace->pairs)) ||
	       hides(trace, beyond, all[2], end, few, *followed);
}

/* Whether as many coordinates are condensed at all stations, so that pairs of multipliers that could
 * not be followed have moved far. */
static int keeps_all(const struct hawser__station *const all[4], int m)
{
	int condensed[4] = {0};

	for (int k = 0; k < 4; k++)
		for (int i = 0; i < m; i++)
			condensed[k] += all[k]->kind[i] == HAWSER__CONDENSED;
	return condensed[0] == condensed[1] && condensed[1] == condensed[2] &&
	       condensed[2] == condensed[3];
}

/* Whether a station between a and b shows events of which those two show nothing. */
static int shows_more(const struct hawser__station *a, const struct hawser__station *between,
                      const struct hawser__station *b)
{
	int sure = hawser__station_unsure(a, between) || hawser__station_unsure(between, b);
	int count = hawser__station_circle(between, sure).unstable;

	for (int k = 0; k < HAWSER_TESTS; k++)
		if (hawser__station_crossed(a, between, k, sure) &&
		    hawser__station_crossed(between, b, k, sure))
			return 1;
	return count != hawser__station_circle(a, sure).unstable &&
	       count != hawser__station_circle(b, sure).unstable;
}

/* *hidden becomes 0 where a station between two others, `step` and step + 1 of four, tells that no
 * events are hidden. It takes an orbit; a step that is made again takes two or three. */
static enum hawser_status look_between(struct hawser__trace *trace, int *hidden,
                                       const struct hawser__station *const all[4], int step)
{
	struct hawser__orbit *orbit = trace->orbit;
	struct hawser__station *between = &trace->scratch;
	const struct hawser__station *a = all[step], *b = all[step + 1];
	const struct hawser__station *five[5] = {all[step - 1], a, between, b, all[3]};
	enum hawser_status status = HAWSER_OK;
	int followed;

	if (!hawser__station_inside(between, orbit, a, b, 0.5, trace->options.tolerance)) {
		between->arc = 0.5*(a->arc + b->arc);
		hawser__station_turn(between, orbit, a->t, trace->options.along ? NULL : between->t);
		status = hawser__station_test(between, orbit, trace->report);
		*hidden = shows_more(a, between, b) || hides_in(trace, &followed, five, 1, 0) ||
		          (step == 1 ? hides_in(trace, &followed, five + 1, 1, 0)
		                     : hides_in(trace, &followed, five, 2, 0));
	}
	(void)orbit->ops->defects(orbit, trace->next.y, 1); /* the orbit is again that of next */
	return status;
}

/* The same of two of the last four stations, also between the last ones where pairs were not followed.
 * Where an orbit takes little, a step is rather made again. */
static enum hawser_status hides_behind(struct hawser__trace *trace, int *hidden, int step)
{
	const struct hawser__station *all[4] = {&trace->before, &trace->prev, &trace->here, &trace->next};

	int followed = 1;

	*hidden = trace->known > 1 && all[step + 1]->arc - all[step]->arc > HAWSER__SORTING_STEP &&
	          hides_in(trace, &followed, all, step, FEW);
	return hawser__is_large(trace->rom) && !trace->orbit->unjudged && trace->known > 2 &&
	       (*hidden || (step == 2 && !followed && keeps_all(all, trace->orbit->m)))
	       ? look_between(trace, hidden, all, step) : HAWSER_OK;
}

enum hawser_status hawser__trace_hides(struct hawser__trace *trace, int *hidden)
{
	return hides_behind(trace, hidden, 2);
}

/* What lies between two stations looks different from either side: an interval in which the motion
 * is unstable may be long before a curve of small slope, and short behind it. The step to `here` is
 * therefore judged again when `next` is known. */
enum hawser_status hawser__trace_hid(struct hawser__trace *trace, int *hidden)
{
	return hides_behind(trace, hidden, 1);
}

/* Whether the corrector had so little work that the point must be on the same branch. */
int hawser__trace_trusted(const struct hawser__correction *correction, double angle)
{
	return angle <= WORST_ANGLE && correction->first <= WORST_DISTANCE &&
	       correction->contraction <= WORST_CONTRACTION &&
	       correction->iterations <= WORST_ITERATIONS;
}

/* Size of the orbit at trace->here, whose metric is set; the equilibrium has size 0. */
static double size_of(const struct hawser__trace *trace)
{
	for (int i = 0; i + 1 < trace->orbit->size; i++)
		if (trace->here.y[i] != 0.0)
			return trace->orbit->X;
	return 0.0;
}

enum hawser_status hawser__trace_vanish(struct hawser__trace *trace, int *vanished)
{
	struct hawser_frf *frf = trace->frf;
	struct hawser_frf_event event;
	enum hawser_status status;

	*vanished = 0;
	if (trace->options.family)
		return HAWSER_OK;
	status = hawser__vanish(&trace->shrinking, vanished, &event, trace->rom, size_of(trace),
	                        hawser__trace_parameter(trace, &trace->here), trace->report);

	if (status || !*vanished)
		return status;
	frf->end = HAWSER_END_AT_REST;
	event.arc = trace->here.arc;
	event.after = frf->points - 1;
	event.unstable[0] = event.unstable[1] = trace->here.circle.unstable;
	return trace->options.skip_events ? HAWSER_OK
	                                  : hawser__record_event(frf, &event, NULL, trace->rom,
	                                                         trace->report);
}
