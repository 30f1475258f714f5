/* rom/energy/exact_bend.c - bending stiffness in a model with the exact energy of stretching.
 *
 *   phi     rotation b/g or c/g;  beta, kappa   EI/(H d^2), stiffness of the rotation of an end
 *   T g phi^2 + beta phi'^2, and kappa phi^2 at the ends: twice the energy of a small motion that is
 *           not of stretching
 *
 * The energy of bending is quadratic in phi (doc/theory-bending.md), so that it adds a constant matrix,
 * and between quasi-static displacements of supports and the coordinates a constant row for each. It is
 * integrated on the grid of the modes, where phi is a polynomial, and exactly.
 *
 * The stretching is collocated at p points of an element (exact.c), and phi is of degree p there: the
 * square of its highest function, P_p, is 0 at all of them. What the quadrature at these points leaves
 * out of T g phi^2 is added to the matrix. The tangent at rest is then that of the modes, and no
 * function is without stiffness.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/condense/follow.h"
#include "rom/energy/exact.h"

/* Rows of a strain: those of bend.h, then sqrt(weight T/g) times b and c on the grid of the modes, and
 * the same at the quadrature points. The product of the first two parts less that of the third is what
 * is added. */
struct rows {
	int count, first, last; /* of strains; numbers in a row before the third part, and in it */
	double *row;
};

static enum hawser_status rows_make(struct rows *rows, const struct hawser__bend *bend, int count,
                                    int points, struct hawser_report *report)
{
	*rows = (struct rows){.count = count, .first = hawser__bend_width(bend) + 2*bend->points,
	                      .last = 2*points};
	rows->row = calloc((size_t)count*(size_t)(rows->first + rows->last) + 1, sizeof *rows->row);
	return rows->row ? HAWSER_OK : hawser__no_memory(report, "rom");
}

/* sqrt(weight T/g) */
static double root_at(const struct hawser_statics *st, double s, double weight)
{
	double strain = hawser_statics_frame(st, s).strain;

	return sqrt(weight*strain/((1.0 + strain)*st->epsilon));
}

/* The row of `strain` [points of the modes][3], which is `at` [points][3] at the quadrature points. */
static void fill(struct rows *rows, int number, const struct hawser_modes *modes,
                 const struct hawser__bend *bend, const struct hawser_grid *rule,
                 const double *strain, const double *at)
{
	double *row = rows->row + (size_t)number*(size_t)(rows->first + rows->last);
	double *more = row + hawser__bend_width(bend), *third = row + rows->first;

	hawser__bend_rows(row, bend, strain);
	for (int p = 0; p < bend->points; p++) {
		double root = root_at(&modes->statics, modes->grid.s[p], modes->grid.weight[p]);

		more[2*p] = root*strain[3*p + 1];
		more[2*p + 1] = root*strain[3*p + 2];
	}
	for (int p = 0; p < rule->points; p++) {
		double root = root_at(&modes->statics, rule->s[p], rule->weight[p]);

		third[2*p] = root*at[3*p + 1];
		third[2*p + 1] = root*at[3*p + 2];
	}
}

/* Add to product [left->count][right->count]. */
static void multiply(double *product, const struct rows *left, const struct rows *right)
{
	int wide = left->first + left->last;

	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, left->count, right->count, left->first, 1.0,
	            left->row, wide, right->row, wide, 1.0, product, right->count);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, left->count, right->count, left->last, -1.0,
	            left->row + left->first, wide, right->row + right->first, wide, 1.0, product,
	            right->count);
}

/* Rows of the coordinates, in the order of the model. */
static enum hawser_status of_modes(struct rows *rows, const struct hawser_rom_exact *exact,
                                   const struct hawser_modes *modes,
                                   const struct hawser__bend *bend, struct hawser_report *report)
{
	int in = exact->in, out = exact->out;
	enum hawser_status status = rows_make(rows, bend, exact->n, exact->points, report);
	double *at = calloc(3*(size_t)exact->points + 1, sizeof *at);

	if (!status && !at)
		status = hawser__no_memory(report, "rom");
	for (int i = 0; !status && i < exact->n; i++) {
		for (size_t p = 0; p < (size_t)exact->points; p++) {
			at[3*p + 1] = i < in ? exact->slope[(2*p + 1)*(size_t)in + (size_t)i] : 0.0;
			at[3*p + 2] = i < in ? 0.0 : exact->slope_z[p*(size_t)out + (size_t)(i - in)];
		}
		fill(rows, exact->index[i], modes, bend, &exact->grid,
		     modes->slope + (size_t)exact->index[i]*3*(size_t)modes->grid.points, at);
	}
	free(at);
	return status;
}

enum hawser_status hawser__exact_bend(double *matrix, const struct hawser_rom_exact *exact,
                                      const struct hawser_modes *modes,
                                      struct hawser_report *report)
{
	struct hawser__stations stations;
	struct rows rows = {.count = 0};
	enum hawser_status status = hawser__stations_make(&stations, modes, 0, NULL, 0, report);

	if (!status && stations.bend)
		status = of_modes(&rows, exact, modes, stations.bend, report);
	if (!status && stations.bend)
		multiply(matrix, &rows, &rows);
	free(rows.row);
	hawser__stations_clear(&stations);
	return status;
}

enum hawser_status hawser__exact_bend_pull(double *pull, const struct hawser_rom_exact *exact,
                                           const struct hawser_modes *modes, const double *strain,
                                           const double *at, struct hawser_report *report)
{
	struct hawser__stations stations;
	struct rows rows = {.count = 0}, one = {.count = 0};
	enum hawser_status status = hawser__stations_make(&stations, modes, 0, NULL, 0, report);
	const struct hawser__bend *bend = stations.bend;

	if (!status && bend)
		status = of_modes(&rows, exact, modes, bend, report);
	if (!status && bend)
		status = rows_make(&one, bend, 1, exact->points, report);
	if (!status && bend) {
		fill(&one, 0, modes, bend, &exact->grid, strain, at);
		multiply(pull, &one, &rows);
	}
	free(rows.row);
	free(one.row);
	hawser__stations_clear(&stations);
	return status;
}
