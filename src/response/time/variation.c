/* response/time/variation.c - the variational equations over a step whose stages are known; see flow.h.
 *
 * At each stage, U follows from the previous F, and F = -by_u U (- by_v V). The work consists of
 * sums of long vectors and of products, which keep blocks of their results in registers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/hot.h"
#include "response/time/flow.h"
#include "rom/energy/kernel.h"

#define MANY 32  /* coordinates from which zeros are looked for, and */
#define SPARSE 8 /* the part of the entries that may differ from 0 then; chosen */
#define STRIP 4 /* vectors of a row that are processed together: as many as registers hold */

/* U or V of a stage as a sum: base + factor * V + sum of c_l F_l. */
struct sum {
	const double *base; /* or NULL */
	double factor;
	const double *V, *F;
	const double *c;    /* [count] */
	int count;
	size_t size;        /* number of doubles from one F_l to the next */
};

/* out = sum on [i, i + 4 vecs). */
HAWSER_PART void add_strip(double *out, const struct sum *sum, int i, const int vecs)
{
	hawser__vec acc[STRIP];
	const double *from = sum->F + i;

	HAWSER_UNROLL
	for (int v = 0; v < vecs; v++) {
		acc[v] = sum->factor**(const hawser__vec *)(sum->V + i + 4*v);
		if (sum->base)
			acc[v] += *(const hawser__vec *)(sum->base + i + 4*v);
	}
	for (int l = 0; l < sum->count; l++, from += sum->size) {
		double c = sum->c[l];

		HAWSER_UNROLL
		for (int v = 0; v < vecs; v++)
			acc[v] += c**(const hawser__vec *)(from + 4*v);
	}
	HAWSER_UNROLL
	for (int v = 0; v < vecs; v++)
		*(hawser__vec *)(out + i + 4*v) = acc[v];
}

/* The sum over the whole of `size`, a multiple of HAWSER_BLOCK. */
HAWSER_PART void add_up(double *out, const struct sum *sum, int size)
{
	int i = 0;

	for (; i + 4*STRIP <= size; i += 4*STRIP)
		add_strip(out, sum, i, STRIP);
	switch ((size - i)/4) {
	case 3:
		add_strip(out, sum, i, 3);
		break;
	case 2:
		add_strip(out, sum, i, 2);
		break;
	case 1:
		add_strip(out, sum, i, 1);
	}
}

/* out rows [j, j + rows) on [i, i + 4 vecs): minus matrix (of a lane, [n][n]) times X; added to out
 * if `add` is set. */
HAWSER_PART void multiply_block(double *out, const double *matrix, const double *X, int n, int w,
                                int j, int i, int add, const int rows, const int vecs)
{
	hawser__vec acc[2*STRIP], zero = {0.0};

	HAWSER_UNROLL
	for (int r = 0; r < rows; r++)
		HAWSER_UNROLL
		for (int v = 0; v < vecs; v++)
			acc[r*vecs + v] = add ? *(hawser__vec *)(out + (j + r)*w + i + 4*v) : zero;
	for (int k = 0; k < n; k++) {
		const hawser__vec *x = (const hawser__vec *)(X + (size_t)k*w + i);

		HAWSER_UNROLL
		for (int r = 0; r < rows; r++)
			HAWSER_UNROLL
			for (int v = 0; v < vecs; v++)
				acc[r*vecs + v] -= matrix[((j + r)*n + k)*HAWSER_LANES]*x[v];
	}
	HAWSER_UNROLL
	for (int r = 0; r < rows; r++)
		HAWSER_UNROLL
		for (int v = 0; v < vecs; v++)
			*(hawser__vec *)(out + (j + r)*w + i + 4*v) = acc[r*vecs + v];
}

HAWSER_PART void multiply_strip(double *out, const double *matrix, const double *X, int n, int w,
                                int i, int add, const int vecs)
{
	int j = 0;

	for (; j + 2 <= n; j += 2)
		multiply_block(out, matrix, X, n, w, j, i, add, 2, vecs);
	if (j < n)
		multiply_block(out, matrix, X, n, w, j, i, add, 1, vecs);
}

/* out [4 vecs] = (add ? out : 0) - sum of value_k X_column_k; X begins at the same column. */
HAWSER_PART void sparse_strip(double *out, const double *value, const int *column, int count,
                              const double *X, int w, int add, const int vecs)
{
	hawser__vec acc[STRIP], zero = {0.0};

	HAWSER_UNROLL
	for (int v = 0; v < vecs; v++)
		acc[v] = add ? *(hawser__vec *)(out + 4*v) : zero;
	for (int k = 0; k < count; k++) {
		const hawser__vec *x = (const hawser__vec *)(X + (size_t)column[k]*w);

		HAWSER_UNROLL
		for (int v = 0; v < vecs; v++)
			acc[v] -= value[k]*x[v];
	}
	HAWSER_UNROLL
	for (int v = 0; v < vecs; v++)
		*(hawser__vec *)(out + 4*v) = acc[v];
}

/* The same as multiply without the zeros of the matrix, with the same round-off; returns 0, and nothing
 * is done, if it has few. */
HAWSER_PART int multiply_sparse(double *out, const double *matrix, const double *X, int n, int w,
                                int add)
{
	double value[HAWSER_ROM_MOST];
	int column[HAWSER_ROM_MOST], found = 0;

	for (int i = 0; i < n*n; i++)
		found += matrix[(size_t)i*HAWSER_LANES] != 0.0;
	if (found > n*n/SPARSE)
		return 0;
	for (int j = 0; j < n; j++, out += w) {
		int count = 0, i = 0;

		for (int k = 0; k < n; k++)
			if (matrix[((size_t)j*n + k)*HAWSER_LANES] != 0.0) {
				value[count] = matrix[((size_t)j*n + k)*HAWSER_LANES];
				column[count++] = k;
			}
		for (; i + 4*STRIP <= w; i += 4*STRIP)
			sparse_strip(out + i, value, column, count, X + i, w, add, STRIP);
		for (; i < w; i += 4)
			sparse_strip(out + i, value, column, count, X + i, w, add, 1);
	}
	return 1;
}

/* out [n][w] = (add ? out : 0) - matrix X. */
HAWSER_PART void multiply(double *out, const double *matrix, const double *X, int n, int w, int add)
{
	int i = 0;

	if (n >= MANY && multiply_sparse(out, matrix, X, n, w, add))
		return;
	for (; i + 4*STRIP <= w; i += 4*STRIP)
		multiply_strip(out, matrix, X, n, w, i, add, STRIP);
	switch ((w - i)/4) {
	case 3:
		multiply_strip(out, matrix, X, n, w, i, add, 3);
		break;
	case 2:
		multiply_strip(out, matrix, X, n, w, i, add, 2);
		break;
	case 1:
		multiply_strip(out, matrix, X, n, w, i, add, 1);
	}
}

/* U (or V) [n][w] at row s of the formula, by rows of the same damping; omega [n] of the lane is
 * added to column m. */
HAWSER_PART void form(double *out, const struct hawser__flow *flow, int lane, int s, int velocity,
                      int count)
{
	int n = flow->n, w = flow->w, rows = flow->dampings == 1 ? n : 1;
	size_t size = (size_t)n*w;
	const double *U = flow->U + (size_t)lane*size, *V = flow->V + (size_t)lane*size;
	const double *omega = (velocity ? flow->v_omega : flow->u_omega) + (size_t)s*n*HAWSER_LANES;

	for (int j = 0; j < n; j += rows) {
		const struct hawser__nystrom *nystrom = &flow->nystrom[flow->damping_of[j]];
		size_t at = (size_t)j*w;
		struct sum sum = {velocity ? NULL : U + at,
			velocity ? 1.0 + nystrom->vv[s] : nystrom->uv[s], V + at, flow->F + at,
			velocity ? nystrom->vf[s] : nystrom->uf[s], count, size};

		add_up(out + at, &sum, rows*w);
	}
	for (int j = 0; j < n; j++)
		out[(size_t)j*w + flow->m] += omega[j*HAWSER_LANES + lane];
}

HAWSER_HOT
static void vary(struct hawser__flow *flow, int lane)
{
	int n = flow->n, w = flow->w;
	size_t size = (size_t)n*w;

	for (int s = 0; s < HAWSER_RK_STAGES; s++) {
		double *F = flow->F + (size_t)s*size;
		size_t at = (size_t)s*n*n*HAWSER_LANES + lane;
		const double *f_omega = flow->f_omega + (size_t)s*n*HAWSER_LANES + lane;

		form(flow->stage_U, flow, lane, s, 0, s > 1 ? s - 1 : 0);
		multiply(F, flow->by_u + at, flow->stage_U, n, w, 0);
		if (flow->coupled) {
			form(flow->stage_V, flow, lane, s, 1, s);
			multiply(F, flow->by_v + at, flow->stage_V, n, w, 1);
		}
		for (int j = 0; j < n; j++)
			F[(size_t)j*w + flow->m] += f_omega[j*HAWSER_LANES];
	}
	form(flow->U + (size_t)lane*size, flow, lane, HAWSER_RK_END, 0, HAWSER_RK_STAGES - 1);
	form(flow->V + (size_t)lane*size, flow, lane, HAWSER_RK_END, 1, HAWSER_RK_STAGES);
}

void hawser__flow_vary(struct hawser__flow *flow, int lane)
{
	vary(flow, lane);
}
