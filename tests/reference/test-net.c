/* Statics of nets against B's Table 3.1, whose figures were computed by two independent programs: the
 * method of this program written in Python, and a cone program (cvxopt).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/nets/comparison.h"
#include "tests/tap.h"

static const struct {
	const char *name;
	double x[3];
} place[] = {
	{"J0", {3.141129, -2.618005, 0.084697}},
	{"K0", {7.007084, -2.623712, 1.588167}},
	{"K4", {6.861568, -2.947491, -2.490236}},
};

static void nodes(const struct hawser_net *net, const struct hawser_net_statics *st)
{
	for (int i = 0; i < net->nodes; i++)
		for (size_t j = 0; j < sizeof place/sizeof *place; j++) {
			double most = 0.0;

			if (strcmp(net->node[i].name, place[j].name) != 0)
				continue;
			for (int k = 0; k < 3; k++)
				most = fmax(most, fabs(st->x[i][k] - place[j].x[k]));
			ok(most <= 1e-6, "%s: node %s is %.1e m from its place", st->method, place[j].name, most);
		}
}

static void whole(const struct hawser_net *net, const struct hawser_net_statics *st)
{
	double T_min = INFINITY, T_max = 0.0, lowest = 0.0, up = 0.0;
	int slack = 0;

	for (int i = 0; i < st->cables; i++) {
		T_min = fmin(T_min, st->member[i].T_min);
		T_max = fmax(T_max, st->member[i].T_max);
		slack += st->member[i].slack;
	}
	for (int i = 0; i < st->points; i++)
		lowest = fmin(lowest, st->point[i].x[1]);
	for (int i = 0; i < net->nodes; i++)
		up += st->reaction[i][1];
	close_to(st->energy, -1753.03356462, 1e-11, "energy, J");
	ok(fabs(T_min - 42.70779) <= 1e-4 && fabs(T_max - 344.23270) <= 1e-4 &&
	   fabs(T_max/344.23399 - 1.0) <= 1e-5, /* that of exact catenaries */
	   "tensions from %.5f to %.5f N", T_min, T_max);
	ok(fabs(lowest + 3.026318) <= 1e-6 && slack == 0, "lowest point %.6f m, %d slack elements", lowest,
	   slack);
	close_to(up, 894.326688, 1e-8, "sum of the upward forces of the supports: the weight, N");
	ok(st->gap >= 0.0 && st->gap <= 1e-12, "gap %.1e J", st->gap);
	ok(st->unknowns == 4683 && st->residual <= st->floor, "%d unknowns, residual %.1e N, floor %.1e N",
	   st->unknowns, st->residual, st->floor);
}

static void solved(const struct hawser_net *net, const struct hawser__net_method *method)
{
	const char *name = method->shown.name;
	struct hawser_net_options options = {.iterations = 200};
	struct hawser_report report = {0};
	struct net_certificate certificate = {.right = 0};
	struct hawser_net_statics st;
	enum hawser_status status;

	/* with a noise of 1e-4 descent takes more iterations */
	net_start_at(strstr("two-sided, regularised, descent", name) != NULL, 0.01, 0);
	status = hawser__net_solve_by(&st, net, method, &options, &report);
	if (!strcmp(name, "two-sided") || !strcmp(name, "regularised")) {
		if (!status)
			status = net_certify(&certificate, net, &st, &report);
		ok(!certificate.right && (status == HAWSER_ERR_CONVERGENCE || certificate.compressed > 0),
		   "%s has no equilibrium of cables: %s", name, report.message);
	} else if (ok(!status, "%s: %s", name, report.message)) {
		ok(st.iterations <= (strcmp(name, "descent") ? 15 : 200), "%d iterations", st.iterations);
		if (!method->solve) { /* the limit of a fine mesh */
			ok(st.energy < -1753.03356462 && st.energy > -1753.06 && st.unknowns == 36,
			   "energy %.9f J below that of the mesh, %d unknowns", st.energy, st.unknowns);
		} else {
			nodes(net, &st);
			whole(net, &st);
		}
	}
	hawser_net_statics_clear(&st);
}

CASE(reference_net)
{
	struct hawser_report report = {0};
	struct hawser_net net;
	const char *path = source_file("notebooks-data/scenes/net-table-3-1.yaml");

	if (!ok(!hawser_net_open(&net, path, NULL, 0, &report), "the scene is read"))
		return done_testing();
	for (int i = 0; hawser__net_method(i); i++)
		solved(&net, hawser__net_method(i));
	for (int i = 0; net_older(i); i++)
		if (strcmp(net_older(i)->shown.name, "relaxation") != 0) /* 190 000 steps */
			solved(&net, net_older(i));
	hawser_net_clear(&net);
	return done_testing();
}
