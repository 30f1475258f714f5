/* net/tree.h - a scene of kind `net` as a tree of values with their places. Its names are the user's,
 * so that the table of keys of spans, which has one place for each key, cannot hold them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_TREE_H
#define HAWSER_NET_TREE_H

#include "scene/reader.h"

enum hawser__tree_kind { HAWSER__SCALAR, HAWSER__MAPPING, HAWSER__SEQUENCE };

struct hawser__tree {
	enum hawser__tree_kind kind;
	char *name, *text;           /* of an entry of a mapping; of a scalar */
	struct hawser__place at;     /* of the name or, without one, of the value */
	struct hawser__tree *child, *last, *next;
	int children;
};

/* Read a file, then overrides "path=value". The caller clears *tree. */
enum hawser_status hawser__tree_read(struct hawser__tree **tree, struct hawser__reader *reader,
                                     const char *text, size_t length, const char *const *set,
                                     size_t nset) HAWSER_MUST_CHECK;
void hawser__tree_clear(struct hawser__tree *tree);
/* Entry of a mapping, or NULL. */
struct hawser__tree *hawser__tree_find(const struct hawser__tree *tree, const char *name);

#endif
