/* net/statics/equilibria.c - the equilibria of a few bars, which also carry compression.
 *
 * Bar between two nodes, d = q_b - q_a, l = |d|, e = d/l: T = EA*(l/length0 - 1), force T*e, tangent
 * stiffness (EA/length0)*e*e' + (T/l)*(I - e*e'). The last part is negative under compression, so that
 * the sum may be indefinite: the factors are those of Bunch and Kaufman (LAPACK dsysv), and Newton's
 * method goes to saddles as well as to minima. A step is at most a tenth of the size of the net.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include <hawser/net_equilibria.h>

#include "core/report.h"
#include "net/body.h"
#include "net/statics/solve.h"

enum { STARTS = 2000, MOST = 200, BLOCK = 64, ROOM = 64 };
#define SAME 1e-6     /* places that are as near, over the size, are one */
#define SINGULAR 1e-9 /* least eigenvalue, over the largest one */

struct search {
	struct hawser__mesh mesh;
	int n, work_size;
	double size, middle[3]; /* m: of the box of the starts */
	double load;            /* N: sum of the absolute forces on the nodes */
	double *K;              /* [n][n] */
	double *r, *step, *value, *work; /* [n], [n], [n], [work_size] */
	double *T;              /* [elements] */
	lapack_int *pivot;      /* [n] */
	double (*kept)[3];      /* [count][nodes of the mesh] places of the equilibria found */
	int room;
	uint64_t state;
};

/* Uniform in -1..1: the same numbers on every machine. */
static double uniform(uint64_t *state)
{
	*state = *state*6364136223846793005u + 1442695040888963407u;
	return (double)(*state >> 11)/4503599627370496.0 - 1.0;
}

static void add_bar(struct search *s, const int at[2][3], const double e[3], double along,
                    double across)
{
	for (int i = 0; i < 2; i++)
		for (int j = 0; j < 2; j++)
			for (int k = 0; k < 3; k++)
				for (int m = 0; m < 3; m++) {
					double value = (along - across)*e[k]*e[m] + (k == m ? across : 0.0);

					if (at[i][k] >= 0 && at[j][m] >= 0)
						s->K[at[i][k]*s->n + at[j][m]] += i == j ? value : -value;
				}
}

/* K and r, minus the gradient of the energy, at mesh->q; returns the energy, or NaN if a bar has no
 * length. */
static double assemble(struct search *s)
{
	const struct hawser__mesh *mesh = &s->mesh;
	double energy = 0.0;

	memset(s->K, 0, (size_t)s->n*(size_t)s->n*sizeof *s->K);
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++) {
			energy -= mesh->force[i][k]*mesh->q[i][k];
			if (mesh->unknown[i][k] >= 0)
				s->r[mesh->unknown[i][k]] = mesh->force[i][k];
		}
	for (int i = 0; i < mesh->elements; i++) {
		const int *end = mesh->end[i];
		int at[2][3];
		double e[3], l = hawser__mesh_direction(e, mesh, i), k = mesh->EA[i]/mesh->length0[i];

		if (!(l > 0.0))
			return NAN;
		s->T[i] = k*(l - mesh->length0[i]);
		energy += k*(l - mesh->length0[i])*(l - mesh->length0[i])/2.0;
		memcpy(at[0], mesh->unknown[end[0]], sizeof at[0]);
		memcpy(at[1], mesh->unknown[end[1]], sizeof at[1]);
		for (int c = 0; c < 3; c++) {
			if (at[0][c] >= 0)
				s->r[at[0][c]] += s->T[i]*e[c];
			if (at[1][c] >= 0)
				s->r[at[1][c]] -= s->T[i]*e[c];
		}
		add_bar(s, at, e, k, s->T[i]/l);
	}
	return energy;
}

static double largest(const double *x, int n)
{
	double most = 0.0;

	for (int i = 0; i < n; i++)
		if (!(fabs(x[i]) <= most))
			most = fabs(x[i]);
	return most;
}

static void random_places(struct search *s)
{
	struct hawser__mesh *mesh = &s->mesh;

	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0)
				mesh->q[i][k] = s->middle[k] + s->size*uniform(&s->state);
}

/* Places in balance with random force densities of both signs, from the density that carries the load
 * to EA/length0: folded and crossing bars, which random places rarely lead to. */
static void random_densities(struct search *s)
{
	static const double any[3] = {1.0, 0.0, 0.0};
	struct hawser__mesh *mesh = &s->mesh;
	int n = s->n;

	memset(s->K, 0, (size_t)n*(size_t)n*sizeof *s->K);
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0)
				s->step[mesh->unknown[i][k]] = mesh->force[i][k];
	for (int i = 0; i < mesh->elements; i++) {
		double most = mesh->EA[i]/mesh->length0[i], least = fmin(0.1*s->load/s->size, 0.1*most);
		double sign = uniform(&s->state) < 0.0 ? -1.0 : 1.0;
		double density = sign*least*pow(most/least, 0.5 + 0.5*uniform(&s->state));
		int at[2][3];

		for (int end = 0; end < 2; end++) {
			const int *unknown = mesh->unknown[mesh->end[i][end]];
			const int *other = mesh->unknown[mesh->end[i][1 - end]];
			const double *x = mesh->q[mesh->end[i][1 - end]];

			memcpy(at[end], unknown, sizeof at[end]);
			for (int k = 0; k < 3; k++)
				if (unknown[k] >= 0 && other[k] < 0)
					s->step[unknown[k]] += density*x[k];
		}
		add_bar(s, (const int (*)[3])at, any, density, density);
	}
	if (LAPACKE_dsysv_work(LAPACK_COL_MAJOR, 'U', n, 1, s->K, n, s->pivot, s->step, n, s->work,
	                       s->work_size))
		return;
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0)
				mesh->q[i][k] = s->step[mesh->unknown[i][k]];
}

/* One run of Newton's method; returns 1 if it converged. */
static int newton(struct search *s, double *energy)
{
	struct hawser__mesh *mesh = &s->mesh;
	int n = s->n;

	for (int it = 0; it < MOST; it++) {
		double residual, most;

		*energy = assemble(s);
		residual = largest(s->r, n);
		if (!isfinite(*energy) || !isfinite(residual))
			return 0;
		if (residual <= hawser__mesh_floor(mesh))
			return 1;
		memcpy(s->step, s->r, (size_t)n*sizeof *s->step);
		if (LAPACKE_dsysv_work(LAPACK_COL_MAJOR, 'U', n, 1, s->K, n, s->pivot, s->step, n, s->work,
		                       s->work_size))
			return 0;
		most = largest(s->step, n);
		if (!isfinite(most))
			return 0;
		for (int i = 0; i < mesh->nodes; i++)
			for (int k = 0; k < 3; k++)
				if (mesh->unknown[i][k] >= 0)
					mesh->q[i][k] += s->step[mesh->unknown[i][k]]*fmin(1.0, 0.1*s->size/most);
	}
	return 0;
}

/* 1 if this place is in the list. */
static int known(const struct search *s, int count)
{
	const struct hawser__mesh *mesh = &s->mesh;

	for (int j = 0; j < count; j++) {
		const double (*x)[3] = s->kept + (size_t)j*(size_t)mesh->nodes;
		double most = 0.0;

		for (int i = 0; i < mesh->nodes; i++)
			for (int k = 0; k < 3; k++)
				most = fmax(most, fabs(x[i][k] - mesh->q[i][k]));
		if (most <= SAME*s->size)
			return 1;
	}
	return 0;
}

static enum hawser_status grow(struct hawser_net_equilibria *found, struct search *s,
                               struct hawser_report *report)
{
	size_t room = (size_t)s->room + ROOM, nodes = (size_t)s->mesh.nodes;
	void *list = realloc(found->list, room*sizeof *found->list);
	void *kept = list ? realloc(s->kept, room*nodes*sizeof *s->kept) : NULL;

	if (list)
		found->list = list;
	if (kept)
		s->kept = kept;
	if (!list || !kept)
		return hawser__no_memory(report, "net");
	s->room = (int)room;
	return HAWSER_OK;
}

/* Put the equilibrium at mesh->q into the list, unless its tangent stiffness is singular. */
static enum hawser_status keep(struct hawser_net_equilibria *found, struct search *s, double energy,
                               struct hawser_report *report)
{
	const struct hawser__mesh *mesh = &s->mesh;
	struct hawser_net_equilibrium one = {.energy = energy, .residual = largest(s->r, s->n)};
	enum hawser_status status = found->count == s->room ? grow(found, s, report) : HAWSER_OK;
	double scale;

	if (status)
		return status;
	if (LAPACKE_dsyev_work(LAPACK_COL_MAJOR, 'N', 'U', s->n, s->K, s->n, s->value, s->work,
	                       s->work_size))
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "net",
		                    "LAPACK found no eigenvalues of the tangent stiffness");
	scale = fmax(fabs(s->value[0]), fabs(s->value[s->n - 1]));
	for (int i = 0; i < s->n; i++) {
		one.unstable += s->value[i] < 0.0;
		if (fabs(s->value[i]) <= SINGULAR*scale) {
			found->degenerate++;
			return HAWSER_OK;
		}
	}
	one.stiffness = s->value[0];
	one.T_min = INFINITY;
	one.T_max = -INFINITY;
	for (int i = 0; i < mesh->elements; i++) {
		one.T_min = fmin(one.T_min, s->T[i]);
		one.T_max = fmax(one.T_max, s->T[i]);
		one.compressed += s->T[i] < 0.0;
	}
	one.x = malloc((size_t)found->nodes*sizeof *one.x);
	if (!one.x)
		return hawser__no_memory(report, "net");
	memcpy(one.x, mesh->q, (size_t)found->nodes*sizeof *one.x);
	memcpy(s->kept + (size_t)found->count*(size_t)mesh->nodes, mesh->q,
	       (size_t)mesh->nodes*sizeof *s->kept);
	found->list[found->count++] = one;
	found->last = found->starts;
	return HAWSER_OK;
}

static int by_energy(const void *a, const void *b)
{
	const struct hawser_net_equilibrium *left = a, *right = b;

	if (left->energy != right->energy)
		return left->energy < right->energy ? -1 : 1;
	for (int i = 0; i < 3; i++)
		if (left->x[0][i] != right->x[0][i])
			return left->x[0][i] < right->x[0][i] ? -1 : 1;
	return 0;
}

/* Starts lie in a box about the nodes in the equilibrium of the cables, that the bars can reach. */
static void box(struct search *s)
{
	const struct hawser__mesh *mesh = &s->mesh;
	double low[3], high[3], length = 0.0;

	for (int k = 0; k < 3; k++) {
		low[k] = high[k] = mesh->q[0][k];
		for (int i = 1; i < mesh->nodes; i++) {
			low[k] = fmin(low[k], mesh->q[i][k]);
			high[k] = fmax(high[k], mesh->q[i][k]);
		}
		s->middle[k] = (low[k] + high[k])/2.0;
		s->size = fmax(s->size, high[k] - low[k]);
	}
	for (int i = 0; i < mesh->elements; i++)
		length = fmax(length, mesh->length0[i]);
	s->size = fmax(s->size, length);
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			s->load += mesh->unknown[i][k] >= 0 ? fabs(mesh->force[i][k]) : 0.0;
	if (!(s->load > 0.0))
		for (int i = 0; i < mesh->elements; i++)
			s->load = fmax(s->load, 1e-3*mesh->EA[i]);
}

static enum hawser_status open_search(struct search *s, const struct hawser_net *net,
                                      struct hawser_report *report)
{
	struct hawser__equilibrium cables;
	struct hawser__mesh *mesh = &s->mesh;
	enum hawser_status status = hawser__mesh_lawless(net, "the search of several equilibria", report);
	size_t n;

	if (!status)
		status = hawser__bodies_none(net, "the search of several equilibria", report);
	if (!status)
		status = hawser__mesh_build(mesh, net, report);
	if (!status)
		status = hawser__net_supported(mesh, net, report);
	if (status)
		return status;
	if (mesh->unknowns < 1 || mesh->unknowns > HAWSER_NET_EQUILIBRIA_UNKNOWNS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net",
		                    "%s: equilibria of bars: the mesh has %d unknowns, and the search "
		                    "takes 1 to %d; give each cable fewer `elements` (1: one bar)", net->name,
		                    mesh->unknowns, HAWSER_NET_EQUILIBRIA_UNKNOWNS);
	s->n = mesh->unknowns;
	s->work_size = BLOCK*s->n;
	n = (size_t)s->n;
	s->K = malloc(n*n*sizeof *s->K);
	s->r = malloc(n*sizeof *s->r);
	s->step = malloc(n*sizeof *s->step);
	s->value = malloc(n*sizeof *s->value);
	s->work = malloc((size_t)s->work_size*sizeof *s->work);
	s->T = malloc((size_t)mesh->elements*sizeof *s->T);
	s->pivot = malloc(n*sizeof *s->pivot);
	if (!s->K || !s->r || !s->step || !s->value || !s->work || !s->T || !s->pivot)
		return hawser__no_memory(report, "net");
	/* also finds the lengths where they are not given */
	status = hawser__mesh_form(mesh, s->T, &cables, net, &(struct hawser__mesh_options){0}, report);
	if (!status)
		box(s);
	return status;
}

static void close_search(struct search *s)
{
	hawser__mesh_clear(&s->mesh);
	free(s->K);
	free(s->r);
	free(s->step);
	free(s->value);
	free(s->work);
	free(s->T);
	free(s->pivot);
	free(s->kept);
}

enum hawser_status hawser_net_equilibria_find(struct hawser_net_equilibria *found,
                                              const struct hawser_net *net,
                                              const struct hawser_net_equilibria_options *options,
                                              struct hawser_report *report)
{
	int most = options && options->starts > 0 ? options->starts : STARTS;
	struct search s = {.state = options && options->seed ? options->seed : 1};
	enum hawser_status status;

	memset(found, 0, sizeof *found);
	status = hawser__touch_none(net, "hawser statics --equilibria", report);
	if (!status)
		status = open_search(&s, net, report);
	found->nodes = net->nodes;
	found->bars = s.mesh.elements;
	found->unknowns = s.n;
	while (!status && found->starts < most) {
		double energy;

		found->starts++;
		if (found->starts % 2)
			random_places(&s);
		else
			random_densities(&s);
		if (!newton(&s, &energy))
			found->failed++;
		else if (!known(&s, found->count))
			status = keep(found, &s, energy, report);
	}
	close_search(&s);
	if (status)
		hawser_net_equilibria_clear(found);
	else if (found->count > 1)
		qsort(found->list, (size_t)found->count, sizeof *found->list, by_energy);
	return status;
}

void hawser_net_equilibria_clear(struct hawser_net_equilibria *found)
{
	if (!found)
		return;
	for (int i = 0; i < found->count; i++)
		free(found->list[i].x);
	free(found->list);
	memset(found, 0, sizeof *found);
}
