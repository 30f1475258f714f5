/* A run with a late start, at the final time of a long run. The phase of the forcing must be accurate,
 * the solution must match the closed form of the steady state, and the output times must be those of a
 * run from t = 0. The phases of Omega = 1.1 (the double), reduced by whole turns, are computed with 80
 * decimal digits.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>

#include "tests/integrate-models.h"

static const double omega = 1.1;

/* Largest relative distance from the steady state of u'' + 0.2 u' + u = cos(Omega t) in a run that
 * starts on it with this phase of the forcing. */
static double late(const char *method, double begin, double phase, double rtol)
{
	struct hawser_rom rom = model_oscillator(0.2, 1.0, 0.0, 1.0);
	const double complex size = 1.0/(1.0 - omega*omega + 0.2*I*omega);
	const double complex at = size*cexp(I*phase);
	const double initial[2] = {creal(at), creal(I*omega*at)};
	const struct hawser_integrate_options options = {.omega = omega, .begin = begin,
		.until = begin + 128.0, .every = 0.25, .rtol = rtol, .method = method,
		.initial = initial};
	struct hawser_report report = {0};
	struct hawser_trajectory run;
	double worst = 0.0;
	int right;

	if (hawser_integrate(&run, &rom, &options, &report)) {
		printf("# %s\n", report.message);
		worst = NAN;
	}
	right = run.rows == 513;
	for (int i = 0; i < run.rows; i++) {
		double complex u = at*cexp(I*omega*(0.25*i));

		right &= run.time[i] == begin + 0.25*i;
		worst = fmax(worst, fabs(run.state[2*i] - creal(u))/cabs(size));
	}
	ok(right, "%s from t = %g: every row at its time", method, begin);
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
	return worst;
}

static void refuse_times(void)
{
	static const double begin[] = {-1.0, 10.0, 11.0, NAN, INFINITY};
	struct hawser_rom rom = model_oscillator(0.2, 1.0, 0.0, 0.0);

	for (int k = 0; k < 5; k++) {
		const struct hawser_integrate_options options = {.begin = begin[k], .until = 10.0,
			.every = 1.0};
		struct hawser_report report = {0};
		struct hawser_trajectory run;
		enum hawser_status status = hawser_integrate(&run, &rom, &options, &report);

		ok(status == HAWSER_ERR_ARGUMENT && run.rows == 0, "begin %g: %s", begin[k],
		   report.message);
		hawser_trajectory_clear(&run);
	}
	hawser_rom_clear(&rom);
}

/* The start lies between two output times, or close to one. */
static void odd_begins(void)
{
	struct hawser_rom rom = model_oscillator(0.2, 1.0, 0.0, 0.0);
	struct hawser_integrate_options options = {.begin = 3.3, .until = 7.0, .every = 1.0};
	struct hawser_report report = {0};
	struct hawser_trajectory run;
	enum hawser_status status = hawser_integrate(&run, &rom, &options, &report);

	ok(!status && run.rows == 5 && run.time[0] == 3.3 && run.time[1] == 4.0 && run.time[4] == 7.0,
	   "from 3.3: 4, 5, 6, 7");
	hawser_trajectory_clear(&run);
	options.every = 0.1;
	options.begin = nextafter(nextafter(33*0.1, 0.0), 0.0);
	status = hawser_integrate(&run, &rom, &options, &report);
	ok(!status && run.rows == 38 && run.time[0] == 33*0.1 && run.time[1] == 34*0.1,
	   "a begin that was rounded is the multiple of the interval that it was");
	hawser_trajectory_clear(&run);
	options.begin = 6.95;
	status = hawser_integrate(&run, &rom, &options, &report);
	ok(!status && run.rows == 2 && run.time[1] == 7.0, "what is left may be shorter than an interval");
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
}

CASE(extremes_integrate_late)
{
	double off;

	off = late("gauss", 0.0, 0.0, 1e-12);
	ok(off < 1e-11, "gauss from 0: %.1e", off);
	off = late("gauss", 1073741824.0, 4.922993198621102, 1e-12);
	ok(off < 1e-11, "gauss after 188 million periods: %.1e", off);
	off = late("gauss", 1099511627776.0, 2.030419029979702, 1e-12);
	ok(off < 1e-11, "gauss after 192 thousand million periods: %.1e", off);
	off = late("adams", 1073741824.0, 4.922993198621102, 1e-12);
	ok(off < 1e-9, "adams after 188 million periods: %.1e", off);
	off = late("bdf", 1073741824.0, 4.922993198621102, 1e-11);
	ok(off < 1e-7, "bdf after 188 million periods: %.1e", off);
	refuse_times();
	odd_begins();
	return done_testing();
}
