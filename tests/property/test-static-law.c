/* The static law of a coordinate (hawser/law.h): the exact one against chains of elastic bars with the
 * same projection on the mode held, relaxed by Newton's method here; that of models against figures
 * of an outside program; the range and what the file says of it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <hawser/law.h>
#include "tests/tap.h"

/* 104 m, sag/span 0.079, EA/T 6100: swings of a metre, and the models get worse with more modes */
static struct hawser_scene footbridge(void)
{
	struct hawser_scene scene = {.cable = {.EA = 280e6, .rho = 28.0}, .span = {104.0, 2.5}, .g = 9.81};

	scene.tension.given = HAWSER_GIVEN_SAG;
	scene.tension.value = 8.2;
	scene.model.condense = HAWSER_CONDENSE_STATIC;
	return scene;
}

static struct hawser_scene steep(void)
{
	struct hawser_scene scene = {.cable = {.EA = 694.6e3, .rho = 0.15913}, .span = {29.273, -46.165},
	                             .g = 9.81};

	scene.tension.given = HAWSER_GIVEN_LENGTH0;
	scene.tension.value = 55.311;
	scene.model.condense = HAWSER_CONDENSE_STATIC;
	return scene;
}

/* With two masses, one of a fifth of the cable's mass. */
static struct hawser_scene laden(void)
{
	struct hawser_scene scene = {.cable = {.EA = 2.3e6, .rho = 1.13}, .span = {87.0, 31.0}, .g = 9.81};

	scene.tension.given = HAWSER_GIVEN_T0;
	scene.tension.value = 4.1e3;
	scene.model.condense = HAWSER_CONDENSE_STATIC;
	scene.attachments = 2;
	scene.attach[0].at = 0.25;
	scene.attach[0].mass = 23.0;
	scene.attach[1].at = 0.625;
	scene.attach[1].mass = 4.7;
	return scene;
}

static struct hawser_scene taut(void)
{
	struct hawser_scene scene = {.cable = {.EA = 31e6, .rho = 2.571}, .span = {211.3, 23.7}, .g = 9.81};

	scene.tension.given = HAWSER_GIVEN_T0;
	scene.tension.value = 71e3;
	scene.model.condense = HAWSER_CONDENSE_STATIC;
	return scene;
}

struct span {
	struct hawser_scene scene;
	struct hawser_statics st;
	struct hawser_modes modes;
	struct hawser_rom rom;
};

static int make(struct span *span, struct hawser_scene scene, int n)
{
	struct hawser_modes_options options = {.n = n};
	struct hawser_report report = {.message = ""};

	memset(span, 0, sizeof *span);
	span->scene = scene;
	return ok(!hawser_statics_scene(&span->st, &scene, &report) &&
	          !hawser_modes_solve(&span->modes, &span->st, &options, &report) &&
	          !hawser_rom_build(&span->rom, &span->modes, &scene, &report), "%d modes %s", n,
	          report.message);
}

static void clear(struct span *span)
{
	hawser_rom_clear(&span->rom);
	hawser_modes_clear(&span->modes);
}

/* --- a chain of bars in space --- */

enum { MOST = 32, SIZE = 3*(MOST - 1) };

struct chain {
	const struct span *span;
	int bars, size;                    /* 3 (bars - 1) unknowns: joints, in global axes */
	double end[6], weight[MOST];       /* N at the joints */
	double x[SIZE], rest[SIZE], c[SIZE], g[SIZE]; /* c: u is c'(x - rest); g: gradient of the energy */
	double matrix[(SIZE + 1)*(SIZE + 1)];
};

static const double *joint(const struct chain *chain, const double *x, int k)
{
	return k == 0 ? chain->end : k == chain->bars ? chain->end + 3 : x + 3*(k - 1);
}

/* Energy; its gradient and, unless 0, its second derivatives in the upper left of the matrix. */
static double strain(struct chain *chain, const double *x, int derive)
{
	double part = chain->span->st.length0/chain->bars, EA = chain->span->st.span.EA, sum = 0.0;
	int n = chain->size, row = n + 1;

	memset(chain->g, 0, sizeof chain->g);
	if (derive)
		memset(chain->matrix, 0, sizeof chain->matrix);
	for (int k = 0; k < chain->bars; k++) {
		const double *a = joint(chain, x, k), *b = joint(chain, x, k + 1);
		double t[3], L = 0.0, T;

		for (int i = 0; i < 3; i++)
			L += (b[i] - a[i])*(b[i] - a[i]);
		L = sqrt(L);
		T = EA*(L/part - 1.0);
		sum += 0.5*EA*part*(L/part - 1.0)*(L/part - 1.0);
		for (int i = 0; i < 3; i++)
			t[i] = (b[i] - a[i])/L;
		for (int i = 0; i < 6; i++) {
			int p = 3*(k - 1) + i;

			if (p < 0 || p >= n)
				continue;
			chain->g[p] += (i < 3 ? -T : T)*t[i%3];
			for (int j = 0; derive && j < 6; j++) {
				int q = 3*(k - 1) + j;
				double sign = (i < 3) == (j < 3) ? 1.0 : -1.0;

				if (q >= 0 && q < n)
					chain->matrix[p*row + q] += sign*((EA/part - T/L)*t[i%3]*t[j%3] +
					                                  (i%3 == j%3 ? T/L : 0.0));
			}
		}
	}
	for (int k = 1; k < chain->bars; k++) {
		sum += chain->weight[k]*x[3*(k - 1) + 1];
		chain->g[3*(k - 1) + 1] += chain->weight[k];
	}
	return sum;
}

/* Minimise the energy with c'x as it is (held) or free; returns the multiplier, NAN on failure. */
static double relax(struct chain *chain, int held)
{
	int n = chain->size, row = n + 1, size = n + held;
	double step[SIZE + 1], next[SIZE], before, part;
	lapack_int pivot[SIZE + 1];

	for (int k = 0; k < 60; k++) {
		double largest = 0.0;

		before = strain(chain, chain->x, 1);
		for (int i = 0; i < n; i++) {
			chain->matrix[i*row + n] = chain->matrix[n*row + i] = chain->c[i];
			step[i] = -chain->g[i];
		}
		step[n] = 0.0;
		if (LAPACKE_dgesv(LAPACK_COL_MAJOR, size, 1, chain->matrix, row, pivot, step, row))
			return NAN;
		for (int i = 0; i < n; i++)
			largest = fmax(largest, fabs(step[i]));
		for (part = 1.0; part > 1e-3; part *= 0.5) {
			for (int i = 0; i < n; i++)
				next[i] = chain->x[i] + part*step[i];
			if (largest < 1e-6 || strain(chain, next, 0) < before)
				break;
		}
		memcpy(chain->x, next, sizeof next);
		if (largest < 1e-10*chain->span->st.span.d)
			return -step[n];
	}
	return NAN;
}

/* Joint k of the profile, and the displacement of mode j there, of which u = 1 is this times d. */
static void place(double x[3], double shape[3], const struct span *span, int j, double part)
{
	const struct hawser_statics *st = &span->st;
	struct hawser_profile_point at = hawser_statics_at(st, st->length0*part);
	struct hawser_frame_point frame = hawser_statics_frame(st, st->l*part);
	double local[3];

	hawser_modes_at(&span->modes, local, NULL, j, st->l*part);
	x[0] = at.x;
	x[1] = at.y;
	x[2] = 0.0;
	shape[0] = local[0]*frame.ex - local[1]*frame.ey;
	shape[1] = local[0]*frame.ey + local[1]*frame.ex;
	shape[2] = local[2];
}

/* Force over stiffness times coordinate, minus 1, of the chain with coordinate j at u. */
static double law(struct chain *chain, const struct span *span, int bars, int j, double u)
{
	const struct hawser_statics *st = &span->st;
	double part = st->length0/bars, d = st->span.d, rho = st->span.rho, R, scale = 0.0, soft = 0.0;
	double shape[SIZE], solved[SIZE + 1], x[3], end[3];
	lapack_int pivot[SIZE + 1];

	*chain = (struct chain){.span = span, .bars = bars, .size = 3*(bars - 1)};
	place(chain->end, end, span, j, 0.0);
	place(chain->end + 3, end, span, j, 1.0);
	for (int k = 1; k < bars; k++) {
		double mass = rho*part;

		for (int i = 0; i < span->scene.attachments; i++)
			if (fabs(span->scene.attach[i].at*bars - k) < 1e-9)
				mass += span->scene.attach[i].mass;
		place(x, shape + 3*(k - 1), span, j, (double)k/bars);
		chain->weight[k] = mass*st->span.g;
		for (int i = 0; i < 3; i++) {
			chain->x[3*(k - 1) + i] = x[i];
			chain->c[3*(k - 1) + i] = mass/(rho*d*d)*shape[3*(k - 1) + i];
			scale += chain->c[3*(k - 1) + i]*shape[3*(k - 1) + i];
		}
	}
	if (isnan(relax(chain, 0)))
		return NAN;
	memcpy(chain->rest, chain->x, sizeof chain->x);
	/* 1/K = c' H^-1 c */
	(void)strain(chain, chain->x, 1);
	memcpy(solved, chain->c, sizeof chain->c);
	LAPACKE_dgesv(LAPACK_COL_MAJOR, chain->size, 1, chain->matrix, chain->size + 1, pivot, solved,
	              chain->size + 1);
	for (int i = 0; i < chain->size; i++)
		soft += chain->c[i]*solved[i];
	for (int i = 0; i < chain->size; i++)
		chain->x[i] += u/scale*shape[i];
	R = relax(chain, 1);
	return R*soft/u - 1.0;
}

/* Two meshes: second order, and Richardson's extrapolation of them. */
static void check_chain(struct hawser_scene scene, int j, double amplitude, double tolerance)
{
	static struct chain chain;
	struct hawser_law_point point = {.amplitude = amplitude};
	struct hawser_report report = {.message = ""};
	struct span span;
	double coarse, fine, order;
	char what[80];

	if (make(&span, scene, 6) &&
	    ok(!hawser_law_trace(&point, 1, &span.rom, &span.st, j, &report) && !point.end &&
	       point.error <= 1e-3*fabs(1.0 + point.exact), "%s at %g m %s", span.rom.label[j], amplitude,
	       report.message)) {
		coarse = law(&chain, &span, MOST/2, j, point.u);
		fine = law(&chain, &span, MOST, j, point.u);
		order = (coarse - point.exact)/(fine - point.exact);
		ok(order > 3.3 && order < 4.7, "order of the chain: the errors' ratio is %.3g", order);
		snprintf(what, sizeof what, "law of %s at %g m", span.rom.label[j], amplitude);
		close_to(fine + (fine - coarse)/3.0, point.exact, tolerance, what);
	}
	clear(&span);
}

/* ../shared table of the outside program: law/a^2 of the first out-of-plane coordinate of the
 * footbridge, a = sqrt(2) d u, by 64 exact bars, and of models with 5 to 24 modes. */
static void check_table(void)
{
	static const int modes[] = {5, 9, 16, 24};
	static const double u[] = {0.1, 0.4, 1.1, 1.6};
	static const double exact[] = {6.859e-3, 6.88e-3, 7.03e-3, 7.25e-3};
	static const double model[][4] = {{6.80e-3, 6.84e-3, 7.06e-3, 7.32e-3},
		{6.81e-3, 6.92e-3, 7.68e-3, 8.57e-3}, {6.84e-3, 7.50e-3, 1.17e-2, 1.59e-2},
		{7.28e-3, 1.43e-2, 4.9e-2, 6.9e-2}};

	for (int k = 0; k < 4; k++) {
		struct hawser_law_point held[4], alike[4];
		struct span span;

		if (!make(&span, footbridge(), modes[k]))
			continue;
		for (int i = 0; i < 4; i++) {
			held[i] = (struct hawser_law_point){.amplitude = M_SQRT2*u[i]};
			alike[i] = (struct hawser_law_point){.amplitude = u[i]/104.0*span.rom.range[0].largest};
		}
		ok(!hawser_law_trace(held, 4, &span.rom, &span.st, 0, NULL) &&
		   !hawser_law_trace(alike, 4, &span.rom, &span.st, 0, NULL), "%d modes", modes[k]);
		for (int i = 0; i < 4; i++) {
			double a2 = 2.0*u[i]*u[i];

			close_to(held[i].exact/a2, exact[i], i < 3 ? 6e-4 : 2e-3, "exact");
			close_to(alike[i].model/a2, model[k][i], 7e-3, "model");
		}
		clear(&span);
	}
}

/* --- the range --- */

static double error_at(const struct span *span, int j, double a)
{
	struct hawser_law_point point[2] = {{.amplitude = a}, {.amplitude = -a}};
	double worst = 0.0;

	if (hawser_law_trace(point, 2, &span->rom, &span->st, j, NULL))
		return NAN;
	for (int i = 0; i < 2; i++)
		worst = fmax(worst, point[i].end ? INFINITY
		                    : fmax(fabs(point[i].model - point[i].exact)/
		                           fmax(fabs(1.0 + point[i].exact), 1.0),
		                           fmax(point[i].inertia,
		                                point[i].damping + 0.5*point[i].inertia)));
	return worst;
}

/* A heavy mass on a light rope swings as a pendulum of the length r of its sag, and rises by
 * s = r - sqrt(r^2 - u^2), which the model of that mode does not have: with a damping ratio as its
 * bounce on both halves of the rope, of the length l, is damped. */
static void check_pendulum(void)
{
	struct hawser_scene scene = {.cable = {.EA = 1e8, .rho = 0.01}, .span = {40.0, 0.0}, .g = 9.81};
	struct hawser_law_point point = {.amplitude = 0.513};
	struct span span;
	double r, s, l = 20.5;

	scene.tension.given = HAWSER_GIVEN_LENGTH0;
	scene.tension.value = 41.0;
	scene.model.condense = HAWSER_CONDENSE_STATIC;
	scene.attachments = 1;
	scene.attach[0].at = 0.5;
	scene.attach[0].mass = 200.0;
	scene.damping.kind = HAWSER_DAMPING_RATIO;
	scene.damping.ratio = 0.01;
	scene.load.present = 1; /* of modes that it excites the damping is known */
	scene.load.per_length[1] = scene.load.extent[1] = 1.0;
	if (make(&span, scene, 1) &&
	    ok(!hawser_rom_know_below(&span.rom, &span.modes, &scene, 50.0*sqrt(*span.rom.K), NULL) &&
	       !hawser_law_trace(&point, 1, &span.rom, &span.st, 0, NULL), "law")) {
		r = span.st.sag;
		s = r - sqrt(r*r - point.amplitude*point.amplitude);
		close_to(point.inertia, 2.0*pow(s/point.amplitude, 2), 2e-3, "inertia of a pendulum");
		close_to(point.damping, pow(s/point.amplitude, 2)*
		         sqrt(2.0*1e8/l*pow(r/l, 2)/200.0*r/9.81), 1e-2, "its damping");
	}
	clear(&span);
}

/* Within the limit below the range, and not above it. */
static void check_range(struct hawser_scene scene, int n)
{
	struct span span;

	if (make(&span, scene, n) && ok(!hawser_law_range(&span.rom, &span.st, NULL, NULL), "range"))
		for (int j = 0; j < n; j += 4) {
			const struct hawser_rom_range *range = &span.rom.range[j];

			ok(range->end == HAWSER_RANGE_FORCE && error_at(&span, j, range->amplitude) <= 0.01 &&
			   error_at(&span, j, 1.04*range->amplitude) > 0.01, "%s: %g m, %.4f and %.4f beyond",
			   span.rom.label[j], range->amplitude, error_at(&span, j, range->amplitude),
			   error_at(&span, j, 1.04*range->amplitude));
		}
	clear(&span);
}

static void check_taut(void)
{
	struct span span;
	double u[3] = {0.0}, most;

	if (make(&span, taut(), 3) && ok(!hawser_law_range(&span.rom, &span.st, NULL, NULL), "taut")) {
		most = 0.05*211.3;
		ok(span.rom.range[0].end == HAWSER_RANGE_AT_LEAST &&
		   fabs(span.rom.range[0].amplitude/most - 1.0) < 1e-12, "taut: %g m, at least",
		   span.rom.range[0].amplitude);
		u[0] = 2.0*most/span.rom.range[0].largest;
		ok(hawser_law_exceeded(&span.rom, u) == -1, "what was not sought is not exceeded");
	}
	clear(&span);
}

/* Up to what a motion has reached; and which coordinate exceeds its range most. */
static void check_reached(void)
{
	struct span span;
	double u[5] = {0.0};

	if (!make(&span, footbridge(), 5))
		return;
	u[0] = 0.7/span.rom.range[0].largest;
	u[3] = 0.9/span.rom.range[3].largest;
	ok(!hawser_law_range(&span.rom, &span.st, u, NULL) &&
	   span.rom.range[0].end == HAWSER_RANGE_AT_LEAST &&
	   span.rom.range[1].end == HAWSER_RANGE_UNKNOWN &&
	   span.rom.range[3].end == HAWSER_RANGE_FORCE && span.rom.range[3].amplitude < 0.9,
	   "in-plane 2 at 0.9 m: %g m", span.rom.range[3].amplitude);
	ok(hawser_law_exceeded(&span.rom, u) == 3, "exceeded");
	clear(&span);
}

static void check_slack(void)
{
	struct hawser_scene scene = steep();
	struct hawser_law_point point[2] = {{.amplitude = -3.0}, {.amplitude = -10.0}};
	struct span span;

	scene.span.h = -60.165;
	scene.tension.value = 72.311;
	if (make(&span, scene, 4)) {
		ok(!hawser_law_trace(point, 2, &span.rom, &span.st, 3, NULL) && !point[0].end &&
		   point[1].end == HAWSER_LAW_SLACK, "slack at %g m, not at %g", point[1].amplitude,
		   point[0].amplitude);
		ok(!hawser_law_range(&span.rom, &span.st, NULL, NULL) &&
		   span.rom.range[3].amplitude < -point[1].amplitude, "the range ends before: %g m",
		   span.rom.range[3].amplitude);
	}
	clear(&span);
}

static void check_refusals(void)
{
	struct hawser_law_point point = {.amplitude = 0.0};
	struct hawser_report report = {.message = ""};
	struct hawser_rom full = {.n = 0};
	struct span span;

	if (!make(&span, taut(), 3))
		return;
	ok(hawser_law_trace(&point, 1, &span.rom, &span.st, 0, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "amplitude 0 m"), "%s", report.message);
	point.amplitude = 0.1;
	ok(hawser_law_trace(&point, 1, &span.rom, &span.st, 3, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "coordinate 3 is no mode"), "%s", report.message);
	ok(!hawser_rom_build_full(&full, &span.st, NULL, 8, NULL) &&
	   hawser_law_trace(&point, 1, &full, &span.st, 0, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "model.energy: quartic"), "%s", report.message);
	hawser_rom_clear(&full);
	clear(&span);
}

static void check_file(void)
{
	struct hawser_report report = {.message = ""};
	struct hawser_rom copy = {.n = 0};
	char path[] = "static-law-XXXXXX";
	int file = mkstemp(path), same = 1;
	struct span span;

	if (file < 0 || !make(&span, footbridge(), 4))
		return;
	close(file);
	ok(!hawser_law_range(&span.rom, &span.st, NULL, NULL) && !hawser_rom_save(&span.rom, path, NULL) &&
	   !hawser_rom_open(&copy, path, &report) && copy.range, "the file %s", report.message);
	for (int j = 0; copy.range && j < 4; j++)
		same &= copy.range[j].largest == span.rom.range[j].largest &&
		        copy.range[j].amplitude == span.rom.range[j].amplitude &&
		        copy.range[j].end == span.rom.range[j].end;
	ok(same, "the same ranges");
	hawser_rom_clear(&copy);
	clear(&span);
	unlink(path);
}

CASE(property_static_law)
{
	check_chain(footbridge(), 0, 1.5556, 1e-5);
	check_chain(footbridge(), 3, -0.7, 2e-4);
	check_chain(steep(), 1, 0.9, 3e-4);
	check_chain(laden(), 2, 1.1, 1e-4);
	check_chain(taut(), 0, 3.3, 1e-5);
	check_table();
	check_range(footbridge(), 9);
	check_range(steep(), 5);
	check_pendulum();
	check_taut();
	check_reached();
	check_slack();
	check_refusals();
	check_file();
	return done_testing();
}
