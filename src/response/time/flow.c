/* response/time/flow.c - see flow.h. The innermost loop of every response: no allocation.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hot.h"
#include "core/report.h"
#include "response/time/flow.h"
#include "rom/energy/kernel.h"
#include "rom/terms/terms.h"
#include "rom/terms/vary.h"

/* Largest d H for which the damping of a coordinate is part of the formula. */
#define LARGEST_DAMPING 1.0

enum { LANES = HAWSER_LANES, STAGES = HAWSER_RK_STAGES };

static int damping_varies(const struct hawser_rom *rom)
{
	for (int h = 0; h < rom->harmonics; h++)
		if (rom->harmonic[h].D)
			return 1;
	return 0;
}

/* The different values on the diagonal of D. */
static void list_dampings(struct hawser__flow *flow)
{
	int n = flow->n;

	flow->dampings = 0;
	for (int j = 0; j < n; j++) {
		double d = flow->rom->D[j*n + j];
		int i = 0;

		while (i < flow->dampings && flow->damping[i] != d)
			i++;
		flow->damping_of[j] = i;
		flow->damping[i] = d;
		if (i == flow->dampings)
			flow->dampings++;
	}
}

/* Divide the memory among the arrays; if next is NULL, return the number of doubles required. */
static size_t share(struct hawser__flow *flow, double *next)
{
	size_t n = (size_t)flow->n, harmonics = (size_t)flow->rom->harmonics, lane = LANES;
	size_t block = n*(size_t)flow->w;
	struct { double **array; size_t size; } part[] = {
		{&flow->damping, n}, {&flow->coupling, n*n}, {&flow->turn, harmonics*2*STAGES},
		{&flow->phase, harmonics*2*lane}, {&flow->wave, harmonics*lane},
		{&flow->u, n*lane}, {&flow->v, n*lane}, {&flow->stage_u, n*lane},
		{&flow->stage_v, n*lane}, {&flow->force, n*lane}, {&flow->f, STAGES*n*lane},
		{&flow->by_u, STAGES*n*n*lane}, {&flow->by_v, STAGES*n*n*lane},
		{&flow->f_omega, STAGES*n*lane}, {&flow->u_omega, (STAGES + 1)*n*lane},
		{&flow->v_omega, (STAGES + 1)*n*lane}, {&flow->work, HAWSER_LANES_WORK(n)},
		{&flow->U, lane*block}, {&flow->V, lane*block}, {&flow->F, STAGES*block},
		{&flow->stage_U, block}, {&flow->stage_V, block},
	};
	size_t total = 0;

	for (size_t i = 0; i < sizeof part/sizeof *part; i++) {
		if (next)
			*part[i].array = next + total;
		total += part[i].size;
	}
	return total;
}

enum hawser_status hawser__flow_init(struct hawser__flow *flow, const struct hawser_rom *rom,
                                     struct hawser_report *report)
{
	memset(flow, 0, sizeof *flow);
	flow->rom = rom;
	flow->n = rom->n;
	flow->m = 2*rom->n;
	flow->w = HAWSER_PADDED(flow->m + 1);
	flow->harmonics = rom->harmonics;
	flow->memory = calloc(share(flow, NULL), sizeof *flow->memory);
	flow->damping_of = calloc((size_t)rom->n, sizeof *flow->damping_of);
	if (flow->memory && flow->damping_of) {
		share(flow, flow->memory);
		flow->nystrom = malloc((size_t)flow->n*sizeof *flow->nystrom);
	}
	if (flow->nystrom && !hawser__flow_place(flow, rom))
		return HAWSER_OK;
	hawser__flow_clear(flow);
	return hawser__no_memory(report, "orbit");
}

int hawser__flow_place(struct hawser__flow *flow, const struct hawser_rom *rom)
{
	if (rom->n != flow->n || rom->harmonics != flow->harmonics)
		return 1;
	flow->rom = rom;
	flow->more = hawser__rom_more(rom);
	flow->damping_varies = damping_varies(rom) || rom->drag || flow->more;
	list_dampings(flow);
	return 0;
}

void hawser__flow_clear(struct hawser__flow *flow)
{
	free(flow->memory);
	free(flow->damping_of);
	free(flow->nystrom);
	memset(flow, 0, sizeof *flow);
}

/* --- constants of all steps --- */

/* Whether the diagonal of D is in the formula; otherwise it is part of f like the rest of D. */
static int damping_eliminated(const struct hawser__flow *flow, double h, double omega)
{
	for (int i = 0; i < flow->dampings; i++)
		if (!(fabs(flow->damping[i]*h) <= LARGEST_DAMPING*omega))
			return 0;
	return 1;
}

static void prepare(struct hawser__flow *flow, double h, double omega)
{
	const struct hawser_rom *rom = flow->rom;
	int n = flow->n, eliminated = damping_eliminated(flow, h, omega);

	flow->h = h;
	flow->coupled = flow->damping_varies;
	for (int i = 0; i < n*n; i++) {
		flow->coupling[i] = eliminated && i%(n + 1) == 0 ? 0.0 : rom->D[i];
		flow->coupled |= flow->coupling[i] != 0.0;
	}
	for (int i = 0; i < flow->dampings; i++)
		hawser__nystrom(&flow->nystrom[i], eliminated ? flow->damping[i] : 0.0, h, omega);
	for (int k = 0; k < rom->harmonics; k++)
		for (int s = 0; s < STAGES; s++) {
			double angle = rom->harmonic[k].k*hawser__dop853.c[s]*h;

			flow->turn[2*(k*STAGES + s)] = cos(angle);
			flow->turn[2*(k*STAGES + s) + 1] = sin(angle);
		}
}

/* Phase of the harmonics at the start of a step. */
static void set_phases(struct hawser__flow *flow, double tau, double apart, int live)
{
	for (int lane = 0; lane < LANES; lane++)
		flow->at[lane] = tau + (lane < live ? lane : live - 1)*apart;
	for (int k = 0; k < flow->rom->harmonics; k++)
		for (int lane = 0; lane < LANES; lane++) {
			double angle = flow->rom->harmonic[k].k*flow->at[lane];

			flow->phase[2*k*LANES + lane] = cos(angle);
			flow->phase[(2*k + 1)*LANES + lane] = sin(angle);
		}
}

/* --- a stage of all lanes --- */

static inline hawser__vec *lanes(double *array, int i)
{
	return (hawser__vec *)(array + (size_t)i*LANES);
}

/* out = base + c v + sum of row_l f_l for coordinate j; base may be NULL. */
HAWSER_PART void combine(hawser__vec *out, const hawser__vec *base, const struct hawser__flow *flow,
                         double c, const double *row, int count, int j)
{
	hawser__vec sum = c**lanes(flow->v, j);

	if (base)
		sum += *base;
	for (int l = 0; l < count; l++)
		sum += row[l]**lanes(flow->f, l*flow->n + j);
	*out = sum;
}

/* State at stage s, and the terms of its derivative that are due to the dependence of the step
 * length on Omega. */
HAWSER_PART void set_stage(struct hawser__flow *flow, int s, int derive)
{
	int n = flow->n, before = s > 1 ? s - 1 : 0;

	for (int j = 0; j < n; j++) {
		const struct hawser__nystrom *ny = &flow->nystrom[flow->damping_of[j]];

		combine(lanes(flow->stage_u, j), lanes(flow->u, j), flow, ny->uv[s], ny->uf[s],
		        before, j);
		if (derive)
			combine(lanes(flow->u_omega, s*n + j), NULL, flow, ny->uv_omega[s],
			        ny->uf_omega[s], before, j);
		if (!flow->coupled)
			continue;
		combine(lanes(flow->stage_v, j), lanes(flow->v, j), flow, ny->vv[s], ny->vf[s], s,
		        j);
		if (derive)
			combine(lanes(flow->v_omega, s*n + j), NULL, flow, ny->vv_omega[s],
			        ny->vf_omega[s], s, j);
	}
}

/* out [n] -= factor * matrix [n][n] * x [n]. */
HAWSER_PART void subtract_product(double *out, hawser__vec factor, const double *matrix, double *x,
                                  int n)
{
	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++)
			*lanes(out, j) -= factor*matrix[j*n + k]**lanes(x, k);
}

/* Derivative of the load by Omega, including the power of Omega in front of it. */
HAWSER_PART void add_harmonic(struct hawser__flow *flow, double *out, hawser__vec factor, int k)
{
	const struct hawser_harmonic *harmonic = &flow->rom->harmonic[k];

	for (int j = 0; harmonic->f && j < flow->n; j++)
		*lanes(out, j) += factor*harmonic->f[j];
	if (harmonic->D)
		subtract_product(out, factor, harmonic->D, flow->stage_v, flow->n);
	if (harmonic->K)
		subtract_product(out, factor, harmonic->K, flow->stage_u, flow->n);
}

/* Factors of the harmonics at stage s. */
HAWSER_PART void set_waves(struct hawser__flow *flow, int s, double omega)
{
	for (int k = 0; k < flow->rom->harmonics; k++) {
		const struct hawser_harmonic *harmonic = &flow->rom->harmonic[k];
		double power = 1.0, c = flow->turn[2*(k*STAGES + s)];
		double d = flow->turn[2*(k*STAGES + s) + 1];
		hawser__vec at_cos = *lanes(flow->phase, 2*k), at_sin = *lanes(flow->phase, 2*k + 1);

		for (int p = 0; p < harmonic->omega_power; p++)
			power *= omega;
		*lanes(flow->wave, k) = power*(harmonic->phase == HAWSER_COS
		                               ? c*at_cos - d*at_sin : c*at_sin + d*at_cos);
	}
}

HAWSER_PART void set_slope(struct hawser__flow *flow, int s)
{
	int n = flow->n;
	double *f = flow->f + (size_t)s*n*LANES;

	for (int j = 0; j < n; j++) {
		hawser__vec sum = -*lanes(flow->force, j);

		for (int k = 0; flow->coupled && k < n; k++)
			sum -= flow->coupling[j*n + k]**lanes(flow->stage_v, k);
		*lanes(f, j) = sum;
	}
	for (int k = 0; k < flow->rom->harmonics; k++)
		add_harmonic(flow, f, *lanes(flow->wave, k), k);
}

/* The terms of vary.h, added to the restoring force and to its derivative. */
HAWSER_PART void set_varying(struct hawser__flow *flow, int s, double *by_u)
{
	for (int lane = 0; flow->rom->exact && hawser__rom_varies(flow->rom) && lane < LANES; lane++)
		hawser__rom_vary_lane(flow->rom, flow->force + lane, by_u ? by_u + lane : NULL,
		                      flow->stage_u + lane, flow->at[lane] + hawser__dop853.c[s]*flow->h,
		                      LANES);
	for (int k = 0; k < flow->rom->harmonics; k++)
		for (int i = 0; i < flow->rom->harmonic[k].quads; i++) { /* as vary_by of rom/terms/vary.c */
			const struct hawser_quad *q = &flow->rom->harmonic[k].Q[i];
			hawser__vec value = *lanes(flow->wave, k)*q->value;
			hawser__vec x = *lanes(flow->stage_u, q->k), y = *lanes(flow->stage_u, q->l);

			*lanes(flow->force, q->j) += value*x*y;
			if (!by_u)
				continue;
			*lanes(by_u, q->j*flow->n + q->k) += value*y;
			*lanes(by_u, q->j*flow->n + q->l) += value*x;
		}
}

/* Contribution of the harmonics to the derivatives of f. */
HAWSER_PART void set_derivatives(struct hawser__flow *flow, int s, double omega)
{
	int n = flow->n;
	double *f_omega = flow->f_omega + (size_t)s*n*LANES;
	hawser__vec zero = {0.0};

	for (int i = 0; flow->coupled && i < n*n; i++)
		*lanes(flow->by_v, s*n*n + i) = zero + flow->coupling[i];
	memset(f_omega, 0, (size_t)n*LANES*sizeof *f_omega);
	for (int k = 0; k < flow->rom->harmonics; k++) {
		const struct hawser_harmonic *harmonic = &flow->rom->harmonic[k];
		hawser__vec wave = *lanes(flow->wave, k);

		for (int i = 0; harmonic->K && i < n*n; i++)
			*lanes(flow->by_u, s*n*n + i) += wave*harmonic->K[i];
		for (int i = 0; harmonic->D && i < n*n; i++)
			*lanes(flow->by_v, s*n*n + i) += wave*harmonic->D[i];
		if (harmonic->omega_power > 0)
			add_harmonic(flow, f_omega, harmonic->omega_power/omega*wave, k);
	}
}

/* --- a step --- */

/* Hairer's combination of the two comparison formulas is proportional to the error, but 8 to 40
 * times as large for steps with errors of 1e-6 to 1e-11 (measured: tests/unit/test-flow.c). */
#define CALIBRATION 0.125

/* Sum of the estimated errors over the lanes in use. */
HAWSER_PART double step_error(const struct hawser__flow *flow, int live)
{
	hawser__vec five = {0.0}, three = {0.0};
	double sum = 0.0;

	for (int j = 0; j < flow->n; j++)
		for (int row = HAWSER_RK_FIVE; row <= HAWSER_RK_THREE; row++) {
			const struct hawser__nystrom *ny = &flow->nystrom[flow->damping_of[j]];
			hawser__vec eu, ev;

			combine(&eu, NULL, flow, ny->uv[row], ny->uf[row], STAGES, j);
			combine(&ev, NULL, flow, ny->vv[row], ny->vf[row], STAGES, j);
			if (row == HAWSER_RK_FIVE)
				five += eu*eu + ev*ev;
			else
				three += eu*eu + ev*ev;
		}
	for (int lane = 0; lane < live; lane++)
		if (!(five[lane] == 0.0)) /* keeps a NaN */
			sum += CALIBRATION*five[lane]/sqrt(five[lane] + 0.01*three[lane]);
	return sum;
}

HAWSER_PART void finish_step(struct hawser__flow *flow, int derive)
{
	const int end = HAWSER_RK_END;

	for (int j = 0; j < flow->n; j++) {
		const struct hawser__nystrom *ny = &flow->nystrom[flow->damping_of[j]];
		int at = end*flow->n + j;

		if (derive) {
			combine(lanes(flow->u_omega, at), NULL, flow, ny->uv_omega[end],
			        ny->uf_omega[end], STAGES - 1, j);
			combine(lanes(flow->v_omega, at), NULL, flow, ny->vv_omega[end],
			        ny->vf_omega[end], STAGES, j);
		}
		combine(lanes(flow->u, j), lanes(flow->u, j), flow, ny->uv[end], ny->uf[end],
		        STAGES - 1, j);
		combine(lanes(flow->v, j), lanes(flow->v, j), flow, ny->vv[end], ny->vf[end],
		        STAGES, j);
	}
}

HAWSER_HOT
static double step(struct hawser__flow *flow, int derive, int live, double omega)
{
	size_t n = (size_t)flow->n;
	double error;

	for (int s = 0; s < STAGES; s++) {
		double *by_u = derive ? flow->by_u + (size_t)s*n*n*LANES : NULL;

		set_stage(flow, s, derive);
		hawser__rom_lanes(flow->rom, flow->force, by_u, flow->stage_u, live, flow->work);
		set_waves(flow, s, omega);
		set_varying(flow, s, by_u);
		set_slope(flow, s);
		if (derive)
			set_derivatives(flow, s, omega);
		if (flow->rom->drag)
			hawser__flow_drag(flow, s, derive, live, omega);
		if (flow->more)
			hawser__flow_more(flow, s, derive, live, omega);
	}
	error = step_error(flow, live);
	finish_step(flow, derive);
	return error;
}

/* --- stretches --- */

/* Copy the states x [live][m] to the lanes; unused lanes get the last state. */
static void load(struct hawser__flow *flow, const double *x, int live)
{
	for (int lane = 0; lane < LANES; lane++)
		for (int j = 0; j < flow->n; j++) {
			const double *from = x + (lane < live ? lane : live - 1)*flow->m;

			flow->u[j*LANES + lane] = from[j];
			flow->v[j*LANES + lane] = from[flow->n + j];
		}
}

static void store(const struct hawser__flow *flow, double *x, int live)
{
	for (int lane = 0; lane < live; lane++)
		for (int j = 0; j < flow->n; j++) {
			x[lane*flow->m + j] = flow->u[j*LANES + lane];
			x[lane*flow->m + flow->n + j] = flow->v[j*LANES + lane];
		}
}

/* Set U and V to the identity. */
static void load_identity(struct hawser__flow *flow, int live)
{
	size_t block = (size_t)flow->n*flow->w;

	memset(flow->U, 0, (size_t)live*block*sizeof *flow->U);
	memset(flow->V, 0, (size_t)live*block*sizeof *flow->V);
	for (int lane = 0; lane < live; lane++)
		for (int j = 0; j < flow->n; j++) {
			flow->U[(size_t)lane*block + (size_t)j*flow->w + j] = 1.0;
			flow->V[(size_t)lane*block + (size_t)j*flow->w + flow->n + j] = 1.0;
		}
}

static void store_derivatives(const struct hawser__flow *flow, double *A, double *b, int live)
{
	size_t n = (size_t)flow->n, m = (size_t)flow->m, w = (size_t)flow->w;

	for (size_t lane = 0; lane < (size_t)live; lane++)
		for (size_t i = 0; i < m; i++) {
			const double *row = i < n ? flow->U + (lane*n + i)*w
			                          : flow->V + (lane*n + i - n)*w;

			memcpy(A + (lane*m + i)*m, row, m*sizeof *A);
			b[lane*m + i] = row[m];
		}
}

/* Integrate the stretches in the lanes. */
static double carry(struct hawser__flow *flow, int derive, double *samples, int live,
                    const struct hawser__stretch *stretch, double tau, double omega)
{
	int n = flow->n;
	double error = 0.0;

	for (int i = 0; i < stretch->steps; i++) {
		for (int lane = 0; samples && lane < live; lane++)
			for (int j = 0; j < n; j++)
				samples[((size_t)lane*stretch->steps + i)*n + j] =
					flow->u[j*LANES + lane];
		set_phases(flow, tau + i*stretch->h, stretch->apart, live);
		error += step(flow, derive, live, omega);
		for (int lane = 0; derive && lane < live; lane++)
			hawser__flow_vary(flow, lane);
	}
	return error;
}

/* The stages add s - 1 (or s) slopes and
 * one further vector at stage s: 67 (or 78) in the 12 stages, and 12 and 13 at the end. */
double hawser__flow_flops(const struct hawser__flow *flow, int derive)
{
	double n = flow->n, width = flow->m + 1, flops = STAGES*hawser__rom_flops(flow->rom, derive);
	double stages = flow->coupled ? 67.0 + 78.0 : 67.0, products = flow->coupled ? 2.0 : 1.0;

	flops += 2.0*n*(stages + 25.0 + 4.0*(STAGES + 1)) + products*STAGES*2.0*n*n*flow->coupled;
	if (derive)
		flops += 2.0*n*(stages + 25.0) + 2.0*n*width*(stages + 25.0 + products*STAGES*n);
	return flops;
}

/* A and b are NULL for the flow without derivatives. */
static double run(struct hawser__flow *flow, double *x, double *A, double *b, double *samples,
                  const struct hawser__stretch *stretch, double omega)
{
	size_t n = (size_t)flow->n, m = (size_t)flow->m;
	double error = 0.0;

	prepare(flow, stretch->h, omega);
	for (int first = 0; first < stretch->count; first += LANES) {
		size_t at = (size_t)first;
		int live = stretch->count - first < LANES ? stretch->count - first : LANES;

		load(flow, x + at*m, live);
		if (A)
			load_identity(flow, live);
		error += carry(flow, A != NULL, samples ? samples + at*stretch->steps*n : NULL,
		               live, stretch, stretch->tau + first*stretch->apart, omega);
		store(flow, x + at*m, live);
		if (A)
			store_derivatives(flow, A + at*m*m, b + at*m, live);
	}
	flow->stages += (long)stretch->count*stretch->steps*STAGES;
	flow->flops += (double)stretch->count*stretch->steps*hawser__flow_flops(flow, A != NULL);
	return error;
}

double hawser__flow_map(struct hawser__flow *flow, double *x, double *samples,
                        const struct hawser__stretch *stretch, double omega)
{
	return run(flow, x, NULL, NULL, samples, stretch, omega);
}

double hawser__flow_derive(struct hawser__flow *flow, double *x, double *A, double *b,
                           double *samples, const struct hawser__stretch *stretch, double omega)
{
	return run(flow, x, A, b, samples, stretch, omega);
}
