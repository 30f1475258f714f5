/* scene/check.c - checks after the file and all overrides are read: missing keys, and keys that
 * require another one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdio.h>
#include <string.h>

#include "scene/reader.h"

static int written(const struct hawser__reader *reader, int index)
{
	return reader->scene->written[index];
}

static int within(const char *path, const char *section)
{
	size_t length = strlen(section);

	return !strncmp(path, section, length) && path[length] == '.';
}

/* 1 if a section is given, by its name or by an override of one of its keys. The section load with
 * nothing but load.static is not: the scene then has no varying load. */
static int present(const struct hawser__reader *reader, int section)
{
	size_t count;
	const char *path = hawser__sections(&count)[section].path;
	int load = !strcmp(path, "load");

	if (reader->section[section].pass &&
	    !(load && reader->section[hawser__section_find("load.static")].pass))
		return 1;
	for (int i = 0; hawser_scene_key(i); i++)
		if (written(reader, i) && (load ? hawser__child_of(hawser_scene_key(i)->path, path)
		                                : within(hawser_scene_key(i)->path, path)))
			return 1;
	return 0;
}

/* The place to report if a key of a section is missing: the section, the override that created it,
 * or the whole scene. */
static const struct hawser__mark *near(const struct hawser__reader *reader, int section)
{
	size_t count;
	const char *path = hawser__sections(&count)[section].path;

	if (reader->section[section].pass)
		return &reader->section[section];
	for (int i = 0; hawser_scene_key(i); i++)
		if (written(reader, i) && within(hawser_scene_key(i)->path, path))
			return &reader->key[i];
	return &reader->root;
}

/* "cable.EA is missing: give a number in N (axial stiffness ...)" */
static enum hawser_status missing(struct hawser__reader *reader, int section,
                                  const struct hawser_scene_key *key)
{
	const char *sort = strncmp(key->type, "numbers", 7) ? "a number" : "a list of numbers";
	int pure = !strcmp(key->unit, "1");

	if (key->words)
		return hawser__reader_fail(reader, near(reader, section),
		                           "%s is missing and has no default: give one of %s (%s)",
		                           key->path, key->words, key->doc);
	return hawser__reader_fail(reader, near(reader, section),
	                           "%s is missing and has no default: give %s%s%s (%s)", key->path,
	                           sort, pure ? "" : " in ", pure ? "" : key->unit, key->doc);
}

/* 1 if a section is required: those of a cable are not if a beam is given. */
static int needs(const struct hawser__reader *reader, int section)
{
	size_t count;

	return hawser__sections(&count)[section].required && !reader->scene->beam.form &&
	       !present(reader, hawser__section_find("beam"));
}

/* Fail if no member of a group is given although its section is required or present. */
static enum hawser_status chosen(struct hawser__reader *reader, enum hawser__group group)
{
	const struct hawser__choice *choice = hawser__choice(group);
	int section = hawser__section_find(choice->section);
	int needed = needs(reader, section) || present(reader, section);

	if (group == HAWSER__WEIGHT)
		needed = reader->scene->beam.form == HAWSER_BEAM_EI;
	if (group == HAWSER__DAMPING && written(reader, hawser__key_find("damping.drag")))
		needed = 0;

	if (!needed || hawser__chosen(reader->scene, group))
		return HAWSER_OK;
	return hawser__reader_fail(reader, near(reader, section), "%s is missing: give %s",
	                           choice->what, choice->rule);
}

/* 1 if a key is required: it has no default, its section is present, and it does not belong to
 * another choice. */
static int required(const struct hawser__reader *reader, int index, int section)
{
	const struct hawser__row *row = &hawser__rows()[index];

	if (hawser_scene_key(index)->fallback)
		return 0;
	if (row->group)
		return hawser__chosen(reader->scene, row->group) == row->member &&
		       present(reader, section);
	if (reader->scene->beam.form)
		return hawser__applies(reader->scene, index);
	return needs(reader, section) || present(reader, section);
}

/* Check that all required keys are given. Of the members of a group (tension.H, T0, ...) only the
 * chosen one is required. The two factors of Rayleigh damping are one choice, so that both are
 * required. */
static enum hawser_status complete(struct hawser__reader *reader)
{
	const struct hawser_scene_key *key;
	size_t sections;
	const struct hawser__section *section = hawser__sections(&sections);

	for (int s = 0; s < (int)sections; s++)
		for (int i = 0; (key = hawser_scene_key(i)); i++)
			if (hawser__child_of(key->path, section[s].path) && !written(reader, i) &&
			    required(reader, i, s))
				return missing(reader, s, key);
	return HAWSER_OK;
}

static enum hawser_status branch(struct hawser__reader *reader)
{
	int index = hawser__key_find("tension.branch");
	const char *given = "";

	if (!written(reader, index) || hawser__applies(reader->scene, index))
		return HAWSER_OK;
	for (int i = 0; hawser_scene_key(i); i++)
		if (hawser__rows()[i].group == HAWSER__TENSION && written(reader, i))
			given = hawser_scene_key(i)->path;
	return hawser__reader_fail(reader, &reader->key[index],
	                           "tension.branch contradicts %s, which has one equilibrium only: "
	                           "remove tension.branch, or give T0 or T1", given);
}

/* If a beam is given, fail on keys of a cable and on keys of another form of beam. */
static enum hawser_status beam(struct hawser__reader *reader)
{
	static const char *const form[] = {"", "mu", "theta", "EI"};
	size_t sections;
	const struct hawser__section *section = hawser__sections(&sections);

	if (!present(reader, hawser__section_find("beam")))
		return HAWSER_OK;
	for (int s = 0; s < (int)sections; s++)
		if (strcmp(section[s].path, "beam") != 0 && present(reader, s))
			return hawser__reader_fail(reader, near(reader, s),
			                           "%s contradicts beam: a scene is of a cable or of a beam, "
			                           "remove one of them", section[s].path);
	for (int i = 0; reader->scene->beam.form && hawser_scene_key(i); i++)
		if (written(reader, i) && !hawser__applies(reader->scene, i))
			return hawser__reader_fail(reader, &reader->key[i],
			                           "%s contradicts beam.%s: %s",
			                           hawser_scene_key(i)->path, form[reader->scene->beam.form],
			                           reader->scene->beam.form == HAWSER_BEAM_EI
			                                   ? "a beam in SI has rhoA, L, tension_end, drag, "
			                                     "gyration, speed and gravity or inclination"
			                                   : "a scaled beam has rho, c, slenderness and v");
	return HAWSER_OK;
}

/* Fail if a string has rotary inertia: without bending rigidity no restoring moment acts on it, and
 * no speed is stable. */
static enum hawser_status string(struct hawser__reader *reader)
{
	const struct hawser_scene *scene = reader->scene;
	int theta = scene->beam.form == HAWSER_BEAM_THETA;
	int index = hawser__key_find(theta ? "beam.slenderness" : "beam.gyration");

	if (!(theta && scene->beam.theta == 0.0 && scene->beam.slenderness > 0.0) &&
	    !(scene->beam.form == HAWSER_BEAM_EI && scene->beam.EI == 0.0 && scene->beam.gyration > 0.0))
		return HAWSER_OK;
	return hawser__reader_fail(reader, &reader->key[index],
	                           "a string has no rotary inertia: remove %s, or give a bending rigidity",
	                           theta ? "beam.slenderness" : "beam.gyration");
}

static enum hawser_status braking(struct hawser__reader *reader)
{
	const struct hawser_scene *scene = reader->scene;
	int final = hawser__key_find("travel.final"), braking = hawser__key_find("travel.braking");

	if (written(reader, final) && !(scene->travel.braking > 0.0))
		return hawser__reader_fail(reader, &reader->key[final],
		                           "travel.final is the speed after braking: give the time that "
		                           "braking takes with travel.braking, or remove travel.final");
	if (scene->travel.braking > 0.0 && scene->travel.fluctuation > 0.0)
		return hawser__reader_fail(reader, &reader->key[braking],
		                           "travel.braking contradicts travel.fluctuation: a speed either "
		                           "repeats itself or changes once and for all");
	return HAWSER_OK;
}

static int gives(const struct hawser__reader *reader, const char *section, const char *leaf)
{
	char path[64];

	snprintf(path, sizeof path, "%s.%s", section, leaf);
	return written(reader, hawser__key_find(path));
}

/* An end that is given has springs, or a motion, to which phase and harmonic belong. *moving and
 * *elastic are set if it has. */
static enum hawser_status end_given(struct hawser__reader *reader, const char *name, int *moving,
                                    int *elastic)
{
	int section = hawser__section_find(name), moves = gives(reader, name, "motion");
	int sprung = gives(reader, name, "stiffness");
	char path[64];

	*moving |= moves;
	*elastic |= sprung;
	if (!present(reader, section) || moves || (sprung && !gives(reader, name, "phase") &&
	                                           !gives(reader, name, "harmonic")))
		return HAWSER_OK;
	snprintf(path, sizeof path, "%s.%s", name, gives(reader, name, "mass") ? "stiffness" : "motion");
	return missing(reader, section, hawser_scene_key(hawser__key_find(path)));
}

/* Fail if the ends of a cable move, or are on springs, for which this is not modelled. */
static enum hawser_status supports(struct hawser__reader *reader)
{
	int section = hawser__section_find("support"), moving = 0, elastic = 0;
	enum hawser_status status = end_given(reader, "support.A", &moving, &elastic);

	if (!status)
		status = end_given(reader, "support.B", &moving, &elastic);
	if (status || !(moving || elastic))
		return status;
	if (reader->scene->travel.present)
		return hawser__reader_fail(reader, near(reader, section), "support contradicts travel: moving "
		                           "or elastic supports of a travelling cable are not modelled, remove "
		                           "one of them");
	return HAWSER_OK;
}

/* Fail if the cable has bending stiffness where this is not modelled, or held ends without it. */
static enum hawser_status bending(struct hawser__reader *reader)
{
	const struct hawser_scene *scene = reader->scene;
	const struct hawser__mark *at = &reader->key[hawser__key_find("cable.EI")];
	int ends = hawser__section_find("ends");
	const char *other = scene->travel.present ? "travel"
	                    : gives(reader, "support.A", "stiffness") ? "support.A.stiffness"
	                    : gives(reader, "support.B", "stiffness") ? "support.B.stiffness" : NULL;

	if (!(scene->cable.EI > 0.0))
		return present(reader, ends)
		       ? hawser__reader_fail(reader, near(reader, ends), "ends contradicts cable.EI = 0: a "
		                             "cable without bending stiffness turns freely at its ends; give "
		                             "cable.EI, or remove ends")
		       : HAWSER_OK;
	if (!other)
		return HAWSER_OK;
	return hawser__reader_fail(reader, at, "cable.EI contradicts %s: bending stiffness of such a "
	                           "cable is not modelled, remove one of them", other);
}

enum hawser_status hawser__check(struct hawser__reader *reader)
{
	enum hawser_status status = beam(reader);

	if (status == HAWSER_OK)
		status = chosen(reader, HAWSER__BEAM);
	if (status == HAWSER_OK)
		status = chosen(reader, HAWSER__WEIGHT);
	if (status == HAWSER_OK)
		status = string(reader);
	if (status == HAWSER_OK)
		status = chosen(reader, HAWSER__TENSION);

	reader->scene->travel.present = present(reader, hawser__section_find("travel"));
	reader->scene->support[0].present = present(reader, hawser__section_find("support.A"));
	reader->scene->support[1].present = present(reader, hawser__section_find("support.B"));
	reader->scene->load.present = present(reader, hawser__section_find("load"));
	reader->scene->static_load.present = present(reader, hawser__section_find("load.static"));
	reader->scene->temperature.present = present(reader, hawser__section_find("temperature"));
	if (status == HAWSER_OK)
		status = chosen(reader, HAWSER__DAMPING);
	if (status == HAWSER_OK)
		status = complete(reader);
	if (status == HAWSER_OK)
		status = branch(reader);
	if (status == HAWSER_OK)
		status = braking(reader);
	if (status == HAWSER_OK)
		status = supports(reader);
	if (status == HAWSER_OK)
		status = bending(reader);
	if (status == HAWSER_OK)
		status = hawser__items_check(reader);
	return status;
}
