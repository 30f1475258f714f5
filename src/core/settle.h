/* core/settle.h - defaults of options: 0 stands for the default (hawser/status.h).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_SETTLE_H
#define HAWSER_CORE_SETTLE_H

static inline void hawser__settle(double *value, double fallback)
{
	if (*value == 0.0)
		*value = fallback;
}

static inline void hawser__settle_count(int *value, int fallback)
{
	if (*value == 0)
		*value = fallback;
}

#endif
