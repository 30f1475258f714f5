/* Cables held at both ends over a floor that moves: random ones against the laws of each node, from
 * the positions alone, and one against an outside program.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <hawser/net.h>

#include "tests/tap.h"

enum { CABLES = 80, TEXT = 320 };

static uint64_t state = 20261128;

static double uniform(double least, double most)
{
	state = state*6364136223846793005U + 1442695040888963407U;
	return least + (most - least)*(double)(state >> 11)*0x1p-53;
}

struct floor {
	double b[2], EA, rho, length0, n[2], at, friction, way; /* n, at: n.x >= at; way: 1 or -1 */
	int elements;
};

/* Both ends on the free side; slack of 5 % to three times the chord. */
static struct floor any(void)
{
	struct floor of = {.b = {uniform(0.3, 1.5), uniform(-0.5, 0.5)}, .EA = pow(10.0, uniform(3.5, 6.5)),
	                   .rho = pow(10.0, uniform(-1.0, 0.7)), .friction = uniform(0.05, 1.2),
	                   .elements = (int)uniform(4.0, 24.0)};
	double angle = uniform(-0.4, 0.4);

	of.way = uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0;
	of.length0 = hypot(of.b[0], of.b[1])*uniform(1.05, 3.0);
	of.n[0] = sin(angle);
	of.n[1] = cos(angle);
	of.at = fmin(0.0, of.n[0]*of.b[0] + of.n[1]*of.b[1]) - uniform(0.0, 0.3)*of.length0;
	return of;
}

static int solve(struct hawser_net_statics *st, const struct floor *of, struct hawser_report *report)
{
	char nodes[TEXT], cables[TEXT], obstacles[TEXT];
	const char *path = source_file("notebooks-data/scenes/net-drag.yaml");
	const char *const set[] = {nodes, cables, "supports={A: fixed, B: fixed}", obstacles};
	struct hawser_net net;
	enum hawser_status status;

	snprintf(nodes, sizeof nodes, "nodes={A: [0, 0, 0], B: [%.17g, %.17g, 0]}", of->b[0], of->b[1]);
	snprintf(cables, sizeof cables, "cables=[{name: c, from: A, to: B, EA: %.17g, rho: %.17g, length0: "
	         "%.17g, elements: %d}]", of->EA, of->rho, of->length0, of->elements);
	snprintf(obstacles, sizeof obstacles, "obstacles=[{name: floor, plane: {point: [%.17g, %.17g], "
	         "normal: [%.17g, %.17g]}, friction: %.17g, velocity: [%.17g, %.17g]}]", of->at*of->n[0],
	         of->at*of->n[1], of->n[0], of->n[1], of->friction, 0.5*of->way*of->n[1],
	         -0.5*of->way*of->n[0]);
	status = hawser_net_open(&net, path, set, 4, report);
	if (!status)
		status = hawser_net_solve(st, &net, NULL, report);
	hawser_net_clear(&net);
	return !status;
}

/* The largest defect of the nodes' balance over the weight: what is not carried off the floor; on
 * it, the force along the floor that is not friction*r, a force r < 0, and a node below it. */
static double defect(const struct hawser_net_statics *st, const struct floor *of)
{
	double h = of->length0/of->elements, weight = 9.81*of->rho*h, worst = 0.0;

	for (int i = 1; i < of->elements; i++) {
		const double *x = st->point[i].x;
		double F[2] = {0.0, -weight}, gap = of->n[0]*x[0] + of->n[1]*x[1] - of->at, r, along;

		for (int k = -1; k <= 1; k += 2) {
			const double *to = st->point[i + k].x;
			double d[2] = {to[0] - x[0], to[1] - x[1]}, l = hypot(d[0], d[1]);
			double T = of->EA*fmax(l/h - 1.0, 0.0);

			F[0] += T*d[0]/l;
			F[1] += T*d[1]/l;
		}
		r = -(of->n[0]*F[0] + of->n[1]*F[1]);
		along = of->way*(of->n[1]*F[0] - of->n[0]*F[1]);
		worst = fmax(worst, fabs(fmin(gap, 0.0))/h);
		worst = gap > 1e-9*h ? fmax(worst, hypot(r, along)/weight)
		                     : fmax(worst, fmax(fabs(along + of->friction*r), -r)/weight);
	}
	return worst;
}

static void random_ones(void)
{
	double worst = 0.0;
	int solved = 0, touch = 0, slack = 0;

	for (int i = 0; i < CABLES; i++) {
		struct floor of = any();
		struct hawser_net_statics st = {0};
		struct hawser_report report;

		if (!solve(&st, &of, &report)) {
			printf("# cable %d: %s\n", i, report.message);
			continue;
		}
		solved++;
		touch += st.contacts > 0;
		slack += st.member[0].slack > 0;
		worst = fmax(worst, defect(&st, &of));
		hawser_net_statics_clear(&st);
	}
	ok(solved == CABLES, "%d of %d random cables over a floor that moves are solved", solved, CABLES);
	/* tensions by the law from positions with 16 digits: EA*1e-16/h */
	ok(worst < 1e-6, "the laws of their nodes hold to %.1e of the weight", worst);
	ok(touch > CABLES/2 && slack > CABLES/10, "%d touch, %d have slack elements", touch, slack);
}

/* By a relaxation, of an outside program. Tensions of elements; the points have their means. */
static void outside(void)
{
	static const double T[] = {3.5804, 2.0317, 1.1772, 0.0, 1.962};
	const struct floor of = {.b = {0.8, 0.0}, .EA = 100e3, .rho = 0.5, .length0 = 2.0, .n = {0.0, 1.0},
	                         .at = -0.6, .friction = 0.6, .way = 1.0, .elements = 5};
	struct hawser_net_statics st = {0};
	struct hawser_report report;
	double worst = 0.0;

	if (ok(solve(&st, &of, &report), "the cable of the outside program")) {
		for (int i = 0; i < 5; i++) {
			const double *a = st.point[i].x, *b = st.point[i + 1].x;
			double strain = hypot(b[0] - a[0], b[1] - a[1])/0.4 - 1.0;

			worst = fmax(worst, fabs(of.EA*fmax(strain, 0.0) - T[i]));
		}
		ok(worst < 6e-5, "its tensions to the digits that are printed: %.1e N", worst);
	}
	hawser_net_statics_clear(&st);
}

CASE(property_net_floor)
{
	outside();
	random_ones();
	return done_testing();
}
