/* scene/paths.c - parts of the path of a key, such as "damping.rayleigh.mass".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "scene/keys.h"

const char *hawser__leaf(const char *path)
{
	const char *dot = strrchr(path, '.');

	return dot ? dot + 1 : path;
}

static size_t parent_length(const char *path)
{
	const char *dot = strrchr(path, '.');

	return dot ? (size_t)(dot - path) : 0;
}

int hawser__child_of(const char *path, const char *section)
{
	size_t length = parent_length(path);

	return length == strlen(section) && !strncmp(path, section, length);
}

int hawser__path_plain(char *path)
{
	char *to = path;
	int open = 0;

	for (const char *at = path; *at; at++) {
		if ((*at == '[') == open && (*at == '[' || *at == ']'))
			return 0;
		if ((*at == ']' && to[-1] == '.') || (open && *at == '.'))
			return 0;
		if (*at == ']' && at[1] && at[1] != '.' && at[1] != '[')
			return 0;
		open = *at == '[' || (open && *at != ']');
		if (*at != ']')
			*to++ = *at == '[' ? '.' : *at;
	}
	*to = '\0';
	return !open;
}

int hawser__path_element(char *path)
{
	char *dot = strrchr(path, '.');
	size_t digits = dot ? strspn(dot + 1, "0123456789") : 0;

	if (digits < 1 || digits > 2 || dot[1 + digits])
		return -1;
	*dot = '\0';
	return (int)strtol(dot + 1, NULL, 10);
}
