/* scene/keys.c - values of a scene by the rows of their keys. See keys.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "scene/keys.h"

#define OF(member) offsetof(struct hawser_scene, member)

static const struct hawser__items lists[HAWSER__LISTS] = {
	[HAWSER__ATTACH] = {"attach", "{at: 40 %, mass: 20 kg}", HAWSER_ATTACH_MAX, OF(attachments),
	                    OF(attach), sizeof(struct hawser_attachment),
	                    offsetof(struct hawser_attachment, name)},
	[HAWSER__LOADS] = {"loads", "{per_length: [0, 1 N/m, 0], from: 20 %, to: 40 %}",
	                   HAWSER_LOADS_MAX, OF(loads), OF(piece), sizeof(struct hawser_load_piece),
	                   offsetof(struct hawser_load_piece, name)},
	[HAWSER__CASES] = {"cases", "{name: ice, load: {static: {mass: 0.9 kg/m}}}", HAWSER_CASES_MAX,
	                   OF(cases), OF(load_case), sizeof(struct hawser_case),
	                   offsetof(struct hawser_case, name)},
};

const struct hawser__items *hawser__list_row(int index)
{
	return index >= 0 && index < HAWSER__LISTS ? &lists[index] : NULL;
}

/* The list "attach" of the key "attach[].at" or "attach.0.at", or NULL. */
static const struct hawser__items *list_at(const char *path)
{
	size_t length = strcspn(path, ".[");

	for (int i = 0; i < HAWSER__LISTS; i++)
		if (strlen(lists[i].name) == length && !strncmp(lists[i].name, path, length))
			return &lists[i];
	return NULL;
}

const struct hawser__items *hawser__list_of(int key)
{
	return list_at(hawser_scene_key(key)->path);
}

int *hawser__list_count(const struct hawser__items *list, const struct hawser_scene *scene)
{
	return (int *)(void *)((char *)(uintptr_t)scene + list->count);
}

void *hawser__item(const struct hawser__items *list, const struct hawser_scene *scene, int item)
{
	return (char *)(uintptr_t)scene + list->first + (size_t)item*list->size;
}

const char *hawser__item_name(const struct hawser__items *list, const struct hawser_scene *scene,
                              int item)
{
	return (const char *)hawser__item(list, scene, item) + list->called;
}

const struct hawser__tree_key *hawser__row(int index)
{
	return &hawser__tree_of_span.row[index];
}

int hawser__key_find(const char *path)
{
	for (int i = 0; hawser_scene_key(i); i++)
		if (!strcmp(hawser_scene_key(i)->path, path))
			return i;
	return -1;
}

int hawser__item_key(int *number, const struct hawser_scene *scene, const char *path)
{
	const struct hawser__items *list = list_at(path);
	const char *name = path + strcspn(path, "."), *dot;
	size_t length;
	char key[2*HAWSER_NAME_SIZE];

	*number = list ? -1 : 0;
	if (!list)
		return hawser__key_find(path);
	name += *name == '.';
	length = strcspn(name, ".");
	dot = name + length;
	for (int i = 0; i < *hawser__list_count(list, scene); i++) {
		const char *own = hawser__item_name(list, scene, i);

		snprintf(key, sizeof key, "%d", i);
		if ((strlen(key) == length && !strncmp(key, name, length)) ||
		    (length && strlen(own) == length && !strncmp(own, name, length)))
			*number = i;
	}
	if (!length || !*dot)
		return -1;
	snprintf(key, sizeof key, "%s[]%s", list->name, dot);
	return hawser__key_find(key);
}

int *hawser__series(const struct hawser_scene *scene, size_t at)
{
	static const size_t series[][2] = {{OF(damping.ratio), OF(damping.ratios)},
	                                   {OF(wind.drag), OF(wind.drags)},
	                                   {OF(wind.lift), OF(wind.lifts)}};

	for (size_t i = 0; i < sizeof series/sizeof *series; i++)
		if (at == series[i][0])
			return (int *)(void *)((char *)(uintptr_t)scene + series[i][1]);
	return NULL;
}

int hawser__count(const struct hawser_scene *scene, int index)
{
	const int *series = hawser__series(scene, hawser__row(index)->at);

	return series ? *series : hawser__row(index)->count;
}

/* 1 if a key of a beam, other than the one that selects the form, applies to the form of this
 * scene. */
static int of_beam(const struct hawser_scene *scene, const char *leaf)
{
	static const char *const scaled[] = {"rho", "c", "slenderness", "v"};

	if (!strcmp(leaf, "ends") || !strcmp(leaf, "moment"))
		return scene->beam.form != HAWSER_BEAM_NONE;
	for (size_t i = 0; i < sizeof scaled/sizeof *scaled; i++)
		if (!strcmp(leaf, scaled[i]))
			return scene->beam.form == HAWSER_BEAM_MU || scene->beam.form == HAWSER_BEAM_THETA;
	return scene->beam.form == HAWSER_BEAM_EI;
}

int hawser__applies(const struct hawser_scene *scene, int index)
{
	const struct hawser__tree_key *row = hawser__row(index);
	const char *path = hawser_scene_key(index)->path;

	if (row->pick != HAWSER__TREE_NOWHERE)
		return *(const int *)(const void *)((const char *)scene + row->pick) == row->member &&
		       (row->pick != offsetof(struct hawser_scene, beam.weight) ||
		        scene->beam.form == HAWSER_BEAM_EI);
	if (hawser__child_of(path, "beam"))
		return of_beam(scene, hawser__leaf(path));
	if (hawser__child_of(path, "damping.rayleigh"))
		return scene->damping.kind == HAWSER_DAMPING_RAYLEIGH;
	if (hawser__list_of(index))
		return 0;
	if (scene->beam.form)
		return !strcmp(path, "g");
	if (hawser__child_of(path, "load"))
		return scene->load.present;
	if (hawser__child_of(path, "load.static"))
		return scene->static_load.present;
	if (!strcmp(path, "wind.drag") || !strcmp(path, "wind.lift"))
		return scene->wind.present && !scene->wind.tables;
	if (!strcmp(path, "wind.viscosity"))
		return scene->wind.crises > 0;
	if (hawser__child_of(path, "wind.wake"))
		return scene->wind.wake.present;
	if (hawser__child_of(path, "wind"))
		return scene->wind.present;
	if (hawser__child_of(path, "temperature"))
		return scene->temperature.present;
	if (!strcmp(path, "tension.state"))
		return scene->static_load.present || scene->wind.present || scene->temperature.present;
	if (hawser__child_of(path, "support.A"))
		return scene->support[0].present;
	if (hawser__child_of(path, "support.B"))
		return scene->support[1].present;
	if (!strcmp(path, "damping.drag"))
		return scene->damping.drag > 0.0;
	if (hawser__child_of(path, "ends"))
		return scene->cable.EI > 0.0;
	if (!strcmp(path, "travel.final"))
		return scene->travel.present && scene->travel.braking > 0.0;
	if (hawser__child_of(path, "travel"))
		return scene->travel.present;
	if (!strcmp(path, "tension.branch"))
		return scene->tension.given == HAWSER_GIVEN_T0 ||
		       scene->tension.given == HAWSER_GIVEN_T1;
	return 1;
}

void *hawser__field(const struct hawser_scene *scene, int index, int item)
{
	const struct hawser__items *list = hawser__list_of(index);
	char *at = list ? hawser__item(list, scene, item) : (void *)(uintptr_t)scene;

	return at + hawser__row(index)->at;
}

double hawser__stored(const struct hawser_scene *scene, int index, int element, int item)
{
	const char *at = hawser__field(scene, index, item);
	double number;
	int whole;

	if (hawser__row(index)->type == HAWSER__TREE_INTEGER) {
		memcpy(&whole, at, sizeof whole);
		return whole;
	}
	memcpy(&number, at + (element > 0 ? (size_t)element : 0)*sizeof number, sizeof number);
	return number;
}

int hawser__is_word(const struct hawser_scene *scene, int index)
{
	if (hawser__row(index)->type == HAWSER__TREE_INTEGER && hawser_scene_key(index)->words)
		return hawser__stored(scene, index, 0, 0) == 0.0;
	return hawser__row(index)->type == HAWSER__TREE_WORD;
}

void hawser__word(char *word, size_t size, const char *words, int choice)
{
	while (choice-- > 0)
		words += strcspn(words, "|") + 1;
	snprintf(word, size, "%.*s", (int)strcspn(words, "|"), words);
}
