/* scene/lists.c - the table of the lists of a scene, and the rules of attachments and loads. A new list
 * is a row here, rows "NAME.KEY" in the table of keys, and an array in struct hawser_scene.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "scene/reader.h"

static const struct hawser_load_piece load = {.frame = HAWSER_FRAME_GLOBAL, .to = 1.0, .harmonic = 1};

static const struct hawser_attachment attachment = {.absorber_direction = {0.0, 1.0, 0.0}};

#define OF(member) offsetof(struct hawser_scene, member)

static const struct hawser__items table[HAWSER__LISTS] = {
	[HAWSER__ATTACH] = {.name = "attach", .one = "attachment",
		.keys = "at, mass, spring, damper, absorber_... or name", .example = "{at: 40 %, mass: 20 kg}",
		.required = "attach.at", .missing = "has no position: give at, such as at: 40 % or at: 12 m",
		.most = HAWSER_ATTACH_MAX, .count = OF(attachments), .first = OF(attach),
		.size = sizeof(struct hawser_attachment),
		.called = offsetof(struct hawser_attachment, name), .fresh = &attachment,
		.check = hawser__attach_check},
	[HAWSER__LOADS] = {.name = "loads", .one = "load",
		.keys = "per_length, from, to, wave, force, at, frame, harmonic, phase or name",
		.example = "{per_length: [0, 1 N/m, 0], from: 20 %, to: 40 %}",
		.most = HAWSER_LOADS_MAX, .count = OF(loads), .first = OF(piece),
		.size = sizeof(struct hawser_load_piece),
		.called = offsetof(struct hawser_load_piece, name), .fresh = &load,
		.check = hawser__loads_check},
	[HAWSER__CASES] = {.name = "cases", .one = "case",
		.example = "{name: ice, load: {static: {mass: 0.9 kg/m}}}",
		.most = HAWSER_CASES_MAX, .count = OF(cases), .first = OF(load_case),
		.size = sizeof(struct hawser_case), .called = offsetof(struct hawser_case, name),
		.read = hawser__case_read, .set = hawser__case_set, .check = hawser__cases_check},
};

const struct hawser__items *hawser__list_row(int index)
{
	return index >= 0 && index < HAWSER__LISTS ? &table[index] : NULL;
}

int hawser__list_find(const char *path)
{
	size_t length = strcspn(path, ".");

	for (int i = 0; i < HAWSER__LISTS; i++)
		if (strlen(table[i].name) == length && !strncmp(table[i].name, path, length))
			return i;
	return -1;
}

const struct hawser__items *hawser__list_of(int key)
{
	return hawser__list_row(hawser__list_find(hawser_scene_key(key)->path));
}

int *hawser__list_count(const struct hawser__items *list, const struct hawser_scene *scene)
{
	return (int *)(void *)((char *)(uintptr_t)scene + list->count);
}

const char *hawser__item_name(const struct hawser__items *list, const struct hawser_scene *scene,
                              int item)
{
	return (const char *)scene + list->first + (size_t)item*list->size + list->called;
}

/* --- attachments --- */

/* 1 if an attachment has no effect. */
static int idle(const struct hawser_attachment *a)
{
	double sum = a->mass + a->absorber_mass;

	for (int c = 0; c < 3; c++)
		sum += a->spring[c] + a->damper[c] + fabs(a->force[c]);
	return sum == 0.0;
}

enum hawser_status hawser__attach_check(struct hawser__reader *reader)
{
	const struct hawser_scene *scene = reader->scene;
	const struct hawser_attachment *a = scene->attach;
	const struct hawser__mark *here = &reader->list[HAWSER__ATTACH];

	if (scene->travel.present)
		return hawser__reader_fail(reader, here, "attach contradicts travel: attachments "
		                           "are at rest, and the cable would move past them; remove one of "
		                           "them");
	for (int i = 0; i < scene->attachments; i++) {
		if (a[i].absorber_mass > 0.0 && a[i].absorber_cubic > 0.0 && a[i].absorber_stiffness == 0.0)
			return hawser__reader_fail(reader, here, "attach[%d] has an absorber whose cubic spring "
			                           "alone does not hold it at rest: give an absorber_stiffness "
			                           "besides, small against absorber_cubic times the square of "
			                           "the stroke", i);
		if ((a[i].absorber_mass > 0.0) != (a[i].absorber_stiffness > 0.0) ||
		    ((a[i].absorber_damping > 0.0 || a[i].absorber_cubic > 0.0) && !(a[i].absorber_mass > 0.0)))
			return hawser__reader_fail(reader, here, "attach[%d] has an incomplete absorber: give "
			                           "both absorber_mass and absorber_stiffness, or none", i);
		if (idle(&a[i]))
			return hawser__reader_fail(reader, here, "attach[%d] has no effect: give it a mass, a "
			                           "force, a spring, a damper or an absorber", i);
		for (int j = 0; j < i; j++)
			if (a[i].by_length == a[j].by_length && a[i].at == a[j].at)
				return hawser__reader_fail(reader, here, "attach[%d] and attach[%d] "
				                           "are at the same point: make one of them", j, i);
	}
	return HAWSER_OK;
}

/* --- loads --- */

static int any(const double *vector)
{
	return vector[0] != 0.0 || vector[1] != 0.0 || vector[2] != 0.0;
}

static enum hawser_status piece(struct hawser__reader *reader, const struct hawser_load_piece *one,
                                int i)
{
	const struct hawser__mark *here = &reader->list[HAWSER__LOADS];

	if (any(one->force) && any(one->per_length))
		return hawser__reader_fail(reader, here, "loads[%d] has both per_length and force: make two "
		                           "loads of them", i);
	if (!any(one->force) && !any(one->per_length))
		return hawser__reader_fail(reader, here, "loads[%d] has no effect: give it a per_length, or "
		                           "a force and at", i);
	if (any(one->force) && one->at == 0.0)
		return hawser__reader_fail(reader, here, "loads[%d] is a force without a point: give at, such "
		                           "as at: 30 %% or at: 12 m", i);
	if (any(one->force) && (one->from != 0.0 || one->to != 1.0 || one->to_length || one->wave != 0.0))
		return hawser__reader_fail(reader, here, "loads[%d]: from, to and wave are of a per_length: a "
		                           "force acts at one point, at", i);
	if (any(one->per_length) && one->at != 0.0)
		return hawser__reader_fail(reader, here, "loads[%d]: at is the point of a force: a per_length "
		                           "acts from and to", i);
	if (any(one->per_length) && one->from_length == one->to_length && one->from >= one->to)
		return hawser__reader_fail(reader, here, "loads[%d] acts from %g to %g: give the end nearer "
		                           "to A first", i, one->from, one->to);
	return HAWSER_OK;
}

enum hawser_status hawser__loads_check(struct hawser__reader *reader)
{
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < reader->scene->loads && !status; i++)
		status = piece(reader, &reader->scene->piece[i], i);
	return status;
}
