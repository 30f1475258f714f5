/* cli/measure/series.c - columns of numbers of a text table (cli/measure/series.h).
 *
 * Lines that begin with # are comments. A line of words before the first row of numbers names the
 * columns. All columns up to the last one that may be wanted are kept until the end, because which
 * one has the largest values is known only then.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/measure/series.h"
#include "core/append.h"
#include "core/grow.h"
#include "core/report.h"

enum { most_columns = 1024, longest_line = 65536 };
static const char blank[] = " \t,;\r\n";

struct table {
	const char *path;
	char (*name)[CLI_COLUMN_NAME]; /* [names] */
	int names;
	double *cell;                  /* [rows][columns] */
	int rows, columns;
	int x, y;                      /* index from 0; y is -1 if the largest displacement is
	                                * requested */
	const char *const *wanted;     /* [wanteds] names of all columns that the table may have, the
	                                * first of which it must have; or NULL: x and y are chosen */
	int wanteds;
};

/* --- which columns --- */

/* Whether column k is a displacement: in metres along an axis (1), or a coordinate (2); else 0. */
static int displacement(const struct table *table, int k)
{
	const char *name = table->name[k], *end = strrchr(name, '_');

	if (name[0] == 'u' && name[1] == '_')
		return 2;
	return strchr("xyz", name[0]) && name[1] == '_' && end > name + 1 && strcmp(end, "_m") == 0;
}

static int has_displacements(const struct table *table)
{
	for (int k = 0; k < table->names; k++)
		if (displacement(table, k))
			return 1;
	return 0;
}

/* The index of the column with this number or name. */
static enum hawser_status find(int *column, const struct table *table, const char *option,
                               const char *wanted, struct hawser_report *report)
{
	char *end;
	/* NOLINTNEXTLINE(clang-analyzer-core.NonNullParamChecker): options have defaults */
	long number = strtol(wanted, &end, 10);

	if (*wanted && !*end && number >= 1 && number <= most_columns) {
		*column = (int)number - 1;
		return HAWSER_OK;
	}
	for (int k = 0; k < table->names; k++)
		if (strcmp(table->name[k], wanted) == 0) {
			*column = k;
			return HAWSER_OK;
		}
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "series",
	                    "--%s %s: %s has no such column; write its number, from 1, or its name in the "
	                    "line above the numbers", option, wanted, table->path);
}

static enum hawser_status choose(struct table *table, const char *x, const char *y,
                                 struct hawser_report *report)
{
	enum hawser_status status = find(&table->x, table, "x", x, report);
	int last;

	table->y = -1;
	if (!status && (y || !has_displacements(table)))
		status = find(&table->y, table, "y", y ? y : "2", report);
	last = table->y;
	for (int k = 0; table->y < 0 && k < table->names; k++)
		if (displacement(table, k))
			last = k;
	table->columns = 1 + (last > table->x ? last : table->x);
	return status;
}

/* Index in table->wanted of the name of column k, or -1. */
static int wanted(const struct table *table, int k)
{
	for (int w = 0; w < table->wanteds; w++)
		if (strcmp(table->name[k], table->wanted[w]) == 0)
			return w;
	return -1;
}

static enum hawser_status all_columns(struct table *table, struct hawser_report *report)
{
	char list[256] = "";
	int first = 0;

	for (int w = 0; w < table->wanteds; w++)
		hawser__append(list, sizeof list, ", ", "%s", table->wanted[w]);
	for (int k = 0; k < table->names; k++) {
		int w = wanted(table, k);

		first |= w == 0;
		if (w < 0)
			return hawser__fail(report, HAWSER_ERR_SCENE, "series",
			                    "%s: unknown column %s: the columns can be %s", table->path,
			                    table->name[k], list);
	}
	if (!first || table->names < 2)
		return hawser__fail(report, HAWSER_ERR_SCENE, "series",
		                    "%s needs a line of names above the numbers, with %s and one or more of "
		                    "the others: %s", table->path, table->wanted[0], list);
	table->columns = table->names;
	return HAWSER_OK;
}

/* The displacement with the largest value; metres before coordinates. */
static int largest(const struct table *table)
{
	int best = -1;
	double most = -1.0;

	for (int kind = 1; kind <= 2 && best < 0; kind++)
		for (int k = 0; k < table->names; k++)
			for (int i = 0; displacement(table, k) == kind && i < table->rows; i++)
				if (fabs(table->cell[i*table->columns + k]) > most) {
					most = fabs(table->cell[i*table->columns + k]);
					best = k;
				}
	return best;
}

/* --- lines --- */

static enum hawser_status read_names(struct table *table, const char *line,
                                     struct hawser_report *report)
{
	free(table->name);
	table->names = 0;
	table->name = calloc(most_columns, sizeof *table->name);
	if (!table->name)
		return hawser__no_memory(report, "series");
	for (line += strspn(line, blank); *line && table->names < most_columns;
	     line += strspn(line, blank)) {
		int length = (int)strcspn(line, blank);

		snprintf(table->name[table->names++], CLI_COLUMN_NAME, "%.*s",
		         length < CLI_COLUMN_NAME ? length : CLI_COLUMN_NAME - 1, line);
		line += length;
	}
	return HAWSER_OK;
}

static enum hawser_status read_row(struct table *table, const char *line, int number,
                                   struct hawser_report *report)
{
	double *cell;

	if (hawser__more(&table->cell, table->rows, (size_t)table->columns*sizeof *cell))
		return hawser__no_memory(report, "series");
	cell = table->cell + (size_t)table->rows*(size_t)table->columns;
	for (int k = 0; k < table->columns; k++) {
		char *end;

		line += strspn(line, blank);
		cell[k] = strtod(line, &end);
		if (end == line)
			return hawser__fail(report, HAWSER_ERR_SCENE, "series", "%s:%d: no number in column %d",
			                    table->path, number, k + 1);
		line = end;
	}
	table->rows++;
	return HAWSER_OK;
}

static enum hawser_status read_lines(struct table *table, FILE *stream, const char *x,
                                     const char *y, struct hawser_report *report)
{
	char *line = malloc(longest_line);
	enum hawser_status status = line ? HAWSER_OK : hawser__no_memory(report, "series");

	for (int number = 1; !status && fgets(line, longest_line, stream); number++) {
		const char *first = line + strspn(line, blank);

		if (!*first || *first == '#')
			continue;
		if (isalpha((unsigned char)*first) && table->rows == 0) {
			status = read_names(table, line, report);
			continue;
		}
		if (table->rows == 0)
			status = table->wanted ? all_columns(table, report) : choose(table, x, y, report);
		if (!status)
			status = read_row(table, line, number, report);
	}
	if (!status && ferror(stream))
		status = hawser__fail(report, hawser__unreadable(errno), "series", "cannot read %s: %s",
		                      table->path, strerror(errno));
	free(line);
	return status;
}

/* --- the two columns --- */

static void name_of(char name[CLI_COLUMN_NAME], const struct table *table, int column)
{
	if (column < table->names)
		snprintf(name, CLI_COLUMN_NAME, "%s", table->name[column]);
	else
		snprintf(name, CLI_COLUMN_NAME, "column %d", column + 1);
}

static enum hawser_status take(struct cli_series *series, struct table *table,
                               struct hawser_report *report)
{
	if (table->rows == 0)
		return HAWSER_OK;
	if (table->y < 0)
		table->y = largest(table);
	series->x = malloc((size_t)table->rows*sizeof *series->x);
	series->y = malloc((size_t)table->rows*sizeof *series->y);
	if (!series->x || !series->y)
		return hawser__no_memory(report, "series");
	for (int i = 0; i < table->rows; i++) {
		const double *cell = table->cell + (size_t)i*(size_t)table->columns;

		series->x[i] = cell[table->x];
		series->y[i] = table->y < 0 ? NAN : cell[table->y];
	}
	series->count = table->rows;
	name_of(series->x_name, table, table->x);
	name_of(series->y_name, table, table->y < 0 ? 1 : table->y);
	return HAWSER_OK;
}

static enum hawser_status read_table(struct table *table, const char *x, const char *y,
                                     struct hawser_report *report)
{
	int standard = strcmp(table->path, "-") == 0;
	FILE *stream = standard ? stdin : fopen(table->path, "r");
	enum hawser_status status;

	if (!stream)
		return hawser__fail(report, hawser__unreadable(errno), "series", "cannot read %s: %s",
		                    table->path, strerror(errno));
	status = read_lines(table, stream, x, y, report);
	if (!standard)
		fclose(stream);
	return status;
}

enum hawser_status cli_series_read(struct cli_series *series, const char *path, const char *x,
                                   const char *y, struct hawser_report *report)
{
	struct table table = {.path = path};
	enum hawser_status status = read_table(&table, x, y, report);

	if (!status)
		status = take(series, &table, report);
	free(table.cell);
	free(table.name);
	return status;
}

enum hawser_status cli_columns_read(double **column, int *rows, const char *path,
                                    const char *const *name, int names,
                                    struct hawser_report *report)
{
	struct table table = {.path = path, .wanted = name, .wanteds = names};
	enum hawser_status status = read_table(&table, NULL, NULL, report);

	memset(column, 0, (size_t)names*sizeof *column);
	*rows = table.rows;
	if (!status && table.rows < 2)
		status = hawser__fail(report, HAWSER_ERR_SCENE, "series", "%s: give two rows or more", path);
	for (int k = 0; k < table.columns && !status; k++) {
		double *to = malloc((size_t)table.rows*sizeof *to);
		int w = wanted(&table, k);

		free(column[w]);
		column[w] = to;
		if (!to)
			status = hawser__no_memory(report, "series");
		for (int i = 0; i < table.rows && to; i++)
			to[i] = table.cell[(size_t)i*(size_t)table.columns + (size_t)k];
	}
	for (int w = 0; w < names && status; w++) {
		free(column[w]);
		column[w] = NULL;
	}
	free(table.cell);
	free(table.name);
	return status;
}

void cli_series_clear(struct cli_series *series)
{
	if (!series)
		return;
	free(series->x);
	free(series->y);
	*series = (struct cli_series){0};
}
