/* Forced periodic orbits at the limits of their parameters, by every method that solves the
 * equations of the model. The model has n coordinates with frequencies 1, 2, ..., n, transformed
 * by a reflection so that its matrices are full. A linear model has a closed form. A model with a
 * cubic term, and a small cable, are compared with the reference of taylor.h. The stated error is
 * the `error` of a point, relative to the state of the orbit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <stdlib.h>

#include <hawser/frf.h>

#include "tests/extremes/reflect.h"
#include "tests/extremes/sweep.h"
#include "tests/extremes/taylor.h"
#include "tests/integrate-models.h"

static const double dampings[] = {0.0, 1e-9, 0.01, 1.0, 20.0};
static const double dampings_long[] = {0.0, 1e-9, 1e-4, 0.01, 0.3, 1.0, 10.0, 100.0};
static const double loads[] = {1e-12, 1e-2, 3.0, 1e2};
static const double loads_long[] = {1e-12, 1e-6, 1e-2, 0.3, 3.0, 1e2, 1e4};
static const double omegas[] = {0.03, 0.9, 1.0, 1e3};
static const double omegas_long[] = {1e-3, 0.03, 0.4, 0.9, 1.0, 1.1, 2.385, 40.0, 1e3};
static const double modes[] = {1, 2, 6};
static const double modes_long[] = {1, 2, 3, 5, 8, 12, 20, 35, 60};

#define VALUES(a) (a), (int)(sizeof(a)/sizeof *(a))
enum { DAMPING, LOAD, OMEGA, AXES };
static struct sweep_axis axis[AXES] = {
	{"damping", 0.02, VALUES(dampings), 1},
	{"load", 0.05, VALUES(loads), 1},
	{"Omega", 1.1, VALUES(omegas), 1},
};
enum { MODES = 2 };
static struct sweep_axis line[] = {
	{"damping", 0.02, VALUES(dampings), 1},
	{"Omega", 1.1, VALUES(omegas), 1},
	{"modes", 2, VALUES(modes), 0},
};

struct task {
	const char *method;
	struct hawser_rom (*make)(double damping, double load);
};

/* The first orbit at Omega, started from the linear response. */
static enum hawser_status first(struct hawser_frf *frf, const struct hawser_rom *rom, double omega,
                                const char *method, struct hawser_report *report)
{
	struct hawser_frf_options options = {.method = NULL};

	options.method = method;
	options.from = omega;
	options.to = omega*1.01;
	options.max_points = 1;
	options.samples = HAWSER_NONE;
	return hawser_frf_trace(frf, rom, &options, report);
}


/* n linear coordinates: u = Re(c exp(i Omega t)) of each, then reflected. */
static void linear(struct sweep_point *point, const double *x, void *context)
{
	enum { MOST = 60 };
	const char *method = context;
	int n = (int)x[MODES];
	double want[MOST] = {0.0}, speed[MOST] = {0.0}, omega = x[1], X = 0.0;
	struct hawser_rom rom = model_new(n);
	struct hawser_frf frf;
	double f[MOST], v2 = 0.0, along[4] = {0.0}, amplitude[MOST][2], sum = 0.0;

	for (int j = 0; j < n; j++) {
		double w = j + 1.0;
		double complex c = (0.3/w)/(w*w - omega*omega + 2.0*I*x[DAMPING]*w*omega);

		point->skip |= x[DAMPING] == 0.0 && w == omega;
		rom.K[j*n + j] = w*w;
		rom.D[j*n + j] = 2.0*x[DAMPING]*w;
		f[j] = 0.3/w;
		amplitude[j][0] = creal(c);
		amplitude[j][1] = -cimag(c);
		v2 += 1 + 3*(j%2);
	}
	for (int j = 0; j < n; j++)
		for (int k = 0; k < 2; k++)
			along[k] += 2.0*(1 + j%2)*amplitude[j][k]/v2;
	for (int j = 0; j < n; j++)
		along[2] += 2.0*(1 + j%2)*f[j]/v2;
	/* H K H, H D H and H f with H = 1 - 2 v v'/v'v, v = (1, 2, 1, 2, ...) */
	for (int j = 0; j < n; j++) {
		double p = amplitude[j][0] - along[0]*(1 + j%2), q = amplitude[j][1] - along[1]*(1 + j%2);

		f[j] -= along[2]*(1 + j%2);
		want[j] = p;
		speed[j] = omega*q;
		X += 0.5*(p*p + q*q)*(1.0 + omega*omega);
	}
	reflect(rom.K, n);
	reflect(rom.D, n);
	X = sqrt(X);
	model_force(&rom, HAWSER_COS, 0, f);
	model_compile(&rom);
	point->status = first(&frf, &rom, omega, method, &point->report);
	if (!point->status && !point->skip) {
		for (int j = 0; j < n; j++)
			sum += pow(frf.state[j] - want[j], 2) + pow(frf.state[n + j] - speed[j], 2);
		point->error = sqrt(sum)/X;
		for (int j = 0; j < n; j++)
			point->error = fmax(point->error,
			                    fabs(frf.coordinate[j] - hypot(want[j], speed[j]/omega))/X);
		point->stated = frf.point[0].error;
	} else if (point->skip && point->status) {
		point->skip = 0; /* an undamped resonance, refused */
	} else if (point->skip) {
		point->skip = 0;
		point->error = INFINITY;
		point->stated = frf.point[0].error;
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* A nonlinear model against the reference, started at the state of the library. */
static void cubic(struct sweep_point *point, const double *x, void *context)
{
	enum { MOST = 12 };
	const struct task *task = context;
	struct hawser_rom rom = task->make(x[DAMPING], x[LOAD]);
	struct taylor *taylor = taylor_new(&rom);
	struct hawser_frf frf;
	long double state[MOST];
	double most[MOST], X, sum = 0.0;
	int n = rom.n;

	taylor_limit(taylor, sweep_long() ? 30000 : 4000);
	point->status = first(&frf, &rom, x[OMEGA], task->method, &point->report);
	for (int j = 0; !point->status && j < 2*n; j++)
		state[j] = frf.state[j];
	if (!point->status && taylor_move(taylor, state, NULL, x[OMEGA], 0.0L,
	                                  2.0L*acosl(-1.0L)/x[OMEGA])) {
		point->skip = 1; /* too long for the reference */
	} else if (!point->status) {
		for (int j = 0; j < 2*n; j++)
			state[j] = frf.state[j];
		point->error = INFINITY;
		point->stated = frf.point[0].error;
		if (!taylor_orbit(taylor, state, NULL, NULL, most, x[OMEGA])) {
			X = taylor_size(taylor, state, x[OMEGA]);
			for (int j = 0; j < 2*n; j++)
				sum += pow((double)(frf.state[j] - state[j]), 2);
			point->error = sqrt(sum)/X;
			for (int j = 0; j < n; j++)
				point->error = fmax(point->error, fabs(frf.coordinate[j] - most[j])/X);
		}
	}
	taylor_free(taylor);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

static struct hawser_rom duffing(double damping, double load)
{
	return model_oscillator(2.0*damping, 1.0, 1.0, load);
}

static void lengthen(struct sweep_axis *at, const double *value, size_t count)
{
	at->value = value;
	at->count = (int)count;
}

CASE(extremes_sweep_frf)
{
	if (sweep_long()) {
		lengthen(&line[MODES], modes_long, sizeof modes_long/sizeof *modes_long);
		lengthen(&line[0], dampings_long, sizeof dampings_long/sizeof *dampings_long);
		lengthen(&line[1], omegas_long, sizeof omegas_long/sizeof *omegas_long);
		lengthen(&axis[DAMPING], dampings_long, sizeof dampings_long/sizeof *dampings_long);
		lengthen(&axis[LOAD], loads_long, sizeof loads_long/sizeof *loads_long);
		lengthen(&axis[OMEGA], omegas_long, sizeof omegas_long/sizeof *omegas_long);
	}
	for (int i = 0; hawser_frf_method(i); i++) {
		const char *method = hawser_frf_method(i)->name;
		struct task task = {method, duffing}, cable = {method, model_cable};
		struct sweep_tally tally;
		char name[80];

		if (hawser_frf_method(i)->approximate)
			continue;
		snprintf(name, sizeof name, "frf %s, linear", method);
		tally = sweep_pairs(name, line, 3, linear, (void *)(uintptr_t)method);
		ok(tally.right > 0.9*tally.points, "nine of ten points are right: %d of %d", tally.right,
		   tally.points);
		snprintf(name, sizeof name, "frf %s", method);
		tally = sweep_pairs(name, axis, AXES, cubic, &task);
		ok(tally.right > tally.points/2, "more than half of the points are right: %d of %d",
		   tally.right, tally.points);
		snprintf(name, sizeof name, "frf %s, cable", method);
		if (sweep_long())
			sweep_pairs(name, axis, AXES, cubic, &cable);
	}
	return done_testing();
}
