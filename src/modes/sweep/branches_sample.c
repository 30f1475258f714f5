/* modes/sweep/branches_sample.c - modes at one sample of a sweep, and the correlation of the shapes of
 * two samples.
 *
 *   t          S/L, the common coordinate of shapes on cables of different lengths
 *   c_ij       inner product over t of the shapes i and j, both of unit norm; |c|^2 is their
 *              squared correlation
 *
 * At rest c is the integral of Phi_i . Phi_j, and c^2 is the modal assurance criterion weighted by
 * the mass. The components P and Q in the local frames are compared, since the rotation of the frame
 * between two samples is not a change of the mode.
 *
 * With the symmetric K and M and the skew G, two modes of q'' + 2 nu G q' + K q = 0 are orthogonal
 * in the energy, u_i^H K u_j + omega_i omega_j u_i^H M u_j = 0. This is the bi-orthogonality of
 * left and right eigenvectors. With the strain energy of doc/theory-modes.md, it is the inner
 * product over the cable of the fields E_i and E_j,
 *
 *   E = (a/sqrt(epsilon), b sqrt(t), omega P, omega Q),   t = T/|x'|, scaled, of the apparent cable
 *
 * For a travelling cable these are the shapes that are compared. Each field uses the statics of its
 * own sample, so that the fields of one sample are exactly orthogonal and vary smoothly along the
 * sweep.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/sweep/branches.h"
#include "modes/label.h"

/* Fields of a shape: P and Q at rest, those of E if the cable travels. */
enum { PLANE_FIELDS = 2, ENERGY_FIELDS = 4 };

void hawser__sample_clear(struct hawser__sample *sample)
{
	free(sample->mode);
	free(sample->shape);
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

/* Compute modes, increasing their number until both planes have enough. */
static enum hawser_status solve(struct hawser_modes *modes, struct hawser__branches *all,
                                const struct hawser_statics *st, struct hawser_report *report)
{
	for (;;) {
		struct hawser_modes_options options = {.n = all->ask, .basis = all->options.basis,
		                                       .tolerance = all->options.tolerance,
		                                       .method = all->options.method};
		enum hawser_status status = all->sweep->moving
			? hawser_complex_modes_solve(modes, st, &options, report)
			: hawser_modes_solve(modes, st, &options, report);
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

/* --- the shapes that are compared --- */

/* The real (part 0) or imaginary (part 1) part of the field E of mode k: field[points][4]. */
static void energy_field(double *field, const struct hawser_modes *modes, int k, int part)
{
	int points = modes->grid.points;
	size_t from = (size_t)k*hawser__modes_row(modes) + (size_t)part*3*(size_t)points;
	const double *shape = modes->shape + from, *slope = modes->slope + from;
	double omega = modes->mode[k].omega;

	for (int i = 0; i < points; i++, field += ENERGY_FIELDS) {
		struct hawser_frame_point at = hawser_statics_frame(&modes->statics,
		                                                    modes->grid.s[i]);
		double tension = hypot(1.0, at.u)/(1.0 + at.strain);

		field[0] = slope[3*i]/sqrt(modes->statics.epsilon);
		field[1] = slope[3*i + 1]*sqrt(tension);
		field[2] = omega*shape[3*i];
		field[3] = omega*shape[3*i + 1];
	}
}

/* One part of mode k at the common nodes. work [points][ENERGY_FIELDS] is used by complex modes. */
static enum hawser_status keep_part(double *out, struct hawser__branches *all,
                                    const struct hawser_modes *modes, int k, int part, double *work,
                                    struct hawser_report *report)
{
	if (!modes->gyroscopic)
		return hawser__branches_interpolate(out, all, &modes->grid,
		                                    modes->shape + (size_t)k*hawser__modes_row(modes), 3,
		                                    PLANE_FIELDS, report);
	energy_field(work, modes, k, part);
	return hawser__branches_interpolate(out, all, &modes->grid, work, ENERGY_FIELDS, ENERGY_FIELDS,
	                                    report);
}

/* The masses of absorbers, which tell apart two modes in which the cable moves alike: their
 * displacements along their directions, over the same length, times sqrt(mass). */
static void keep_absorbers(double *out, const struct hawser_modes *modes, int k)
{
	const struct hawser_statics *st = &modes->statics;

	for (int i = 0; i < st->attachments; i++) {
		const double *a = st->attached[i].absorber_axis;
		double u[3];

		hawser__modes_attached(u, modes, k, i);
		out[i] = sqrt(st->attached[i].absorber/st->l)*
		         (a[0]*u[0] + a[1]*u[1] + hawser__stroke(modes, k, i));
	}
}

/* To unit norm: shape [parts][values]. */
static void normalise(double *shape, int parts, int values)
{
	double norm = 0.0;

	for (int part = 0; part < parts; part++)
		norm = hypot(norm, cblas_dnrm2(values, shape + part*values, 1));
	cblas_dscal(parts*values, 1.0/norm, shape, 1);
}

static enum hawser_status keep_shapes(struct hawser__sample *sample, struct hawser__branches *all,
                                      const struct hawser_modes *modes,
                                      struct hawser_report *report)
{
	int parts = modes->gyroscopic ? 2 : 1;
	int fields = (modes->gyroscopic ? ENERGY_FIELDS : PLANE_FIELDS)*all->nodes.points;
	int values = fields + (modes->stroke ? modes->statics.attachments : 0);
	double *work = malloc(ENERGY_FIELDS*(size_t)modes->grid.points*sizeof *work), *shape;
	enum hawser_status status = HAWSER_OK;

	all->values = values;
	shape = sample->shape = malloc((size_t)sample->in*(size_t)(parts*values)*sizeof *sample->shape);
	if (!work || !shape)
		status = hawser__no_memory(report, all->sweep->where);
	for (int k = 0; k < modes->n && !status; k++) {
		if (modes->mode[k].plane != HAWSER_IN_PLANE)
			continue;
		for (int part = 0; part < parts && !status; part++)
			status = keep_part(shape + part*values, all, modes, k, part, work, report);
		if (modes->stroke)
			keep_absorbers(shape + fields, modes, k);
		normalise(shape, parts, values);
		shape += parts*values;
	}
	free(work);
	return status;
}

/* --- a sample --- */

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
		struct hawser_mode *mode = sample->mode + next[modes->mode[k].plane]++;

		*mode = modes->mode[k];
		mode->omega /= modes->time_unit;
		mode->re /= modes->time_unit;
	}
	return HAWSER_OK;
}

enum hawser_status hawser__sample_solve(struct hawser__sample *sample, struct hawser__branches *all,
                                        double x, int shapes, struct hawser_report *report)
{
	struct hawser_modes modes = {.n = 0};
	enum hawser_status status;

	*sample = (struct hawser__sample){.x = x};
	status = all->sweep->statics_at(&sample->statics, all, x, report);
	if (!status)
		status = solve(&modes, all, &sample->statics, report);
	if (!status)
		status = keep(sample, all, &modes, report);
	if (!status && shapes)
		status = keep_shapes(sample, all, &modes, report);
	if (!status) {
		all->method = modes.method;
		all->basis = modes.basis > all->basis ? modes.basis : all->basis;
	}
	hawser_modes_clear(&modes);
	if (status)
		hawser__sample_clear(sample);
	return status;
}

double hawser__sample_correlation(const struct hawser__sample *a, int i,
                                  const struct hawser__sample *b, int j,
                                  const struct hawser__branches *all)
{
	int values = all->values;
	size_t row = (size_t)values*(all->sweep->moving ? 2 : 1);
	const double *from = a->shape + (size_t)i*row, *to = b->shape + (size_t)j*row;
	double c = cblas_ddot(values, from, 1, to, 1), s = 0.0;

	if (all->sweep->moving) {
		c += cblas_ddot(values, from + values, 1, to + values, 1);
		s = cblas_ddot(values, from, 1, to + values, 1)
		    - cblas_ddot(values, from + values, 1, to, 1);
	}
	return c*c + s*s;
}

double hawser__sample_gap(const struct hawser__sample *sample, int k)
{
	double below = sample->mode[k].omega, above = sample->mode[k + 1].omega;

	return 2.0*(above - below)/(above + below);
}
