/* The least load at which a response folds within a range of frequencies: by a closed form, with the
 * range's ends exchanged, and by responses at loads below and above it.
 *
 * Two coordinates with an isotropic spring under a rotating load,
 *
 *     u'' + d u' + u + c |u|^2 u = F exp(i Omega t),    u = u_1 + i u_2,
 *
 * have the exact solution u = A exp(i (Omega t - phi)), with r = A^2 and k = 1 - Omega^2
 *
 *     r ((k + c r)^2 + d^2 Omega^2) = F^2.
 *
 * It folds where the derivative by r vanishes: 3 c^2 r^2 + 4 c k r + k^2 + d^2 Omega^2 = 0. So the
 * loads of both folds at every Omega are known, and the least one within any range.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/folds.h>

#include "rom/build/model.h"
#include "tests/folds-duffing.h"
#include "tests/tap.h"

static unsigned long seed = 20385;

/* A random number between lo and hi, by the minimal standard generator of Park and Miller. */
static double between(double lo, double hi)
{
	seed = seed*48271ul%2147483647ul;
	return lo + (hi - lo)*(double)seed/2147483647.0;
}

static int rotating(struct hawser_rom *rom, double d, double c, double F)
{
	const struct hawser_cubic C[] = {{0, 0, 0, 0, c}, {0, 0, 1, 1, c}, {1, 0, 0, 1, c},
	                                 {1, 1, 1, 1, c}};

	if (hawser__rom_init(rom, 2, NULL))
		return 1;
	rom->K[0] = rom->K[3] = 1.0;
	rom->D[0] = rom->D[3] = d;
	rom->C = malloc(sizeof C);
	memcpy(rom->C, C, sizeof C);
	rom->cubics = 4;
	rom->harmonics = 2;
	rom->harmonic = calloc(2, sizeof *rom->harmonic);
	for (int h = 0; h < 2; h++) {
		rom->harmonic[h] = (struct hawser_harmonic){.k = 1, .f = calloc(2, sizeof(double)),
			.phase = h ? HAWSER_SIN : HAWSER_COS};
		rom->harmonic[h].f[h] = F;
	}
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

/* The smaller load of the two folds at Omega; infinite if there are none. */
static double fold_load(double d, double c, double omega)
{
	double k = 1.0 - omega*omega, s = k*k - 3.0*d*d*omega*omega, least = INFINITY;

	if (s < 0.0 || c*k >= 0.0)
		return least;
	for (int sign = -1; sign <= 1; sign += 2) {
		double r = (2.0*fabs(k) + sign*sqrt(s))/(3.0*fabs(c)), a = k + c*r;

		least = fmin(least, sqrt(r*(a*a + d*d*omega*omega)));
	}
	return least;
}

/* The cusp, where both folds coincide. */
static double cusp_omega(double d, double c)
{
	return 0.5*(sqrt(3.0*d*d + 4.0) + (c > 0.0 ? 1.0 : -1.0)*sqrt(3.0)*d);
}

/* The least load within [lo, hi]: at an end of the range, or at the cusp. A grid confirms that
 * there is no other minimum. */
static double least_load(double d, double c, double lo, double hi, int *cusp)
{
	double least = fmin(fold_load(d, c, lo), fold_load(d, c, hi)), at = cusp_omega(d, c);
	double grid = INFINITY;

	*cusp = at > lo && at < hi;
	if (*cusp) {
		double k = 1.0 - at*at, r = 2.0*fabs(k)/(3.0*fabs(c)), a = k + c*r;
		double load = sqrt(r*(a*a + d*d*at*at));

		*cusp = load < least;
		least = fmin(least, load);
	}
	for (int i = 1; i < 1000; i++)
		grid = fmin(grid, fold_load(d, c, lo + (hi - lo)*i/1000.0));
	return grid < least ? NAN : least;
}

static enum hawser_status trace(struct hawser_folds *folds, const struct hawser_rom *rom, double from,
                                double to, struct hawser_report *report)
{
	struct hawser_folds_options options = {.method = NULL};

	options.from = from;
	options.to = to;
	options.skip_isolas = 1;
	return hawser_folds_trace(folds, rom, &options, report);
}

/* A range that contains the cusp, or ends on the branch near it. */
static void check_rotating(int i)
{
	double d = between(0.01, 0.06), c = (i%2 ? -1.0 : 1.0)*between(0.05, 0.5);
	double at = cusp_omega(d, c);
	double lo = at + d*between(-4.0, 4.0), hi = lo + d*between(0.5, 12.0), want, F;
	struct hawser_report report = {.message = ""};
	int cusp, swapped = i/2%2;
	struct hawser_folds folds;
	struct hawser_rom rom;
	enum hawser_status status;

	want = least_load(d, c, lo, hi, &cusp);
	F = (isfinite(want) ? want : least_load(d, c, 0.7, 1.5, &(int){0}))/between(0.05, 1.6);
	if (!ok(!isnan(want) && !rotating(&rom, d, c, F), "rotating load %d", i))
		return;
	status = trace(&folds, &rom, swapped ? hi : lo, swapped ? lo : hi, &report);
	if (!isfinite(want)) {
		ok(status == HAWSER_ERR_NO_SOLUTION, "none in %.6g to %.6g, cusp at %.6g: %s", lo, hi, at,
		   report.message);
	} else if (ok(!status, "d %.4g, c %.4g, %.6g to %.6g, cusp at %.6g, least %.6g: %s", d, c, lo,
	              hi, at, want/F, report.message)) {
		close_to(F*folds.least_load, want, 1e-7, "least load");
		ok(folds.least_kind == (cusp ? HAWSER_FOLDS_LEAST_CUSP : HAWSER_FOLDS_LEAST_OMEGA),
		   "it is a %s", hawser_folds_least_name(folds.least_kind));
	}
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
}

/* At loads so large that the resonance lies beyond the range, the response within the range has no
 * fold and the multipliers of the linear model. The least load is far below. */
static void check_large(void)
{
	double d = 0.03067, c = 0.4615, lo = 0.94072, hi = 1.08747;
	struct hawser_report report = {.message = ""};
	struct hawser_folds folds;
	struct hawser_rom rom;
	double want = least_load(d, c, lo, hi, &(int){0});

	if (!ok(!rotating(&rom, d, c, want/0.0842341), "a large load"))
		return;
	if (ok(!trace(&folds, &rom, hi, lo, &report), "traced %s", report.message))
		close_to(folds.least_load, 0.0842341, 1e-7, "the least load is found");
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
}

/* A cusp just inside an end of the range, which a step of a fold curve outside it might pass. */
static void check_shallow(void)
{
	for (int i = 0; i < 12; i++) {
		double d = 0.03421, c = i%2 ? -0.2507 : 0.2507, depth = d*pow(10.0, -1.0 - i/2);
		double end = cusp_omega(d, c) + (c > 0.0 ? depth : -depth), want;
		double lo = c > 0.0 ? end - 0.12 : end, hi = lo + 0.12;
		struct hawser_report report = {.message = ""};
		struct hawser_folds folds;
		struct hawser_rom rom;
		int cusp;

		want = least_load(d, c, lo, hi, &cusp);
		if (!ok(cusp && !rotating(&rom, d, c, want/1.10591), "a cusp %.3g inside", depth))
			return;
		if (ok(!trace(&folds, &rom, lo, hi, &report), "traced %s", report.message)) {
			close_to(folds.least_load, 1.10591, 1e-7, "its load");
			ok(folds.curves == 1 && folds.events == 1 && folds.points > 1 &&
			   folds.least_kind == HAWSER_FOLDS_LEAST_CUSP, "%d curves, %d events, %d points: %s",
			   folds.curves, folds.events, folds.points,
			   hawser_folds_least_name(folds.least_kind));
		}
		hawser_folds_clear(&folds);
		hawser_rom_clear(&rom);
	}
}

/* A model whose response from 0.8 leaves the range on its upper branch. */
static void check_duffing(void)
{
	static const double range[][2] = {{0.8, 1.3}, {1.3, 0.8}, {0.8, 3.0}};
	struct hawser_rom rom;

	if (!ok(!duffing(&rom, 0.02, 0.1, 0.1), "a Duffing oscillator"))
		return;
	for (int k = 0; k < 3; k++) {
		struct hawser_report report = {.message = ""};
		struct hawser_folds folds;

		if (ok(!trace(&folds, &rom, range[k][0], range[k][1], &report), "from %g to %g %s",
		       range[k][0], range[k][1], report.message)) {
			close_to(folds.least_load, 0.131399055935, 1e-11, "jumps begin");
			ok(folds.least_kind == HAWSER_FOLDS_LEAST_CUSP && folds.searched &&
			   folds.nearly_linear && folds.levels > 3 &&
			   folds.level[folds.levels - 1].folds == 0, "a cusp, and none below it");
		}
		hawser_folds_clear(&folds);
	}
	hawser_rom_clear(&rom);
}

/* --- random models --- */

/* Two coordinates with a potential; *w2 is the second natural frequency. */
static int random_model(struct hawser_rom *rom, double *w2)
{
	double a = between(-0.15, 0.15), b = between(-0.15, 0.15), ratio = between(0.004, 0.02);
	double p = between(0.02, 0.4), q = between(0.02, 0.4), s = between(-0.1, 0.3);
	/* V = a u^2 v + b u v^2 + p u^4/4 + q v^4/4 + s u^2 v^2/2 */
	const struct hawser_quad Q[] = {{0, 0, 1, 2.0*a}, {0, 1, 1, b}, {1, 0, 0, a}, {1, 0, 1, 2.0*b}};
	const struct hawser_cubic C[] = {{0, 0, 0, 0, p}, {0, 0, 1, 1, s}, {1, 0, 0, 1, s},
	                                 {1, 1, 1, 1, q}};

	*w2 = between(1.1, 3.2);
	if (hawser__rom_init(rom, 2, NULL))
		return 1;
	rom->K[0] = 1.0;
	rom->K[3] = *w2**w2;
	rom->D[0] = 2.0*ratio;
	rom->D[3] = 2.0*ratio**w2;
	rom->Q = malloc(sizeof Q);
	memcpy(rom->Q, Q, sizeof Q);
	rom->quads = 4;
	rom->C = malloc(sizeof C);
	memcpy(rom->C, C, sizeof C);
	rom->cubics = 4;
	rom->harmonics = 1;
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	rom->harmonic[0] = (struct hawser_harmonic){.k = 1, .f = calloc(2, sizeof(double))};
	rom->harmonic[0].f[0] = between(0.01, 0.12);
	rom->harmonic[0].f[1] = between(-0.12, 0.12);
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

/* Folds of the responses at this load factor from both ends of the range; -1 if one cannot be
 * traced. */
static int folds_at(struct hawser_rom *rom, double factor, const double *range)
{
	struct hawser_frf_options options = {.method = NULL};
	double full[2] = {rom->harmonic[0].f[0], rom->harmonic[0].f[1]};
	int folds = 0;

	options.method = "balance";
	options.samples = HAWSER_NONE;
	for (int k = 0; k < 2; k++)
		rom->harmonic[0].f[k] = factor*full[k];
	for (int k = 0; k < 2 && folds >= 0; k++) {
		struct hawser_frf frf;

		options.from = range[k];
		options.to = range[1 - k];
		if (hawser_frf_trace(&frf, rom, &options, NULL))
			folds = -1;
		for (int e = 0; folds >= 0 && e < frf.events; e++)
			folds += frf.event[e].kind == HAWSER_FOLD;
		hawser_frf_clear(&frf);
	}
	for (int k = 0; k < 2; k++)
		rom->harmonic[0].f[k] = full[k];
	return folds;
}

/* Both directions give the same least load, and responses at a lower load have no folds. */
static void check_random(int i)
{
	struct hawser_report report[2] = {{.message = ""}, {.message = ""}};
	struct hawser_folds folds[2];
	struct hawser_rom rom;
	enum hawser_status status[2];
	double w2, range[2];

	if (!ok(!random_model(&rom, &w2), "random model %d", i))
		return;
	range[0] = between(0.8, 0.97);
	range[1] = between(1.03, 1.25)*(i%2 ? w2 : 1.0);
	for (int k = 0; k < 2; k++)
		status[k] = trace(&folds[k], &rom, range[k], range[1 - k], &report[k]);
	if (ok(status[0] == status[1], "%d: %.6g to %.6g, w2 %.6g: %s, %s; %s %s", i, range[0], range[1],
	       w2, hawser_status_name(status[0]), hawser_status_name(status[1]), report[0].message,
	       report[1].message) && !status[0]) {
		double least = folds[0].least_load;
		int below;

		ok(folds[0].least_kind == folds[1].least_kind, "%d: %s and %s", i,
		   hawser_folds_least_name(folds[0].least_kind),
		   hawser_folds_least_name(folds[1].least_kind));
		close_to(folds[1].least_load, least, 1e-8, "with the ends exchanged");
		for (double part = 0.99; part > 0.3 && folds[0].least_kind < HAWSER_FOLDS_LEAST_LOAD;
		     part *= 0.75) {
			below = folds_at(&rom, part*least, range);
			ok(below == 0, "%d: %d folds at %.3g of the least load, %.6g", i, below, part,
			   least);
		}
		if (folds[0].least_kind == HAWSER_FOLDS_LEAST_CUSP)
			ok(folds_at(&rom, 1.03*least, range) > 0, "%d: folds just above", i);
	}
	hawser_folds_clear(&folds[0]);
	hawser_folds_clear(&folds[1]);
	hawser_rom_clear(&rom);
}

CASE(property_folds_least)
{
	int more = getenv("HAWSER_LONG") != NULL;

	check_duffing();
	check_large();
	check_shallow();
	for (int i = 0; i < (more ? 200 : 8); i++)
		check_rotating(i);
	for (int i = 0; i < (more ? 200 : 2); i++)
		check_random(i);
	return done_testing();
}
