/* response/floquet/half_class.c - see half.h: what begins in the coordinates that a motion
 * leaves at rest. SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "response/floquet/half.h"

static const char where[] = "backbone";

/* block [count][count], column-major: the part of class `c` with its sign or the opposite one.
 * Returns its size. */
static int block_of(const struct hawser__half *half, double *block, int c, int other)
{
	int n = half->base.n, count = 0;

	for (int j = 0; j < n; j++)
		count += half->class_of[j] == c;
	for (int j = 0, row = 0; j < n; j++) {
		if (half->class_of[j] != c)
			continue;
		for (int k = 0, column = 0; k < n; k++)
			if (half->class_of[k] == c)
				block[(size_t)count*column++ + row] = hawser__half_entry(half, j, k, other);
		row++;
	}
	return count;
}

double hawser__half_class_determinant(struct hawser__half *half, int c, int other, double least)
{
	double value = 1.0;
	int count = block_of(half, half->matrix, c, other);

	for (int j = 0, row = 0; j < half->base.n; j++) {
		double length = hawser__half_length(half, j, other);

		if (half->class_of[j] != c)
			continue;
		for (int k = 0; k < count; k++)
			half->matrix[(size_t)k*count + row] /= length;
		row++;
	}
	if (LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, count, count, half->matrix, count, half->pivot))
		return 0.0;
	for (int j = 0; j < count; j++) {
		double pivot = half->matrix[(size_t)j*count + j];

		if (fabs(pivot) < least)
			return 0.0;
		value *= half->pivot[j] != j + 1 ? -pivot : pivot;
	}
	return value;
}

enum hawser_status hawser__half_class_other(struct hawser__half *half, double *s, int c, int other,
                                            struct hawser_report *report)
{
	int n = half->base.n, count = block_of(half, half->matrix, c, other), info, next = 0;
	double *room = malloc(((size_t)count*count + 2*(size_t)count)*sizeof *room), length = 0.0;

	if (!room)
		return hawser__no_memory(report, where);
	info = LAPACKE_dgesvd(LAPACK_COL_MAJOR, 'N', 'A', count, count, half->matrix, count,
	                      room + (size_t)count*count, NULL, 1, room, count,
	                      room + (size_t)count*count + count);
	for (int k = 0; k <= n; k++) {
		s[k] = k < n && half->class_of[k] == c ? room[(size_t)count*next++ + count - 1] : 0.0;
		length += k < n ? s[k]*s[k]*half->base.weight[k] : 0.0;
	}
	for (int k = 0; k < n; k++)
		s[k] /= sqrt(length);
	free(room);
	return info ? hawser__fail(report, HAWSER_ERR_CONVERGENCE, where,
	                           "the curves at a branch point were not found") : HAWSER_OK;
}
