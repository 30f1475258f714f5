/* Whole response curves: through folds, out of their range and back, and closed curves from the
 * load at which they appear to the load at which they merge. Points of a curve are compared with
 * the reference of taylor.h. The error is the distance of a point from the branch, where a change
 * of Omega is divided by 0.05 Omega, as in the library. The result for a curve is its largest
 * ratio of true to stated error.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdint.h>

#include <hawser/folds.h>

#include "tests/extremes/sweep.h"
#include "tests/extremes/taylor.h"
#include "tests/integrate-models.h"

#define VALUES(a) (a), (int)(sizeof(a)/sizeof *(a))
enum { SAMPLES = 9, MOST = 4 };

/* Distance of the state [m] from the branch through x [m] with the tangent `along`, relative to the
 * size of the orbit. */
static double distance(const double *state, const long double *x, const long double *along, int m,
                       double size, double width)
{
	double d2 = 0.0, dt = 0.0, t2 = 1.0;

	for (int j = 0; j < m; j++) {
		double d = (state[j] - (double)x[j])/size, t = (double)along[j]*width/size;

		d2 += d*d;
		dt += d*t;
		t2 += t*t;
	}
	return sqrt(fmax(d2 - dt*dt/t2, 0.0));
}

/* Samples of a curve; the result of the point is that of the worst sample. */
static void look(struct sweep_point *point, const struct hawser_frf *frf,
                 const struct hawser_rom *rom)
{
	struct taylor *taylor = taylor_new(rom);
	int m = 2*rom->n, step = frf->points/SAMPLES + 1;

	taylor_limit(taylor, 4000);
	for (int p = 0; p < frf->points; p += step) {
		const double *state = frf->state + (size_t)p*m;
		double omega = frf->point[p].omega, error, stated = frf->point[p].error;
		long double x[MOST], along[MOST];

		for (int j = 0; j < m; j++)
			x[j] = state[j];
		if (taylor_orbit(taylor, x, NULL, along, NULL, omega))
			continue; /* Newton's method at a fold */
		error = distance(state, x, along, m, taylor_size(taylor, x, omega), 0.05*omega);
		if (p == 0 || error/stated > point->error/point->stated) {
			point->error = error;
			point->stated = stated;
		}
	}
	taylor_free(taylor);
}

/* --- open curves --- */

enum { DAMPING, LOAD, END, AXES };
static const double dampings[] = {1e-9, 1e-3, 0.05, 0.5, 2.0};
static const double loads[] = {1e-12, 1e-3, 0.2, 2.0};
static const double ends[] = {0.3, 0.95, 1.01, 1.6, 3.0};
static const struct sweep_axis axis[AXES] = {
	{"damping", 0.05, VALUES(dampings), 3},
	{"load", 0.2, VALUES(loads), 3},
	{"end", 1.6, VALUES(ends), 3},
};

/* From 0.8 to the end of the range, up or down. The curve must end at the end of the range, at 0.8 if
 * it turns back, or at the limit of points. */
static void open_curve(struct sweep_point *point, const double *x, void *context)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_rom rom = model_oscillator(2.0*x[DAMPING], 1.0, 0.1, x[LOAD]);
	struct hawser_frf frf;

	point->skip = sweep_left_out(2, 1);
	if (point->skip)
		goto done;
	options.method = context;
	options.from = 0.8;
	options.to = x[END];
	options.samples = HAWSER_NONE;
	options.max_points = 3000;
	point->status = hawser_frf_trace(&frf, &rom, &options, &point->report);
	if (!point->status) {
		double last = frf.point[frf.points - 1].omega;

		look(point, &frf, &rom);
		/* the corrector's last step may round */
		if (frf.end == HAWSER_END_RANGE ? fabs(last - x[END]) > 1e-15*x[END]
		    : frf.end == HAWSER_END_RETURNED ? fabs(last - 0.8) > 1e-15
		    : frf.end != HAWSER_END_MAX_POINTS)
			point->error = INFINITY;
	}
	hawser_frf_clear(&frf);
done:
	hawser_rom_clear(&rom);
}

/* --- closed curves: the absorber of tests/reference/test-folds.c, whose isola appears at the load
 * factor 0.83106335662 and merges at 1.2374865578 --- */

enum { FACTOR, TOLERANCE, CLOSED_AXES };
#define BORN 0.83106335662
#define MERGED 1.2374865578
static const double factors[] = {0.5, BORN*(1.0 - 1e-6), BORN*(1.0 + 1e-6), BORN*(1.0 + 1e-3), 1.0,
	MERGED*(1.0 - 1e-3)};
static const double tolerances[] = {1e-10, 1e-7};
static const struct sweep_axis closed_axis[CLOSED_AXES] = {
	{"factor", 1.0, VALUES(factors), 2},
	{"tolerance", 1e-9, VALUES(tolerances), 2},
};

static void closed_curve(struct sweep_point *point, const double *x, void *context)
{
	struct hawser_folds_options options = {.method = NULL};
	struct hawser_folds folds;
	struct hawser_rom rom;
	const char *path = source_file("tests/reference/absorber.json");
	int there = x[FACTOR] > BORN && x[FACTOR] < MERGED, m;

	(void)context;
	point->skip = sweep_left_out(3, 1);
	if (point->skip)
		return;
	point->status = hawser_rom_open(&rom, path, &point->report);
	if (point->status)
		return;
	for (int j = 0; j < rom.n; j++)
		rom.harmonic[0].f[j] *= x[FACTOR];
	m = 2*rom.n;
	options.from = 0.5;
	options.to = 3.0;
	options.load_to = 1.4/x[FACTOR];
	options.tolerance = x[TOLERANCE];
	point->status = hawser_folds_trace(&folds, &rom, &options, &point->report);
	if (!point->status && folds.lost > 0) {
		point->status = point->report.status = HAWSER_ERR_CONVERGENCE;
		snprintf(point->report.message, sizeof point->report.message,
		         "%d folds of detached curves are said to be lost", folds.lost);
	} else if (!point->status && folds.isolas != there) {
		point->error = INFINITY;
	} else if (!point->status && there) {
		const struct hawser_frf *frf = &folds.isola[0];
		const double *first = frf->state, *last = frf->state + (size_t)(frf->points - 1)*m;
		double gap = 0.0, size = 0.0;
		int turns = 0;

		for (int j = 0; j < m; j++) {
			gap = fmax(gap, fabs(first[j] - last[j]));
			size = fmax(size, fabs(first[j]));
		}
		for (int e = 0; e < frf->events; e++)
			turns += frf->event[e].kind == HAWSER_FOLD;
		look(point, frf, &rom);
		if (frf->end != HAWSER_END_CLOSED || turns%2 || turns == 0 || gap > 1e-3*size)
			point->error = INFINITY;
	} else if (!point->status) {
		point->stated = x[TOLERANCE];
	}
	hawser_folds_clear(&folds);
	hawser_rom_clear(&rom);
}

CASE(extremes_sweep_curves)
{
	struct sweep_tally tally;

	for (int i = 0; hawser_frf_method(i); i++) {
		const char *method = hawser_frf_method(i)->name;
		char name[80];

		if (hawser_frf_method(i)->approximate)
			continue;
		snprintf(name, sizeof name, "frf %s, curves", method);
		tally = sweep_pairs(name, axis, AXES, open_curve, (void *)(uintptr_t)method);
		ok(tally.right > tally.points/2, "more than half of the curves are right: %d of %d",
		   tally.right, tally.points);
	}
	tally = sweep_pairs("frf, closed curves", closed_axis, CLOSED_AXES, closed_curve, NULL);
	ok(tally.right == tally.points, "all closed curves are right: %d of %d", tally.right,
	   tally.points);
	sweep_again("just born, as large as the defects allow", closed_curve,
	            (double[]){BORN*(1.0 + 3.3333e-7), 1e-7}, NULL);
	sweep_again("the same, with an odd number of folds", closed_curve,
	            (double[]){BORN*(1.0 + 5e-7), 1e-7}, NULL);
	return done_testing();
}
