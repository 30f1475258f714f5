/* Models of a cable on elastic supports: their energy against that of a chain of links on the displaced
 * nodes, with the springs, their preload and the weight; damping of the cable alone; refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/rom.h>

#include "tests/tap.h"

static struct hawser_report report;
enum { COUNT = 6 };

static int solve(struct hawser_modes *modes, const struct hawser_span *span, double T0,
                 const struct hawser_held *held)
{
	const struct hawser_modes_options options = {.n = COUNT};
	struct hawser_statics st;

	if (!hawser_statics_solve(&st, span, HAWSER_GIVEN_T0, T0, HAWSER_BRANCH_TAUT, &report) &&
	    !hawser_statics_hold(&st, held, &report) && !hawser_modes_solve(modes, &st, &options, &report))
		return 1;
	return ok(0, "solved: %s", report.message);
}

/* Displacement (m) along x, y, z at s of the coordinates u. */
static void displaced(double x[3], const struct hawser_modes *modes, const double *u, double s)
{
	struct hawser_frame_point at = hawser_statics_frame(&modes->statics, s);
	double d = modes->statics.span.d;

	memset(x, 0, 3*sizeof *x);
	for (int k = 0; k < modes->n; k++) {
		double p[3];

		hawser_modes_at(modes, p, NULL, k, s);
		x[0] += d*u[k]*(p[0]*at.ex - p[1]*at.ey);
		x[1] += d*u[k]*(p[0]*at.ey + p[1]*at.ex);
		x[2] += d*u[k]*p[2];
	}
}

/* Energy (J) of `links` links whose nodes are on the displaced cable, minus that at rest. The force of
 * the preload is minus that of the cable at rest: (H, V0) on end A, (-H, -V1) on end B. */
static double chain(const struct hawser_modes *modes, const double *u, int links)
{
	const struct hawser_statics *st = &modes->statics;
	double h = st->length0/links, sum = 0.0, last[3] = {0.0}, at[3] = {0.0};
	struct hawser_profile_point before = hawser_statics_at(st, 0.0);

	for (int i = 0; i <= links; i++) {
		struct hawser_profile_point here = hawser_statics_at(st, i < links ? i*h : st->length0);
		double x, y, rest, now;

		displaced(at, modes, u, i*h/st->span.d);
		if (i == 0 || i == links) {
			const struct hawser_held *held = &st->held[i > 0];
			double sign = i ? -1.0 : 1.0;

			sum += sign*(st->H*at[0] + (i ? st->V1 : st->V0)*at[1]);
			for (int c = 0; c < 3; c++)
				sum += isfinite(held->stiffness[c]) ? 0.5*held->stiffness[c]*at[c]*at[c] : 0.0;
		}
		sum += st->span.rho*st->span.g*h*(i == 0 || i == links ? 0.5 : 1.0)*at[1];
		if (i > 0) {
			x = here.x - before.x;
			y = here.y - before.y;
			rest = hypot(x, y)/h - 1.0;
			now = sqrt((x + at[0] - last[0])*(x + at[0] - last[0]) +
			           (y + at[1] - last[1])*(y + at[1] - last[1]) +
			           (at[2] - last[2])*(at[2] - last[2]))/h - 1.0;
			sum += 0.5*st->span.EA*h*(now - rest)*(now + rest);
		}
		before = here;
		memcpy(last, at, sizeof last);
	}
	return sum;
}

/* Richardson's extrapolation: the chain is of second order. */
static double limit(const struct hawser_modes *modes, const double *u)
{
	double coarse = chain(modes, u, 800), fine = chain(modes, u, 1600);

	return fine + (fine - coarse)/3.0;
}

static const struct hawser_span span = {2e6, 6.0, 9.81, 100.0, 45.0};
static const struct hawser_held held[2] = {{{2385.0, 5100.0, 900.0}, 231.7, 0.0},
                                           {{7000.0, INFINITY, 400.0}, 55.0, 0.0}};

static void energies(struct hawser_scene *scene)
{
	const double u[COUNT] = {0.011, -0.017, 0.008, 0.013, -0.009, 0.0121}, none[COUNT] = {0.0};
	struct hawser_rom exact, quartic;
	struct hawser_modes modes;
	double unit, all, small, off[2], truncated[2];

	if (!solve(&modes, &span, 6500.0, held))
		return;
	if (hawser_rom_build_exact(&exact, &modes, scene, &report) ||
	    hawser_rom_build(&quartic, &modes, scene, &report)) {
		ok(0, "built: %s", report.message);
		return;
	}
	unit = modes.statics.H*span.d;
	for (int i = 0; i < 2; i++) {
		double v[COUNT];

		for (int k = 0; k < COUNT; k++)
			v[k] = u[k]*(i ? 0.25 : 1.0);
		all = limit(&modes, v)/unit;
		off[i] = fabs(hawser_rom_energy(&exact, v, none)/all - 1.0);
		truncated[i] = fabs(hawser_rom_energy(&quartic, v, none)/all - 1.0);
		small = all;
	}
	ok(off[0] < 1e-6 && off[1] < 1e-6, "the exact energy is that of a chain on springs: %.1e, %.1e of "
	   "%.2e", off[0], off[1], small);
	ok(truncated[0] < 1e-2 && truncated[1] < truncated[0]/50.0,
	   "the quartic energy up to terms of degree 5: %.1e, %.1e", truncated[0], truncated[1]);
	hawser_rom_clear(&exact);
	hawser_rom_clear(&quartic);
	hawser_modes_clear(&modes);
}

/* The power of still air is that on the cable alone. */
static void damping(struct hawser_scene *scene)
{
	struct hawser_modes modes;
	struct hawser_rom rom;
	double worst = 0.0, beside = 0.0;

	if (!solve(&modes, &span, 6500.0, held))
		return;
	scene->damping.kind = HAWSER_DAMPING_ALPHA;
	scene->damping.alpha = 0.2385;
	if (hawser_rom_build(&rom, &modes, scene, &report)) {
		ok(0, "built: %s", report.message);
		hawser_modes_clear(&modes);
		return;
	}
	for (int j = 0; j < COUNT; j++)
		for (int k = 0; k < COUNT; k++) {
			const struct hawser_grid *grid = &modes.grid;
			double sum = 0.0;

			for (int i = 0; i < 3*grid->points; i++)
				sum += grid->weight[i/3]*modes.shape[j*3*grid->points + i]*
				       modes.shape[k*3*grid->points + i];
			sum *= scene->damping.alpha*modes.time_unit/span.rho;
			worst = fmax(worst, fabs(rom.D[j*COUNT + k] - sum));
			beside = fmax(beside, j != k ? fabs(sum) : 0.0);
		}
	ok(worst < 1e-12 && beside > 1e-3, "damping by still air acts on the cable alone: %.1e, with %.1e "
	   "beside the diagonal", worst, beside);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	scene->damping.kind = HAWSER_DAMPING_NONE;
}

/* Two kept modes with the others condensed: forces of all modes of a basis, of which the others
 * answer statically. */
static void condensed(struct hawser_scene *scene)
{
	const struct hawser_modes_options options = {.n = 2};
	const double amplitude = 3e-4;
	struct hawser_modes kept, all;
	struct hawser_rom small, large;
	struct hawser_statics st;
	double worst = 0.0;

	scene->load.present = 1;
	scene->load.frame = HAWSER_FRAME_GLOBAL;
	scene->load.extent[0] = 0.1;
	scene->load.extent[1] = 0.7;
	scene->load.per_length[0] = 1.1;
	scene->load.per_length[1] = 2.385;
	scene->load.per_length[2] = 0.7;
	scene->model.condense = HAWSER_CONDENSE_STATIC;
	scene->model.inertia = HAWSER_INERTIA_NONE;
	if (hawser_statics_solve(&st, &span, HAWSER_GIVEN_T0, 6500.0, HAWSER_BRANCH_TAUT, &report) ||
	    hawser_statics_hold(&st, held, &report) || hawser_modes_solve(&kept, &st, &options, &report) ||
	    hawser_modes_basis(&all, &st, 16, 16, &report) ||
	    hawser_rom_build(&small, &kept, scene, &report) ||
	    hawser_rom_build_exact(&large, &all, scene, &report)) {
		ok(0, "condensed: %s", report.message);
		return;
	}
	for (int trial = 0; trial < 3; trial++) {
		/* static equilibrium of all other modes with the kept ones held, by iteration with K */
		double *u = calloc((size_t)large.n, sizeof *u), *f = calloc((size_t)large.n, sizeof *f);
		double mine[2], v[2] = {amplitude*(1.0 - trial), amplitude*(0.5 + trial)};

		u[0] = v[0];
		u[1] = v[1];
		for (int i = 0; i < 60; i++) {
			hawser_rom_restoring(&large, f, u);
			for (int k = 2; k < large.n; k++)
				u[k] -= f[k]/large.K[k*large.n + k];
		}
		hawser_rom_restoring(&large, f, u);
		hawser_rom_restoring(&small, mine, v);
		for (int k = 0; k < 2; k++) {
			double linear = large.K[k*large.n + k]*v[k], bent = f[k] - linear;

			worst = fmax(worst, fabs(mine[k] - f[k])/fmax(fabs(bent), 1e-3*fabs(linear)));
		}
		free(u);
		free(f);
	}
	ok(worst < 1e-4, "the condensed forces are those of all modes in equilibrium: %.1e", worst);
	hawser_rom_clear(&small);
	hawser_rom_clear(&large);
	hawser_modes_clear(&kept);
	hawser_modes_clear(&all);
	scene->load.present = 0;
}

static void refused(struct hawser_scene *scene)
{
	struct hawser_modes modes;
	struct hawser_rom rom;

	if (!solve(&modes, &span, 6500.0, held))
		return;
	scene->model.condense = HAWSER_CONDENSE_NONE;
	scene->model.modes = HAWSER_MODES_AUTO;
	ok(hawser_rom_build_linear(&rom, &modes, scene, &report) == HAWSER_ERR_ARGUMENT &&
	           strstr(report.message, "does not know elastic"), "%s", report.message);
	scene->model.modes = 5;
	hawser_modes_clear(&modes);
}

CASE(property_rom_elastic)
{
	static struct hawser_scene scene = {.model = {.condense = HAWSER_CONDENSE_NONE, .modes = 5}};

	energies(&scene);
	damping(&scene);
	condensed(&scene);
	refused(&scene);
	return done_testing();
}
