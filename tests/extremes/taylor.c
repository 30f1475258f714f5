/* tests/extremes/taylor.c - motions of a model by Taylor series.
 *
 *   u[j][k]     Taylor coefficients about the start of the step
 *   p[j,l][k]   Taylor coefficients of the product u_j u_l, j <= l, at l(l+1)/2 + j
 *   wave[h][k]  Taylor coefficients of the cosine or sine of the phase of harmonic h
 *
 * The step is the one at which the last two terms fall below the round-off (Jorba and Zou 2005).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/extremes/taylor.h"

enum { ORDER = 30, SERIES = ORDER + 2 };
#define ROUND_OFF 1e-20L
#define ESCAPED 1e30L

struct taylor {
	const struct hawser_rom *rom;
	int n, *wanted; /* [pairs] products that are */
	long limit;
	long double *u, *p, *wave, *turned, *spare;
};

static int pair(int j, int l)
{
	return j <= l ? l*(l + 1)/2 + j : j*(j + 1)/2 + l;
}

void taylor_free(struct taylor *taylor)
{
	if (!taylor)
		return;
	free(taylor->wanted);
	free(taylor->u);
	free(taylor->p);
	free(taylor->wave);
	free(taylor->turned);
	free(taylor->spare);
	free(taylor);
}

struct taylor *taylor_new(const struct hawser_rom *rom)
{
	struct taylor *taylor = calloc(1, sizeof *taylor);
	size_t n = (size_t)rom->n, pairs = n*(n + 1)/2, waves = (size_t)rom->harmonics + 1;

	if (!taylor)
		return NULL;
	*taylor = (struct taylor){.rom = rom, .n = rom->n, .limit = 2000000};
	taylor->wanted = calloc(pairs, sizeof *taylor->wanted);
	taylor->u = calloc(n*SERIES, sizeof(long double));
	taylor->p = calloc(pairs*SERIES, sizeof(long double));
	taylor->wave = calloc(waves*SERIES, sizeof(long double));
	taylor->turned = calloc(waves*SERIES, sizeof(long double));
	taylor->spare = calloc(16*n*n + 16*n, sizeof(long double));
	if (!taylor->wanted || !taylor->u || !taylor->p || !taylor->wave || !taylor->turned ||
	    !taylor->spare) {
		taylor_free(taylor);
		return NULL;
	}
	for (int i = 0; i < rom->quads; i++)
		taylor->wanted[pair(rom->Q[i].k, rom->Q[i].l)] = 1;
	for (int i = 0; i < rom->cubics; i++)
		taylor->wanted[pair(rom->C[i].k, rom->C[i].l)] = 1;
	return taylor;
}

void taylor_limit(struct taylor *taylor, long steps)
{
	taylor->limit = steps;
}

/* Coefficient k of a b. */
static long double product(const long double *a, const long double *b, int k)
{
	long double sum = 0.0L;

	for (int i = 0; i <= k; i++)
		sum += a[i]*b[k - i];
	return sum;
}

/* Phases: cos and sin, turned is the other one with its sign, so that wave' = w turned. */
static void waves(struct taylor *taylor, long double omega, long double t)
{
	for (int h = 0; h < taylor->rom->harmonics; h++) {
		const struct hawser_harmonic *harmonic = &taylor->rom->harmonic[h];
		long double w = harmonic->k*omega, *a = taylor->wave + h*SERIES;
		long double *b = taylor->turned + h*SERIES;
		int cosine = harmonic->phase == HAWSER_COS;

		a[0] = cosine ? cosl(w*t) : sinl(w*t);
		b[0] = cosine ? -sinl(w*t) : cosl(w*t);
		for (int k = 0; k < ORDER; k++) {
			a[k + 1] = w*b[k]/(k + 1);
			b[k + 1] = -w*a[k]/(k + 1);
		}
	}
}

/* Coefficient k of (K u + D u')_j with the matrices given; either may be NULL. */
static long double linear(const struct taylor *taylor, const double *K, const double *D, int j, int k)
{
	long double sum = 0.0L;
	int n = taylor->n;

	for (int l = 0; l < n; l++) {
		const long double *u = taylor->u + l*SERIES;

		if (K)
			sum += K[j*n + l]*u[k];
		if (D)
			sum += D[j*n + l]*(k + 1)*u[k + 1];
	}
	return sum;
}

/* acceleration[j], coefficient k, of what harmonic h does: a convolution with its wave. */
static long double excitation(const struct taylor *taylor, int h, int j, int k, long double omega)
{
	const struct hawser_harmonic *harmonic = &taylor->rom->harmonic[h];
	const long double *wave = taylor->wave + h*SERIES;
	long double sum = harmonic->f ? harmonic->f[j]*wave[k] : 0.0L;

	for (int i = 0; (harmonic->K || harmonic->D) && i <= k; i++)
		sum -= wave[k - i]*linear(taylor, harmonic->K, harmonic->D, j, i);
	return sum*powl(omega, harmonic->omega_power);
}

static void series(struct taylor *taylor, long double omega)
{
	const struct hawser_rom *rom = taylor->rom;
	int n = taylor->n;
	long double *acceleration = taylor->spare;

	for (int k = 0; k < ORDER; k++) {
		for (int l = 0, at = 0; l < n; l++)
			for (int j = 0; j <= l; j++, at++)
				if (taylor->wanted[at])
					taylor->p[at*SERIES + k] = product(taylor->u + j*SERIES,
					                                   taylor->u + l*SERIES, k);
		for (int j = 0; j < n; j++) {
			acceleration[j] = -linear(taylor, rom->K, rom->D, j, k);
			for (int h = 0; h < rom->harmonics; h++)
				acceleration[j] += excitation(taylor, h, j, k, omega);
		}
		for (int i = 0; i < rom->quads; i++)
			acceleration[rom->Q[i].j] -= rom->Q[i].value*
				taylor->p[pair(rom->Q[i].k, rom->Q[i].l)*SERIES + k];
		for (int i = 0; i < rom->cubics; i++)
			acceleration[rom->C[i].j] -= rom->C[i].value*
				product(taylor->p + pair(rom->C[i].k, rom->C[i].l)*SERIES,
				        taylor->u + rom->C[i].m*SERIES, k);
		for (int j = 0; j < n; j++)
			taylor->u[j*SERIES + k + 2] = acceleration[j]/((k + 1)*(k + 2));
	}
}

/* The largest coefficient k. */
static long double norm(const struct taylor *taylor, int k)
{
	long double most = 0.0L;

	for (int j = 0; j < taylor->n; j++)
		most = fmaxl(most, fabsl(taylor->u[j*SERIES + k]));
	return most;
}

/* Relative to the first four terms at the step's own length: a motion that passes zero has its size in
 * its velocity. The iteration converges like 0.1^i. */
static long double step_length(const struct taylor *taylor)
{
	long double h = 1.0L;

	for (int i = 0; i < 5; i++) {
		long double size = 0.0L, power = 1.0L, next = INFINITY;

		for (int k = 0; k < 4; k++, power *= h)
			size = fmaxl(size, norm(taylor, k)*power);
		for (int k = ORDER; k <= ORDER + 1; k++) {
			long double last = norm(taylor, k);

			if (last > 0.0L)
				next = fminl(next, powl(ROUND_OFF*size/last, 1.0L/k));
		}
		h = next;
		if (isinf(h))
			break;
	}
	return 0.8L*h;
}

/* The polynomial, its first or its second derivative. */
static long double value(const long double *u, long double t, int derivative)
{
	long double sum = 0.0L;

	for (int k = ORDER + 1; k >= derivative; k--)
		sum = sum*t + u[k]*(derivative > 0 ? k : 1)*(derivative > 1 ? k - 1 : 1);
	return sum;
}

/* Largest of |u| over 0 to h: samples, and where the velocity changes its sign a secant to its zero. */
static void note_most(double *most, const long double *u, long double h)
{
	enum { SAMPLES = 16 };
	long double before = u[1];

	*most = fmax(*most, fabs((double)value(u, h, 0)));
	for (int i = 1; i <= SAMPLES; i++) {
		long double a = h*(i - 1)/SAMPLES, b = h*i/SAMPLES, now = value(u, b, 1), t = b;

		if (before*now < 0.0L) {
			t = a + (b - a)*before/(before - now);
			for (int k = 0; k < 5; k++)
				t -= value(u, t, 1)/value(u, t, 2);
			if (t >= a && t <= b)
				*most = fmax(*most, fabs((double)value(u, t, 0)));
		}
		before = now;
	}
}

int taylor_move(struct taylor *taylor, long double *x, double *most, double omega, long double t,
                long double until)
{
	int n = taylor->n;

	for (int j = 0; most && j < n; j++)
		most[j] = 0.0;
	for (long i = 0; t < until; i++) {
		long double h;

		for (int j = 0; j < n; j++) {
			taylor->u[j*SERIES] = x[j];
			taylor->u[j*SERIES + 1] = x[n + j];
		}
		waves(taylor, omega, t);
		series(taylor, omega);
		h = fminl(step_length(taylor), until - t);
		if (i >= taylor->limit || !(h > 0.0L) || !(norm(taylor, 0) < ESCAPED))
			return 1;
		for (int j = 0; j < n; j++) {
			const long double *u = taylor->u + j*SERIES;
			long double a = 0.0L, b = 0.0L;

			for (int k = ORDER + 1; k >= 1; k--) {
				a = a*h + u[k];
				b = b*h + k*u[k];
			}
			if (most)
				note_most(&most[j], u, h);
			x[j] = u[0] + a*h;
			x[n + j] = b;
		}
		t += h;
	}
	return 0;
}

int taylor_derivative(struct taylor *taylor, long double *M, long double *by_omega,
                      const long double *x, double omega, double periods, double size)
{
	int n = taylor->n, m = 2*n, failed = 0;
	long double *low = taylor->spare + n, *high = low + m;
	long double period = 2.0L*acosl(-1.0L)/omega;

	for (int k = 0; k < m && !failed; k++) {
		/* an eighth of the digits: the error of a central difference is the square of it */
		long double h = 3e-7L*size*(k < n ? 1.0 : fmax(1.0, omega));

		memcpy(low, x, (size_t)m*sizeof *low);
		memcpy(high, x, (size_t)m*sizeof *low);
		low[k] -= h;
		high[k] += h;
		failed = taylor_move(taylor, low, NULL, omega, 0.0L, periods*period) ||
		         taylor_move(taylor, high, NULL, omega, 0.0L, periods*period);
		for (int j = 0; j < m; j++)
			M[j*m + k] = (high[j] - low[j])/(2.0L*h);
	}
	if (by_omega && !failed) {
		double up = omega*(1.0 + 1e-7), down = omega*(1.0 - 1e-7);

		memcpy(low, x, (size_t)m*sizeof *low);
		memcpy(high, x, (size_t)m*sizeof *low);
		failed = taylor_move(taylor, low, NULL, down, 0.0L, periods*2.0L*acosl(-1.0L)/down) ||
		         taylor_move(taylor, high, NULL, up, 0.0L, periods*2.0L*acosl(-1.0L)/up);
		for (int j = 0; j < m; j++)
			by_omega[j] = (high[j] - low[j])/((long double)up - down);
	}
	return failed;
}

int taylor_solve(long double *A, long double *b, int m)
{
	for (int k = 0; k < m; k++) {
		int pivot = k;

		for (int i = k + 1; i < m; i++)
			pivot = fabsl(A[i*m + k]) > fabsl(A[pivot*m + k]) ? i : pivot;
		if (!(fabsl(A[pivot*m + k]) > 0.0L))
			return 1;
		for (int j = 0; pivot != k && j < m; j++) {
			long double keep = A[k*m + j];

			A[k*m + j] = A[pivot*m + j];
			A[pivot*m + j] = keep;
		}
		if (pivot != k) {
			long double keep = b[k];

			b[k] = b[pivot];
			b[pivot] = keep;
		}
		for (int i = k + 1; i < m; i++) {
			long double part = A[i*m + k]/A[k*m + k];

			for (int j = k; j < m; j++)
				A[i*m + j] -= part*A[k*m + j];
			b[i] -= part*b[k];
		}
	}
	for (int k = m - 1; k >= 0; k--) {
		for (int j = k + 1; j < m; j++)
			b[k] -= A[k*m + j]*b[j];
		b[k] /= A[k*m + k];
	}
	return 0;
}

static double size_of(const long double *x, int n, double omega)
{
	long double size = 0.0L;

	for (int j = 0; j < n; j++)
		size = fmaxl(size, fmaxl(fabsl(x[j]), fabsl(x[n + j])/fmax(1.0, omega)));
	return size > 0.0L ? (double)size : 1.0;
}

/* Newton's method, the derivative of the first orbit and again where it contracts badly. */
int taylor_orbit(struct taylor *taylor, long double *x, long double *M, long double *along,
                 double *most, double omega)
{
	int n = taylor->n, m = 2*n;
	long double period = 2.0L*acosl(-1.0L)/omega, before = INFINITY;
	long double *A = taylor->spare + 8*n, *d = A + m*m, *N = d + m, *by = N + m*m;
	int good = 0;

	for (int i = 0; i < 12 && !good; i++) {
		double size = size_of(x, n, omega);
		long double length = 0.0L;

		if (taylor_derivative(taylor, N, along ? by : NULL, x, omega, 1.0, size))
			return 1;
		memcpy(d, x, (size_t)m*sizeof *d);
		if (taylor_move(taylor, d, NULL, omega, 0.0L, period))
			return 1;
		for (int j = 0; j < m; j++)
			d[j] -= x[j];
		for (int j = 0; j < m*m; j++)
			A[j] = (j%(m + 1) == 0) - N[j];
		if (taylor_solve(A, d, m))
			return 1;
		for (int j = 0; j < m; j++) {
			x[j] += d[j];
			length = fmaxl(length, fabsl(d[j])/(size*(j < n ? 1.0 : fmax(1.0, omega))));
		}
		good = length < 1e-15L || (i > 2 && length < 1e-11L && length > 0.1L*before);
		before = length;
	}
	if (good && along) {
		for (int j = 0; j < m*m; j++)
			A[j] = (j%(m + 1) == 0) - N[j];
		memcpy(along, by, (size_t)m*sizeof *by);
		good = !taylor_solve(A, along, m);
	}
	if (good && M)
		memcpy(M, N, (size_t)(m*m)*sizeof *M);
	if (good && most) {
		memcpy(d, x, (size_t)m*sizeof *d);
		good = !taylor_move(taylor, d, most, omega, 0.0L, period);
	}
	return !good;
}

double taylor_size(struct taylor *taylor, const long double *x, double omega)
{
	enum { SAMPLES = 48 };
	int m = 2*taylor->n;
	long double *at = taylor->spare + 8*taylor->n, sum = 0.0L, period = 2.0L*acosl(-1.0L)/omega;

	memcpy(at, x, (size_t)m*sizeof *at);
	for (int i = 0; i < SAMPLES; i++) {
		for (int j = 0; j < m; j++)
			sum += at[j]*at[j]/SAMPLES;
		if (taylor_move(taylor, at, NULL, omega, period*i/SAMPLES, period*(i + 1)/SAMPLES))
			return NAN;
	}
	return (double)sqrtl(sum);
}
