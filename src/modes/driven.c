/* modes/driven.c - what the modes that are not kept do under a force that oscillates.
 *
 *   b, W       the force, times cos(W t); M, K mass and stiffness; A = K^-1 M
 *   P          takes the kept modes out of a displacement
 *   z_0        P K^-1 b: the static response; z_1 = P A z_0 the first correction for inertia
 *   v_i, T     Lanczos' vectors of A that begin with z_0/|z_0|, orthonormal in M, and v_i' M A v_j
 *   y, theta   eigenvectors of T and eigenvalues 1/omega_s^2; Phi_s = sum y_i v_i, force omega_s^2
 *              |z_0| y_1
 *
 * The response is (1 - W^2 A)^-1 z_0. In the space of the vectors it is the sum of |z_0| y_1 Phi_s/(1 -
 * W^2/omega_s^2), the first two terms of whose series in W^2 are those of z_0 and z_1. What the sum has
 * beyond these is force*H_s Phi_s (rom/condense/known.c). Up to a frequency, `reach`, the Phi_s are
 * the modes that the force drives; above it they stand for many.
 *
 * The lowest modes would do the same. But most of those that a model does not keep hardly move under
 * its force, and a loaded span has tens of them below a harmonic of a load; Lanczos' vectors are those
 * that do, and each takes one static solution. All are made orthogonal to all others, twice.
 *
 * Reference: E. L. Wilson, M.-W. Yuan and J. M. Dickens, Earthq. Eng. Struct. Dyn. 10 (1982) 813.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/driven.h"

enum { STEPS = 40 }; /* vectors; chosen: they find what a span does up to ten times its lowest
                       * frequency, and thirteen spans up to five times theirs */
/* Residual of an eigenvector relative to its eigenvalue, which then has an error of 1e-4; chosen. */
static const double found = 1e-2;
static const double nothing = 1e-10; /* what is left of a vector when there is no further one */

struct driven_work {
	const struct hawser__driven_by *by;
	double *vector;        /* [STEPS + 1][width] */
	double T[STEPS*STEPS], y[STEPS*STEPS], theta[STEPS];
	double left;           /* what of A v_m the vectors don't contain */
	int steps;             /* vectors that were found */
};

static double *vector_of(const struct driven_work *w, int i)
{
	return w->vector + (size_t)i*w->by->width;
}

/* Vectors and T, of which the first vector is set. */
static enum hawser_status iterate(struct driven_work *w, struct hawser_report *report)
{
	int width = (int)w->by->width;
	double part[STEPS + 1];

	for (w->steps = 1; ; w->steps++) {
		int i = w->steps - 1;
		double *next = vector_of(w, i + 1);
		enum hawser_status status = w->by->follow(w->by->of, next, vector_of(w, i), report);

		if (status)
			return status;
		for (int pass = 0; pass < 2; pass++) {
			w->by->products(w->by->of, part, w->vector, w->steps, next);
			cblas_dgemv(CblasRowMajor, CblasTrans, w->steps, width, -1.0, w->vector, width, part, 1,
			            1.0, next, 1);
			cblas_daxpy(w->steps, 1.0, part, 1, w->T + i, STEPS);
		}
		w->by->products(w->by->of, &w->left, next, 1, next);
		w->left = sqrt(fmax(w->left, 0.0));
		if (w->left <= nothing*w->T[0] || w->steps == STEPS)
			return HAWSER_OK;
		cblas_dscal(width, 1.0/w->left, next, 1);
	}
}

/* The eigenvectors of T by falling theta in the rows of y; returns 0, or 1 if LAPACK fails. */
static int decompose(struct driven_work *w)
{
	for (int i = 0; i < w->steps; i++)
		for (int j = 0; j <= i; j++)
			w->y[(size_t)i*STEPS + j] = w->y[(size_t)j*STEPS + i] =
				i - j <= 1 ? -w->T[j*STEPS + i] : 0.0;
	/* column-major: the eigenvectors become rows */
	return LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'U', w->steps, w->y, STEPS, w->theta) != 0;
}

/* The motions that are found, and reach. `size`: |z_0|. */
static void choose(struct hawser__driven *driven, const struct driven_work *w, double size)
{
	int reached = 0;

	for (int s = 0; s < w->steps && -w->theta[s] > 0.0; s++) {
		const double *y = w->y + (size_t)s*STEPS;
		double theta = -w->theta[s];

		reached |= fabs(w->left*y[w->steps - 1]) > found*theta;
		driven->reach = reached ? driven->reach : 1.0/sqrt(theta);
		driven->omega2[s] = 1.0/theta;
		driven->force[s] = size*y[0]/theta;
		for (int i = 0; i < w->steps; i++)
			cblas_daxpy((int)driven->width, y[i], vector_of(w, i), 1,
			            hawser__driven_field(driven, 2 + s), 1);
		driven->known = s + 1;
	}
}

enum hawser_status hawser__driven_open(struct hawser__driven *driven, size_t width,
                                       struct hawser_report *report)
{
	*driven = (struct hawser__driven){.width = width,
		.omega2 = hawser__numbers(STEPS, 1), .force = hawser__numbers(STEPS, 1),
		.field = hawser__numbers(2 + STEPS, width)};
	return driven->omega2 && driven->force && driven->field ? HAWSER_OK
	       : hawser__no_memory(report, "line rom");
}

enum hawser_status hawser__driven_find(struct hawser__driven *driven,
                                       const struct hawser__driven_by *by,
                                       struct hawser_report *report)
{
	const double *z = driven->field;
	double size;
	enum hawser_status status = by->follow(by->of, hawser__driven_field(driven, 1), z, report);
	struct driven_work *w;

	by->products(by->of, &size, z, 1, z);
	size = sqrt(fmax(size, 0.0));
	if (status || !(size > 0.0))
		return status;
	w = calloc(1, sizeof *w);
	if (w) {
		w->by = by;
		w->vector = hawser__numbers(STEPS + 1, by->width);
	}
	if (!w || !w->vector) {
		free(w);
		return hawser__no_memory(report, "line rom");
	}
	cblas_daxpy((int)by->width, 1.0/size, z, 1, w->vector, 1);
	status = iterate(w, report);
	if (!status && decompose(w))
		status = hawser__no_memory(report, "line rom");
	else if (!status)
		choose(driven, w, size);
	free(w->vector);
	free(w);
	return status;
}

void hawser__driven_clear(struct hawser__driven *driven)
{
	free(driven->omega2);
	free(driven->force);
	free(driven->field);
	*driven = (struct hawser__driven){.known = 0};
}
