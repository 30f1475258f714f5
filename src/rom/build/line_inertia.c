/* rom/build/line_inertia.c - second-order shapes of a rope over sheaves (expanded_inertia.c). What
 * follows lifts the ends of the free rope from where they are on the sheaves, which no vibration does:
 * the shapes are static responses to its inertia.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "rom/build/line.h"

/* Largest mean square of the slopes of mode j in a span, or of a hanger. */
static double turning_of(const struct hawser__lexpand *t, const struct hawser_line_modes *modes, int j)
{
	const double *own = t->slope + 3*(size_t)t->points*(size_t)j;
	const double *slope = modes->slope + 3*(size_t)j*(size_t)modes->points;
	double most = 0.0;

	for (int span = 0; span < modes->spans; span++) {
		double sum = 0.0, length = 0.0;

		for (int i = 0; i < modes->pieces; i++) {
			const struct hawser_line_modes_piece *piece = &modes->piece[i];

			if (piece->span != span)
				continue;
			for (int p = piece->first; p < piece->first + piece->grid.points; p++) {
				sum += modes->weight[p]*(slope[3*p + 1]*slope[3*p + 1] +
				                         slope[3*p + 2]*slope[3*p + 2]);
				length += modes->weight[p];
			}
		}
		most = fmax(most, length > 0.0 ? sum/length : 0.0);
	}
	for (int p = t->points - t->hangers; p < t->points; p++)
		most = fmax(most, own[3*p + 1]*own[3*p + 1] + own[3*p + 2]*own[3*p + 2]);
	return most;
}

static double amplitude(const void *of, int j)
{
	const struct hawser__line_inertia *inertia = of;
	const struct hawser__lexpand *t = inertia->t;
	double omega = inertia->modes->mode[j].omega;
	double force = hawser__line_force(t, inertia->modes, inertia->options, inertia->pull, j);
	const int own[4] = {j, j, j, j};

	return force > 0.0 ? hawser__inertia_expected(omega*omega, 0.5*t->third[(j*t->n + j)*t->n + j],
	                                              hawser__lexpand_fourth(t, own),
	                                              force/(2.0*inertia->options->ratio*omega),
	                                              turning_of(t, inertia->modes, j)) : 0.0;
}

static double mass(const void *of, const double *x, const double *y)
{
	const struct hawser__line_inertia *inertia = of;
	double product;

	inertia->driven.products(inertia->driven.of, &product, x, 1, y);
	return product;
}

static double stiffness(const void *of, const double *x, const double *y)
{
	return hawser__lexpand_stiffness(&((const struct hawser__line_inertia *)of)->work, x, y);
}

static enum hawser_status vibrates(const void *of, double *to, const double *from,
                                   struct hawser_report *report)
{
	const struct hawser__line_inertia *inertia = of;

	return inertia->driven.follow(inertia->driven.of, to, from, report);
}

static double part(const void *of, int j, int k, const double *row, double kappa2)
{
	const struct hawser__lexpand *t = ((const struct hawser__line_inertia *)of)->t;

	(void)kappa2;
	return mass(of, t->second + (size_t)hawser__pair(j, k)*t->width, row);
}

/* Modes of a model with these shapes, at most: among more are those that move with what follows, and
 * shapes change nothing but the time (doc/theory-ropeway-response.md). */
enum { SHAPES_UNTIL = 12 };

static struct hawser__inertia_by made_by(const struct hawser__line_inertia *inertia)
{
	return (struct hawser__inertia_by){.of = inertia, .n = inertia->modes->n,
		.width = inertia->t->width, .second = inertia->t->second, .amplitude = amplitude, .mass = mass,
		.stiffness = stiffness, .vibrates = vibrates, .part = part};
}

enum hawser_status hawser__line_inertia_find(struct hawser__line_inertia *inertia,
                                             const struct hawser__lexpand_modes *own,
                                             struct hawser_report *report)
{
	const struct hawser__inertia_by by = made_by(inertia);
	enum hawser_status status;

	if (by.n > SHAPES_UNTIL || inertia->options->condensed || inertia->options->held)
		return HAWSER_OK;
	status = hawser__lexpand_by(&inertia->driven, &inertia->work, own, report);
	return status ? status : hawser__inertia_find(&inertia->of, &inertia->hold, &by, report);
}

enum hawser_status hawser__line_inertia_make(struct hawser__line_inertia *inertia,
                                             struct hawser_report *report)
{
	const struct hawser__inertia_by by = made_by(inertia);
	struct hawser__inertia *of = &inertia->of;
	int pairs = by.n*(by.n + 1)/2;
	enum hawser_status status = hawser__inertia_make(of, &inertia->hold, &by, report);

	for (int i = 0; i < of->found.shapes && !status; i++)
		cblas_dger(CblasRowMajor, pairs, pairs, of->kappa2[i], of->part + i*pairs, 1,
		           of->part + i*pairs, 1, inertia->t->pairing, inertia->t->pairs);
	return status;
}

void hawser__line_inertia_clear(struct hawser__line_inertia *inertia)
{
	free(inertia->work.load);
	hawser__hold_clear(&inertia->hold);
}
