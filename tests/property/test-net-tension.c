/* Tensions at the nodes of a mesh: against exact catenaries, by their order, at joints, in motions; and
 * the error of the mesh that is stated, from which the default number of elements is chosen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/net_motion.h>

#include "tests/net-random.h"
#include "tests/tap.h"

static struct hawser_report report;

static int open_net(struct hawser_net *net, const char *folder, const char *name,
                    const char *const *set, size_t sets)
{
	const char *path = source_file("%s/%s.yaml", folder, name);

	return ok(!hawser_net_open(net, path, set, sets, &report), "%s %s", name, report.message);
}

/* net-bight.yaml: 14385.962 and 4576.892 N (outside program), which exact catenaries have too; the
 * least tension, in the bight between two nodes, is their horizontal part (outside program). */
static void bight(void)
{
	const double T_to = 14385.962, T_from = 4576.892, T_min = 4153.466;
	double off[2][3];

	for (int i = 0; i < 2; i++) {
		const char *const set[] = {i ? "cables.c.elements=80" : "cables.c.elements=20"};
		struct hawser_net net;
		struct hawser_net_statics st = {0};
		struct hawser_net_mesh_error error;

		if (!open_net(&net, "tests/reference", "net-bight", set, 1) ||
		    !ok(!hawser_net_solve(&st, &net, NULL, &report) &&
		        !hawser_net_mesh_error(&error, &net, &st, &report), "%s", report.message))
			return;
		off[i][0] = fabs(st.member[0].T_from/T_from - 1.0);
		off[i][1] = fabs(st.member[0].T_to/T_to - 1.0);
		off[i][2] = fabs(st.member[0].T_min/T_min - 1.0);
		close_to(st.member[0].T_max, st.member[0].T_to, 0.0, "the largest tension is at the upper end");
		ok(fmax(fmax(off[i][0]*T_from, off[i][2]*T_min), off[i][1]*T_to)/T_to <=
		   1.001*error.tension + 1e-7,
		   "stated error %.2e, true ones %.2e, %.2e", error.tension, off[i][0], off[i][1]);
		hawser_net_statics_clear(&st);
		hawser_net_clear(&net);
	}
	ok(off[0][0] < 1e-3 && off[0][1] < 1e-3, "20 elements: %.1e and %.1e", off[0][0], off[0][1]);
	for (int end = 0; end < 3; end++) /* and between */
		ok(fabs(log2(off[0][end]/off[1][end])/2.0 - 2.0) < 0.05, "order 2 at end %d: %.3f", end,
		   log2(off[0][end]/off[1][end])/2.0);
}

/* Random nets: the statement holds against exact catenaries, and the default number of elements leaves
 * an error of 1e-3 at most, but in a few nets with folds. */
static void nets(int count)
{
	struct random_net *r = malloc(sizeof *r);
	uint64_t state = 4711;
	int beyond = 0, known = 0, refined = 0, large = 0;

	for (int i = 0; i < count; i++) {
		struct hawser_net_statics st = {0}, exact = {0};
		struct hawser_net_options options = {.method = "catenary"};
		struct hawser_net_mesh_error error;
		double most = 0.0, all = 0.0;

		random_net(r, &state, HEAVY);
		for (int c = 0; c < r->net.cables; c++) {
			r->cable[c].elements = 8;
			r->cable[c].elements_given = 0;
		}
		if (hawser_net_refine(&r->net, &report) || hawser_net_solve(&st, &r->net, NULL, &report) ||
		    hawser_net_mesh_error(&error, &r->net, &st, &report) ||
		    hawser_net_solve(&exact, &r->net, &options, &report)) {
			hawser_net_statics_clear(&st);
			continue;
		}
		for (int c = 0; c < st.cables; c++)
			all = fmax(all, st.member[c].T_max);
		for (int c = 0; c < st.cables; c++) {
			const struct hawser_net_member *a = &st.member[c], *b = &exact.member[c];
			double off = fmax(fabs(a->T_from - b->T_from), fabs(a->T_to - b->T_to));

			most = fmax(most, off/fmax(a->T_max, 0.01*all));
			refined += r->cable[c].elements > 8;
		}
		known++;
		beyond += !(most <= error.tension*(1.0 + 1e-9) + 1e-9);
		large += error.tension > 1e-3;
		hawser_net_statics_clear(&st);
		hawser_net_statics_clear(&exact);
	}
	free(r);
	ok(known > count/2 && beyond == 0, "%d random nets: errors of tensions beyond the stated one: %d",
	   known, beyond);
	ok(refined > count && large <= known/20, "%d cables got more elements; error above 1e-3 in %d nets",
	   refined, large);
}

/* A cable in two parts has the tensions of a whole one, and no jump at the joint. */
static void joint(void)
{
	struct hawser_net_node node[3] = {
		{.name = "A", .placed = 1, .held = {1, 1, 1}, .support = 1},
		{.name = "B", .placed = 1, .x = {97.0, 31.0, 5.0}, .held = {1, 1, 1}, .support = 1},
		{.name = "J", .x = {10.0, 0.0, 0.0}}};
	struct hawser_net_cable cable[2] = {
		{.name = "c", .from = 0, .to = 2, .EA = 3e6, .rho = 7.0, .value = 50.0, .elements = 5},
		{.name = "d", .from = 1, .to = 2, .EA = 3e6, .rho = 7.0, .value = 90.0, .elements = 9}};
	char name[] = "joint";
	struct hawser_net net = {.name = name, .g = 9.81, .node = node, .cable = cable, .nodes = 3,
	                         .cables = 2};
	struct hawser_net_statics st = {0};

	if (ok(!hawser_net_solve(&st, &net, NULL, &report), "a joint %s", report.message))
		close_to(st.member[0].T_to, st.member[1].T_to, 1e-9, "tensions on both sides of a joint, N");
	hawser_net_statics_clear(&st);
}

/* The line on a sea bed of test-net-contact: H = 96643.4535 N; the judges are coarser meshes. */
static void bed(void)
{
	for (int n = 25; n <= 200; n *= 2) {
		char elements[40];
		const char *const set[] = {elements, "contact={sliding: none}"};
		struct hawser_net net;
		struct hawser_net_statics st = {0};
		struct hawser_net_mesh_error error = {0};

		snprintf(elements, sizeof elements, "cables.line.elements=%d", n);
		if (open_net(&net, "notebooks-data/scenes", "net-seabed", set, 2) &&
		    ok(!hawser_net_solve(&st, &net, NULL, &report) &&
		       !hawser_net_mesh_error(&error, &net, &st, &report), "%s", report.message))
			ok(fabs(st.member[0].T_from - 96643.4535) <= error.tension*st.member[0].T_max,
			   "%d elements: off %.1e, stated %.1e", n, st.member[0].T_from/96643.4535 - 1.0,
			   error.tension);
		hawser_net_statics_clear(&st);
		hawser_net_clear(&net);
	}
}

/* The tension at a support that moves: order 2, against a mesh of 160 elements. */
static void moved(void)
{
	double T[3] = {0.0};

	for (int i = 0; i < 3; i++) {
		struct hawser_net_node node[2] = {
			{.name = "A", .placed = 1, .held = {1, 1, 1}, .support = 1},
			{.name = "B", .placed = 1, .x = {30.0, 11.0, 0.0}, .held = {1, 1, 1}, .support = 1}};
		struct hawser_net_cable cable = {.name = "c", .from = 0, .to = 1, .EA = 2e5, .rho = 3.1,
		                                 .value = 34.0, .elements = i == 2 ? 160 : 10 << i};
		struct hawser_net_load motion = {.node = 1, .cable = -1, .value = {0.0, 0.7, 0.0},
		                                 .harmonic = 1, .Omega = 2.3};
		char name[] = "moved";
		struct hawser_net net = {.name = name, .g = 9.81, .node = node, .cable = &cable, .nodes = 2,
		                         .cables = 1, .motion = &motion, .motions = 1, .axial = 0.02,
		                         .alpha = 0.3};
		const struct hawser_net_probe at = {.node = 1, .cable = -1};
		const struct hawser_net_motion_options options = {.until = 1.3, .every = 1.3, .step = 1e-3,
		                                                  .probe = &at, .probes = 1};
		struct hawser_net_motion run;

		if (!ok(!hawser_net_integrate(&run, &net, &options, &report), "%s", report.message))
			return;
		T[i] = run.T[run.rows - 1];
		hawser_net_motion_clear(&run);
	}
	ok(fabs((T[0] - T[2])/(T[1] - T[2])) > 3.5 && fabs(T[1]/T[2] - 1.0) < 2e-3,
	   "%.6g, %.6g and %.6g N with 10, 20, 160 elements", T[0], T[1], T[2]);
}

/* net-damped.yaml: a mass on a spring of EA/length0, with the damper of 0.3 s, under a moved support:
 * amplitude 24586 N (outside program); of the closed form |k (1 + 0.3i Omega) x|, x the relative
 * displacement of a linear oscillator, 24585.8. */
static void damped(void)
{
	const struct hawser_net_probe at = {.node = 1, .cable = -1};
	static const char *const schemes[] = {"energy", "alpha", "cvode"};
	struct hawser_net net;

	if (!open_net(&net, "tests/reference", "net-damped", NULL, 0))
		return;
	for (int i = 0; i < 3; i++) {
		const struct hawser_net_motion_options options = {
			.until = 40.0, .every = 0.01, .probe = &at, .probes = 1, .scheme = schemes[i],
			.step = 2e-3};
		struct hawser_net_motion run;
		double least = INFINITY, most = 0.0;

		if (!ok(!hawser_net_integrate(&run, &net, &options, &report), "%s %s", schemes[i],
		        report.message))
			continue;
		for (int row = 3600; row < run.rows; row++) {
			least = fmin(least, run.T[row]);
			most = fmax(most, run.T[row]);
		}
		close_to(0.5*(most - least), 24586.0, 2e-4, "amplitude of the tension, N");
		hawser_net_motion_clear(&run);
	}
	hawser_net_clear(&net);
}

CASE(property_net_tension)
{
	bight();
	nets(getenv("HAWSER_LONG") ? 500 : 30);
	joint();
	bed();
	moved();
	damped();
	return done_testing();
}
