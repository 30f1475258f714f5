/* study/map/map_structure.c - statics and modes along the parameters of a map: computed where they
 * change, and stored.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/gyroscopic.h>

#include "core/order.h"
#include "core/report.h"
#include "core/share.h"
#include "rom/condense/answer.h"
#include "rom/terms/drag.h"
#include "study/map/map_cable.h"

enum { MOST_KEPT = 1024 }; /* largest number of stored structures; chosen to limit memory */

/* condensed modes up to this multiple of the highest kept frequency have their own response to the
 * load, as in study/accuracy/fidelity.c */
static const double known_to = 4.0;

void hawser__structure_clear(struct hawser__structure *structure)
{
	hawser_modes_clear(&structure->modes);
	hawser_rom_clear(&structure->rom);
}

enum hawser_status hawser__map_cable_axes(struct hawser_scene *scene,
                                          const struct hawser__map_cable *cable,
                                          const double at[2], enum hawser__reach least,
                                   struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	*scene = *cable->source.scene;
	for (int k = 0; k < 2 && !status; k++)
		if (cable->reach[k] >= least)
			status = hawser_scene_set(scene, cable->source.key[k], at[k], report);
	return status;
}

/* The inertia of what follows, where the program chose what moves. About rest what follows is
 * quasi-static by definition, as in models of modes. */
static enum hawser_status lag(struct hawser_rom *rom, const struct hawser__map_cable *cable,
                              const struct hawser_modes *modes, const struct hawser_scene *scene,
                              struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	if (cable->source.waves > 0 && cable->source.swapped != hawser__map_cable_whole(cable) &&
	    scene->model.condense == HAWSER_CONDENSE_STATIC)
		status = hawser__rom_travel_lag(rom, modes, report);
	if (status)
		hawser_rom_clear(rom);
	return status;
}

enum hawser_status hawser__map_cable_model(struct hawser_rom *rom,
                                           const struct hawser__map_cable *cable,
                                           const struct hawser_modes *modes,
                                     const struct hawser_scene *scene, struct hawser_report *report)
{
	enum hawser_status status;

	if (hawser__map_cable_whole(cable) && scene->damping.drag > 0.0)
		return hawser__drag_refuse(NULL, "a map of responses", report);
	if (!hawser__map_cable_whole(cable)) {
		status = hawser_rom_build_linear(rom, modes, scene, report);
		return status ? status : lag(rom, cable, modes, scene, report);
	}
	if (scene->model.energy == HAWSER_ENERGY_EXACT)
		return hawser_rom_build_full(rom, &modes->statics, scene, scene->model.basis, report);
	status = hawser_rom_build(rom, modes, scene, report);
	if (!status)
		status = lag(rom, cable, modes, scene, report);
	if (!status && cable->quantity->about.nonlinear)
		status = hawser_rom_know_below(rom, modes, scene,
		                               known_to*modes->mode[modes->n - 1].omega, report);
	if (status)
		hawser_rom_clear(rom);
	return status;
}

static enum hawser_status solve(struct hawser__structure *to, const struct hawser__map_cable *cable,
                                const struct hawser_scene *scene, struct hawser_report *report)
{
	struct hawser_modes_options options = {.n = scene->model.modes, .basis = scene->model.basis};
	struct hawser_statics statics;
	enum hawser_status status = hawser_statics_scene(&statics, scene, report);

	if (hawser_scene_written(scene, "model.tolerance"))
		options.tolerance = scene->model.tolerance;
	if (status)
		return status;
	if (hawser__map_cable_whole(cable) && scene->model.energy == HAWSER_ENERGY_EXACT)
		to->modes.statics = statics; /* such a model needs nothing else */
	else if (cable->source.waves > 0)
		status = hawser_complex_modes_span(&to->modes, &statics,
		                                   &(struct hawser_modes_options){.n = cable->source.waves},
		                                   report);
	else
		status = hawser_modes_solve(&to->modes, &statics, &options, report);
	if (!status && !cable->models)
		status = hawser__map_cable_model(&to->rom, cable, &to->modes, scene, report);
	if (!status && !cable->models && !cable->damps)
		hawser_modes_clear(&to->modes);
	return status;
}

void hawser__structure_build(struct hawser__structure *to, const struct hawser__map_cable *cable,
                             const double at[2])
{
	struct hawser_scene scene;

	memset(to, 0, sizeof *to);
	to->status = hawser__map_cable_axes(&scene, cable, at, HAWSER__REACH_STRUCTURE, &to->report);
	if (!to->status)
		to->status = solve(to, cable, &scene, &to->report);
}

struct hawser__structure *hawser__structure_find(const struct hawser__map_cable *cable, double value)
{
	size_t low = 0, high = cable->count;

	while (low < high) {
		size_t middle = (low + high)/2;

		if (cable->kept[middle].value < value)
			low = middle + 1;
		else
			high = middle;
	}
	return low < cable->count && cable->kept[low].value == value ? &cable->kept[low] : NULL;
}

/* Remove structures that the present preparation does not need, if too many are stored. */
static void drop(struct hawser__map_cable *cable)
{
	size_t kept = 0;

	if (cable->count <= MOST_KEPT)
		return;
	for (size_t c = 0; c < cable->count; c++)
		if (cable->kept[c].used)
			cable->kept[kept++] = cable->kept[c];
		else
			hawser__structure_clear(&cable->kept[c]);
	cable->count = kept;
}

/* Moves the values that are not stored to the front of the ascending distinct values [count]. */
static size_t missing(struct hawser__map_cable *cable, double *value, size_t count)
{
	double before = 0.0;
	size_t fresh = 0;

	for (size_t c = 0; c < cable->count; c++)
		cable->kept[c].used = 0;
	for (size_t i = 0; i < count; i++) {
		struct hawser__structure *here;

		if (i > 0 && value[i] == before)
			continue;
		before = value[i];
		here = hawser__structure_find(cable, before);
		if (here)
			here->used = 1;
		else
			value[fresh++] = before;
	}
	return fresh;
}

static enum hawser_status fatal(const struct hawser__structure *list, size_t count,
                                struct hawser_report *report)
{
	for (size_t c = 0; c < count; c++)
		if (hawser_status_exit(list[c].status) == hawser_status_exit(HAWSER_ERR_MEMORY)) {
			if (report)
				*report = list[c].report;
			return list[c].status;
		}
	return HAWSER_OK;
}

struct building {
	struct hawser__map_cable *cable;
	struct hawser__structure *added;
	const double *value;
};

static void build(void *context, long i, int worker)
{
	const struct building *building = context;
	const double at[2] = {building->value[i], building->value[i]};

	(void)worker;
	hawser__structure_build(&building->added[i], building->cable, at);
	building->added[i].value = building->value[i];
	building->added[i].used = 1;
}

static enum hawser_status add_structures(struct hawser__map_cable *cable, const double *value,
                                         size_t fresh, int threads, struct hawser_report *report)
{
	size_t need = cable->count + fresh;
	struct hawser__structure *added;
	enum hawser_status status;

	if (need > cable->room) {
		struct hawser__structure *larger = realloc(cable->kept, need*sizeof *larger);

		if (!larger)
			return hawser__no_memory(report, "map");
		cable->kept = larger;
		cable->room = need;
	}
	added = cable->kept + cable->count;
	hawser__share((long)fresh, threads, build, &(struct building){cable, added, value});
	cable->count = need;
	status = fatal(added, fresh, report);
	qsort(cable->kept, cable->count, sizeof *cable->kept, hawser__ascending);
	return status;
}

enum hawser_status hawser__structure_prepare(void *context, const double *x, const double *y, int count,
                                  int threads, struct hawser_report *report)
{
	struct hawser__map_cable *cable = context;
	enum hawser_status status = HAWSER_OK;
	double *value;
	size_t fresh;

	if (cable->varies != 0 && cable->varies != 1)
		return HAWSER_OK;
	value = malloc((size_t)count*sizeof *value);
	if (!value)
		return hawser__no_memory(report, "map");
	memcpy(value, cable->varies == 0 ? x : y, (size_t)count*sizeof *value);
	qsort(value, (size_t)count, sizeof *value, hawser__ascending);
	fresh = missing(cable, value, (size_t)count);
	drop(cable);
	if (fresh > 0)
		status = add_structures(cable, value, fresh, threads, report);
	free(value);
	return status;
}
