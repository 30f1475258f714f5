/* The model of carriers that pass against their equations of motion, which share nothing with it: a
 * straight string on N sine functions, and point masses fixed to it that run through the span with it.
 * The equations are periodic; a Floquet exponent is the frequency.
 *
 * The model has its first frequency at that speed with the mass of the carriers at one phase, and
 * Coriolis forces of the mean mass. Smeared carriers are wrong. The sines converge slowly, with 1/N,
 * where masses are points, but for all speeds alike: the ratio to carriers at rest is compared.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <hawser/line_rom.h>

#include "tests/tap.h"

enum { N = 10, M = 2*N };

static const double L = 110.0, spacing = 36.6, mass = 400.0, rho = 4.0, apparent = 90e3;
static const double two_pi = 2.0*M_PI;

/* Mass and the right side's matrices of u' and u at the time t: rho u'' + 2 rho v u_x' + (rho v^2 - T)
 * u_xx, and the same without tension for each carrier. */
static void matrices(double m[N*N], double g[N*N], double k[N*N], double t, double v)
{
	double T = apparent + (rho + mass/spacing)*v*v;

	for (int a = 0; a < N; a++)
		for (int b = 0; b < N; b++) {
			double i = a + 1.0, j = b + 1.0, wave = j*M_PI/L;

			m[a*N + b] = a == b ? rho : 0.0;
			k[a*N + b] = a == b ? (rho*v*v - T)*wave*wave : 0.0;
			g[a*N + b] = (a + b)%2 ? -2.0*v*rho*2.0/L*wave*2.0*i*L/M_PI/(i*i - j*j) : 0.0;
		}
	for (double x = fmod(v*t, spacing); x < L; x += spacing)
		for (int a = 0; a < N; a++)
			for (int b = 0; b < N; b++) {
				double wave = (b + 1.0)*M_PI/L, here = mass*2.0/L*sin((a + 1.0)*M_PI*x/L);

				m[a*N + b] += here*sin(wave*x);
				g[a*N + b] -= 2.0*v*here*wave*cos(wave*x);
				k[a*N + b] += v*v*here*wave*wave*sin(wave*x);
			}
}

/* rate [M][M] of the states y in columns. */
static void flow(double *rate, const double *y, double t, double v)
{
	double m[N*N], g[N*N], k[N*N];
	lapack_int pivot[N];

	matrices(m, g, k, t, v);
	for (int c = 0; c < M; c++)
		for (int a = 0; a < N; a++) {
			double sum = 0.0;

			for (int b = 0; b < N; b++)
				sum += k[a*N + b]*y[b*M + c] + g[a*N + b]*y[(N + b)*M + c];
			rate[a*M + c] = y[(N + a)*M + c];
			rate[(N + a)*M + c] = sum;
		}
	(void)LAPACKE_dgesv(LAPACK_ROW_MAJOR, N, M, m, N, pivot, rate + N*M, M);
}

/* One step of the classical Runge-Kutta method. */
static void step(double *y, double t, double h, double v)
{
	static double rate[4][M*M], z[M*M];
	const double part[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0, 2.0, 2.0, 1.0};

	for (int s = 0; s < 4; s++) {
		for (int i = 0; i < M*M; i++)
			z[i] = y[i] + (s ? part[s]*h*rate[s - 1][i] : 0.0);
		flow(rate[s], z, t + part[s]*h, v);
	}
	for (int s = 0; s < 4; s++)
		for (int i = 0; i < M*M; i++)
			y[i] += h/6.0*weight[s]*rate[s][i];
}

/* The Floquet exponent next to `guess` of the multiplier that has most of the first sine. */
static double floquet(double v, double guess)
{
	enum { STEPS = 500 };
	static double y[M*M], vector[M*M], re[M], im[M];
	double period = spacing/v, best = 0.0, most = 0.0, turn = 0.0;

	for (int i = 0; i < M*M; i++)
		y[i] = i%(M + 1) == 0;
	for (int s = 0; s < STEPS; s++)
		step(y, period*s/STEPS, period/STEPS, v);
	if (LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'V', M, y, M, re, im, NULL, 1, vector, M))
		return NAN;
	for (int i = 0; i + 1 < M; i++) {
		double own = hypot(vector[i], vector[i + 1]), all = 0.0;

		for (int b = 0; b < N; b++)
			all = hypot(all, hypot(vector[b*M + i], vector[b*M + i + 1]));
		if (im[i] > 0.0 && own > most*all) {
			most = own/all;
			turn = atan2(im[i], re[i]);
		}
	}
	for (int k = 0; k < 20; k++)
		for (int sign = -1; sign <= 1; sign += 2) {
			double omega = (two_pi*k + sign*turn)/period;

			best = fabs(omega - guess) < fabs(best - guess) ? omega : best;
		}
	return best;
}

/* The same with carriers at rest, the first at x = 10 m. */
static double still(void)
{
	double m[N*N], g[N*N], k[N*N], re[N], im[N], least = INFINITY;
	lapack_int pivot[N];

	matrices(m, g, k, 10.0/1e-9, 1e-9);
	(void)LAPACKE_dgesv(LAPACK_ROW_MAJOR, N, N, m, N, pivot, k, N);
	(void)LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', N, k, N, re, im, NULL, 1, NULL, 1);
	for (int i = 0; i < N; i++)
		least = fmin(least, -re[i]);
	return sqrt(least);
}

/* First frequency of K and of Omega G of the modes in the plane. */
static double of_model(const struct hawser_rom *rom, double v, double *rest)
{
	double omega = two_pi*v/spacing*rom->time, *a, least = INFINITY;
	int n = rom->n, m = 2*n;
	double *re = calloc((size_t)m, sizeof *re), *im = calloc((size_t)m, sizeof *im);

	a = calloc((size_t)m*(size_t)m, sizeof *a);
	for (int j = 0; j < n; j++) {
		a[j*m + n + j] = 1.0;
		for (int k = 0; k < n; k++)
			a[(n + j)*m + k] = -rom->K[j*n + k];
		for (int h = 0; h < rom->harmonics; h++)
			for (int k = 0; k < n && rom->harmonic[h].D; k++)
				a[(n + j)*m + n + k] -= omega*rom->harmonic[h].D[j*n + k];
	}
	(void)LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', m, a, m, re, im, NULL, 1, NULL, 1);
	for (int i = 0; i < m; i++)
		least = im[i] > 0.0 && im[i] < least ? im[i] : least;
	*rest = sqrt(rom->K[0])/rom->time;
	free(a);
	free(re);
	free(im);
	return least/rom->time;
}

static double build(double v, int smeared, double *rest)
{
	struct hawser_line_mass body[3];
	struct hawser_line line = {.EA = 40e6, .rho = rho, .g = 1e-6, .B = {L, 0.0}, .value = apparent};
	struct hawser_line_rom_options options = {.modes = {.n = 6}, .load = HAWSER_LINE_LOAD_PASSING,
		.weight = {1.0}, .spacing = spacing, .running = {rho + mass/spacing}};
	struct hawser_line_statics st;
	const struct hawser_line_statics *lane[1] = {&st};
	struct hawser_line_modes modes;
	struct hawser_rom rom;
	struct hawser_report report = {0};
	double omega = NAN;

	for (int i = 0; i < 3; i++)
		body[i] = (struct hawser_line_mass){.S = 10.0 + spacing*i, .body = mass};
	line.mass = body;
	line.masses = smeared ? 0 : 3;
	line.rho += smeared ? mass/spacing : 0.0;
	if (!ok(!hawser_line_solve(&st, &line, &report), "statics %s", report.message))
		return NAN;
	if (ok(!hawser_line_rom_build(&rom, &modes, lane, 1, &options, &report), "model %s",
	       report.message)) {
		omega = of_model(&rom, v, rest);
		hawser_rom_clear(&rom);
		hawser_line_modes_clear(&modes);
	}
	hawser_line_statics_clear(&st);
	return omega;
}

CASE(property_line_carriers)
{
	for (int i = 0; i < 2; i++) {
		double v = i ? 10.0 : 5.0, rest, even;
		double fixed = build(v, 0, &rest), smeared = build(v, 1, &even), sines = still();
		double exact = rest*floquet(v, sines)/sines;

		printf("# %g m/s: exact %.5f rad/s; fixed and running %.5f, fixed %.5f, smeared and running "
		       "%.5f, smeared %.5f\n", v, exact, fixed, rest, smeared, even);
		close_to(fixed, exact, i ? 8e-3 : 2e-3, "carriers at a phase that run");
		ok(smeared > exact*1.015, "smeared carriers are wrong by %.1f %%", 100.0*(smeared/exact - 1.0));
	}
	return done_testing();
}
