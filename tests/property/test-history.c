/* Forces with a history: the spline reproduces a cubic and is of fourth order, a harmonic load as a
 * table against the harmonic load by every integrator, parametric terms, a pulse after a long rest, and
 * what is refused.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rom/terms/history.h"
#include "tests/integrate-models.h"

enum { ROWS = 801 };

static struct hawser_rom unit_of(double k, double load)
{
	struct hawser_rom unit = model_oscillator(0.05, k, 0.7, load);

	unit.harmonic->K = calloc(1, sizeof *unit.harmonic->K);
	if (!unit.harmonic->K)
		abort();
	unit.harmonic->K[0] = 0.23;
	return unit;
}

static void spline(void)
{
	struct hawser_rom rom = model_oscillator(0.05, 1.0, 0.7, 0.0), unit = unit_of(1.0, 1.0);
	const struct hawser_rom *units[1] = {&unit};
	double time[9] = {0.0, 0.3, 1.0, 1.2, 2.0, 3.1, 3.2, 4.0, 5.0}, value[9], worst[3] = {0.0};

	for (int i = 0; i < 9; i++)
		value[i] = 1.0 + time[i]*(-2.0 + time[i]*(0.5 + 0.31*time[i]));
	ok(!hawser_rom_history_set(&rom, units, 1, time, value, 9, NULL), "a history");
	for (double t = 0.0; t <= 5.0; t += 0.01) {
		double p = 1.0 + t*(-2.0 + t*(0.5 + 0.31*t)), rate = -2.0 + t*(1.0 + 0.93*t);

		worst[0] = fmax(worst[0], fabs(hawser__history_value(rom.history, 0, t, 0) - p));
		worst[1] = fmax(worst[1], fabs(hawser__history_value(rom.history, 0, t, 1) - rate));
	}
	ok(worst[0] < 1e-12 && worst[1] < 1e-12, "a cubic is reproduced: %.1e, rate %.1e", worst[0],
	   worst[1]);
	close_to(hawser__history_spacing(rom.history), 0.1, 1e-12, "least spacing");
	for (int rows = 2; rows <= 4; rows++) {
		ok(!hawser_rom_history_set(&rom, units, 1, time, value, rows, NULL), "%d rows", rows);
		worst[2] = 0.0;
		for (int i = 0; i < rows; i++)
			worst[2] = fmax(worst[2], fabs(hawser__history_value(rom.history, 0, time[i], 0) -
			                               value[i]));
		ok(worst[2] < 1e-14, "through its values");
	}
	hawser_rom_clear(&rom);
	hawser_rom_clear(&unit);
}

/* Distance at the end of a run with the load cos(1.3 t) as a table from one with the harmonic load. */
static double distance(const char *method, int rows)
{
	struct hawser_rom harmonic = unit_of(1.0, 0.3), rom = model_oscillator(0.05, 1.0, 0.7, 0.0);
	struct hawser_rom unit = unit_of(1.0, 0.3);
	const struct hawser_rom *units[1] = {&unit};
	double time[ROWS], value[ROWS], rest[2] = {0.1, 0.0}, far;
	struct hawser_integrate_options options = {.omega = 1.3, .until = 40.0, .every = 1.0,
		.rtol = 1e-10, .atol = 1e-12, .method = method, .initial = rest};
	struct hawser_trajectory a, b;
	struct hawser_report report;

	for (int i = 0; i < rows; i++) {
		time[i] = 40.0*i/(rows - 1);
		value[i] = cos(1.3*time[i]);
	}
	if (hawser_rom_history_set(&rom, units, 1, time, value, rows, &report) ||
	    hawser_integrate(&a, &harmonic, &options, &report) ||
	    hawser_integrate(&b, &rom, &options, &report)) {
		ok(0, "%s", report.message);
		return NAN;
	}
	far = fabs(a.state[2*(a.rows - 1)] - b.state[2*(b.rows - 1)]);
	hawser_trajectory_clear(&a);
	hawser_trajectory_clear(&b);
	hawser_rom_clear(&rom);
	hawser_rom_clear(&unit);
	hawser_rom_clear(&harmonic);
	return far;
}

/* A pulse of 2 time units after a rest of 500: its momentum, through which a step could jump. */
static void pulse(const char *method)
{
	struct hawser_rom rom = model_oscillator(0.0, 1e-6, 0.0, 0.0);
	struct hawser_rom unit = model_oscillator(0.0, 1e-6, 0.0, 1.0);
	const struct hawser_rom *units[1] = {&unit};
	double time[ROWS], value[ROWS] = {0.0}, rest[2] = {0.0};
	struct hawser_integrate_options options = {.until = 600.0, .every = 600.0, .rtol = 1e-6,
		.method = method, .initial = rest};
	struct hawser_trajectory run;

	for (int i = 0; i < ROWS; i++)
		time[i] = (double)i;
	value[500] = value[501] = 1.0;
	if (!ok(!hawser_rom_history_set(&rom, units, 1, time, value, ROWS, NULL) &&
	        !hawser_integrate(&run, &rom, &options, NULL), "a pulse, %s", method))
		return;
	ok(fabs(run.state[2*run.rows - 1] - 2.0) < 0.02, "its momentum: %g", run.state[2*run.rows - 1]);
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
	hawser_rom_clear(&unit);
}

static void refused(void)
{
	struct hawser_rom rom = model_oscillator(0.05, 1.0, 0.7, 0.0), free_one = rom, pair = model_pair();
	struct hawser_rom unit = unit_of(1.0, 1.0);
	const struct hawser_rom *units[1] = {&unit}, *none[1] = {&free_one}, *other[1] = {&pair};
	double time[3] = {0.0, 1.0, 0.5}, value[3] = {0.0};
	struct hawser_integrate_options options = {.until = 2.0, .every = 1.0};
	struct hawser_trajectory run;
	struct hawser_report report;

	ok(hawser_rom_history_set(&rom, units, 1, time, value, 3, &report) == HAWSER_ERR_ARGUMENT,
	   "times: %s", report.message);
	ok(hawser_rom_history_set(&rom, units, 1, time, value, 1, &report) == HAWSER_ERR_ARGUMENT,
	   "rows: %s", report.message);
	ok(hawser_rom_history_set(&rom, none, 1, time, value, 2, &report) == HAWSER_ERR_ARGUMENT,
	   "no load: %s", report.message);
	ok(hawser_rom_history_set(&rom, other, 1, time, value, 2, &report) == HAWSER_ERR_ARGUMENT,
	   "another model: %s", report.message);
	value[1] = NAN;
	ok(hawser_rom_history_set(&rom, units, 1, time, value, 2, &report) == HAWSER_ERR_NAN, "%s",
	   report.message);
	value[1] = 1.0;
	ok(!hawser_rom_history_set(&rom, units, 1, time, value, 2, &report) &&
	   hawser_integrate(&run, &rom, &options, &report) == HAWSER_ERR_ARGUMENT, "too short: %s",
	   report.message);
	hawser_rom_clear(&rom);
	hawser_rom_clear(&pair);
	hawser_rom_clear(&unit);
}

CASE(property_history)
{
	double coarse, fine;

	spline();
	for (int m = 0; m < METHODS; m++) {
		double far = distance(all_methods[m], ROWS);

		ok(far < 2e-6, "%s: the same motion as under the harmonic load: %.1e", all_methods[m], far);
		pulse(all_methods[m]);
	}
	coarse = distance("gauss", 101);
	fine = distance("gauss", 201);
	ok(coarse/fine > 12.0 && coarse/fine < 20.0, "fourth order: %.2e, %.2e", coarse, fine);
	refused();
	return done_testing();
}
