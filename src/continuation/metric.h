/* continuation/metric.h - geometry of a curve in a weighted metric, <a, b> = sum weight_i a_i b_i.
 * Every vector has `size` components, as the weights have.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CONTINUATION_METRIC_H
#define HAWSER_CONTINUATION_METRIC_H

struct hawser__metric {
	int size;
	const double *weight; /* [size] */
};

/* A point of a curve: y [size], t [size] its tangent, of any length. */
struct hawser__node {
	const double *y, *t;
};

double hawser__metric_dot(const struct hawser__metric *metric, const double *a, const double *b);
double hawser__metric_length(const struct hawser__metric *metric, const double *a);
/* Square of the distance of a from b. */
double hawser__metric_distance2(const struct hawser__metric *metric, const double *a, const double *b);
/* Angle between a and b, 0 to pi. */
double hawser__metric_angle(const struct hawser__metric *metric, const double *a, const double *b);

/* Length of the arc from a to b, from its chord and the angle between the tangents. */
double hawser__arc_between(const struct hawser__metric *metric, const struct hawser__node *a,
                           const struct hawser__node *b);

/* y [size] and unit direction [size] at fraction s of the way from a to b, on the cubic through both
 * points and tangents. */
void hawser__curve_between(double *y, double *direction, const struct hawser__node *a,
                           const struct hawser__node *b, double s,
                           const struct hawser__metric *metric);

/* y [size] at arclength ds beyond the last of 1 to 3 nodes, which follow each other along the curve, on
 * the polynomial of degree 2 nodes - 1 through points and tangents. */
void hawser__curve_ahead(double *y, const struct hawser__node *node, int nodes, double ds,
                         const struct hawser__metric *metric);

/* t [size]: tangent at y, which is at arclength ds beyond the last of these nodes, on the polynomial of
 * degree 2 nodes through them, their tangents and y. */
void hawser__curve_slope(double *t, const double *y, const struct hawser__node *node, int nodes,
                         double ds, const struct hawser__metric *metric);

/* The fraction of the way from a to b at which component `place` of the cubic meets `bound`, which
 * lies between those of a and b; y [size] is the point there, direction [size] work space. */
double hawser__curve_meets(double *y, double *direction, const struct hawser__node *a,
                           const struct hawser__node *b, int place, double bound,
                           const struct hawser__metric *metric);

/* Whether the cubic from a to b, `step` long, passes the point goal [size] within `near` steps, and at
 * which *share of the way. y and direction [size] are work space. */
int hawser__curve_passes(double *share, const double *goal, const struct hawser__node *a,
                         const struct hawser__node *b, double step, double near, double *y,
                         double *direction, const struct hawser__metric *metric);

#endif
