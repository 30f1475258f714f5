/* bench/friction - contact with friction in one step: agreement with Siconos on random problems; time
 * over the number of contacts, cold and warm, errors beside it; times of Siconos; how many random
 * problems are not solved.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/friction.h>

#include "bench/clock.h"
#include "tests/friction-random.h"
#include "tests/friction-siconos.h"

/* A cable of length 1 and mass 1 on the floor, pulled at its end until about half of it slips; the
 * elements are stiff against the step: h^2 k = stiff*m. */
struct drag {
	int nodes, (*link)[2];
	double (*diagonal)[9], (*off)[9], (*right)[3], (*u)[3];
	unsigned char *held;
	struct hawser_contact *contact;
	struct hawser_contact_reply *reply;
};

static int drag_open(struct drag *drag, int n, double stiff)
{
	static const double up[3] = {0.0, 1.0, 0.0};
	const size_t size = (size_t)n;
	const double m = 1.0/n, k = stiff*m;

	*drag = (struct drag){.nodes = n, .link = calloc(size, sizeof *drag->link),
	                      .diagonal = calloc(size, sizeof *drag->diagonal),
	                      .off = calloc(size, sizeof *drag->off),
	                      .right = calloc(size, sizeof *drag->right),
	                      .u = calloc(size, sizeof *drag->u), .held = calloc(size, 1),
	                      .contact = calloc(size, sizeof *drag->contact),
	                      .reply = calloc(size, sizeof *drag->reply)};
	if (!drag->link || !drag->diagonal || !drag->off || !drag->right || !drag->u || !drag->held ||
	    !drag->contact || !drag->reply)
		return 0;
	for (int i = 0; i < n; i++) {
		double ends = i == 0 || i == n - 1 ? 1.0 : 2.0;

		drag->link[i][0] = i;
		drag->link[i][1] = i + 1;
		drag->diagonal[i][0] = m + ends*k;
		drag->diagonal[i][4] = drag->diagonal[i][8] = m + ends*1e-3*k;
		drag->off[i][0] = -k;
		drag->off[i][4] = drag->off[i][8] = -1e-3*k;
		drag->held[i] = 4;
		drag->right[i][1] = -9.81e-3*m;
		drag->contact[i] = (struct hawser_contact){.node = i, .friction = 0.3};
		hawser_contact_frame(&drag->contact[i], up);
	}
	drag->right[n - 1][0] = 0.15*9.81e-3;
	return 1;
}

static void drag_clear(struct drag *drag)
{
	free(drag->link);
	free(drag->diagonal);
	free(drag->off);
	free(drag->right);
	free(drag->u);
	free(drag->held);
	free(drag->contact);
	free(drag->reply);
}

static struct hawser_friction_problem problem_of(const struct drag *drag)
{
	return (struct hawser_friction_problem){
		.diagonal = (const double (*)[9])drag->diagonal, .off = (const double (*)[9])drag->off,
		.right = (const double (*)[3])drag->right, .held = drag->held, .contact = drag->contact,
		.contacts = drag->nodes};
}

/* Seconds of a solution, best of some; NAN if it fails. With `warm` the pull changes a little between
 * solutions, as from step to step. */
static double timed(struct hawser_friction_counts *counts, struct drag *drag, int warm, int times)
{
	const struct hawser_friction_problem problem = problem_of(drag);
	struct hawser_friction_options options = {.most = 1000};
	struct hawser_friction *solver;
	struct hawser_report report;
	double best = HUGE_VAL;
	int failed = hawser_friction_open(&solver, drag->nodes, (const int (*)[2])drag->link,
	                                  drag->nodes - 1, drag->nodes, &report) != HAWSER_OK;

	for (int i = 0; i < times + warm && !failed; i++) {
		double began;

		options.warm = warm && i;
		drag->right[drag->nodes - 1][0] = 0.15*9.81e-3*(1.0 + (warm ? 1e-3*i : 0.0));
		began = cpu_secs();
		failed = hawser_friction_solve(solver, drag->u, drag->reply, counts, &problem, &options,
		                               &report) != HAWSER_OK;
		if (!warm || i)
			best = fmin(best, cpu_secs() - began);
	}
	if (failed)
		printf("%s\n", report.message);
	hawser_friction_clear(solver);
	return failed ? NAN : best;
}

static int scaling(double stiff, int warm)
{
	static const int size[] = {100, 200, 500, 1000, 2000, 5000, 10000};
	double sum[4] = {0.0}, slope;
	int points = sizeof size/sizeof *size, failed = 0;

	printf("# %s, stiffness over mass of an element %g\n# contacts  ms  us/contact  iterations  slip  "
	       "residual  balance\n", warm ? "warm start" : "cold start", stiff);
	for (int i = 0; i < points; i++) {
		struct hawser_friction_counts counts;
		struct drag drag;
		double secs = NAN, x = log(size[i]);

		if (drag_open(&drag, size[i], stiff))
			secs = timed(&counts, &drag, warm, size[i] < 1000 ? 20 : 5);
		drag_clear(&drag);
		failed += !(counts.residual < 1e-9 && counts.balance < 1e-9 && secs > 0.0);
		printf("%6d %9.3f %6.2f %4d %6d %8.1e %8.1e\n", size[i], 1e3*secs, 1e6*secs/size[i],
		       counts.iterations, counts.slip, counts.residual, counts.balance);
		sum[0] += x;
		sum[1] += log(secs);
		sum[2] += x*x;
		sum[3] += x*log(secs);
	}
	slope = (points*sum[3] - sum[0]*sum[1])/(points*sum[2] - sum[0]*sum[0]);
	printf("slope of time against contacts: %.3f\n", slope);
	return failed;
}

/* Siconos beside ours, with friction (of Lemke's: without). */
static void methods(void)
{
	static const int size[] = {50, 100, 200};

	printf("# ms of a solution from a cold start, ours and by Siconos\n");
	for (int m = 0; siconos_method(m); m++) {
		const char *method = siconos_method(m);

		for (int i = 0; i < 3; i++) {
			struct hawser_friction_counts counts;
			struct drag drag;
			double ours = NAN, began = 0.0;
			const char *wrong = "no memory";

			if (drag_open(&drag, size[i], 1e3)) {
				const struct hawser_friction_problem problem = problem_of(&drag);

				for (int c = 0; c < size[i] && m == 0; c++)
					drag.contact[c].friction = 0.0;
				ours = timed(&counts, &drag, 0, 1);
				began = cpu_secs();
				wrong = siconos_solve(drag.reply, &problem, drag.nodes,
				                      (const int (*)[2])drag.link, drag.nodes - 1, method);
			}
			printf("%4d contacts: %9.2f, %s %9.2f %s\n", size[i], 1e3*ours, method,
			       1e3*(cpu_secs() - began), wrong ? wrong : "");
			drag_clear(&drag);
		}
	}
}

/* Random problems by ours and another method: how many agree in states and forces. */
static int agreement(const char *name, int count)
{
	static struct friction_case of;
	static struct hawser_contact_reply a[FRICTION_NODES], b[FRICTION_NODES];
	static double u[FRICTION_NODES][3];
	struct hawser_friction_counts ours;
	struct hawser_report report;
	int failed = 0, unsolved = 0, states = 0, contacts = 0;
	double most = 0.0;

	for (int i = 0; i < count; i++) {
		struct hawser_friction_problem problem;
		double size = 1e-3;

		friction_random(&of, i, 0.6, 1e3);
		problem = friction_problem(&of);
		if (friction_solve(u, a, &ours, &of, &report)) {
			failed++;
			continue;
		}
		if (siconos_solve(b, &problem, of.nodes, (const int (*)[2])of.link, of.nodes - 1, name)) {
			unsolved++;
			continue;
		}
		for (int c = 0; c < of.contacts; c++)
			size = fmax(size, a[c].impulse[0]);
		for (int c = 0; c < of.contacts; c++) {
			contacts++;
			states += a[c].state != b[c].state;
			for (int k = 0; k < 3; k++)
				most = fmax(most, fabs(a[c].impulse[k] - b[c].impulse[k])/size);
		}
	}
	printf("%d random problems, %d contacts: newton failed %d, %s failed %d; %d other states, largest "
	       "difference of impulses %.1e\n", count, contacts, failed, name, unsolved, states, most);
	return failed || states || most > 1e-6;
}

/* How many random problems of a class are not solved. */
static void failures(double mu, double stiff, int count)
{
	static struct friction_case of;
	static struct hawser_contact_reply reply[FRICTION_NODES];
	static double u[FRICTION_NODES][3];
	struct hawser_friction_counts counts;
	struct hawser_report report;
	int failed = 0, most = 0;
	double sum = 0.0;

	for (int i = 0; i < count; i++) {
		friction_random(&of, i, mu, stiff);
		failed += friction_solve(u, reply, &counts, &of, &report) != HAWSER_OK;
		sum += counts.iterations;
		most = counts.iterations > most ? counts.iterations : most;
	}
	printf("%6g %10g %6d of %d %6.1f %5d\n", mu, stiff, failed, count, sum/count, most);
}

static void classes(int count)
{
	static const double mu[] = {0.6, 1.0, 2.0}, stiff[] = {1e3, 1e6, 1e9};

	printf("# random problems from a cold start\n"
	       "# friction  stiffness  not solved  iterations  most\n");
	for (int m = 0; m < 3; m++)
		for (int s = 0; s < 3; s++)
			failures(mu[m], stiff[s], count);
}

int main(void)
{
	int failed = 0;

	if (siconos_method(0))
		failed += agreement("nsgs", 1000) + agreement("nsn_ac", 1000);
	else
		printf("built without Siconos: nothing to compare with\n");
	failed += scaling(1e3, 0) + scaling(1e6, 0) + scaling(1e6, 1);
	methods();
	classes(20000);
	return failed != 0;
}
