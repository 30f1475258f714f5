/* rom/energy/full_map.c - the motions of one full-order model in the coordinates of another.
 *
 *    A, B    modes of the first and of the second basis, with their displacements at the points of B's
 *            grid and the strokes of absorbers, as columns
 *    W       weights of the grid; 1 for a stroke
 *
 * The coordinates of B nearest to those of A are the solution of B'WB x = B'WA. A larger basis on the
 * same elements holds the smaller one, and nothing is lost.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include <hawser/modes.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/grid.h"
#include "rom/energy/full_map.h"

/* out [n][rows]: the columns of `modes` times the root of W, at the points of `grid`. */
static void columns_of(double *out, const struct hawser_modes *modes, const struct hawser_grid *grid,
                       int rows)
{
	int strokes = rows - 3*grid->points;

	for (int j = 0; j < modes->n; j++) {
		const double *shape = modes->shape + 3*(size_t)j*(size_t)modes->grid.points;
		double *column = out + (size_t)j*(size_t)rows;

		for (int p = 0; p < grid->points; p++) {
			double root = sqrt(grid->weight[p]);

			hawser__grid_at(column + 3*p, &modes->grid, shape, 3, 3, grid->s[p]);
			for (int c = 0; c < 3; c++)
				column[3*p + c] *= root;
		}
		for (int k = 0; k < strokes; k++)
			column[3*grid->points + k] = modes->stroke[(size_t)j*(size_t)strokes + (size_t)k];
	}
}

static enum hawser_status solve(double **map, const struct hawser_modes *a,
                                const struct hawser_modes *b, struct hawser_report *report)
{
	int rows = 3*b->grid.points + (b->stroke ? b->statics.attachments : 0), m = b->n, n = a->n;
	int info;
	double *from = hawser__numbers((size_t)n, (size_t)rows);
	double *to = hawser__numbers((size_t)m, (size_t)rows);
	double *gram = hawser__numbers((size_t)m, (size_t)m);

	*map = hawser__numbers((size_t)m, (size_t)n);
	if (!from || !to || !gram || !*map) {
		info = LAPACK_WORK_MEMORY_ERROR;
	} else {
		columns_of(from, a, &b->grid, rows);
		columns_of(to, b, &b->grid, rows);
		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, m, m, rows, 1.0, to, rows, to, rows,
		            0.0, gram, m);
		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, m, n, rows, 1.0, to, rows, from, rows,
		            0.0, *map, n);
		info = LAPACKE_dposv(LAPACK_ROW_MAJOR, 'L', m, n, gram, m, *map, n);
	}
	free(from);
	free(to);
	free(gram);
	if (hawser__lapack_starved(info))
		return hawser__no_memory(report, "rom");
	return info ? hawser__fail(report, HAWSER_ERR_CONVERGENCE, "rom",
	                           "the shapes of a basis depend on each other") : HAWSER_OK;
}

enum hawser_status hawser__full_map(double **map, int *rows, int *columns,
                                    const struct hawser_statics *statics, int from, int to,
                                    struct hawser_report *report)
{
	struct hawser_modes a = {.n = 0}, b = {.n = 0};
	enum hawser_status status = hawser_modes_basis(&a, statics, from, from, report);

	*map = NULL;
	if (!status)
		status = hawser_modes_basis(&b, statics, to, to, report);
	if (!status)
		status = solve(map, &a, &b, report);
	*rows = b.n;
	*columns = a.n;
	hawser_modes_clear(&a);
	hawser_modes_clear(&b);
	if (status) {
		free(*map);
		*map = NULL;
	}
	return status;
}
