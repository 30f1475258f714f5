/* water/near.c - the waves near places (water/near.h).
 *
 * u - i v is an analytic function W of z = s + i y, s along the waves: linear waves have neither
 * divergence nor rotation. So W at a place that moves little is its Taylor series about a point near
 * by. In time it is interpolated between instants at which W, W_t and W_tt are known (the polynomial
 * of fifth order), which also gives the acceleration. One component is, with A = a omega C and
 * B = a omega S,
 *
 *     X = A cos q - i B sin q,  Y = B cos q - i A sin q:  W = X,  dX/dz = -i k Y,  dX/dt = i omega Y
 *
 * and the same with X and Y exchanged. The elevation is the real part of such a function with
 * A = B = a, for real z. The direct sum costs a sine, a cosine and two exponentials for each
 * component, place and iteration of a step (`bench/waves` has the times).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "water/near.h"

enum {
	ORDERS = 4, /* of the series in space: 1, z, z^2, z^3 */
	RATES = 3   /* W, W_t, W_tt */
};

/* Error of the series at its radius, over the standard deviation of the function. */
static const double SERIES = 1e-5;
/* Components are left out at the end of the list while all of them have less than this part of it. */
static const double LEAST = 1e-6;
/* Phase (rad) of the shortest wave between two instants: the error of the interpolation is its sixth
 * power over 46080, 6e-6 of that wave. */
static const double PHASE = 0.8;

struct term {
	double cosine, sine; /* of k s + phase at the point */
	double A, B;
};
struct series {
	double complex point;
	double radius;
	long instant;     /* of the first of both; LONG_MIN: none is known */
	int used;         /* terms */
	struct term *term; /* [count of the waves] */
	double complex at[2][RATES][ORDERS]; /* derivatives by z over factorials */
};
struct turn {
	double cosine, sine;
};
struct hawser__near {
	const struct hawser_waves *waves;
	double step;            /* s, between instants */
	long turned[2];         /* instants of */
	struct turn *turn[2];   /* [count] cosine and sine of omega t */
	struct series *series;  /* [places][2] of the flow and of the elevation */
	struct term *term;
};

void hawser__near_free(struct hawser__near *near)
{
	if (near == NULL)
		return;
	free(near->turn[0]);
	free(near->turn[1]);
	free(near->series);
	free(near->term);
	free(near);
}

enum hawser_status hawser__near_open(struct hawser__near **near, const struct hawser_waves *waves,
                                     int places, struct hawser_report *report)
{
	struct hawser__near *new = calloc(1, sizeof *new);
	size_t count = (size_t)waves->count, all = 2*(size_t)places;

	*near = NULL;
	if (new == NULL)
		return hawser__no_memory(report, "waves");
	new->waves = waves;
	new->step = PHASE/waves->wave[count - 1].omega;
	new->turned[0] = new->turned[1] = LONG_MIN;
	new->series = calloc(all + !all, sizeof *new->series);
	new->term = malloc((all + !all)*count*sizeof *new->term);
	for (int i = 0; i < 2; i++)
		new->turn[i] = malloc(count*sizeof *new->turn[i]);
	if (!new->series || !new->term || !new->turn[0] || !new->turn[1]) {
		hawser__near_free(new);
		return hawser__no_memory(report, "waves");
	}
	for (size_t i = 0; i < all; i++) {
		new->series[i].term = new->term + i*count;
		new->series[i].radius = -1.0;
	}
	*near = new;
	return HAWSER_OK;
}

/* Begin a series about this point, unless it holds there; elevation: that of the elevation. */
static void begin(struct series *series, const struct hawser_waves *waves, double complex point,
                  int elevation)
{
	double sum = 0.0, fourth = 0.0, rest = 0.0;

	if (cabs(point - series->point) <= series->radius)
		return;
	series->point = point;
	series->instant = LONG_MIN;
	for (int j = 0; j < waves->count; j++) {
		const struct hawser_wave *wave = &waves->wave[j];
		struct hawser__profile at = {1.0, 1.0};
		double q = wave->k*creal(point) + wave->phase, rise = wave->amplitude, k4;
		struct term *term = &series->term[j];

		if (!elevation) {
			at = hawser__wave_profile(wave->k, cimag(point), waves->depth);
			rise *= wave->omega;
		}
		*term = (struct term){cos(q), sin(q), rise*at.C, rise*at.S};
		k4 = wave->k*wave->k*wave->k*wave->k*term->A;
		sum += term->A*term->A;
		fourth += k4*k4;
	}
	for (series->used = waves->count; series->used > 1; series->used--) {
		double A = series->term[series->used - 1].A;

		if ((rest += A*A) > LEAST*LEAST*sum)
			break;
	}
	series->radius = pow(24.0*SERIES*sqrt(sum/fourth), 0.25);
}

static const struct turn *turns(struct hawser__near *near, long instant)
{
	int i = (int)(instant & 1);

	for (int j = 0; near->turned[i] != instant && j < near->waves->count; j++) {
		double angle = near->waves->wave[j].omega*near->step*(double)instant;

		near->turn[i][j] = (struct turn){cos(angle), sin(angle)};
	}
	near->turned[i] = instant;
	return near->turn[i];
}

/* The series at an instant: sums of k^n omega^m times X or Y, then their factors (-i)^n i^m/n!. */
static void sum(double complex at[RATES][ORDERS], const struct series *series,
                const struct hawser_wave *wave, const struct turn *turn)
{
	static const double factorial[ORDERS] = {1.0, 1.0, 2.0, 6.0};
	double re[RATES][ORDERS] = {{0.0}}, im[RATES][ORDERS] = {{0.0}};

	for (int j = 0; j < series->used; j++) {
		const struct term *t = &series->term[j];
		double cosine = t->cosine*turn[j].cosine + t->sine*turn[j].sine;
		double sine = t->cosine*turn[j].sine - t->sine*turn[j].cosine;
		double X[2] = {t->A*cosine, t->B*sine}, Y[2] = {t->B*cosine, t->A*sine};
		double omega = wave[j].omega, k = wave[j].k;
		double odd = k*k, even[RATES] = {1.0, omega, omega*omega};

		for (int m = 0; m < RATES; m++) {
			const double *P = m & 1 ? Y : X, *Q = m & 1 ? X : Y;
			double f = even[m], g = f*k;

			re[m][0] += f*P[0];
			im[m][0] += f*P[1];
			re[m][1] += g*Q[0];
			im[m][1] += g*Q[1];
			re[m][2] += f*odd*P[0];
			im[m][2] += f*odd*P[1];
			re[m][3] += g*odd*Q[0];
			im[m][3] += g*odd*Q[1];
		}
	}
	for (int m = 0; m < RATES; m++)
		for (int n = 0; n < ORDERS; n++) {
			static const double complex power[4] = {1.0, I, -1.0, -I};

			at[m][n] = power[(m + 3*n) & 3]*(re[m][n] + I*im[m][n])/factorial[n];
		}
}

/* W and W_t at this displacement from the point and, on the tangent, `beyond` it; a part q of the step
 * after its instant. */
static void between(double complex value[2], const struct series *series, double complex z,
                    double complex beyond, double q, double step)
{
	double complex f[2][RATES], a, b, c, d;

	for (int e = 0; e < 2; e++) {
		for (int m = 0; m < RATES; m++) {
			const double complex *s = series->at[e][m];

			f[e][m] = s[0] + z*(s[1] + z*(s[2] + z*s[3])) +
			          beyond*(s[1] + z*(2.0*s[2] + z*3.0*s[3]));
		}
		f[e][1] *= step;
		f[e][2] *= 0.5*step*step;
	}
	/* f0 + f0' q + f0'' q^2/2 + q^3 (b + c q + d q^2): what is left at q = 1 */
	a = f[1][0] - f[0][0] - f[0][1] - f[0][2];
	b = f[1][1] - f[0][1] - 2.0*f[0][2];
	c = f[1][2] - f[0][2];
	d = 6.0*a - 3.0*b + c;
	c = -15.0*a + 7.0*b - 2.0*c;
	b = a - c - d;
	value[0] = f[0][0] + q*(f[0][1] + q*(f[0][2] + q*(b + q*(c + q*d))));
	value[1] = (f[0][1] + q*(2.0*f[0][2] + q*(3.0*b + q*(4.0*c + q*5.0*d))))/step;
}

/* W and W_t of a series at a point and on the tangent beyond it, at a time. */
static void value(double complex value[2], struct series *series, struct hawser__near *near,
                  double complex z, double complex beyond, double t)
{
	double first = floor(t/near->step);
	long instant = (long)first;
	int next = series->instant != LONG_MIN && instant == series->instant + 1;

	if (next)
		memcpy(series->at[0], series->at[1], sizeof series->at[0]);
	for (int e = next; instant != series->instant && e < 2; e++)
		sum(series->at[e], series, near->waves->wave, turns(near, instant + e));
	series->instant = instant;
	between(value, series, z - series->point, beyond, t/near->step - first, near->step);
}

void hawser__near_at(struct hawser_wave_flow *flow, struct hawser__near *near, int place,
                     const double x[3], double t)
{
	const struct hawser_waves *waves = near->waves;
	struct series *series = &near->series[2*place];
	double s = waves->along[0]*x[0] + waves->along[1]*x[2], rate, beyond;
	double complex W[2], z = s;

	begin(&series[1], waves, z, 1);
	value(W, &series[1], near, z, 0.0, t);
	flow->elevation = hawser__wave_growth(&rate, waves, t)*creal(W[0]);
	z += I*hawser__wave_height(&beyond, waves, x[1] - waves->surface, flow->elevation);
	begin(series, waves, z, 0);
	value(W, series, near, z, I*beyond, t);
	hawser__wave_flow(flow, waves, (const double [2]){creal(W[0]), -cimag(W[0])},
	                  (const double [2]){creal(W[1]), -cimag(W[1])}, t);
}
