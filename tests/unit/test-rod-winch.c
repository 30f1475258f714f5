/* Rods that lengthen: the tangent against differences; the pendulum of growing length and the elevator
 * against Bessel functions; ledgers; no speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <gsl/gsl_sf_bessel.h>

#include "rod/so3.h"
#include "tests/rod-chain.h"

static unsigned long seed = 2385;

static double number(void) /* -1 to 1 */
{
	seed = (seed*1103515245UL + 12345UL) & 0x7fffffffUL;
	return 2.0*(double)seed/0x7fffffff - 1.0;
}

/* --- the tangent --- */

static void move(struct hawser__rod_motion *motion, const double *by, double part)
{
	hawser__rod_move(motion->mesh, by, part);
	for (int i = 0; i < motion->mesh->nodes; i++)
		for (int k = 0; k < 6; k++) {
			motion->velocity[i][k] += part*motion->to_velocity*by[6*i + k];
			motion->rate[i][k] += part*motion->to_rate*by[6*i + k];
		}
}

static void tangent(void)
{
	double row[3][2] = {{0.0, 0.3}, {1.0, 1.9}, {2.0, -0.7}};
	struct chain c = cable(2.385, 1.3, 900.0, 20.0, 0.0, 3);
	double by[36], minus[36], product[36] = {0.0}, worst = 0.0, size = 0.0;
	const double eps = 1e-6;

	c.segment[0].curvature[1] = 0.4;
	c.segment[1] = c.segment[0];
	c.segment[1].elements = 2;
	c.rod.segments = 2;
	c.rod.winch = (struct hawser_rod_winch){.on = 1, .row = row, .rows = 3};
	c.rod.alpha = 0.31;
	chain_open(&c, 2.0, 1);
	hawser__rod_motion_factors(&c.motion, 0.7, 0);
	for (int i = 0; i < c.mesh.n; i++)
		by[i] = c.mesh.held[i] ? 0.0 : number();
	hawser__rod_move(&c.mesh, by, 0.2);
	for (int i = 0; i < c.mesh.n; i++) {
		c.motion.velocity[i/6][i % 6] = number();
		c.motion.rate[i/6][i % 6] = 5.0*number();
		by[i] = c.mesh.held[i] ? 0.0 : number();
	}
	for (int i = 0; i < c.mesh.nodes; i++) /* Ji of no turn */
		for (int k = 0; k < 9; k++)
			c.motion.Ji[i][k] = k % 4 == 0;
	c.motion.by_place = 1.0;
	c.motion.to_velocity = 3.0;
	c.motion.to_rate = 11.0;
	(void)hawser__rod_motion_form(&c.motion, 0.7, 1);
	for (int i = 0; i < c.mesh.n; i++)
		for (int j = i > 11 ? i - 11 : 0; j <= i + 11 && j < c.mesh.n; j++)
			product[i] += c.mesh.held[i] ? 0.0 : *hawser__band_at(&c.mesh.band, i, j)*by[j];
	move(&c.motion, by, -eps);
	(void)hawser__rod_motion_form(&c.motion, 0.7, 0);
	memcpy(minus, c.mesh.r, sizeof minus);
	move(&c.motion, by, 2.0*eps);
	(void)hawser__rod_motion_form(&c.motion, 0.7, 0);
	for (int i = 0; i < c.mesh.n; i++) {
		worst = fmax(worst, fabs(product[i] + (c.mesh.r[i] - minus[i])/(2.0*eps)));
		size = fmax(size, fabs(product[i]));
	}
	ok(worst < 1e-8*size, "tangent of a rod that lengthens against differences: %.1e", worst/size);
	chain_close(&c);
}

/* --- the pendulum of growing length --- */

/* theta'' + 2 (l'/l) theta' + (g/l) theta = 0, l = l0 + v t: theta = (A J1(u) + B Y1(u))/u, u = 2
 * sqrt(g l)/v; at t = 0 theta = first, theta' = 0, which is (A J2 + B Y2)(u0) = 0. */
static double bessel(double first, double l0, double v, double g, double t)
{
	double u0 = 2.0*sqrt(g*l0)/fabs(v), u = 2.0*sqrt(g*(l0 + v*t))/fabs(v);
	double A = gsl_sf_bessel_Yn(2, u0), B = -gsl_sf_bessel_Jn(2, u0);
	double at0 = (A*gsl_sf_bessel_J1(u0) + B*gsl_sf_bessel_Y1(u0))/u0;

	return first/at0*(A*gsl_sf_bessel_J1(u) + B*gsl_sf_bessel_Y1(u))/u;
}

static double pendulum(double speed, double until, int steps, double EA, int elements)
{
	const double first = 1e-3, l0 = 5.0, M = 1.0;
	struct chain c = cable(l0, 1e-6, EA, 1e-6, speed, elements);
	double angle;

	c.rod.tangent[0] = sin(first);
	c.rod.tangent[1] = -cos(first);
	c.body = (struct hawser__rod_body){.node = elements, .mass = M};
	for (int k = 0; k < 3; k++)
		c.body.inertia[4*k] = 1e-9;
	chain_open(&c, until, 1);
	c.motion.body = &c.body;
	c.motion.bodies = 1;
	for (int i = 0; i < c.mesh.nodes; i++) /* strained by the weight */
		for (int k = 0; k < 3; k++)
			c.mesh.node[i].x[k] *= 1.0 + M*c.rod.g/EA;
	(void)hawser__rod_winch_begin(&c.motion, 1);
	chain_begin(&c);
	chain_go(&c, until, steps);
	angle = atan2(c.mesh.node[elements].x[0], -c.mesh.node[elements].x[1]);
	chain_close(&c);
	return (angle - bessel(first, l0, speed, 9.81, until))/first;
}

static void pendulums(void)
{
	static const struct {
		double speed, until;
		const char *name;
	} of[] = {{1.0, 15.0, "longer"}, {-0.4, 10.0, "shorter"}};

	for (int i = 0; i < 2; i++) {
		double first = pendulum(of[i].speed, of[i].until, 500, 1e7, 2);
		double second = pendulum(of[i].speed, of[i].until, 1000, 1e7, 2);

		ok(fabs(second) < 1.2e-3 && first > 3.5*second && first < 4.4*second, "a pendulum that gets "
		   "%s: off Bessel functions by %.2e and %.2e of its first angle", of[i].name, first, second);
	}
	ok(fabs(pendulum(1.0, 15.0, 2000, 500.0, 2)/pendulum(1.0, 15.0, 2000, 1000.0, 2) - 2.0) < 0.15,
	   "on a cable that stretches the difference is as the stretch");
}

/* --- along itself: a load on a rope without mass, M u'' = -EA u/l --- */

static void elevator(void)
{
	const double l0 = 10.0, speed = 0.2, M = 10.0, EA = 1e4, first = 1e-3, until = 20.0;
	double u0 = 2.0*sqrt(EA/M*l0)/speed, l = l0 + speed*until, u = 2.0*sqrt(EA/M*l)/speed;
	double A, B, exact, slow, moved[2];

	for (int n = 0; n < 2; n++) {
		struct chain c = cable(l0, 1e-6, EA, 1e-6, speed, 2);

		c.body = (struct hawser__rod_body){.node = 2, .mass = M,
		                                   .inertia = {1e-9, 0, 0, 0, 1e-9, 0, 0, 0, 1e-9}};
		chain_open(&c, until, 1);
		c.motion.body = &c.body;
		c.motion.bodies = 1;
		for (int i = 0; i < c.mesh.nodes; i++)
			c.mesh.node[i].x[1] *= 1.0 + M*c.rod.g/EA + first/l0;
		(void)hawser__rod_winch_begin(&c.motion, 1);
		for (int i = 0; i < c.mesh.nodes; i++)
			c.motion.velocity[i][1] *= 1.0 + M*c.rod.g/EA;
		chain_begin(&c);
		chain_go(&c, until, 1500 << n);
		moved[n] = -c.mesh.node[2].x[1] - l*(1.0 + M*c.rod.g/EA);
		chain_close(&c);
	}
	/* u = sqrt(l) (A J1 + B Y1), and d(x J1)/dx = x J0: u' = 0 at first */
	A = gsl_sf_bessel_Y0(u0);
	B = -gsl_sf_bessel_J0(u0);
	exact = first*sqrt(l/l0)*(A*gsl_sf_bessel_J1(u) + B*gsl_sf_bessel_Y1(u))/
	        (A*gsl_sf_bessel_J1(u0) + B*gsl_sf_bessel_Y1(u0));
	/* phase: the integral of sqrt(EA/(M l)); amplitude: energy over frequency stays */
	slow = first*pow(l/l0, 0.25)*cos(u - u0);
	ok(fabs((4.0*moved[1] - moved[0])/3.0 - exact) < 0.01*first, "an elevator: off Bessel functions by "
	   "%.2e, %.2e of its amplitude, extrapolated by %.1e", (moved[0] - exact)/first,
	   (moved[1] - exact)/first, ((4.0*moved[1] - moved[0])/3.0 - exact)/first);
	ok(fabs(slow - exact) < 3e-3*first, "which go with the frequency of the moment: %.1e",
	   (slow - exact)/first);
}

/* --- ledgers, no speed --- */

enum { STEPS = 400 };

static void ledgers(void)
{
	double row[3][2] = {{0.0, 0.5}, {0.6, 2.0}, {1.2, -1.0}}, lost[2], gap[2], turn[2], bought[3];

	for (int n = 0; n < 3; n++) {
		struct hawser_rod_load load = {.distributed = 1, .from = 0.0, .to = 3.0,
		                               .force = {2.0, 1.0, 3.0}};
		struct chain c = cable(3.0, 1.3, 4e3, 0.5, 0.0, n == 2 ? 16 : 8);
		const double *f, *v;
		double sum = 0.0, before = 0.0;

		c.segment[0].inertia[0] = 0.02;
		c.segment[0].inertia[1] = c.segment[0].inertia[2] = 0.01;
		c.rod.tangent[2] = 0.7;
		c.rod.alpha = 0.4;
		c.rod.rho_inf = 1.0;
		c.rod.load = &load;
		c.rod.loads = 1;
		c.rod.winch = (struct hawser_rod_winch){.on = 1, .row = row, .rows = 3};
		chain_open(&c, 1.0, 1);
		(void)hawser__rod_winch_begin(&c.motion, 1);
		chain_begin(&c);
		for (int i = 0; i <= STEPS << (n == 1); i++) {
			const struct hawser__rod_strain *at;
			const struct hawser__rod_winch *winch = &c.motion.winch;
			double slope[3], power = 0.0, W;

			if (i > 0)
				chain_go(&c, c.motion.t + 1.0/(STEPS << (n == 1)), 1);
			/* tension of the start along the material, energy of what comes in */
			at = c.mesh.strain;
			f = c.motion.reaction[0];
			v = winch->slip[0];
			for (int k = 0; k < 3; k++) {
				slope[k] = (c.mesh.node[1].x[k] - c.mesh.node[0].x[k])/c.mesh.element[0].h;
				power += (f[k] - 1.3*winch->speed*v[k])*slope[k];
			}
			W = hawser__rod_energy(c.mesh.element, at)/c.mesh.element[0].h;
			power = winch->speed*(power + 0.65*hawser__dot(v, v) + W);
			sum += i > 0 ? 0.5*(power + before)*c.motion.h : 0.0;
			before = power;
		}
		if (n < 2) {
			lost[n] = fabs(c.motion.energy_lost)/c.motion.most_energy;
			gap[n] = c.motion.momentum_gap/c.motion.most_momentum;
			turn[n] = c.motion.angular_gap/c.motion.most_angular;
		}
		bought[n] = sum/c.motion.energy.winch - 1.0;
		chain_close(&c);
	}
	ok(lost[1] < 1e-5 && lost[0] > 3.0*lost[1], "energy closes to %.1e, %.1e of its largest term",
	   lost[0], lost[1]);
	ok(gap[1] < 1e-5 && turn[1] < 1e-5 && turn[0] > 3.0*turn[1], "momentum to %.1e, %.1e, about the "
	   "origin %.1e, %.1e", gap[0], gap[1], turn[0], turn[1]);
	ok(fabs(bought[2]) < 1e-4 && fabs(bought[2]) < 0.3*fabs(bought[1]), "the winch does l' (F x' + rho "
	   "|l' x'|^2/2 + W) but for %.1e with 8 elements, %.1e with 16", bought[1], bought[2]);
}

static void no_speed(void)
{
	double x[2], worst = 0.0;

	for (int on = 0; on < 2; on++) {
		struct chain c = cable(3.0, 1.3, 4e3, 0.5, 0.0, 8);

		c.rod.winch.on = on;
		c.rod.tangent[2] = 0.7;
		c.rod.alpha = 0.4;
		chain_open(&c, 1.0, 1);
		(void)hawser__rod_winch_begin(&c.motion, 1);
		chain_begin(&c);
		chain_go(&c, 1.0, 200);
		x[on] = c.mesh.node[8].x[2];
		worst = fabs(x[on] - x[0]);
		chain_close(&c);
	}
	ok(worst < 1e-10, "a winch at rest changes nothing: %.1e m", worst);
}

CASE(unit_rod_winch)
{
	tangent();
	pendulums();
	elevator();
	ledgers();
	no_speed();
	return done_testing();
}
