/* Obstacles: gaps of points, their gradients and second derivatives against central differences of the
 * gap, surface velocities against where the gap is constant, and what is refused.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <hawser/surface.h>

#include "tests/tap.h"

#define STEP 1e-5 /* m, of central differences: errors of 1e-10 for curvatures of 1/m */

static const struct hawser_surface shapes[] = {
	{.name = "plane", .at = {0.3, -1.2, 0.1}, .normal = {0.2, 2.0, -0.4}, .velocity = {2.0, 0.0, 1.0}},
	{.name = "table", .kind = HAWSER_SURFACE_SEGMENT, .at = {-1.0, 0.2}, .to = {2.385, 0.7},
	 .speed = 1.5},
	{.name = "ceiling", .kind = HAWSER_SURFACE_SEGMENT, .side = HAWSER_SIDE_BELOW, .at = {-1.0, 0.2},
	 .to = {2.385, 0.7}, .speed = -1.5},
	{.name = "wall", .kind = HAWSER_SURFACE_SEGMENT, .side = HAWSER_SIDE_RIGHT, .at = {0.1, 3.0},
	 .to = {0.1, -2.0}, .speed = 0.7},
	{.name = "sheave", .kind = HAWSER_SURFACE_CIRCLE, .at = {0.4, -0.3}, .radius = 1.385, .speed = 2.0},
	{.name = "pipe", .kind = HAWSER_SURFACE_CIRCLE, .side = HAWSER_SIDE_INSIDE, .at = {0.4, -0.3},
	 .radius = 5.0, .speed = 2.0},
};
enum { SHAPES = sizeof shapes/sizeof *shapes };
static const double points[][3] = {{0.385, 1.9, 0.3}, {-2.1, 0.9, -0.2}, {3.1, 1.1, 0.0},
                                   {0.2, -0.7, 0.6}, {1.7, -2.3, -1.1}, {2.385, 2.385, 2.385}};
enum { POINTS = sizeof points/sizeof *points };

/* Largest errors of gradient and second derivatives, and of the gradient's length. */
static void differences(double error[3], const struct hawser_surface *surface, const double x[3])
{
	double n[3], H[3][3];

	hawser_surface_gap(n, H, surface, x);
	error[2] = fmax(error[2], fabs(sqrt(n[0]*n[0] + n[1]*n[1] + n[2]*n[2]) - 1.0));
	for (int k = 0; k < 3; k++) {
		double up[3] = {x[0], x[1], x[2]}, down[3] = {x[0], x[1], x[2]}, a[3], b[3], g;

		up[k] += STEP;
		down[k] -= STEP;
		g = hawser_surface_gap(a, NULL, surface, up) - hawser_surface_gap(b, NULL, surface, down);
		error[0] = fmax(error[0], fabs(g/(2.0*STEP) - n[k]));
		for (int j = 0; j < 3; j++)
			error[1] = fmax(error[1], fabs((a[j] - b[j])/(2.0*STEP) - H[j][k]));
	}
}

static void shape(const struct hawser_surface *given)
{
	struct hawser_surface surface = *given;
	struct hawser_report report;
	double error[3] = {0}, across = 0.0, speed = 0.0, least = 0.0;

	ok(!hawser_surface_settle(&surface, &report), "%s is accepted", surface.name);
	for (int i = 0; i < POINTS; i++) {
		double n[3], v[3], x[3];

		differences(error, &surface, points[i]);
		memcpy(x, points[i], sizeof x);
		hawser_surface_clear_of(x, &surface);
		least = fmin(least, hawser_surface_gap(n, NULL, &surface, x));
		if (given->kind == HAWSER_SURFACE_SEGMENT && i > 0)
			continue; /* beyond its ends */
		hawser_surface_gap(n, NULL, &surface, points[i]);
		hawser_surface_velocity(v, &surface, points[i]);
		across = fmax(across, fabs(n[0]*v[0] + n[1]*v[1] + n[2]*v[2]));
		speed = sqrt(v[0]*v[0] + v[1]*v[1] + v[2]*v[2]);
	}
	ok(error[0] < 1e-9 && error[1] < 1e-8 && error[2] < 1e-15, "%s: gradient and second derivatives "
	   "are those of the gap", surface.name);
	ok(across < 1e-14 && speed > 0.5, "%s: its surface moves along itself", surface.name);
	ok(least > -1e-15, "%s: points inside or behind it are brought to the free side", surface.name);
}

static double spread(const double *x)
{
	return 0.3*x[0]*x[0] - 0.4*x[0]*x[2] + 0.2*x[2]*x[2] - 0.5*x[0];
}

/* Beds: above and below roundings, between lines, and beyond the points. */
static void beds(void)
{
	static const double x[] = {-3.0, -1.385, 0.2, 1.1, 4.0}, z[] = {-2.0, -0.3, 0.9, 2.385};
	static const double off[] = {-0.05, 0.0, 0.02, 0.05}; /* m, less than the radii of curvature */
	double y[20], error[3] = {0}, most = 0.0;
	struct hawser_report report;

	for (int i = 0; i < 20; i++)
		y[i] = spread((double[]){x[i % 5], 0.0, z[i/5]});
	for (int lines = 1; lines <= 4; lines += 3) {
		struct hawser_surface bed = {.name = "bed", .kind = lines > 1 ? HAWSER_SURFACE_GRID
			: HAWSER_SURFACE_PROFILE, .friction = 0.5};

		ok(!hawser_heights_make(&bed.heights, 5, x, lines, z, y, 0.35, &report) &&
		   !hawser_surface_settle(&bed, &report), "a bed of %d lines", lines);
		for (int i = 0; i < 140; i++) {
			double at[3] = {-3.4 + 0.413*(i % 20), 0.0, -2.3 + 0.759*(i/20)}, n[3], g;

			at[1] = hawser_heights_at(bed.heights, at[0], at[2]) + off[i % 4];
			differences(error, &bed, at);
			g = hawser_surface_gap(n, NULL, &bed, at);
			for (int k = 0; k < 3; k++)
				at[k] -= g*n[k];
			most = fmax(most, fabs(at[1] - hawser_heights_at(bed.heights, at[0], at[2])));
		}
		hawser_heights_free(bed.heights);
	}
	ok(error[0] < 1e-9 && error[1] < 1e-7 && error[2] < 1e-15, "beds: gradient and second derivatives "
	   "are those of the gap, to %.1e, %.1e, %.1e", error[0], error[1], error[2]);
	ok(most < 1e-14, "the nearest point is on the bed, to %.1e m", most);
}

static void gaps(void)
{
	struct hawser_surface sheave = shapes[4], table = shapes[1], pipe = shapes[5];
	struct hawser_report report;
	double n[3];

	ok(!hawser_surface_settle(&sheave, &report) && !hawser_surface_settle(&table, &report),
	   "circle and segment");
	close_to(hawser_surface_gap(n, NULL, &sheave, (double[3]){0.4 + 3.0, -0.3 + 4.0, 7.0}), 5.0 - 1.385,
	         1e-15, "gap of a circle, whatever z");
	close_to(hawser_surface_gap(n, NULL, &pipe, (double[3]){0.4 + 3.0, -0.3, 7.0}), 2.0, 1e-15,
	         "gap inside a pipe");
	close_to(hawser_surface_gap(n, NULL, &table, (double[3]){2.385 + 3.0, 0.7 - 4.0, 0.0}), 5.0, 1e-15,
	         "beyond its end a segment is at the distance of the end");
	ok(hawser_surface_gap(n, NULL, &table, (double[3]){0.0, 0.0, 0.0}) < 0.0, "below a table the gap "
	   "is negative");
	ok(hawser_surface_convex(&pipe) && hawser_surface_convex(&shapes[0]) &&
	   !hawser_surface_convex(&sheave) && !hawser_surface_convex(&table),
	   "planes and pipes leave a convex space");
	hawser_surface_gap(n, NULL, &sheave, sheave.at);
	close_to(n[1], 1.0, 0.0, "at the centre the direction is defined");
}

static void refused(const struct hawser_surface *surface, const char *word)
{
	struct hawser_surface copy = *surface;
	struct hawser_report report;

	ok(hawser_surface_settle(&copy, &report) == HAWSER_ERR_ARGUMENT && strstr(report.message, word),
	   "refused: %s", report.message);
}

static void refusals(void)
{
	struct hawser_surface plane = shapes[0], table = shapes[1], circle = shapes[4];

	plane.normal[1] = NAN;
	refused(&plane, "finite");
	memset(plane.normal, 0, sizeof plane.normal);
	refused(&plane, "normal");
	plane = shapes[0];
	plane.velocity[1] = 1.0;
	refused(&plane, "velocity");
	plane = shapes[0];
	plane.friction = INFINITY;
	refused(&plane, "finite");
	memcpy(table.to, table.at, sizeof table.to);
	refused(&table, "one point");
	table = shapes[1];
	table.side = HAWSER_SIDE_LEFT;
	refused(&table, "above or below");
	table.side = HAWSER_SIDE_INSIDE;
	refused(&table, "inside");
	circle.side = HAWSER_SIDE_INSIDE;
	circle.radius = 0.0;
	refused(&circle, "no room");
}

CASE(unit_surface)
{
	for (int i = 0; i < SHAPES; i++)
		shape(&shapes[i]);
	beds();
	gaps();
	refusals();
	return done_testing();
}
