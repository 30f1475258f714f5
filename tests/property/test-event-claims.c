/* What located events claim, by another route: the period map of the event's orbit by Runge and Kutta's
 * formula on a fine mesh, and its eigenvalues. The model of ten coordinates has a period doubling and a
 * torus point 1.8e-4 apart, between which the number of unstable multipliers changes as by the doubling
 * alone: 5, 6, 4. Found by a user; the places agree with other steps along the same curve.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <complex.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include <hawser/frf.h>

#include "tests/tap.h"

enum { N = 10, M = 2*N, STEPS = 3000 };

static struct hawser_rom rom;
static struct hawser_report report;

/* Beside the two events. */
static const double omega = 1.1722443503249422;
static const double start[M] = {
	-1.866740127768046, -0.23663238516239565, -0.06211915435818362, 1.2593720650933413,
	-0.8169382930069541, -0.813080606851264, -0.0018097947063125867, -0.02354870964133378,
	-0.04271764399279184, 0.09218489928330659, 2.210314501462002, 0.16786692321403898,
	-0.479655397009412, 0.2153564791005659, -0.4663138151885947, 0.02708060448363569,
	0.16085499999906286, -0.10244187998489805, 0.028407881218289494, -0.40109038237723704};

/* Derivative by the phase of the state and of M neighbours, x [M + 1][M]. */
static void slope(double *dx, const double *x, double tau, double at)
{
	double a[N], by_u[N*N], by_v[N*N], by_omega[N];

	hawser_rom_acceleration_jacobian(&rom, a, by_u, by_v, by_omega, x, x + N, tau, at);
	for (int j = 0; j < N; j++) {
		dx[j] = x[N + j]/at;
		dx[N + j] = a[j]/at;
	}
	for (int c = 1; c <= M; c++)
		for (int j = 0; j < N; j++) {
			const double *y = x + (size_t)c*M;
			double sum = 0.0;

			for (int k = 0; k < N; k++)
				sum += by_u[j*N + k]*y[k] + by_v[j*N + k]*y[N + k];
			dx[c*M + j] = y[N + j]/at;
			dx[c*M + N + j] = sum/at;
		}
}

/* Multipliers of the motion from `state`; returns its distance from its start after a period. */
static double multipliers(double complex *mu, const double *state, double at)
{
	static double x[(M + 1)*M], y[(M + 1)*M], d[4][(M + 1)*M];
	static const double part[] = {0.5, 0.5, 1.0};
	double h = 2.0*M_PI/STEPS, gap = 0.0, re[M], im[M];

	memset(x, 0, sizeof x);
	memcpy(x, state, M*sizeof *x);
	for (int i = 0; i < M; i++)
		x[(i + 1)*M + i] = 1.0;
	for (int s = 0; s < STEPS; s++) {
		slope(d[0], x, s*h, at);
		for (int k = 1; k < 4; k++) {
			for (int i = 0; i < (M + 1)*M; i++)
				y[i] = x[i] + part[k - 1]*h*d[k - 1][i];
			slope(d[k], y, (s + part[k - 1])*h, at);
		}
		for (int i = 0; i < (M + 1)*M; i++)
			x[i] += h/6.0*(d[0][i] + 2.0*d[1][i] + 2.0*d[2][i] + d[3][i]);
	}
	for (int i = 0; i < M; i++)
		gap = fmax(gap, fabs(x[i] - state[i]));
	if (LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', M, x + M, M, re, im, NULL, M, NULL, M))
		return INFINITY;
	for (int i = 0; i < M; i++)
		mu[i] = re[i] + I*im[i];
	return gap;
}

/* Distance of the nearest multiplier from what the event claims. */
static double claim(const struct hawser_frf_event *event, const double complex *mu)
{
	double least = INFINITY;

	for (int i = 0; i < M; i++) {
		int complex_one = fabs(cimag(mu[i])) > 1e-3;

		if (event->kind == HAWSER_TORUS && complex_one)
			least = fmin(least, fabs(cabs(mu[i]) - 1.0));
		else if (event->kind != HAWSER_TORUS)
			least = fmin(least, cabs(mu[i] + (event->kind == HAWSER_PERIOD_DOUBLING ? 1.0 : -1.0)));
	}
	return least;
}

int main(void)
{
	struct hawser_frf_options options = {.method = "shooting", .from = 2.3, .to = 1.145, .begin = omega,
		.start = start, .samples = HAWSER_NONE};
	struct hawser_frf frf;
	const char *source = getenv("SRCDIR");
	char path[4096];
	int doubling = 0, torus = 0;

	snprintf(path, sizeof path, "%s/tests/reference/torus-as-doubling.json", source ? source : ".");
	if (!ok(!hawser_rom_open(&rom, path, &report) && !hawser_frf_trace(&frf, &rom, &options, &report),
	        "traced %s", report.message))
		return done_testing();
	for (int e = 0; e < frf.events; e++) {
		const struct hawser_frf_event *event = &frf.event[e];
		double complex mu[M];
		double gap = multipliers(mu, frf.event_state + (size_t)e*M, event->omega);

		ok(gap < 1e-6 && claim(event, mu) < 1e-5 && !event->suspected,
		   "%s at %.9g: its orbit closes to %.1e, and its multiplier is off by %.1e",
		   hawser_event_name(event->kind), event->omega, gap, claim(event, mu));
		doubling += event->kind == HAWSER_PERIOD_DOUBLING && fabs(event->omega - 1.15125107) < 1e-8;
		torus += event->kind == HAWSER_TORUS && fabs(event->omega - 1.15107084) < 1e-8;
	}
	ok(doubling == 1 && torus == 1, "the period doubling beside the torus point, once each");
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	return done_testing();
}
