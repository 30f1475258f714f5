/* response/orbit/shooting.c - see shooting.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/determinant.h"
#include "core/grow.h"
#include "core/report.h"
#include "response/floquet/floquet.h"
#include "response/orbit/shooting.h"

/* With up to this many steps per period the error is estimated in a second way; see
 * halved_steps(). */
#define COARSE 32
/* Safety factor on the error from the comparison formulas and the condition estimate in the 1-norm.
 * The largest ratio of true to stated error was 0.6 in 3000 cases (bench/estimates frf). */
#define SAFETY 6.0
/* Round-off of the map, relative to the terms of a defect. */
#define ROUND_OFF 2e-15
/* Relative error of the multipliers by the steps, without that of the orbit. The Liouville gap of
 * strongly damped coordinates is larger but does not concern the multipliers near the unit circle.
 * With this value, the largest of 262 ratios of true to stated error is 0.08 (bench/estimates
 * events 150 7). */
#define LARGEST_GAP 1e-6

/* Largest product of the norms of two neighbouring transition matrices that are multiplied: 1e4
 * leaves twelve digits. */
#define LARGEST_PRODUCT 1e4

static const struct hawser__orbit_ops ops;

enum hawser_status hawser__shooting_remesh(struct hawser__shooting *shooting, int steps,
                                           struct hawser_report *report)
{
	int rows = shooting->segments*steps;

	shooting->steps = steps;
	shooting->base.rows = shooting->base.resolution = rows;
	if (rows > shooting->sample_capacity) {
		if (hawser__resize(&shooting->base.samples, 2*(size_t)rows*(size_t)shooting->base.n,
		                   sizeof(double)))
			return hawser__no_memory(report, "orbit");
		shooting->sample_capacity = 2*rows;
	}
	return HAWSER_OK;
}

enum hawser_status hawser__shooting_init(struct hawser__shooting *shooting,
                                         const struct hawser_rom *rom, int segments, int steps,
                                         struct hawser_report *report)
{
	size_t m = 2*(size_t)rom->n, S = (size_t)segments, size = S*m + 1;
	enum hawser_status status;

	memset(shooting, 0, sizeof *shooting);
	shooting->base.ops = &ops;
	shooting->segments = segments;
	shooting->scale = hawser__hold(&shooting->hold, m, sizeof(double));
	shooting->defect = hawser__hold(&shooting->hold, S*m, sizeof(double));
	shooting->finer = hawser__hold(&shooting->hold, S*m, sizeof(double));
	shooting->A = hawser__hold(&shooting->hold, S*m*(m + 1), sizeof(double));
	shooting->matrix = hawser__hold(&shooting->hold, size*size, sizeof(double));
	shooting->pivot = hawser__hold(&shooting->hold, size, sizeof(int));
	shooting->estimate = hawser__hold(&shooting->hold, 4*size, sizeof(double));
	shooting->estimate_int = hawser__hold(&shooting->hold, size, sizeof(int));
	shooting->schur = hawser__hold(&shooting->hold, S*m*m, sizeof(double));
	shooting->rates = hawser__hold(&shooting->hold, S*m, sizeof(double));
	shooting->node = hawser__hold(&shooting->hold, S*m, sizeof(double));
	shooting->reduced = hawser__hold(&shooting->hold, 3*m*m + 40*m, sizeof(double));
	shooting->floquet_work = hawser__hold(&shooting->hold, hawser__floquet_work(segments, (int)m),
	                                      sizeof(double));
	if (shooting->hold.short_of_memory)
		status = hawser__no_memory(report, "orbit");
	else
		status = hawser__flow_init(&shooting->flow, rom, report);
	if (!status)
		status = hawser__orbit_init(&shooting->base, rom, (int)size, report);
	shooting->b = shooting->A ? shooting->A + S*m*m : NULL;
	if (!status && hawser__orbit_remember(&shooting->base, shooting->A, S*m*(m + 1)))
		status = hawser__no_memory(report, "orbit");
	if (!status)
		status = hawser__shooting_remesh(shooting, steps, report);
	if (status)
		hawser__shooting_release(shooting);
	return status;
}

void hawser__shooting_release(struct hawser__shooting *shooting)
{
	hawser__flow_clear(&shooting->flow);
	hawser__hold_clear(&shooting->hold);
	free(shooting->base.samples);
	hawser__orbit_free(&shooting->base);
	memset(shooting, 0, sizeof *shooting);
}

static void clear(struct hawser__orbit *orbit)
{
	hawser__shooting_release((struct hawser__shooting *)orbit);
	free(orbit);
}

static void metric(struct hawser__orbit *orbit, const double *y)
{
	struct hawser__shooting *shooting = (struct hawser__shooting *)orbit;
	int m = shooting->base.m, S = shooting->segments;
	double sum = 0.0;

	for (int j = 0; j < m; j++) {
		double part = 0.0, mean = 0.0;

		for (int i = 0; orbit->freely && i < S; i++)
			mean += y[i*m + j]/S;
		for (int i = 0; i < S; i++)
			part += (y[i*m + j] - mean)*(y[i*m + j] - mean);
		shooting->scale[j] = sqrt(part/S);
		sum += part;
	}
	/* An orbit at rest (parametric excitation only) has size 0. */
	shooting->base.X = sum > 0.0 ? sqrt(sum/S) : 1.0;
	for (int j = 0; j < m; j++)
		shooting->scale[j] = fmax(shooting->scale[j], HAWSER_SCALE_FLOOR*shooting->base.X);
	shooting->base.W = HAWSER_OMEGA_WIDTH*hawser__orbit_extent(orbit, y);
	for (int i = 0; i < S*m; i++)
		orbit->weight[i] = 1.0/(shooting->scale[i%m]*shooting->scale[i%m]*S*m);
	orbit->weight[S*m] = 1.0/(shooting->base.W*shooting->base.W);
}

/* The comparison formulas of a step estimate its error if the step resolves the orbit. On a mesh
 * this coarse the estimate may be thirty times too small (a soft oscillator with a dozen steps per
 * period). Therefore the same intervals, which are few, are integrated again in steps of half the
 * length. */
static double halved_steps(struct hawser__shooting *shooting, const double *y, double omega)
{
	int m = shooting->base.m, S = shooting->segments;
	double *finer = shooting->finer, sum = 0.0;
	struct hawser__stretch stretch = {.h = M_PI/S/shooting->steps, .steps = 2*shooting->steps,
		.count = S, .apart = 2.0*M_PI/S};

	memcpy(finer, y, (size_t)S*m*sizeof *finer);
	(void)hawser__flow_map(&shooting->flow, finer, NULL, &stretch, omega);
	for (int i = 0; i < S; i++) {
		double gap = 0.0;

		for (int j = i*m; j < (i + 1)*m; j++)
			gap += (finer[j] - shooting->defect[j])*(finer[j] - shooting->defect[j]);
		sum += sqrt(gap);
	}
	return sum;
}

/* The ends of the segments in the model at the parameter p, in end [S m]; returns 1, and they are those
 * of the model at `own`, if there is none at p. */
static int map_at(double *end, struct hawser__shooting *shooting, const double *y, double p, double own,
                  const struct hawser__stretch *stretch)
{
	struct hawser__orbit *orbit = &shooting->base;
	int failed = hawser__orbit_place(orbit, p) || hawser__flow_place(&shooting->flow, orbit->rom);

	if (failed && !hawser__orbit_place(orbit, own))
		(void)hawser__flow_place(&shooting->flow, orbit->rom);
	memcpy(end, y, (size_t)shooting->segments*orbit->m*sizeof *end);
	(void)hawser__flow_map(&shooting->flow, end, NULL, stretch,
	                       hawser__orbit_frequency(orbit, orbit->placed));
	return failed;
}

/* b becomes the derivative by the parameter of the family, from the models on both sides of the present
 * one (one side where the other has none). */
static void differentiate_family(struct hawser__shooting *shooting, const double *y,
                                 const struct hawser__stretch *stretch)
{
	struct hawser__orbit *orbit = &shooting->base;
	double p = y[orbit->size - 1], wide, middle = hawser__orbit_middle(orbit, &wide, y);
	double span = 2.0*wide;

	span -= map_at(shooting->finer, shooting, y, middle - wide, p, stretch) ? wide : 0.0;
	span -= map_at(shooting->b, shooting, y, middle + wide, p, stretch) ? wide : 0.0;
	for (int i = 0; i < orbit->size - 1; i++)
		shooting->b[i] = (shooting->b[i] - shooting->finer[i])/span;
	if (!hawser__orbit_place(orbit, p))
		(void)hawser__flow_place(&shooting->flow, orbit->rom);
}

/* The derivative of the nodes by the phase, of an autonomous model; of y, Omega stays. */
static void shift(struct hawser__orbit *orbit, double *dy, const double *y)
{
	int n = orbit->n, m = orbit->m, nodes = orbit->size - 1;
	double omega = hawser__orbit_omega(orbit, y);

	for (int i = 0; i < nodes; i += m) {
		hawser_rom_acceleration(orbit->rom, dy + i + n, y + i, y + i + n, 0.0, omega);
		for (int j = 0; j < n; j++) {
			dy[i + j] = y[i + n + j]/omega;
			dy[i + n + j] /= omega;
		}
	}
}

static int parts(struct hawser__orbit *orbit, double **defect, double **column)
{
	struct hawser__shooting *shooting = (struct hawser__shooting *)orbit;

	*defect = shooting->defect;
	*column = shooting->b;
	return orbit->size - 1;
}

static double defects(struct hawser__orbit *orbit, const double *y, int derive)
{
	struct hawser__shooting *shooting = (struct hawser__shooting *)orbit;
	int m = shooting->base.m, S = shooting->segments;
	double omega = hawser__orbit_omega(orbit, y), worst = 0.0;
	double *end = shooting->defect;
	struct hawser__stretch stretch = {.h = 2.0*M_PI/S/shooting->steps, .steps = shooting->steps,
		.count = S, .apart = 2.0*M_PI/S};

	if (hawser__orbit_place(orbit, y[orbit->size - 1]) ||
	    hawser__flow_place(&shooting->flow, orbit->rom))
		return NAN;
	memcpy(end, y, (size_t)S*m*sizeof *end);
	if (derive) {
		shooting->omega = omega;
		shooting->flow.drained = 0.0;
		orbit->mesh = hawser__flow_derive(&shooting->flow, end, shooting->A, shooting->b,
		                                  orbit->samples, &stretch, omega);
		orbit->drained = shooting->flow.drained;
	} else {
		orbit->mesh = hawser__flow_map(&shooting->flow, end, orbit->samples, &stretch, omega);
	}
	if (derive && S*shooting->steps <= COARSE)
		orbit->mesh = fmax(orbit->mesh, halved_steps(shooting, y, omega));
	if (derive && orbit->family)
		differentiate_family(shooting, y, &stretch);
	if (derive && orbit->freely) {
		memcpy(shooting->node, y, (size_t)S*m*sizeof *y);
		shift(orbit, shooting->rates, y);
	}
	for (int i = 0; i < S; i++) {
		const double *next = y + ((i + 1)%S)*m;
		double sum = 0.0;

		for (int j = 0; j < m; j++) {
			end[i*m + j] -= next[j];
			sum += end[i*m + j]*end[i*m + j];
		}
		/* keeps a NaN, which fmax would drop */
		if (!(sqrt(sum) <= worst))
			worst = sqrt(sum);
	}
	orbit->cost.stages = shooting->flow.stages;
	orbit->cost.flops = shooting->flow.flops + shooting->factor_flops;
	if (derive)
		shooting->base.cost.flows++;
	else
		shooting->base.cost.maps++;
	return worst/shooting->base.X;
}

static void fill_segment(struct hawser__shooting *shooting, int i)
{
	int m = shooting->base.m, S = shooting->segments, size = shooting->base.size, next = (i + 1)%S;
	double *matrix = shooting->matrix;

	for (int j = 0; j < m; j++) {
		int row = i*m + j;

		for (int k = 0; k < m; k++)
			matrix[(size_t)(i*m + k)*size + row] +=
				shooting->A[(size_t)i*m*m + (size_t)j*m + k]*
				shooting->scale[k]/shooting->scale[j];
		matrix[(size_t)(next*m + j)*size + row] -= 1.0;
		matrix[(size_t)(size - 1)*size + row] =
			shooting->b[i*m + j]*shooting->base.W/shooting->scale[j];
	}
}

static int factor(struct hawser__orbit *orbit, const double *row)
{
	struct hawser__shooting *shooting = (struct hawser__shooting *)orbit;
	int size = shooting->base.size, info;

	memset(shooting->matrix, 0, (size_t)size*size*sizeof *shooting->matrix);
	for (int i = 0; i < shooting->segments; i++)
		fill_segment(shooting, i);
	hawser__shooting_border(shooting);
	for (int i = 0; i < size - 1; i++)
		shooting->matrix[(size_t)i*size + size - 1] =
			row[i]/(shooting->scale[i%shooting->base.m]*(size - 1));
	shooting->matrix[(size_t)size*size - 1] = row[size - 1]/shooting->base.W;
	shooting->norm = LAPACKE_dlange_work(LAPACK_COL_MAJOR, '1', size, size, shooting->matrix,
	                                     size, NULL);
	info = LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, size, size, shooting->matrix, size,
	                           shooting->pivot);
	if (info == 0)
		orbit->det_log = hawser__determinant(&orbit->det_sign, shooting->matrix, shooting->pivot, size);
	shooting->factor_flops += 2.0/3.0*size*size*size;
	return info != 0;
}

/* A defect may be amplified by the norm of the inverse Jacobian. */
static double error(struct hawser__orbit *orbit, double residual)
{
	struct hawser__shooting *shooting = (struct hawser__shooting *)orbit;
	double rcond = 0.0;

	LAPACKE_dgecon_work(LAPACK_COL_MAJOR, '1', orbit->size, shooting->matrix, orbit->size,
	                    shooting->norm, &rcond, shooting->estimate, shooting->estimate_int);
	orbit->round_off = ROUND_OFF/(rcond*shooting->norm);
	return (SAFETY*(orbit->mesh/orbit->X + residual) + ROUND_OFF)/(rcond*shooting->norm);
}

static void solve(struct hawser__orbit *orbit, double *dy, int homogeneous, double last)
{
	struct hawser__shooting *shooting = (struct hawser__shooting *)orbit;
	int size = orbit->size, m = orbit->m;

	for (int i = 0; i < size - 1; i++)
		dy[i] = homogeneous ? 0.0 : -shooting->defect[i]/shooting->scale[i%m];
	dy[size - 1] = last;
	if (!homogeneous)
		hawser__shooting_hold(shooting, dy);
	LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', size, 1, shooting->matrix, size,
	                    shooting->pivot, dy, size);
	for (int i = 0; i < size - 1; i++)
		dy[i] *= shooting->scale[i%m];
	dy[size - 1] *= orbit->W;
}

/* Multiply neighbouring transition matrices, so that `count` factors become (count + 1)/2. */
static int pair_up(struct hawser__shooting *shooting, int count, int m)
{
	int kept = 0;
	size_t block = (size_t)m*m;
	double *A = shooting->schur, *product = shooting->flow.U; /* free between flows */

	for (int i = 0; i < count; i += 2, kept++) {
		if (i + 1 < count)
			cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, m, m, m, 1.0,
			            A + (size_t)(i + 1)*block, m, A + (size_t)i*block, m, 0.0,
			            product, m);
		else
			memcpy(product, A + (size_t)i*block, block*sizeof *product);
		memcpy(A + (size_t)kept*block, product, block*sizeof *product);
	}
	return kept;
}

/* Whether neighbouring factors may be multiplied before the periodic QR algorithm, whose cost is
 * proportional to their number. The round-off of the product is |A_i| |A_i+1| times 1e-16, which
 * must be small compared with the smallest multiplier. */
static int harmless(const struct hawser__shooting *shooting)
{
	const struct hawser_rom *rom = shooting->base.rom;
	int n = rom->n, m = 2*n, S = shooting->segments;
	double worst = 0.0, damping = 0.0, omega = shooting->omega;

	for (int j = 0; j < n; j++)
		damping = fmax(damping, rom->D[j*n + j]);
	for (int i = 0; i + 1 < S; i += 2)
		worst = fmax(worst, cblas_dnrm2(m*m, shooting->A + (size_t)i*m*m, 1)*
		                    cblas_dnrm2(m*m, shooting->A + (size_t)(i + 1)*m*m, 1));
	return S > 1 && worst*exp(damping*4.0*M_PI/(S*omega)) < LARGEST_PRODUCT;
}

/* The periodic QR iteration of SLICOT sometimes fails to converge for large orders. It is then
 * repeated with fewer factors, products of neighbours. The smallest multipliers lose digits by
 * this, which the Liouville gap shows. */
static enum hawser_status product_multipliers(struct hawser__orbit *orbit,
                                              struct hawser_report *report)
{
	struct hawser__shooting *shooting = (struct hawser__shooting *)orbit;
	int order = orbit->m;
	enum hawser_status status;

	if (!orbit->freely &&
	    hawser__floquet_directly(orbit->log_modulus, orbit->argument, orbit->kind, shooting->reduced,
	                             shooting->A, shooting->segments, orbit->rom, shooting->omega)) {
		hawser__orbit_idle(orbit, order);
		return HAWSER_OK;
	}
	for (int tries = harmless(shooting);; tries++) {
		int count = shooting->segments;

		if (orbit->freely)
			order = hawser__shooting_reduce(shooting);
		else
			memcpy(shooting->schur, shooting->A, (size_t)count*order*order*sizeof(double));
		for (int i = 0; i < tries; i++)
			count = pair_up(shooting, count, order);
		status = hawser__floquet(orbit->log_modulus, orbit->argument, shooting->schur, count, order,
		                         shooting->floquet_work, report);
		hawser__orbit_idle(orbit, order);
		if (status != HAWSER_ERR_CONVERGENCE || count == 1)
			return status;
	}
}

/* The number of steps is chosen by the error of the orbit; the Liouville gap checks the error of
 * the variational equations. At rest the orbit gives no criterion for the steps. */
static enum hawser_status multipliers(struct hawser__orbit *orbit, struct hawser_report *report)
{
	enum hawser_status status = product_multipliers(orbit, report);
	double omega = ((struct hawser__shooting *)orbit)->omega;

	orbit->product_error = orbit->product_round_off = ROUND_OFF*orbit->m;
	if (!status)
		orbit->product_error += fmin(LARGEST_GAP, orbit->mesh > 0.0
		                             ? hawser__orbit_liouville(orbit, omega) : LARGEST_GAP);
	return status;
}

static void state(const struct hawser__orbit *orbit, double *x, const double *y)
{
	memcpy(x, y, (size_t)orbit->m*sizeof *x);
}

static const struct hawser__orbit_ops ops = {
	metric, defects, factor, solve, error, multipliers, hawser__shooting_refine,
	hawser__shooting_relax, hawser__shooting_enrich, hawser__shooting_sharpen,
	hawser__shooting_add_wave, hawser__shooting_from_state, state, clear,
	hawser__orbit_keep, hawser__orbit_guess, parts, shift,
};

static enum hawser_status open_method(struct hawser__orbit **orbit, const struct hawser_rom *rom,
                                      const struct hawser_frf_options *options,
                                      struct hawser_report *report)
{
	struct hawser__shooting *shooting = malloc(sizeof *shooting);
	int segments = options->segments ? options->segments
	               : hawser__shooting_segments(rom, fmin(options->from, options->to));
	int steps = hawser__shooting_steps(rom, options->begin, segments);
	enum hawser_status status;

	*orbit = NULL;
	if (!shooting)
		return hawser__no_memory(report, "frf");
	status = hawser__shooting_init(shooting, rom, segments, steps, report);
	if (status)
		free(shooting);
	else
		*orbit = &shooting->base;
	return status;
}

const struct hawser__orbit_method hawser__shooting_method = {
	{"shooting", "multiple shooting with the exact derivatives of the flow",
	 "Bock 1981; Ascher, Mattheij and Russell 1995, ch. 4", 0},
	open_method, NULL,
};
