/* output/curves/plot_map.c - a map over two parameters: colours, and the boundaries as lines.
 *
 * A quantity that decides stability is blue on the stable side of the boundary and orange on the
 * unstable side. Other quantities have the colours of viridis, whose lightness is linear. Points
 * without a value are grey.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/output.h"
#include "output/drawing/figure.h"

static const char *const colour[] = {"#440154", "#46327e", "#365c8d", "#277f8e", "#1fa187", "#4ac16d",
                                     "#a0da39", "#fde725"};
static const char ground[] = "#b4b4b4"; /* colour of points without a value */
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

/* Centre of pixel k. The pixels fill the axis exactly, so that a centre is at most half a pixel
 * from its sample. */
static double middle(const double *at, int count, int k)
{
	return at[0] + (at[count - 1] - at[0])*(k + 0.5)/count;
}

/* Colours of stable values, from far to close to the boundary; colours of unstable values from it
 * on. */
static const char *const stable[] = {"#08306b", "#2a7ab9", "#7fb9dc", "#deebf7"};
static const char *const unstable[] = {"#fdae6b", "#f16913", "#a63603", "#4d1600"};
enum { SIDE = 4 };

static void draw_pixels(struct hawser__figure *figure, const struct hawser__map_picture *map)
{
	for (int j = 0; j < map->ny; j++) {
		for (int i = 0; i < map->nx; i++)
			hawser__figure_row(figure, "xy.", (double[]){middle(map->x, map->nx, i),
			                   middle(map->y, map->ny, j), map->value[(long)j*map->nx + i]});
		hawser__figure_gap(figure);
	}
	hawser__figure_draw(figure, NULL, "using 1:2:3 with image");
	hawser__map_tongues(figure, map);
	hawser__figure_draw(figure, NULL,
	                    "using 1:2:1:3:2:4 with boxxyerror fillstyle solid noborder lc rgb '%s'",
	                    unstable[1]);
	for (int k = 0; k < map->segments; k++) {
		hawser__figure_put(figure, map->segment[4*k], map->segment[4*k + 1]);
		hawser__figure_put(figure, map->segment[4*k + 2], map->segment[4*k + 3]);
		hawser__figure_gap(figure);
	}
	hawser__figure_draw(figure, NULL, "with lines lc rgb 'black' lw 0.8");
}

static void even_colours(FILE *script)
{
	fputs("set palette defined (", script);
	for (int k = 0; k < COLOURS; k++)
		fprintf(script, "%s%d '%s'", k ? ", " : "", k, colour[k]);
	fputs(")\n", script);
}

/* Position of the boundary in [low, high], as a fraction of the colour bar. */
static double border_part(const struct hawser__map_picture *map, double low, double high,
                          int logarithmic)
{
	double part = logarithmic ? log(map->border/low)/log(high/low) : (map->border - low)/(high - low);

	return fmin(fmax(part, 0.0), 1.0);
}

static void side(FILE *script, const char *const *colours, double from, double to, int *count)
{
	for (int k = 0; k < SIDE && to > from; k++)
		fprintf(script, "%s%.6g '%s'", (*count)++ ? ", " : "", from + (to - from)*k/(SIDE - 1),
		        colours[k]);
}

static void sided_colours(FILE *script, double part)
{
	int count = 0;

	fputs("set palette maxcolors 0 defined (", script);
	side(script, stable, 0.0, part, &count);
	side(script, unstable, part, 1.0, &count);
	fputs(")\n", script);
}

/* A colour for each whole number from low to high; 0 is stable. The least one that is not has the
 * colour that the legend shows. */
static void whole_colours(FILE *script, const struct hawser__map_picture *map, double low, double high)
{
	int levels = (int)(high - low) + 1, least = (int)high;
	long count = (long)map->nx*map->ny;

	for (long p = 0; p < count; p++)
		if (map->value[p] >= 1.0 && map->value[p] < least)
			least = (int)map->value[p];
	fputs("set palette maxcolors 0 defined (", script);
	for (int k = 0; k < levels; k++) {
		int value = (int)low + k, beyond = value > least ? value - least : 0;
		int deeper = beyond ? 1 + (beyond - 1)*(SIDE - 3)/(levels > 2 ? levels - 2 : 1) : 0;
		const char *one = value < 1 ? stable[2] : unstable[1 + deeper];

		fprintf(script, "%s%d '%s', %d '%s'", k ? ", " : "", k, one, k + 1, one);
	}
	fprintf(script, ")\nset cbrange [%g:%g]\nset cbtics %d\n", low - 0.5, high + 0.5,
	        levels > 12 ? 5 : 1);
}

/* Colours of motions without bounds and of those that end at no response; then of responses, again from
 * the first on after the last. */
static const char *const basin_colour[] = {"#f0f0f0", "#4d4d4d", "#56b4e9", "#e69f00", "#009e73",
                                           "#cc79a7", "#f0e442", "#0072b2", "#d55e00"};
enum { BASIN_COLOURS = sizeof basin_colour/sizeof *basin_colour - 2 };

static const char *colour_of_basin(int number)
{
	return basin_colour[number < 1 ? number + 1 : 2 + (number - 1)%BASIN_COLOURS];
}

static void basin_colours(FILE *script, const struct hawser__map_picture *map)
{
	fputs("set palette maxcolors 0 defined (", script);
	for (int k = -1; k <= map->basins; k++)
		fprintf(script, "%s%d '%s', %d '%s'", k >= 0 ? ", " : "", k, colour_of_basin(k), k + 1,
		        colour_of_basin(k));
	fprintf(script, ")\nset cbrange [-1.5:%g]\n", map->basins + 0.5);
}

/* An entry for each number that occurs, up to the room of the legend. */
static void basin_legend(struct hawser__legend *entries, const struct hawser__map_picture *map)
{
	static const char box[] = "with boxes fillstyle solid noborder";
	long count = (long)map->nx*map->ny;

	for (int k = -1; k <= (map->basins < 12 ? map->basins : 12); k++) {
		char title[40];
		long p = 0;

		while (p < count && map->value[p] != k)
			p++;
		if (p == count)
			continue;
		snprintf(title, sizeof title, k > 0 ? "response %d" : k ? "no bounds" : "no periodic response",
		         k);
		hawser__legend_add(entries, title, "%s lc rgb '%s'", box, colour_of_basin(k));
	}
}

static const double height = 12.0, bottom = 2.7/12.0, top = 0.96; /* cm; parts of it */

static void colour_bar(struct hawser__picture *picture, const struct hawser__map_picture *map)
{
	FILE *script = picture->script;
	/* relative difference of values that are drawn as one, and of those on both sides of the border */
	const double same = 1e-3, same_across = 1e-6;
	double low, high, size, room;
	int logarithmic, across;

	range_of(&low, &high, map);
	if (!(low <= high)) {
		low = 0.0;
		high = 1.0;
	}
	logarithmic = map->logarithmic && high > 5.0*low;
	size = fmax(fabs(low), fabs(high));
	across = low < map->border && map->border < high;
	room = high - low > (across ? same_across : same)*size || logarithmic ? 0.0
	     : size > 0.0 ? 0.01*size : 1.0;
	low -= room;
	high += room;
	if (logarithmic)
		hawser__picture_log_tics(picture, "cb", low, high, 30.0);
	fprintf(script, "set cbrange [%.9g:%.9g]\n", low, high);
	if (map->basins > 0) {
		basin_colours(script, map);
		fputs("unset colorbox\n", script);
		return;
	}
	if (map->whole)
		whole_colours(script, map, low + room, high - room);
	else if (isnan(map->border))
		even_colours(script);
	else
		sided_colours(script, border_part(map, low, high, logarithmic));
	fprintf(script, "set colorbox user origin screen 0.82, screen up(%.4f) size screen 0.025, "
	                "screen up(%.4f) - up(%.4f)\nset cbtics out scale 0.5\n", bottom, top, bottom);
	fprintf(script, "set label 1001 '%s' at screen 0.97, screen up(%.4f) center rotate by 90\n",
	        map->title, 0.5*(bottom + top));
}

/* Legend: the stable and unstable colours that occur, the boundaries, and grey for missing
 * values. */
static void add_entries(struct hawser__legend *entries, const struct hawser__map_picture *map)
{
	static const char box[] = "with boxes fillstyle solid noborder";
	double low, high, border = map->border;

	range_of(&low, &high, map);
	if (map->basins > 0)
		basin_legend(entries, map);
	if (low < border)
		hawser__legend_add(entries, "stable", "%s lc rgb '%s'", box, stable[2]);
	if (high > border)
		hawser__legend_add(entries, "unstable", "%s lc rgb '%s'", box, unstable[1]);
	if (map->segments > 0)
		hawser__legend_add(entries, map->line_title, "with lines lc rgb 'black' lw 0.8");
	if (map->holes)
		hawser__legend_add(entries, "no value", "%s lc rgb '%s'", box, ground);
}

enum hawser_status hawser__plot_map(const char *path, const struct hawser__map_picture *map,
                                    struct hawser_report *report)
{
	struct hawser__figure figure = {0};
	enum hawser_status status = hawser__figure_begin(&figure, path, 17.0, height, report);

	if (status)
		return status;
	hawser__figure_panel(&figure, &(struct hawser__panel_frame){
		0.13, 0.80, bottom, top,
		.x = {&map->x_axis, map->x[0], map->x[map->nx - 1], .tics = 8},
		.y = {&map->y_axis, map->y[0], map->y[map->ny - 1], .tics = 8}});
	colour_bar(&figure.out, map);
	fprintf(figure.out.script, "unset grid\nset border 15 front\n"
	        "set object 1 rectangle from graph 0,0 to graph 1,1 behind fillcolor rgb '%s' "
	        "fillstyle solid noborder\n", ground);
	draw_pixels(&figure, map);
	add_entries(&figure.legend, map);
	return hawser__figure_finish(&figure, report);
}
