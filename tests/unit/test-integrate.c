/* hawser_integrate: closed forms, invalid arguments, early ends.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/integrate-models.h"

/* u(t) and u'(t) of u'' + d u' + k u = 0. */
static void free_motion(double *u, double *v, double t, double d, double k, double u0, double v0)
{
	double a = d/2.0, square = k - a*a, fade = exp(-a*t);

	if (square > 0.0) {
		double w = sqrt(square), b = (v0 + a*u0)/w;

		*u = fade*(u0*cos(w*t) + b*sin(w*t));
		*v = fade*(-u0*w*sin(w*t) + b*w*cos(w*t)) - a**u;
	} else if (square == 0.0) {
		*u = fade*(u0 + (v0 + a*u0)*t);
		*v = fade*(v0 + a*u0) - a**u;
	} else {
		double w = sqrt(-square), b = (v0 + a*u0)/w;

		*u = fade*(u0*cosh(w*t) + b*sinh(w*t));
		*v = fade*(u0*w*sinh(w*t) + b*w*cosh(w*t)) - a**u;
	}
}

static double free_error(double d, double k, const char *method, double rtol)
{
	const double initial[2] = {0.7, -1.3};
	struct hawser_rom rom = model_oscillator(d, k, 0.0, 0.0);
	struct hawser_trajectory run = model_run(&rom, method, 0.0, 11.1, 0.37, rtol, initial);
	double worst = 0.0;

	for (int i = 0; i < run.rows; i++) {
		double u, v;

		free_motion(&u, &v, run.time[i], d, k, initial[0], initial[1]);
		worst = fmax(worst, fmax(fabs(run.state[2*i] - u), fabs(run.state[2*i + 1] - v)));
	}
	if (run.rows != 31)
		worst = HUGE_VAL;
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
	return worst;
}

static void check_free(void)
{
	const double k = 5.6169; /* 2.37^2 */
	const double damping[3] = {0.237, 4.74, 11.85};
	const char *const name[3] = {"under-damped", "critically damped", "over-damped"};

	for (int m = 0; m < METHODS; m++)
		for (int i = 0; i < 3; i++) {
			/* BDF's local errors accumulate over the hundreds of steps of each oscillation */
			double error = free_error(damping[i], k, all_methods[m], 1e-11);
			double want = m == 0 ? 1e-11 : m == 1 ? 1e-9 : 1e-8;

			ok(error < want, "%s, %s: within %.1e of the closed form, bound %.0e",
			   all_methods[m], name[i], error, want);
		}
}

/* u'' + d u' + k u = Omega^2 f sin(Omega t): after the transient, amplitude and phase. */
static void check_forced(void)
{
	const double d = 0.61, k = 2.3, f = 0.83, omega = 1.7;
	struct hawser_rom rom = model_new(1);
	double amplitude = omega*omega*f/hypot(k - omega*omega, d*omega);
	double lag = atan2(d*omega, k - omega*omega);

	rom.K[0] = k;
	rom.D[0] = d;
	model_force(&rom, HAWSER_SIN, 2, &f);
	model_compile(&rom);
	for (int m = 0; m < METHODS; m++) {
		struct hawser_trajectory run = model_run(&rom, all_methods[m], omega, 130.0, 0.5,
		                                         1e-11, NULL);
		double worst = 0.0;

		for (int i = run.rows - 20; i < run.rows; i++)
			worst = fmax(worst, fabs(run.state[2*i] -
			                         amplitude*sin(omega*run.time[i] - lag)));
		ok(worst < (m == 0 ? 1e-10 : 1e-8), "%s: forced steady state within %.1e",
		   all_methods[m], worst);
		ok(run.state[0] == 0.0 && run.state[1] == 0.0, "and it started from rest");
		hawser_trajectory_clear(&run);
	}
	hawser_rom_clear(&rom);
}

/* --- refusals --- */

static int stop_at_fifth(void *data, const struct hawser_progress_state *state)
{
	(void)state;
	return ++*(int *)data == 5;
}

static void refuses(struct hawser_integrate_options options, const struct hawser_rom *rom,
                    enum hawser_status want, const char *word, const char *what)
{
	struct hawser_report report = {0};
	struct hawser_trajectory run;
	enum hawser_status got = hawser_integrate(&run, rom, &options, &report);

	ok(got == want && strstr(report.message, word), "%s: %s (%s)", what,
	   hawser_status_name(got), report.message);
	hawser_trajectory_clear(&run);
}

#define WITH(field, value) \
	(options = good, options.field = (value), options)

static void check_arguments(void)
{
	const struct hawser_integrate_options good = {.omega = 1.1, .until = 10.0, .every = 0.5};
	struct hawser_integrate_options options;
	struct hawser_rom rom = model_oscillator(0.1, 1.0, 0.2, 0.3);
	const double broken[2] = {0.1, NAN}, huge[2] = {1e200, 0.0};
	const enum hawser_status bad = HAWSER_ERR_ARGUMENT;

	refuses(WITH(until, 0.0), &rom, bad, "until", "no end time");
	refuses(WITH(until, -3.0), &rom, bad, "until", "a negative end time");
	refuses(WITH(until, INFINITY), &rom, bad, "until", "an endless run");
	refuses(WITH(until, NAN), &rom, bad, "until", "an end time that is no number");
	refuses(WITH(every, 0.0), &rom, bad, "every", "no output interval");
	refuses(WITH(every, -0.5), &rom, bad, "every", "a negative output interval");
	refuses(WITH(every, 10.5), &rom, bad, "every", "an output interval beyond the end");
	refuses(WITH(every, 1e-9), &rom, bad, "8", "ten thousand million rows");
	refuses(WITH(omega, 0.0), &rom, bad, "Omega", "a forced model without frequency");
	refuses(WITH(omega, -1.0), &rom, bad, "Omega", "a negative frequency");
	refuses(WITH(rtol, 1.0), &rom, bad, "rtol", "rtol 1");
	refuses(WITH(rtol, -1e-8), &rom, bad, "rtol", "a negative rtol");
	refuses(WITH(rtol, 1e-17), &rom, bad, "rtol", "rtol below round-off");
	refuses(WITH(rtol, NAN), &rom, bad, "rtol", "rtol that is no number");
	refuses(WITH(atol, -1e-8), &rom, bad, "atol", "a negative atol");
	refuses(WITH(max_steps, -1), &rom, bad, "max_steps", "a negative limit on steps");
	refuses(WITH(method, "euler"), &rom, bad, "gauss, radau, adams, bdf", "an unknown method");
	refuses(WITH(initial, broken), &rom, HAWSER_ERR_NAN, "velocity of coordinate 0",
	        "a state that is no number");
	refuses(WITH(initial, huge), &rom, HAWSER_ERR_NAN, "acceleration of coordinate 0",
	        "a state whose cube overflows");
	for (int m = 0; m < METHODS; m++) {
		options = WITH(method, all_methods[m]);
		options.until = 1e6;
		options.every = 1e5;
		options.max_steps = 51;
		refuses(options, &rom, HAWSER_ERR_CONVERGENCE, "51 steps", "too many steps");
	}
	hawser_rom_clear(&rom);
}

static void check_interruption(void)
{
	int calls = 0;
	struct hawser_integrate_options options = {
		.until = 10.0, .every = 0.5, .progress = {stop_at_fifth, &calls},
	};
	struct hawser_rom rom = model_oscillator(0.1, 1.0, 0.2, 0.0);
	struct hawser_trajectory run;

	ok(!hawser_integrate(&run, &rom, &options, NULL) && run.interrupted && run.rows == 6 &&
	   run.time[5] == 2.5, "interrupted at the fifth output: six rows kept");
	hawser_trajectory_clear(&run);
	hawser_trajectory_clear(NULL);
	hawser_rom_clear(&rom);
}

/* u'' = 2 u^3 with u' = u^2 at the start has the solution u = 1/(1/u0 - t), which is infinite at t
 * = 2 for u0 = 1/2. */
static void check_escape(void)
{
	const double initial[2] = {0.5, 0.25};
	struct hawser_rom rom = model_oscillator(0.0, 0.0, -2.0, 0.0);

	for (int m = 0; m < METHODS; m++) {
		struct hawser_integrate_options options = {
			.until = 30.0, .every = 0.13, .method = all_methods[m], .initial = initial,
		};
		struct hawser_report report = {0};
		struct hawser_trajectory run;
		enum hawser_status status = hawser_integrate(&run, &rom, &options, &report);
		int last = run.rows - 1;

		ok(status == HAWSER_ERR_CONVERGENCE && strstr(report.message, "escapes"),
		   "%s: an escape is %s (%s)", all_methods[m], hawser_status_name(status),
		   report.message);
		ok(last == 15, "the rows before the escape are kept: %d", run.rows);
		close_to(run.state[2*last], 1.0/(2.0 - run.time[last]), 1e-6, "and are right");
		hawser_trajectory_clear(&run);
	}
	hawser_rom_clear(&rom);
}

/* Neither the run nor the rest of a continued run needs to be a multiple of the interval. */
static void check_end(void)
{
	struct hawser_rom rom = model_oscillator(0.1, 1.0, 0.2, 0.3);
	struct hawser_integrate_options options = {.omega = 1.1, .begin = 0.7, .until = 2.385,
	                                           .every = 0.4};
	const double want[] = {0.7, 0.8, 1.2000000000000002, 1.6, 2.0, 2.385};
	struct hawser_trajectory run, direct;
	enum hawser_status status = hawser_integrate(&run, &rom, &options, NULL);

	ok(!status && run.rows == 6, "%d rows to the end", run.rows);
	for (int row = 0; row < 6 && row < run.rows; row++)
		ok(run.time[row] == want[row], "row %d at t = %.17g", row, run.time[row]);
	options.every = 1.685;
	ok(!hawser_integrate(&direct, &rom, &options, NULL), "the same run with an interval as long");
	close_to(run.state[2*(run.rows - 1)], direct.state[2*(direct.rows - 1)], 1e-9,
	         "and the same displacement there");
	hawser_trajectory_clear(&run);
	hawser_trajectory_clear(&direct);
	hawser_rom_clear(&rom);
}

static void check_table(void)
{
	const double moved[2] = {0.7, -1.3};
	struct hawser_rom light = model_oscillator(0.5, 4.0, 0.0, 0.0);
	struct hawser_rom heavy = model_oscillator(50.0, 4.0, 0.0, 0.0);
	struct hawser_trajectory run = model_run(&light, NULL, 0.0, 1.0, 0.1, 1e-6, NULL);

	for (int m = 0; m < METHODS; m++)
		ok(!strcmp(hawser_integrate_method(m)->name, all_methods[m]) &&
		   hawser_integrate_method(m)->summary[0], "method %d is %s", m, all_methods[m]);
	ok(!hawser_integrate_method(METHODS) && !hawser_integrate_method(-1), "and there are no more");
	ok(run.rows == 11, "ten intervals of 0.1 are eleven rows: %d", run.rows);
	ok(run.state[20] == 0.0 && run.energy[10] == 0.0, "rest stays rest");
	ok(!strcmp(run.method, "gauss"), "a lightly damped model takes gauss");
	hawser_trajectory_clear(&run);
	run = model_run(&heavy, "auto", 0.0, 400.0, 40.0, 1e-6, moved);
	ok(!strcmp(run.method, "radau"), "a heavily damped one takes radau");
	ok(run.jacobians > 0 && run.steps > 0 && run.evaluations >= run.steps, "costs are counted");
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&light);
	hawser_rom_clear(&heavy);
}

/* The smallest tolerance, unusual end times, and models for which a step could fail. */
static void check_edges(void)
{
	const double initial[2] = {0.7, -1.3};
	struct hawser_rom loose = model_oscillator(0.0, 0.0, 0.0, 0.0);
	struct hawser_rom hill = model_oscillator(0.1, -1.0, 0.0, 0.0);
	struct hawser_rom stiff = model_oscillator(0.0, 1e10, 0.0, 0.0);
	int bad = 0;

	for (int m = 0; m < METHODS; m++) {
		const char *name = all_methods[m];
		struct hawser_trajectory run;
		double u, v;

		ok(free_error(0.237, 5.6169, name, 1e-15) < 1e-10, "%s at rtol 1e-15", name);
		run = model_run(&loose, name, 0.0, 1e6, 1e5, 1e-10, initial);
		close_to(run.state[20], 0.7 - 1.3e6, 1e-12, "free flight");
		hawser_trajectory_clear(&run);
		run = model_run(&hill, name, 0.0, 20.0, 2.0, 1e-11, initial);
		free_motion(&u, &v, 20.0, 0.1, -1.0, 0.7, -1.3);
		close_to(run.state[20], u, 1e-8, "down an unstable equilibrium");
		hawser_trajectory_clear(&run);
		run = model_run(&stiff, name, 0.0, 1e-3, 1e-4, 1e-11, initial);
		free_motion(&u, &v, 1e-3, 0.0, 1e10, 0.7, -1.3);
		close_to(run.state[20], u, 1e-6, "100 000 rad a time unit");
		hawser_trajectory_clear(&run);
	}
	for (int i = 1; i <= 400; i++) {
		struct hawser_trajectory run = model_run(&hill, "gauss", 0.0, 0.1*i, 0.1*i/3.0, 1e-8,
		                                         initial);

		bad += run.rows != 4 || run.time[3] != 0.1*i;
		hawser_trajectory_clear(&run);
	}
	ok(!bad, "400 end times are met to the last bit");
	hawser_rom_clear(&loose);
	hawser_rom_clear(&hill);
	hawser_rom_clear(&stiff);
}

CASE(unit_integrate)
{
	check_edges();
	check_free();
	check_forced();
	check_arguments();
	check_interruption();
	check_escape();
	check_end();
	check_table();
	return done_testing();
}
