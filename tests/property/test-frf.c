/* The response by other routes: closed form of a linear model, settled integration, undamped
 * motion, symmetry of a Duffing curve, a closed curve, and every failure. All with every method.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <stdlib.h>

#include <hawser/frf.h>
#include <hawser/integrate.h>
#include <hawser/modes.h>
#include <hawser/scene.h>
#include <hawser/statics.h>

#include "rom/build/model.h"
#include "tests/tap.h"

static const char *method;

static struct hawser_frf_options defaults(void)
{
	struct hawser_frf_options options = {.method = NULL};

	options.method = method;
	return options;
}

static void set_load(struct hawser_rom *rom, int k, const double *f)
{
	rom->harmonics = 1;
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	rom->harmonic[0] = (struct hawser_harmonic){.k = k, .f = calloc((size_t)rom->n, sizeof *f)};
	memcpy(rom->harmonic[0].f, f, (size_t)rom->n*sizeof *f);
}

static void add_cubic(struct hawser_rom *rom, double value)
{
	rom->cubics = 1;
	rom->C = calloc(1, sizeof *rom->C);
	rom->C[0] = (struct hawser_cubic){0, 0, 0, 0, value};
}

/* u = Re(c exp(i w t)) of a two-coordinate linear model with full damping matrix. */
static void linear_amplitudes(const struct hawser_rom *rom, double w, double amplitude[2])
{
	double complex a[4], f0 = rom->harmonic[0].f[0], f1 = rom->harmonic[0].f[1], det;

	for (int i = 0; i < 4; i++)
		a[i] = rom->K[i] + I*w*rom->D[i] - (i%3 == 0 ? w*w : 0.0);
	det = a[0]*a[3] - a[1]*a[2];
	amplitude[0] = cabs((a[3]*f0 - a[1]*f1)/det);
	amplitude[1] = cabs((a[0]*f1 - a[2]*f0)/det);
}

static void check_linear(void)
{
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_frf_options options = defaults();
	double worst = 0.0, decay = -INFINITY;

	if (hawser__rom_init(&rom, 2, NULL))
		return;
	rom.K[0] = 1.0;
	rom.K[1] = rom.K[2] = -0.3;
	rom.K[3] = 2.385;
	rom.D[0] = 0.02;
	rom.D[1] = 0.03;
	rom.D[2] = -0.03; /* gyroscopic part */
	rom.D[3] = 0.05;
	set_load(&rom, 1, (double[]){0.7, -0.4});
	options.from = 0.3;
	options.to = 2.2;
	options.tolerance = 1e-11;
	ok(!hawser_rom_compile(&rom, NULL) && !hawser_frf_trace(&frf, &rom, &options, NULL),
	   "linear model traced");
	for (int i = 0; i < frf.points; i++) {
		double want[2];

		linear_amplitudes(&rom, frf.point[i].omega, want);
		for (int j = 0; j < 2; j++)
			worst = fmax(worst, fabs(frf.coordinate[2*i + j]/want[j] - 1.0));
		decay = fmax(decay, frf.multiplier[8*i]*frf.point[i].omega/(2*M_PI));
	}
	ok(worst < 1e-9, "amplitudes of %d points in closed form: %.1e", frf.points, worst);
	ok(frf.events == 0 && frf.end == HAWSER_END_RANGE, "no events, to the end of the range");
	ok(frf.point[0].omega == 0.3 && frf.point[frf.points - 1].omega == 2.2,
	   "from and to are met exactly");
	/* the slowest decay rate is the same at every Omega */
	for (int i = 0; i < frf.points; i++)
		worst = fmax(worst, fabs(frf.multiplier[8*i]*frf.point[i].omega/(2*M_PI) - decay));
	ok(worst < 1e-8, "Floquet exponents do not depend on Omega: %.1e", worst);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* A point of a Duffing curve, and the motion to which integration from rest settles. */
static void check_settled(void)
{
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_frf_options options = defaults();
	struct hawser_integrate_options run = {.rtol = 1e-12, .atol = 1e-14};
	struct hawser_trajectory trajectory;
	struct hawser_report report = {.message = ""};
	double period;
	const double *end, *orbit;

	if (hawser__rom_init(&rom, 1, NULL))
		return;
	rom.K[0] = 1.0;
	rom.D[0] = 0.3;
	add_cubic(&rom, 0.4);
	set_load(&rom, 1, (double[]){0.5});
	options.from = 0.6;
	options.to = 1.385;
	options.tolerance = 1e-11;
	ok(!hawser_rom_compile(&rom, NULL) && !hawser_frf_trace(&frf, &rom, &options, NULL),
	   "Duffing traced");
	period = 2*M_PI/options.to;
	run.omega = options.to;
	run.until = 40*period;
	run.every = period;
	ok(!hawser_integrate(&trajectory, &rom, &run, &report), "integrated over 40 periods %s",
	   report.message);
	end = trajectory.state + (size_t)(trajectory.rows - 1)*2;
	orbit = frf.state + (size_t)(frf.points - 1)*2;
	ok(fabs(end[0] - orbit[0]) < 1e-8 && fabs(end[1] - orbit[1]) < 1e-8,
	   "the orbit agrees with settled integration: %.1e, %.1e", fabs(end[0] - orbit[0]),
	   fabs(end[1] - orbit[1]));
	hawser_trajectory_clear(&trajectory);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* Without damping the multipliers of the lower branch lie on the unit circle: nothing is unstable,
 * and the product is 1. */
static void check_undamped(void)
{
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_frf_options options = defaults();
	int unstable = 0;
	double gap = 0.0;

	if (hawser__rom_init(&rom, 1, NULL))
		return;
	rom.K[0] = 1.0;
	add_cubic(&rom, 0.1);
	set_load(&rom, 1, (double[]){0.01});
	options.from = 0.5;
	options.to = 0.85;
	ok(!hawser_rom_compile(&rom, NULL) && !hawser_frf_trace(&frf, &rom, &options, NULL),
	   "undamped Duffing traced below resonance");
	for (int i = 0; i < frf.points; i++) {
		unstable += frf.point[i].unstable;
		gap = fmax(gap, frf.point[i].liouville);
	}
	ok(unstable == 0 && gap < 1e-8, "on the unit circle, not outside: gap %.1e", gap);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* Options that are 0 have the defaults that the header states. */
static void check_zeros(void)
{
	struct hawser_rom rom;
	struct hawser_frf frf[2];
	struct hawser_sweep sweep[2];
	struct hawser_frf_options of[2] = {{.method = NULL}, {.method = "auto", .tolerance = 1e-9,
		.event_tolerance = 1e-10, .step_max = 0.02, .max_points = 20000, .samples = 5}};
	struct hawser_sweep_options by[2] = {{.count = 3}, {.count = 3, .settle = 1e-6,
		.max_periods = 2000}};
	int same = 1, failed = 0;

	if (hawser__rom_init(&rom, 1, NULL))
		return;
	rom.K[0] = 1.0;
	rom.D[0] = 0.05;
	add_cubic(&rom, 0.1);
	set_load(&rom, 1, (double[]){0.18});
	failed |= hawser_rom_compile(&rom, NULL) != HAWSER_OK;
	for (int i = 0; i < 2; i++) {
		by[i].from = of[i].from = 0.9;
		by[i].to = of[i].to = 1.4;
		failed |= hawser_frf_trace(&frf[i], &rom, &of[i], NULL) != HAWSER_OK;
		failed |= hawser_sweep_run(&sweep[i], &rom, &by[i], NULL) != HAWSER_OK;
	}
	same &= frf[0].points == frf[1].points && frf[0].events == frf[1].events &&
	        frf[0].events > 0 && frf[0].sampled == frf[1].sampled;
	for (int p = 0; same && p < frf[0].points; p++)
		same &= frf[0].point[p].omega == frf[1].point[p].omega;
	for (int p = 0; same && p < 3; p++)
		same &= sweep[0].coordinate[p] == sweep[1].coordinate[p];
	ok(!failed && same, "zeros are the stated defaults: %d points, %d events", frf[0].points,
	   frf[0].events);
	for (int i = 0; i < 2; i++) {
		hawser_frf_clear(&frf[i]);
		hawser_sweep_clear(&sweep[i]);
	}
	by[0].settle = -1e-6;
	ok(hawser_sweep_run(&sweep[0], &rom, &by[0], NULL) == HAWSER_ERR_ARGUMENT, "but not below 0");
	hawser_rom_clear(&rom);
}

/* The upward sweep jumps down, the downward sweep jumps up, and elsewhere both lie on the curve. */
static void check_sweep(void)
{
	struct hawser_rom rom;
	struct hawser_sweep up, down;
	struct hawser_sweep_options options = {.from = 1.0, .to = 1.5, .count = 51, .settle = 1e-7,
		.max_periods = 2000};
	double jump_up = 0.0, jump_down = 0.0;

	if (hawser__rom_init(&rom, 1, NULL))
		return;
	rom.K[0] = 1.0;
	rom.D[0] = 0.05;
	add_cubic(&rom, 0.1);
	set_load(&rom, 1, (double[]){0.18});
	ok(!hawser_rom_compile(&rom, NULL) && !hawser_sweep_run(&up, &rom, &options, NULL),
	   "swept up");
	options.from = 1.5;
	options.to = 1.0;
	ok(!hawser_sweep_run(&down, &rom, &options, NULL), "swept down");
	for (int i = 1; i < 51; i++) {
		if (up.coordinate[i] < 0.7*up.coordinate[i - 1])
			jump_up = up.omega[i];
		if (down.coordinate[i] > 1.4*down.coordinate[i - 1])
			jump_down = down.omega[i];
	}
	ok(fabs(jump_up - 1.2696) < 0.0101, "up-sweep falls at the fold 1.2696: %.3f", jump_up);
	ok(fabs(jump_down - 1.1157) < 0.0101, "down-sweep jumps at the fold 1.1157: %.3f", jump_down);
	close_to(up.coordinate[0], down.coordinate[50], 1e-5, "both agree outside");
	hawser_sweep_clear(&up);
	hawser_sweep_clear(&down);
	options.count = 1;
	ok(hawser_sweep_run(&up, &rom, &options, NULL) == HAWSER_ERR_ARGUMENT, "one frequency: refused");
	hawser_rom_clear(&rom);
}

/* u'' + d u' + u + u^3 = f cos 3 Omega t has subharmonic orbits of period 2 pi/Omega on a closed
 * curve separate from the main branch. Its lowest and its highest point are folds. */
static void check_closed(void)
{
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_frf_options options = defaults();
	struct hawser_report report = {.message = ""};
	double start[2] = {-1.01741, 0.12134};
	int folds = 0;

	if (hawser__rom_init(&rom, 1, NULL))
		return;
	rom.K[0] = 1.0;
	rom.D[0] = 0.06;
	add_cubic(&rom, 1.0);
	set_load(&rom, 3, (double[]){2.0});
	options.from = 1.0;
	options.to = 3.0;
	options.begin = 1.3;
	options.start = start;
	options.tolerance = 1e-10;
	if (!ok(!hawser_rom_compile(&rom, NULL) && !hawser_frf_trace(&frf, &rom, &options, &report),
	        "subharmonic traced %s", report.message))
		return;
	ok(frf.end == HAWSER_END_CLOSED, "the curve closes (%s)", hawser_frf_end_name(frf.end));
	close_to(frf.point[frf.points - 1].omega, 1.3, 1e-9, "it ends at its first Omega");
	close_to(frf.coordinate[frf.points - 1], frf.coordinate[0], 1e-7, "and at its first orbit");
	for (int i = 0; i < frf.events; i++)
		folds += frf.event[i].kind == HAWSER_FOLD;
	ok(folds == 2 && frf.events == 2, "two folds and nothing else: %d, %d", folds, frf.events);
	hawser_frf_clear(&frf);
	options.begin = 4.0;
	ok(hawser_frf_trace(&frf, &rom, &options, &report) == HAWSER_ERR_ARGUMENT, "%s",
	   report.message);
	hawser_frf_clear(&frf);
	options.begin = 1.3;
	start[0] = 40.0;
	ok(hawser_frf_trace(&frf, &rom, &options, &report) == HAWSER_ERR_CONVERGENCE, "%s",
	   report.message);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

static int stop_at_five(void *data, const struct hawser_progress_state *state)
{
	(void)data;
	return state->frf->points >= 5;
}

static int stop_at_once(void *data, const struct hawser_progress_state *state)
{
	(void)data;
	(void)state;
	return 1;
}

static void check_ends_and_errors(void)
{
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_frf_options options = defaults(), bad;
	struct hawser_report report = {.message = ""};

	if (hawser__rom_init(&rom, 1, NULL))
		return;
	rom.K[0] = 1.0;
	options.from = 0.55; /* not 0.5, where a free motion of the undamped model has this period */
	options.to = 2.0;
	ok(!hawser_rom_compile(&rom, NULL), "undamped oscillator");
	set_load(&rom, 1, (double[]){0.0});
	ok(!hawser_rom_compile(&rom, NULL) &&
	   hawser_frf_trace(&frf, &rom, &options, &report) == HAWSER_ERR_ARGUMENT, "a zero load: %s",
	   report.message);
	free(rom.harmonic->f);
	free(rom.harmonic);
	rom.harmonic = NULL;
	rom.harmonics = 0;
	ok(hawser_frf_trace(&frf, &rom, &options, &report) == HAWSER_ERR_ARGUMENT, "%s",
	   report.message);
	set_load(&rom, 1, (double[]){0.1});
	ok(!hawser_rom_compile(&rom, NULL), "now loaded");
	options.max_points = 7;
	ok(!hawser_frf_trace(&frf, &rom, &options, &report) && frf.points == 7 &&
	   frf.end == HAWSER_END_MAX_POINTS, "stops at max_points and says so");
	hawser_frf_clear(&frf);
	options.progress.function = stop_at_five;
	ok(!hawser_frf_trace(&frf, &rom, &options, &report) && frf.points == 5 &&
	   frf.end == HAWSER_END_INTERRUPTED, "stops when asked and says so");
	hawser_frf_clear(&frf);
	bad = options;
	bad.start = (const double[]){1e200, 1e200};
	bad.progress.function = stop_at_once;
	ok(hawser_frf_trace(&frf, &rom, &bad, &report) == HAWSER_ERR_CONVERGENCE && frf.points == 0 &&
	   frf.end == HAWSER_END_INTERRUPTED && strstr(report.message, "before its first orbit"),
	   "before the first orbit, too: %s", report.message);
	hawser_frf_clear(&frf);
	bad = options;
	bad.from = 1.0;
	ok(hawser_frf_trace(&frf, &rom, &bad, &report) == HAWSER_ERR_NO_SOLUTION, "%s",
	   report.message);
	hawser_frf_clear(&frf);
	bad = options;
	bad.to = bad.from;
	ok(hawser_frf_trace(&frf, &rom, &bad, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	bad = options;
	bad.from = NAN;
	ok(hawser_frf_trace(&frf, &rom, &bad, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	bad = options;
	bad.tolerance = -1e-9;
	ok(hawser_frf_trace(&frf, &rom, &bad, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	bad = options;
	bad.segments = -1;
	ok(hawser_frf_trace(&frf, &rom, &bad, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	/* no damping and no nonlinearity: the amplitude grows without bound at the resonance in the
	 * range */
	options.progress.function = NULL;
	options.max_points = 100000;
	ok(hawser_frf_trace(&frf, &rom, &options, &report) == HAWSER_ERR_CONVERGENCE &&
	   frf.end == HAWSER_END_FAILED && frf.points > 10, "resonance without damping: %s",
	   report.message);
	hawser_frf_clear(&frf);
	hawser_frf_clear(NULL);
	hawser_rom_clear(&rom);
}

/* One period from the state x of Duffing's equation by Runge and Kutta's method; the largest |u|. */
static double duffing_period(double x[2], double W, double f)
{
	enum { STEPS = 4000 };
	double h = 2.0*M_PI/W/STEPS, top = 0.0;

	for (int i = 0; i < STEPS; i++) {
		double k[4][2], sum[2] = {0.0, 0.0};

		for (int s = 0; s < 4; s++) {
			double c = s == 0 ? 0.0 : s == 3 ? h : 0.5*h;
			double u = x[0] + (s ? c*k[s - 1][0] : 0.0), v = x[1] + (s ? c*k[s - 1][1] : 0.0);

			k[s][0] = v;
			k[s][1] = f*cos(W*(i*h + c)) - 0.1*v - u - u*u*u;
			for (int j = 0; j < 2; j++)
				sum[j] += (s == 0 || s == 3 ? 1.0 : 2.0)*h/6.0*k[s][j];
		}
		x[0] += sum[0];
		x[1] += sum[1];
		top = fmax(top, fabs(x[0]));
	}
	return top;
}

/* First orbits that lie beyond folds in the load, which can be raised to 0.84 of 20 and 0.012 of 200.
 * The amplitude is that of a shooting program of its own (Runge and Kutta, differences for Newton's
 * method), which begins elsewhere. */
static void check_beyond_folds(void)
{
	static const double load[] = {20.0, 200.0}, begin[] = {1.0, 2.0};

	for (int i = 0; i < 2; i++) {
		struct hawser_frf_options options = {.method = NULL};
		struct hawser_report report = {.message = ""};
		struct hawser_rom rom;
		struct hawser_frf frf;

		if (hawser__rom_init(&rom, 1, NULL))
			return;
		rom.K[0] = 1.0;
		rom.D[0] = 0.1;
		add_cubic(&rom, 1.0);
		set_load(&rom, 1, &load[i]);
		options.from = begin[i];
		options.to = 4.0;
		options.max_points = 2;
		options.samples = HAWSER_NONE;
		if (ok(!hawser_rom_compile(&rom, NULL) &&
		       !hawser_frf_trace(&frf, &rom, &options, &report) && frf.points > 0,
		       "load %g: a first orbit %s", load[i], report.message)) {
			double x[2] = {frf.state[0], frf.state[1]}, top = duffing_period(x, begin[i], load[i]);

			ok(hypot(x[0] - frf.state[0], x[1] - frf.state[1]) < 1e-6,
			   "which is periodic, by Runge and Kutta's method");
			close_to(frf.coordinate[0], top, 1e-5, "its amplitude");
			if (i == 0)
				close_to(frf.coordinate[0], 3.216813, 2e-6, "that of another program");
		}
		hawser_frf_clear(&frf);
		hawser_rom_clear(&rom);
	}
}

/* B Table 4.5 with six raw modes: a pair of multipliers leaves the unit circle through -1 and
 * returns within 0.1 % of Omega, twice. The result must not depend on the positions of the points. */
static void check_narrow_doublings(void)
{
	static const double step[] = {0.02, 0.003, 0.005, 0.002};
	struct hawser_frf_options options = {.method = NULL};
	const struct hawser_modes_options six = {.n = 6, .tolerance = 1e-12};
	struct hawser_modes modes = {0};
	struct hawser_statics statics;
	struct hawser_scene scene;
	struct hawser_rom rom;
	const char *path = source_file("notebooks-data/scenes/b-table-4.5.yaml");
	int fine;

	fine = !hawser_scene_open(&scene, path, NULL, 0, NULL) &&
	       !hawser_statics_scene(&statics, &scene, NULL) &&
	       !hawser_modes_solve(&modes, &statics, &six, NULL) &&
	       !hawser_rom_build(&rom, &modes, &scene, NULL);
	hawser_modes_clear(&modes);
	if (!ok(fine, "B Table 4.5, six modes"))
		return;
	options.from = (getenv("HAWSER_LONG") ? 0.6 : 2.4)*sqrt(rom.K[0]);
	options.to = (getenv("HAWSER_LONG") ? 3.3 : 2.6)*sqrt(rom.K[0]);
	options.samples = HAWSER_NONE;
	for (size_t i = 0; i < (getenv("HAWSER_LONG") ? sizeof step/sizeof *step : 2); i++) {
		struct hawser_frf frf;
		int doublings = 0;

		options.step_max = step[i];
		fine = !hawser_frf_trace(&frf, &rom, &options, NULL);
		for (int e = 0; fine && e < frf.events; e++)
			doublings += frf.event[e].kind == HAWSER_PERIOD_DOUBLING;
		ok(doublings == 4, "largest step %g: %d points, %d period doublings", step[i],
		   fine ? frf.points : 0, doublings);
		hawser_frf_clear(&frf);
	}
	hawser_rom_clear(&rom);
	hawser_scene_clear(&scene);
}

CASE(property_frf)
{
	for (int i = 0; hawser_frf_method(i); i++) {
		if (hawser_frf_method(i)->approximate)
			continue;
		method = hawser_frf_method(i)->name;
		printf("# %s\n", method);
		check_linear();
		check_settled();
		check_undamped();
		check_closed();
		check_ends_and_errors();
	}
	check_sweep();
	check_zeros();
	check_beyond_folds();
	check_narrow_doublings();
	return done_testing();
}
