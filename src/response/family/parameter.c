/* response/family/parameter.c - models of a file over one or two of its named parameters; see
 * hawser/family.h. The first model stays to the end.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/family.h>

#include "core/append.h"
#include "core/report.h"
#include "rom/file/read.h"

#define MODELS 10 /* kept at the same time: the first, and those of the last calls */

struct family {
	struct hawser_rom_source source; /* its text is not owned */
	json_t *root;        /* of the text; NULL: not read yet, or a function of a library */
	const char *name[2]; /* the second one may be NULL */
	int next, count;
	double value[MODELS][2];
	struct hawser_rom rom[MODELS]; /* [count] */
};

/* The text is read once. */
static enum hawser_status own_model(struct hawser_rom *rom, struct family *family,
                                    struct hawser_report *report)
{
	const struct hawser_rom_source *from = &family->source;
	enum hawser_status status = HAWSER_OK;

	if (from->plugin)
		return hawser_rom_source_model(rom, from, report);
	if (!family->root)
		status = hawser__rom_load(&family->root, from->text, from->size, from->name, report);
	return status ? status : hawser__rom_read(rom, family->root, from->name, from->parameter,
	                                          from->parameters, report);
}

static enum hawser_status model_of_two(void *context, const struct hawser_rom **rom,
                                       const double p[2], struct hawser_report *report)
{
	struct family *family = context;
	int i = family->next, known;
	struct hawser_rom made;
	enum hawser_status status;

	for (int k = 0; k < family->count; k++)
		if (family->value[k][0] == p[0] && family->value[k][1] == p[1]) {
			*rom = &family->rom[k];
			return HAWSER_OK;
		}
	for (int k = 0; k < 2 && family->name[k]; k++)
		hawser_rom_source_set(&family->source, family->name[k], p[k], &known);
	status = own_model(&made, family, report);
	if (status)
		return status;
	hawser_rom_clear(&family->rom[i]);
	family->rom[i] = made;
	memcpy(family->value[i], p, sizeof family->value[i]);
	family->next = i%(MODELS - 1) + 1;
	family->count = family->count > i + 1 ? family->count : i + 1;
	*rom = &family->rom[i];
	return HAWSER_OK;
}

static enum hawser_status model(void *context, const struct hawser_rom **rom, double p,
                                struct hawser_report *report)
{
	return model_of_two(context, rom, (double[2]){p, 0.0}, report);
}

static void end(void *context)
{
	struct family *own = context;

	for (int i = 0; own && i < own->count; i++)
		hawser_rom_clear(&own->rom[i]);
	if (own) {
		json_decref(own->root);
		free(own->source.parameter);
	}
	free(own);
}

void hawser_parameter_close(struct hawser_rom_family *family)
{
	end(family->context);
	*family = (struct hawser_rom_family){0.0, NULL, NULL};
}

/* "eps, mu" */
static void list(char *text, size_t size, const struct hawser_rom_source *source)
{
	snprintf(text, size, "%s", source->parameters ? "" : "none");
	for (int i = 0; i < source->parameters; i++)
		hawser__append(text, size, ", ", "%s", source->parameter[i].name);
}

static enum hawser_status make(struct family **made, const struct hawser_rom_source *source,
                               const char *const name[2], struct hawser_report *report)
{
	struct family *own = calloc(1, sizeof *own);
	int known;
	char names[160];

	*made = own;
	if (!own)
		return hawser__no_memory(report, "frf");
	*own = (struct family){.source = *source, .name = {name[0], name[1]}};
	own->source.parameter = malloc(((size_t)source->parameters + 1)*sizeof *own->source.parameter);
	if (!own->source.parameter)
		return hawser__no_memory(report, "frf");
	for (int i = 0; i < source->parameters; i++)
		own->source.parameter[i] = source->parameter[i];
	for (int k = 0; k < 2 && name[k]; k++) {
		known = 0;
		hawser_rom_source_set(&own->source, name[k], 0.0, &known);
		if (known)
			continue;
		list(names, sizeof names, source);
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "%s has no parameter %.40s; its parameters are: %s", source->name, name[k],
		                    names);
	}
	return HAWSER_OK;
}

enum hawser_status hawser_parameter_open(struct hawser_rom_family *family,
                                         const struct hawser_rom_source *source, const char *name,
                                         double omega, struct hawser_report *report)
{
	struct family *own;
	enum hawser_status status = make(&own, source, (const char *[2]){name, NULL}, report);

	*family = (struct hawser_rom_family){omega, model, own};
	if (status)
		hawser_parameter_close(family);
	return status;
}

enum hawser_status hawser_parameter_plane_open(struct hawser_rom_plane *plane,
                                               const struct hawser_rom_source *source,
                                               const char *const name[2], double omega,
                                               struct hawser_report *report)
{
	struct family *own;
	enum hawser_status status = make(&own, source, name, report);

	*plane = (struct hawser_rom_plane){omega, model_of_two, own, end};
	if (status)
		hawser_plane_close(plane);
	return status;
}
