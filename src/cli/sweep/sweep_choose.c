/* cli/sweep/sweep_choose.c - which rows and columns of a result are kept: --last, --max, --min,
 * --keep. See sweep.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "cli/sweep/sweep.h"
#include "core/append.h"

void cli_sweep_miss(struct cli_sweep_rows *rows, const char *format, ...)
{
	char text[400];
	va_list args;

	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	if (!rows->missing)
		rows->missing = strdup(text);
}

static int find_column(const struct cli_sweep_rows *rows, const char *name)
{
	for (int c = 0; c < rows->columns; c++)
		if (strcmp(rows->column[c].name, name) == 0)
			return c;
	for (int c = 0; c < rows->columns; c++)
		if (strcmp(rows->column[c].bare, name) == 0)
			return c;
	return -1;
}

static void no_column(struct cli_sweep_rows *rows, const struct cli_sweep_choice *choice,
                      const char *option, const char *name)
{
	const char *names[200] = {NULL}, *best;
	char list[240] = "";
	int count = 0;

	for (; count < rows->columns && count < 200; count++)
		names[count] = rows->column[count].name;
	best = cli_nearest(name, names, count);
	for (int c = 0; c < count && strlen(list) < 180; c++)
		hawser__append(list, sizeof list, ", ", "%.50s", names[c]);
	cli_sweep_miss(rows, "--%s %s: the result of %s has no such column%s%s%s; it has %s%s%s",
	               option, name, choice->command->name, best ? "; did you mean " : "", best ? best : "",
	               best ? "?" : "", list, strlen(list) < 180 ? "" : ", ...",
	               strcmp(choice->rows, "values") == 0 && strcmp(option, "keep") == 0
	               ? "; of lists of its JSON, as nodes.J[0] or cables[c1].T_max, what is named" : "");
}

static void clear_row(struct cli_sweep_row *row)
{
	for (int c = 0; c < row->cells; c++)
		free(row->cell[c]);
	free(row->cell);
}

/* The row that is chosen: the last, or the one with the largest or least number. -1: none. */
static long pick(const struct cli_sweep_rows *rows, enum cli_sweep_pick pick, int column)
{
	long best = -1;
	double most = -INFINITY;

	if (pick == CLI_SWEEP_LAST)
		return rows->rows - 1;
	for (long r = 0; r < rows->rows; r++) {
		const char *cell = column < rows->row[r].cells ? rows->row[r].cell[column] : NULL;
		double value;

		if (!cell || !*cell || *cell == '\'' || *cell == 't' || *cell == 'f')
			continue;
		value = pick == CLI_SWEEP_MAX ? strtod(cell, NULL) : -strtod(cell, NULL);
		if (value > most) {
			most = value;
			best = r;
		}
	}
	return best;
}

static void pick_row(struct cli_sweep_rows *rows, const struct cli_sweep_choice *choice)
{
	int column = choice->by ? find_column(rows, choice->by) : 0;
	long chosen;

	if (choice->pick == CLI_SWEEP_ALL || rows->rows == 0)
		return;
	if (column < 0) {
		no_column(rows, choice, choice->pick == CLI_SWEEP_MAX ? "max" : "min", choice->by);
		return;
	}
	chosen = pick(rows, choice->pick, column);
	for (long r = 0; r < rows->rows; r++)
		if (r != chosen)
			clear_row(&rows->row[r]);
	if (chosen >= 0)
		rows->row[0] = rows->row[chosen];
	rows->rows = chosen >= 0;
}

/* 1 if the name is that of a part of `whole`: "end[0]" of "end". */
static int is_part(const char *name, const char *whole)
{
	size_t length = strlen(whole);

	return strncmp(name, whole, length) == 0 && (name[length] == '[' || name[length] == '.');
}

/* Into from [columns + keeps] the columns of --keep, in its order: their number. */
static int kept_columns(int *from, struct cli_sweep_rows *rows,
                        const struct cli_sweep_choice *choice)
{
	int count = 0;

	for (int k = 0; k < choice->keeps; k++) {
		int before = count, found = find_column(rows, choice->keep[k]);

		if (found >= 0)
			from[count++] = found;
		for (int c = 0; c < rows->columns && found < 0; c++)
			if (is_part(rows->column[c].bare, choice->keep[k]) && count < rows->columns + k)
				from[count++] = c;
		if (count == before)
			no_column(rows, choice, "keep", choice->keep[k]);
	}
	return count;
}

static void clear_columns(struct cli_sweep_rows *rows)
{
	for (int c = 0; c < rows->columns; c++) {
		free(rows->column[c].name);
		free(rows->column[c].bare);
	}
	free(rows->column);
}

static void keep_columns(struct cli_sweep_rows *rows, const struct cli_sweep_choice *choice)
{
	size_t most = (size_t)(rows->columns + choice->keeps);
	struct cli_sweep_column *column = calloc(most, sizeof *column);
	int *from = calloc(most, sizeof *from), count = 0;

	rows->failed |= !column || !from;
	if (!rows->failed)
		count = kept_columns(from, rows, choice);
	for (int k = 0; k < count; k++) {
		column[k].name = strdup(rows->column[from[k]].name);
		column[k].bare = strdup(rows->column[from[k]].bare);
		rows->failed |= !column[k].name || !column[k].bare;
	}
	for (long r = 0; r < rows->rows && !rows->failed; r++) {
		struct cli_sweep_row old = rows->row[r], *row = &rows->row[r];

		*row = (struct cli_sweep_row){calloc((size_t)count + 1, sizeof *row->cell), count};
		rows->failed |= !row->cell;
		for (int k = 0; k < count && row->cell; k++)
			row->cell[k] = from[k] < old.cells && old.cell[from[k]]
				? strdup(old.cell[from[k]]) : NULL;
		row->cells = row->cell ? count : 0;
		clear_row(&old);
	}
	clear_columns(rows);
	free(from);
	rows->column = column;
	rows->columns = column ? count : 0;
}

void cli_sweep_choose(struct cli_sweep_rows *rows, const struct cli_sweep_choice *choice)
{
	pick_row(rows, choice);
	if (!rows->missing && choice->keeps > 0 && rows->rows > 0)
		keep_columns(rows, choice);
}

void cli_sweep_rows_clear(struct cli_sweep_rows *rows)
{
	for (long r = 0; r < rows->rows; r++)
		clear_row(&rows->row[r]);
	clear_columns(rows);
	free(rows->row);
	free(rows->missing);
	memset(rows, 0, sizeof *rows);
}
