/* The motion of a net by CVODE against the scheme that keeps energy: two programs for the same
 * equations, but for the vectors of the elements. Newton's matrix against differences; the ledger;
 * order 2.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/net_motion.h>

#include "net/motion/motion-ode.h"
#include "tests/tap.h"

enum { N = 12, MOST = 3*(N + 20) };
static struct hawser_report report;
static unsigned long long seed = 2385;

static double any(void)
{
	seed = seed*6364136223846793005ULL + 1442695040888963407ULL;
	return (double)(seed >> 11)/4503599627370496.0 - 1.0;
}

/* A hanging chain of 2 m under a harmonic load, one end of which moves; with a second cable of 3 m from
 * its other end and a mass there if `net` is 1. */
static void scene(struct hawser_net *to, int net)
{
	static struct hawser_net_node node[3];
	static struct hawser_net_cable cable[2];
	static struct hawser_net_load load[2], motion[2];
	static char name[] = "chain";

	node[0] = (struct hawser_net_node){.name = "A", .placed = 1, .held = {1, 1, 1}, .support = 1};
	node[1] = (struct hawser_net_node){.name = "B", .placed = 1, .x = {1.7, 0.2, 0.3},
	                                   .held = {!net, !net, !net}, .support = !net, .mass = 0.2};
	node[2] = (struct hawser_net_node){.name = "C", .placed = 1, .x = {4.0, 1.2, 0.9},
	                                   .held = {1, 1, 1}, .support = 1};
	cable[0] = (struct hawser_net_cable){.name = "c", .from = 0, .to = 1, .EA = 238.5, .rho = 0.37,
	                                     .value = 2.0, .elements = N};
	cable[1] = (struct hawser_net_cable){.name = "d", .from = 2, .to = 1, .EA = 238.5, .rho = 0.2,
	                                     .value = 3.0, .elements = 6};
	load[0] = (struct hawser_net_load){.node = -1, .cable = 0, .value = {0.1, 0.3, 0.5}, .harmonic = 1,
	                                   .Omega = 5.3};
	load[1] = (struct hawser_net_load){.node = 1, .cable = -1, .value = {0.2, 0.1, 0.3}, .harmonic = 1,
	                                   .Omega = 3.1, .phase = 0.4};
	motion[0] = (struct hawser_net_load){.node = 0, .cable = -1, .value = {0.03, 0.0, 0.05},
	                                     .harmonic = 1, .Omega = 4.1, .phase = 0.5*M_PI};
	*to = (struct hawser_net){.name = name, .g = 9.81, .node = node, .cable = cable, .load = load,
	                          .motion = motion, .nodes = net ? 3 : 2, .cables = 1 + net,
	                          .loads = 1 + net, .motions = 1, .alpha = 0.1, .axial = 2e-3};
}

/* (I - gamma*J)*(x, y) by differences, then Newton's step back. */
static void newton(void)
{
	struct hawser_net net;
	struct hawser__mesh mesh;
	struct hawser__motion motion;
	struct hawser__ode ode;
	struct hawser__equilibrium found;
	double u[MOST], v[MOST], x[MOST], y[MOST], bx[MOST], by[MOST], low[MOST], high[MOST], size = 0.0,
	       off = 0.0;
	const double gamma = 3e-3, eps = 1e-6, t = 0.37;
	int n, good = 0;

	scene(&net, 1);
	if (!ok(!hawser__mesh_build(&mesh, &net, &report) &&
	        !hawser__mesh_statics(&mesh, NULL, &found, NULL, &report) &&
	        !hawser__motion_open(&motion, &mesh, NULL, -1.0, 1, NULL, &report) &&
	        !hawser__ode_open(&ode, &motion, &report), "begin %s", report.message))
		return;
	n = mesh.unknowns;
	for (int side = -1; side <= 1; side += 2) {
		seed = 2385;
		for (int i = 0; i < n; i++) {
			x[i] = any();
			y[i] = any();
			u[i] = 0.02*any() + side*eps*x[i];
			v[i] = any() + side*eps*y[i];
		}
		ok(!hawser__ode_accelerate(side < 0 ? low : high, &ode, t, u, v, &report), "accelerations");
	}
	for (int i = 0; i < n; i++) {
		bx[i] = x[i] - gamma*y[i];
		by[i] = y[i] - gamma*(high[i] - low[i])/(2.0*eps);
		u[i] -= eps*x[i];
		v[i] -= eps*y[i];
	}
	ok(!hawser__ode_newton(bx, by, &good, &ode, gamma, t, u, v, &report) && good, "Newton's step");
	for (int i = 0; i < n; i++) {
		off = fmax(off, fmax(fabs(bx[i] - x[i]), fabs(by[i] - y[i])));
		size = fmax(size, fmax(fabs(x[i]), fabs(y[i])));
	}
	ok(off <= 1e-6*size, "is that of differences of the accelerations to %.1e", off/size);
	hawser__ode_clear(&ode);
	hawser__motion_clear(&motion);
	hawser__mesh_clear(&mesh);
}

static int run(struct hawser_net_motion *motion, const struct hawser_net *net, const char *scheme,
               double step, double tolerance)
{
	struct hawser_net_probe probe[2] = {{.node = -1, .cable = 0, .part = 0.5},
	                                    {.node = -1, .cable = net->cables - 1, .part = 0.9}};
	struct hawser_net_motion_options options = {.until = 1.2, .every = 0.1, .step = step,
	                                            .tolerance = tolerance, .scheme = scheme,
	                                            .probe = probe, .probes = 2};

	return ok(!hawser_net_integrate(motion, net, &options, &report), "%s, step %g, rtol %g: %s", scheme,
	          step, tolerance, report.message);
}

static double distance(const struct hawser_net_motion *a, const struct hawser_net_motion *b)
{
	double most = 0.0;

	for (int i = 0; i < a->rows*a->probes; i++)
		for (int k = 0; k < 3; k++)
			most = fmax(most, fabs(a->x[i][k] - b->x[i][k]));
	return most;
}

static double ledgers(const struct hawser_net_motion *a, const struct hawser_net_motion *b)
{
	double most = 0.0;

	for (int i = 0; i < a->rows; i++) {
		most = fmax(most, fabs(a->kinetic[i] - b->kinetic[i]));
		most = fmax(most, fabs(a->potential[i] - b->potential[i]));
		most = fmax(most, fabs(a->work[i] - b->work[i]));
		most = fmax(most, fabs(a->dissipated[i] - b->dissipated[i]));
	}
	return most/fabs(a->work[a->rows - 1]);
}

/* Steps of 2, 1 and 0.5 ms: the stated error of the last is a third of its distance from the one
 * before. */
static void agree(int net)
{
	struct hawser_net scene_of;
	struct hawser_net_motion by[3] = {{0}}, cvode = {0}, coarse = {0};
	double off[3], stated, own;

	scene(&scene_of, net);
	for (int i = 0; i < 3; i++)
		if (!run(&by[i], &scene_of, "energy", 2e-3/(1 << i), 0.0))
			return;
	if (!run(&cvode, &scene_of, "cvode", -1.0, 1e-10) || !run(&coarse, &scene_of, "cvode", -1.0, 1e-7))
		return;
	own = distance(&cvode, &coarse);
	ok(own <= coarse.error && cvode.error <= 1e-2*coarse.error, "CVODE at 1e-7 is %.1e m from that at "
	   "1e-10, and states %.1e m", own, coarse.error);
	for (int i = 0; i < 3; i++)
		off[i] = distance(&by[i], &cvode);
	ok(fabs(log2(off[1]/off[2]) - 2.0) <= 0.1, "the schemes converge to each other with order %.3f, "
	   "%.3f", log2(off[0]/off[1]), log2(off[1]/off[2]));
	stated = distance(&by[1], &by[2])/3.0;
	ok(off[2] <= 1.1*stated + cvode.error, "%.2e m apart, stated errors %.2e and %.1e m", off[2],
	   stated, cvode.error);
	ok(by[2].closure <= 1e-12 && cvode.closure <= 1e-8 && coarse.closure <= 1e-5,
	   "ledgers close to %.1e, and %.1e and %.1e", by[2].closure, cvode.closure, coarse.closure);
	ok(ledgers(&cvode, &by[2]) <= 2e-3 && ledgers(&cvode, &by[2]) <= 0.3*ledgers(&cvode, &by[1]),
	   "their terms agree to %.1e, with steps of 1 ms to %.1e", ledgers(&cvode, &by[2]),
	   ledgers(&cvode, &by[1]));
	for (int i = 0; i < 3; i++)
		hawser_net_motion_clear(&by[i]);
	hawser_net_motion_clear(&cvode);
	hawser_net_motion_clear(&coarse);
}

/* Backward differences, where axial waves are overdamped. */
static void stiff(void)
{
	struct hawser_net net;
	struct hawser_net_motion a = {0}, b = {0};

	scene(&net, 1);
	net.axial = 0.05;
	if (run(&a, &net, "cvode", -1.0, 1e-9) && run(&b, &net, "energy", 2e-4, 0.0)) {
		double off = distance(&a, &b);

		ok(off <= b.error + a.error, "overdamped axial waves: %.1e m apart, stated %.1e and %.1e", off,
		   b.error, a.error);
		ok(a.steps < 2000, "%ld steps by backward differences", a.steps);
	}
	hawser_net_motion_clear(&a);
	hawser_net_motion_clear(&b);
}

static void refused(void)
{
	struct hawser_net net;
	struct hawser_net_motion_options options = {.until = 1.0, .scheme = "cvode"};
	struct hawser_net_motion motion;

	scene(&net, 1);
	net.cable[0].rho = net.cable[1].rho = 0.0;
	ok(hawser_net_integrate(&motion, &net, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "cable c has inner nodes without"), "%s", report.message);
	net.cable[0].elements = net.cable[1].elements = 1;
	net.node[1].mass = 0.0;
	ok(hawser_net_integrate(&motion, &net, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "node B has none"), "%s", report.message);
}

CASE(property_net_cvode)
{
	newton();
	agree(0);
	agree(1);
	stiff();
	refused();
	return done_testing();
}
