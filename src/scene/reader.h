/* scene/reader.h - the state of reading a scene: the text, the unit system, and places in them.
 *
 * Reading consists of passes: the file, then each override (--set) in order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_READER_H
#define HAWSER_SCENE_READER_H

#include <stddef.h>
#include <yaml.h>

#include <hawser/document.h>

/* --- units.c: numbers with units. All input conversions of units are done here --- */

/* A unit system, read from the database of udunits2 with the first unit that is none of the common
 * ones. Zero is a valid initial state; release with hawser__units_clear. */
struct hawser__units {
	struct ut_system *system;
};

enum hawser__number {
	HAWSER__NUMBER_OK = 0,
	HAWSER__NUMBER_SYNTAX,    /* not a number, or invalid text after it */
	HAWSER__NUMBER_NAN,
	HAWSER__NUMBER_OVERFLOW,  /* beyond double precision */
	HAWSER__NUMBER_UNKNOWN,   /* no such unit */
	HAWSER__NUMBER_DIMENSION, /* a unit of another dimension */
	HAWSER__NUMBER_DATABASE   /* the database of udunits2 cannot be read */
};

/* Read "18 km/h" for the unit "m/s" as 5. A plain number is in `unit`. ".inf" is a number. */
enum hawser__number hawser__units_read(struct hawser__units *units, double *value,
                                       const char *text, const char *unit);

/* By what a number in the common unit `from` is multiplied to be in `to`; 0 if this pair is no
 * common one. */
double hawser__units_common(const char *from, const char *to);

/* What follows the number in a text. */
const char *hawser__units_behind(const char *text);

/* Write the sentence that explains a failure, to follow the quoted text. */
void hawser__units_explain(char *sentence, size_t size, enum hawser__number failure,
                           const char *text, const char *unit);

/* Copy a text of the user for a message: control characters masked, at most 40 characters. */
enum { HAWSER__SHOWN = 56 };
const char *hawser__shown(char shown[HAWSER__SHOWN], const char *text);

void hawser__units_clear(struct hawser__units *units);

enum { HAWSER__TEXT_ROOM = 256 };

/* A place in the file or in an override. */
struct hawser__mark {
	int pass;
	const char *set;      /* the override's text; NULL in the file */
	size_t line, column;  /* from 1; 0: the whole file */
};

struct hawser__reader {
	struct hawser_report *report;
	const char *name; /* of the file */
	enum hawser_kind kind; /* as the whole text says */
	int any_size;     /* 1: numbers may be larger than 1e100 or smaller than 1e-100 */
	const char *set;  /* of the current pass, NULL for the file */
	int pass;
	yaml_parser_t *yaml;
	struct hawser__units units;
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

#endif
