/* output/report/vtk.h - places, lines and what belongs to them as a legacy VTK file (PolyData,
 * ASCII), for programs such as ParaView. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_VTK_H
#define HAWSER_OUTPUT_VTK_H

#include <hawser/status.h>

struct hawser__vtk {
	const char *title;    /* one line; cut to 255 characters */
	int points, lines;
	const double (*x)[3]; /* [points] */
	const int (*end)[2];  /* [lines] points; NULL: from each point to the next */
	int scalars;          /* of lines: */
	const struct hawser__vtk_scalar {
		const char *name;     /* without white space */
		const double *value;  /* [lines] */
	} *scalar;            /* [scalars] */
	int marks;            /* of points: */
	const struct hawser__vtk_scalar *mark; /* [marks], with value [points] */
	int vectors;          /* of points: vector_1 and so on */
	const char *vector;   /* such as "mode" */
	const double (*shape)[3]; /* [vectors*points] */
	const char *field;    /* a number for each vector, or NULL */
	const double *number; /* [vectors] */
};
/* The file is written whole or not at all. HAWSER_ERR_NAN names a number that is not finite. */
enum hawser_status hawser__vtk_write(const char *path, const struct hawser__vtk *vtk,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* STEM.vtk.series: the times [files] of the files STEM-00000.vtk and so on, for ParaView. */
enum hawser_status hawser__vtk_series(const char *stem, const double *time, int files,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
