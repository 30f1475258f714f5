/* Fold curves by other routes: the folds of the response, models with another load, settled motion
 * on an isola, the range in the opposite direction.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/folds.h>
#include <hawser/integrate.h>

#include "tests/tap.h"

static int open_model(struct hawser_rom *rom, const char *name)
{
	const char *path = source_file("tests/reference/%s.json", name);

	return ok(!hawser_rom_open(rom, path, NULL), "%s read", path);
}

/* What is done of the search rises from 0 to 1. */
struct told {
	double last, largest_fall;
	int count;
};

static int tell(void *data, const struct hawser_progress_state *state)
{
	struct told *told = data;

	told->largest_fall = fmax(told->largest_fall, told->last - state->fraction);
	told->last = state->fraction;
	told->count += isfinite(state->fraction) && state->fraction <= 1.0;
	return 0;
}

/* starts: pseudo-random motions, 0 for as many as by default, HAWSER_NONE where the curves are
 * found without. */
static int trace(struct hawser_folds *folds, const struct hawser_rom *rom, double from, double to,
                 int starts)
{
	struct hawser_folds_options options = {.method = NULL};
	struct told told = {.count = 0};
	struct hawser_report report = {.message = ""};
	enum hawser_status status;

	options.from = from;
	options.to = to;
	options.load_from = 0.05;
	options.starts = starts;
	options.progress = (struct hawser_progress){tell, &told};
	options.method = "shooting"; /* the curves are computed by harmonic balance, the folds by
	                              * another method */
	status = hawser_folds_trace(folds, rom, &options, &report);
	ok(told.count > 0 && told.largest_fall <= 0.0 && told.last > 0.5,
	   "its progress rises, to %g", told.last);
	return ok(!status, "traced %s", report.message);
}

/* Relative distance of Omega from the nearest crossing of the nominal load. */
static double passage(const struct hawser_folds *folds, double omega)
{
	double best = INFINITY;

	for (int e = 0; e < folds->events; e++)
		if (folds->event[e].kind == HAWSER_FOLDS_NOMINAL)
			best = fmin(best, fabs(folds->event[e].omega/omega - 1.0));
	return best;
}

static int count(const struct hawser_folds *folds, enum hawser_folds_kind kind)
{
	int found = 0;

	for (int e = 0; e < folds->events; e++)
		found += folds->event[e].kind == kind;
	return found;
}

/* Every fold of the response lies on a curve, and every crossing of the nominal load is a fold of
 * the response or of a detached curve, as located by hawser_frf_trace. */
static void check_nominal(const struct hawser_folds *folds, const char *name)
{
	int all = 0;
	double worst = 0.0;

	for (int k = -1; k < folds->isolas; k++) {
		const struct hawser_frf *frf = k < 0 ? &folds->response : &folds->isola[k];

		for (int e = 0; e < frf->events; e++)
			if (frf->event[e].kind == HAWSER_FOLD) {
				worst = fmax(worst, passage(folds, frf->event[e].omega));
				all++;
			}
	}
	ok(worst < 1e-8, "%s: %d folds of responses are on the curves: %.1e", name, all, worst);
	ok(count(folds, HAWSER_FOLDS_NOMINAL) == all && folds->lost == 0,
	   "%s: %d passages", name, count(folds, HAWSER_FOLDS_NOMINAL));
	for (int e = 0; e < folds->events; e++)
		ok(folds->event[e].kind == HAWSER_FOLDS_NOMINAL || (folds->event[e].minimum != 0 &&
		   folds->event[e].residual < 1e-8), "%s: %s at load %.9g located to %.1e", name,
		   hawser_folds_kind_name(folds->event[e].kind), folds->event[e].load,
		   folds->event[e].residual);
}

static void check_curves(const char *name, double from, double to)
{
	struct hawser_folds folds;
	struct hawser_rom rom;

	if (!open_model(&rom, name))
		return;
	if (trace(&folds, &rom, from, to, HAWSER_NONE))
		check_nominal(&folds, name);
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
}

/* The same oscillators at f = 1e-3 and 3e-3: the cusp is at the same load. */
static void check_scaling(void)
{
	static const char *const name[] = {"springs-nlvib-06-f1e-3", "springs-nlvib-06-f3e-3"};
	double load[2] = {0}, omega[2] = {0};

	for (int k = 0; k < 2; k++) {
		struct hawser_folds folds;
		struct hawser_rom rom;

		if (!open_model(&rom, name[k]))
			return;
		if (trace(&folds, &rom, 0.95, 1.15, HAWSER_NONE))
			for (int e = 0; e < folds.events; e++)
				if (folds.event[e].kind == HAWSER_FOLDS_CUSP) {
					load[k] = folds.event[e].load*rom.harmonic[0].f[0];
					omega[k] = folds.event[e].omega;
				}
		hawser_folds_clear(&folds);
		hawser_rom_clear(&rom);
	}
	close_to(load[0], load[1], 1e-9, "load of the cusp, from two models");
	close_to(omega[0], omega[1], 1e-9, "its Omega");
}

/* Below the cusp the response has no fold, above it two. */
static void check_jumps(void)
{
	static const double factor[] = {0.2994, 0.2999};
	struct hawser_rom rom;

	if (!open_model(&rom, "duffing-nlvib-01"))
		return;
	for (int k = 0; k < 2; k++) {
		struct hawser_frf_options options = {.method = NULL};
		struct hawser_frf frf;
		double f = rom.harmonic[0].f[0];
		enum hawser_status status;

		options.from = 0.9;
		options.to = 1.2;
		rom.harmonic[0].f[0] = factor[k]*f;
		status = hawser_frf_trace(&frf, &rom, &options, NULL);
		ok(!status && frf.events == 2*k, "load factor %g: %d folds", factor[k],
		   frf.events);
		rom.harmonic[0].f[0] = f;
		hawser_frf_clear(&frf);
	}
	hawser_rom_clear(&rom);
}

/* A stable motion on the isola remains there, and differs from the main one. */
static void check_isola(const struct hawser_folds *folds, const struct hawser_rom *rom)
{
	const struct hawser_frf *isola = folds->isola, *main = &folds->response;
	struct hawser_integrate_options options = {0};
	struct hawser_trajectory run;
	int stable = -1;
	double omega, end = 0.0, lower = INFINITY;

	if (!ok(folds->isolas == 1, "an isola"))
		return;
	/* the point where a disturbance decays fastest: its largest multiplier is smallest */
	for (int i = 0; i < isola->points; i++)
		if (isola->point[i].unstable == 0 && (stable < 0 ||
		    isola->multiplier[8*(size_t)i] < isola->multiplier[8*(size_t)stable]))
			stable = i;
	if (!ok(stable >= 0, "with a stable part"))
		return;
	omega = isola->point[stable].omega;
	options.omega = omega;
	options.until = 400.0*2.0*M_PI/omega;
	options.every = 2.0*M_PI/omega;
	options.initial = isola->state + 4*(size_t)stable;
	ok(!hawser_integrate(&run, rom, &options, NULL), "400 periods");
	for (int i = 0; i < 4; i++)
		end = fmax(end, fabs(run.state[4*(size_t)(run.rows - 1) + (size_t)i] -
		                     options.initial[i]));
	ok(end < 1e-6, "the motion stays on the isola: %.1e", end);
	for (int i = 0; i < main->points; i++)
		if (fabs(main->point[i].omega - omega) < 0.02)
			lower = fmin(lower, fabs(main->coordinate[2*(size_t)i] -
			                         isola->coordinate[2*(size_t)stable]));
	ok(lower > 0.1, "the main response is %.2g away", lower);
	hawser_trajectory_clear(&run);
}

/* From the other end of the range: the same special points. (At twice the load the response that
 * begins at Omega 3 is another one, with a fold of a curve that lies above the nominal load.) */
static void check_reverse(const struct hawser_folds *a, const struct hawser_rom *rom)
{
	struct hawser_folds b;

	if (trace(&b, rom, 3.0, 0.5, HAWSER_NONE)) {
		double worst = 0.0;

		ok(count(a, HAWSER_FOLDS_NOMINAL) == 6 && count(&b, HAWSER_FOLDS_NOMINAL) == 6 &&
		   a->events == 11 && b.events == 11, "%d and %d events", a->events, b.events);
		for (int i = 0; i < b.events; i++) {
			double best = INFINITY;

			for (int k = 0; k < a->events; k++)
				if (a->event[k].kind == b.event[i].kind)
					best = fmin(best, hypot(a->event[k].omega - b.event[i].omega,
					                        a->event[k].load - b.event[i].load));
			worst = fmax(worst, best);
		}
		ok(worst < 1e-8, "they are the same: %.1e", worst);
	}
	hawser_folds_clear(&b);
}

/* Without multipliers a response has the same folds, and nothing else. */
static void check_unjudged(const struct hawser_folds *folds, const struct hawser_rom *rom)
{
	struct hawser_frf_options options = {.from = 0.5, .to = 3.0, .unjudged = 1};
	struct hawser_frf frf;
	double worst = 0.0;
	int all = 0, others = 0;
	enum hawser_status status = hawser_frf_trace(&frf, rom, &options, NULL);

	for (int e = 0; e < folds->response.events; e++)
		all += folds->response.event[e].kind == HAWSER_FOLD;
	for (int e = 0; e < frf.events; e++) {
		others += frf.event[e].kind != HAWSER_FOLD;
		worst = fmax(worst, passage(folds, frf.event[e].omega));
	}
	ok(!status && all > 1 && frf.events == all && others == 0 && worst < 1e-8,
	   "without multipliers: %d of %d folds, %.1e away", frf.events, all, worst);
	hawser_frf_clear(&frf);
}

/* All of it for one model, traced once. */
static void check_absorber(void)
{
	struct hawser_folds folds;
	struct hawser_rom rom;

	if (!open_model(&rom, "absorber"))
		return;
	if (trace(&folds, &rom, 0.5, 3.0, 0)) {
		check_nominal(&folds, "absorber");
		check_isola(&folds, &rom);
		check_unjudged(&folds, &rom);
		check_reverse(&folds, &rom);
	}
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
}

CASE(property_folds)
{
	check_curves("duffing-nlvib-01", 0.8, 1.8);
	check_curves("pair-2to1", 0.55, 1.3);
	check_scaling();
	check_jumps();
	check_absorber();
	return done_testing();
}
