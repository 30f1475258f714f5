/* Drag of a line and of a ring: closed forms, and derivatives against differences.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include <hawser/drag.h>

#include "tests/tap.h"

static const struct hawser_drag cable = {1.2, 0.004, 1.3, 0.02};

/* Largest entry of the difference of two matrices, over the largest of the first. */
static double distance(double (*a)[3], double (*b)[3])
{
	double largest = 0.0, difference = 0.0;

	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++) {
			largest = fmax(largest, fabs(a[i][j]));
			difference = fmax(difference, fabs(a[i][j] - b[i][j]));
		}
	return difference/fmax(largest, 1e-300);
}

static void line(void)
{
	const double along[3] = {0.0, -1.0, 0.0}, wind[3] = {13.0, 0.0, 0.0}, down[3] = {0.0, -7.0, 0.0};
	double f[3], f_u[3][3], f_x[3][3], worst = 0.0, h = 1e-6;

	hawser_drag_line(f, NULL, NULL, &cable, wind, along);
	close_to(f[0], 0.5*1.2*1.3*0.008*13.0*13.0, 1e-15, "across: cn d/2 density V^2");
	hawser_drag_line(f, f_u, f_x, &cable, down, along);
	close_to(-f[1], 0.5*1.2*0.02*acos(-1.0)*0.008*49.0, 1e-14, "along: ct pi d/2 density V^2");
	ok(f[0] == 0.0 && f[2] == 0.0 && f_u[0][0] == 0.0, "no normal flow: no force, no derivative");
	hawser_drag_line(f, f_u, f_x, &cable, f, (const double [3]){3.0, 0.0, 0.0});
	memset(f, 0, sizeof f);
	hawser_drag_line(f, f_u, f_x, &cable, (const double [3]){0.0}, along);
	ok(f[0] == 0.0 && f_u[1][1] == 0.0 && f_x[2][0] == 0.0, "calm air: nothing, and no NaN");
	for (int k = 0; k < 20; k++) {
		double u[3] = {3.0*sin(k), 4.0*cos(2.3*k), 5.0*sin(1.7*k + 1.0)};
		double x[3] = {cos(1.1*k), 1.7*sin(k), 0.6*cos(0.3*k)}, by_u[3][3], by_x[3][3];

		hawser_drag_line(f, f_u, f_x, &cable, u, x);
		for (int j = 0; j < 3; j++) {
			double up[3], down_[3], keep = u[j];

			u[j] = keep + h;
			hawser_drag_line(up, NULL, NULL, &cable, u, x);
			u[j] = keep - h;
			hawser_drag_line(down_, NULL, NULL, &cable, u, x);
			u[j] = keep;
			for (int i = 0; i < 3; i++)
				by_u[i][j] = (up[i] - down_[i])/(2.0*h);
			keep = x[j];
			x[j] = keep + h;
			hawser_drag_line(up, NULL, NULL, &cable, u, x);
			x[j] = keep - h;
			hawser_drag_line(down_, NULL, NULL, &cable, u, x);
			x[j] = keep;
			for (int i = 0; i < 3; i++)
				by_x[i][j] = (up[i] - down_[i])/(2.0*h);
		}
		worst = fmax(worst, fmax(distance(f_u, by_u), distance(f_x, by_x)));
	}
	ok(worst < 1e-7, "derivatives by the flow and by x': %.1e from differences", worst);
}

/* The axis after a small rotation about unit vector j. */
static void turned(double *to, const double *axis, int j, double angle)
{
	double unit[3] = {j == 0, j == 1, j == 2};

	for (int i = 0; i < 3; i++) {
		int a = (i + 1)%3, b = (i + 2)%3;

		to[i] = axis[i]*cos(angle) + (unit[a]*axis[b] - unit[b]*axis[a])*sin(angle) +
		        unit[i]*axis[j]*(1.0 - cos(angle));
	}
}

static void ring_derivatives(void)
{
	/* so many segments that it does not matter where they begin */
	struct hawser_ring ring = {1.1, 2000, {1.2, 0.05, 1.3, 0.03}};
	double u[3] = {7.0, -2.0, 3.0}, axis[3] = {0.48, -0.64, 0.6}, spin[3] = {0.9, 0.4, -1.2};
	double diff[6][3][3], h = 1e-5;
	struct hawser_ring_drag at, up, down;

	hawser_ring_drag(&at, &ring, u, axis, spin);
	for (int what = 0; what < 3; what++)
		for (int j = 0; j < 3; j++) {
			double other[3], *by = what == 0 ? u : what == 1 ? spin : NULL, keep = by ? by[j] : 0.0;

			if (by)
				by[j] = keep + h;
			turned(other, axis, j, by ? 0.0 : h);
			hawser_ring_drag(&up, &ring, u, other, spin);
			if (by)
				by[j] = keep - h;
			turned(other, axis, j, by ? 0.0 : -h);
			hawser_ring_drag(&down, &ring, u, other, spin);
			if (by)
				by[j] = keep;
			for (int i = 0; i < 3; i++) {
				diff[what][i][j] = (up.force[i] - down.force[i])/(2.0*h);
				diff[3 + what][i][j] = (up.moment[i] - down.moment[i])/(2.0*h);
			}
		}
	ok(distance(at.force_u, diff[0]) < 1e-7 && distance(at.moment_u, diff[3]) < 1e-7,
	   "ring: derivatives by the flow");
	ok(distance(at.force_spin, diff[1]) < 1e-7 && distance(at.moment_spin, diff[4]) < 1e-7,
	   "by the angular velocity");
	ok(distance(at.force_turn, diff[2]) < 1e-5 && distance(at.moment_turn, diff[5]) < 1e-5,
	   "by a rotation: %.1e, %.1e", distance(at.force_turn, diff[2]),
	   distance(at.moment_turn, diff[5]));
}

static void ring_closed_forms(void)
{
	struct hawser_ring ring = {11.0, 0, {1.2, 0.07, 1.2, 0.0}};
	const double still[3] = {0.0}, down[3] = {0.0, -25.74, 0.0}, wind[3] = {27.8, 0.0, 0.0},
	             axis[3] = {0.0, -1.0, 0.0};
	struct hawser_ring_drag out;
	double before = 0.0, error;

	hawser_ring_drag(&out, &ring, down, axis, still);
	close_to(-out.force[1], 2.0*acos(-1.0)*11.0*1.2*0.07*1.2*25.74*25.74, 1e-13,
	         "flow along the axis: all of the ring across it");
	/* D 5.3: the tube's radius of which the drag is 5051.74 N, to the digits of 0.0766 and 0.0707 m */
	for (int other = 0; other < 2; other++) {
		double cn = other ? 1.3 : 1.2, tube = other ? 0.0707 : 0.0766;

		ring.drag.radius = tube;
		ring.drag.normal = cn;
		hawser_ring_drag(&out, &ring, down, axis, still);
		ok(fabs(5051.74/-out.force[1]*tube - tube) < 5e-5, "cn = %g: %.5f m", cn,
		   5051.74/-out.force[1]*tube);
	}
	ring.drag.radius = 0.07;
	ring.drag.normal = 1.2;
	for (int segments = 32; segments <= 128; segments *= 2) {
		ring.segments = segments;
		hawser_ring_drag(&out, &ring, wind, axis, still);
		error = out.force[0]/(8.0/3.0*1.2*1.2*0.07*11.0*27.8*27.8) - 1.0;
		ok(fabs(error) < 2e-5 && (before == 0.0 || fabs(error) < 0.1*fabs(before)),
		   "flat ring: (8/3) density cn r_cs r V^2, %d segments: %.1e", segments, error);
		before = error;
	}
	ok(fabs(out.moment[0]) + fabs(out.moment[1]) + fabs(out.moment[2]) < 1e-10*fabs(out.force[0]),
	   "no moment in steady flow");
	hawser_ring_drag(&out, &ring, wind, (const double [3]){0.6, -0.8, 0.0}, still);
	ok(fabs(out.moment[0]) + fabs(out.moment[1]) + fabs(out.moment[2]) < 1e-10*fabs(out.force[0]),
	   "nor with a tilt, by symmetry");
}

CASE(unit_drag)
{
	line();
	ring_derivatives();
	ring_closed_forms();
	return done_testing();
}
