/* rom/file/read_range.c - the ranges of coordinates in a reduced-model file (law_range.c).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/energy/law.h"
#include "rom/file/read.h"

const char *const hawser__range_ends[] = {
	[HAWSER_RANGE_UNKNOWN] = "unknown", [HAWSER_RANGE_FORCE] = "force",
	[HAWSER_RANGE_AT_LEAST] = "at least", [HAWSER_RANGE_SLACK] = "slack", NULL};

static enum hawser_status read_end(const struct hawser__parser *reader, enum hawser_range_end *end,
                                   const json_t *value, const char *where)
{
	const char *word = json_string_value(value);

	for (int i = HAWSER_RANGE_FORCE; word && hawser__range_ends[i]; i++)
		if (strcmp(word, hawser__range_ends[i]) == 0) {
			*end = (enum hawser_range_end)i;
			return HAWSER_OK;
		}
	return hawser__wrong(reader, "%s.end is %s%.40s%s; \"force\", \"at least\" or \"slack\" is wanted",
	                     where, word ? "\"" : "", word ? word : "no text", word ? "\"" : "");
}

static enum hawser_status read_one(const struct hawser__parser *reader, struct hawser_rom *rom,
                                   json_t *object, const char *where)
{
	static const char *const keys[] = {"coordinate", "amplitude", "largest", "end", NULL};
	enum hawser_status status = hawser__read_keys(reader, object, keys, where);
	struct hawser_rom_range range;
	char place[48];
	int j = 0;

	snprintf(place, sizeof place, "%s.coordinate", where);
	if (!status)
		status = hawser__read_integer(reader, &j, json_object_get(object, "coordinate"), 0,
		                              rom->n - 1, place);
	if (!status)
		status = hawser__read_positive(reader, &range.amplitude, object, "amplitude", where);
	if (!status)
		status = hawser__read_positive(reader, &range.largest, object, "largest", where);
	if (!status)
		status = read_end(reader, &range.end, json_object_get(object, "end"), where);
	if (!status)
		rom->range[j] = range;
	return status;
}

enum hawser_status hawser__read_range(const struct hawser__parser *reader, struct hawser_rom *rom,
                                      const json_t *list)
{
	enum hawser_status status = HAWSER_OK;
	char where[32];

	if (!json_is_array(list))
		return hawser__wrong(reader, "range: a list of objects is wanted");
	rom->range = calloc((size_t)rom->n, sizeof *rom->range);
	if (!rom->range)
		return hawser__no_memory(reader->report, "rom");
	for (size_t i = 0; !status && i < json_array_size(list); i++) {
		snprintf(where, sizeof where, "range[%zu]", i);
		status = read_one(reader, rom, json_array_get(list, i), where);
	}
	return status;
}
