/* modes/complex/gyroscopic_fdm.c - finite differences of B (5.36) to (5.38), as printed except for the
 * errata.
 *
 *   N        intervals; the unknowns are U, V (or W) at the N - 1 inner points, U and V alternating
 *   A        stiffness of the apparent cable (fdm.c): not symmetric
 *   C        2 nu times the central difference in the moving frame: not skew
 *   lambda   of the companion matrix [0 1; -A -C], by LAPACK
 *
 * This method exists for comparison with B only. Neither matrix has the symmetry of its operator.
 * Eigenvalues therefore leave the imaginary axis at any speed, by round-off of order N^2/epsilon
 * and where two frequencies nearly coincide: spurious growth (figures in doc/theory-gyroscopic.md).
 * The error estimate combines Weinstein's bound of im (complex_mode.c) and re, whose exact value is
 * 0. It is at least 1 if the grid does not resolve the stretch (halving.c), since in-plane modes
 * are then missing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/methods.h"
#include "modes/complex/gyroscopic.h"
#include "modes/label.h"
#include "modes/halving.h"

enum { POINTS_MAX = 250, POINTS = 60, POINTS_A_MODE = 6, APPLICATIONS = 3 };

/* Eigenvalues of one plane with im > 0, and eigenvectors. */
struct side {
	int n, count;    /* unknowns, eigenvalues kept */
	double *wr, *wi; /* [2n] */
	double *vector;  /* [2n] columns of 2n, row-major; a complex vector is a pair of columns, as in
	                  * LAPACK */
	int *order;      /* [count] columns by ascending wi */
};

static void side_clear(struct side *side)
{
	free(side->wr);
	free(side->wi);
	free(side->vector);
	free(side->order);
}

/* The terms 2 nu (U' - kappa V) and 2 nu (V' + kappa U), with a sign, in the rows of point i. */
static void convect(double *row, int stride, int i, int points, double kappa, double rate, double h)
{
	int D = stride;

	for (int c = 0; c < D; c++) {
		double *line = row + (size_t)(i*D + c)*(size_t)(2*D*points) + D*points;

		if (i > 0)
			line[(i - 1)*D + c] -= -rate*0.5/h;
		if (i < points - 1)
			line[(i + 1)*D + c] -= rate*0.5/h;
		if (D == 2)
			line[i*D + 1 - c] -= (c == 0 ? -1.0 : 1.0)*rate*kappa;
	}
}

/* [0 1; -A -C], row-major. */
static enum hawser_status companion(double *H, const struct hawser_statics *st,
                                    enum hawser_plane plane,
                                    int N, struct hawser_report *report)
{
	int points = N - 1, D = plane == HAWSER_IN_PLANE ? 2 : 1, n = D*points;
	double *A = calloc((size_t)n*(size_t)n, sizeof *A), h = st->l/N;
	enum hawser_status status = A ? hawser__fdm_dense(A, st, plane, N, report)
	                              : hawser__no_memory(report, "modes");

	for (int i = 0; i < n && !status; i++) {
		H[(size_t)i*(size_t)(2*n) + (size_t)(n + i)] = 1.0;
		for (int j = 0; j < n; j++)
			H[(size_t)(n + i)*(size_t)(2*n) + (size_t)j] = -A[i*n + j];
	}
	for (int i = 0; i < points && !status; i++) {
		double u = st->eta + st->delta*(i + 1)*h;

		convect(H + (size_t)n*(size_t)(2*n), D, i, points, st->delta/(1.0 + u*u),
		        2.0*st->motion.nu, h);
	}
	free(A);
	return status;
}

static void sort(struct side *side)
{
	for (int k = 0; k < 2*side->n; k++) {
		int at = side->count;

		if (!(side->wi[k] > 0.0))
			continue;
		for (; at > 0 && side->wi[side->order[at - 1]] > side->wi[k]; at--)
			side->order[at] = side->order[at - 1];
		side->order[at] = k;
		side->count++;
	}
}

static enum hawser_status side_solve(struct side *side, const struct hawser_statics *st,
                                     enum hawser_plane plane, int N, struct hawser_report *report)
{
	int n = (plane == HAWSER_IN_PLANE ? 2 : 1)*(N - 1);
	size_t order = 2*(size_t)n;
	double *H = calloc(order*order, sizeof *H), unused = 0.0;
	int info = 0;
	enum hawser_status status = HAWSER_OK;

	side->n = n;
	side->wr = malloc(order*sizeof *side->wr);
	side->wi = malloc(order*sizeof *side->wi);
	side->vector = malloc(order*order*sizeof *side->vector);
	side->order = malloc(order*sizeof *side->order);
	if (!H || !side->wr || !side->wi || !side->vector || !side->order)
		status = hawser__no_memory(report, "modes");
	if (!status)
		status = companion(H, st, plane, N, report);
	if (!status)
		info = LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'V', (int)order, H, (int)order, side->wr,
		                     side->wi, &unused, (int)order, side->vector, (int)order);
	if (info)
		status = hawser__lapack_starved(info) ? hawser__no_memory(report, "modes")
			: hawser__fail(report, HAWSER_ERR_NAN, "modes",
			               "the eigenvalue solver met a not-a-number with %d finite-difference "
			               "points: take another basis, or the method spectral", N - 1);
	if (!status)
		sort(side);
	free(H);
	return status;
}

/* Mode `place` of the result is the k-th of this side; x [n]. */
static enum hawser_status fill(struct hawser_modes *modes, const struct side *side,
                               enum hawser_plane plane, int place, int k, int N,
                               const struct hawser__cable *cable, double *work,
                               struct hawser_report *report)
{
	struct hawser_mode *mode = modes->mode + place;
	int column = side->order[k];
	size_t size = 3*(size_t)cable->grid.points, at = 2*(size_t)place*size;
	struct hawser__complex iterate;
	enum hawser_status status = HAWSER_OK;

	mode->plane = plane;
	mode->re = side->wr[column];
	mode->omega = side->wi[column];
	for (size_t part = 0; part < 2 && !status; part++) {
		for (int i = 0; i < side->n; i++)
			work[i] = side->vector[(size_t)i*2*(size_t)side->n + (size_t)column + part];
		status = hawser__fdm_sample(modes->shape + at + part*size, modes->slope + at + part*size,
		                            &cable->grid, work, &modes->statics, plane, N, report);
	}
	if (status)
		return status;
	hawser__complex_init(&iterate, cable, plane, modes->statics.motion.nu, work);
	hawser__complex_load(&iterate, modes->shape + at, modes->slope + at);
	iterate.omega = mode->omega;
	mode->residual = hypot(hawser__complex_bound(&iterate, APPLICATIONS), mode->re/mode->omega);
	if (hawser__unresolved(&modes->statics, N, 1))
		mode->residual = fmax(mode->residual, 1.0);
	hawser__complex_step(&iterate);
	mode->condition = iterate.condition;
	return HAWSER_OK;
}

static enum hawser_status collect(struct hawser_modes *modes, const struct side *side,
                                  int n,
                                  int N, struct hawser__cable *cable, struct hawser_report *report)
{
	int next[HAWSER__PLANES] = {0}, points = cable->grid.points;
	size_t room = HAWSER__COMPLEX_WORK*(size_t)points + 2*(size_t)N;
	double *work = calloc(room, sizeof *work);
	enum hawser_status status = work ? hawser__modes_allocate(modes, n, points, report)
	                                 : hawser__no_memory(report, "modes");

	for (int k = 0; k < n && !status; k++) {
		const struct side *in = side + HAWSER_IN_PLANE, *out = side + HAWSER_OUT_OF_PLANE;
		int q = next[0] == in->count ||
		        (next[1] < out->count && out->wi[out->order[next[1]]] < in->wi[in->order[next[0]]]);

		if (next[q] == side[q].count)
			status = hawser__fail(report, HAWSER_ERR_NAN, "modes",
			                      "the finite differences of %d points have %d oscillating modes "
			                      "where %d were requested: the others are real, which is spurious",
			                      N - 1, k, n);
		else
			status = fill(modes, side + q, (enum hawser_plane)q, k, next[q]++, N, cable, work,
			              report);
	}
	free(work);
	return status;
}

static enum hawser_status refuse(struct hawser_report *report, int n, int points)
{
	if (points > POINTS_MAX)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "%d finite-difference points are more than the %d that this method "
		                    "takes (its matrices are dense): lower model.basis, or ask for fewer "
		                    "modes", points, POINTS_MAX);
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
	                    "%d modes asked of %d finite-difference points: ask for fewer modes, or raise "
	                    "model.basis to %d or more", n, points, n);
}

enum hawser_status hawser__gyroscopic_fdm(struct hawser_modes *modes,
                                          const struct hawser_statics *statics,
                                          const struct hawser_modes_options *options,
                                          struct hawser_report *report)
{
	int n = options->n, elements = hawser__cable_elements(statics), points = options->basis;
	struct side side[HAWSER__PLANES] = {{0}, {0}};
	struct hawser__cable cable = {0};
	enum hawser_status status = HAWSER_OK;
	double worst = 0.0;

	if (statics->motion.nu == 0.0)
		return hawser__gyroscopic_at_rest(modes, statics, options, "fdm", report);
	if (points == 0)
		points = POINTS_A_MODE*n > POINTS ? POINTS_A_MODE*n : POINTS;
	if (points > POINTS_MAX || n > points)
		return refuse(report, n, points);
	for (int q = 0; q < HAWSER__PLANES && !status; q++)
		status = side_solve(&side[q], statics, (enum hawser_plane)q, points + 1, report);
	if (!status)
		status = hawser__cable_init(&cable, statics, elements,
		                            hawser__cable_degree(elements, 2*n), report);
	if (!status)
		status = collect(modes, side, n, points + 1, &cable, report);
	if (!status) {
		modes->grid = cable.grid;
		cable.grid = (struct hawser_grid){0};
		modes->basis = points;
		status = hawser__modes_label(modes, report);
	}
	for (int k = 0; !status && k < n; k++)
		worst = fmax(worst, modes->mode[k].residual);
	if (!status && options->basis == 0 && !(worst <= options->tolerance))
		status = hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "modes", 1, worst,
		                         "%d finite-difference points are within a relative error of %.1e of "
		                         "the first %d frequencies, where %.1e was asked: leave the tolerance "
		                         "away to have them with their error, or take the method spectral",
		                         points, worst, n, options->tolerance);
	hawser__cable_clear(&cable);
	side_clear(&side[0]);
	side_clear(&side[1]);
	return status;
}
