/* bench/estimates-spans.c - the estimated errors of responses (estimates-accuracy.c) of spans with what
 * real spans have: masses, wind and ice, warmth, and ends that move.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "bench/estimates.h"

enum { LOWEST = 5, MASSES = 3 };

struct drawn {
	struct hawser_scene scene;
	struct hawser_statics st;
	char what[80];
};

static void draw_span(struct hawser_scene *scene, struct chance *chance)
{
	double sag = chance_log(chance, 5e-3, 0.2);

	*scene = (struct hawser_scene){.g = 9.81};
	scene->span.d = chance_log(chance, 10.0, 500.0);
	scene->span.h = chance_unit(chance) < 0.3 ? 0.0 : scene->span.d*chance_between(chance, -0.8, 0.8);
	scene->cable.rho = chance_log(chance, 0.2, 50.0);
	scene->tension.given = HAWSER_GIVEN_H;
	scene->tension.value = scene->cable.rho*scene->g*scene->span.d/(8.0*sag);
	scene->cable.EA = scene->tension.value/chance_log(chance, 1e-5, 3e-3);
	scene->model.condense = HAWSER_CONDENSE_STATIC;
	scene->model.inertia = HAWSER_INERTIA_AUTO;
}

/* Masses of together up to half that of the cable, apart from each other and from the ends. */
static void draw_masses(struct hawser_scene *scene, struct chance *chance)
{
	scene->attachments = chance_int(chance, 1, MASSES);
	for (int i = 0; i < scene->attachments; i++) {
		scene->attach[i].at = (i + chance_between(chance, 0.2, 0.8))/scene->attachments;
		scene->attach[i].mass = scene->cable.rho*scene->span.d/scene->attachments*
		                        chance_log(chance, 0.01, 0.5);
	}
}

static void draw_static_load(struct hawser_scene *scene, struct chance *chance)
{
	double weight = scene->cable.rho*scene->g;

	scene->static_load.present = 1;
	scene->static_load.per_length[2] = scene->attachments ? 0.0 : weight*chance_log(chance, 0.03, 2.0);
	scene->static_load.mass = scene->cable.rho*chance_log(chance, 0.01, 0.5);
	scene->tension.state = chance_unit(chance) < 0.5 ? HAWSER_STATE_LOADED : HAWSER_STATE_REFERENCE;
}

/* A load or a motion of the ends that moves the mode by about `part` of the span: f/(D w), and for a
 * motion across, which acts on the mode by its acceleration, f = W^2 A. */
static void draw_excitation(struct drawn *drawn, struct chance *chance, double omega)
{
	struct hawser_scene *scene = &drawn->scene;
	const struct hawser_statics *st = &drawn->st;
	double ratio = chance_log(chance, 3e-3, 0.03), part = chance_log(chance, 1e-4, 1e-2);
	double force = 2.0*ratio*omega*omega*part*st->H/st->span.d;

	scene->damping.kind = HAWSER_DAMPING_RATIO;
	scene->damping.ratio = ratio;
	if (chance_unit(chance) < 0.5) {
		for (int i = 0; i < 3; i++)
			scene->support[1].motion[i] = 2.0*ratio*part*st->span.d*chance_between(chance, -1.0, 1.0);
		scene->support[1].harmonic = 1;
		return;
	}
	scene->load.present = 1;
	scene->load.frame = HAWSER_FRAME_GLOBAL;
	scene->load.extent[1] = 1.0;
	for (int i = 0; i < 3; i++)
		scene->load.per_length[i] = force*chance_between(chance, 0.2, 1.0);
}

static int draw(struct drawn *drawn, double *omega, int *n, struct chance *chance)
{
	struct hawser_modes_options lowest = {.n = LOWEST};
	struct hawser_modes modes = {.n = 0};
	int kind = chance_int(chance, 1, 3), which = chance_int(chance, 0, LOWEST - 1), failed;

	draw_span(&drawn->scene, chance);
	if (kind & 1)
		draw_masses(&drawn->scene, chance);
	if (kind & 2)
		draw_static_load(&drawn->scene, chance);
	failed = hawser_statics_scene(&drawn->st, &drawn->scene, NULL) ||
	         hawser_modes_solve(&modes, &drawn->st, &lowest, NULL);
	if (!failed) {
		*omega = modes.mode[which].omega;
		*n = which + 1 + chance_int(chance, 1, 10);
		draw_excitation(drawn, chance, *omega);
		snprintf(drawn->what, sizeof drawn->what, ", %d masses%s%s", drawn->scene.attachments,
		         drawn->scene.static_load.present ? ", static load" : "",
		         drawn->scene.load.present ? "" : ", end B moves");
	}
	hawser_modes_clear(&modes);
	return failed;
}

int estimate_spans(struct tally *tally, struct chance *chance)
{
	struct drawn drawn;
	double omega, from, to;
	int n;

	if (draw(&drawn, &omega, &n, chance))
		return 1;
	from = omega*(1.0 - chance_log(chance, 5e-3, 0.2));
	to = omega*(1.0 + chance_log(chance, 5e-3, 0.2));
	drawn.scene.model.accuracy = chance_log(chance, 0.003, 0.03);
	if (drawn.scene.load.present && chance_unit(chance) < 0.5) {
		drawn.scene.model.modes = HAWSER_MODES_AUTO;
		return estimate_reached(tally, &drawn.st, &drawn.scene, from, to, drawn.what);
	}
	drawn.scene.model.modes = n;
	return estimate_kept(tally, &drawn.st, &drawn.scene, n, from, to, drawn.what);
}
