/* tow/trajectory_file.c - waypoints from a text file: a line t x y z each.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/locale.h"
#include "core/report.h"
#include "tow/trajectory.h"

enum { COLUMNS = 4, MOST_COLUMNS = 64, LINE = 4096, MOST = 1000000 /* of waypoints */ };
static const char blank[] = " \t,;\r\n", where[] = "trajectory";
/* The name of a column, without and with its unit. */
static const char *const name[COLUMNS][2] = {{"t", "t_s"}, {"x", "x_m"}, {"y", "y_m"}, {"z", "z_m"}};

struct table {
	const char *path;
	int line, named;
	int column[COLUMNS]; /* where t, x, y, z are */
	struct hawser_waypoint *point; /* [count] */
	int count;
};

/* A line of names; fails if one of the four is not there. */
static enum hawser_status read_names(struct table *table, const char *line,
                                     struct hawser_report *report)
{
	int found[COLUMNS] = {0}, number = 0;

	for (line += strspn(line, blank); *line && number < MOST_COLUMNS; number++) {
		size_t length = strcspn(line, blank);

		for (int c = 0; c < COLUMNS; c++)
			for (int k = 0; k < 2; k++)
				if (strlen(name[c][k]) == length && !strncmp(name[c][k], line, length)) {
					table->column[c] = number;
					found[c] = 1;
				}
		line += length;
		line += strspn(line, blank);
	}
	table->named = 1;
	for (int c = 0; c < COLUMNS; c++)
		if (!found[c])
			return hawser__fail(report, HAWSER_ERR_SCENE, where, "%s:%d: no column %s: a line of a "
			                    "path is t x y z in s and m, or the columns have the names t_s, "
			                    "x_m, y_m and z_m", table->path, table->line, name[c][1]);
	return HAWSER_OK;
}

static enum hawser_status add(struct table *table, const double value[COLUMNS],
                              struct hawser_report *report)
{
	struct hawser_waypoint *one;

	if (table->count == MOST)
		return hawser__fail(report, HAWSER_ERR_SCENE, where, "%s:%d: more than %d waypoints: leave "
		                    "out some of them", table->path, table->line, MOST);
	if (hawser__more(&table->point, table->count, sizeof *table->point))
		return hawser__no_memory(report, where);
	one = &table->point[table->count];
	memset(one, 0, sizeof *one);
	one->t = value[0];
	memcpy(one->at[0], &value[1], sizeof one->at[0]);
	if (table->count && !(one->t > one[-1].t))
		return hawser__fail(report, HAWSER_ERR_SCENE, where, "%s:%d: t is %.10g s, but that of the "
		                    "waypoint before it is %.10g s: times must increase", table->path,
		                    table->line, one->t, one[-1].t);
	table->count++;
	return HAWSER_OK;
}

static enum hawser_status read_numbers(struct table *table, const char *line,
                                       struct hawser_report *report)
{
	double value[COLUMNS] = {0.0};
	int number = 0, found = 0;

	for (line += strspn(line, blank); *line && *line != '#' && number < MOST_COLUMNS; number++) {
		size_t length = strcspn(line, blank);
		char *end;
		double one = strtod(line, &end);

		if (!table->named && number == COLUMNS)
			return hawser__fail(report, HAWSER_ERR_SCENE, where, "%s:%d: more than the four "
			                    "columns t x y z: name them in a first line t_s x_m y_m z_m",
			                    table->path, table->line);
		for (int c = 0; c < COLUMNS; c++) {
			if (table->column[c] != number)
				continue;
			if (end != line + length || !isfinite(one))
				return hawser__fail(report, HAWSER_ERR_SCENE, where, "%s:%d: %s is \"%.*s\", but "
				                    "must be a finite number", table->path, table->line, name[c][1],
				                    (int)(length < 40 ? length : 40), line);
			value[c] = one;
			found++;
		}
		line += length;
		line += strspn(line, blank);
	}
	if (!number)
		return HAWSER_OK;
	if (found < COLUMNS)
		return hawser__fail(report, HAWSER_ERR_SCENE, where, "%s:%d: a line of a path is t x y z, "
		                    "in s and m, and %d of them are there", table->path, table->line, found);
	return add(table, value, report);
}

static int begins_with_number(const char *line)
{
	char *end;

	line += strspn(line, blank);
	(void)strtod(line, &end);
	return end != line;
}

static enum hawser_status read_line(struct table *table, const char *line, struct hawser_report *report)
{
	const char *first = line + strspn(line, blank);

	if (strlen(line) + 1 >= LINE)
		return hawser__fail(report, HAWSER_ERR_SCENE, where, "%s:%d: the line has more than %d "
		                    "characters", table->path, table->line, LINE - 2);
	if (!*first || *first == '#')
		return HAWSER_OK;
	if (!table->named && !table->count && !begins_with_number(first))
		return read_names(table, first, report);
	return read_numbers(table, first, report);
}

enum hawser_status hawser__path_read(struct hawser_waypoint **point, int *count, const char *path,
                                     struct hawser_report *report)
{
	struct table table = {.path = path, .column = {0, 1, 2, 3}};
	FILE *stream = fopen(path, "r");
	struct hawser__locale locale;
	char line[LINE];
	enum hawser_status status = HAWSER_OK;

	*point = NULL;
	*count = 0;
	if (!stream)
		return hawser__fail(report, hawser__unreadable(errno), where, "cannot open %s: %s", path,
		                    strerror(errno));
	hawser__locale_begin(&locale);
	while (!status && fgets(line, sizeof line, stream)) {
		table.line++;
		status = read_line(&table, line, report);
	}
	hawser__locale_end(&locale);
	if (!status && ferror(stream))
		status = hawser__fail(report, hawser__unreadable(errno), where, "cannot read %s: %s", path,
		                      strerror(errno));
	fclose(stream);
	if (!status && table.count < 2)
		status = hawser__fail(report, HAWSER_ERR_SCENE, where, "%s: a path needs at least 2 "
		                      "waypoints, lines t x y z in s and m, and %d is there", path,
		                      table.count);
	if (status) {
		free(table.point);
		return status;
	}
	*point = table.point;
	*count = table.count;
	return HAWSER_OK;
}
