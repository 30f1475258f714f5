/* continuation/false_position.h - the zero of a function between two places at which its signs differ:
 * false position with the Anderson-Bjorck weight, and a bisection every sixth time, for false position
 * may converge slowly where the function is strongly curved.
 *
 * Source: N. Anderson and A. Bjorck, BIT 13 (1973) 253.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CONTINUATION_FALSE_POSITION_H
#define HAWSER_CONTINUATION_FALSE_POSITION_H

struct hawser__bracketed {
	double a, b, fa, fb; /* a < b; f(a) and f(b) have different signs; weighted */
};

/* Where to try next, strictly inside; `i` counts the tries from 0. */
static inline double hawser__false_position(const struct hawser__bracketed *in, int i)
{
	double middle = 0.5*(in->a + in->b);
	double s = i%6 == 5 ? middle : in->b - in->fb*(in->b - in->a)/(in->fb - in->fa);

	return s > in->a && s < in->b ? s : middle;
}

/* Take in the value f at s. */
static inline void hawser__false_position_take(struct hawser__bracketed *in, double s, double f)
{
	int left = (f < 0.0) == (in->fa < 0.0);
	double weight = 1.0 - f/(left ? in->fa : in->fb);

	weight = weight > 0.0 ? weight : 0.5;
	if (left) {
		in->a = s;
		in->fa = f;
		in->fb *= weight;
	} else {
		in->b = s;
		in->fb = f;
		in->fa *= weight;
	}
}

#endif
