/* Steps of meshes: momentum in free flight, orders of the schemes, the tangent, in water as well,
 * against differences of the residual, elimination along a chain against KLU.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/net_motion.h>

#include "net/motion/motion.h"
#include "tests/tap.h"

enum { N = 12 };
static struct hawser_report report;
static unsigned long long seed = 2385;

static double any(void)
{
	seed = seed*6364136223846793005ULL + 1442695040888963407ULL;
	return (double)(seed >> 11)/4503599627370496.0 - 1.0;
}

/* A cable of 2 m over 1.7 m in equilibrium, partly in water that flows if `wet` is 1; both ends let
 * go if free is 1. */
static int open(struct hawser__motion *motion, struct hawser__mesh *mesh, const char *scheme, int free,
                double g, int wet)
{
	static const unsigned char none[3];
	static char name[] = "cable";
	static struct hawser_water_level current = {.u = {0.7, 0.0, 0.3}};
	static struct hawser_net net;
	static struct hawser_net_cable cable;
	unsigned char loose[N + 1] = {1, 1};
	struct hawser_net_node node[2] = {
		{.name = "A", .placed = 1, .held = {1, 1, 1}, .support = 1},
		{.name = "B", .placed = 1, .x = {1.7, 0.2, 0.3}, .held = {1, 1, 1}, .support = 1}};
	struct hawser__equilibrium found;
	enum hawser_status status;

	cable = (struct hawser_net_cable){.name = "c", .from = 0, .to = 1, .EA = 238.5, .rho = 0.37,
	                                  .line = {0.02, 1.2, 0.1, 1.0, 0.3}, .value = 2.0, .elements = N};
	net = (struct hawser_net){.name = name, .g = 9.81, .node = node, .cable = &cable, .nodes = 2,
	                          .cables = 1};
	if (wet)
		net.water = (struct hawser_water){.density = 1000.0, .surface = -0.15, .current = &current,
		                                  .levels = 1};
	status = hawser__mesh_build(mesh, &net, &report);
	if (!status)
		status = hawser__mesh_statics(mesh, NULL, &found, NULL, &report);
	for (int i = 0; i < 2 && free; i++)
		hawser__mesh_hold(mesh, i, none);
	for (int i = 0; i < mesh->nodes; i++)
		mesh->force[i][1] *= g/9.81;
	if (!status)
		status = hawser__motion_open(motion, mesh, scheme, -1.0, !free, loose, &report);
	return ok(!status, "%s: begin %s", scheme, report.message);
}

static void close(struct hawser__motion *motion, struct hawser__mesh *mesh)
{
	hawser__motion_clear(motion);
	hawser__mesh_clear(mesh);
}

/* Angular momentum about the origin, and momentum: sum[6]. */
static void momentum(double sum[6], const struct hawser__motion *motion)
{
	memset(sum, 0, 6*sizeof *sum);
	for (int e = 0; e < motion->elements; e++) {
		const struct hawser__motion_element *el = &motion->element[e];
		int end[2] = {el->a, el->b};

		for (int i = 0; i < 4; i++) {
			int p = end[i/2], q = end[i%2];
			double part = el->m*(p == q ? 0.5 - motion->far : motion->far), x[3];

			for (int k = 0; k < 3; k++)
				x[k] = motion->reference[p][k] + motion->u[p][k];
			for (int k = 0; k < 3; k++) {
				int a = (k + 1)%3, b = (k + 2)%3;

				sum[k] += part*(x[a]*motion->v[q][b] - x[b]*motion->v[q][a]);
				sum[3 + k] += part*motion->v[q][k];
			}
		}
	}
}

static void flight(void)
{
	struct hawser__mesh mesh;
	struct hawser__motion motion;
	double before[6], after[6], off = 0.0, size = 0.0;
	enum hawser_status status = HAWSER_OK;

	if (!open(&motion, &mesh, "energy", 1, 0.0, 0))
		return;
	for (int i = 0; i < motion.nodes; i++)
		for (int k = 0; k < 3; k++)
			motion.v[i][k] = 3.0*any();
	ok(!hawser__motion_begin(&motion, &report), "random velocities");
	momentum(before, &motion);
	for (int i = 0; i < 8000 && !status; i++)
		status = hawser__motion_step(&motion, 1e-3, &report);
	ok(!status, "8000 steps %s", report.message);
	momentum(after, &motion);
	for (int k = 0; k < 6; k++) {
		off = fmax(off, fabs(after[k] - before[k]));
		size = fmax(size, fabs(before[k]));
	}
	ok(off <= 1e-10*size, "momenta in free flight to %.1e, %ld changes of slack and taut", off/size,
	   motion.switches);
	ok(motion.switches > 1000 && motion.closure <= 1e-10*motion.most_energy, "energy to %.1e",
	   motion.closure/motion.most_energy);
	close(&motion, &mesh);
}

/* Place of the middle at 0.1 s, with waves that start smoothly. */
static double middle(const char *scheme, double h)
{
	struct hawser__mesh mesh;
	struct hawser__motion motion;
	double y;

	if (!open(&motion, &mesh, scheme, 0, 9.81, 0))
		return NAN;
	for (int i = 2; i < motion.nodes; i++)
		motion.v[i][2] = 0.4*sin(M_PI*(i - 1)/N);
	if (hawser__motion_begin(&motion, &report))
		return NAN;
	for (int i = 0; i < (int)lround(0.1/h); i++)
		if (hawser__motion_step(&motion, h, &report))
			return NAN;
	y = motion.u[7][2];
	close(&motion, &mesh);
	return y;
}

static void orders(void)
{
	for (int i = 0; hawser_net_scheme(i); i++) {
		const struct hawser_net_scheme *scheme = hawser_net_scheme(i);
		double a, b, c, order;

		if (scheme->order == 0)
			continue; /* steps of its own: test-net-cvode */
		a = middle(scheme->name, 1e-3);
		b = middle(scheme->name, 0.5e-3);
		c = middle(scheme->name, 0.25e-3);
		order = log2(fabs((a - b)/(b - c)));
		ok(fabs(order - scheme->order) <= 0.1, "%s: order %.3f", scheme->name, order);
	}
}

/* Tangent of a step in the middle of a motion: differences of the residual along a random
 * direction, and both solvers. */
static void tangents(void)
{
	int wet = 1;

	for (int s = 0; hawser__motion_scheme(s) && hawser__motion_scheme(s)->rule; s += !wet, wet = 0) {
		struct hawser__blocks_matrix matrix;
		struct hawser__motion_rule rule = {0};
		struct hawser__mesh mesh;
		struct hawser__motion motion;
		struct hawser__klu *klu;
		double (*dx)[3], (*low)[3], (*other)[3], off = 0.0, apart = 0.0, size = 0.0;
		int good = 0, both = 0;
		const double h = 2e-3, eps = 1e-7;

		if (!open(&motion, &mesh, hawser__motion_scheme(s)->shown.name, 0, 9.81, wet))
			return;
		dx = calloc(3*(size_t)motion.nodes, sizeof *dx);
		low = dx + motion.nodes;
		other = low + motion.nodes;
		motion.scheme->rule(&rule, h, -1.0);
		for (int i = 2; i < motion.nodes; i++)
			for (int k = 0; k < 3; k++) {
				motion.element[i - 2].c = 0.02;
				motion.element[i - 2].drag = 0.3;
				motion.u0[i][k] = motion.u[i][k] = 0.01*any();
				motion.v0[i][k] = any();
				motion.x[i][k] = 0.01*any();
				dx[i][k] = any();
			}
		hawser__motion_prepare(&motion, &rule, h);
		for (int side = -1; side <= 1; side += 2) {
			for (int i = 2; i < motion.nodes; i++)
				for (int k = 0; k < 3; k++)
					motion.x[i][k] += side*eps*dx[i][k]*(side > 0 ? 2.0 : 1.0);
			hawser__motion_residual(&motion, &rule, h, 0);
			for (int i = 2; i < motion.nodes; i++)
				for (int k = 0; k < 3; k++)
					low[i][k] += side*motion.r[i][k]/(2.0*eps);
		}
		for (int i = 2; i < motion.nodes; i++)
			for (int k = 0; k < 3; k++)
				motion.x[i][k] -= eps*dx[i][k];
		hawser__motion_residual(&motion, &rule, h, 1);
		memcpy(other, low, (size_t)motion.nodes*sizeof *low);
		matrix = (struct hawser__blocks_matrix){
			(const double (*)[9])motion.B, (const double (*)[9])motion.other,
			(const double (*)[2])motion.mass, motion.point, (const double (*)[9])motion.block};
		ok(!hawser__blocks_solve(low, &good, motion.blocks, &matrix, &report) && good &&
		   hawser__blocks_chain(motion.blocks), "%s: solved along the chain%s",
		   motion.scheme->shown.name, wet ? ", in water" : "");
		ok(!hawser__klu_open(&klu, &mesh, &report) &&
		   !hawser__klu_solve(other, &both, klu, &matrix, &report) && both, "by KLU");
		for (int i = 2; i < motion.nodes; i++)
			for (int k = 0; k < 3; k++) {
				off = fmax(off, fabs(low[i][k] - dx[i][k]));
				apart = fmax(apart, fabs(low[i][k] - other[i][k]));
				size = fmax(size, fabs(dx[i][k]));
			}
		ok(off <= 1e-6*size, "the tangent is that of differences: %.1e", off/size);
		ok(apart <= 1e-11*size, "both solvers agree: %.1e", apart/size);
		hawser__klu_clear(klu);
		free(dx);
		close(&motion, &mesh);
	}
}

CASE(property_net_steps)
{
	flight();
	orders();
	tangents();
	return done_testing();
}
