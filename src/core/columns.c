/* core/columns.c - see columns.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/columns.h"

/* Sort the entries by column (key 0) or row (key 1); those of one key keep their order. place [n + 1]
 * is work space. */
static void sort(int (*sorted)[2], const int (*list)[2], size_t count, int key, size_t *place, int n)
{
	memset(place, 0, ((size_t)n + 1)*sizeof *place);
	for (size_t k = 0; k < count; k++)
		place[list[k][key] + 1]++;
	for (int j = 0; j < n; j++)
		place[j + 1] += place[j];
	for (size_t k = 0; k < count; k++)
		memcpy(sorted[place[list[k][key]]++], list[k], sizeof *list);
}

int hawser__columns(int *p, int *i, int (*list)[2], size_t count, int n)
{
	int (*sorted)[2] = malloc((count + 1)*sizeof *sorted);
	size_t *place = malloc(((size_t)n + 1)*sizeof *place);
	int failed = !sorted || !place, rows = 0, column = -1;

	if (!failed) {
		sort(sorted, (const int (*)[2])list, count, 1, place, n);
		sort(list, (const int (*)[2])sorted, count, 0, place, n);
		for (size_t k = 0; k < count; k++) {
			if (k && list[k][0] == list[k - 1][0] && list[k][1] == list[k - 1][1])
				continue;
			while (column < list[k][0])
				p[++column] = rows;
			i[rows++] = list[k][1];
		}
		while (column < n)
			p[++column] = rows;
	}
	free(sorted);
	free(place);
	return failed;
}

int hawser__columns_find(const int *p, const int *i, int row, int column)
{
	int low = p[column], high = p[column + 1] - 1;

	while (low < high) {
		int mid = low + (high - low)/2;

		if (i[mid] < row)
			low = mid + 1;
		else
			high = mid;
	}
	return low;
}
