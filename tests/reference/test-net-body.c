/* Rigid bodies on nets: a rod on a hinge in water, of which a judge's numbers are known; tops and gates
 * against their equations of motion; and bodies on lines, whose equilibrium and stiffness are told by
 * the same lines with supports. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <hawser/net_motion.h>

#include "tests/net-text.h"
#include "tests/tap.h"

enum { TEXT = 2000 };

/* The last row of a motion of a node. */
static void moved(double x[3], const struct hawser_net *net, int node, double until, double step)
{
	const struct hawser_net_probe probe = {node, -1, 0.0};
	const struct hawser_net_motion_options options = {
		.until = until, .every = until, .step = step, .probe = &probe, .probes = 1};
	struct hawser_report report = {0};
	struct hawser_net_motion m = {0};
	enum hawser_status status = hawser_net_integrate(&m, net, &options, &report);

	if (ok(!status && m.closure < 1e-11, "the motion, its energy closed to %.1e: %s",
	       status ? NAN : m.closure, report.message))
		memcpy(x, m.x[m.rows - 1], 3*sizeof *x);
	hawser_net_motion_clear(&m);
}

/* A rod of length L that is `angle` off the vertical above or below its hinge, in water. */
static double rod(double L, double D, double m, double cd, double angle, int above, int elements,
                  double until, double step)
{
	char text[TEXT];
	double x[3] = {NAN, NAN, NAN};
	struct hawser_net net = {0};

	snprintf(text, sizeof text, "kind: net\nnodes: {A: [0, -60, 0], B: [%.17g, %.17g, 0]}\n"
	         "supports: {A: fixed, B: fixed}\nwater: {density: 1025}\ndynamics: {release: [B]}\n"
	         "bodies: {R: {nodes: [A, B], rods: [{from: A, to: B, rho: %.17g, diameter: %.17g, "
	         "drag: {normal: %g}, added_mass: {normal: 1}, elements: %d}]}}\n", L*sin(angle),
	         -60.0 + (above ? L : -L)*cos(angle), m, D, cd, elements);
	if (net_opened(&net, text, NULL))
		moved(x, &net, 1, until, step);
	hawser_net_clear(&net);
	return asin(x[0]/L);
}

static void rods(void)
{
	const double L = 13.7, D = 0.55, m = 310.0, A = 1025.0*M_PI*D*D/4.0;
	const double omega = sqrt(1.5*9.81*(m - A)/(L*(m + A)));
	double quarter = rod(20.0, 0.8, 200.0, 0.0, 1e-3, 1, 100, 11.03432/4.0, 0.01);
	double low = rod(L, D, m, 0.0, 1e-3, 0, 100, 0.5*M_PI/omega, 0.01);
	double late = rod(20.0, 0.8, 200.0, 1.0, 0.3, 1, 60, 7.0939, 0.02);

	ok(fabs(quarter) < 1e-3*2e-4, "W21: upright after a quarter of 11.03432 s, to %.1e", quarter/1e-3);
	ok(fabs(low) < 1e-3*2e-4, "a heavier one below its hinge likewise, to %.1e", low/1e-3);
	ok(fabs(late + 0.0573358) < 3e-5, "W21: with drag %.7f rad, not -0.0573358", late);
}

/* --- a top: J w' = - w x J w + moment, about the hinge, in axes of the body --- */

struct top {
	double J[3][3], arm[3]; /* kg m^2 about the hinge; kg m: masses times places */
	double g;
};

static void cross(double c[3], const double a[3], const double b[3])
{
	for (int k = 0; k < 3; k++)
		c[k] = a[(k + 1)%3]*b[(k + 2)%3] - a[(k + 2)%3]*b[(k + 1)%3];
}

/* x = A^-1 b by Cramer's rule. */
static void solve(double x[3], const double A[3][3], const double b[3])
{
	double c[3], det;

	cross(c, A[1], A[2]);
	det = A[0][0]*c[0] + A[0][1]*c[1] + A[0][2]*c[2];
	for (int j = 0; j < 3; j++) { /* A is symmetric: its columns are its rows */
		cross(c, A[(j + 1)%3], A[(j + 2)%3]);
		x[j] = (c[0]*b[0] + c[1]*b[1] + c[2]*b[2])/det;
	}
}

/* y: rows of the rotation, 9, and w in the body. */
static void rate(double d[12], const double y[12], const struct top *top)
{
	double L[3], gyro[3], down[3], moment[3];

	for (int k = 0; k < 3; k++) {
		double w[3] = {y[9], y[10], y[11]}, row[3] = {y[3*k], y[3*k + 1], y[3*k + 2]};

		cross(&d[3*k], row, w); /* R' = R [w] */
		L[k] = top->J[k][0]*w[0] + top->J[k][1]*w[1] + top->J[k][2]*w[2];
		down[k] = -top->g*y[3 + k];
	}
	cross(gyro, &y[9], L);
	cross(moment, top->arm, down);
	for (int k = 0; k < 3; k++)
		moment[k] -= gyro[k];
	solve(&d[9], top->J, moment);
}

static void runge_kutta(double y[12], const struct top *top, double until, int steps)
{
	double h = until/steps, k[4][12], at[12];

	for (int i = 0; i < steps; i++) {
		for (int s = 0; s < 4; s++) {
			for (int j = 0; j < 12; j++)
				at[j] = y[j] + (s ? (s < 3 ? 0.5 : 1.0)*h*k[s - 1][j] : 0.0);
			rate(k[s], at, top);
		}
		for (int j = 0; j < 12; j++)
			y[j] += h/6.0*(k[0][j] + 2.0*k[1][j] + 2.0*k[2][j] + k[3][j]);
	}
}

/* A mass with three moments of inertia and a mass at a node, on a hinge or an axis, let go. */
static void tops(void)
{
	static const char text[] =
		"kind: net\nnodes: {A: [0, 0, 0], B: [2, 0.3, 0.4], C: [0.2, 0, 1.1]}\n"
		"supports: {A: fixed, B: fixed, C: fixed}\nmasses: {B: 3}\ndynamics: {release: [B, C]}\n"
		"bodies: {R: {nodes: [A, B, C], mass: 7, centre: [0.7, -0.2, 0.9], inertia: [4, 5, 2.5]}}\n";
	const double c[3] = {0.7, -0.2, 0.9}, b[3] = {2.0, 0.3, 0.4}, a[3] = {0.2, 0.0, 1.1};
	const double J[3] = {4.0, 5.0, 2.5}, M = 7.0, m = 3.0, until = 2.6;
	const double size = sqrt(a[0]*a[0] + a[2]*a[2]), axis[3] = {a[0]/size, 0.0, a[2]/size};
	struct top top = {.g = 9.81};
	struct hawser_net net = {0};
	double y[12] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, x[2][3] = {{NAN}}, error[2] = {0};
	double about = 0.0, moment[3], weight[3], theta, v = 0.0, h = 1e-3;

	for (int i = 0; i < 9; i++) {
		int r = i/3, s = i % 3;

		top.J[r][s] = M*((r == s)*(c[0]*c[0] + c[1]*c[1] + c[2]*c[2]) - c[r]*c[s]) + (r == s)*J[r] +
		              m*((r == s)*(b[0]*b[0] + b[1]*b[1] + b[2]*b[2]) - b[r]*b[s]);
		top.arm[r] = M*c[r] + m*b[r];
		about += axis[r]*top.J[r][s]*axis[s];
	}
	runge_kutta(y, &top, until, 2000);
	if (net_opened(&net, text, NULL))
		for (int i = 0; i < 2; i++) {
			moved(x[i], &net, 1, until, i ? 0.005 : 0.01);
			for (int k = 0; k < 3; k++)
				error[i] = fmax(error[i], fabs(x[i][k] - y[3*k]*b[0] - y[3*k + 1]*b[1] -
				                               y[3*k + 2]*b[2]));
		}
	ok(error[1] < 2e-3 && fabs(error[0]/error[1] - 4.0) < 0.2, "a top: place to %.1e m, of second "
	   "order (ratio %.2f)", error[1], error[0]/error[1]);
	hawser_net_clear(&net);
	/* about the axis of two hinges: theta'' = moment of the weight over J */
	theta = 0.0;
	for (double t = 0.0; t < until - 0.5*h; t += h) { /* leapfrog */
		double turned[3];

		theta += 0.5*h*v;
		cross(moment, axis, top.arm);
		for (int k = 0; k < 3; k++) {
			double along = axis[0]*top.arm[0] + axis[1]*top.arm[1] + axis[2]*top.arm[2];

			turned[k] = cos(theta)*(top.arm[k] - along*axis[k]) + sin(theta)*moment[k] + along*axis[k];
		}
		cross(weight, turned, (const double[3]){0.0, -top.g, 0.0});
		v += h*(weight[0]*axis[0] + weight[1]*axis[1] + weight[2]*axis[2])/about;
		theta += 0.5*h*v;
	}
	if (net_opened(&net, text, "dynamics.release=[B]")) {
		double along = b[0]*axis[0] + b[2]*axis[2], across[3];

		moved(x[0], &net, 1, until, 0.002);
		cross(across, axis, b);
		for (int k = 0; k < 3; k++)
			ok(fabs(x[0][k] - (cos(theta)*(b[k] - along*axis[k]) + sin(theta)*across[k] +
			                   along*axis[k])) < 1e-4, "on an axis: %c = %.6f m", "xyz"[k], x[0][k]);
	}
	hawser_net_clear(&net);
}

/* --- bodies on lines --- */

static const char lines[] =
	"kind: net\nwater: {density: 1025, depth: 90, current: "
	"{table: [[-90, 0.1, 0, 0.3], [0, 0.9, 0, -0.2]]}}\n"
	"nodes: {a: [-60, -90, 5], b: [70, -90, 20], c: [-5, -90, -75], d: [40, -30, 30],\n"
	"  f: [-4, -40, 0], g: [4, -40, 1], h: [0, -41, -5], t: [0, -20, 0], s: [25, -30, 20]}\n"
	"cables:\n"
	"  - {name: la, from: a, to: f, EA: 3 MN, rho: 9, "
	"length0: 75, diameter: 60 mm, drag: {normal: 1.2}, elements: 8}\n"
	"  - {name: lb, from: b, to: g, EA: 3 MN, rho: 9, "
	"length0: 84, diameter: 60 mm, drag: {normal: 1.2}, elements: 8}\n"
	"  - {name: lc, from: c, to: h, EA: 3 MN, rho: 9, "
	"length0: 85, diameter: 60 mm, drag: {normal: 1.2}, elements: 8}\n"
	"  - {name: link, from: t, to: s, EA: 1 MN, rho: 3, "
	"length0: 31, diameter: 40 mm, drag: {normal: 1}, elements: 6}\n"
	"supports: {a: fixed, b: fixed, c: fixed, d: fixed}\n"
	"buoys: {s: {mass: 900, volume: 2, CdA: 1, added_mass: 0.5}}\n"
	"bodies:\n"
	"  R: {nodes: [f, g, h, t], mass: 20 t, centre: [0.2, -36, 0.1], inertia: [1e6, 8e5, 9e5],\n"
	"    rods: [{from: h, to: t, rho: 90, diameter: 1.5, drag: {normal: 0.9, tangential: 0.02}, "
	"added_mass: {normal: 1}, elements: 5}]}\n"
	"  S: {nodes: [s, d]}\n";
enum { F = 4, T = 7, S = 8 };

/* The equilibrium with a load on a node of the first body. */
static int loaded(struct hawser_net_statics *st, const struct hawser_net *net, int axis, double force)
{
	struct hawser_net by = *net;
	struct hawser_net_load load = {.node = T, .cable = -1};
	struct hawser_report report = {0};

	load.value[axis] = force;
	by.load = &load;
	by.loads = 1;
	return ok(!hawser_net_solve(st, &by, NULL, &report), "with a load: %s", report.message);
}

/* The matrix is the derivative of a load by the motion of the body, here by differences. */
static void pulled(const struct hawser_net *net, const struct hawser_net_stiffness *k, int axis)
{
	const double f = 300.0;
	struct hawser_net_statics st[2] = {{0}};
	double load[6] = {0.0}, motion[6] = {0.0}, r[3], turned[3], off = 0.0;

	if (loaded(&st[0], net, axis, -f) && loaded(&st[1], net, axis, f)) {
		for (int i = 0; i < 3; i++) {
			cross(turned, st[0].body[0].axes[i], st[1].body[0].axes[i]);
			for (int n = 0; n < 3; n++)
				motion[3 + n] += 0.5*turned[n];
		}
		for (int n = 0; n < 3; n++)
			r[n] = 0.5*(st[0].x[T][n] + st[1].x[T][n]) - k->about[n];
		cross(turned, &motion[3], r);
		for (int n = 0; n < 3; n++)
			motion[n] = st[1].x[T][n] - st[0].x[T][n] - turned[n];
		load[axis] = 2.0*f;
		cross(&load[3], r, load);
		for (int n = 0; n < 6; n++) {
			double sum = -load[n];

			for (int i = 0; i < 6; i++)
				sum += k->K[n][i]*motion[i];
			off = fmax(off, fabs(sum)/(n < 3 ? 2.0*f : 2.0*f*20.0));
		}
		ok(off < 1e-4, "K times the motion by a load along %c is the load, to %.1e", "xyz"[axis], off);
	}
	hawser_net_statics_clear(&st[0]);
	hawser_net_statics_clear(&st[1]);
}

/* What holds the body in its equilibrium has no force and no moment. */
static void held(const struct hawser_net *net)
{
	struct hawser_net_stiffness k;
	struct hawser_report report = {0};
	const double about[3] = {1.0, -30.0, 2.0};
	double most = 0.0;
	const int node = F;

	if (!ok(!hawser_net_stiffness_of(&k, net, &node, 1, about, &report), "stiffness: %s",
	        report.message))
		return;
	for (int i = 0; i < 6; i++)
		most = fmax(most, fabs(k.force[i]));
	ok(most < 1e-3, "forces and moments on the body: %.1e N, N m", most);
	for (int j = 0; j < 3; j++)
		pulled(net, &k, j);
}

static void on_lines(void)
{
	struct hawser_net net = {0};
	struct hawser_net_statics st = {0};
	struct hawser_report report = {0};
	double x[3] = {NAN, NAN, NAN}, far = 0.0;

	if (!net_opened(&net, lines, NULL))
		return;
	if (ok(!hawser_net_solve(&st, &net, NULL, &report), "two bodies on lines: %s", report.message)) {
		double span = 0.0;

		for (int k = 0; k < 3; k++)
			span += pow(st.x[T][k] - st.x[F][k], 2.0) - pow(net.node[T].x[k] - net.node[F].x[k], 2.0);
		ok(fabs(span) < 1e-9, "the body keeps its shape: %.1e m^2", span);
		ok(st.residual < 1e-4, "balance to %.1e N", st.residual);
		ok(st.reaction[F][1] == 0.0 && fabs(st.reaction[3][1]) > 1.0,
		   "its hinge holds, its nodes do not");
		moved(x, &net, T, 3.0, 0.05);
		for (int k = 0; k < 3; k++)
			far = fmax(far, fabs(x[k] - st.x[T][k]));
		ok(far < 1e-7, "in motion it stays there, to %.1e m", far);
	}
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
	if (net_opened(&net, lines, "bodies.S=")) /* the matrix is that with the other bodies held */
		held(&net);
	hawser_net_clear(&net);
	if (net_opened(&net, lines, "water.waves={height: 4, period: 7, heading: 40 degree}"))
		moved(x, &net, T, 5.0, 0.05);
	hawser_net_clear(&net);
}

/* A float at a node where no cable ends, on a line from the bed, in still water and after a push. */
static void floats(void)
{
	static const char text[] =
		"kind: net\nwater: {density: 1025}\nnodes: {A: [0, -30, 0], f: [0.3, -10, 0], "
		"b: [0, -7, 0.4]}\n"
		"cables: [{name: c, from: A, to: f, EA: 1e6, rho: 2, length0: 20, "
		"diameter: 0.02, elements: 4}]\n"
		"supports: {A: fixed}\nbuoys: {b: {volume: 3, CdA: 1, added_mass: 0.5}}\n"
		"obstacles: [{plane: {point: [0, -30], normal: [0, 1]}, stiffness: 1e6, friction: 0.5}]\n"
		"bodies: {R: {nodes: [f, b], mass: 1200, centre: [0, -7, 0.4], inertia: [300, 300, 300]}}\n";
	struct hawser_net net = {0};
	struct hawser_net_statics st = {0};
	struct hawser_report report = {0};
	double x[3] = {NAN, NAN, NAN};

	if (net_opened(&net, text, NULL) &&
	    ok(!hawser_net_solve(&st, &net, NULL, &report), "a float: %s", report.message)) {
		close_to(st.member[0].T_to, 9.81*(3.0*1025.0 - 1200.0), 1e-9, "its pull, N");
		ok(fabs(st.x[2][0]) + fabs(st.x[2][2]) < 1e-6 && st.x[2][1] > st.x[1][1],
		   "it is above its line");
	}
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
	if (net_opened(&net, text, "loads={b: {force: [900, 0, 400], harmonic: {Omega: 1.3}}}"))
		moved(x, &net, 2, 3.0, 0.05);
	ok(fabs(x[0]) > 1e-3, "it moves: x = %g m", x[0]);
	hawser_net_clear(&net);
}

CASE(reference_net_body)
{
	rods();
	tops();
	on_lines();
	floats();
	return done_testing();
}
