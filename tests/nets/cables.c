/* tests/nets/cables.c - random cables between two supports, for comparisons of methods of statics.
 *
 * B 3.2.3 compares methods on 1600 random cables, and does not print the ranges of their parameters.
 * Those here have stiff and soft cables, taut, shallow and deep ones. Numbers are rounded to six
 * digits, so that powers that two machines round differently give the same cable.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/random.h"
#include "core/report.h"
#include "tests/nets/comparison.h"

/* Uniform between two bounds. */
static double uniform(uint64_t *state, double low, double high)
{
	return low + (high - low)*hawser__random(state);
}

static double rounded(double value)
{
	char text[32];

	snprintf(text, sizeof text, "%.5e", value);
	return strtod(text, NULL);
}

static double power(uint64_t *state, double low, double high)
{
	return rounded(pow(10.0, uniform(state, low, high)));
}

struct net_cable net_cable(unsigned seed, unsigned number)
{
	uint64_t state = (uint64_t)seed << 32 | number;
	struct net_cable cable = {.g = 9.81};
	double excess, chord;

	cable.d = power(&state, 0.0, 3.0);
	cable.h = rounded(uniform(&state, -1.0, 1.0)*cable.d);
	chord = sqrt(cable.d*cable.d + cable.h*cable.h);
	excess = uniform(&state, 0.0, 1.0) < 0.2 ? -power(&state, -4.0, -2.0) : power(&state, -3.0, 0.5);
	cable.length0 = chord*(1.0 + excess);
	cable.rho = power(&state, -1.0, log10(30.0));
	cable.EA = rounded(power(&state, 1.5, 7.0)*cable.rho*cable.g*cable.length0);
	cable.elements = 10 + (int)uniform(&state, 0.0, 91.0);
	return cable;
}

enum hawser_status net_cable_open(struct hawser_net *net, const struct net_cable *cable,
                                  struct hawser_report *report)
{
	memset(net, 0, sizeof *net);
	net->name = calloc(HAWSER_NET_NAME, 1);
	net->node = calloc(2, sizeof *net->node);
	net->cable = calloc(1, sizeof *net->cable);
	if (!net->name || !net->node || !net->cable) {
		hawser_net_clear(net);
		return hawser__no_memory(report, "net");
	}
	strcpy(net->name, "random cable");
	net->g = cable->g;
	net->nodes = 2;
	net->cables = 1;
	for (int i = 0; i < 2; i++) {
		net->node[i] = (struct hawser_net_node){.name = {(char)('A' + i)}, .placed = 1, .support = 1,
		                                        .held = {1, 1, 1}};
		net->node[i].x[0] = i*cable->d;
		net->node[i].x[1] = i*cable->h;
	}
	net->cable[0] = (struct hawser_net_cable){.name = "c", .from = 0, .to = 1, .EA = cable->EA,
	                                          .rho = cable->rho, .value = cable->length0,
	                                          .given = HAWSER_NET_LENGTH0,
	                                          .elements = cable->elements};
	return HAWSER_OK;
}
