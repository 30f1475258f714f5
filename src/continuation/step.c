/* continuation/step.c - one step along a curve: predict, correct, judge, and choose the next length.
 *
 * The next step is the longest at which the contraction of the corrector, the angle between the
 * tangents and the distance of the prediction are expected to stay at their goals (Allgower and Georg,
 * Numerical Continuation Methods, 6.1): the angle grows with the step, the contraction with its square,
 * the distance with the power that the predictor's order gives.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "continuation/curve.h"

#define TINY 1e-12 /* an angle, contraction or distance below this is round-off and limits nothing */

/* By what factor the next step may be longer than the last one. */
static double next_factor(const struct hawser__curve *curve, double angle)
{
	const struct hawser__step_settings *is = curve->settings;
	const struct hawser__correction *did = &curve->correction;
	double factor = is->goal_angle/fmax(angle, TINY);

	if (is->goal_contraction > 0.0)
		factor = fmin(factor, sqrt(is->goal_contraction/fmax(did->contraction, TINY)));
	if (is->goal_distance > 0.0)
		factor = fmin(factor, pow(is->goal_distance/fmax(did->first, TINY),
		                          1.0/is->distance_order));
	return fmax(is->slowest, fmin(is->fastest, factor));
}

/* After a failure of the corrector. */
static enum hawser_status after_failure(struct hawser__curve *curve)
{
	double factor = 0.0;
	enum hawser_status status = HAWSER_OK;

	if (curve->ops->refine)
		status = curve->ops->refine(curve->owner, curve->ds, &factor);
	curve->ds *= factor > 0.0 ? factor : curve->settings->after_failure;
	return status;
}

/* A try from the current point with the length curve->ds. *verdict is HAWSER__REPEAT, too, where the
 * length has been changed already. */
static enum hawser_status try_step(struct hawser__curve *curve, double *angle,
                                   enum hawser__verdict *verdict)
{
	const struct hawser__curve_ops *ops = curve->ops;
	void *owner = curve->owner;
	int failed;
	enum hawser_status status;

	*verdict = HAWSER__SHORTEN;
	if (ops->predict(owner, curve->ds))
		return HAWSER_OK;
	status = ops->correct(owner, curve->ds, &curve->correction, &failed);
	if (status)
		return status;
	if (failed) {
		*verdict = HAWSER__REPEAT;
		return after_failure(curve);
	}
	if ((status = ops->finish(owner, curve->ds, angle)))
		return status;
	return ops->judge(owner, curve->ds, *angle, verdict);
}

enum hawser_status hawser__curve_step(struct hawser__curve *curve, double *taken,
                                      enum hawser__outcome *outcome)
{
	const struct hawser__curve_ops *ops = curve->ops;

	*taken = 0.0;
	for (int tries = 0;; tries++) {
		double angle;
		enum hawser__verdict verdict;
		enum hawser_status status;

		*outcome = HAWSER__LOST;
		if (curve->ds < curve->settings->smallest)
			return HAWSER_OK;
		*outcome = HAWSER__INTERRUPTED;
		if (ops->interrupted && ops->interrupted(curve->owner, tries))
			return HAWSER_OK;
		status = try_step(curve, &angle, &verdict);
		if (status)
			return status;
		if (verdict == HAWSER__SHORTEN)
			curve->ds *= curve->settings->after_refusal;
		if (verdict != HAWSER__KEEP)
			continue;
		*taken = curve->ds;
		curve->ds = fmin(curve->ds*next_factor(curve, angle), ops->longest(curve->owner));
		return HAWSER_OK;
	}
}
