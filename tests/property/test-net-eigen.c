/* Modes of meshes against dense matrices that share no code with them: K by differences of the
 * gradient of the energy, M by its own sum, both solved by LAPACK for all modes. Random nets, taut and
 * slack, with joints without mass; rows of equal cables, whose frequencies many modes share.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include "net/modes/eigen.h"
#include "tests/net-random.h"
#include "tests/tap.h"

enum { MOST = 160, COLUMN = 102 /* LAPACK_COL_MAJOR */ };

static struct hawser_report report;

/* K [unknowns][unknowns] at the equilibrium. */
static void differences(double *K, struct hawser__mesh *mesh, double step)
{
	double (*f)[3] = calloc((size_t)mesh->nodes, sizeof *f);

	for (int j = 0; j < 3*mesh->nodes; j++) {
		int u = mesh->unknown[j/3][j%3];

		for (int side = -1; side <= 1 && u >= 0; side += 2) {
			double at = mesh->q[j/3][j%3];

			mesh->q[j/3][j%3] = at + side*step;
			hawser__mesh_gradient(f, NULL, mesh);
			mesh->q[j/3][j%3] = at;
			for (int i = 0; i < 3*mesh->nodes; i++)
				if (mesh->unknown[i/3][i%3] >= 0)
					K[u*mesh->unknowns + mesh->unknown[i/3][i%3]] += side*f[i/3][i%3]/(2.0*step);
		}
	}
	free(f);
}

static void add(double *M, const struct hawser__mesh *mesh, int i, int j, double mass)
{
	for (int k = 0; k < 3; k++)
		if (mesh->unknown[i][k] >= 0 && mesh->unknown[j][k] >= 0)
			M[mesh->unknown[i][k]*mesh->unknowns + mesh->unknown[j][k]] += mass;
}

/* Mean of the consistent (1/3, 1/6) and the lumped (1/2, 0) matrix. */
static void masses(double *M, const struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->nodes; i++)
		add(M, mesh, i, i, mesh->mass[i]);
	for (int e = 0; e < mesh->elements; e++)
		for (int i = 0; i < 4; i++)
			add(M, mesh, mesh->end[e][i/2], mesh->end[e][i%2],
			    mesh->rho[e]*mesh->length0[e]*(i/2 == i%2 ? 1.0/3.0 + 1.0/2.0 : 1.0/6.0)/2.0);
}

/* value [unknowns] 1/omega^2 of all modes, ascending; 0 if K is not positive. */
static int dense(double *value, struct hawser__mesh *mesh, double step)
{
	size_t size = (size_t)mesh->unknowns*(size_t)mesh->unknowns;
	double *K = calloc(size, sizeof *K), *M = calloc(size, sizeof *M);
	int info;

	differences(K, mesh, step);
	masses(M, mesh);
	info = LAPACKE_dsygvd(COLUMN, 1, 'N', 'L', mesh->unknowns, M, mesh->unknowns, K, mesh->unknowns,
	                      value);
	free(K);
	free(M);
	return info == 0;
}

struct tally {
	int nets, slack, refused, wrong, miscounted, uncertain;
	double worst;
};

static void compare(struct tally *tally, const struct hawser_net *net, struct hawser__mesh *mesh,
                    const double *T, double step, int n)
{
	double value[MOST], other[MOST], noise = 0.0;
	struct hawser__eigen eigen;
	int definite = dense(value, mesh, step) && dense(other, mesh, step/2.0);
	int all = mesh->unknowns, rank = 0, below = 0, near = 0;
	enum hawser_status status;

	for (int j = 0; j < mesh->unknowns && definite; j++)
		rank += value[j] > 1e-12*value[mesh->unknowns - 1];
	n = n < rank || !definite ? n : rank;
	status = hawser__eigen_open(&eigen, mesh, T, net, n, &report);

	if (status || !definite) {
		tally->refused += status != HAWSER_OK;
		tally->wrong += !status || (definite && rank > 0);
		hawser__eigen_clear(&eigen);
		return;
	}
	tally->slack += eigen.slack > 0;
	status = hawser__eigen_solve(&eigen, &report);
	tally->wrong += status != HAWSER_OK;
	tally->uncertain += eigen.shift < 0.0;
	for (int j = 0; j < rank; j++) /* of the differences, by two steps */
		noise = fmax(noise, 4.0*fabs(value[all - 1 - j]/other[all - 1 - j] - 1.0));
	for (int j = 0; j < eigen.found && !status; j++)
		tally->worst = fmax(tally->worst, fabs(sqrt(eigen.value[j]*value[all - 1 - j]) - 1.0) -
		                                  eigen.error[j] - noise);
	for (int j = 0; j < mesh->unknowns; j++) {
		below += value[j] > 0.0 && 1.0/value[j] < eigen.shift;
		near += fabs(value[j]*eigen.shift - 1.0) < 1e-4; /* the differences do not tell its side */
	}
	tally->miscounted += !status && !near && eigen.shift > 0.0 && below != eigen.found;
	hawser__eigen_clear(&eigen);
}

/* A step of differences that leaves taut elements taut and slack ones slack. */
static double step_of(const struct hawser__mesh *mesh, double size)
{
	double step = 2e-6*size, d[3];

	for (int e = 0; e < mesh->elements; e++)
		step = fmin(step, 0.2*fabs(hawser__mesh_direction(d, mesh, e) - mesh->length0[e]));
	return step;
}

static void one(struct tally *tally, const struct hawser_net *net, double size, int n)
{
	struct hawser__mesh mesh;
	struct hawser__equilibrium found;
	struct hawser__mesh_options options = {.tolerance = 0.0};
	double T[3*MOST];

	if (hawser__mesh_build(&mesh, net, &report))
		return;
	if (mesh.unknowns <= MOST && mesh.unknowns > 0 && mesh.elements <= 3*MOST &&
	    !hawser__mesh_statics(&mesh, T, &found, &options, &report) &&
	    step_of(&mesh, size) > 1e-7*size) {
		tally->nets++;
		compare(tally, net, &mesh, T, step_of(&mesh, size), n);
	}
	hawser__mesh_clear(&mesh);
}

/* Random nets of moderate stiffness, for the sake of the differences. */
static void random_nets(int count)
{
	struct tally tally = {0};
	struct random_net *r = malloc(sizeof *r);
	uint64_t state = 2385;

	while (tally.nets < count) {
		random_net(r, &state, uniform(&state) < 0.5 ? HEAVY : SOME_LIGHT);
		for (int i = 0; i < r->net.cables; i++) {
			r->cable[i].elements = 1 + (int)(3.0*uniform(&state));
			r->cable[i].EA = r->weight*pow(10.0, 1.0 + 2.0*uniform(&state));
		}
		one(&tally, &r->net, r->size, 1 + (int)(12.0*uniform(&state)));
	}
	free(r);
	ok(tally.wrong == 0 && tally.worst < 1e-6, "%d random nets: omega within %.1e of dense matrices",
	   tally.nets, tally.worst);
	ok(tally.miscounted == 0 && tally.uncertain == 0, "the count of modes below the shift is right");
	ok(tally.slack > 0 && tally.refused > 0, "%d with slack elements; %d refused, as their matrices "
	   "are singular", tally.slack, tally.refused);
}

/* `count` equal strings of 4 elements side by side: 2*count modes of each frequency. */
static void strings(int count, int n)
{
	struct random_net *r = calloc(1, sizeof *r);
	struct tally tally = {0};

	r->net = (struct hawser_net){.name = r->node[0].name, .g = 0.0, .node = r->node, .cable = r->cable,
	                             .nodes = 2, .cables = count};
	for (int i = 0; i < 2; i++)
		r->node[i] = (struct hawser_net_node){.placed = 1, .x = {10.0*i, 0.0, 0.0}, .support = 1,
		                                      .held = {1, 1, 1}};
	for (int i = 0; i < count; i++)
		r->cable[i] = (struct hawser_net_cable){.from = 0, .to = 1, .EA = 1e4, .rho = 0.7, .value = 9.5,
		                                        .elements = 4};
	one(&tally, &r->net, 10.0, n);
	free(r);
	ok(tally.nets == 1 && tally.wrong == 0 && tally.miscounted == 0 && tally.uncertain == 0 &&
	   tally.worst < 1e-7, "%d equal strings, %d modes: none is missed", count, n);
}

/* Squares of the frequencies across the plane of a chain in a plane, 1/omega^2, ascending: [n] and room
 * for the matrices of T/l and of the mean mass. */
static int across(double *value, const struct hawser__mesh *mesh, const double *T)
{
	int n = mesh->elements - 1;
	double *K = calloc((size_t)(2*n*n), sizeof *K), *M = K + n*n, d[3];
	int info;

	for (int e = 0; e <= n; e++) {
		double k = T[e]/hawser__mesh_direction(d, mesh, e), m = mesh->rho[e]*mesh->length0[e];

		for (int i = e - 1; i <= e; i++)
			for (int j = e - 1; j <= e; j++)
				if (i >= 0 && j >= 0 && i < n && j < n) {
					K[i*n + j] += i == j ? k : -k;
					M[i*n + j] += m*(i == j ? 5.0 : 1.0)/12.0;
				}
	}
	info = LAPACKE_dsygvd(COLUMN, 1, 'N', 'L', n, M, n, K, n, value);
	free(K);
	return info == 0;
}

/* EA is 1e8 times the tension, and the modes that are asked for reach the axial ones: a Lanczos basis
 * is exhausted before (of 5 elements it never came to an end). */
static void stiff(int elements, int n, double wanted)
{
	static char name[] = "stiff";
	struct hawser_net_node node[2] = {
		{.name = "A", .placed = 1, .held = {1, 1, 1}, .support = 1},
		{.name = "B", .placed = 1, .x = {1.65, 0.0, 0.0}, .held = {1, 1, 1}, .support = 1}};
	struct hawser_net_cable cable = {.name = "c", .to = 1, .EA = 40e6, .rho = 0.0022, .value = 1.656,
	                                 .elements = elements};
	struct hawser_net net = {.name = name, .g = 9.81, .node = node, .cable = &cable, .nodes = 2,
	                         .cables = 1};
	struct hawser__mesh mesh;
	struct hawser__equilibrium found;
	struct hawser__eigen eigen = {0};
	double T[MOST], value[MOST], worst = 0.0;
	int all = 0, good = !hawser__mesh_build(&mesh, &net, &report) &&
	                    !hawser__mesh_statics(&mesh, T, &found, NULL, &report) &&
	                    across(value, &mesh, T) &&
	                    !hawser__eigen_open(&eigen, &mesh, T, &net, n, &report) &&
	                    !hawser__eigen_solve(&eigen, &report);

	for (int i = elements - 2; i >= 0 && good; i--) {
		double nearest = INFINITY;

		if (1.0/value[i] > eigen.value[eigen.found - 1])
			continue;
		for (int j = 0; j < eigen.found; j++)
			nearest = fmin(nearest, fabs(sqrt(eigen.value[j]*value[i]) - 1.0) - eigen.error[j]);
		worst = fmax(worst, nearest);
		all++;
	}
	ok(good && all > 0 && worst < wanted, "%d elements, %d modes (%s): %d across the plane are among "
	   "them to %.1e", elements, n, eigen.dense ? "dense" : "Lanczos", all, worst);
	hawser__eigen_clear(&eigen);
	hawser__mesh_clear(&mesh);
}

CASE(property_net_eigen)
{
	stiff(5, 7, 1e-9);
	stiff(5, 12, 1e-9);
	stiff(19, 39, 1e-8);
	stiff(30, 58, 1e-8);
	stiff(30, 87, 1e-8);
	random_nets(getenv("HAWSER_LONG") ? 3000 : 100);
	strings(13, 1);
	strings(13, 30);
	strings(9, 81);
	return done_testing();
}
