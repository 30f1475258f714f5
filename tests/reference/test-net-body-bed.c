/* Rigid bodies on beds that give way: boxes that fall, against their equations of motion; a rod that
 * leans on a bed that moves; a clump weight that is lifted, against a mass at a node; modes; and
 * floats whose lines lie in part. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net_modes.h>
#include <hawser/net_motion.h>

#include "tests/net-text.h"
#include "tests/tap.h"

enum { TEXT = 2400 };

/* The last row of a motion of a node; returns 0 without one. */
static int moved(struct hawser_net_motion *m, double x[3], const struct hawser_net *net, int node,
                 double until, double step)
{
	const struct hawser_net_probe probe = {node, -1, 0.0};
	const struct hawser_net_motion_options options = {
		.until = until, .every = until/20.0, .step = step, .probe = &probe, .probes = 1};
	struct hawser_report report = {0};
	enum hawser_status status = hawser_net_integrate(m, net, &options, &report);

	if (!ok(!status && m->closure < 1e-8, "the motion, its energy closed to %.1e: %s",
	        status ? NAN : m->closure, report.message))
		return 0;
	memcpy(x, m->x[m->rows - 1], 3*sizeof *x);
	return 1;
}

/* --- a box that falls, in a vertical plane --- */

static const double A = 0.83, E = 0.52, W = 0.4; /* m: half its length; its centre above its nodes */
static const double MASS = 2385.0, J = 1100.0, K = 1.4e5, G = 9.81; /* K: N/m, of two nodes */

static const char held[] =
	"supports: {a: fixed, b: fixed, c: fixed, d: fixed}\ndynamics: {release: [a, b, c, d]}\n";

static void box_text(char *text, const char *how, double y, double angle, double speed,
                     double friction, double damping)
{
	double c = cos(angle), s = sin(angle), at[2][2];

	for (int i = 0; i < 2; i++) {
		at[i][0] = (i ? A : -A)*c + E*s;
		at[i][1] = y + (i ? A : -A)*s - E*c;
	}
	snprintf(text, TEXT, "kind: net\nnodes: {a: [%.17g, %.17g, %g], b: [%.17g, %.17g, %g], "
	         "c: [%.17g, %.17g, %g], d: [%.17g, %.17g, %g]}\n"
	         "%sobstacles: [{name: bed, plane: {point: [0, 0], normal: [0, 1]}, stiffness: 1e5, "
	         "damping: %g, friction: %g, velocity: [%g, 0]}]\n"
	         "bodies: {box: {nodes: [a, b, c, d], mass: %g, centre: [0, %.17g, 0], "
	         "inertia: [900, 950, %g], bearing: %g}}\n",
	         at[0][0], at[0][1], -W, at[1][0], at[1][1], -W, at[1][0], at[1][1], W, at[0][0], at[0][1],
	         W, how, damping/(K/1e5), friction, speed, MASS, y, J, K/2e5);
}

struct fall {
	double x[3], v[3]; /* m, m, rad, and rates */
	double T[2];       /* N: friction of both edges */
	double friction, speed, damping;
};

/* Forces, with the friction that there is after edges have moved for dt. */
static void push(double f[3], struct fall *of, double dt)
{
	double c = cos(of->x[2]), s = sin(of->x[2]);

	f[0] = f[2] = 0.0;
	f[1] = -MASS*G;
	for (int i = 0; i < 2; i++) {
		double r[2] = {(i ? A : -A)*c + E*s, (i ? A : -A)*s - E*c};
		double depth = -of->x[1] - r[1], rate = -of->v[1] - r[0]*of->v[2];
		double N = depth > 0.0 ? fmax(K*depth + of->damping*rate, 0.0) : 0.0, most = of->friction*N;

		of->T[i] -= 10.0*K*(of->v[0] - r[1]*of->v[2] - of->speed)*dt;
		of->T[i] = fmin(fmax(of->T[i], -most), most);
		f[0] += of->T[i];
		f[1] += N;
		f[2] += r[0]*N - r[1]*of->T[i];
	}
}

/* Half a step of the velocities, one of the places and another half: its error is of order 1 with
 * friction and damping. */
static void fall(struct fall *of, double until, int steps)
{
	double h = until/steps, f[3], m[3] = {MASS, MASS, J};

	for (int n = 0; n <= steps; n++) {
		push(f, of, n ? h : 0.0);
		for (int k = 0; k < 3; k++) {
			of->v[k] += (n && n < steps ? 1.0 : 0.5)*h*f[k]/m[k];
			of->x[k] += n < steps ? h*of->v[k] : 0.0;
		}
	}
}

/* How far the edge b of a box that begins at a height, an angle and over a bed with this speed is from
 * where its equations of motion have it. */
static double off_fall(double angle, double speed, double friction, double damping, double step)
{
	struct fall of = {.x = {0.0, 1.6, angle}, .friction = friction, .speed = speed, .damping = damping};
	struct hawser_net net = {0};
	struct hawser_net_motion m = {0};
	const double until = 0.9;
	double x[3] = {NAN}, c, s;
	char text[TEXT];

	fall(&of, until, 90000);
	c = cos(of.x[2]);
	s = sin(of.x[2]);
	box_text(text, held, 1.6, angle, speed, friction, damping);
	if (net_opened(&net, text, NULL) && moved(&m, x, &net, 1, until, step))
		ok((m.friction[m.rows - 1] > 10.0) == (friction > 0.0), "it rubs by %.0f J",
		   m.friction[m.rows - 1]);
	hawser_net_motion_clear(&m);
	hawser_net_clear(&net);
	return hypot(x[0] - of.x[0] - A*c - E*s, x[1] - of.x[1] - A*s + E*c);
}

/* Down flat: a fall, half an oscillation about the depth at rest, and the way back up. */
static void flat(void)
{
	const double drop = 1.6 - E, w = sqrt(2.0*K/MASS), rest = G/(w*w), v = sqrt(2.0*G*drop);
	const double fallen = v/G, in = 2.0*(M_PI - atan2(v, w*rest))/w, late = 0.31;
	struct hawser_net net = {0};
	struct hawser_net_motion m = {0};
	double x[2][3] = {{NAN}, {NAN}}, want = v*late - 0.5*G*late*late, error[2];
	char text[TEXT];

	box_text(text, held, 1.6, 0.0, 0.0, 0.0, 0.0);
	if (!net_opened(&net, text, NULL))
		return;
	for (int i = 0; i < 2; i++) {
		if (moved(&m, x[i], &net, 1, fallen + in + late, i ? 0.001 : 0.002))
			error[i] = fabs(x[i][1] - want);
		hawser_net_motion_clear(&m);
	}
	ok(error[1] < 2e-5 && fabs(x[1][0] - A) < 1e-12, "flat, it has come back up to %.5f m, to %.1e",
	   want, error[1]);
	hawser_net_clear(&net);
}

static void boxes(void)
{
	double coarse, fine;

	flat();
	coarse = off_fall(0.31, 0.0, 0.0, 0.0, 0.004);
	fine = off_fall(0.31, 0.0, 0.0, 0.0, 0.002);
	ok(fine < 2e-4 && coarse/fine > 3.0 && coarse/fine < 5.0, "on an edge, without friction: to "
	   "%.1e m, of second order (ratio %.2f)", fine, coarse/fine);
	coarse = off_fall(0.31, 0.7, 0.35, 900.0, 0.001);
	fine = off_fall(0.31, 0.7, 0.35, 900.0, 0.00025);
	ok(fine < 1e-3 && coarse/fine > 3.0 && coarse/fine < 5.0, "with friction on a bed that moves, "
	   "damped: to %.1e m, of first order (%.1e with steps four times as long)", fine, coarse);
}

/* --- at rest --- */

/* A rod on a hinge above that leans on a bed, which moves away from it; if against it, it turns around:
 * where the bed pushes, it would not stay. */
static void leans(double speed)
{
	const double L = hypot(8.0, 2.9), m = 210.0*L, k = 50e6*0.05, mu = 0.4;
	struct hawser_net net = {0};
	struct hawser_net_statics st = {0};
	struct hawser_report report = {0};
	double r = 0.0, x = 8.0, y = 0.0;
	char text[TEXT];

	for (int i = 0; i < 100; i++) { /* moments about the hinge */
		x = sqrt(L*L - (y - 3.0)*(y - 3.0));
		r = 0.5*m*G*x/(x - mu*(y - 3.0));
		y = -r/k;
	}
	snprintf(text, sizeof text, "kind: net\nnodes: {A: [0, 3, 0], B: [8, 0.1, 0]}\n"
	         "supports: {A: fixed}\nobstacles: [{plane: {point: [0, 0], normal: [0, 1]}, "
	         "stiffness: 50e6, friction: 0.4, velocity: [%g, 0]}]\nbodies: {R: {nodes: [A, B], "
	         "bearing: 0.05, rods: [{from: A, to: B, rho: 210, elements: 10}]}}\n", speed);
	if (net_opened(&net, text, NULL) &&
	    ok(!hawser_net_solve(&st, &net, NULL, &report) && st.contacts == 1, "a rod that leans: %s",
	       report.message)) {
		close_to(st.contact[0].r, r, 1e-9, "the force of the bed, N");
		close_to(st.contact[0].friction[0], speed*mu*r, 1e-9, "its friction, N");
		close_to(st.reaction[0][1], m*G - r, 1e-9, "the hinge, N");
		close_to(st.x[1][1], y, 1e-9, "depth of its end, m");
		close_to(st.x[1][0], speed*x, 1e-9, "where its end is, m");
		ok(st.energy > 0.0 && st.member[0].length < L*1.000001, "the rod keeps its length");
	}
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
}

static const char clump[] =
	"kind: net\nwater: {density: 1025}\nnodes: {P: [-90, 0, 0], A: [0, 0, 0], F: [60, 50, 4]}\n"
	"supports: {P: fixed, F: {motion: {y: {amplitude: -6, Omega: 0.9}, "
	"x: {amplitude: -2, Omega: 0.9}}}}\n"
	"obstacles: [{plane: {point: [0, 0], normal: [0, 1]}, stiffness: 3e6, damping: 2e5, "
	"friction: 0.5}]\n"
	"cables:\n"
	"  - {name: c1, from: P, to: A, EA: 500e6, rho: 80, diameter: 0.0766, length0: 90.1, "
	"elements: 15}\n"
	"  - {name: c2, from: A, to: F, EA: 500e6, rho: 80, diameter: 0.0766, length0: 80, "
	"elements: 9}\n";

/* A weight between two lines that is lifted off the bed, and set down: a mass at a node; a body. */
static void lifted(void)
{
	static const char *const has[] = {
		"masses: {A: 4000}\n",
		"bodies: {R: {nodes: [A], mass: 4000, centre: [0, 0, 0], inertia: [300, 200, 200]}}\n"};
	struct hawser_net_motion m = {0};
	double x[2][3] = {{NAN}, {NAN}}, far = 0.0;
	int least = 100, most = 0;

	for (int i = 0; i < 2; i++) {
		struct hawser_net net = {0};
		char text[TEXT];

		snprintf(text, sizeof text, "%s%s", clump, has[i]);
		if (net_opened(&net, text, NULL) && moved(&m, x[i], &net, 1, 5.0, 0.01))
			for (int k = 0; k < m.rows; k++) {
				least = m.touching[k] < least ? m.touching[k] : least;
				most = m.touching[k] > most ? m.touching[k] : most;
			}
		hawser_net_motion_clear(&m);
		hawser_net_clear(&net);
	}
	for (int k = 0; k < 3; k++)
		far = fmax(far, fabs(x[1][k] - x[0][k]));
	ok(far < 1e-5 && x[0][1] > 0.01, "a mass and a body are at %.6f m, %.1e m apart", x[0][1], far);
	ok(most - least > 3, "%d to %d nodes touch", least, most);
}

/* Modes of a box that stands: heave; and, with the height of its centre against them, turns. */
static void stands(void)
{
	const double rest = MASS*G/(2.0*K), roll = 2.0*K*W*W - MASS*G*E, pitch = 2.0*K*A*A - MASS*G*E;
	struct hawser_net net = {0};
	struct hawser_net_modes modes = {0};
	struct hawser_net_statics st = {0};
	struct hawser_net_stiffness k;
	struct hawser_report report = {0};
	const int node = 1;
	char text[TEXT];

	box_text(text, "", E, 0.0, 0.0, 0.0, 0.0);
	if (!net_opened(&net, text, NULL))
		return;
	if (ok(!hawser_net_solve(&st, &net, NULL, &report) && st.contacts == 4, "a box that stands: %s",
	       report.message)) {
		close_to(st.x[2][1], -rest, 1e-9, "its depth, m");
		close_to(st.contact[3].r, MASS*G/4.0, 1e-9, "the force at an edge, N");
		close_to(st.energy, MASS*G*(E - 0.5*rest), 1e-9, "its energy, J");
	}
	if (ok(!hawser_net_stiffness_of(&k, &net, &node, 1, NULL, &report), "its stiffness: %s",
	       report.message)) {
		close_to(k.K[1][1], 2.0*K, 1e-9, "up, N/m");
		close_to(k.K[3][3], roll, 1e-9, "about x, N m");
		close_to(k.K[5][5], pitch, 1e-9, "about z, N m");
	}
	if (ok(!hawser_net_modes_solve(&modes, &net, 6, &report) && modes.n == 6, "its modes: %s",
	       report.message)) {
		close_to(modes.omega[3], sqrt(roll/900.0), 1e-9, "roll, rad/s");
		close_to(modes.omega[4], sqrt(2.0*K/MASS), 1e-9, "heave, rad/s");
		close_to(modes.omega[5], sqrt(pitch/J), 1e-9, "pitch, rad/s");
	}
	hawser_net_modes_clear(&modes);
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
}

/* --- floats whose lines lie in part --- */

static const char moored[] =
	"kind: net\nwater: {density: 1025}\ndamping: {axial: 0.02}\n"
	"nodes: {P: [-500, -100, 0], Q: [480, -100, 60], a: [-4, -8, 0], b: [4, -8, 0.5], "
	"r: [0, -30, 0], s: [0, 10, 0]}\nsupports: {P: fixed, Q: fixed}\n"
	"obstacles: [{plane: {point: [0, -100], normal: [0, 1]}, stiffness: 3e6, damping: 3e5}]\n"
	"cables:\n"
	"  - {name: c1, from: P, to: a, EA: 500e6, rho: 100, diameter: 0.0766, length0: 515, "
	"drag: {normal: 2}, added_mass: {normal: 1}, elements: %d}\n"
	"  - {name: c2, from: b, to: Q, EA: 500e6, rho: 100, diameter: 0.0766, length0: 500, "
	"drag: {normal: 2}, added_mass: {normal: 1}, elements: %d}\n"
	"loads: {r: {force: [%g, 0, 0], harmonic: {Omega: 0.6}}}\n"
	"bodies: {spar: {nodes: [a, b, r, s], mass: 1e6, centre: [0, -26, 0], inertia: [5e7, 5e6, 5e7], "
	"rods: [{from: r, to: s, diameter: 8, rho: 1e4, elements: 20, drag: {normal: 1}, "
	"added_mass: {normal: 1}}]}}\n";

/* The tensions of the line at the float, and how far this moves. */
static double tensions(double T[21], int elements, double load, double until, double step)
{
	struct hawser_net net = {0};
	const struct hawser_net_probe probe = {2, -1, 0.0};
	const struct hawser_net_motion_options options = {
		.until = until, .every = until/20.0, .step = step, .probe = &probe, .probes = 1};
	struct hawser_net_motion m = {0};
	struct hawser_report report = {0};
	double far = 0.0;
	char text[TEXT];
	enum hawser_status status = HAWSER_ERR_SCENE;

	snprintf(text, sizeof text, moored, elements, elements, load);
	if (net_opened(&net, text, NULL))
		status = hawser_net_integrate(&m, &net, &options, &report);
	if (ok(!status && (load == 0.0 || m.closure < 1e-8), "a float, its energy closed to %.1e: %s",
	       m.closure, report.message))
		for (int i = 0; i < 21; i++) {
			T[i] = m.T[i];
			for (int k = 0; k < 3; k++)
				far = fmax(far, fabs(m.x[i][k] - m.x[0][k]));
		}
	hawser_net_motion_clear(&m);
	hawser_net_clear(&net);
	return far;
}

/* Root of the mean square of the difference, without its mean. */
static double apart(const double a[21], const double b[21])
{
	double mean = 0.0, square = 0.0;

	for (int i = 0; i < 21; i++)
		mean += (a[i] - b[i])/21.0;
	for (int i = 0; i < 21; i++)
		square += pow(a[i] - b[i] - mean, 2.0)/21.0;
	return sqrt(square);
}

static void floats(void)
{
	double T[4][21] = {{0}}, far = tensions(T[0], 13, 0.0, 5.0, 0.05), error[3];

	ok(T[0][20] > 1e5 && far < 1e-6, "at rest from its equilibrium, to %.1e m", far);
	if (!getenv("HAWSER_LONG"))
		return;
	for (int i = 0; i < 4; i++)
		tensions(T[i], (int [4]){13, 26, 52, 104}[i], 5e5, 30.0, 0.05);
	for (int i = 0; i < 3; i++)
		error[i] = apart(T[i], T[3]);
	ok(error[1] < 0.45*error[0] && error[2] < 0.35*error[1], "the change of the tension with 13, 26, "
	   "52 elements, against 104: %.0f, %.0f, %.0f N", error[0], error[1], error[2]);
}

CASE(reference_net_body_bed)
{
	boxes();
	leans(1.0);
	leans(-1.0);
	lifted();
	stands();
	floats();
	return done_testing();
}
