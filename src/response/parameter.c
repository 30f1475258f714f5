/* response/parameter.c - models of a file over one of its named parameters; see hawser/family.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdio.h>
#include <stdlib.h>

#include <hawser/family.h>

#include "core/report.h"

#define MODELS 8 /* kept at the same time: those of the last calls */

struct family {
	struct hawser_rom_source source; /* its text is not owned */
	const char *name;
	int next, count;
	double value[MODELS];
	struct hawser_rom rom[MODELS]; /* [count] */
};

static enum hawser_status model(void *context, const struct hawser_rom **rom, double p,
                                struct hawser_report *report)
{
	struct family *family = context;
	int i = family->next, known;
	struct hawser_rom made;
	enum hawser_status status;

	for (int k = 0; k < family->count; k++)
		if (family->value[k] == p) {
			*rom = &family->rom[k];
			return HAWSER_OK;
		}
	hawser_rom_source_set(&family->source, family->name, p, &known);
	if ((status = hawser_rom_source_model(&made, &family->source, report)))
		return status;
	hawser_rom_clear(&family->rom[i]);
	family->rom[i] = made;
	family->value[i] = p;
	family->next = (i + 1)%MODELS;
	family->count = family->count > i + 1 ? family->count : i + 1;
	*rom = &family->rom[i];
	return HAWSER_OK;
}

void hawser_parameter_close(struct hawser_rom_family *family)
{
	struct family *own = family->context;

	for (int i = 0; own && i < own->count; i++)
		hawser_rom_clear(&own->rom[i]);
	if (own)
		free(own->source.parameter);
	free(own);
	*family = (struct hawser_rom_family){0.0, NULL, NULL};
}

/* "eps, mu" */
static void list(char *text, size_t size, const struct hawser_rom_source *source)
{
	size_t used = 0;

	snprintf(text, size, "none");
	for (int i = 0; i < source->parameters && used < size; i++)
		used += (size_t)snprintf(text + used, size - used, "%s%s", i ? ", " : "",
		                         source->parameter[i].name);
}

enum hawser_status hawser_parameter_open(struct hawser_rom_family *family,
                                         const struct hawser_rom_source *source, const char *name,
                                         double omega, struct hawser_report *report)
{
	struct family *own = calloc(1, sizeof *own);
	int known = 0;
	char names[160];

	*family = (struct hawser_rom_family){omega, model, own};
	if (!own)
		return hawser__no_memory(report, "frf");
	own->source = *source;
	own->name = name;
	own->source.parameter = malloc(((size_t)source->parameters + 1)*sizeof *own->source.parameter);
	if (!own->source.parameter) {
		hawser_parameter_close(family);
		/* cppcheck-suppress memleak ; freed as the context of the family */
		return hawser__no_memory(report, "frf");
	}
	for (int i = 0; i < source->parameters; i++)
		own->source.parameter[i] = source->parameter[i];
	hawser_rom_source_set(&own->source, name, 0.0, &known);
	if (known)
		return HAWSER_OK;
	hawser_parameter_close(family);
	list(names, sizeof names, source);
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
	                    "%s has no parameter %.40s; its parameters are: %s", source->name, name, names);
}
