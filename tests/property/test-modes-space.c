/* Modes of cables with point masses in a wind, which hang in space: a plane span by the way in space
 * against its two planes, a chain of masses and rods (tests/lumped-chain.h), limits, mirror images,
 * the modes of a basis, and refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/modes.h>
#include <hawser/scene.h>

#include "tests/lumped-chain.h"
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

enum { MODES = 10, RODS = 48 };

static int solve(struct hawser_modes *modes, const struct hawser_statics *st, int n)
{
	struct hawser_modes_options options = {.n = n};
	struct hawser_report report = {.message = ""};

	return ok(!hawser_modes_solve(modes, st, &options, &report), "modes %s", report.message);
}

static int of_scene(struct hawser_modes *modes, const struct hawser_scene *scene)
{
	struct hawser_report report = {.message = ""};
	struct hawser_statics st;

	*modes = (struct hawser_modes){.n = 0};
	return ok(!hawser_statics_scene(&st, scene, &report), "statics %s", report.message) &&
	       solve(modes, &st, MODES);
}

static double rate(const struct hawser_modes *modes, int k)
{
	return modes->mode[k].omega/modes->time_unit;
}

/* Largest relative difference of frequencies. */
static double off(const struct hawser_modes *a, const struct hawser_modes *b)
{
	double most = 0.0;

	for (int k = 0; k < a->n && k < b->n; k++)
		most = fmax(most, fabs(rate(a, k)/rate(b, k) - 1.0));
	return most;
}

/* --- one span, two ways --- */

static void one_plane(const char *what, const struct hawser_span *span, double length0,
                      const struct hawser_attachment *attach, int count)
{
	struct hawser_report report = {.message = ""};
	struct hawser_statics st[2];
	struct hawser_modes modes[2] = {{.n = 0}};
	double gravity[3] = {0.0, -span->g, 0.0}, worst = 0.0;
	int done = 1;

	for (int way = 0; way < 2 && done; way++) {
		done = ok(!hawser_statics_weighted(&st[way], span, HAWSER_GIVEN_LENGTH0, length0,
		                                   HAWSER_BRANCH_TAUT, attach, count, gravity, &report) &&
		          st[way].space == way, "%s: statics %s", what, report.message) &&
		       solve(&modes[way], &st[way], 2*MODES);
		gravity[2] = 1e-300; /* the way in space, with the same forces */
	}
	if (done) {
		ok(off(&modes[0], &modes[1]) < 1e-12, "%s: frequencies to %.1e of those of both planes", what,
		   off(&modes[0], &modes[1]));
		for (int k = 0; k < 2*MODES; k++) {
			const struct hawser_mode *a = &modes[0].mode[k], *b = &modes[1].mode[k];

			worst = fmax(worst, fabs(a->axial_share - b->axial_share) +
			                    fabs(a->out_of_plane_share - b->out_of_plane_share));
			for (int c = 0; c < 3; c++)
				worst = fmax(worst, fabs(a->effective_mass[c] - b->effective_mass[c]));
			ok(a->plane == b->plane && a->number == b->number && a->symmetry == b->symmetry,
			   "%s: labels of mode %d", what, k + 1);
		}
		ok(worst < 1e-9, "%s: shares and effective masses to %.1e", what, worst);
	}
	hawser_modes_clear(&modes[0]);
	hawser_modes_clear(&modes[1]);
}

static void planes(void)
{
	const struct hawser_span taut = {2.17e7, 1.571, 9.81, 387.3, 31.7};
	const struct hawser_span steep = {4.31e6, 3.2, 9.81, 80.3, -140.1};
	struct hawser_attachment attach[3] = {{.at = 0.23, .mass = 210.0}, {.at = 0.57},
	                                      {.at = 0.83, .mass = 41.7}};

	one_plane("taut", &taut, 391.2, attach, 3);
	one_plane("slack", &taut, 700.0, attach, 3);
	one_plane("steep", &steep, 170.0, attach, 3);
	attach[1].spring[0] = 3.1e3;
	attach[1].spring[1] = 700.0;
	attach[1].spring[2] = 1.3e3;
	one_plane("taut, with springs", &taut, 391.2, attach, 3);
}

/* --- a chain --- */

static int chain(double *omega, const struct hawser_scene *scene, const struct hawser_statics *st,
                 int n)
{
	static struct lumped c;
	static double x[3*LUMPED_MOST + 3];

	memset(&c, 0, sizeof c);
	c.n = n;
	c.L0 = st->length0;
	c.EA = scene->cable.EA;
	c.rho = scene->cable.rho + scene->static_load.mass;
	c.gravity = scene->g;
	c.end[0] = scene->span.d;
	c.end[1] = scene->span.h;
	for (int i = 0; i < 3; i++)
		c.weight[i] = scene->static_load.per_length[i] - (i == 1 ? c.rho*scene->g : 0.0);
	for (int k = 0; k < scene->attachments; k++)
		c.attached[lround(scene->attach[k].at*n)] += scene->attach[k].mass;
	for (int k = 0; k <= n; k++) {
		struct hawser_profile_point at = hawser_statics_at(st, st->length0*k/n);
		const double in[3] = {at.x, at.y, at.z};

		hawser_statics_to_global(st, x + 3*k, in);
	}
	memcpy(x + 3*n, c.end, sizeof c.end);
	memset(x, 0, 3*sizeof *x);
	return lumped_straighten(&c, x) && lumped_frequencies(omega, MODES, &c, x);
}

static void against_chain(const char *what, const char *text, double limit)
{
	struct hawser_scene scene;
	struct hawser_modes modes;
	double omega[3][MODES], most = 0.0, low = INFINITY, high = 0.0;

	if (!is_read(&scene, text))
		return;
	if (of_scene(&modes, &scene) &&
	    ok(chain(omega[0], &scene, &modes.statics, RODS) &&
	       chain(omega[1], &scene, &modes.statics, 2*RODS) &&
	       chain(omega[2], &scene, &modes.statics, 4*RODS), "%s: chains", what)) {
		for (int k = 0; k < MODES; k++) {
			double error[2] = {omega[1][k]/rate(&modes, k) - 1.0, omega[2][k]/rate(&modes, k) - 1.0};

			low = fmin(low, error[0]/error[1]);
			high = fmax(high, error[0]/error[1]);
			most = fmax(most, fabs((64.0*omega[2][k] - 20.0*omega[1][k] + omega[0][k])/45.0/
			                       rate(&modes, k) - 1.0));
		}
		ok(low > 3.6 && high < 4.4, "%s: the chain is of second order, errors decrease %.2f to %.2f "
		   "times", what, low, high);
		ok(most < limit, "%s: %d frequencies to %.1e of the chain, extrapolated twice", what, MODES,
		   most);
	}
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

static void chains(void)
{
	against_chain("conductor with spacers",
	              "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 400 m, h: 22 m}\n"
	              "tension: {H: 24 kN}\n"
	              "attach: [{at: 31.25 %, mass: 48}, {at: 68.75 %, mass: 63}]\n"
	              "load: {static: {per_length: [0, 0, 12 N/m], mass: 0.8 kg/m}}\n", 1e-8);
	against_chain("steep and deep, heavy masses, wind in all directions",
	              "cable: {EA: 3.1 MN, rho: 2.3 kg/m}\nspan: {d: 90 m, h: 120 m}\n"
	              "tension: {length0: 190 m}\n"
	              "attach: [{at: 25 %, mass: 210}, {at: 43.75 %, mass: 35}, {at: 81.25 %, mass: 480}]\n"
	              "load: {static: {per_length: [7, 11, -31]}}\n", 1e-8);
	against_chain("wind stronger than weight, masses hanging",
	              "cable: {EA: 12 MN, rho: 0.4 kg/m}\nspan: {d: 150 m, h: -17 m}\n"
	              "tension: {length0: 156 m}\nattach: [{at: 37.5 %, mass: 90}]\n"
	              "load: {static: {per_length: [0, 6, 55]}}\n", 1e-8);
}

/* Supports that are as stiff along every axis: a wind turns the cable between them, and changes its
 * modes as a larger gravity does. */
static void on_springs(void)
{
	static const char text[] = "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 200 m, h: 0 m}\n"
	                           "tension: {T0: 23 kN, state: loaded}\n"
	                           "load: {static: {per_length: [0, 0, 12]}}\n"
	                           "support: {A: {stiffness: [90 kN/m, 90 kN/m, 90 kN/m], mass: 70},\n"
	                           "  B: {stiffness: [40 kN/m, 40 kN/m, 40 kN/m], mass: 110}}\n";
	struct hawser_scene scene, heavy;
	struct hawser_modes modes, plane;

	if (!is_read(&scene, text))
		return;
	heavy = scene;
	heavy.static_load.present = 0;
	heavy.g = hypot(scene.g, 12.0/scene.cable.rho);
	if (of_scene(&modes, &scene) && of_scene(&plane, &heavy)) {
		ok(modes.statics.space && !plane.statics.space, "in space, and in two planes");
		ok(off(&modes, &plane) < 1e-12, "springs: frequencies to %.1e", off(&modes, &plane));
		hawser_modes_clear(&plane);
	}
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

/* --- limits and images --- */

static void images(void)
{
	static const char text[] = "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 200 m, h: 62 m}\n"
	                           "tension: {length0: 216 m}\n"
	                           "attach: [{at: 0.3, mass: 48}, {at: 0.7, mass: 13}]\n"
	                           "load: {static: {per_length: [4, 3, 12]}}\n";
	struct hawser_scene scene, other;
	struct hawser_modes modes, image;

	if (!is_read(&scene, text))
		return;
	of_scene(&modes, &scene);
	other = scene;
	other.static_load.per_length[2] *= -1.0;
	of_scene(&image, &other);
	ok(off(&modes, &image) < 1e-13, "mirrored: frequencies to %.1e", off(&modes, &image));
	hawser_modes_clear(&image);
	other = scene;
	other.span.h *= -1.0;
	other.static_load.per_length[0] *= -1.0;
	other.attach[0].mass = scene.attach[1].mass;
	other.attach[1].mass = scene.attach[0].mass;
	of_scene(&image, &other);
	ok(off(&modes, &image) < 1e-12, "ends exchanged: frequencies to %.1e", off(&modes, &image));
	hawser_modes_clear(&image);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

/* Towards the swung plane without masses with the mass, and towards the plane without wind with its
 * square. */
static void limits(void)
{
	static const char text[] = "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 200 m, h: 62 m}\n"
	                           "tension: {length0: 216 m}\nattach: [{at: 0.3, mass: 48}]\n"
	                           "load: {static: {per_length: [4, 3, 12]}}\n";
	struct hawser_scene scene, to;
	struct hawser_modes modes, limit;
	double before[2] = {0.0};

	if (!is_read(&scene, text))
		return;
	for (int k = 0; k < 3; k++) {
		double small = pow(10.0, -k), here;

		to = scene;
		to.attach[0].mass = 0.0;
		of_scene(&limit, &to);
		to.attach[0].mass = 0.03*small;
		of_scene(&modes, &to);
		here = off(&modes, &limit);
		ok(k == 0 || fabs(before[0]/here/10.0 - 1.0) < 0.05, "mass %g kg: frequencies to %.1e",
		   0.03*small, here);
		before[0] = here;
		hawser_modes_clear(&modes);
		hawser_modes_clear(&limit);
		to = scene;
		to.static_load.per_length[0] = to.static_load.per_length[2] = 0.0;
		of_scene(&limit, &to);
		ok(!limit.statics.space, "a load along y leaves the plane as it is");
		to.static_load.per_length[2] = 0.3*small;
		of_scene(&modes, &to);
		here = off(&modes, &limit);
		ok(k == 0 || fabs(before[1]/here/100.0 - 1.0) < 0.05, "wind %g N/m: frequencies to %.1e",
		   0.3*small, here);
		before[1] = here;
		hawser_modes_clear(&modes);
		hawser_modes_clear(&limit);
	}
	hawser_scene_clear(&scene);
}

/* The modes of a basis: the same lowest ones, orthonormal with the masses, complete. */
static void basis(void)
{
	static const char text[] = "cable: {EA: 2.17 MN, rho: 1.57 kg/m}\nspan: {d: 200 m, h: 62 m}\n"
	                           "tension: {length0: 216 m}\n"
	                           "attach: [{at: 0.3, mass: 48}, {at: 0.7, mass: 13}]\n"
	                           "load: {static: {per_length: [4, 3, 12]}}\n";
	struct hawser_report report = {.message = ""};
	struct hawser_scene scene;
	struct hawser_modes modes, all;
	double sum[3] = {0.0};

	if (!is_read(&scene, text) || !of_scene(&modes, &scene))
		return;
	if (ok(!hawser_modes_basis(&all, &modes.statics, 40, 40, &report), "basis %s", report.message)) {
		ok(off(&all, &modes) < 1e-10, "%d modes of a basis: frequencies to %.1e", all.n,
		   off(&all, &modes));
		for (int k = 0; k < all.n; k++)
			for (int c = 0; c < 3; c++)
				sum[c] += all.mode[k].effective_mass[c];
		for (int c = 0; c < 3; c++)
			ok(sum[c] > 0.98 && sum[c] < 1.0 + 1e-12, "effective masses along %c add up to %.4f",
			   "xyz"[c], sum[c]);
		hawser_modes_clear(&all);
	}
	modes.statics.bending.EI = 1.0;
	ok(hawser_modes_basis(&all, &modes.statics, 9, 9, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "hangs in space"), "%s", report.message);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

CASE(property_modes_space)
{
	planes();
	chains();
	on_springs();
	images();
	limits();
	basis();
	return done_testing();
}
