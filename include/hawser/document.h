/* hawser/document.h - the text of a scene or of a reduced model, read once, and what it describes.
 *
 * Every kind of scene is read from a document: hawser_scene_of, hawser_net_of, hawser_obstacles_of,
 * hawser_ropeway_of, hawser_rod_of, hawser_tow_of; a reduced model by hawser_rom_source_of. The
 * functions _open of these read a file by its name, for programs that know what is in it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_DOCUMENT_H
#define HAWSER_DOCUMENT_H

#include <stddef.h>
#include <stdio.h>

#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The kinds of scenes beside spans: names and numbers, HAWSER_KIND_NET and so on. A new kind is a word
 * here. */
#define HAWSER_SCENE_KINDS(X) \
	X(net, NET) X(obstacles, OBSTACLES) X(ropeway, ROPEWAY) X(rod, ROD) X(tow, TOW)
#define HAWSER_KIND_NUMBER(name, NAME) HAWSER_KIND_##NAME,

/* The key `kind` says it, in block or flow style, as YAML or JSON; else the other keys of the outermost
 * mapping do: tow, ropeway, nodes (a net), obstacles or contact (a span over obstacles; a net where one
 * of them is a plane or a segment), rod. A JSON object with the key hawser_rom, or with n and K and
 * without cable, is a reduced model. What has none of these is a span of cable, or a beam. */
enum hawser_kind {
	HAWSER_KIND_SPAN,
	HAWSER_SCENE_KINDS(HAWSER_KIND_NUMBER)
	HAWSER_KIND_MODEL,
	HAWSER_KINDS
};
#undef HAWSER_KIND_NUMBER

struct hawser_document {
	char *name;   /* for messages: of the file, or "<stdin>" */
	char *text;   /* [length + 1], with a zero at the end */
	size_t length;
	enum hawser_kind kind;
	struct hawser__tree *tree; /* internal; NULL for a model, and where the text is no YAML */
};

/* Read a file; "-" is standard input, which is left where it was if that is possible. A text that is no
 * YAML has the kind that follows from its beginning, and the reader of this kind tells what is wrong.
 * HAWSER_ERR_IO, HAWSER_ERR_ARGUMENT (there is no such file), HAWSER_ERR_SCENE (larger than 1 GiB),
 * HAWSER_ERR_MEMORY. The caller clears the document; after a failure nothing need be cleared. */
enum hawser_status hawser_document_open(struct hawser_document *document, const char *path,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same for a stream, up to its end. */
enum hawser_status hawser_document_read(struct hawser_document *document, FILE *stream,
                                        const char *name,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_document_clear(struct hawser_document *document);

/* "span", "net", "obstacles", "ropeway", "rod", "tow", "model"; NULL beyond. */
const char *hawser_kind_name(enum hawser_kind kind);

#ifdef __cplusplus
}
#endif

#endif
