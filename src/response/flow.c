/* response/flow.c - see flow.h. The innermost loop of every response: no allocation, and the
 * derivative's stages reuse the state's Jacobians.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/flow.h"
#include "response/tableau.h"

enum hawser_status hawser__flow_init(struct hawser__flow *flow, const struct hawser_rom *rom,
                                     struct hawser_report *report)
{
	size_t n = (size_t)rom->n, m = 2*n, w = m + 1, stages = HAWSER_RK_STAGES;
	double *next;

	memset(flow, 0, sizeof *flow);
	flow->rom = rom;
	flow->n = (int)n;
	flow->m = (int)m;
	flow->w = (int)w;
	next = flow->memory = calloc(stages*m + m + 2*n + 2*n*n + (2 + stages)*m*w, sizeof *next);
	if (!next)
		return hawser__no_memory(report, "orbit");
	flow->slope = next;
	flow->stage = next += stages*m;
	flow->acc = next += m;
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

/* out = base + h * sum_{j<count} coefficient_j * slope_j, elementwise over `size`. */
static void combine(double *restrict out, const double *restrict base, double h,
                    const double *coefficient, const double *slope, int count, int size)
{
	memcpy(out, base, (size_t)size*sizeof *out);
	for (int j = 0; j < count; j++) {
		const double *restrict s = slope + (size_t)j*size;
		double c = h*coefficient[j];

		if (coefficient[j] == 0.0)
			continue;
		for (int i = 0; i < size; i++)
			out[i] += c*s[i];
	}
}

static void state_slope(const struct hawser__flow *flow, double *slope, double omega)
{
	double inverse = 1.0/omega;

	for (int j = 0; j < flow->n; j++) {
		slope[j] = flow->stage[flow->n + j]*inverse;
		slope[flow->n + j] = flow->acc[j]*inverse;
	}
}

/* row [w] += c * other [w] */
static void add_row(double *restrict row, double c, const double *restrict other, int w)
{
	for (int i = 0; i < w; i++)
		row[i] += c*other[i];
}

/* Slope of X at a stage: (V, Ju U + Jv V)/Omega, and in the last column the explicit Omega. */
static void derivative_slope(const struct hawser__flow *flow, double *slope, double omega)
{
	int n = flow->n, w = flow->w;
	double inverse = 1.0/omega;
	const double *U = flow->X_stage, *V = U + (size_t)n*w;

	for (int i = 0; i < n*w; i++)
		slope[i] = V[i]*inverse;
	memset(slope + (size_t)n*w, 0, (size_t)n*w*sizeof *slope);
	for (int j = 0; j < n; j++) {
		double *row = slope + (size_t)(n + j)*w;

		for (int k = 0; k < n; k++) {
			double cu = flow->by_u[j*n + k], cv = flow->by_v[j*n + k];

			if (cu != 0.0)
				add_row(row, cu*inverse, U + (size_t)k*w, w);
			if (cv != 0.0)
				add_row(row, cv*inverse, V + (size_t)k*w, w);
		}
		slope[(size_t)j*w + w - 1] -= flow->stage[n + j]*inverse*inverse;
		row[w - 1] += (flow->by_omega[j] - flow->acc[j]*inverse)*inverse;
	}
}

/* Hairer's combination of the two comparison formulas: behaves like the error of order 8. */
static double step_error(const struct hawser__flow *flow, double h)
{
	double five = 0.0, three = 0.0;

	for (int i = 0; i < flow->m; i++) {
		double e5 = 0.0, e3 = 0.0;

		for (int s = 0; s < HAWSER_RK_STAGES; s++) {
			e5 += hawser__dop853.e5[s]*flow->slope[s*flow->m + i];
			e3 += hawser__dop853.e3[s]*flow->slope[s*flow->m + i];
		}
		five += e5*e5;
		three += e3*e3;
	}
	return five > 0.0 ? fabs(h)*five/sqrt(five + 0.01*three) : 0.0;
}

static double step(struct hawser__flow *flow, double *x, int derive, double tau, double h,
                   double omega)
{
	const struct hawser__tableau *rk = &hawser__dop853;
	int n = flow->n, m = flow->m, size = m*flow->w;
	double *stage = flow->stage;

	for (int s = 0; s < HAWSER_RK_STAGES; s++) {
		double at = tau + rk->c[s]*h;

		combine(stage, x, h, rk->a[s], flow->slope, s, m);
		if (derive) {
			hawser_rom_acceleration_jacobian(flow->rom, flow->acc, flow->by_u,
			                                 flow->by_v, flow->by_omega, stage,
			                                 stage + n, at, omega);
			combine(flow->X_stage, flow->X, h, rk->a[s], flow->X_slope, s, size);
			derivative_slope(flow, flow->X_slope + (size_t)s*size, omega);
		} else {
			hawser_rom_acceleration(flow->rom, flow->acc, stage, stage + n, at, omega);
		}
		state_slope(flow, flow->slope + s*m, omega);
	}
	combine(stage, x, h, rk->b, flow->slope, HAWSER_RK_STAGES, m);
	memcpy(x, stage, (size_t)m*sizeof *x);
	if (derive) {
		combine(flow->X_stage, flow->X, h, rk->b, flow->X_slope, HAWSER_RK_STAGES, size);
		memcpy(flow->X, flow->X_stage, (size_t)size*sizeof *flow->X);
	}
	flow->stages += HAWSER_RK_STAGES;
	return step_error(flow, h);
}

static double carry(struct hawser__flow *flow, double *x, int derive, double *samples,
                    const struct hawser__stretch *stretch, double omega)
{
	double error = 0.0;

	for (int i = 0; i < stretch->steps; i++) {
		if (samples)
			memcpy(samples + (size_t)i*flow->n, x, (size_t)flow->n*sizeof *x);
		error += step(flow, x, derive, stretch->tau + i*stretch->h, stretch->h, omega);
	}
	return error;
}

double hawser__flow_map(struct hawser__flow *flow, double *x, double *samples,
                        const struct hawser__stretch *stretch, double omega)
{
	return carry(flow, x, 0, samples, stretch, omega);
}

double hawser__flow_derive(struct hawser__flow *flow, double *x, double *A, double *b,
                           double *samples, const struct hawser__stretch *stretch, double omega)
{
	int m = flow->m, w = flow->w;
	double error;

	memset(flow->X, 0, (size_t)m*w*sizeof *flow->X);
	for (int i = 0; i < m; i++)
		flow->X[(size_t)i*w + i] = 1.0;
	error = carry(flow, x, 1, samples, stretch, omega);
	for (int i = 0; i < m; i++) {
		memcpy(A + (size_t)i*m, flow->X + (size_t)i*w, (size_t)m*sizeof *A);
		b[i] = flow->X[(size_t)i*w + w - 1];
	}
	return error;
}
