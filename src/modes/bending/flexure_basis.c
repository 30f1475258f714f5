/* modes/bending/flexure_basis.c - all Galerkin modes of a polynomial basis with bending stiffness.
 *
 *   z      coordinates of flexure.h: the energy is z.z/2, end B is at rest
 *   G      displacements of z times the roots of weights and masses: the mass is G'G
 *   G = U S V'      singular values, 1/omega; one-sided Jacobi, as in basis.c and for its reason
 *
 * The error estimate of a frequency is the share of the energy that the mode has in the two highest
 * functions of each element: what is beyond them is smaller if the basis resolves the mode at all,
 * and the frequency has an error of its square's order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/bending/bending.h"
#include "modes/complex/damped.h"
#include "modes/bending/flexure.h"
#include "modes/label.h"
#include "modes/methods.h"
#include "modes/spectral.h"

enum { FUNCTIONS_MAX = 800 }; /* of both components: the decomposition takes some seconds */

/* The result in one plane: `count` modes by ascending omega. */
struct part {
	struct hawser__flexure flexure;
	int count;
	double *G;     /* columns: displacements, orthonormal */
	double *S, *V; /* [count]; columns of z */
};

static void part_clear(struct part *part)
{
	hawser__flexure_clear(&part->flexure);
	free(part->G);
	free(part->S);
	free(part->V);
}

static enum hawser_status solve(struct part *part, const struct hawser_statics *st,
                                const struct hawser_grid *grid, int degree, int plane,
                                struct hawser_report *report)
{
	struct hawser__flexure *t = &part->flexure;
	enum hawser_status status = hawser__flexure_init(t, st, grid, degree, plane, report);
	double stat[6] = {0.0};
	int n = t->free, info;

	if (!status)
		status = hawser__flexure_roots(&part->G, t, st, report);
	if (status)
		return status;
	part->S = calloc((size_t)n, sizeof *part->S);
	part->V = calloc((size_t)n*(size_t)n, sizeof *part->V);
	if (!part->S || !part->V)
		return hawser__no_memory(report, "modes");
	info = LAPACKE_dgesvj(LAPACK_COL_MAJOR, 'G', 'U', 'V', t->rows, n, part->G, t->rows, part->S, 0,
	                      part->V, n, stat);
	if (hawser__lapack_starved(info))
		return hawser__no_memory(report, "modes");
	if (info)
		return hawser__fail(report, HAWSER_ERR_NAN, "modes",
		                    "the modes of a basis of %d functions with cable.EI did not come out: "
		                    "check EA, EI, rho, d and the tension of the span", n);
	cblas_dscal(n, stat[0], part->S, 1);
	part->count = n;
	return HAWSER_OK;
}

/* Displacements in the local frame from column k of G, which has fixed axes. */
static void shape_of(double *shape, const struct part *part, const struct hawser_statics *st, int k)
{
	const struct hawser__flexure *t = &part->flexure;
	const double *U = part->G + (size_t)k*(size_t)t->rows;

	for (int i = 0; i < t->points; i++, shape += 3) {
		double root = sqrt(t->grid->weight[i]), c, s;

		if (t->D == 1) {
			shape[2] = U[i]/root;
			continue;
		}
		hawser__flexure_axes(&c, &s, st, t->grid->s[i]);
		shape[0] = (c*U[i] + s*U[t->points + i])/root;
		shape[1] = (c*U[t->points + i] - s*U[i])/root;
	}
}

/* Mode k of `part` as mode `to`. */
static enum hawser_status fill(struct hawser_modes *modes, int to, const struct part *part, int k,
                               double *y, struct hawser_report *report)
{
	const struct hawser__flexure *t = &part->flexure;
	size_t row = 3*(size_t)t->points;
	double *slope = modes->slope + (size_t)to*row, omega = 1.0/part->S[k];
	enum hawser_status status = hawser__flexure_expand(y, t, part->V + (size_t)k*(size_t)t->free,
	                                                   report);

	if (!status)
		status = hawser__flexure_hold(y, t, report);
	if (status)
		return status;
	hawser__flexure_strain(slope, t, y);
	cblas_dscal((int)row, omega, slope, 1);
	shape_of(modes->shape + (size_t)to*row, part, &modes->statics, k);
	modes->mode[to].plane = (enum hawser_plane)t->plane;
	modes->mode[to].omega = omega;
	modes->mode[to].residual = hawser__spectral_round_off(t->elements) +
	                           0.5*hawser__flexure_tail(t, y);
	return HAWSER_OK;
}

/* Merge both planes by ascending omega. */
static enum hawser_status finish(struct hawser_modes *modes, struct hawser_grid *grid,
                                 const struct part *part, struct hawser_report *report)
{
	int next[2] = {0}, n = part[0].count + part[1].count;
	int most = part[0].flexure.functions > part[1].flexure.functions ? part[0].flexure.functions
	                                                                 : part[1].flexure.functions;
	double *y = malloc((size_t)most*sizeof *y);
	enum hawser_status status = y ? hawser__modes_allocate(modes, n, grid->points, report)
	                              : hawser__no_memory(report, "modes");

	for (int k = 0; !status && k < n; k++) {
		int q = next[1] == part[1].count ||
		        (next[0] < part[0].count && part[0].S[next[0]] >= part[1].S[next[1]]) ? 0 : 1;

		status = fill(modes, k, &part[q], next[q]++, y, report);
	}
	free(y);
	if (status)
		return status;
	modes->grid = *grid;
	*grid = (struct hawser_grid){0};
	return hawser__modes_label(modes, report);
}

enum hawser_status hawser__flexure_basis(struct hawser_modes *modes, const struct hawser_statics *st,
                                         const int degree[2], double waves,
                                         struct hawser_report *report)
{
	int most = degree[0] > degree[1] ? degree[0] : degree[1], elements;
	double *edge = NULL;
	struct hawser_grid grid = {0};
	struct part part[2] = {{.count = 0}};
	enum hawser_status status = hawser__flexure_edges(&edge, &elements, st, most, waves, report);

	*modes = (struct hawser_modes){.statics = *st};
	if (!status && 2*elements*most > FUNCTIONS_MAX)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                      "a basis of %d elements of degree %d with cable.EI: at most %d "
		                      "functions, ask for fewer", elements, most, FUNCTIONS_MAX/2);
	if (!status)
		status = hawser__grid_init(&grid, elements, 2*(most + 1), edge, NULL, report);
	free(edge);
	for (int q = 0; q < 2 && !status; q++)
		if (degree[q] > 0)
			status = solve(&part[q], st, &grid, degree[q], q, report);
	if (!status)
		status = finish(modes, &grid, part, report);
	hawser__grid_clear(&grid);
	part_clear(&part[0]);
	part_clear(&part[1]);
	if (status) {
		hawser_modes_clear(modes);
		return status;
	}
	modes->method = "basis";
	modes->basis = most*elements - 1;
	modes->time_unit = st->span.d*sqrt(st->span.rho/st->H);
	return HAWSER_OK;
}

/* The degree follows from the number of functions, with one element between the boundary layers. */
enum hawser_status hawser__flexure_functions(int degree[2], const struct hawser_statics *st,
                                             const int functions[2],
                                             struct hawser_report *report)
{
	enum { LEAST = 4 };
	enum hawser_status status = HAWSER_OK;

	for (int q = 0; q < 2 && !status; q++) {
		double *edge = NULL;
		int elements = 1;

		degree[q] = 0;
		if (functions[q] < 1)
			continue;
		status = hawser__flexure_edges(&edge, &elements, st, LEAST, 1.0, report);
		free(edge);
		degree[q] = functions[q]/elements > LEAST ? (functions[q] + 1)/elements : LEAST;
	}
	return status;
}

enum hawser_status hawser__damped_bending(struct hawser__damped_pair *pair,
                                          const struct hawser_statics *st, int n, int tries,
                                          struct hawser_report *report)
{
	enum { FIRST = 10, MORE = 3 };
	int coarse = FIRST + 2*MORE*tries, fine = coarse + MORE;
	struct hawser_statics held = *st;
	enum hawser_status status;

	for (int i = 0; i < held.attachments; i++)
		held.attached[i].absorber = 0.0;
	status = hawser__modes_check_statics(&held, report);
	if (!status)
		status = hawser__flexure_basis(&pair->fine, &held, (int[]){fine, fine}, 0.5*n + 1.0,
		                               report);
	if (!status)
		status = hawser__flexure_basis(&pair->coarse, &held, (int[]){coarse, coarse}, 0.5*n + 1.0,
		                               report);
	if (status)
		hawser__damped_pair_clear(pair);
	else
		pair->functions = pair->fine.basis;
	return status;
}
