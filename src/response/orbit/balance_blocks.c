/* response/orbit/balance_blocks.c - see balance_blocks.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "response/orbit/balance.h"

#define S HAWSER__BLOCK_NODES
/* Steps per harmonic: the highest harmonic turns by 5.2 rad in a step, for which the step has an
 * error of 0.14, half of it by 2.6 rad, with an error of 1e-3. More steps save iterations with new
 * factors only, of which there are few. Chosen: of 1.0, 1.2, 1.4 and 1.6, and 0.8 with 8 nodes each,
 * the one with the shortest responses with exact energy. */
#define STEPS_PER_HARMONIC 1.2
#define LEAST_STEPS 4 /* the fundamental then turns by 90 degrees in a step, whose error is 2e-5 */

void hawser__blocks_init(struct hawser__blocks *blocks)
{
	memset(blocks, 0, sizeof *blocks);
	hawser__collocation_make_radau(&blocks->radau, S);
	memcpy(blocks->weight, blocks->radau.end_once, sizeof blocks->weight);
	hawser__collocation_indirect(&blocks->radau);
}

void hawser__blocks_release(struct hawser__blocks *blocks)
{
	free(blocks->memory);
	free(blocks->member);
	free(blocks->pivot);
	blocks->memory = NULL;
	blocks->member = blocks->pivot = NULL;
}

/* --- room --- */

static int list_members(int *member, const struct hawser__balance *balance, int which)
{
	int n = balance->base.n, count = 0;

	for (int j = 0; j < n; j++) {
		int on = 0;

		for (int h = 0; h <= balance->order; h++)
			on |= balance->active[h*n + j];
		if (!on || hawser__balance_fast(balance, j) != which)
			continue;
		if (member)
			member[count] = j;
		count++;
	}
	return count;
}

static int count_steps(const struct hawser__balance *balance)
{
	return (int)fmax(LEAST_STEPS, ceil(STEPS_PER_HARMONIC*balance->order));
}

double hawser__blocks_cost(const struct hawser__balance *balance)
{
	double w = list_members(NULL, balance, 0), wide = S*w;

	return count_steps(balance)*(2.0/3.0*wide*wide*wide + 2.0*wide*wide*(2.0*w + 1.0));
}

/* Reserve `count` values at *next, which is advanced; if `memory` is NULL they are only counted. */
static float *take(size_t *next, float *memory, size_t count)
{
	float *here = memory ? memory + *next : NULL;

	*next += count;
	return here;
}

/* Assign the arrays in `memory`, or NULL; returns the number of values. */
static size_t share_out(struct hawser__blocks *blocks, float *memory, size_t n)
{
	size_t K = (size_t)blocks->steps, w = (size_t)blocks->w, f = (size_t)blocks->f, wide = S*w;
	size_t m = 2*w + 1, columns = 2*(size_t)blocks->order + 1, width = 2*(size_t)blocks->width + 1;
	size_t next = 0;

	blocks->T = take(&next, memory, (2*(size_t)blocks->spread + 1)*n*n);
	blocks->resist = take(&next, memory, blocks->more ? (2*(size_t)blocks->spread + 1)*n*n : 0);
	blocks->table = take(&next, memory, S*K*width);
	blocks->start = take(&next, memory, K*width); /* must follow the table in memory */
	blocks->stiff = take(&next, memory, S*n*n);
	blocks->damp = take(&next, memory, S*n*n);
	blocks->slow = take(&next, memory, S*w*w);
	blocks->mass = take(&next, memory, S*w*w);
	blocks->scale = take(&next, memory, w);
	blocks->series = take(&next, memory, columns*(w + f));
	blocks->forcing = take(&next, memory, K*wide);
	blocks->displacement = take(&next, memory, K*wide);
	blocks->column = take(&next, memory, K*wide);
	blocks->fast = take(&next, memory, K*S*f);
	blocks->fast_column = take(&next, memory, K*S*f);
	blocks->fast_room = take(&next, memory, 2*f*w + f);
	blocks->plane = take(&next, memory, K*2*w);
	blocks->A = take(&next, memory, K*2*w*m);
	blocks->prefix = take(&next, memory, 4*w*m);
	blocks->closing = take(&next, memory, m*m);
	blocks->state = take(&next, memory, 3*m);
	blocks->lu = take(&next, memory, K*wide*wide);
	blocks->X = take(&next, memory, K*wide*m);
	blocks->inverse = take(&next, memory, S*K*f*f);
	blocks->follow = take(&next, memory, S*K*f*w);
	blocks->weigh = take(&next, memory, S*K*w*f);
	return next;
}

int hawser__blocks_arrange(struct hawser__blocks *blocks, const struct hawser__balance *balance)
{
	size_t n = (size_t)balance->base.n, pivots;

	hawser__blocks_release(blocks);
	blocks->member = malloc(n*sizeof(int));
	if (!blocks->member)
		return 1;
	blocks->order = balance->order;
	blocks->width = balance->width;
	blocks->spread = balance->spread;
	blocks->more = balance->more;
	blocks->steps = count_steps(balance);
	blocks->w = list_members(blocks->member, balance, 0);
	blocks->f = list_members(blocks->member + blocks->w, balance, 1);
	pivots = (size_t)blocks->steps*S*blocks->w + 2*(size_t)blocks->w + 1;
	blocks->memory = malloc(share_out(blocks, NULL, n)*sizeof *blocks->memory);
	blocks->pivot = malloc((pivots + blocks->f)*sizeof(int));
	if (!blocks->memory || !blocks->pivot)
		return 1;
	share_out(blocks, blocks->memory, n);
	blocks->last = blocks->pivot + (size_t)blocks->steps*S*blocks->w;
	hawser__blocks_tabulate(blocks);
	return 0;
}

/* --- a step --- */

/* M and -[K/scale | c h K + D | b] of a step. */
static void fill_step(struct hawser__blocks *blocks, float *M, float *right, int n, int step)
{
	int w = blocks->w, wide = S*w;
	double h = blocks->h;
	const float *column = blocks->column + (size_t)step*wide;

	for (int i = 0; i < S; i++)
		for (int q = 0; q < w; q++)
			for (int p = 0; p < w; p++) {
				size_t e = ((size_t)i*n + blocks->member[p])*n + blocks->member[q];
				double k = blocks->slow[((size_t)i*w + p)*w + q], d = blocks->damp[e];
				float *at = M + (size_t)q*wide + (size_t)i*w + p;
				float *rhs = right + (size_t)q*wide + (size_t)i*w + p;

				for (int j = 0; j < S; j++)
					at[(size_t)j*w*wide] = h*h*blocks->radau.twice[i][j]*k +
					                        h*blocks->radau.once[i][j]*d;
				at[(size_t)i*w*wide] += blocks->mass[((size_t)i*w + p)*w + q];
				rhs[0] = -k/blocks->scale[q];
				rhs[(size_t)w*wide] = -blocks->radau.node[i]*h*k - d;
			}
	for (int i = 0; i < wide; i++)
		right[2*(size_t)w*wide + i] = -column[i];
}

/* end [2w] += contribution of the accelerations a [S][w] at the nodes of a step to the state at its
 * end. */
static void add_end(const struct hawser__blocks *blocks, float *end, int stride, const float *a)
{
	int w = blocks->w;
	double h = blocks->h;

	for (int p = 0; p < w; p++) {
		double once = 0.0, twice = 0.0;

		for (int i = 0; i < S; i++) {
			once += blocks->radau.end_once[i]*a[i*w + p];
			twice += blocks->radau.end_twice[i]*a[i*w + p];
		}
		end[p*stride] += blocks->scale[p]*h*h*twice;
		end[(w + p)*stride] += h*once;
	}
}

static int factor_step(struct hawser__blocks *blocks, const struct hawser__balance *balance, int step)
{
	int w = blocks->w, m = 2*w + 1, wide = S*w;
	float *M = blocks->lu + (size_t)step*wide*wide, *X = blocks->X + (size_t)step*wide*m;
	float *A = blocks->A + (size_t)step*2*w*m;

	hawser__blocks_evaluate(blocks, balance, step);
	if (hawser__blocks_condense(blocks, blocks->slow, blocks->stiff, balance->base.n, step))
		return 1;
	hawser__blocks_load_slow(blocks, blocks->column, blocks->fast_column, step, 1);
	fill_step(blocks, M, X, balance->base.n, step);
	if (LAPACKE_sgesv_work(LAPACK_COL_MAJOR, wide, m, M, wide, blocks->pivot + (size_t)step*wide, X,
	                       wide))
		return 1;
	hawser__blocks_invert_diagonal(M, wide);
	memset(A, 0, 2*(size_t)w*m*sizeof *A);
	for (int q = 0; q < m; q++)
		add_end(blocks, A + q, m, X + (size_t)q*wide);
	for (int p = 0; p < w; p++) {
		A[(size_t)p*m + p] += 1.0;
		A[(size_t)p*m + w + p] += blocks->scale[p]*blocks->h;
		A[(size_t)(w + p)*m + w + p] += 1.0;
	}
	return 0;
}

/* --- the period --- */

/* Values at the nodes, [SK][w], of a series y [2 top + 1][n] at w coordinates. */
static void synthesise(struct hawser__blocks *blocks, float *values, const double *y, int n,
                       const int *member, int w)
{
	int columns = 2*blocks->order + 1;

	if (w == 0)
		return;
	for (int c = 0; c < columns; c++)
		for (int p = 0; p < w; p++)
			blocks->series[c*w + p] = y[(size_t)c*n + member[p]];
	cblas_sgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, S*blocks->steps, w, columns, 1.0,
	            blocks->table, 2*blocks->width + 1, blocks->series, w, 0.0, values, w);
}

/* The border as a functional of the states at the beginning of the steps: the metric is the mean of
 * their squares over the period. */
static void set_plane(struct hawser__blocks *blocks, const struct hawser__balance *balance,
                      const double *row)
{
	int n = balance->base.n, w = blocks->w, K = blocks->steps, columns = 2*blocks->width + 1;

	for (int k = 0; k < K; k++) {
		const float *wave = blocks->start + (size_t)k*columns;

		for (int p = 0; p < w; p++) {
			int j = blocks->member[p];
			double u = row[j], v = 0.0, part = 1.0/(2.0*n*K);

			for (int h = 1; h <= blocks->order; h++) {
				double a = row[hawser__cos(n, h, j)], b = row[hawser__sin(n, h, j)];

				u += a*wave[2*h - 1] + b*wave[2*h];
				v += h*blocks->omega*(b*wave[2*h - 1] - a*wave[2*h]);
			}
			blocks->plane[(2*k)*w + p] =
				part*u/(pow(balance->size_u[j], 2)*blocks->scale[p]);
			blocks->plane[(2*k + 1)*w + p] = part*v/pow(balance->size_v[j], 2);
		}
	}
}

/* [1 - product of A | -...], and the border below it. */
static int close_period(struct hawser__blocks *blocks, const struct hawser__balance *balance,
                        const double *row)
{
	int w = blocks->w, two = 2*w, m = two + 1, last = balance->base.size - 1;
	float *now = blocks->prefix, *next = now + (size_t)two*m, *C = blocks->closing;

	memset(now, 0, (size_t)two*m*sizeof *now);
	memset(C, 0, (size_t)m*m*sizeof *C);
	for (int p = 0; p < two; p++)
		now[(size_t)p*m + p] = 1.0;
	C[(size_t)two*m + two] = row[last]*balance->base.weight[last];
	for (int k = 0; k < blocks->steps; k++) {
		const float *A = blocks->A + (size_t)k*two*m;
		float *swap = now;

		cblas_sgemv(CblasRowMajor, CblasTrans, two, m, 1.0, now, m, blocks->plane + (size_t)k*two,
		            1, 1.0, C + (size_t)two*m, 1);
		cblas_sgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, two, m, two, 1.0, A, m, now, m,
		            0.0, next, m);
		cblas_saxpy(two, 1.0, A + two, m, next + two, m);
		now = next;
		next = swap;
	}
	for (int p = 0; p < two; p++)
		for (int q = 0; q < m; q++)
			C[(size_t)p*m + q] = (p == q ? 1.0 : 0.0) - now[(size_t)p*m + q];
	return LAPACKE_sgetrf_work(LAPACK_COL_MAJOR, m, m, C, m, blocks->last) != 0;
}

/* Whether the set of fast coordinates has changed since the arrays were allocated. */
static int changed(const struct hawser__blocks *blocks, const struct hawser__balance *balance)
{
	int others = list_members(NULL, balance, 1) != blocks->f;

	for (int q = blocks->w; q < blocks->w + blocks->f; q++)
		others |= !hawser__balance_fast(balance, blocks->member[q]);
	return others;
}

int hawser__blocks_factor(struct hawser__blocks *blocks, struct hawser__balance *balance,
                          const double *row)
{
	int n = balance->base.n;

	if (changed(blocks, balance) && hawser__blocks_arrange(blocks, balance))
		return 1;
	hawser__balance_transform(balance);
	blocks->harmonics = hawser__blocks_harmonics(balance);
	for (size_t e = 0; e < (2*(size_t)blocks->harmonics + 1)*n*n; e++)
		blocks->T[e] = (float)balance->T[e];
	for (size_t e = 0; blocks->more && e < (2*(size_t)balance->monodromy.resist_order + 1)*n*n; e++)
		blocks->resist[e] = (float)balance->resist[e];
	blocks->omega = balance->derived_at;
	blocks->h = 2.0*M_PI/blocks->omega/blocks->steps;
	for (int p = 0; p < blocks->w; p++)
		blocks->scale[p] = fmax(sqrt(fabs(balance->stiffness[blocks->member[p]])), blocks->omega);
	synthesise(blocks, blocks->column, balance->by_omega, n, blocks->member, blocks->w);
	synthesise(blocks, blocks->fast_column, balance->by_omega, n, blocks->member + blocks->w,
	           blocks->f);
	for (int k = 0; k < blocks->steps; k++)
		if (factor_step(blocks, balance, k))
			return 1;
	set_plane(blocks, balance, row);
	return close_period(blocks, balance, row);
}

/* Particular solution, starting from rest: `forcing` is overwritten by the accelerations at the
 * nodes of the steps. end [2w]: its state at the end of the period. Returns its contribution to the
 * border. */
static double particular(struct hawser__blocks *blocks, float *end)
{
	int w = blocks->w, two = 2*w, m = two + 1, wide = S*w;
	float *next = blocks->state + m;
	double sum = 0.0;

	memset(end, 0, (size_t)two*sizeof *end);
	for (int k = 0; k < blocks->steps; k++) {
		float *a = blocks->forcing + (size_t)k*wide;

		hawser__blocks_substitute(a, blocks->lu + (size_t)k*wide*wide,
		                          blocks->pivot + (size_t)k*wide, wide);
		sum += cblas_sdot(two, blocks->plane + (size_t)k*two, 1, end, 1);
		cblas_sgemv(CblasRowMajor, CblasNoTrans, two, two, 1.0, blocks->A + (size_t)k*two*m, m, end,
		            1, 0.0, next, 1);
		add_end(blocks, next, 1, a);
		memcpy(end, next, (size_t)two*sizeof *end);
	}
	return sum;
}

/* The solution that begins with the state [2w + 1], whose last element is dOmega: `forcing` is
 * overwritten by its accelerations at the nodes, and `displacement` by its displacements. */
static void general(struct hawser__blocks *blocks, float *state)
{
	int w = blocks->w, two = 2*w, m = two + 1, wide = S*w;
	float *next = blocks->state + 2*m;
	double h = blocks->h;

	for (int k = 0; k < blocks->steps; k++) {
		float *a = blocks->forcing + (size_t)k*wide;
		float *u = blocks->displacement + (size_t)k*wide;

		memset(next, 0, (size_t)two*sizeof *next);
		add_end(blocks, next, 1, a);
		cblas_sgemv(CblasColMajor, CblasNoTrans, wide, m, 1.0, blocks->X + (size_t)k*wide*m, wide,
		            state, 1, 1.0, a, 1);
		for (int i = 0; i < S; i++)
			for (int p = 0; p < w; p++) {
				double twice = 0.0;

				for (int j = 0; j < S; j++)
					twice += blocks->radau.twice[i][j]*a[j*w + p];
				u[i*w + p] = state[p]/blocks->scale[p] +
				             h*(blocks->radau.node[i]*state[w + p] + h*twice);
			}
		cblas_sgemv(CblasRowMajor, CblasNoTrans, two, m, 1.0, blocks->A + (size_t)k*two*m, m, state,
		            1, 1.0, next, 1);
		memcpy(state, next, (size_t)two*sizeof *state);
	}
}

/* y [2 order + 1][n] at w coordinates: Fourier coefficients of values at the nodes [SK][w], which
 * are overwritten. Those of accelerations are divided by (i h Omega)^2. */
static void analyse(struct hawser__blocks *blocks, double *y, int n, float *values, const int *member,
                    int w, int accelerations)
{
	int columns = 2*blocks->order + 1, nodes = S*blocks->steps;

	if (w == 0)
		return;
	for (int i = 0; i < nodes; i++)
		cblas_sscal(w, blocks->weight[i%S]/blocks->steps, values + (size_t)i*w, 1);
	cblas_sgemm(CblasRowMajor, CblasTrans, CblasNoTrans, columns, w, nodes, 1.0, blocks->table,
	            2*blocks->width + 1, values, w, 0.0, blocks->series, w);
	for (int c = accelerations; c < columns; c++) {
		double turn = (c + 1)/2*blocks->omega;
		double factor = accelerations ? -2.0/(turn*turn) : c ? 2.0 : 1.0;

		for (int p = 0; p < w; p++)
			y[(size_t)c*n + member[p]] = factor*blocks->series[c*w + p];
	}
}

/* The mean of the displacement, which does not follow from the accelerations. */
static void average(struct hawser__blocks *blocks, double *y)
{
	int w = blocks->w, nodes = S*blocks->steps;

	for (int p = 0; p < w; p++) {
		double mean = 0.0;

		for (int i = 0; i < nodes; i++)
			mean += blocks->weight[i%S]*blocks->displacement[(size_t)i*w + p];
		y[blocks->member[p]] = mean/blocks->steps;
	}
}

void hawser__blocks_apply(struct hawser__blocks *blocks, const struct hawser__balance *balance,
                          double *x)
{
	int n = balance->base.n, P = balance->unknowns, w = blocks->w, f = blocks->f, m = 2*w + 1;
	const int *quick = blocks->member + w;
	float *state = blocks->state;
	double *y = balance->direction, last = x[P], share, domega;

	memset(y, 0, (2*(size_t)balance->order + 1)*n*sizeof *y);
	for (int i = 0; i < P; i++)
		y[balance->slot[i]] = x[i]/balance->row_scale[i];
	synthesise(blocks, blocks->forcing, y, n, blocks->member, w);
	synthesise(blocks, blocks->fast, y, n, quick, f);
	hawser__blocks_load_slow(blocks, blocks->forcing, blocks->fast, 0, blocks->steps);
	share = particular(blocks, state);
	state[m - 1] = last - share;
	LAPACKE_sgetrs_work(LAPACK_COL_MAJOR, 'T', m, 1, blocks->closing, m, blocks->last, state, m);
	domega = state[m - 1];
	general(blocks, state);
	hawser__blocks_follow(blocks, blocks->fast, blocks->displacement, blocks->fast_column, domega);
	average(blocks, y);
	analyse(blocks, y, n, blocks->forcing, blocks->member, w, 1);
	analyse(blocks, y, n, blocks->fast, quick, f, 0);
	x[P] = domega/balance->base.W;
	for (int i = 0; i < P; i++)
		x[i] = y[balance->slot[i]]/balance->col_scale[i];
}

double hawser__blocks_applied(const struct hawser__blocks *blocks,
                              const struct hawser__balance *balance)
{
	double wide = S*blocks->w, m = 2.0*blocks->w + 1.0, n = balance->base.n;
	double columns = 2.0*balance->order + 1.0, rows = balance->base.rows;

	return blocks->steps*(2.0*wide*wide + 4.0*wide*m + 4.0*columns*wide) +
	       rows*(2.0*n*n + 4.0*columns*n);
}

double hawser__blocks_factored(const struct hawser__blocks *blocks,
                               const struct hawser__balance *balance)
{
	double n = balance->base.n, columns = 2.0*balance->order + 1.0;

	return hawser__blocks_cost(balance) + 2.0*blocks->steps*S*columns*n*n;
}
