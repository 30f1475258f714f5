/* net/statics/statics.c - equilibrium of a mesh: start, methods, and the certificate.
 *
 * Pi   energy, convex in the positions for any graph: no local minima
 * n    a force vector for each element, in equilibrium with the loads
 *
 * The start gives every element a force density: one linear problem, from which the positions
 * follow without any guess of a shape. The certificate is Fenchel's inequality: for any n in
 * equilibrium, Pi(q) - least Pi <= sum of W(d) + W*(n) - n.d, with W*(n) = length0*|n| +
 * length0*|n|^2/(2 EA). Such an n is the true force of each element plus the linear answer to what
 * is not balanced. For a taut element the term is length0/(2 EA)*(|n| - T)^2 + (|n|*l - n.d), for
 * a slack one length0/(2 EA)*|n|^2 + |n|*(length0 - l) + (|n|*l - n.d): sums of positive numbers,
 * without cancellation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/motion/motion.h"
#include "net/statics/solve.h"
#include "net/touch/touch.h"
#include "net/water/water.h"

static const struct hawser__net_method methods[] = {
	{{"automatic", "Newton's method for positions and forces with slack members, from exact catenaries "
	  "or force densities, and where it fails the methods cone and forces", "this program"},
	 hawser__net_automatic, 1},
	{{"interior-point", "primal-dual interior point of the convex energy", "this program"},
	 hawser__net_interior, 0},
	{{"cone", "interior point of the convex energy as a second-order cone program: converges from any "
	  "start", "this program"}, hawser__net_cone, 0},
	{{"forces", "Newton's method for forces in balance, with steps that lower their energy: slower",
	  "this program"}, hawser__net_dual, 0},
	{{"catenary", "exact catenaries between the joints, whose positions alone are unknown",
	  "this program"}, NULL, 0},
};

const struct hawser__net_method *hawser__net_method(int index)
{
	return index >= 0 && (size_t)index < sizeof methods/sizeof *methods ? &methods[index] : NULL;
}

double hawser__net_residual(struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;
	double most = 0.0;

	hawser__mesh_gradient(work->residual, work->T, mesh);
	hawser__touch_forces(work->residual, mesh);
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++) {
			double r = fabs(work->residual[i][k]);

			if (mesh->unknown[i][k] >= 0 && !(r <= most))
				most = r;
		}
	return most;
}

enum hawser_status hawser__net_factor(struct hawser__net_work *work, int *definite,
                                      struct hawser_report *report)
{
	const struct hawser__mesh *mesh = work->mesh;
	enum hawser_status status;

	hawser__sparse_zero(work->sparse);
	for (int i = 0; i < mesh->elements; i++) {
		hawser__mesh_direction(work->e[i], mesh, i);
		hawser__sparse_add(work->sparse, i, work->a[i], work->b[i], work->e[i]);
	}
	hawser__touch_matrix(work->sparse, mesh);
	for (int i = 0; work->damp > 0.0 && i < mesh->unknowns; i++)
		hawser__sparse_diagonal(work->sparse, i, work->damp);
	status = hawser__sparse_factor(work->sparse, definite, report);
	work->factored = !status && *definite;
	return status;
}

void hawser__net_move(struct hawser__net_work *work, double factor)
{
	struct hawser__mesh *mesh = work->mesh;

	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0)
				mesh->q[i][k] += factor*work->x[mesh->unknown[i][k]];
	if (mesh->water && mesh->water->follows)
		hawser__water_load(mesh);
}

void hawser__net_stretch(double d[3], const struct hawser__net_work *work, int element)
{
	const int *a = work->mesh->unknown[work->mesh->end[element][0]];
	const int *b = work->mesh->unknown[work->mesh->end[element][1]];

	for (int k = 0; k < 3; k++)
		d[k] = (b[k] < 0 ? 0.0 : work->x[b[k]]) - (a[k] < 0 ? 0.0 : work->x[a[k]]);
}

static void add_force(struct hawser__net_work *work, int element, const double force[3])
{
	const int *a = work->mesh->unknown[work->mesh->end[element][0]];
	const int *b = work->mesh->unknown[work->mesh->end[element][1]];

	for (int k = 0; k < 3; k++) {
		if (a[k] >= 0)
			work->x[a[k]] += force[k];
		if (b[k] >= 0)
			work->x[b[k]] -= force[k];
	}
}

void hawser__net_right_loads(struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;

	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0)
				work->x[mesh->unknown[i][k]] = mesh->force[i][k];
}

void hawser__net_right(struct hawser__net_work *work, const double *force)
{
	const struct hawser__mesh *mesh = work->mesh;

	hawser__net_right_loads(work);
	for (int i = 0; i < mesh->elements; i++) {
		double e[3], l = hawser__mesh_direction(e, mesh, i);
		double T = mesh->density[i] > 0.0 ? mesh->density[i]*l : force[i];

		add_force(work, i, (double[3]){T*e[0], T*e[1], T*e[2]});
	}
	hawser__touch_right(work->x, mesh);
}

const struct hawser_net_method *hawser_net_method(int index)
{
	const struct hawser__net_method *row = hawser__net_method(index);

	return row ? &row->shown : NULL;
}

/* First node of the part of the net that node i is in. */
static int part_of(int *part, int i)
{
	while (part[i] != i)
		i = part[i] = part[part[i]];
	return i;
}

enum hawser_status hawser__mesh_loose(int *lost, int *direction, const struct hawser__mesh *mesh,
                                      int *part, struct hawser_report *report)
{
	unsigned char *held = calloc((size_t)mesh->nodes, 3);

	*lost = -1;
	if (!held)
		return hawser__no_memory(report, "net");
	for (int i = 0; i < mesh->nodes; i++)
		part[i] = i;
	for (int i = 0; i < mesh->elements; i++) {
		int a = part_of(part, mesh->end[i][0]), b = part_of(part, mesh->end[i][1]);

		part[a > b ? a : b] = a > b ? b : a;
	}
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			held[3*part_of(part, i) + k] |= mesh->unknown[i][k] < 0;
	for (int i = 0; i < mesh->nodes && *lost < 0; i++)
		for (int k = 0; k < 3 && *lost < 0; k++)
			if (part[i] == i && !held[3*i + k]) {
				*lost = i;
				*direction = k;
			}
	for (int i = 0; i < mesh->nodes; i++)
		part[i] = part_of(part, i);
	free(held);
	return HAWSER_OK;
}

/* Fail for a part of the net that no support holds in one direction. */
static enum hawser_status supported(const struct hawser__mesh *mesh, struct hawser_report *report)
{
	int *part = malloc((size_t)mesh->nodes*sizeof *part), lost, direction;
	enum hawser_status status = part ? hawser__mesh_loose(&lost, &direction, mesh, part, report)
	                                 : hawser__no_memory(report, "net");

	free(part);
	if (status || lost < 0 || mesh->around)
		return status;
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net",
	                    "the part of the mesh with node %d has no support in direction %c", lost,
	                    "xyz"[direction]);
}

/* Sum of the absolute forces: the scale of the tensions. Without any, a small part of the least
 * EA. */
static double weight_of(const struct hawser__mesh *mesh)
{
	double sum = 0.0;

	for (int i = 0; i < mesh->nodes; i++)
		sum += fabs(mesh->force[i][0]) + fabs(mesh->force[i][1]) + fabs(mesh->force[i][2]);
	if (sum > 0.0)
		return sum;
	for (int i = 0; i < mesh->elements; i++)
		sum = i ? fmin(sum, 1e-6*mesh->EA[i]) : 1e-6*mesh->EA[i];
	return sum;
}

enum hawser_status hawser__net_automatic(struct hawser__net_work *work, int *done,
                                         struct hawser_report *report)
{
	enum hawser_status status;

	if (work->mesh->touches)
		return hawser__net_touching(work, done, report);
	status = hawser__net_finish(work, done, report);

	if (status || *done)
		return status;
	work->first = NULL;
	memcpy(work->mesh->q, work->start, (size_t)work->mesh->nodes*sizeof *work->start);
	hawser__net_start_forces(work);
	status = hawser__net_cone(work, done, report);
	return status || *done ? status : hawser__net_dual(work, done, report);
}

/* Term of the gap of an element with force vector n. */
static double gap_of(const struct hawser__mesh *mesh, int i, const double e[3], double l, double T,
                     const double n[3])
{
	double along = n[0]*e[0] + n[1]*e[1] + n[2]*e[2], across = 0.0, N, term;
	double c = mesh->length0[i]/mesh->EA[i];

	for (int k = 0; k < 3; k++)
		across += (n[k] - along*e[k])*(n[k] - along*e[k]);
	N = sqrt(along*along + across);
	term = along > 0.0 ? l*across/(N + along) : l*(N - along);
	if (T > 0.0)
		return term + c/2.0*(N - T)*(N - T);
	return term + c/2.0*N*N + N*(mesh->length0[i] - l);
}

/* The energy, that of the strain from the tensions. */
static double energy(const struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;
	double sum = 0.0, e[3];

	for (int i = 0; i < mesh->elements; i++)
		sum += mesh->density[i] > 0.0 ? work->T[i]*hawser__mesh_direction(e, mesh, i)/2.0
		                              : work->T[i]*(mesh->length0[i]/mesh->EA[i])*work->T[i]/2.0;
	for (int i = 0; i < mesh->touches; i++)
		sum += 0.5*mesh->touch[i].give*mesh->touch[i].r*mesh->touch[i].r;
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			sum -= mesh->force[i][k]*mesh->q[i][k];
	return sum;
}

/* A matrix of the elements at mesh->q. */
static enum hawser_status factor_here(struct hawser__net_work *work, struct hawser_report *report)
{
	const struct hawser__mesh *mesh = work->mesh;
	int definite;

	for (int i = 0; i < mesh->elements; i++) {
		double e[3], l = fmax(hawser__mesh_direction(e, mesh, i), 1e-12*mesh->length0[i]);

		work->a[i] = mesh->density[i] > 0.0 ? mesh->density[i]
		                                    : fmax(work->T[i], 1e-9*work->weight)/l;
		work->b[i] = mesh->density[i] > 0.0 || work->T[i] == 0.0 ? 0.0
			: fmax(fmin(mesh->EA[i]/mesh->length0[i], HAWSER__NET_RIGID*work->a[i]) - work->a[i],
			       -0.5*work->a[i]);
	}
	return hawser__net_factor(work, &definite, report);
}

/* The gap with forces in balance: those of the elements, and the forces that the last factors give
 * them for what is not balanced. */
static enum hawser_status gap_with_factors(double *gap, struct hawser__net_work *work,
                                           struct hawser_report *report)
{
	const struct hawser__mesh *mesh = work->mesh;
	enum hawser_status status;

	hawser__net_right(work, work->T);
	status = hawser__sparse_solve(work->x, work->sparse, report);
	if (status)
		return status;
	*gap = 0.0;
	for (int i = 0; i < mesh->elements; i++) {
		double e[3], d[3], n[3], l = hawser__mesh_direction(e, mesh, i), along;

		hawser__net_stretch(d, work, i);
		along = work->e[i][0]*d[0] + work->e[i][1]*d[1] + work->e[i][2]*d[2];
		for (int k = 0; k < 3; k++)
			n[k] = work->T[i]*e[k] + work->a[i]*d[k] + work->b[i]*along*work->e[i][k];
		if (mesh->density[i] == 0.0)
			*gap += gap_of(mesh, i, e, l,
			               hawser__net_lawful_force(mesh, i, l, work->T[i]), n);
	}
	return HAWSER_OK;
}

/* Any definite matrix of the elements gives forces in balance; that of the last iteration is as good as
 * a new one, unless the gap is beyond the round-off of the energy. */
static enum hawser_status certify(struct hawser__net_work *work, struct hawser__equilibrium *found,
                                  struct hawser_report *report)
{
	const struct hawser__mesh *mesh = work->mesh;
	enum hawser_status status = HAWSER_OK;

	if (!work->own)
		found->residual = hawser__net_residual(work);
	found->energy = energy(work);
	found->gap = INFINITY;
	if (mesh->touches) { /* forces of contacts are loads now, without stiffness */
		hawser__touch_fixed(work->mesh);
		work->factored = 0;
	}
	if (work->factored)
		status = gap_with_factors(&found->gap, work, report);
	if (!status && !(found->gap <= DBL_EPSILON*work->weight*work->reach)) {
		status = factor_here(work, report);
		if (!status && work->factored)
			status = gap_with_factors(&found->gap, work, report);
	}
	for (int i = 0; i < mesh->touches; i++)
		if (mesh->touch[i].r > 0.0)
			found->gap += hawser_surface_convex(mesh->touch[i].surface)
			              ? fabs(mesh->touch[i].r*(mesh->touch[i].g +
			                                       mesh->touch[i].give*mesh->touch[i].r)) : INFINITY;
	if (hawser__water_flows(mesh))
		found->gap = INFINITY;
	return status;
}

static void clear(struct hawser__net_work *work)
{
	hawser__hold_clear(&work->hold);
	hawser__sparse_clear(work->sparse);
	hawser__klu_clear(work->klu);
}

static enum hawser_status open(struct hawser__net_work *work, struct hawser__mesh *mesh,
                               struct hawser_report *report)
{
	size_t elements = (size_t)mesh->elements;

	*work = (struct hawser__net_work){.mesh = mesh};
	work->N = hawser__hold(&work->hold, 5*elements, sizeof *work->N);
	work->e = hawser__hold(&work->hold, elements, sizeof *work->e);
	work->x = hawser__hold(&work->hold, (size_t)mesh->unknowns + 1, sizeof *work->x);
	work->residual = hawser__hold(&work->hold, (size_t)mesh->nodes, sizeof *work->residual);
	work->start = hawser__hold(&work->hold, (size_t)mesh->nodes, sizeof *work->start);
	work->near = hawser__hold(&work->hold, (size_t)mesh->nodes, sizeof *work->near);
	work->bound = hawser__hold(&work->hold, (size_t)mesh->nodes, sizeof *work->bound);
	work->rest = INFINITY;
	if (work->hold.short_of_memory)
		return hawser__no_memory(report, "net");
	work->s = work->N + elements;
	work->a = work->s + elements;
	work->b = work->a + elements;
	work->T = work->b + elements;
	return hawser__sparse_open(&work->sparse, mesh, report);
}

static enum hawser_status solve(struct hawser__net_work *work, struct hawser__equilibrium *found,
                                const struct hawser__mesh_options *options,
                                struct hawser_report *report)
{
	const struct hawser__net_method *method = options->method ? options->method : hawser__net_method(0);
	const struct hawser__mesh *mesh = work->mesh;
	double tolerance = options->tolerance > 0.0 ? options->tolerance : 1e-10;
	int done = 0;
	enum hawser_status status = HAWSER_OK;

	work->weight = weight_of(mesh);
	for (int i = 0; i < mesh->elements; i++)
		work->reach += mesh->length0[i];
	work->most = options->iterations;
	work->rubs = options->rubs;
	status = hawser__net_begin(work, options, report);
	if (status)
		return status;
	found->floor = hawser__mesh_floor(mesh);
	work->wanted = tolerance*work->weight;
	work->tolerance = fmax(work->wanted, found->floor);
	status = mesh->water ? hawser__water_statics(work, method, &done, report)
	                     : method->solve(work, &done, report);
	if (!work->own)
		found->floor = hawser__mesh_floor(mesh);
	else if (!status)
		done = hawser__net_settled(work, &found->residual, &found->floor) && done;
	if (!status && mesh->touches)
		done = hawser__touch_settled(&found->apart, work) && done;
	found->method = method->shown.name;
	found->iterations = work->iterations;
	if (!status && !done && mesh->touches)
		return hawser__touch_lost(found, work, report);
	if (!status)
		status = certify(work, found, report);
	if (status || (done && isfinite(found->residual)))
		return status;
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "net", work->iterations, found->residual,
	                       "the equilibrium was not found by the method %s: after %d iterations the "
	                       "largest force that is not balanced is %.3g N, and round-off allows %.3g N",
	                       method->shown.name, work->iterations, found->residual, found->floor);
}

enum { PIECES = 200 };

/* Equilibria on pieces of the laws of cables, until each element is on its own (net/law.c). */
static enum hawser_status by_pieces(struct hawser__net_work *work, struct hawser__equilibrium *found,
                                    const struct hawser__mesh_options *options,
                                    struct hawser_report *report)
{
	struct hawser__mesh *mesh = work->mesh;
	enum hawser_status status = solve(work, found, options, report);
	int others = status ? 0 : hawser__mesh_follow(mesh);
	size_t size = (size_t)mesh->nodes*sizeof *mesh->q;
	double (*from)[3] = others ? malloc(2*size) : NULL;

	if (others && !from)
		return hawser__no_memory(report, "net");
	for (int i = 0; others && i < PIECES && !status; i++) {
		memcpy(from, mesh->q, size);
		clear(work);
		status = open(work, mesh, report);
		if (!status)
			status = solve(work, found, options, report);
		others = status ? others : hawser__mesh_follow(mesh);
		if (!status && others) {
			hawser__mesh_descend(mesh, from, from + mesh->nodes);
			hawser__mesh_follow(mesh);
		}
	}
	free(from);
	for (int i = 0; i < mesh->elements; i++)
		found->energy += mesh->stored[i];
	return status || !others ? status
		: hawser__fail(report, HAWSER_ERR_CONVERGENCE, "net", "the laws of the cables were not "
		               "followed: after %d equilibria %d elements are on other pieces of their tables: "
		               "give tables with smaller changes of the slope", PIECES, others);
}

enum hawser_status hawser__mesh_statics(struct hawser__mesh *mesh, double *T,
                                        struct hawser__equilibrium *found,
                                        const struct hawser__mesh_options *options,
                                        struct hawser_report *report)
{
	static const struct hawser__mesh_options defaults = {0};
	struct hawser__net_work work = {0};
	enum hawser_status status = supported(mesh, report);

	memset(found, 0, sizeof *found);
	options = options ? options : &defaults;
	if (!status)
		status = open(&work, mesh, report);
	if (!status)
		status = by_pieces(&work, found, options, report);
	if (!status && T)
		memcpy(T, work.T, (size_t)mesh->elements*sizeof *T);
	clear(&work);
	return status;
}
