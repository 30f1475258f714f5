/* The limits of multiple scales: its orbits against those of the model, computed from them by the
 * reference of taylor.h, over load, damping and detuning.
 *
 * The truncation error of the expansion for a resonant orbit of size a is of second order in a.
 * Relative to the orbit it has a third harmonic of c a^2/32, corrections of the mean and of the
 * second harmonic of the order (q a)^2, and terms of q a times the damping and the detuning,
 * which are of second order. This sum is the stated error. The true error is the distance from
 * the branch, because close to a fold an orbit at the same frequency may not exist.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/scales.h>

#include "tests/extremes/sweep.h"
#include "tests/extremes/taylor.h"
#include "tests/integrate-models.h"

#define VALUES(a) (a), (int)(sizeof(a)/sizeof *(a))
#define LARGEST 0.1 /* stated error above which the expansion is not used */
enum { LOAD, DAMPING, OMEGA, QUADRATIC, AXES };
static const double loads[] = {1e-12, 1e-6, 1e-3, 0.01, 0.05, 0.2, 1.0, 10.0};
static const double dampings[] = {1e-9, 1e-4, 0.01, 0.1, 0.5, 1.0, 10.0};
static const double omegas[] = {0.7, 0.9, 0.97, 0.999, 1.0, 1.001, 1.03, 1.2, 1.4};
static const double quadratics[] = {-0.5, 0.0, 1e-6, 0.3, 1.0};
static const struct sweep_axis axis[AXES] = {
	{"load", 0.01, VALUES(loads), 5},
	{"damping", 0.02, VALUES(dampings), 5},
	{"Omega", 1.03, VALUES(omegas), 2},
	{"quadratic", 0.0, VALUES(quadratics), 3},
};

static enum hawser_status cheap(struct hawser_frf *frf, const struct hawser_rom *rom, double omega,
                                struct hawser_report *report)
{
	const struct hawser_resonance one = {.count = 1, .mode = {0}, .order = {1}, .omega0 = omega};
	struct hawser_frf_options options = {.method = NULL};

	options.method = "multiple-scales";
	options.from = omega;
	options.to = omega*1.01;
	options.max_points = 1;
	options.samples = HAWSER_NONE;
	options.resonance = &one;
	return hawser_frf_trace(frf, rom, &options, report);
}

/* Distance of the state [2] from the branch through x [2] with the tangent `along`, relative to the
 * size X of the orbit; a relative change of Omega has the same weight. */
static double distance(const double *state, const long double *x, const long double *along,
                       double X, double omega)
{
	double d2 = 0.0, dt = 0.0, t2 = 1.0;

	for (int j = 0; j < 2; j++) {
		double d = (state[j] - (double)x[j])/X, t = (double)along[j]*omega/X;

		d2 += d*d;
		dt += d*t;
		t2 += t*t;
	}
	return sqrt(fmax(d2 - dt*dt/t2, 0.0));
}

static void solve(struct sweep_point *point, const double *x, void *context)
{
	struct hawser_rom rom = model_new(1);
	struct taylor *taylor;
	struct hawser_frf frf;
	long double state[2], along[2];
	double load = x[LOAD], a;

	(void)context;
	rom.K[0] = 1.0;
	rom.D[0] = 2.0*x[DAMPING];
	model_cubic(&rom, 0, 0, 0, 0, 1.0);
	model_quad(&rom, 0, 0, 0, x[QUADRATIC]);
	model_force(&rom, HAWSER_COS, 0, &load);
	model_compile(&rom);
	taylor = taylor_new(&rom);
	taylor_limit(taylor, 5000);
	point->status = cheap(&frf, &rom, x[OMEGA], &point->report);
	if (!point->status) {
		a = frf.coordinate[0];
		point->stated = a*a/16.0 + pow(x[QUADRATIC]*a, 2) + 1e-9 +
			fabs(x[QUADRATIC]*a)*(x[DAMPING] + fabs(x[OMEGA] - 1.0));
		state[0] = frf.state[0];
		state[1] = frf.state[1];
		/* where the expansion is valid there must be an orbit near it */
		point->skip = point->stated > LARGEST;
	}
	if (!point->status && !point->skip) {
		point->error = taylor_orbit(taylor, state, NULL, along, NULL, x[OMEGA]) ? INFINITY :
			distance(frf.state, state, along, taylor_size(taylor, state, x[OMEGA]), x[OMEGA]);
	}
	taylor_free(taylor);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

CASE(extremes_sweep_mms)
{
	struct sweep_tally tally = sweep_pairs("mms", axis, AXES, solve, NULL);

	ok(tally.right > tally.points/2, "more than half of the points are right: %d of %d", tally.right,
	   tally.points);
	return done_testing();
}
