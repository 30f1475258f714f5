/* Beds of any shape, against a program that shares no code with this one: Newton's method for the
 * energy of the nodes, with heights as means of the polyline over the rounding (box), and the nearest
 * point by tangent planes, in Python. Level and sloped grids against planes, grids against profiles,
 * and the ledger of motions over corners. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net_motion.h>

#include "net/motion/motion-contact.h"
#include "tests/tap.h"

#define CORNER "profile: [[-10, 0], [150, 0], [900, -52.44510895763281]]"
#define HILLS "profile: [[-10, 0], [150, -8], [300, 5], [450, -20], [900, 0]]"
#define TROUGH "profile: [[-10, 0], [150, -20], [350, -25], [900, 40]]"
#define SOFT ", stiffness: 3e6, damping: 3e5"

static char path[] = P_tmpdir "/hawser-ground-XXXXXX", bed_text[300], cable_text[300];

/* The scene with this bed, a line of this length and number of elements, and its ends. */
static int opened(struct hawser_net *net, const char *bed, double length, int n, const char *nodes,
                  const char *more)
{
	const char *set[] = {nodes, cable_text, bed_text, "g=9.4011927657697393", more};
	struct hawser_report report = {0};
	const char *file = source_file("notebooks-data/scenes/net-mooring.yaml");

	snprintf(bed_text, sizeof bed_text, "obstacles=[{name: bed, %s}]", bed);
	snprintf(cable_text, sizeof cable_text, "cables=[{name: line, from: A, to: B, EA: 753.6e6, rho: "
	         "113.35, length0: %.17g, elements: %d, diameter: 0.0766}]", length, n);
	return ok(!hawser_net_open(net, file, set, more ? 5 : 4, &report), "the scene: %s", report.message);
}

/* A file of a grid whose heights are y(x, z). */
static int grid(double (*y)(double x, double z), int nx, const double *x, int nz, const double *z)
{
	FILE *to = fopen(path, "w");

	for (int i = 0; to && i < nx*nz; i++)
		fprintf(to, "%.17g %.17g %.17g\n", x[i % nx], y(x[i % nx], z[i/nx]), z[i/nx]);
	return ok(to && fclose(to) == 0, "a file of a grid");
}

static double ridge(double x, double z)
{
	return 12.0*fmax(0.0, 1.0 - fabs(x + 0.7*z - 250.0)/120.0) - 0.01*x;
}

static void judged(void)
{
	char by_file[200], rigid[200];
	double x[21], z[13];
	const struct {
		const char *bed, *nodes;
		double length, H, across;
	} of[] = {
		{CORNER, "nodes={A: [0, 0, 0], B: [800, 140, 0]}", 835.5, 634724.83650, 0.0},
		{CORNER SOFT, "nodes={A: [0, 0, 0], B: [800, 140, 0]}", 835.5, 634744.290787, 0.0},
		{HILLS, "nodes={A: [0, -0.5, 0], B: [796.732, 186, 0]}", 835.5, 873089.4263, 0.0},
		{HILLS SOFT, "nodes={A: [0, -0.5, 0], B: [796.732, 186, 0]}", 835.5, 873416.42075, 0.0},
		{TROUGH, "nodes={A: [0, 0, 0], B: [796.732, 150, 0]}", 850.0, 273933.5915, 0.0},
		{TROUGH SOFT, "nodes={A: [0, 0, 0], B: [796.732, 150, 0]}", 850.0, 273967.725108, 0.0},
		{by_file, "nodes={A: [0, 0, 0], B: [780, 186, 160]}", 835.5, 798946.41157, 166017.826217},
		{rigid, "nodes={A: [0, 0, 0], B: [780, 186, 160]}", 835.5, 798981.379205, 166038.315251},
	};

	for (int i = 0; i < 21; i++)
		x[i] = -50.0 + 50.0*i;
	for (int i = 0; i < 13; i++)
		z[i] = -200.0 + 50.0*i;
	snprintf(by_file, sizeof by_file, "grid: %s%s", path, SOFT);
	snprintf(rigid, sizeof rigid, "grid: %s", path);
	grid(ridge, 21, x, 13, z);
	for (size_t i = 0; i < sizeof of/sizeof *of; i++) {
		struct hawser_net net = {0};
		struct hawser_net_statics st = {0};
		struct hawser_report report = {0};

		if (opened(&net, of[i].bed, of[i].length, 100, of[i].nodes, NULL) &&
		    ok(!hawser_net_solve(&st, &net, NULL, &report), "%s", report.message)) {
			close_to(st.reaction[1][0], of[i].H, 1e-8, "pull along x, N");
			close_to(st.reaction[1][2], of[i].across, of[i].across > 0.0 ? 1e-8 : 0.0,
			         "pull along z, N");
		}
		hawser_net_statics_clear(&st);
		hawser_net_clear(&net);
	}
}

/* Fairlead and end of a motion on a bed: T at both ends and the largest closure of the ledger. */
static void moved(double T[2], const char *bed, int n, double until)
{
	const struct hawser_net_probe probe[] = {{0, -1, 0.0}, {1, -1, 0.0}};
	const struct hawser_net_motion_options options = {.until = until, .every = until, .step = 0.05,
	                                                  .probe = probe, .probes = 2};
	struct hawser_net net = {0};
	struct hawser_net_motion m = {0};
	struct hawser_report report = {0};

	T[0] = T[1] = NAN;
	if (opened(&net, bed, 835.5, n, "nodes={A: [0, -0.2, 0], B: [780, 186, 60]}",
	           "supports={A: fixed, B: {motion: {x: {amplitude: 1 m, Omega: 0.8}, z: {amplitude: 2 m, "
	           "Omega: 0.8}}}}") &&
	    ok(!hawser_net_integrate(&m, &net, &options, &report), "%s: %s", bed, report.message)) {
		memcpy(T, &m.T[2], 2*sizeof *T);
		ok(m.closure < 1e-10, "energy closed to %.1e", m.closure);
	}
	hawser_net_motion_clear(&m);
	hawser_net_clear(&net);
}

static double slope(double x, double z)
{
	return -0.03*x + 0.02*z - 0.5;
}

static double hills(double x, double z)
{
	const double at[] = {-50, 150, 300, 450, 900}, y[] = {0, -8, 5, -20, 0};
	int i = 0;

	(void)z;
	while (i < 3 && x >= at[i + 1])
		i++;
	return y[i] + (y[i + 1] - y[i])*(x - at[i])/(at[i + 1] - at[i]);
}

/* One bed in two forms gives one motion, rigid or giving way, with friction. */
static void same(void)
{
	static const char *const rules[] = {"", SOFT, ", friction: 0.6", SOFT ", friction: 0.6"};
	static const double x[] = {-50, 150, 300, 450, 900}, z[] = {-100, -20, 200};
	char bed[300];

	for (int i = 0; i < 8; i++) {
		double one[2], other[2];
		int level = i < 4;

		grid(level ? slope : hills, 5, x, 3, z);
		snprintf(bed, sizeof bed, "grid: %s%s", path, rules[i % 4]);
		moved(one, bed, 40, 4.0);
		snprintf(bed, sizeof bed, "%s%s", level
		         ? "plane: {point: [0, -0.5, 0], normal: [0.03, 1, -0.02]}"
		         : "profile: [[-50, 0], [150, -8], [300, 5], [450, -20], [900, 0]]", rules[i % 4]);
		moved(other, bed, 40, 4.0);
		for (int k = 0; k < 2; k++)
			close_to(one[k], other[k], 1e-9, level ? "tension: a grid as a plane"
			         : "tension: a grid as a profile");
	}
}

/* The stiffness at the fairlead: a sloped grid as the plane; over hills, where the line leaves flat
 * parts and a rounded corner, differences of equilibria 0.1 m off. */
static void stiffness(void)
{
	static const char *const bed[] = {"plane: {point: [0, -0.5, 0], normal: [0.03, 1, -0.02]}", path,
	                                  HILLS, HILLS, HILLS};
	static const double x[] = {0.0, 0.0, 796.732, 796.632, 796.832};
	double H[5] = {0}, K[5] = {0};

	for (int i = 0; i < 5; i++) {
		struct hawser_net net = {0};
		struct hawser_net_stiffness at;
		struct hawser_report report = {0};
		char nodes[100], file[sizeof path + 20];

		snprintf(file, sizeof file, "grid: %s", path);
		snprintf(nodes, sizeof nodes, "nodes={A: [0, -0.48, 0], B: [%.17g, 186, 0]}",
		         i < 2 ? 780.0 : x[i]);
		if (opened(&net, i == 1 ? file : bed[i], 835.5, 400, nodes, NULL) &&
		    ok(!hawser_net_stiffness_of(&at, &net, (const int []){1}, 1, NULL, &report), "%s",
		       report.message)) {
			H[i] = at.force[0];
			K[i] = at.K[0][0];
		}
		hawser_net_clear(&net);
	}
	close_to(K[1], K[0], 1e-7, "stiffness along x on a grid, as on a plane, N/m");
	close_to(K[2], (H[4] - H[3])/0.2, 4e-4, "and over hills, by differences, N/m");
}

/* Nodes that go over corners which are sharper than elements: the ledger, and the same with half the
 * step. */
static void corners(void)
{
	static const char *const rules[] = {"", SOFT, ", stiffness: 1e5, friction: 0.3"};
	char bed[200];

	for (int i = 0; i < 3; i++) {
		double T[2];

		snprintf(bed, sizeof bed, "profile: [[-50, 2], [60, -12], [110, 0], [160, -12], [900, -12]], "
		         "rounding: 0.4%s", rules[i]);
		moved(T, bed, 80, 4.0);
		ok(T[1] > 0.0, "T %.9g, %.9g", T[0], T[1]);
	}
}

/* The mean normal of a step over a corner: it has the change of the gap along the way, and its
 * derivative is that of differences. */
static void mean(void)
{
	static const double x[] = {-3.0, 0.2, 1.1, 4.0}, z[] = {-2.0, 0.9, 2.385};
	static const double from[3] = {-0.2, 0.31, 0.5};
	double y[12], H1[3][3], n0[3], n1[3], n[3], by[3][3], apart = 0.0, off = 0.0;
	struct hawser_surface bed = {.kind = HAWSER_SURFACE_GRID};
	struct hawser_report report = {0};

	for (int i = 0; i < 12; i++)
		y[i] = 0.4*x[i % 4]*cos(z[i/4]) - 0.3*x[i % 4]*x[i % 4];
	ok(!hawser_heights_make(&bed.heights, 4, x, 3, z, y, 0.45, &report) &&
	   !hawser_surface_settle(&bed, &report), "a bed");
	for (int i = 0; i < 9; i++) {
		double to[3] = {0.1 + 0.07*i, 0.3 - 0.02*i, 0.62 + 0.05*i};
		double change = -hawser_surface_gap(n0, NULL, &bed, from), along = 0.0;

		change += hawser_surface_gap(n1, H1, &bed, to);
		hawser__mean_normal(n, by, &bed, from, to, change, n0, n1, (const double (*)[3])H1);
		for (int k = 0; k < 3; k++) {
			double up[3] = {to[0], to[1], to[2]}, m[3], m1[3], more;

			along += n[k]*(to[k] - from[k]);
			up[k] += 1e-6;
			more = hawser_surface_gap(m1, NULL, &bed, up) - hawser_surface_gap(n1, NULL, &bed, to);
			hawser__mean_normal(m, NULL, &bed, from, up, change + more, n0, m1, NULL);
			for (int j = 0; j < 3; j++)
				off = fmax(off, fabs((m[j] - n[j])/1e-6 - by[j][k]));
		}
		apart = fmax(apart, fabs(along - change));
	}
	ok(apart < 1e-15, "its product with the way is the change of the gap, to %.1e m", apart);
	ok(off < 1e-5, "its derivative is that of differences, to %.1e/m", off);
	hawser_heights_free(bed.heights);
}

/* Friction over hills, all towards the anchor: a bed that moves there, and a line that is drawn over
 * it. */
static void dragged(void)
{
	double T[2] = {0};

	for (int i = 0; i < 2; i++) {
		struct hawser_net net = {0};
		struct hawser_net_statics st = {0};
		struct hawser_report report = {0};

		if (opened(&net, i ? HILLS ", friction: 0.6, velocity: -1" : HILLS ", friction: 0.6", 835.5,
		           100, "nodes={A: [0, -0.5, 0], B: [796.732, 186, 0]}",
		           i ? NULL : "contact={sliding: pulled, steps: 10}") &&
		    ok(!hawser_net_solve(&st, &net, NULL, &report), "%s", report.message))
			T[i] = st.member[0].T_from;
		hawser_net_statics_clear(&st);
		hawser_net_clear(&net);
	}
	close_to(T[1], T[0], 1e-8, "a profile that moves, and a line that is pulled: T at the anchor, N");
}

CASE(reference_net_ground)
{
	int file = mkstemp(path);

	ok(file >= 0, "a temporary file");
	judged();
	same();
	corners();
	mean();
	dragged();
	grid(slope, 5, (const double []){-50, 150, 300, 450, 900}, 2, (const double []){-100, 200});
	stiffness();
	remove(path);
	return done_testing();
}
