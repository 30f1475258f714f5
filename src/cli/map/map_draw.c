/* cli/map/map_draw.c - the picture of a map.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/axis.h"
#include "cli/map/map_result.h"
#include "core/report.h"

enum { MOST_PIXELS = 500 }; /* along an axis */

static int pixel(int k, int pixels, int points)
{
	return pixels == points ? k : (int)((long)k*(points - 1)/(pixels - 1));
}

static void fill(struct hawser__map_picture *picture, double *x, double *y, double *value,
                 const struct hawser_map *map, double per)
{
	for (int i = 0; i < picture->nx; i++)
		x[i] = map->x[0] + (map->x[map->nx - 1] - map->x[0])*i/(picture->nx - 1);
	for (int j = 0; j < picture->ny; j++)
		y[j] = map->y[0] + (map->y[map->ny - 1] - map->y[0])*j/(picture->ny - 1);
	for (int j = 0; j < picture->ny; j++)
		for (int i = 0; i < picture->nx; i++) {
			long place = (long)pixel(j, picture->ny, map->ny)*map->nx +
			             pixel(i, picture->nx, map->nx);
			const struct hawser_map_sample *sample = &map->point[place].sample;
			int good = sample->code == HAWSER_MAP_OK;

			value[(long)j*picture->nx + i] = good ? sample->value/per : NAN;
			picture->holes |= !good;
		}
}

/* Value at the limit of stability; NAN: the quantity does not determine stability. */
static double border_of(const char *quantity)
{
	return strcmp(quantity, "growth") == 0 ? 0.0 : strcmp(quantity, "multiplier") == 0 ? 1.0
	     : strcmp(quantity, "unstable") == 0 ? 0.5 : NAN;
}

/* Short title for the colour bar. */
static const char *quantity_title(const struct hawser_map_quantity *quantity)
{
	static const char *const titles[][2] = {
		{"growth", "Largest growth rate"}, {"multiplier", "Largest modulus of a multiplier"},
		{"unstable", "Number of unstable multipliers"}, {"amplitude", "Largest peak amplitude"},
		{"basin", "Response"}, {"critical-speed", "Critical speed of the wind"}};

	for (size_t k = 0; k < sizeof titles/sizeof *titles; k++)
		if (strcmp(titles[k][0], quantity->name) == 0)
			return titles[k][1];
	return quantity->name;
}

/* What changes on the map's boundary lines: whether there is a value, stability, or the number of
 * instabilities where some remain on both sides. */
static const char *line_title(const struct hawser_map *map, int basins, int responds)
{
	int code = 0, stability = 0, number = 0;

	for (int k = 0; k < map->boundaries; k++) {
		const struct hawser_map_boundary *at = &map->boundary[k];

		if (at->code[0] != at->code[1])
			code = 1;
		else if (at->number[0] && at->number[1])
			number = 1;
		else
			stability = 1;
	}
	if (basins && !code)
		return "boundary of basins";
	if (map->branches && !code)
		return "number of responses or their stability changes";
	if (code)
		return stability || number ? "stability changes, or edge of what has a value"
		                           : "edge of what has a value";
	if (number)
		return stability ? "stability or number of instabilities changes"
		                 : "number of instabilities changes";
	return responds ? "boundary of stability of the response" : "boundary of stability";
}

/* The axis of a parameter, or of a component of the initial state. */
static struct hawser__axis axis_of(const struct cli_map_result *result, int k, double largest)
{
	const char *key = result->key[k];
	char label[60];

	if (result->basins.count == 0)
		return cli_axis(key, result->unit[k], largest);
	snprintf(label, sizeof label, "Initial %s %c_{%.20s}",
	         *key == 'u' ? "displacement" : "velocity", *key, key + 1);
	return hawser__axis_of(label, *result->unit[k] ? result->unit[k] : "1", largest);
}

enum hawser_status cli_map_draw(const char *path, const void *context, struct hawser_report *report)
{
	const struct cli_map_result *result = context;
	const struct hawser_map *map = result->map;
	int nx = map->nx < MOST_PIXELS ? map->nx : MOST_PIXELS;
	int ny = map->ny < MOST_PIXELS ? map->ny : MOST_PIXELS;
	double *x = malloc(((size_t)nx + (size_t)ny + (size_t)nx*(size_t)ny)*sizeof *x);
	struct hawser__map_picture picture = {.nx = nx, .ny = ny, .segments = map->segments,
		.segment = map->segment, .logarithmic = result->quantity->logarithmic,
		.whole = strcmp(result->quantity->name, "unstable") == 0,
		.basins = result->basins.count};
	struct hawser__axis axis;
	enum hawser_status status;

	if (!x)
		return hawser__no_memory(report, "map");
	picture.x = x;
	picture.y = x + nx;
	picture.value = x + nx + ny;
	axis = hawser__axis_of(quantity_title(result->quantity), cli_map_value_unit(result), 0.0);
	fill(&picture, x, x + nx, x + nx + ny, map, axis.per);
	picture.x_axis = axis_of(result, 0, map->x[map->nx - 1]);
	picture.y_axis = axis_of(result, 1, map->y[map->ny - 1]);
	picture.line_title = line_title(map, picture.basins > 0, result->responds);
	picture.border = border_of(result->quantity->name);
	picture.title = axis.title;
	status = hawser__plot_map(path, &picture, report);
	free(x);
	return status;
}
