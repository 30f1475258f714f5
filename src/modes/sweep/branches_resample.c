/* modes/sweep/branches_resample.c - interpolation of the fields of modes to the nodes common to all
 * samples.
 *
 * The nodes are Gauss points. The spectral method on one element uses the same nodes in S/L at all
 * samples with the same degree, so that the interpolation is a matrix, computed once per degree.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/sweep/branches.h"

enum { NODES_LEAST = 32, NODES_EACH = 6, FIELDS_MOST = 8 };

enum hawser_status hawser__branches_open(struct hawser__branches *all, struct hawser_report *report)
{
	const double ends[] = {0.0, 1.0};

	all->least_correlation = 1.0;
	return hawser__grid_init(&all->nodes, 1, NODES_LEAST + NODES_EACH*all->options.n, ends, NULL,
	                         report);
}

void hawser__branches_clear(struct hawser__branches *all)
{
	for (int i = 0; i < all->samples; i++)
		hawser__sample_clear(all->sample + i);
	hawser__grid_clear(&all->nodes);
	free(all->resample);
	free(all->sample);
	free(all->crossover);
	free(all->at);
}

/* Barycentric interpolation from the nodes of a single element, as in grid.c. */
static enum hawser_status make_resample(struct hawser__branches *all,
                                        const struct hawser_grid *grid,
                                        struct hawser_report *report)
{
	int m = grid->order, nodes = all->nodes.points;
	double *matrix = malloc((size_t)nodes*(size_t)m*sizeof *matrix);

	if (!matrix)
		return hawser__no_memory(report, all->sweep->where);
	for (int g = 0; g < nodes; g++) {
		double *row = matrix + (size_t)g*(size_t)m, sum = 0.0;

		for (int i = 0; i < m; i++) {
			double distance = all->nodes.node[g] - grid->node[i];

			/* if two nodes coincide, normalising the row makes this weight 1 and the others 0 */
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

enum hawser_status hawser__branches_interpolate(double *out, struct hawser__branches *all,
                                           const struct hawser_grid *grid, const double *in,
                                           int stride, int fields, struct hawser_report *report)
{
	int nodes = all->nodes.points, single = grid->elements == 1;
	double l = grid->edge[grid->elements];

	if (single && grid->order != all->resampled) {
		enum hawser_status status = make_resample(all, grid, report);

		if (status)
			return status;
	}
	for (int f = 0; f < fields && single; f++)
		cblas_dgemv(CblasRowMajor, CblasNoTrans, nodes, all->resampled, 1.0, all->resample,
		            all->resampled, in + f, stride, 0.0, out + f*nodes, 1);
	for (int g = 0; g < nodes; g++) {
		double value[FIELDS_MOST], root = sqrt(all->nodes.weight[g]);

		if (!single)
			hawser__grid_at(value, grid, in, stride, fields, all->nodes.s[g]*l);
		for (int f = 0; f < fields; f++)
			out[f*nodes + g] = root*(single ? out[f*nodes + g] : value[f]);
	}
	return HAWSER_OK;
}
