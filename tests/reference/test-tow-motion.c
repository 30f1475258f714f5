/* A towed body in time: D's U-turn and round, an end on the steady state, an orbit that stays, vortex
 * shedding and what sampling makes of it.
 *
 * D: Dehadrai, 2018. The tilts of the turns are those of an independent program, in a head wind of
 * 5 m/s, for t > 50 s (D: "< 0.1" in 5.2.5, "< 0.05" in 5.3).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/tow.h>

#include "tests/tap.h"

#define PI 3.14159265358979323846 /* to the digits of a double */
static const double origin[3] = {0.0};

/* A cable of nylon, E = 4 GPa, in air of 1.2 kg/m^3, with a ring. */
static struct hawser_tow with_ring(struct hawser_tow_segment *cable, double length, double r, double cn,
                                   double mass, double radius, double tube, double offset)
{
	*cable = (struct hawser_tow_segment){.length = length, .rho = 1150.0*PI*r*r, .EA = 4e9*PI*r*r,
	                                     .EI = 4e9*PI/4.0*pow(r, 4.0), .diameter = 2.0*r, .normal = cn,
	                                     .elements = 8};
	return (struct hawser_tow){
		.g = 9.81, .density = 1.2, .segment = cable, .segments = 1,
		.body = {.kind = HAWSER_TOW_RING, .mass = mass, .offset = offset,
		         .ring = {.radius = radius, .drag = {1.2, tube, cn, 0.0}}}};
}

static int move(struct hawser_tow_motion *motion, const struct hawser_tow *tow,
                const struct hawser_tow_options *options, const char *what)
{
	struct hawser_report report = {0};
	enum hawser_status status = hawser_tow_move(motion, tow, options, &report);

	return ok(!status && fabs(motion->closure) < 1e-4 && motion->momentum < 1e-3,
	          "%s: energy closes to %.1e, momentum to %.1e %s", what, status ? 0.0 : motion->closure,
	          status ? 0.0 : motion->momentum, report.message);
}

/* Least snap with free jerk at the ends, through 100 m and to -width, width or 0, width. */
static int turn_path(struct hawser_path *path, int round)
{
	static const double t[] = {0.0, 30.0, 70.0, 100.0}, x[] = {0.0, 100.0, 100.0, 0.0},
	                    z[2][4] = {{0.0, 0.0, 100.0, 100.0}, {0.0, -100.0, 100.0, 0.0}};
	struct hawser_waypoint point[4] = {{.t = 0.0}};
	struct hawser_report report;

	for (int i = 0; i < 4; i++) {
		point[i].t = t[i];
		point[i].at[0][0] = x[i];
		point[i].at[0][2] = z[round][i];
		point[i].given[0] = 1;
		point[i].given[1] = point[i].given[2] = i == 0 || i == 3;
	}
	return !hawser_path_waypoints(path, point, 4, HAWSER_MINIMISE_SNAP, &report);
}

static void turns(void)
{
	static const struct {
		int large, round;
		double after, wind, tilt, digits;
		const char *what;
	} row[] = {{0, 0, 50.0, -5.0, 0.042, 5e-4, "D 5.2.5, U-turn"},
	           {0, 1, 0.0, -5.0, 0.098, 5e-4, "D 5.2.6, round"},
	           {1, 0, 50.0, -5.0, 0.041, 5e-4, "D 5.3, U-turn"}};

	for (int i = 0; i < 3; i++) {
		struct hawser_tow_segment cable;
		struct hawser_tow tow = row[i].large
			? with_ring(&cable, 14.0, 0.004, 1.2, 435.0, 11.0, 0.07, 16.0)
			: with_ring(&cable, 10.0, 0.005, 1.3, 50.0, 1.0, 0.05, 1.0);
		struct hawser_tow_options options = {.every = row[i].round ? 0.1 : 0.25, .tolerance = 1e-4};
		struct hawser_tow_motion motion;
		double tilt = 0.0;

		tow.wind[0] = row[i].wind;
		if (!ok(turn_path(&tow.path, row[i].round), "path"))
			continue;
		if (move(&motion, &tow, &options, row[i].what)) {
			for (int k = 0; k < motion.samples; k++)
				if (motion.sample[k].t > row[i].after)
					tilt = fmax(tilt, motion.sample[k].tilt);
			ok(fabs(tilt - row[i].tilt) < row[i].digits, "%s: tilt %.3f: %.5f", row[i].what,
			   row[i].tilt, tilt);
			hawser_tow_motion_clear(&motion);
		}
		hawser_path_clear(&tow.path);
	}
}

/* D 5.3: from rest to 27.8 and 32.8 m/s; at the end the steady state. */
static void forward(double speed, double top)
{
	struct hawser_tow_segment cable;
	struct hawser_tow tow = with_ring(&cable, 14.0, 0.004, 1.2, 435.0, 11.0, 0.07, 16.0);
	struct hawser_tow_options options = {.until = 150.0, .every = 10.0, .tolerance = 1e-3};
	struct hawser_tow_steady steady;
	struct hawser_tow_motion motion;
	struct hawser_report report;
	double velocity[3] = {speed, 0.0, 0.0};

	if (hawser_path_straight(&tow.path, origin, velocity, 32.0, HAWSER_PATH_RAMP_ERF, &report) ||
	    hawser_tow_steady_solve(&steady, &tow, &report)) {
		ok(0, "%s", report.message);
		return;
	}
	ok(fabs(steady.tension_top - top) < 0.5, "steady: %.2f N", steady.tension_top);
	if (move(&motion, &tow, &options, "D 5.3, forward flight")) {
		const struct hawser_tow_sample *last = &motion.sample[motion.samples - 1];

		/* 1e-6; the steady state has a mesh of twice the elements */
		ok(fabs(last->tilt + steady.tilt) < 1e-6, "it ends on the steady state: tilt %.7f, %.7f",
		   -last->tilt, steady.tilt);
		ok(fabs(last->tension_top - steady.tension_top) < 1e-6*top + 0.01, "top %.3f N",
		   last->tension_top);
		hawser_tow_motion_clear(&motion);
	}
	hawser_tow_steady_clear(&steady);
}

/* The start in an orbit is at rest in the turning frame, and stays so: drag, spin and inertia of the
 * ring agree in statics and in motion. */
static void orbit(int joint)
{
	struct hawser_tow_segment cable;
	struct hawser_tow tow = with_ring(&cable, 14.0, 0.004, 1.2, 435.0, 11.0, 0.07, 16.0);
	struct hawser_tow_options options = {.until = 3.0, .every = 0.5, .step = 0.02};
	struct hawser_tow_motion motion;
	struct hawser_report report;
	double worst = 0.0, pull = 0.0;

	tow.body.joint = joint;
	tow.body.torsion = 3e3;
	tow.clamped = joint == HAWSER_TOW_CLAMPED;
	if (hawser_path_orbit(&tow.path, origin, 60.0, 13.9, 0.0, HAWSER_PATH_RAMP_SMOOTH, &report) ||
	    !move(&motion, &tow, &options, "an orbit"))
		return;
	for (int i = 1; i < motion.samples; i++) {
		const struct hawser_tow_sample *a = &motion.sample[0], *b = &motion.sample[i];

		worst = fmax(worst, fabs(hypot(a->body[0], a->body[2]) - hypot(b->body[0], b->body[2])));
		worst = fmax(worst, fabs(a->body[1] - b->body[1]));
		pull = fmax(pull, fabs(a->tension_top/b->tension_top - 1.0));
	}
	ok(worst < 2e-3 && pull < 2e-3, "it stays: %.1e m, tension to %.1e", worst, pull);
	hawser_tow_motion_clear(&motion);
}

/* Amplitude at a frequency of each `stride`th acceleration across the wind, dt apart, as second
 * differences of the rows. */
static double amplitude(const struct hawser_tow_motion *motion, int stride, double dt, double frequency)
{
	const struct hawser_tow_sample *at = motion->sample;
	double re = 0.0, im = 0.0;
	int count = 0;

	for (int i = 1; i < motion->samples - 1; i += stride, count++) {
		double value = at[i + 1].end[2] - 2.0*at[i].end[2] + at[i - 1].end[2];
		double angle = 2.0*PI*frequency*dt*count;

		re += value*cos(angle);
		im += value*sin(angle);
	}
	return hypot(re, im)*2.0/count;
}

/* St V/d in a wind of V across a cable at rest; samples of 0.01 s show 110 Hz as 10, 440 as 40, 137.5
 * as 37.5, as D's steps of this length do. */
static void shedding(double frequency, double shown)
{
	struct hawser_tow_segment cable = {.length = 1.0, .rho = 0.09, .EA = 3e5, .EI = 2.0,
	                                   .diameter = 0.01,
	                                   .normal = 1.2, .elements = 3, .lift = 0.6, .strouhal = 0.22};
	struct hawser_tow tow = {.g = 9.81, .density = 1.2, .segment = &cable, .segments = 1, .clamped = 1};
	struct hawser_tow_options options = {.until = 0.8, .step = 0.01, .every = 0.01};
	struct hawser_tow_motion motion;
	struct hawser_report report = {0};

	tow.wind[0] = frequency*cable.diameter/cable.strouhal;
	cable.normal = 0.0; /* it hangs straight, and all of it sheds at one frequency */
	if (hawser_path_straight(&tow.path, origin, origin, 0.0, HAWSER_PATH_RAMP_SMOOTH, &report))
		return;
	ok(hawser_tow_move(&motion, &tow, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "--step 0.01 s is too long for vortex shedding"), "%s", report.message);
	options.step = options.every = 0.01/(ceil(0.25*frequency) + 1.0);
	/* not by `move`: with no momentum to speak of, its gap has no measure */
	if (!ok(!hawser_tow_move(&motion, &tow, &options, &report), "vortex shedding"))
		return;
	close_to(motion.frequency, frequency, 1e-3, "its frequency");
	{
		int stride = (int)floor(0.01/options.every + 0.5);
		double own = amplitude(&motion, 1, options.every, frequency);
		double alias = amplitude(&motion, stride, 0.01, shown);

		ok(own > 0.0 && fabs(alias/own - 1.0) < 0.3 &&
		   own > 3.0*amplitude(&motion, 1, options.every, shown),
		   "%g Hz are shown as %g Hz by each %dth row, %.2f times as large", frequency, shown, stride,
		   alias/own);
	}
	hawser_tow_motion_clear(&motion);
}

CASE(reference_tow_motion)
{
	turns();
	forward(27.8, 5752.0);
	if (getenv("HAWSER_LONG"))
		forward(32.8, 7205.0);
	orbit(HAWSER_TOW_CLAMPED);
	orbit(HAWSER_TOW_JOINT);
	orbit(HAWSER_TOW_SPRING);
	shedding(110.0, 10.0);
	shedding(137.5, 37.5);
	shedding(440.0, 40.0);
	return done_testing();
}
