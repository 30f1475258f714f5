/* scene/events.c - the subset of YAML that a scene uses: mappings, lists, scalars. Anchors, aliases
 * and tags are rejected, so that a value depends on its own line only and aliases cannot expand
 * exponentially. The code reads libyaml's events and not its document tree: each event has a line
 * and a column.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/report.h"
#include "scene/reader.h"

enum hawser_status hawser__reader_fail(struct hawser__reader *reader,
                                       const struct hawser__mark *place, const char *format,
                                       ...)
{
	char text[512], shown[HAWSER__SHOWN];
	va_list args;

	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	if (place->set)
		return hawser__fail(reader->report, HAWSER_ERR_SCENE, "scene", "--set %s: %s",
		                    hawser__shown(shown, place->set), text);
	if (!place->line)
		return hawser__fail(reader->report, HAWSER_ERR_SCENE, "scene", "%s: %s",
		                    reader->name, text);
	return hawser__fail(reader->report, HAWSER_ERR_SCENE, "scene", "%s:%zu:%zu: %s",
	                    reader->name, place->line, place->column, text);
}

const char *hawser__mark_text(char *text, size_t size, const struct hawser__mark *mark)
{
	if (mark->set)
		snprintf(text, size, "in the same override");
	else
		snprintf(text, size, "in line %zu", mark->line);
	return text;
}

static struct hawser__mark at(const struct hawser__reader *reader, const yaml_mark_t *mark)
{
	return (struct hawser__mark){.pass = reader->pass,
	                             .set = reader->set,
	                             .line = mark->line + 1,
	                             .column = mark->column + 1};
}

struct hawser__mark hawser__event_place(const struct hawser__reader *reader,
                                        const yaml_event_t *event)
{
	return at(reader, &event->start_mark);
}

/* Report a syntax error found by libyaml. */
static enum hawser_status broken(struct hawser__reader *reader)
{
	const yaml_parser_t *yaml = reader->yaml;
	const char *problem = yaml->problem ? yaml->problem : "unreadable";
	struct hawser__mark place = at(reader, &yaml->problem_mark);

	if (yaml->error == YAML_MEMORY_ERROR)
		return hawser__no_memory(reader->report, "scene");
	if (yaml->error == YAML_READER_ERROR) {
		place.line = 0;
		return hawser__reader_fail(reader, &place, "not a text in UTF-8: %s at byte %zu",
		                           problem, yaml->problem_offset + 1);
	}
	if (yaml->buffer.pointer && *yaml->buffer.pointer == '\t')
		return hawser__reader_fail(reader, &place, "YAML syntax: a tab, where only spaces may be: "
		                           "indent with spaces");
	if (yaml->context)
		return hawser__reader_fail(reader, &place, "YAML syntax: %s %s (line %zu)", problem,
		                           yaml->context, yaml->context_mark.line + 1);
	return hawser__reader_fail(reader, &place, "YAML syntax: %s", problem);
}

static enum hawser_status refuse_extras(struct hawser__reader *reader, const yaml_event_t *event)
{
	struct hawser__mark place = hawser__event_place(reader, event);
	const yaml_char_t *anchor = NULL, *tag = NULL;

	switch (event->type) {
	case YAML_ALIAS_EVENT:
		return hawser__reader_fail(reader, &place,
		                           "a scene has no aliases: write the value "
		                                           "out instead of *%.40s",
		                           (const char *)event->data.alias.anchor);
	case YAML_SCALAR_EVENT:
		anchor = event->data.scalar.anchor;
		tag = event->data.scalar.tag;
		break;
	case YAML_SEQUENCE_START_EVENT:
		anchor = event->data.sequence_start.anchor;
		tag = event->data.sequence_start.tag;
		break;
	case YAML_MAPPING_START_EVENT:
		anchor = event->data.mapping_start.anchor;
		tag = event->data.mapping_start.tag;
		break;
	default:
		break;
	}
	if (anchor)
		return hawser__reader_fail(reader, &place, "a scene has no anchors: remove &%.40s",
		                           (const char *)anchor);
	if (tag)
		return hawser__reader_fail(reader, &place, "a scene has no tags: remove %.40s",
		                           (const char *)tag);
	return HAWSER_OK;
}

enum hawser_status hawser__event_next(struct hawser__reader *reader, yaml_event_t *event)
{
	enum hawser_status status;

	memset(event, 0, sizeof *event);
	if (!yaml_parser_parse(reader->yaml, event))
		return broken(reader);
	status = refuse_extras(reader, event);
	if (status != HAWSER_OK) {
		yaml_event_delete(event);
		memset(event, 0, sizeof *event);
	}
	return status;
}

enum hawser_status hawser__event_text(struct hawser__reader *reader, char text[HAWSER__TEXT_ROOM],
                                      const yaml_event_t *event, const char *what)
{
	struct hawser__mark place = hawser__event_place(reader, event);
	size_t length = event->data.scalar.length;

	if (length >= HAWSER__TEXT_ROOM)
		return hawser__reader_fail(reader, &place,
		                           "%s is %zu characters long; %d is the most",
		                           what, length, HAWSER__TEXT_ROOM - 1);
	if (event->end_mark.line > event->start_mark.line)
		return hawser__reader_fail(reader, &place,
		                           "%s runs over several lines, up to line %zu: is "
		                           "a bracket, quote or colon missing?",
		                           what, event->end_mark.line + 1);
	memcpy(text, event->data.scalar.value, length);
	text[length] = '\0';
	if (strlen(text) != length)
		return hawser__reader_fail(reader, &place, "%s holds a NUL character: remove it",
		                           what);
	return HAWSER_OK;
}
