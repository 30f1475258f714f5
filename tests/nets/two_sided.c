/* tests/nets/two_sided.c - equilibrium with the two-sided law: Newton's method with the whole tangent.
 *
 * T  force of an element, EA*(l/length0 - 1), also below 0
 *
 * The element forces and the tangent are those of B (3.17) and (3.21), with one point of integration,
 * which is exact for a straight element. The energy of this law is not convex: Newton's method goes to
 * any of its stationary points, most of them with compressed elements, which no cable has. The tangent
 * is indefinite there, so that its factors are those of LU with pivots. Not for use: for comparison.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/motion/motion.h"
#include "tests/nets/comparison.h"

enum { MOST = 500 };

struct newton {
	struct hawser__klu *klu;
	double (*r)[3];     /* [nodes] loads minus internal forces, then the step */
	double (*B)[9];     /* [elements] */
	double (*mass)[2], *point; /* [elements], [nodes]: zero, of matrices with masses */
};

static enum hawser_status begin(struct newton *newton, const struct hawser__mesh *mesh,
                                struct hawser_report *report)
{
	newton->r = calloc((size_t)mesh->nodes, sizeof *newton->r);
	newton->B = calloc((size_t)mesh->elements, sizeof *newton->B);
	newton->mass = calloc((size_t)mesh->elements, sizeof *newton->mass);
	newton->point = calloc((size_t)mesh->nodes, sizeof *newton->point);
	if (!newton->r || !newton->B || !newton->mass || !newton->point)
		return hawser__no_memory(report, "net");
	return hawser__klu_open(&newton->klu, mesh, report);
}

static void end(struct newton *newton)
{
	hawser__klu_clear(newton->klu);
	free(newton->r);
	free(newton->B);
	free(newton->mass);
	free(newton->point);
}

/* r, T and the blocks B at mesh->q; returns the largest component of r over the unknowns. */
static double assemble(struct newton *newton, struct hawser__net_work *work)
{
	const struct hawser__mesh *mesh = work->mesh;
	double most = 0.0;

	memcpy(newton->r, mesh->force, (size_t)mesh->nodes*sizeof *newton->r);
	for (int i = 0; i < mesh->elements; i++) {
		double e[3], l = fmax(hawser__mesh_direction(e, mesh, i), 1e-12*mesh->length0[i]);
		double k = mesh->EA[i]/mesh->length0[i], across;

		across = mesh->density[i] > 0.0 ? mesh->density[i] : k*((l - mesh->length0[i])/l);
		k = mesh->density[i] > 0.0 ? across : k;
		work->T[i] = across*l;
		for (int j = 0; j < 3; j++) {
			newton->r[mesh->end[i][0]][j] += work->T[i]*e[j];
			newton->r[mesh->end[i][1]][j] -= work->T[i]*e[j];
			for (int m = 0; m < 3; m++)
				newton->B[i][3*j + m] = (k - across)*e[j]*e[m] + (j == m ? across : 0.0);
		}
	}
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[i][k] >= 0 && !(fabs(newton->r[i][k]) <= most))
				most = fabs(newton->r[i][k]);
	return most;
}

enum hawser_status net_two_sided(struct hawser__net_work *work, int *done,
                                 struct hawser_report *report)
{
	struct hawser__mesh *mesh = work->mesh;
	struct newton newton = {0};
	enum hawser_status status = begin(&newton, mesh, report);
	int most = work->most ? work->most : MOST, good = 1;
	double left;

	*done = 0;
	net_start(work);
	left = status ? INFINITY : assemble(&newton, work);
	while (!status && good && !*done && work->iterations < most && isfinite(left)) {
		const struct hawser__blocks_matrix matrix = {.B = (const double (*)[9])newton.B,
		                                             .mass = (const double (*)[2])newton.mass,
		                                             .point = newton.point};

		hawser__klu_forget(newton.klu);
		status = hawser__klu_solve(newton.r, &good, newton.klu, &matrix, report);
		if (status || !good)
			break;
		for (int i = 0; i < mesh->nodes; i++)
			for (int k = 0; k < 3; k++)
				if (mesh->unknown[i][k] >= 0)
					mesh->q[i][k] += newton.r[i][k];
		work->iterations++;
		left = assemble(&newton, work);
		*done = left <= work->tolerance;
	}
	work->factored = 0;
	end(&newton);
	return status;
}
