/* response/branch/normal_form.c - coefficients of normal forms of the period map.
 *
 *   P        period map of the state x = (u, v/Omega); A = P' at the motion, by the flow's exact
 *            derivatives
 *   B, C     second and third derivative of P there, as forms of directions
 *   mu       the multiplier that is 1, -1 or on the unit circle; A q = mu q, p* A = mu p*, p* q = 1
 *
 *   fold     c = p B(q, q)/2
 *   doubling c = p [C(q, q, q) + 3 B(q, r)]/6,                     (I - A) r = B(q, q)
 *   torus    d = conj(mu)/2 p* [C(q, q, q~) + 2 B(q, r) + B(q~, s)],
 *            (I - A) r = B(q, q~), (mu^2 I - A) s = B(q, q)
 *
 * B(d, d) and C(d, d, d) are derivatives of P(x + t d) by t: central differences of nine points, at the
 * distance t for which they differ least from those at half of it. Mixed arguments follow by
 * polarisation. The flow has fixed steps, so that the map is smooth and its differences have round-off
 * only. (Exact variational equations of third order would hold for polynomials only, and not for drag,
 * stops and models of full order.)
 *
 * Reference: Kuznetsov, Elements of Applied Bifurcation Theory, 5.4.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <complex.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/normal_form.h>

#include "core/report.h"
#include "response/time/flow.h"
#include "response/orbit/shooting.h"
#include "rom/terms/terms.h"

enum { POINTS = 4, SHRINKS = 14 };
#define SHRINK 0.5     /* of the distance, from one trial to the next */
#define NEAR 1e-3      /* largest distance of a multiplier from its place; chosen */
#define RESONANT 1e-3  /* of mu^3 or mu^4 from 1; chosen: c grows with its inverse */
#define UNSURE 0.05    /* largest relative error of a coefficient that is given; chosen */
#define SAFETY 10.0      /* the smallest of several differences is smaller than the error */
#define STEP_ERROR 1e-12 /* of the integration over the period, relative; chosen, near round-off */
#define MOST_STEPS 4000 /* of a period, so that the result takes seconds; chosen */

struct work {
	const struct hawser_rom *rom;
	struct hawser__flow flow;
	struct hawser__stretch stretch;
	int m;
	double omega, size, t; /* size: of the state, or 1 at rest; t: distance of the differences */
	double *x;             /* [m] the motion's state: u, v */
	double *A;             /* [m][m] of u and v/Omega */
	double *P;             /* [2 POINTS][m] */
	double *center;        /* [m] P(x) */
	double *left, *right, *copy; /* [m][m] */
	double *re, *im;       /* [m] */
	double *sum;           /* [m] a direction */
	double *form;          /* [4][m] second and third derivative of two directions */
	double complex *q, *p, *r, *s, *value, *part, *matrix; /* [m], matrix [m][m] */
	lapack_int *pivot;
};

static void release(struct work *w)
{
	hawser__flow_clear(&w->flow);
	free(w->x);
	free(w->q);
	free(w->pivot);
}

static enum hawser_status prepare(struct work *w, const struct hawser_rom *rom, const double *state,
                                  double omega, int period, struct hawser_report *report)
{
	size_t n = (size_t)rom->n, m = 2*n;
	enum hawser_status status;
	double *next;

	*w = (struct work){.rom = rom, .m = (int)m, .omega = omega/hawser__rom_periods(rom)};
	status = hawser__flow_init(&w->flow, rom, report);
	w->x = next = calloc(4*m*m + (2*POINTS + 9)*m, sizeof *next);
	w->q = calloc(6*m + m*m, sizeof *w->q);
	w->pivot = calloc(m, sizeof *w->pivot);
	if (!status && (!next || !w->q || !w->pivot))
		status = hawser__no_memory(report, "orbit");
	if (status)
		return status;
	w->A = next += m;
	w->left = next += m*m;
	w->right = next += m*m;
	w->copy = next += m*m;
	w->P = next += m*m;
	w->center = next += 2*POINTS*m;
	w->re = next += m;
	w->im = next += m;
	w->sum = next += m;
	w->form = next + m;
	w->p = w->q + m;
	w->r = w->p + m;
	w->s = w->r + m;
	w->value = w->s + m;
	w->part = w->value + m;
	w->matrix = w->part + m;
	memcpy(w->x, state, m*sizeof *state);
	for (size_t i = 0; i < m; i++)
		w->size = hypot(w->size, state[i]/(i < n ? 1.0 : w->omega));
	w->size = w->size > 0.0 ? w->size : 1.0;
	w->stretch = (struct hawser__stretch){
		.steps = period*hawser__shooting_steps(rom, w->omega, 1), .count = 1};
	return HAWSER_OK;
}

/* The number of steps, A and P(x). Returns 1 if the period takes too many steps. */
static int set_steps(struct work *w, int period)
{
	int m = w->m, n = m/2;
	double *b = w->sum, size = 0.0;

	for (int i = 0; i < m; i++)
		size = hypot(size, w->x[i]);
	size = size > 0.0 ? size : 1.0;
	for (double error = INFINITY; error > STEP_ERROR*size; w->stretch.steps *= 2) {
		if (w->stretch.steps > MOST_STEPS)
			return 1;
		memcpy(w->center, w->x, (size_t)m*sizeof *w->x);
		w->stretch.h = 2.0*M_PI*period/w->stretch.steps;
		error = hawser__flow_map(&w->flow, w->center, NULL, &w->stretch, w->omega);
		if (!isfinite(error))
			return 1;
	}
	w->stretch.h = 2.0*M_PI*period/w->stretch.steps;
	memcpy(w->center, w->x, (size_t)m*sizeof *w->x);
	(void)hawser__flow_derive(&w->flow, w->center, w->A, b, NULL, &w->stretch, w->omega);
	for (int i = 0; i < m; i++)
		for (int j = 0; j < m; j++)
			w->A[i*m + j] *= (j < n ? 1.0 : w->omega)/(i < n ? 1.0 : w->omega);
	return 0;
}

/* How far mu is from its place. */
static double distance_of(double re, double im, enum hawser_event_kind kind)
{
	if (kind == HAWSER_TORUS)
		return im > 0.0 ? fabs(hypot(re, im) - 1.0) : INFINITY;
	return im == 0.0 ? fabs(re - (kind == HAWSER_FOLD ? 1.0 : -1.0)) : INFINITY;
}

/* mu, q and p. Returns its distance, or -1 when out of memory. */
static double find_vectors(double complex *mu, struct work *w, enum hawser_event_kind kind)
{
	int m = w->m, at = 0, pair;
	double length = 0.0;
	double complex product = 0.0;

	memcpy(w->copy, w->A, (size_t)m*m*sizeof *w->A);
	if (LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'V', 'V', m, w->copy, m, w->re, w->im, w->left, m, w->right, m))
		return -1.0;
	for (int i = 1; i < m; i++)
		if (distance_of(w->re[i], w->im[i], kind) < distance_of(w->re[at], w->im[at], kind))
			at = i;
	pair = w->im[at] != 0.0;
	*mu = w->re[at] + I*w->im[at];
	for (int i = 0; i < m; i++) {
		w->q[i] = w->right[i*m + at] + (pair ? I*w->right[i*m + at + 1] : 0.0);
		w->p[i] = w->left[i*m + at] + (pair ? I*w->left[i*m + at + 1] : 0.0);
		length += pow(cabs(w->q[i]), 2);
	}
	for (int i = 0; i < m; i++) {
		w->q[i] /= sqrt(length);
		product += conj(w->p[i])*w->q[i];
	}
	for (int i = 0; i < m; i++)
		w->p[i] /= conj(product);
	return distance_of(w->re[at], w->im[at], kind);
}

/* second, third [m]: derivatives of P(x + t d) by t at 0. */
static void differentiate(struct work *w, double *second, double *third, const double *d)
{
	static const double two[POINTS] = {8.0/5.0, -1.0/5.0, 8.0/315.0, -1.0/560.0};
	static const double three[POINTS] = {-61.0/30.0, 169.0/120.0, -3.0/10.0, 7.0/240.0};
	int m = w->m, n = m/2;
	double length = 0.0, t;

	for (int i = 0; i < m; i++)
		length = hypot(length, d[i]);
	t = w->t/(length > 0.0 ? length : 1.0);
	for (int k = 0; k < 2*POINTS; k++)
		for (int i = 0; i < m; i++)
			w->P[k*m + i] = w->x[i] + (k%2 ? -t : t)*(k/2 + 1)*d[i]*(i < n ? 1.0 : w->omega);
	w->stretch.count = 2*POINTS;
	(void)hawser__flow_map(&w->flow, w->P, NULL, &w->stretch, w->omega);
	w->stretch.count = 1;
	for (int i = 0; i < m; i++) {
		second[i] = third[i] = 0.0;
		for (int k = 0; k < POINTS; k++) {
			double ahead = w->P[2*k*m + i] - w->center[i], back = w->P[(2*k + 1)*m + i] - w->center[i];

			second[i] += two[k]*(ahead + back);
			third[i] += three[k]*(ahead - back);
		}
		second[i] /= t*t*(i < n ? 1.0 : w->omega);
		third[i] /= t*t*t*(i < n ? 1.0 : w->omega);
	}
}

static double component(double complex z, int imaginary)
{
	return imaginary ? cimag(z) : creal(z);
}

/* out [m] += factor B(a, b) of the real or imaginary parts: (B(a + b, a + b) - B(a - b, a - b))/4. */
static void add_mixed(struct work *w, double complex *out, double complex factor,
                      const double complex *a, int a_imaginary, const double complex *b,
                      int b_imaginary)
{
	int m = w->m;
	double *plus = w->form, *minus = w->form + m, *third = w->form + 2*m, size[2] = {0.0}, by;

	for (int i = 0; i < m; i++) {
		size[0] = hypot(size[0], component(a[i], a_imaginary));
		size[1] = hypot(size[1], component(b[i], b_imaginary));
	}
	if (size[0] == 0.0 || size[1] == 0.0)
		return;
	by = size[0]/size[1]; /* both of one length: else the difference would lose digits */
	for (int i = 0; i < m; i++)
		w->sum[i] = component(a[i], a_imaginary) + by*component(b[i], b_imaginary);
	differentiate(w, plus, third, w->sum);
	for (int i = 0; i < m; i++)
		w->sum[i] = component(a[i], a_imaginary) - by*component(b[i], b_imaginary);
	differentiate(w, minus, third, w->sum);
	for (int i = 0; i < m; i++)
		out[i] += factor*(plus[i] - minus[i])/(4.0*by);
}

/* right [m] = (z I - A)^-1 right. Returns 1 if singular. */
static int solve(struct work *w, double complex *right, double complex z)
{
	int m = w->m;

	for (int i = 0; i < m*m; i++)
		w->matrix[i] = (i%(m + 1) == 0 ? z : 0.0) - w->A[i];
	return LAPACKE_zgesv(LAPACK_ROW_MAJOR, m, 1, w->matrix, m, w->pivot, right, 1) != 0;
}

static double complex project(const struct work *w, const double complex *v)
{
	double complex sum = 0.0;

	for (int i = 0; i < w->m; i++)
		sum += conj(w->p[i])*v[i];
	return sum;
}

/* c of a fold or a doubling. */
static double real_form(struct work *w, enum hawser_event_kind kind)
{
	int m = w->m;
	double *second = w->form, *third = w->form + m;

	for (int i = 0; i < m; i++)
		w->sum[i] = creal(w->q[i]);
	differentiate(w, second, third, w->sum);
	for (int i = 0; i < m; i++) {
		w->r[i] = second[i];
		w->value[i] = kind == HAWSER_FOLD ? second[i] : third[i];
	}
	if (kind == HAWSER_FOLD)
		return fabs(creal(project(w, w->value)))/2.0;
	if (solve(w, w->r, 1.0))
		return NAN;
	add_mixed(w, w->value, 3.0, w->q, 0, w->r, 0);
	return creal(project(w, w->value))/6.0;
}

/* value = C(q, q, q~), r = B(q, q~) and s = B(q, q) of q = a + ib: with C of a, b, a + b, a - b. */
static void torus_forms(struct work *w)
{
	static const double of[4][2] = {{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}};
	/* parts of these four in C(a,a,a) + C(a,b,b) and C(a,a,b) + C(b,b,b), in B(a,a) + B(b,b), and in
	 * B(a,a) - B(b,b) and 2 B(a,b) */
	static const double cubic[4][2] = {{2.0/3.0, 0.0}, {0.0, 2.0/3.0}, {1.0/6.0, 1.0/6.0},
	                                   {1.0/6.0, -1.0/6.0}};
	static const double mean[4] = {1.0, 1.0, 0.0, 0.0}, square[4][2] = {{1.0, 0.0}, {-1.0, 0.0},
	                                                                    {0.0, 0.5}, {0.0, -0.5}};
	int m = w->m;
	double *second = w->form, *third = w->form + m;

	for (int i = 0; i < m; i++)
		w->value[i] = w->r[i] = w->s[i] = 0.0;
	for (int k = 0; k < 4; k++) {
		for (int i = 0; i < m; i++)
			w->sum[i] = of[k][0]*creal(w->q[i]) + of[k][1]*cimag(w->q[i]);
		differentiate(w, second, third, w->sum);
		for (int i = 0; i < m; i++) {
			w->value[i] += (cubic[k][0] + I*cubic[k][1])*third[i];
			w->r[i] += mean[k]*second[i];
			w->s[i] += (square[k][0] + I*square[k][1])*second[i];
		}
	}
}

static double torus_form(struct work *w, double complex mu)
{
	torus_forms(w);
	if (solve(w, w->r, 1.0) || solve(w, w->s, mu*mu))
		return NAN;
	add_mixed(w, w->value, 2.0, w->q, 0, w->r, 0);
	add_mixed(w, w->value, 2.0*I, w->q, 1, w->r, 0);
	add_mixed(w, w->value, 1.0, w->q, 0, w->s, 0);
	add_mixed(w, w->value, 1.0, w->q, 1, w->s, 1);
	add_mixed(w, w->value, I, w->q, 0, w->s, 1);
	add_mixed(w, w->value, -I, w->q, 1, w->s, 0);
	return creal(conj(mu)*project(w, w->value))/2.0;
}

/* The distance of the differences is halved; where two results are nearest to each other is the best
 * one, between truncation and round-off. */
static void search(struct hawser_normal_form *form, struct work *w, double complex mu)
{
	double before = NAN, least = INFINITY;
	int worse = 0;

	w->t = 0.25*w->size;
	for (int k = 0; k < SHRINKS && worse < 4; k++, w->t *= SHRINK) {
		double c = form->kind == HAWSER_TORUS ? torus_form(w, mu) : real_form(w, form->kind);
		double change = fabs(c - before);

		worse += isfinite(least) && !(change < least);
		if (change < least) {
			form->c = c;
			least = change;
			worse = 0;
		}
		before = c;
	}
	form->error = SAFETY*least;
}

static enum hawser_status decide(struct hawser_normal_form *form, double complex mu,
                                 struct hawser_report *report)
{
	double third = cabs(mu*mu*mu - 1.0), fourth = cabs(mu*mu*mu*mu - 1.0);

	if (form->kind == HAWSER_TORUS && fmin(third, fourth) < RESONANT)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "orbit",
		                    "no normal form: the torus point is a 1:%d resonance, which has "
		                    "another one", third < fourth ? 3 : 4);
	if (!isfinite(form->error) || (form->kind != HAWSER_FOLD && !(form->error < UNSURE*fabs(form->c))))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "orbit",
		                    "no normal form: its coefficient %.3g has the error %.1g; the forces may "
		                    "have kinks, or the coefficient is 0", form->c, form->error);
	if (form->kind != HAWSER_FOLD)
		form->decided = (form->kind == HAWSER_TORUS ? -form->c : form->c) > 0.0 ? 1 : -1;
	return HAWSER_OK;
}

enum hawser_status hawser_normal_form(struct hawser_normal_form *form, const struct hawser_rom *rom,
                                      const double *state, double omega, int period,
                                      enum hawser_event_kind kind, struct hawser_report *report)
{
	enum hawser_status status;
	double complex mu = 0.0;
	struct work w;

	*form = (struct hawser_normal_form){.kind = kind};
	if ((kind != HAWSER_FOLD && kind != HAWSER_PERIOD_DOUBLING && kind != HAWSER_TORUS) || period < 1 ||
	    !(omega > 0.0) || rom->ramp || rom->history)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "orbit",
		                    "a normal form is that of a fold, a period doubling or a torus point of a "
		                    "motion with a period");
	status = prepare(&w, rom, state, omega, period, report);
	if (!status && set_steps(&w, period))
		status = hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "orbit",
		                      "no normal form: a period takes more than %d steps", MOST_STEPS);
	if (!status && (form->distance = find_vectors(&mu, &w, kind)) < 0.0)
		status = hawser__no_memory(report, "orbit");
	if (!status && !(form->distance <= NEAR))
		status = hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "orbit",
		                      "no normal form: the multiplier that belongs to the %s is off its "
		                      "place by %.1g", hawser_event_name(kind), form->distance);
	if (!status) {
		form->angle = kind == HAWSER_TORUS ? carg(mu) : 0.0;
		search(form, &w, mu);
		status = decide(form, mu, report);
	}
	release(&w);
	return status;
}
