/* A forcing whose frequency changes slowly: a linear oscillator against Duhamel's integral by Simpson's
 * rule, all integrators against each other on a nonlinear model, from any beginning, and a backward
 * sweep; the slow sweep up and down a hardening resonance jumps where frequency responses have folds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/integrate-models.h"

/* Velocity and displacement at the end, from rest at `begin`. */
static void duhamel(double state[2], const struct hawser_integrate_options *options, double damping,
                    double load)
{
	enum { INTERVALS = 200000 };
	double w = sqrt(1.0 - 0.25*damping*damping), h = (options->until - options->begin)/INTERVALS;

	state[0] = state[1] = 0.0;
	for (int i = 0; i <= INTERVALS; i++) {
		double t = options->begin + i*h, left = options->until - t;
		double share = (i == 0 || i == INTERVALS ? 1.0 : i % 2 ? 4.0 : 2.0)*h/3.0;
		struct hawser_rom_moment moment = hawser_integrate_moment(options, t);
		double force = share*load*cos(moment.tau)*exp(-0.5*damping*left);

		state[0] += force*sin(w*left)/w;
		state[1] += force*(cos(w*left) - 0.5*damping*sin(w*left)/w);
	}
}

static void linear(const char *method, double from, double to, double begin)
{
	struct hawser_rom rom = model_oscillator(0.031, 1.0, 0.0, 0.2);
	double rest[2] = {0.0, 0.0}, want[2];
	struct hawser_integrate_options options = {.omega = from, .omega_to = to, .begin = begin,
		.until = begin + 150.0, .every = 10.0, .rtol = 1e-9, .atol = 1e-12, .method = method,
		.initial = rest};
	struct hawser_trajectory run;
	const double *last;

	ok(!hawser_integrate(&run, &rom, &options, NULL), "%s: %g to %g", method, from, to);
	last = run.state + 2*(run.rows - 1);
	duhamel(want, &options, 0.031, 0.2);
	ok(fabs(last[0] - want[0]) < 1e-6 && fabs(last[1] - want[1]) < 1e-6,
	   "Duhamel's integral: %.9f %.9f against %.9f %.9f", last[0], last[1], want[0], want[1]);
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
}

/* Frequency at which the displacement of a hardening oscillator exceeds `level` for the first time
 * (last 0) or the last time (1) of a slow sweep. */
static double passes(double from, double to, double level, int last)
{
	struct hawser_rom rom = model_oscillator(0.04, 1.0, 0.7, 0.05);
	struct hawser_integrate_options options = {.omega = from, .omega_to = to, .until = 8000.0,
	                                           .every = 0.5, .rtol = 1e-7};
	struct hawser_trajectory run;
	double at = NAN;

	if (hawser_integrate(&run, &rom, &options, NULL))
		return NAN;
	for (int i = 0; i < run.rows; i++)
		if (fabs(run.state[2*i]) > level && (last || isnan(at)))
			at = hawser_integrate_moment(&options, run.time[i]).omega;
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
	return at;
}

CASE(property_integrate_swept)
{
	static const char *const method[] = {"gauss", "radau", "adams", "bdf"};
	struct hawser_rom rom = model_oscillator(0.04, 1.0, 0.7, 0.05);
	struct hawser_integrate_options options = {.omega = 0.8, .omega_to = -1.0, .until = 1.0,
	                                           .every = 0.5};
	struct hawser_trajectory run;
	double up, down;

	for (int m = 0; m < 4; m++) {
		linear(method[m], 0.6, 1.7, 0.0);
		linear(method[m], 1.4, 0.5, 37.5);
	}
	ok(hawser_integrate(&run, &rom, &options, NULL) == HAWSER_ERR_ARGUMENT, "a negative end");
	hawser_rom_clear(&rom);
	/* One harmonic of amplitude a: (1 + 3/4 c a^2 - w^2)^2 + (d w)^2 = (f/a)^2 has folds at w = 1.2384
	 * (a = 1.009) and 1.0953 (a = 0.369); a sweep at finite rate jumps a little later. */
	up = passes(0.8, 1.6, 0.7, 1);
	down = passes(1.6, 0.8, 0.5, 0);
	ok(up > 1.238 && up < 1.26, "upward it falls at the upper fold: %.4f", up);
	ok(down < 1.096 && down > 1.07, "downward it rises at the lower fold: %.4f", down);
	return done_testing();
}
