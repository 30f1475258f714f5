/* rom/terms/load.c - the varying load of a scene as forces on modes; its pieces: statics/load.c.
 *
 * Each multiple k of the frequency has on mode j the forces
 *
 *    f_j cos   =   scale * integral of Phi_j . f cos(phase - kappa s) ds
 *    f_j sin   = - scale * integral of Phi_j . f sin(phase - kappa s) ds
 *
 * The integrals are exact at the ends a and b of a piece: the elements of the modes' grid are
 * divided there, and in a wave so that the phase changes by at most HAWSER__LOAD_STEP on each part,
 * on which the Gauss rule is exact to round-off. The load becomes forces at the points of the grid,
 * once for all modes. A force F at a point is a piece without length: its work is F . Phi_j there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include <cblas.h>

#include "core/report.h"
#include "modes/grid.h"
#include "modes/label.h"
#include "rom/terms/load.h"

/* F [points][3] += a force of a piece at s, times factor, as forces at the points of the grid that
 * do the same work on every shape. */
static void add_at(double *F, const struct hawser__piece *piece, const struct hawser__loads *loads,
                   int h, const struct hawser_modes *modes, double s, double factor, double *weight)
{
	const struct hawser_grid *grid = &modes->grid;
	double f[3], *to = F + 3*hawser__grid_weights(weight, grid, s)*grid->order;

	hawser__piece_at(f, piece, loads, h, &modes->statics, s);
	for (int i = 0; i < grid->order; i++)
		for (int c = 0; c < 3; c++)
			to[3*i + c] += factor*weight[i]*f[c];
}

/* The same of a piece over [from, to] inside element e, by the rule of the element, on as many parts
 * as a wave needs. */
static void add_panel(double *F, const struct hawser__piece *piece, const struct hawser__loads *loads,
                      int h, const struct hawser_modes *modes, int e, double from, double to,
                      double *weight)
{
	const struct hawser_grid *grid = &modes->grid;
	int parts = 1 + (int)(fabs(piece->kappa)*(to - from)/HAWSER__LOAD_STEP);
	double width = (to - from)/parts;
	double shrink = width/(grid->edge[e + 1] - grid->edge[e]);

	for (int p = 0; p < parts; p++)
		for (int i = 0; i < grid->order; i++)
			add_at(F, piece, loads, h, modes, from + p*width + 0.5*width*(1.0 + grid->node[i]),
			       shrink*grid->weight[e*grid->order + i], weight);
}

static void add_whole(double *F, const struct hawser__piece *piece, const struct hawser__loads *loads,
                      int h, const struct hawser_modes *modes, double *weight)
{
	const struct hawser_grid *grid = &modes->grid;

	if (piece->from == piece->to)
		add_at(F, piece, loads, h, modes, piece->from, 1.0, weight);
	for (int e = 0; e < grid->elements; e++) {
		double from = fmax(grid->edge[e], piece->from);
		double to = fmin(grid->edge[e + 1], piece->to);

		if (from < to)
			add_panel(F, piece, loads, h, modes, e, from, to, weight);
	}
}

enum hawser_status hawser__loads_work(double *work, const struct hawser__loads *loads, int h,
                                      const struct hawser_modes *modes, struct hawser_report *report)
{
	const struct hawser_grid *grid = &modes->grid;
	size_t size = 3*(size_t)grid->points;
	double *F = calloc(size + (size_t)grid->order, sizeof *F);

	if (!F)
		return hawser__no_memory(report, "rom");
	for (int i = 0; i < loads->count; i++)
		if (loads->piece[i].harmonic[loads->sine[h]] == h)
			add_whole(F, &loads->piece[i], loads, h, modes, F + size);
	for (int j = 0; j < modes->n; j++)
		work[j] = loads->scale*cblas_ddot((int)size, F, 1, modes->shape +
		                                  (size_t)j*hawser__modes_row(modes), 1);
	free(F);
	return HAWSER_OK;
}

enum hawser_status hawser__loads_most(double *most, const struct hawser__loads *loads,
                                      const struct hawser_modes *modes, struct hawser_report *report)
{
	size_t n = (size_t)modes->n;
	double *work = calloc((size_t)loads->harmonics*n + 1, sizeof *work);
	enum hawser_status status = work ? HAWSER_OK : hawser__no_memory(report, "rom");

	for (int h = 0; !status && h < loads->harmonics; h++)
		status = hawser__loads_work(work + (size_t)h*n, loads, h, modes, report);
	for (size_t j = 0; !status && j < n; j++) {
		most[j] = loads->harmonics == 1 ? work[j] : 0.0;
		for (int h = 0; loads->harmonics > 1 && h < loads->harmonics; h++) {
			double square = 0.0;

			for (int i = 0; i < loads->harmonics; i++)
				if (loads->k[i] == loads->k[h])
					square += pow(work[(size_t)i*n + j], 2.0);
			most[j] = fmax(most[j], sqrt(square));
		}
	}
	free(work);
	return status;
}
