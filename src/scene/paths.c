/* scene/paths.c - parts of the path of a key, such as "damping.rayleigh.mass".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <string.h>

#include "scene/keys.h"

const char *hawser__leaf(const char *path)
{
	const char *dot = strrchr(path, '.');

	return dot ? dot + 1 : path;
}

size_t hawser__parent_length(const char *path)
{
	const char *dot = strrchr(path, '.');

	return dot ? (size_t)(dot - path) : 0;
}

int hawser__child_of(const char *path, const char *section)
{
	size_t length = hawser__parent_length(path);

	return length == strlen(section) && !strncmp(path, section, length);
}
