/* Galloping of an iced conductor: critical speeds by damped modes and by the reduced model, amplitudes
 * by long integration, the terms against the exact force, and a wind along a profile.
 *
 * Numbers: an independent projection on parabolic cables with sines, and on hawser's modes; 1e-3 is
 * the distance of the two.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <stdlib.h>

#include <hawser/damped.h>
#include <hawser/integrate.h>

#include "tests/tap.h"
#include "tests/unit/scene-text.h"

static struct hawser_report report;

static const char conductor[] =
	"cable: {EA: 25 MN, rho: 1.6 kg/m}\nspan: {d: 300 m, h: 0 m}\n"
	"tension: {H: 30 kN, state: loaded}\ndamping: {ratio: 0.005}\nload: {static: {mass: 0.4 kg/m}}\n"
	"wind: {speed: 6 m/s, density: 1.225 kg/m^3, diameter: 32 mm, drag: [1, 0.2, 1.5],\n"
	"       lift: [0.1, -1.8, 0, 8]}\nmodel: {modes: 4}\n";

static int read(struct hawser_scene *scene, const char *const *set, size_t sets)
{
	return ok(!read_bytes(scene, conductor, strlen(conductor), set, sets, &report), "a scene %s",
	          report.message);
}

static int build(struct hawser_rom *rom, struct hawser_modes *modes, const struct hawser_scene *scene)
{
	const struct hawser_modes_options options = {.n = 4};
	struct hawser_statics statics;

	*rom = (struct hawser_rom){.n = 0};
	*modes = (struct hawser_modes){.n = 0};
	return ok(!hawser_statics_scene(&statics, scene, &report) &&
	          !hawser_modes_solve(modes, &statics, &options, &report) &&
	          !hawser_rom_build(rom, modes, scene, &report), "a model %s", report.message);
}

/* The largest growth over frequency of u'' + D u' + K u = 0. */
static double growth(const struct hawser_rom *rom)
{
	enum { N = 8 };
	double A[N*N] = {0.0}, re[N], im[N], most = -INFINITY;

	for (int j = 0; j < rom->n; j++) {
		A[j*N + N/2 + j] = 1.0;
		for (int k = 0; k < rom->n; k++) {
			A[(N/2 + j)*N + k] = -rom->K[j*rom->n + k];
			A[(N/2 + j)*N + N/2 + k] = -rom->D[j*rom->n + k];
		}
	}
	if (LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', N, A, N, re, im, NULL, N, NULL, N))
		return NAN;
	for (int i = 0; i < N; i++)
		most = fmax(most, re[i]/hypot(re[i], im[i]));
	return most;
}

/* Events of damped modes over the speed, and the first one by the model of four modes. */
static void critical(const char *const *set, size_t sets, double first, double second, double omega)
{
	static const double speed[] = {1.0, 17.0/6.0, 14.0/3.0, 6.5, 25.0/3.0, 61.0/6.0, 12.0};
	const struct hawser_damped_sweep_options options = {
		.key = "wind.speed", .value = speed, .points = 7, .modes = {.n = 4}};
	struct hawser_damped_sweep sweep = {.points = 0};
	struct hawser_scene scene;

	if (!read(&scene, set, sets))
		return;
	if (ok(!hawser_damped_trace(&sweep, &scene, &options, &report) && sweep.events == 2,
	       "two modes begin to grow %s", report.message)) {
		double side[2];

		close_to(sweep.event[0].value, first, 1e-4, "critical speed");
		close_to(sweep.event[1].value, second, 1e-4, "of the next mode");
		if (omega > 0.0)
			close_to(2.0*acos(-1.0)*sweep.event[0].frequency, omega, 1e-5, "its frequency");
		for (int i = 0; i < 2; i++) {
			struct hawser_modes modes;
			struct hawser_rom rom;

			scene.wind.speed = sweep.event[0].value*(i ? 1.0001 : 0.9999);
			side[i] = build(&rom, &modes, &scene) ? growth(&rom) : NAN;
			hawser_rom_clear(&rom);
			hawser_modes_clear(&modes);
		}
		ok(side[0] < 0.0 && side[1] > 0.0, "that of the model is the same within 1e-4: %.1e, %.1e",
		   side[0], side[1]);
	}
	hawser_damped_sweep_clear(&sweep);
	hawser_scene_clear(&scene);
}

/* Half the height of the motion at mid-span in the last 3 of 250 s, from near the limit cycle. */
static double amplitude(const struct hawser_rom *rom, double begin)
{
	const double t = rom->time;
	double u[8] = {0.0};
	const struct hawser_integrate_options options = {
		.until = 250.0/t, .every = 0.02/t, .rtol = 1e-8, .atol = 1e-11, .initial = u};
	struct hawser_trajectory run;
	double least = INFINITY, most = -INFINITY;

	u[1] = begin/rom->length;
	if (!ok(!hawser_integrate(&run, rom, &options, &report), "a run %s", report.message))
		return NAN;
	for (int i = run.rows - 150; i < run.rows; i++) {
		struct hawser_rom_moment still = {.omega = 1.0};
		double at[3];

		hawser_rom_displacement_at(rom, at, 1, run.state + (size_t)i*8, &still);
		least = fmin(least, at[1]);
		most = fmax(most, at[1]);
	}
	hawser_trajectory_clear(&run);
	return 0.5*(most - least)*rom->length;
}

/* The force of third order against the exact one: accelerations at rest differ by the fourth power of
 * the velocity. */
static void orders(const struct hawser_rom *cubic, const struct hawser_rom *exact)
{
	const double u[4] = {0.0}, v[4] = {0.31, -0.9, 0.47, 0.22};
	double gap[2] = {0.0};

	for (int k = 0; k < 2; k++) {
		double at[4], a[4], b[4];

		for (int j = 0; j < 4; j++)
			at[j] = 1e-3*v[j]*(k ? 0.5 : 1.0);
		hawser_rom_acceleration(cubic, a, u, at, 0.0, 1.0);
		hawser_rom_acceleration(exact, b, u, at, 0.0, 1.0);
		for (int j = 0; j < 4; j++)
			gap[k] = fmax(gap[k], fabs(a[j] - b[j]));
	}
	ok(gap[0] > 13.0*gap[1] && gap[0] < 19.0*gap[1], "cubic and exact force differ by %.1e, at half "
	   "the velocity by 1/%.3g of it", gap[0], gap[0]/gap[1]);
}

static void cycle(void)
{
	static const char *const form[] = {"wind.form=exact"};
	struct hawser_modes modes, again;
	struct hawser_rom cubic, exact;
	struct hawser_scene scene, other;

	if (!read(&scene, NULL, 0) || !read(&other, form, 1))
		return;
	if (build(&cubic, &modes, &scene) && build(&exact, &again, &other)) {
		orders(&cubic, &exact);
		close_to(amplitude(&cubic, 0.43), 0.694339, 1e-3, "amplitude by the cubic form");
		close_to(amplitude(&exact, 0.43), 0.702179, 1e-3, "amplitude by the exact one");
	}
	hawser_rom_clear(&cubic);
	hawser_rom_clear(&exact);
	hawser_modes_clear(&modes);
	hawser_modes_clear(&again);
	hawser_scene_clear(&scene);
	hawser_scene_clear(&other);
}

CASE(reference_galloping)
{
	static const char *const other[] = {"wind.drag=[1, -0.4, 1.5]", "wind.lift=[0.6, -1.8, 0, 8]"};
	static const char *const taut[] = {"tension.H=60 kN"};

	critical(NULL, 0, 3.03908, 3.24464, 2.389515);
	critical(other, 2, 3.03677, 9.52402, 0.0); /* alone, the second mode would grow from 3.264 on */
	critical(taut, 1, 2.65982, 4.59154, 0.0);
	cycle();
	return done_testing();
}
