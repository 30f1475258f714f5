/* rom/file/open.c - the file of a reduced model, and its parts that convert coordinates to metres and
 * newtons: labels, scale, shapes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/terms/dampers.h"
#include "rom/build/model.h"
#include "rom/file/plug.h"
#include "rom/file/read.h"

enum hawser_status hawser__read_positive(const struct hawser__parser *reader, double *number,
                                         const json_t *object, const char *key, const char *where)
{
	char place[48];
	enum hawser_status status;

	snprintf(place, sizeof place, "%s.%s", where, key);
	status = hawser__read_number(reader, number, json_object_get(object, key), place);
	if (!status && !(*number > 0.0))
		return hawser__wrong(reader, "%s is %g; a positive number is wanted", place, *number);
	return status;
}

static enum hawser_status read_scale(const struct hawser__parser *reader, struct hawser_rom *rom,
                                     json_t *object)
{
	static const char *const keys[] = {"length", "time", "force", NULL};
	enum hawser_status status = hawser__read_keys(reader, object, keys, "scale");

	if (!status)
		status = hawser__read_positive(reader, &rom->length, object, "length", "scale");
	if (!status)
		status = hawser__read_positive(reader, &rom->time, object, "time", "scale");
	if (!status)
		status = hawser__read_positive(reader, &rom->force, object, "force", "scale");
	rom->scaled = !status;
	return status;
}

/* The contribution of condensed modes; both members or none. */
static enum hawser_status read_second(const struct hawser__parser *reader, struct hawser_rom *rom,
                                      json_t *object)
{
	const size_t n = (size_t)rom->n, points = (size_t)rom->shapes.points;
	const size_t shape[3] = {n*(n + 1)/2, points, 3};
	enum hawser_status status = hawser__rom_init_second(rom, reader->report);

	if (!status)
		status = hawser__read_array(reader, rom->shapes.second_shape,
		                            json_object_get(object, "second_shape"), shape, 3,
		                            "shapes.second_shape");
	if (!status)
		status = hawser__read_array(reader, rom->shapes.second_slope,
		                            json_object_get(object, "second_slope"), shape, 3,
		                            "shapes.second_slope");
	return status;
}

static enum hawser_status read_mach2(const struct hawser__parser *reader, struct hawser_rom *rom,
                                     const json_t *object)
{
	double *m = &rom->shapes.mach2;
	enum hawser_status status = hawser__read_number(reader, m, json_object_get(object, "mach2"),
	                                                "shapes.mach2");

	if (!status && !(*m >= 0.0 && *m < 1.0))
		return hawser__wrong(reader, "shapes.mach2 is %g; a number from 0 to below 1 is wanted",
		                     *m);
	return status;
}

/* The axes of the cable's plane: three orthogonal unit vectors. */
static enum hawser_status read_axes(const struct hawser__parser *reader,
                                    struct hawser_rom_shapes *shapes, const json_t *object)
{
	static const size_t shape[2] = {3, 3};
	static const double round_off = 1e-9;
	enum hawser_status status = hawser__read_array(reader, shapes->axes[0],
	                                               json_object_get(object, "axes"), shape, 2,
	                                               "shapes.axes");

	shapes->turned = 1;
	for (int i = 0; !status && i < 9; i++) {
		const double *a = shapes->axes[i/3], *b = shapes->axes[i%3];
		double product = a[0]*b[0] + a[1]*b[1] + a[2]*b[2];

		if (!(fabs(product - (i/3 == i%3 ? 1.0 : 0.0)) <= round_off))
			return hawser__wrong(reader, "shapes.axes: three orthogonal vectors of length 1 are "
			                     "wanted, the product of %d and %d is %g", i/3 + 1, i%3 + 1, product);
	}
	return status;
}

static enum hawser_status read_shapes(const struct hawser__parser *reader, struct hawser_rom *rom,
                                      json_t *object)
{
	static const char *const keys[] = {"names", "s", "tangent", "axes", "stretch", "shape", "slope",
	                                   "EA", "mach2", "second_shape", "second_slope", NULL};
	const json_t *names = json_object_get(object, "names");
	const size_t points = json_array_size(names), n = (size_t)rom->n;
	const struct hawser_rom_shapes *to = &rom->shapes;
	enum hawser_status status = hawser__read_keys(reader, object, keys, "shapes");

	if (status)
		return status;
	if (points < 1 || points > 1000000)
		return hawser__wrong(reader, "shapes.names: a list of one name or more is wanted");
	status = hawser__rom_init_shapes(rom, (int)points, reader->report);
	if (!status)
		status = hawser__read_words(reader, to->name, names, points, "shapes.names");
	const struct {
		const char *key, *where;
		double *out;
		size_t shape[3];
		int rank;
	} part[] = {
		{"s", "shapes.s", to->s, {points}, 1},
		{"tangent", "shapes.tangent", to->tangent, {points, 2}, 2},
		{"stretch", "shapes.stretch", to->stretch, {points}, 1},
		{"shape", "shapes.shape", to->shape, {n, points, 3}, 3},
		{"slope", "shapes.slope", to->slope, {n, points, 3}, 3},
	};

	for (size_t i = 0; !status && i < sizeof part/sizeof *part; i++)
		status = hawser__read_array(reader, part[i].out, json_object_get(object, part[i].key),
		                            part[i].shape, part[i].rank, part[i].where);
	if (!status)
		status = hawser__read_positive(reader, &rom->shapes.EA, object, "EA", "shapes");
	if (!status && json_object_get(object, "axes"))
		status = read_axes(reader, &rom->shapes, object);
	if (!status && json_object_get(object, "mach2"))
		status = read_mach2(reader, rom, object);
	if (!status && (json_object_get(object, "second_shape") ||
	                json_object_get(object, "second_slope")))
		status = read_second(reader, rom, object);
	return status;
}

/* The `answer` of one force, [orders][points][4], if the object has it. */
static enum hawser_status read_answer(const struct hawser__parser *reader, double **answer,
                                      const struct hawser_rom *rom, const json_t *object, int orders,
                                      const char *where)
{
	const size_t points = (size_t)rom->shapes.points;
	const size_t shape[3] = {(size_t)orders, points, 4};
	const json_t *value = json_object_get(object, "answer");
	char place[48];

	if (!value)
		return HAWSER_OK;
	snprintf(place, sizeof place, "%s.answer", where);
	if (points == 0)
		return hawser__wrong(reader, "%s: there are no shapes that say at which points", place);
	*answer = malloc((size_t)orders*points*4*sizeof **answer);
	if (!*answer)
		return hawser__no_memory(reader->report, "rom");
	return hawser__read_array(reader, *answer, value, orders > 1 ? shape : shape + 1,
	                          orders > 1 ? 3 : 2, place);
}

/* Those of the harmonics and of the ramp, after the points have been read. */
static enum hawser_status read_answers(const struct hawser__parser *reader, struct hawser_rom *rom,
                                       const json_t *root)
{
	const json_t *list = json_object_get(root, "harmonics"), *ramp = json_object_get(root, "ramp");
	enum hawser_status status = HAWSER_OK;
	char where[32];

	for (int h = 0; !status && h < rom->harmonics; h++) {
		snprintf(where, sizeof where, "harmonics[%d]", h);
		status = read_answer(reader, &rom->harmonic[h].answer, rom,
		                     json_array_get(list, (size_t)h), 2, where);
	}
	for (int p = 0; !status && rom->ramp && p < HAWSER_RAMP_TERMS; p++) {
		snprintf(where, sizeof where, "ramp.%s", hawser__ramp_names[p]);
		status = read_answer(reader, &rom->ramp->term[p].answer, rom,
		                     json_object_get(ramp, hawser__ramp_names[p]), 1, where);
	}
	return status;
}

enum hawser_status hawser__read_extras(const struct hawser__parser *reader, struct hawser_rom *rom,
                                       const json_t *root)
{
	const json_t *labels = json_object_get(root, "labels");
	json_t *scale = json_object_get(root, "scale"), *shapes = json_object_get(root, "shapes");
	enum hawser_status status = HAWSER_OK;

	if (labels && !(rom->label = calloc((size_t)rom->n, sizeof *rom->label)))
		return hawser__no_memory(reader->report, "rom");
	if (labels)
		status = hawser__read_words(reader, rom->label, labels, (size_t)rom->n, "labels");
	if (!status && scale)
		status = read_scale(reader, rom, scale);
	if (!status && shapes)
		status = read_shapes(reader, rom, shapes);
	if (!status)
		status = read_answers(reader, rom, root);
	if (!status && json_object_get(root, "ends"))
		status = hawser__read_ends(reader, rom, json_object_get(root, "ends"));
	if (!status && json_object_get(root, "contacts"))
		status = hawser__read_contacts(reader, rom, json_object_get(root, "contacts"));
	if (!status && json_object_get(root, "range"))
		status = hawser__read_range(reader, rom, json_object_get(root, "range"));
	return status ? status : hawser__read_known(reader, rom, root);
}

/* --- the file --- */

enum hawser_status hawser_rom_source_of(struct hawser_rom_source *source,
                                        const struct hawser_document *from,
                                        struct hawser_report *report)
{
	struct hawser_parameter parameter[HAWSER_PARAMETERS];
	enum hawser_status status = HAWSER_OK;
	int count = 0;

	*source = (struct hawser_rom_source){.name = strdup(from->name), .size = from->length,
	                                     .text = malloc(from->length + 1)};
	if (source->text)
		memcpy(source->text, from->text, from->length);
	if (!source->name || !source->text)
		status = hawser__no_memory(report, "rom");
	if (!status && memmem(source->text, source->size, "\"parameters\"", 12))
		status = hawser__parse_parameters(parameter, &count, source->text, source->size, source->name,
		                                  report);
	if (!status && count > 0) {
		source->parameter = malloc((size_t)count*sizeof *parameter);
		source->parameters = count;
		if (source->parameter)
			memcpy(source->parameter, parameter, (size_t)count*sizeof *parameter);
		else
			status = hawser__no_memory(report, "rom");
	}
	if (status)
		hawser_rom_source_clear(source);
	return status;
}

enum hawser_status hawser_rom_source_open(struct hawser_rom_source *source, const char *path,
                                          struct hawser_report *report)
{
	struct hawser_document from;
	enum hawser_status status = hawser_document_open(&from, path, report);

	*source = (struct hawser_rom_source){.text = NULL};
	if (!status)
		status = hawser_rom_source_of(source, &from, report);
	hawser_document_clear(&from);
	return status;
}

void hawser_rom_source_set(struct hawser_rom_source *source, const char *name, double value, int *known)
{
	*known = 0;
	for (int i = 0; i < source->parameters; i++)
		if (!strcmp(source->parameter[i].name, name)) {
			source->parameter[i].value = value;
			source->parameter[i].set = *known = 1;
		}
}

enum hawser_status hawser_rom_source_model(struct hawser_rom *rom,
                                           const struct hawser_rom_source *source,
                                           struct hawser_report *report)
{
	if (source->plugin)
		return hawser__plug_make(rom, source, report);
	return hawser__rom_parse(rom, source->text, source->size, source->name, source->parameter,
	                         source->parameters, report);
}

void hawser_rom_source_clear(struct hawser_rom_source *source)
{
	if (!source)
		return;
	free(source->text);
	free(source->name);
	free(source->parameter);
	*source = (struct hawser_rom_source){.text = NULL};
}

enum hawser_status hawser_rom_open(struct hawser_rom *rom, const char *path,
                                   struct hawser_report *report)
{
	struct hawser_rom_source source;
	enum hawser_status status = hawser_rom_source_open(&source, path, report);

	memset(rom, 0, sizeof *rom);
	if (!status)
		status = hawser_rom_source_model(rom, &source, report);
	hawser_rom_source_clear(&source);
	return status;
}
