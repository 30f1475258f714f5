/* The response at the limits of damping, load, Omega and number of coordinates, with coincident modes
 * and with ill-conditioned segments, for every method. Each point has a check of its own, or must be
 * refused.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/frf.h>

#include "rom/build/model.h"
#include "tests/tap.h"

static const char *method;

/* n coordinates with frequencies 1, 2, ..., damping ratio z, the same load on all. */
static int make(struct hawser_rom *rom, int n, double z, double cubic, double load)
{
	if (hawser__rom_init(rom, n, NULL))
		return 1;
	rom->C = calloc((size_t)n, sizeof *rom->C);
	rom->harmonics = 1;
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	rom->harmonic[0] = (struct hawser_harmonic){.k = 1, .f = calloc((size_t)n, sizeof(double))};
	for (int j = 0; j < n; j++) {
		double w = j + 1.0;

		rom->K[j*n + j] = w*w;
		rom->D[j*n + j] = 2.0*z*w;
		rom->C[rom->cubics++] = (struct hawser_cubic){j, j, j, j, cubic};
		rom->harmonic[0].f[j] = load;
	}
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

static enum hawser_status trace(struct hawser_frf *frf, const struct hawser_rom *rom, double from,
                                double to, double tolerance, struct hawser_report *report)
{
	struct hawser_frf_options options = {.step_max = getenv("HAWSER_LONG") ? 0.02 : 0.1};

	options.from = from;
	options.to = to;
	options.tolerance = tolerance;
	options.method = method;
	report->message[0] = 0;
	return hawser_frf_trace(frf, rom, &options, report);
}

/* Linear amplitude of coordinate j. */
static double linear(const struct hawser_rom *rom, int j, double w)
{
	int at = j*rom->n + j;

	return rom->harmonic[0].f[j]/hypot(rom->K[at] - w*w, rom->D[at]*w);
}

/* The linear model has a closed form at any damping: from light to far beyond critical. */
static void check_damping(void)
{
	static const double ratio[] = {1e-5, 1e-3, 0.1, 1.0, 10.0, 100.0};

	for (unsigned i = 0; i < sizeof ratio/sizeof *ratio; i++) {
		struct hawser_rom rom;
		struct hawser_frf frf;
		struct hawser_report report = {.message = ""};
		/* beyond critical damping nothing changes with Omega, and orbits are stiff */
		double to = ratio[i] > 1.0 && !getenv("HAWSER_LONG") ? 0.75 : 2.385;
		double worst = 0.0, stated = 0.0;

		if (make(&rom, 2, ratio[i], 0.0, 0.3))
			return;
		if (ok(!trace(&frf, &rom, 0.7, to, 1e-10, &report), "damping ratio %g: traced %s",
		       ratio[i], report.message)) {
			for (int p = 0; p < frf.points; p++) {
				double error = 0.0, size = 0.0;

				for (int j = 0; j < 2; j++) {
					double want = linear(&rom, j, frf.point[p].omega);

					error = fmax(error, fabs(frf.coordinate[2*p + j] - want));
					size = fmax(size, want);
				}
				worst = fmax(worst, error/size);
				stated = fmax(stated, frf.point[p].error);
			}
			ok(worst < 1e-3 && worst < 20.0*stated,
			   "damping ratio %g: %d points, worst error %.1e, stated up to %.1e", ratio[i],
			   frf.points, worst, stated);
		}
		hawser_frf_clear(&frf);
		hawser_rom_clear(&rom);
	}
}

/* Amplitudes are proportional to a load that is too small for the cubic term to matter. */
static void check_small_load(void)
{
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_report report = {.message = ""};
	double worst = 0.0;

	if (make(&rom, 2, 0.01, 1.0, 1e-12))
		return;
	ok(!trace(&frf, &rom, 0.7, 2.385, 1e-10, &report), "load 1e-12: traced %s", report.message);
	for (int p = 0; p < frf.points; p++)
		for (int j = 0; j < 2; j++)
			worst = fmax(worst, fabs(frf.coordinate[2*p + j]/
			                         linear(&rom, j, frf.point[p].omega) - 1.0));
	ok(worst < 1e-6 && frf.events == 0, "load 1e-12: amplitudes in closed form to %.1e", worst);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* A hardening cubic term that is 400 times the linear one: u^3 = 1e4 cos(tau), far below the resonance
 * of this amplitude. Larger loads must be right or refused. Where the load crosses zero, the motion
 * reverses within tau = 0.04 (tau^(5/3) = 2/1e4^(2/3)). An error of 1e-8 needs about 450 harmonics,
 * and harmonic balance refuses. */
static void check_large_load(void)
{
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_report report = {.message = ""};
	enum hawser_status status;

	if (make(&rom, 1, 5.0, 1.0, 1e4))
		return;
	status = trace(&frf, &rom, 0.2, 0.25, 1e-8, &report);
	ok(status == (strcmp(method, "balance") ? HAWSER_OK : HAWSER_ERR_CONVERGENCE),
	   "load 1e4: traced, or refused by harmonic balance %s", report.message);
	if (!status)
		close_to(frf.coordinate[0] + pow(frf.coordinate[0], 3), 1e4, 0.02, "static limit");
	hawser_frf_clear(&frf);
	rom.harmonic[0].f[0] = 1e9;
	status = trace(&frf, &rom, 0.02, 0.021, 1e-8, &report);
	ok(status == HAWSER_ERR_CONVERGENCE || (status == HAWSER_OK && fabs(frf.coordinate[0]/1e3 -
	   1.0) < 0.05), "load 1e9: right, or refused: %s", report.message);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* Omega far below and far above the frequencies: static and inertial limits. */
static void check_far_omega(void)
{
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_report report = {.message = ""};

	if (make(&rom, 1, 0.02, 0.0, 0.3))
		return;
	ok(!trace(&frf, &rom, 1e-3, 1.05e-3, 1e-9, &report), "Omega 1e-3: traced %s",
	   report.message);
	if (frf.points)
		close_to(frf.coordinate[0], linear(&rom, 0, 1e-3), 1e-7, "static limit");
	hawser_frf_clear(&frf);
	ok(!trace(&frf, &rom, 1e3, 1.05e3, 1e-9, &report), "Omega 1e3: traced %s", report.message);
	if (frf.points)
		close_to(frf.coordinate[0], linear(&rom, 0, 1e3), 1e-4, "inertial limit");
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* Two equal modes with a symmetric load: both follow the curve of one mode, without further events. */
static void check_coincident(void)
{
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_report report = {.message = ""};
	double worst = 0.0;

	if (make(&rom, 2, 0.02, 0.0, 0.3))
		return;
	rom.K[3] = rom.K[0];
	rom.D[3] = rom.D[0];
	ok(!hawser_rom_compile(&rom, NULL) && !trace(&frf, &rom, 0.7, 1.4, 1e-10, &report),
	   "equal modes: traced %s", report.message);
	for (int p = 0; p < frf.points; p++)
		worst = fmax(worst, fabs(frf.coordinate[2*p]/frf.coordinate[2*p + 1] - 1.0));
	ok(worst < 1e-9 && frf.events == 0, "equal modes move alike: %.1e", worst);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* Many coordinates: 24 linear ones, and the Liouville certificate where a product would underflow. */
static void check_many(void)
{
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_report report = {.message = ""};
	double gap = 0.0, worst = 0.0;

	if (make(&rom, 24, 0.05, 0.0, 0.3)) /* the fastest makes 48 cycles a period */
		return;
	ok(!trace(&frf, &rom, 0.5, 0.504, 1e-8, &report), "24 coordinates: traced %s",
	   report.message);
	for (int p = 0; p < frf.points; p++) {
		gap = fmax(gap, frf.point[p].liouville);
		for (int j = 0; j < 24; j++)
			worst = fmax(worst, fabs(frf.coordinate[24*p + j]/
			                         linear(&rom, j, frf.point[p].omega) - 1.0));
	}
	ok(worst < 1e-5, "24 coordinates: amplitudes to %.1e", worst);
	ok(gap < 1e-3, "sum of 48 logarithms, about -380, off by %.1e", gap);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* A model that escapes to infinity (softening without bound) under a load above its limit. */
static void check_escape(void)
{
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_report report = {.message = ""};
	/* the search for an orbit integrates many periods, which are long at low frequencies */
	double from = getenv("HAWSER_LONG") ? 0.05 : 0.5;

	if (make(&rom, 1, 0.05, -1.0, 10.0))
		return;
	ok(trace(&frf, &rom, from, 2.0, 1e-9, &report) == HAWSER_ERR_CONVERGENCE &&
	   report.message[0], "no bounded orbit: %s", report.message);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* A not-a-number set in the model after its compilation is named, not reported as a resonance. */
static void check_nan(void)
{
	for (int which = 0; which < 3; which++) {
		struct hawser_report report = {.message = ""};
		struct hawser_rom rom;
		struct hawser_frf frf;
		enum hawser_status status;

		if (!ok(!make(&rom, 2, 0.05, 0.1, 0.1), "two oscillators"))
			return;
		*(which == 0 ? rom.K : which == 1 ? rom.D : rom.harmonic[0].f) = NAN;
		status = trace(&frf, &rom, 0.5, 1.5, 1e-8, &report);
		ok(status == HAWSER_ERR_NAN && strstr(report.message, "nan") &&
		   strstr(report.message, "entry 0"), "%s", report.message);
		hawser_frf_clear(&frf);
		hawser_rom_clear(&rom);
	}
}

CASE(extremes_frf_extremes)
{
	for (int i = 0; hawser_frf_method(i); i++) {
		if (hawser_frf_method(i)->approximate)
			continue;
		method = hawser_frf_method(i)->name;
		printf("# %s\n", method);
		check_damping();
		check_small_load();
		check_large_load();
		check_far_omega();
		check_coincident();
		check_many();
		check_escape();
		check_nan();
	}
	return done_testing();
}
