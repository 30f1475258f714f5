/* All methods of the statics of nets on the same nets: those that cannot fail agree with each other;
 * the older ones agree where they succeed, and fail as their sources say.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "tests/net-random.h"
#include "tests/nets/comparison.h"
#include "tests/tap.h"

enum { NETS = 12, MOST = 12 };

/* What a method has done on all nets. */
struct score {
	int solved, compressed, failed;
	double worst; /* distance of a node from the place of the first method, over the size */
};

/* Mesh methods that find any equilibrium of cables. */
static int certain(const char *name)
{
	return !strcmp(name, "automatic") || !strcmp(name, "interior-point") || !strcmp(name, "forces");
}

static double distance(const struct hawser_net_statics *a, const struct hawser_net_statics *b)
{
	double most = 0.0;

	for (int i = 0; i < a->points; i++)
		for (int k = 0; k < 3; k++)
			most = fmax(most, fabs(a->point[i].x[k] - b->point[i].x[k]));
	return most;
}

/* Method i: the rows of the library, then the older ones. */
static const struct hawser__net_method *method(int i)
{
	int own = 0;

	while (hawser__net_method(own))
		own++;
	return i < own ? hawser__net_method(i) : net_older(i - own);
}

/* A method on one net, against the equilibrium `own`. */
static void one(struct score *score, const struct hawser_net *net,
                const struct hawser__net_method *by, const struct hawser_net_statics *own, double size)
{
	const char *name = by->shown.name;
	struct hawser_net_options options = {.iterations = strcmp(name, "relaxation") ? 200 : 20000};
	struct hawser_report report = {0};
	struct net_certificate certificate;
	struct hawser_net_statics st;
	enum hawser_status status;

	net_start_at(strstr("two-sided, regularised, descent", name) != NULL, 1e-4, 0);
	status = hawser__net_solve_by(&st, net, by, &options, &report);
	if (status) {
		score->failed++;
		if (status != HAWSER_ERR_CONVERGENCE || !strstr(report.message, name) || report.iteration < 1)
			ok(0, "%s: %s", name, report.message);
		return;
	}
	status = net_certify(&certificate, net, &st, &report);
	if (!strcmp(name, "two-sided") && !certificate.right && certificate.compressed > 0) {
		score->compressed++;
	} else {
		score->solved++;
		score->worst = fmax(score->worst, distance(&st, own)/size);
		if (!(st.gap >= 0.0 && st.gap <= 1e-8*(fabs(st.energy) + fabs(own->energy))))
			ok(0, "%s: gap %.1e J", name, st.gap);
	}
	hawser_net_statics_clear(&st);
}

/* Hanging chains between two supports, 1 cable or 2 in a row; with `slack` always 2, and a longer cable
 * without weight from a support to their joint, which is slack. */
static void chains(struct score score[MOST], int slack, double EA)
{
	for (int i = 0; i < NETS; i++) {
		static const double ratio[] = {1.4, 2.385, 1.01, 0.996};
		struct random_net r = {0};
		struct hawser_net_statics own;
		struct hawser_report report = {0};
		int two = slack || i%2;
		char name[] = "chain";

		r.net = (struct hawser_net){.name = name, .g = 9.81, .node = r.node, .cable = r.cable,
		                            .nodes = 2 + two, .cables = 1 + two + slack};
		for (int k = 0; k < 2; k++)
			memset(r.node[k].held, 1, 3);
		r.node[1].x[0] = 31.0;
		r.node[1].x[1] = 4.0*(i%3);
		for (int c = 0; c < r.net.cables; c++)
			r.cable[c] = (struct hawser_net_cable){
				.from = c ? 2 : 0, .to = c || !two ? 1 : 2, .EA = EA*pow(10.0, i/3.0), .rho = 1.2,
				.value = ratio[i%4]*hypot(31.0, 4.0*(i%3))/(1 + two), .elements = 10 + i};
		if (slack)
			r.cable[r.net.cables - 1] = (struct hawser_net_cable){
				.from = 0, .to = 2, .EA = EA, .rho = 0.0, .value = 80.0, .elements = 1};
		if (!ok(!hawser_net_solve(&own, &r.net, NULL, &report), "chain %d%s: %s", i,
		        slack ? " with a slack cable" : "", report.message))
			continue;
		for (int k = 0; method(k); k++)
			if (method(k)->solve)
				one(&score[k], &r.net, method(k), &own, 31.0);
		hawser_net_statics_clear(&own);
	}
}

static int row(const char *name)
{
	int k = 0;

	while (method(k) && strcmp(method(k)->shown.name, name) != 0)
		k++;
	return k;
}

CASE(property_net_methods)
{
	struct score taut[MOST] = {{0}}, slack[MOST] = {{0}};
	const struct score *two = &taut[row("two-sided")], *regular = &taut[row("regularised")];

	chains(taut, 0, 4000.0);
	chains(slack, 1, 4000.0);
	for (int k = 0; method(k); k++) {
		const char *name = method(k)->shown.name;

		if (!method(k)->solve)
			continue;
		ok(taut[k].worst <= 1e-8 && slack[k].worst <= 1e-8,
		   "%s: %d and %d of %d solved, %d and %d compressed, %d and %d failed; off by %.1e and %.1e",
		   name, taut[k].solved, slack[k].solved, NETS, taut[k].compressed, slack[k].compressed,
		   taut[k].failed, slack[k].failed, taut[k].worst, slack[k].worst);
		if (certain(name))
			ok(taut[k].solved == NETS && slack[k].solved == NETS, "%s solves all", name);
		ok(strlen(method(k)->shown.summary) > 0 && strlen(method(k)->shown.source) > 0,
		   "%s has a summary and a source", name);
	}
	ok(taut[row("mixed")].solved == NETS, "mixed solves all without slack cables");
	ok(slack[row("mixed")].solved < NETS, "and not those with them");
	ok(two->compressed > 0, "two-sided ends with compressed elements (B Figure 3.3)");
	ok(regular->failed > 0 && regular->solved > 0, "regularised solves some, and not others");
	return done_testing();
}
