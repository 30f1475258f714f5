/* Published motions of rods: D 5.1.2 (damped cantilever), 5.1.3 (flying spaghetti), 5.1.4 (rotor),
 * which have only figures; Simo and Vu-Quoc 1986, 1988. The numbers are those of another program,
 * converged to the digits given. Meshes are coarse here, and errors of order h^2 are extrapolated
 * from two of them; with HAWSER_LONG the runs are as long as the figures.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/rod_motion.h>

#include "tests/tap.h"

#define PI 3.14159265358979323846

static struct hawser_rod_segment segment;
static struct hawser_rod_load load;

static struct hawser_rod rod_of(double EA, double GA, double EI, double rho, double J, double J1)
{
	segment = (struct hawser_rod_segment){.length = 10.0, .rho = rho, .EA = EA, .GA = {GA, GA},
	                                      .EI = {EI, EI}, .GJ = EI, .inertia = {J1, J, J}};
	return (struct hawser_rod){
		.segment = &segment, .segments = 1, .length = 10.0, .load = &load, .loads = 1,
		.hold = {HAWSER_ROD_CLAMPED, HAWSER_ROD_FREE}, .tangent = {1.0, 0.0, 0.0},
		.normal = {0.0, 1.0, 0.0}, .rho_inf = 0.8};
}

static struct hawser_rod_motion run(const struct hawser_rod *rod, double until, double step,
                                    double every, int elements)
{
	double probe = 10.0;
	struct hawser_rod_motion_options options = {.until = until, .every = every, .step = step,
	                                            .probe = &probe, .probes = 1, .skip_error = 1};
	struct hawser_rod_motion motion;
	struct hawser_report report;

	segment.elements = elements;
	if (hawser_rod_integrate(&motion, rod, &options, &report))
		ok(0, "%s", report.message);
	return motion;
}

/* To the digits given: half a unit of the last one, unless a comment says why not. */
static void digits(double value, double want, double half, const char *what)
{
	ok(fabs(value - want) <= half, "%s: %.6f, wanted %g to %g", what, value, want, half);
}

static double better(double coarse, double fine)
{
	return fine + (fine - coarse)/3.0;
}

/* The largest (sign 1) or smallest value of y, and its time, by a parabola through three rows. */
static double extreme(double *at, const double *t, const double *y, int rows, double sign)
{
	int most = 1;
	double a, b;

	for (int i = 1; i < rows - 1; i++)
		if (sign*y[i] > sign*y[most])
			most = i;
	a = 0.5*(y[most + 1] - y[most - 1]);
	b = 0.5*(y[most + 1] + y[most - 1]) - y[most];
	*at = t[most] - a/(2.0*b)*(t[most + 1] - t[most]);
	return y[most] - a*a/(4.0*b);
}

/* --- D 5.1.2 --- */

static void cantilever(void)
{
	static double table[3][2] = {{0.0, 0.0}, {0.75, 1.0}, {1.5, 0.0}};
	static const double upward[3] = {7.598, 14.437, 21.277};
	int far = getenv("HAWSER_LONG") != NULL, found[2] = {0, 0};
	struct hawser_rod rod = rod_of(1e6, 1e6, 1e3, 1.0, 10.0, 20.0);
	double most[2], least[2], high[2], low[2], zero[2][3];

	rod.alpha = 0.1;
	load = (struct hawser_rod_load){.from = 10.0, .to = 10.0, .force = {0.0, 37.5, 0.0},
	                                .factor = table, .factors = 3};
	for (int k = 0; k < 2; k++) {
		struct hawser_rod_motion of = run(&rod, far ? 25.0 : 8.0, 0.01, 0.01, 10 << k);
		double *y = calloc((size_t)of.rows, sizeof *y);

		for (int i = 0; i < of.rows; i++)
			y[i] = of.x[i][1];
		most[k] = extreme(&high[k], of.time, y, of.rows, 1.0);
		least[k] = extreme(&low[k], of.time, y, of.rows, -1.0);
		for (int i = 160; i < of.rows && found[k] < 3; i++)
			if (y[i - 1] < 0.0 && y[i] >= 0.0)
				zero[k][found[k]++] = of.time[i] - 0.01*y[i]/(y[i] - y[i - 1]);
		free(y);
		hawser_rod_motion_clear(&of);
	}
	digits(better(most[0], most[1]), 6.400, 5e-4, "5.1.2: highest place of the tip, m");
	digits(better(high[0], high[1]), 2.39, 5e-3, "its time, s");
	digits(better(least[0], least[1]), -5.597, 5e-4, "lowest place, m");
	digits(better(low[0], low[1]), 5.81, 5e-3, "its time, s");
	/* the first one is 7.5987 s with finer steps and meshes too: 0.7 ms from the other program's */
	for (int i = 0; i < (far ? 3 : 1); i++)
		digits(better(zero[0][i], zero[1][i]), upward[i], i ? 5e-4 : 1e-3,
		       "the tip rises through 0 at, s");
}

/* A small force, released: the period of the first mode, 6.865 s (6.86493 s of Timoshenko's
 * equations with rotary inertia). The second mode, 3.45738 rad/s, is taken out by y(t - d) + y(t + d)
 * - 2 cos(3.45738 d) y(t), and the third stays small. Zeros that rise are a period apart. */
static void period(void)
{
	enum { APART = 25 };
	static double table[2][2] = {{0.0, 1.0}, {0.0, 0.0}};
	struct hawser_rod rod = rod_of(1e6, 1e6, 1e3, 1.0, 10.0, 20.0);
	double of[2], step = 0.02, c = 2.0*cos(3.45738*APART*step);

	load = (struct hawser_rod_load){.from = 10.0, .to = 10.0, .force = {0.0, 1e-3, 0.0},
	                                .factor = table, .factors = 2};
	for (int k = 0; k < 2; k++) {
		struct hawser_rod_motion motion = run(&rod, 13.0, step, step, 8 << k);
		double before = NAN, zero[2] = {NAN, NAN};

		for (int i = APART, found = 0; i < motion.rows - APART && found < 2; i++) {
			double y = motion.x[i - APART][1] + motion.x[i + APART][1] - c*motion.x[i][1];

			if (before < 0.0 && y >= 0.0)
				zero[found++] = motion.time[i] - step*y/(y - before);
			before = y;
		}
		of[k] = zero[1] - zero[0];
		hawser_rod_motion_clear(&motion);
	}
	digits(better(of[0], of[1]), 6.865, 5e-4, "first period, s");
}

/* --- D 5.1.3 --- */

static void spaghetti(double until, int elements)
{
	static double table[3][2] = {{0.0, 1.0}, {2.5, 1.0}, {2.5, 0.0}};
	struct hawser_rod rod = rod_of(1e4, 1e4, 500.0, 1.0, 10.0, 20.0);
	double tip[2][4], H[2], turned[2];

	rod.hold[0] = HAWSER_ROD_FREE;
	load = (struct hawser_rod_load){.force = {-4.8, -6.4, 0.0}, .moment = {0.0, 0.0, -80.0},
	                                .factor = table, .factors = 3};
	for (int k = 0; k < 2; k++) {
		struct hawser_rod_motion of = run(&rod, until, 0.005, 2.5, elements << k);
		int last = of.rows - 1;
		double P[2] = {of.momentum[last][0], of.momentum[last][1]};

		for (int c = 0; c < 2; c++) {
			tip[k][c] = of.x[1][c];
			tip[k][2 + c] = of.x[last][c];
		}
		H[k] = of.angular[last][2];
		turned[k] = of.turned[last];
		if (k && elements < 40) { /* of finer meshes Newton's iteration leaves 3e-5 N s */
			double way = 0.0;

			ok(fabs(P[0] + 12.0) + fabs(P[1] + 16.0) < 1e-5, "5.1.3: momentum (-12, -16) N s, %.1e",
			   fabs(P[0] + 12.0) + fabs(P[1] + 16.0));
			for (int c = 0; c < 2; c++) {
				double sum = 0.0; /* of the places, by the trapezoidal rule: the centre of mass */

				for (int n = 0; n < of.nodes; n++)
					sum += (n == 0 || n == of.nodes - 1 ? 0.5 : 1.0)*
					       (of.shape[last*of.nodes + n][c] - of.shape[n][c])/(of.nodes - 1);
				way += sum*sum;
			}
			/* 2 N s a kg: 2.5 m in the first 2.5 s, 2 m/s then */
			close_to(sqrt(way), 2.0*until - 2.5, 1e-7, "the centre has come, m");
		}
		hawser_rod_motion_clear(&of);
	}
	digits(better(tip[0][0], tip[1][0]), 7.209, 5e-4, "far tip at 2.5 s, x");
	digits(better(tip[0][1], tip[1][1]), -5.339, 5e-4, "y");
	digits(better(H[0], H[1]), -189.27, 5e-3, "angular momentum, N m s");
	if (elements < 40)
		return;
	/* with 10 and 20 elements it would be (-13.522, -26.566): too few to extrapolate */
	digits(better(tip[0][2], tip[1][2]), -13.50, 5e-3, "far tip at 15 s, x");
	digits(better(tip[0][3], tip[1][3]), -26.58, 5e-3, "y");
	/* 1.3174 with 80 elements, 1.3176 extrapolated */
	digits(better(turned[0], turned[1]), -1.317, 1e-3, "mean turn: 1.317 revolutions, not two");
}

/* --- D 5.1.4 --- */

/* By how much the tip is behind the axis of the root (at that speed in the end), and its height. */
static struct hawser_rod_motion rotor(double *lag, double *height, double speed, double until,
                                      double step, int elements)
{
	static double table[3][2] = {{0.0, 0.0}, {0.5, 1.0}, {1.0, 0.0}};
	struct hawser_rod rod = rod_of(2.8e7, 1e7, 1.4e4, 1.2, 6e-4, 12e-4);
	struct hawser_rod_motion of;

	load = (struct hawser_rod_load){.from = 10.0, .to = 10.0, .force = {0.0, 0.0, 40.0},
	                                .factor = table, .factors = 3};
	rod.loads = speed < 5.0;
	rod.drive[0] = (struct hawser_rod_drive){.axis = {0.0, 0.0, 1.0}, .speed = speed, .rise = 15.0};
	of = run(&rod, until, step, 0.02, elements);
	for (int i = 0; i < of.rows; i++) {
		double t = of.time[i], p = 2.0*PI/15.0;
		double angle = t < 15.0 ? speed/15.0*(0.5*t*t - (1.0 - cos(p*t))/(p*p)) : speed*(t - 7.5);

		lag[i] = of.x[i][1]*cos(angle) - of.x[i][0]*sin(angle);
		height[i] = of.x[i][2];
	}
	return of;
}

static void rotors(void)
{
	enum { ROWS = 1600 };
	int far = getenv("HAWSER_LONG") != NULL;
	static double lag[ROWS], height[ROWS];
	double up[2], down[2], at_up[2], at_down[2], most[2] = {0.0}, when[2] = {0.0}, fast[2], at_fast[2];

	for (int k = 0; k < 2; k++) {
		struct hawser_rod_motion of = rotor(lag, height, PI, far ? 30.0 : 2.5, 0.005, 16 << k);

		up[k] = extreme(&at_up[k], of.time, height, 110, 1.0);
		down[k] = extreme(&at_down[k], of.time, height, 110, -1.0);
		down[k] = extreme(&at_down[k], of.time, height, 126, -1.0);
		if (far)
			most[k] = extreme(&when[k], of.time, lag, 750, -1.0);
		if (far && k)
			close_to(of.turned[of.rows - 1], 11.25, 1e-3, "22.5 pi at 30 s, in revolutions");
		hawser_rod_motion_clear(&of);
	}
	digits(better(up[0], up[1]), 1.286, 5e-4, "5.1.4: e3 of the tip, m");
	digits(better(at_up[0], at_up[1]), 0.90, 5e-3, "at, s");
	digits(better(down[0], down[1]), -1.280, 5e-4, "and, m");
	digits(better(at_down[0], at_down[1]), 1.74, 5e-3, "at, s");
	if (!far)
		return;
	digits(better(most[0], most[1]), -0.334, 5e-4, "lag, m");
	digits(better(when[0], when[1]), 7.2, 5e-2, "at, s");
	for (int k = 0; k < 2; k++) {
		struct hawser_rod_motion of = rotor(lag, height, 6.0, 12.0, 0.005, 10 << k);

		fast[k] = extreme(&at_fast[k], of.time, lag, 600, -1.0);
		hawser_rod_motion_clear(&of);
	}
	digits(better(fast[0], fast[1]), -0.574, 5e-4, "6 rad/s: lag, m");
	digits(at_fast[0], 6.77, 5e-3, "at, s, with 10 elements");
	digits(better(at_fast[0], at_fast[1]), 6.763, 1e-3, "and of no error of the mesh");
}

/* A rotor that does not bend (EI and GA of 1000 and 100 times), so that no vibration is left when it
 * has come to its speed: energy and torque (at 7.5 s) of I = 400.006 kg m^2, and the stretch,
 * tan(kL)/k - L with k^2 = rho speed^2/EA. Errors of the step, of order (speed h)^2, and of the mesh
 * are extrapolated. */
static void stiff_rotor(double *energy, double *torque, double *stretch, double EA, double speed)
{
	struct hawser_rod rod = rod_of(EA, 1e9, 1.4e7, 1.2, 6e-4, 12e-4);
	double of[3][2][2], *to[3] = {energy, torque, stretch};

	rod.loads = 0;
	rod.drive[0] = (struct hawser_rod_drive){.axis = {0.0, 0.0, 1.0}, .speed = speed, .rise = 15.0};
	for (int h = 0; h < 2; h++)
		for (int k = 0; k < 2; k++) {
			struct hawser_rod_motion motion = run(&rod, 16.0, h ? 0.01 : 0.02, 0.5, 4 << k);
			int last = motion.rows - 1;

			of[0][h][k] = motion.kinetic[last];
			of[1][h][k] = motion.moment[15][2];
			of[2][h][k] = hypot(motion.x[last][0], motion.x[last][1]) - 10.0;
			hawser_rod_motion_clear(&motion);
		}
	for (int i = 0; i < 3; i++)
		*to[i] = better(better(of[i][0][0], of[i][1][0]), better(of[i][0][1], of[i][1][1]));
}

static void stiff_rotors(void)
{
	double energy, torque, stretch;

	stiff_rotor(&energy, &torque, &stretch, 2.8e9, PI);
	digits(energy, 1973.95, 5e-3, "a rigid rotor, J");
	digits(torque, 400.006*PI/7.5, 5e-3, "its torque, 167.55 N m");
	stiff_rotor(&energy, &torque, &stretch, 2.8e7, 6.0);
	digits(1e4*stretch, 5.143, 5e-4, "stretch at 6 rad/s, 1e-4 m");
}

CASE(reference_rod_motion)
{
	cantilever();
	period();
	spaghetti(getenv("HAWSER_LONG") ? 15.0 : 5.0, 10);
	if (getenv("HAWSER_LONG"))
		spaghetti(15.0, 40);
	rotors();
	stiff_rotors();
	return done_testing();
}
