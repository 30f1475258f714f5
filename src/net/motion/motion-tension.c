/* net/motion/motion-tension.c - the tension of an element, with its damping.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/vec3.h"
#include "net/motion/motion-events.h"

double hawser__elastic_tension(const struct hawser__motion_element *el, double p)
{
	return el->law ? hawser__table_tension(el, p) : p > 0.0 ? el->k*p : 0.0;
}

/* Change of the length of an element in a step that has brought its vector to d, by increments x; d
 * becomes the vector before. */
static double longer(double d[3], const struct hawser__motion_element *el, const double (*x)[3])
{
	double before[3], more = 0.0, sum;

	for (int k = 0; k < 3; k++)
		before[k] = d[k] - (x[el->b][k] - x[el->a][k]);
	sum = sqrt(hawser__dot(d, d)) + sqrt(hawser__dot(before, before));
	for (int k = 0; k < 3; k++) {
		more += (d[k] + before[k])*(d[k] - before[k]);
		d[k] = before[k];
	}
	return sum > 0.0 ? more/sum : 0.0;
}

/* The rate of the length: from the mean rates of the last two steps, of second order. The velocities of
 * schemes without numerical damping alternate from step to step where axial damping is strong. */
static double rate_of(const struct hawser__motion *motion, const struct hawser__motion_element *el,
                      const double d[3])
{
	const double *va = motion->v[el->a], *vb = motion->v[el->b];
	double at[3] = {d[0], d[1], d[2]}, l = sqrt(hawser__dot(d, d)), rate = 0.0, before;

	for (int k = 0; k < 3 && motion->past_h <= 0.0; k++)
		rate += l > 0.0 ? d[k]/l*(vb[k] - va[k]) : 0.0;
	if (motion->past_h <= 0.0)
		return rate;
	rate = longer(at, el, (const double (*)[3])motion->past)/motion->past_h;
	if (motion->past2_h <= 0.0)
		return rate;
	before = longer(at, el, (const double (*)[3])motion->past2)/motion->past2_h;
	return rate + (rate - before)*motion->past_h/(motion->past_h + motion->past2_h);
}

double hawser__motion_tension(const struct hawser__motion *motion, int number, const double d[3],
                              double p)
{
	const struct hawser__motion_element *el = &motion->element[number];
	double T = hawser__elastic_tension(el, p);

	if (p > el->zero && el->c > 0.0)
		T = hawser__larger(T + el->c*rate_of(motion, el, d), 0.0);
	return T;
}
