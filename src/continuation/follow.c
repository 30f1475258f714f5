/* continuation/follow.c - a curve from its current point to its end.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "continuation/curve.h"

enum hawser_status hawser__curve_follow(struct hawser__curve *curve, enum hawser__outcome *outcome)
{
	const struct hawser__curve_ops *ops = curve->ops;
	enum hawser__arrival arrival = HAWSER__GO_ON;

	while (arrival != HAWSER__AT_END) {
		int ended = 0;
		double taken;
		enum hawser_status status = ops->prepare(curve->owner, &ended);

		*outcome = HAWSER__ENDED;
		if (status || ended)
			return status;
		status = hawser__curve_step(curve, &taken, outcome);
		if (status || !(taken > 0.0))
			return status;
		*outcome = HAWSER__ENDED;
		status = ops->arrive(curve->owner, &arrival, taken, &curve->ds);
		if (status)
			return status;
	}
	return HAWSER_OK;
}
