/* tests/property/test-campbell.c - sweeps of the speed: modes at rest at one end, the limits known
 * from theory, branches that keep their identity through veerings, the end of the steady state,
 * failures.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/campbell.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/tap.h"

/* B Table 5.3, travelling with constant tension. */
static struct hawser_scene table_5_3(void)
{
	struct hawser_scene scene = {0};

	scene.cable.EA = 100e6;
	scene.cable.rho = 5.0;
	scene.span.d = 100.0;
	scene.span.h = 5.0;
	scene.g = 9.81;
	scene.tension.given = HAWSER_GIVEN_T0;
	scene.tension.value = 85e3;
	scene.travel.present = 1;
	scene.travel.hold = HAWSER_HOLD_TENSION;
	return scene;
}

static int trace(struct hawser_campbell *campbell, const struct hawser_scene *scene,
                 struct hawser_campbell_options options)
{
	struct hawser_report report = {0};
	enum hawser_status status = hawser_campbell_trace(campbell, scene, &options, &report);

	return ok(!status, "h/d %.3g: a sweep of %d points %s", scene->span.h/scene->span.d,
	          options.points, report.message);
}

static double im(const struct hawser_campbell *campbell, int i, int b)
{
	return campbell->im[i*campbell->branches + b];
}

/* The first station at that speed or at a higher one. */
static int station_at(const struct hawser_campbell *campbell, double speed)
{
	int i = 0;

	while (i + 1 < campbell->stations && campbell->station[i].speed < speed*(1.0 - 1e-12))
		i++;
	return i;
}

static void rest(void)
{
	struct hawser_scene scene = table_5_3();
	struct hawser_campbell_options options = {.to = 30.0, .points = 4, .n = 8};
	const struct hawser_modes_options choice = {.n = 8};
	struct hawser_campbell campbell;
	struct hawser_modes modes = {0};
	int next[2] = {0}, same = 1;

	if (!trace(&campbell, &scene, options))
		return;
	next[HAWSER_OUT_OF_PLANE] = campbell.in_plane;
	if (ok(!hawser_modes_solve(&modes, &campbell.station[0].statics, &choice, NULL), "modes at "
	       "rest"))
		for (int k = 0; k < 8; k++)
			same = same && fabs(im(&campbell, 0, next[modes.mode[k].plane]++)
			                    *modes.time_unit/modes.mode[k].omega - 1.0) < 1e-13;
	ok(same, "at speed 0 the resting modes, but for the size of the basis");
	ok(campbell.criticals == 0 && campbell.limit > 127.556 && campbell.limit < 127.557,
	   "nothing critical below the limit of %.9g m/s", campbell.limit);
	hawser_modes_clear(&modes);
	hawser_campbell_clear(&campbell);
}

/* A string with hardly any weight. The classical result is n pi sqrt(H/rho)/d (1 - v^2/c^2); the
 * first frequency vanishes when v reaches the wave speed c. */
static void taut(void)
{
	struct hawser_scene scene = table_5_3();
	struct hawser_campbell_options options = {.from = 0.0, .to = 0.95*130.0, .points = 20, .n = 6};
	struct hawser_campbell campbell;
	double worst = 0.0;

	scene.g = 1e-6;
	scene.span.h = 0.0;
	scene.tension.given = HAWSER_GIVEN_H;
	if (!trace(&campbell, &scene, options))
		return;
	for (int i = 0; i < campbell.stations; i++)
		for (int b = 0; b < campbell.branches; b++) {
			/* Waves at the speed c along the cable at rest, which is stretched: s^2 = t + nu^2 of
			 * the apparent one, n pi s (1 - nu^2/s^2)/l */
			const struct hawser_statics *st = &campbell.station[i].statics;
			double t = 1.0/(1.0 + st->epsilon), nu = st->motion.nu, c = sqrt(t + nu*nu);
			double want = campbell.branch[b].number*M_PI/st->l*c*(1.0 - nu*nu/(c*c))
			              *sqrt(st->H/st->span.rho)/st->span.d;

			worst = fmax(worst, fabs(im(&campbell, i, b)/want - 1.0));
		}
	ok(worst < 1e-8, "a string: n pi (1 - nu^2) at all speeds, off by %.1e", worst);
	hawser_campbell_clear(&campbell);
}

/* So nearly taut that the branches reach 0 at the end of the steady state. */
static void end_of_string(void)
{
	struct hawser_scene scene = table_5_3();
	struct hawser_campbell_options options = {.points = 10, .n = 2};
	struct hawser_campbell campbell;

	scene.g = 1e-4;
	scene.span.h = 0.0;
	if (!trace(&campbell, &scene, options))
		return;
	ok(campbell.criticals == 1 && campbell.critical[0].kind == HAWSER_CRITICAL_NO_STEADY_STATE
	   && campbell.critical[0].speed == campbell.limit, "the steady state ends at %.12g m/s",
	   campbell.limit);
	/* (1 - m) T0 - rho v^2 = 0, less the effect of the small weight */
	close_to(campbell.limit, sqrt(85e3/5.0/(1.0 + 85e3/100e6)), 1e-5, "where the tension is used up");
	ok(im(&campbell, campbell.stations - 1, 0) < 2e-3*im(&campbell, 0, 0),
	   "and the first frequency is down to %.1e of itself",
	   im(&campbell, campbell.stations - 1, 0)/im(&campbell, 0, 0));
	hawser_campbell_clear(&campbell);
}

static const struct hawser_campbell_crossover *first_of(const struct hawser_campbell *campbell,
                                                        int below, int above)
{
	for (int k = 0; k < campbell->crossovers; k++)
		if (campbell->crossover[k].below == below && campbell->crossover[k].above == above)
			return campbell->crossover + k;
	return NULL;
}

/* The fictitious cable of B Table 4.1: transverse branches cross its first longitudinal branch as
 * the speed increases. */
static struct hawser_scene veering_scene(double h)
{
	struct hawser_scene scene = table_5_3();

	scene.cable.EA = 1e6;
	scene.cable.rho = 3.0;
	scene.span.h = h;
	scene.tension.value = 20e3;
	return scene;
}

/* Relative gap of the neighbouring in-plane frequencies k, k + 1, from a separate solution. */
static double gap_at(const struct hawser_scene *scene, double speed, int k)
{
	const struct hawser_span span = {scene->cable.EA, scene->cable.rho, scene->g, scene->span.d,
	                                 scene->span.h};
	const struct hawser_motion motion = {.speed = speed, .hold = scene->travel.hold};
	const struct hawser_modes_options options = {.n = 2*k + 6};
	struct hawser_modes modes = {0};
	struct hawser_statics st;
	double omega[2] = {NAN, NAN}, gap;

	if (hawser_statics_travel(&st, &span, scene->tension.given, scene->tension.value,
	                          scene->tension.branch, &motion, NULL)
	    || hawser_complex_modes_solve(&modes, &st, &options, NULL))
		return NAN;
	for (int i = 0, place = 0; i < modes.n; i++)
		if (modes.mode[i].plane == HAWSER_IN_PLANE) {
			if (place == k || place == k + 1)
				omega[place - k] = modes.mode[i].omega;
			place++;
		}
	gap = 2.0*(omega[1] - omega[0])/(omega[1] + omega[0]);
	hawser_modes_clear(&modes);
	return gap;
}

static void check_meeting(const struct hawser_scene *scene, const struct hawser_campbell *coarse,
                          const struct hawser_campbell *fine, int below)
{
	const struct hawser_campbell_crossover *at = first_of(coarse, below, below + 1);
	const struct hawser_campbell_crossover *again = first_of(fine, below, below + 1);
	int last = coarse->stations - 1;
	const enum hawser_family *family = coarse->family + below - 1;

	if (!ok(at && again && at->kind == HAWSER_VEERING, "branches %d and %d veer", below, below + 1))
		return;
	close_to(at->speed, again->speed, 1e-7, "from any stations at the same speed");
	close_to(at->relative_gap, again->relative_gap, 1e-6, "with the same gap");
	close_to(gap_at(scene, at->speed, below - 1), at->relative_gap, 1e-6,
	         "and by a solution of its own");
	ok(gap_at(scene, at->speed - 1e-2, below - 1) > at->relative_gap*(1.0 + 1e-6)
	   && gap_at(scene, at->speed + 1e-2, below - 1) > at->relative_gap*(1.0 + 1e-6),
	   "which is least there");
	ok(family[0] == HAWSER_LONGITUDINAL && family[1] == HAWSER_TRANSVERSE
	   && family[last*coarse->branches] == HAWSER_TRANSVERSE
	   && family[last*coarse->branches + 1] == HAWSER_LONGITUDINAL,
	   "the branches keep their order, and their shapes change hands");
}

/* Sweeps of 7 and of 31 stations (241 with HAWSER_LONG) must agree on a gap that is 5e-4 of the
 * frequency and a tenth of a coarse step wide. */
static void veering(double h)
{
	struct hawser_scene scene = veering_scene(h);
	struct hawser_campbell_options few = {.from = 30.0, .to = 42.0, .points = 7, .n = 20};
	struct hawser_campbell_options many = {.from = 30.0, .to = 42.0, .n = 20,
	                                       .points = getenv("HAWSER_LONG") ? 241 : 19};
	struct hawser_campbell coarse, fine = {0};
	int same = 1, sorted = 1;

	if (!trace(&coarse, &scene, few))
		return;
	if (!trace(&fine, &scene, many))
		goto done;
	for (int i = 0; i < coarse.stations; i++)
		for (int k = 0; k < coarse.branches && !coarse.station[i].inserted; k++) {
			int j = station_at(&fine, coarse.station[i].speed);

			same = same && fabs(coarse.station[i].speed - fine.station[j].speed) < 1e-9
			       && fabs(im(&coarse, i, k)/im(&fine, j, k) - 1.0) < 1e-9;
		}
	for (int i = 0; i < fine.stations; i++)
		for (int k = 0; k + 1 < fine.in_plane; k++)
			sorted = sorted && im(&fine, i, k) < im(&fine, i, k + 1);
	ok(same, "branches of %d and of %d stations are the same ones", coarse.stations, fine.stations);
	ok(sorted, "and keep their order");
	check_meeting(&scene, &coarse, &fine, 9);
	ok(coarse.unsure == 0 && coarse.least_correlation > 0.9 && fine.least_correlation > 0.9,
	   "no doubt about any of them (%.3f)", coarse.least_correlation);
done:
	hawser_campbell_clear(&coarse);
	hawser_campbell_clear(&fine);
}

static void end_state(void)
{
	struct hawser_scene scene = table_5_3();
	struct hawser_campbell_options options = {.to = 500.0, .points = 30, .n = 6};
	struct hawser_campbell campbell;
	double left[2] = {0.0};
	int last, k = 0;

	if (!trace(&campbell, &scene, options))
		return;
	last = campbell.stations - 1;
	ok(campbell.criticals == 1 && campbell.critical[0].plane == HAWSER_IN_PLANE,
	   "beyond the limit the sweep ends at it");
	ok(campbell.station[last].speed > (1.0 - 2e-9)*campbell.limit
	   && campbell.station[last].speed < campbell.limit, "to 1e-9 of it");
	for (int i = last - 8; i < last - 4; i += 2, k++)
		left[k] = im(&campbell, i, 0) - im(&campbell, last, 0);
	ok(left[0] > 0.0 && fabs(left[0]/left[1] - 4.0) < 0.2,
	   "frequencies go with the square root of what is left: %.3f for 16", left[0]/left[1]);
	for (int i = 0; i < campbell.stations*campbell.branches; i++)
		if (campbell.re[i] != 0.0)
			ok(0, "a real part of %g", campbell.re[i]);
	hawser_campbell_clear(&campbell);
}

/* Requested speeds so close to the limit that one of them is also a station of the approach: no
 * station may occur twice. */
static void last_steps(void)
{
	const struct hawser_scene scene = table_5_3();
	struct hawser_campbell campbell;
	double to, limit;

	if (!ok(!hawser_campbell_range(&to, &limit, &scene, NULL), "a limit"))
		return;
	for (int k = 0; k < 8; k++) {
		double left = (double[]){2e-9, 3e-9, 4e-9, 1.3e-9, 1.26e-9, 2.6e-9, 1e-8, 1e-7}[k];
		struct hawser_campbell_options options = {.from = limit*(1.0 - left), .n = 3,
		                                          .points = k < 3 ? k + 3 : 4};
		double least = limit;

		if (!trace(&campbell, &scene, options))
			continue;
		for (int i = 1; i < campbell.stations; i++)
			least = fmin(least, campbell.station[i].speed - campbell.station[i - 1].speed);
		ok(campbell.stations > 1 && least > 1e-10*limit && !campbell.unsure,
		   "from %g below the limit: %d stations, the nearest %.2g of the limit apart", left,
		   campbell.stations, least/limit);
		hawser_campbell_clear(&campbell);
	}
}

static void held_length(void)
{
	struct hawser_scene scene = table_5_3();
	struct hawser_campbell_options options = {.points = 12, .n = 4};
	struct hawser_campbell campbell;

	scene.travel.hold = HAWSER_HOLD_LENGTH;
	if (!trace(&campbell, &scene, options))
		return;
	close_to(campbell.station[campbell.stations - 1].speed, 2.0*sqrt(85e3/5.0), 1e-12,
	         "length held: to twice the speed of waves");
	ok(campbell.criticals == 0, "where nothing ends");
	hawser_campbell_clear(&campbell);
}

static void resonances(void)
{
	struct hawser_scene scene = table_5_3();
	struct hawser_campbell_options options = {.to = 40.0, .points = 81, .n = 4};
	struct hawser_campbell_resonance *list = NULL;
	struct hawser_campbell campbell;
	int count = 0, on = 1;

	if (!trace(&campbell, &scene, options))
		return;
	ok(!hawser_campbell_resonances(&list, &count, &campbell, 23.85, 3, NULL) && count == 12,
	   "three harmonics meet four branches (%d times)", count);
	for (int k = 0; k < count; k++) {
		int i = station_at(&campbell, list[k].speed);

		on = on && fabs(list[k].omega - list[k].harmonic*2.0*M_PI*list[k].speed/23.85)
		           < 1e-12*list[k].omega
		     && fabs(list[k].omega/im(&campbell, i, list[k].branch) - 1.0) < 2e-2;
	}
	ok(on, "on the lines and on the branches");
	free(list);
	ok(hawser_campbell_resonances(&list, &count, &campbell, 0.0, 3, NULL) == HAWSER_ERR_ARGUMENT
	   && !list
	   && hawser_campbell_resonances(&list, &count, &campbell, 1.0, 0, NULL) == HAWSER_ERR_ARGUMENT,
	   "no spacing or no harmonic is refused");
	hawser_campbell_clear(&campbell);
}

static void refuse(struct hawser_scene scene, struct hawser_campbell_options options,
                   enum hawser_status want, const char *word)
{
	struct hawser_report report = {0};
	struct hawser_campbell campbell;
	enum hawser_status status = hawser_campbell_trace(&campbell, &scene, &options, &report);

	ok(status == want && report.status == want && strstr(report.message, word) &&
	   !campbell.station, "refused (%s): %s", hawser_status_name(status), report.message);
	hawser_campbell_clear(&campbell);
}

static void refusals(void)
{
	typedef struct hawser_campbell_options options;
	struct hawser_scene scene = table_5_3(), other;
	double to, limit = NAN;

	ok(!hawser_campbell_range(&to, &limit, &scene, NULL), "there is a limit");
	refuse(scene, (options){.n = -1}, HAWSER_ERR_ARGUMENT, "branches");
	refuse(scene, (options){.n = 501}, HAWSER_ERR_ARGUMENT, "501");
	refuse(scene, (options){.points = 1}, HAWSER_ERR_ARGUMENT, "points");
	refuse(scene, (options){.from = 7.0, .to = 7.0}, HAWSER_ERR_ARGUMENT, "7 to 7");
	refuse(scene, (options){.from = -2.0, .to = 7.0}, HAWSER_ERR_ARGUMENT, "negative");
	refuse(scene, (options){.from = NAN, .to = 7.0}, HAWSER_ERR_ARGUMENT, "nan");
	refuse(scene, (options){.correlation = 0.3}, HAWSER_ERR_ARGUMENT, "correlation");
	refuse(scene, (options){.crossing = 0.1}, HAWSER_ERR_ARGUMENT, "crossings");
	refuse(scene, (options){.method = "none of them"}, HAWSER_ERR_ARGUMENT, "none of them");
	refuse(scene, (options){.from = 128.0, .to = 140.0}, HAWSER_ERR_NO_SOLUTION, "127.55");
	refuse(scene, (options){.from = limit*(1.0 - 9e-10), .to = 140.0}, HAWSER_ERR_NO_SOLUTION,
	       "too near");
	other = scene;
	other.travel.present = 0;
	refuse(other, (options){0}, HAWSER_ERR_ARGUMENT, "travel");
	other = scene;
	other.cable.EA = INFINITY;
	refuse(other, (options){0}, HAWSER_ERR_NO_SOLUTION, "inextensible");
	other = scene;
	other.tension.value = 200.0;
	refuse(other, (options){0}, HAWSER_ERR_NO_SOLUTION, "N");
	hawser_campbell_clear(NULL);
	ok(strcmp(hawser_critical_name(HAWSER_CRITICAL_FLUTTER), "flutter") == 0
	   && strcmp(hawser_critical_name(HAWSER_CRITICAL_DIVERGENCE), "divergence") == 0,
	   "kinds have names");
}

CASE(property_campbell)
{
	rest();
	taut();
	end_of_string();
	veering(0.0);
	veering(5.0);
	end_state();
	last_steps();
	held_length();
	resonances();
	refusals();
	return done_testing();
}
