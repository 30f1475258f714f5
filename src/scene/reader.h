/* scene/reader.h - one reading of a scene: the text, the unit system, and where each key was met.
 *
 * A reading is a row of passes over the same table: the file first, then each override (--set) in
 * order. Within a pass a key may be given once; a later pass replaces what an earlier one gave.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_READER_H
#define HAWSER_SCENE_READER_H

#include <yaml.h>

#include <hawser/scene.h>
#include "scene/keys.h"
#include "scene/units.h"

enum { HAWSER__KEYS_MAX = 64, HAWSER__SECTIONS_MAX = 16, HAWSER__TEXT = 256 };

/* Where something stands: in the file, or in an override. */
struct hawser__place {
	int pass;             /* 0: nowhere */
	const char *set;      /* the override's text; NULL in the file */
	size_t line, column;  /* from 1; 0: the whole file */
};

struct hawser__reader {
	struct hawser_scene *scene;
	struct hawser_report *report;
	const char *name; /* of the file */
	const char *set;  /* of the current pass, NULL for the file */
	int pass;
	yaml_parser_t *yaml;
	struct hawser__units units;
	struct hawser__place key[HAWSER__KEYS_MAX], section[HAWSER__SECTIONS_MAX];
	struct hawser__place root;
};

/* Fail with HAWSER_ERR_SCENE, the message prefixed with the place. */
enum hawser_status hawser__reader_fail(struct hawser__reader *reader,
                                       const struct hawser__place *place, const char *format,
                                       ...) HAWSER_PRINTF(3, 4);

/* events.c: libyaml's events, with the features a scene does without refused. */
enum hawser_status hawser__event_next(struct hawser__reader *reader, yaml_event_t *event)
	HAWSER_MUST_CHECK;
/* Text of a scalar event; fails where it is too long, on several lines, or holds a NUL. `what`
 * names it. */
enum hawser_status hawser__event_text(struct hawser__reader *reader, char text[HAWSER__TEXT],
                                      const yaml_event_t *event, const char *what)
	HAWSER_MUST_CHECK;
struct hawser__place hawser__event_place(const struct hawser__reader *reader,
                                         const yaml_event_t *event);

/* value.c: the value that `event` begins, stored in the scene for key `index`. */
enum hawser_status hawser__value_read(struct hawser__reader *reader, yaml_event_t *event,
                                      int index) HAWSER_MUST_CHECK;

/* parse.c: a whole document. The text of a file, or of what stands after "path=". */
enum hawser_status hawser__parse_file(struct hawser__reader *reader, const char *text,
                                      size_t length) HAWSER_MUST_CHECK;
enum hawser_status hawser__parse_override(struct hawser__reader *reader, const char *set)
	HAWSER_MUST_CHECK;
/* Give every key that was not written its default. */
enum hawser_status hawser__parse_defaults(struct hawser__reader *reader) HAWSER_MUST_CHECK;

/* check.c: what only the whole scene can tell: missing keys, keys that need others. */
enum hawser_status hawser__check(struct hawser__reader *reader) HAWSER_MUST_CHECK;

#endif
