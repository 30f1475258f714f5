/* study/identify/least_squares.c - see study/identify/identify.h.
 *
 *    r, J    residuals and their derivatives; a "row" of J are the derivatives by one unknown
 *    d       step: least squares of r + J d and sqrt(damp) |J_a| d_a for each unknown a
 *
 * The step is computed from the QR decomposition of both together, so that nearly dependent unknowns
 * cost half the digits that normal equations would (Nocedal and Wright 2006, section 10.3). Damping
 * relative to |J_a| makes the steps independent of the units of the unknowns (Marquardt 1963).
 *
 * GSL's and MINPACK's solvers are not used: GSL's ends the process where memory is short, and Debian's
 * MINPACK for C cannot be linked statically.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include "core/report.h"
#include "study/identify/identify.h"

#define FIRST_DAMPING 1e-3  /* Marquardt's 0.01 or less: starts are near */
#define MORE_DAMPING 8.0    /* factor after a step that failed; Marquardt has 10 */
#define LESS_DAMPING 20.0   /* divisor after a step that succeeded: few steps are wanted */
#define LEAST_DAMPING 1e-14 /* round-off of the matrix */
#define MOST_DAMPING 1e12  /* no step decreases the sum: the minimum, to round-off */
#define LEAST_FALL 1e-13   /* of the sum of squares, relative */

struct work {
	double *r, *J, *trial; /* [count], [unknowns][count], [count] */
	double *matrix, *right; /* [unknowns][count + unknowns], [count + unknowns] */
	double *at;             /* [unknowns] */
	double damp;
};

static double sum_of_squares(const double *r, int count)
{
	double sum = 0.0;

	for (int i = 0; i < count; i++)
		sum += r[i]*r[i];
	return sum;
}

/* The step for the present damping, in work->right. Returns 0 if the matrix has not full rank. */
static int propose(struct work *work, const struct hawser__least_squares *problem, int *starved)
{
	int n = problem->unknowns, m = problem->count, rows = m + n, info;

	memset(work->matrix, 0, (size_t)rows*(size_t)n*sizeof *work->matrix);
	for (int a = 0; a < n; a++) {
		const double *column = work->J + (size_t)a*(size_t)m;

		memcpy(work->matrix + (size_t)a*(size_t)rows, column, (size_t)m*sizeof *column);
		work->matrix[a*rows + m + a] = sqrt(work->damp*sum_of_squares(column, m));
	}
	for (int i = 0; i < rows; i++)
		work->right[i] = i < m ? -work->r[i] : 0.0;
	info = LAPACKE_dgels(LAPACK_COL_MAJOR, 'N', rows, n, 1, work->matrix, rows, work->right, rows);
	*starved = hawser__lapack_starved(info);
	return info == 0;
}

/* One step that decreases the sum of squares. *done: there is none, or it is small. */
static enum hawser_status advance(double *x, double *sum, int *done, struct work *work,
                                  const struct hawser__least_squares *problem)
{
	size_t n = (size_t)problem->unknowns;
	int starved;

	for (*done = 1; work->damp < MOST_DAMPING; work->damp *= MORE_DAMPING) {
		enum hawser_status status;
		double longest = 0.0, now;

		if (!propose(work, problem, &starved)) {
			if (starved)
				return HAWSER_ERR_MEMORY;
			continue;
		}
		for (size_t a = 0; a < n; a++) {
			longest = fmax(longest, fabs(work->right[a]));
			work->at[a] = x[a] + work->right[a];
		}
		status = problem->residuals(problem->context, work->trial, NULL, work->at);
		if (status == HAWSER_ERR_MEMORY)
			return status;
		now = status ? INFINITY : sum_of_squares(work->trial, problem->count);
		if (!(now <= *sum))
			continue;
		*done = *sum - now <= LEAST_FALL**sum + DBL_MIN || longest <= problem->least_step;
		*sum = now;
		memcpy(x, work->at, n*sizeof *x);
		memcpy(work->r, work->trial, (size_t)problem->count*sizeof *work->r);
		work->damp = fmax(work->damp/LESS_DAMPING, LEAST_DAMPING);
		break;
	}
	return HAWSER_OK;
}

enum hawser_status hawser__least_squares(double *x, double *sum, int *steps,
                                         const struct hawser__least_squares *problem)
{
	size_t n = (size_t)problem->unknowns, m = (size_t)problem->count;
	struct work work = {.damp = FIRST_DAMPING};
	double *all = malloc((2*m + n*m + (n + 1)*(m + n) + n)*sizeof *all);
	enum hawser_status status;
	int done = 0;

	*steps = 0;
	if (!all)
		return HAWSER_ERR_MEMORY;
	work.r = all;
	work.trial = work.r + m;
	work.J = work.trial + m;
	work.matrix = work.J + n*m;
	work.right = work.matrix + n*(m + n);
	work.at = work.right + m + n;
	status = problem->residuals(problem->context, work.r, NULL, x);
	*sum = status ? INFINITY : sum_of_squares(work.r, problem->count);
	while (!status && !done && *steps < problem->steps) {
		status = problem->residuals(problem->context, NULL, work.J, x);
		if (!status)
			status = advance(x, sum, &done, &work, problem);
		*steps += !done;
	}
	free(all);
	return status;
}
