/* rom/order_effect.c - inertia and damping of relaxed coordinates, and the effect of the omitted force
 * on the response. Symbols as in order.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <complex.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/order.h"
#include "rom/weigh.h"

#define FAINT 0.4 /* smallest displacement, relative to the largest, that counts; chosen */

/* --- inertia and damping of the relaxed coordinates --- */

static double complex turn(const struct hawser__omitted *w, int h, int t)
{
	const double *at = w->turn + 2*(size_t)(h*t%w->rows);

	return at[0] + I*at[1];
}

static void set_spin(struct hawser__omitted *w)
{
	for (int t = 0; t < w->rows; t++) {
		w->turn[2*t] = cos(2.0*M_PI*t/w->rows);
		w->turn[2*t + 1] = sin(2.0*M_PI*t/w->rows);
	}
	for (int t = 0; t < w->rows; t++)
		for (int h = 1; h <= (w->rows - 1)/2; h++) {
			w->spin[t] -= 2.0*h*sin(2.0*M_PI*h*t/w->rows)/w->rows;
			w->spin[w->rows + t] -= 2.0*h*h*cos(2.0*M_PI*h*t/w->rows)/w->rows;
		}
}

/* dx/dtau (order 0) or d2x/dtau2 (order 1) at row t of x[rows][stride]. */
static double turned(const struct hawser__omitted *w, const double *x, int stride, int t, int order)
{
	const double *kernel = w->spin + (size_t)order*w->rows;
	double sum = 0.0;

	for (int k = 0; k < w->rows; k++)
		sum += kernel[(t - k + w->rows)%w->rows]*x[(size_t)k*stride];
	return sum;
}

static void add_followers(struct hawser__omitted *w)
{
	int N = w->N, held = w->held;

	for (int i = 0; i < w->frees; i++) {
		int s = w->freed[i];

		for (int t = 0; w->beyond[i] && t < w->rows; t++) {
			double force = w->omega*w->omega*turned(w, w->motion + s, N, t, 1) +
			               w->omega*w->exact->D[s*N + s]*turned(w, w->motion + s, N, t, 0);

			cblas_daxpy(held, force, w->led + ((size_t)t*w->frees + i)*held, 1,
			            w->G + (size_t)t*held, 1);
		}
	}
}

/* Add to w->G the force of the inertia and damping of the relaxed coordinate number i, with its own
 * resonance. */
static void add_dynamic(struct hawser__omitted *w, int i)
{
	int s = w->freed[i], rows = w->rows, N = w->N;
	double K = w->exact->K[(size_t)s*N + s], D = w->exact->D[(size_t)s*N + s];

	memset(w->rate, 0, (size_t)rows*sizeof *w->rate);
	for (int h = 1; h <= (rows - 1)/2; h++) {
		double W = h*w->omega;
		double complex own = -W*W + I*W*D, y = 0.0;

		for (int t = 0; t < rows; t++)
			y += w->motion[(size_t)t*N + s]*conj(turn(w, h, t));
		y *= 2.0/rows*own*K/(K + own);
		for (int t = 0; t < rows; t++)
			w->rate[t] += creal(y*turn(w, h, t));
	}
	for (int t = 0; t < rows; t++)
		cblas_daxpy(w->held, w->rate[t], w->led + ((size_t)t*w->frees + i)*w->held, 1,
		            w->G + (size_t)t*w->held, 1);
}

/* The same for all that are candidates. */
static void add_looked_at(struct hawser__omitted *w)
{
	for (int i = 0; i < w->frees; i++)
		if (!w->beyond[i])
			add_dynamic(w, i);
}

/* The part that the model's inertia shapes represent, for coordinate x of the model: w->rate gets q,
 * w->bend gets dq/du [rows][held]. at[i]: index of the kept mode that is coordinate i, or -1. */
static void subtract_shape(struct hawser__omitted *w, int x, const int *at)
{
	const struct hawser_rom *model = w->model;
	int modes = model->n - model->inertia.shapes, held = w->held;
	double K = model->K[x*(model->n + 1)], D = model->D[x*(model->n + 1)];

	memset(w->rate, 0, (size_t)w->rows*sizeof *w->rate);
	memset(w->bend, 0, (size_t)w->rows*held*sizeof *w->bend);
	for (int i = 0; i < model->quads; i++) {
		const struct hawser_quad *Q = &model->Q[i];
		int a, b;

		if (Q->j != x || Q->l >= modes || at[Q->k] < 0 || at[Q->l] < 0)
			continue;
		a = at[Q->k];
		b = at[Q->l];
		for (int t = 0; t < w->rows; t++) {
			const double *u = w->kept + (size_t)t*held;

			w->rate[t] -= Q->value/K*u[a]*u[b];
			w->bend[(size_t)t*held + a] -= Q->value/K*u[b];
			w->bend[(size_t)t*held + b] -= Q->value/K*u[a];
		}
	}
	for (int t = 0; t < w->rows; t++)
		cblas_daxpy(held, -w->omega*w->omega*turned(w, w->rate, 1, t, 1) -
		                  w->omega*D*turned(w, w->rate, 1, t, 0),
		            w->bend + (size_t)t*held, 1, w->G + (size_t)t*held, 1);
}

static enum hawser_status subtract_shapes(struct hawser__omitted *w, struct hawser_report *report)
{
	const struct hawser_rom *model = w->model;
	int *at, place = 0;

	if (!model || model->inertia.shapes == 0)
		return HAWSER_OK;
	at = malloc((size_t)model->n*sizeof *at);
	if (!at)
		return hawser__no_memory(report, "choose");
	for (int i = 0; i < model->n; i++)
		at[i] = -1;
	for (int j = 0; j < w->n; j++) {
		if (!w->choice->mode[j].kept)
			continue;
		for (int k = 0; k < w->held; k++)
			if (w->mode[k] == j)
				at[place] = k;
		place++;
	}
	for (int x = model->n - model->inertia.shapes; x < model->n; x++)
		subtract_shape(w, x, at);
	free(at);
	return HAWSER_OK;
}

/* --- the displaced response --- */

/* Orthonormal over the period: 1, sqrt(2) cos(tau), sqrt(2) sin(tau), ..., at row t. */
static double wave(const struct hawser__omitted *w, int p, int t)
{
	return w->wave[(size_t)p*w->rows + t];
}

static void set_waves(struct hawser__omitted *w)
{
	for (int p = 0; p < w->functions; p++)
		for (int t = 0; t < w->rows; t++) {
			double complex at = turn(w, (p + 1)/2, t);

			w->wave[(size_t)p*w->rows + t] = p == 0 ? 1.0 : sqrt(2.0)*(p%2 ? creal(at) : cimag(at));
		}
}

/* c[held][functions], `stride` doubles from one to the next, of x[rows][held]. */
static void analyse(const struct hawser__omitted *w, double *c, const double *x, int stride)
{
	for (int k = 0; k < w->held; k++)
		for (int p = 0; p < w->functions; p++) {
			double sum = 0.0;

			for (int t = 0; t < w->rows; t++)
				sum += x[(size_t)t*w->held + k]*wave(w, p, t);
			c[stride*(k*w->functions + p)] = sum/w->rows;
		}
}

/* A[unknowns][unknowns + 1]: effect of the harmonics of du, in units of `size`, and of
 * dOmega/Omega. product[functions][functions][rows] is workspace. c: the harmonics of u. */
static void assemble(const struct hawser__omitted *w, double *A, double *product, const double *c,
                     double size)
{
	int held = w->held, f = w->functions, width = held*f + 1;
	const double *D = w->all->D;

	for (int e = 0; e < f*f; e++)
		for (int t = 0; t < w->rows; t++)
			product[e*w->rows + t] = size*wave(w, e/f, t)*wave(w, e%f, t)/w->rows;
	for (int j = 0; j < held; j++)
		for (int k = 0; k < held; k++)
			for (int e = 0; e < f*f; e++)
				A[(size_t)(j*f + e/f)*width + k*f + e%f] =
					cblas_ddot(w->rows, product + (size_t)e*w->rows, 1,
					           w->stiff + (size_t)j*held + k, held*held);
	for (int j = 0; j < held; j++)
		for (int p = 0; p < f; p++) {
			int harmonic = (p + 1)/2, other = p%2 ? p + 1 : p - 1; /* the index of its time
			                                                        * derivative */
			double *row = A + (size_t)(j*f + p)*width, W = harmonic*w->omega;

			row[j*f + p] -= size*W*W;
			row[width - 1] = -2.0*W*W*c[j*f + p];
			for (int k = 0; p > 0 && k < held; k++) {
				double d = (p%2 ? W : -W)*D[w->mode[j]*w->n + w->mode[k]];

				row[k*f + other] += size*d;
				row[width - 1] += d*c[k*f + other];
			}
		}
}

/* Largest relative change of an amplitude that counts, for harmonics x[] of du, HAWSER__OMITTED
 * apart. */
static double amplitudes(struct hawser__omitted *w, const double *x, unsigned peaks)
{
	double was[HAWSER__COUNTED] = {0.0}, is[HAWSER__COUNTED] = {0.0}, at[HAWSER__COUNTED];
	double largest = 0.0, worst = 0.0;

	for (int t = 0; t < w->rows; t++)
		for (int moved = 0; moved < 2; moved++) {
			for (int k = 0; k < w->held; k++) {
				double u = w->kept[(size_t)t*w->held + k];

				for (int p = 0; moved && p < w->functions; p++)
					u += x[HAWSER__OMITTED*(k*w->functions + p)]*wave(w, p, t);
				w->u[w->mode[k]] = u;
			}
			hawser__omitted_condensed(w);
			hawser__omitted_displace(at, w->all, w->u);
			for (int i = 0; i < w->places; i++)
				if (moved)
					is[i] = fmax(is[i], fabs(at[i] + w->off[(size_t)t*w->places + i]));
				else
					was[i] = fmax(was[i], fabs(at[i]));
		}
	for (int i = 0; i < w->places; i++)
		largest = fmax(largest, was[i]);
	for (int i = 0; i < w->places; i++)
		if (was[i] > FAINT*largest && (peaks & 1u << i))
			worst = fmax(worst, fabs(is[i]/was[i] - 1.0));
	return worst;
}

enum hawser_status hawser__omitted_effect(double omitted[HAWSER__OMITTED], struct hawser__omitted *w,
                                       unsigned peaks, struct hawser_report *report)
{
	const int waves = HAWSER__OMITTED_WAVES, sides = HAWSER__OMITTED;
	int most = w->rows > 2*waves ? waves : (w->rows - 1)/2, f = 2*most + 1, unknowns = w->held*f;
	size_t width = (size_t)unknowns + 1;
	double *A = malloc((size_t)unknowns*width*sizeof *A), *c = malloc(width*sizeof *c);
	double *x = calloc((size_t)sides*width, sizeof *x);
	double *product = malloc((size_t)f*f*w->rows*sizeof *product);
	enum hawser_status status = HAWSER_OK;
	double size;
	int info;

	if (!A || !c || !x || !product) {
		status = hawser__no_memory(report, "choose");
		goto done;
	}
	w->functions = f;
	set_spin(w);
	set_waves(w);
	analyse(w, c, w->kept, 1);
	analyse(w, x + 1, w->G, sides);
	add_followers(w);
	status = subtract_shapes(w, report);
	if (status)
		goto done;
	analyse(w, x, w->G, sides);
	add_looked_at(w);
	analyse(w, x + 2, w->G, sides);
	size = cblas_dnrm2(unknowns, c, 1);
	assemble(w, A, product, c, size);
	cblas_dscal(sides*unknowns, -1.0, x, 1);
	info = LAPACKE_dgels(LAPACK_ROW_MAJOR, 'N', unknowns, unknowns + 1, sides, A, unknowns + 1, x,
	                     sides);
	if (hawser__lapack_starved(info))
		status = hawser__no_memory(report, "choose");
	if (info)
		goto done;
	cblas_dscal(sides*unknowns, size, x, 1);
	for (int i = 0; i < sides; i++)
		omitted[i] = fmax(fabs(x[sides*unknowns + i]), amplitudes(w, x + i, peaks));
done:
	free(A);
	free(c);
	free(x);
	free(product);
	return status;
}
