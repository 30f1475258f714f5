/* response/judge.c - whether a step of the continuation may be kept.
 *
 * Two dangers: that next lies on another branch (bifurcations that a small load has pulled apart
 * leave branches close to each other), and that events in the step are lost because two of them
 * undo each other. The first is met by limits on what the corrector had to do, the second by
 * counting: sign changes of the test functions must account for the change in the number of
 * unstable multipliers, one event at a time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "response/collide.h"
#include "response/trace.h"

#define WORST_ANGLE 0.4        /* rad */
#define WORST_DISTANCE 5e-2    /* of the prediction from the branch, relative to the orbit */
#define WORST_CONTRACTION 0.2 /* of Newton: where it is larger the curve bends within the step */
#define WORST_ITERATIONS 5 /* more of them mean a prediction too far from the curve */
#define SHALLOW 0.1             /* of the ends of a step: a dip to which hides none */
#define NEAR 0.3                /* of 1 or -1 */

/* Whether the parabola through g at the last three stations has an extremum beyond zero between
 * here and next, where g itself has one sign: a sign of two crossings in one step. */
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

/* The same for modulus i, of which only what exceeds its error counts as outside. Where it does not at
 * the ends of the step, and no parabola can be made of round-off, nothing is known. */
static int hides_modulus(const struct hawser__station *a, const struct hawser__station *b,
                         const struct hawser__station *c, int i)
{
	double bound = fmax(a->bound[i], fmax(b->bound[i], c->bound[i]));

	if (fabs(b->log_modulus[i]) <= bound && fabs(c->log_modulus[i]) <= bound)
		return 0;
	return hides_crossings(a->arc, a->log_modulus[i] - bound, b->arc, b->log_modulus[i] - bound,
	                       c->arc, c->log_modulus[i] - bound);
}

/* Product of (1 - c mu), c = 1 or -1, over the multipliers near c; returns how many they are.
 * Unlike the moduli, which have a corner where a pair meets on the real axis, it is smooth along
 * the branch. */
static int product_near(double *product, const struct hawser__station *station, int m, double c)
{
	int count = 0;

	*product = 1.0;
	for (int i = 0; i < m; i++) {
		double r = exp(station->log_modulus[i]), angle = station->argument[i];
		double away = 1.0 - 2.0*c*r*cos(angle) + r*r; /* squared */

		if (away > NEAR*NEAR)
			continue;
		count++;
		if (angle == 0.0 || fabs(angle) >= M_PI)
			*product *= -expm1(station->log_modulus[i]);
		else if (angle > 0.0)
			*product *= away;
	}
	return count;
}

/* A pair may meet on the real axis, leave the unit circle through `centre` and be back, all within
 * a step; its product comes near zero before. A step towards a dip is halved until its parabola is
 * to be believed. High modes rotate past `centre` from station to station: they are not the same
 * ones each time, and are left alone. */
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

/* Two crossings of the unit circle, or two folds, leave no change of sign and no change in the
 * count. */
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

/* Whether the corrector had so little to do that next can only be on the same branch as here. */
int hawser__trace_trusted(const struct hawser__trace *trace, double angle)
{
	const struct hawser__correction *correction = &trace->next.correction;

	return angle <= WORST_ANGLE && correction->first <= WORST_DISTANCE &&
	       correction->contraction <= WORST_CONTRACTION &&
	       correction->iterations <= WORST_ITERATIONS;
}

/* Size of the orbit of trace->here, whose metric is set: one at rest has none. */
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
	enum hawser_status status = hawser__vanish(&trace->shrinking, vanished, &event, trace->rom,
	                                           size_of(trace),
	                                           hawser__trace_omega(trace, &trace->here),
	                                           trace->report);

	if (status || !*vanished)
		return status;
	frf->end = HAWSER_END_AT_REST;
	event.arc = trace->here.arc;
	event.after = frf->points - 1;
	event.unstable[0] = event.unstable[1] = trace->here.circle.unstable;
	return trace->options.skip_events ? HAWSER_OK
	                                  : hawser__record_event(frf, &event, trace->report);
}
