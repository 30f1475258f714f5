/* cli/nearest.c - the name that a misspelt one was probably meant to be.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <string.h>

#include "cli/cli.h"

enum { longest = 31 };

static int least(int a, int b)
{
	return a < b ? a : b;
}

/* Levenshtein's distance, of the first 31 characters; one row of the table is kept. */
static int distance(const char *a, const char *b)
{
	int columns = least((int)strlen(b), longest), row[longest + 1], i, j;

	for (j = 0; j <= columns; j++)
		row[j] = j;
	for (i = 0; a[i] && i < longest; i++) {
		int diagonal = row[0];

		row[0] = i + 1;
		for (j = 0; j < columns; j++) {
			int replaced = diagonal + (a[i] != b[j]);

			diagonal = row[j + 1];
			row[j + 1] = least(replaced, least(row[j], row[j + 1]) + 1);
		}
	}
	return row[columns];
}

/* Near enough: a third of the letters wrong at most, or a name that was left unfinished. */
const char *cli_nearest(const char *name, const char *const *names, int count)
{
	int limit = 1 + (int)strlen(name)/3, i;
	const char *best = NULL;

	for (i = 0; i < count; i++) {
		int d = distance(name, names[i]);

		if (strlen(name) >= 2 && strncmp(name, names[i], strlen(name)) == 0)
			return names[i];
		if (d <= limit) {
			limit = d - 1;
			best = names[i];
		}
	}
	return best;
}
