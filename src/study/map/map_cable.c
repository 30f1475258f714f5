/* study/map/map_cable.c - the field of a scene or a model over two of its parameters.
 *
 * Parameters affect different stages of the computation: Omega and the factors only the last one,
 * the damping of a scene the matrix D of a linear model, its load the model that is made from the
 * modes, and all others statics and modes. What depends on neither parameter is computed once. What
 * depends on one of them is stored for each of its values, of which a map has few.
 *
 *    structure   statics and modes at one value of a parameter; also the model, if no parameter of the
 *                map changes it further
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/append.h"
#include "core/report.h"
#include "response/floquet/linear_margin.h"
#include "rom/terms/load.h"
#include "rom/condense/support.h"
#include "rom/terms/terms.h"
#include "study/map/map.h"
#include "study/map/map_cable.h"
#include "study/map/map_rows.h"

int hawser__map_cable_cheap(const void *context)
{
	const struct hawser__map_cable *cable = context;

	return cable->varies == 0 ? 2 : cable->varies == 1 ? 1 : 0;
}

enum { COLUMNS = 3 }; /* of maps whose models are cheap; chosen */
enum { LISTED = 8 }; /* coordinates of a full-order model whose tongues are searched, the slowest;
                      * chosen */

/* --- opening --- */

static int is_parameter(const struct hawser_rom_source *file, const char *name)
{
	for (int i = 0; file && i < file->parameters; i++)
		if (strcmp(file->parameter[i].name, name) == 0)
			return 1;
	return 0;
}

void hawser__map_cable_file(struct hawser_rom_source *to, struct hawser_parameter *parameter,
                            const struct hawser__map_cable *cable, const double at[2])
{
	const struct hawser_rom_source *file = cable->source.file;
	int known;

	*to = *file;
	to->parameter = memcpy(parameter, file->parameter,
	                       (size_t)file->parameters*sizeof *file->parameter);
	for (int k = 0; k < 2; k++)
		if (cable->reach[k] == HAWSER__REACH_PARAMETER)
			hawser_rom_source_set(to, cable->source.key[k], at[k], &known);
}

static enum hawser_status refuse_key(const struct hawser_map_source *source, const char *key,
                                     struct hawser_report *report)
{
	char names[160] = "";

	for (int i = 0; source->file && i < source->file->parameters; i++)
		hawser__append(names, sizeof names, ", ", "%s",
		               source->file->parameter[i].name);
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
	                    "%.60s: the keys of nets, ropeways and reduced models are Omega, factor.load, "
	                    "factor.damping and the parameters of a model's file%s%s", key,
	                    *names ? ", here " : "", names);
}

static enum hawser_status reach_of(enum hawser__reach *reach,
                                   const struct hawser_map_source *source, int k,
                                   struct hawser_report *report)
{
	const char *key = source->key[k];
	struct hawser_held held[2];
	double unused;

	if (strcmp(key, "Omega") == 0)
		*reach = HAWSER__REACH_OMEGA;
	else if (strcmp(key, "factor.load") == 0)
		*reach = HAWSER__REACH_LOAD;
	else if (strcmp(key, "factor.damping") == 0)
		*reach = HAWSER__REACH_DAMPING;
	else if (is_parameter(source->file, key))
		*reach = HAWSER__REACH_PARAMETER;
	else if (source->rom)
		return refuse_key(source, key, report);
	else if (strncmp(key, "damping.", 8) == 0)
		/* with point masses the damping is not diagonal, and dampers add coordinates */
		*reach = source->scene->attachments > 0 || hawser_statics_held(held, source->scene)
		         ? HAWSER__REACH_STRUCTURE : HAWSER__REACH_RATES;
	else if ((strncmp(key, "load.", 5) == 0 && strncmp(key, "load.static.", 12) != 0) ||
	         strncmp(key, "loads.", 6) == 0 ||
	         (strncmp(key, "support.", 8) == 0 && !strstr(key, ".stiffness") && !strstr(key, ".mass")))
		*reach = HAWSER__REACH_MODEL;
	else
		*reach = HAWSER__REACH_STRUCTURE;
	return *reach < HAWSER__REACH_RATES ? HAWSER_OK
	       : hawser_scene_get(source->scene, &unused, key, report);
}

/* Whether something moves the model somewhere in the plane: a load, ends, a fluctuating speed. */
static int driven(const struct hawser_map_source *source)
{
	static const char *const moving[] = {"load.", "loads.", "support.", "travel.fluctuation"};
	int any = source->rom ? hawser_rom_loaded(source->rom)
	          : hawser__loaded(source->scene) || hawser__support_moves(source->scene) ||
	            source->scene->travel.fluctuation > 0.0;

	for (int k = 0; k < 2; k++)
		any |= is_parameter(source->file, source->key[k]) && source->rom->harmonics > 0;
	for (int k = 0; k < 2 && source->scene; k++)
		for (size_t i = 0; i < sizeof moving/sizeof *moving; i++)
			any |= strncmp(source->key[k], moving[i], strlen(moving[i])) == 0;
	return any;
}

static enum hawser_status check(struct hawser__map_cable *cable, struct hawser_report *report)
{
	const struct hawser_map_source *source = &cable->source;
	const char *name = source->quantity;
	enum hawser_status status = HAWSER_OK;
	int excited = 0;

	cable->quantity = hawser__map_quantity(name);
	if (!cable->quantity || !cable->quantity->measure)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "there is no quantity \"%.40s\": write growth, multiplier, unstable "
		                    "or amplitude", name);
	for (int k = 0; k < 2 && !status; k++)
		status = reach_of(&cable->reach[k], source, k, report);
	if (status)
		return status;
	excited = source->omega > 0.0 || hawser__map_omega_is_axis(cable);
	cable->moves = cable->quantity->resonant && excited && !source->rest && driven(source);
	if (strcmp(source->key[0], source->key[1]) == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map", "both axes are %s: give --y another "
		                    "key", source->key[0]);
	if (cable->quantity->about.needs_omega && !excited)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "the quantity %s needs a forcing frequency: give Omega, or make it an "
		                    "axis", name);
	if (cable->quantity->about.nonlinear &&
	    (cable->reach[0] == HAWSER__REACH_DAMPING || cable->reach[1] == HAWSER__REACH_DAMPING))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "factor.damping is for linear quantities: for the %s give a key of "
		                    "the scene's damping", name);
	if (source->scene && source->scene->model.energy == HAWSER_ENERGY_EXACT &&
	    cable->quantity->resonant && excited && !cable->moves)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "the quantity %s about rest is not that of the full-order model "
		                    "(model.energy: exact), which is not excited there: leave --rest out, "
		                    "or set model.energy=quartic", name);
	if (source->scene && source->scene->model.modes == HAWSER_MODES_AUTO)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "model.modes: auto chooses for one response, not for a map: give a "
		                    "number of modes");
	return HAWSER_OK;
}

static enum hawser_status describe(struct hawser__map_cable *cable, struct hawser_report *report)
{
	const struct hawser_map_source *source = &cable->source;
	enum hawser_status status = HAWSER_OK;
	char *model = NULL, *text = NULL;
	size_t size = 0;
	FILE *stream;

	if (source->rom && !source->rom->plug && (status = hawser_rom_text(source->rom, &model, report)))
		return status;
	stream = open_memstream(&text, &size);
	if (!stream) {
		free(model);
		return hawser__no_memory(report, "map");
	}
	fprintf(stream, "hawser %s, %s%s over %s and %s, Omega %a, waves %d\n%s", hawser_version(),
	        source->quantity, cable->moves ? " of the response" : "", source->key[0],
	        source->key[1], source->omega, source->waves, model ? model : "");
	if (source->start)
		fprintf(stream, "from %a %a\n", source->start->at[0], source->start->at[1]);
	for (int i = 0; source->start && i < 2*source->start->coordinates; i++)
		fprintf(stream, "%a\n", source->start->state[i]);
	if (source->scene)
		status = hawser_scene_write(source->scene, stream, report);
	for (int i = 0; source->rom && source->rom->plug && i < source->file->parameters; i++)
		fprintf(stream, "%s %a\n", source->file->parameter[i].name, source->file->parameter[i].value);
	/* when memory is short, glibc's fclose returns 0 but sets no text */
	if ((fclose(stream) != 0 || !text) && !status)
		status = hawser__no_memory(report, "map");
	free(model);
	cable->identity = text;
	return status;
}

/* if no parameter changes the structure, there is one, and its failure is that of the map */
static enum hawser_status first_structure(struct hawser__map_cable *cable, struct hawser_report *report)
{
	const double none[2] = {0.0, 0.0};

	if (cable->source.rom || cable->varies >= 0)
		return HAWSER_OK;
	cable->kept = calloc(1, sizeof *cable->kept);
	if (!cable->kept)
		return hawser__no_memory(report, "map");
	cable->count = cable->room = 1;
	hawser__structure_build(cable->kept, cable, none);
	if (cable->kept->status && report)
		*report = cable->kept->report;
	return cable->kept->status;
}

static void set_marks(struct hawser_map_field *field, struct hawser__map_cable *cable)
{
	const struct hawser_map_source *source = &cable->source;
	int excited = source->omega > 0.0 || hawser__map_omega_is_axis(cable);

	if (!cable->quantity->about.nonlinear) {
		field->margins = 1;
		field->marks = HAWSER__MARGINS;
	}
	if (!cable->quantity->resonant || !excited || strcmp(source->key[0], "model.modes") == 0 ||
	    strcmp(source->key[1], "model.modes") == 0)
		return;
	cable->n = source->rom ? source->rom->n
	           : source->waves > 0 ? source->waves
	           : source->scene->model.energy == HAWSER_ENERGY_EXACT ? LISTED
	           : source->scene->model.modes;
	field->marks = HAWSER__MARGINS + HAWSER__EXPONENTS(cable->n);
	field->exponents = cable->n;
}

enum hawser_status hawser_map_cable_open(struct hawser_map_field *field,
                                         const struct hawser_map_source *source,
                                         struct hawser_report *report)
{
	struct hawser__map_cable *cable = calloc(1, sizeof *cable);
	enum hawser__reach other;
	enum hawser_status status;

	*field = (struct hawser_map_field){.name = source->quantity};
	if (!cable)
		return hawser__no_memory(report, "map");
	cable->source = *source;
	status = check(cable, report);
	for (int k = 0; k < 2 && !status && source->rom; k++)
		if (cable->reach[k] == HAWSER__REACH_LOAD && source->rom->plug &&
		    source->from[k] != source->to[k]) /* of a basin they are equal */
			status = hawser__more_refuse(source->rom, "a factor of load or damping", report);
	if (!status && source->rom && !cable->quantity->about.nonlinear)
		status = hawser__more_refuse(source->rom, "a map or the stability of rest", report);
	if (!status && source->rom)
		status = hawser__periods_refuse(source->rom, "a map or the stability of rest", report);
	if (!status) {
		int x = cable->reach[0] == HAWSER__REACH_STRUCTURE;
		int y = cable->reach[1] == HAWSER__REACH_STRUCTURE;

		cable->varies = x && y ? 2 : x ? 0 : y ? 1 : -1;
		cable->damps = cable->reach[0] == HAWSER__REACH_RATES ||
		               cable->reach[1] == HAWSER__REACH_RATES;
		cable->models = cable->reach[0] == HAWSER__REACH_MODEL ||
		                cable->reach[1] == HAWSER__REACH_MODEL ||
		                (hawser__map_cable_whole(cable) && cable->damps);
		cable->damps = cable->damps && !cable->models;
		status = describe(cable, report);
	}
	if (!status)
		status = first_structure(cable, report);
	*field = (struct hawser_map_field){.name = source->quantity, .context = cable,
		.identity = cable->identity, .open = hawser__map_worker_open,
		.close = hawser__map_worker_close,
		.prepare = hawser__map_prepare, .point = hawser__map_worker_point};
	if (status) {
		hawser_map_cable_close(field);
		return status;
	}
	field->threshold = cable->quantity->threshold;
	field->responds = cable->moves;
	field->logarithmic = cable->quantity->about.logarithmic;
	field->condensed = &cable->condensed;
	set_marks(field, cable);
	cable->marks = field->marks;
	if (cable->quantity->about.nonlinear) {
		field->row = hawser__map_worker_row;
		field->along = hawser__map_row_along(cable);
		field->start = source->start;
		other = cable->reach[1 - field->along];
		field->columns = other == HAWSER__REACH_LOAD || other == HAWSER__REACH_PARAMETER ? COLUMNS : 0;
	}
	return HAWSER_OK;
}

void hawser_map_cable_close(struct hawser_map_field *field)
{
	struct hawser__map_cable *cable = field ? field->context : NULL;

	if (!cable)
		return;
	for (size_t c = 0; c < cable->count; c++)
		hawser__structure_clear(&cable->kept[c]);
	free(cable->kept);
	hawser__map_guides_free(cable->guides);
	free(cable->identity);
	free(cable);
	*field = (struct hawser_map_field){.name = NULL};
}
