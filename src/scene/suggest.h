/* scene/suggest.h - suggestions for misspelt keys.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_SUGGEST_H
#define HAWSER_SCENE_SUGGEST_H

#include <stddef.h>

/* The key or section nearest to `path`: in the same section if one is within the limit, else among
 * all keys, by full path or last component. NULL if none is within the limit. */
const char *hawser__nearest(const char *path);

/* Write into `hint` [size] the text that follows "unknown key PATH": the nearest key with its
 * section, if that is a different one, or all keys of the section. */
void hawser__suggest(char *hint, size_t size, const char *path);

/* "cable takes EA, rho": the keys of a section ("" is the top level), in the table's order. */
void hawser__list(char *hint, size_t size, const char *section);

#endif
