/* rom/file/parse.c - the JSON text of a reduced-model file, and its parameters.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <jansson.h>
#include <string.h>

#include "core/report.h"
#include "rom/file/read.h"

enum hawser_status hawser__rom_load(json_t **root, const char *text, size_t size, const char *name,
                                    struct hawser_report *report)
{
	const struct hawser__parser reader = {.name = name, .report = report};
	json_error_t error;

	*root = json_loadb(text, size, JSON_REJECT_DUPLICATES, &error);
	/* jansson reports a failed allocation as an error in the text; therefore the text is parsed
	 * again: an error is the same the second time */
	if (!*root)
		*root = json_loadb(text, size, JSON_REJECT_DUPLICATES, &error);
	if (!*root && error.line < 1 && !*error.text)
		return hawser__no_memory(report, "rom");
	if (!*root)
		return hawser__wrong(&reader, "line %d, column %d: %s (JSON)", error.line,
		                     error.column, error.text);
	return HAWSER_OK;
}

enum hawser_status hawser__rom_read(struct hawser_rom *rom, json_t *root, const char *name,
                                    const struct hawser_parameter *set, int sets,
                                    struct hawser_report *report)
{
	struct hawser_parameter parameter[HAWSER_PARAMETERS];
	struct hawser__parser reader = {.name = name, .report = report, .root = root};
	enum hawser_status status = hawser__read_parameters(&reader, parameter, root, set, sets);

	memset(rom, 0, sizeof *rom);
	if (!status)
		status = hawser__read_model(&reader, rom, root);
	if (status)
		hawser_rom_clear(rom);
	return status;
}

enum hawser_status hawser__rom_parse(struct hawser_rom *rom, const char *text, size_t size,
                                     const char *name, const struct hawser_parameter *set, int sets,
                                     struct hawser_report *report)
{
	json_t *root;
	enum hawser_status status = hawser__rom_load(&root, text, size, name, report);

	memset(rom, 0, sizeof *rom);
	if (!status)
		status = hawser__rom_read(rom, root, name, set, sets, report);
	json_decref(root);
	return status;
}

enum hawser_status hawser__parse_parameters(struct hawser_parameter *parameter, int *count,
                                            const char *text, size_t size, const char *name,
                                            struct hawser_report *report)
{
	struct hawser__parser reader = {.name = name, .report = report};
	json_t *root;
	enum hawser_status status = hawser__rom_load(&root, text, size, name, report);

	*count = 0;
	if (status)
		return status;
	status = hawser__read_parameters(&reader, parameter, root, NULL, 0);
	*count = reader.parameters;
	json_decref(root);
	return status;
}
