/* modes/complex/gyroscopic_span.c - real coordinates that carry the complex modes of a travelling
 * cable.
 *
 *   Phi_j, w_j   transverse modes of a basis of the apparent cable at rest, one plane
 *   v            real or imaginary part of a complex mode, as a sum of Phi_j
 *   z_j = w_j v_j, so that z.z is twice the strain energy of v
 *   mu           eigenvalues of the mass matrix of orthonormal z, 1/omega^2
 *
 * The frequency of a complex mode in a model of n modes at rest converges like n^-3 only, since the
 * speed couples each of them with all others. The two parts of the complex modes themselves span a
 * space in which these frequencies are exact, and which has two coordinates for each. Rayleigh and
 * Ritz's method in this space gives mass and stiffness that are diagonal, so that its coordinates take
 * the place of modes in a reduced model.
 *
 * Longitudinal modes are left out of v. Their shares are small, but the parts of the complex modes are
 * nearly dependent, and what remains of one after the others would be longitudinal for the most: a
 * coordinate that stretches the cable and is neither followed nor resolved (doc/theory-rom.md, "Which
 * modes are kept"). All longitudinal motion then follows.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/gyroscopic.h>

#include "core/report.h"
#include "modes/label.h"
#include "modes/spectral.h"

/* A part that adds less than this to the space, as a share of its own size in the norm of the energy,
 * is round-off of the others: the square is an error of a frequency. Chosen. */
static const double new_part = 1e-5;

struct side {
	int n, want, have; /* transverse modes; coordinates asked for, and so far */
	int *of;           /* [n] their indices in the basis */
	double *z;         /* [want] columns of n */
	double *mu;        /* [want] ascending */
	double *mass;      /* [want][want], then its eigenvectors, by rows */
};

static void side_clear(struct side *side)
{
	free(side->of);
	free(side->z);
	free(side->mu);
	free(side->mass);
}

static enum hawser_status side_open(struct side *side, const struct hawser_modes *basis, int plane,
                                    int want, struct hawser_report *report)
{
	size_t most = (size_t)basis->n + 1, w = (size_t)want + 1;

	*side = (struct side){.want = want};
	side->of = calloc(most, sizeof *side->of);
	side->z = calloc(most*w, sizeof *side->z);
	side->mu = calloc(w, sizeof *side->mu);
	side->mass = calloc(w*w, sizeof *side->mass);
	if (!side->of || !side->z || !side->mu || !side->mass)
		return hawser__no_memory(report, "modes");
	for (int j = 0; j < basis->n; j++)
		if ((int)basis->mode[j].plane == plane && basis->mode[j].family == HAWSER_TRANSVERSE)
			side->of[side->n++] = j;
	if (side->n < want)
		return hawser__spectral_too_few(want, side->n, report);
	return HAWSER_OK;
}

/* The next column of z becomes a coordinate, unless the others have it already. */
static void take(struct side *side)
{
	int n = side->n;
	double *z = side->z + (size_t)side->have*(size_t)n, size = cblas_dnrm2(n, z, 1), left;

	for (int pass = 0; pass < 2; pass++) /* twice is enough for round-off */
		for (int k = 0; k < side->have; k++) {
			const double *other = side->z + (size_t)k*(size_t)n;

			cblas_daxpy(n, -cblas_ddot(n, z, 1, other, 1), other, 1, z, 1);
		}
	left = cblas_dnrm2(n, z, 1);
	if (!(left > new_part*size))
		return;
	cblas_dscal(n, 1.0/left, z, 1);
	side->have++;
}

/* Both parts of complex mode k; shape [points][6] of it at the points of the basis. */
static void take_mode(struct side *side, const struct hawser_modes *basis, const double *shape)
{
	const struct hawser_grid *grid = &basis->grid;

	for (int part = 0; part < 2 && side->have < side->want; part++) {
		double *z = side->z + (size_t)side->have*(size_t)side->n;

		for (int j = 0; j < side->n; j++) {
			const double *phi = basis->shape + (size_t)side->of[j]*3*(size_t)grid->points;
			double sum = 0.0;

			for (int i = 0; i < grid->points; i++)
				sum += grid->weight[i]*cblas_ddot(3, phi + 3*i, 1, shape + 6*i + 3*part, 1);
			z[j] = basis->mode[side->of[j]].omega*sum;
		}
		take(side);
	}
}

/* Without speed the second parts vanish: the next modes at rest take their places, so that the number
 * of coordinates does not depend on the speed. */
static void fill(struct side *side)
{
	for (int j = 0; j < side->n && side->have < side->want; j++) {
		double *z = side->z + (size_t)side->have*(size_t)side->n;

		memset(z, 0, (size_t)side->n*sizeof *z);
		z[j] = 1.0;
		take(side);
	}
}

static enum hawser_status diagonalise(struct side *side, const struct hawser_modes *basis,
                                      struct hawser_report *report)
{
	int n = side->n, w = side->have, info;

	for (int a = 0; a < w; a++)
		for (int b = 0; b <= a; b++) {
			double sum = 0.0;

			for (int j = 0; j < n; j++)
				sum += side->z[a*n + j]*side->z[b*n + j]/pow(basis->mode[side->of[j]].omega, 2);
			side->mass[a*w + b] = side->mass[b*w + a] = sum;
		}
	info = w > 0 ? LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'L', w, side->mass, w, side->mu) : 0;
	if (info)
		return hawser__lapack_starved(info) ? hawser__no_memory(report, "modes")
		       : hawser__fail(report, HAWSER_ERR_NAN, "modes",
		                      "the eigenvalue solver met a not-a-number with %d parts of complex "
		                      "modes: check EA, rho, d, the speed and the tension of the span", w);
	return HAWSER_OK;
}

/* Coordinate k of the result: the one of largest mu that is left. */
static void unfold(struct hawser_modes *modes, int k, struct side *side,
                   const struct hawser_modes *basis)
{
	int n = side->n, w = side->want, row = 3*basis->grid.points;
	const double *vector = side->mass + (size_t)--side->have*(size_t)w;
	struct hawser_mode *mode = &modes->mode[k];

	mode->omega = 1.0/sqrt(side->mu[side->have]);
	mode->plane = basis->mode[side->of[0]].plane;
	mode->condition = 1.0;
	for (int j = 0; j < n; j++) {
		size_t from = (size_t)side->of[j]*(size_t)row, to = (size_t)k*(size_t)row;
		double part = mode->omega*cblas_ddot(w, vector, 1, side->z + j, n)/
		              basis->mode[side->of[j]].omega;

		cblas_daxpy(row, part, basis->shape + from, 1, modes->shape + to, 1);
		cblas_daxpy(row, part, basis->slope + from, 1, modes->slope + to, 1);
	}
}

static enum hawser_status collect(struct hawser_modes *modes, struct side side[2],
                                  struct hawser_modes *basis, struct hawser_report *report)
{
	enum hawser_status status;

	modes->statics = basis->statics;
	status = hawser__modes_allocate(modes, side[0].have + side[1].have, basis->grid.points, report);
	for (int k = 0; !status && k < modes->n; k++) {
		int q = side[0].have == 0 || (side[1].have > 0 && side[1].mu[side[1].have - 1] >
		                              side[0].mu[side[0].have - 1]);

		unfold(modes, k, &side[q], basis);
	}
	if (status)
		return status;
	modes->method = "span of complex modes";
	modes->spanned = 1;
	modes->basis = basis->basis;
	modes->time_unit = basis->time_unit;
	modes->grid = basis->grid;
	basis->grid = (struct hawser_grid){0};
	return hawser__modes_label(modes, report);
}

static enum hawser_status span(struct side side[2], const struct hawser_modes *complex_modes,
                               const struct hawser_modes *basis, struct hawser_report *report)
{
	int points = basis->grid.points, count[2] = {0};
	double *shape = malloc(6*(size_t)points*sizeof *shape);
	enum hawser_status status = shape ? HAWSER_OK : hawser__no_memory(report, "modes");

	for (int k = 0; k < complex_modes->n; k++)
		count[complex_modes->mode[k].plane]++;
	for (int q = 0; !status && q < 2; q++)
		status = side_open(&side[q], basis, q, 2*count[q], report);
	for (int k = 0; !status && k < complex_modes->n; k++) {
		for (int i = 0; i < points; i++)
			hawser_modes_at(complex_modes, shape + 6*i, NULL, k, basis->grid.s[i]);
		take_mode(&side[complex_modes->mode[k].plane], basis, shape);
	}
	for (int q = 0; !status && q < 2; q++) {
		fill(&side[q]);
		status = diagonalise(&side[q], basis, report);
	}
	free(shape);
	return status;
}

enum hawser_status hawser_complex_modes_span(struct hawser_modes *modes,
                                             const struct hawser_statics *statics,
                                             const struct hawser_modes_options *options,
                                             struct hawser_report *report)
{
	struct hawser_modes complex_modes, basis = {.n = 0};
	struct side side[2] = {{0}};
	enum hawser_status status = hawser_complex_modes_solve(&complex_modes, statics, options, report);

	*modes = (struct hawser_modes){.n = 0};
	if (!status && (statics->space || statics->bending.EI > 0.0 || statics->attachments > 0))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                      "the span of complex modes is that of a bare cable in its plane");
	if (!status)
		status = hawser_modes_basis(&basis, statics, complex_modes.basis, complex_modes.basis, report);
	if (!status)
		status = span(side, &complex_modes, &basis, report);
	if (!status)
		status = collect(modes, side, &basis, report);
	side_clear(&side[0]);
	side_clear(&side[1]);
	hawser_modes_clear(&complex_modes);
	hawser_modes_clear(&basis);
	if (status)
		hawser_modes_clear(modes);
	return status;
}
