/* rom/condense/inertia_field.c - see inertia_field.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "modes/grid.h"
#include "modes/label.h"
#include "rom/terms/absorbers.h"
#include "rom/condense/inertia_field.h"
#include "statics/frame.h"

enum { EACH = 4 }; /* numbers of an absorber */

static int first_absorber(const struct hawser_modes *modes)
{
	return 3*(modes->grid.points + hawser__points(&modes->statics));
}

int hawser__inertia_width(const struct hawser_modes *modes)
{
	return first_absorber(modes) + (modes->stroke ? EACH*modes->statics.attachments : 0);
}

size_t hawser__inertia_stroke(const struct hawser_modes *modes, int i)
{
	return (size_t)(first_absorber(modes) + EACH*i + EACH - 1);
}

void hawser__inertia_roots(double *root, double *stiff, const struct hawser_modes *modes)
{
	const struct hawser_statics *st = &modes->statics;

	for (int p = 0; p < modes->grid.points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(st, modes->grid.s[p]);
		double weight = modes->grid.weight[p], k = at.tension/(1.0 + at.strain);

		for (int c = 0; c < 3; c++) {
			root[3*p + c] = sqrt(weight);
			stiff[3*p + c] = sqrt(weight*k);
		}
		stiff[3*p] = sqrt(weight/st->epsilon);
	}
	for (int p = 3*modes->grid.points; p < first_absorber(modes); p++) {
		int i = p/3 - modes->grid.points, end = i - st->attachments;
		const double *k = end < 0 ? st->attached[i].spring : st->held[end].stiffness;

		root[p] = sqrt(hawser__point_bare(st, i));
		stiff[p] = sqrt(isfinite(k[p%3]) ? k[p%3]*st->span.d/st->H : 0.0);
	}
	for (int i = 0; modes->stroke && i < st->attachments; i++)
		for (int c = 0; c < EACH; c++) {
			int at = first_absorber(modes) + EACH*i + c, own = c == EACH - 1;

			root[at] = own ? 0.0 : sqrt(hawser__point_absorber(st, i));
			stiff[at] = own ? sqrt(hawser__absorber_stiffness(st, i)) : 0.0;
		}
}

void hawser__inertia_absorbers(double *row, const struct hawser_modes *modes, const double *stroke)
{
	const struct hawser_statics *st = &modes->statics;

	for (int i = 0; stroke && i < st->attachments; i++) {
		const double *u = row + 3*(modes->grid.points + i), *a = st->attached[i].absorber_axis;
		double *to = row + first_absorber(modes) + EACH*i;

		for (int c = 0; c < 3; c++)
			to[c] = u[c] + stroke[i]*a[c];
		to[3] = stroke[i];
	}
}

void hawser__inertia_displacement(double *shape, const struct hawser_modes *modes,
                                  const struct hawser__reference *reference, const double *strain,
                                  const struct hawser__condensed *condensed, int pair,
                                  double *scratch)
{
	int points = modes->grid.points;
	double *along = scratch + 3*points;

	hawser__displacement(along, &modes->grid, reference, &modes->statics, strain,
	                     condensed->start + 3*(size_t)pair, scratch);
	for (int p = 0; p < points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(&modes->statics, modes->grid.s[p]);
		const double v[3] = {along[p], along[points + p], along[2*points + p]};

		hawser__frame_in(shape + 3*p, &at, v);
	}
	for (int i = 0; i < hawser__points(&modes->statics); i++)
		for (int axis = 0; axis < 3; axis++)
			hawser__grid_at(shape + 3*(points + i) + axis, &modes->grid, along + axis*points, 1, 1,
			                hawser__point(&modes->statics, i).s);
	hawser__inertia_absorbers(shape, modes, condensed->stroke
	                          ? condensed->stroke + pair*modes->statics.attachments : NULL);
}
