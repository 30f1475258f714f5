/* cli/measure/measured.c - see series.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/measure/series.h"
#include "core/report.h"

enum { most_columns = 64, longest_line = 4096, most_rows = 100 };
static const char blank[] = " \t,;\r\n", where[] = "identify";

/* What a column contains. */
enum content { SKIPPED = 0, OMEGA, HERTZ, OMEGA_DEVIATION, HERTZ_DEVIATION, PLANE, INDEX, NUMBER };
static const struct {
	const char *name;
	enum content content;
} names[] = {
	{"omega_rad_s", OMEGA}, {"frequency_Hz", HERTZ}, {"deviation_rad_s", OMEGA_DEVIATION},
	{"deviation_Hz", HERTZ_DEVIATION}, {"plane", PLANE}, {"index", INDEX}, {"number", NUMBER},
};
enum { NAMES = sizeof names/sizeof *names };

struct table {
	const char *path;
	enum content column[most_columns];
	int columns, line, named;
	struct hawser_measured *row; /* [most_rows] */
	int rows;
};

static enum hawser_status read_names(struct table *table, const char *line,
                                     struct hawser_report *report)
{
	int frequencies = 0;

	for (line += strspn(line, blank); *line && table->columns < most_columns;
	     line += strspn(line, blank)) {
		size_t length = strcspn(line, blank);
		enum content content = SKIPPED;

		for (int k = 0; k < NAMES; k++)
			if (strlen(names[k].name) == length && !strncmp(names[k].name, line, length))
				content = names[k].content;
		frequencies += content == OMEGA || content == HERTZ;
		table->column[table->columns++] = content;
		line += length;
	}
	table->named = 1;
	return frequencies > 0
	       ? HAWSER_OK
	       : hawser__fail(report, HAWSER_ERR_SCENE, where,
	                      "%s:%d: no column of frequencies: name it frequency_Hz or omega_rad_s",
	                      table->path, table->line);
}

static enum hawser_status number(double *value, const struct table *table, int column,
                                 const char *cell, size_t length, struct hawser_report *report)
{
	char *end;

	*value = strtod(cell, &end);
	if (end == cell + length && isfinite(*value) && *value >= 0.0)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_SCENE, where,
	                    "%s:%d: \"%.*s\" in column %d is not a number that is finite and not negative",
	                    table->path, table->line, (int)(length < 40 ? length : 40), cell, column + 1);
}

static enum hawser_status whole(int *value, const struct table *table, int column, double from,
                                struct hawser_report *report)
{
	if (from < 1.0 || from > most_rows || from != floor(from))
		return hawser__fail(report, HAWSER_ERR_SCENE, where,
		                    "%s:%d: %g in column %d: the number of a mode is from 1 to %d, and - if "
		                    "it is not known", table->path, table->line, from, column + 1, most_rows);
	*value = (int)from;
	return HAWSER_OK;
}

static enum hawser_status read_plane(int *plane, const struct table *table, const char *cell,
                                     size_t length, struct hawser_report *report)
{
	for (int k = 0; k < 2; k++) {
		const char *name = hawser_plane_name((enum hawser_plane)k);

		if (strlen(name) == length && !strncmp(name, cell, length)) {
			*plane = k;
			return HAWSER_OK;
		}
	}
	return hawser__fail(report, HAWSER_ERR_SCENE, where,
	                    "%s:%d: the plane \"%.*s\": write in-plane, out-of-plane, or - if it is not "
	                    "known", table->path, table->line, (int)(length < 40 ? length : 40), cell);
}

static enum hawser_status read_cell(struct hawser_measured *row, const struct table *table,
                                    int column, const char *cell, size_t length,
                                    struct hawser_report *report)
{
	enum content content = table->column[column];
	double value = 0.0;
	enum hawser_status status;

	if (content == SKIPPED || (length == 1 && *cell == '-' && content >= PLANE))
		return HAWSER_OK;
	if (content == PLANE)
		return read_plane(&row->plane, table, cell, length, report);
	status = number(&value, table, column, cell, length, report);
	if (status)
		return status;
	if (content == OMEGA || (content == HERTZ && row->omega == 0.0))
		row->omega = content == OMEGA ? value : 2.0*M_PI*value;
	else if (content == OMEGA_DEVIATION || content == HERTZ_DEVIATION)
		row->deviation = content == OMEGA_DEVIATION ? value : 2.0*M_PI*value;
	else if (content == INDEX || content == NUMBER)
		return whole(content == INDEX ? &row->place : &row->number, table, column, value, report);
	return HAWSER_OK;
}

static enum hawser_status read_row(struct table *table, const char *line,
                                   struct hawser_report *report)
{
	struct hawser_measured row = {.plane = -1};
	int column = 0;

	if (table->rows == most_rows)
		return hawser__fail(report, HAWSER_ERR_SCENE, where, "%s:%d: more than %d frequencies",
		                    table->path, table->line, most_rows);
	if (!table->named) {
		table->column[0] = HERTZ;
		table->columns = 1;
	}
	for (line += strspn(line, blank); *line && column < table->columns; column++) {
		size_t length = strcspn(line, blank);
		enum hawser_status status = read_cell(&row, table, column, line, length, report);

		if (status)
			return status;
		line += length;
		line += strspn(line, blank);
	}
	if (column < table->columns)
		return hawser__fail(report, HAWSER_ERR_SCENE, where,
		                    "%s:%d: %d of %d columns; write - for what is not known", table->path,
		                    table->line, column, table->columns);
	if (row.place > 0)
		row.number = 0; /* of all modes, which is enough */
	table->row[table->rows++] = row;
	return HAWSER_OK;
}

static enum hawser_status read_lines(struct table *table, FILE *stream,
                                     struct hawser_report *report)
{
	char line[longest_line];
	enum hawser_status status = HAWSER_OK;

	while (!status && fgets(line, sizeof line, stream)) {
		const char *first = line + strspn(line, blank);

		table->line++;
		if (!*first || *first == '#')
			continue;
		status = isalpha((unsigned char)*first) && !table->rows && !table->named
		         ? read_names(table, line, report) : read_row(table, line, report);
	}
	if (!status && ferror(stream))
		status = hawser__fail(report, hawser__unreadable(errno), where, "cannot read %s: %s",
		                      table->path, strerror(errno));
	if (!status && table->rows == 0)
		status = hawser__fail(report, HAWSER_ERR_SCENE, where, "%s has no frequencies",
		                      table->path);
	return status;
}

enum hawser_status cli_measured_read(struct hawser_measured **measured, int *count,
                                     const char *path, struct hawser_report *report)
{
	struct table table = {.path = path};
	int standard = strcmp(path, "-") == 0;
	FILE *stream = standard ? stdin : fopen(path, "r");
	enum hawser_status status;

	if (!stream)
		return hawser__fail(report, hawser__unreadable(errno), where, "cannot read %s: %s", path,
		                    strerror(errno));
	table.row = malloc(most_rows*sizeof *table.row);
	status = table.row ? read_lines(&table, stream, report) : hawser__no_memory(report, where);
	if (!standard)
		fclose(stream);
	if (status) {
		free(table.row);
		table.row = NULL;
	}
	*measured = table.row;
	*count = table.rows;
	return status;
}
