/* continuation/false_position.h - the zero of a function between two places at which its signs differ:
 * false position with the Anderson-Bjorck weight, and a bisection every eighth time, for false position
 * may converge slowly where the function is strongly curved.
 *
 * Source: N. Anderson and A. Bjorck, BIT 13 (1973) 253.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CONTINUATION_FALSE_POSITION_H
#define HAWSER_CONTINUATION_FALSE_POSITION_H

struct hawser__bracketed {
	double a, b, fa, fb; /* a < b; f(a) and f(b) have different signs; weighted */
	int moved;           /* the end that moved last: -1 a, 1 b, 0 none */
};

/* Where to try next, strictly inside; `i` counts the tries from 0. */
static inline double hawser__false_position(const struct hawser__bracketed *in, int i)
{
	double middle = 0.5*(in->a + in->b);
	double s = i%8 == 7 ? middle : in->b - in->fb*(in->b - in->a)/(in->fb - in->fa);

	return s > in->a && s < in->b ? s : middle;
}

/* Take in the value f at s. The value of an end that stays twice is reduced, so that the next try is
 * nearer to it. */
static inline void hawser__false_position_take(struct hawser__bracketed *in, double s, double f)
{
	int end = (f < 0.0) == (in->fa < 0.0) ? -1 : 1;
	double weight = in->moved != end ? 1.0 : 1.0 - f/(end < 0 ? in->fa : in->fb);

	weight = weight > 0.0 ? weight : 0.5;
	if (end < 0) {
		in->a = s;
		in->fa = f;
		in->fb *= weight;
	} else {
		in->b = s;
		in->fb = f;
		in->fa *= weight;
	}
	in->moved = end;
}

#endif
