/* response/judge.c - whether a step of the continuation is accepted.
 *
 * Two errors are possible. First, next may lie on another branch: bifurcations that a small load
 * has unfolded leave branches close to each other. Limits on the work of the corrector exclude
 * this. Second, two events in the step may cancel each other and be lost. This is excluded by
 * counting: the sign changes of the test functions must explain the change of the number of
 * unstable multipliers, with one event per step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "response/collide.h"
#include "response/trace.h"

#define WORST_ANGLE 0.4        /* largest angle between successive tangents, rad; chosen */
#define WORST_DISTANCE 5e-2    /* largest distance of the prediction from the branch, relative to
                                * the orbit; chosen */
#define WORST_CONTRACTION 0.2 /* largest contraction of Newton's method: with a larger one the curve
                               * bends within the step; chosen */
#define WORST_ITERATIONS 5 /* more iterations mean that the prediction is too far from the curve;
                            * chosen */
#define SHALLOW 0.1             /* a minimum of more than this fraction of the values at the ends of
                                 * a step hides no crossing; chosen */
#define NEAR 0.3                /* distance from 1 or -1 below which multipliers are included;
                                 * chosen */

/* Whether the parabola through g at the last three stations crosses zero twice between here and
 * next, while g has the same sign at both: a sign of two crossings in one step. */
static int hides_crossings(double s0, double g0, double s1, double g1, double s2, double g2)
{
	double d01 = (g1 - g0)/(s1 - s0), d12 = (g2 - g1)/(s2 - s1);
	double curvature = (d12 - d01)/(s2 - s0); /* half the second derivative */
	double slope = d12 - curvature*(s2 - s1); /* at s1 */
	double at = curvature != 0.0 ? -slope/(2.0*curvature) : -1.0;

	if ((g1 < 0.0) != (g2 < 0.0) || at <= 0.0 || at >= s2 - s1)
		return 0;
	return (g1 + 0.5*slope*at < 0.0) != (g1 < 0.0);
}

/* The same for modulus i, which counts as outside only if it exceeds its error. If it does not at
 * the ends of the step, the parabola would be round-off, and nothing is concluded. */
static int hides_modulus(const struct hawser__station *a, const struct hawser__station *b,
                         const struct hawser__station *c, int i)
{
	double bound = fmax(a->bound[i], fmax(b->bound[i], c->bound[i]));

	if (fabs(b->log_modulus[i]) <= bound && fabs(c->log_modulus[i]) <= bound)
		return 0;
	return hides_crossings(a->arc, a->log_modulus[i] - bound, b->arc, b->log_modulus[i] - bound,
	                       c->arc, c->log_modulus[i] - bound);
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
		double away = 1.0 - 2.0*c*r*cos(angle) + r*r; /* squared */

		if (away > NEAR*NEAR || station->condensed[i])
			continue;
		count++;
		if (angle == 0.0 || fabs(angle) >= M_PI)
			*product *= -expm1(station->log_modulus[i]);
		else if (angle > 0.0)
			*product *= away;
	}
	return count;
}

/* A pair may meet on the real axis, leave the unit circle through `centre` and return within one
 * step; before that, its product approaches zero. A step towards a minimum is halved until its
 * parabola is reliable. Multipliers of high modes rotate past `centre` from station to station;
 * they are different ones each time and are not considered. */
static int hides_excursion(const struct hawser__station *a, const struct hawser__station *b,
                           const struct hawser__station *c, int m, double centre)
{
	double g[3], below;
	int count = product_near(&g[0], a, m, centre);

	if (count < 2 || product_near(&g[1], b, m, centre) != count ||
	    product_near(&g[2], c, m, centre) != count || (g[1] < 0.0) != (g[2] < 0.0))
		return 0;
	below = SHALLOW*(g[2] < 0.0 ? -1.0 : 1.0)*fmin(fabs(g[1]), fabs(g[2]));
	return hides_crossings(a->arc, g[0] - below, b->arc, g[1] - below, c->arc, g[2] - below);
}

/* Two crossings of the unit circle, or two folds, change neither the signs nor the count. */
int hawser__trace_hides(const struct hawser__trace *trace)
{
	const struct hawser__station *a = &trace->prev, *b = &trace->here, *c = &trace->next;
	const struct hawser__station *all[4] = {&trace->before, a, b, c};
	int last = trace->orbit->size - 1;

	if (trace->known < 2)
		return 0;
	if (trace->known > 2 && hawser__collide(all, trace->orbit->m, trace->pairs))
		return 1;
	for (int i = 0; i < trace->orbit->m; i++)
		if (hides_modulus(a, b, c, i))
			return 1;
	return hides_excursion(a, b, c, trace->orbit->m, -1.0) ||
	       hides_excursion(a, b, c, trace->orbit->m, 1.0) ||
	       hides_crossings(a->arc, a->t[last], b->arc, b->t[last], c->arc, c->t[last]);
}

/* Whether the corrector had so little work that next must be on the same branch as here. */
int hawser__trace_trusted(const struct hawser__trace *trace, double angle)
{
	const struct hawser__correction *correction = &trace->next.correction;

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
