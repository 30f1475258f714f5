/* scene/document.c - reads a text once, and tells what it describes. See hawser/document.h.
 *
 * The text is parsed into a tree, from which all kinds of scenes but spans are read. Where that fails,
 * the names found so far tell the kind, so that its reader explains the failure. Reduced models can be
 * a hundred times longer than scenes and are JSON: their outermost names are looked for without a
 * parser, which also finds them in a damaged file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <hawser/document.h>
#include "core/report.h"
#include "scene/tree_keys.h"

static const size_t largest = (size_t)1 << 30; /* bytes of a text */

/* The sign `index` of the kinds that have a word of their own, or of those that have none; 0: there are
 * fewer, and *index is the number that is left. */
static int sign_of(struct hawser__kind_sign *sign, int *index, int named)
{
	const struct hawser__tree_table *table;

	for (int i = 1; (table = hawser__tree_kind((enum hawser_kind)i)); i++)
		for (int k = 0; k < HAWSER__TREE_SIGNS && table->sign[k]; k++) {
			*sign = (struct hawser__kind_sign){table->sign[k], NULL, (enum hawser_kind)i};
			if ((table->word != NULL) == named && (*index)-- == 0)
				return 1;
		}
	return 0;
}

/* The words of the key `kind` come first, and spans over obstacles last: nets and ropeways may have the
 * same keys. */
int hawser__kind_sign(struct hawser__kind_sign *sign, int index)
{
	const struct hawser__tree_table *table;

	*sign = (struct hawser__kind_sign){"kind", "span", HAWSER_KIND_SPAN};
	if (index-- == 0)
		return 1;
	for (int i = 1; (table = hawser__tree_kind((enum hawser_kind)i)); i++) {
		*sign = (struct hawser__kind_sign){"kind", table->word, (enum hawser_kind)i};
		if (table->word && index-- == 0)
			return 1;
	}
	if (sign_of(sign, &index, 1) || sign_of(sign, &index, 0))
		return 1;
	/* whose reader refuses what is no kind */
	*sign = (struct hawser__kind_sign){"kind", NULL, HAWSER_KIND_NET};
	return index == 0;
}

const char *hawser_kind_name(enum hawser_kind kind)
{
	const struct hawser__tree_table *table = hawser__tree_kind(kind);

	return table ? table->kind : kind == HAWSER_KIND_SPAN ? "span"
	       : kind == HAWSER_KIND_MODEL ? "model" : NULL;
}

/* 1 if an obstacle is a plane, a profile, a grid or a segment: such spans are meshes. */
static int has_flat(const struct hawser__tree *tree)
{
	for (const struct hawser__tree *child = tree ? tree->child : NULL; child; child = child->next)
		if ((child->name && (!strcmp(child->name, "plane") || !strcmp(child->name, "segment") ||
		                     !strcmp(child->name, "profile") || !strcmp(child->name, "grid"))) ||
		    has_flat(child))
			return 1;
	return 0;
}

static enum hawser_kind kind_of(const struct hawser__tree *tree)
{
	struct hawser__kind_sign sign;
	int mesh = has_flat(hawser__tree_find(tree, "obstacles")) ||
	           (hawser__tree_find(tree, "water") && hawser__tree_find(tree, "span"));

	for (int i = 0; hawser__kind_sign(&sign, i); i++) {
		const struct hawser__tree *found = hawser__tree_find(tree, sign.key);

		if (!found || (sign.word && (!found->text || strcmp(found->text, sign.word) != 0)))
			continue;
		return mesh && (sign.kind == HAWSER_KIND_OBSTACLES ||
		                (sign.kind == HAWSER_KIND_SPAN && hawser__tree_find(tree, "water")))
		       ? HAWSER_KIND_NET : sign.kind;
	}
	return mesh && hawser__tree_find(tree, "water") ? HAWSER_KIND_NET : HAWSER_KIND_SPAN;
}

static const char *skip_blanks(const char *at, const char *end)
{
	while (at < end && (*at == ' ' || *at == '\t' || *at == '\n' || *at == '\r'))
		at++;
	return at;
}

/* Behind the end of a string of JSON that begins at `at`, behind its quotation mark. */
static const char *skip_string(const char *at, const char *end)
{
	while (at < end && *at != '"')
		at += *at == '\\' && at + 1 < end ? 2 : 1;
	return at < end ? at + 1 : end;
}

static int is_word(const char *from, const char *end, const char *word)
{
	size_t length = strlen(word);

	return (size_t)(end - from) == length + 1 && memcmp(from, word, length) == 0;
}

/* Whether it is a reduced model, by the names of the outermost object of JSON. */
static int is_model(const char *text, size_t length)
{
	const char *end = text + length, *at = skip_blanks(text, end);
	int depth = 0, n = 0, K = 0;

	if (at == end || *at != '{')
		return 0;
	while (at < end) {
		const char *from = at + 1;

		depth += (*at == '{' || *at == '[') - (*at == '}' || *at == ']');
		if (depth == 0)
			break;
		if (*at++ != '"')
			continue;
		at = skip_string(at, end);
		if (depth != 1 || skip_blanks(at, end) == end || *skip_blanks(at, end) != ':')
			continue;
		if (is_word(from, at, "hawser_rom") || is_word(from, at, "cable"))
			return *from == 'h';
		n |= is_word(from, at, "n");
		K |= is_word(from, at, "K");
	}
	return n && K;
}

/* The whole stream. */
static enum hawser_status slurp(struct hawser_document *document, FILE *stream,
                                struct hawser_report *report)
{
	size_t capacity = 0, got = 1;

	while (got && document->length <= largest) {
		if (document->length + 1 >= capacity) { /* room for the zero at the end */
			char *longer = realloc(document->text, capacity = capacity ? 4*capacity : 65536);

			if (!longer)
				return hawser__no_memory(report, "scene");
			document->text = longer;
		}
		got = fread(document->text + document->length, 1, capacity - document->length - 1, stream);
		document->length += got;
	}
	document->text[document->length] = '\0';
	if (ferror(stream))
		return hawser__fail(report, hawser__unreadable(errno), "scene", "cannot read %s: %s",
		                    document->name, strerror(errno));
	if (document->length > largest)
		return hawser__fail(report, HAWSER_ERR_SCENE, "scene",
		                    "%s: larger than 1 GiB, so this is neither a scene nor a model",
		                    document->name);
	return HAWSER_OK;
}

enum hawser_status hawser_document_read(struct hawser_document *document, FILE *stream,
                                        const char *name, struct hawser_report *report)
{
	enum hawser_status status;

	*document = (struct hawser_document){.name = strdup(name)};
	status = document->name ? slurp(document, stream, report) : hawser__no_memory(report, "scene");
	if (!status && is_model(document->text, document->length)) {
		document->kind = HAWSER_KIND_MODEL;
	} else if (!status) {
		int whole = hawser__tree_parse(&document->tree, document->text, document->length);

		document->kind = kind_of(document->tree);
		if (!whole) {
			hawser__tree_clear(document->tree);
			document->tree = NULL;
		}
	}
	if (status)
		hawser_document_clear(document);
	return status;
}

enum hawser_status hawser_document_open(struct hawser_document *document, const char *path,
                                        struct hawser_report *report)
{
	int standard = !strcmp(path, "-");
	FILE *stream = standard ? stdin : fopen(path, "rb");
	off_t from = standard ? ftello(stdin) : -1;
	enum hawser_status status;

	*document = (struct hawser_document){.name = NULL};
	if (!stream)
		return hawser__fail(report, hawser__unreadable(errno), "scene", "cannot read %s: %s", path,
		                    strerror(errno));
	status = hawser_document_read(document, stream, standard ? "<stdin>" : path, report);
	if (!standard)
		fclose(stream);
	else if (from >= 0)
		(void)fseeko(stdin, from, SEEK_SET); /* a file can be read again */
	return status;
}

void hawser_document_clear(struct hawser_document *document)
{
	if (!document)
		return;
	free(document->name);
	free(document->text);
	hawser__tree_clear(document->tree);
	*document = (struct hawser_document){.name = NULL};
}
