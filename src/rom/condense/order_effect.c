/* rom/condense/order_effect.c - the force that a condensed model omits, and its effect on the
 * response. Symbols as in order.c. SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <complex.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/condense/order.h"
#include "rom/choose/weigh.h"

#define FAINT 0.4 /* smallest displacement, relative to the largest, that counts; chosen */

/* --- the omitted force --- */

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

/* w->force and w->pull. */
static void set_forces(struct hawser__omitted *w)
{
	int N = w->N;
	double *bend = w->relax.R, *zero = w->relax.step;

	memset(zero, 0, (size_t)N*sizeof *zero);
	for (int t = 0; t < w->rows; t++) {
		const double *y = w->motion + (size_t)t*N;
		double *force = w->force + (size_t)t*N, *pull = w->pull + (size_t)t*N;
		double tau = 2.0*M_PI*t/w->rows;

		for (int i = 0; i < N; i++) {
			w->relax.trial[i] = w->omega*turned(w, w->motion + i, N, t, 0);
			bend[i] = w->omega*w->omega*turned(w, w->motion + i, N, t, 1);
		}
		hawser_rom_acceleration(w->exact, pull, y, zero, tau, w->omega);
		hawser_rom_acceleration(w->exact, force, y, w->relax.trial, tau, w->omega);
		for (int i = 0; i < w->relax.frees; i++)
			force[w->relax.freed[i]] -= bend[w->relax.freed[i]];
	}
}

/* w->rate: r of coordinate s, with its resonance. */
static void resonate(struct hawser__omitted *w, int s)
{
	int rows = w->rows, N = w->N;
	double K = w->exact->K[(size_t)s*N + s], D = w->exact->D[(size_t)s*N + s];

	memset(w->rate, 0, (size_t)rows*sizeof *w->rate);
	for (int h = 0; h <= (rows - 1)/2; h++) {
		double W = h*w->omega;
		double complex force = 0.0;

		for (int t = 0; t < rows; t++)
			force += w->force[(size_t)t*N + s]*conj(turn(w, h, t));
		force *= (h ? 2.0 : 1.0)/rows*K/(K - W*W + I*W*D);
		for (int t = 0; t < rows; t++)
			w->rate[t] += creal(force*turn(w, h, t));
	}
}

/* Add to G the gyroscopic force on the kept modes by what w->rate moves coordinate s, whose row of D is
 * minus its column there. */
static void push_back(struct hawser__omitted *w, int s)
{
	const double *row = w->exact->D + (size_t)s*w->N;
	double K = w->exact->K[(size_t)s*w->N + s];

	for (int t = 0; t < w->rows && w->choice->modes->statics.motion.nu > 0.0; t++) {
		double speed = w->omega*turned(w, w->rate, 1, t, 0)/K;

		for (int k = 0; k < w->held; k++)
			w->G[(size_t)t*w->held + k] -= speed*hawser__omitted_twin(w, k, row);
	}
}

/* Coordinate k of the modes by coordinate e of the model. */
static double part(const struct hawser__omitted *w, int k, int e)
{
	const struct hawser_rom *model = w->orbit.model;

	return model->carried ? model->carried[w->place[k]*model->n + w->place[e]] : k == e;
}

/* Forces f[held] on the modes become those on the coordinates of the model. */
static void turn_back(struct hawser__omitted *w, double *f)
{
	for (int e = 0; e < w->held; e++) {
		w->plus[e] = 0.0;
		for (int k = 0; k < w->held; k++)
			w->plus[e] += part(w, k, e)*f[k];
	}
	memcpy(f, w->plus, (size_t)w->held*sizeof *f);
}

/* w->G, with the inertia and damping of all relaxed coordinates, or of those that are not candidates.
 * a[rows][model->n]: accelerations of the model. */
static void set_omitted(struct hawser__omitted *w, const double *a, int all_of_them)
{
	int held = w->held, N = w->N, n = w->orbit.model->n;

	for (int t = 0; t < w->rows; t++)
		for (int k = 0; k < held; k++)
			w->G[(size_t)t*held + k] = -hawser__omitted_twin(w, k, w->force + (size_t)t*N);
	for (int i = 0; i < w->relax.frees; i++) {
		int s = w->relax.freed[i], moves = all_of_them || w->beyond[i];

		if (moves) {
			resonate(w, s);
			push_back(w, s);
		}
		for (int t = 0; t < w->rows; t++)
			cblas_daxpy(held, -(moves ? w->rate[t] : w->pull[(size_t)t*N + s]),
			            w->led + ((size_t)t*w->relax.frees + i)*held, 1, w->G + (size_t)t*held, 1);
	}
	for (int t = 0; t < w->rows; t++) {
		turn_back(w, w->G + (size_t)t*held);
		for (int k = 0; k < held; k++)
			w->G[(size_t)t*held + k] += a[(size_t)t*n + w->place[k]];
	}
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

/* d/dtau of the same. */
static double slope(const struct hawser__omitted *w, int p, int t)
{
	int harmonic = (p + 1)/2;

	return p == 0 ? 0.0 : p%2 ? -harmonic*wave(w, p + 1, t) : harmonic*wave(w, p - 1, t);
}

/* c[functions], `stride` doubles from one to the next, of x, `step` doubles from row to row. */
static void analyse(const struct hawser__omitted *w, double *c, int stride, const double *x, int step)
{
	for (int p = 0; p < w->functions; p++) {
		double sum = 0.0;

		for (int t = 0; t < w->rows; t++)
			sum += x[(size_t)t*step]*wave(w, p, t);
		c[stride*p] = sum/w->rows;
	}
}

/* Side `i` of x[unknowns][HAWSER__OMITTED]: the harmonics of -G. */
static void set_side(const struct hawser__omitted *w, double *x, int i)
{
	for (int k = 0; k < w->held; k++)
		analyse(w, x + i + HAWSER__OMITTED*(size_t)w->place[k]*w->functions, HAWSER__OMITTED,
		        w->G + k, w->held);
	for (int e = 0; e < w->held*w->functions; e++)
		x[i + HAWSER__OMITTED*((size_t)w->place[e/w->functions]*w->functions + e%w->functions)] *= -1.0;
}

/* The equations of motion at row t, linearised. */
struct linear {
	double *u, *v, *bend;         /* [n] of the model, v = Omega u', bend = u'' */
	double *a, *by_u, *by_v, *by_omega; /* [n], [n][n], [n][n], [n] */
	double *store;
};

static int linear_make(struct linear *at, size_t n)
{
	double *p = at->store = malloc((5*n + 2*n*n)*sizeof *p);

	if (!p)
		return 0;
	at->u = p;
	at->v = p + n;
	at->bend = p + 2*n;
	at->a = p + 3*n;
	at->by_omega = p + 4*n;
	at->by_u = p + 5*n;
	at->by_v = at->by_u + n*n;
	return 1;
}

static void linearise(struct linear *at, const struct hawser__omitted *w, int t)
{
	int n = w->orbit.model->n, step = w->stride*n;

	for (int j = 0; j < n; j++) {
		at->u[j] = w->orbit.state[(size_t)t*step + j];
		at->v[j] = w->omega*turned(w, w->orbit.state + j, step, t, 0);
		at->bend[j] = turned(w, w->orbit.state + j, step, t, 1);
	}
	hawser_rom_acceleration_jacobian(w->orbit.model, at->a, at->by_u, at->by_v, at->by_omega, at->u,
	                                 at->v, 2.0*M_PI*t/w->rows, w->omega);
}

/* Add what row t is of A[unknowns][unknowns + 1]: effect of the harmonics of dx, in units of `size`,
 * and of dOmega/Omega, on the harmonics of the equations. */
static void assemble(const struct hawser__omitted *w, double *A, const struct linear *at, int t,
                     double size)
{
	int n = w->orbit.model->n, f = w->functions;
	size_t width = (size_t)n*f + 1;
	double W = w->omega, waves[2*HAWSER__OMITTED_WAVES + 1], slopes[2*HAWSER__OMITTED_WAVES + 1];

	for (int p = 0; p < f; p++) {
		waves[p] = wave(w, p, t)/w->rows;
		slopes[p] = W*slope(w, p, t)/w->rows;
	}
	for (int j = 0; j < n; j++) {
		double sum = 2.0*W*W*at->bend[j] - W*at->by_omega[j];

		for (int k = 0; k < n; k++) {
			double by_u = size*at->by_u[j*n + k], by_v = size*at->by_v[j*n + k];

			sum -= at->by_v[j*n + k]*at->v[k];
			if (by_u == 0.0 && by_v == 0.0)
				continue;
			for (int e = 0; e < f*f; e++)
				A[((size_t)j*f + e/f)*width + k*f + e%f] -=
					wave(w, e/f, t)*(by_u*waves[e%f] + by_v*slopes[e%f]);
		}
		for (int p = 0; p < f; p++)
			A[((size_t)j*f + p)*width + width - 1] += waves[p]*sum;
	}
}

/* The whole of A, and the accelerations of the model, a[rows][n]. 0: no memory. */
static int set_matrix(const struct hawser__omitted *w, double *A, double *a, double size)
{
	int n = w->orbit.model->n, f = w->functions;
	size_t unknowns = (size_t)n*f, width = unknowns + 1;
	struct linear at;

	if (!linear_make(&at, (size_t)n))
		return 0;
	memset(A, 0, unknowns*width*sizeof *A);
	for (int t = 0; t < w->rows; t++) {
		linearise(&at, w, t);
		assemble(w, A, &at, t, size);
		memcpy(a + (size_t)t*n, at.a, (size_t)n*sizeof *a);
	}
	for (size_t i = 0; i < unknowns; i++)
		A[i*width + i] -= size*pow(w->omega*(double)((i%f + 1)/2), 2);
	free(at.store);
	return 1;
}

/* --- the displacements --- */

/* Add to w->off what moves the relaxed coordinates from where they are relaxed. */
static void answer(struct hawser__omitted *w)
{
	double *one = w->relax.trial, at[HAWSER__COUNTED];

	memset(one, 0, (size_t)w->N*sizeof *one);
	for (int i = 0; i < w->relax.frees; i++) {
		int s = w->relax.freed[i];

		resonate(w, s);
		one[s] = 1.0/w->exact->K[(size_t)s*w->N + s];
		hawser__omitted_displace(at, w->exact, one);
		one[s] = 0.0;
		for (int t = 0; t < w->rows; t++)
			cblas_daxpy(w->places, w->rate[t], at, 1, w->off + (size_t)t*w->places, 1);
	}
}

/* Displacements at row t as a response of the model has them, with what the condensed modes do under
 * the load. */
static void shown(const struct hawser__omitted *w, double *xyz, int t)
{
	const struct hawser_rom *model = w->orbit.model;
	struct hawser_rom_moment moment = {.tau = 2.0*M_PI*t/w->rows, .omega = w->omega};

	for (int p = 0; p < w->places/3; p++)
		hawser_rom_displacement_at(model, xyz + 3*p, p,
		                           w->orbit.state + (size_t)t*w->stride*model->n, &moment);
}

/* Root mean square of the motion. */
static double size_of(const struct hawser__omitted *w)
{
	int n = w->orbit.model->n;
	double sum = 0.0;

	for (int t = 0; t < w->rows; t++)
		sum += pow(cblas_dnrm2(n, w->orbit.state + (size_t)t*w->stride*n, 1), 2)/w->rows;
	return sqrt(sum);
}

/* dx of coordinate e at row t. */
static double moves(const struct hawser__omitted *w, const double *x, int e, int t)
{
	double sum = 0.0;

	for (int p = 0; p < w->functions; p++)
		sum += x[HAWSER__OMITTED*(w->place[e]*w->functions + p)]*wave(w, p, t);
	return sum;
}

/* Largest relative change of an amplitude that counts, for harmonics x[] of dx, HAWSER__OMITTED
 * apart; with `answers`, from what the model shows. */
static double amplitudes(struct hawser__omitted *w, const double *x, unsigned peaks, int answers)
{
	double was[HAWSER__COUNTED] = {0.0}, is[HAWSER__COUNTED] = {0.0}, at[HAWSER__COUNTED];
	double largest = 0.0, worst = 0.0;

	for (int t = 0; t < w->rows; t++)
		for (int moved = 0; moved < 2; moved++) {
			for (int k = 0; k < w->held; k++) {
				double u = w->kept[(size_t)t*w->held + k];

				for (int e = 0; moved && e < w->held; e++)
					u += part(w, k, e)*moves(w, x, e, t);
				w->u[w->mode[k]] = u;
			}
			if (answers && !moved) {
				shown(w, at, t);
			} else {
				hawser__omitted_condensed(w);
				hawser__omitted_displace(at, w->all, w->u);
			}
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
	int most = w->rows > 2*waves ? waves : (w->rows - 1)/2, f = 2*most + 1;
	int unknowns = w->orbit.model->n*f, info;
	size_t width = (size_t)unknowns + 1;
	double *A = malloc((size_t)unknowns*width*sizeof *A);
	double *a = malloc((size_t)w->rows*w->orbit.model->n*sizeof *a);
	double *x = calloc((size_t)sides*width, sizeof *x), size = size_of(w);
	enum hawser_status status = HAWSER_OK;

	w->functions = f;
	set_spin(w);
	set_waves(w);
	if (!A || !a || !x || !set_matrix(w, A, a, size)) {
		status = hawser__no_memory(report, "choose");
		goto done;
	}
	set_side(w, x, 1);
	set_forces(w);
	set_omitted(w, a, 0);
	set_side(w, x, 0);
	set_omitted(w, a, 1);
	set_side(w, x, 2);
	info = LAPACKE_dgels(LAPACK_ROW_MAJOR, 'N', unknowns, unknowns + 1, sides, A, unknowns + 1, x,
	                     sides);
	if (hawser__lapack_starved(info))
		status = hawser__no_memory(report, "choose");
	if (info)
		goto done;
	cblas_dscal(sides*unknowns, size, x, 1);
	for (int i = 0; i < sides; i++) {
		int whole = i == 2;

		if (whole)
			answer(w);
		omitted[i] = fmax(fabs(x[sides*unknowns + i]),
		                  amplitudes(w, x + i, peaks, whole && w->orbit.model != w->all));
	}
done:
	free(A);
	free(a);
	free(x);
	return status;
}
