/* response/cycle/equilibrium.c - equilibria over a parameter, as a method of method.h.
 *
 *    y       unknowns [n + 1]: u, then the parameter
 *    r       defects [n]: accelerations at rest; of equations u' = g of first order, g
 *    x       eigenvalue of the motion about the equilibrium
 *    s       rate of the map mu = (s + x)/(s - x), which makes "multipliers" of eigenvalues
 *            (cycle.h): the geometric mean of the moduli of the first equilibrium's
 *
 * The eigenvalues about a model with n coordinates are 2n. Those of equations of first order are n;
 * the others would be those of the relaxation by which the file's equations are made to second
 * order, and are left out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/determinant.h"
#include "core/hold.h"
#include "core/report.h"
#include "response/cycle/cycle.h"
#include "response/cycle/hopf.h"
#include "response/floquet/floquet.h"

#define SMALLEST 1e-6 /* size of coordinates below which all are the same; chosen */
#define REMEMBERED 0.05 /* of the largest size so far, to which the metric does not shrink; chosen */
#define SLOW 1e-6 /* of the largest modulus: slower eigenvalues don't count in s; chosen */
#define TRIES 200 /* steps to the first equilibrium, */
#define FIRST_DAMP 1e-6 /* their regularisation, relative, */
#define ARRIVED 1e-9 /* and the last one, relative; chosen */
#define BLOCK 34 /* dgeev's workspace divided by the order */
enum { ROWS = 4 }; /* samples, all the same */

struct equilibrium {
	struct hawser__orbit base;
	double rate;                      /* s; 0: not known yet */
	double largest;                   /* size so far */
	double *acceleration, *rest;      /* [n]; zeros [n] */
	double *by_u, *by_v, *by_p;       /* [n][n], [n][n], [n] */
	double *scale, *row_scale;        /* [n] */
	double *matrix, *A, *work;        /* [n + 1][n + 1], [2n][2n], [BLOCK 2n] */
	double *re, *im;                  /* [2n] */
	double *estimate;                 /* [4 (n + 1)] */
	int *pivot, *estimate_int;        /* [n + 1] */
	double norm;
	struct hawser__hold hold;
};

/* The accelerations, or g; by_u and by_v may both be NULL. */
static void forces(double *acceleration, double *by_u, double *by_v, double *spare,
                   const struct hawser_rom *rom, const double *u, const double *v)
{
	const struct hawser_rom *of = rom->first ? rom->first : rom;

	if (by_u)
		hawser_rom_acceleration_jacobian(of, acceleration, by_u, by_v, spare, u, v, 0.0, 1.0);
	else
		hawser_rom_acceleration(of, acceleration, u, v, 0.0, 1.0);
}

int hawser__autonomous_matrix(double *A, double *by_u, double *by_v, double *acceleration,
                              const struct hawser_rom *rom, const double *u, const double *v)
{
	int n = rom->n, m = rom->first ? n : 2*n;

	forces(acceleration, by_u, by_v, acceleration + n, rom, u, v);
	memset(A, 0, (size_t)m*m*sizeof *A);
	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++) {
			int row = rom->first ? j : n + j;

			A[(size_t)k*m + row] = by_u[j*n + k];
			if (!rom->first)
				A[(size_t)(n + k)*m + row] = by_v[j*n + k];
		}
	for (int j = 0; !rom->first && j < n; j++)
		A[(size_t)(n + j)*m + j] = 1.0;
	return m;
}

static void metric(struct hawser__orbit *orbit, const double *y)
{
	struct equilibrium *of = (struct equilibrium *)orbit;
	int n = orbit->n;
	double sum = 0.0;

	for (int j = 0; j < n; j++)
		sum += y[j]*y[j];
	of->largest = fmax(of->largest, sqrt(sum));
	orbit->X = fmax(sqrt(sum), REMEMBERED*of->largest);
	if (orbit->X < SMALLEST)
		orbit->X = 1.0;
	for (int j = 0; j < n; j++) {
		of->scale[j] = fmax(fabs(y[j]), HAWSER_SCALE_FLOOR*orbit->X);
		orbit->weight[j] = 1.0/(of->scale[j]*of->scale[j]*n);
	}
	orbit->W = HAWSER_OMEGA_WIDTH*hawser__orbit_extent(orbit, y);
	orbit->weight[n] = 1.0/(orbit->W*orbit->W);
}

/* The derivative by the parameter, from the models on both sides of the present one, or on one. */
static int by_parameter(struct equilibrium *of, const double *y)
{
	struct hawser__orbit *orbit = &of->base;
	int n = orbit->n;
	double p = y[n], span = 0.0, wide, middle = hawser__orbit_middle(orbit, &wide, y);

	memset(of->by_p, 0, (size_t)n*sizeof(double));
	for (int side = -1; orbit->family && side <= 1; side += 2) {
		int away = !hawser__orbit_place(orbit, middle + side*wide);

		if (!away && hawser__orbit_place(orbit, p))
			return 1;
		forces(of->acceleration, NULL, NULL, NULL, orbit->rom, y, of->rest);
		span += away ? wide : 0.0;
		for (int j = 0; j < n; j++)
			of->by_p[j] += side*of->acceleration[j];
	}
	for (int j = 0; span > 0.0 && j < n; j++)
		of->by_p[j] /= span;
	return orbit->family && hawser__orbit_place(orbit, p);
}

static double defects(struct hawser__orbit *orbit, const double *y, int derive)
{
	struct equilibrium *of = (struct equilibrium *)orbit;
	int n = orbit->n;
	double worst = 0.0;

	if (derive ? by_parameter(of, y) : hawser__orbit_place(orbit, y[n]))
		return NAN;
	forces(of->acceleration, of->by_u, of->by_v, of->estimate, orbit->rom, y, of->rest);
	for (int j = 0; j < n; j++) {
		double stiff = 0.0, part;

		for (int k = 0; k < n; k++)
			stiff += fabs(of->by_u[j*n + k]);
		of->row_scale[j] = (stiff > 0.0 ? stiff : 1.0)*orbit->X;
		part = fabs(of->acceleration[j])/of->row_scale[j];
		/* keeps a NaN, which fmax would drop */
		if (!(part <= worst))
			worst = part;
	}
	for (int i = 0; i < ROWS; i++)
		memcpy(orbit->samples + (size_t)i*n, y, (size_t)n*sizeof *y);
	orbit->cost.stages++;
	if (derive)
		orbit->cost.flows++;
	else
		orbit->cost.maps++;
	return worst;
}

static int factor(struct hawser__orbit *orbit, const double *row)
{
	struct equilibrium *of = (struct equilibrium *)orbit;
	int n = orbit->n, size = n + 1, info;

	for (int j = 0; j < n; j++) {
		for (int k = 0; k < n; k++)
			of->matrix[(size_t)k*size + j] = of->by_u[j*n + k]*of->scale[k]/of->row_scale[j];
		of->matrix[(size_t)n*size + j] = of->by_p[j]*orbit->W/of->row_scale[j];
		of->matrix[(size_t)j*size + n] = orbit->weight[j]*row[j]*of->scale[j];
	}
	of->matrix[(size_t)n*size + n] = row[n]/orbit->W;
	of->norm = LAPACKE_dlange_work(LAPACK_COL_MAJOR, '1', size, size, of->matrix, size, NULL);
	info = LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, size, size, of->matrix, size, of->pivot);
	orbit->det_log = hawser__determinant(&orbit->det_sign, of->matrix, of->pivot, info ? 0 : size);
	return info != 0;
}

static void solve(struct hawser__orbit *orbit, double *dy, int homogeneous, double last)
{
	struct equilibrium *of = (struct equilibrium *)orbit;
	int n = orbit->n;

	for (int j = 0; j < n; j++)
		dy[j] = homogeneous ? 0.0 : -of->acceleration[j]/of->row_scale[j];
	dy[n] = last;
	LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', n + 1, 1, of->matrix, n + 1, of->pivot, dy, n + 1);
	for (int j = 0; j < n; j++)
		dy[j] *= of->scale[j];
	dy[n] *= orbit->W;
}

static double error(struct hawser__orbit *orbit, double residual)
{
	struct equilibrium *of = (struct equilibrium *)orbit;
	int size = orbit->n + 1;
	double rcond = 0.0;

	LAPACKE_dgecon_work(LAPACK_COL_MAJOR, '1', size, of->matrix, size, of->norm, &rcond, of->estimate,
	                    of->estimate_int);
	orbit->round_off = DBL_EPSILON/(rcond*of->norm);
	return (residual + DBL_EPSILON)/(rcond*of->norm);
}

/* --- eigenvalues --- */

static void set_rate(struct equilibrium *of, int m)
{
	double most = 0.0, sum = 0.0;
	int count = 0;

	for (int i = 0; i < m; i++)
		most = fmax(most, hypot(of->re[i], of->im[i]));
	for (int i = 0; i < m; i++)
		if (hypot(of->re[i], of->im[i]) > SLOW*most) {
			sum += log(hypot(of->re[i], of->im[i]));
			count++;
		}
	of->rate = count ? exp(sum/count) : 1.0;
}

/* mu = (s + x)/(s - x), without cancellation near the unit circle. */
static void set_multiplier(struct hawser__orbit *orbit, int i, double s, double re, double im)
{
	double below = (s - re)*(s - re) + im*im;

	orbit->log_modulus[i] = below > 0.0 ? 0.5*log1p(4.0*s*re/below) : HAWSER__MOST_GROWTH;
	if (!(orbit->log_modulus[i] >= -HAWSER__MOST_GROWTH))
		orbit->log_modulus[i] = -HAWSER__MOST_GROWTH;
	orbit->argument[i] = atan2(2.0*s*im, s*s - re*re - im*im);
}

void hawser__equilibrium_value(double *growth, double *turn, const struct hawser__orbit *orbit,
                               double log_modulus, double argument)
{
	double s = ((const struct equilibrium *)orbit)->rate, below = cosh(log_modulus) + cos(argument);

	*growth = s*sinh(log_modulus)/below;
	*turn = s*sin(argument)/below;
}

static enum hawser_status multipliers(struct hawser__orbit *orbit, struct hawser_report *report)
{
	struct equilibrium *of = (struct equilibrium *)orbit;
	double trace = 0.0, norm, unused;
	int m = hawser__autonomous_matrix(of->A, of->by_u, of->by_v, of->estimate, orbit->rom,
	                                  orbit->samples, of->rest), info;

	for (int i = 0; i < m; i++)
		trace += of->A[(size_t)i*m + i];
	norm = LAPACKE_dlange_work(LAPACK_COL_MAJOR, 'F', m, m, of->A, m, NULL);
	info = LAPACKE_dgeev_work(LAPACK_COL_MAJOR, 'N', 'N', m, of->A, m, of->re, of->im, &unused, 1,
	                          &unused, 1, of->work, BLOCK*m);
	if (info)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "frf",
		                    "the eigenvalues of the equilibrium at %s were not found",
		                    hawser__orbit_where(orbit, orbit->placed).text);
	if (of->rate == 0.0)
		set_rate(of, m);
	for (int i = 0; i < m; i++)
		set_multiplier(orbit, i, of->rate, of->re[i], of->im[i]);
	hawser__orbit_idle(orbit, m);
	hawser__floquet_sort(orbit->log_modulus, orbit->argument, NULL, m);
	for (int i = 0; i < m; i++)
		trace -= of->re[i];
	orbit->drained = fabs(trace)/of->rate;
	orbit->product_error = orbit->product_round_off = DBL_EPSILON*m*fmax(1.0, norm/of->rate);
	return HAWSER_OK;
}

/* --- the first one --- */

/* Newton's method from u [n], with steps regularised as Levenberg and Marquardt do it: *damp is the
 * part of the identity that is added to J'J. memory [3 n n + 4 n]. Returns 1 where it arrives. */
static int approach(double *u, double *memory, int *pivot, const struct hawser_rom *rom)
{
	int n = rom->n;
	double *J = memory, *other = J + n*n, *matrix = other + n*n, *f = matrix + n*n, *step = f + 2*n;
	double *rest = step + n, damp = FIRST_DAMP, size;

	memset(rest, 0, (size_t)n*sizeof *rest);
	forces(f, J, other, f + n, rom, u, rest);
	size = cblas_dnrm2(n, f, 1);
	for (int i = 0; i < TRIES && isfinite(size); i++) {
		double stiff = pow(cblas_dnrm2(n*n, J, 1), 2), now;

		memset(matrix, 0, (size_t)n*n*sizeof *matrix);
		for (int j = 0; j < n; j++)
			matrix[j*n + j] = damp*(stiff > 0.0 ? stiff : 1.0);
		cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, n, n, n, 1.0, J, n, J, n, 1.0, matrix, n);
		cblas_dgemv(CblasRowMajor, CblasTrans, n, n, 1.0, J, n, f, 1, 0.0, step, 1);
		if (LAPACKE_dgesv_work(LAPACK_ROW_MAJOR, n, 1, matrix, n, pivot, step, 1))
			return 0;
		cblas_daxpy(n, -1.0, step, 1, u, 1);
		forces(f, J, other, f + n, rom, u, rest);
		now = cblas_dnrm2(n, f, 1);
		if (now <= size && cblas_dnrm2(n, step, 1) <= ARRIVED*fmax(cblas_dnrm2(n, u, 1), SMALLEST))
			return 1;
		if (!(now < size)) { /* back, and a shorter step */
			cblas_daxpy(n, 1.0, step, 1, u, 1);
			forces(f, J, other, f + n, rom, u, rest);
		}
		damp = now < size ? 0.1*damp : fmax(10.0*damp, FIRST_DAMP);
		size = fmin(now, size);
	}
	return 0;
}

enum hawser_status hawser__equilibrium_find(double *u, const struct hawser_rom *rom, int far,
                                            struct hawser_report *report)
{
	static const double size[] = {0.0, 1.0, 0.1, 10.0, 0.01, 100.0};
	size_t n = (size_t)rom->n;
	double *memory = malloc((3*n*n + 4*n)*sizeof *memory);
	int *pivot = malloc(n*sizeof *pivot), found = 0;

	for (int i = 0; memory && pivot && !found && i < (far ? 6 : 1); i++) {
		for (int j = 0; far && j < rom->n; j++)
			u[j] = size[i]*cos(2.385*j);
		found = approach(u, memory, pivot, rom);
	}
	free(pivot);
	free(memory);
	if (!memory || !pivot)
		return hawser__no_memory(report, "frf");
	return found ? HAWSER_OK
	       : hawser__fail(report, HAWSER_ERR_CONVERGENCE, "frf",
	                      "no equilibrium was found: give one that is near with --start");
}

/* --- there is no discretisation --- */

static enum hawser_status refine(struct hawser__orbit *orbit, int *again, double tolerance,
                                 double omega, struct hawser_report *report)
{
	(void)orbit;
	(void)tolerance;
	(void)omega;
	(void)report;
	*again = 0;
	return HAWSER_OK;
}

static enum hawser_status relax(struct hawser__orbit *orbit, double tolerance,
                                struct hawser_report *report)
{
	(void)orbit;
	(void)tolerance;
	(void)report;
	return HAWSER_OK;
}

static enum hawser_status enrich(struct hawser__orbit *orbit, int most, struct hawser_report *report)
{
	(void)orbit;
	(void)report;
	return most ? HAWSER_OK : HAWSER_ERR_CONVERGENCE;
}

static enum hawser_status sharpen(struct hawser__orbit *orbit, int on, struct hawser_report *report)
{
	(void)orbit;
	(void)on;
	(void)report;
	return HAWSER_OK;
}

static void add_wave(struct hawser__orbit *orbit, double *y, const double *pq, int k, double omega)
{
	(void)omega;
	for (int j = 0; k == 0 && j < orbit->n; j++)
		y[j] += pq[j];
}

static enum hawser_status from_state(struct hawser__orbit *orbit, double *y, const double *x,
                                     double omega, struct hawser_report *report)
{
	(void)omega;
	(void)report;
	memcpy(y, x, (size_t)orbit->n*sizeof *y);
	return HAWSER_OK;
}

static void state(const struct hawser__orbit *orbit, double *x, const double *y)
{
	memset(x, 0, (size_t)orbit->m*sizeof *x);
	memcpy(x, y, (size_t)orbit->n*sizeof *x);
}

static void clear(struct hawser__orbit *orbit)
{
	struct equilibrium *of = (struct equilibrium *)orbit;

	hawser__hold_clear(&of->hold);
	hawser__orbit_free(orbit);
	free(of);
}

static const struct hawser__orbit_ops ops = {
	.metric = metric, .defects = defects, .factor = factor, .solve = solve, .error = error,
	.multipliers = multipliers, .refine = refine, .relax = relax, .enrich = enrich, .sharpen = sharpen,
	.add_wave = add_wave, .from_state = from_state, .state = state, .clear = clear
};

enum hawser_status hawser__equilibrium_open(struct hawser__orbit **orbit,
                                            const struct hawser_rom *rom,
                                            struct hawser_report *report)
{
	size_t n = (size_t)rom->n, size = n + 1;
	struct equilibrium *of = calloc(1, sizeof *of);
	enum hawser_status status;

	*orbit = NULL;
	if (!of)
		return hawser__no_memory(report, "frf");
	of->base.ops = &ops;
	of->base.own = HAWSER__RESTS;
	status = hawser__orbit_init(&of->base, rom, (int)size, report);
	of->acceleration = hawser__hold(&of->hold, n, sizeof(double));
	of->rest = hawser__hold(&of->hold, n, sizeof(double));
	of->by_u = hawser__hold(&of->hold, n*n, sizeof(double));
	of->by_v = hawser__hold(&of->hold, n*n, sizeof(double));
	of->by_p = hawser__hold(&of->hold, n, sizeof(double));
	of->scale = hawser__hold(&of->hold, n, sizeof(double));
	of->row_scale = hawser__hold(&of->hold, n, sizeof(double));
	of->matrix = hawser__hold(&of->hold, size*size, sizeof(double));
	of->A = hawser__hold(&of->hold, 4*n*n, sizeof(double));
	of->work = hawser__hold(&of->hold, BLOCK*2*n, sizeof(double));
	of->re = hawser__hold(&of->hold, 2*n, sizeof(double));
	of->im = hawser__hold(&of->hold, 2*n, sizeof(double));
	of->estimate = hawser__hold(&of->hold, 4*size, sizeof(double));
	of->pivot = hawser__hold(&of->hold, size, sizeof(int));
	of->estimate_int = hawser__hold(&of->hold, size, sizeof(int));
	of->base.samples = hawser__hold(&of->hold, ROWS*n, sizeof(double));
	of->base.rows = ROWS;
	of->base.resolution = 1;
	if (!status && of->hold.short_of_memory)
		status = hawser__no_memory(report, "frf");
	if (!status) {
		*orbit = &of->base;
		return HAWSER_OK;
	}
	clear(&of->base);
	return status;
}
