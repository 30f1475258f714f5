/* scene/check.c - rules over several keys of a span, after the file and all overrides are read.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "scene/keys.h"
#include "scene/reader.h"
#include "scene/tree.h"

struct checked {
	struct hawser__reader *reader;
	struct hawser_scene *scene;
	const struct hawser__tree *root;
};

static int given(const struct checked *of, const char *path)
{
	return hawser__tree_at(of->root, path) != NULL;
}

/* The place of a key or mapping that is given. */
static const struct hawser__mark *place(const struct checked *of, const char *path)
{
	return &hawser__tree_at(of->root, path)->at;
}

static enum hawser_status missing(const struct checked *of, const char *section, const char *leaf)
{
	char what[64], path[80];

	snprintf(what, sizeof what, "%s.%s", section, leaf);
	snprintf(path, sizeof path, "span.%s", what);
	return hawser__tree_missing(of->reader, hawser__tree_at(of->root, section), what, path);
}

/* What the form of a beam needs, and what belongs to another one. */
static enum hawser_status beam(const struct checked *of)
{
	static const char *const form[] = {"", "mu", "theta", "EI"};
	const struct hawser_scene *scene = of->scene;

	for (int i = 0; scene->beam.form && hawser_scene_key(i); i++) {
		const char *path = hawser_scene_key(i)->path;

		if (!hawser__child_of(path, "beam"))
			continue;
		if (given(of, path) && !hawser__applies(scene, i))
			return hawser__reader_fail(of->reader, place(of, path), "%s contradicts beam.%s: %s", path,
			                           form[scene->beam.form], scene->beam.form == HAWSER_BEAM_EI
			                           ? "a beam in SI has rhoA, L, tension_end, drag, gyration, "
			                           "speed and gravity or inclination"
			                           : "a scaled beam has rho, c, slenderness and v");
		if (!given(of, path) && hawser__applies(scene, i) && !hawser_scene_key(i)->fallback)
			return missing(of, "beam", hawser__leaf(path));
	}
	if (scene->beam.form != HAWSER_BEAM_EI || scene->beam.weight)
		return HAWSER_OK;
	return hawser__reader_fail(of->reader, place(of, "beam"), "the direction of the weight is "
	                           "missing: give exactly one of gravity and inclination");
}

/* Fail if a string has rotary inertia: without bending rigidity no restoring moment acts on it, and
 * no speed is stable. */
static enum hawser_status string(const struct checked *of)
{
	const struct hawser_scene *scene = of->scene;
	int theta = scene->beam.form == HAWSER_BEAM_THETA;
	const char *inertia = theta ? "beam.slenderness" : "beam.gyration";

	if (!(theta && scene->beam.theta == 0.0 && scene->beam.slenderness > 0.0) &&
	    !(scene->beam.form == HAWSER_BEAM_EI && scene->beam.EI == 0.0 && scene->beam.gyration > 0.0))
		return HAWSER_OK;
	return hawser__reader_fail(of->reader, place(of, inertia),
	                           "a string has no rotary inertia: remove %s, or give a bending rigidity",
	                           inertia);
}

/* tension.branch belongs to T0 and T1; an override by another tension takes it out. */
static enum hawser_status branch(const struct checked *of)
{
	static const char *const quantity[] = {"", "tension.H", "tension.T0", "tension.T1",
	                                       "tension.length0", "tension.sag"};
	struct hawser_scene *scene = of->scene;
	int index = hawser__key_find("tension.branch");

	if (!scene->written[index] || hawser__applies(scene, index))
		return HAWSER_OK;
	if (place(of, "tension.branch")->pass >= place(of, quantity[scene->tension.given])->pass)
		return hawser__reader_fail(of->reader, place(of, "tension.branch"),
		                           "tension.branch contradicts %s, which has one equilibrium only: "
		                           "remove tension.branch, or give T0 or T1",
		                           quantity[scene->tension.given]);
	scene->tension.branch = HAWSER_BRANCH_TAUT;
	scene->written[index] = 0;
	return HAWSER_OK;
}

static enum hawser_status braking(const struct checked *of)
{
	const struct hawser_scene *scene = of->scene;

	if (given(of, "travel.final") && !(scene->travel.braking > 0.0))
		return hawser__reader_fail(of->reader, place(of, "travel.final"),
		                           "travel.final is the speed after braking: give the time that "
		                           "braking takes with travel.braking, or remove travel.final");
	if (scene->travel.braking > 0.0 && scene->travel.fluctuation > 0.0)
		return hawser__reader_fail(of->reader, place(of, "travel.braking"),
		                           "travel.braking contradicts travel.fluctuation: a speed either "
		                           "repeats itself or changes once and for all");
	return HAWSER_OK;
}

/* An end that is given has springs, or a motion, to which phase and harmonic belong. */
static enum hawser_status end(const struct checked *of, const char *name)
{
	const struct hawser__tree *tree = hawser__tree_at(of->root, name);

	if (!tree || hawser__tree_find(tree, "motion") ||
	    (hawser__tree_find(tree, "stiffness") && !hawser__tree_find(tree, "phase") &&
	     !hawser__tree_find(tree, "harmonic")))
		return HAWSER_OK;
	return missing(of, name, hawser__tree_find(tree, "mass") ? "stiffness" : "motion");
}

static enum hawser_status supports(const struct checked *of)
{
	enum hawser_status status = end(of, "support.A");

	if (!status)
		status = end(of, "support.B");
	if (status || !of->scene->travel.present ||
	    !(of->scene->support[0].present || of->scene->support[1].present))
		return status;
	return hawser__reader_fail(of->reader, place(of, "support"), "support contradicts travel: "
	                           "moving or elastic supports of a travelling cable are not modelled, "
	                           "remove one of them");
}

/* Fail if the cable has bending stiffness where this is not modelled, or held ends without it. */
static enum hawser_status bending(const struct checked *of)
{
	static const char *const others[] = {"travel", "support.A.stiffness", "support.B.stiffness"};
	size_t i = 0;

	if (!(of->scene->cable.EI > 0.0))
		return given(of, "ends")
		       ? hawser__reader_fail(of->reader, place(of, "ends"), "ends contradicts cable.EI = 0: a "
		                             "cable without bending stiffness turns freely at its ends; give "
		                             "cable.EI, or remove ends")
		       : HAWSER_OK;
	while (i < sizeof others/sizeof *others && !given(of, others[i]))
		i++;
	if (i == sizeof others/sizeof *others)
		return HAWSER_OK;
	return hawser__reader_fail(of->reader, place(of, "cable.EI"), "cable.EI contradicts %s: bending "
	                           "stiffness of such a cable is not modelled, remove one of them",
	                           others[i]);
}

static enum hawser_status damping(const struct checked *of)
{
	if (!given(of, "damping") || of->scene->damping.kind || given(of, "damping.drag"))
		return HAWSER_OK;
	return hawser__reader_fail(of->reader, place(of, "damping"), "the kind of damping is missing: give "
	                           "exactly one of alpha, rayleigh, ratio");
}

static int zero(const double *v)
{
	return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0;
}

/* What is needed together, and what contradicts the force of a wind on a moving cable. */
static enum hawser_status wind(const struct checked *of)
{
	static const char *const other[] = {"travel", "support.A", "support.B", "damping.drag"};
	const struct hawser_wind *wind = &of->scene->wind;

	if (!wind->present)
		return HAWSER_OK;
	for (size_t i = 0; i < sizeof other/sizeof *other; i++)
		if (given(of, other[i]))
			return hawser__reader_fail(of->reader, place(of, "wind"), "wind contradicts %s: the force "
			                           "of the wind on such a cable is not modelled, remove one of "
			                           "them", other[i]);
	if (zero(wind->direction))
		return hawser__reader_fail(of->reader, place(of, "wind.direction"), "wind.direction is [0, 0, "
		                           "0]: give a direction, such as [0, 0, 1] across the span");
	if (wind->wake.present && wind->wake.fluid_damping > 0.0 &&
	    (wind->tables || wind->crises || given(of, "wind.drag") || given(of, "wind.lift")))
		return hawser__reader_fail(of->reader, place(of, "wind.wake"), "wind.wake.fluid_damping = %g "
		                           "is the damping by the drag, and wind has drag and lift besides: "
		                           "set wind.wake.fluid_damping: 0, or remove them",
		                           wind->wake.fluid_damping);
	if (wind->wake.present && wind->form == HAWSER_WIND_EXACT)
		return hawser__reader_fail(of->reader, place(of, "wind.form"), "wind.form: exact contradicts "
		                           "wind.wake, whose oscillators go with the cubic form: remove one of "
		                           "them");
	if (wind->wake.present && wind->profiles && wind->wake.places == 0)
		return hawser__reader_fail(of->reader, place(of, "wind.profile"), "wind.profile contradicts "
		                           "wind.wake.at: modes, which have one speed each: give a number of "
		                           "places, such as at: 16");
	return hawser__wind_check(of->reader, wind, hawser__tree_at(of->root, "wind"), "wind");
}

/* 1 if an attachment has no effect. */
static int idle(const struct hawser_attachment *a)
{
	double sum = a->mass + a->absorber_mass;

	for (int c = 0; c < 3; c++)
		sum += a->spring[c] + a->damper[c] + fabs(a->force[c]);
	return sum == 0.0;
}

static enum hawser_status attachments(const struct checked *of)
{
	const struct hawser_scene *scene = of->scene;
	const struct hawser_attachment *a = scene->attach;
	const struct hawser__tree *one = hawser__tree_find(of->root, "attach");

	if (!one || !scene->attachments)
		return HAWSER_OK;
	if (scene->travel.present)
		return hawser__reader_fail(of->reader, &one->at, "attach contradicts travel: attachments "
		                           "are at rest, and the cable would move past them; remove one of "
		                           "them");
	one = one->child;
	for (int i = 0; i < scene->attachments; i++, one = one->next) {
		const struct hawser__mark *here = &one->at;

		if (a[i].absorber_mass > 0.0 && a[i].absorber_cubic > 0.0 && a[i].absorber_stiffness == 0.0)
			return hawser__reader_fail(of->reader, here, "attach[%d] has an absorber whose cubic "
			                           "spring alone does not hold it at rest: give an "
			                           "absorber_stiffness besides, small against absorber_cubic "
			                           "times the square of the stroke", i);
		if ((a[i].absorber_mass > 0.0) != (a[i].absorber_stiffness > 0.0) ||
		    ((a[i].absorber_damping > 0.0 || a[i].absorber_cubic > 0.0) && !(a[i].absorber_mass > 0.0)))
			return hawser__reader_fail(of->reader, here, "attach[%d] has an incomplete absorber: give "
			                           "both absorber_mass and absorber_stiffness, or none", i);
		if (idle(&a[i]))
			return hawser__reader_fail(of->reader, here, "attach[%d] has no effect: give it a mass, a "
			                           "force, a spring, a damper or an absorber", i);
		for (int j = 0; j < i; j++)
			if (a[i].by_length == a[j].by_length && a[i].at == a[j].at)
				return hawser__reader_fail(of->reader, here, "attach[%d] and attach[%d] "
				                           "are at the same point: make one of them", j, i);
	}
	return HAWSER_OK;
}

static enum hawser_status piece(struct hawser__reader *reader, const struct hawser_load_piece *one,
                                int i, const struct hawser__mark *here)
{
	if (!zero(one->force) && !zero(one->per_length))
		return hawser__reader_fail(reader, here, "loads[%d] has both per_length and force: make two "
		                           "loads of them", i);
	if (zero(one->force) && zero(one->per_length))
		return hawser__reader_fail(reader, here, "loads[%d] has no effect: give it a per_length, or "
		                           "a force and at", i);
	if (!zero(one->force) && one->at == 0.0)
		return hawser__reader_fail(reader, here, "loads[%d] is a force without a point: give at, such "
		                           "as at: 30 %% or at: 12 m", i);
	if (!zero(one->force) && (one->from != 0.0 || one->to != 1.0 || one->to_length || one->wave != 0.0))
		return hawser__reader_fail(reader, here, "loads[%d]: from, to and wave are of a per_length: a "
		                           "force acts at one point, at", i);
	if (!zero(one->per_length) && one->at != 0.0)
		return hawser__reader_fail(reader, here, "loads[%d]: at is the point of a force: a per_length "
		                           "acts from and to", i);
	if (!zero(one->per_length) && one->from_length == one->to_length && one->from >= one->to)
		return hawser__reader_fail(reader, here, "loads[%d] acts from %g to %g: give the end nearer "
		                           "to A first", i, one->from, one->to);
	return HAWSER_OK;
}

static enum hawser_status loads(const struct checked *of)
{
	const struct hawser__tree *one = hawser__tree_find(of->root, "loads");
	enum hawser_status status = HAWSER_OK;

	one = one ? one->child : NULL;
	for (int i = 0; i < of->scene->loads && !status; i++, one = one->next)
		status = piece(of->reader, &of->scene->piece[i], i, &one->at);
	return status;
}

static enum hawser_status cases(const struct checked *of)
{
	struct hawser_scene *scene = of->scene;

	for (int i = 0; i < scene->cases; i++) {
		struct hawser_case *c = &scene->load_case[i];

		if (c->wind > 0.0 && !scene->wind.present)
			return hawser__reader_fail(of->reader, place(of, "cases"), "cases[%d] (%s) has a "
			                           "wind.speed, and the scene has no wind: give it, with its "
			                           "density, diameter and drag", i, c->name);
		if (!c->heated || !isnan(c->expansion))
			continue;
		if (!scene->temperature.present)
			return hawser__reader_fail(of->reader, place(of, "cases"), "cases[%d] (%s) has no "
			                           "temperature.expansion, and neither has the scene: give it "
			                           "in 1/K in one of them", i, c->name);
		c->expansion = scene->temperature.expansion;
	}
	return HAWSER_OK;
}

enum hawser_status hawser__check(struct hawser__reader *reader, struct hawser_scene *scene,
                                 const struct hawser__tree *root)
{
	static enum hawser_status (*const rule[])(const struct checked *) = {
		beam, string, damping, wind, branch, braking, supports, bending, attachments, loads, cases};
	const struct checked of = {reader, scene, root};
	const struct hawser__tree *load = hawser__tree_find(root, "load");
	enum hawser_status status = HAWSER_OK;

	scene->travel.present = given(&of, "travel");
	scene->support[0].present = given(&of, "support.A");
	scene->support[1].present = given(&of, "support.B");
	scene->static_load.present = given(&of, "load.static");
	scene->wind.present = given(&of, "wind");
	scene->wind.wake.present = given(&of, "wind.wake");
	scene->temperature.present = given(&of, "temperature");
	scene->load.present = load && (load->children != 1 || !scene->static_load.present);
	for (size_t i = 0; i < sizeof rule/sizeof *rule && !status; i++)
		status = rule[i](&of);
	return status;
}
