/* modes/branches_sample.c - modes at one sample of a sweep, and the correlation of the shapes of
 * two samples.
 *
 *   t          S/L, the common coordinate of shapes on cables of different lengths
 *   c_ij       inner product over t of the shapes i and j, both of unit norm; |c|^2 is their
 *              squared correlation. At rest it is the integral of Phi_i . Phi_j, and c^2 is the
 *              modal assurance criterion weighted by the mass; for a travelling cable see
 *              branches_moving.c. The components P and Q in the local frames are compared, since
 *              the rotation of the frame between two samples is not a change of the mode.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/branches.h"

void hawser__sample_clear(struct hawser__sample *sample)
{
	free(sample->mode);
	free(sample->shape);
	free(sample->imaginary);
	free(sample->wave);
	*sample = (struct hawser__sample){0};
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
	all->sweep->describe(here, sizeof here, st);
	return hawser__fail(report, HAWSER_ERR_CONVERGENCE, all->sweep->where,
	                    "at %s more than %d modes are needed to follow the branches requested: give "
	                    "fewer branches, or a smaller range", here, HAWSER__ASK_MOST);
}

/* Compute modes at rest, increasing their number until both planes have enough. */
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

static enum hawser_status keep_shapes(struct hawser__sample *sample, struct hawser__branches *all,
                                      const struct hawser_modes *modes,
                                      struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int next = 0;

	all->values = 2*all->nodes.points;
	sample->shape = malloc((size_t)sample->in*(size_t)all->values*sizeof *sample->shape);
	if (!sample->shape)
		return hawser__no_memory(report, all->sweep->where);
	for (int k = 0; k < modes->n && !status; k++) {
		double *shape = sample->shape + (size_t)next*(size_t)all->values;

		if (modes->mode[k].plane != HAWSER_IN_PLANE)
			continue;
		status = hawser__branches_interpolate(shape, all, &modes->grid,
		                                 modes->shape + (size_t)k*3*(size_t)modes->grid.points,
		                                 3, 2, report);
		cblas_dscal(all->values, 1.0/cblas_dnrm2(all->values, shape, 1), shape, 1);
		next++;
	}
	return status;
}

static enum hawser_status keep(struct hawser__sample *sample, const struct hawser__branches *all,
                               const struct hawser_modes *modes, struct hawser_report *report)
{
	int next[2] = {0};

	for (int k = 0; k < modes->n; k++)
		sample->in += modes->mode[k].plane == HAWSER_IN_PLANE;
	sample->out = modes->n - sample->in;
	next[HAWSER_OUT_OF_PLANE] = sample->in;
	sample->mode = malloc((size_t)modes->n*sizeof *sample->mode);
	if (!sample->mode)
		return hawser__no_memory(report, all->sweep->where);
	for (int k = 0; k < modes->n; k++) {
		int place = next[modes->mode[k].plane]++;

		sample->mode[place] = modes->mode[k];
		sample->mode[place].omega /= modes->time_unit;
	}
	return HAWSER_OK;
}

static enum hawser_status resting(struct hawser__sample *sample, struct hawser__branches *all,
                                  int shapes, struct hawser_report *report)
{
	struct hawser_modes modes = {0};
	enum hawser_status status = solve(&modes, all, &sample->statics, report);

	if (!status)
		status = keep(sample, all, &modes, report);
	if (!status && shapes)
		status = keep_shapes(sample, all, &modes, report);
	if (!status) {
		all->method = modes.method;
		all->basis = modes.basis > all->basis ? modes.basis : all->basis;
	}
	hawser_modes_clear(&modes);
	return status;
}

enum hawser_status hawser__sample_solve(struct hawser__sample *sample, struct hawser__branches *all,
                                      double x, int shapes, struct hawser_report *report)
{
	enum hawser_status status;

	*sample = (struct hawser__sample){.x = x};
	status = all->sweep->statics_at(&sample->statics, all, x, report);
	if (!status)
		status = all->sweep->moving ? hawser__sample_moving(sample, all, shapes, report)
		                             : resting(sample, all, shapes, report);
	if (status)
		hawser__sample_clear(sample);
	return status;
}

double hawser__sample_correlation(const struct hawser__sample *a, int i, const struct hawser__sample *b,
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

double hawser__sample_gap(const struct hawser__sample *sample, int k)
{
	double below = sample->mode[k].omega, above = sample->mode[k + 1].omega;

	return 2.0*(above - below)/(above + below);
}
