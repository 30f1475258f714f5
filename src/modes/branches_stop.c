/* modes/branches_stop.c - modes at one station of a sweep, and how alike two stations' shapes are.
 *
 *   t          S/L, the coordinate that shapes of different cable lengths have in common
 *   c_ij       product of the shapes i and j over t, both of unit norm; |c|^2 correlates them. At rest
 *              it is the integral of Phi_i . Phi_j, and c^2 the modal assurance criterion with the mass
 *              as weight; branches_moving.c says what it is for travelling ones. P and Q of the local
 *              frames are compared: the frame itself turns a little from station to station, which
 *              is no change of the mode.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/branches.h"

void hawser__stop_clear(struct hawser__stop *stop)
{
	free(stop->mode);
	free(stop->shape);
	free(stop->imaginary);
	free(stop->wave);
	*stop = (struct hawser__stop){0};
}

enum hawser_status hawser__branches_enough(int *enough, struct hawser__branches *all,
                                           const int *have, const struct hawser_statics *st,
                                           struct hawser_report *report)
{
	int in = all->need - have[HAWSER_IN_PLANE], out = all->out - have[HAWSER_OUT_OF_PLANE];
	char here[HAWSER__HERE];

	all->solves++;
	*enough = in <= 0 && out <= 0;
	if (*enough)
		return HAWSER_OK;
	all->ask += 2*(in > out ? in : out);
	if (all->ask <= HAWSER__ASK_MOST)
		return HAWSER_OK;
	all->course->say(here, sizeof here, st);
	return hawser__fail(report, HAWSER_ERR_CONVERGENCE, all->course->where,
	                    "at %s more than %d modes are needed to hold the branches asked for: ask "
	                    "for fewer, or for a smaller range", here, HAWSER__ASK_MOST);
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
		int have[2] = {0}, enough;

		if (status)
			return status;
		for (int k = 0; k < modes->n; k++)
			have[modes->mode[k].plane]++;
		status = hawser__branches_enough(&enough, all, have, st, report);
		if (status || enough)
			return status;
		hawser_modes_clear(modes);
	}
}

static enum hawser_status keep_shapes(struct hawser__stop *stop, struct hawser__branches *all,
                                      const struct hawser_modes *modes,
                                      struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int next = 0;

	all->values = 2*all->nodes.points;
	stop->shape = malloc((size_t)stop->in*(size_t)all->values*sizeof *stop->shape);
	if (!stop->shape)
		return hawser__no_memory(report, all->course->where);
	for (int k = 0; k < modes->n && !status; k++) {
		double *shape = stop->shape + (size_t)next*(size_t)all->values;

		if (modes->mode[k].plane != HAWSER_IN_PLANE)
			continue;
		status = hawser__branches_sample(shape, all, &modes->grid,
		                                 modes->shape + (size_t)k*3*(size_t)modes->grid.points,
		                                 3, 2, report);
		cblas_dscal(all->values, 1.0/cblas_dnrm2(all->values, shape, 1), shape, 1);
		next++;
	}
	return status;
}

static enum hawser_status keep(struct hawser__stop *stop, const struct hawser__branches *all,
                               const struct hawser_modes *modes, struct hawser_report *report)
{
	int next[2] = {0};

	for (int k = 0; k < modes->n; k++)
		stop->in += modes->mode[k].plane == HAWSER_IN_PLANE;
	stop->out = modes->n - stop->in;
	next[HAWSER_OUT_OF_PLANE] = stop->in;
	stop->mode = malloc((size_t)modes->n*sizeof *stop->mode);
	if (!stop->mode)
		return hawser__no_memory(report, all->course->where);
	for (int k = 0; k < modes->n; k++) {
		int place = next[modes->mode[k].plane]++;

		stop->mode[place] = modes->mode[k];
		stop->mode[place].omega /= modes->time_unit;
	}
	return HAWSER_OK;
}

static enum hawser_status resting(struct hawser__stop *stop, struct hawser__branches *all,
                                  int shapes, struct hawser_report *report)
{
	struct hawser_modes modes = {0};
	enum hawser_status status = solve(&modes, all, &stop->statics, report);

	if (!status)
		status = keep(stop, all, &modes, report);
	if (!status && shapes)
		status = keep_shapes(stop, all, &modes, report);
	if (!status) {
		all->method = modes.method;
		all->basis = modes.basis > all->basis ? modes.basis : all->basis;
	}
	hawser_modes_clear(&modes);
	return status;
}

enum hawser_status hawser__stop_solve(struct hawser__stop *stop, struct hawser__branches *all,
                                      double x, int shapes, struct hawser_report *report)
{
	enum hawser_status status;

	*stop = (struct hawser__stop){.x = x};
	status = all->course->place(&stop->statics, all, x, report);
	if (!status)
		status = all->course->moving ? hawser__stop_moving(stop, all, shapes, report)
		                             : resting(stop, all, shapes, report);
	if (status)
		hawser__stop_clear(stop);
	return status;
}

double hawser__stop_correlation(const struct hawser__stop *a, int i, const struct hawser__stop *b,
                                int j, const struct hawser__branches *all)
{
	size_t from = (size_t)i*(size_t)all->values, to = (size_t)j*(size_t)all->values;
	double c = cblas_ddot(all->values, a->shape + from, 1, b->shape + to, 1), s = 0.0;

	if (a->imaginary) {
		c += cblas_ddot(all->values, a->imaginary + from, 1, b->imaginary + to, 1);
		s = cblas_ddot(all->values, a->shape + from, 1, b->imaginary + to, 1)
		    - cblas_ddot(all->values, a->imaginary + from, 1, b->shape + to, 1);
	}
	return c*c + s*s;
}

double hawser__stop_gap(const struct hawser__stop *stop, int k)
{
	double below = stop->mode[k].omega, above = stop->mode[k + 1].omega;

	return 2.0*(above - below)/(above + below);
}
