/* study/accuracy/certify.c - a fold or a peak on a curve of periodic motions, by the secant method.
 *
 *   v, g    what is extreme there: Omega at a fold, the largest |x| of a component at a peak; dv/ds
 *   bend    dg/ds, s the arclength in the metric of the corrector
 *
 * Each motion is corrected in the plane normal to the last tangent, so that a step of -g/bend along the
 * tangent comes nearer by the square of its length. The last one is not made: v falls short by
 * g^2/(2 bend), which is known better than that.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "study/accuracy/certify.h"

enum { TRIES = 8 };
#define FAR 0.3   /* longest correction, relative; chosen */
static const double enough = 1e-6; /* of the last step's effect on Omega and size, relative; chosen, far
                                    * below the distances that are stated */
static const double longest = 0.05; /* step along the curve, in its metric; chosen */

static double value_of(double *slope, const struct hawser__corrector *c,
                       const struct hawser_certified *item, const double *y, const double *along)
{
	if (item->kind == HAWSER_LANDMARK_PEAK)
		return c->size_of(c->of, slope, item, y, along);
	*slope = along[c->size - 1];
	return y[c->size - 1];
}

/* The sign of `bend`: of a maximum, but at the left end of a fold. */
static double side_of(const struct hawser_certified *item)
{
	return item->kind == HAWSER_LANDMARK_FOLD && item->turn < 0 ? 1.0 : -1.0;
}

/* The step to the extreme; with a bend that is not that of such an extreme, uphill. */
static double step_of(double g, double bend, double side)
{
	double step = bend*side > 0.0 ? -g/bend : copysign(longest, -side*g);

	return fabs(step) > longest ? copysign(longest, step) : step;
}

static void finish(struct hawser_certified *item, const struct hawser__corrector *c, const double *y,
                   const double *along, double v, double g, double step)
{
	item->exact_omega = y[c->size - 1] + step*along[c->size - 1];
	if (item->kind == HAWSER_LANDMARK_PEAK)
		item->exact_size = v + 0.5*step*g;
	else
		item->exact_omega = v + 0.5*step*g;
}

enum hawser_status hawser__certify_from(struct hawser_certified *item, double *y, double *along,
                                        double *bend, const struct hawser__corrector *c,
                                        struct hawser_report *report)
{
	double *next = hawser__numbers(2, c->size), *turned = next ? next + c->size : NULL, v, g, step;
	size_t bytes = c->size*sizeof *y;
	int lost = 0;

	item->exact_omega = item->exact_size = NAN;
	if (!next)
		return hawser__no_memory(report, "certificate");
	c->metric(c->of, y);
	c->correct(c->of, y, along, &lost, FAR);
	for (int i = 0; i < TRIES && !lost; i++) {
		double before;

		v = value_of(&g, c, item, y, along);
		step = step_of(g, *bend, side_of(item));
		if (fabs(step*g) < enough*fabs(v) && *bend*side_of(item) > 0.0 &&
		    fabs(step*along[c->size - 1]) < enough*y[c->size - 1]) {
			finish(item, c, y, along, v, g, step);
			break;
		}
		memcpy(next, y, bytes);
		memcpy(turned, along, bytes);
		cblas_daxpy((int)c->size, step, along, 1, next, 1);
		c->correct(c->of, next, turned, &lost, FAR);
		before = g;
		value_of(&g, c, item, next, turned);
		*bend = (g - before)/step;
		memcpy(y, next, bytes);
		memcpy(along, turned, bytes);
	}
	free(next);
	return HAWSER_OK;
}

enum hawser_status hawser__certify_near(struct hawser_certified *item, double *y, double *along,
                                        double *bend, const struct hawser__corrector *c,
                                        const struct hawser__neighbours *from,
                                        struct hawser_report *report)
{
	double part[2], v[3], unused, length;
	size_t bytes = c->size*sizeof *y;

	memcpy(y, from->y, bytes);
	c->metric(c->of, y);
	for (int i = 0; i < 2; i++) {
		memcpy(along, from->around[i], bytes);
		cblas_daxpy((int)c->size, -1.0, y, 1, along, 1);
		part[i] = sqrt(c->dot(c->of, along, along));
	}
	memcpy(along, from->around[1], bytes);
	cblas_daxpy((int)c->size, -1.0, from->around[0], 1, along, 1);
	length = sqrt(c->dot(c->of, along, along));
	cblas_dscal((int)c->size, 1.0/length, along, 1);
	for (int i = 0; i < 3; i++)
		v[i] = value_of(&unused, c, item, i == 1 ? y : from->around[i/2], along);
	*bend = 2.0*((v[2] - v[1])/part[1] - (v[1] - v[0])/part[0])/(part[0] + part[1]);
	return hawser__certify_from(item, y, along, bend, c, report);
}
