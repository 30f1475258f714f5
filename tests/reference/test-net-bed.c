/* Beds of moorings, against numbers of other programs and closed forms: slopes, friction, chains
 * that are drawn across and along a bed, a bed that gives way at rest and in motion, and its
 * ledger. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <hawser/net_motion.h>

#include "tests/tap.h"

static int opened(struct hawser_net *net, const char *const *set, size_t sets)
{
	struct hawser_report report = {0};
	const char *path = source_file("notebooks-data/scenes/net-mooring.yaml");

	return ok(!hawser_net_open(net, path, set, sets, &report), "the scene: %s", report.message);
}

static int solved(struct hawser_net *net, struct hawser_net_statics *st, const char *const *set,
                  size_t sets)
{
	struct hawser_report report = {0};

	return opened(net, set, sets) &&
	       ok(!hawser_net_solve(st, net, NULL, &report), "solved: %s", report.message);
}

#define WEIGHT "g=9.4011927657697393"
#define PLANE(x, y) "obstacles=[{plane: {point: [0, 0], normal: [" x ", " y "]}}]"
#define ROUGH_OF(mu, more) "obstacles=[{plane: {point: [0, 0], normal: [0, 1]}, friction: " mu more "}]"
#define ROUGH(more) ROUGH_OF("0.6", more)

/* The chain of the scene: tension at the anchor, pull along x and y at the fairlead. */
static void chains(void)
{
	static const struct {
		const char *what, *set[3];
		double T_A, H, V;
	} of[] = {
		{"W1", {PLANE("0", "1"), WEIGHT, WEIGHT}, 900903.8, 900903.8, 629156.6},
		{"W17", {PLANE("-0.08715574274765817", "0.9961946980917455"), "nodes.B=[790, 220, 0]", WEIGHT},
		 751509.0, 779493.0, 603282.0},
		{"W17", {PLANE("0.08715574274765817", "0.9961946980917455"), "nodes.B=[790, 150, 0]", WEIGHT},
		 637368.0, 607094.0, 516470.0},
		{"W1", {ROUGH(", velocity: [-1, 0]"), WEIGHT, WEIGHT}, 745579.1, 902064.3, 629521.1},
		{"W1", {ROUGH(""), "contact={sliding: pulled, steps: 10}", WEIGHT},
		 745579.1, 902064.3, 629521.1},
	};

	for (size_t i = 0; i < sizeof of/sizeof *of; i++) {
		struct hawser_net net;
		struct hawser_net_statics st = {0};

		if (solved(&net, &st, of[i].set, 3)) {
			const double got[3] = {st.member[0].T_from, st.reaction[1][0], st.reaction[1][1]};
			const double want[3] = {of[i].T_A, of[i].H, of[i].V};

			for (int k = 0; k < 3; k++) {
				char what[60];

				snprintf(what, sizeof what, "%s: %s, N", of[i].what, (const char *[3]){
				         "tension at the anchor", "pull along x", "pull upwards"}[k]);
				close_to(got[k], want[k], 1e-5, what);
			}
		}
		hawser_net_statics_clear(&st);
		hawser_net_clear(&net);
	}
}

#define LINE(end, EA, length) "nodes={A: [0, 0, 0], B: [" end ", 0, 0]}", "g=9.81", \
	"cables=[{name: c, from: A, to: B, EA: " EA ", rho: 88.40752293577982, length0: " length ", " \
	"elements: 400}]"

/* Drawn across, a chain is a catenary under mu*w; pulled by T, it slides over T/(mu w) and moves by
 * T^2/(2 EA mu w). */
static void drawn(void)
{
	static const char *const across[] = {LINE("80", "600e6", "100"), ROUGH(", velocity: [0, 0, -1]")};
	static const char *const round[] = {LINE("80", "600e6", "100"),
		ROUGH_OF("{axial: 0.6, transverse: 0.6}", ", velocity: [0, 0, -1]")};
	static const char *const ellipse[] = {LINE("80", "600e6", "100"),
		ROUGH_OF("{axial: 0.5, transverse: 0.9}", ", velocity: [0, 0, -1]")};
	static const char *const along[] = {
		LINE("1000.0960861", "4e8", "1000"), ROUGH(""),
		"contact={sliding: history, path: {B: [[1000.00001, 0, 0]]}, steps: 2}"};
	struct hawser_net net;
	struct hawser_net_statics st = {0};
	double slid = 0.0;

	for (int i = 0; i < 3; i++) {
		if (solved(&net, &st, i == 2 ? ellipse : i ? round : across, 4)) {
			close_to(st.reaction[1][0], i == 2 ? 19274.57 : 17596.75, 1e-5, "W16: pull along, N");
			close_to(st.reaction[0][2] + st.reaction[1][2], i == 2 ? 67995.52 : 52036.67,
			         i == 2 ? 1e-5 : 1e-6, "W16: pull across, N");
		}
		hawser_net_statics_clear(&st);
		hawser_net_clear(&net);
	}
	if (solved(&net, &st, along, 5)) {
		for (int i = 0; i < st.contacts; i++)
			slid += st.contact[i].sticks ? 0.0 : st.contact[i].length0;
		close_to(st.reaction[1][0], 2e5, 1e-4, "W24: pull along the bed, N");
		close_to(slid, 384.344, 1e-2, "W24: length that slides, m");
	}
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
}

/* Down a slope of 4 degrees from x = 150 on; and the chain of the scene hauled in. A corner is rounded
 * over an element: of first order. */
static void corner(void)
{
	static const char *const bed[] = {
		"g=9.81", "nodes.B=[800, 140, 0]", "obstacles=[{name: bed, profile: [[-10, 0], [150, 0], "
		"[900, -52.44510895763281]]}]",
		"cables=[{name: line, from: A, to: B, EA: 753.6e6, rho: 108.62641988118506, length0: 835.5, "
		"elements: 400}]"};
	static const char *const hauled[] = {PLANE("0", "1"), "g=9.4011927657697393",
		"cables.chain.length0=833.4385", "cables.chain.elements=400"};
	struct hawser_net net;
	struct hawser_net_statics st = {0};

	if (solved(&net, &st, bed, 4)) {
		close_to(st.member[0].T_from, 650423.0, 2e-4, "W25: over a corner, tension at the anchor, N");
		close_to(st.reaction[1][0], 634895.0, 1e-4, "pull along x, N");
		close_to(st.reaction[1][1], 485855.0, 1e-4, "pull upwards, N");
	}
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
	if (solved(&net, &st, hauled, 4))
		close_to(st.member[0].T_to, 1.2e6, 1e-5, "W25: hauled in, tension at the fairlead, N");
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
}

#define SOFT "cables.chain.diameter=0.0766", WEIGHT, \
	"obstacles=[{plane: {point: [0, 0], normal: [0, 1]}, stiffness: 3e6, damping: 3e5}]"

/* The chain sinks by its weight over stiffness times diameter; its energy is that of the
 * certificate. */
static void gives_way(void)
{
	static const char *const set[] = {SOFT, "cables.chain.elements=200"};
	struct hawser_net net;
	struct hawser_net_statics st = {0};

	if (solved(&net, &st, set, 4)) {
		double least = 0.0;

		for (int i = 0; i < st.points/5; i++)
			least = fmin(least, st.point[i].x[1]);
		close_to(least, -4.637e-3, 1e-4, "W24: depth on a bed that gives way, m");
		ok(st.gap >= 0.0 && st.gap < 1e-13*st.energy && st.apart < 1e-11, "gap %.1e J, %.1e m", st.gap,
		   st.apart);
	}
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
}

/* The fairlead goes up and down by 1 m in 10 s, which grows over 20 s. In water; forces from 50 s
 * on. */
static void heaves(void)
{
	char path[] = P_tmpdir "/hawser-bed-XXXXXX", table[200];
	const char *const set[] = {
		"cables=[{name: c, from: A, to: B, EA: 753.6e6, rho: 113.35, length0: 835.5, elements: 80, "
		"diameter: 0.0766, drag: {normal: 2, tangential: 0.4}, added_mass: {normal: 1}}]",
		"g=9.81", "water={density: 1025, surface: 200}", table,
		"obstacles=[{plane: {point: [0, 0], normal: [0, 1]}, stiffness: 3e6, damping: 3e5}]"};
	const struct hawser_net_probe probe[] = {{0, -1, 0.0}, {1, -1, 0.0}};
	const struct hawser_net_motion_options options = {.until = 60.0, .every = 0.1, .step = 0.05,
	                                                  .probe = probe, .probes = 2};
	double range[2][2] = {{INFINITY, 0.0}, {INFINITY, 0.0}};
	struct hawser_net net;
	struct hawser_net_motion motion = {0};
	struct hawser_report report = {0};
	int file = mkstemp(path);
	FILE *to = file < 0 ? NULL : fdopen(file, "w");

	for (int i = 0; to && i <= 610; i++) {
		double t = 0.1*i, q = fmin(t/20.0, 1.0), p = q*q*q*(10.0 - 15.0*q + 6.0*q*q);

		fprintf(to, "%.17g 0 %.17g 0\n", t, p*sin(2.0*M_PI*t/10.0));
	}
	ok(to && fclose(to) == 0, "a table of the motion");
	snprintf(table, sizeof table, "supports={A: fixed, B: {table: %s}}", path);
	if (opened(&net, set, 5) && ok(!hawser_net_integrate(&motion, &net, &options, &report), "%s",
	                               report.message)) {
		for (int i = 1000; i <= 1200; i++)
			for (int k = 0; k < 2; k++) {
				range[k][0] = fmin(range[k][0], motion.T[i/2*2 + k]);
				range[k][1] = fmax(range[k][1], motion.T[i/2*2 + k]);
			}
		close_to(range[0][0], 855.9e3, 1e-3, "W9: least tension at the anchor, N");
		close_to(range[0][1], 943.8e3, 1e-3, "W9: largest tension at the anchor, N");
		close_to(range[1][0], 1049.5e3, 1e-3, "W9: least tension at the fairlead, N");
		close_to(range[1][1], 1146.3e3, 1e-3, "W9: largest tension at the fairlead, N");
		ok(motion.closure < 1e-10, "energy closed to %.1e", motion.closure);
	}
	remove(path);
	hawser_net_motion_clear(&motion);
	hawser_net_clear(&net);
}

/* A chain on a slope whose joint with a light rope is just above it, in a current whose table has
 * corners: the stated error against four times the elements. */
static void joint(void)
{
	double T[2] = {NAN, NAN}, stated = NAN, least = NAN; /* least: the stated error is over it */

	for (int i = 0; i < 2; i++) {
		char cables[600];
		const char *const set[] = {
			"nodes={A: [0, -205.59, 0], J: {}, K: {}, B: [140.83, -5, -100.56]}", cables,
			"water={density: 1025, current: {table: [[-205.59, 0.1, 0, 0], [-68.53, 0.4, 0, -0.58], "
			"[0, 0.23, 0, -0.6]]}}",
			"obstacles=[{plane: {point: [0, -205.59], normal: [-0.026626, 1]}}]", "g=9.81"};
		const int n = i ? 120 : 30;
		struct hawser_net net = {0};
		struct hawser_net_statics st = {0};
		struct hawser_net_mesh_error error;
		struct hawser_report report = {0};

		snprintf(cables, sizeof cables, "cables=[{name: a, from: A, to: J, EA: 2.17e6, rho: 103.97, "
		         "length0: 111.46, diameter: 0.13811, drag: {normal: 0.9}, elements: %d}, {name: b, "
		         "from: J, to: K, EA: 137e6, rho: 1.605, length0: 76.84, diameter: 0.040925, drag: "
		         "{normal: 1.66}, elements: %d}, {name: c, from: K, to: B, EA: 95e6, rho: 347.6, "
		         "length0: 172.2, diameter: 0.2445, drag: {normal: 1.47}, elements: %d}]", n, n, n);
		if (solved(&net, &st, set, 5)) {
			T[i] = st.member[0].T_to;
			least = 0.01*st.member[2].T_max;
		}
		if (!i && ok(!hawser_net_mesh_error(&error, &net, &st, &report), "%s", report.message))
			stated = error.tension;
		hawser_net_statics_clear(&st);
		hawser_net_clear(&net);
	}
	ok(fabs(T[0] - T[1])/least < 1.5*stated && stated < 0.1, "tension at a joint above the bed: %.2f, "
	   "%.2f N, stated %.1e", T[0], T[1], stated);
}

/* Pulled along a rough bed that gives way by u, and back, slowly: T^2/(2 EA mu w) = u, and on the way
 * back by v of it (T1 - T)^2/(4 EA mu w) = v. */
static void rubs(double EA, double rho, double mu, double T, const char *friction)
{
	const double w = 9.81*rho, u = T*T/(2.0*EA*mu*w), back = 0.5*(1.0 - cos(0.25*M_PI));
	char cables[300], ends[200], support[200], bed[200];
	const char *const set[] = {"g=9.81", cables, ends, support, bed};
	struct hawser_net net = {0};
	struct hawser_net_motion m = {0};
	struct hawser_report report = {0};
	const struct hawser_net_probe probe = {1, -1, 0.0};
	const struct hawser_net_motion_options options = {
		.until = 12.5, .every = 2.5, .step = 0.05, .probe = &probe, .probes = 1};

	snprintf(cables, sizeof cables, "cables=[{name: c, from: A, to: B, EA: %.17g, rho: %.17g, length0: "
	         "%.17g, diameter: 0.08, elements: 100}]", EA, rho, 1.3*T/(mu*w));
	snprintf(ends, sizeof ends, "nodes={A: [0, 0, 0], B: [%.17g, 0, 0]}", 1.3*T/(mu*w) + 0.5*u);
	snprintf(support, sizeof support, "supports={A: fixed, B: {motion: {x: {amplitude: %.17g, Omega: "
	         "%.17g}}}}", -0.5*u, 0.1*M_PI);
	snprintf(bed, sizeof bed, "obstacles=[{plane: {point: [0, 0], normal: [0, 1]}, friction: %s, "
	         "stiffness: 3e6}]", friction);
	if (opened(&net, set, 5) &&
	    ok(!hawser_net_integrate(&m, &net, &options, &report), "pulled: %s", report.message)) {
		close_to(m.T[4], T, 6e-3, "pull at the end of the way, N");
		ok(fabs(m.T[5] - T + sqrt(4.0*EA*mu*w*back*u)) < 1e-2*T, "and on the way back: %.1f of %.1f N",
		   m.T[5], T);
		ok(m.closure < 1e-11, "the ledger closes to %.1e", m.closure);
	}
	hawser_net_motion_clear(&m);
	hawser_net_clear(&net);
}

/* The ellipse of a bed that gives way and moves across a chain, in a motion that begins at rest: the
 * pulls of W16 stay. */
static void oval(void)
{
	const char *const set[] = {
		"nodes={A: [0, 0, 0], B: [80, 0, 0]}", "g=9.81",
		"cables=[{name: c, from: A, to: B, EA: 600e6, rho: 88.40752293577982, length0: 100, "
		"diameter: 0.0766, elements: 80}]",
		"obstacles=[{plane: {point: [0, 0], normal: [0, 1]}, stiffness: 3e9, damping: 3e7, "
		"friction: {axial: 0.5, transverse: 0.9}, velocity: [0, 0, -1]}]"};
	const struct hawser_net_probe probe[] = {{0, -1, 0.0}, {1, -1, 0.0}};
	const struct hawser_net_motion_options options = {
		.until = 3.0, .every = 3.0, .step = 0.05, .probe = probe, .probes = 2};
	struct hawser_net net = {0};
	struct hawser_net_motion m = {0};
	struct hawser_report report = {0};

	if (opened(&net, set, 4) &&
	    ok(!hawser_net_integrate(&m, &net, &options, &report), "dragged: %s", report.message)) {
		close_to(-m.pull[3][0], 19274.57, 1e-3, "pull along, N");
		close_to(-m.pull[2][2] - m.pull[3][2], 67995.52, 1e-3, "pull across, N");
		ok(m.closure < 1e-11, "the ledger closes to %.1e", m.closure);
	}
	hawser_net_motion_clear(&m);
	hawser_net_clear(&net);
}

CASE(reference_net_bed)
{
	chains();
	drawn();
	corner();
	gives_way();
	heaves();
	joint();
	rubs(4e8, 867.2778/9.81, 0.6, 2e5, "0.6");
	rubs(2.5e8, 41.3, 0.35, 6e4, "{axial: 0.35, transverse: 0.83}");
	oval();
	return done_testing();
}
