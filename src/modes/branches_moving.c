/* modes/branches_moving.c - a sample of a travelling cable: complex modes, and the inner product in
 * which they are orthogonal.
 *
 * With the symmetric K and M and the skew G, two modes of q'' + 2 nu G q' + K q = 0 are orthogonal
 * in the energy, u_i^H K u_j + omega_i omega_j u_i^H M u_j = 0. This is the bi-orthogonality of
 * left and right eigenvectors. With the strain energy of doc/theory-modes.md, it is the inner
 * product over the cable of the fields E_i and E_j,
 *
 *   E = (a/sqrt(epsilon), b sqrt(t), omega P, omega Q),   t = T/|x'|, scaled, of the apparent cable
 *
 * Each field uses the statics of its own sample, so that the fields of one sample are exactly
 * orthogonal and vary smoothly along the sweep.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/branches.h"

enum { FIELDS = 4 };

static enum hawser_status solve(struct hawser_complex_modes *modes, struct hawser__branches *all,
                                const struct hawser_statics *st, struct hawser_report *report)
{
	for (;;) {
		struct hawser_modes_options options = {.n = all->ask, .basis = all->options.basis,
		                                       .tolerance = all->options.tolerance,
		                                       .method = all->options.method};
		enum hawser_status status = hawser_complex_modes_solve(modes, st, &options, report);
		int have[2] = {0}, enough;

		if (status)
			return status;
		for (int k = 0; k < modes->n; k++)
			have[modes->mode[k].plane]++;
		status = hawser__branches_enough(&enough, all, have, st, report);
		if (status || enough)
			return status;
		hawser_complex_modes_clear(modes);
	}
}

static enum hawser_status keep(struct hawser__sample *sample, const struct hawser__branches *all,
                               const struct hawser_complex_modes *modes,
                               struct hawser_report *report)
{
	int next[2] = {0};

	for (int k = 0; k < modes->n; k++)
		sample->in += modes->mode[k].plane == HAWSER_IN_PLANE;
	sample->out = modes->n - sample->in;
	next[HAWSER_OUT_OF_PLANE] = sample->in;
	sample->mode = calloc((size_t)modes->n, sizeof *sample->mode);
	sample->wave = malloc((size_t)modes->n*sizeof *sample->wave);
	if (!sample->mode || !sample->wave)
		return hawser__no_memory(report, all->sweep->where);
	for (int k = 0; k < modes->n; k++) {
		const struct hawser_complex_mode *from = modes->mode + k;
		int place = next[from->plane]++;

		sample->mode[place] = (struct hawser_mode){
			.omega = from->im/modes->time_unit, .residual = from->residual,
			.plane = from->plane, .place = from->place, .number = from->number,
			.axial_share = from->axial_share, .normal_share = from->normal_share,
			.out_of_plane_share = from->out_of_plane_share, .symmetry = HAWSER_MIXED,
			.family = from->axial_share > 0.5 ? HAWSER_LONGITUDINAL
			                                  : HAWSER_TRANSVERSE};
		sample->wave[place] = (struct hawser__wave){from->re/modes->time_unit,
		                                          from->downstream};
	}
	return HAWSER_OK;
}

/* The real (part 0) or imaginary (part 1) part of the field E of mode k: field[points][FIELDS]. */
static void energy_field(double *field, const struct hawser_complex_modes *modes, int k, int part)
{
	int points = modes->grid.points;
	size_t from = ((size_t)k*2 + (size_t)part)*3*(size_t)points;
	const double *shape = modes->shape + from, *slope = modes->slope + from;
	double omega = modes->mode[k].im;

	for (int i = 0; i < points; i++, field += FIELDS) {
		struct hawser_frame_point at = hawser_statics_frame(&modes->statics,
		                                                    modes->grid.s[i]);
		double tension = hypot(1.0, at.u)/(1.0 + at.strain);

		field[0] = slope[3*i]/sqrt(modes->statics.epsilon);
		field[1] = slope[3*i + 1]*sqrt(tension);
		field[2] = omega*shape[3*i];
		field[3] = omega*shape[3*i + 1];
	}
}

static void normalise(double *re, double *im, int values)
{
	double norm = hypot(cblas_dnrm2(values, re, 1), cblas_dnrm2(values, im, 1));

	cblas_dscal(values, 1.0/norm, re, 1);
	cblas_dscal(values, 1.0/norm, im, 1);
}

static enum hawser_status keep_shapes(struct hawser__sample *sample, struct hawser__branches *all,
                                      const struct hawser_complex_modes *modes,
                                      struct hawser_report *report)
{
	size_t values = FIELDS*(size_t)all->nodes.points, next = 0;
	double *field = malloc(FIELDS*(size_t)modes->grid.points*sizeof *field);
	enum hawser_status status = HAWSER_OK;

	all->values = (int)values;
	sample->shape = malloc((size_t)sample->in*values*sizeof *sample->shape);
	sample->imaginary = malloc((size_t)sample->in*values*sizeof *sample->imaginary);
	if (!field || !sample->shape || !sample->imaginary)
		status = hawser__no_memory(report, all->sweep->where);
	for (int k = 0; k < modes->n && !status; k++) {
		double *part[] = {sample->shape + next*values, sample->imaginary + next*values};

		if (modes->mode[k].plane != HAWSER_IN_PLANE)
			continue;
		for (int i = 0; i < 2 && !status; i++) {
			energy_field(field, modes, k, i);
			status = hawser__branches_interpolate(part[i], all, &modes->grid, field, FIELDS,
			                                 FIELDS, report);
		}
		normalise(part[0], part[1], (int)values);
		next++;
	}
	free(field);
	return status;
}

enum hawser_status hawser__sample_moving(struct hawser__sample *sample, struct hawser__branches *all,
                                       int shapes, struct hawser_report *report)
{
	struct hawser_complex_modes modes = {0};
	enum hawser_status status = solve(&modes, all, &sample->statics, report);

	if (!status)
		status = keep(sample, all, &modes, report);
	if (!status && shapes)
		status = keep_shapes(sample, all, &modes, report);
	if (!status) {
		all->method = modes.method;
		all->basis = modes.basis > all->basis ? modes.basis : all->basis;
	}
	hawser_complex_modes_clear(&modes);
	return status;
}
