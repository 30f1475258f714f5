/* contact/heights_read.c - beds of scenes: a profile, places along x; and the file of a grid, which is
 * one of three:
 *
 *   x y z                       a point in each line, in any order, y upwards; every x with every z
 *   nx ny / x... / y... / x y z    as MoorDyn-C has it, z upwards (SeafloorFile)
 *   nGridX n / nGridY n / x... / y depth...    as MoorDyn-F and MoorPy have it, depths downwards
 *
 * Of the axes of these programs x is x, z is y, and y is -z here. A line that begins with # or dashes
 * is no point, nor is an empty one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "contact/heights.h"
#include "core/grow.h"
#include "core/locale.h"
#include "core/report.h"

enum { MOST = 4000000 }; /* points: 32 MB */

/* Numbers of a line of the file. */
struct row {
	int line, first, count;
};
struct grid {
	const char *path;
	struct hawser_report *report;
	double *value, *x, *z, *y;
	struct row *row;
	int values, rows, nx, nz, given[2]; /* given: nGridX and nGridY */
};

static enum hawser_status wrong(const struct grid *grid, int line, const char *format, ...)
	HAWSER_PRINTF(3, 4);
static enum hawser_status wrong(const struct grid *grid, int line, const char *format, ...)
{
	char text[300], place[20] = "";
	va_list args;

	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	if (line > 0)
		snprintf(place, sizeof place, ":%d", line);
	return hawser__fail(grid->report, HAWSER_ERR_SCENE, "scene", "%s%s: %s", grid->path, place, text);
}

static enum hawser_status parse(struct grid *grid, int line, char *text)
{
	static const char *const counts[] = {"nGridX", "nGridY"};
	struct row row = {line, grid->values, 0};
	char *at = text + strspn(text, " \t\r\n"), *end;

	for (int k = 0; k < 2; k++)
		if (!strncasecmp(at, counts[k], strlen(counts[k]))) {
			grid->given[k] = (int)strtol(at + strlen(counts[k]), NULL, 10);
			return grid->given[k] >= 2 ? HAWSER_OK
				: wrong(grid, line, "%s must be a number from 2 on", counts[k]);
		}
	if (!strncmp(at, "--", 2))
		return HAWSER_OK;
	while (*at && *at != '#') {
		double value = strtod(at, &end);

		if (end == at || !isfinite(value))
			return wrong(grid, line, "'%.*s' is not a number: a grid has numbers in m alone, behind #, "
			             "dashes, nGridX and nGridY", (int)strcspn(at, " \t\r\n"), at);
		if (grid->values >= 3*MOST || hawser__more(&grid->value, grid->values, sizeof value))
			return hawser__no_memory(grid->report, "scene");
		grid->value[grid->values++] = value;
		at = end + strspn(end, " \t\r\n,");
	}
	row.count = grid->values - row.first;
	if (!row.count)
		return HAWSER_OK;
	if (hawser__more(&grid->row, grid->rows, sizeof row))
		return hawser__no_memory(grid->report, "scene");
	grid->row[grid->rows++] = row;
	return HAWSER_OK;
}

static enum hawser_status parse_all(struct grid *grid)
{
	FILE *file = fopen(grid->path, "r");
	struct hawser__locale locale;
	enum hawser_status status = HAWSER_OK;
	char *line = NULL;
	size_t room = 0;

	if (!file)
		return wrong(grid, 0, "%s", strerror(errno));
	hawser__locale_begin(&locale);
	for (int number = 1; !status && getline(&line, &room, file) >= 0; number++)
		status = parse(grid, number, line);
	hawser__locale_end(&locale);
	free(line);
	if (!status && ferror(file))
		status = wrong(grid, 0, "it cannot be read");
	fclose(file);
	if (!status && !grid->rows)
		status = wrong(grid, 0, "no points");
	return status;
}

/* Room for the grid. */
static enum hawser_status room(struct grid *grid, int nx, int nz)
{
	grid->nx = nx;
	grid->nz = nz;
	if (nx < 2 || nz < 2 || (double)nx*nz > MOST)
		return wrong(grid, 0, "a grid of %d by %d points: it has two or more along each axis, and %d "
		             "in all at most", nx, nz, MOST);
	grid->x = calloc((size_t)nx + (size_t)nz + (size_t)nx*(size_t)nz, sizeof *grid->x);
	if (!grid->x)
		return hawser__no_memory(grid->report, "scene");
	grid->z = grid->x + nx;
	grid->y = grid->z + nz;
	for (int i = 0; i < nx*nz; i++)
		grid->y[i] = NAN;
	return HAWSER_OK;
}

/* The coordinates of a line, times sign, into `to` upwards. */
static enum hawser_status axis(double *to, const struct grid *grid, int row, int from, int count,
                               double sign, const char *name)
{
	const double *value = &grid->value[grid->row[row].first + from];

	for (int i = 0; i < count; i++) {
		to[sign < 0.0 ? count - 1 - i : i] = sign*value[i];
		if (i > 0 && !(value[i] > value[i - 1]))
			return wrong(grid, grid->row[row].line, "%s %.9g m is not above the one before, %.9g m: "
			             "sort them upwards", name, value[i], value[i - 1]);
	}
	return HAWSER_OK;
}

/* Of a file whose axis of heights may have been taken the wrong way: the bed is not all above z = 0. */
static enum hawser_status below(const struct grid *grid, const char *rule)
{
	double most = -INFINITY, least = INFINITY;

	for (int i = 0; i < grid->nx*grid->nz; i++) {
		most = fmax(most, grid->y[i]);
		least = fmin(least, grid->y[i]);
	}
	return !(least > 0.0) ? HAWSER_OK
		: wrong(grid, 0, "all points are above z = 0, from %.6g to %.6g m: %s", least, most, rule);
}

/* nGridX, nGridY: a line of x, then lines of y and the depths there. */
static enum hawser_status by_depths(struct grid *grid)
{
	const int nx = grid->given[0], nz = grid->given[1];
	enum hawser_status status = room(grid, nx, nz);

	if (!status && grid->rows != nz + 1)
		return wrong(grid, 0, "%d lines of numbers: with nGridY %d there is one of x, and %d that "
		             "begin with their y", grid->rows, nz, nz);
	for (int j = 0; j <= nz && !status; j++) {
		const struct row *row = &grid->row[j];
		const double *value = &grid->value[row->first];

		if (row->count != nx + (j > 0))
			return wrong(grid, row->line, "%d numbers: with nGridX %d there are %d%s", row->count, nx,
			             nx + (j > 0), j ? ", y and the depths" : " x");
		if (j == 0) {
			status = axis(grid->x, grid, 0, 0, nx, 1.0, "x");
			continue;
		}
		if (j > 1 && !(value[0] > grid->value[row[-1].first]))
			return wrong(grid, row->line, "y %.9g m is not above that of the line before, %.9g m: sort "
			             "the lines upwards", value[0], grid->value[row[-1].first]);
		grid->z[nz - j] = -value[0];
		for (int i = 0; i < nx; i++)
			grid->y[(nz - j)*nx + i] = -value[1 + i];
	}
	return status ? status
		: below(grid, "depths are downwards in such a file, so that the bed has positive ones");
}

static int upwards(const void *a, const void *b)
{
	const double *one = a, *other = b;

	return (*one > *other) - (*one < *other);
}

/* Column k of the points, each value once, upwards. */
static int column(double *to, const struct grid *grid, int k)
{
	int count = 0;

	for (int i = 0; i < grid->rows; i++)
		to[i] = grid->value[grid->row[i].first + k];
	qsort(to, (size_t)grid->rows, sizeof *to, upwards);
	for (int i = 0; i < grid->rows; i++)
		if (count == 0 || to[i] > to[count - 1])
			to[count++] = to[i];
	return count;
}

/* Points in lines from `first` on: x, and the height in this column; z is the other one times sign. */
static enum hawser_status by_points(struct grid *grid, int first, int height, double sign)
{
	const int other = 3 - height;

	for (int r = first; r < grid->rows; r++) {
		const struct row *row = &grid->row[r];
		double key[2], *x, *z, *y;

		if (row->count != 3)
			return wrong(grid, row->line, "%d numbers: a point has three", row->count);
		key[0] = grid->value[row->first];
		key[1] = sign*grid->value[row->first + other];
		x = bsearch(&key[0], grid->x, (size_t)grid->nx, sizeof *x, upwards);
		z = bsearch(&key[1], grid->z, (size_t)grid->nz, sizeof *z, upwards);
		if (!x || !z)
			return wrong(grid, row->line, "%.9g m is none of the coordinates at the top of the file",
			             x ? sign*key[1] : key[0]);
		y = &grid->y[(z - grid->z)*grid->nx + (x - grid->x)];
		if (!isnan(*y))
			return wrong(grid, row->line, "the point at (%.9g, %.9g) m is there already", key[0],
			             sign*key[1]);
		*y = grid->value[row->first + height];
	}
	for (int i = 0; i < grid->nx*grid->nz; i++)
		if (isnan(grid->y[i]))
			return wrong(grid, 0, "no point at (%.9g, %.9g) m: a grid has one for each x with each %s",
			             grid->x[i % grid->nx], sign*grid->z[i/grid->nx], sign < 0.0 ? "y" : "z");
	return HAWSER_OK;
}

/* The numbers of x and y, lines with them, then points with z upwards. */
static enum hawser_status by_lists(struct grid *grid)
{
	const double *count = grid->value;
	enum hawser_status status;

	if (!(count[0] >= 2.0 && count[1] >= 2.0 && count[0] <= MOST && count[1] <= MOST))
		return wrong(grid, grid->row[0].line, "numbers of points along x and y must be from 2 on, and "
		             "they are %g and %g", count[0], count[1]);
	status = room(grid, (int)count[0], (int)count[1]);
	for (int k = 0; k < 2 && !status; k++)
		if (grid->rows < 3 || grid->row[1 + k].count != (k ? grid->nz : grid->nx))
			status = wrong(grid, grid->row[grid->rows < 2 + k ? 0 : 1 + k].line, "after the numbers of "
			               "points there is a line with %d x, and one with %d y", grid->nx, grid->nz);
	if (!status)
		status = axis(grid->x, grid, 1, 0, grid->nx, 1.0, "x");
	if (!status)
		status = axis(grid->z, grid, 2, 0, grid->nz, -1.0, "y");
	if (!status)
		status = by_points(grid, 3, 2, -1.0);
	return status ? status
		: below(grid, "z is upwards in such a file, so that the bed has negative ones");
}

static enum hawser_status by_table(struct grid *grid)
{
	double *x = calloc(2*(size_t)grid->rows, sizeof *x), *z = x ? x + grid->rows : NULL;
	enum hawser_status status = x ? HAWSER_OK : hawser__no_memory(grid->report, "scene");

	for (int r = 0; r < grid->rows && !status; r++)
		if (grid->row[r].count != 3)
			status = wrong(grid, grid->row[r].line, "%d numbers: a point has three, x, y and z in m, y "
			               "upwards", grid->row[r].count);
	if (!status) {
		int nx = column(x, grid, 0), nz = column(z, grid, 2);

		status = room(grid, nx, nz);
		if (!status) {
			memcpy(grid->x, x, (size_t)nx*sizeof *x);
			memcpy(grid->z, z, (size_t)nz*sizeof *z);
			status = by_points(grid, 0, 1, 1.0);
		}
	}
	free(x);
	return status;
}

static enum hawser_status read_grid(struct hawser__reader *reader, struct hawser_surface *surface,
                                    const struct hawser__tree *tree, const char *section, double round)
{
	struct hawser_report why = {0};
	struct grid grid = {.path = surface->file, .report = &why};
	enum hawser_status status = parse_all(&grid);

	if (!status)
		status = grid.given[0] && grid.given[1] ? by_depths(&grid)
			: grid.row[0].count == 2 ? by_lists(&grid) : by_table(&grid);
	if (!status)
		status = hawser_heights_make(&surface->heights, grid.nx, grid.x, grid.nz, grid.z, grid.y,
		                             round, &why);
	free(grid.value);
	free(grid.row);
	free(grid.x);
	return !status ? HAWSER_OK
		: why.status == HAWSER_ERR_MEMORY ? hawser__no_memory(reader->report, "scene")
		: hawser__reader_fail(reader, &tree->at, "%s.grid: %s", section, why.message);
}

static enum hawser_status read_profile(struct hawser__reader *reader, struct hawser_surface *surface,
                                       const struct hawser__tree *tree, const char *section,
                                       double round)
{
	const int points = tree->children;
	double *x = calloc(2*(size_t)points + 1, sizeof *x), *y = x ? x + points : NULL, at[2];
	char what[HAWSER__TEXT_ROOM + 80];
	enum hawser_status status = x ? HAWSER_OK : hawser__no_memory(reader->report, "scene");
	int i = 0;

	snprintf(what, sizeof what, "%s.profile", section);
	if (!status && (tree->kind != HAWSER__SEQUENCE || points < 2))
		status = hawser__reader_fail(reader, &tree->at, "%s must be a list of two or more places, such "
		                             "as [[0 m, -200 m], [800 m, -210 m]]", what);
	for (const struct hawser__tree *one = status ? NULL : tree->child; one && !status;
	     one = one->next, i++) {
		status = hawser__tree_vector(reader, at, 2, one, what, "m");
		if (status)
			break;
		x[i] = at[0];
		y[i] = at[1];
		if (i > 0 && !(x[i] > x[i - 1]))
			status = hawser__reader_fail(reader, &one->at, "%s: x must rise from place to place: %.9g "
			                             "m is not above %.9g m", what, x[i], x[i - 1]);
	}
	if (!status)
		status = hawser_heights_make(&surface->heights, points, x, 1, NULL, y, round, reader->report);
	free(x);
	return status;
}

enum hawser_status hawser__heights_read(struct hawser__reader *reader, struct hawser_surface *surface,
                                        const struct hawser__tree *tree, const char *section,
                                        double round)
{
	const struct hawser__tree *grid = hawser__tree_find(tree, "grid");

	return grid ? read_grid(reader, surface, grid, section, round)
		: read_profile(reader, surface, hawser__tree_find(tree, "profile"), section, round);
}
