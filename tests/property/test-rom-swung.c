/* The model of a cable that hangs in another plane under ice and wind: its frequencies and its response
 * to a load along global axes against a chain of masses in space, and its tensors against those of the
 * span with the same shape in the vertical plane under a turned load.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/rom.h>
#include "tests/tap.h"

static struct hawser_scene scene_of(void)
{
	struct hawser_scene scene = {.cable = {.EA = 3.1e6, .rho = 1.571}, .span = {211.3, 23.7},
	                             .g = 9.81};

	scene.tension.given = HAWSER_GIVEN_T0;
	scene.tension.value = 9.7e3;
	scene.tension.state = HAWSER_STATE_LOADED;
	scene.static_load.present = 1;
	scene.static_load.per_length[0] = 1.9;
	scene.static_load.per_length[1] = -0.7;
	scene.static_load.per_length[2] = 13.3;
	scene.static_load.mass = 0.67;
	scene.load.present = 1;
	scene.load.frame = HAWSER_FRAME_GLOBAL;
	scene.load.per_length[0] = 0.3;
	scene.load.per_length[1] = -1.1;
	scene.load.per_length[2] = 0.7;
	scene.load.extent[1] = 1.0;
	return scene;
}

/* --- a chain of `elements` springs with masses at the joints, in global axes --- */

enum { MOST = 128, SIZE = 3*(MOST - 1) };

/* Joint k, on the profile: its distance from the joints of the loaded chain is of second order. */
static void joint(double x[3], const struct hawser_statics *st, int k, int elements)
{
	struct hawser_profile_point at = hawser_statics_at(st, st->length0*k/elements);
	const double in[3] = {at.x, at.y, 0.0};

	hawser_statics_to_global(st, x, in);
}

/* Stiffness of the joints between the ends. An element has the stiffness EA/L0 along itself and T/L
 * across. */
static void stiffness(double *K, const struct hawser_statics *st, int elements)
{
	int size = 3*(elements - 1);
	double part = st->length0/elements, EA = st->span.EA;

	memset(K, 0, (size_t)size*(size_t)size*sizeof *K);
	for (int e = 0; e < elements; e++) {
		double a[3], b[3], t[3], L = 0.0;

		joint(a, st, e, elements);
		joint(b, st, e + 1, elements);
		for (int i = 0; i < 3; i++)
			L += (b[i] - a[i])*(b[i] - a[i]);
		L = sqrt(L);
		for (int i = 0; i < 3; i++)
			t[i] = (b[i] - a[i])/L;
		for (int i = 0; i < 9; i++) {
			double across = EA*(1.0/part - 1.0/L);
			double k = (EA/part - across)*t[i/3]*t[i%3] + (i/3 == i%3 ? across : 0.0);

			for (int corner = 0; corner < 4; corner++) {
				int p = e - 1 + corner/2, q = e - 1 + corner%2; /* joints less 1 */

				if (p >= 0 && q >= 0 && p < elements - 1 && q < elements - 1)
					K[(size_t)(3*p + i/3)*(size_t)size + (size_t)(3*q + i%3)] +=
						p == q ? k : -k;
			}
		}
	}
}

/* omega[count], rad/s, and the static response [3] of the middle to the scene's load, m. */
static int chain(double *omega, int count, double middle[3], const struct hawser_statics *st,
                 const struct hawser_scene *scene, int elements)
{
	static double K[SIZE*SIZE], f[SIZE], w[SIZE];
	static lapack_int pivot[SIZE];
	int size = 3*(elements - 1);
	double part = st->length0/elements;

	stiffness(K, st, elements);
	for (int i = 0; i < size; i++)
		f[i] = scene->load.per_length[i%3]*part;
	if (LAPACKE_dgesv(LAPACK_ROW_MAJOR, size, 1, K, size, pivot, f, 1))
		return 0;
	memcpy(middle, f + 3*(elements/2 - 1), 3*sizeof *middle);
	stiffness(K, st, elements);
	if (LAPACKE_dsyev(LAPACK_ROW_MAJOR, 'N', 'U', size, K, size, w))
		return 0;
	for (int k = 0; k < count; k++)
		omega[k] = sqrt(w[k]/(st->span.rho*part));
	return 1;
}

static int built(struct hawser_statics *st, struct hawser_modes *modes, struct hawser_rom *rom,
                 const struct hawser_scene *scene, int n)
{
	struct hawser_modes_options options = {.n = n};
	struct hawser_report report = {.message = ""};

	*modes = (struct hawser_modes){.n = 0};
	return ok(!hawser_statics_scene(st, scene, &report) &&
	          !hawser_modes_solve(modes, st, &options, &report) &&
	          !hawser_rom_build(rom, modes, scene, &report), "model of %d modes %s", n, report.message);
}

static void against_chain(void)
{
	enum { COUNT = 6 };
	struct hawser_scene scene = scene_of();
	struct hawser_statics st;
	struct hawser_modes modes;
	struct hawser_rom rom;
	double coarse[COUNT], fine[COUNT], low[3], high[3], u[100], xyz[3];
	struct hawser_report report = {.message = ""};

	if (!ok(!hawser_statics_scene(&st, &scene, &report) &&
	        !hawser_rom_build_full(&rom, &st, &scene, 20, &report), "full model %s", report.message))
		return;
	modes = (struct hawser_modes){.n = 0};
	if (!ok(!hawser_modes_solve(&modes, &st, &(struct hawser_modes_options){.n = COUNT}, &report) &&
	        chain(coarse, COUNT, low, &st, &scene, MOST/2) &&
	        chain(fine, COUNT, high, &st, &scene, MOST), "chain %s", report.message))
		return;
	for (int k = 0; k < COUNT; k++)
		close_to(modes.mode[k].omega/modes.time_unit, (4.0*fine[k] - coarse[k])/3.0, 2e-6,
		         hawser_plane_name(modes.mode[k].plane));
	for (int j = 0; j < rom.n; j++)
		u[j] = rom.harmonic->f[j]/rom.K[(size_t)j*(size_t)(rom.n + 1)];
	hawser_rom_displacement(&rom, xyz, 1, u);
	for (int i = 0; i < 3; i++)
		ok(fabs(xyz[i]*rom.length - (4.0*high[i] - low[i])/3.0) <
		   2e-5*hypot(high[0], hypot(high[1], high[2])),
		   "static response of the middle along %c: %.9g m, of chains of 64 and 128 elements "
		   "%.9g, %.9g m", "xyz"[i], xyz[i]*rom.length, low[i], high[i]);
	hawser_modes_clear(&modes);
	hawser_rom_clear(&rom);
}

/* The equal span in the vertical plane. */
static struct hawser_scene upright(const struct hawser_scene *scene, const struct hawser_statics *st)
{
	struct hawser_scene other = *scene;

	other.static_load.present = 0;
	other.cable.rho = st->span.rho;
	other.g = st->span.g;
	other.span.d = st->span.d;
	other.span.h = st->span.h;
	hawser_statics_from_global(st, other.load.per_length, scene->load.per_length);
	return other;
}

static double apart(const double *a, const double *b, size_t count)
{
	double most = 0.0, gap = 0.0;

	for (size_t i = 0; i < count; i++) {
		most = fmax(most, fabs(b[i]));
		gap = fmax(gap, fabs(a[i] - b[i]));
	}
	return gap/most;
}

/* Forces at a state, with condensed modes, and the motion of the probes. */
static void against_upright(void)
{
	struct hawser_scene swung = scene_of(), scene;
	struct hawser_statics st, still;
	struct hawser_modes modes[2];
	struct hawser_rom rom[2];
	const struct hawser_rom_moment moment = {.tau = 0.7, .omega = 1.3};
	double u[12], v[12] = {0.0}, a[2][12], xyz[2][3], turned[3];

	if (!built(&st, &modes[0], &rom[0], &swung, 5))
		return;
	scene = upright(&swung, &st);
	if (!built(&still, &modes[1], &rom[1], &scene, 5))
		return;
	if (!ok(rom[0].n == rom[1].n && rom[0].n >= 5 && rom[0].n <= 12, "both have %d coordinates",
	        rom[0].n))
		return;
	for (int j = 0; j < rom[0].n; j++)
		u[j] = 0.0121*sin(2.385*(j + 1));
	for (int i = 0; i < 2; i++)
		hawser_rom_acceleration(&rom[i], a[i], u, v, 0.7, 1.3);
	ok(apart(a[0], a[1], (size_t)rom[0].n) < 1e-11, "accelerations differ by %.1e",
	   apart(a[0], a[1], (size_t)rom[0].n));
	for (int p = 0; p < 3; p++) {
		hawser_rom_displacement_at(&rom[0], xyz[0], p, u, &moment);
		hawser_rom_displacement_at(&rom[1], xyz[1], p, u, &moment);
		hawser_statics_to_global(&st, turned, xyz[1]);
		ok(apart(xyz[0], turned, 3) < 1e-12, "%s moves as there, turned: difference %.1e",
		   rom[0].shapes.name[p], apart(xyz[0], turned, 3));
		close_to(hawser_rom_tension_at(&rom[0], p, u, &moment),
		         hawser_rom_tension_at(&rom[1], p, u, &moment), 1e-12, "tension there");
	}
	for (int i = 0; i < 2; i++) {
		hawser_modes_clear(&modes[i]);
		hawser_rom_clear(&rom[i]);
	}
}

/* Participation along the global axes: all modes together move the whole mass along each. */
static void participation(void)
{
	struct hawser_scene scene = scene_of();
	struct hawser_report report = {.message = ""};
	struct hawser_statics st;
	struct hawser_modes modes = {.n = 0};
	double sum[3] = {0.0};

	if (!ok(!hawser_statics_scene(&st, &scene, &report) &&
	        !hawser_modes_basis(&modes, &st, 24, 24, &report), "basis %s", report.message))
		return;
	for (int k = 0; k < modes.n; k++)
		for (int i = 0; i < 3; i++)
			sum[i] += modes.mode[k].effective_mass[i];
	for (int i = 0; i < 3; i++)
		ok(sum[i] > 0.95 && sum[i] < 1.0 + 1e-9, "effective mass along %c: %.6f", "xyz"[i], sum[i]);
	hawser_modes_clear(&modes);
}

/* The file of such a model has the axes. */
static void file(void)
{
	struct hawser_scene scene = scene_of();
	struct hawser_statics st;
	struct hawser_modes modes;
	struct hawser_rom rom, again;
	struct hawser_report report = {.message = ""};
	const char *path = "test-rom-swung.json";

	if (!built(&st, &modes, &rom, &scene, 3))
		return;
	if (ok(!hawser_rom_save(&rom, path, &report) && !hawser_rom_open(&again, path, &report),
	       "saved and read %s", report.message)) {
		ok(again.shapes.turned && !memcmp(again.shapes.axes, rom.shapes.axes, sizeof rom.shapes.axes),
		   "the axes are those that were saved");
		hawser_rom_clear(&again);
	}
	remove(path);
	rom.shapes.axes[1][2] += 0.01;
	ok(!hawser_rom_save(&rom, path, &report) &&
	   hawser_rom_open(&again, path, &report) == HAWSER_ERR_SCENE &&
	   strstr(report.message, "three orthogonal"), "axes that are none: %s", report.message);
	remove(path);
	hawser_modes_clear(&modes);
	hawser_rom_clear(&rom);
}

CASE(property_rom_swung)
{
	against_chain();
	against_upright();
	participation();
	file();
	return done_testing();
}
