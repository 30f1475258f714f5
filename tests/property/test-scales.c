/* Multiple scales: coefficients against closed forms, derivatives, and the order at which folds,
 * torus points and branches approach those of the model as load and damping decrease.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/scales.h>

#include "tests/tap.h"

static const struct hawser_resonance primary = {.count = 1, .mode = {0}, .order = {1}, .omega0 =
                                                1.0};

/* n coordinates with given stiffness, damping d, 2d ..., load f cos on the first. */
static int make(struct hawser_rom *rom, int n, const double *stiffness, double d, double f,
                const struct hawser_quad *Q, int quads, const struct hawser_cubic *C, int cubics)
{
	struct hawser_report report;

	*rom = (struct hawser_rom){.n = n, .quads = quads, .cubics = cubics, .harmonics = 1,
		.length = 1.0, .time = 1.0, .force = 1.0};
	rom->D = calloc((size_t)(n*n), sizeof(double));
	rom->K = calloc((size_t)(n*n), sizeof(double));
	rom->Q = calloc((size_t)quads + 1, sizeof *rom->Q);
	rom->C = calloc((size_t)cubics + 1, sizeof *rom->C);
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	if (!rom->D || !rom->K || !rom->Q || !rom->C || !rom->harmonic ||
	    !(rom->harmonic->f = calloc((size_t)n, sizeof(double))))
		return 1;
	for (int j = 0; j < n; j++) {
		rom->K[j*n + j] = stiffness[j];
		rom->D[j*n + j] = d*(j + 1);
	}
	if (quads)
		memcpy(rom->Q, Q, (size_t)quads*sizeof *Q);
	if (cubics)
		memcpy(rom->C, C, (size_t)cubics*sizeof *C);
	rom->harmonic->k = 1;
	rom->harmonic->f[0] = f;
	return hawser_rom_compile(rom, &report) != HAWSER_OK;
}

/* The coefficient of A^2 conj(A): 3 C - (10/3) Q^2/omega^2 by the mode itself (B 4.106), and by
 * another mode s, which beta u^2 drives and which acts back by 2 beta u u_s, -beta^2 [4/w_s^2 +
 * 2/(w_s^2 - 4)]. */
static void coefficients(void)
{
	const double stiffness[] = {1.0, 7.0};
	const struct hawser_quad Q[] = {{0, 0, 0, 0.3}, {0, 0, 1, 0.4}, {1, 0, 0, 0.2}};
	const struct hawser_cubic C[] = {{0, 0, 0, 0, 0.25}};
	struct hawser_rom rom;
	struct hawser_modulation m;
	struct hawser_report report;
	double want = 3.0*0.25 - 10.0/3.0*0.09 - 0.04*(4.0/7.0 + 2.0/3.0);

	if (!ok(!make(&rom, 2, stiffness, 0.01, 0.1, Q, 3, C, 1), "a model of two modes"))
		return;
	if (ok(hawser_modulation_derive(&m, &rom, &primary, &report) == HAWSER_OK, "its modulation")) {
		int at = -1;

		for (int i = 0; i < m.monomials; i++) {
			const int *factor = m.monomial[i].factor;

			if (factor[0] == 0 && factor[1] == 0 && factor[2] == 1)
				at = i;
		}
		if (ok(at >= 0, "A A conj(A) is among the %d monomials", m.monomials)) {
			close_to(m.monomial[at].re, want, 1e-14, "its coefficient");
			ok(fabs(m.monomial[at].im) < 1e-15, "real");
		}
	}
	hawser_modulation_clear(&m);
	hawser_rom_clear(&rom);
}

/* by_x and by_omega against central differences. */
static void derivatives(const struct hawser_rom *rom, const struct hawser_resonance *resonance)
{
	enum { MOST = 4 };
	struct hawser_modulation m;
	struct hawser_report report = {.message = ""};
	double G[MOST], up[MOST], down[MOST], by_x[MOST*MOST], by_omega[MOST], x[MOST] =
	        {0.3, -0.2, 0.1, 0.4};
	double worst = 0.0, h = 1e-5;
	int count = 2*resonance->count;

	if (!ok(hawser_modulation_derive(&m, rom, resonance, &report) == HAWSER_OK, "modulation: %s",
	        report.message))
		return;
	hawser_modulation_equations(&m, G, by_x, by_omega, x, 1.02);
	for (int k = 0; k <= count; k++) {
		double keep = k < count ? x[k] : 1.02;

		if (k < count)
			x[k] = keep + h;
		hawser_modulation_equations(&m, up, NULL, NULL, x, k < count ? 1.02 : keep + h);
		if (k < count)
			x[k] = keep - h;
		hawser_modulation_equations(&m, down, NULL, NULL, x, k < count ? 1.02 : keep - h);
		if (k < count)
			x[k] = keep;
		for (int i = 0; i < count; i++)
			worst = fmax(worst, fabs((up[i] - down[i])/(2.0*h)
			                         - (k < count ? by_x[i*count + k] : by_omega[i])));
	}
	ok(worst < 1e-8, "derivatives against differences: %.1e", worst);
	hawser_modulation_clear(&m);
}

/* --- order of convergence --- */

enum { EVENTS = 4 };

struct family {
	const char *name;
	/* powers of epsilon of load and damping; the range narrows with the first */
	double damping, load;
	double from, to;
	int event, kind;
	double order; /* expected */
	double small; /* largest epsilon */
};

static int locate(double *omega, const struct hawser_rom *rom, const char *method,
                  const struct family *family, double e)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_report report = {.message = ""};
	struct hawser_frf frf;
	double narrow = pow(e, family->damping);
	int found = 0;

	options.method = method;
	options.from = 1.0 + (family->from - 1.0)*narrow;
	options.to = 1.0 + (family->to - 1.0)*narrow;
	options.tolerance = 1e-11;
	options.event_tolerance = 1e-13;
	options.samples = HAWSER_NONE;
	options.step_max = 0.01;
	if (!ok(hawser_frf_trace(&frf, rom, &options, &report) == HAWSER_OK, "%s by %s at epsilon %g",
	        family->name, method, e))
		puts(report.message);
	for (int i = 0, seen = 0; i < frf.events; i++)
		if ((int)frf.event[i].kind == family->kind && seen++ == family->event) {
			*omega = frf.event[i].omega;
			found = 1;
		}
	hawser_frf_clear(&frf);
	return found;
}

static void order(struct hawser_rom *rom, const struct family *family)
{
	double gap[2] = {0.0}, D = rom->D[0], f = rom->harmonic->f[0];
	int n = rom->n, both = 1;

	for (int i = 0; i < 2; i++) {
		double e = family->small/(1 << i), full = NAN, scales = NAN;

		for (int j = 0; j < n; j++)
			rom->D[j*n + j] = D*(j + 1)*pow(e, family->damping);
		rom->harmonic->f[0] = f*pow(e, family->load);
		both &= locate(&full, rom, "shooting", family, e);
		both &= locate(&scales, rom, "multiple-scales", family, e);
		gap[i] = fabs(full - scales);
	}
	if (ok(both, "%s: event %d on both", family->name, family->event))
		ok(fabs(log2(gap[0]/gap[1]) - family->order) < 0.05*family->order,
		   "%s: distance %.2e falls with slope %.3f, order %g", family->name, gap[0],
		   log2(gap[0]/gap[1]), family->order);
	for (int j = 0; j < n; j++)
		rom->D[j*n + j] = D*(j + 1);
	rom->harmonic->f[0] = f;
}

static void orders(void)
{
	const double one[] = {1.0}, two[] = {1.0, 4.0}, equal[] = {1.0, 1.0};
	const struct hawser_quad soft[] = {{0, 0, 0, 0.3}}, pair[] = {{0, 0, 1, 1.0}, {1, 0, 0, 1.0}};
	const struct hawser_cubic hard[] = {{0, 0, 0, 0, 0.1}}, little[] = {{0, 0, 0, 0, 0.02}};
	const struct hawser_cubic round[] = {{0, 0, 0, 0, 0.3}, {0, 0, 1, 1, 0.3}, {1, 1, 1, 1, 0.3},
	                                     {1, 0, 0, 1, 0.3}};
	const struct family hardening = {"hardening", 2.0, 3.0, 0.8, 1.8, 1, HAWSER_FOLD, 4.0, 0.125};
	const struct family softening = {"softening", 2.0, 3.0, 0.8, 1.2, 0, HAWSER_FOLD, 4.0, 0.125};
	/* effective coefficient 0.11 - (10/9) 0.3^2 = 0.01, a tenth of either term */
	const struct family neutral = {"nearly neutral", 2.0, 3.0, 0.8, 1.2, 1, HAWSER_FOLD, 4.0, 0.0625};
	const struct hawser_cubic nearly[] = {{0, 0, 0, 0, 0.11}};
	const struct family same = {"1:1", 2.0, 3.0, 0.8, 2.0, 0, HAWSER_BRANCH_POINT, 4.0, 0.25};
	const struct family double_one = {"1:2", 1.0, 2.0, 1.12, 0.98, 0, HAWSER_FOLD, 3.0, 0.25};
	const struct family torus = {"1:2 torus", 1.0, 2.0, 1.12, 0.98, 0, HAWSER_TORUS, 2.0, 0.25};
	const struct hawser_resonance both = {.count = 2, .mode = {0, 1}, .order = {1, 2}, .omega0 =
	                                      1.0};
	struct hawser_rom rom;

	if (!make(&rom, 1, one, 0.05, 0.18, NULL, 0, hard, 1))
		order(&rom, &hardening);
	hawser_rom_clear(&rom);
	if (!make(&rom, 1, one, 0.05, 0.1, soft, 1, little, 1))
		order(&rom, &softening);
	hawser_rom_clear(&rom);
	if (!make(&rom, 1, one, 0.05, 0.2, soft, 1, nearly, 1))
		order(&rom, &neutral);
	hawser_rom_clear(&rom);
	if (!make(&rom, 2, equal, 0.05, 0.2, NULL, 0, round, 4))
		order(&rom, &same);
	hawser_rom_clear(&rom);
	if (!make(&rom, 2, two, 0.005, 0.01, pair, 2, NULL, 0)) {
		derivatives(&rom, &both);
		order(&rom, &double_one);
		order(&rom, &torus);
	}
	hawser_rom_clear(&rom);
}

static void refusals(void)
{
	const double stiffness[] = {1.0, 4.0};
	const struct hawser_quad Q[] = {{1, 0, 0, 0.2}};
	struct hawser_resonance wrong = primary;
	struct hawser_rom rom;
	struct hawser_modulation m;
	struct hawser_report report = {.message = ""};

	if (!ok(!make(&rom, 2, stiffness, 0.01, 0.1, Q, 1, NULL, 0), "a model in 1:2 resonance"))
		return;
	ok(hawser_modulation_derive(&m, &rom, &primary, &report) == HAWSER_ERR_NO_SOLUTION,
	   "a resonant mode left out is refused: %s", report.message);
	wrong.mode[0] = 5;
	ok(hawser_modulation_derive(&m, &rom, &wrong, &report) == HAWSER_ERR_ARGUMENT,
	   "mode 6 of 2: %s",
	   report.message);
	wrong = primary;
	wrong.count = 0;
	ok(hawser_modulation_derive(&m, &rom, &wrong, &report) == HAWSER_ERR_ARGUMENT, "no mode: %s",
	   report.message);
	rom.K[1] = 0.1;
	ok(hawser_modulation_derive(&m, &rom, &primary, &report) == HAWSER_ERR_ARGUMENT, "K: %s",
	   report.message);
	rom.K[1] = 0.0;
	ok(hawser_resonance_find(&wrong, &rom, 3.0, 4.0, &report) == HAWSER_ERR_ARGUMENT,
	   "a range without a mode: %s", report.message);
	ok(hawser_resonance_find(&wrong, &rom, 0.9, 1.1, &report) == HAWSER_OK && wrong.count == 2 &&
	           wrong.order[1] == 2, "1:2 is found");
	hawser_rom_clear(&rom);
	hawser_modulation_clear(NULL);
}

CASE(property_scales)
{
	coefficients();
	orders();
	refusals();
	return done_testing();
}
