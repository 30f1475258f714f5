/* scene/suggest.h - the key that a misspelt one was probably meant to be.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_SUGGEST_H
#define HAWSER_SCENE_SUGGEST_H

#include <stddef.h>

/* The key or section nearest to `path`: among its siblings if one is within the limit, else among
 * all keys, by full path or last component. NULL where nothing is near. */
const char *hawser__nearest(const char *path);

/* Write into `hint` [size] what a message says after "unknown key PATH": the nearest key and,
 * where it is not a sibling, where it belongs; or all keys of the section. */
void hawser__suggest(char *hint, size_t size, const char *path);

/* "cable takes EA, rho": the keys of a section ("" is the top level), in the table's order. */
void hawser__list(char *hint, size_t size, const char *section);

#endif
