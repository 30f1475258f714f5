/* response/orbit/balance_fast.c - coordinates that are too fast for the steps of balance_blocks.h.
 *
 *   s, f   slow and fast coordinates
 *
 * A coordinate with a frequency far above all harmonics responds statically at every node:
 *
 *   x_f = K_ff^-1 (r_f - K_fs x_s - b_f dOmega)
 *
 * so that the slow coordinates have the stiffness K_ss - K_sf K_ff^-1 K_fs. Its own acceleration is
 * that of G x_s, G = -K_ff^-1 K_fs, of which G x_s'' is the part that does not vanish with the rate
 * of G: the mass 1 + G'G of the slow coordinates. The neglected terms are of the order
 * (H Omega/omega_f)^2. In steps that are long for such a coordinate, collocation would
 * give it free vibrations of wrong frequencies, which resonate, and its equations would enlarge the
 * blocks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hot.h"
#include "core/report.h"
#include "response/orbit/balance.h"

#define S HAWSER__BLOCK_NODES
#define FAST 3.0 /* at the highest harmonic the static response has an error of 1/9, which GMRES
                  * corrects */

/* block [rows][columns] of a matrix [n][n] at the coordinates listed. */
static void gather(float *block, const float *matrix, int n, const int *row, int rows,
                   const int *column, int columns)
{
	for (int i = 0; i < rows; i++)
		for (int j = 0; j < columns; j++)
			block[i*columns + j] = matrix[(size_t)row[i]*n + column[j]];
}

static void transpose(float *matrix, int n)
{
	for (int i = 0; i < n; i++)
		for (int j = 0; j < i; j++) {
			float keep = matrix[i*n + j];

			matrix[i*n + j] = matrix[j*n + i];
			matrix[j*n + i] = keep;
		}
}

/* At one node: K [n][n]; slow [w][w] receives the condensed stiffness. Returns 1 if K_ff is
 * singular. */
static int condense_node(struct hawser__blocks *blocks, float *slow, const float *K, int n, int node)
{
	int w = blocks->w, f = blocks->f, *pivot = blocks->last;
	const int *s = blocks->member, *q = blocks->member + w;
	float *ff = blocks->inverse + (size_t)node*f*f, *G = blocks->follow + (size_t)node*f*w;
	float *H = blocks->weigh + (size_t)node*w*f, *fs = blocks->fast_room, *sf = fs + (size_t)f*w;

	if (w == 0)
		return 1; /* nothing is slow */
	gather(slow, K, n, s, w, s, w);
	gather(ff, K, n, q, f, q, f);
	gather(fs, K, n, q, f, s, w);
	gather(sf, K, n, s, w, q, f);
	/* by columns this inverts the transpose, which is the transpose of the inverse */
	if (LAPACKE_sgetrf_work(LAPACK_COL_MAJOR, f, f, ff, f, pivot) ||
	    LAPACKE_sgetri_work(LAPACK_COL_MAJOR, f, ff, f, pivot, G, f*w))
		return 1;
	cblas_sgemm(CblasRowMajor, CblasTrans, CblasTrans, w, f, f, -1.0, fs, w, ff, f, 0.0, G, f);
	cblas_sgemm(CblasRowMajor, CblasTrans, CblasTrans, f, w, f, -1.0, ff, f, sf, f, 0.0, H, w);
	cblas_sgemm(CblasRowMajor, CblasNoTrans, CblasTrans, w, w, f, 1.0, sf, f, G, f, 1.0, slow, w);
	cblas_sgemm(CblasRowMajor, CblasNoTrans, CblasTrans, w, w, f, 1.0, G, f, G, f, 1.0,
	            blocks->mass + (size_t)node%S*w*w, w);
	transpose(ff, f);
	return 0;
}

int hawser__blocks_condense(struct hawser__blocks *blocks, float *slow, const float *K, int n,
                            int step)
{
	int w = blocks->w;

	memset(blocks->mass, 0, (size_t)S*w*w*sizeof *blocks->mass);
	for (int p = 0; p < S*w; p++)
		blocks->mass[(size_t)p*w + p%w] = 1.0F;
	for (int i = 0; i < S; i++) {
		const float *at = K + (size_t)i*n*n;

		if (blocks->f == 0)
			gather(slow + (size_t)i*w*w, at, n, blocks->member, w, blocks->member, w);
		else if (condense_node(blocks, slow + (size_t)i*w*w, at, n, step*S + i))
			return 1;
	}
	return 0;
}

/* y [count] += columns [inner][count] times x [inner]: dot products over so few values, of a matrix by
 * rows, would take three times as long. */
HAWSER_PART void add_columns(float *y, const float *columns, const float *x, int count, int inner)
{
	int at = 0;

	for (; at + S <= count; at += S) {
		hawser__floats sum = *(hawser__floats *)(y + at);

		for (int j = 0; j < inner; j++)
			sum += *(const hawser__floats *)(columns + (size_t)j*count + at)*x[j];
		*(hawser__floats *)(y + at) = sum;
	}
	for (; at < count; at++)
		for (int j = 0; j < inner; j++)
			y[at] += columns[(size_t)j*count + at]*x[j];
}

HAWSER_HOT
void hawser__blocks_load_slow(struct hawser__blocks *blocks, float *slow, const float *fast,
                              int first, int steps)
{
	size_t w = (size_t)blocks->w, f = (size_t)blocks->f;

	for (size_t node = (size_t)S*first; f > 0 && node < (size_t)S*(first + steps); node++)
		add_columns(slow + node*w, blocks->weigh + node*w*f, fast + node*f, blocks->w, blocks->f);
}

HAWSER_HOT
void hawser__blocks_follow(struct hawser__blocks *blocks, float *fast, const float *slow,
                           const float *column, double domega)
{
	size_t w = (size_t)blocks->w, f = (size_t)blocks->f;
	float *load = blocks->fast_room;

	for (size_t node = 0; f > 0 && node < (size_t)S*blocks->steps; node++) {
		float *x = fast + node*f;

		for (size_t q = 0; q < f; q++) {
			load[q] = x[q] - column[node*f + q]*(float)domega;
			x[q] = 0.0F;
		}
		add_columns(x, blocks->inverse + node*f*f, load, blocks->f, blocks->f);
		add_columns(x, blocks->follow + node*f*w, slow + node*w, blocks->f, blocks->w);
	}
}

/* --- a first value --- */

int hawser__balance_fast(const struct hawser__balance *balance, int j)
{
	const struct hawser_rom *rom = balance->base.rom;
	double stiffness = rom->exact ? rom->K[(size_t)j*((size_t)rom->n + 1)]
	                              : balance->stiffness[j];
	double top = FAST*fmax(balance->order, 1.0)*balance->derived_at;

	return stiffness > top*top;
}

/* Static change [f] of the fast coordinates at a sample, for their defects there, which it replaces;
 * K: room [f][f]. Returns 1 if there is none. */
static int settle_sample(double *values, double *K, int *pivot, const double *tangent, int n,
                         const int *fast, int f)
{
	for (int p = 0; p < f; p++)
		for (int q = 0; q < f; q++)
			K[p*f + q] = tangent[(size_t)fast[p]*n + fast[q]];
	/* by columns this is the transpose, and K is symmetric */
	return LAPACKE_dgesv_work(LAPACK_COL_MAJOR, f, 1, K, f, pivot, values, f) != 0;
}

enum hawser_status hawser__balance_settle(struct hawser__balance *balance, double *y,
                                          struct hawser_report *report)
{
	int n = balance->base.n, f = 0, failed = 0, rows, columns, wide = 2*balance->order + 1;
	double *values, *series, *K;
	int *fast = malloc(2*(size_t)n*sizeof *fast);

	hawser__balance_evaluate(balance, y, 1);
	rows = balance->base.rows;
	columns = 2*balance->width + 1;
	for (int j = 0; fast && j < n; j++)
		if (hawser__balance_fast(balance, j))
			fast[f++] = j;
	values = calloc(((size_t)rows + wide + n)*(size_t)f + 1, sizeof *values);
	if (!fast || !values) {
		free(fast);
		free(values);
		return hawser__no_memory(report, "orbit");
	}
	series = values + (size_t)rows*f;
	K = series + (size_t)wide*f;
	for (int c = 0; c < wide; c++)
		for (int q = 0; q < f; q++)
			if (balance->active[(c + 1)/2*n + fast[q]])
				series[c*f + q] = balance->defect[(size_t)c*n + fast[q]];
	if (f > 0)
		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, f, wide, 1.0, balance->basis,
		            columns, series, f, 0.0, values, f);
	for (int r = 0; !failed && f > 0 && r < rows; r++)
		failed = settle_sample(values + (size_t)r*f, K, fast + n, balance->tangent + (size_t)r*n*n, n,
		                       fast, f);
	if (f > 0)
		cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, wide, f, rows, 2.0/rows, balance->basis,
		            columns, values, f, 0.0, series, f);
	for (int c = 0; !failed && c < wide; c++)
		for (int q = 0; q < f; q++)
			if (balance->active[(c + 1)/2*n + fast[q]])
				y[(size_t)c*n + fast[q]] -= (c ? 1.0 : 0.5)*series[c*f + q];
	free(values);
	free(fast);
	return HAWSER_OK;
}
