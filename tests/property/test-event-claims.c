/* What located events claim, by another route: the period map of the event's orbit by Runge and Kutta's
 * formula on a fine mesh, and its eigenvalues. Two models in which users found wrong events:
 *
 *    torus-as-doubling   ten coordinates; a period doubling and a torus point 1.8e-4 apart, between
 *                        which the number of unstable multipliers changes as by the doubling alone:
 *                        5, 6, 4
 *    beam-1to3           six modes of a beam; a torus point beside which the moduli are within their
 *                        error over several steps, the more of them, the smaller the steps are
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

#include <hawser/frf.h>

#include "tests/tap.h"

enum { MOST = 20, STEPS = 2000 }; /* states; steps of a period */

static struct hawser_rom rom;

/* Derivative by the phase of the state and of m neighbours, x [m + 1][m]. */
static void slope(double *dx, const double *x, double tau, double at)
{
	double a[MOST], by_u[MOST*MOST], by_v[MOST*MOST], by_omega[MOST];
	int n = rom.n, m = 2*n;

	hawser_rom_acceleration_jacobian(&rom, a, by_u, by_v, by_omega, x, x + n, tau, at);
	for (int j = 0; j < n; j++) {
		dx[j] = x[n + j]/at;
		dx[n + j] = a[j]/at;
	}
	for (int c = 1; c <= m; c++)
		for (int j = 0; j < n; j++) {
			const double *y = x + c*m;
			double sum = 0.0;

			for (int k = 0; k < n; k++)
				sum += by_u[j*n + k]*y[k] + by_v[j*n + k]*y[n + k];
			dx[c*m + j] = y[n + j]/at;
			dx[c*m + n + j] = sum/at;
		}
}

/* Multipliers of the motion from `state`; returns its distance from its start after a period. */
static double multipliers(double complex *mu, const double *state, double at)
{
	static double x[(MOST + 1)*MOST], y[(MOST + 1)*MOST], d[4][(MOST + 1)*MOST];
	static const double part[] = {0.5, 0.5, 1.0};
	double h = 2.0*M_PI/STEPS, gap = 0.0, re[MOST], im[MOST];
	int m = 2*rom.n, size = (m + 1)*m;

	memset(x, 0, sizeof x);
	memcpy(x, state, (size_t)m*sizeof *x);
	for (int i = 0; i < m; i++)
		x[(i + 1)*m + i] = 1.0;
	for (int s = 0; s < STEPS; s++) {
		slope(d[0], x, s*h, at);
		for (int k = 1; k < 4; k++) {
			for (int i = 0; i < size; i++)
				y[i] = x[i] + part[k - 1]*h*d[k - 1][i];
			slope(d[k], y, (s + part[k - 1])*h, at);
		}
		for (int i = 0; i < size; i++)
			x[i] += h/6.0*(d[0][i] + 2.0*d[1][i] + 2.0*d[2][i] + d[3][i]);
	}
	for (int i = 0; i < m; i++)
		gap = fmax(gap, fabs(x[i] - state[i]));
	if (LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', m, x + m, m, re, im, NULL, m, NULL, m))
		return INFINITY;
	for (int i = 0; i < m; i++)
		mu[i] = re[i] + I*im[i];
	return gap;
}

/* Distance of the nearest multiplier from what the event claims. */
static double claim(const struct hawser_frf_event *event, const double complex *mu)
{
	double least = INFINITY;

	for (int i = 0; i < 2*rom.n; i++) {
		int complex_one = fabs(cimag(mu[i])) > 1e-3;

		if (event->kind == HAWSER_TORUS && complex_one)
			least = fmin(least, fabs(cabs(mu[i]) - 1.0));
		else if (event->kind != HAWSER_TORUS)
			least = fmin(least, cabs(mu[i] + (event->kind == HAWSER_PERIOD_DOUBLING ? 1.0 : -1.0)));
	}
	return least;
}

static int trace(struct hawser_frf *frf, const char *name, const struct hawser_frf_options *options)
{
	struct hawser_report report = {.status = HAWSER_OK};
	const char *path = source_file("tests/reference/%s", name);

	if (ok(!hawser_rom_open(&rom, path, &report) && !hawser_frf_trace(frf, &rom, options, &report),
	       "%s %s", name, report.message))
		return 1;
	hawser_rom_clear(&rom);
	return 0;
}

static void check_event(const struct hawser_frf *frf, int e, double most)
{
	const struct hawser_frf_event *event = &frf->event[e];
	double complex mu[MOST];
	double gap = multipliers(mu, frf->event_state + 2*(size_t)frf->n*(size_t)e, event->omega);

	ok(gap < 1e-6 && claim(event, mu) < most && !event->suspected,
	   "%s at %.9g: its orbit closes to %.1e, and its multiplier is off by %.1e",
	   hawser_event_name(event->kind), event->omega, gap, claim(event, mu));
}

static void two_in_a_step(void)
{
	static const double start[] = {
		-1.866740127768046, -0.23663238516239565, -0.06211915435818362, 1.2593720650933413,
		-0.8169382930069541, -0.813080606851264, -0.0018097947063125867, -0.02354870964133378,
		-0.04271764399279184, 0.09218489928330659, 2.210314501462002, 0.16786692321403898,
		-0.479655397009412, 0.2153564791005659, -0.4663138151885947, 0.02708060448363569,
		0.16085499999906286, -0.10244187998489805, 0.028407881218289494, -0.40109038237723704};
	struct hawser_frf_options options = {.method = "shooting", .from = 2.3, .to = 1.145,
		.begin = 1.1722443503249422, .start = start, .samples = HAWSER_NONE};
	struct hawser_frf frf;
	int doubling = 0, torus = 0;

	if (!trace(&frf, "torus-as-doubling.json", &options))
		return;
	for (int e = 0; e < frf.events; e++) {
		const struct hawser_frf_event *event = &frf.event[e];

		check_event(&frf, e, 1e-7);
		doubling += event->kind == HAWSER_PERIOD_DOUBLING && fabs(event->omega - 1.15125107) < 1e-8;
		torus += event->kind == HAWSER_TORUS && fabs(event->omega - 1.15107084) < 1e-8;
	}
	ok(doubling == 1 && torus == 1, "the period doubling beside the torus point, once each");
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* From one end of a short range, with at most `step` of it a step, to the one torus point in it:
 * below it the motion is unstable. */
static void small_steps(double begin, const double *start, int way, double step)
{
	struct hawser_frf_options options = {.method = "balance", .from = way > 0 ? 15.85 : 15.87,
		.to = way > 0 ? 15.87 : 15.85, .begin = begin, .start = start, .step_max = step,
		.samples = HAWSER_NONE};
	struct hawser_frf frf;

	if (!trace(&frf, "beam-1to3.json", &options))
		return;
	if (ok(frf.events == 1, "one event by steps of %g of the range", step)) {
		const struct hawser_frf_event *event = &frf.event[0];
		const struct hawser_frf_point *p = &frf.point[event->after];

		check_event(&frf, 0, 1e-8);
		ok(fabs(event->omega/15.86040439 - 1.0) < event->error + 1e-9 && event->error < 1e-8,
		   "at %.10g to %.1e", event->omega, event->error);
		ok((p[0].omega < event->omega) != (p[1].omega < event->omega) &&
		   event->unstable[way > 0] == 0 && event->unstable[way < 0] == 2,
		   "between its points, with the numbers on both sides");
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

CASE(property_event_claims)
{
	static const double below[] = {
		0.0852717638631588, -0.007166286550373236, -0.00016780227578806992, 3.904555577656096e-05,
		-1.4019985917349701e-05, 6.243581588782903e-06, 0.022350542256176005, -0.0023555543057402844,
		-0.00019958266690965574, 3.768533695683802e-05, -1.3212954230083245e-05, 5.843105997540861e-06};
	static const double above[] = {
		0.08673727645176289, -0.007072331454651223, -0.00017483178694265196,
		4.0725335920179206e-05, -1.462513909935257e-05, 6.5133311906160875e-06,
		0.022510550678965787, -0.0029813201460740573, -0.00021229850779527483,
		3.994653880629875e-05, -1.3999736793971084e-05, 6.190296215188024e-06};

	two_in_a_step();
	for (double step = 0.5; step > 0.01; step *= 0.15) {
		small_steps(15.852843055407495, below, 1, step);
		small_steps(15.868570139822397, above, -1, step);
	}
	return done_testing();
}
