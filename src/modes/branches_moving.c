/* modes/branches_moving.c - a stop of a travelling cable: complex modes, and the product that makes
 * them orthogonal.
 *
 * With the symmetric K and M and the skew G, two modes of q'' + 2 nu G q' + K q = 0 are orthogonal in
 * the energy, u_i^H K u_j + omega_i omega_j u_i^H M u_j = 0, which is the bi-orthogonality of the
 * pair's left and right vectors. As a field over the cable (doc/theory-modes.md has the strain energy):
 *
 *   E = (a/sqrt(epsilon), b sqrt(t), omega P, omega Q),   t = T/|x'|, scaled, of the apparent cable
 *
 * so that the product of E_i and E_j over the cable is it. From stop to stop each field takes its own
 * statics: at one stop it is exactly orthogonal, and it changes as smoothly as the cable does.
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

static enum hawser_status keep(struct hawser__stop *stop, const struct hawser__branches *all,
                               const struct hawser_complex_modes *modes,
                               struct hawser_report *report)
{
	int next[2] = {0};

	for (int k = 0; k < modes->n; k++)
		stop->in += modes->mode[k].plane == HAWSER_IN_PLANE;
	stop->out = modes->n - stop->in;
	next[HAWSER_OUT_OF_PLANE] = stop->in;
	stop->mode = calloc((size_t)modes->n, sizeof *stop->mode);
	stop->wave = malloc((size_t)modes->n*sizeof *stop->wave);
	if (!stop->mode || !stop->wave)
		return hawser__no_memory(report, all->course->where);
	for (int k = 0; k < modes->n; k++) {
		const struct hawser_complex_mode *from = modes->mode + k;
		int place = next[from->plane]++;

		stop->mode[place] = (struct hawser_mode){
			.omega = from->im/modes->time_unit, .residual = from->residual,
			.plane = from->plane, .place = from->place, .number = from->number,
			.axial_share = from->axial_share, .normal_share = from->normal_share,
			.out_of_plane_share = from->out_of_plane_share, .symmetry = HAWSER_MIXED,
			.family = from->axial_share > 0.5 ? HAWSER_LONGITUDINAL
			                                  : HAWSER_TRANSVERSE};
		stop->wave[place] = (struct hawser__wave){from->re/modes->time_unit,
		                                          from->downstream};
	}
	return HAWSER_OK;
}

/* The field of mode k, its real (0) or imaginary (1) part, into field[points][FIELDS]. */
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

static enum hawser_status keep_shapes(struct hawser__stop *stop, struct hawser__branches *all,
                                      const struct hawser_complex_modes *modes,
                                      struct hawser_report *report)
{
	size_t values = FIELDS*(size_t)all->nodes.points, next = 0;
	double *field = malloc(FIELDS*(size_t)modes->grid.points*sizeof *field);
	enum hawser_status status = HAWSER_OK;

	all->values = (int)values;
	stop->shape = malloc((size_t)stop->in*values*sizeof *stop->shape);
	stop->imaginary = malloc((size_t)stop->in*values*sizeof *stop->imaginary);
	if (!field || !stop->shape || !stop->imaginary)
		status = hawser__no_memory(report, all->course->where);
	for (int k = 0; k < modes->n && !status; k++) {
		double *part[] = {stop->shape + next*values, stop->imaginary + next*values};

		if (modes->mode[k].plane != HAWSER_IN_PLANE)
			continue;
		for (int i = 0; i < 2 && !status; i++) {
			energy_field(field, modes, k, i);
			status = hawser__branches_sample(part[i], all, &modes->grid, field, FIELDS,
			                                 FIELDS, report);
		}
		normalise(part[0], part[1], (int)values);
		next++;
	}
	free(field);
	return status;
}

enum hawser_status hawser__stop_moving(struct hawser__stop *stop, struct hawser__branches *all,
                                       int shapes, struct hawser_report *report)
{
	struct hawser_complex_modes modes = {0};
	enum hawser_status status = solve(&modes, all, &stop->statics, report);

	if (!status)
		status = keep(stop, all, &modes, report);
	if (!status && shapes)
		status = keep_shapes(stop, all, &modes, report);
	if (!status) {
		all->method = modes.method;
		all->basis = modes.basis > all->basis ? modes.basis : all->basis;
	}
	hawser_complex_modes_clear(&modes);
	return status;
}
