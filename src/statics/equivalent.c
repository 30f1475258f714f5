/* statics/equivalent.c - static load, change of temperature, and the plane in which the cable hangs.
 *
 *   rho, m   mass of the cable and of what adheres to it, per unstretched length
 *   p        static load, N per unstretched length; w = (rho + m) g (0,-1,0) + p, the whole force
 *   c        the chord (d, h, 0)
 *   up       -w/|w|, the axis y' of the cable's plane; z' = c x up/|c x up|, x' = up x z'
 *   L        unstretched length in the reference state, L (1 + a dT) in the loaded one
 *
 * w is the same at each point of the cable, so that the equation (T e)' = -w has the solutions of a
 * cable under its weight, with -w/|w| in place of the vertical: a catenary in the plane of c and w, for
 * which |w|/(rho + m) takes the place of g, c.x' that of d and c.up that of h. In that plane the
 * equations of motion are those of such a cable too, as w does no other work. This is exact. c.x' is
 * computed as |c x up|: where the chord is nearly parallel to w, c - (c.up) up would cancel.
 *
 * The ends are at the places of the scene in the state whose tension is given. In the other state ends
 * on springs have moved (yield.c), and c is the chord between where they are then.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "statics/loaded.h"
#include "statics/travel.h"
#include "statics/wind.h"

static const char where[] = "statics";
/* Round-off of the sum of two forces that cancel, and of the direction of a chord; relative. */
static const double nothing = 1e-12, parallel = 1e-9;

static const struct hawser_span *bare(struct hawser_span *span, const struct hawser_scene *scene)
{
	*span = (struct hawser_span){scene->cable.EA, scene->cable.rho, scene->g, scene->span.d,
	                             scene->span.h};
	return span;
}

static void cross(double v[3], const double a[3], const double b[3])
{
	for (int i = 0; i < 3; i++)
		v[i] = a[(i + 1)%3]*b[(i + 2)%3] - a[(i + 2)%3]*b[(i + 1)%3];
}

/* Angle about the chord from the vertical plane to that of the cable, positive towards z. */
static double swing_of(const double normal[3], const double chord[3])
{
	double level = hypot(chord[0], chord[2]), along[3];
	const double vertical[3] = {-chord[2]/level, 0.0, chord[0]/level};

	cross(along, normal, vertical);
	return atan2((along[0]*chord[0] + along[1]*chord[1] + along[2]*chord[2])/hawser__norm(chord),
	             normal[0]*vertical[0] + normal[2]*vertical[2]);
}

/* The span in the plane of the chord and w, and the axes of this plane. */
static enum hawser_status turn(struct hawser_equivalent *equal, const double w[3],
                               const double chord[3], struct hawser_report *report)
{
	double *across = equal->axes[0], *up = equal->axes[1], *normal = equal->axes[2];
	double force = hawser__norm(w), d;

	for (int i = 0; i < 3; i++)
		up[i] = -w[i]/force;
	cross(normal, chord, up);
	d = hawser__norm(normal);
	if (!(d > parallel*hawser__norm(chord)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "weight and load.static together, (%g, %g, %g) N/m, act along the chord "
		                    "of the span: such a cable hangs like a vertical one, which H does not "
		                    "describe; change the load or the span", w[0], w[1], w[2]);
	for (int i = 0; i < 3; i++)
		normal[i] /= d;
	cross(across, up, normal);
	equal->turned = 1;
	equal->swing = swing_of(normal, chord);
	equal->span.d = d;
	equal->span.h = chord[0]*up[0] + chord[1]*up[1] + chord[2]*up[2];
	return HAWSER_OK;
}

/* Springs and dampers along the axes of the scene couple the motions in and out of a plane that is
 * turned, or of a cable in space. */
static enum hawser_status refuse_attached(const struct hawser_scene *scene,
                                          struct hawser_report *report)
{
	double p[3];
	int wind = hawser__static_load(p, scene) && (p[0] != 0.0 || p[2] != 0.0), aside = 0;

	for (int i = 0; i < scene->attachments; i++) {
		const struct hawser_attachment *a = &scene->attach[i];

		aside |= a->force[0] != 0.0 || a->force[2] != 0.0 ||
		         a->force[1] > (a->mass + a->absorber_mass)*scene->g;
	}
	for (int i = 0; i < scene->attachments && (wind || aside); i++) {
		const struct hawser_attachment *a = &scene->attach[i];

		if (hawser__norm(a->spring) > 0.0 || hawser__norm(a->damper) > 0.0 || a->absorber_mass > 0.0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "attach[%d] contradicts %s: springs, dampers and absorbers couple "
			                    "the planes of a turned cable, which is not available; remove one "
			                    "of them, or give a mass or force only", i,
			                    scene->wind.present ? "wind" : wind ? "load.static.per_length"
			                    : "attach.force, which turns the cable out of one plane");
	}
	return HAWSER_OK;
}

/* Whether the static load balances the weight, as of a cable that floats in water. */
static int balanced(const struct hawser_scene *scene)
{
	double weight = (scene->cable.rho + scene->static_load.mass)*scene->g, p[3];
	int loaded = hawser__static_load(p, scene);
	double force = hypot(hypot(p[0], p[1] - weight), p[2]);

	return loaded && !(force > nothing*(weight + hawser__norm(p)));
}

/* Without any force, a cable that is not taut by itself has no shape. */
static enum hawser_status determined(const struct hawser_equivalent *equal,
                                     const struct hawser_scene *scene, struct hawser_report *report)
{
	double chord = hypot(equal->span.d, equal->span.h);

	if (!balanced(scene) || scene->attachments > 0)
		return HAWSER_OK;
	if (equal->given == HAWSER_GIVEN_SAG)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "load.static balances the weight, so that the cable is straight: it has no "
		                    "sag; give H, T0, T1 or length0 in place of tension.sag");
	if (equal->given == HAWSER_GIVEN_LENGTH0 && equal->value >= chord)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "load.static balances the weight, and the unstretched length of %.9g m is "
		                    "not below the distance of %.9g m of the ends: without tension and force "
		                    "the shape is not determined; give a shorter length0 or another load",
		                    equal->value, chord);
	return HAWSER_OK;
}

/* The span between ends with the given chord, with the static load of the scene, without what gives
 * its tension. */
static enum hawser_status apply(struct hawser_equivalent *equal, const struct hawser_scene *scene,
                                const double chord[3], struct hawser_report *report)
{
	double p[3];
	int loaded = hawser__static_load(p, scene);
	double rho = scene->cable.rho + (scene->static_load.present ? scene->static_load.mass : 0.0);
	double weight = rho*scene->g;
	double w[3] = {p[0], p[1] - weight, p[2]}, force = hawser__norm(w);
	enum hawser_status status = refuse_attached(scene, report);

	bare(&equal->span, scene);
	rho += hawser__added_mass(scene);
	equal->span.rho = rho;
	equal->span.d = chord[0];
	equal->span.h = chord[1];
	if (status)
		return status;
	if (!isfinite(force))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "load.static and the weight of %g N/m leave a force of %g N/m on the "
		                    "cable: change the load", weight, force);
	if (loaded && balanced(scene)) { /* straight: what is left of the weight bends it by round-off */
		equal->span.g = nothing*scene->g;
		return HAWSER_OK;
	}
	if (loaded)
		equal->span.g = force/rho;
	if (p[0] == 0.0 && p[2] == 0.0 && w[1] < 0.0 && chord[2] == 0.0)
		return HAWSER_OK;
	status = turn(equal, w, chord, report);
	for (int i = 0; i < 3; i++)
		equal->gravity[i] = -scene->g*equal->axes[i][1];
	return status;
}

static enum hawser_status stretch_of(double *stretch, const struct hawser_scene *scene,
                                     struct hawser_report *report)
{
	*stretch = 1.0;
	if (!scene->temperature.present)
		return HAWSER_OK;
	*stretch += scene->temperature.expansion*scene->temperature.change;
	if (*stretch > 0.0 && isfinite(*stretch))
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
	                    "temperature.change = %g K with temperature.expansion = %g /K makes the "
	                    "unstretched length %g times as long: this is no change of temperature",
	                    scene->temperature.change, scene->temperature.expansion, *stretch);
}

static int changed(const struct hawser_scene *scene)
{
	return scene->static_load.present || scene->wind.present || scene->temperature.present;
}

void hawser__attached_along(struct hawser_attachment attach[HAWSER_ATTACH_MAX],
                            const struct hawser_equivalent *equal, const struct hawser_scene *scene)
{
	memcpy(attach, scene->attach, (size_t)scene->attachments*sizeof *attach);
	for (int i = 0; i < scene->attachments && equal->turned; i++)
		for (int c = 0; c < 3; c++)
			attach[i].force[c] = hawser__dot(equal->axes[c], scene->attach[i].force);
}

enum hawser_status hawser__statics_attached(struct hawser_statics *st,
                                            const struct hawser_equivalent *equal,
                                            const struct hawser_scene *scene,
                                            struct hawser_report *report)
{
	struct hawser_attachment attach[HAWSER_ATTACH_MAX];

	hawser__attached_along(attach, equal, scene);
	return hawser_statics_weighted(st, &equal->span, equal->given, equal->value, equal->branch,
	                               attach, scene->attachments, equal->gravity, report);
}

/* The span at rest without static load and change of temperature. Attachments with their forces
 * belong to both states. */
static enum hawser_status at_rest(struct hawser_statics *st, const struct hawser_span *span,
                                  enum hawser_given given, double value, enum hawser_branch branch,
                                  const struct hawser_scene *scene, struct hawser_report *report)
{
	const double down[3] = {0.0, -scene->g, 0.0};

	return scene->attachments > 0
	       ? hawser_statics_weighted(st, span, given, value, branch, scene->attach,
	                                 scene->attachments, down, report)
	       : hawser_statics_solve(st, span, given, value, branch, report);
}

/* A travelling cable may hold H or T1: the loaded state has the given quantity of the scene. */
static enum hawser_status given_again(struct hawser_equivalent *equal, const struct hawser_scene *scene,
                                      struct hawser_report *report)
{
	enum hawser_given given = scene->tension.given;
	struct hawser_statics rest;
	enum hawser_status status;

	if (!scene->travel.present || (given != HAWSER_GIVEN_H && given != HAWSER_GIVEN_T1))
		return HAWSER_OK;
	status = hawser_statics_solve(&rest, &equal->span, equal->given, equal->value, equal->branch,
	                              report);
	if (!status && given == HAWSER_GIVEN_T1)
		status = hawser__branch_of(&equal->branch, &rest, given, report);
	equal->given = given;
	equal->value = given == HAWSER_GIVEN_H ? rest.H : rest.T1;
	return status;
}

/* The span between the places of the ends. */
static enum hawser_status between_places(struct hawser_equivalent *equal,
                                         const struct hawser_scene *scene,
                                         struct hawser_report *report)
{
	const double chord[3] = {scene->span.d, scene->span.h, 0.0};

	*equal = (struct hawser_equivalent){.axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
	                                    .given = scene->tension.given,
	                                    .value = scene->tension.value,
	                                    .branch = scene->tension.branch,
	                                    .gravity = {0.0, -scene->g, 0.0}};
	return apply(equal, scene, chord, report);
}

/* Let the ends move on their springs, from where they carry rest[2]. */
static enum hawser_status give_way(struct hawser_equivalent *equal, const struct hawser_scene *scene,
                                   double rest[2][3], struct hawser_report *report)
{
	double chord[3];
	enum hawser_status status = hawser__yield(equal, chord, scene, rest, report);

	return status ? status : apply(equal, scene, chord, report);
}

/* A length that is given, between ends that hawser_statics_case has placed. */
static enum hawser_status placed(struct hawser_equivalent *equal, const struct hawser_scene *scene,
                                 struct hawser_report *report)
{
	double rest[2][3];

	for (int end = 0; end < 2; end++)
		memcpy(rest[end], scene->support[end].force, sizeof rest[end]);
	return give_way(equal, scene, rest, report);
}

static enum hawser_status equivalent(struct hawser_equivalent *equal, const struct hawser_scene *scene,
                                     struct hawser_report *report)
{
	struct hawser_span span;
	struct hawser_statics reference;
	double stretch, rest[2][3];
	enum hawser_status status = stretch_of(&stretch, scene, report);
	int moved = scene->support[0].placed;

	if (!status)
		status = between_places(equal, scene, report);
	if (status || scene->tension.state == HAWSER_STATE_LOADED || !(changed(scene) || moved))
		return status;
	if (moved) {
		equal->value *= stretch;
		return placed(equal, scene, report);
	}
	status = at_rest(&reference, bare(&span, scene), equal->given, equal->value, equal->branch, scene,
	                 report);
	if (status)
		return status;
	equal->given = HAWSER_GIVEN_LENGTH0;
	equal->value = stretch*reference.length0;
	equal->branch = HAWSER_BRANCH_TAUT;
	if (!hawser__on_springs(scene))
		return given_again(equal, scene, report);
	hawser__end_forces(rest, &reference);
	return give_way(equal, scene, rest, report);
}

enum hawser_status hawser_statics_equivalent(struct hawser_equivalent *equal,
                                             const struct hawser_scene *scene,
                                             struct hawser_report *report)
{
	enum hawser_status status = equivalent(equal, scene, report);

	return status ? status : determined(equal, scene, report);
}

/* *st: the span of *equal at rest. */
static enum hawser_status solve(struct hawser_statics *st, const struct hawser_equivalent *equal,
                                const struct hawser_scene *scene, struct hawser_report *report)
{
	enum hawser_status status =
		scene->attachments > 0
		? hawser__statics_attached(st, equal, scene, report)
		: hawser_statics_solve(st, &equal->span, equal->given, equal->value, equal->branch, report);

	if (!status)
		hawser_statics_turn(st, equal);
	return status;
}

enum hawser_status hawser_statics_reference(struct hawser_statics *st,
                                            const struct hawser_scene *scene,
                                            struct hawser_report *report)
{
	struct hawser_equivalent equal, before;
	struct hawser_scene bare_scene = *scene;
	double stretch, rest[2][3];
	int other = scene->tension.state == HAWSER_STATE_LOADED && changed(scene);
	enum hawser_status status = stretch_of(&stretch, scene, report);

	bare_scene.static_load.present = bare_scene.wind.present = bare_scene.temperature.present = 0;
	if (!status && other)
		status = hawser_statics_equivalent(&equal, scene, report);
	if (!status && other)
		status = solve(st, &equal, scene, report);
	if (!status)
		status = between_places(&before, &bare_scene, report);
	if (!status && other) {
		before.given = HAWSER_GIVEN_LENGTH0;
		before.value = st->length0/stretch;
		before.branch = HAWSER_BRANCH_TAUT;
		hawser__end_forces(rest, st);
	}
	if (!status && other && hawser__on_springs(scene))
		status = give_way(&before, &bare_scene, rest, report);
	if (!status && scene->support[0].placed)
		status = placed(&before, &bare_scene, report);
	return status ? status : solve(st, &before, &bare_scene, report);
}

enum hawser_status hawser_statics_case(struct hawser_scene *to, const struct hawser_scene *scene,
                                       int index, struct hawser_report *report)
{
	struct hawser_statics reference, given;
	double rest[2][3];
	enum hawser_status status = HAWSER_OK;

	hawser_scene_case(to, scene, index);
	to->tension.state = HAWSER_STATE_REFERENCE;
	if (scene->tension.state == HAWSER_STATE_REFERENCE || !changed(scene))
		return HAWSER_OK;
	status = hawser_statics_reference(&reference, scene, report);
	to->tension.given = HAWSER_GIVEN_LENGTH0;
	to->tension.value = reference.length0;
	to->tension.branch = HAWSER_BRANCH_TAUT;
	if (status || !hawser__on_springs(scene))
		return status;
	status = hawser_statics_scene(&given, scene, report);
	hawser__end_forces(rest, &given);
	for (int end = 0; end < 2; end++) {
		to->support[end].placed = 1;
		memcpy(to->support[end].force, rest[end], sizeof rest[end]);
	}
	return status;
}

/* The swing of the plane of the chord and of all forces together. */
static void swing_of_all(struct hawser_statics *st)
{
	double total[3], normal[3], chord[3] = {st->span.d, st->span.h, 0.0};

	hawser__space_total(total, st);
	hawser_statics_to_global(st, total, total);
	hawser_statics_to_global(st, chord, chord);
	cross(normal, total, chord);
	st->swing = swing_of(normal, chord);
}

void hawser_statics_turn(struct hawser_statics *st, const struct hawser_equivalent *equal)
{
	memcpy(st->axes, equal->axes, sizeof st->axes);
	st->turned = equal->turned;
	st->swing = equal->swing;
	if (st->space)
		swing_of_all(st);
	hawser__yield_moved(st, equal);
}

void hawser_statics_to_global(const struct hawser_statics *st, double global[3], const double v[3])
{
	const double in[3] = {v[0], v[1], v[2]};

	for (int i = 0; i < 3; i++)
		global[i] = !st->turned ? in[i] : st->axes[0][i]*in[0] + st->axes[1][i]*in[1] +
		                                  st->axes[2][i]*in[2];
}

void hawser_statics_from_global(const struct hawser_statics *st, double v[3], const double global[3])
{
	const double in[3] = {global[0], global[1], global[2]};

	for (int i = 0; i < 3; i++)
		v[i] = !st->turned ? in[i] : st->axes[i][0]*in[0] + st->axes[i][1]*in[1] +
		                             st->axes[i][2]*in[2];
}
