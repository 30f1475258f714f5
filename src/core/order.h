/* core/order.h - orders for qsort, and places in what is in order.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_ORDER_H
#define HAWSER_CORE_ORDER_H

/* Of doubles, or of structures that begin with one. */
static inline int hawser__ascending(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

/* Which of the n intervals between the ascending x [n + 1] has the value, from 0: that which begins
 * with the last one not above it; the first or the last interval has what is beyond all. */
static inline int hawser__interval(const double *x, int n, double value)
{
	int low = 0, high = n;

	while (high - low > 1) {
		int middle = low + (high - low)/2;

		if (value < x[middle])
			high = middle;
		else
			low = middle;
	}
	return low;
}

#endif
