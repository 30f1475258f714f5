/* tests/modes-span.h - spans for the tests of the modes, directly from the scaled parameters.
 *
 * With u(0) = sinh(c - w), u(l) = sinh(c + w), the closure of the elastic catenary is
 *
 *   2w/delta + epsilon*l = 1,  sinh(c)*(2 sinh(w)/delta + epsilon*l*cosh(w)) = hs,
 *   l = 2 cosh(c) sinh(w)/delta
 *
 * without cancellation; both equations are monotone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_MODES_SPAN_H
#define HAWSER_TESTS_MODES_SPAN_H

#include <hawser/modes.h>
#include <math.h>

/* w for given c, by Newton on a convex increasing function, from above. */
static inline long double half_width(long double c, long double epsilon, long double delta)
{
	long double w = 0.5L*delta, k = epsilon*coshl(c);

	for (int i = 0; i < 200; i++) {
		long double step = (w + k*sinhl(w) - 0.5L*delta)/(1.0L + k*coshl(w));

		w -= step;
		if (fabsl(step) <= 1e-19L*w)
			break;
	}
	return w;
}

/* d = 1 m, H = 1 N, rho = 1 kg/m. */
static inline struct hawser_statics scaled_span(double epsilon, double delta, double hs)
{
	struct hawser_statics st = {.span = {.EA = 1.0/epsilon, .rho = 1.0, .g = delta, .d = 1.0,
	                                     .h = hs},
	                            .H = 1.0, .epsilon = epsilon, .delta = delta, .hs = hs};
	long double low = 0.0L, high = asinhl(fabs(hs) + 1.0) + 1.0L, c, w, l;

	for (int i = 0; i < 120; i++) {
		c = 0.5L*(low + high);
		w = half_width(c, epsilon, delta);
		l = 2.0L*coshl(c)*sinhl(w)/delta;
		if (sinhl(c)*(2.0L*sinhl(w)/delta + epsilon*l*coshl(w)) < fabs(hs))
			low = c;
		else
			high = c;
	}
	c = hs < 0.0 ? -high : hs > 0.0 ? high : 0.0L;
	w = half_width(c, epsilon, delta);
	st.l = (double)(2.0L*coshl(c)*sinhl(w)/delta);
	st.eta = (double)sinhl(c - w);
	st.length0 = st.l;
	return st;
}

/* The same with the forces at its ends. */
static inline struct hawser_statics span_of(double epsilon, double delta, double hs)
{
	struct hawser_statics st = scaled_span(epsilon, delta, hs);

	st.V0 = st.eta;
	st.V1 = st.eta + st.delta*st.l;
	st.T0 = hypot(1.0, st.V0);
	st.T1 = hypot(1.0, st.V1);
	return st;
}

#endif
