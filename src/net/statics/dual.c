/* net/statics/dual.c - equilibrium from forces that are in balance.
 *
 * q  positions of the nodes, A q the chords of the elements
 * F  mean tension vector of each element (net/statics/catenary.h), W(F) its complementary energy
 *
 * Of all forces in equilibrium, A'F = f, the true ones have the least sum of W(F) - F.(A q of the
 * supports): Castigliano. The sum is convex and smooth, and the positions are its multipliers. The
 * start gives each element a force density: those forces are in equilibrium. From there Newton's
 * method with steps that lower the sum converges from anywhere. Its matrix A'K A, with the stiffness K
 * of each element, is of the size of the unknown positions. An element without weight may be slack:
 * its |t| is rounded off by a force that falls to 1e-14 of the loads.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/statics/dual.h"
#include "net/statics/solve.h"

#define CLOSED 1e-9  /* part of its length by which a chord may be off */
enum { MOST = 300, HALVINGS = 40 };
#define LEAST 1e-14 /* part of the loads that rounds off |t| at the end */

enum hawser_status hawser__dual_open(struct hawser__dual *dual, struct hawser__mesh *mesh,
                                     struct hawser_report *report)
{
	size_t elements = (size_t)mesh->elements;

	memset(dual, 0, sizeof *dual);
	dual->mesh = mesh;
	dual->cable = calloc(elements, sizeof *dual->cable);
	dual->F = calloc(elements, sizeof *dual->F);
	dual->step = calloc(elements, sizeof *dual->step);
	dual->x = calloc((size_t)mesh->unknowns + 1, sizeof *dual->x);
	if (!dual->cable || !dual->F || !dual->step || !dual->x)
		return hawser__no_memory(report, "net");
	for (int i = 0; i < mesh->elements; i++)
		dual->cable[i] = (struct hawser__net_catenary){.length0 = mesh->length0[i], .EA = mesh->EA[i],
		                                               .density = mesh->density[i]};
	return HAWSER_OK;
}

void hawser__dual_clear(struct hawser__dual *dual)
{
	free(dual->cable);
	free(dual->F);
	free(dual->step);
	free(dual->x);
	memset(dual, 0, sizeof *dual);
}

static void chord_of(double d[3], const struct hawser__mesh *mesh, int c)
{
	for (int k = 0; k < 3; k++)
		d[k] = mesh->q[mesh->end[c][1]][k] - mesh->q[mesh->end[c][0]][k];
}

/* The stiffness of a cable and what its chord has beyond that of its force; at the start the stiffness
 * of a force density, and no force. */
void hawser__dual_linear(double K[3][3], double gap[3], const struct hawser__dual *dual, int c)
{
	double chord[3], N = dual->started ? 0.0 : dual->step[c][0];

	chord_of(gap, dual->mesh, c);
	if (!dual->started) {
		memset(K, 0, 9*sizeof **K);
		for (int k = 0; k < 3; k++)
			K[k][k] = dual->cable[c].density > 0.0 ? dual->cable[c].density
			                                       : N/dual->cable[c].length0;
		return;
	}
	hawser__catenary(chord, NULL, &dual->cable[c], dual->F[c]);
	hawser__catenary_stiffness(K, &dual->cable[c], dual->F[c]);
	for (int k = 0; k < 3; k++)
		gap[k] -= chord[k];
}

static void to_joints(struct hawser__dual *dual, int c, const double force[3])
{
	for (int end = 0; end < 2; end++)
		for (int k = 0; k < 3; k++) {
			int u = dual->mesh->unknown[dual->mesh->end[c][end]][k];

			if (u >= 0)
				dual->x[u] += end ? -force[k] : force[k];
		}
}

/* x = force on the joints that the forces of the chords do not balance; returns the largest of them and
 * of the differences between the forces and those of the chords. */
static double assemble(struct hawser__dual *dual)
{
	const struct hawser__mesh *mesh = dual->mesh;
	double K[3][3], gap[3], most = 0.0;

	dual->open = 0.0;
	if (dual->sparse)
		hawser__sparse_zero(dual->sparse);
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0)
				dual->x[mesh->unknown[i][k]] = mesh->force[i][k];
	for (int c = 0; c < mesh->elements; c++) {
		double force[3];

		hawser__dual_linear(K, gap, dual, c);
		if (dual->cable[c].density == 0.0)
			dual->open = fmax(dual->open, sqrt(hawser__dot(gap, gap))/dual->cable[c].length0);
		for (int k = 0; k < 3; k++) {
			force[k] = hawser__dot(K[k], gap);
			if (!(fabs(force[k]) <= most))
				most = fabs(force[k]);
			force[k] += dual->F[c][k];
		}
		to_joints(dual, c, force);
		if (dual->sparse)
			hawser__sparse_block(dual->sparse, c, K);
	}
	for (int i = 0; i < mesh->unknowns; i++)
		if (!(fabs(dual->x[i]) <= most))
			most = fabs(dual->x[i]);
	return most;
}

/* Change of the sum of W(F) - F.chord for `factor` times the step: *slope is its derivative there, and
 * *size the size of what was added up. */
static double lowered(double *slope, double *size, const struct hawser__dual *dual, double factor)
{
	double sum = 0.0, G[3], chord[3], d[3];

	*slope = *size = 0.0;
	for (int c = 0; c < dual->mesh->elements; c++) {
		const double *F = dual->F[c], *step = dual->step[c];
		double before = hawser__catenary(NULL, NULL, &dual->cable[c], F), after;

		for (int k = 0; k < 3; k++)
			G[k] = F[k] + factor*step[k];
		after = hawser__catenary(chord, NULL, &dual->cable[c], G);
		chord_of(d, dual->mesh, c);
		sum += after - before - factor*hawser__dot(step, d);
		*slope += hawser__dot(step, chord) - hawser__dot(step, d);
		*size += fabs(after) + fabs(before) + fabs(factor*hawser__dot(step, d));
	}
	return sum;
}

/* One step of Newton's method from the matrix and forces of assemble(). */
static enum hawser_status advance(struct hawser__dual *dual, struct hawser_report *report)
{
	struct hawser__mesh *mesh = dual->mesh;
	double slope, size, first, factor = 1.0;
	enum hawser_status status = HAWSER_OK;
	int definite = 1;

	if (dual->sparse)
		status = hawser__sparse_factor(dual->sparse, &definite, report);
	if (!status && !definite)
		return hawser__fail(report, HAWSER_ERR_NAN, "net",
		                    "the stiffness of the joints is not positive definite: the loads or "
		                    "stiffnesses are out of range");
	if (!status && dual->sparse)
		status = hawser__sparse_solve(dual->x, dual->sparse, report);
	if (status)
		return status;
	for (int c = 0; c < mesh->elements; c++) {
		double K[3][3], gap[3], force[3];

		hawser__dual_linear(K, gap, dual, c);
		for (int k = 0; k < 3; k++) {
			int a = mesh->unknown[mesh->end[c][0]][k], b = mesh->unknown[mesh->end[c][1]][k];

			gap[k] += (b < 0 ? 0.0 : dual->x[b]) - (a < 0 ? 0.0 : dual->x[a]);
		}
		for (int k = 0; k < 3; k++)
			force[k] = hawser__dot(K[k], gap);
		memcpy(dual->step[c], force, sizeof force);
	}
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0)
				mesh->q[i][k] += dual->x[mesh->unknown[i][k]];
	lowered(&first, &size, dual, 0.0);
	for (int i = 0; dual->started && i < HALVINGS; i++, factor *= 0.5) {
		double change = lowered(&slope, &size, dual, factor);

		if (change <= 1e-4*factor*first + 1e-13*size && slope <= 0.9*fabs(first))
			break;
	}
	for (int c = 0; c < mesh->elements; c++)
		for (int k = 0; k < 3; k++)
			dual->F[c][k] += factor*dual->step[c][k];
	return HAWSER_OK;
}

static double weight_of(const struct hawser__mesh *mesh)
{
	double sum = 0.0;

	for (int i = 0; i < mesh->nodes; i++)
		sum += fabs(mesh->force[i][0]) + fabs(mesh->force[i][1]) + fabs(mesh->force[i][2]);
	for (int i = 0; sum == 0.0 && i < mesh->elements; i++)
		sum = 1e-6*mesh->EA[i];
	return sum;
}

/* Force densities of the start, in step[c][0], with the unknown joints at 0. */
static void begin(struct hawser__dual *dual)
{
	struct hawser__mesh *mesh = dual->mesh;

	for (int c = 0; c < mesh->elements; c++) {
		double d[3], N = 0.2*dual->weight;
		int free_ends = 0;

		chord_of(d, mesh, c);
		for (int k = 0; k < 3; k++)
			free_ends += mesh->unknown[mesh->end[c][0]][k] >= 0 ||
			             mesh->unknown[mesh->end[c][1]][k] >= 0;
		if (!free_ends)
			N = fmax(N, mesh->EA[c]*(sqrt(hawser__dot(d, d))/mesh->length0[c] - 1.0));
		dual->step[c][0] = N;
	}
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0)
				mesh->q[i][k] = 0.0;
	dual->started = 0;
}

/* Round off |t| by a part of the loads; the last part is 0 for cables that have weight. */
static void soften(struct hawser__dual *dual, double part)
{
	for (int c = 0; c < dual->mesh->elements; c++) {
		struct hawser__net_catenary *cable = &dual->cable[c];
		double own = sqrt(hawser__dot(cable->p, cable->p))*cable->length0;

		cable->soft = part > LEAST || own < 1e-12*dual->weight ? part*dual->weight : 0.0;
	}
}

/* 1 if the weight of a cable is next to nothing. */
static int light(const struct hawser__dual *dual)
{
	for (int c = 0; c < dual->mesh->elements; c++)
		if (hawser__norm(dual->cable[c].p)*dual->cable[c].length0 < 1e-6*dual->weight)
			return 1;
	return 0;
}

enum hawser_status hawser__dual_solve(struct hawser__dual *dual, int *done, double *residual,
                                      double tolerance, int most, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	double part, best = INFINITY;
	int idle = 0;

	*done = 0;
	*residual = INFINITY;
	dual->weight = weight_of(dual->mesh);
	begin(dual);
	part = light(dual) ? 0.1 : LEAST;
	soften(dual, part);
	for (dual->iterations = 0; dual->iterations < (most ? most : MOST) && !status; dual->iterations++) {
		double enough = fmax(tolerance*dual->weight, hawser__mesh_floor(dual->mesh));

		*residual = assemble(dual);
		*done = dual->started && part <= LEAST && *residual <= enough &&
		        (dual->open <= CLOSED || (idle > 10 && dual->open <= 1e-6));
		idle = dual->open < 0.5*best ? 0 : idle + 1;
		best = part > LEAST ? INFINITY : fmin(best, dual->open);
		if (*done || !isfinite(*residual))
			break;
		if (dual->started && *residual <= fmax(enough, part*dual->weight)) {
			part = fmax(1e-3*part, LEAST);
			soften(dual, part);
			assemble(dual);
		}
		status = advance(dual, report);
		dual->started = 1;
	}
	return status;
}

enum hawser_status hawser__net_dual(struct hawser__net_work *work, int *done,
                                    struct hawser_report *report)
{
	struct hawser__mesh *mesh = work->mesh;
	struct hawser__dual dual;
	double residual;
	enum hawser_status status = hawser__dual_open(&dual, mesh, report);

	dual.sparse = work->sparse;
	if (!status)
		status = hawser__dual_solve(&dual, done, &residual, work->tolerance/work->weight, work->most,
		                            report);
	work->iterations += dual.iterations;
	work->factored = 0;
	for (int i = 0; i < mesh->elements && !status; i++)
		work->N[i] = sqrt(hawser__dot(dual.F[i], dual.F[i]));
	if (!status && *done)
		status = hawser__net_finish(work, done, report);
	hawser__dual_clear(&dual);
	return status;
}
