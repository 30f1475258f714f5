/* The equilibria of a few bars (B 2.2.5), against the closed form of two bars and against the force
 * polygon of a chain: there the only unknowns are the components H and V of the first force, once it is
 * chosen which bars are compressed. It shares no code with the search.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/net_equilibria.h>

#include "tests/tap.h"

enum { MOST = 8, GRID = 61, NEWTON = 60, FOUND = 64 };

/* Bars of total length 1.2 m, EA = 1 N, between supports at 0 and 1 m; each joint carries its part of
 * 1.2*G newton. */
static enum hawser_status chain(struct hawser_net_equilibria *found, int bars, double G, int starts,
                                struct hawser_report *report)
{
	struct hawser_net_node node[MOST + 1] = {{.name = "A"}};
	struct hawser_net_cable cable[MOST] = {{.name = "a"}};
	struct hawser_net_load load[MOST] = {{.node = 0}};
	struct hawser_net net = {.name = node[0].name, .g = 9.81, .node = node, .cable = cable,
	                         .load = load, .nodes = bars + 1, .cables = bars, .loads = bars - 1};

	for (int i = 0; i <= bars; i++) {
		snprintf(node[i].name, sizeof node[i].name, "n%d", i);
		node[i].support = node[i].placed = i == 0 || i == bars;
		memset(node[i].held, node[i].support, sizeof node[i].held);
		node[i].x[0] = i == bars;
	}
	for (int i = 0; i < bars; i++)
		cable[i] = (struct hawser_net_cable){.from = i, .to = i + 1, .EA = 1.0, .value = 1.2/bars,
		                                     .elements = 1};
	for (int i = 1; i < bars; i++)
		load[i - 1] = (struct hawser_net_load){.node = i, .cable = -1,
		                                       .value = {0.0, -1.2*G/(bars - 1), 0.0}};
	return hawser_net_equilibria_find(
		found, &net, &(struct hawser_net_equilibria_options){.starts = starts}, report);
}

struct polygon {
	int bars, compressed; /* a bit for each bar */
	double load;          /* N, of each joint */
};

/* f = the sum of the bars minus (1, 0) m at the force x = (H, V) of the first bar; J its derivative.
 * Returns 0 if a bar would have a negative length. */
static int closure(double f[2], double J[3], const struct polygon *p, const double x[2])
{
	double length0 = 1.2/p->bars;
	int possible = 1;

	f[0] = -1.0;
	f[1] = J[0] = J[1] = J[2] = 0.0;
	for (int i = 0; i < p->bars; i++) {
		double V = x[1] + p->load*i, t = hypot(x[0], V), sign = p->compressed >> i & 1 ? -1.0 : 1.0;
		double c = length0*(sign/t + 1.0), s = -length0*sign/(t*t*t);

		possible &= sign > 0.0 || t < 1.0;
		f[0] += c*x[0];
		f[1] += c*V;
		J[0] += c + s*x[0]*x[0];
		J[1] += s*x[0]*V;
		J[2] += c + s*V*V;
	}
	return possible;
}

static int solve(double x[2], const struct polygon *p)
{
	double f[2], J[3];

	for (int i = 0; i < NEWTON; i++) {
		int possible = closure(f, J, p, x);
		double determinant = J[0]*J[2] - J[1]*J[1], step[2], most;

		if (hypot(f[0], f[1]) < 1e-12)
			return possible;
		step[0] = -(J[2]*f[0] - J[1]*f[1])/determinant;
		step[1] = -(J[0]*f[1] - J[1]*f[0])/determinant;
		most = fmax(fabs(step[0]), fabs(step[1]));
		if (!isfinite(most))
			return 0;
		for (int k = 0; k < 2; k++)
			x[k] += step[k]*fmin(1.0, 0.1/most);
	}
	return 0;
}

/* Number of equilibria of the chain by its force polygon. */
static int by_polygon(int bars, double G)
{
	int total = 0;

	for (int compressed = 0; compressed < 1 << bars; compressed++) {
		struct polygon p = {bars, compressed, 1.2*G/(bars - 1)};
		double found[FOUND][2];
		int count = 0;

		for (int i = 0; i < GRID*GRID; i++) {
			double x[2] = {1.5*(2.0*(i%GRID)/(GRID - 1) - 1.0) + 1e-3,
			               1.7*(2.0*(i/GRID)/(GRID - 1) - 1.0) + 1e-3}; /* off the axes */
			int j = 0;

			if (!solve(x, &p))
				continue;
			while (j < count && hypot(found[j][0] - x[0], found[j][1] - x[1]) > 1e-7)
				j++;
			if (j == count && count < FOUND)
				memcpy(found[count++], x, sizeof x);
		}
		total += count;
	}
	return total;
}

/* Two bars, symmetric shapes: 2*a*(1/L - 1/l)*2 = -G*L with l = sqrt(1 + 4*a^2) has three solutions
 * below G = 2*(L^(2/3) - 1)^(3/2)/L^2, else one. */
static void two_bars(void)
{
	static const double expected[] = {-0.38264666, 0.25228358, 0.10254549};
	double limit = 2.0*pow(pow(1.2, 2.0/3.0) - 1.0, 1.5)/1.44;
	const double G[] = {0.05, 0.999*limit, 1.001*limit, 0.1};
	const int symmetric[] = {3, 3, 1, 1};
	struct hawser_report report = {0};

	close_to(limit, 0.06453261, 1e-7, "the load at which two of the shapes meet");
	for (int i = 0; i < 4; i++) {
		struct hawser_net_equilibria found;
		int count = 0, taut = 0, stable = 0;

		if (!ok(!chain(&found, 2, G[i], 4000, &report), "two bars, G = %g: %s", G[i], report.message))
			continue;
		for (int j = 0; j < found.count; j++) {
			const double *x = found.list[j].x[1];
			double l = sqrt(1.0 + 4.0*x[1]*x[1]);

			taut += found.list[j].compressed == 0;
			stable += found.list[j].unstable == 0;
			if (fabs(x[0] - 0.5) > 1e-6)
				continue;
			ok(fabs(4.0*x[1]*(1.0/1.2 - 1.0/l) + 1.2*G[i]) < 1e-9, "balance at a = %.8f", x[1]);
			if (i == 0 && count < 3)
				ok(fabs(x[1] - expected[count]) < 1e-8, "a = %.8f against %.8f", x[1],
				   expected[count]);
			count++;
		}
		ok(count == symmetric[i], "G = %.8f: %d symmetric shapes against %d", G[i], count,
		   symmetric[i]);
		ok(taut == 1 && stable == 1, "one shape without compression (%d), and no other is stable (%d)",
		   taut, stable);
		hawser_net_equilibria_clear(&found);
	}
}

static void chains(void)
{
	struct hawser_report report = {0};

	for (int bars = 2; bars <= 4; bars++) {
		struct hawser_net_equilibria found;
		int expected = by_polygon(bars, 0.05), taut = 0;

		if (!ok(!chain(&found, bars, 0.05, 4000, &report), "%d bars: %s", bars, report.message))
			continue;
		ok(found.count == expected, "%d bars: %d equilibria against %d of the force polygon", bars,
		   found.count, expected);
		for (int i = 0; i < found.count; i++) {
			taut += found.list[i].compressed == 0;
			ok(found.list[i].residual < 1e-14, "residual %.1e N", found.list[i].residual);
		}
		ok(taut == 1 && found.list[0].compressed == 0, "%d without compression, of the least energy",
		   taut);
		hawser_net_equilibria_clear(&found);
	}
}

static void refusals(void)
{
	struct hawser_net_node node[2] = {{.name = "A", .support = 1, .placed = 1, .held = {1, 1, 1}},
	                                  {.name = "B", .support = 1, .placed = 1, .held = {1, 1, 1},
	                                   .x = {1.0, 0.0, 0.0}}};
	struct hawser_net_cable cable = {.name = "c", .to = 1, .EA = 1.0, .rho = 0.1, .value = 1.2,
	                                 .elements = 32};
	struct hawser_net net = {.name = node[0].name, .g = 9.81, .node = node, .cable = &cable, .nodes = 2,
	                         .cables = 1};
	struct hawser_net_equilibria found;
	struct hawser_report report = {0};

	ok(hawser_net_equilibria_find(&found, &net, NULL, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "93 unknowns"), "too many: %s", report.message);
	cable.elements = 1;
	ok(hawser_net_equilibria_find(&found, &net, NULL, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "0 unknowns"), "none: %s", report.message);
	hawser_net_equilibria_clear(NULL);
}

CASE(property_net_equilibria)
{
	two_bars();
	chains();
	refusals();
	return done_testing();
}
