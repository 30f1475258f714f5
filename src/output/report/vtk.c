/* output/report/vtk.c - see vtk.h. Numbers have 9 digits, places and shapes need no more.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "core/file.h"
#include "core/report.h"
#include "output/report/vtk.h"

/* Write `size` numbers a line; returns 0 if one of them is not finite. */
static int numbers(FILE *stream, const double *value, size_t count, size_t size)
{
	int finite = 1;

	for (size_t i = 0; i < count*size; i++) {
		finite &= isfinite(value[i]) != 0;
		fprintf(stream, "%.9g%c", value[i], (i + 1) % size ? ' ' : '\n');
	}
	return finite;
}

static int write_all(FILE *stream, const struct hawser__vtk *vtk)
{
	size_t points = (size_t)vtk->points;
	int finite;

	fprintf(stream, "# vtk DataFile Version 3.0\n%.255s\nASCII\nDATASET POLYDATA\n", vtk->title);
	if (vtk->field) {
		fprintf(stream, "FIELD FieldData 1\n%s 1 %d double\n", vtk->field, vtk->vectors);
		numbers(stream, vtk->number, (size_t)vtk->vectors, 1);
	}
	fprintf(stream, "POINTS %d double\n", vtk->points);
	finite = numbers(stream, vtk->x[0], points, 3);
	fprintf(stream, "LINES %d %d\n", vtk->lines, 3*vtk->lines);
	for (int i = 0; i < vtk->lines; i++)
		fprintf(stream, "2 %d %d\n", vtk->end ? vtk->end[i][0] : i, vtk->end ? vtk->end[i][1] : i + 1);
	for (int i = 0; i < vtk->scalars; i++) {
		if (i == 0)
			fprintf(stream, "CELL_DATA %d\n", vtk->lines);
		fprintf(stream, "SCALARS %s double 1\nLOOKUP_TABLE default\n", vtk->scalar[i].name);
		finite &= numbers(stream, vtk->scalar[i].value, (size_t)vtk->lines, 1);
	}
	if (vtk->marks + vtk->vectors > 0)
		fprintf(stream, "POINT_DATA %d\n", vtk->points);
	for (int i = 0; i < vtk->marks; i++) {
		fprintf(stream, "SCALARS %s double 1\nLOOKUP_TABLE default\n", vtk->mark[i].name);
		finite &= numbers(stream, vtk->mark[i].value, points, 1);
	}
	for (int i = 0; i < vtk->vectors; i++) {
		fprintf(stream, "VECTORS %s_%d double\n", vtk->vector, i + 1);
		finite &= numbers(stream, vtk->shape[(size_t)i*points], points, 3);
	}
	return finite;
}

enum hawser_status hawser__vtk_write(const char *path, const struct hawser__vtk *vtk,
                                     struct hawser_report *report)
{
	struct hawser__file file = {0};
	enum hawser_status status = hawser__file_begin(&file, path, report);

	if (!status && !write_all(file.stream, vtk))
		status = hawser__fail(report, HAWSER_ERR_NAN, "vtk",
		                      "%s is not written: a number in it is not finite", path);
	if (status) {
		hawser__file_abort(&file);
		return status;
	}
	return hawser__file_commit(&file, report);
}

enum hawser_status hawser__vtk_series(const char *stem, const double *time, int files,
                                      struct hawser_report *report)
{
	struct hawser__file file = {0};
	const char *slash = strrchr(stem, '/'), *name = slash ? slash + 1 : stem;
	char path[PATH_MAX];
	enum hawser_status status;

	snprintf(path, sizeof path, "%s.vtk.series", stem);
	status = hawser__file_begin(&file, path, report);
	if (status) {
		hawser__file_abort(&file);
		return status;
	}
	fputs("{\"file-series-version\": \"1.0\", \"files\": [\n", file.stream);
	for (int i = 0; i < files; i++) {
		fputs(" {\"name\": \"", file.stream);
		for (const char *c = name; *c; c++)
			fprintf(file.stream, *c == '"' || *c == '\\' ? "\\%c" : "%c", *c);
		fprintf(file.stream, "-%05d.vtk\", \"time\": %.9g}%s\n", i, time[i],
		        i + 1 < files ? "," : "");
	}
	fputs("]}\n", file.stream);
	return hawser__file_commit(&file, report);
}
