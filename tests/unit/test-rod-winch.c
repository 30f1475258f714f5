/* Rods that lengthen: the tangent against differences; the pendulum of growing length against Bessel
 * functions; the string with a uniformly moving end against its exact modes; a heavy chain against
 * Galerkin's method on the equation of small motions; no speed; ledgers; order in step and mesh.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sf_bessel.h>

#include "rod/motion.h"
#include "rod/so3.h"
#include "tests/tap.h"

#define PI 3.14159265358979323846

static unsigned long seed = 2385;

static double number(void) /* -1 to 1 */
{
	seed = (seed*1103515245UL + 12345UL) & 0x7fffffffUL;
	return 2.0*(double)seed/0x7fffffff - 1.0;
}

/* A mesh that moves; the winch, too. */
struct chain {
	struct hawser_rod_segment segment[2];
	struct hawser_rod rod;
	struct hawser__rod_mesh mesh;
	struct hawser__rod_motion motion;
	struct hawser__rod_body body;
};

static void chain_open(struct chain *c, double until, int refine)
{
	struct hawser_report report;
	enum hawser_status status;

	c->rod.segment = c->segment;
	c->rod.length = 0.0;
	for (int i = 0; i < c->rod.segments; i++)
		c->rod.length += c->segment[i].length;
	status = hawser__rod_mesh_open(&c->mesh, &c->rod, refine, &report);
	if (!status)
		status = hawser__rod_motion_open(&c->motion, &c->mesh, &report);
	if (!status)
		status = hawser__rod_winch_open(&c->motion.winch, &c->mesh, until, &report);
	if (status)
		ok(0, "%s", report.message);
	hawser__rod_motion_factors(&c->motion, 0.0, 0);
}

static void chain_close(struct chain *c)
{
	hawser__rod_motion_clear(&c->motion);
	hawser__rod_mesh_clear(&c->mesh);
}

static void chain_go(struct chain *c, double until, int steps)
{
	struct hawser_report report;
	enum hawser_status status = HAWSER_OK;
	double h = (until - c->motion.t)/steps;

	for (int i = 0; i < steps && !status; i++)
		status = hawser__rod_motion_step(&c->motion, h, &report);
	if (status)
		ok(0, "%s", report.message);
}

static void chain_begin(struct chain *c)
{
	struct hawser_report report;

	if (hawser__rod_motion_begin(&c->motion, 1, &report))
		ok(0, "%s", report.message);
}

/* A cable along `tangent`, with a winch of constant speed. */
static struct chain cable(double length, double rho, double EA, double EI, double speed, int elements)
{
	struct chain c = {.segment = {{
		.length = length, .rho = rho, .EA = EA, .GA = {EA, EA}, .EI = {EI, EI}, .GJ = EI,
		.inertia = {2e-6*rho, 1e-6*rho, 1e-6*rho}, .elements = elements}}};

	c.rod = (struct hawser_rod){.segments = 1, .hold = {HAWSER_ROD_HINGED, HAWSER_ROD_FREE},
	                            .tangent = {0.0, -1.0, 0.0}, .normal = {1.0, 0.0, 0.0}, .g = 9.81,
	                            .rho_inf = 0.8, .winch = {.on = 1, .speed = speed}};
	return c;
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
	static const struct { double speed, until; const char *name; } of[] = {{1.0, 15.0, "longer"},
		{-0.4, 10.0, "shorter"}};

	for (int i = 0; i < 2; i++) {
		double first = pendulum(of[i].speed, of[i].until, 500, 1e7, 2);
		double second = pendulum(of[i].speed, of[i].until, 1000, 1e7, 2);

		ok(fabs(second) < 1.2e-3 && first > 3.5*second && first < 4.4*second, "a pendulum that gets %s: "
		   "off Bessel functions by %.2e and %.2e of its first angle", of[i].name, first, second);
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

/* --- the string with a moving end (Balazs 1961) --- */

static const double string_l = 2.0, string_v = 3.0, string_T = 100.0, string_rho = 1.0;

static double string_c(double EA)
{
	return sqrt(string_T*(1.0 + string_T/EA)/string_rho);
}

/* y = cos(k ln(c t + x)) - cos(k ln(c t - x)), k = 2 pi n/ln((c + v)/(c - v)), t counted from when the
 * length was 0; y and its derivatives by t and x. */
static void balazs(double y[3], double c, double x, double t)
{
	double k = 4.0*PI/log((c + string_v)/(c - string_v)), p = c*t + x, q = c*t - x;

	y[0] = cos(k*log(p)) - cos(k*log(q));
	y[1] = c*k*(-sin(k*log(p))/p + sin(k*log(q))/q);
	y[2] = k*(-sin(k*log(p))/p - sin(k*log(q))/q);
}

static void string_guide(void *data, struct hawser__rod_guide *to, double t)
{
	(void)data;
	memset(to, 0, sizeof *to);
	to->q[0] = 1.0;
	to->x[0] = -string_l - string_v*t;
	to->v[0] = -string_v;
}

static double string(int elements, int steps, double *energy)
{
	const double EA = 1e5, strain = string_T/EA, wave = string_c(EA), size = 1e-6, until = 0.6;
	const double began = string_l/string_v;
	struct chain c = cable(string_l/(1.0 + strain), string_rho, EA, 1e-7, string_v/(1.0 + strain),
	                       elements);
	double worst = 0.0;

	memcpy(c.rod.tangent, (const double [3]){1.0, 0.0, 0.0}, sizeof c.rod.tangent);
	memcpy(c.rod.normal, (const double [3]){0.0, 1.0, 0.0}, sizeof c.rod.normal);
	c.rod.at[0] = -string_l;
	c.rod.hold[1] = HAWSER_ROD_HINGED;
	c.rod.g = 0.0;
	c.rod.rho_inf = 1.0;
	chain_open(&c, until, 1);
	c.motion.guide[0] = string_guide;
	for (int i = 0; i <= elements; i++) {
		double x = string_l*(1.0 - (double)i/elements), y[3];

		balazs(y, wave, x, began);
		c.mesh.node[i].x[0] = -x;
		c.mesh.node[i].x[1] = size*y[0];
		hawser__quaternion_exp(c.mesh.node[i].q, (const double [3]){0.0, 0.0, -size*y[2]});
		c.motion.velocity[i][0] = -string_v*x/string_l;
		c.motion.velocity[i][1] = size*(y[1] + y[2]*string_v*x/string_l);
	}
	chain_begin(&c);
	chain_go(&c, until, steps);
	for (int i = 0; i <= elements; i++) {
		double x = -c.mesh.node[i].x[0], y[3];

		balazs(y, wave, x, began + until);
		worst = fmax(worst, fabs(c.mesh.node[i].x[1]/size - y[0]));
	}
	*energy = c.motion.energy_lost/c.motion.most_energy;
	chain_close(&c);
	return worst;
}

static void strings(void)
{
	double energy, first = string(20, 400, &energy), second = string(40, 800, &energy);

	ok(second < 0.02 && first > 3.5*second && first < 4.5*second, "a string whose end moves at 0.3 of "
	   "its waves' speed: off the exact mode, of size 2, by %.2e, %.2e", first, second);
}

/* --- a heavy chain that hangs from the winch: small motions by collocation --- */

enum { TERMS = 14 };
#define ZERO 2.404825557695773 /* of J0 */

/* w'' of y(S, t) = w(xi, t), xi = S/l from the free end, at Chebyshev's points; w = 0 at xi = 1:
 *   w_tt = 2 b xi w_txi + (b' - b^2) xi w_xi - b^2 xi^2 w_xixi + (g - l'')/l (xi w_xi)_xi
 * D: the matrix of d/dxi. */
static void collocate(double *a, const double *w, const double *v, double (*D)[TERMS], const double *xi,
                      const double l[3])
{
	double b = l[1]/l[0], b1 = l[2]/l[0] - b*b, first[TERMS], second[TERMS], rate[TERMS];

	for (int pass = 0; pass < 2; pass++)
		for (int i = 0; i < TERMS; i++) {
			(pass ? second : first)[i] = 0.0;
			for (int j = 0; j < TERMS; j++)
				(pass ? second : first)[i] += D[i][j]*(pass ? first[j] : w[j]);
		}
	for (int i = 0; i < TERMS; i++) {
		rate[i] = 0.0;
		for (int j = 0; j < TERMS; j++)
			rate[i] += D[i][j]*v[j];
		a[i] = 2.0*b*xi[i]*rate[i] + (b1 - b*b)*xi[i]*first[i] - b*b*xi[i]*xi[i]*second[i] +
		       (9.81 - l[2])/l[0]*(first[i] + xi[i]*second[i]);
	}
	a[0] = 0.0; /* xi = 1 */
}

/* The free end at time `until`, from the first mode, w = J0(j sqrt(xi)), at rest, by the method of Runge and Kutta. */
static double chebyshev(const struct hawser__rod_winch *winch, double until, int steps)
{
	double xi[TERMS], D[TERMS][TERMS], w[TERMS], v[TERMS], k[4][2][TERMS], h = until/steps;

	for (int i = 0; i < TERMS; i++) {
		xi[i] = 0.5*(1.0 + cos(PI*i/(TERMS - 1)));
		w[i] = gsl_sf_bessel_J0(ZERO*sqrt(xi[i]));
		v[i] = 0.0;
	}
	for (int i = 0; i < TERMS; i++) {
		D[i][i] = 0.0;
		for (int j = 0; j < TERMS; j++) {
			double ci = i % (TERMS - 1) ? 1.0 : 2.0, cj = j % (TERMS - 1) ? 1.0 : 2.0;

			if (i == j)
				continue;
			D[i][j] = ci/cj*((i + j) % 2 ? -1.0 : 1.0)/(xi[i] - xi[j]);
			D[i][i] -= D[i][j];
		}
	}
	for (int n = 0; n < steps; n++) {
		for (int s = 0; s < 4; s++) {
			double part = s == 0 ? 0.0 : s == 3 ? h : 0.5*h, l[3], at[TERMS], by[TERMS];

			for (int i = 0; i < TERMS; i++) {
				at[i] = w[i] + (s ? part*k[s - 1][0][i] : 0.0);
				by[i] = v[i] + (s ? part*k[s - 1][1][i] : 0.0);
			}
			memcpy(k[s][0], by, sizeof by);
			hawser__rod_winch_at(l, winch, n*h + part);
			collocate(k[s][1], at, by, D, xi, l);
		}
		for (int i = 0; i < TERMS; i++) {
			w[i] += h/6.0*(k[0][0][i] + 2.0*k[1][0][i] + 2.0*k[2][0][i] + k[3][0][i]);
			v[i] += h/6.0*(k[0][1][i] + 2.0*k[1][1][i] + 2.0*k[2][1][i] + k[3][1][i]);
		}
	}
	return w[TERMS - 1];
}

static double heavy(int elements, int steps, double to, double *exact)
{
	double row[3][2] = {{0.0, 0.0}, {2.0, to}, {6.0, 0.3*to}};
	const double EA = 1e7, size = 1e-5, until = 5.0;
	struct chain c = cable(6.0, 1.0, EA, 1e-7, 0.0, elements);
	double y = 0.0, end;

	c.rod.winch = (struct hawser_rod_winch){.on = 1, .row = row, .rows = 3};
	chain_open(&c, until, 1);
	for (int i = 1; i <= elements; i++) {
		double h = 6.0/elements, below = h*(elements - i + 0.5);

		y += h*(1.0 + 9.81*below/EA);
		c.mesh.node[i].x[0] = size*gsl_sf_bessel_J0(ZERO*sqrt(1.0 - (double)i/elements));
		c.mesh.node[i].x[1] = -y;
	}
	for (int i = 0; i <= elements; i++) {
		double root = sqrt(1.0 - (double)i/elements);
		double slope = 0.5*ZERO*(root > 0.0 ? gsl_sf_bessel_J1(ZERO*root)/root : 0.5*ZERO);

		hawser__quaternion_turn(c.mesh.node[i].q, (const double [3]){0.0, 0.0, size*slope/6.0});
	}
	chain_begin(&c);
	*exact = chebyshev(&c.motion.winch, until, 2000);
	chain_go(&c, until, steps);
	end = c.mesh.node[elements].x[0]/size;
	chain_close(&c);
	return end - *exact;
}

static void chains(void)
{
	for (int in = 0; in < 2; in++) {
		double exact, first = heavy(12, 500, in ? -0.9 : 2.5, &exact);
		double second = heavy(48, 500, in ? -0.9 : 2.5, &exact);

		ok(fabs(second) < 2e-3 && fabs(first) > 8.0*fabs(second), "a heavy chain that is %s: its end, at "
		   "%.5f by Chebyshev's points, off by %.2e and %.2e", in ? "hauled in" : "paid out", exact, first,
		   second);
	}
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
	ok(lost[1] < 1e-5 && lost[0] > 3.0*lost[1], "energy closes to %.1e, %.1e of its largest term", lost[0],
	   lost[1]);
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

int main(void)
{
	tangent();
	pendulums();
	elevator();
	strings();
	chains();
	ledgers();
	no_speed();
	return done_testing();
}
