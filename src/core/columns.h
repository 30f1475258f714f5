/* core/columns.h - the pattern of a sparse matrix by columns, from a list of its entries.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_COLUMNS_H
#define HAWSER_CORE_COLUMNS_H

#include <stddef.h>

/* Sort the entries (column, row) of list [count][2], and write each once: the rows of column j of n are
 * i[p[j]] to i[p[j + 1] - 1], ascending; p [n + 1], i [count]. Returns 1 if memory is short. */
int hawser__columns(int *p, int *i, int (*list)[2], size_t count, int n);
/* The place in i of a row that the column has. */
int hawser__columns_find(const int *p, const int *i, int row, int column);

#endif
