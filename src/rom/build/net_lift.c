/* rom/build/net_lift.c - the motion of a net's mesh that a motion of its model stands for:
 *
 *   x = sum q_a Phi_a + 1/2 sum q_a q_b w_ab + sum q_i Psi_i
 *
 * with the coordinates and the fields of the load as q, their shapes Phi, what follows them, and the
 * second-order shapes Psi. What follows the frequency of the load alone is left out: the mesh's own
 * equations, for which this is a start, are linear in it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/build/net.h"

/* Factor of shape a at row t of the motion. */
static double factor_of(const struct hawser__net_source *source, const struct hawser__answers *answers,
                        const double *u, int t, int rows, int a)
{
	int modes = source->n, n = modes + source->inertia.found.shapes, k;
	double angle;

	if (a < modes)
		return u[t*n + a];
	k = answers->field[a - modes].k;
	angle = 2.0*M_PI*(double)(k*t%rows)/rows;
	return answers->field[a - modes].factor*(answers->field[a - modes].sine ? sin(angle) : cos(angle));
}

static void add_shape(double *row, const struct hawser__net_source *source, int a, double factor)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;
	double (*shape)[3] = source->t.shape + (size_t)a*(size_t)mesh->nodes;

	for (int i = 0; i < 3*mesh->nodes; i++)
		if (mesh->unknown[i/3][i%3] >= 0)
			row[mesh->unknown[i/3][i%3]] += factor*shape[i/3][i%3];
}

enum hawser_status hawser__net_lift(double *to, const struct hawser__net_source *source,
                                    const struct hawser__answers *answers, const double *u, int rows,
                                    struct hawser_report *report)
{
	int unknowns = source->modal.mesh.unknowns, shapes = source->inertia.found.shapes;
	int pairs = source->t.pairs, all = source->t.n;
	double *product = hawser__numbers((size_t)rows, (size_t)pairs);
	double *q = hawser__numbers(1, (size_t)all);

	memset(to, 0, (size_t)rows*(size_t)unknowns*sizeof *to);
	for (int t = 0; product && q && t < rows; t++) {
		double *row = to + (size_t)t*(size_t)unknowns;

		for (int b = 0; b < all; b++) {
			q[b] = factor_of(source, answers, u, t, rows, b);
			add_shape(row, source, b, q[b]);
			for (int a = 0; a <= b; a++)
				product[t*pairs + hawser__pair(a, b)] = (a == b ? 0.5 : 1.0)*q[a]*q[b];
		}
		for (int i = 0; i < shapes; i++)
			cblas_daxpy(unknowns, u[t*(source->n + shapes) + source->n + i],
			            source->inertia.row + (size_t)i*(size_t)unknowns, 1, row, 1);
	}
	if (product && q)
		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, unknowns, pairs, 1.0, product,
		            pairs, source->t.second, unknowns, 1.0, to, unknowns);
	free(product);
	free(q);
	return product && q ? HAWSER_OK : hawser__no_memory(report, "net rom");
}
