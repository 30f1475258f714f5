/* tow/trajectory_pieces.c - pieces of least degree with given derivatives at both ends.
 *
 * With a conditions at the first waypoint of a piece and b at the second its degree is a + b - 1,
 * at most 13, and one small dense system in tau gives the coefficients of all three axes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include <lapacke.h>

#include "core/report.h"
#include "tow/trajectory.h"

enum { SIZE = HAWSER__TRAJECTORY_DEGREE + 1, AXES = 3 };

int hawser__waypoint_orders(const struct hawser_waypoint *point)
{
	int orders = 1;

	while (orders < HAWSER_PATH_GIVEN && point->given[orders])
		orders++;
	return orders;
}

/* The rows of one end, with the right-hand sides [SIZE][AXES] in b. */
static int rows(double *A, double *b, int row, int n, const struct hawser_waypoint *point,
                const double *origin, double half, double tau)
{
	int orders = hawser__waypoint_orders(point);

	for (int k = 0; k < orders; k++, row++) {
		hawser__trajectory_row(&A[row*n], n - 1, k, tau);
		for (int axis = 0; axis < AXES; axis++)
			b[row*AXES + axis] = (point->at[k][axis] - (k ? 0.0 : origin[axis]))*pow(half, k);
	}
	return row;
}

static enum hawser_status piece(struct hawser_path *of, const struct hawser_waypoint *point,
                                int i, struct hawser_report *report)
{
	double A[SIZE*SIZE], factors[SIZE*SIZE], b[SIZE*AXES], x[SIZE*AXES], r[SIZE], c[SIZE];
	double rcond, growth, ferr[AXES], berr[AXES], half = 0.5*(point[1].t - point[0].t);
	int n = hawser__waypoint_orders(&point[0]) + hawser__waypoint_orders(&point[1]);
	int row = rows(A, b, 0, n, &point[0], of->origin, half, -1.0);
	lapack_int pivot[SIZE], info;
	char scaled = 'N';

	rows(A, b, row, n, &point[1], of->origin, half, 1.0);
	info = LAPACKE_dgesvx(LAPACK_ROW_MAJOR, 'E', 'N', n, AXES, A, n, factors, n, pivot, &scaled, r, c,
	                      b, AXES, x, AXES, &rcond, ferr, berr, &growth);
	if (info != 0)
		return hawser__lapack_starved((int)info)
		       ? hawser__no_memory(report, "trajectory")
		       : hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "trajectory", i, rcond, "the "
		                         "piece after waypoint %d has no solution in double precision", i);
	for (int axis = 0; axis < AXES; axis++) {
		of->error = fmax(of->error, ferr[axis]);
		for (int p = 0; p < n; p++)
			of->coefficient[(AXES*i + axis)*(of->degree + 1) + p] = x[p*AXES + axis];
	}
	return HAWSER_OK;
}

enum hawser_status hawser__trajectory_pieces(struct hawser_path *of,
                                             const struct hawser_waypoint *point,
                                             struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < of->pieces && !status; i++)
		status = piece(of, &point[i], i, report);
	return status;
}
