/* Floquet multipliers of Hill's equation at the limits of its parameters.
 *
 *   u'' + 2 z w u' + w^2 (1 + e cos Omega t) u = 0,      w = 1 ... n
 *
 * The coordinates are transformed by a rotation, so that the matrices are full and the multipliers are
 * those of single oscillators. References: the trace from the Taylor series of taylor.h, the product
 * from Liouville's formula. A second part tests Mathieu's equation exactly on a boundary, where two
 * multipliers meet on the unit circle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>

#include <hawser/hill.h>

#include "rom/build/model.h"
#include "tests/gsl_mathieu.h"
#include "tests/extremes/reflect.h"
#include "tests/extremes/sweep.h"
#include "tests/extremes/taylor.h"

enum { DAMPING, EXCITATION, OMEGA, MODES, AXES, MOST = 60 };

static const double dampings[] = {0.0, 1e-9, 1e-2, 1.0, 3.0, 100.0};
static const double excitations[] = {0.0, 1e-12, 1e-6, 0.3, 4.0};
static const double omegas[] = {0.05, 0.5, 1.0, 2.0, 1e3};
static const double omegas_long[] = {1e-3, 0.01, 0.05, 0.5, 1.0, 2.0, 2.385, 30.0, 1e3};
static const double modes[] = {1, 2, 4};
static const double modes_long[] = {1, 2, 3, 5, 8, 12, 20, 35, 60};

#define VALUES(a) (a), (int)(sizeof(a)/sizeof *(a))
static struct sweep_axis axis[AXES] = {
	{"damping", 0.01, VALUES(dampings), 3},
	{"excitation", 0.3, VALUES(excitations), 3},
	{"Omega", 2.385, VALUES(omegas), 3},
	{"modes", 1, VALUES(modes), 0},
};

/* u'' + 2 z w u' + w^2 (1 + e cos) u on the diagonal; then all matrices are rotated. */
static int make(struct hawser_rom *rom, int n, double z, double e)
{
	if (hawser__rom_init(rom, n, NULL))
		return 1;
	rom->harmonics = 1;
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	rom->harmonic[0] = (struct hawser_harmonic){.k = 1, .K = calloc((size_t)(n*n), sizeof(double))};
	for (int j = 0; j < n; j++) {
		double w = j + 1.0;

		rom->K[j*n + j] = w*w;
		rom->D[j*n + j] = 2.0*z*w;
		rom->harmonic[0].K[j*n + j] = e*w*w;
	}
	return 0;
}

/* Logarithms of the two multipliers of one oscillator: 2 cosh(x) = trace/sqrt(product). Returns 0 on
 * success. */
static int single(double complex log_mu[2], double w, double z, double e, double omega)
{
	struct hawser_rom rom;
	struct taylor *taylor = NULL;
	long double M[4], x[2] = {0.0L, 0.0L}, half = 2.0L*acosl(-1.0L)/omega*z*w, trace;
	int failed = make(&rom, 1, z*w, e*w*w);

	rom.K[0] = w*w;
	failed = failed || !(taylor = taylor_new(&rom));
	if (!failed)
		taylor_limit(taylor, 40000);
	failed = failed || taylor_derivative(taylor, M, NULL, x, omega, 1.0, 1.0);
	if (!failed) {
		long double complex mu;

		trace = 0.5L*(M[0] + M[3])*expl(half);
		failed = !isfinite(trace);
		if (fabsl(trace) > 1e12L) /* the square would overflow */
			mu = 2.0L*trace;
		else
			mu = trace + (trace < 0 ? -1.0L : 1.0L)*csqrtl((long double complex)(trace*trace - 1.0L));
		log_mu[0] = (double complex)(clogl(mu) - half);
		log_mu[1] = (double complex)(-clogl(mu) - half);
	}
	taylor_free(taylor);
	hawser_rom_clear(&rom);
	return failed;
}

/* Largest distance of the two sets of m logarithms, matched one by one; arguments are mod 2 pi.
 * It is relative for logarithms above 1. Logarithms below -1e4 are ignored, because their exp is 0. */
static double gap(double complex *want, const double *log_modulus, const double *argument, int m)
{
	double worst = 0.0;

	for (int i = 0; i < m; i++) {
		double least = INFINITY;
		int at = i;

		for (int k = i; k < m; k++) {
			double re = creal(want[k]) - log_modulus[i];
			double im = remainder(cimag(want[k]) - argument[i], 2.0*M_PI);
			double d = hypot(re, creal(want[k]) < -600.0 ? 0.0 : im)/
			           fmax(1.0, fabs(creal(want[k])));

			if (d < least) {
				least = d;
				at = k;
			}
		}
		double complex keep = want[i];
		if (creal(want[at]) > -1e4)
			worst = fmax(worst, least);
		want[i] = want[at];
		want[at] = keep;
	}
	return worst;
}

static void solve(struct sweep_point *point, const double *x, void *context)
{
	int n = (int)x[MODES], m = 2*n;
	double complex want[2*MOST];
	double log_modulus[2*MOST], argument[2*MOST];
	struct hawser_linear *linear = NULL;
	struct hawser_rom rom;

	(void)context;
	for (int j = 0; j < n && !point->skip; j++)
		point->skip = single(want + 2*j, j + 1.0, x[DAMPING], x[EXCITATION], x[OMEGA]);
	if (point->skip || make(&rom, n, x[DAMPING], x[EXCITATION]))
		return;
	reflect(rom.K, n);
	reflect(rom.D, n);
	reflect(rom.harmonic[0].K, n);
	point->status = hawser_linear_open(&linear, n, &point->report);
	if (!point->status)
		point->status = hawser_linear_multipliers(linear, log_modulus, argument, &point->stated,
		                                          &rom, x[OMEGA], &point->report);
	if (!point->status)
		point->error = gap(want, log_modulus, argument, m);
	hawser_linear_free(linear);
	hawser_rom_clear(&rom);
}

/* --- a point of a map: its value, and how many multipliers lie outside the unit circle --- */

static void mapped(struct sweep_point *point, const double *x, void *context)
{
	struct hawser_map_sample sample = {.code = HAWSER_MAP_OK};
	struct hawser_map_field field = {.name = NULL};
	struct hawser_linear *linear = NULL;
	struct hawser_map_source source = {.key = {"Omega", "factor.load"}, .quantity = "multiplier"};
	double complex want[2];
	double log_modulus[2], argument[2], largest;
	struct hawser_rom rom;
	void *worker = NULL;
	int number;

	(void)context;
	point->skip = single(want, 1.0, x[DAMPING], x[EXCITATION], x[OMEGA]);
	if (point->skip || make(&rom, 1, x[DAMPING], 1.0))
		return;
	source.rom = &rom;
	source.from[0] = 0.5*x[OMEGA];
	source.to[0] = 2.0*x[OMEGA];
	source.to[1] = 10.0;
	largest = fmax(creal(want[0]), creal(want[1]));
	number = (creal(want[0]) > 1e-8) + (creal(want[1]) > 1e-8);
	point->status = hawser_map_cable_open(&field, &source, &point->report);
	if (!point->status)
		point->status = field.open(&worker, field.context, &point->report);
	if (!point->status)
		point->status = field.point(worker, &sample, NULL, x[OMEGA], x[EXCITATION],
		                            &point->report);
	if (!point->status && sample.code != HAWSER_MAP_OK)
		point->status = point->report.status;
	if (worker)
		field.close(worker);
	hawser_map_cable_close(&field);
	/* the error stated for the multipliers */
	rom.harmonic[0].K[0] = x[EXCITATION];
	if (!point->status && !hawser_linear_open(&linear, 1, &point->report))
		point->status = hawser_linear_multipliers(linear, log_modulus, argument, &point->stated,
		                                          &rom, x[OMEGA], &point->report);
	if (!point->status) {
		point->stated = 10.0*point->stated + 1e-13;
		point->error = fabs(log(sample.value) - fmax(largest, -700.0))/fmax(1.0, fabs(largest));
		if (sample.value == 0.0)
			point->error = largest < -700.0 ? 0.0 : INFINITY;
		if (largest > 1e2)
			point->error = sample.value > exp(99.0) ? 0.0 : INFINITY;
		if (sample.number != number && fabs(largest) > 1e-8 + 10.0*point->stated)
			point->error = INFINITY;
	}
	hawser_linear_free(linear);
	hawser_rom_clear(&rom);
}

/* --- Mathieu's equation on its boundaries --- */

enum { ORDER, EPSILON, INSIDE, PLACES };
static const double orders[] = {0, 1, 2, 3, 4}; /* a_0, b_1, a_1, b_2, a_2 */
static const double epsilons[] = {1e-3, 1.0, 60.0};
static const double insides[] = {-1e-2, -1e-6, -1e-10, 0.0, 1e-10, 1e-6, 1e-2};
static struct sweep_axis place[PLACES] = {
	{"boundary", 1, VALUES(orders), 0},
	{"epsilon", 1.0, VALUES(epsilons), 4},
	{"inside", 0.0, VALUES(insides), 0},
};

/* A few units in the last place from a boundary on which solutions grow by 1e7 and decay again in each
 * period. The error is round-off, and the stated error must have its size on every processor. */
enum { ULPS = 49 };
static double ulps[ULPS];
static const double barriers[] = {0, 1};
static struct sweep_axis barrier[PLACES] = {
	{"boundary", 1, VALUES(barriers), 0},
	{"epsilon", 60.0, epsilons, 1, 0},
	{"inside", 0.0, ulps, ULPS, 0},
};

/* delta on a boundary and near it. GSL's value is accurate to a few units of round-off, so the side of
 * the boundary on which it lies is unknown; the multipliers must be those of the reference. */
static void mathieu(struct sweep_point *point, const double *x, void *context)
{
	int k = (int)x[ORDER], r = (k + 1)/2;
	double complex want[2];
	double delta, log_modulus[2], argument[2];
	struct hawser_linear *linear = NULL;
	struct hawser_rom rom;

	(void)context;
	if (gsl_mathieu(&delta, r, k%2, x[EPSILON]))
		return;
	delta += x[INSIDE]*fmax(1.0, fabs(delta));
	if (make(&rom, 1, 0.0, 2.0*x[EPSILON]))
		return;
	rom.K[0] = delta;
	{
		struct taylor *taylor = taylor_new(&rom);
		long double M[4], zero[2] = {0.0L, 0.0L}, trace;
		long double complex root;

		point->skip = taylor_derivative(taylor, M, NULL, zero, 2.0, 1.0, 1.0);
		trace = 0.5L*(M[0] + M[3]);
		root = csqrtl((long double complex)(trace*trace - 1.0L));
		want[0] = (double complex)clogl(trace + (trace < 0 ? -root : root));
		want[1] = -want[0];
		taylor_free(taylor);
	}
	point->status = hawser_linear_open(&linear, 1, &point->report);
	if (!point->status)
		point->status = hawser_linear_multipliers(linear, log_modulus, argument, &point->stated,
		                                          &rom, 2.0, &point->report);
	if (!point->status)
		point->error = gap(want, log_modulus, argument, 2);
	hawser_linear_free(linear);
	hawser_rom_clear(&rom);
}

CASE(extremes_sweep_hill)
{
	struct sweep_tally tally;

	if (sweep_long()) {
		axis[OMEGA].value = omegas_long;
		axis[OMEGA].count = sizeof omegas_long/sizeof *omegas_long;
		axis[MODES].value = modes_long;
		axis[MODES].count = sizeof modes_long/sizeof *modes_long;
	}
	tally = sweep_pairs("hill", axis, AXES, solve, NULL);
	ok(tally.right > tally.points/2, "more than half of the points are right: %d of %d", tally.right,
	   tally.points);
	tally = sweep_pairs("map", axis, MODES, mapped, NULL);
	ok(tally.right > tally.points/2, "more than half of the points are right: %d of %d", tally.right,
	   tally.points);
	tally = sweep_pairs("mathieu", place, PLACES, mathieu, NULL);
	ok(tally.right == tally.points, "all of the points are right: %d", tally.right);
	for (int k = 0; k < ULPS; k++)
		ulps[k] = (k - ULPS/2)*0x1p-52;
	sweep_pair("mathieu", barrier, PLACES, ORDER, INSIDE, mathieu, NULL);
	return done_testing();
}
