/* study/hill/mathieu_matrix.c - see hill.h.
 *
 * At a boundary the motion is x = sum over k of x_k exp(i k t), k odd or even, and harmonic balance
 * without truncation reads
 *
 *      (delta - k^2 + 2 i c k) x_k + epsilon (x_{k-2} + x_{k+2}) = 0
 *
 * Without damping cosines and sines are not coupled, and delta is an eigenvalue of a symmetric
 * tridiagonal matrix for each of them. The two edges of a tongue are eigenvalues of different
 * matrices, so that both are found whatever their distance is.
 *
 * With damping let x = exp(-c t) z: z satisfies the equation without damping for delta - c^2, and
 * its growth must be c. A tongue with damping therefore lies within the undamped one shifted by
 * c^2. In it, elimination from high harmonics down,
 *
 *      g_k = delta - k^2 + 2 i c k - epsilon^2/g_{k+2},
 *
 * yields f = delta - 2 epsilon^2 Re(1/g_2) or f = |g_1|^2 - epsilon^2, which is negative if the
 * motion is unstable. f is smooth, since Im g_k > 0 for c > 0.
 *
 * In a narrow tongue f is of the order of the square of its width and lost in round-off. There the
 * harmonics other than r and -r are eliminated, both those above and those between, which leaves
 *
 *      |G|^2 - H^2 = 0,   G = delta - r^2 + 2 i c r - ...,   H = epsilon^r/(product of pivots)
 *
 * so that Re G = +-sqrt(H^2 - (Im G)^2), in which each term has a small relative error. A narrow
 * tongue is far from the others, so that no pivot is small.
 *
 * Reference: McLachlan, Theory and Application of Mathieu Functions, 1947, ch. III and IV.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>

#include "study/hill/hill.h"

#define NARROW 1e-3  /* width of a tongue below which f is not used: its square is then 1e-6, so
                      * that f keeps ten digits */
#define MORE 8       /* additional harmonics for the estimate of the truncation error; chosen */
#define MOST_TRIALS 200 /* largest number of steps of the secant method, which needs 6 to 10 */

/* --- without damping --- */

static enum hawser_status undamped(double edge[2], int r, double epsilon, int top,
                                   struct hawser_report *report)
{
	enum hawser_status status = hawser__mathieu_eigenvalue(&edge[1], r, 0, epsilon, top, report);

	edge[0] = edge[1];
	if (!status && r > 0)
		status = hawser__mathieu_eigenvalue(&edge[0], r, 1, epsilon, top, report);
	if (edge[0] > edge[1]) { /* for epsilon < 0, or by round-off */
		double keep = edge[0];

		edge[0] = edge[1];
		edge[1] = keep;
	}
	return status;
}

/* --- narrow tongues --- */

struct reduced {
	double re, im, coupling; /* G, |H| */
};

static double complex diagonal(double delta, double c, int k)
{
	return delta - (double)k*k + 2.0*I*c*k;
}

/* 1/z; the division of C guards against overflow, which takes ten times as long. */
static double complex inverse(double complex z)
{
	double re = creal(z), im = cimag(z), over = 1.0/(re*re + im*im);

	return re*over - I*(im*over);
}

static double complex from_above(double delta, double epsilon, double c, int k, int top)
{
	double complex g = diagonal(delta, c, top);

	for (int h = top - 2; h >= k; h -= 2)
		g = diagonal(delta, c, h) - epsilon*epsilon*inverse(g);
	return g;
}

static struct reduced reduce(double delta, double epsilon, double c, int r, int top)
{
	double complex G = from_above(delta, epsilon, c, r, top), pivot = 0.0;
	double coupling = fabs(epsilon);

	for (int k = 2 - r; k <= r - 2; k += 2) {
		pivot = diagonal(delta, c, k) - (k > 2 - r ? epsilon*epsilon*inverse(pivot) : 0.0);
		coupling *= fabs(epsilon)/cabs(pivot);
	}
	if (r > 1)
		G -= epsilon*epsilon*inverse(pivot);
	return (struct reduced){creal(G), cimag(G), coupling};
}

/* Solve Re G = side*sqrt(H^2 - (Im G)^2) from the initial value *delta; side 0: the middle. Returns
 * H^2 - (Im G)^2 there. The slope of Re G is 1 up to terms of the order of (epsilon/r)^2. */
static double settle(double *delta, double epsilon, double c, int r, int top, int side)
{
	double inside = 0.0, before = 0.0, f_before = 0.0, slope = 1.0;

	for (int i = 0; i < MOST_TRIALS; i++) {
		struct reduced at = reduce(*delta, epsilon, c, r, top);
		double f, step;

		inside = (at.coupling - at.im)*(at.coupling + at.im);
		f = at.re - side*sqrt(fmax(inside, 0.0));
		if (i && *delta != before && f != f_before)
			slope = (f - f_before)/(*delta - before);
		before = *delta;
		f_before = f;
		step = f/slope;
		*delta -= step;
		if (fabs(step) <= 1e-16*fabs(*delta))
			break;
	}
	return inside;
}

static double slope_of(double delta, double epsilon, int r, int top)
{
	double h = 1e-4;

	return (reduce(delta + h, epsilon, 0.0, r, top).re - reduce(delta - h, epsilon, 0.0, r, top).re)/
	       (2.0*h);
}

/* --- wide tongues --- */

/* The test function f: negative if the motion is unstable. */
static double test(double delta, double epsilon, double c, int r, int top)
{
	double complex g = from_above(delta, epsilon, c, r%2 ? 1 : 2, top);

	if (r%2)
		return (cabs(g) - fabs(epsilon))*(cabs(g) + fabs(epsilon));
	return delta - 2.0*epsilon*epsilon*creal(inverse(g));
}

/* The root between a, where the motion is stable, and b, where it is unstable. */
static double bisect(double a, double b, double epsilon, double c, int r, int top)
{
	for (int i = 0; i < MOST_TRIALS; i++) {
		double middle = 0.5*(a + b);

		if (middle == a || middle == b)
			break;
		if (test(middle, epsilon, c, r, top) < 0.0)
			b = middle;
		else
			a = middle;
	}
	return 0.5*(a + b);
}

/* The minimum of f in [a, b] by golden sections, or the first negative value. */
static double lowest(double *at, double a, double b, double epsilon, double c, int r, int top)
{
	const double golden = 0.3819660112501051;
	double s = a + golden*(b - a), t = b - golden*(b - a);
	double fs = test(s, epsilon, c, r, top), ft = test(t, epsilon, c, r, top);

	for (int i = 0; i < 60 && fs >= 0.0 && ft >= 0.0; i++)
		if (fs < ft) {
			b = t;
			t = s;
			ft = fs;
			s = a + golden*(b - a);
			fs = test(s, epsilon, c, r, top);
		} else {
			a = s;
			s = t;
			fs = ft;
			t = b - golden*(b - a);
			ft = test(t, epsilon, c, r, top);
		}
	*at = fs < ft ? s : t;
	return fmin(fs, ft);
}

/* --- narrow and wide tongues --- */

/* With damping; edge [2] has the edges without damping. */
static int damp(double edge[2], double *width, int r, double epsilon, double c, int top)
{
	double low = edge[0] + c*c, high = edge[1] + c*c, middle = 0.5*(low + high);

	if (r == 0) {
		double below = 1.0;

		while (test(high - below, epsilon, c, r, top) >= 0.0 && below < 1e12)
			below *= 2.0;
		edge[0] = edge[1] = bisect(high, high - below, epsilon, c, r, top);
		*width = 0.0;
		return 1;
	}
	edge[0] = edge[1] = middle;
	if (high - low < NARROW) {
		double inside = settle(&middle, epsilon, c, r, top, 0);

		edge[0] = edge[1] = middle;
		*width = 2.0*sqrt(fmax(inside, 0.0))/slope_of(middle, epsilon, r, top);
		for (int k = 0; inside > 0.0 && k < 2; k++)
			settle(&edge[k], epsilon, c, r, top, k ? 1 : -1);
		return inside > 0.0;
	}
	*width = 0.0;
	if (lowest(&middle, low, high, epsilon, c, r, top) >= 0.0)
		return 0;
	edge[0] = bisect(low, middle, epsilon, c, r, top);
	edge[1] = bisect(high, middle, epsilon, c, r, top);
	*width = edge[1] - edge[0];
	return 1;
}

static enum hawser_status solve(struct hawser__tongue *tongue, int r, double epsilon, double c,
                                int top, struct hawser_report *report)
{
	enum hawser_status status = undamped(tongue->edge, r, epsilon, top, report);

	if (status)
		return status;
	tongue->width = tongue->edge[1] - tongue->edge[0];
	if (r > 0 && tongue->width < NARROW && epsilon != 0.0) {
		double middle = 0.5*(tongue->edge[0] + tongue->edge[1]);
		double half = sqrt(fmax(settle(&middle, epsilon, 0.0, r, top, 0), 0.0));

		tongue->width = 2.0*half/slope_of(middle, epsilon, r, top);
	}
	tongue->open = r == 0 || tongue->width > 0.0;
	if (c > 0.0)
		tongue->open = damp(tongue->edge, &tongue->width, r, epsilon, c, top);
	return HAWSER_OK;
}

enum hawser_status hawser__mathieu_tongue(struct hawser__tongue *tongue, int r, double epsilon,
                                          double c, int certain, struct hawser_report *report)
{
	int top = hawser__mathieu_highest(r, epsilon);
	struct hawser__tongue finer;
	enum hawser_status status;

	top += (top - r)%2;
	tongue->truncation = 0.0;
	status = solve(tongue, r, epsilon, c, top, report);
	if (!status && certain)
		status = solve(&finer, r, epsilon, c, top + MORE, report);
	if (!status && certain)
		tongue->truncation = fmax(fabs(finer.edge[0] - tongue->edge[0]),
		                          fabs(finer.edge[1] - tongue->edge[1]));
	return status;
}
