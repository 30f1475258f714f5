/* cli/map_draw.c - a map's picture.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/cli.h"
#include "core/report.h"

enum { MOST_PIXELS = 500 }; /* along an axis */

/* "Omega (rad/s)", "travel.fluctuation (m/s)" with gnuplot's markup. */
static void title(char *text, size_t size, const char *key, const char *unit)
{
	int pure = !*unit || strcmp(unit, "1") == 0;
	size_t used = 0;

	if (strcmp(key, "Omega") == 0)
		used = (size_t)snprintf(text, size, "Forcing frequency {/:Italic Ω}");
	else
		for (; *key && used + 3 < size; key++) {
			if (*key == '_')
				text[used++] = '\\';
			text[used++] = *key;
		}
	snprintf(text + used, size - used, "%s%s%s", pure ? "" : " (", pure ? "" : unit,
	         pure ? "" : ")");
}

void cli_map_title(char *text, size_t size, const char *key, const char *unit)
{
	title(text, size, key, unit);
}

static int pixel(int k, int pixels, int points)
{
	return pixels == points ? k : (int)((long)k*(points - 1)/(pixels - 1));
}

static void fill(struct hawser__map_picture *picture, double *x, double *y, double *value,
                 const struct hawser_map *map)
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

			value[(long)j*picture->nx + i] = good ? sample->value : NAN;
			picture->holes |= !good;
		}
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
		.whole = strcmp(result->quantity->name, "unstable") == 0};
	char x_title[120], y_title[120], over[200];
	enum hawser_status status;

	if (!x)
		return hawser__no_memory(report, "map");
	picture.x = x;
	picture.y = x + nx;
	picture.value = x + nx + ny;
	fill(&picture, x, x + nx, x + nx + ny, map);
	title(x_title, sizeof x_title, result->key[0], result->unit[0]);
	title(y_title, sizeof y_title, result->key[1], result->unit[1]);
	snprintf(over, sizeof over, "%c%s%s%s%s", result->quantity->summary[0] - 'a' + 'A',
	         result->quantity->summary + 1,
	         strcmp(cli_map_value_unit(result), "1") == 0 ? "" : " (",
	         strcmp(cli_map_value_unit(result), "1") == 0 ? "" : cli_map_value_unit(result),
	         strcmp(cli_map_value_unit(result), "1") == 0 ? "" : ")");
	picture.x_title = x_title;
	picture.y_title = y_title;
	picture.title = over;
	status = hawser__plot_map(path, &picture, report);
	free(x);
	return status;
}
