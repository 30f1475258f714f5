/* core/paths.c - see paths.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/paths.h"

/* Links at each node, at most 2: touch [nodes][2]; 0 if a node has more. */
static int neighbours(int (*touch)[2], int nodes, const int (*end)[2], int links)
{
	for (int i = 0; i < nodes; i++)
		touch[i][0] = touch[i][1] = -1;
	for (int e = 0; e < links; e++)
		for (int side = 0; side < 2; side++) {
			int *at = touch[end[e][side]];

			if (at[1] >= 0)
				return 0;
			at[at[0] >= 0] = e;
		}
	return 1;
}

int hawser__paths(int *node, int *link, int (*touch)[2], int nodes, const int (*end)[2], int links)
{
	int count = 0;

	if (!neighbours(touch, nodes, end, links))
		return 0;
	for (int i = 0; i < nodes; i++) {
		int here = i, from = -1;

		if (touch[i][1] >= 0 || touch[i][0] == -2)
			continue; /* inside a path, or the end of one that was taken */
		for (int more = 1; more; count++) {
			int on = touch[here][0] != from ? touch[here][0] : touch[here][1];

			more = on >= 0;
			node[count] = here;
			link[count] = more ? on : -1;
			if (!more || touch[here][1] < 0)
				touch[here][0] = -2;
			from = on;
			if (more)
				here = end[on][end[on][0] == here];
		}
	}
	return count == nodes;
}
