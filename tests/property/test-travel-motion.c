/* Motions of travelling cables: energy, braking to rest, parametric resonance against Mathieu's
 * functions, the response to a change of speed alone.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <gsl/gsl_sf_mathieu.h>
#include <stdlib.h>

#include <hawser/frf.h>
#include <hawser/integrate.h>
#include "tests/tap.h"

static struct hawser_scene scene_of(double h, double speed, double fluctuation,
                                    enum hawser_hold hold)
{
	struct hawser_scene scene = {.cable = {.EA = 4e6, .rho = 2.385}, .span = {97.3, h}, .g = 9.81};

	scene.tension.given = HAWSER_GIVEN_T0;
	scene.tension.value = 9.1e3;
	scene.travel.present = 1;
	scene.travel.speed = speed;
	scene.travel.fluctuation = fluctuation;
	scene.travel.hold = hold;
	return scene;
}

static int build(struct hawser_rom *rom, struct hawser_statics *st, const struct hawser_scene *scene,
                 int n)
{
	struct hawser_modes_options options = {.n = n, .tolerance = 1e-11};
	struct hawser_modes modes = {.n = 0};
	struct hawser_report report = {.message = ""};
	int fine = !hawser_statics_scene(st, scene, &report) &&
	           !hawser_modes_solve(&modes, st, &options, &report) &&
	           !hawser_rom_build(rom, &modes, scene, &report);

	hawser_modes_clear(&modes);
	return ok(fine, "a model of %d modes%s", n, report.message);
}

/* Undamped and unforced, at a steady speed: gyroscopic forces do no work. */
static void check_energy(void)
{
	struct hawser_scene scene = scene_of(11.0, 33.0, 0.0, HAWSER_HOLD_TENSION);
	double initial[12] = {0.01, -0.006, 0.004, 0.002, 0.003, -0.001}, worst = 0.0;
	struct hawser_integrate_options options = {.until = 300.0, .every = 1.0, .rtol = 1e-13,
	                                           .atol = 1e-16, .initial = initial};
	struct hawser_trajectory run;
	struct hawser_statics st;
	struct hawser_rom rom;

	if (!build(&rom, &st, &scene, 6))
		return;
	if (ok(!hawser_integrate(&run, &rom, &options, NULL), "a free motion"))
		for (int i = 0; i < run.rows; i++)
			worst = fmax(worst, fabs(run.energy[i]/run.energy[0] - 1.0));
	ok(worst < 1e-12, "its energy is kept within %.1e", worst);
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
}

/* --- braking --- */

/* Probes of the model at u against the profile of the cable at rest with the same unstretched
 * length: largest distance, m. */
static double off_rest(const struct hawser_rom *rom, const struct hawser_statics *st,
                       const struct hawser_scene *scene, const double *u)
{
	const struct hawser_span span = {scene->cable.EA, scene->cable.rho, scene->g, scene->span.d,
	                                 scene->span.h};
	struct hawser_statics actual = hawser_statics_actual(st), rest;
	double worst = 0.0, moved = 0.0;

	if (hawser_statics_solve(&rest, &span, HAWSER_GIVEN_LENGTH0, actual.length0,
	                         HAWSER_BRANCH_TAUT, NULL))
		return INFINITY;
	for (int p = 0; p < rom->shapes.points; p++) {
		double S = rom->shapes.s[p]*rom->length*(1.0 - st->motion.mach2), xyz[3];
		struct hawser_profile_point from = hawser_statics_actual_at(st, S);
		struct hawser_profile_point to = hawser_statics_at(&rest, S);

		hawser_rom_displacement(rom, xyz, p, u);
		worst = fmax(worst, hypot(from.x + rom->length*xyz[0] - to.x,
		                          from.y + rom->length*xyz[1] - to.y));
		moved = fmax(moved, hypot(from.x - to.x, from.y - to.y));
	}
	printf("# the cable moves by %.3g m, the model is within %.1e m of it\n", moved, worst);
	return worst;
}

static double least(const struct hawser_trajectory *run)
{
	double lowest = INFINITY;

	for (int i = run->rows/2; i < run->rows; i++)
		lowest = fmin(lowest, run->energy[i]);
	return lowest;
}

static void check_braking(void)
{
	struct hawser_scene scene = scene_of(11.0, 25.0, 0.0, HAWSER_HOLD_TENSION);
	struct hawser_integrate_options options = {.until = 40.0, .every = 0.7, .rtol = 1e-9};
	struct hawser_trajectory run, other;
	struct hawser_statics st;
	struct hawser_rom exact, quartic;
	double end, worst = 0.0;

	scene.damping.kind = HAWSER_DAMPING_RATIO;
	scene.damping.ratio = 0.5;
	scene.travel.braking = 4.3;
	if (!build(&quartic, &st, &scene, 12))
		return;
	if (!ok(!hawser_rom_build_full(&exact, &st, &scene, 6, NULL), "the full order"))
		return;
	ok(!hawser_integrate(&run, &exact, &options, NULL), "braking");
	end = off_rest(&exact, &st, &scene, run.state + (size_t)(run.rows - 1)*2*(size_t)exact.n);
	ok(end < 1e-7, "ends at the cable at rest: %.1e m", end);
	ok(run.energy[0] == 0.0 && least(&run) < 0.0 &&
	   fabs(run.energy[run.rows - 1] - least(&run)) <= 1e-12*fabs(least(&run)),
	   "where the energy is least");
	hawser_trajectory_clear(&run);
	ok(!hawser_integrate(&run, &quartic, &options, NULL), "the same of the reduced model");
	end = off_rest(&quartic, &st, &scene, run.state + (size_t)(run.rows - 1)*2*(size_t)quartic.n);
	ok(end < 2e-3, "ends within %.1e m", end);
	options.method = "adams";
	options.rtol = 1e-10;
	ok(!hawser_integrate(&other, &quartic, &options, NULL), "by another method");
	for (int i = 0; i < run.rows*2*quartic.n; i++)
		worst = fmax(worst, fabs(run.state[i] - other.state[i]));
	ok(worst < 1e-8, "the same motion: %.1e", worst);
	hawser_trajectory_clear(&run);
	hawser_trajectory_clear(&other);
	hawser_rom_clear(&exact);
	hawser_rom_clear(&quartic);
}

/* After braking, an undamped cable conserves its energy from the end of braking on to the last
 * digit: no step extends across the jump of the rate. */
static void check_after(double braking)
{
	struct hawser_scene scene = scene_of(11.0, 25.0, 0.0, HAWSER_HOLD_LENGTH);
	struct hawser_integrate_options options = {.until = 60.0, .every = 0.25, .rtol = 1e-13,
	                                           .atol = 1e-16};
	struct hawser_report report = {.message = ""};
	struct hawser_frf_options frf = {.method = NULL};
	struct hawser_frf curve = {.points = 0};
	struct hawser_trajectory run;
	struct hawser_statics st;
	struct hawser_rom rom;
	double worst = 0.0, first = NAN;

	scene.travel.braking = braking;
	if (!build(&rom, &st, &scene, 6))
		return;
	if (ok(!hawser_integrate(&run, &rom, &options, NULL), "undamped"))
		for (int i = 0; i < run.rows; i++) {
			if (run.time[i] < rom.ramp->time)
				continue;
			first = isnan(first) ? run.energy[i] : first;
			worst = fmax(worst, fabs(run.energy[i]/first - 1.0));
		}
	ok(worst < 1e-11, "braking within %g s: energy %.3g kept within %.1e from there on", braking,
	   first, worst);
	frf.from = 1.0;
	frf.to = 2.0;
	ok(hawser_frf_trace(&curve, &rom, &frf, &report) == HAWSER_ERR_ARGUMENT,
	   "no frequency response: %s", report.message);
	hawser_frf_clear(&curve);
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
}

/* --- parametric resonance --- */

/* Trace of the monodromy matrix over pi/Omega, the period of cos(2 Omega t). */
static double trace(const struct hawser_rom *rom, double Omega)
{
	double sum = 0.0;

	for (int i = 0; i < 2; i++) {
		double initial[2] = {i == 0 ? 1e-6 : 0.0, i == 1 ? 1e-6 : 0.0};
		struct hawser_integrate_options options = {.omega = Omega, .until = M_PI/Omega,
			.every = M_PI/Omega, .rtol = 1e-13, .atol = 1e-19, .initial = initial};
		struct hawser_trajectory run;

		if (!hawser_integrate(&run, rom, &options, NULL))
			sum += run.state[(size_t)(run.rows - 1)*2 + i]*1e6;
		hawser_trajectory_clear(&run);
	}
	return sum;
}

/* The Omega at which the trace passes -2, between two frequencies. */
static double edge(const struct hawser_rom *rom, double stable, double unstable)
{
	for (int i = 0; i < 34; i++) {
		double middle = 0.5*(stable + unstable);

		*(trace(rom, middle) < -2.0 ? &unstable : &stable) = middle;
	}
	return 0.5*(stable + unstable);
}

/* u'' + (w^2 + V^2/2 M cos 2 Omega t) u = 0 is Mathieu's equation with a = w^2/Omega^2 and |q| =
 * V^2 M/(4 Omega^2): its edges at a_1(q) and b_1(q). */
static double mathieu(double w2, double quarter, int upper)
{
	double lo = 0.5*sqrt(w2), hi = 1.5*sqrt(w2);

	for (int i = 0; i < 100; i++) {
		double Omega = 0.5*(lo + hi), q = quarter/(Omega*Omega);
		double a = upper ? gsl_sf_mathieu_b(1, q) : gsl_sf_mathieu_a(1, q);

		*(a*Omega*Omega < w2 ? &lo : &hi) = Omega;
	}
	return 0.5*(lo + hi);
}

static void check_mathieu(double V)
{
	struct hawser_scene scene = scene_of(0.0, 0.0, V, HAWSER_HOLD_TENSION);
	struct hawser_modes_options options = {.n = 3, .tolerance = 1e-11};
	struct hawser_modes modes = {.n = 0}, one = {.n = 0};
	struct hawser_statics st;
	struct hawser_rom rom;
	int first = 0;
	double M, w, low, high;

	scene.model.condense = HAWSER_CONDENSE_NONE; /* M is the matrix element of the mode itself */
	if (!ok(!hawser_statics_scene(&st, &scene, NULL) &&
	        !hawser_modes_solve(&modes, &st, &options, NULL), "a cable that goes to and fro"))
		return;
	while (modes.mode[first].plane != HAWSER_OUT_OF_PLANE)
		first++;
	if (!ok(!hawser_modes_select(&one, &modes, &first, 1, NULL) &&
	        !hawser_rom_build(&rom, &one, &scene, NULL), "its first mode out of the plane"))
		return;
	hawser_modes_convection(&one, NULL, &M, NULL, NULL);
	w = one.mode[0].omega;
	low = mathieu(w*w, 0.25*st.motion.swing*st.motion.swing*M, 0);
	high = mathieu(w*w, 0.25*st.motion.swing*st.motion.swing*M, 1);
	if (low > high) {
		double swap = low;

		low = high;
		high = swap;
	}
	printf("# %g m/s: unstable from %.9g to %.9g w\n", V, low/w, high/w);
	close_to(edge(&rom, 0.9*low, 0.5*(low + high)), low, 1e-8, "lower edge");
	close_to(edge(&rom, 1.1*high, 0.5*(low + high)), high, 1e-8, "upper edge");
	hawser_rom_clear(&rom);
	hawser_modes_clear(&one);
	hawser_modes_clear(&modes);
}

/* --- the response to the speed alone --- */

static void check_response(void)
{
	struct hawser_scene scene = scene_of(11.0, 12.0, 0.7, HAWSER_HOLD_TENSION);
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_report report = {.message = ""};
	struct hawser_frf curve = {.points = 0}, other = {.points = 0};
	struct hawser_statics st;
	struct hawser_rom rom;
	double worst = 0.0, largest = 0.0;

	scene.damping.kind = HAWSER_DAMPING_ALPHA;
	scene.damping.alpha = 0.2;
	if (!build(&rom, &st, &scene, 5))
		return;
	options.from = 0.7*sqrt(rom.K[0]);
	options.to = 1.6*sqrt(rom.K[0]);
	ok(!hawser_frf_trace(&curve, &rom, &options, &report), "a response without a load %s",
	   report.message);
	options.method = "shooting";
	ok(!hawser_frf_trace(&other, &rom, &options, &report), "by shooting %s", report.message);
	for (int i = 0; i < other.points; i++) {
		worst = fmax(worst, fmax(other.point[i].liouville, other.point[i].residual));
		for (int j = 0; j < 5; j++)
			largest = fmax(largest, other.coordinate[(size_t)i*5 + j]);
	}
	ok(other.points > 20 && worst < 1e-6 && largest > 0.0, "%d points, Liouville's formula and "
	   "residuals within %.1e", other.points, worst);
	hawser_frf_clear(&curve);
	hawser_frf_clear(&other);
	hawser_rom_clear(&rom);
}

CASE(property_travel_motion)
{
	check_energy();
	check_braking();
	check_after(4.3);
	check_after(0.02);
	check_mathieu(10.0);
	check_mathieu(31.0);
	check_response();
	return done_testing();
}
