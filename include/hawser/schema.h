/* hawser/schema.h - the JSON Schema of scenes, for editors: from the tables of keys that the readers
 * use.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCHEMA_H
#define HAWSER_SCHEMA_H

#include <stdio.h>
#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Keys of scenes of all kinds as --set takes them, such as "cables.0.EA", those below names of the user
 * left out; into key [HAWSER_SCHEMA_KEY]. 0: there is none of this index. A key may come twice. */
enum { HAWSER_SCHEMA_KEY = 128 };
int hawser_schema_key(char *key /* [HAWSER_SCHEMA_KEY] */, int index);

/* Write the JSON Schema (draft-07) of scenes of one kind, or of all (kind NULL), to `stream`. It has
 * every key with its unit, range and meaning. It cannot compare values with each other, and takes a
 * text for a number with a unit without its dimension being checked: what it accepts may still be
 * refused by the reader, and what the reader takes it accepts. Returns HAWSER_ERR_ARGUMENT for an
 * unknown kind, HAWSER_ERR_IO if the stream fails, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_schema_write(FILE *stream, const char *kind,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif

#endif
