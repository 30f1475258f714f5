/* Fold curves against AUTO-07p. Its figures come from `hawser rom MODEL --export auto m`, where f is
 * multiplied by PAR(2) in m.f90, and from this m.auto, with NTST 60 and EPSL = EPSU = 1e-10:
 *
 *     r = run('m')
 *     k = dict(ISW=2, ICP=[2,1,11], ILP=1, ISP=0, DSMAX=0.1, NMX=600, RL0=0.05, RL1=2)
 *     s = run(r('LP1'), DS=0.001, **k)
 *     run(s('EP1'), DS=0.001, **k); run(s('EP1'), DS=-0.001, **k)
 *
 * (ICP=[1,2,11] and UZSTOP={2: ...} for the points at a given load). What AUTO calls a fold of the
 * curve (LP) is an extremum of PAR(2): a cusp, or an isola's birth or merger, which it does not tell
 * apart.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/folds.h>

#include "tests/tap.h"

static int open_model(struct hawser_rom *rom, const char *name)
{
	const char *path = source_file("tests/reference/%s.json", name);

	return ok(!hawser_rom_open(rom, path, NULL), "%s read", path);
}

static const struct hawser_folds_event *nearest(const struct hawser_folds *folds,
                                                enum hawser_folds_kind kind, double load)
{
	const struct hawser_folds_event *best = NULL;

	for (int e = 0; e < folds->events; e++)
		if (folds->event[e].kind == kind &&
		    (!best || fabs(folds->event[e].load - load) < fabs(best->load - load)))
			best = &folds->event[e];
	return best;
}

static void expect(const struct hawser_folds *folds, enum hawser_folds_kind kind, double load,
                   double omega, int minimum)
{
	const struct hawser_folds_event *event = nearest(folds, kind, load);
	const char *name = hawser_folds_kind_name(kind);

	if (!ok(event && event->minimum == minimum, "%s near load %.9g, %s", name, load,
	        minimum > 0 ? "a minimum" : minimum < 0 ? "a maximum" : "a passage"))
		return;
	close_to(event->load, load, 1e-9, name);
	/* at an extremum the error of AUTO's Omega is the square root of its tolerance */
	close_to(event->omega, omega, 1e-6, "its Omega");
}

/* Ends of the curves at the limits of the load. */
static void expect_end(const struct hawser_folds *folds, double load, double omega)
{
	double best = INFINITY, at = 0.0;

	for (int c = 0; c < folds->curves; c++)
		for (int k = 0; k < 2; k++) {
			const struct hawser_folds_curve *curve = &folds->curve[c];
			const struct hawser_folds_point *point =
				&folds->point[curve->first + (k ? curve->points - 1 : 0)];

			if (point->load == load && fabs(point->omega - omega) < best) {
				best = fabs(point->omega - omega);
				at = point->omega;
			}
		}
	close_to(at, omega, 1e-8, "Omega where the curve meets the largest load");
}

static void check_duffing(void)
{
	struct hawser_folds_options options = {.method = NULL};
	struct hawser_folds folds;
	struct hawser_rom rom;

	if (!open_model(&rom, "duffing-nlvib-01"))
		return;
	options.from = 0.8;
	options.to = 1.8;
	ok(!hawser_folds_trace(&folds, &rom, &options, NULL) && folds.curves == 1 &&
	   folds.isolas == 0 && folds.lost == 0, "Duffing: one curve");
	expect(&folds, HAWSER_FOLDS_CUSP, 0.29961728591, 1.0441742291, 1);
	expect_end(&folds, 2.0, 1.1820628364);
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
}

/* A Duffing oscillator with a nonlinear absorber, f = 0.15: m 1, c 0.002, k 1, k3 1; absorber m 0.05,
 * c 0.0128, k 0.0454, k3 0.0042. Its isola is known from Detroux, Renson, Masset and Kerschen, The
 * harmonic balance method for bifurcation analysis of large-scale nonlinear mechanical systems,
 * Comput. Methods Appl. Mech. Engrg. 296 (2015). Coordinates are u1 = x1, u2 = sqrt(0.05) x2. */
static void check_absorber(void)
{
	struct hawser_folds_options options = {.method = NULL};
	struct hawser_folds folds;
	struct hawser_rom rom;

	if (!open_model(&rom, "absorber"))
		return;
	options.from = 0.5;
	options.to = 3.0;
	ok(!hawser_folds_trace(&folds, &rom, &options, NULL) && folds.lost == 0, "absorber: traced");
	expect(&folds, HAWSER_FOLDS_CUSP, 0.62594964546, 1.1869372928, 1);
	expect(&folds, HAWSER_FOLDS_BIFURCATION, 1.2374865578, 1.4405921045, -1);
	expect(&folds, HAWSER_FOLDS_ISOLA, 0.83106335662, 1.8026456213, 1);
	expect(&folds, HAWSER_FOLDS_CUSP, 0.83248674312, 1.0699251954, 1);
	ok(folds.isolas == 1 && folds.isola[0].end == HAWSER_END_CLOSED, "one isola, closed");
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
}

/* Two masses, the second one a nonlinear energy sink. The isola begins beside a fold, where a step
 * turns by so much that its tangent passes the first point beyond it. */
static void check_sink(void)
{
	struct hawser_folds_options options = {.from = 0.85, .to = 1.05, .starts = HAWSER_NONE};
	struct hawser_folds folds;
	struct hawser_rom rom;
	int closed = 0;

	if (!open_model(&rom, "two-masses-nes"))
		return;
	ok(!hawser_folds_trace(&folds, &rom, &options, NULL), "sink: traced");
	for (int i = 0; i < folds.isolas; i++) {
		const struct hawser_frf *isola = &folds.isola[i];
		int again = 0;

		for (int e = 0; e < isola->events; e++)
			for (int k = 0; k < e; k++)
				again += isola->event[e].kind == isola->event[k].kind &&
				         fabs(isola->event[e].omega/isola->event[k].omega - 1.0) < 1e-8;
		closed += isola->end == HAWSER_END_CLOSED && isola->events == 3;
		ok(again == 0, "%d events, each once", isola->events);
	}
	ok(closed == 1, "one isola, closed, with two folds and a torus point");
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
}

CASE(reference_folds)
{
	check_duffing();
	check_absorber();
	check_sink();
	return done_testing();
}
