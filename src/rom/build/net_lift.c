/* rom/build/net_lift.c - the motion of a net's mesh that a motion of its model stands for:
 *
 *   x = sum q_a Phi_a + 1/2 sum q_a q_b w_ab + sum q_i Psi_i
 *
 * with the coordinates and the fields of the load as q, their shapes Phi, what follows them, and the
 * second-order shapes Psi. What follows the frequency of the load alone is left out: the mesh's own
 * equations, for which this is a start, are linear in it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/build/net.h"

/* cos(k tau), or sine, at `turn` of `turns` equal parts of a period of the load. */
static double wave_at(int k, int sine, int turn, int turns)
{
	double angle = 2.0*M_PI*(double)(k*turn%turns)/turns;

	return sine ? sin(angle) : cos(angle);
}

/* Factor of shape a, where the coordinates are u. */
static double factor_of(const struct hawser__net_source *source, const struct hawser__answers *answers,
                        const double *u, int turn, int turns, int a)
{
	int field = a - source->n;

	return field < 0 ? u[a] : answers->field[field].factor*
	       wave_at(answers->field[field].k, answers->field[field].sine, turn, turns);
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
                                    int periods, struct hawser_report *report)
{
	int unknowns = source->modal.mesh.unknowns, shapes = source->inertia.found.shapes;
	int pairs = source->t.pairs, all = source->t.n, n = source->n + shapes;
	double *product = hawser__numbers((size_t)rows, (size_t)pairs);
	double *q = hawser__numbers(1, (size_t)all);

	memset(to, 0, (size_t)rows*(size_t)unknowns*sizeof *to);
	for (int t = 0; product && q && t < rows; t++) {
		double *row = to + (size_t)t*(size_t)unknowns;

		for (int b = 0; b < all; b++) {
			q[b] = factor_of(source, answers, u + t*n, t*periods, rows, b);
			add_shape(row, source, b, q[b]);
			for (int a = 0; a <= b; a++)
				product[t*pairs + hawser__pair(a, b)] = (a == b ? 0.5 : 1.0)*q[a]*q[b];
		}
		for (int i = 0; i < shapes; i++)
			cblas_daxpy(unknowns, u[t*n + source->n + i],
			            source->inertia.row + (size_t)i*(size_t)unknowns, 1, row, 1);
	}
	if (product && q)
		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, unknowns, pairs, 1.0, product,
		            pairs, source->t.second, unknowns, 1.0, to, unknowns);
	free(product);
	free(q);
	return product && q ? HAWSER_OK : hawser__no_memory(report, "net rom");
}

/* --- the whole net --- */

/* Places, of the unknowns as given and of the others as their supports move. */
static void take_places(double (*x)[3], const struct hawser__net_source *source, const double *row,
                        int turn, int turns)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;

	for (int i = 0; i < 3*mesh->nodes; i++) {
		double *to = &x[i/3][i%3];
		int at = mesh->unknown[i/3][i%3];

		*to = mesh->q[i/3][i%3] + (at >= 0 ? row[at] : 0.0);
		for (int k = 0; k < source->lifts && at < 0; k++)
			*to += source->lift[k].shape[i/3][i%3]*
			       wave_at(source->lift[k].k, source->lift[k].sine, turn, turns);
	}
}

static enum hawser_status show(const struct hawser__net_source *source,
                               const struct hawser__answers *answers,
                               const struct hawser_net_rom_motion *motion, struct hawser_report *report)
{
	const struct hawser__mesh *mesh = &source->modal.mesh;
	double *to = hawser__numbers((size_t)motion->rows, (size_t)mesh->unknowns);
	double (*x)[3] = calloc((size_t)mesh->nodes, sizeof *x);
	struct hawser_net_frame frame = {.nodes = mesh->nodes, .elements = mesh->elements,
	                                 .x = (const double (*)[3])x, .end = (const int (*)[2])mesh->end};
	enum hawser_status status = to && x ? HAWSER_OK : hawser__no_memory(report, "net rom");

	if (!status)
		status = hawser__net_lift(to, source, answers, motion->u, motion->rows, motion->periods,
		                          report);
	for (int stop = 0; !status && !stop && frame.row < motion->rows; frame.row++) {
		frame.t = motion->duration*frame.row/motion->rows;
		take_places(x, source, to + (size_t)frame.row*(size_t)mesh->unknowns,
		            frame.row*motion->periods, motion->rows);
		stop = motion->frame(motion->data, &frame);
	}
	free(to);
	free(x);
	return status;
}

enum hawser_status hawser_net_rom_show(const struct hawser_net *net,
                                       const struct hawser_net_rom_options *options,
                                       const struct hawser_net_rom_motion *motion,
                                       struct hawser_report *report)
{
	struct hawser_net fine = {.nodes = 0};
	struct hawser__net_source source;
	struct hawser__answers answers;
	enum hawser_status status = hawser__net_source_open(&source, &fine, &answers, net, options, report);

	if (!status)
		status = show(&source, &answers, motion, report);
	hawser__answers_clear(&answers);
	hawser__net_source_clear(&source);
	free(fine.cable);
	return status;
}
