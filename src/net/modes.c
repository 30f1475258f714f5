/* net/modes.c - modes of a mesh by subspace iteration: see hawser/net_modes.h.
 *
 * K   tangent at the equilibrium, factored once by CHOLMOD
 * X   [vectors][unknowns] a basis; each iteration solves K*Y = M*X, projects K and M on Y
 *     (Rayleigh-Ritz) and takes the Ritz vectors as the next X
 *
 * With twice as many vectors as modes the error of a cable's frequency falls by some 16 in each
 * iteration. Modes of equal frequency, as in the two planes of a taut cable, cost nothing more.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include <hawser/net_modes.h>

#include "core/report.h"
#include "net/net.h"

enum { MOST = 200, EXTRA = 8, DEFAULT = 6, COLUMN = 102 /* LAPACK_COL_MAJOR */ };
/* Relative change of an eigenvalue at which it is taken as found. */
static const double found = 1e-13;

struct work {
	const struct hawser__mesh *mesh;
	struct hawser__sparse *sparse;
	int n, vectors, unknowns;
	double *x, *y, *mx, *my; /* [vectors][unknowns] */
	double *k, *m;           /* [vectors][vectors] */
	double *value, *last;    /* [vectors] */
	double *T;               /* [elements] */
	int iterations;
};

void hawser_net_modes_clear(struct hawser_net_modes *modes)
{
	if (!modes)
		return;
	free(modes->omega);
	free(modes->mass);
	free(modes->share);
	free(modes->residual);
	free(modes->shape);
	free(modes->point);
	free(modes->cable);
	free(modes->S);
	memset(modes, 0, sizeof *modes);
}

/* y = M*x, of the directions in `along` only (bit k: direction k). */
static void mass(double *y, const double *x, const struct hawser__mesh *mesh, unsigned along)
{
	memset(y, 0, (size_t)mesh->unknowns*sizeof *y);
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0 && along & (1U << k))
				y[mesh->unknown[i][k]] += mesh->mass[i]*x[mesh->unknown[i][k]];
	for (int e = 0; e < mesh->elements; e++) {
		double m = mesh->rho[e]*mesh->length0[e]/12.0;
		const int *a = mesh->unknown[mesh->end[e][0]], *b = mesh->unknown[mesh->end[e][1]];

		for (int k = 0; k < 3; k++) {
			double xa = a[k] >= 0 ? x[a[k]] : 0.0, xb = b[k] >= 0 ? x[b[k]] : 0.0;

			if (a[k] >= 0 && along & (1U << k))
				y[a[k]] += m*(5.0*xa + xb);
			if (b[k] >= 0 && along & (1U << k))
				y[b[k]] += m*(5.0*xb + xa);
		}
	}
}

static double dot(const double *a, const double *b, int n)
{
	double sum = 0.0;

	for (int i = 0; i < n; i++)
		sum += a[i]*b[i];
	return sum;
}

static enum hawser_status stiffness(struct work *work, const struct hawser_net *net,
                                    struct hawser_report *report)
{
	const struct hawser__mesh *mesh = work->mesh;
	enum hawser_status status = hawser__sparse_open(&work->sparse, mesh, report);
	int definite = 0;

	for (int e = 0; e < mesh->elements && !status; e++) {
		double d[3], l = hawser__mesh_direction(d, mesh, e), k = mesh->EA[e]/mesh->length0[e];

		if (work->T[e] <= 0.0)
			return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: cable %s is slack in the "
			                    "equilibrium, so that there are no modes about it: shorten the cable, "
			                    "load it, or leave it out", net->name,
			                    net->cable[mesh->cable[e]].name);
		hawser__sparse_add(work->sparse, e, work->T[e]/l, k - work->T[e]/l, d);
	}
	if (!status)
		status = hawser__sparse_factor(work->sparse, &definite, report);
	if (!status && !definite)
		status = hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: the stiffness of the net is "
		                      "not positive to double precision: a part of it has next to no tension",
		                      net->name);
	return status;
}

/* x of a generator of random numbers, the same in each run. */
static void begin(struct work *work)
{
	unsigned long long seed = 88172645463325252ULL;

	for (size_t i = 0; i < (size_t)work->vectors*(size_t)work->unknowns; i++) {
		seed ^= seed << 13;
		seed ^= seed >> 7;
		seed ^= seed << 17;
		work->x[i] = (double)(seed >> 11)/9007199254740992.0 - 0.5;
	}
}

static enum hawser_status project(struct work *work, struct hawser_report *report)
{
	int n = work->unknowns, q = work->vectors, info;

	for (int i = 0; i < q; i++) {
		double *y = work->y + (size_t)i*(size_t)n, scale;
		enum hawser_status status;

		memcpy(y, work->mx + (size_t)i*(size_t)n, (size_t)n*sizeof *y);
		status = hawser__sparse_solve(y, work->sparse, report);
		if (status)
			return status;
		mass(work->my + (size_t)i*(size_t)n, y, work->mesh, 7U);
		scale = 1.0/sqrt(dot(y, work->my + (size_t)i*(size_t)n, n));
		for (int r = 0; r < n; r++) {
			y[r] *= scale;
			work->my[(size_t)i*(size_t)n + (size_t)r] *= scale;
			work->mx[(size_t)i*(size_t)n + (size_t)r] *= scale; /* K*y */
		}
	}
	for (int i = 0; i < q; i++)
		for (int j = 0; j <= i; j++) {
			const double *y = work->y + (size_t)i*(size_t)n;

			work->k[j*q + i] = dot(y, work->mx + (size_t)j*(size_t)n, n);
			work->m[j*q + i] = dot(y, work->my + (size_t)j*(size_t)n, n);
		}
	/* lower triangles by columns; the vectors come back in k */
	info = LAPACKE_dsygvd(COLUMN, 1, 'V', 'L', q, work->k, q, work->m, q, work->value);
	if (hawser__lapack_starved(info))
		return hawser__no_memory(report, "net");
	return info == 0 ? HAWSER_OK
		: hawser__fail(report, HAWSER_ERR_CONVERGENCE, "net", "the modes cannot be told apart to "
		               "double precision: ask for fewer than %d", work->n);
}

/* out = y*k, the Ritz vectors. */
static void combine(double *out, const double *y, const struct work *work)
{
	int n = work->unknowns, q = work->vectors;

	memset(out, 0, (size_t)q*(size_t)n*sizeof *out);
	for (int j = 0; j < q; j++)
		for (int i = 0; i < q; i++)
			for (int r = 0; r < n; r++)
				out[(size_t)j*(size_t)n + (size_t)r] += work->k[j*q + i]*
				                                        y[(size_t)i*(size_t)n + (size_t)r];
}

static enum hawser_status iterate(struct work *work, struct hawser_report *report)
{
	size_t size = (size_t)work->vectors*(size_t)work->unknowns;

	begin(work);
	for (int i = 0; i < work->vectors; i++)
		mass(work->mx + (size_t)i*(size_t)work->unknowns, work->x + (size_t)i*(size_t)work->unknowns,
		     work->mesh, 7U);
	for (work->iterations = 1; work->iterations <= MOST; work->iterations++) {
		double worst = 0.0;
		enum hawser_status status = project(work, report);

		if (status)
			return status;
		combine(work->x, work->y, work);
		combine(work->mx, work->my, work);
		for (int i = 0; i < work->n; i++)
			worst = fmax(worst, fabs(work->value[i] - work->last[i])/work->value[i]);
		memcpy(work->last, work->value, (size_t)work->vectors*sizeof *work->last);
		if (worst <= found || size == 0)
			return HAWSER_OK;
	}
	return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "net", "the modes were not found in %d "
	                    "iterations: ask for more or fewer than %d", MOST, work->n);
}

static enum hawser_status allocate(struct work *work, struct hawser_net_modes *modes,
                                   struct hawser_report *report)
{
	const struct hawser__mesh *mesh = work->mesh;
	size_t q = (size_t)work->vectors, all = q*(size_t)work->unknowns, n = (size_t)work->n,
	       points = (size_t)mesh->elements + (size_t)mesh->cables;

	work->x = calloc(all, sizeof *work->x);
	work->y = calloc(all, sizeof *work->y);
	work->mx = calloc(all, sizeof *work->mx);
	work->my = calloc(all, sizeof *work->my);
	work->k = calloc(q*q, sizeof *work->k);
	work->m = calloc(q*q, sizeof *work->m);
	work->value = calloc(q, sizeof *work->value);
	work->last = calloc(q, sizeof *work->last);
	modes->omega = calloc(n, sizeof *modes->omega);
	modes->mass = calloc(n, sizeof *modes->mass);
	modes->share = calloc(n, sizeof *modes->share);
	modes->residual = calloc(n, sizeof *modes->residual);
	modes->shape = calloc(n*(size_t)modes->nodes + 1, sizeof *modes->shape);
	modes->point = calloc(n*points + 1, sizeof *modes->point);
	modes->cable = calloc(points + 1, sizeof *modes->cable);
	modes->S = calloc(points + 1, sizeof *modes->S);
	return work->x && work->y && work->mx && work->my && work->k && work->m && work->value &&
	       work->last && modes->omega && modes->mass && modes->share && modes->residual &&
	       modes->shape && modes->point && modes->cable && modes->S
		? HAWSER_OK : hawser__no_memory(report, "net");
}

/* Displacement of a node of the mesh. */
static void place(double x[3], const double *phi, const struct hawser__mesh *mesh, int node)
{
	for (int k = 0; k < 3; k++)
		x[k] = mesh->unknown[node][k] >= 0 ? phi[mesh->unknown[node][k]] : 0.0;
}

/* Scale a vector so that the largest displacement of a node is 1, its largest component positive. */
static void scale(double *phi, const struct hawser__mesh *mesh)
{
	double most = 0.0, sign = 1.0, x[3];

	for (int i = 0; i < mesh->nodes; i++) {
		double length;

		place(x, phi, mesh, i);
		length = sqrt(x[0]*x[0] + x[1]*x[1] + x[2]*x[2]);
		if (length > most*(1.0 + 1e-6)) {
			int k = fabs(x[1]) > fabs(x[0]) ? 1 : 0;

			most = length;
			k = fabs(x[2]) > fabs(x[k]) ? 2 : k;
			sign = x[k] < 0.0 ? -1.0 : 1.0;
		}
	}
	for (int i = 0; i < mesh->unknowns; i++)
		phi[i] *= sign/most;
}

/* K*phi, by elements. */
static void push(double *f, const double *phi, const struct work *work)
{
	const struct hawser__mesh *mesh = work->mesh;

	memset(f, 0, (size_t)mesh->unknowns*sizeof *f);
	for (int e = 0; e < mesh->elements; e++) {
		double d[3], a[3], b[3], l = hawser__mesh_direction(d, mesh, e), along = 0.0;
		double t = work->T[e]/l, k = mesh->EA[e]/mesh->length0[e];

		place(a, phi, mesh, mesh->end[e][0]);
		place(b, phi, mesh, mesh->end[e][1]);
		for (int i = 0; i < 3; i++)
			along += d[i]*(b[i] - a[i]);
		for (int i = 0; i < 3; i++) {
			double force = t*(b[i] - a[i]) + (k - t)*along*d[i];
			int from = mesh->unknown[mesh->end[e][0]][i], to = mesh->unknown[mesh->end[e][1]][i];

			if (from >= 0)
				f[from] -= force;
			if (to >= 0)
				f[to] += force;
		}
	}
}

static void fill(struct hawser_net_modes *modes, struct work *work, int j)
{
	const struct hawser__mesh *mesh = work->mesh;
	double *phi = work->x + (size_t)j*(size_t)work->unknowns, *y = work->my, *f = work->y;
	double omega2 = work->value[j], most = 0.0, off = 0.0;
	int p = 0;

	scale(phi, mesh);
	mass(y, phi, mesh, 7U);
	push(f, phi, work);
	for (int i = 0; i < work->unknowns; i++) {
		most = fmax(most, fabs(f[i]));
		off = fmax(off, fabs(f[i] - omega2*y[i]));
	}
	modes->residual[j] = off/most;
	modes->omega[j] = sqrt(omega2);
	modes->mass[j] = dot(phi, y, work->unknowns);
	for (int k = 0; k < 3; k++) {
		mass(y, phi, mesh, 1U << k);
		modes->share[j][k] = dot(phi, y, work->unknowns)/modes->mass[j];
	}
	for (int i = 0; i < modes->nodes; i++)
		place(modes->shape[j*modes->nodes + i], phi, mesh, i);
	for (int c = 0; c < mesh->cables; c++) {
		double S = 0.0;

		for (int e = mesh->first[c]; e <= mesh->first[c + 1]; e++, p++) {
			int last = e == mesh->first[c + 1];

			place(modes->point[(size_t)j*(size_t)modes->points + (size_t)p], phi, mesh,
			      mesh->end[last ? e - 1 : e][last]);
			modes->cable[p] = c;
			modes->S[p] = S;
			S += last ? 0.0 : mesh->length0[e];
		}
	}
}

static enum hawser_status solve(struct hawser_net_modes *modes, struct work *work,
                                struct hawser__mesh *mesh, const struct hawser_net *net,
                                struct hawser_report *report)
{
	struct hawser__equilibrium equilibrium;
	struct hawser__mesh_options settings = {0};
	enum hawser_status status = hawser__mesh_form(mesh, work->T, &equilibrium, net, &settings, report);

	if (!status)
		status = stiffness(work, net, report);
	modes->points = mesh->elements + mesh->cables;
	if (!status)
		status = allocate(work, modes, report);
	if (!status)
		status = iterate(work, report);
	for (int j = 0; j < work->n && !status; j++)
		fill(modes, work, j);
	return status;
}

static void clear(struct work *work)
{
	hawser__sparse_clear(work->sparse);
	free(work->x);
	free(work->y);
	free(work->mx);
	free(work->my);
	free(work->k);
	free(work->m);
	free(work->value);
	free(work->last);
	free(work->T);
}

enum hawser_status hawser_net_modes_solve(struct hawser_net_modes *modes, const struct hawser_net *net,
                                          int n, struct hawser_report *report)
{
	struct hawser__mesh mesh = {0};
	struct work work = {.mesh = &mesh, .n = n};
	enum hawser_status status;

	memset(modes, 0, sizeof *modes);
	status = hawser__mesh_build(&mesh, net, report);
	if (n == 0)
		work.n = n = mesh.unknowns < DEFAULT ? mesh.unknowns : DEFAULT;
	if (!status && (n < 1 || n > mesh.unknowns))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: the mesh has %d unknowns: ask "
		                      "for 1 to %d modes, not %d", net->name, mesh.unknowns, mesh.unknowns, n);
	work.unknowns = mesh.unknowns;
	work.vectors = 2*n > n + EXTRA ? 2*n : n + EXTRA;
	work.vectors = work.vectors < mesh.unknowns ? work.vectors : mesh.unknowns;
	*modes = (struct hawser_net_modes){.n = n, .nodes = net->nodes, .unknowns = mesh.unknowns};
	if (!status && !(work.T = calloc((size_t)mesh.elements, sizeof *work.T)))
		status = hawser__no_memory(report, "net");
	if (!status)
		status = solve(modes, &work, &mesh, net, report);
	modes->iterations = work.iterations;
	clear(&work);
	hawser__mesh_clear(&mesh);
	if (status)
		hawser_net_modes_clear(modes);
	return status;
}
