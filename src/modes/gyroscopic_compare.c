/* modes/gyroscopic_compare.c - errors of complex modes with respect to reference modes.
 *
 *   z    integral of conj(Phi) . Phi_ref: its phase is the phase difference of the shapes, its
 *        modulus their correlation, 1 for equal shapes
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include <hawser/gyroscopic.h>

struct work {
	const struct hawser_complex_modes *modes, *reference;
	double *shape;    /* [modes->n][2][points][3] of `modes` on the grid of the reference */
	int *own, *other; /* indices of one plane's modes */
	int owns, others;
};

/* Real and imaginary part of z of the i-th mode of the plane and the j-th of the reference. */
static double correlation(double *re, double *im, const struct work *w, int i, int j)
{
	const struct hawser_grid *grid = &w->reference->grid;
	size_t size = 3*(size_t)grid->points;
	const double *x = w->shape + 2*(size_t)w->own[i]*size;
	const double *y = w->reference->shape + 2*(size_t)w->other[j]*size;

	*re = *im = 0.0;
	for (size_t k = 0; k < size; k++) {
		double weight = grid->weight[k/3];

		*re += weight*(x[k]*y[k] + x[size + k]*y[size + k]);
		*im += weight*(x[k]*y[size + k] - x[size + k]*y[k]);
	}
	return hypot(*re, *im);
}

/* Smallest of |Phi exp(i phase) - Phi_ref|. */
static double distance(const struct work *w, int i, int j)
{
	const struct hawser_grid *grid = &w->reference->grid;
	size_t size = 3*(size_t)grid->points;
	const double *x = w->shape + 2*(size_t)w->own[i]*size;
	const double *y = w->reference->shape + 2*(size_t)w->other[j]*size;
	double re, im, modulus = correlation(&re, &im, w, i, j), sum = 0.0;
	double c = modulus > 0.0 ? re/modulus : 1.0, s = modulus > 0.0 ? im/modulus : 0.0;

	for (size_t k = 0; k < size; k++)
		sum += grid->weight[k/3]*(pow(c*x[k] - s*x[size + k] - y[k], 2.0)
		                          + pow(s*x[k] + c*x[size + k] - y[size + k], 2.0));
	return sqrt(sum);
}

static int gather(int *index, const struct hawser_complex_modes *modes, enum hawser_plane plane)
{
	int count = 0;

	for (int k = 0; k < modes->n; k++)
		if (modes->mode[k].plane == plane)
			index[count++] = k;
	return count;
}

/* Is mode i of the plane closer to the partner of its neighbour j than to its own? As in
 * compare.c. */
static int exchanged(const struct work *w, int i, int j)
{
	double re, im, neighbour = correlation(&re, &im, w, i, j);

	return neighbour > correlation(&re, &im, w, i, i) && neighbour*neighbour > 0.5;
}

static void exchange_neighbours(struct work *w)
{
	for (int i = 0; i + 1 < w->owns && i + 1 < w->others; i++)
		if (exchanged(w, i, i + 1) && exchanged(w, i + 1, i)) {
			int kept = w->own[i];

			w->own[i] = w->own[i + 1];
			w->own[i + 1] = kept;
			i++;
		}
}

static enum hawser_status compare_plane(struct hawser_modes_error *error, struct work *w,
                                        enum hawser_plane plane, struct hawser_report *report)
{
	w->owns = gather(w->own, w->modes, plane);
	w->others = gather(w->other, w->reference, plane);
	if (w->owns > w->others)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "%d %s modes are compared with a reference that has %d of them: ask "
		                    "for more modes of it", w->owns, hawser_plane_name(plane), w->others);
	exchange_neighbours(w);
	for (int i = 0; i < w->owns; i++) {
		const struct hawser_complex_mode *mode = w->modes->mode + w->own[i];
		const struct hawser_complex_mode *reference = w->reference->mode + w->other[i];
		struct hawser_modes_error *e = error + w->own[i];

		e->partner = w->other[i];
		e->frequency = hypot(mode->re - reference->re, mode->im - reference->im)
		               /hypot(reference->re, reference->im);
		e->shape = distance(w, i, i);
		if (!isfinite(e->frequency) || !isfinite(e->shape))
			return hawser__fail(report, HAWSER_ERR_NAN, "modes",
			                    "mode %d cannot be compared: its frequency or shape holds numbers "
			                    "that are not finite", w->own[i] + 1);
	}
	return HAWSER_OK;
}

enum hawser_status hawser_complex_modes_compare(struct hawser_modes_error *error,
                                                const struct hawser_complex_modes *modes,
                                                const struct hawser_complex_modes *reference,
                                                struct hawser_report *report)
{
	struct work w = {.modes = modes, .reference = reference};
	const struct hawser_grid *grid = &reference->grid;
	size_t points = (size_t)grid->points;
	enum hawser_status status = HAWSER_OK;

	if (!(fabs(modes->statics.l - reference->statics.l) <= 1e-9*reference->statics.l))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "modes of different spans are compared: their scaled lengths are "
		                    "%.15g and %.15g", modes->statics.l, reference->statics.l);
	w.shape = calloc((size_t)modes->n*points, 6*sizeof *w.shape);
	w.own = calloc((size_t)modes->n, sizeof *w.own);
	w.other = calloc((size_t)reference->n, sizeof *w.other);
	if (!w.shape || !w.own || !w.other)
		status = hawser__no_memory(report, "modes");
	for (size_t k = 0; k < (size_t)modes->n && !status; k++)
		for (size_t i = 0; i < points; i++) {
			double value[6];

			hawser_complex_modes_at(modes, value, NULL, (int)k, grid->s[i]);
			for (size_t c = 0; c < 6; c++)
				w.shape[((2*k + c/3)*points + i)*3 + c%3] = value[c];
		}
	if (!status)
		status = compare_plane(error, &w, HAWSER_IN_PLANE, report);
	if (!status)
		status = compare_plane(error, &w, HAWSER_OUT_OF_PLANE, report);
	free(w.shape);
	free(w.own);
	free(w.other);
	return status;
}
