/* output/drawing/picture_choice.c - what the user has chosen of pictures: size, title, ranges of
 * the axes.
 *
 * A title needs room above: the function up() of the script (gnuplot.c) makes all vertical places
 * smaller. figure.c asks for the ranges.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "output/output.h"
#include "output/drawing/picture_choice.h"

#define TITLE_CM 0.9 /* height of the line of the title */

static struct hawser__picture_choice chosen;

void hawser__picture_choose(const struct hawser__picture_choice *choice)
{
	chosen = *choice;
}

double hawser__picture_below_title(double height)
{
	double all = chosen.height > 0.0 ? chosen.height : height + TITLE_CM;

	return chosen.title ? 1.0 - TITLE_CM/all : 1.0;
}

double hawser__picture_size(double size[2], double width, double height)
{
	double factor;

	size[0] = chosen.width > 0.0 ? chosen.width : width;
	size[1] = chosen.height > 0.0 ? chosen.height : height + (chosen.title ? TITLE_CM : 0.0);
	factor = fmin(size[0]/width, size[1]*hawser__picture_below_title(height)/height);
	return factor < 1.0 ? factor : 1.0;
}

void hawser__picture_title(FILE *script)
{
	if (!chosen.title)
		return;
	fputs("set label 1002 '", script);
	hawser__picture_literal(script, chosen.title, 0);
	fputs("' at screen 0.5, screen 0.5*(1.0 + up(1.0)) center font ',13'\n", script);
}

const struct hawser__picture_range *hawser__picture_range_of(int axis)
{
	return chosen.range[axis].given ? &chosen.range[axis] : NULL;
}

enum hawser_status hawser__picture_logarithmic(char axis, struct hawser_report *report)
{
	const struct hawser__picture_range *range = &chosen.range[axis == 'y'];

	if (!range->given || (range->high > 0.0 && (range->low > 0.0 || isinf(range->low))))
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "picture",
	                    "--%crange %s: the axis is logarithmic: give limits above 0", axis,
	                    range->text);
}
