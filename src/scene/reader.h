/* scene/reader.h - the state of reading a scene: the text, the unit system, and the place of each
 * key.
 *
 * Reading consists of passes over the same table: the file, then each override (--set) in order. A
 * key may be given once in a pass; a later pass replaces the value of an earlier one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_READER_H
#define HAWSER_SCENE_READER_H

#include <yaml.h>

#include <hawser/scene.h>
#include "scene/keys.h"
#include "scene/units.h"

enum { HAWSER__SECTIONS_MAX = 16, HAWSER__TEXT_ROOM = 256 };

/* A place in the file or in an override. */
struct hawser__mark {
	int pass;             /* 0: nowhere */
	const char *set;      /* the override's text; NULL in the file */
	size_t line, column;  /* from 1; 0: the whole file */
};

struct hawser__reader {
	struct hawser_scene *scene;
	struct hawser_report *report;
	const char *name; /* of the file */
	enum hawser_kind kind; /* as the whole text says */
	const char *set;  /* of the current pass, NULL for the file */
	int pass;
	int item, items; /* the item being read; a count of all that were read, in all passes */
	yaml_parser_t *yaml;
	struct hawser__units units;
	struct hawser__mark key[HAWSER_SCENE_KEYS], section[HAWSER__SECTIONS_MAX];
	struct hawser__mark root, list[HAWSER__LISTS];
};

/* Fail with HAWSER_ERR_SCENE; the message begins with the place. */
enum hawser_status hawser__reader_fail(struct hawser__reader *reader,
                                       const struct hawser__mark *place, const char *format,
                                       ...) HAWSER_PRINTF(3, 4);

/* "in line 7": the place of the earlier of two keys, for a message about the later one. */
const char *hawser__mark_text(char *text, size_t size, const struct hawser__mark *mark);

/* events.c: the next event of libyaml; fails for features that a scene must not use. */
enum hawser_status hawser__event_next(struct hawser__reader *reader, yaml_event_t *event)
	HAWSER_MUST_CHECK;
/* Text of a scalar event; fails if it is too long, has several lines or contains a NUL. `what`
 * names it in messages. */
enum hawser_status hawser__event_text(struct hawser__reader *reader, char text[HAWSER__TEXT_ROOM],
                                      const yaml_event_t *event, const char *what)
	HAWSER_MUST_CHECK;
struct hawser__mark hawser__event_place(const struct hawser__reader *reader,
                                        const yaml_event_t *event);

struct hawser__tree;

/* value.c: read a value and store it in the scene for key `index`. */
enum hawser_status hawser__value_read(struct hawser__reader *reader, const struct hawser__tree *tree,
                                      int index) HAWSER_MUST_CHECK;

/* parse.c: read a whole document, or an override "path=value". */
enum hawser_status hawser__parse_file(struct hawser__reader *reader,
                                      const struct hawser_document *from) HAWSER_MUST_CHECK;
enum hawser_status hawser__parse_override(struct hawser__reader *reader, const char *set)
	HAWSER_MUST_CHECK;
/* Set every key that is not given to its default. */
enum hawser_status hawser__parse_defaults(struct hawser__reader *reader) HAWSER_MUST_CHECK;

/* parse.c: the value of `path`; the entries of the mapping of a section. */
enum hawser_status hawser__parse_value(struct hawser__reader *reader, const char *path,
                                       const struct hawser__tree *tree) HAWSER_MUST_CHECK;
enum hawser_status hawser__parse_mapping(struct hawser__reader *reader, const char *section,
                                         const struct hawser__tree *tree) HAWSER_MUST_CHECK;
enum hawser_status hawser__parse_unknown(struct hawser__reader *reader,
                                         const struct hawser__mark *place, const char *path);

/* Size in bytes of the value of a row in the scene; make a key that is none of a list's not given. */
size_t hawser__parse_size(const struct hawser__row *row);
void hawser__parse_forget(struct hawser__reader *reader, int index);

/* override.c: take out a key, a section, a list, an item of one or a key of it: an override without a
 * value. "[0, 0.8 N/m, 0]" of the list `path` with another element; 0: the scene has no such list. */
enum hawser_status hawser__parse_take_out(struct hawser__reader *reader, const char *path,
                                          const struct hawser__mark *place) HAWSER_MUST_CHECK;
int hawser__parse_element(char *text, size_t size, const struct hawser_scene *scene, const char *path,
                          int element, const char *value);

/* items.c: read a list; an override "attach.0.mass"; check the items of all lists. */
enum hawser_status hawser__items_read(struct hawser__reader *reader, int list,
                                      const struct hawser__tree *tree) HAWSER_MUST_CHECK;
enum hawser_status hawser__items_set(struct hawser__reader *reader, int list, const char *path,
                                     const struct hawser__tree *tree) HAWSER_MUST_CHECK;
enum hawser_status hawser__items_check(struct hawser__reader *reader) HAWSER_MUST_CHECK;

/* Rules of single lists: lists.c; cases.c, which also reads an item, or a key of one. */
enum hawser_status hawser__attach_check(struct hawser__reader *reader) HAWSER_MUST_CHECK;
enum hawser_status hawser__loads_check(struct hawser__reader *reader) HAWSER_MUST_CHECK;
enum hawser_status hawser__cases_check(struct hawser__reader *reader) HAWSER_MUST_CHECK;
enum hawser_status hawser__case_read(struct hawser__reader *reader, int number,
                                     const struct hawser__tree *tree) HAWSER_MUST_CHECK;
enum hawser_status hawser__case_set(struct hawser__reader *reader, int number, const char *path,
                                    const struct hawser__tree *tree) HAWSER_MUST_CHECK;

/* check.c: check the whole scene: missing keys, keys that require others. */
enum hawser_status hawser__check(struct hawser__reader *reader) HAWSER_MUST_CHECK;

#endif
