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
	close_to(better(most[0], most[1]), 6.400, 1e-3, "5.1.2: highest place of the tip, m");
	close_to(better(high[0], high[1]), 2.39, 2e-3, "its time, s");
	close_to(better(least[0], least[1]), -5.597, 1e-3, "lowest place, m");
	close_to(better(low[0], low[1]), 5.81, 2e-3, "its time, s");
	for (int i = 0; i < (far ? 3 : 1); i++)
		close_to(better(zero[0][i], zero[1][i]), upward[i], 3e-4, "the tip rises through 0 at, s");
}

/* A small force, released: the period of the first mode, 6.865 s. */
static void period(void)
{
	static double table[2][2] = {{0.0, 1.0}, {0.0, 0.0}};
	struct hawser_rod rod = rod_of(1e6, 1e6, 1e3, 1.0, 10.0, 20.0);
	double of[2];

	load = (struct hawser_rod_load){.from = 10.0, .to = 10.0, .force = {0.0, 1e-3, 0.0},
	                                .factor = table, .factors = 2};
	for (int k = 0; k < 2; k++) {
		struct hawser_rod_motion motion = run(&rod, 6.0, 0.02, 0.02, 8 << k);
		int i = 1;

		while (i < motion.rows && !(motion.x[i - 1][1] < 0.0 && motion.x[i][1] >= 0.0))
			i++;
		/* from the largest deflection to the second zero: three quarters */
		of[k] = i < motion.rows ? 4.0/3.0*(motion.time[i] - 0.02*motion.x[i][1]/
		                                   (motion.x[i][1] - motion.x[i - 1][1])) : NAN;
		hawser_rod_motion_clear(&motion);
	}
	close_to(better(of[0], of[1]), 6.865, 6e-3, "first period, s (three quarters of a free vibration)");
}

/* --- D 5.1.3 --- */

static void spaghetti(void)
{
	static double table[3][2] = {{0.0, 1.0}, {2.5, 1.0}, {2.5, 0.0}};
	int far = getenv("HAWSER_LONG") != NULL;
	struct hawser_rod rod = rod_of(1e4, 1e4, 500.0, 1.0, 10.0, 20.0);
	double tip[2][4], H[2], turned[2], until = far ? 15.0 : 5.0;

	rod.hold[0] = HAWSER_ROD_FREE;
	load = (struct hawser_rod_load){.force = {-4.8, -6.4, 0.0}, .moment = {0.0, 0.0, -80.0},
	                                .factor = table, .factors = 3};
	for (int k = 0; k < 2; k++) {
		struct hawser_rod_motion of = run(&rod, until, 0.005, 2.5, 10 << k);
		int last = of.rows - 1;
		double P[2] = {of.momentum[last][0], of.momentum[last][1]};

		for (int c = 0; c < 2; c++) {
			tip[k][c] = of.x[1][c];
			tip[k][2 + c] = of.x[last][c];
		}
		H[k] = of.angular[last][2];
		turned[k] = of.turned[last];
		if (k) {
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
	close_to(better(tip[0][0], tip[1][0]), 7.209, 3e-4, "far tip at 2.5 s, x");
	close_to(better(tip[0][1], tip[1][1]), -5.339, 3e-4, "y");
	close_to(better(H[0], H[1]), -189.27, 1e-4, "angular momentum, N m s");
	if (!far)
		return;
	close_to(better(tip[0][2], tip[1][2]), -13.50, 2e-3, "far tip at 15 s, x");
	close_to(better(tip[0][3], tip[1][3]), -26.58, 1e-3, "y");
	close_to(better(turned[0], turned[1]), -1.317, 1e-3, "mean turn: 1.317 revolutions, not two");
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
	double torque = 0.0;

	for (int k = 0; k < 2; k++) {
		struct hawser_rod_motion of = rotor(lag, height, PI, far ? 30.0 : 2.5, 0.01, 8 << k);

		up[k] = extreme(&at_up[k], of.time, height, 110, 1.0);
		down[k] = extreme(&at_down[k], of.time, height, 110, -1.0);
		down[k] = extreme(&at_down[k], of.time, height, 126, -1.0);
		if (far)
			most[k] = extreme(&when[k], of.time, lag, 750, -1.0);
		if (far && k)
			close_to(of.turned[of.rows - 1], 11.25, 1e-3, "22.5 pi at 30 s, in revolutions");
		hawser_rod_motion_clear(&of);
	}
	close_to(better(up[0], up[1]), 1.286, 1e-3, "5.1.4: e3 of the tip, m");
	close_to(better(at_up[0], at_up[1]), 0.90, 5e-3, "at, s");
	close_to(better(down[0], down[1]), -1.280, 1.5e-3, "and, m");
	close_to(better(at_down[0], at_down[1]), 1.74, 3e-3, "at, s");
	/* a rotor that is all but rigid: energy 1973.95 J and torque 167.55 N m of I = 400 kg m^2 */
	{
		struct hawser_rod rod = rod_of(2.8e9, 1e9, 1.4e7, 1.2, 6e-4, 12e-4);
		double of[2];

		rod.loads = 0;
		rod.drive[0] = (struct hawser_rod_drive){.axis = {0.0, 0.0, 1.0}, .speed = PI, .rise = 15.0};
		for (int k = 0; k < 2; k++) {
			struct hawser_rod_motion motion = run(&rod, 16.0, 0.02, 0.5, 4 << k);
			double moment = motion.moment[15][2]; /* at 7.5 s */

			torque = k ? better(torque, moment) : moment;
			of[k] = motion.kinetic[motion.rows - 1];
			hawser_rod_motion_clear(&motion);
		}
		close_to(better(of[0], of[1]), 1973.95, 1e-3, "a rigid rotor, J");
		close_to(torque, 167.55, 2e-3, "its torque, N m");
	}
	if (!far)
		return;
	close_to(better(most[0], most[1]), -0.334, 4e-3, "lag, m");
	close_to(better(when[0], when[1]), 7.2, 1e-2, "at, s");
	for (int k = 0; k < 2; k++) {
		struct hawser_rod_motion of = rotor(lag, height, 6.0, 20.0, 0.005, 10 << k);
		int last = of.rows - 1;

		fast[k] = extreme(&at_fast[k], of.time, lag, 750, -1.0);
		when[k] = hypot(of.x[last][0], of.x[last][1]) - 10.0;
		hawser_rod_motion_clear(&of);
	}
	close_to(better(fast[0], fast[1]), -0.574, 2e-3, "6 rad/s: lag, m");
	close_to(better(at_fast[0], at_fast[1]), 6.77, 3e-3, "at, s");
	close_to(better(when[0], when[1])*1e4, 5.143, 2e-3, "stretch, 1e-4 m");
}

int main(void)
{
	cantilever();
	period();
	spaghetti();
	rotors();
	return done_testing();
}
