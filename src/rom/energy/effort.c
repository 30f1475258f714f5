/* rom/energy/effort.c - estimated times of forces and tangents from tensors and from functions.
 *
 * Both are a number of operations times a measured rate. bench/kernel prints estimate and
 * measurement of each task; only ratios matter, which differ little between processors.
 *
 *    entries   of C
 *    pass      multiplications by the table of strains: points (2 in + out)
 *    products  multiplications of the matrix products in a tangent (quartic_tangent.c)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rom/energy/kernel.h"

/* Nanoseconds per call, per n^2, and per operation. Measured with bench/kernel on a Xeon of 2.5 GHz
 * (Cooper Lake), chairlift and deep sag with 3 to 60 modes, condensed and not; the estimates are
 * within 30 % of most of these measurements. `beyond`: further nanoseconds of each operation beyond
 * CACHED, from which the tensors of tangents do not fit in a cache of 4 MB. */
#define CACHED 4e5
static const struct rate {
	double call, square, operation, beyond;
} tensor_rate[HAWSER__TASKS] = { /* operation: an entry of C */
	[HAWSER__FORCE] = {30.0, 1.4, 0.18, 0.0},
	[HAWSER__TANGENT] = {30.0, 1.4, 0.18, 0.0},
	[HAWSER__FORCES] = {5.0, 0.4, 0.036, 0.0},
	[HAWSER__TANGENTS] = {5.0, 0.6, 0.085, 0.11},
}, force_rate = {30.0, 0.04, 0.075, 0.0},   /* operation: a multiplication by the table of strains */
   product_rate = {800.0, 1.0, 0.075, 0.0}; /* operation: a multiplication in a matrix product */

static double time_of(const struct rate *rate, double n, double operations)
{
	return rate->call + rate->square*n*n + rate->operation*operations +
	       (operations > CACHED ? rate->beyond*(operations - CACHED) : 0.0);
}

/* Products of tables and vectors in a force. */
static double force_operations(const struct hawser__size *size)
{
	double ends = size->condensed ? 5.0 : 0.0;
	double pass = size->points*(2.0*size->in + size->out), all = size->n - size->in - size->out;

	/* the shapes are in the plane nearly always */
	return size->condensed ? 4.0*pass + 2.0*size->points*(ends + 2.0*all) : 2.0*pass;
}

static double tangent_operations(const struct hawser__size *size)
{
	double in = size->in, out = size->out, modes = in + out, rows = size->n + 3.0;
	double strains = size->points*(2.0*in*in + in*out + out*out);

	/* pull, B Y by plane, and Y'B Y */
	return size->condensed ? strains + 0.5*modes*modes*rows + 0.5*rows*rows*modes +
	                         modes*modes*rows
	                       : strains;
}

void hawser__effort(struct hawser__effort *effort, const struct hawser__size *size)
{
	double n = size->n, force = time_of(&force_rate, n, force_operations(size));
	double tangent = force + time_of(&product_rate, n, tangent_operations(size));

	for (int task = 0; task < HAWSER__TASKS; task++) {
		int derive = task == HAWSER__TANGENT || task == HAWSER__TANGENTS;

		effort->tensors[task] = time_of(&tensor_rate[task], n, size->cubics);
		effort->functions[task] = derive ? tangent : force;
	}
}

double hawser__function_flops(const struct hawser__size *size, int tangent)
{
	const double point = 45.0, stiff_point = 40.0; /* operations at a point, counted in quartic.c */
	double n = size->n, sum = 2.0*force_operations(size) + point*size->points + 2.0*n*n;

	return tangent ? sum + 2.0*tangent_operations(size) + stiff_point*size->points + 2.0*n*n : sum;
}
