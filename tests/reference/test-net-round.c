/* Ropes over round obstacles on fine meshes: a drum above both ends, a sheave (W22), and a bed's convex
 * corner (W25).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net.h>

#include "tests/tap.h"

static int solved(struct hawser_net_statics *st, const char *path, const char *const *set, size_t sets)
{
	struct hawser_net net;
	struct hawser_report report;
	enum hawser_status status = hawser_net_open(&net, path, set, sets, &report);

	if (!status)
		status = hawser_net_solve(st, &net, NULL, &report);
	hawser_net_clear(&net);
	return ok(!status, "%s: %s", path, status ? report.message : "solved");
}

/* Outside use: works with 40 to 160 elements, and failed from 200 on. Of a mesh that is taut the
 * polygon of 1 m + 3 m and half a turn, pi*R*(1 - (h/R)^2/24), has the mean tension; the weight
 * changes tensions by 1.5 N at most. */
static void drum(void)
{
	static const int elements[] = {200, 400, 1000, 2000};
	const double R = 0.25, L = 4.78535, EA = 3e6;
	const char *path = source_file("notebooks-data/scenes/net-capstan.yaml");

	for (int i = 0; i < 4; i++) {
		char cables[200];
		const char *const set[] = {"nodes={A: [-0.25, -1, 0], B: [0.25, -3, 0]}", cables, "g=9.81",
			"obstacles=[{circle: {centre: [0, 0], radius: 0.25}}]", "contact={sliding: none}"};
		double h = L/elements[i], taut = EA*((4.0 + M_PI*R*(1.0 - h*h/(24.0*R*R)))/L - 1.0);
		struct hawser_net_statics st = {0};

		snprintf(cables, sizeof cables, "cables=[{name: c, from: A, to: B, EA: 3 MN, rho: 0.05, "
		         "length0: 4.78535, elements: %d}]", elements[i]);
		if (solved(&st, path, set, 5) && taut > 2.0)
			ok(fabs(0.5*(st.member[0].T_from + st.member[0].T_to) - taut) < 0.75,
			   "%d elements: T %.6g and %.6g N, mean %.6g N", elements[i], st.member[0].T_from,
			   st.member[0].T_to, taut);
		hawser_net_statics_clear(&st);
	}
}

/* W22: a massless rope over a smooth sheave, whose centre is at 20 m and at 20.5 m; closed form. Both
 * supports bear what the sheave does. */
static void sheave(void)
{
	static const double expected[2][2] = {{14434.16, 21805.31}, {27300.14, 41649.11}};
	const char *path = source_file("notebooks-data/scenes/net-capstan.yaml");

	for (int i = 0; i < 2; i++) {
		const char *const set[] = {
			"nodes={A: [-20, 0, 0], B: [20, 0, 0]}", "cables=[{name: c, from: A, to: B, EA: 1 MN, "
			"rho: 0, length0: 59, elements: 2000}]", "contact={sliding: none}",
			i ? "obstacles=[{circle: {centre: [0, 20.5], radius: 2}}]"
			  : "obstacles=[{circle: {centre: [0, 20], radius: 2}}]"};
		struct hawser_net_statics st = {0};

		if (solved(&st, path, set, 4)) {
			close_to(st.member[0].T_to, expected[i][0], 5e-5, "W22: tension, N");
			close_to(-st.reaction[0][1] - st.reaction[1][1], expected[i][1], 5e-5, "W22: force on the "
			         "sheave, N");
		}
		hawser_net_statics_clear(&st);
	}
}

/* A bed of two segments with a circle between them, as the message for sharp ends advises: T_A
 * 650.4, H 634.9, V 485.9 kN by an outside program. */
static void corner(void)
{
	static const char *const fine[] = {"cables.line.elements=800"};
	static const char *const coarse[] = {"cables.line.elements=50"};
	static const char *const sharp[] = {
		"obstacles=[{segment: {from: [-10, 0], to: [149.65079, 0]}}, {segment: {from: [150.3483, "
		"-0.02436], to: [900, -52.445]}}]"};
	struct hawser_net_statics st = {0};
	struct hawser_net net;
	struct hawser_report report;
	const char *path = source_file("tests/reference/net-bed-corner.yaml");

	if (solved(&st, path, fine, 1)) {
		close_to(st.member[0].T_from, 650.4e3, 1e-4, "T_A, N");
		close_to(st.reaction[1][0], 634.9e3, 1e-4, "H, N");
		close_to(st.reaction[1][1], 485.9e3, 2e-4, "V, N");
	}
	hawser_net_statics_clear(&st);
	if (solved(&st, path, NULL, 0))
		close_to(st.member[0].T_from, 650.4e3, 1.5e-3, "T_A of 400 elements, N");
	hawser_net_statics_clear(&st);
	ok(!hawser_net_open(&net, path, coarse, 1, &report) && hawser_net_solve(&st, &net, NULL, &report) &&
	   strstr(report.message, "the radius of k, 10 m: give it more elements than 84"),
	   "with elements longer than the radius: %s", report.message);
	hawser_net_clear(&net);
	hawser_net_statics_clear(&st);
	ok(!hawser_net_open(&net, path, sharp, 1, &report) && hawser_net_solve(&st, &net, NULL, &report),
	   "without the circle: %s", report.message);
	hawser_net_clear(&net);
	hawser_net_statics_clear(&st);
}

CASE(reference_net_round)
{
	drum();
	sheave();
	corner();
	return done_testing();
}
