/* bench/estimates-spans.c - the estimated errors of responses (estimates-accuracy.c) of spans with what
 * real spans have: masses, springs, wind and ice, and ends that move.
 *
 * Commands of one term each have short ranges about one of the lowest modes, few modes and motions so
 * small that a full-order response takes seconds; `spans` has wide ranges and models with modes: auto
 * too. With dampers of attachments, ends on springs, or motions of ends without a load no error is
 * stated.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "bench/estimates.h"

enum { LOWEST = 5, MASSES = 3, FEW = 3, FEW_MORE = 6 };
enum term { MASS, SPRING, END, TERMS };

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

/* End A or B, rigid and at rest. */
static void support(struct hawser_scene *scene, int end)
{
	scene->support[end].present = scene->support[end].harmonic = 1;
	for (int k = 0; k < 3; k++)
		scene->support[end].stiffness[k] = INFINITY;
}

/* A load that moves the mode by about `part` of the span: f/(D w). */
static void draw_load(struct drawn *drawn, struct chance *chance, double omega)
{
	struct hawser_scene *scene = &drawn->scene;
	const struct hawser_statics *st = &drawn->st;
	double ratio = chance_log(chance, 3e-3, 0.03), part = chance_log(chance, 1e-4, 1e-2);
	double force = 2.0*ratio*omega*omega*part*st->H/st->span.d;

	scene->damping.kind = HAWSER_DAMPING_RATIO;
	scene->damping.ratio = ratio;
	scene->load.present = 1;
	scene->load.frame = HAWSER_FRAME_GLOBAL;
	scene->load.extent[1] = 1.0;
	for (int i = 0; i < 3; i++)
		scene->load.per_length[i] = force*chance_between(chance, 0.2, 1.0);
}

/* Beside the load, in half the scenes, a motion of end B, which acts on the mode by its acceleration,
 * f = W^2 A, with an effect of about the same size. */
static void draw_excitation(struct drawn *drawn, struct chance *chance, double omega)
{
	struct hawser_scene *scene = &drawn->scene;
	double size = drawn->st.span.d*chance_log(chance, 1e-6, 3e-4);

	draw_load(drawn, chance, omega);
	if (chance_unit(chance) < 0.5)
		return;
	support(scene, 1);
	for (int i = 0; i < 3; i++)
		scene->support[1].motion[i] = size*chance_between(chance, -1.0, 1.0);
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
		         drawn->scene.support[1].present ? ", end B moves" : "");
	}
	hawser_modes_clear(&modes);
	return failed;
}

/* --- one term --- */

/* Springs at one point or two, in units of the cable's stiffness H/d across. */
static void draw_springs(struct hawser_scene *scene, struct chance *chance)
{
	double stiff = scene->tension.value/scene->span.d*chance_log(chance, 0.1, 30.0);

	scene->attachments = chance_int(chance, 1, 2);
	for (int i = 0; i < scene->attachments; i++) {
		scene->attach[i].at = (i + chance_between(chance, 0.03, 0.97))/scene->attachments;
		for (int k = 0; k < 3; k++)
			scene->attach[i].spring[k] = stiff*chance_unit(chance);
	}
}

/* Motions of one end or both along all axes, at up to the third multiple of the frequency, beside a
 * load. */
static void draw_ends(struct drawn *drawn, struct chance *chance)
{
	double size = drawn->st.span.d*chance_log(chance, 1e-6, 1e-4);
	int which = chance_int(chance, 1, 3);

	for (int end = 0; end < 2; end++)
		if (which & 1 << end) {
			support(&drawn->scene, end);
			for (int i = 0; i < 3; i++)
				drawn->scene.support[end].motion[i] = size*chance_between(chance, -1.0, 1.0);
			drawn->scene.support[end].phase = chance_between(chance, -3.0, 3.0);
			drawn->scene.support[end].harmonic =
				chance_unit(chance) < 0.7 ? 1 : chance_int(chance, 2, 3);
		}
}

static int one_term(struct tally *tally, struct chance *chance, enum term term)
{
	static const char *const name[TERMS] = {"masses", "springs", "moving ends"};
	struct hawser_modes_options lowest = {.n = FEW};
	struct hawser_modes modes = {.n = 0};
	int which = chance_int(chance, 0, FEW - 1), failed;
	struct drawn drawn;
	double omega = 1.0, from, to;

	draw_span(&drawn.scene, chance);
	if (term == MASS)
		draw_masses(&drawn.scene, chance);
	else if (term == SPRING)
		draw_springs(&drawn.scene, chance);
	failed = hawser_statics_scene(&drawn.st, &drawn.scene, NULL) ||
	         hawser_modes_solve(&modes, &drawn.st, &lowest, NULL);
	if (!failed)
		omega = modes.mode[which].omega;
	hawser_modes_clear(&modes);
	draw_load(&drawn, chance, omega);
	if (term == END)
		draw_ends(&drawn, chance);
	from = omega*(1.0 - chance_log(chance, 5e-3, 0.05));
	to = omega*(1.0 + chance_log(chance, 5e-3, 0.05));
	drawn.scene.model.modes = which + 1 + chance_int(chance, 1, FEW_MORE);
	snprintf(drawn.what, sizeof drawn.what, ", %d %s", drawn.scene.attachments, name[term]);
	return failed || estimate_kept(tally, &drawn.st, &drawn.scene, drawn.scene.model.modes, from, to,
	                               drawn.what);
}

int estimate_masses(struct tally *tally, struct chance *chance)
{
	return one_term(tally, chance, MASS);
}

int estimate_springs(struct tally *tally, struct chance *chance)
{
	return one_term(tally, chance, SPRING);
}

int estimate_ends(struct tally *tally, struct chance *chance)
{
	return one_term(tally, chance, END);
}

/* --- all together --- */

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
	if (chance_unit(chance) < 0.3) {
		drawn.scene.model.modes = HAWSER_MODES_AUTO;
		return estimate_reached(tally, &drawn.st, &drawn.scene, from, to, drawn.what);
	}
	drawn.scene.model.modes = n;
	return estimate_kept(tally, &drawn.st, &drawn.scene, n, from, to, drawn.what);
}
