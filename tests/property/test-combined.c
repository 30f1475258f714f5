/* Scenes that combine attachments, static loads, dampers and moving ends, against a chain of rods
 * in space (tests/lumped-chain.h): static shape, natural frequencies, and a nonlinear motion from
 * rest.
 *
 * The chain is of second order in the length of its rods and in the time step; its results with n
 * and 2 n rods are extrapolated. For the conductors with moving ends the limit of the tension is 4e-3:
 * the models are 3.1e-3 and 3.5e-3 from chains of 64 and 128 rods, 2.1e-3 and 2.4e-3 from chains of
 * twice as many rods in four times as many steps; what remains is not explained.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/integrate.h>
#include <hawser/modes.h>
#include <hawser/scene.h>

#include "tests/lumped-chain.h"
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

/* Two periods, from a quarter of the first one, where cos(omega t) = 0. */
enum { POINTS = 3, A_QUARTER = 5, ROWS = 8*A_QUARTER, FREQUENCIES = 8 };

struct combined {
	const char *what, *scene;
	double omega;                 /* in units of the first frequency */
	int rods, modes;
	int steps;                    /* of the motion; 0: shape and frequencies only */
	int full;                     /* functions of the full-order model; 0: a condensed one */
	double shape, frequency, displacement, tension; /* limits: m over m, then relative */
};

#define SPRINGS "cable: {EA: 60 MN, rho: 8.2 kg/m}\nspan: {d: 240 m, h: 38 m}\n" \
	"tension: {T0: 120 kN, state: reference}\n" \
	"temperature: {change: -12 K, expansion: 1.2e-5}\n" \
	"attach: [{at: 31.25 %, mass: 300 kg, damper: [0, 60 N s/m, 100 N s/m]},\n" \
	"  {at: 62.5 %, spring: [1 kN/m, 2 kN/m, 1 kN/m]}]\n" \
	"damping: {rayleigh: {mass: 0.05, stiffness: 0}}\n" \
	"load: {frame: global, per_length: [0, 3 N/m, 2 N/m], static: {mass: 1.1}}\n" \
	"support: {A: {stiffness: [4 MN/m, 9 MN/m, 2 MN/m], mass: 700, motion: [10 mm, 50 mm, 30 mm]},\n" \
	"  B: {stiffness: [0.7 MN/m, 5 MN/m, 0.2 MN/m], motion: [30 mm, 0, 50 mm]}}\n"

#define TOWERS "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 400 m, h: 22 m}\n" \
	"tension: {H: 24 kN, state: reference}\n" \
	"load: {static: {per_length: [0, 0, 12 N/m], mass: 0.8 kg/m}, frame: global,\n" \
	"  per_length: [0, 0.3 N/m, 0.6 N/m]}\n" \
	"damping: {rayleigh: {mass: 0.1, stiffness: 0}}\n" \
	"support: {A: {stiffness: [300 kN/m, 2 MN/m, 90 kN/m], mass: 210},\n" \
	"  B: {stiffness: [60 kN/m, 1.1 MN/m, 25 kN/m]}}\n"

static const struct combined table[] = {
	{.what = "a span of a ropeway with four carriers",
	 .scene = "cable: {EA: 60 MN, rho: 8.2 kg/m}\nspan: {d: 240 m, h: 38 m}\ntension: {T0: 210 kN}\n"
	          "attach:\n  - {at: 12.5 %, mass: 820 kg}\n  - {at: 37.5 %, mass: 820 kg}\n"
	          "  - {at: 62.5 %, mass: 820 kg}\n  - {at: 87.5 %, mass: 820 kg}\n"
	          "damping: {rayleigh: {mass: 0.05, stiffness: 0}}\n"
	          "load: {frame: global, per_length: [0, 8 N/m, 6 N/m]}\n",
	 .omega = 0.93, .rods = 64, .steps = 400, .modes = 24,
	 .shape = 1e-8, .frequency = 1e-6, .displacement = 3e-4, .tension = 2e-3},
	{.what = "a stay whose anchorage moves",
	 .scene = "cable: {EA: 480 MN, rho: 52 kg/m}\nspan: {d: 110 m, h: 110 m}\ntension: {T0: 2.1 MN}\n"
	          "damping: {rayleigh: {mass: 0.03, stiffness: 0}}\n"
	          "support: {B: {motion: [4 mm, 6 mm, 3 mm]}}\n",
	 .omega = 0.93, .rods = 64, .steps = 400, .modes = 16,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 3e-4, .tension = 2e-3},
	{.what = "a clamped stay",
	 .scene = "cable: {EA: 480 MN, rho: 52 kg/m, EI: 12 MN m2}\nspan: {d: 110 m, h: 110 m}\n"
	          "tension: {T0: 2.1 MN}\nends: {A: clamped, B: clamped}\n",
	 .omega = 0.93, .rods = 256, .modes = 8, .shape = 2e-7, .frequency = 3e-6},
	{.what = "a clamped stay with a damper near the deck, whose anchorage moves",
	 .scene = "cable: {EA: 480 MN, rho: 52 kg/m, EI: 12 MN m2}\nspan: {d: 110 m, h: 110 m}\n"
	          "tension: {T0: 2.1 MN}\nends: {A: clamped, B: clamped}\n"
	          "attach: [{at: 6.25 %, damper: [0, 4 kN s/m, 7 kN s/m]}]\n"
	          "damping: {rayleigh: {mass: 0.03, stiffness: 0}}\n"
	          "support: {A: {motion: [4 mm, 6 mm, 3 mm]}}\n",
	 .omega = 0.93, .rods = 128, .steps = 320, .modes = 24, /* rods of half a layer's width */
	 .shape = 2e-7, .frequency = 2e-5, .displacement = 6e-4, .tension = 2e-3},
	{.what = "a clamped stay under a load, whose anchorage moves, by the full-order model",
	 .scene = "cable: {EA: 480 MN, rho: 52 kg/m, EI: 12 MN m2}\nspan: {d: 110 m, h: 110 m}\n"
	          "tension: {T0: 2.1 MN}\nends: {A: clamped, B: clamped}\n"
	          "damping: {rayleigh: {mass: 0.03, stiffness: 0}}\n"
	          "load: {frame: global, per_length: [0, 16 N/m, 12 N/m]}\n"
	          "support: {A: {motion: [4 mm, 6 mm, 3 mm]}}\n",
	 .omega = 0.93, .rods = 128, .steps = 400, .modes = 24, .full = 27,
	 .shape = 2e-7, .frequency = 2e-5, .displacement = 3e-4, .tension = 2e-3},
	{.what = "a conductor with ice and wind",
	 .scene = "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 400 m, h: 22 m}\n"
	          "tension: {H: 24 kN, state: reference}\n"
	          "load: {static: {per_length: [0, 0, 12 N/m], mass: 0.8 kg/m}, frame: global,\n"
	          "  per_length: [0, 1 N/m, 2 N/m]}\n"
	          "damping: {rayleigh: {mass: 0.1, stiffness: 0}}\n",
	 .omega = 0.93, .rods = 64, .steps = 400, .modes = 24,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 3e-4, .tension = 2e-3},
	{.what = "a conductor with ice, wind and two spacers",
	 .scene = "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 400 m, h: 22 m}\n"
	          "tension: {H: 24 kN, state: reference}\n"
	          "attach: [{at: 31.25 %, mass: 48}, {at: 68.75 %, mass: 63}]\n"
	          "load: {static: {per_length: [0, 0, 12 N/m], mass: 0.8 kg/m}, frame: global,\n"
	          "  per_length: [0, 0.5 N/m, 1 N/m]}\n"
	          "damping: {rayleigh: {mass: 0.1, stiffness: 0}}\n",
	 .omega = 0.93, .rods = 48, .steps = 320, .modes = 24,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 1e-4, .tension = 3e-3},
	{.what = "the same conductor at full order",
	 .scene = "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 400 m, h: 22 m}\n"
	          "tension: {H: 24 kN, state: reference}\n"
	          "attach: [{at: 31.25 %, mass: 48}, {at: 68.75 %, mass: 63}]\n"
	          "load: {static: {per_length: [0, 0, 12 N/m], mass: 0.8 kg/m}, frame: global,\n"
	          "  per_length: [0, 1 N/m, 2 N/m]}\n"
	          "damping: {rayleigh: {mass: 0.1, stiffness: 0}}\n",
	 .omega = 0.93, .rods = 64, .steps = 400, .modes = 24, .full = 24,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 1e-4, .tension = 2e-3},
	{.what = "a conductor with a mass and forces from the side",
	 .scene = "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 400 m, h: 22 m}\n"
	          "tension: {T0: 24 kN}\n"
	          "attach: [{at: 31.25 %, force: [0, -500 N, 200 N]}, {at: 62.5 %, mass: 60}]\n"
	          "load: {frame: global, per_length: [0, 0.2 N/m, 0.4 N/m]}\n"
	          "damping: {rayleigh: {mass: 0.1, stiffness: 0}}\n",
	 .omega = 0.93, .rods = 48, .steps = 320, .modes = 24,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 1e-4, .tension = 3e-3},
	{.what = "a conductor with a force downwards, in the plane",
	 .scene = "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 400 m, h: 22 m}\n"
	          "tension: {H: 24 kN}\nattach: [{at: 62.5 %, force: [0, -700 N, 0], mass: 30}]\n",
	 .rods = 48, .modes = 12, .shape = 2e-7, .frequency = 1e-6},
	{.what = "a conductor in the wind with a mass and forces along all axes",
	 .scene = "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 400 m, h: -40 m}\n"
	          "tension: {T1: 26 kN, state: loaded}\n"
	          "attach: [{at: 31.25 %, mass: 48, force: [300 N, 900 N, -250 N]},\n"
	          "  {at: 68.75 %, force: [-700 N, -400 N, 350 N]}]\n"
	          "load: {static: {per_length: [0.5 N/m, 0, 9 N/m], mass: 0.4 kg/m}}\n",
	 .rods = 64, .modes = 12, .shape = 2e-7, .frequency = 1e-6},
	{.what = "the conductor with forces from the side at full order",
	 .scene = "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 400 m, h: 22 m}\n"
	          "tension: {T0: 24 kN}\n"
	          "attach: [{at: 31.25 %, force: [0, -500 N, 200 N]}, {at: 62.5 %, mass: 60}]\n"
	          "load: {frame: global, per_length: [0, 1 N/m, 2 N/m]}\n"
	          "damping: {rayleigh: {mass: 0.1, stiffness: 0}}\n",
	 .omega = 0.93, .rods = 64, .steps = 400, .modes = 24, .full = 24,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 1e-4, .tension = 2e-3},
	{.what = "a conductor in the wind with a mass and forces between towers that give way",
	 .scene = "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 400 m, h: -40 m}\n"
	          "tension: {T1: 26 kN, state: reference}\n"
	          "attach: [{at: 31.25 %, mass: 48, force: [300 N, 200 N, -250 N]},\n"
	          "  {at: 68.75 %, force: [-700 N, -400 N, 350 N]}]\n"
	          "load: {static: {per_length: [0.5 N/m, 0, 9 N/m], mass: 0.4 kg/m}}\n"
	          "support: {A: {stiffness: [300 kN/m, 2 MN/m, 90 kN/m], mass: 210},\n"
	          "  B: {stiffness: [60 kN/m, 1.1 MN/m, 25 kN/m]}}\n",
	 .rods = 64, .modes = 12, .shape = 2e-7, .frequency = 1e-6},
	{.what = "a conductor with forces between towers at full order",
	 .scene = "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 400 m, h: 22 m}\n"
	          "tension: {T0: 24 kN, state: reference}\n"
	          "attach: [{at: 31.25 %, force: [0, -500 N, 200 N]}, {at: 62.5 %, mass: 60}]\n"
	          "load: {static: {mass: 0.3}, frame: global, per_length: [0, 1 N/m, 2 N/m]}\n"
	          "damping: {rayleigh: {mass: 0.1, stiffness: 0}}\n"
	          "support: {A: {stiffness: [300 kN/m, 2 MN/m, 90 kN/m], mass: 210},\n"
	          "  B: {stiffness: [60 kN/m, 1.1 MN/m, 25 kN/m]}}\n",
	 .omega = 0.93, .rods = 48, .steps = 400, .modes = 16, .full = 20,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 3e-4, .tension = 3e-3},
	{.what = "a stay with a spring and a damper, whose anchorage moves",
	 .scene = "cable: {EA: 480 MN, rho: 52 kg/m}\nspan: {d: 110 m, h: 60 m}\ntension: {T0: 2.1 MN}\n"
	          "attach: [{at: 12.5 %, damper: [0, 60 N s/m, 100 N s/m]},\n"
	          "  {at: 62.5 %, mass: 200, spring: [10 kN/m, 60 kN/m, 40 kN/m]}]\n"
	          "damping: {rayleigh: {mass: 0.03, stiffness: 0}}\n"
	          "support: {A: {motion: [4 mm, 6 mm, 3 mm]}, B: {motion: [2 mm, 0, 5 mm]}}\n",
	 .omega = 0.93, .rods = 64, .steps = 400, .modes = 16, .full = 20,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 3e-4, .tension = 2e-3},
	{.what = "an iced span with a mass and a damper between springs whose foundations move",
	 .scene = SPRINGS, .omega = 0.93, .rods = 64, .steps = 400, .modes = 34,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 3e-4, .tension = 2e-3},
	{.what = "the same by the full-order model",
	 .scene = SPRINGS, .omega = 0.93, .rods = 64, .steps = 400, .modes = 16, .full = 20,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 3e-4, .tension = 2e-3},
	/* the tension needs longitudinal modes: 5e-3 with 24 of them, 2e-4 at full order */
	{.what = "a conductor with ice and wind between towers that give way",
	 .scene = TOWERS, .omega = 0.93, .rods = 64, .steps = 400, .modes = 44,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 3e-4, .tension = 2e-3},
	{.what = "the same at full order",
	 .scene = TOWERS, .omega = 0.93, .rods = 64, .steps = 400, .modes = 24, .full = 24,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 3e-4, .tension = 2e-3},
	{.what = "a conductor with ice, wind and two spacers between towers",
	 .scene = TOWERS "attach: [{at: 31.25 %, mass: 48}, {at: 68.75 %, mass: 63}]\n",
	 .omega = 0.93, .rods = 64, .steps = 400, .modes = 24, .full = 24,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 3e-4, .tension = 2e-3},
	{.what = "a stay with a mass and a damper, both of whose ends move",
	 .scene = "cable: {EA: 480 MN, rho: 52 kg/m}\nspan: {d: 110 m, h: 60 m}\ntension: {T0: 2.1 MN}\n"
	          "attach: [{at: 12.5 %, damper: [0, 60 N s/m, 100 N s/m]}, {at: 62.5 %, mass: 200}]\n"
	          "damping: {rayleigh: {mass: 0.03, stiffness: 0}}\n"
	          "support: {A: {motion: [4 mm, 6 mm, 3 mm]}, B: {motion: [2 mm, 0, 5 mm]}}\n",
	 .omega = 0.93, .rods = 64, .steps = 400, .modes = 16,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 4e-4, .tension = 2e-3},
	{.what = "a conductor with ice and wind, both of whose ends move",
	 .scene = "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 400 m, h: 22 m}\n"
	          "tension: {H: 24 kN, state: reference}\n"
	          "load: {static: {per_length: [0, 0, 12 N/m], mass: 0.8 kg/m}}\n"
	          "damping: {rayleigh: {mass: 0.1, stiffness: 0}}\n"
	          "support: {A: {motion: [5 cm, 3 cm, 4 cm]}, B: {motion: [0, 13 cm, 6 cm]}}\n",
	 .omega = 0.93, .rods = 64, .steps = 400, .modes = 24,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 4e-4, .tension = 4e-3},
	{.what = "a conductor with two masses and ice, both of whose ends move",
	 .scene = "cable: {EA: 21.7 MN, rho: 1.57 kg/m}\nspan: {d: 400 m, h: 22 m}\n"
	          "tension: {H: 24 kN, state: reference}\n"
	          "attach: [{at: 12.5 %, mass: 40}, {at: 62.5 %, mass: 60}]\n"
	          "load: {static: {mass: 0.8 kg/m}}\n"
	          "damping: {rayleigh: {mass: 0.1, stiffness: 0}}\n"
	          "support: {A: {motion: [5 cm, 3 cm, 4 cm]}, B: {motion: [0, 13 cm, 6 cm]}}\n",
	 .omega = 0.93, .rods = 64, .steps = 400, .modes = 24,
	 .shape = 2e-7, .frequency = 1e-6, .displacement = 4e-4, .tension = 4e-3},
};

/* The static load and the ends of the scene, and its attachments at the joints. */
static void describe(struct lumped *c, const struct hawser_scene *scene,
                     const struct hawser_statics *st, int n)
{
	double mass = scene->static_load.present ? scene->static_load.mass : 0.0;

	memset(c, 0, sizeof *c);
	c->n = n;
	c->L0 = st->length0;
	c->EA = scene->cable.EA;
	c->rho = scene->cable.rho + mass;
	c->gravity = scene->g;
	c->end[0] = scene->span.d;
	c->end[1] = scene->span.h;
	for (int i = 0; i < 3; i++) {
		c->weight[i] = (scene->static_load.present ? scene->static_load.per_length[i] : 0.0) -
		               (i == 1 ? c->rho*scene->g : 0.0);
		c->load[i] = scene->load.present ? scene->load.per_length[i] : 0.0;
		for (int e = 0; e < 2; e++)
			c->motion[e][i] = scene->support[e].motion[i];
	}
	for (int e = 0; e < 2; e++) {
		c->phase[e] = scene->support[e].phase;
		memcpy(c->stiffness[e], scene->support[e].stiffness, sizeof c->stiffness[e]);
		c->held_mass[e] = scene->support[e].mass;
	}
	c->alpha = scene->damping.mass;
	c->EI = scene->cable.EI;
	c->clamped = scene->ends[0] > 0.0;
	for (int k = 0; k < scene->attachments; k++) {
		const struct hawser_attachment *a = &scene->attach[k];
		int joint = (int)lround((a->by_length ? a->at/st->length0 : a->at)*n);

		c->attached[joint] += a->mass;
		for (int i = 0; i < 3; i++) {
			c->dead[joint][i] += a->force[i];
			c->damper[joint][i] += a->damper[i];
			c->spring[joint][i] += a->spring[i];
		}
	}
}

static void place(double x[3], const struct hawser_statics *st, double part)
{
	struct hawser_profile_point at = hawser_statics_at(st, part*st->length0);
	const double in[3] = {at.x, at.y, at.z};

	hawser_statics_to_global(st, x, in);
	for (int i = 0; i < 3; i++)
		x[i] += st->moved[0][i];
}

struct seen {
	const struct lumped *c;
	const double *rest;
	int rows;
	double value[ROWS][4*POINTS]; /* displacement and tension at a quarter, the middle,
		three quarters */
};

static void see(const double *x, void *data)
{
	struct seen *seen = data;
	int held = seen->c->held, n = seen->c->n - 2*held;

	for (int p = 0; p < POINTS; p++) {
		int joint = held + (p + 1)*n/4;

		for (int i = 0; i < 3; i++)
			seen->value[seen->rows][4*p + i] = x[3*joint + i] - seen->rest[3*joint + i];
		seen->value[seen->rows][4*p + 3] = 0.5*(lumped_tension(seen->c, x, joint - 1) +
		                                        lumped_tension(seen->c, x, joint));
	}
	seen->rows++;
}

static double rate(const struct hawser_modes *modes, int k)
{
	return modes->mode[k].omega/modes->time_unit;
}

static double extrapolated(double coarse, double fine)
{
	return (4.0*fine - coarse)/3.0;
}

/* The chain between springs under its static load, from the reference state, where its ends are at
 * their places: x, whose foundations stay there. */
static int give_way(struct lumped *c, double *x, const struct hawser_scene *scene,
                    const struct hawser_statics *st, int n)
{
	struct hawser_report report = {.message = ""};
	struct hawser_statics before;
	double loaded[3], adhering = c->rho - scene->cable.rho;

	if (hawser_statics_reference(&before, scene, &report))
		return 0;
	memcpy(loaded, c->weight, sizeof loaded);
	c->L0 = before.length0;
	c->rho = scene->cable.rho;
	for (int i = 0; i < 3; i++)
		c->weight[i] = i == 1 ? -c->rho*scene->g : 0.0;
	for (int k = 1; k < n; k++)
		place(x + 3*k, &before, (double)k/n);
	if (!lumped_straighten(c, x))
		return 0;
	lumped_hold(c, x);
	c->L0 = st->length0;
	c->rho += adhering;
	memcpy(c->weight, loaded, sizeof loaded);
	for (int k = 0; k <= n; k++)
		place(x + 3*k + 3, st, (double)k/n);
	return lumped_statics(x, c);
}

/* One chain: its shape against the profile (m), frequencies (rad/s) and motion. */
static int chain(double *shape, double *omega, struct seen *seen, const struct combined *row,
                 const struct hawser_scene *scene, const struct hawser_statics *st, double Omega,
                 int fine)
{
	static struct lumped c;
	static double x[3*LUMPED_MOST + 3], v[3*LUMPED_MOST + 3], rest[3*LUMPED_MOST + 3];
	int n = row->rods*fine;
	double quarter, *at[3] = {shape, shape + 3, shape + 6};

	describe(&c, scene, st, n);
	for (int k = 0; k <= n; k++)
		place(x + 3*k, st, (double)k/n);
	memcpy(x + 3*n, c.end, sizeof c.end);
	memset(x, 0, 3*sizeof *x);
	if (!(st->elastic ? give_way(&c, x, scene, st, n) : lumped_straighten(&c, x)))
		return 0;
	for (int p = 0; p < POINTS; p++)
		memcpy(at[p], x + 3*(c.held + (p + 1)*n/4), 3*sizeof *x);
	memcpy(rest, x, sizeof rest);
	c.relaxed = rest;
	if (!lumped_frequencies(omega, FREQUENCIES, &c, x))
		return 0;
	if (!row->steps)
		return 1;
	c.omega = Omega;
	quarter = 0.5*M_PI/c.omega;
	memset(v, 0, sizeof v);
	if (!lumped_follow(v, &c, x, quarter))
		return 0;
	seen->c = &c;
	seen->rest = rest;
	seen->rows = 0;
	return lumped_run(&c, x, v, quarter, 9.0*quarter, row->steps*fine,
	                  row->steps*fine/ROWS, see, seen);
}

/* The same of the model: rows at the same times. */
static int model(struct seen *seen, const struct combined *row,
                 const struct hawser_scene *scene, const struct hawser_modes *modes, double Omega)
{
	struct hawser_report report = {.message = ""};
	struct hawser_rom rom;
	struct hawser_trajectory run = {.n = 0};
	double quarter = 0.5*M_PI/Omega;
	struct hawser_integrate_options options = {.rtol = 1e-9};
	int done;

	if (!ok(!(row->full ? hawser_rom_build_full(&rom, &modes->statics, scene, row->full, &report)
	          : hawser_rom_build(&rom, modes, scene, &report)), "%s: model %s", row->what,
	        report.message))
		return 0;
	options.omega = Omega*rom.time;
	options.begin = quarter/rom.time;
	options.until = 9.0*quarter/rom.time;
	options.every = options.begin/A_QUARTER;
	done = ok(!hawser_integrate(&run, &rom, &options, &report) && run.rows == ROWS + 1,
	          "%s: motion %s",
	          row->what, report.message);
	for (int i = 0; done && i < ROWS; i++) {
		struct hawser_rom_moment moment = {options.omega*run.time[i + 1], options.omega, 0.0};

		for (int p = 0; p < POINTS; p++) {
			hawser_rom_displacement_at(&rom, seen->value[i] + 4*p, p, run.state + 2*(i + 1)*run.n,
			                           &moment);
			for (int x = 0; x < 3; x++)
				seen->value[i][4*p + x] *= rom.length;
			seen->value[i][4*p + 3] =
				hawser_rom_tension_at(&rom, p, run.state + 2*(i + 1)*run.n, &moment);
		}
	}
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
	return done;
}

/* Largest differences of the motion: of the displacement over the largest one, of the tension over
 * the range of its changes. */
static void compare_motion(const struct combined *row, const struct seen *got,
                           const struct seen *coarse,
                           const struct seen *fine)
{
	double off[2] = {0.0}, size[2] = {0.0}, doubt[2] = {0.0};

	for (int i = 0; i < ROWS; i++)
		for (int k = 0; k < 4*POINTS; k++) {
			double want = extrapolated(coarse->value[i][k], fine->value[i][k]);
			double from = k%4 == 3 ? extrapolated(coarse->value[0][k], fine->value[0][k]) : 0.0;

			off[k%4 == 3] = fmax(off[k%4 == 3], fabs(got->value[i][k] - want));
			size[k%4 == 3] = fmax(size[k%4 == 3], fabs(want - from));
			doubt[k%4 == 3] = fmax(doubt[k%4 == 3], fabs(want - fine->value[i][k]));
		}
	ok(off[0] < row->displacement*size[0],
	   "%s: displacement to %.1e of %.3g m (extrapolated by %.1e)",
	   row->what, off[0]/size[0], size[0], doubt[0]/size[0]);
	ok(off[1] < row->tension*size[1],
	   "%s: tension to %.1e of its change of %.4g N (extrapolated by %.1e)",
	   row->what, off[1]/size[1], size[1], doubt[1]/size[1]);
}

static void compare_shape(const struct combined *row, const struct hawser_statics *st,
                          const struct hawser_modes *modes, double shape[2][9],
	double omega[2][FREQUENCIES])
{
	double off = 0.0, most = 0.0;

	for (int p = 0; p < POINTS; p++) {
		double at[3];

		place(at, st, 0.25*(p + 1));
		for (int i = 0; i < 3; i++)
			off = fmax(off, fabs(extrapolated(shape[0][3*p + i], shape[1][3*p + i]) - at[i]));
	}
	for (int k = 0; k < FREQUENCIES; k++)
		most = fmax(most, fabs(rate(modes, k)/extrapolated(omega[0][k], omega[1][k]) - 1.0));
	ok(off < row->shape, "%s: shape to %.1e m", row->what, off);
	ok(most < row->frequency, "%s: %d frequencies to %.1e", row->what, FREQUENCIES, most);
}

static int scene_of(struct hawser_scene *scene, const struct combined *row)
{
	char text[2000];
	struct hawser_report report = {.message = ""};

	snprintf(text, sizeof text, "%smodel: {modes: %d, condense: static}\n", row->scene, row->modes);
	return ok(!read_text(scene, text, NULL, &report), "%s: scene %s", row->what, report.message);
}

static void check(const struct combined *row)
{
	static struct seen got, want[2];
	struct hawser_scene scene;
	struct hawser_statics st;
	struct hawser_modes modes = {.n = 0};
	struct hawser_modes_options options = {.n = row->modes};
	struct hawser_report report = {.message = ""};
	double shape[2][9], omega[2][FREQUENCIES];
	int done;

	if (!scene_of(&scene, row))
		return;
	done = ok(!hawser_statics_scene(&st, &scene, &report) &&
	          !hawser_modes_solve(&modes, &st, &options, &report), "%s: modes %s", row->what,
	          report.message);
	if (done) {
		double Omega = row->omega*rate(&modes, 0);

		done = ok(chain(shape[0], omega[0], &want[0], row, &scene, &st, Omega, 1) &&
		          chain(shape[1], omega[1], &want[1], row, &scene, &st, Omega, 2), "%s: chains",
			row->what);
		if (done)
			compare_shape(row, &st, &modes, shape, omega);
		if (done && row->steps && model(&got, row, &scene, &modes, Omega))
			compare_motion(row, &got, &want[0], &want[1]);
	}
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

CASE(property_combined)
{
	for (size_t i = 0; i < sizeof table/sizeof *table; i++)
		if (!table[i].full || getenv("HAWSER_LONG"))
			check(&table[i]);
	return done_testing();
}
