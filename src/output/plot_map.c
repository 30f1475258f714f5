/* output/plot_map.c - a map over two parameters: colours, and the boundaries as lines.
 *
 * What has no value shows the grey ground. Colours are those of viridis, whose lightness rises evenly.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"

static const char *const colour[] = {"#440154", "#46327e", "#365c8d", "#277f8e", "#1fa187", "#4ac16d",
                                     "#a0da39", "#fde725"};
enum { COLOURS = sizeof colour/sizeof *colour };

static void range_of(double *low, double *high, const struct hawser__map_picture *map)
{
	long count = (long)map->nx*map->ny;

	*low = INFINITY;
	*high = -INFINITY;
	for (long p = 0; p < count; p++)
		if (isfinite(map->value[p]) && (!map->logarithmic || map->value[p] > 0.0)) {
			*low = fmin(*low, map->value[p]);
			*high = fmax(*high, map->value[p]);
		}
}

static void data(FILE *script, const struct hawser__map_picture *map)
{
	fputs("$map << END\n", script);
	for (int j = 0; j < map->ny; j++) {
		for (int i = 0; i < map->nx; i++) {
			double value = map->value[(long)j*map->nx + i];

			if (isfinite(value))
				fprintf(script, "%.9g %.9g %.6g\n", map->x[i], map->y[j], value);
			else
				fprintf(script, "%.9g %.9g NaN\n", map->x[i], map->y[j]);
		}
		fputc('\n', script);
	}
	fputs("END\n$line << END\n", script);
	for (int k = 0; k < map->segments; k++)
		fprintf(script, "%.12g %.12g\n%.12g %.12g\n\n", map->segment[4*k],
		        map->segment[4*k + 1], map->segment[4*k + 2], map->segment[4*k + 3]);
	fputs("NaN NaN\nEND\n", script);
}

static void even_colours(FILE *script)
{
	fputs("set palette defined (", script);
	for (int k = 0; k < COLOURS; k++)
		fprintf(script, "%s%d '%s'", k ? ", " : "", k, colour[k]);
	fputs(")\n", script);
}

/* A colour for each whole number from low to high. */
static void whole_colours(FILE *script, double low, double high)
{
	int levels = (int)(high - low) + 1;

	fputs("set palette maxcolors 0 defined (", script);
	for (int k = 0; k < levels; k++) {
		const char *one = colour[levels > 1 ? k*(COLOURS - 1)/(levels - 1) : 0];

		fprintf(script, "%s%d '%s', %d '%s'", k ? ", " : "", k, one, k + 1, one);
	}
	fprintf(script, ")\nset cbrange [%g:%g]\nset cbtics %d\n", low - 0.5, high + 0.5,
	        levels > 12 ? 5 : 1);
}

static void colour_bar(FILE *script, const struct hawser__map_picture *map)
{
	double low, high, size, room;

	range_of(&low, &high, map);
	if (!(low <= high)) {
		low = 0.0;
		high = 1.0;
	}
	size = fmax(fabs(low), fabs(high));
	room = high - low > 1e-6*size ? 0.0 : size > 0.0 ? 0.01*size : 1.0; /* one value */
	even_colours(script);
	if (map->whole)
		whole_colours(script, low, high);
	else if (map->logarithmic && high > 5.0*low)
		fprintf(script, "set logscale cb\nset format cb '%%g'\nset cbrange [%.6g:%.6g]\n", low,
		        high);
	else
		fprintf(script, "set cbrange [%.9g:%.9g]\n", low - room, high + room);
	fprintf(script, "set colorbox user origin screen 0.84, screen 0.15 size screen 0.025, "
	                "screen 0.72\nset cbtics out scale 0.5\n");
	fprintf(script, "set label 1001 '%s' at screen 0.13, screen 0.965 left\n", map->title);
}

enum hawser_status hawser__plot_map(const char *path, const struct hawser__map_picture *map,
                                    struct hawser_report *report)
{
	const double height = 11.5;
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 17.0, height, report);
	FILE *script = picture.script;
	double x0 = map->x[0], x1 = map->x[map->nx - 1], y0 = map->y[0], y1 = map->y[map->ny - 1];

	if (status)
		return status;
	data(script, map);
	hawser__picture_panel(&picture, 0.13, 0.82, 0.15, 0.93);
	fprintf(script, "set xrange [%.12g:%.12g]\nset yrange [%.12g:%.12g]\n", x0, x1, y0, y1);
	hawser__picture_tics(&picture, 'x', fmin(x0, x1), fmax(x0, x1), 8);
	hawser__picture_tics(&picture, 'y', fmin(y0, y1), fmax(y0, y1), 8);
	colour_bar(script, map);
	fputs("unset grid\nset border 15 front\n"
	      "set object 1 rectangle from graph 0,0 to graph 1,1 behind fillcolor rgb '#b4b4b4' "
	      "fillstyle solid noborder\n", script);
	fprintf(script, "set xlabel '%s'\n", map->x_title);
	hawser__picture_ylabel(&picture, "%s", map->y_title);
	if (map->holes)
		fputs("set label 1002 'grey: no value' at screen 0.82, screen 0.965 right "
		      "tc rgb '#606060'\n", script);
	fputs("plot $map using 1:2:3 with image, $line using 1:2 with lines lc rgb '#ffffff' "
	      "lw 2.2, $line using 1:2 with lines lc rgb '#D55E00' lw 1.1\n", script);
	return hawser__picture_finish(&picture, report);
}
