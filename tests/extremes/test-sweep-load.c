/* Cables under loads from 1e-12 of their weight to far above the load that makes them slack: forced
 * orbits of the full-order model and of a model of a few modes, from far below the first frequency to
 * several times it, from nearly undamped to overdamped.
 *
 * References: Gauss collocation in time, which shares only the force with the library, must return to
 * the initial state of the orbit after one period. The extremes of the tension must be those of the
 * strain |q'| - 1, computed here at 512 times of the period, and a negative tension must be reported.
 * Orbits that cannot be computed must be refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/frf.h>
#include <hawser/integrate.h>

#include "tests/extremes/sweep.h"

static const double loads[] = {1e-12, 1e-4, 1e-2, 0.1, 0.5, 2.0, 20.0};
static const double omegas[] = {0.1, 0.5, 0.97, 1.3, 2.0, 7.0};
static const double dampings[] = {1e-4, 1e-2, 0.3, 2.0};
enum { LOAD, OMEGA, DAMPING, AXES };
#define COUNT(a) (int)(sizeof (a)/sizeof *(a))
static const struct sweep_axis axis[AXES] = {
	{"load", 0.05, loads, COUNT(loads), 1},
	{"Omega", 1.2, omegas, COUNT(omegas), 1},
	{"damping", 0.05, dampings, COUNT(dampings), 1},
};

/* Permitted error of the sampled extremes of the tension, relative to the range of the tension. */
static const double between_samples = 0.01;

/* A span of 100 m; H in units of the weight, EA in units of H. Stiffer spans take too long for the
 * reference. */
struct cable {
	double H, EA;
	int modes;     /* of the quartic model; 0: the full-order model ... */
	int functions; /* ... with this number of functions per component */
};

static int told_slack, was_slack; /* number of orbits with negative tension: reported, and true */

static enum hawser_status model(struct hawser_rom *rom, double *rest, const struct cable *cable,
                                double load, struct hawser_report *report)
{
	struct hawser_scene scene = {.cable = {.EA = 0.0, .rho = 1.0}, .span = {100.0, 20.0}, .g = 9.81};
	struct hawser_modes_options options = {.n = cable->modes};
	struct hawser_modes modes = {.n = 0};
	struct hawser_statics st;
	enum hawser_status status;

	*rest = scene.tension.value = cable->H*981.0;
	scene.tension.given = HAWSER_GIVEN_H;
	scene.cable.EA = cable->EA*scene.tension.value;
	scene.load.present = 1;
	scene.load.frame = HAWSER_FRAME_GLOBAL;
	scene.load.per_length[0] = 0.2*load*9.81;
	scene.load.per_length[1] = load*9.81;
	scene.load.per_length[2] = 0.1*load*9.81;
	scene.load.extent[1] = 1.0;
	scene.model.condense = HAWSER_CONDENSE_NONE;
	status = hawser_statics_scene(&st, &scene, report);
	if (!status && cable->modes == 0)
		return hawser_rom_build_full(rom, &st, &scene, cable->functions, report);
	if (!status)
		status = hawser_modes_solve(&modes, &st, &options, report);
	if (!status)
		status = hawser_rom_build(rom, &modes, &scene, report);
	hawser_modes_clear(&modes);
	return status;
}

/* D = 2 zeta w1. */
static enum hawser_status damp(double *w1, struct hawser_rom *rom, double zeta,
                               struct hawser_report *report)
{
	double least = rom->K[0];

	for (int j = 1; j < rom->n; j++)
		least = fmin(least, rom->K[j*rom->n + j]);
	memset(rom->D, 0, (size_t)rom->n*rom->n*sizeof *rom->D);
	for (int j = 0; j < rom->n; j++)
		rom->D[j*rom->n + j] = 2.0*zeta*sqrt(least);
	*w1 = sqrt(least);
	return hawser_rom_compile(rom, report);
}

static enum hawser_status first(struct hawser_frf *frf, const struct hawser_rom *rom, double omega,
                                struct hawser_report *report)
{
	struct hawser_frf_options options = {.method = NULL};

	options.from = omega;
	options.to = omega*1.01;
	options.max_points = 1;
	options.samples = HAWSER_NONE;
	return hawser_frf_trace(frf, rom, &options, report);
}

/* Extremes of EA (|q'| - 1) over the points of the cable. */
static void tensions(double range[2], const struct hawser_rom *rom, const double *u)
{
	const struct hawser_rom_line *line = &rom->line;

	for (int p = 0; p < line->points; p++) {
		double q[3] = {line->stretch[p], 0.0, 0.0}, T;

		for (int j = 0; j < rom->n; j++)
			for (int c = 0; c < 3; c++)
				q[c] += u[j]*line->slope[((size_t)j*line->points + p)*3 + c];
		T = rom->shapes.EA*(sqrt(q[0]*q[0] + q[1]*q[1] + q[2]*q[2]) - 1.0);
		range[0] = fmin(range[0], T);
		range[1] = fmax(range[1], T);
	}
}

static double gap(double *size, const struct hawser_trajectory *run, double omega)
{
	const double *a = run->state, *b = a + (size_t)(run->rows - 1)*2*run->n;
	double sum = 0.0;

	*size = 0.0;
	for (int r = 0; r < run->rows; r++) {
		const double *x = a + (size_t)r*2*run->n;
		double here = 0.0;

		for (int j = 0; j < run->n; j++)
			here += x[j]*x[j] + pow(x[run->n + j]/omega, 2);
		*size = fmax(*size, sqrt(here));
	}
	for (int j = 0; j < run->n; j++)
		sum += pow(a[j] - b[j], 2) + pow((a[run->n + j] - b[run->n + j])/omega, 2);
	return sqrt(sum);
}

/* Deviation from periodicity, and the size to which the error of the orbit can grow in a period. */
static void look(struct sweep_point *point, const struct hawser_frf *frf,
                 const struct hawser_rom *rom, double rest)
{
	struct hawser_integrate_options options = {.omega = frf->point[0].omega, .rtol = 1e-12,
	                                           .atol = 1e-22, .initial = frf->state};
	double growth = exp(fmax(0.0, frf->multiplier[0])), off, size, range[2] = {INFINITY, -INFINITY};
	struct hawser_trajectory run;

	options.until = 2.0*M_PI/options.omega;
	options.every = options.until/512;
	if (hawser_integrate(&run, rom, &options, &point->report)) {
		point->skip = 1; /* too long for the reference */
		return;
	}
	off = gap(&size, &run, options.omega);
	for (int r = 0; r < run.rows; r++)
		tensions(range, rom, run.state + (size_t)r*2*rom->n);
	sweep_keep(point, off/size, (1.0 + growth)*frf->point[0].error + 1e-9);
	for (int i = 0; i < 2; i++)
		sweep_keep(point, fabs(range[i] - frf->tension[i])/(range[1] - range[0]),
		           between_samples + 1e-9*rest/(range[1] - range[0]));
	was_slack += range[0] < 0.0;
	told_slack += range[0] < 0.0 && frf->tension[0] < 0.0;
	hawser_trajectory_clear(&run);
}

static void solve(struct sweep_point *point, const double *x, void *context)
{
	struct hawser_frf frf = {.n = 0};
	struct hawser_rom rom = {.n = 0};
	const struct cable *cable = context;
	double rest, w1;

	point->skip = cable->modes ? sweep_left_out(7, 1) : sweep_left_out(1, 5);
	if (point->skip)
		return;
	point->status = model(&rom, &rest, cable, x[LOAD], &point->report);
	if (!point->status)
		point->status = damp(&w1, &rom, x[DAMPING], &point->report);
	if (!point->status)
		point->status = first(&frf, &rom, x[OMEGA]*w1, &point->report);
	if (!point->status)
		look(point, &frf, &rom, rest);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

CASE(extremes_sweep_load)
{
	static struct cable cables[] = {{5.0, 100.0, 3, 0}, {0.6, 100.0, 3, 0},
	                                {5.0, 100.0, 0, 4}, {0.6, 100.0, 0, 4}};

	for (int k = 0; k < (sweep_long() ? COUNT(cables) : 2); k++) {
		char name[80];

		snprintf(name, sizeof name, "loads of %s span, %s", cables[k].H > 1.0 ? "a taut" : "a sagging",
		         cables[k].modes ? "3 modes" : "full order");
		sweep_pairs(name, axis, AXES, solve, &cables[k]);
	}
	sweep_again("a taut span at full order", solve, (double[]){0.5, 0.5, 0.05}, &cables[2]);
	sweep_again("a sagging one", solve, (double[]){0.1, 2.0, 0.3}, &cables[3]);
	ok(was_slack > 0 && told_slack == was_slack, "%d slack orbits, %d told", was_slack, told_slack);
	return done_testing();
}
