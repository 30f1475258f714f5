/* Fold curves in extreme cases: no fold, no damping, a range that cuts the curve, a limit of points, an
 * interruption; and every failure.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/folds.h>

#include "response/locus/folds_search.h"
#include "tests/folds-duffing.h"
#include "tests/tap.h"

static struct hawser_folds_options between(double from, double to)
{
	struct hawser_folds_options options = {.starts = HAWSER_NONE};

	options.from = from;
	options.to = to;
	return options;
}

static void check_none(void)
{
	struct hawser_folds_options options = between(0.5, 2.0);
	struct hawser_report report = {.message = ""};
	struct hawser_folds folds;
	struct hawser_rom rom;
	enum hawser_status status;

	if (!ok(!duffing(&rom, 0.03, 0.0, 0.2), "a linear model"))
		return;
	status = hawser_folds_trace(&folds, &rom, &options, &report);
	ok(status == HAWSER_ERR_NO_SOLUTION, "has no fold: %s", report.message);
	ok(folds.curves == 0 && folds.response.points > 10, "its response is there");
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
}

/* The initial load is too small for folds: the folds are those of the largest load. */
static void check_weak(void)
{
	struct hawser_folds_options options = between(0.8, 2.0);
	struct hawser_folds folds;
	struct hawser_rom rom;

	if (!ok(!duffing(&rom, 0.05, 0.1, 0.02), "below its cusp"))
		return;
	options.load_to = 5.0;
	ok(!hawser_folds_trace(&folds, &rom, &options, NULL) && folds.curves == 1 &&
	   folds.events == 1 && folds.event[0].kind == HAWSER_FOLDS_CUSP, "the cusp is found above");
	/* 0.29961728591 of f = 0.18, see tests/reference/test-folds.c */
	if (folds.events == 1)
		close_to(0.02*folds.event[0].load, 0.18*0.29961728591, 1e-9, "where it is");
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
}

/* Without damping the folds end where there is no load. One harmonic: (1 - Omega^2) a + (3/4) c a^3
 * = f, and its derivative by a: Omega^2 = 1 + (9/4) c a^2, f = -(3/2) c a^3. */
static void check_undamped(void)
{
	struct hawser_folds_options options = between(1.0005, 1.4);
	struct hawser_report report = {.message = ""};
	struct hawser_folds folds;
	struct hawser_rom rom;
	const double c = 0.1;
	enum hawser_status status;

	if (!ok(!duffing(&rom, 0.0, c, 0.01), "without damping"))
		return;
	options.load_from = 1e-3;
	/* the response comes from above, where it is bounded */
	options.from = 1.4;
	options.to = 1.0005;
	status = hawser_folds_trace(&folds, &rom, &options, &report);
	ok(!status, "traced: %s", report.message);
	if (ok(folds.curves == 1, "one curve")) {
		const struct hawser_folds_curve *curve = &folds.curve[0];
		double worst = 0.0;

		ok(curve->least_event == -1 && curve->events == 1, "no cusp");
		for (int i = curve->first; i < curve->first + curve->points; i++) {
			const struct hawser_folds_point *point = &folds.point[i];
			double a2 = (point->omega*point->omega - 1.0)/(2.25*c);

			/* higher harmonics count for some c a^2/32 */
			if (c*a2 < 0.01)
				worst = fmax(worst, fabs(0.01*point->load/(1.5*c*pow(a2, 1.5)) - 1.0));
		}
		ok(worst > 0.0 && worst < 1e-3, "as one harmonic has it: %.1e", worst);
	}
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
}

/* Ends of curves: at the ranges, exactly; at the limit of points. */
static void check_ends(void)
{
	/* from above the response meets the lower fold, and turns back out of the range */
	struct hawser_folds_options options = between(1.2, 0.8);
	struct hawser_folds folds;
	struct hawser_rom rom;

	if (!ok(!duffing(&rom, 0.05, 0.1, 0.18), "a Duffing oscillator"))
		return;
	options.load_from = 0.9;
	options.load_to = 1.2;
	ok(!hawser_folds_trace(&folds, &rom, &options, NULL) && folds.curves == 1, "one fold is left");
	if (folds.curves == 1) {
		const struct hawser_folds_curve *curve = &folds.curve[0];
		double first = folds.point[0].load, last = folds.point[curve->points - 1].load;

		ok(curve->end[0] == HAWSER_FOLDS_LOAD && curve->end[1] == HAWSER_FOLDS_LOAD &&
		   fmin(first, last) == 0.9 && fmax(first, last) == 1.2,
		   "from %.17g to %.17g: %s", first, last, hawser_folds_end_name(curve->end[0]));
	}
	hawser_folds_clear(&folds);
	options = between(0.8, 1.3);
	ok(!hawser_folds_trace(&folds, &rom, &options, NULL) && folds.curves == 1 &&
	   (folds.curve[0].end[0] == HAWSER_FOLDS_OMEGA || folds.curve[0].end[1] ==
	    HAWSER_FOLDS_OMEGA), "an end of the frequencies");
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
}

/* The limit of work applies to responses and curves together. */
static void check_work(void)
{
	struct hawser_folds_options options = between(0.8, 1.6);
	struct hawser_report report = {.message = ""};
	struct hawser_folds folds;
	struct hawser_rom rom;
	int points;

	if (!ok(!duffing(&rom, 0.05, 0.1, 0.18), "a Duffing oscillator"))
		return;
	ok(!hawser_folds_trace(&folds, &rom, &options, NULL) && !folds.costly, "without a limit");
	points = folds.points;
	options.most_work = 1.05*hawser_orbit_work(&folds.response.cost, &rom);
	hawser_folds_clear(&folds);
	ok(!hawser_folds_trace(&folds, &rom, &options, NULL) && folds.costly && folds.points < points &&
	   folds.curves > 0 && folds.curve[folds.curves - 1].end[0] == HAWSER_FOLDS_WORK &&
	   folds.least_kind == HAWSER_FOLDS_LEAST_BOUND, "ends with the work of little more than the "
	   "response, and the least load is a bound");
	hawser_folds_clear(&folds);
	options.most_work *= 0.1;
	ok(hawser_folds_trace(&folds, &rom, &options, &report) == HAWSER_ERR_CONVERGENCE &&
	   strstr(report.message, "no fold was found in the part"), "%s", report.message);
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
}

/* The limit of points applies to each direction of the curves and to the responses, and is reported. */
static void check_limit(void)
{
	struct hawser_folds_options options = between(1.1, 1.3);
	struct hawser_report report = {.message = ""};
	struct hawser_folds folds;
	struct hawser_rom rom;
	enum hawser_status status;
	int limited = 0, most = 0;

	if (!ok(!duffing(&rom, 0.05, 0.1, 0.18), "a Duffing oscillator"))
		return;
	options.max_points = 60; /* of the 138 that the response has: one of two folds */
	options.step_max = 0.002;
	status = hawser_folds_trace(&folds, &rom, &options, &report);
	ok(!status && folds.response.points == 60 && folds.response.end == HAWSER_END_MAX_POINTS,
	   "a response of %d points", folds.response.points);
	ok(strstr(folds.note, "load factor 1 ") && strstr(folds.note, "--max-points"), "told: %s",
	   folds.note);
	for (int c = 0; c < folds.curves; c++) {
		limited += folds.curve[c].end[0] == HAWSER_FOLDS_MAX_POINTS ||
		           folds.curve[c].end[1] == HAWSER_FOLDS_MAX_POINTS;
		most = folds.curve[c].points > most ? folds.curve[c].points : most;
	}
	ok(limited > 0 && most <= 119, "sixty points each way: %d at most, %d curves limited", most,
	   limited);
	hawser_folds_clear(&folds);
	options.max_points = 7;
	options.starts = 0;
	ok(!hawser_folds_trace(&folds, &rom, &options, &report) && strstr(folds.note, "--max-points"),
	   "seen by other motions, told: %s", folds.note);
	hawser_folds_clear(&folds);
	options.starts = HAWSER_NONE;
	status = hawser_folds_trace(&folds, &rom, &options, &report);
	ok(status == HAWSER_ERR_CONVERGENCE && strstr(report.message, "--max-points"),
	   "none seen is not none there: %s", report.message);
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
}

/* Folds from which no curve can be followed stay in the result. */
static void check_lost(void)
{
	struct hawser_folds folds = {.n = 1};
	struct hawser__fold_search search = {.folds = &folds};
	int failed = hawser__fold_lost(&search, 1.5, 1.0) || hawser__fold_lost(&search, 2.385, 4.0);

	ok(!failed && folds.lost == 2 && folds.lost_at[0].omega == 1.5 &&
	   folds.lost_at[1].omega == 2.385 && folds.lost_at[1].load == 4.0, "two that were lost");
	hawser_folds_clear(&folds);
	ok(!folds.lost_at && folds.lost == 0, "cleared");
}

static int stop_after(void *data, const struct hawser_progress_state *state)
{
	int *left = data;

	(void)state;
	return --*left < 0;
}

static void check_interruption(void)
{
	struct hawser_folds_options options = between(0.8, 1.8);
	struct hawser_folds folds;
	struct hawser_rom rom;
	int most_curves = 0, left;

	if (!ok(!duffing(&rom, 0.05, 0.1, 0.18), "a Duffing oscillator"))
		return;
	options.progress = (struct hawser_progress){stop_after, &left};
	for (int calls = 0; calls < 400; calls += 46) {
		enum hawser_status status;

		left = calls;
		status = hawser_folds_trace(&folds, &rom, &options, NULL);
		ok(!status && folds.interrupted, "interrupted after %d calls: %d points of the "
		   "response, %d of curves", calls, folds.response.points, folds.points);
		most_curves = folds.curves > most_curves ? folds.curves : most_curves;
		hawser_folds_clear(&folds);
	}
	ok(most_curves == 1, "some of them in a curve");
	hawser_rom_clear(&rom);
}

static void refuse(const struct hawser_rom *rom, const struct hawser_folds_options *options,
                   enum hawser_status want, const char *part)
{
	struct hawser_report report = {.message = ""};
	struct hawser_folds folds;
	enum hawser_status status = hawser_folds_trace(&folds, rom, options, &report);

	ok(status == want && strstr(report.message, part), "%s: %s", hawser_status_name(status),
	   report.message);
	hawser_folds_clear(&folds);
}

/* A not-a-number in the model is named, not reported as a failure to converge. */
static void check_nan(void)
{
	struct hawser_folds_options good = between(0.8, 1.8);
	struct hawser_rom rom;

	for (int which = 0; which < 3; which++) {
		if (!ok(!duffing(&rom, 0.05, 0.1, 0.18), "a Duffing oscillator"))
			return;
		*(which == 0 ? rom.K : which == 1 ? rom.D : rom.harmonic[0].f) = NAN;
		refuse(&rom, &good, HAWSER_ERR_NAN, "nan");
		hawser_rom_clear(&rom);
	}
}

static void check_refusals(void)
{
	struct hawser_folds_options good = between(0.8, 1.8), bad;
	struct hawser_rom rom;

	if (!ok(!duffing(&rom, 0.05, 0.1, 0.18), "a Duffing oscillator"))
		return;
	bad = between(1.0, 1.0);
	refuse(&rom, &bad, HAWSER_ERR_ARGUMENT, "different");
	bad = between(-1.0, 1.0);
	refuse(&rom, &bad, HAWSER_ERR_ARGUMENT, "positive");
	bad = good;
	bad.load_from = -0.01;
	refuse(&rom, &bad, HAWSER_ERR_ARGUMENT, "between 0 and 1");
	bad.load_from = 1.5;
	refuse(&rom, &bad, HAWSER_ERR_ARGUMENT, "between 0 and 1");
	bad = good;
	bad.load_to = 0.7;
	refuse(&rom, &bad, HAWSER_ERR_ARGUMENT, "1 or more");
	bad = good;
	bad.tolerance = 0.1;
	refuse(&rom, &bad, HAWSER_ERR_ARGUMENT, "tolerance");
	bad = good;
	bad.max_points = 1;
	refuse(&rom, &bad, HAWSER_ERR_ARGUMENT, "max points");
	bad = good;
	bad.method = "guess";
	refuse(&rom, &bad, HAWSER_ERR_ARGUMENT, "guess");
	rom.harmonic[0].f[0] = 0.0;
	refuse(&rom, &good, HAWSER_ERR_ARGUMENT, "no forcing");
	hawser_rom_clear(&rom);
	/* a softening spring escapes: there is no response at this load */
	if (ok(!duffing(&rom, 0.05, -1.0, 3.0), "a softening spring")) {
		bad = between(0.3, 0.6);
		refuse(&rom, &bad, HAWSER_ERR_CONVERGENCE, "Omega");
	}
	hawser_rom_clear(&rom);
	check_nan();
	hawser_folds_clear(NULL);
	ok(!strcmp(hawser_folds_kind_name((enum hawser_folds_kind)99), "unknown") &&
	   !strcmp(hawser_folds_end_name((enum hawser_folds_end)99), "unknown"), "unknown names");
}

/* A search that ends at the most work: it says so, counts no motions that it did not look at, and finds
 * what one without limit finds where only these are missing. */
static void check_part(void)
{
	struct hawser_folds_options options = {.from = 0.6, .to = 3.0, .starts = 96};
	struct hawser_report report;
	struct hawser_folds folds;
	struct hawser_rom rom;
	enum hawser_status status;

	if (!ok(!duffing(&rom, 0.05, 0.1, 0.01), "a response without folds"))
		return;
	for (int k = 0; k < 2; k++) { /* after the first orbit, and within the first response */
		options.most_work = k ? 1e-3 : 1e-9;
		status = hawser_folds_trace(&folds, &rom, &options, &report);
		ok(status == HAWSER_ERR_CONVERGENCE && folds.costly && folds.levels == 0 &&
		   strstr(report.message, "no fold was found in the part of the search that was done: fewer") &&
		   strstr(folds.note, "; no load was searched from both ends"), "%s; %s", report.message,
		   folds.note);
		hawser_folds_clear(&folds);
	}
	options.most_work = 0.1;
	status = hawser_folds_trace(&folds, &rom, &options, &report);
	ok(status == HAWSER_ERR_NO_SOLUTION && folds.costly && folds.searched && !folds.note[0] &&
	   folds.starts.starts < 96 && folds.starts.frequencies < 24 &&
	   folds.starts.known == folds.starts.starts && folds.starts.starts > 0,
	   "%d of 96 motions at %d frequencies: %s", folds.starts.starts, folds.starts.frequencies,
	   report.message);
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
}

CASE(extremes_folds_extremes)
{
	check_part();
	check_none();
	check_weak();
	check_undamped();
	check_ends();
	check_work();
	check_limit();
	check_lost();
	check_interruption();
	check_refusals();
	return done_testing();
}
