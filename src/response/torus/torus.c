/* response/torus/torus.c - see torus.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/orbit/method.h"
#include "response/orbit/shooting.h"
#include "response/torus/torus.h"

#define WHERE "torus"
#define MOST_ITERATIONS 12 /* Newton needs four from a good guess; chosen */
#define MESH 1e-13         /* estimated error of a period, relative; chosen */
#define MOST_STEPS 4000    /* chosen */
#define FARTHEST 1.0 /* longest step of Newton's method in the metric of a continuation; chosen */
#define SMALL 1e-11        /* residual that counts as solved: round-off of the map; chosen */

void hawser__torus_points(struct hawser__torus *torus, int N)
{
	torus->points = N;
	torus->size = N*torus->m + 2;
}

enum hawser_status hawser__torus_open(struct hawser__torus *torus, const struct hawser_rom *rom,
                                      int points, double omega, struct hawser_report *report)
{
	return hawser__torus_room(torus, rom, points, points, omega, report);
}

enum hawser_status hawser__torus_room(struct hawser__torus *torus, const struct hawser_rom *rom,
                                      int points, int most, double omega,
                                      struct hawser_report *report)
{
	size_t m = 2*(size_t)rom->n, N = (size_t)most, size = N*m + 2;

	memset(torus, 0, sizeof *torus);
	torus->m = (int)m;
	torus->most = most;
	torus->mesh = MESH;
	hawser__torus_points(torus, points);
	torus->steps = 2*hawser__shooting_steps(rom, omega, 1);
	torus->x = calloc(N*m*(4 + m) + size*size + 4*size + N, sizeof *torus->x);
	torus->pivot = calloc(size, sizeof *torus->pivot);
	if (!torus->x || !torus->pivot)
		return hawser__no_memory(report, WHERE);
	torus->image = torus->x + N*m;
	torus->A = torus->image + N*m;
	torus->b = torus->A + N*m*m;
	torus->matrix = torus->b + N*m;
	torus->right = torus->matrix + size*size;
	torus->guess = torus->right + size;
	torus->along = torus->guess + size;
	torus->row = torus->along + size;
	torus->kernel = torus->row + size;
	torus->other = torus->kernel + N;
	return hawser__flow_init(&torus->flow, rom, report);
}

void hawser__torus_clear(struct hawser__torus *torus)
{
	hawser__flow_clear(&torus->flow);
	free(torus->x);
	free(torus->pivot);
	memset(torus, 0, sizeof *torus);
}

/* The model and the frequency at this place; 1 if there is none. */
static int torus_place(struct hawser__torus *torus, double place)
{
	const struct hawser_rom_family *family = torus->family;
	const struct hawser_rom *rom;

	torus->place = torus->omega = place;
	if (!family)
		return 0;
	if (family->model(family->context, &rom, place, NULL) || hawser__flow_place(&torus->flow, rom))
		return 1;
	torus->omega = family->omega*rom->time;
	return 0;
}

/* The derivative of the images by the parameter of the family, from the models on both sides. 1 where
 * there are none. */
static int differentiate_family(struct hawser__torus *torus, const struct hawser__stretch *stretch)
{
	int Nm = torus->points*torus->m, failed = 0;
	double place = torus->place, wide = HAWSER__NUDGE*torus->extent;

	for (int side = -1; side <= 1 && !failed; side += 2) {
		failed = torus_place(torus, place + side*wide);
		memcpy(torus->other, torus->x, (size_t)Nm*sizeof *torus->x);
		(void)hawser__flow_map(&torus->flow, torus->other, NULL, stretch, torus->omega);
		for (int i = 0; i < Nm; i++)
			torus->b[i] = (side < 0 ? 0.0 : torus->b[i]) + side*torus->other[i]/(2.0*wide);
	}
	return torus_place(torus, place) || failed;
}

double hawser__torus_cardinal(int N, double t, int derivative)
{
	double sum = derivative ? 0.0 : 1.0, half = sin(0.5*t);

	if (!derivative && fabs(half) > 1e-3) /* round-off below N 1e-13 */
		return sin(0.5*N*t)/(N*half);
	for (int k = 1; k <= N/2; k++)
		sum += derivative ? -2.0*k*sin(k*t) : 2.0*cos(k*t);
	return sum/N;
}

void hawser__torus_shifted(double *out, struct hawser__torus *torus, double shift, int derivative)
{
	int N = torus->points, m = torus->m;

	for (int d = 0; d < N; d++)
		torus->kernel[d] = hawser__torus_cardinal(N, shift + 2.0*M_PI*d/N, derivative);
	memset(out, 0, (size_t)N*(size_t)m*sizeof *out);
	for (int i = 0; i < N; i++)
		for (int j = 0; j < N; j++)
			cblas_daxpy(m, torus->kernel[(i - j + N)%N], torus->x + (size_t)j*m, 1,
			            out + (size_t)i*m, 1);
}

void hawser__torus_resample(double *y, double *work, int m, int N, int points)
{
	for (int i = 0; i < points; i++) {
		double *to = work + (size_t)i*(size_t)m;

		memset(to, 0, (size_t)m*sizeof *to);
		for (int j = 0; j < N; j++)
			cblas_daxpy(m, hawser__torus_cardinal(N, 2.0*M_PI*((double)i/points - (double)j/N), 0),
			            y + (size_t)j*m, 1, to, 1);
	}
	work[(size_t)points*(size_t)m] = y[(size_t)N*(size_t)m];
	work[(size_t)points*(size_t)m + 1] = y[(size_t)N*(size_t)m + 1];
	memcpy(y, work, ((size_t)points*(size_t)m + 2)*sizeof *y);
}

enum hawser_status hawser__torus_begin(struct hawser__torus *torus, const double *x0, double place,
                                       double distance, struct hawser_report *report)
{
	int m = torus->m, N = torus->points, at = -1;
	struct hawser__stretch stretch = {.h = 2.0*M_PI/torus->steps, .steps = torus->steps, .count = 1};
	double *re = torus->right, *im = re + m, *v = torus->matrix, length = 0.0;

	if (torus_place(torus, place))
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, WHERE,
		                    "there is no model at the parameter %.9g", place);
	for (;;) {
		double error;

		memcpy(torus->image, x0, (size_t)m*sizeof *x0);
		error = hawser__flow_derive(&torus->flow, torus->image, torus->A, torus->b, NULL, &stretch,
		                            torus->omega);
		if (!(error > torus->mesh*cblas_dnrm2(m, x0, 1)) || torus->steps > MOST_STEPS)
			break;
		torus->steps += torus->steps/2;
		stretch.steps = torus->steps;
		stretch.h = 2.0*M_PI/torus->steps;
	}
	if (LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'V', m, torus->A, m, re, im, NULL, 1, v, m))
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, WHERE,
		                    "the multipliers at the torus point were not found");
	for (int k = 0; k < m; k++)
		if (im[k] > 0.0 && (at < 0 || fabs(hypot(re[k], im[k]) - 1.0) <
		                              fabs(hypot(re[at], im[at]) - 1.0)))
			at = k;
	if (at < 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "no pair of complex multipliers at Omega %.9g%s: not a torus point",
		                    HAWSER_SHOWN(torus->flow.rom, torus->omega));
	torus->rho = atan2(im[at], re[at]);
	for (int j = 0; j < m; j++)
		length = fmax(length, hypot(v[j*m + at], v[j*m + at + 1]));
	for (int i = 0; i < N; i++)
		for (int j = 0; j < m; j++)
			torus->x[i*m + j] = x0[j] + distance/length*(v[j*m + at]*cos(2.0*M_PI*i/N) -
			                                             v[j*m + at + 1]*sin(2.0*M_PI*i/N));
	return HAWSER_OK;
}

/* The bordered Jacobian, column-major; `right` holds P(x) - x(theta + rho) and then the constraints. */
static double assemble(struct hawser__torus *torus)
{
	int N = torus->points, m = torus->m, size = torus->size;
	struct hawser__stretch stretch = {.h = 2.0*M_PI/torus->steps, .steps = torus->steps, .count = N};
	double *J = torus->matrix, *r = torus->right, largest = 0.0, most = 0.0, error;

	if (torus_place(torus, torus->place))
		return INFINITY;
	memcpy(torus->image, torus->x, (size_t)N*(size_t)m*sizeof *torus->x);
	error = hawser__flow_derive(&torus->flow, torus->image, torus->A, torus->b, NULL, &stretch,
	                            torus->omega);
	if (torus->family && differentiate_family(torus, &stretch))
		return INFINITY;
	memset(J, 0, (size_t)size*(size_t)size*sizeof *J);
	hawser__torus_shifted(J + (size_t)(N*m)*size, torus, torus->rho, 1); /* column of rho */
	cblas_dscal(N*m, -1.0, J + (size_t)(N*m)*size, 1);
	memcpy(J + (size_t)(N*m + 1)*size, torus->b, (size_t)(N*m)*sizeof *J);
	hawser__torus_shifted(r, torus, torus->rho, 0);
	for (int i = 0; i < N*m; i++) {
		r[i] = torus->image[i] - r[i];
		if (!isfinite(r[i])) /* fmax would pass over it */
			return INFINITY;
		largest = fmax(largest, fabs(r[i]));
		most = fmax(most, fabs(torus->x[i]));
	}
	torus->period_error = error/(N*most);
	for (int i = 0; i < N; i++)
		for (int j = 0; j < N; j++)
			for (int a = 0; a < m; a++)
				J[(size_t)(j*m + a)*size + i*m + a] -= torus->kernel[(i - j + N)%N];
	for (int i = 0; i < N; i++)
		for (int a = 0; a < m; a++)
			for (int c = 0; c < m; c++)
				J[(size_t)(i*m + c)*size + i*m + a] += torus->A[((size_t)i*m + a)*m + c];
	r[N*m] = 0.0;
	r[N*m + 1] = torus->row[N*m]*(torus->rho - torus->guess[N*m]) +
	             torus->row[N*m + 1]*(torus->place - torus->guess[N*m + 1]);
	for (int i = 0; i < N*m; i++) {
		J[(size_t)i*size + N*m] = torus->along[i];
		r[N*m] += torus->along[i]*(torus->x[i] - torus->guess[i]);
		r[N*m + 1] += torus->row[i]*(torus->x[i] - torus->guess[i]);
	}
	for (int i = 0; i < size; i++)
		J[(size_t)i*size + N*m + 1] = torus->row[i];
	return largest/most;
}

void hawser__torus_judge(struct hawser__torus *torus)
{
	int N = torus->points, m = torus->m;
	struct hawser__stretch stretch = {.h = M_PI/torus->steps, .steps = 2*torus->steps, .count = N};
	double most = 0.0, first = 0.0, last = 0.0;

	hawser__torus_shifted(torus->image, torus, M_PI/N, 0);
	(void)hawser__flow_map(&torus->flow, torus->image, NULL, &stretch, torus->omega);
	hawser__torus_shifted(torus->right, torus, M_PI/N + torus->rho, 0);
	torus->defect = 0.0;
	for (int i = 0; i < N*m; i++) {
		double gap = fabs(torus->image[i] - torus->right[i]);

		torus->defect = isfinite(gap) ? fmax(torus->defect, gap) : INFINITY;
		most = fmax(most, fabs(torus->x[i]));
	}
	torus->defect /= most;
	for (int a = 0; a < m; a++)
		for (int k = 1; k <= N/2; k++) {
			double re = 0.0, im = 0.0, size;

			for (int i = 0; i < N; i++) {
				re += torus->x[i*m + a]*cos(2.0*M_PI*i*k/N);
				im += torus->x[i*m + a]*sin(2.0*M_PI*i*k/N);
			}
			size = hypot(re, im);
			first = fmax(first, size);
			last = k > N/2 - 2 ? fmax(last, size) : last;
		}
	torus->tail = last/first;
}

void hawser__torus_guess(struct hawser__torus *torus)
{
	int Nm = torus->points*torus->m;
	double length;

	memcpy(torus->guess, torus->x, (size_t)Nm*sizeof *torus->x);
	torus->guess[Nm] = torus->rho;
	torus->guess[Nm + 1] = torus->place;
	hawser__torus_shifted(torus->along, torus, 0.0, 1);
	length = cblas_dnrm2(Nm, torus->along, 1);
	if (length > 0.0)
		cblas_dscal(Nm, 1.0/length, torus->along, 1);
}

int hawser__torus_newton(struct hawser__torus *torus, struct hawser__correction *did,
                         const double *weight)
{
	int Nm = torus->points*torus->m, size = torus->size;
	double previous = 0.0, length = 0.0;

	*did = (struct hawser__correction){.iterations = 0};
	for (torus->iterations = 0;; torus->iterations++) {
		torus->residual = assemble(torus);
		did->residual = torus->residual;
		did->iterations = torus->iterations;
		if (torus->residual < SMALL || torus->iterations == MOST_ITERATIONS ||
		    !isfinite(torus->residual))
			break;
		if (LAPACKE_dgesv(LAPACK_COL_MAJOR, size, 1, torus->matrix, size, torus->pivot, torus->right,
		                  size))
			break;
		cblas_daxpy(Nm, -1.0, torus->right, 1, torus->x, 1);
		torus->rho -= torus->right[Nm];
		torus->place -= torus->right[Nm + 1];
		length = 0.0;
		for (int k = 0; weight && k < size; k++)
			length += weight[k]*torus->right[k]*torus->right[k];
		length = sqrt(length);
		if (torus->iterations == 0)
			did->first = length;
		if (torus->iterations == 1 && previous > 0.0)
			did->contraction = length/previous;
		if (weight && !(length < FARTHEST))
			return 1;
		previous = length;
	}
	return !(torus->residual < SMALL);
}

int hawser__torus_tangent(struct hawser__torus *torus, double *t)
{
	int size = torus->size;

	memset(t, 0, (size_t)size*sizeof *t);
	t[size - 1] = 1.0;
	return LAPACKE_dgesv(LAPACK_COL_MAJOR, size, 1, torus->matrix, size, torus->pivot, t, size) != 0;
}

enum hawser_status hawser__torus_correct(struct hawser__torus *torus, int sized,
                                         struct hawser_report *report)
{
	int N = torus->points, m = torus->m;
	struct hawser__correction did;

	hawser__torus_guess(torus);
	memset(torus->row, 0, (size_t)torus->size*sizeof *torus->row);
	if (!sized)
		torus->row[N*m + 1] = 1.0;
	for (int i = 0; sized && i < N*m; i++) {
		double mean = 0.0;

		for (int k = i%m; k < N*m; k += m)
			mean += torus->x[k]/N;
		torus->row[i] = torus->x[i] - mean;
	}
	if (hawser__torus_newton(torus, &did, NULL))
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, WHERE, torus->iterations,
		                       torus->residual, "no invariant circle of %d points was found near "
		                       "Omega %.9g%s, rotation number %.9g", N,
		                       HAWSER_SHOWN(torus->flow.rom, torus->omega), torus->rho);
	hawser__torus_judge(torus);
	return HAWSER_OK;
}
