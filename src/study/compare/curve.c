/* study/compare/curve.c - the distance of two frequency responses as curves.
 *
 *    w, a    log Omega, and the amplitude of one component relative to its maximum along the curve
 *    d_i     distance from point i of one curve to the other curve, in the norm max(|w|, |a|)
 *    e_i     distance from that point to the nearer end of the range, in w
 *
 * Folds and peaks alone do not show whether two responses agree: both may have none, because a
 * resonance lies at an end of the range or because both models miss it. Therefore the whole curves
 * are compared by their Hausdorff distance. It needs no pairing of points and also holds for curves
 * with folds. It is the error of Omega where the curves are steep and the error of the amplitude
 * where they are flat.
 *
 * The counterpart of a point near an end of the range may lie outside the range. A distance d_i >
 * e_i is therefore no evidence of a difference, and the result is the maximum of min(d_i, e_i).
 *
 * Below a sharp peak the curve's flanks are nearer than its top: with 0.6 % of damping a peak that is
 * off by 0.35 % is 0.04 % from the curve. Of points carried over from one model to another, extremes
 * are therefore compared too.
 *
 * The distance is taken to a refinement of the other curve by cubics in its arclength, so that the
 * chords between its points do not count as error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "study/accuracy/landmark.h"
#include "study/compare/curve.h"

enum { PARTS = 6 };             /* segments into which each segment of a curve is refined; chosen */
static const double uneven = 100.0; /* ratio of successive steps above which the shorter one has too
                                     * few digits for a parabola; chosen */
static const double apart = 0.4, small = 0.02; /* arclength between two marks, relative amplitude from
                                                 * which on there are marks; chosen */
static const double counted_peak = 0.2; /* smallest that counts, of the component; as of landmarks */
static const double singular = 1e-6; /* smallest determinant, of equations scaled to 1; chosen */
static const double faintest = 0.5; /* smallest component that counts, relative to the largest one, as
                                     * of the peaks that are compared. Those with the two largest
                                     * peaks count too: others may be larger at an end of the range */

void hawser__curve_clear(struct hawser__drawn_curve *curve)
{
	free(curve->arc);
	free(curve->value);
	*curve = (struct hawser__drawn_curve){0};
}

static enum hawser_status find_largest(struct hawser__drawn_curve *curve,
                                       const struct hawser_frf *frf, struct hawser_report *report)
{
	struct hawser_landmark *peak, largest[2];
	int peaks;
	enum hawser_status status = hawser_landmarks(&peak, &peaks, frf, NULL, report);

	if (status)
		return status;
	hawser__largest_peaks(largest, frf, peak, peaks);
	for (int k = 0; k < 2; k++)
		curve->largest[k] = largest[k].probe < 0 ? 0 : 1 + hawser__peak_column(&largest[k]);
	free(peak);
	return HAWSER_OK;
}

enum hawser_status hawser__curve_copy(struct hawser__drawn_curve *curve, const struct hawser_frf *frf,
                                      struct hawser_report *report)
{
	size_t points = (size_t)frf->points, width = 3*(size_t)frf->probes;

	*curve = (struct hawser__drawn_curve){.points = frf->points, .width = (int)width};
	curve->arc = malloc((points + 1)*sizeof *curve->arc);
	curve->value = malloc((points*(width + 1) + 1)*sizeof *curve->value);
	if (!curve->arc || !curve->value)
		return hawser__no_memory(report, "study");
	for (size_t i = 0; i < points; i++) {
		double *row = curve->value + i*(width + 1);

		curve->arc[i] = frf->point[i].arc;
		row[0] = log(frf->point[i].omega);
		memcpy(row + 1, frf->probe + i*width, width*sizeof *row);
	}
	return find_largest(curve, frf, report);
}

static double at(const struct hawser__drawn_curve *curve, int i, int column)
{
	return curve->value[(size_t)i*((size_t)curve->width + 1) + (size_t)column];
}

static double largest(const struct hawser__drawn_curve *curve, int column)
{
	double most = 0.0;

	for (int i = 0; i < curve->points; i++)
		most = fmax(most, at(curve, i, column));
	return most;
}

static int is_peak(const struct hawser__drawn_curve *curve, int column)
{
	return column == curve->largest[0] || column == curve->largest[1];
}

/* Whether a component counts; scale, most: its largest value, and that of all. */
static int counts(const struct hawser__drawn_curve *curve, int column, double scale, double most)
{
	return scale > 0.0 && (scale >= faintest*most || is_peak(curve, column));
}

int hawser__curve_reaches(const struct hawser__drawn_curve *curve, int column, double part)
{
	double most = 0.0;

	for (int c = 1; c <= curve->width; c++)
		most = fmax(most, largest(curve, c));
	return largest(curve, column) >= part*most || is_peak(curve, column);
}

/* Derivative by arc at point i of the parabola through it and its neighbours; at an end, through the
 * next two. Where steps are too uneven, the slope of the longer one. */
static double slope(const struct hawser__drawn_curve *curve, int i, int column)
{
	const double *s = curve->arc;
	int k = i < 1 ? 1 : i > curve->points - 2 ? curve->points - 2 : i;
	double left = s[k] - s[k - 1], right = s[k + 1] - s[k];
	double before = (at(curve, k, column) - at(curve, k - 1, column))/left;
	double after = (at(curve, k + 1, column) - at(curve, k, column))/right;
	double bend = (after - before)/(left + right);

	if (fmax(left, right) > uneven*fmin(left, right))
		return left > right ? before : after;
	return before + bend*(2.0*s[i] - s[k - 1] - s[k]);
}

/* Cubic interpolation between points i and i + 1, at the fraction x. */
static double between(const struct hawser__drawn_curve *curve, int i, double x, int column)
{
	double step = curve->arc[i + 1] - curve->arc[i], y = 1.0 - x;
	double a = at(curve, i, column), b = at(curve, i + 1, column);

	if (curve->points < 3)
		return y*a + x*b;
	return y*y*(1.0 + 2.0*x)*a + x*x*(3.0 - 2.0*x)*b +
	       x*y*step*(y*slope(curve, i, column) - x*slope(curve, i + 1, column));
}

/* The refined curve of one component: (w, a) [count][2]. */
struct line {
	int count;
	double *wa;
};

static int refine(struct line *line, const struct hawser__drawn_curve *curve, int column, double scale)
{
	int count = (curve->points - 1)*PARTS + 1;

	*line = (struct line){.count = count, .wa = malloc(2*(size_t)count*sizeof *line->wa)};
	if (!line->wa)
		return 1;
	for (int k = 0; k < count; k++) {
		int i = k/PARTS < curve->points - 1 ? k/PARTS : curve->points - 2;
		double x = (double)(k - i*PARTS)/PARTS;

		if (curve->points == 1) {
			line->wa[0] = at(curve, 0, 0);
			line->wa[1] = at(curve, 0, column)/scale;
			break;
		}
		line->wa[2*k] = between(curve, i, x, 0);
		line->wa[2*k + 1] = between(curve, i, x, column)/scale;
	}
	return 0;
}

/* Distance of the origin from the point p + t (q - p), t limited to [0, 1]. */
static double reach(const double *p, const double *q, double t)
{
	t = fmin(fmax(t, 0.0), 1.0);
	return fmax(fabs(p[0] + t*(q[0] - p[0])), fabs(p[1] + t*(q[1] - p[1])));
}

/* Distance of the origin from the segment p q in the maximum norm. The norm is piecewise linear
 * along the segment, so that its minimum is at an end or at a kink. */
static double segment(const double *p, const double *q)
{
	double dw = q[0] - p[0], da = q[1] - p[1], least = fmin(reach(p, q, 0.0), reach(p, q, 1.0));

	if (dw != 0.0)
		least = fmin(least, reach(p, q, -p[0]/dw));
	if (da != 0.0)
		least = fmin(least, reach(p, q, -p[1]/da));
	if (dw != da)
		least = fmin(least, reach(p, q, (p[1] - p[0])/(dw - da)));
	if (dw != -da)
		least = fmin(least, reach(p, q, -(p[0] + p[1])/(dw + da)));
	return least;
}

/* Distance from (w, a) to the refined curve, or `least` if it is larger. */
static double to_line(const struct line *line, double w, double a, double least)
{
	double p[2] = {line->wa[0] - w, line->wa[1] - a}, q[2];

	least = fmin(least, fmax(fabs(p[0]), fabs(p[1])));
	for (int k = 1; k < line->count; k++, p[0] = q[0], p[1] = q[1]) {
		q[0] = line->wa[2*k] - w;
		q[1] = line->wa[2*k + 1] - a;
		/* both ends are farther than `least` on one side, and so is the segment */
		if (fmin(p[0], q[0]) >= least || fmax(p[0], q[0]) <= -least ||
		    fmin(p[1], q[1]) >= least || fmax(p[1], q[1]) <= -least)
			continue;
		least = fmin(least, segment(p, q));
	}
	return least;
}

/* Largest distance of the points of one component of `a` from the curve `b`; ends [2]: range of w. */
static double one_way(const struct hawser__drawn_curve *a, const struct line *b, int column,
                      double scale, const double *ends)
{
	double most = 0.0;

	for (int i = 0; i < a->points; i++) {
		double w = at(a, i, 0), end = fmin(w - ends[0], ends[1] - w);

		if (end > most)
			most = fmax(most, to_line(b, w, at(a, i, column)/scale, end));
	}
	return most;
}

static void range(double *ends, const struct hawser__drawn_curve *curve)
{
	for (int i = 0; i < curve->points; i++) {
		ends[0] = fmin(ends[0], at(curve, i, 0));
		ends[1] = fmax(ends[1], at(curve, i, 0));
	}
}

static enum hawser_status compare(double *distance, const struct hawser__drawn_curve *a,
                                  const struct hawser__drawn_curve *b, int column, double scale,
                                  struct hawser_report *report)
{
	double ends[2] = {HUGE_VAL, -HUGE_VAL};
	struct line line_a = {0}, line_b = {0};
	enum hawser_status status = HAWSER_OK;

	range(ends, a);
	range(ends, b);
	if (refine(&line_a, a, column, scale) || refine(&line_b, b, column, scale)) {
		status = hawser__no_memory(report, "study");
	} else {
		*distance = fmax(*distance, one_way(a, &line_b, column, scale, ends));
		*distance = fmax(*distance, one_way(b, &line_a, column, scale, ends));
	}
	free(line_a.wa);
	free(line_b.wa);
	return status;
}

enum hawser_status hawser__curve_distance(double *distance, const struct hawser__drawn_curve *a,
                                          const struct hawser__drawn_curve *b,
                                          struct hawser_report *report)
{
	int width = a->width < b->width ? a->width : b->width;
	double most = 0.0;
	enum hawser_status status = HAWSER_OK;

	*distance = 0.0;
	if (a->points == 0 || b->points == 0)
		return HAWSER_OK;
	for (int c = 1; c <= width; c++)
		most = fmax(most, fmax(largest(a, c), largest(b, c)));
	for (int c = 1; !status && c <= width; c++) {
		double scale = fmax(largest(a, c), largest(b, c));

		if (counts(a, c, scale, most) || counts(b, c, scale, most))
			status = compare(distance, a, b, c, scale, report);
	}
	return status;
}

/* Whether column `column` has an extreme at point i. */
static int turns(const struct hawser__drawn_curve *curve, int i, int column)
{
	if (i < 1 || i + 1 >= curve->points)
		return 0;
	return (at(curve, i, column) - at(curve, i - 1, column))*
	       (at(curve, i + 1, column) - at(curve, i, column)) <= 0.0;
}

/* By what component c of counterpart i is off from its point. */
static double off(const struct hawser__drawn_curve *curve, const int *at_point,
                  const struct hawser__drawn_curve *a, const struct hawser__drawn_curve *b, int i,
                  int c)
{
	return at(b, i, c) - (a ? at(a, i, c) : at(curve, at_point[i], c));
}

/* By how much an extreme of component c near point at_point[i] is higher in the other response, where
 * that point's counterpart lies beside the top: with the factor 1 + h and moved by m in log Omega the
 * curve goes through the counterparts of three points, to first order
 *
 *    w' da - a' dw = w' a h - a' m,    w', a' its derivatives by arclength, dw, da what they are off
 *
 * by least squares. Relative to a peak that counts, or to the component. */
static double extreme_change(const struct hawser__drawn_curve *curve, const int *at_point,
                             const struct hawser__drawn_curve *a,
                             const struct hawser__drawn_curve *b, int i, int c, double scale)
{
	double top = at(curve, at_point[i], c), xx = 0.0, xy = 0.0, yy = 0.0, xz = 0.0, yz = 0.0;
	int highest = top >= at(curve, at_point[i] - 1, c);

	for (int k = i - 1; k <= i + 1 && i > 0 && i + 1 < b->points; k++) {
		double rise = slope(curve, at_point[k], c), pace = slope(curve, at_point[k], 0);
		double x = pace*at(curve, at_point[k], c), y = -rise;
		double z = pace*off(curve, at_point, a, b, k, c) - rise*off(curve, at_point, a, b, k, 0);

		xx += x*x;
		xy += x*y;
		yy += y*y;
		xz += x*z;
		yz += y*z;
	}
	top = highest ? top/fmax(top, counted_peak*scale) : top/scale;
	if (!(xx*yy - xy*xy > singular*xx*yy))
		return fabs(off(curve, at_point, a, b, i, c))/scale;
	return fabs((xz*yy - yz*xy)/(xx*yy - xy*xy))*top;
}

/* The same from the curve and the parabola through what three
 * counterparts are off. */
static double extreme_read(const struct hawser__drawn_curve *curve, const int *at_point,
                             const struct hawser__drawn_curve *a,
                             const struct hawser__drawn_curve *b, int i, int c, double scale)
{
	double d[3], s[3], top = -HUGE_VAL, other = -HUGE_VAL, side;

	if (i < 1 || i + 1 >= b->points)
		return fabs(off(curve, at_point, a, b, i, c))/scale;
	for (int k = 0; k < 3; k++) {
		d[k] = off(curve, at_point, a, b, i - 1 + k, c);
		s[k] = curve->arc[at_point[i - 1 + k]];
	}
	side = at(curve, at_point[i], c) >= at(curve, at_point[i] - 1, c) ? 1.0 : -1.0;
	for (int k = at_point[i - 1]*PARTS; k <= at_point[i + 1]*PARTS; k++) {
		int p = k/PARTS < curve->points - 1 ? k/PARTS : curve->points - 2;
		double x = (double)(k - p*PARTS)/PARTS, value = side*between(curve, p, x, c);
		double arc = curve->arc[p] + x*(curve->arc[p + 1] - curve->arc[p]);
		double by = d[0]*(arc - s[1])*(arc - s[2])/((s[0] - s[1])*(s[0] - s[2])) +
		            d[1]*(arc - s[0])*(arc - s[2])/((s[1] - s[0])*(s[1] - s[2])) +
		            d[2]*(arc - s[0])*(arc - s[1])/((s[2] - s[0])*(s[2] - s[1]));

		top = fmax(top, value);
		other = fmax(other, value + side*by);
	}
	return fabs(other - top)/(side > 0.0 ? fmax(top, counted_peak*scale) : scale);
}

enum hawser_status hawser__curve_points_distance(double *distance,
                                                 const struct hawser__drawn_curve *curve,
                                                 const int *at_point,
                                                 const struct hawser__drawn_curve *a,
                                                 const struct hawser__drawn_curve *b,
                                                 int peaks, struct hawser_report *report)
{
	double ends[2] = {HUGE_VAL, -HUGE_VAL}, most = 0.0;
	enum hawser_status status = HAWSER_OK;

	*distance = 0.0;
	range(ends, curve);
	for (int c = 1; c <= curve->width; c++)
		most = fmax(most, largest(curve, c));
	for (int c = 1; !status && c <= curve->width; c++) {
		double scale = largest(curve, c);
		struct line line = {0};

		if (!counts(curve, c, scale, most) || (peaks && !is_peak(curve, c)))
			continue;
		if (refine(&line, curve, c, scale))
			status = hawser__no_memory(report, "study");
		for (int i = 0; !status && i < b->points; i++) {
			double w = at(b, i, 0), size = at(b, i, c), end;

			if (a) {
				w += at(curve, at_point[i], 0) - at(a, i, 0);
				size += at(curve, at_point[i], c) - at(a, i, c);
			}
			end = fmin(w - ends[0], ends[1] - w);
			if (end > *distance)
				*distance = fmax(*distance, to_line(&line, w, size/scale, end));
			/* below a peak the curve's flanks are nearer than its top, and more so the sharper it is */
			if (end > *distance && at_point && turns(curve, at_point[i], c))
				*distance = fmax(*distance, fmax(extreme_change(curve, at_point, a, b, i, c, scale),
				                                 extreme_read(curve, at_point, a, b, i, c, scale)));
		}
		free(line.wa);
	}
	return status;
}

enum hawser_status hawser__curve_marks(int *marks, int *count, const struct hawser__drawn_curve *curve,
                                       struct hawser_report *report)
{
	double *scale = malloc(((size_t)curve->width + 1)*sizeof *scale), most = 0.0;
	double last = -HUGE_VAL;

	*count = 0;
	if (!scale)
		return hawser__no_memory(report, "study");
	for (int c = 1; c <= curve->width; c++)
		most = fmax(most, scale[c] = largest(curve, c));
	for (int i = 0; i < curve->points; i++) {
		int mark = 0;
		double size = 0.0;

		for (int c = 1; c <= curve->width; c++)
			if (counts(curve, c, scale[c], most)) {
				size = fmax(size, at(curve, i, c)/scale[c]);
				mark |= turns(curve, i, c);
			}
		mark |= turns(curve, i, 0) || curve->arc[i] - last >= apart;
		if (mark && size >= small) {
			marks[(*count)++] = i;
			last = curve->arc[i];
		}
	}
	free(scale);
	return HAWSER_OK;
}
