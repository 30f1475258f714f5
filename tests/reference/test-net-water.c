/* Nets in water against numbers of two other programs: a string that an integrator of ordinary
 * differential equations follows, and elements of other kinds (doc/water.md).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <hawser/net.h>

#include "tests/tap.h"

enum { PARTS_OF_LINE = 3 };

struct wet_scene {
	struct hawser_net net;
	struct hawser_net_node node[PARTS_OF_LINE + 1];
	struct hawser_net_cable cable[PARTS_OF_LINE];
	struct hawser_water_level level[4];
};

/* One line of several cables between two places. */
static void wet_line_of(struct wet_scene *scene, int cables, const double to[3], const double from[3])
{
	static char name[] = "water";

	memset(scene, 0, sizeof *scene);
	scene->net = (struct hawser_net){.name = name, .g = 9.81, .node = scene->node,
	                                 .cable = scene->cable, .nodes = cables + 1, .cables = cables,
	                                 .water = {.density = 1025.0, .current = scene->level}};
	memcpy(scene->node[0].x, from, sizeof scene->node[0].x);
	memcpy(scene->node[cables].x, to, sizeof scene->node[0].x);
	memset(scene->node[0].held, 1, 3);
	memset(scene->node[cables].held, 1, 3);
	for (int i = 0; i < cables; i++)
		scene->cable[i] = (struct hawser_net_cable){.from = i, .to = i + 1,
		                                            .line = {.normal = 1.2, .tangential = 0.02}};
}

static void wet_cable(struct wet_scene *scene, int i, double length0, double EA, double rho,
                      double diameter, int elements)
{
	scene->cable[i].value = length0;
	scene->cable[i].EA = EA;
	scene->cable[i].rho = rho;
	scene->cable[i].line.diameter = diameter;
	scene->cable[i].elements = elements;
}

static void wet_flow(struct wet_scene *scene, double y, double ux, double uz)
{
	scene->level[scene->net.water.levels++] = (struct hawser_water_level){y, {ux, 0.0, uz}};
}

/* Forces of the line on a support, within `part` of the largest of the case. */
static void wet_pulls(const struct hawser_net_statics *st, int node, const double expected[3],
                      double within, const char *name)
{
	for (int k = 0; k < 3; k++)
		ok(fabs(-st->reaction[node][k] - expected[k]) <= within, "%s: pull on node %d along %c "
		   "%.9g, %.9g expected", name, node, "xyz"[k], -st->reaction[node][k], expected[k]);
}

static int wet_solved(struct hawser_net_statics *st, struct wet_scene *scene, const char *name)
{
	struct hawser_report report = {0};
	enum hawser_status status = hawser_net_solve(st, &scene->net, NULL, &report);

	return ok(!status, "%s: %s", name, status ? report.message : "solved");
}

/* 300 m in a uniform current; the error of the mesh is of second order. */
static void wet_uniform_current(void)
{
	static const double A[3] = {10654.75, 5079.19, 3794.18}, B[3] = {-2652.88, -11045.70, 5838.36};
	static const double middle[3] = {122.629, -120.451, 29.702};
	double off[2] = {0.0};
	struct wet_scene scene;

	for (int i = 0; i < 3; i++) {
		struct hawser_net_statics st = {0};

		wet_line_of(&scene, 1, (const double[3]){200.0, 0.0, 0.0}, (const double[3]){0.0, -200.0, 0.0});
		wet_cable(&scene, 0, 300.0, 20e6, 12.0, 0.12, i == 2 ? 400 : 25 << i);
		wet_flow(&scene, 0.0, 0.8, 0.6);
		if (!wet_solved(&st, &scene, "uniform current"))
			return;
		if (i == 1) {
			wet_pulls(&st, 0, A, 2e-4*11045.70, "W2, 50 elements");
			wet_pulls(&st, 1, B, 2e-4*11045.70, "W2, 50 elements");
			for (int k = 0; k < 3; k++)
				ok(fabs(st.point[25].x[k] - middle[k]) <= 2e-4*122.629, "place of the middle "
				   "along %c: %.9g", "xyz"[k], st.point[25].x[k]);
			ok(isinf(st.gap), "no bound of the energy in a current");
		}
		if (i == 2) {
			wet_pulls(&st, 0, A, 1e-5*11045.70, "W2, 400 elements");
			wet_pulls(&st, 1, B, 1e-5*11045.70, "W2, 400 elements");
		}
		off[i & 1] = i < 2 ? -st.reaction[0][0] - A[0] : off[0];
		hawser_net_statics_clear(&st);
	}
	close_to(off[0]/off[1], 4.0, 0.03, "errors of 25 and 50 elements");
}

/* A current that changes over the depth. */
static void wet_over_depth(void)
{
	static const double A[3] = {2194.16, 1027.90, 488.49}, B[3] = {2332.21, -1551.78, 1846.37};
	struct hawser_net_statics st = {0};
	struct wet_scene scene;

	wet_line_of(&scene, 1, (const double[3]){150.0, 0.0, 0.0}, (const double[3]){0.0, -200.0, 0.0});
	wet_cable(&scene, 0, 300.0, 20e6, 12.0, 0.12, 250);
	wet_flow(&scene, -250.0, 0.1, 0.0);
	wet_flow(&scene, -100.0, 0.4, 0.2);
	wet_flow(&scene, -20.0, 1.0, 0.5);
	wet_flow(&scene, 0.0, 1.2, 0.9);
	if (wet_solved(&st, &scene, "current over the depth")) {
		wet_pulls(&st, 0, A, 2e-4*2332.21, "W3, over the depth");
		wet_pulls(&st, 1, B, 2e-4*2332.21, "W3, over the depth");
	}
	hawser_net_statics_clear(&st);
}

/* Chain, line with floats, chain, in still water and in a current. */
static void wet_several(void)
{
	static const double A[3] = {21932.4, 11318.8, 14143.7};
	struct wet_scene scene;

	for (int i = 0; i < 2; i++) {
		struct hawser_net_statics st = {0};

		wet_line_of(&scene, 3, (const double[3]){170.0, 110.0, 0.0}, (const double[3]){0.0});
		wet_cable(&scene, 0, 80.0, 300e6, 90.0, 0.2, 60);
		wet_cable(&scene, 1, 70.0, 300e6, 160.0, 0.6, 60);
		wet_cable(&scene, 2, 130.0, 300e6, 90.0, 0.2, 60);
		scene.net.water.surface = 200.0;
		if (i)
			wet_flow(&scene, 0.0, 0.4, 0.7);
		if (wet_solved(&st, &scene, "three parts") && i)
			wet_pulls(&st, 0, A, 2e-4*21932.4, "W4, three parts in a current");
		else if (!i)
			wet_pulls(&st, 0, (const double[3]){16689.59, 13113.04, 0.0}, 2e-4*16689.59,
			      "W4, three parts in still water");
		ok(i == isinf(st.gap), "a bound of the energy in still water");
		hawser_net_statics_clear(&st);
	}
}

/* Upright, 20 m of 100 dry: the closed form. */
static void wet_dry(void)
{
	struct hawser_net_statics st = {0};
	struct wet_scene scene;
	double wet = 1025.0*M_PI*0.25*0.12*0.12*9.81*80.0;

	wet_line_of(&scene, 1, (const double[3]){0.0, -80.0, 0.0}, (const double[3]){0.0, 20.0, 0.0});
	wet_cable(&scene, 0, 100.0, 2e10, 12.0, 0.12, 7);
	memset(scene.node[1].held, 0, 3);
	if (wet_solved(&st, &scene, "partly dry")) {
		close_to(st.reaction[0][1], 12.0*9.81*100.0 - wet, 1e-6*2674.224, "weight in water");
		close_to(st.reaction[0][1], 2674.224, 1e-3, "W24: weight in water, of the table");
	}
	hawser_net_statics_clear(&st);
}

/* A line that is towed at 2 m/s, as seen from the towing point; its other end is free. */
static void wet_towed(void)
{
	struct wet_scene scene;
	struct hawser_net_statics st = {0};

	wet_line_of(&scene, 1, (const double[3]){90.0, -50.0, 0.0}, (const double[3]){0.0, -20.0, 0.0});
	wet_cable(&scene, 0, 100.0, 1e7, 0.8, 0.02, 20);
	scene.cable[0].line.tangential = 0.015;
	memset(scene.node[1].held, 0, 3);
	wet_flow(&scene, 0.0, 2.0, 0.0);
	if (wet_solved(&st, &scene, "towed")) {
		double x = st.x[1][0], y = st.x[1][1] + 20.0;

		close_to(hypot(st.reaction[0][0], st.reaction[0][1]), 317.0023, 1e-6, "W5: its tension");
		close_to(atan2(-y, x)*180.0/acos(-1.0), 17.54475, 1e-6, "W5: its angle, degrees");
	}
	hawser_net_statics_clear(&st);
}

/* The stiffness at an end in a current, which no energy has, against differences. */
static void stiff(void)
{
	struct hawser_report report = {0};
	struct hawser_net_stiffness K;
	struct wet_scene scene;
	const double h = 0.01;
	const int node = 1;
	double off = 0.0, most = 0.0;

	wet_line_of(&scene, 1, (const double[3]){200.0, -3.0, 0.0}, (const double[3]){0.0, -200.0, 0.0});
	wet_cable(&scene, 0, 300.0, 20e6, 12.0, 0.12, 25);
	wet_flow(&scene, -150.0, 0.3, 0.1);
	wet_flow(&scene, 0.0, 0.8, 0.6);
	if (!ok(!hawser_net_stiffness_of(&K, &scene.net, &node, 1, NULL, &report), "stiffness%s",
	        report.message))
		return;
	for (int k = 0; k < 3; k++) {
		struct hawser_net_statics st[2] = {{0}, {0}};

		for (int side = 0; side < 2; side++) {
			scene.node[1].x[k] += side ? -2.0*h : h;
			if (!wet_solved(&st[side], &scene, "beside"))
				return;
		}
		scene.node[1].x[k] += h;
		for (int i = 0; i < 3; i++) {
			double slope = (st[0].reaction[1][i] - st[1].reaction[1][i])/(2.0*h);

			off = fmax(off, fabs(K.K[i][k] - slope));
			most = fmax(most, fabs(slope));
		}
		hawser_net_statics_clear(&st[0]);
		hawser_net_statics_clear(&st[1]);
	}
	ok(off < 1e-6*most && K.asymmetry > 0.05, "stiffness in a current: off by %.1e of %g N/m, "
	   "unsymmetric by %.2f", off/most, most, K.asymmetry);
}

/* Lines that float: what of them is wet carries their weight. */
static void wet_floats(void)
{
	struct hawser_net_statics st = {0};
	struct wet_scene scene;
	double most = -INFINITY, sum = 0.0;

	wet_line_of(&scene, 1, (const double[3]){100.0, -20.0, 10.0}, (const double[3]){0.0, -20.0, 0.0});
	wet_cable(&scene, 0, 200.0, 20e6, 6.0, 0.12, 40);
	wet_flow(&scene, 0.0, 0.8, 0.6);
	if (!wet_solved(&st, &scene, "a line that floats"))
		return;
	for (int i = 0; i < st.points; i++) {
		most = fmax(most, st.point[i].x[1]);
		sum += st.point[i].x[1] > -0.001;
	}
	ok(most < 0.001 && sum > 5.0, "%g nodes at the surface, the highest at %g m", sum, most);
	hawser_net_statics_clear(&st);
}

CASE(reference_net_water)
{
	wet_uniform_current();
	wet_over_depth();
	wet_several();
	wet_dry();
	wet_towed();
	stiff();
	wet_floats();
	return done_testing();
}
