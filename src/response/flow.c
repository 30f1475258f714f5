/* response/flow.c - see flow.h. The innermost loop of every response: no allocation, and the
 * derivative's stages reuse the state's Jacobians.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hot.h"
#include "core/report.h"
#include "response/flow.h"
#include "response/tableau.h"
#include "rom/kernel.h"

enum hawser_status hawser__flow_init(struct hawser__flow *flow, const struct hawser_rom *rom,
                                     struct hawser_report *report)
{
	size_t n = (size_t)rom->n, m = 2*n, w = HAWSER_PADDED(m + 1), padded = HAWSER_PADDED(m);
	size_t stages = HAWSER_RK_STAGES;
	double *next;

	memset(flow, 0, sizeof *flow);
	flow->rom = rom;
	flow->n = (int)n;
	flow->m = (int)m;
	flow->w = (int)w;
	flow->padded = (int)padded;
	next = flow->memory = calloc((stages + 2)*padded + 2*n + 2*n*n + (2 + stages)*m*w,
	                             sizeof *next);
	if (!next)
		return hawser__no_memory(report, "orbit");
	flow->slope = next;
	flow->x = next += stages*padded;
	flow->stage = next += padded;
	flow->acc = next += padded;
	flow->by_omega = next += n;
	flow->by_u = next += n;
	flow->by_v = next += n*n;
	flow->X = next += n*n;
	flow->X_stage = next += m*w;
	flow->X_slope = next + m*w;
	return HAWSER_OK;
}

void hawser__flow_clear(struct hawser__flow *flow)
{
	free(flow->memory);
	memset(flow, 0, sizeof *flow);
}

/* A linear combination sum c_t * from_t of vectors, without the terms that are zero. */
struct combination {
	int count;
	double c[2*HAWSER_ROM_MAX];
	const double *from[2*HAWSER_ROM_MAX];
};

/* row is the factors of `count` vectors of length `size`, one behind the other. */
HAWSER_PART void collect(struct combination *sum, const double *row, int count, double factor,
                         const double *vectors, int size)
{
	for (int j = 0; j < count; j++) {
		if (row[j] == 0.0)
			continue;
		sum->c[sum->count] = factor*row[j];
		sum->from[sum->count++] = vectors + (size_t)j*size;
	}
}

/* out = base + sum on [i, i + 4 vecs): `vecs` accumulators stay in registers and hide the latency
 * of the additions. base may be NULL. */
HAWSER_PART void add_block(double *out, const double *base, const struct combination *sum, int i,
                           const int vecs)
{
	hawser__vec acc[4], zero = {0.0};

	for (int v = 0; v < vecs; v++)
		acc[v] = base ? *(const hawser__vec *)(base + i + 4*v) : zero;
	for (int t = 0; t < sum->count; t++) {
		const double *from = sum->from[t] + i;
		double c = sum->c[t];

		acc[0] += c**(const hawser__vec *)from;
		if (vecs == 4) {
			acc[1] += c**(const hawser__vec *)(from + 4);
			acc[2] += c**(const hawser__vec *)(from + 8);
			acc[3] += c**(const hawser__vec *)(from + 12);
		}
	}
	for (int v = 0; v < vecs; v++)
		*(hawser__vec *)(out + i + 4*v) = acc[v];
}

/* out = base + sum, elementwise over `size`, a multiple of HAWSER_BLOCK. */
HAWSER_PART void add_up(double *out, const double *base, const struct combination *sum, int size)
{
	int i = 0;

	for (; i + 16 <= size; i += 16)
		add_block(out, base, sum, i, 4);
	for (; i < size; i += HAWSER_BLOCK)
		add_block(out, base, sum, i, 1);
}

HAWSER_PART void state_slope(const struct hawser__flow *flow, double *slope, double omega)
{
	double inverse = 1.0/omega;

	for (int j = 0; j < flow->n; j++) {
		slope[j] = flow->stage[flow->n + j]*inverse;
		slope[flow->n + j] = flow->acc[j]*inverse;
	}
}

/* Slope of X at a stage: (V, Ju U + Jv V)/Omega, and in column m the explicit Omega. */
HAWSER_PART void derivative_slope(const struct hawser__flow *flow, double *slope, double omega)
{
	int n = flow->n, w = flow->w, m = flow->m;
	double inverse = 1.0/omega;
	const double *U = flow->X_stage, *V = U + (size_t)n*w;
	struct combination sum;

	for (int i = 0; i < n*w; i++)
		slope[i] = V[i]*inverse;
	for (int j = 0; j < n; j++) {
		double *row = slope + (size_t)(n + j)*w;

		sum.count = 0;
		collect(&sum, flow->by_u + j*n, n, inverse, U, w);
		collect(&sum, flow->by_v + j*n, n, inverse, V, w);
		add_up(row, NULL, &sum, w);
		slope[(size_t)j*w + m] -= flow->stage[n + j]*inverse*inverse;
		row[m] += (flow->by_omega[j] - flow->acc[j]*inverse)*inverse;
	}
}

/* Hairer's combination of the two comparison formulas behaves like the error, but is 8 to 40 times
 * as large at the steps that give 1e-6 to 1e-11 (measured: tests/unit/test-flow.c). */
#define CALIBRATION 0.125

HAWSER_PART double step_error(const struct hawser__flow *flow, double h)
{
	double five = 0.0, three = 0.0;

	for (int i = 0; i < flow->m; i++) {
		double e5 = 0.0, e3 = 0.0;

		for (int s = 0; s < HAWSER_RK_STAGES; s++) {
			e5 += hawser__dop853.e5[s]*flow->slope[s*flow->padded + i];
			e3 += hawser__dop853.e3[s]*flow->slope[s*flow->padded + i];
		}
		five += e5*e5;
		three += e3*e3;
	}
	return five > 0.0 ? CALIBRATION*fabs(h)*five/sqrt(five + 0.01*three) : 0.0;
}

/* out = base + h * sum_j row_j slope_j. */
HAWSER_PART void stage_sum(double *out, const double *base, double h, const double *row, int count,
                           const double *slope, int size)
{
	struct combination sum;

	sum.count = 0;
	collect(&sum, row, count, h, slope, size);
	add_up(out, base, &sum, size);
}

HAWSER_PART double step(struct hawser__flow *flow, int derive, double tau, double h, double omega)
{
	const struct hawser__tableau *rk = &hawser__dop853;
	int n = flow->n, size = flow->m*flow->w, padded = flow->padded;
	double *stage = flow->stage;

	for (int s = 0; s < HAWSER_RK_STAGES; s++) {
		double at = tau + rk->c[s]*h;

		stage_sum(stage, flow->x, h, rk->a[s], s, flow->slope, padded);
		if (derive) {
			hawser_rom_acceleration_jacobian(flow->rom, flow->acc, flow->by_u,
			                                 flow->by_v, flow->by_omega, stage,
			                                 stage + n, at, omega);
			stage_sum(flow->X_stage, flow->X, h, rk->a[s], s, flow->X_slope, size);
			derivative_slope(flow, flow->X_slope + (size_t)s*size, omega);
		} else {
			hawser_rom_acceleration(flow->rom, flow->acc, stage, stage + n, at, omega);
		}
		state_slope(flow, flow->slope + s*padded, omega);
	}
	stage_sum(flow->x, flow->x, h, rk->b, HAWSER_RK_STAGES, flow->slope, padded);
	if (derive)
		stage_sum(flow->X, flow->X, h, rk->b, HAWSER_RK_STAGES, flow->X_slope, size);
	flow->stages += HAWSER_RK_STAGES;
	return step_error(flow, h);
}

HAWSER_HOT
static double carry(struct hawser__flow *flow, int derive, double *samples,
                    const struct hawser__stretch *stretch, double omega)
{
	double error = 0.0;

	for (int i = 0; i < stretch->steps; i++) {
		if (samples)
			memcpy(samples + (size_t)i*flow->n, flow->x,
			       (size_t)flow->n*sizeof *samples);
		error += step(flow, derive, stretch->tau + i*stretch->h, stretch->h, omega);
	}
	return error;
}

double hawser__flow_map(struct hawser__flow *flow, double *x, double *samples,
                        const struct hawser__stretch *stretch, double omega)
{
	double error;

	memcpy(flow->x, x, (size_t)flow->m*sizeof *x);
	error = carry(flow, 0, samples, stretch, omega);
	memcpy(x, flow->x, (size_t)flow->m*sizeof *x);
	return error;
}

double hawser__flow_derive(struct hawser__flow *flow, double *x, double *A, double *b,
                           double *samples, const struct hawser__stretch *stretch, double omega)
{
	int m = flow->m, w = flow->w;
	double error;

	memset(flow->X, 0, (size_t)m*w*sizeof *flow->X);
	for (int i = 0; i < m; i++)
		flow->X[(size_t)i*w + i] = 1.0;
	memcpy(flow->x, x, (size_t)m*sizeof *x);
	error = carry(flow, 1, samples, stretch, omega);
	memcpy(x, flow->x, (size_t)m*sizeof *x);
	for (int i = 0; i < m; i++) {
		memcpy(A + (size_t)i*m, flow->X + (size_t)i*w, (size_t)m*sizeof *A);
		b[i] = flow->X[(size_t)i*w + m];
	}
	return error;
}
