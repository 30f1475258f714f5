/* response/shooting.c - see shooting.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/floquet.h"
#include "response/shooting.h"

/* Corrector: at most this many steps, and a contraction worse than this is given up: the caller
 * halves the arc step, which costs less than a slow iteration. */
#define MAX_ITERATIONS 12
#define WORST_CONTRACTION 0.5
/* A chord step is trusted below this; above it the derivatives are computed anew. */
#define GOOD_CONTRACTION 0.1

/* The metric's width in Omega, as a fraction of Omega. */
#define OMEGA_WIDTH 0.05
/* The least size a component has in the metric, as a fraction of the orbit's. */
#define SCALE_FLOOR 0.003

enum hawser_status hawser__shooting_remesh(struct hawser__shooting *shooting, int steps,
                                           struct hawser_report *report)
{
	int rows = shooting->segments*steps;

	shooting->steps = steps;
	if (rows > shooting->sample_capacity) {
		double *larger = realloc(shooting->samples,
		                         2*(size_t)rows*shooting->n*sizeof *larger);

		if (!larger)
			return hawser__no_memory(report, "orbit");
		shooting->samples = larger;
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
	if ((status = hawser__flow_init(&shooting->flow, rom, report)))
		return status;
	shooting->n = rom->n;
	shooting->m = (int)m;
	shooting->segments = segments;
	shooting->size = (int)size;
	shooting->X = shooting->W = 1.0;
	shooting->scale = calloc(m, sizeof(double));
	shooting->defect = calloc(S*m, sizeof(double));
	shooting->A = calloc(S*m*m, sizeof(double));
	shooting->b = calloc(S*m, sizeof(double));
	shooting->matrix = calloc(size*size, sizeof(double));
	shooting->pivot = calloc(size, sizeof(int));
	shooting->rhs = calloc(size, sizeof(double));
	shooting->copy = calloc(size, sizeof(double));
	shooting->estimate = calloc(4*size, sizeof(double));
	shooting->estimate_int = calloc(size, sizeof(int));
	shooting->schur = calloc(S*m*m, sizeof(double));
	shooting->floquet_work = calloc(hawser__floquet_work(segments, (int)m), sizeof(double));
	shooting->log_modulus = calloc(m, sizeof(double));
	shooting->argument = calloc(m, sizeof(double));
	if (!shooting->scale || !shooting->defect || !shooting->A || !shooting->b || !shooting->matrix ||
	    !shooting->pivot || !shooting->rhs || !shooting->copy || !shooting->schur ||
	    !shooting->estimate || !shooting->estimate_int || !shooting->floquet_work ||
	    !shooting->log_modulus || !shooting->argument)
		status = hawser__no_memory(report, "orbit");
	if (!status)
		status = hawser__shooting_remesh(shooting, steps, report);
	if (status)
		hawser__shooting_clear(shooting);
	return status;
}

void hawser__shooting_clear(struct hawser__shooting *shooting)
{
	hawser__flow_clear(&shooting->flow);
	free(shooting->scale);
	free(shooting->defect);
	free(shooting->A);
	free(shooting->b);
	free(shooting->samples);
	free(shooting->matrix);
	free(shooting->pivot);
	free(shooting->rhs);
	free(shooting->copy);
	free(shooting->estimate);
	free(shooting->estimate_int);
	free(shooting->schur);
	free(shooting->floquet_work);
	free(shooting->log_modulus);
	free(shooting->argument);
	memset(shooting, 0, sizeof *shooting);
}

void hawser__shooting_metric(struct hawser__shooting *shooting, const double *y)
{
	int m = shooting->m, S = shooting->segments;
	double sum = 0.0;

	for (int j = 0; j < m; j++) {
		double part = 0.0;

		for (int i = 0; i < S; i++)
			part += y[i*m + j]*y[i*m + j];
		shooting->scale[j] = sqrt(part/S);
		sum += part;
	}
	/* An orbit at rest (parametric excitation only) has no size of its own. */
	shooting->X = sum > 0.0 ? sqrt(sum/S) : 1.0;
	for (int j = 0; j < m; j++)
		shooting->scale[j] = fmax(shooting->scale[j], SCALE_FLOOR*shooting->X);
	shooting->W = OMEGA_WIDTH*fabs(y[shooting->size - 1]);
}

double hawser__shooting_dot(const struct hawser__shooting *shooting, const double *a,
                            const double *b)
{
	int m = shooting->m, last = shooting->size - 1;
	double sum = 0.0;

	for (int i = 0; i < shooting->segments; i++)
		for (int j = 0; j < m; j++)
			sum += a[i*m + j]*b[i*m + j]/(shooting->scale[j]*shooting->scale[j]);
	return sum/(shooting->segments*m) + a[last]*b[last]/(shooting->W*shooting->W);
}

double hawser__shooting_distance2(const struct hawser__shooting *shooting, const double *a,
                                  const double *b)
{
	double *d = shooting->copy;

	for (int i = 0; i < shooting->size; i++)
		d[i] = b[i] - a[i];
	return hawser__shooting_dot(shooting, d, d);
}

double hawser__shooting_defects(struct hawser__shooting *shooting, const double *y, int derive)
{
	int m = shooting->m, S = shooting->segments;
	double omega = y[shooting->size - 1], worst = 0.0;
	double h = 2.0*M_PI/S/shooting->steps;

	shooting->mesh = 0.0;
	for (int i = 0; i < S; i++) {
		struct hawser__stretch stretch = {i*(2.0*M_PI/S), h, shooting->steps};
		double *x = shooting->defect + i*m, sum = 0.0;
		double *samples = shooting->samples + (size_t)i*shooting->steps*shooting->n;
		const double *next = y + ((i + 1)%S)*m;

		memcpy(x, y + i*m, (size_t)m*sizeof *x);
		shooting->mesh += derive
			? hawser__flow_derive(&shooting->flow, x, shooting->A + (size_t)i*m*m,
		                              shooting->b + i*m, samples, &stretch, omega)
			: hawser__flow_map(&shooting->flow, x, samples, &stretch, omega);
		for (int j = 0; j < m; j++) {
			x[j] -= next[j];
			sum += x[j]*x[j];
		}
		/* keeps a NaN, which fmax would lose */
		if (!(sqrt(sum) <= worst))
			worst = sqrt(sum);
	}
	shooting->cost.stages = shooting->flow.stages;
	if (derive)
		shooting->cost.flows++;
	else
		shooting->cost.maps++;
	return worst/shooting->X;
}

static void fill_segment(struct hawser__shooting *shooting, int i)
{
	int m = shooting->m, S = shooting->segments, size = shooting->size, next = (i + 1)%S;
	double *matrix = shooting->matrix;

	for (int j = 0; j < m; j++) {
		int row = i*m + j;

		for (int k = 0; k < m; k++)
			matrix[(size_t)(i*m + k)*size + row] +=
				shooting->A[(size_t)i*m*m + (size_t)j*m + k]*
				shooting->scale[k]/shooting->scale[j];
		matrix[(size_t)(next*m + j)*size + row] -= 1.0;
		matrix[(size_t)(size - 1)*size + row] =
			shooting->b[i*m + j]*shooting->W/shooting->scale[j];
	}
}

static void read_determinant(struct hawser__shooting *shooting)
{
	int size = shooting->size;

	shooting->det_sign = 1.0;
	shooting->det_log = 0.0;
	for (int i = 0; i < size; i++) {
		double d = shooting->matrix[(size_t)i*size + i];

		shooting->det_log += log(fabs(d));
		if ((d < 0.0) != (shooting->pivot[i] != i + 1))
			shooting->det_sign = -shooting->det_sign;
	}
}

int hawser__shooting_factor(struct hawser__shooting *shooting, const double *row)
{
	int size = shooting->size, info;

	memset(shooting->matrix, 0, (size_t)size*size*sizeof *shooting->matrix);
	for (int i = 0; i < shooting->segments; i++)
		fill_segment(shooting, i);
	for (int i = 0; i < size - 1; i++)
		shooting->matrix[(size_t)i*size + size - 1] =
			row[i]/(shooting->scale[i%shooting->m]*(size - 1));
	shooting->matrix[(size_t)size*size - 1] = row[size - 1]/shooting->W;
	shooting->norm = LAPACKE_dlange_work(LAPACK_COL_MAJOR, '1', size, size, shooting->matrix,
	                                     size, NULL);
	info = LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, size, size, shooting->matrix, size,
	                           shooting->pivot);
	if (info == 0)
		read_determinant(shooting);
	return info != 0;
}

double hawser__shooting_amplification(struct hawser__shooting *shooting)
{
	double rcond = 0.0;

	LAPACKE_dgecon_work(LAPACK_COL_MAJOR, '1', shooting->size, shooting->matrix, shooting->size,
	                    shooting->norm, &rcond, shooting->estimate, shooting->estimate_int);
	return 1.0/(rcond*shooting->norm);
}

void hawser__shooting_solve(struct hawser__shooting *shooting, double *dy, const double *defect,
                            double last)
{
	int size = shooting->size;

	for (int i = 0; i < size - 1; i++)
		dy[i] = defect ? -defect[i]/shooting->scale[i%shooting->m] : 0.0;
	dy[size - 1] = last;
	LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', size, 1, shooting->matrix, size,
	                    shooting->pivot, dy, size);
	for (int i = 0; i < size - 1; i++)
		dy[i] *= shooting->scale[i%shooting->m];
	dy[size - 1] *= shooting->W;
	shooting->cost.solves++;
}

/* One step of the corrector from the current defects; returns its length in the metric. */
static double correct_once(struct hawser__shooting *shooting, double *y)
{
	double *dy = shooting->rhs;

	hawser__shooting_solve(shooting, dy, shooting->defect, 0.0);
	for (int i = 0; i < shooting->size; i++)
		y[i] += dy[i];
	return sqrt(hawser__shooting_dot(shooting, dy, dy));
}

int hawser__shooting_correct(struct hawser__shooting *shooting, double *y,
                             struct hawser__correction *correction, const double *row,
                             double tolerance)
{
	double previous = 0.0;

	*correction = (struct hawser__correction){0};
	correction->residual = hawser__shooting_defects(shooting, y, 1);
	if (!isfinite(correction->residual) || hawser__shooting_factor(shooting, row))
		return 1;
	for (int i = 1; i <= MAX_ITERATIONS; i++) {
		double length = correct_once(shooting, y);
		double contraction = previous > 0.0 ? length/previous : 0.0;
		int done = length <= 0.1*tolerance || contraction*length <= 0.1*tolerance*(i > 1);
		int derive = done || contraction > GOOD_CONTRACTION;

		correction->iterations = i;
		if (i == 1)
			correction->first = length;
		if (i == 2)
			correction->contraction = contraction;
		if (!isfinite(length) || y[shooting->size - 1] <= 0.0 ||
		    (contraction > WORST_CONTRACTION && length > tolerance))
			return 1;
		/* The chord's derivatives are those of the prediction; the accepted point gets its
		 * own, for its tangent and multipliers. */
		correction->residual = hawser__shooting_defects(shooting, y, derive);
		if (!isfinite(correction->residual) ||
		    (derive && hawser__shooting_factor(shooting, row)))
			return 1;
		if (done && correction->residual <= tolerance)
			return 0;
		previous = length;
	}
	return 1;
}

void hawser__shooting_tangent(struct hawser__shooting *shooting, double *t)
{
	double length;

	hawser__shooting_solve(shooting, t, NULL, 1.0);
	length = sqrt(hawser__shooting_dot(shooting, t, t));
	for (int i = 0; i < shooting->size; i++)
		t[i] /= length;
}

/* Product of neighbouring transition matrices, so that `count` factors become (count + 1)/2. */
static int pair_up(struct hawser__shooting *shooting, int count)
{
	int m = shooting->m, kept = 0;
	size_t block = (size_t)m*m;
	double *A = shooting->schur, *product = shooting->flow.X_slope; /* free between flows */

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

/* The periodic QR iteration of SLICOT now and then fails to converge for large orders. Fewer
 * factors help: neighbours are multiplied and it is tried again. That costs the smallest
 * multipliers digits, which the Liouville gap shows. */
enum hawser_status hawser__shooting_multipliers(struct hawser__shooting *shooting,
                                                struct hawser_report *report)
{
	size_t block = (size_t)shooting->m*shooting->m;
	enum hawser_status status;

	for (int tries = 0;; tries++) {
		int count = shooting->segments;

		memcpy(shooting->schur, shooting->A, (size_t)count*block*sizeof(double));
		for (int i = 0; i < tries; i++)
			count = pair_up(shooting, count);
		status = hawser__floquet(shooting->log_modulus, shooting->argument,
		                         shooting->schur, count, shooting->m,
		                         shooting->floquet_work, report);
		if (status != HAWSER_ERR_CONVERGENCE || count == 1)
			return status;
	}
}
