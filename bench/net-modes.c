/* bench/net-modes - modes of nets: processor time over the numbers of unknowns and of modes, the
 * bound of the error, and whether none is missed.
 *
 *     bench/net-modes [-d UNKNOWNS]
 *
 * Spider webs of 12 spokes and rings, whose modes come in pairs. Wrong is a bound above 1e-7, a count
 * of modes that cannot be made, another symmetry than twelvefold, or a mode without label; the status
 * is then 1. Times include the statics and the search for the symmetry.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net_modes.h>

#include "bench/clock.h"

enum { SPOKES = 12, RINGS = 8 };
#define STIFF 1.5e6 /* N */
#define RHO 0.8     /* kg/m */

static int node(struct hawser_net *net, double x, double y, double z, int held)
{
	struct hawser_net_node *one = &net->node[net->nodes];

	*one = (struct hawser_net_node){.placed = 1, .x = {x, y, z}, .support = held};
	memset(one->held, held, sizeof one->held);
	return net->nodes++;
}

/* Unstretched length: that part of the chord between the given places. */
static void cable(struct hawser_net *net, int from, int to, double part, int elements)
{
	const double *a = net->node[from].x, *b = net->node[to].x;
	double chord = hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);

	net->cable[net->cables++] = (struct hawser_net_cable){
		.from = from, .to = to, .EA = STIFF, .rho = RHO, .value = part*chord, .elements = elements};
}

static void web(struct hawser_net *net, int elements)
{
	static struct hawser_net_node nodes[SPOKES*(RINGS + 1) + 1];
	static struct hawser_net_cable cables[2*SPOKES*(RINGS + 1)];
	static char name[] = "web";
	int hub, last[SPOKES];

	*net = (struct hawser_net){.name = name, .g = 9.81, .node = nodes, .cable = cables};
	hub = node(net, 0.0, 0.0, 0.0, 0);
	for (int i = 0; i < SPOKES; i++)
		last[i] = hub;
	for (int ring = 1; ring <= RINGS + 1; ring++) {
		int first = net->nodes;

		for (int i = 0; i < SPOKES; i++) {
			double angle = 2.0*M_PI*i/SPOKES + 0.1, radius = 2.0*ring;
			int at = node(net, radius*cos(angle), 0.02*radius*radius, -radius*sin(angle),
			              ring > RINGS);

			cable(net, last[i], at, 0.998, elements);
			last[i] = at;
		}
		for (int i = 0; i < SPOKES && ring <= RINGS; i++)
			cable(net, first + i, first + (i + 1) % SPOKES, 1.002, elements);
	}
}

static int run(int elements, int n)
{
	struct hawser_net_modes modes;
	struct hawser_report report = {0};
	struct hawser_net net;
	double began, took, worst = 0.0;
	int wrong = 0;

	web(&net, elements);
	began = cpu_secs();
	if (hawser_net_modes_solve(&modes, &net, n, &report)) {
		printf("%s\n", report.message);
		return 1;
	}
	took = cpu_secs() - began;
	for (int j = 0; j < n; j++) {
		worst = fmax(worst, modes.residual[j]);
		wrong |= modes.waves[j] < 0 || fabs(modes.parity[j][1]) < 0.98;
	}
	wrong |= !(worst <= 1e-7) || modes.below <= 0.0 || modes.symmetry.turns != SPOKES ||
	         modes.symmetry.mirrors != 2;
	printf("%8d %6d %10.1f %10d %10.1e %8d%s\n", modes.unknowns, n, 1e3*took, modes.iterations, worst,
	       modes.counted, wrong ? "  WRONG" : "");
	hawser_net_modes_clear(&modes);
	return wrong;
}

int main(int count, char **arguments)
{
	double most = count == 3 && strcmp(arguments[1], "-d") == 0 ? strtod(arguments[2], NULL) : 1e5;
	int wrong = 0;

	printf("%8s %6s %10s %10s %10s %8s\n", "unknowns", "modes", "ms", "solutions", "bound", "counted");
	for (int elements = 1; 600.0*elements <= most; elements *= 3) {
		wrong |= run(elements, 6);
		wrong |= run(elements, 50);
		if (600.0*elements <= 3e4)
			wrong |= run(elements, 200);
	}
	return wrong;
}
