/* modes/irvine_stop.c - modes at one station of a sweep, and how alike two stations' shapes are.
 *
 *   t          S/L, the coordinate that shapes of different cable lengths have in common
 *   c_ij       integral of Phi_i.Phi_j over t, both of unit norm; c^2 is the modal assurance criterion
 *              with the mass as weight. P and Q of the local frames are compared: the frame itself
 *              turns a little from station to station, which is no change of the mode.
 *
 * The nodes are Gauss points. The spectral method on one element has the same nodes in t for all
 * stations with one degree, so that the interpolation is one small matrix, made once.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/irvine_branches.h"

enum { ASK_MOST = 1000 };

void hawser__stop_clear(struct hawser__stop *stop)
{
	free(stop->mode);
	free(stop->shape);
	*stop = (struct hawser__stop){0};
}

static int count_plane(const struct hawser_modes *modes, enum hawser_plane plane)
{
	int count = 0;

	for (int k = 0; k < modes->n; k++)
		count += modes->mode[k].plane == plane;
	return count;
}

/* Modes enough in both planes: as many as the last stop took, or more. */
static enum hawser_status solve(struct hawser_modes *modes, struct hawser__branches *all,
                                const struct hawser_statics *st, struct hawser_report *report)
{
	for (;;) {
		struct hawser_modes_options options = {.n = all->ask, .basis = all->options.basis,
		                                       .tolerance = all->options.tolerance,
		                                       .method = all->options.method};
		enum hawser_status status = hawser_modes_solve(modes, st, &options, report);
		int in, out;

		all->solves++;
		if (status)
			return status;
		in = all->need - count_plane(modes, HAWSER_IN_PLANE);
		out = all->out - count_plane(modes, HAWSER_OUT_OF_PLANE);
		if (in <= 0 && out <= 0)
			return HAWSER_OK;
		hawser_modes_clear(modes);
		all->ask += 2*(in > out ? in : out);
		if (all->ask > ASK_MOST)
			return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "irvine",
			                    "at H = %g N more than %d modes are needed to hold the "
			                    "branches asked for: ask for fewer, or for a smaller "
			                    "range", st->H, ASK_MOST);
	}
}

/* Interpolation from the one element's nodes, barycentric as in grid.c. */
static enum hawser_status make_resample(struct hawser__branches *all,
                                        const struct hawser_grid *grid,
                                        struct hawser_report *report)
{
	int m = grid->order, nodes = all->nodes.points;
	double *matrix = malloc((size_t)nodes*(size_t)m*sizeof *matrix);

	if (!matrix)
		return hawser__no_memory(report, "irvine");
	for (int g = 0; g < nodes; g++) {
		double *row = matrix + (size_t)g*(size_t)m, sum = 0.0;

		for (int i = 0; i < m; i++) {
			double distance = all->nodes.node[g] - grid->node[i];

			/* nodes that coincide but for round-off make this 1, others 0 */
			row[i] = grid->bary[i]/(distance != 0.0 ? distance : 1e-300);
			sum += row[i];
		}
		for (int i = 0; i < m; i++)
			row[i] /= sum;
	}
	free(all->resample);
	all->resample = matrix;
	all->resampled = m;
	return HAWSER_OK;
}

/* P and Q of mode k at the nodes, into shape[2][nodes]. */
static void sample(double *shape, const struct hawser__branches *all,
                   const struct hawser_modes *modes, int k)
{
	int nodes = all->nodes.points, m = all->resampled;
	const double *from = modes->shape + (size_t)k*3*(size_t)modes->grid.points;

	if (modes->grid.elements == 1) {
		for (int c = 0; c < 2; c++)
			cblas_dgemv(CblasRowMajor, CblasNoTrans, nodes, m, 1.0, all->resample, m,
			            from + c, 3, 0.0, shape + c*nodes, 1);
		return;
	}
	for (int g = 0; g < nodes; g++) {
		double value[3];

		hawser_modes_at(modes, value, NULL, k, all->nodes.s[g]*modes->statics.l);
		shape[g] = value[0];
		shape[nodes + g] = value[1];
	}
}

/* Times the square root of the weight, and to unit norm, so that a plain product correlates. */
static void weigh(double *shape, const struct hawser_grid *nodes)
{
	double norm;

	for (int g = 0; g < 2*nodes->points; g++)
		shape[g] *= sqrt(nodes->weight[g%nodes->points]);
	norm = cblas_dnrm2(2*nodes->points, shape, 1);
	cblas_dscal(2*nodes->points, 1.0/norm, shape, 1);
}

static enum hawser_status keep_shapes(struct hawser__stop *stop, struct hawser__branches *all,
                                      const struct hawser_modes *modes,
                                      struct hawser_report *report)
{
	size_t size = 2*(size_t)all->nodes.points;
	int next = 0;

	stop->shape = malloc((size_t)stop->in*size*sizeof *stop->shape);
	if (!stop->shape)
		return hawser__no_memory(report, "irvine");
	if (modes->grid.elements == 1 && modes->grid.order != all->resampled) {
		enum hawser_status status = make_resample(all, &modes->grid, report);

		if (status)
			return status;
	}
	for (int k = 0; k < modes->n; k++) {
		double *shape = stop->shape + (size_t)next*size;

		if (modes->mode[k].plane != HAWSER_IN_PLANE)
			continue;
		sample(shape, all, modes, k);
		weigh(shape, &all->nodes);
		next++;
	}
	return HAWSER_OK;
}

static enum hawser_status keep(struct hawser__stop *stop, const struct hawser_modes *modes,
                               struct hawser_report *report)
{
	int in = 0, out;

	stop->in = out = count_plane(modes, HAWSER_IN_PLANE);
	stop->out = modes->n - stop->in;
	stop->mode = malloc((size_t)modes->n*sizeof *stop->mode);
	if (!stop->mode)
		return hawser__no_memory(report, "irvine");
	for (int k = 0; k < modes->n; k++) {
		int place = modes->mode[k].plane == HAWSER_IN_PLANE ? in++ : out++;

		stop->mode[place] = modes->mode[k];
		stop->mode[place].omega /= modes->time_unit;
	}
	return HAWSER_OK;
}

enum hawser_status hawser__stop_solve(struct hawser__stop *stop, struct hawser__branches *all,
                                      double x, int shapes, struct hawser_report *report)
{
	struct hawser_modes modes = {0};
	enum hawser_status status;

	*stop = (struct hawser__stop){.x = x};
	status = hawser_statics_solve(&stop->statics, &all->span, HAWSER_GIVEN_H, exp(x),
	                              HAWSER_BRANCH_TAUT, report);
	if (!status)
		status = solve(&modes, all, &stop->statics, report);
	if (!status)
		status = keep(stop, &modes, report);
	if (!status && shapes)
		status = keep_shapes(stop, all, &modes, report);
	if (!status)
		all->method = modes.method;
	hawser_modes_clear(&modes);
	if (status)
		hawser__stop_clear(stop);
	return status;
}

double hawser__stop_correlation(const struct hawser__stop *a, int i, const struct hawser__stop *b,
                                int j, const struct hawser__branches *all)
{
	int size = 2*all->nodes.points;
	double c = cblas_ddot(size, a->shape + (size_t)i*(size_t)size, 1,
	                      b->shape + (size_t)j*(size_t)size, 1);

	return c*c;
}

double hawser__stop_gap(const struct hawser__stop *stop, int k)
{
	double below = stop->mode[k].omega, above = stop->mode[k + 1].omega;

	return 2.0*(above - below)/(above + below);
}
