/* statics/search.h - one step of a bracketed Newton search for x > 0, in ln x.
 *
 * The caller states on which side of x the root lies. The search takes Newton's step if it stays
 * inside the bracket and is at most half of the previous step. Otherwise it bisects the bracket in
 * ln x or, if one end is open, multiplies or divides x by 16. It terminates for any function,
 * usually after two to five Newton steps, in the worst case after about sixty bisections.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_SEARCH_H
#define HAWSER_STATICS_SEARCH_H

#include <float.h>
#include <math.h>

struct hawser__search {
	double x;
	double lo, hi; /* bracket; 0 and INFINITY while open */
	double step;   /* the last step in ln x */
};

/* Move x, given the side of the root and Newton's step in ln x (0 if it is not known). Returns 0 if
 * the bracket has shrunk to neighbouring numbers or the step to round-off; x is then the last point
 * tried. */
static inline int hawser__search_next(struct hawser__search *s, int root_is_below, double newton)
{
	int closed, small = fabs(newton) < 1e-6;
	double x, middle;

	if (root_is_below)
		s->hi = s->x;
	else
		s->lo = s->x;
	closed = s->lo > 0.0 && s->hi < INFINITY;
	middle = sqrt(s->lo)*sqrt(s->hi);
	if (closed && !(middle > s->lo && middle < s->hi))
		return 0;
	if (newton != 0.0 && (fabs(newton) <= DBL_EPSILON || (small && fabs(newton) >= s->step)))
		return 0;
	if (!closed)
		newton = fmax(-4.0, fmin(4.0, newton));
	x = s->x*(fabs(newton) < 1e-3 ? 1.0 + newton*(1.0 + 0.5*newton) : exp(newton));
	if (newton != 0.0 && x > s->lo && x < s->hi && (small || !closed || fabs(newton) <= 0.5*s->step)) {
		s->step = fabs(newton);
		s->x = x;
	} else if (closed) {
		s->step = 0.5*log(s->hi/s->lo);
		s->x = middle;
	} else {
		s->step = INFINITY;
		s->x = root_is_below ? s->x/16.0 : s->x*16.0;
	}
	return s->x >= DBL_MIN && s->x <= DBL_MAX;
}

#endif
