/* Cables with a table of strains and tensions: a rope of another program's case, ropes across the
 * pieces of their laws against closed forms, tables of a straight line, and what has no place for
 * them. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net_equilibria.h>
#include <hawser/net_modes.h>
#include <hawser/net_motion.h>

#include "tests/tap.h"

static enum hawser_status opened(struct hawser_net *net, const char *const *set, size_t sets,
                                 struct hawser_report *report)
{
	const char *path = source_file("notebooks-data/scenes/net-mooring.yaml");

	return hawser_net_open(net, path, set, sets, report);
}

/* The rope with this EA and so many elements: force on the support B. */
static int rope(double force[3], double K[6][6], const char *EA, int elements, const double B[2])
{
	char cable[300], nodes[100];
	const char *const set[] = {
		cable, nodes, "g=9.81", "water={density: 1025, surface: 900}",
		"obstacles=[{plane: {point: [0, -900], normal: [0, 1]}}]"};
	const int node = 1;
	struct hawser_net net;
	struct hawser_net_statics st = {0};
	struct hawser_net_stiffness stiffness;
	struct hawser_report report = {0};
	int right;

	snprintf(cable, sizeof cable, "cables=[{name: c, from: A, to: B, EA: %s, rho: 20, diameter: 0.18, "
	         "length0: 1100, elements: %d}]", EA, elements);
	snprintf(nodes, sizeof nodes, "nodes={A: [0, 0, 0], B: [%.17g, %.17g, 0]}", B[0], B[1]);
	right = !opened(&net, set, 5, &report) && !hawser_net_solve(&st, &net, NULL, &report) &&
	        !hawser_net_stiffness_of(&stiffness, &net, &node, 1, NULL, &report);
	if (ok(right, "a rope: %s", report.message)) {
		memcpy(force, st.reaction[0], 3*sizeof *force);
		memcpy(K, stiffness.K, sizeof stiffness.K);
	}
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
	return right;
}

#define TABLE "{table: [[0.01, 1e6], [0.02, 1.6e6], [0.04, 4e6], [0.08, 12e6]]}"

static void another_program(void)
{
	static const double B[2] = {800.0, 800.0}, h = 0.01;
	double f[3][3] = {{0.0}}, K[6][6], unused[6][6];

	if (!rope(f[0], K, TABLE, 100, B) || !rope(f[1], unused, TABLE, 50, B))
		return;
	close_to(f[0][0], -1855294.6, 1e-7, "W18: pull along x, N");
	close_to(f[0][1], -1888210.5, 1e-7, "W18: pull upwards, N");
	close_to(f[0][0] + (f[0][0] - f[1][0])/3.0, -1855294.6, 3e-8, "W18: the same of fine meshes, N");
	for (int k = 0; k < 2; k++) {
		double at[2][2] = {{B[0], B[1]}, {B[0], B[1]}};

		at[0][k] -= h;
		at[1][k] += h;
		if (rope(f[1], unused, TABLE, 100, at[0]) && rope(f[2], unused, TABLE, 100, at[1]))
			for (int i = 0; i < 2; i++)
				close_to(K[i][k], (f[1][i] - f[2][i])/(2.0*h), 1e-6, "stiffness at B, N/m");
	}
	if (rope(f[0], K, "1e8", 20, B) &&
	    rope(f[1], K, "{table: [[0.01, 1e6], [0.03, 3e6], [0.06, 6e6]]}", 20, B))
		ok(!memcmp(f[0], f[1], sizeof f[0]), "a straight line is EA");
}

static const double law[][2] = {{0.001, 2e3}, {0.002, 10e3}, {0.01, 30e3}, {0.05, 32e3}, {0.06, 90e3}};
enum { ROWS = sizeof law/sizeof *law, PARTS = 40 };

/* The law turned around. */
static double strain_of(double T)
{
	int i = 0;

	while (i < ROWS - 1 && T > law[i][1])
		i++;
	return i ? law[i - 1][0] + (T - law[i - 1][1])/(law[i][1] - law[i - 1][1])*
	                           (law[i][0] - law[i - 1][0]) : T*law[0][0]/law[0][1];
}

struct hanging {
	struct hawser_net_node node[2];
	struct hawser_net_cable cable;
	struct hawser_net net;
	char name[8];
};

/* A rope under its end A, with this mass per length and a mass at B. */
static void hang(struct hanging *h, double rho, double mass, int elements)
{
	*h = (struct hanging){
		.node = {{.name = "A", .placed = 1, .held = {1, 1, 1}, .support = 1},
		         {.name = "B", .mass = mass}},
		.cable = {.name = "c", .from = 0, .to = 1, .EA = law[0][1]/law[0][0], .rho = rho,
		          .rows = ROWS, .value = 100.0, .elements = elements}};
	memcpy(h->cable.law, law, sizeof law);
	memcpy(h->name, "rope", sizeof "rope");
	h->net = (struct hawser_net){.name = h->name, .g = 9.81, .node = h->node, .cable = &h->cable,
	                             .nodes = 2, .cables = 1};
}

/* Height of B, and energy. */
static double hung(double *energy, struct hanging *h)
{
	struct hawser_net_statics st = {0};
	struct hawser_report report = {0};
	double y = NAN;

	if (ok(!hawser_net_solve(&st, &h->net, NULL, &report), "a rope hangs: %s", report.message)) {
		ok(st.gap < 1e-12*fabs(st.energy), "gap %.1e of %.1e J", st.gap, st.energy);
		y = st.x[1][1];
		*energy = st.energy;
	}
	hawser_net_statics_clear(&st);
	return y;
}

static void across_pieces(void)
{
	static const double rho = 50.0, g = 9.81;
	struct hanging h;
	double energy[3], y, want = 0.0, length = 100.0/PARTS;

	for (int i = 0; i < PARTS; i++)
		want -= length*(1.0 + strain_of(100.0*g + rho*length*g*(i + 0.5)));
	hang(&h, rho, 100.0, PARTS);
	y = hung(&energy[0], &h);
	close_to(y, want, 1e-12, "height, m");
	hang(&h, rho, 99.0, PARTS);
	hung(&energy[1], &h);
	hang(&h, rho, 101.0, PARTS);
	hung(&energy[2], &h);
	close_to((energy[2] - energy[1])/(2.0*g), y, 1e-6, "the energy over the weight of the mass, m");
}

/* Equilibria on the pieces alone would go to and fro. */
static void steep(void)
{
	struct hawser_net net;
	struct hawser_net_statics st = {0};
	struct hawser_report report = {0};

	if (ok(!hawser_net_open(&net, source_file("tests/reference/net-law.yaml"), NULL, 0, &report) &&
	       !hawser_net_solve(&st, &net, NULL, &report), "steep laws: %s", report.message))
		ok(st.residual < 1e-6 && st.gap < 1e-12*st.energy, "balanced to %.1e N, gap %.1e J",
		   st.residual, st.gap);
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
}

/* A mass on a rope without mass: the slope of the law is the stiffness. */
static void swings(void)
{
	static const double mass[] = {100.0, 500.0, 2000.0, 3200.0, 5000.0};

	for (size_t i = 0; i < sizeof mass/sizeof *mass; i++) {
		struct hanging h;
		struct hawser_net_modes modes = {0};
		struct hawser_report report = {0};
		double slope = i ? (law[i][1] - law[i - 1][1])/(law[i][0] - law[i - 1][0])
		                 : law[0][1]/law[0][0];
		double T = mass[i]*9.81, l = 100.0*(1.0 + strain_of(T)), most = 0.0, least = INFINITY;

		hang(&h, 0.0, mass[i], 1);
		if (ok(!hawser_net_modes_solve(&modes, &h.net, 3, &report), "modes: %s", report.message))
			for (int k = 0; k < modes.n; k++) {
				most = fmax(most, modes.omega[k]);
				least = fmin(least, modes.omega[k]);
			}
		close_to(fmax(sqrt(slope/(100.0*mass[i])), sqrt(9.81/l)), most, 1e-11, "largest, rad/s");
		close_to(fmin(sqrt(slope/(100.0*mass[i])), sqrt(9.81/l)), least, 1e-11, "least, rad/s");
		hawser_net_modes_clear(&modes);
	}
}

static void refused(void)
{
	static const char *const bad[][2] = {
		{"cables.chain.EA={table: [[0.01, 1e6], [0.01, 2e6]]}", "both must rise"},
		{"cables.chain.EA={table: [[0.01, 1e6], [0.02, 1e6]]}", "both must rise"},
		{"cables.chain.EA={table: [[0, 0], [0.02, 1e6]]}", "both must rise"},
		{"cables.chain.EA={table: [[0.01, 1e6], [0.5, 1.1e6]]}", "with a slope above"},
		{"cables.chain.EA={table: []}", "must be a number or {table"},
		{"cables.chain.EA={table: [[0.01, 1e6, 2]]}", "a row must be [strain, tension]"},
		{"cables=[{name: c, from: A, to: B, EA: {table: [[0.01, 1e6]]}, rho: 1, tension: 1e6}]",
		 "which needs length0 and no damper"},
	};
	const struct hawser_net_motion_options motion = {.until = 1.0, .scheme = "alpha"};
	const struct hawser_net_options by = {.method = "catenary"};
	struct hawser_net_equilibria equilibria = {0};
	struct hawser_net_motion run = {0};
	struct hawser_net_statics st = {0};
	struct hawser_report report = {0};
	struct hanging h;

	for (size_t i = 0; i < sizeof bad/sizeof *bad; i++) {
		struct hawser_net net = {0};

		ok(opened(&net, bad[i], 1, &report) == HAWSER_ERR_SCENE &&
		   strstr(report.message, bad[i][1]), "%s: %s", bad[i][0], report.message);
		hawser_net_clear(&net);
	}
	hang(&h, 1.0, 0.0, 4);
	ok(hawser_net_integrate(&run, &h.net, &motion, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "another scheme than energy cannot use"), "%s", report.message);
	ok(hawser_net_solve(&st, &h.net, &by, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	ok(hawser_net_equilibria_find(&equilibria, &h.net, NULL, &report) == HAWSER_ERR_ARGUMENT, "%s",
	   report.message);
	hawser_net_motion_clear(&run);
	hawser_net_statics_clear(&st);
	hawser_net_equilibria_clear(&equilibria);
}

/* In motion, with damping and slack: a table of a straight line is EA, and one whose pieces the rope
 * crosses has a ledger. */
static void tables(const struct hawser_net_motion_options *options, const char *const *set)
{
	static const char *const EA[] = {"20 MN", "{table: [[0.5, 10 MN]]}",
		"{table: [[0.005, 0.1 MN], [0.012, 0.3 MN], [0.02, 0.9 MN], [0.03, 1 MN]]}"};
	struct hawser_report report = {0};
	double T[3] = {0.0};

	for (int i = 0; i < 3; i++) {
		char cable[300];
		const char *const own[] = {set[0], set[1], cable, set[3], "supports.B.motion.x.amplitude=2.9"};
		struct hawser_net net;
		struct hawser_net_motion to = {0};

		snprintf(cable, sizeof cable, "cables=[{name: c, from: A, to: B, EA: %s, rho: 2.3, length0: "
		         "100, elements: 8, axial: 0.05}]", EA[i]);
		if (ok(!opened(&net, own, 5, &report), "a rope: %s", report.message) &&
		    ok(!hawser_net_integrate(&to, &net, options, &report), "%s", report.message)) {
			T[i] = to.T[to.rows - 1];
			ok(to.closure <= 1e-11 && to.switches > 20, "the ledger closes to %.1e", to.closure);
		}
		hawser_net_motion_clear(&to);
		hawser_net_clear(&net);
	}
	close_to(T[1], T[0], 1e-6, "tension by a table of a straight line, N");
}

/* A rope that is stiffer when it is quick: its tension over its strain at a period of 10 s, by its
 * springs and its dashpot in closed form; and the ledger where it is slack for a part of the
 * time. */
static void creeps(void)
{
	static const char *const set[] = {
		"obstacles=[{plane: {point: [0, -900], normal: [0, 1]}}]",
		"nodes={A: [0, 0, 0], B: [101, 0, 0]}",
		("cables=[{name: c, from: A, to: B, EA: {static: 20 MN, dynamic: 50 MN, viscosity: 0.2 GN s}, "
		 "rho: 1e-3, length0: 100, elements: 4}]"),
		"supports.B={motion: {x: {amplitude: 0.37, Omega: 0.62831853071795862}}}",
		"cables.c.rho=2.3", "supports.B.motion.x.amplitude=3"};
	const struct hawser_net_probe at = {.node = 1, .cable = -1};
	struct hawser_net_motion_options options = {.every = 0.1, .step = 0.025, .probe = &at, .probes = 1};
	const double w = 0.62831853071795862;
	struct hawser_report report = {0};
	double c[2] = {0.0};

	for (int i = 0; i < 2; i++) {
		struct hawser_net net;
		struct hawser_net_motion to = {0};

		options.until = i ? 20.0 : 60.0;
		if (ok(!opened(&net, set, i ? 6 : 4, &report), "a rope: %s", report.message) &&
		    ok(!hawser_net_integrate(&to, &net, &options, &report), "%s", report.message)) {
			for (int row = 500; row < 600 && !i; row++) {
				c[0] += to.T[row]*cos(w*0.1*row)/50.0/0.0037;
				c[1] -= to.T[row]*sin(w*0.1*row)/50.0/0.0037;
			}
			ok(to.closure <= 1e-11 && (i == 0 || to.switches > 100), "the ledger closes to %.1e",
			   to.closure);
		}
		hawser_net_motion_clear(&to);
		hawser_net_clear(&net);
	}
	tables(&options, set);
	close_to(c[0], 40836776.0, 1e-5, "W19: tension over strain in phase, N");
	close_to(c[1], 13817816.0, 1e-5, "W19: a quarter before it, N");
}

/* W23: cooled by 35 K, with 1.2e-5 1/K; the unstretched length of a net's cable changes with it. */
static void cooled(void)
{
	for (int i = 0; i < 2; i++) {
		char cable[200];
		const char *const set[] = {cable, "nodes={A: [0, 0, 0], B: [100, 0, 0]}", "g=0",
		                           "obstacles=", "contact="};
		struct hawser_net net;
		struct hawser_net_statics st = {0};
		struct hawser_report report = {0};

		snprintf(cable, sizeof cable, "cables=[{name: c, from: A, to: B, EA: 12e6, rho: 1, length0: "
		         "%.17g, elements: 3}]", 99.5*(i ? 1.0 - 35.0*1.2e-5 : 1.0));
		if (ok(!opened(&net, set, 5, &report) && !hawser_net_solve(&st, &net, NULL, &report),
		       "W23: %s", report.message))
			close_to(st.member[0].T_to, i ? 65368.96 : 60301.51, 1e-7, "W23: tension, N");
		hawser_net_statics_clear(&st);
		hawser_net_clear(&net);
	}
}

CASE(reference_net_law)
{
	cooled();
	another_program();
	across_pieces();
	steep();
	swings();
	creeps();
	refused();
	return done_testing();
}
