/* response/backbone/scales.c - the method of multiple scales as a method of method.h: equilibria of the
 * modulation equations (hawser/scales.h) represent orbits, and their eigenvalues multipliers.
 *
 *    y    real parts of the R amplitudes, imaginary parts, Omega
 *    G    the equations, each divided by the stiffness of its mode
 *    L    eigenvalue of the modulation equations: the multiplier is exp(2 pi L/Omega). Modes that are
 *         not resonant have the multipliers of their own free decay
 *
 * The certificate refers to the modulation equations. The distance from the orbits of the model
 * itself is shown by the sample of points that shooting computes again (certify.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/determinant.h"
#include "core/report.h"
#include "response/orbit/method.h"
#include "response/backbone/modulation.h"

enum { MOST = 2*HAWSER_RESONANT_MOST, SIZE = MOST + 1, PHASES = 64 };

struct scales {
	struct hawser__orbit base;
	struct hawser_modulation modulation;
	double G[MOST], by_x[MOST*MOST], by_omega[MOST];
	double matrix[SIZE*SIZE]; /* column-major, factors of the scaled bordered Jacobian */
	int pivot[SIZE];
	double norm;
	double scale[MOST], over[MOST]; /* scales of an unknown and of an equation */
	double direct;                  /* squared size of the direct response, which does not depend on
	                                 * the amplitudes */
};

static struct scales *of(struct hawser__orbit *orbit)
{
	return (struct scales *)orbit;
}

static void clear(struct hawser__orbit *orbit)
{
	hawser_modulation_clear(&of(orbit)->modulation);
	free(orbit->samples);
	hawser__orbit_free(orbit);
	free(orbit);
}

static void metric(struct hawser__orbit *orbit, const double *y)
{
	struct scales *scales = of(orbit);
	int count = orbit->size - 1, R = count/2;
	double sum = scales->direct;

	for (int i = 0; i < count; i++)
		sum += y[i]*y[i];
	orbit->X = sum > 0.0 ? sqrt(sum) : 1.0;
	for (int i = 0; i < count; i++) {
		/* NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): R is at least 1 */
		double both = hypot(y[i%R], y[R + i%R]);

		scales->scale[i] = fmax(both, HAWSER_SCALE_FLOOR*orbit->X);
		orbit->weight[i] = 1.0/(scales->scale[i]*scales->scale[i]*count);
	}
	orbit->W = HAWSER_OMEGA_WIDTH*fabs(y[count]);
	orbit->weight[count] = 1.0/(orbit->W*orbit->W);
}

static void sample(struct scales *scales, const double *x)
{
	for (int i = 0; i < PHASES; i++)
		hawser_modulation_motion(&scales->modulation,
		                         scales->base.samples + (size_t)i*(size_t)scales->base.n, x,
		                         2.0*M_PI*i/PHASES);
}

static double defects(struct hawser__orbit *orbit, const double *y, int derive)
{
	struct scales *scales = of(orbit);
	int count = orbit->size - 1;
	double worst = 0.0;

	hawser_modulation_equations(&scales->modulation, scales->G, derive ? scales->by_x : NULL,
	                            derive ? scales->by_omega : NULL, y, y[count]);
	for (int i = 0; i < count; i++) {
		double size = fabs(scales->G[i])/scales->over[i];

		if (!(size <= worst)) /* keeps a NaN */
			worst = size;
	}
	if (derive) {
		sample(scales, y);
		orbit->cost.flows++;
	} else {
		orbit->cost.maps++;
	}
	return worst/orbit->X;
}

static int factor(struct hawser__orbit *orbit, const double *row)
{
	struct scales *scales = of(orbit);
	int size = orbit->size, count = size - 1;
	double *matrix = scales->matrix;

	for (int i = 0; i < count; i++) {
		double over = 1.0/(scales->over[i]*scales->scale[i]);

		for (int k = 0; k < count; k++)
			matrix[k*size + i] = scales->by_x[i*count + k]*scales->scale[k]*over;
		matrix[count*size + i] = scales->by_omega[i]*orbit->W*over;
		matrix[i*size + count] = orbit->weight[i]*row[i]*scales->scale[i];
	}
	matrix[size*size - 1] = row[count]/orbit->W;
	scales->norm = LAPACKE_dlange_work(LAPACK_COL_MAJOR, '1', size, size, matrix, size, NULL);
	if (!isfinite(scales->norm) ||
	    LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, size, size, matrix, size, scales->pivot))
		return 1;
	orbit->det_log = hawser__determinant(&orbit->det_sign, matrix, scales->pivot, size);
	return 0;
}

static void solve(struct hawser__orbit *orbit, double *dy, int homogeneous, double last)
{
	struct scales *scales = of(orbit);
	int size = orbit->size, count = size - 1;

	for (int i = 0; i < count; i++)
		dy[i] = homogeneous ? 0.0 : -scales->G[i]/(scales->over[i]*scales->scale[i]);
	dy[count] = last;
	LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', size, 1, scales->matrix, size, scales->pivot, dy,
	                    size);
	for (int i = 0; i < count; i++)
		dy[i] *= scales->scale[i];
	dy[count] *= orbit->W;
}

static double error(struct hawser__orbit *orbit, double residual)
{
	struct scales *scales = of(orbit);
	double rcond = 0.0, work[4*SIZE];
	int integers[SIZE];

	LAPACKE_dgecon_work(LAPACK_COL_MAJOR, '1', orbit->size, scales->matrix, orbit->size,
	                    scales->norm,
	                    &rcond, work, integers);
	return residual/(rcond*scales->norm);
}

/* --- multipliers --- */

struct multiplier {
	double log_modulus, argument;
};

static int falling(const void *left, const void *right)
{
	const struct multiplier *a = left, *b = right;

	if (a->log_modulus != b->log_modulus)
		return a->log_modulus < b->log_modulus ? 1 : -1;
	if (fabs(a->argument) != fabs(b->argument))
		return fabs(a->argument) < fabs(b->argument) ? -1 : 1;
	return (a->argument < b->argument) - (a->argument > b->argument);
}

static struct multiplier multiplier(double re, double im, double period)
{
	/* cppcheck-suppress ignoredReturnValue ; it is the value of a member */
	return (struct multiplier){re*period, remainder(im*period, 2.0*M_PI)};
}

/* dA/dt = i G/(2 p Omega), in real and imaginary parts. */
static void rates(double *rate, const struct scales *scales, double omega)
{
	const struct hawser_resonance *resonance = &scales->modulation.resonance;
	int R = resonance->count, count = 2*R;

	for (int r = 0; r < R; r++) {
		double over = 1.0/(2.0*resonance->order[r]*omega);

		for (int k = 0; k < count; k++) {
			rate[k*count + r] = -scales->by_x[(R + r)*count + k]*over;
			rate[k*count + R + r] = scales->by_x[r*count + k]*over;
		}
	}
}

static int is_resonant(const struct hawser_resonance *resonance, int s)
{
	for (int r = 0; r < resonance->count; r++)
		if (resonance->mode[r] == s)
			return 1;
	return 0;
}

static enum hawser_status multipliers(struct hawser__orbit *orbit, struct hawser_report *report)
{
	struct scales *scales = of(orbit);
	const struct hawser_rom *rom = orbit->rom;
	int count = orbit->size - 1, m = 0;
	double omega = orbit->W/HAWSER_OMEGA_WIDTH, period = 2.0*M_PI/omega;
	double rate[MOST*MOST], re[MOST], im[MOST], unused, work[8*MOST];
	struct multiplier *all = malloc((size_t)orbit->m*sizeof *all);

	if (!all)
		return hawser__no_memory(report, "multiple scales");
	rates(rate, scales, omega);
	orbit->product_error = orbit->product_round_off =
		DBL_EPSILON*count*period*cblas_dnrm2(count*count, rate, 1);
	if (LAPACKE_dgeev_work(LAPACK_COL_MAJOR, 'N', 'N', count, rate, count, re, im, &unused, 1,
	                       &unused,
	                       1, work, 8*MOST)) {
		free(all);
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "multiple scales",
		                    "the eigenvalues of the modulation equations were not found");
	}
	for (int i = 0; i < count; i++)
		all[m++] = multiplier(re[i], im[i], period);
	for (int s = 0; s < rom->n; s++) {
		double half = 0.5*rom->D[(size_t)s*((size_t)rom->n + 1)], k = hawser__stiffness(rom, s);
		double w = sqrt(fabs(k - half*half));

		if (is_resonant(&scales->modulation.resonance, s))
			continue;
		if (k > half*half) {
			all[m++] = multiplier(-half, w, period);
			all[m++] = multiplier(-half, -w, period);
		} else {
			all[m++] = multiplier(-half + w, 0.0, period);
			all[m++] = multiplier(-half - w, 0.0, period);
		}
	}
	qsort(all, (size_t)m, sizeof *all, falling);
	for (int i = 0; i < m; i++) {
		orbit->log_modulus[i] = all[i].log_modulus;
		orbit->argument[i] = all[i].argument;
	}
	free(all);
	return HAWSER_OK;
}

/* --- the other functions of the method --- */

static enum hawser_status as_it_is(struct hawser__orbit *orbit, int *again, double tolerance,
                                   double omega, struct hawser_report *report)
{
	(void)orbit, (void)tolerance, (void)omega, (void)report;
	*again = 0;
	return HAWSER_OK;
}

static enum hawser_status relax(struct hawser__orbit *orbit, double tolerance,
                                struct hawser_report *report)
{
	(void)orbit, (void)tolerance, (void)report;
	return HAWSER_OK;
}

/* The modulation equations have no discretisation: a comparison shows round-off only. */
static enum hawser_status sharpen(struct hawser__orbit *orbit, int on, struct hawser_report *report)
{
	(void)orbit, (void)on, (void)report;
	return HAWSER_OK;
}

static enum hawser_status enrich(struct hawser__orbit *orbit, int most, struct hawser_report *report)
{
	(void)orbit, (void)most;
	return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "multiple scales",
	                    "no equilibrium of the modulation equations was found: start elsewhere");
}

/* p cos + q sin is Re[(p - i q) exp(i k tau)]: twice the amplitude. */
static void add_wave(struct hawser__orbit *orbit, double *y, const double *pq, int k, double omega)
{
	const struct hawser_resonance *resonance = &of(orbit)->modulation.resonance;
	int R = resonance->count;

	(void)omega;
	for (int r = 0; r < R; r++)
		if (resonance->order[r] == k) {
			y[r] += 0.5*pq[resonance->mode[r]];
			y[R + r] -= 0.5*pq[orbit->n + resonance->mode[r]];
		}
}

/* At first order u = 2 Re A and du/dt = -2 p Omega Im A at phase 0. */
static enum hawser_status from_state(struct hawser__orbit *orbit, double *y, const double *x,
                                     double omega, struct hawser_report *report)
{
	const struct hawser_resonance *resonance = &of(orbit)->modulation.resonance;
	int R = resonance->count;

	(void)report;
	for (int r = 0; r < R; r++) {
		y[r] = 0.5*x[resonance->mode[r]];
		y[R + r] = -0.5*x[orbit->n + resonance->mode[r]]/(resonance->order[r]*omega);
	}
	return HAWSER_OK;
}

static void state(const struct hawser__orbit *orbit, double *x, const double *y)
{
	const struct scales *scales = (const struct scales *)orbit;

	hawser_modulation_state(&scales->modulation, x, y, y[orbit->size - 1]);
}

static const struct hawser__orbit_ops ops = {
	metric, defects, factor, solve, error, multipliers, as_it_is, relax, enrich,
	sharpen, add_wave, from_state, state, clear, NULL, NULL, NULL, NULL,
};

static double direct_size(const struct hawser_modulation *m)
{
	double sum = 0.0;

	for (int i = 0; i < m->carriers; i++)
		for (int e = 0; m->carrier[i].variable < 0 && e < 2*m->rom->n; e++)
			sum += 0.5*m->carrier[i].c[e]*m->carrier[i].c[e];
	return sum;
}

static enum hawser_status open_method(struct hawser__orbit **orbit, const struct hawser_rom *rom,
                                      const struct hawser_frf_options *options,
                                      struct hawser_report *report)
{
	struct scales *scales = calloc(1, sizeof *scales);
	struct hawser_resonance resonance;
	enum hawser_status status = HAWSER_OK;

	*orbit = NULL;
	if (!scales)
		return hawser__no_memory(report, "frf");
	if (options->resonance)
		resonance = *options->resonance;
	else
		status = hawser_resonance_find(&resonance, rom, options->from, options->to, report);
	if (!status)
		status = hawser_modulation_derive(&scales->modulation, rom, &resonance, report);
	if (!status)
		status = hawser__orbit_init(&scales->base, rom, 2*resonance.count + 1, report);
	if (!status && !(scales->base.samples = calloc((size_t)PHASES*(size_t)rom->n, sizeof(double))))
		status = hawser__no_memory(report, "frf");
	if (status) {
		clear(&scales->base);
		return status;
	}
	scales->base.ops = &ops;
	scales->direct = direct_size(&scales->modulation);
	scales->base.rows = PHASES;
	scales->base.resolution = 2*resonance.count;
	for (int i = 0; i < 2*resonance.count; i++)
		scales->over[i] = hawser__stiffness(rom, resonance.mode[i%resonance.count]);
	*orbit = &scales->base;
	return HAWSER_OK;
}

static int never(const struct hawser_rom *rom, const struct hawser_frf_options *options)
{
	(void)rom, (void)options;
	return 0;
}

const struct hawser__orbit_method hawser__scales_method = {
	{"multiple-scales",
	 "equilibria of the modulation equations of the resonant modes (approximate)",
	 "Nayfeh and Mook 1979; Bertrand 2022, 4.3", 1},
	open_method, never,
};
