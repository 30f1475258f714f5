/* Form finding with given tensions. The shape is the least of sum of T*|d| - f.q, a convex problem;
 * what is checked is what its minimum must have: each cable has its tension, or no length and less; the
 * forces of nodes balance by the statics. Nets like a chessboard of 12 free nodes, in which some nodes
 * come to one place; two cables and a load (sag 1.50075 m: outside program, and by hand).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "tests/net-random.h"
#include "tests/tap.h"

enum { ROWS = 3, COLUMNS = 4, NODES = (ROWS + 2)*(COLUMNS + 2), CABLES = 2*NODES };

struct grid {
	struct hawser_net net;
	struct hawser_net_node node[NODES];
	struct hawser_net_cable cable[CABLES];
	struct hawser_net_load load[NODES];
};

static int inner(int i, int j)
{
	return i > 0 && i <= ROWS && j > 0 && j <= COLUMNS;
}

static void connect(struct grid *g, int a, int b, double rho, int elements, uint64_t *state)
{
	struct hawser_net_cable *cable = &g->cable[g->net.cables];

	if (!g->node[a].support || !g->node[b].support)
		*cable = (struct hawser_net_cable){
			.from = a, .to = b, .EA = 1e7, .rho = rho, .elements = elements,
			.given = HAWSER_NET_TENSION, .value = 1e3*pow(3.0, uniform(state))};
	g->net.cables += !g->node[a].support || !g->node[b].support;
}

static void grid(struct grid *g, double rho, int elements, uint64_t *state)
{
	static char name[] = "grid";

	memset(g, 0, sizeof *g);
	g->net = (struct hawser_net){.name = name, .g = 9.81, .node = g->node, .cable = g->cable,
	                             .load = g->load, .nodes = NODES};
	for (int i = 0; i < NODES; i++) {
		int row = i/(COLUMNS + 2), column = i%(COLUMNS + 2);

		g->node[i] = (struct hawser_net_node){.placed = 1, .support = !inner(row, column)};
		for (int k = 0; k < 3; k++)
			g->node[i].x[k] = k == 1 ? 6.0*uniform(state)
				: 5.0*(k ? column : row) + 2.0*uniform(state) - 1.0;
		memset(g->node[i].held, g->node[i].support, sizeof g->node[i].held);
		if (inner(row, column))
			g->load[g->net.loads++] = (struct hawser_net_load){
				.node = i, .cable = -1, .value = {50.0*uniform(state), -500.0*uniform(state), 20.0}};
	}
	for (int i = 0; i < NODES; i++) {
		if (i%(COLUMNS + 2) < COLUMNS + 1)
			connect(g, i, i + 1, rho, elements, state);
		if (i + COLUMNS + 2 < NODES)
			connect(g, i, i + COLUMNS + 2, rho, elements, state);
	}
}

static void grids(int count, double rho, int elements)
{
	struct grid *g = malloc(sizeof *g);
	uint64_t state = 1811;
	int solved = 0, gone = 0, wrong = 0;
	double worst = 0.0, least = 0.0;

	for (int i = 0; i < count; i++) {
		struct hawser_net_statics st = {0};
		struct hawser_report report = {0};

		grid(g, rho, elements, &state);
		if (hawser_net_solve(&st, &g->net, NULL, &report)) {
			ok(0, "net %d: %s", i, report.message);
			continue;
		}
		solved++;
		for (int c = 0; c < st.cables; c++) {
			const struct hawser_net_member *m = &st.member[c];
			double mean = 0.5*(m->T_min + m->T_max), T = g->cable[c].value;

			if (m->length < 1e-4)
				gone++;
			wrong += m->T_max > T*(1.0 + (rho > 0.0 ? 0.05 : 1e-6));
			if (m->length >= 1e-4)
				worst = fmax(worst, fabs(mean/T - 1.0));
		}
		least = fmax(least, st.residual);
		hawser_net_statics_clear(&st);
	}
	free(g);
	ok(solved == count && wrong == 0 && worst < (rho > 0.0 ? 0.02 : 2e-6), "%d of %d nets, rho %g: "
	   "tensions to %.1e, %d cables without length", solved, count, rho, worst, gone);
	ok(least < 1e-4, "forces balance to %.1e N", least);
	ok(rho > 0.0 || gone > 0, "some nodes come to one place");
}

/* Two cables of 2.6 kN over 21 m, with 735.75 N at their joint: 2 T sin(a) = F, sag = 10.5 tan(a). */
static void two(int elements)
{
	static char name[] = "two";
	struct hawser_net_node node[3] = {
		{.placed = 1, .held = {1, 1, 1}, .support = 1},
		{.placed = 1, .x = {21.0, 0.0, 0.0}, .held = {1, 1, 1}, .support = 1}, {.name = "J"}};
	struct hawser_net_cable cable[2] = {
		{.from = 0, .to = 2, .EA = 1e6, .given = HAWSER_NET_TENSION, .value = 2.6e3,
		 .elements = elements},
		{.from = 2, .to = 1, .EA = 1e6, .given = HAWSER_NET_TENSION, .value = 2.6e3,
		 .elements = elements}};
	struct hawser_net_load load = {.node = 2, .cable = -1, .value = {0.0, -735.75, 0.0}};
	struct hawser_net net = {.name = name, .g = 9.81, .node = node, .cable = cable, .nodes = 3,
	                         .cables = 2, .load = &load, .loads = 1};
	struct hawser_net_statics st = {0};
	struct hawser_report report = {0};

	if (ok(!hawser_net_solve(&st, &net, NULL, &report), "two cables %s", report.message)) {
		close_to(-st.x[2][1], 10.5*tan(asin(735.75/5200.0)), 1e-9, "sag, m");
		close_to(-st.x[2][1], 1.50075, 2e-5, "sag by an outside program, m");
		close_to(st.member[0].T_from, 2.6e3, 1e-9, "tension, N");
	}
	hawser_net_statics_clear(&st);
}

CASE(property_net_form)
{
	int many = getenv("HAWSER_LONG") ? 200 : 20;

	two(1);
	two(20);
	grids(many, 0.0, 1);
	grids(many/4, 0.0, 6);
	grids(many/4, 1.3, 6);
	return done_testing();
}
