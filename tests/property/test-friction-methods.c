/* The same forces, and the same contacts open, sticking and slipping, as by methods of Siconos; and in
 * chains as in nets.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "tests/friction-random.h"
#include "tests/friction-siconos.h"
#include "tests/tap.h"

/* A contact at the limit of two states may be called either: its distance over the largest impulse. */
static const double limit = 1e-7;

/* Largest difference of impulses over the largest impulse; *states: contacts whose states differ. */
static double difference(int *states, const struct hawser_contact_reply *a,
                         const struct hawser_contact_reply *b, const struct friction_case *of)
{
	double most = 0.0, size = 1e-3;

	for (int c = 0; c < of->contacts; c++)
		size = fmax(size, a[c].impulse[0]);
	for (int c = 0; c < of->contacts; c++) {
		double near = fabs(hypot(a[c].impulse[1], a[c].impulse[2]) -
		                   of->contact[c].friction*a[c].impulse[0]);

		for (int k = 0; k < 3; k++)
			most = fmax(most, fabs(a[c].impulse[k] - b[c].impulse[k])/size);
		if (a[c].state != b[c].state && near > limit*size && a[c].impulse[0] > limit*size)
			++*states;
	}
	return most;
}

static void compare(const char *method, int count, double mu)
{
	static struct friction_case of;
	static struct hawser_contact_reply a[FRICTION_NODES], b[FRICTION_NODES];
	static double u[FRICTION_NODES][3];
	struct hawser_friction_counts ours = {0};
	struct hawser_report report = {.message = ""};
	int failed = 0, states = 0, counted[3] = {0}, refused = 0;
	double most = 0.0, balance = 0.0;

	for (int i = 0; i < count; i++) {
		const char *wrong = NULL;

		friction_random(&of, i, mu, 1e3);
		if (friction_solve(u, a, &ours, &of, &report)) {
			printf("# problem %d: %s\n", i, report.message);
			failed++;
			continue;
		}
		counted[0] += ours.open;
		counted[1] += ours.stick;
		counted[2] += ours.slip;
		balance = fmax(balance, ours.balance);
		if (method) {
			const struct hawser_friction_problem problem = friction_problem(&of);

			wrong = siconos_solve(b, &problem, of.nodes, (const int (*)[2])of.link, of.nodes - 1,
			                      method);
		}
		if (wrong)
			printf("# problem %d, %s: %s\n", i, method, wrong);
		refused += wrong != NULL;
		if (method && !wrong)
			most = fmax(most, difference(&states, a, b, &of));
	}
	ok(!failed && balance < 1e-9, "%d of %d problems are solved, balance %.1e (contacts: %d open, "
	   "%d stick, %d slip)", count - failed, count, balance, counted[0], counted[1], counted[2]);
	if (method)
		ok(most < 1e-6 && !states && refused*50 <= count, "%s: the same, largest difference %.1e, %d "
		   "other states, %d not solved by it", method, most, states, refused);
	else
		ok(1, "methods of Siconos # SKIP built without Siconos");
}

/* A link of no stiffness from the last node to the first makes a net of a chain, and changes nothing
 * else: elimination along the chain and KLU give the same. */
static void nets(int count)
{
	static struct friction_case of;
	static struct hawser_contact_reply a[FRICTION_NODES], b[FRICTION_NODES];
	static double u[FRICTION_NODES][3];
	struct hawser_friction_counts counts;
	struct hawser_report report = {.message = ""};
	int failed = 0, states = 0, solved = 0;
	double most = 0.0;

	for (int i = 0; i < count; i++) {
		friction_random(&of, i, 0.6, 1e3);
		if (of.nodes < 3)
			continue;
		failed += friction_solve(u, a, &counts, &of, &report) != HAWSER_OK;
		of.link[of.nodes - 1][1] = 0;
		of.rings = 1;
		memset(of.off[of.nodes - 1], 0, sizeof of.off[0]);
		if (friction_solve(u, b, &counts, &of, &report)) {
			printf("# problem %d: %s\n", i, report.message);
			failed++;
			continue;
		}
		solved++;
		most = fmax(most, difference(&states, a, b, &of));
	}
	ok(!failed && !states && most < 1e-7, "%d chains as nets: %d fail, %d other states, largest "
	   "difference %.1e", solved, failed, states, most);
}

CASE(property_friction_methods)
{
	int count = getenv("HAWSER_LONG") ? 1000 : 100;

	for (int i = 0; i < 3; i++) /* the first is one without friction */
		compare(siconos_method(i), count, i ? 0.6 : 0.0);
	nets(count);
	return done_testing();
}
