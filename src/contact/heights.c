/* contact/heights.c - beds by their heights at the points of a grid, or of a line along x.
 *
 * h(u, w)  height at x = u, z = w
 * b        of a line of the grid: within this distance of it the bed is rounded
 * p, n     the point of the bed nearest to a place, and the normal there
 * g        gap, n.(x - p): the signed distance, so that |n| = 1 and H*n = 0, as of all surfaces
 *
 * Between the lines of the grid h is linear along x and along z. At a line the slopes s on both sides
 * differ, and a parabola takes their place, which begins with them at b from the line:
 *   h = h_line + (s_left + s_right)/2*d + (s_right - s_left)*(d^2 + b^2)/(4*b), |d| <= b.
 * So the normal is continuous, as Newton's method needs it, a plane stays a plane, and the corner is
 * rounded by (s_right - s_left)*b/4. A polyline with sharp corners has no normal there, and on both
 * sides of one that points upwards the tensions of a mesh depend on where its nodes are.
 *
 * The nearest point is found by Newton's method from the one below or above the place. Where the bed
 * is curved upwards more than by 1/g, as far above a trough, there are several such points, and it is
 * one of them: there nothing touches. y - h or (y - h)*n_y, which need no such search, are no
 * distances: the first is not that of a plane, and the gradient of the second jumps where the
 * curvature does.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/heights.h"
#include "core/order.h"
#include "core/report.h"
#include "core/vec3.h"

enum { STEPS = 40, HALVES = 30 };
/* Of the coordinates: a step of this size ends the search. */
static const double ROUND = DBL_EPSILON, FEW = 1e3; /* FEW: where steps may get no shorter */
/* Of the square of the distance: more is no step down. Near the end the steps, which are exact to
 * round-off, are too short for the distance to tell. */
static const double NO_MORE = 1e-9;
/* Of the metric: a curvature that leaves less is that of a place above a centre of curvature. */
static const double LEAST = 1e-3;
/* Of the coordinates: so near to the edge a place is at it. */
static const double EDGE = 1e-9;
/* Of the size of the heights: differences of slopes that are round-off. */
static const double STRAIGHT = 1e-12;

/* Where a coordinate is: between two lines, or in the rounding of the middle one of three. */
struct within {
	int first, count;
	double d, l[2], b;
};

static void locate(struct within *at, const double *x, const double *round, int n, double value)
{
	int low = hawser__interval(x, n - 1, value), line;

	*at = (struct within){.count = n < 2 ? n : 2};
	if (n < 2)
		return;
	line = fabs(value - x[low]) < round[low] ? low
		: fabs(value - x[low + 1]) < round[low + 1] ? low + 1 : -1;
	at->first = line < 0 ? low : line - 1;
	at->d = value - x[line < 0 ? low : line];
	at->l[0] = x[at->first + 1] - x[at->first];
	if (line < 0)
		return;
	at->count = 3;
	at->l[1] = x[line + 1] - x[line];
	at->b = round[line];
}

/* f: value, first and second derivative of what has these values at the lines. */
static void smooth(double f[3], const struct within *at, const double *value)
{
	double left, right;

	memset(f, 0, 3*sizeof *f);
	f[0] = value[at->count == 3];
	if (at->count < 2)
		return;
	left = (value[1] - value[0])/at->l[0];
	if (at->count == 2) {
		f[0] += left*at->d;
		f[1] = left;
		return;
	}
	right = (value[2] - value[1])/at->l[1];
	f[2] = 0.5*(right - left)/at->b;
	f[1] = 0.5*(left + right) + f[2]*at->d;
	f[0] += 0.5*(left + right)*at->d + 0.5*f[2]*(at->d*at->d + at->b*at->b);
}

/* Height with its derivatives by u and w. */
struct bed {
	double h, by[2], twice[2][2];
};

static void bed_at(struct bed *bed, const struct hawser_heights *of, double u, double w)
{
	struct within along, across;
	double lines[3][3], f[3][3]; /* by u: derivative, line along z; both derivatives */

	locate(&along, of->x, of->round_x, of->nx, u);
	locate(&across, of->z, of->round_z, of->nz, w);
	for (int j = 0; j < across.count; j++) {
		double own[3];

		smooth(own, &along, &of->y[(across.first + j)*of->nx + along.first]);
		for (int k = 0; k < 3; k++)
			lines[k][j] = own[k];
	}
	for (int k = 0; k < 3; k++)
		smooth(f[k], &across, lines[k]);
	bed->h = f[0][0];
	bed->by[0] = f[1][0];
	bed->by[1] = f[0][1];
	bed->twice[0][0] = f[2][0];
	bed->twice[0][1] = bed->twice[1][0] = f[1][1];
	bed->twice[1][1] = f[0][2];
}

double hawser_heights_at(const struct hawser_heights *heights, double x, double z)
{
	struct bed bed;

	bed_at(&bed, heights, x, z);
	return bed.h;
}

/* A step of Newton's method for the least distance, or one that leads down. */
static void step_of(double step[2], const struct bed *bed, const double r[3])
{
	double A[2][2], down[2], det;

	for (int i = 0; i < 2; i++) {
		down[i] = r[2*i] + r[1]*bed->by[i];
		for (int j = 0; j < 2; j++)
			A[i][j] = (i == j ? 1.0 : 0.0) + bed->by[i]*bed->by[j] - r[1]*bed->twice[i][j];
	}
	det = A[0][0]*A[1][1] - A[0][1]*A[1][0];
	if (!(A[0][0] > LEAST && det > LEAST*A[0][0])) {
		for (int i = 0; i < 4; i++)
			A[i/2][i % 2] += r[1]*bed->twice[i/2][i % 2];
		det = A[0][0]*A[1][1] - A[0][1]*A[1][0];
	}
	step[0] = (A[1][1]*down[0] - A[0][1]*down[1])/det;
	step[1] = (A[0][0]*down[1] - A[1][0]*down[0])/det;
}

/* From the place of a point of the bed to x, and half the square of the distance. */
static double apart(double r[3], const struct bed *bed, const double at[2], const double x[3])
{
	r[0] = x[0] - at[0];
	r[1] = x[1] - bed->h;
	r[2] = x[2] - at[1];
	return 0.5*hawser__dot(r, r);
}

static void nearest(struct bed *bed, double r[3], const struct hawser_heights *of, const double x[3])
{
	const double floor = ROUND*(fabs(x[0]) + fabs(x[1]) + fabs(x[2]));
	double at[2] = {x[0], x[2]}, square, last = INFINITY;

	bed_at(bed, of, at[0], at[1]);
	square = apart(r, bed, at, x);
	for (int i = 0; i < STEPS; i++) {
		double step[2], part = 1.0, size, now = INFINITY;

		step_of(step, bed, r);
		size = hypot(step[0], step[1]);
		if (!(size > floor) || (size < FEW*floor && size > 0.5*last))
			return;
		for (int k = 0; k < HALVES && !(now <= square*(1.0 + NO_MORE)); k++) {
			double to[2] = {at[0] + part*step[0], at[1] + part*step[1]};

			bed_at(bed, of, to[0], to[1]);
			now = apart(r, bed, to, x);
			part *= 0.5;
		}
		for (int k = 0; k < 2; k++)
			at[k] += 2.0*part*step[k];
		square = fmin(square, now);
		last = size;
	}
}

/* The derivatives of the normal: A*du = J'*dx for the nearest point, J its derivatives. */
static void curvature(double (*H)[3], const struct bed *bed, const double n[3], double g)
{
	const double size = 1.0/n[1];
	double A[2][2], N[2][3], J[2][3] = {{1.0, bed->by[0], 0.0}, {0.0, bed->by[1], 1.0}}, det;

	for (int i = 0; i < 2; i++) {
		const double m[3] = {-bed->twice[i][0], 0.0, -bed->twice[i][1]};
		double along = hawser__dot(m, n);

		for (int k = 0; k < 3; k++)
			N[i][k] = (m[k] - along*n[k])/size;
		for (int j = 0; j < 2; j++)
			A[i][j] = hawser__dot(J[i], J[j]) - g*n[1]*bed->twice[i][j];
	}
	det = A[0][0]*A[1][1] - A[0][1]*A[1][0];
	if (!(A[0][0] > LEAST && det > LEAST*A[0][0]))
		det = INFINITY;
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			H[i][j] = (N[0][i]*(A[1][1]*J[0][j] - A[0][1]*J[1][j]) +
			           N[1][i]*(A[0][0]*J[1][j] - A[1][0]*J[0][j]))/det;
}

double hawser__heights_gap(double n[3], double (*H)[3], const struct hawser_heights *of,
                           const double x[3])
{
	struct bed bed;
	double r[3], g, size;

	nearest(&bed, r, of, x);
	size = sqrt(1.0 + bed.by[0]*bed.by[0] + bed.by[1]*bed.by[1]);
	n[0] = -bed.by[0]/size;
	n[1] = 1.0/size;
	n[2] = -bed.by[1]/size;
	g = hawser__dot(n, r);
	if (H)
		curvature(H, &bed, n, g);
	return g;
}

int hawser_surface_beyond(const struct hawser_surface *surface, const double *x)
{
	const struct hawser_heights *of = surface->heights;
	const double room = EDGE*(fabs(x[0]) + fabs(x[2]) + fabs(surface->at[0]) + fabs(surface->at[2]));

	return of && (x[0] < of->x[0] - room || x[0] > of->x[of->nx - 1] + room ||
	              (of->nz > 1 && (x[2] < of->z[0] - room || x[2] > of->z[of->nz - 1] + room)));
}

/* Where the roundings of the lines begin; none at the first and last one. */
static void roundings(double *round, const double *x, int n, double most)
{
	for (int i = 0; i < n; i++)
		round[i] = i == 0 || i + 1 == n ? 0.0
			: fmin(most, 0.5*fmin(x[i] - x[i - 1], x[i + 1] - x[i]));
}

void hawser__heights_round(struct hawser_heights *of, double round)
{
	roundings(of->round_x, of->x, of->nx, round);
	roundings(of->round_z, of->z, of->nz, round);
}

/* 1 if the second differences of one direction, n values apart by `stride`, are not below 0. */
static int rises(const double *x, const double *y, int n, int stride, double size)
{
	int is = 1;

	for (int i = 1; i + 1 < n; i++) {
		double left = (y[i*stride] - y[(i - 1)*stride])/(x[i] - x[i - 1]);
		double right = (y[(i + 1)*stride] - y[i*stride])/(x[i + 1] - x[i]);

		is = is && right - left >= -STRAIGHT*size/fmin(x[i] - x[i - 1], x[i + 1] - x[i]);
	}
	return is;
}

/* 1 if the bed is a sum of functions of x and z that curve upwards: the space above is convex. */
static int convex(const struct hawser_heights *of)
{
	double size = 0.0;
	int is = 1;

	for (int i = 0; i < of->nx*of->nz; i++)
		size = fmax(size, fabs(of->y[i]));
	for (int j = 1; j < of->nz; j++)
		for (int i = 1; i < of->nx; i++) {
			const double *y = &of->y[j*of->nx + i];

			is = is && fabs(y[0] - y[-1] - y[-of->nx] + y[-of->nx - 1]) <= STRAIGHT*size;
		}
	return is && rises(of->x, of->y, of->nx, 1, size) && rises(of->z, of->y, of->nz, of->nx, size);
}

static enum hawser_status rising(const char *name, const double *x, int n, struct hawser_report *report)
{
	for (int i = 0; i < n; i++) {
		if (!isfinite(x[i]))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "contact", "%s number %d is not finite",
			                    name, i + 1);
		if (i > 0 && !(x[i] > x[i - 1]))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "contact", "%s number %d, %.9g m, is not "
			                    "above the one before, %.9g m: sort them upwards", name, i + 1, x[i],
			                    x[i - 1]);
	}
	return HAWSER_OK;
}

enum hawser_status hawser_heights_make(struct hawser_heights **heights, int nx, const double *x,
                                       int nz, const double *z, const double *y, double round,
                                       struct hawser_report *report)
{
	size_t points = (size_t)nx*(size_t)nz, lines = (size_t)nx + (size_t)nz;
	struct hawser_heights *of;
	enum hawser_status status;

	*heights = NULL;
	if (nx < 2 || nz < 1 || !(round >= 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "contact", "a bed of %d by %d points, rounded "
		                    "over %g m: it needs two or more along x, one or more along z, and a "
		                    "length from 0 on", nx, nz, round);
	status = rising("x", x, nx, report);
	if (!status && nz > 1)
		status = rising("z", z, nz, report);
	for (size_t i = 0; i < points && !status; i++)
		if (!isfinite(y[i]))
			status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "contact", "height number %zu is not "
			                      "finite", i + 1);
	if (status)
		return status;
	of = calloc(1, sizeof *of);
	if (of)
		of->x = calloc(2*lines + points, sizeof *of->x);
	if (!of || !of->x) {
		free(of);
		return hawser__no_memory(report, "contact");
	}
	of->nx = nx;
	of->nz = nz;
	of->z = of->x + nx;
	of->round_x = of->z + nz;
	of->round_z = of->round_x + nx;
	of->y = of->round_z + nz;
	memcpy(of->x, x, (size_t)nx*sizeof *x);
	if (nz > 1)
		memcpy(of->z, z, (size_t)nz*sizeof *z);
	memcpy(of->y, y, points*sizeof *y);
	hawser__heights_round(of, round);
	of->convex = convex(of);
	*heights = of;
	return HAWSER_OK;
}

void hawser_heights_free(struct hawser_heights *heights)
{
	if (heights)
		free(heights->x);
	free(heights);
}
