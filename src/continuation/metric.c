/* continuation/metric.c - see metric.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "continuation/metric.h"

#define HALVINGS 60 /* of the unit interval: to round-off */
#define FEET 4      /* iterations for the foot of a perpendicular: the curve bends little in a step */
#define BESIDE 1.5  /* distance from the middle of a step up to which they may begin; chosen */
#define SLACK 1e-3  /* part of a step by which steps overlap, above the error of a foot; chosen */

double hawser__metric_dot(const struct hawser__metric *metric, const double *a, const double *b)
{
	double sum = 0.0;

	for (int i = 0; i < metric->size; i++)
		sum += metric->weight[i]*a[i]*b[i];
	return sum;
}

double hawser__metric_length(const struct hawser__metric *metric, const double *a)
{
	return sqrt(hawser__metric_dot(metric, a, a));
}

double hawser__metric_distance2(const struct hawser__metric *metric, const double *a, const double *b)
{
	double sum = 0.0;

	for (int i = 0; i < metric->size; i++)
		sum += metric->weight[i]*(b[i] - a[i])*(b[i] - a[i]);
	return sum;
}

double hawser__metric_angle(const struct hawser__metric *metric, const double *a, const double *b)
{
	double ab = hawser__metric_dot(metric, a, b);
	double aa = hawser__metric_dot(metric, a, a), bb = hawser__metric_dot(metric, b, b);

	return acos(fmax(-1.0, fmin(1.0, ab/sqrt(aa*bb))));
}

/* The arc over the chord is 1 + angle^2/24 + ...; *la and *lb are the lengths of the tangents, each of
 * which may have been made a unit vector in another metric. */
static double arc_between(const struct hawser__metric *metric, const struct hawser__node *a,
                          const struct hawser__node *b, double *la, double *lb)
{
	double chord2 = hawser__metric_distance2(metric, a->y, b->y), turn;

	*la = hawser__metric_length(metric, a->t);
	*lb = hawser__metric_length(metric, b->t);
	turn = 1.0 - hawser__metric_dot(metric, a->t, b->t)/(*la**lb);
	return sqrt(chord2)*(1.0 + turn/12.0);
}

double hawser__arc_between(const struct hawser__metric *metric, const struct hawser__node *a,
                           const struct hawser__node *b)
{
	return arc_between(metric, a, b, &(double){0.0}, &(double){0.0});
}

void hawser__curve_between(double *y, double *direction, const struct hawser__node *a,
                           const struct hawser__node *b, double s,
                           const struct hawser__metric *metric)
{
	double la, lb, arc = arc_between(metric, a, b, &la, &lb), ta = arc/la, tb = arc/lb;
	double length, r = 1.0 - s;

	for (int i = 0; i < metric->size; i++) {
		double d = b->y[i] - a->y[i], pa = ta*a->t[i], pb = tb*b->t[i];

		y[i] = a->y[i] + s*s*(3.0 - 2.0*s)*d + s*r*(r*pa - s*pb);
		direction[i] = 6.0*s*r*d + r*(1.0 - 3.0*s)*pa + s*(3.0*s - 2.0)*pb;
	}
	length = hawser__metric_length(metric, direction);
	for (int i = 0; i < metric->size; i++)
		direction[i] /= length;
}

/* Arclengths of 1 to 3 nodes, 0 of the last, and the lengths of their tangents. */
static void place_nodes(double *s, double *scale, const struct hawser__node *node, int nodes,
                        const struct hawser__metric *metric)
{
	s[nodes - 1] = 0.0;
	scale[nodes - 1] = hawser__metric_length(metric, node[nodes - 1].t);
	for (int k = nodes - 1; k > 0; k--)
		s[k - 1] = s[k] - arc_between(metric, &node[k - 1], &node[k], &scale[k - 1], &scale[k]);
}

void hawser__curve_ahead(double *y, const struct hawser__node *node, int nodes, double ds,
                         const struct hawser__metric *metric)
{
	double s[3], scale[3];

	place_nodes(s, scale, node, nodes, metric);
	memset(y, 0, (size_t)metric->size*sizeof *y);
	for (int k = 0; k < nodes; k++) {
		double basis = 1.0, slope = 0.0, value, tangent;

		for (int o = 0; o < nodes; o++)
			if (o != k) {
				basis *= (ds - s[o])/(s[k] - s[o]);
				slope += 1.0/(s[k] - s[o]);
			}
		value = basis*basis*(1.0 - 2.0*slope*(ds - s[k]));
		tangent = basis*basis*(ds - s[k])/scale[k];
		for (int i = 0; i < metric->size; i++)
			y[i] += value*node[k].y[i] + tangent*node[k].t[i];
	}
}

/* Hermite's interpolation with y as a further node without a slope. With d_k = ds - s_k, and l_k the
 * product of (ds - s_o)/(s_k - s_o) over the other nodes o,
 *   t = sum_k 2 y/d_k - l_k^2 ((2 + sum_o 2 d_k/(s_o - s_k)) y_k/d_k + t_k) */
void hawser__curve_slope(double *t, const double *y, const struct hawser__node *node, int nodes,
                         double ds, const struct hawser__metric *metric)
{
	double s[3], scale[3];

	place_nodes(s, scale, node, nodes, metric);
	memset(t, 0, (size_t)metric->size*sizeof *t);
	for (int k = 0; k < nodes; k++) {
		double basis = 1.0, back = ds - s[k], sum = 2.0;

		for (int o = 0; o < nodes; o++)
			if (o != k) {
				basis *= (ds - s[o])/(s[k] - s[o]);
				sum += 2.0*back/(s[o] - s[k]);
			}
		basis *= basis;
		for (int i = 0; i < metric->size; i++)
			t[i] += 2.0/back*y[i] - basis*(sum/back*node[k].y[i] + node[k].t[i]/scale[k]);
	}
}

double hawser__curve_meets(double *y, double *direction, const struct hawser__node *a,
                           const struct hawser__node *b, int place, double bound,
                           const struct hawser__metric *metric)
{
	double lo = 0.0, hi = 1.0, side = a->y[place] < bound ? 1.0 : -1.0;

	for (int i = 0; i < HALVINGS; i++) {
		double s = 0.5*(lo + hi);

		hawser__curve_between(y, direction, a, b, s, metric);
		if ((y[place] - bound)*side < 0.0)
			lo = s;
		else
			hi = s;
	}
	y[place] = bound;
	return lo;
}

int hawser__curve_passes(double *share, const double *goal, const struct hawser__node *a,
                         const struct hawser__node *b, double step, double near, double *y,
                         double *direction, const struct hawser__metric *metric)
{
	for (int i = 0; i < metric->size; i++)
		direction[i] = goal[i] - a->y[i];
	*share = hawser__metric_dot(metric, direction, a->t)/step;
	for (int k = 0; k < FEET; k++) {
		double foot = 0.0;

		/* the foot on the tangent may be beyond the step where that on the curve is within it */
		if (!(fabs(*share - 0.5) <= BESIDE))
			return 0;
		hawser__curve_between(y, direction, a, b, *share, metric);
		for (int i = 0; i < metric->size; i++)
			foot += metric->weight[i]*(goal[i] - y[i])*direction[i];
		*share += k + 1 < FEET ? foot/step : 0.0;
	}
	if (!(*share > -SLACK && *share <= 1.0 + SLACK))
		return 0;
	*share = fmin(fmax(*share, SLACK), 1.0);
	return sqrt(hawser__metric_distance2(metric, y, goal)) < near*step;
}
