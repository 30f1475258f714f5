/* The tangent stiffness of nets at their nodes: mooring lines on a seabed against the closed form
 * of the catenary, a body with three lines against its rigid motions, and nets with joints, slack
 * cables and friction against differences of equilibria. SPDX-License-Identifier: GPL-3.0-or-later
 * */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <hawser/net.h>

#include "tests/tap.h"

static int opened(struct hawser_net *net, const char *scene, const char *const *set, size_t sets)
{
	struct hawser_report report = {0};
	const char *path = source_file("notebooks-data/scenes/%s.yaml", scene);

	return ok(!hawser_net_open(net, path, set, sets, &report), "%s: %s", scene, report.message);
}

static int stiffness(struct hawser_net_stiffness *K, const struct hawser_net *net, const int *node,
                     int nodes, const double *about)
{
	struct hawser_report report;
	enum hawser_status status = hawser_net_stiffness_of(K, net, node, nodes, about, &report);

	return ok(!status, "stiffness: %s", status ? report.message : "found");
}

/* Chain on a bed: the flexibility of the catenary, whose length on the bed is elastic too; H over
 * the horizontal distance sideways. Where all of the bed slides towards the end, a larger V leaves
 * less of the chain there and less friction, by mu*V, so that what lies there has more tension. */
static void chain(const char *scene, const char *const *set, size_t sets, double w, double EA, double L,
                  double mu)
{
	struct hawser_net net;
	struct hawser_net_stiffness K;
	int end = 1;

	if (opened(&net, scene, set, sets) && stiffness(&K, &net, &end, 1, NULL)) {
		double H = K.force[0], V = K.force[1], T = hypot(H, V), x = net.node[1].x[0];
		double a = L/EA + (asinh(V/H) - V/T)/w, b = (H/T - 1.0)/w, c = V/(w*EA) + V/(w*T);
		double rubs = b + mu*(L - V/w)/EA, det = a*c - b*rubs;

		close_to(K.K[0][0], c/det, 1e-4, "along, N/m");
		close_to(K.K[1][0], -b/det, 1e-4, "upwards, by a motion along, N/m");
		close_to(K.K[0][1], -rubs/det, 1e-4, "along, by a motion upwards, N/m");
		close_to(K.K[1][1], a/det, 1e-4, "upwards, N/m");
		if (mu > 0.0) {
			close_to(K.K[1][0] - K.K[0][1], (rubs - b)/det, 1e-3, "by friction, N/m");
		} else {
			close_to(K.K[2][2], H/x, 1e-10, "sideways, N/m");
			ok(K.asymmetry < 1e-9 && K.size == 3, "symmetric: %.1e", K.asymmetry);
		}
	}
	hawser_net_clear(&net);
}

/* Three of these lines at the fairleads of a floating body: of the stiffness of one line, turned.
 * */
#define LINE(i) "{name: c" #i ", from: a" #i ", to: f" #i ", EA: 753.6 MN, rho: 113.35, length0: " \
	"835.5, elements: 200}"
static void body(void)
{
	static const char *const set[] = {
		"nodes={a1: [418.8, -200, 725.3828782], f1: [20.434, -14, 35.39272621], "
		"a2: [-837.6, -200, 0], f2: [-40.868, -14, 0], a3: [418.8, -200, -725.3828782], "
		"f3: [20.434, -14, -35.39272621]}",
		"cables=[" LINE(1) ", " LINE(2) ", " LINE(3) "]",
		"supports={a1: fixed, a2: fixed, a3: fixed, f1: fixed, f2: fixed, f3: fixed}",
		"obstacles=[{plane: {point: [0, -200], normal: [0, 1]}}]", "g=9.4011927657697393"};
	static const int fairlead[] = {1, 3, 5};
	struct hawser_net net;
	struct hawser_net_stiffness K;

	if (opened(&net, "net-mooring", set, 5) && stiffness(&K, &net, fairlead, 3, (double[3]){0.0})) {
		close_to(K.K[0][0], 70143.2, 2e-5, "W15: surge, N/m");
		close_to(K.K[2][2], 70143.2, 2e-5, "W15: sway, N/m");
		close_to(K.K[1][1], 19086.3, 2e-5, "W15: heave, N/m");
		close_to(K.K[0][5], 103208.0, 3e-4, "W15: surge by a turn about z, N");
		close_to(K.K[3][3], 8.67324e7, 1e-4, "W15: roll, N m");
		close_to(K.K[4][4], 1.161201e8, 2e-5, "W15: yaw, N m");
		ok(K.asymmetry < 1e-7, "symmetric: no moment acts: %.1e", K.asymmetry);
	}
	hawser_net_clear(&net);
}

/* Differences of the force of a support, moved by a small step to both sides. */
static void differences(const char *scene, const char *const *set, size_t sets, int node,
                        double step, double least, const char *what)
{
	struct hawser_net net;
	struct hawser_net_stiffness K;
	struct hawser_report report;
	double worst = 0.0, most = 0.0;

	if (!opened(&net, scene, set, sets) || !stiffness(&K, &net, &node, 1, NULL)) {
		hawser_net_clear(&net);
		return;
	}
	for (int j = 0; j < 3; j++) {
		struct hawser_net_statics st[2];
		double place = net.node[node].x[j];

		for (int side = 0; side < 2; side++) {
			net.node[node].x[j] = place + (side ? step : -step);
			if (hawser_net_solve(&st[side], &net, NULL, &report))
				ok(0, "%s", report.message);
		}
		net.node[node].x[j] = place;
		for (int i = 0; i < 3; i++) {
			double slope = (st[1].reaction[node][i] - st[0].reaction[node][i])/(2.0*step);

			worst = fmax(worst, fabs(slope - K.K[i][j]));
			most = fmax(most, fabs(slope));
		}
		for (int side = 0; side < 2; side++)
			hawser_net_statics_clear(&st[side]);
	}
	ok(worst < 1e-5*most, "%s: differences of the equilibrium, by %.1e of %.6g N/m", what, worst/most,
	   most);
	ok(K.asymmetry >= least && (least > 0.0 || K.asymmetry < 1e-9), "asymmetry %.3g", K.asymmetry);
	hawser_net_clear(&net);
}

CASE(reference_net_stiffness)
{
	/* the first: the digits of the page, by another program */
	static const char *const first[] = {"g=9.4011927657697393"};
	static const char *const other[] = {"nodes={A: [0,0,0], B: [560, 131, 0]}", "cables.chain.rho=61",
	                                    "cables.chain.EA=90 MN", "cables.chain.length0=612",
	                                    "cables.chain.elements=300", "g=9.81"};
	static const char *const rough[] = {
		"cables.line.EA=50 MN", "cables.line.elements=300", "obstacles.seabed.friction=0.385",
		"contact={sliding: history, path: {B: [[330, 200, 0]]}, steps: 4}"};
	static const char *const tree[] = {
		"nodes={A: [0,0,0], B: [60,9,4], C: [22,-3,35], J: {}}",
		"cables=[{name: a, from: A, to: J, EA: 2e6, rho: 4, length0: 31, elements: 7}, "
		"{name: b, from: J, to: B, EA: 3e6, rho: 2.5, length0: 34, elements: 9}, "
		"{name: c, from: C, to: J, EA: 1e6, rho: 3, length0: 41, elements: 6}]",
		"supports={A: fixed, B: fixed, C: fixed}",
		"obstacles=[{plane: {point: [0, -900], normal: [0, 1]}}]"};
	static const char *const drum[] = {
		"contact={sliding: none}", "nodes.B=[1, -1, 0]", "cables.c.length0=4.2",
		"obstacles=[{circle: {centre: [0, 0], radius: 1}, friction: 0.3, velocity: 1}]"};
	static const char *const current[] = {
		"nodes={A: [0,-200,0], B: [200,-10,0]}", "g=9.81", "cables=[{name: c, from: A, to: B, "
		"EA: 20 MN, rho: 12, length0: 300, elements: 30, diameter: 0.12, drag: {normal: 1.2, "
		"tangential: 0.02}}]", ("water={density: 1025, current: {table: [[-200, 0.1, 0, 0.3], "
		"[0, 0.9, 0, 0.5]]}}"), "obstacles=[{plane: {point: [0, -900], normal: [0, 1]}}]"};
	struct hawser_net net;
	struct hawser_net_stiffness K;
	int end = 1;

	if (opened(&net, "net-mooring", first, 1) && stiffness(&K, &net, &end, 1, NULL)) {
		close_to(K.K[0][0], 45631.40, 2e-5, "W15: of W1's chain, N/m");
		close_to(K.K[0][1], 14335.53, 2e-5, "W15: of W1's chain, N/m");
		close_to(K.K[1][1], 6362.089, 2e-5, "W15: of W1's chain, N/m");
		close_to(K.K[2][2], 1130.749, 2e-6, "W15: of W1's chain, N/m");
	}
	hawser_net_clear(&net);
	chain("net-mooring", first, 1, 1065.6252, 753.6e6, 835.5, 0.0);
	chain("net-mooring", other, 6, 61*9.81, 90e6, 612.0, 0.0);
	chain("net-seabed", rough, 4, 81.549439*9.81, 5e7, 500.0, 0.385);
	body();
	differences("net-mooring", tree, 4, 1, 1e-4, 0.0, "a joint");
	differences("net-mooring", current, 5, 1, 1e-4, 1e-4, "a line in a current");
	differences("net-capstan", drum, 4, 1, 1e-5, 1e-3, "a rope on a drum that turns");
	return done_testing();
}
