/* bench/net-statics - statics of nets: time, memory and error.
 *
 *     SRCDIR=. bench/net-statics [-d UNKNOWNS]
 *
 * First the net of B's Table 3.1 by each method of the library, and by older ones: reading of the
 * scene, and one solution.
 * Then generated spider webs and cable roofs of 10^3 to UNKNOWNS (10^5) unknown coordinates, each in a
 * process of its own whose largest memory is measured: webs and roofs that are taut, webs with threads
 * that are too long, and roofs whose wind lifts the hanging cables slack. The results are verified
 * before times are printed: the gap of the energy, and the residual against tolerance and round-off.
 * Times are processor times, best of several for short ones. The status is 1 if a result is wrong.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/clock.h"
#include "tests/nets/comparison.h"

/* N, and the energy, J: of two independent programs (tests/reference/test-net.c). */
#define WEIGHT 894.326688
#define ENERGY -1753.03356462
enum { WEB, LOOSE_WEB, ROOF, LIFTED_ROOF, KINDS };
static const char *const name[KINDS] = {"web", "web, slack threads", "roof", "roof, lifted"};

struct shape {
	struct hawser_net net;
	double weight; /* N, of all loads */
};

/* --- the net of Table 3.1 --- */

/* Best processor time of a solution in 0.3 s, at least one. */
static double best_of(const struct hawser_net *net, const struct hawser__net_method *method)
{
	double best = INFINITY, spent = 0.0;

	while (spent < 0.3) {
		const struct hawser_net_options options = {.method = NULL};
		struct hawser_net_statics st;
		struct hawser_report report;
		double began = cpu_secs(), took;

		if (hawser__net_solve_by(&st, net, method, &options, &report))
			return INFINITY;
		took = cpu_secs() - began;
		hawser_net_statics_clear(&st);
		best = fmin(best, took);
		spent += took;
	}
	return best;
}

static double best_reading(const char *path)
{
	double best = INFINITY;

	for (int i = 0; i < 20; i++) {
		struct hawser_net net;
		struct hawser_report report;
		double began = cpu_secs();

		if (hawser_net_open(&net, path, NULL, 0, &report))
			return INFINITY;
		best = fmin(best, cpu_secs() - began);
		hawser_net_clear(&net);
	}
	return best;
}

/* Of these the net has no equilibrium of cables: they are there for comparison. */
static int may_fail(const char *method)
{
	return !strcmp(method, "two-sided") || !strcmp(method, "regularised");
}

/* One line; *first: ms of the first method. Returns 1 if the result is wrong. */
static int method_line(double *first, const struct hawser_net *net,
                       const struct hawser__net_method *method, double reading)
{
	const struct hawser_net_options options = {.method = NULL};
	const char *called = method->shown.name;
	struct hawser_report report = {0};
	struct net_certificate certificate = {.right = 1};
	struct hawser_net_statics st;
	double ms, off;
	int wrong;

	net_start_at(strstr("two-sided, regularised, descent", called) != NULL, 0.01, 0);
	if (hawser__net_solve_by(&st, net, method, &options, &report)) {
		printf("%-16s %s\n", called, report.message);
		return !may_fail(called);
	}
	if (method->solve && (net_certify(&certificate, net, &st, &report) || !certificate.right)) {
		printf("%-16s %d compressed elements\n", called, certificate.compressed);
		hawser_net_statics_clear(&st);
		return !may_fail(called);
	}
	off = st.energy/ENERGY - 1.0;
	/* Catenaries have no mesh, whose error of the energy is 3e-6. */
	wrong = !(fabs(off) <= (method->solve ? 1e-10 : 1e-5));
	ms = 1e3*best_of(net, method);
	*first = *first > 0.0 ? *first : ms;
	printf("%-16s %8d %10d %10.3f %12.3f %10.1e %10.1e %8.1f\n", called, st.unknowns, st.iterations, ms,
	       ms + 1e3*reading, st.residual/WEIGHT, off, ms/ *first);
	hawser_net_statics_clear(&st);
	return wrong;
}

/* Dynamic relaxation stops at its own tolerance: its distance from the others is in the columns of the
 * error. */
static int table_3_1(void)
{
	const char *top = getenv("SRCDIR");
	struct hawser_report report = {0};
	struct hawser_net net;
	double reading, first = 0.0;
	char path[1000];
	int wrong = 0;

	snprintf(path, sizeof path, "%s/notebooks-data/scenes/net-table-3-1.yaml", top ? top : ".");
	if (hawser_net_open(&net, path, NULL, 0, &report)) {
		printf("%s\n", report.message);
		return 1;
	}
	reading = best_reading(path);
	printf("net of Table 3.1; reading of the scene %.2f ms\n", 1e3*reading);
	printf("%-16s %8s %10s %10s %12s %10s %10s %8s\n", "method", "unknowns", "iterations", "ms",
	       "with reading", "residual/W", "energy", "ratio");
	for (int i = 0; hawser__net_method(i); i++)
		wrong |= method_line(&first, &net, hawser__net_method(i), reading);
	for (int i = 0; net_older(i); i++)
		wrong |= method_line(&first, &net, net_older(i), reading);
	hawser_net_clear(&net);
	printf("energy: difference from the published one, relative; ratio: of the times, to the first "
	       "row\n\n");
	return wrong;
}

/* --- generated nets --- */

static int node(struct shape *shape, double x, double y, double z, int held)
{
	struct hawser_net_node *one = &shape->net.node[shape->net.nodes];

	*one = (struct hawser_net_node){.placed = 1, .x = {x, y, z}, .support = held};
	memset(one->held, held, sizeof one->held);
	return shape->net.nodes++;
}

/* A cable whose unstretched length is a part of its chord. */
static void cable(struct shape *shape, int from, int to, double part, double EA, double rho)
{
	const double *a = shape->net.node[from].x, *b = shape->net.node[to].x;
	struct hawser_net_cable *one = &shape->net.cable[shape->net.cables++];
	double d2 = 0.0;

	for (int k = 0; k < 3; k++)
		d2 += (b[k] - a[k])*(b[k] - a[k]);
	*one = (struct hawser_net_cable){.from = from, .to = to, .EA = EA, .rho = rho,
	                                 .value = part*sqrt(d2), .elements = 1};
	shape->weight += rho*one->value*shape->net.g;
}

static int room(struct shape *shape, int nodes, int cables)
{
	static char title[] = "generated";

	*shape = (struct shape){.net = {.name = title, .g = 9.81}};
	shape->net.node = calloc((size_t)nodes, sizeof *shape->net.node);
	shape->net.cable = calloc((size_t)cables, sizeof *shape->net.cable);
	shape->net.load = calloc((size_t)nodes, sizeof *shape->net.load);
	return !shape->net.node || !shape->net.cable || !shape->net.load;
}

/* A web in a vertical plane: n spokes, and n/3 polygons across them; diameter 0.4 m, silk of 5 um.
 * With `loose`, one thread of seven between spokes is 8 % too long. */
static int web(struct shape *shape, int unknowns, int loose)
{
	int spokes = (int)sqrt(unknowns), rings = spokes/3, hub;
	double EA = 1e10*M_PI*2.5e-6*2.5e-6, rho = 1300.0*M_PI*2.5e-6*2.5e-6;

	if (room(shape, spokes*(rings + 1) + 1, 2*spokes*(rings + 1)))
		return 1;
	hub = node(shape, 0.0, 0.0, 0.0, 0);
	for (int i = 0; i <= rings; i++)
		for (int j = 0; j < spokes; j++) {
			double r = 0.2*(i + 1.0)/(rings + 1.0), angle = 2.0*M_PI*j/spokes;

			node(shape, r*cos(angle), r*sin(angle), 0.0, i == rings);
		}
	for (int i = 0; i <= rings; i++)
		for (int j = 0; j < spokes; j++) {
			int at = 1 + i*spokes + j, inner = i ? at - spokes : hub;
			int next = 1 + i*spokes + (j + 1)%spokes;

			cable(shape, inner, at, 0.97, EA, rho);
			if (i < rings)
				cable(shape, at, next, loose && (i + j)%7 == 0 ? 1.08 : 0.97, EA/10.0, rho/10.0);
		}
	return 0;
}

/* A saddle of 100 m x 100 m, held at its edge: ropes of EA 50 MN every metre for 100 x 100 meshes, with
 * prestress 10^-3; roofing of 0.3 kN/m^2. With `lifted`, wind of 2 kN/m^2 upwards, at which the hanging
 * ropes lose their tension. */
static int roof(struct shape *shape, int unknowns, int lifted)
{
	int n = (int)sqrt(unknowns/3.0) + 2;
	double h = 100.0/(n - 1), EA = 50e6*h, pressure = lifted ? 1.7e3 : -300.0;

	if (room(shape, n*n, 2*n*n))
		return 1;
	for (int i = 0; i < n; i++)
		for (int j = 0; j < n; j++) {
			double x = i*h - 50.0, z = j*h - 50.0;
			int edge = i == 0 || j == 0 || i == n - 1 || j == n - 1;
			int at = node(shape, x, (x*x - z*z)/250.0, z, edge);

			if (edge)
				continue;
			shape->net.load[shape->net.loads++] =
				(struct hawser_net_load){.node = at, .cable = -1, .value = {0.0, pressure*h*h, 0.0}};
			shape->weight += fabs(pressure)*h*h;
		}
	for (int i = 0; i < n; i++)
		for (int j = 0; j < n; j++) {
			if (i < n - 1 && j > 0 && j < n - 1)
				cable(shape, i*n + j, (i + 1)*n + j, 0.999, EA, 3.0*h);
			if (j < n - 1 && i > 0 && i < n - 1)
				cable(shape, i*n + j, i*n + j + 1, 0.999, EA, 3.0*h);
		}
	return 0;
}

struct outcome {
	double secs, gap, residual, MB; /* gap over the energy, residual over the weight */
	int unknowns, iterations, slack, good;
};

static void solve_one(struct outcome *out, int kind, int unknowns, const char *method)
{
	struct hawser_net_options options = {.method = method};
	struct hawser_report report = {0};
	struct hawser_net_statics st;
	struct rusage usage;
	struct shape shape;
	double spent = 0.0;

	memset(out, 0, sizeof *out);
	if (kind < ROOF ? web(&shape, unknowns, kind == LOOSE_WEB) : roof(&shape, unknowns,
	                                                                  kind == LIFTED_ROOF))
		return;
	out->secs = INFINITY;
	for (int i = 0; i == 0 || (spent < 0.3 && i < 20); i++) {
		double began = cpu_secs(), took;

		if (hawser_net_solve(&st, &shape.net, &options, &report)) {
			printf("%s\n", report.message);
			fflush(stdout);
			return;
		}
		took = cpu_secs() - began;
		spent += took;
		out->secs = fmin(out->secs, took);
		out->slack = 0;
		for (int c = 0; c < st.cables; c++)
			out->slack += st.member[c].slack > 0;
		out->unknowns = st.unknowns;
		out->iterations = st.iterations;
		out->gap = st.gap/fabs(st.energy);
		out->residual = st.residual/shape.weight;
		out->good = out->gap <= 1e-9 && st.residual <= fmax(1e-10*shape.weight, st.floor);
		hawser_net_statics_clear(&st);
	}
	getrusage(RUSAGE_SELF, &usage);
	out->MB = (double)usage.ru_maxrss/1024.0;
}

/* In a process of its own, for its memory. */
static int apart(struct outcome *out, int kind, int unknowns, const char *method)
{
	int pipes[2], state = 0;
	pid_t child;
	ssize_t got;

	if (pipe(pipes))
		return 1;
	fflush(stdout);
	child = fork();
	if (child == 0) {
		struct outcome one;

		solve_one(&one, kind, unknowns, method);
		_exit(write(pipes[1], &one, sizeof one) != sizeof one);
	}
	close(pipes[1]);
	got = read(pipes[0], out, sizeof *out);
	close(pipes[0]);
	return child < 0 || waitpid(child, &state, 0) != child || got != sizeof *out;
}

static int sizes(int most, const char *method)
{
	int wrong = 0;

	printf("%-20s %8s %10s %7s %9s %8s %9s %10s\n", "generated net", "unknowns", "iterations", "slack",
	       "s", "MB", "gap", "residual/W");
	for (int kind = 0; kind < KINDS; kind++) {
		double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, n = 0.0;

		for (double size = 1e3; size <= 1.001*most; size *= sqrt(10.0)) {
			struct outcome out;

			if (apart(&out, kind, (int)size, method) || !out.good) {
				printf("%-20s %8.0f WRONG: gap %.1e, residual/W %.1e\n", name[kind], size, out.gap,
				       out.residual);
				wrong = 1;
				continue;
			}
			printf("%-20s %8d %10d %7d %9.4f %8.1f %9.1e %10.1e\n", name[kind], out.unknowns,
			       out.iterations, out.slack, out.secs, out.MB, out.gap, out.residual);
			x += log(out.unknowns);
			y += log(out.secs);
			xx += log(out.unknowns)*log(out.unknowns);
			xy += log(out.unknowns)*log(out.secs);
			n += 1.0;
		}
		if (n > 1.0)
			printf("%-20s time grows with the power %.2f of the unknowns\n", name[kind],
			       (n*xy - x*y)/(n*xx - x*x));
	}
	return wrong;
}

int main(int argc, char **argv)
{
	const char *method = NULL;
	int most = 100000, option, wrong;

	while ((option = getopt(argc, argv, "d:m:")) != -1)
		switch (option) {
		case 'd': most = atoi(optarg); break;
		case 'm': method = optarg; break;
		default:
			fprintf(stderr, "usage: net-statics [-d UNKNOWNS] [-m METHOD]\n");
			return 1;
		}
	wrong = table_3_1();
	wrong |= sizes(most, method);
	return wrong;
}
