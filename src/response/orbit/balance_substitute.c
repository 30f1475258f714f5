/* response/orbit/balance_substitute.c - the solution of the equations of one step of
 * balance_blocks.h from their LU factors.
 *
 * Every iteration of GMRES solves the equations of all steps one after the other, each with a single
 * right side. For this case LAPACK calls a vector operation a column, whose call takes as long as its
 * arithmetic. Here S columns are subtracted at a time: the order of the equations is a multiple of
 * the number of nodes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/hot.h"
#include "response/orbit/balance.h"

#define S HAWSER__BLOCK_NODES

/* x[rows from..to) -= columns [S] of the factors times values [S]. */
HAWSER_PART void subtract(float *x, const float *column, int count, int from, int to,
                          const float *value)
{
	for (int r = from; r < to; r += S) {
		hawser__floats sum = *(const hawser__floats *)(x + r);

		HAWSER_UNROLL
		for (int c = 0; c < S; c++)
			sum -= *(const hawser__floats *)(column + (size_t)c*count + r)*value[c];
		*(hawser__floats *)(x + r) = sum;
	}
}

/* The same for the triangle of these columns: y [S] in registers. */
HAWSER_PART void solve_lower(float *x, const float *block, int count)
{
	float y[S];

	HAWSER_UNROLL
	for (int r = 0; r < S; r++)
		y[r] = x[r];
	HAWSER_UNROLL
	for (int c = 0; c < S; c++) {
		HAWSER_UNROLL
		for (int r = c + 1; r < S; r++)
			y[r] -= block[(size_t)c*count + r]*y[c];
	}
	HAWSER_UNROLL
	for (int r = 0; r < S; r++)
		x[r] = y[r];
}

HAWSER_PART void solve_upper(float *x, const float *block, int count)
{
	float y[S];

	HAWSER_UNROLL
	for (int r = 0; r < S; r++)
		y[r] = x[r];
	HAWSER_UNROLL
	for (int c = S - 1; c >= 0; c--) {
		y[c] *= block[(size_t)c*count + c];
		HAWSER_UNROLL
		for (int r = 0; r < c; r++)
			y[r] -= block[(size_t)c*count + r]*y[c];
	}
	HAWSER_UNROLL
	for (int r = 0; r < S; r++)
		x[r] = y[r];
}

void hawser__blocks_invert_diagonal(float *lu, int count)
{
	for (int i = 0; i < count; i++)
		lu[(size_t)i*count + i] = 1.0F/lu[(size_t)i*count + i];
}

HAWSER_HOT
void hawser__blocks_substitute(float *x, const float *lu, const int *pivot, int count)
{
	for (int i = 0; i < count; i++) {
		float keep = x[i];

		x[i] = x[pivot[i] - 1];
		x[pivot[i] - 1] = keep;
	}
	for (int at = 0; at < count; at += S) {
		const float *column = lu + (size_t)at*count;

		solve_lower(x + at, column + at, count);
		subtract(x, column, count, at + S, count, x + at);
	}
	for (int at = count - S; at >= 0; at -= S) {
		const float *column = lu + (size_t)at*count;

		solve_upper(x + at, column + at, count);
		subtract(x, column, count, 0, at, x + at);
	}
}
