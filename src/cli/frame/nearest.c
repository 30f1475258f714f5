/* cli/frame/nearest.c - the name that the user probably meant: the nearest in spelling, or one that
 * begins with the given letters.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "cli/frame/cli.h"
#include "core/spelling.h"

const char *cli_nearest(const char *name, const char *const *names, int count)
{
	int nearest = hawser__edit_limit(strlen(name)) + 1;
	const char *best = NULL;

	for (int i = 0; i < count; i++) {
		int distance = hawser__edit_distance(name, names[i]);

		if (strlen(name) >= 2 && strncmp(name, names[i], strlen(name)) == 0)
			return names[i];
		if (distance < nearest) {
			nearest = distance;
			best = names[i];
		}
	}
	return best;
}
