/* core/order.h - orders for qsort. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_ORDER_H
#define HAWSER_CORE_ORDER_H

/* Of doubles, or of structures that begin with one. */
static inline int hawser__ascending(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

#endif
