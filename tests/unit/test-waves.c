/* Linear waves and seas: reference cases W10 and W11 of doc/water.md, dispersion by bisection, flow
 * without divergence and rotation by differences, the energy of seas, and what is refused.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/waves.h>

#include "water/near.h"

#include "tests/tap.h"

static struct hawser_waves make(const struct hawser_waves_given *given)
{
	struct hawser_report report = {0};
	struct hawser_waves waves;

	if (hawser_waves_make(&waves, given, &report) != HAWSER_OK)
		ok(0, "waves: %s", report.message);
	return waves;
}

static double bisected(double omega, double depth, double g)
{
	double a = 0.0, b = omega*omega/g + omega/sqrt(g*depth) + 1e-300;

	for (int i = 0; i < 200; i++) {
		double k = 0.5*(a + b);

		*(g*k*tanh(k*depth) < omega*omega ? &a : &b) = k;
	}
	return 0.5*(a + b);
}

static void dispersion(void)
{
	double worst = 0.0;

	for (double omega = 1.3e-4; omega < 50.0; omega *= 2.07)
		for (double depth = 0.017; depth < 1e6; depth *= 1.93) {
			double k = bisected(omega, depth, 9.71);

			worst = fmax(worst, fabs(hawser_wave_number(omega, depth, 9.71)/k - 1.0));
		}
	ok(worst < 1e-15, "dispersion: against bisection within %.1e", worst);
	ok(hawser_wave_number(2.385, INFINITY, 9.71) == 2.385*2.385/9.71, "deep water: omega^2/g");
}

/* A regular wave at its phase, against the flow at a time: all stretchings, shallow and deep water. */
static void phases(void)
{
	double worst = 0.0;

	for (int i = 0; i < 8*30; i++) {
		struct hawser_waves waves = make(&(struct hawser_waves_given){
			.height = 3.0, .period = 8.0, .depth = i%8 < 4 ? 23.0 : INFINITY, .heading = 0.7,
			.phase = 0.3, .surface = 1.5, .stretching = i%4});
		const struct hawser__regular wave = hawser__regular_wave(&waves, waves.wave->omega, 9.81);
		const double x[3] = {2.385*(i/8), 3.0 - 0.9*(i/8), -1.3*(i/8)}, t = 0.77*i;
		struct hawser__regular_flow at;
		struct hawser_wave_flow flow;

		hawser__regular_at(&at, &wave, x, waves.wave->omega*t);
		hawser_waves_at(&flow, &waves, x, t);
		worst = fmax(worst, fabs(at.elevation - flow.elevation));
		for (int k = 0; k < 3; k++)
			worst = fmax(worst, fmax(fabs(at.u[k] - flow.u[k]), fabs(at.du[k] - flow.du[k])));
		hawser_waves_clear(&waves);
	}
	ok(worst < 1e-12, "a wave at its phase: as at a time within %.1e", worst);
}

/* W10 */
static void regular(void)
{
	/* extrapolated: a omega (C + k y S) with C and S at the mean surface */
	const double k = 0.04152845, tangent = 0.6*acos(-1.0)*(1.0/tanh(50.0*k) + 2.0*k);
	const double crest[4] = {1.872789, 2.108615, 1.945164, tangent};
	struct hawser_waves waves = make(&(struct hawser_waves_given){
		.height = 6.0, .period = 10.0, .depth = 50.0, .stretching = HAWSER_STRETCH_NONE});
	struct hawser_wave_flow flow;

	close_to(waves.wave[0].k, 0.04152845, 1e-7, "W10: wave number");
	hawser_waves_at(&flow, &waves, (const double [3]){3.0, -10.0, 7.0}, 2.0);
	close_to(flow.u[0], 0.5564214, 1e-7, "W10: velocity along x");
	close_to(flow.u[1], -1.1032079, 1e-7, "W10: velocity along y");
	close_to(flow.du[0], -0.7450431, 1e-7, "W10: acceleration along x");
	close_to(flow.du[1], -0.3252666, 1e-6, "W10: acceleration along y");
	for (int i = 0; i < 4; i++) {
		waves.stretching = (enum hawser_wave_stretching)i;
		hawser_waves_at(&flow, &waves, (const double [3]){0.0, 2.0, 0.0}, 0.0);
		close_to(flow.u[0], crest[i], 3e-7, "W10: velocity in the crest, stretched");
		hawser_waves_at(&flow, &waves, (const double [3]){0.0, -60.0, 0.0}, 2.0);
		ok(flow.u[1] == 0.0, "below the bed: as at the bed, without vertical velocity");
	}
	hawser_waves_clear(&waves);
	/* very deep: as infinitely deep; a surface elsewhere, another direction */
	for (int i = 0; i < 2; i++) {
		struct hawser_wave_flow at[2];
		const double x[3] = {3.0, 4.7, -2.385};

		waves = make(&(struct hawser_waves_given){.height = 6.0, .period = 10.0, .phase = 0.3*i,
			.depth = i ? INFINITY : 1e5, .heading = 0.7, .surface = 11.0});
		hawser_waves_at(&at[i], &waves, x, 2.0 + 0.3*i*10.0/(2.0*acos(-1.0)));
		if (i)
			ok(fabs(at[1].u[0] - at[0].u[0]) < 1e-3*fabs(at[0].u[0]) && at[1].u[2]/at[1].u[0] > 0.84,
			   "at a depth of 100 km as in deep water; a phase is a time");
		hawser_waves_clear(&waves);
	}
}

/* A sea that grows: du against differences in time, divergence and rotation against differences in
 * space. */
static void differences(void)
{
	struct hawser_waves waves = make(&(struct hawser_waves_given){
		.Hs = 5.0, .Tp = 11.0, .depth = 73.0, .seed = 7, .heading = 0.4, .ramp = 18.0,
		.stretching = HAWSER_STRETCH_NONE});
	const double x[3] = {2.385, -6.1, 1.7}, h = 1e-4;
	struct hawser_wave_flow flow, up, down;
	double G[3][3], worst = 0.0, largest;

	for (double t = 4.0; t < 40.0; t += 9.3) {
		hawser_waves_at(&flow, &waves, x, t);
		hawser_waves_at(&up, &waves, x, t + h);
		hawser_waves_at(&down, &waves, x, t - h);
		for (int k = 0; k < 3; k++)
			worst = fmax(worst, fabs((up.u[k] - down.u[k])/(2.0*h) - flow.du[k]));
		for (int j = 0; j < 3; j++) {
			double at[3] = {x[0], x[1], x[2]};

			at[j] = x[j] + h;
			hawser_waves_at(&up, &waves, at, t);
			at[j] = x[j] - h;
			hawser_waves_at(&down, &waves, at, t);
			for (int k = 0; k < 3; k++)
				G[k][j] = (up.u[k] - down.u[k])/(2.0*h);
		}
		largest = fabs(G[0][0]) + fabs(G[0][1]);
		ok(fabs(G[0][0] + G[1][1] + G[2][2]) < 1e-7*largest, "no divergence at t = %g", t);
		ok(fabs(G[0][1] - G[1][0]) + fabs(G[0][2] - G[2][0]) + fabs(G[1][2] - G[2][1]) < 1e-7*largest,
		   "no rotation at t = %g", t);
	}
	ok(worst < 1e-7, "the acceleration is the change of the velocity: %.1e m/s^2", worst);
	hawser_waves_at(&flow, &waves, x, 0.0);
	ok(flow.u[0] == 0.0 && flow.elevation == 0.0, "at rest at t = 0");
	hawser_waves_clear(&waves);
}

/* W11 */
static void spectrum(void)
{
	const double turn = 2.0*acos(-1.0);
	struct hawser_jonswap S, flat;
	double m[3], variance = 0.0, dw = 2e-3, worst = 0.0;

	hawser_jonswap_of(&S, 5.0, 11.0, 3.3);
	for (int i = 0; i < 3; i++)
		m[i] = hawser_jonswap_moment(&S, i, 0.0, INFINITY);
	close_to(m[0], 25.0/16.0, 1e-14, "W11: the variance of the elevation is Hs^2/16");
	close_to(hawser_jonswap_at(&S, turn/11.0), 8.479954, 1e-7, "W11: the peak");
	close_to(turn*sqrt(m[0]/m[2]), 8.551391, 1e-7, "W11: Tz");
	close_to(turn*m[0]/m[1], 9.177607, 1e-7, "W11: T1");
	for (double w = 0.5*dw; w < 8.0; w += dw) {
		double k = hawser_wave_number(w, 100.0, 9.81), C = cosh(k*90.0)/sinh(k*100.0);

		variance += k < 5.0 ? hawser_jonswap_at(&S, w)*w*w*C*C*dw : 0.0;
	}
	close_to(sqrt(variance), 0.4990845, 1e-6, "W11: velocity 10 m below the surface");
	hawser_jonswap_of(&flat, 3.1, 7.7, 1.0);
	for (double n = 0.0; n < 4.0; n += 0.5)
		worst = fmax(worst, fabs(hawser_jonswap_moment(&flat, n, 0.0, INFINITY)/(flat.scale*
		                         pow(flat.omega_p, n + 1.0)*0.25*pow(1.25, 0.25*n - 1.0)*
		                         tgamma(1.0 - 0.25*n)) - 1.0));
	ok(worst < 1e-13, "gamma 1: moments against gamma functions within %.1e", worst);
	m[0] = hawser_jonswap_moment(&S, 0.0, 0.3, 0.55);
	m[1] = hawser_jonswap_moment(&S, 0.0, 0.55, 19.0);
	m[2] = hawser_jonswap_moment(&S, 0.0, 19.0, INFINITY);
	close_to(m[0] + m[1] + m[2], hawser_jonswap_moment(&S, 0.0, 0.3, INFINITY), 1e-13,
	         "the energy of a range is that of its parts");
}

/* The velocity of seas, by seed and depth: the variance of the elevation is exact, and the components
 * draw their frequencies, so that no two differences are alike. */
static void seas(void)
{
	for (int seed = HAWSER_NONE; seed < 4; seed++) {
		struct hawser_waves waves = make(&(struct hawser_waves_given){
			.Hs = 5.0, .Tp = 11.0, .depth = seed == 2 ? INFINITY : 100.0, .seed = seed});
		double elevation = 0.0, velocity = 0.0, least = INFINITY, most = 0.0;

		for (int i = 0; i < waves.count; i++) {
			const struct hawser_wave *wave = &waves.wave[i];
			double a2 = 0.5*wave->amplitude*wave->amplitude, k = wave->k, h = fmin(100.0, 700.0/k);
			double rise = wave->omega*cosh(k*(h - 10.0))/sinh(k*h);

			elevation += a2;
			velocity += a2*rise*rise;
			least = i ? fmin(least, wave->omega - wave[-1].omega) : least;
			most = i ? fmax(most, wave->omega - wave[-1].omega) : 0.0;
		}
		close_to(elevation, 25.0/16.0, 1e-13, "the energy of the sea");
		close_to(sqrt(velocity), 0.4990845, seed == 2 ? 5e-3 : 5e-4, "its velocity at 10 m");
		ok(seed < 0 ? most < least*(1.0 + 1e-9) : least < 0.2*most && least > 0.0,
		   "frequencies of the seed %d", seed);
		hawser_waves_clear(&waves);
	}
}

/* Places that move, and times that go back once: against the direct sum, over the standard deviations
 * of the sea at the surface, sigma and sigma omega. */
static void near(void)
{
	for (int i = 0; i < 4; i++) {
		struct hawser_waves waves = make(&(struct hawser_waves_given){
			.Hs = 3.1, .Tp = 9.7, .depth = i & 1 ? INFINITY : 61.0, .seed = i, .heading = -0.7,
			.components = 60, .surface = 1.7, .ramp = 7.0,
			.stretching = (enum hawser_wave_stretching)i});
		double omega = waves.wave[30].omega, error[3] = {0.0};
		struct hawser_report report = {0};
		struct hawser__near *places;

		if (hawser__near_open(&places, &waves, 3, &report) != HAWSER_OK) {
			ok(0, "%s", report.message);
			return;
		}
		for (int n = 0; n < 150; n++) {
			double t = 0.083*n + (n == 100 ? -5.0 : 0.0);
			const double x[3] = {400.0*(n%3) + 3.0*sin(0.57*t), 2.0*cos(t) - 25.0*(n%3), 7.0};
			struct hawser_wave_flow got, want;

			hawser__near_at(&got, places, n%3, x, t);
			hawser_waves_at(&want, &waves, x, t);
			for (int k = 0; k < 3; k++) {
				error[0] = fmax(error[0], fabs(got.u[k] - want.u[k]));
				error[1] = fmax(error[1], fabs(got.du[k] - want.du[k])/omega);
			}
			error[2] = fmax(error[2], omega*fabs(got.elevation - want.elevation));
		}
		for (int k = 0; k < 3; k++)
			error[k] /= omega*3.1/4.0;
		ok(error[0] < 5e-5 && error[1] < 5e-5 && error[2] < 5e-5,
		   "near places, stretching %d: u %.1e, du %.1e, elevation %.1e", i, error[0], error[1],
		   error[2]);
		hawser__near_free(places);
		hawser_waves_clear(&waves);
	}
}

static void refused(void)
{
	const struct hawser_waves_given given[] = {
		{.height = 2.0, .period = 9.0}, {.height = 2.0, .depth = 10.0},
		{.Hs = 2.0, .Tp = 9.0, .depth = 10.0, .gamma = 0.5}, {.Hs = 2.0, .depth = 10.0},
		{.Hs = 2.0, .Tp = 9.0, .depth = 10.0, .components = -3},
		{.height = 2.3, .period = 3.2, .depth = INFINITY},
		{.Hs = 2.0, .Tp = 9.0, .depth = 10.0, .range = {2.0, 1.0}},
		{.height = 2.0, .period = NAN, .depth = 10.0}};
	static const char *const say[] = {"depth", "period", "gamma", "Tp", "-3", "2.27 m", "rise",
	                                  "period"};

	for (size_t i = 0; i < sizeof say/sizeof *say; i++) {
		struct hawser_report report = {0};
		struct hawser_waves waves;
		enum hawser_status status = hawser_waves_make(&waves, &given[i], &report);

		ok(status == HAWSER_ERR_ARGUMENT && strstr(report.message, say[i]) && waves.wave == NULL,
		   "refused: %s", report.message);
	}
}

CASE(unit_waves)
{
	dispersion();
	phases();
	regular();
	differences();
	spectrum();
	seas();
	near();
	refused();
	return done_testing();
}
