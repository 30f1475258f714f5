/* Supports that move as a table says: a table of a harmonic motion against the support keys, of fourth
 * order in its spacing; the instantaneous forces of all terms; a motion that is not harmonic against a
 * chain of rods; a slow one against statics; what is refused.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/integrate.h>
#include <hawser/modes.h>
#include <hawser/scene.h>

#include "rom/terms/history.h"
#include "tests/lumped-chain.h"
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

enum { ENDS = 2, AXES = 3, MOST = 1601, MANY = 24 };
static const double Omega = 0.71;

static int prepare(struct hawser_modes *modes, struct hawser_scene *scene, const char *more,
                   int n)
{
	struct hawser_modes_options options = {.n = n};
	struct hawser_statics statics;
	struct hawser_report report = {.message = ""};
	char text[1024];

	snprintf(text, sizeof text, "cable: {EA: 2 MN, rho: 8 kg/m}\nspan: {d: 100 m, h: 37 m}\n"
	         "tension: {H: 12 kN}\ndamping: {alpha: 0.3 kg/m/s}\n%s", more);
	return ok(!read_text(scene, text, NULL, &report) &&
	          !hawser_statics_scene(&statics, scene, &report) &&
	          !hawser_modes_solve(modes, &statics, &options, &report), "modes %s", report.message);
}

/* Displacement of the scene's support motion at phase tau, scaled. */
static double displacement(const struct hawser_scene *scene, double length, int end, int axis,
                           double tau)
{
	return scene->support[end].present
	       ? scene->support[end].motion[axis]/length*
	         cos(scene->support[end].harmonic*tau + scene->support[end].phase) : 0.0;
}

/* Models with harmonic supports and with a table of them, `rows` up to `until`. */
static int both(struct hawser_rom *harmonic, struct hawser_rom *table, const struct hawser_modes *modes,
                const struct hawser_scene *scene, int rows, double until)
{
	static double time[MOST], value[ENDS*AXES][MOST];
	struct hawser_rom_motion motion = {.rows = rows, .time = time};
	struct hawser_scene given = *scene;
	struct hawser_report report = {.message = ""};
	int full = scene->model.energy == HAWSER_ENERGY_EXACT;

	for (int i = 0; i < rows; i++) {
		time[i] = until*i/(rows - 1);
		for (int c = 0; c < ENDS*AXES; c++)
			value[c][i] = displacement(scene, modes->statics.span.d, c/AXES, c%AXES, Omega*time[i]);
	}
	for (int c = 0; c < ENDS*AXES; c++) {
		given.support[c/AXES].given[c%AXES] = scene->support[c/AXES].motion[c%AXES] != 0.0;
		given.support[c/AXES].motion[c%AXES] = 0.0;
		motion.value[c] = given.support[c/AXES].given[c%AXES] ? value[c] : NULL;
	}
	return ok(!(full ? hawser_rom_build_full(harmonic, &modes->statics, scene, 4, &report)
	            : hawser_rom_build(harmonic, modes, scene, &report)) &&
	          !(full ? hawser_rom_build_full(table, &modes->statics, &given, 4, &report)
	            : hawser_rom_build(table, modes, &given, &report)) &&
	          !hawser_rom_motion_set(table, &motion, &report), "models %s", report.message);
}

/* Leave out the correction of the response of condensed modes for inertia, which a table does not have:
 * it has the fourth derivative of the motion. */
static void simplify(struct hawser_rom *rom)
{
	for (int h = 0; h < rom->harmonics; h++) {
		struct hawser_harmonic *of = &rom->harmonic[h];

		for (int i = 4*rom->shapes.points; of->answer && i < 8*rom->shapes.points; i++)
			of->answer[i] = 0.0;
	}
}

/* Forces and outputs at instants, with a fine table: all terms of the energy, of inertia and of
 * damping. */
static void forces(const struct hawser_modes *modes, const struct hawser_scene *scene, const char *what)
{
	struct hawser_rom harmonic, table;
	double u[MANY], v[MANY], a[MANY], b[MANY], J[2*MANY*MANY], H[2*MANY*MANY], by_omega[MANY];
	double worst[4] = {0.0}, size[4] = {0.0}, x[2][3], T[2];

	if (!both(&harmonic, &table, modes, scene, MOST, 12.0))
		return;
	simplify(&harmonic);
	for (int j = 0; j < harmonic.n; j++) {
		u[j] = 0.011*cos(2.0*j + 0.3)/(1.0 + j);
		v[j] = 0.004*cos(3.0*j + 1.0);
	}
	for (double t = 0.3; t < 11.0; t += 1.37) {
		struct hawser_rom_moment at = {.tau = Omega*t, .omega = Omega, .time = t};
		int n = harmonic.n;

		hawser_rom_acceleration_jacobian(&harmonic, a, J, J + n*n, by_omega, u, v, Omega*t, Omega);
		hawser_rom_acceleration_jacobian(&table, b, H, H + n*n, by_omega, u, v, Omega*t, Omega);
		hawser__rom_history(&table, b, H, H + n*n, u, v, t);
		for (int j = 0; j < n; j++) {
			worst[0] = fmax(worst[0], fabs(a[j] - b[j]));
			size[0] = fmax(size[0], fabs(a[j]));
		}
		for (int j = 0; j < 2*n*n; j++) {
			worst[3] = fmax(worst[3], fabs(J[j] - H[j]));
			size[3] = fmax(size[3], fabs(J[j]));
		}
		for (int rate = 0; rate < 2; rate++) {
			for (int k = 0; k < 2; k++)
				if (rate)
					hawser_rom_velocity_at(k ? &table : &harmonic, x[k], 1, u, v, &at);
				else
					hawser_rom_displacement_at(k ? &table : &harmonic, x[k], 1, u, &at);
			for (int c = 0; c < 3; c++) {
				worst[1] = fmax(worst[1], fabs(x[0][c] - x[1][c]));
				size[1] = fmax(size[1], fabs(x[0][c]));
			}
		}
		for (int k = 0; k < 2; k++)
			T[k] = hawser_rom_tension_at(k ? &table : &harmonic, 1, u, &at);
		worst[2] = fmax(worst[2], fabs(T[0] - T[1]));
		size[2] = fmax(size[2], fabs(T[0] - modes->statics.H));
	}
	ok(worst[0] < 2e-5*size[0], "%s: the forces of a harmonic motion: %.1e of %.1e", what, worst[0],
	   size[0]);
	ok(worst[3] < 1e-8*size[3] + 1e-5*size[0], "%s: their derivatives: %.1e of %.1e", what, worst[3],
	   size[3]);
	ok(worst[1] < 1e-5*size[1], "%s: displacement and velocity: %.1e of %.1e", what, worst[1], size[1]);
	ok(worst[2] < 2e-5*size[2], "%s: tension: %.1e of %.1e", what, worst[2], size[2]);
	hawser_rom_clear(&harmonic);
	hawser_rom_clear(&table);
}

static double distance(const struct hawser_modes *modes, const struct hawser_scene *scene, int rows)
{
	struct hawser_rom harmonic, table;
	struct hawser_integrate_options options = {.omega = Omega, .until = 20.0, .every = 1.0,
		.rtol = 1e-10, .atol = 1e-13, .method = "gauss"};
	struct hawser_trajectory a, b;
	struct hawser_report report = {.message = ""};
	double far = 0.0;

	if (!both(&harmonic, &table, modes, scene, rows, 20.0) ||
	    !ok(!hawser_integrate(&a, &harmonic, &options, &report) &&
	        !hawser_integrate(&b, &table, &options, &report), "runs %s", report.message))
		return NAN;
	for (int j = 0; j < 4; j++)
		far = fmax(far, fabs(a.state[8*(a.rows - 1) + j] - b.state[8*(b.rows - 1) + j]));
	hawser_trajectory_clear(&a);
	hawser_trajectory_clear(&b);
	hawser_rom_clear(&harmonic);
	hawser_rom_clear(&table);
	return far;
}

static void refused(const struct hawser_modes *modes, const struct hawser_scene *scene)
{
	struct hawser_scene other = *scene;
	struct hawser_rom rom;
	double time[2] = {0.0, 1.0}, value[2] = {0.0};
	struct hawser_rom_motion motion = {.rows = 2, .time = time};
	struct hawser_integrate_options options = {.until = 1.0, .every = 1.0};
	struct hawser_trajectory run;
	struct hawser_report report = {.message = ""};

	memset(other.support, 0, sizeof other.support);
	if (!ok(!hawser_rom_build(&rom, modes, &other, &report), "model"))
		return;
	ok(hawser_rom_motion_set(&rom, &motion, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	hawser_rom_clear(&rom);
	other.support[1].present = other.support[1].given[1] = 1;
	if (!ok(!hawser_rom_build(&rom, modes, &other, &report), "model with a moving end"))
		return;
	ok(hawser_rom_motion_set(&rom, &motion, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	ok(hawser_integrate(&run, &rom, &options, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	motion.value[4] = value;
	ok(!hawser_rom_motion_set(&rom, &motion, &report), "two rows");
	value[1] = NAN;
	ok(hawser_rom_motion_set(&rom, &motion, &report) == HAWSER_ERR_NAN, "%s", report.message);
	value[1] = 0.5;
	time[1] = 0.0;
	ok(hawser_rom_motion_set(&rom, &motion, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	hawser_rom_clear(&rom);
}

/* --- against a chain of rods --- */

enum { SEEN = 40 };
static const double until = 4.0; /* s */

static void path(double moved[2][3], double t)
{
	static const double most[2][3] = {{0.05, -0.08, 0.06}, {-0.04, 0.11, 0.09}};
	double a = pow(sin(M_PI*t/7.0), 4.0), b = pow(sin(M_PI*t/10.0), 4.0)*cos(1.9*t);

	for (int i = 0; i < 3; i++) {
		moved[0][i] = most[0][i]*a;
		moved[1][i] = most[1][i]*b;
	}
}

struct seen {
	const struct lumped *c;
	const double *rest;
	int rows;
	double value[SEEN][4]; /* displacement and tension at mid-span */
};

static void see(const double *x, void *data)
{
	struct seen *seen = data;
	int joint = seen->c->n/2;

	for (int i = 0; i < 3; i++)
		seen->value[seen->rows][i] = x[3*joint + i] - seen->rest[3*joint + i];
	seen->value[seen->rows++][3] = 0.5*(lumped_tension(seen->c, x, joint - 1) +
	                                    lumped_tension(seen->c, x, joint));
}

static int chain(struct seen *seen, const struct hawser_scene *scene, const struct hawser_statics *st,
                 int n)
{
	static struct lumped c;
	static double x[3*LUMPED_MOST + 3], v[3*LUMPED_MOST + 3], rest[3*LUMPED_MOST + 3];

	c = (struct lumped){.n = n, .L0 = st->length0, .EA = scene->cable.EA, .rho = scene->cable.rho,
		.end = {scene->span.d, scene->span.h}, .weight = {0.0, -scene->cable.rho*scene->g},
		.gravity = scene->g, .alpha = scene->damping.alpha/scene->cable.rho, .path = path};
	for (int k = 0; k <= n; k++) {
		struct hawser_profile_point at = hawser_statics_at(st, st->length0*k/n);

		x[3*k] = at.x;
		x[3*k + 1] = at.y;
		x[3*k + 2] = 0.0;
	}
	if (!lumped_straighten(&c, x))
		return 0;
	memcpy(rest, x, sizeof rest);
	memset(v, 0, sizeof v);
	*seen = (struct seen){.c = &c, .rest = rest};
	return lumped_run(&c, x, v, 0.0, until, 12*n, 12*n/SEEN, see, seen);
}

/* A model of the scene with the motion in rows 0.05 s apart; condensed or of full order. */
static int moving(struct hawser_rom *rom, const struct hawser_modes *modes, struct hawser_scene *scene,
                  int full)
{
	static double time[161], value[6][161];
	struct hawser_rom_motion motion = {.rows = 161, .time = time};
	struct hawser_report report = {.message = ""};
	enum hawser_status status;

	for (int c = 0; c < 6; c++) {
		scene->support[c/3].present = scene->support[c/3].given[c%3] = 1;
		motion.value[c] = value[c];
	}
	status = full ? hawser_rom_build_full(rom, &modes->statics, scene, full, &report)
	         : hawser_rom_build(rom, modes, scene, &report);
	for (int i = 0; i < 161 && !status; i++) {
		double at[2][3];

		path(at, 0.05*i);
		time[i] = 0.05*i/rom->time;
		for (int c = 0; c < 6; c++)
			value[c][i] = at[c/3][c%3]/rom->length;
	}
	if (!status)
		status = hawser_rom_motion_set(rom, &motion, &report);
	return ok(!status, "model %s", report.message);
}

/* The chains are made with the first of the models. */
static void against_chain(const struct hawser_modes *modes, const struct hawser_scene *scene, int full)
{
	struct hawser_scene moved = *scene;
	static struct seen coarse, fine;
	struct hawser_rom rom;
	struct hawser_trajectory run;
	struct hawser_integrate_options options = {.rtol = 1e-9};
	double off[2] = {0.0}, size[2] = {0.0};

	memset(moved.support, 0, sizeof moved.support);
	if (!moving(&rom, modes, &moved, full))
		return;
	options.until = until/rom.time;
	options.every = options.until/SEEN;
	if (!ok((full || (chain(&coarse, scene, &modes->statics, 20) &&
	                 chain(&fine, scene, &modes->statics, 40))) &&
	        !hawser_integrate(&run, &rom, &options, NULL) && run.rows == SEEN + 1, "motions"))
		return;
	for (int i = 0; i < SEEN; i++) {
		struct hawser_rom_moment at = {.time = run.time[i + 1]};
		double got[4];

		hawser_rom_displacement_at(&rom, got, 1, run.state + 2*(i + 1)*run.n, &at);
		for (int k = 0; k < 4; k++) {
			double want = (4.0*fine.value[i][k] - coarse.value[i][k])/3.0;

			got[k] = k == 3 ? hawser_rom_tension_at(&rom, 1, run.state + 2*(i + 1)*run.n, &at)
			         : got[k]*rom.length;
			off[k == 3] = fmax(off[k == 3], fabs(got[k] - want));
			size[k == 3] = fmax(size[k == 3], fabs(want - (k == 3 ? fine.value[0][3] : 0.0)));
		}
	}
	ok(off[0] < 5e-4*size[0], "%s: displacement %.1e of %.3g m off a chain", full ? "full order"
	   : "condensed", off[0], size[0]);
	ok(off[1] < 5e-4*size[1], "%s: tension %.1e of %.4g N off it", full ? "full order" : "condensed",
	   off[1], size[1]);
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
}

/* --- slowly --- */

static void slowly(const struct hawser_modes *modes, const struct hawser_scene *scene, double limit,
                   int full)
{
	enum { SLOW = 61 };
	struct hawser_scene moved = *scene, there = *scene;
	double time[SLOW], value[2][SLOW], xyz[3], tension, place;
	const double by[2] = {0.3, -0.4};
	struct hawser_rom_motion motion = {.rows = SLOW, .time = time, .value = {[3] = value[0],
		[4] = value[1]}};
	struct hawser_rom rom;
	struct hawser_statics after;
	struct hawser_trajectory run;
	struct hawser_integrate_options options = {.method = "radau"};
	struct hawser_profile_point is, was;
	enum hawser_status status;

	memset(moved.support, 0, sizeof moved.support);
	moved.support[1].present = moved.support[1].given[0] = moved.support[1].given[1] = 1;
	status = full ? hawser_rom_build_full(&rom, &modes->statics, &moved, full, NULL)
	         : hawser_rom_build(&rom, modes, &moved, NULL);
	if (!ok(!status, "model"))
		return;
	for (int i = 0; i < SLOW; i++) {
		double s = 0.5*(1.0 + tanh(0.25*(i - 30)));

		time[i] = 10.0*i/rom.time;
		for (int c = 0; c < 2; c++)
			value[c][i] = by[c]*s/rom.length;
	}
	options.until = options.every = time[SLOW - 1];
	there.span.d += by[0];
	there.span.h += by[1];
	there.tension.given = HAWSER_GIVEN_LENGTH0;
	there.tension.value = modes->statics.length0;
	memset(there.support, 0, sizeof there.support);
	if (!ok(!hawser_rom_motion_set(&rom, &motion, NULL) &&
	        !hawser_integrate(&run, &rom, &options, NULL) &&
	        !hawser_statics_scene(&after, &there, NULL), "a slow motion"))
		return;
	place = rom.shapes.s[1]*rom.length;
	is = hawser_statics_at(&after, place);
	was = hawser_statics_at(&modes->statics, place);
	hawser_rom_displacement_at(&rom, xyz, 1, run.state + 2*(run.rows - 1)*run.n,
	                           &(struct hawser_rom_moment){.time = options.until});
	tension = hawser_rom_tension_at(&rom, 1, run.state + 2*(run.rows - 1)*run.n,
	                                &(struct hawser_rom_moment){.time = options.until});
	ok(fabs(xyz[1]*rom.length - (is.y - was.y)) < limit*fabs(is.y - was.y), "%d: displacement %.6f m, "
	   "statics %.6f m", full, xyz[1]*rom.length, is.y - was.y);
	ok(fabs(tension - is.T) < limit*fabs(is.T - was.T), "tension changes by %.3f N, statics %.3f N",
	   tension - was.T, is.T - was.T);
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
}

static const struct variant {
	const char *name, *text, *support;
} variants[] = {
	{"all modes kept", "model: {condense: none, inertia: none}\n", ""},
	{"condensed", "model: {condense: static, inertia: none}\n", ""},
	{"full order", "model: {energy: exact}\n", ""},
	{"attachments", "model: {inertia: none}\nattach: [{at: 30 %, mass: 90, spring: [0, 2 kN/m, 300], "
	 "damper: [0, 200, 0]}]\n", ""},
	{"elastic supports", "model: {inertia: none}\n", "stiffness: [1 MN/m, 3 MN/m, 2 MN/m], mass: 50, "},
	{"a wind", "model: {inertia: none}\nload: {static: {per_length: [0, -10, 25]}}\n", ""},
};

CASE(property_motion)
{
	double coarse, fine;

	for (int i = 0; i < (int)(sizeof variants/sizeof *variants); i++) {
		struct hawser_scene scene;
		struct hawser_modes modes;
		char text[500];

		snprintf(text, sizeof text, "%ssupport: {A: {%smotion: [0.2, -0.1, 0.15], phase: 0.6, "
		         "harmonic: 2}, B: {motion: [0.1, 0.3, -0.2], phase: -1.2}}\n", variants[i].text,
		         variants[i].support);
		if (!prepare(&modes, &scene, text, 4))
			continue;
		forces(&modes, &scene, variants[i].name);
		if (i == 0) {
			coarse = distance(&modes, &scene, 101);
			fine = distance(&modes, &scene, 201);
			ok(coarse/fine > 12.0 && coarse/fine < 20.0, "fourth order: %.2e, %.2e", coarse, fine);
			refused(&modes, &scene);
		}
		if (i == 1)
			slowly(&modes, &scene, 3e-3, 0);
		if (i == 2)
			slowly(&modes, &scene, 1e-4, 8);
		hawser_modes_clear(&modes);
		hawser_scene_clear(&scene);
	}
	for (int full = 0; full < 2; full++) {
		struct hawser_scene scene;
		struct hawser_modes modes;

		if (!prepare(&modes, &scene, "model: {inertia: none}\n", 16))
			continue;
		against_chain(&modes, &scene, full ? 12 : 0);
		hawser_modes_clear(&modes);
		hawser_scene_clear(&scene);
	}
	return done_testing();
}
