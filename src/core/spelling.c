/* core/spelling.c - edit distance of two names. Reference: Damerau, Commun. ACM 7 (1964) 171;
 * the restricted form (no edit between swapped letters) suffices for short names.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <string.h>

#include "core/spelling.h"

enum { LONGEST = 63, EDIT = 2, CASE = 1 };

static int least(int a, int b)
{
	return a < b ? a : b;
}

static int swap_cost(char a, char b)
{
	if (a == b)
		return 0;
	return tolower((unsigned char)a) == tolower((unsigned char)b) ? CASE : EDIT;
}

int hawser__edit_distance(const char *a, const char *b)
{
	int n = (int)strnlen(a, LONGEST), m = (int)strnlen(b, LONGEST);
	int cost[LONGEST + 1][LONGEST + 1];

	for (int i = 0; i <= n; i++)
		cost[i][0] = i*EDIT;
	for (int j = 0; j <= m; j++)
		cost[0][j] = j*EDIT;
	for (int i = 1; i <= n; i++)
		for (int j = 1; j <= m; j++) {
			int best = least(cost[i-1][j], cost[i][j-1]) + EDIT;

			best = least(best, cost[i-1][j-1] + swap_cost(a[i-1], b[j-1]));
			if (i > 1 && j > 1 && a[i-1] == b[j-2] && a[i-2] == b[j-1])
				best = least(best, cost[i-2][j-2] + EDIT);
			cost[i][j] = best;
		}
	return cost[n][m];
}

/* One edit for a short name, and one more for every four letters; the limit is low enough that a
 * suggestion always shares letters with the name. */
int hawser__edit_limit(size_t length)
{
	int limit = EDIT*(1 + (int)(least((int)length, LONGEST)/4));

	return least(limit, EDIT*(int)length - 1);
}
