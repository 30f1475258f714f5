/* Published equilibria of rods. Sources: D: the second thesis, example numbers; Mattiasson 1981
 * (elastica); Bathe and Bolourchi 1979, Simo and Vu-Quoc 1986 (45 degree bend); EXUDYN's cantilever;
 * the Princeton beam as computed with ANSYS. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include <hawser/rod.h>

#include "tests/tap.h"

#define PI 3.14159265358979323846

static struct hawser_rod clamped(struct hawser_rod_segment *segment, struct hawser_rod_load *load,
                                 int loads)
{
	return (struct hawser_rod){
		.segment = segment, .segments = 1, .length = segment->length, .load = load, .loads = loads,
		.hold = {HAWSER_ROD_CLAMPED, HAWSER_ROD_FREE}, .tangent = {1.0, 0.0, 0.0},
		.normal = {0.0, 1.0, 0.0}, .g = 9.81};
}

static struct hawser_rod_segment stiff(double length, double EA, double GA, double EI, double GJ, int n)
{
	return (struct hawser_rod_segment){.length = length, .EA = EA, .GA = {GA, GA}, .EI = {EI, EI},
	                                   .GJ = GJ, .elements = n};
}

/* The place of the last point. */
static const double *tip(struct hawser_rod_statics *st, const struct hawser_rod *rod)
{
	static const double none[3] = {NAN, NAN, NAN};
	struct hawser_report report;

	hawser_rod_statics_clear(st);
	if (hawser_rod_solve(st, rod, NULL, &report))
		return ok(0, "%s", report.message), none;
	return st->point[st->points - 1].x;
}

/* D 5.1.1 and Simo and Vu-Quoc: a couple rolls a rod up. */
static void roll_up(void)
{
	static const int elements[] = {4, 10, 37, 100};
	struct hawser_rod_segment segment = stiff(1.0, 1e4, 1e4, 2.0, 2.0, 10);
	struct hawser_rod_load load = {.from = 1.0, .to = 1.0, .moment = {0.0, 0.0, 4.0*PI}, .follower = 1};
	struct hawser_rod rod = clamped(&segment, &load, 1);
	struct hawser_rod_statics st = {0};
	const double *x;
	double error[2];

	for (int i = 0; i < 4; i++) {
		segment.elements = elements[i];
		x = tip(&st, &rod);
		ok(hypot(x[0], x[1]) < 3e-11 && st.iterations <= 3, "D 5.1.1, M = 4 pi, %d elements: tip at "
		   "%.1e m from the start, %d iterations, the last one without effect", elements[i],
		   hypot(x[0], x[1]), st.iterations);
	}
	load.moment[2] = 2.0*PI;
	for (int i = 0; i < 2; i++) {
		segment.elements = i ? 20 : 10;
		error[i] = tip(&st, &rod)[1] - 2.0/PI;
	}
	close_to(error[0], 2.6e-3, 0.02, "D 5.1.1, M = 2 pi: error of y with 10 elements");
	close_to(error[0]/error[1], 4.0, 0.01, "of order 2");
	close_to(st.error_x, error[1], 0.01, "the stated mesh error");
	load.moment[2] = 8.0*PI;
	segment.elements = 5;
	x = tip(&st, &rod);
	ok(hypot(x[0], x[1]) < 1e-12 && st.iterations <= 3, "M = 8 pi, 5 elements: tip at %.1e m, %d "
	   "iterations", hypot(x[0], x[1]), st.iterations);
	close_to(st.point[3].M[2], 8.0*PI, 1e-12, "moment in the middle");
	hawser_rod_statics_clear(&st);
}

/* D 5.1.5: a hinged rod tows W, on which D acts; the normal drag of the rod is q cos^2 of its angle
 * from the vertical. That of a string has T^2 = W^2 + D^2 and the slope p = D/W + q s/T, and its end is
 * at (T/q)(d sqrt(1 + p^2), d asinh p). The drag is found by repetition: loads across each element,
 * which follow it. */
enum { DRAGGED = 40 };
static void glauert(void)
{
	double r = 0.003, A = PI*r*r, EI = 4e9*A*r*r/4.0, W = 20.0*9.81, q = 10.0, T = hypot(W, 10.0);
	double p = 10.0/W, to = p + q/T;
	struct hawser_rod_segment segment = stiff(1.0, 4e9*A, 4e9*A, EI, 2.0*EI, DRAGGED);
	struct hawser_rod_load load[DRAGGED + 1] = {{.from = 1.0, .to = 1.0, .force = {10.0, -W, 0.0}}};
	struct hawser_rod rod = clamped(&segment, load, DRAGGED + 1);
	struct hawser_rod_statics st = {0};
	const double *x = NULL;

	rod.hold[0] = HAWSER_ROD_HINGED;
	rod.tangent[0] = 0.0;
	rod.tangent[1] = -1.0;
	rod.normal[0] = 1.0;
	rod.normal[1] = 0.0;
	for (int e = 0; e < DRAGGED; e++)
		load[e + 1] = (struct hawser_rod_load){.distributed = 1, .from = (double)e/DRAGGED,
			.to = (e + 1.0)/DRAGGED, .force = {0.0, q, 0.0}, .follower = 1};
	for (int i = 0; i < 7; i++) {
		x = tip(&st, &rod);
		for (int e = 0; e < DRAGGED && st.points; e++) {
			const double *a = st.point[e].x, *b = st.point[e + 1].x;
			double part = (b[1] - a[1])/hypot(b[0] - a[0], b[1] - a[1]);

			load[e + 1].force[1] = q*part*part;
		}
	}
	close_to(T/q*(sqrt(1.0 + to*to) - sqrt(1.0 + p*p)), 0.076173, 1e-5, "D 5.1.5, the string: x");
	close_to(T/q*(asinh(to) - asinh(p)), 0.996988, 1e-6, "y");
	/* 0.998722 to its digits: test-tow-steady, with 200 elements */
	ok(fabs(x[0] - 0.076305) < 1e-6 && fabs(x[1] + 0.998722) < 2e-6, "D 5.1.5, 6 mm: (%.6f, %.6f) m",
	   x[0], -x[1]);
	ok(fabs(st.residual) < 1e-8 && st.flow, "residual %.1e N", st.residual);
	hawser_rod_statics_clear(&st);
}

/* A hanging rod with forces of fixed direction, whose start is far off: the tip from the balance of
 * moments about the hinge, W x = D y + q int y ds. */
static void hinged(void)
{
	double r = 0.003, A = PI*r*r, EI = 4e9*A*r*r/4.0;
	struct hawser_rod_segment segment = stiff(1.0, 4e9*A, 4e9*A, EI, 2.0*EI, 60);
	struct hawser_rod_load load[] = {
		{.from = 1.0, .to = 1.0, .force = {10.0, -196.2, 0.0}},
		{.distributed = 1, .from = 0.0, .to = 1.0, .force = {10.0, 0.0, 0.0}}};
	struct hawser_rod rod = clamped(&segment, load, 2);
	struct hawser_rod_statics st = {0};
	const double *x;
	double area = 0.0;

	rod.hold[0] = HAWSER_ROD_HINGED;
	rod.tangent[1] = 0.3;
	x = tip(&st, &rod);
	for (int i = 1; i < st.points; i++)
		area -= 0.5*(st.point[i].x[1] + st.point[i - 1].x[1])/60.0;
	close_to(196.2*x[0], -10.0*x[1] + 10.0*area, 1e-9, "moments about the hinge");
	ok(st.judged && st.negative == 0, "stable");
	ok(fabs(st.force[0][0] + 20.0) < 1e-9 && fabs(st.force[0][1] - 196.2) < 1e-9, "its support");
	hawser_rod_statics_clear(&st);
}

static void bend(void)
{
	static const struct {
		double force, GA, x[3], within; /* x: across, along, out of the plane */
		int elements;
		const char *who;
	} row[] = {
		{300.0, 5e6, {22.29, 58.85, 40.10}, 0.006, 8, "8 elements"},
		{600.0, 5e6, {15.73, 47.24, 53.40}, 0.006, 8, "8 elements"},
		{600.0, 5e6*5.0/6.0, {15.685, 47.150, 53.475}, 6e-4, 120, "limit"},
		{300.0, 5e6, {22.33, 58.84, 40.08}, 0.05, 8, "Simo and Vu-Quoc"},
		{600.0, 5e6, {15.79, 47.23, 53.37}, 0.07, 8, "Simo and Vu-Quoc"},
		/* theirs are the farthest: 8 straight elements */
		{300.0, 5e6, {22.5, 59.2, 39.5}, 0.61, 8, "Bathe and Bolourchi"},
		{600.0, 5e6, {15.9, 47.2, 53.4}, 0.17, 8, "Bathe and Bolourchi"},
	};
	struct hawser_rod_statics st = {0};

	for (size_t i = 0; i < sizeof row/sizeof *row; i++) {
		struct hawser_rod_segment segment = stiff(25.0*PI, 1e7, row[i].GA, 1e7/12.0, 1e7/12.0,
		                                          row[i].elements);
		struct hawser_rod_load load = {.from = 25.0*PI, .to = 25.0*PI,
		                               .force = {0.0, 0.0, row[i].force}};
		struct hawser_rod rod = clamped(&segment, &load, 1);
		const double *x;

		segment.curvature[2] = 0.01;
		x = tip(&st, &rod);
		ok(fabs(x[1] - row[i].x[0]) < row[i].within && fabs(x[0] - row[i].x[1]) < row[i].within &&
		   fabs(x[2] - row[i].x[2]) < row[i].within, "45 degree bend, %g N, %s: (%.3f, %.3f, %.3f)",
		   row[i].force, row[i].who, x[1], x[0], x[2]);
	}
	hawser_rod_statics_clear(&st);
}

/* Length 2 m, 0.5 x 0.1 m, shear factor 10 (1 + nu)/(12 + 11 nu). */
static void exudyn(void)
{
	double E = 2.07e11, nu = 0.3, GA = 10.0*(1.0 + nu)/(12.0 + 11.0*nu)*E/(2.0 + 2.0*nu)*0.05;
	struct hawser_rod_segment segment = stiff(2.0, 0.05*E, GA, E*0.1*0.125/12.0, 1e8, 400);
	struct hawser_rod_load load = {.from = 2.0, .to = 2.0, .force = {0.0, -6.25e7, 0.0}};
	struct hawser_rod rod = clamped(&segment, &load, 1);
	struct hawser_rod_statics st = {0};
	const double *x = tip(&st, &rod);

	ok(fabs(2.0 - x[0] - 0.150971) < 1e-6 && fabs(-x[1] - 0.710568) < 1e-6, "EXUDYN's cantilever: "
	   "(%.6f, %.6f) m", 2.0 - x[0], -x[1]);
	hawser_rod_statics_clear(&st);
}

static void princeton(void)
{
	static const struct {
		double angle, force, flat, deep, within; /* rad, N, m */
		const char *who;
	} row[] = {{0.5*PI, 8.896, 0.146252, 0.0, 1.5e-6, "another program"},
	           {0.5*PI, 13.345, 0.200684, 0.0, 1.5e-6, "another program"},
	           {0.25*PI, 8.896, 0.10911, 0.00898, 5e-6, "another program"},
	           {0.5*PI, 8.896, 0.146246, 0.0, 6e-6, "ANSYS"},
	           {0.5*PI, 13.345, 0.200678, 0.0, 6e-6, "ANSYS"},
	           /* apart by 0.1 and 1.6 %, as is the other program, which has the same equations */
	           {0.25*PI, 8.896, 0.108988, 0.008837, 1.5e-4, "ANSYS"}};
	double b = 12.3777e-3, h = 3.2024e-3, E = 71.7e9, G = E/(2.0 + 2.0*0.31);
	double deep = b*b*b*h/12.0, flat = h*h*h*b/12.0;
	struct hawser_rod_statics st = {0};

	for (size_t i = 0; i < sizeof row/sizeof *row; i++) {
		struct hawser_rod_segment segment = stiff(0.508, E*b*h, 5.0/6.0*G*b*h, 0.0,
		                                          0.198*G*(deep + flat), 120);
		struct hawser_rod_load load = {.from = 0.508, .to = 0.508, .force = {
			0.0, -row[i].force*cos(row[i].angle), -row[i].force*sin(row[i].angle)}};
		struct hawser_rod rod = clamped(&segment, &load, 1);
		const double *x;

		segment.EI[0] = E*flat;
		segment.EI[1] = E*deep;
		x = tip(&st, &rod);
		ok(fabs(-x[2] - row[i].flat) < row[i].within && fabs(-x[1] - row[i].deep) < row[i].within,
		   "Princeton beam, %.0f degrees, %g N: (%.6f, %.6f) m, %s (%g, %g)", row[i].angle*180.0/PI,
		   row[i].force, -x[1], -x[2], row[i].who, row[i].deep, row[i].flat);
	}
	hawser_rod_statics_clear(&st);
}

static double agm(double a, double b)
{
	for (int i = 0; i < 9; i++) {
		double mean = 0.5*(a + b);

		b = sqrt(a*b);
		a = mean;
	}
	return a;
}

/* Cantilevers: a force across (Mattiasson), and one along beyond Euler's (elliptic integrals): K =
 * pi/2/agm(1, k'), P/EI = (K/L)^2, deflection 2 k L/K. */
static void elastica(void)
{
	static const double P[] = {1.0, 2.0, 5.0, 10.0}, w[] = {0.30172, 0.49346, 0.71379, 0.81061};
	struct hawser_rod_segment segment = stiff(1.0, 1e8, 1e8, 1.0, 1.0, 60);
	struct hawser_rod_load load = {.from = 1.0, .to = 1.0};
	struct hawser_rod rod = clamped(&segment, &load, 1);
	struct hawser_rod_statics st = {0};
	double k = sin(0.5*1.2), K = 0.5*PI/agm(1.0, sqrt(1.0 - k*k));

	for (int i = 0; i < 4; i++) {
		double of[2];

		load.force[1] = P[i];
		for (int h = 0; h < 2; h++) {
			segment.elements = 60 << h;
			of[h] = tip(&st, &rod)[1];
		}
		of[1] += (of[1] - of[0])/3.0;
		ok(fabs(of[1] - w[i]) < 6e-6, "elastica, PL^2/EI = %g: %.6f against %.5f", P[i], of[1], w[i]);
	}
	segment.elements = 60;
	load.force[1] = 0.0;
	for (int side = -1; side <= 1; side += 2) {
		load.force[0] = -0.25*PI*PI*(1.0 + 0.002*side);
		(void)tip(&st, &rod);
		ok(st.judged && st.negative == (side > 0 ? 2 : 0), "at %.3f of Euler's load %d directions "
		   "lower the energy", 1.0 + 0.002*side, st.negative);
	}
	load.force[0] = -K*K;
	load.force[1] = 1e-5;
	(void)tip(&st, &rod);
	ok(fabs(st.point[60].x[1] - 2.0*k/K) < 3e-4 && st.negative == 0, "buckled by an angle of 1.2 rad: "
	   "%.5f against %.5f", st.point[60].x[1], 2.0*k/K);
	hawser_rod_statics_clear(&st);
}

CASE(reference_rod_statics)
{
	roll_up();
	glauert();
	hinged();
	bend();
	exudyn();
	princeton();
	elastica();
	return done_testing();
}
