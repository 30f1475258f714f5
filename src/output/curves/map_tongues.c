/* output/curves/map_tongues.c - unstable tongues of a map that are narrower than its pixels.
 *
 * A pixel shows the value at its centre, so that a tongue between two centres would have the colour
 * of the stable region. If a row of pixels crosses the boundary twice within two pixels, and the
 * pixels to the left and to the right of the two crossings are stable, there is a tongue between
 * the crossings.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/order.h"
#include "output/output.h"
#include "output/drawing/figure.h"

/* Abscissas at which segments of the boundary cross the row at y: at[segments]; returns their
 * number. */
static int crossings(double *at, const struct hawser__map_picture *map, double y)
{
	int count = 0;

	for (int k = 0; k < map->segments; k++) {
		const double *s = map->segment + 4*k;

		if ((s[1] <= y) != (s[3] <= y))
			at[count++] = s[0] + (s[2] - s[0])*(y - s[1])/(s[3] - s[1]);
	}
	qsort(at, (size_t)count, sizeof *at, hawser__ascending);
	return count;
}

/* 1 if the pixel of the row at x is stable; 0 outside the map. */
static int stable(const struct hawser__map_picture *map, const double *row, double x)
{
	double part = (x - map->x[0])/(map->x[map->nx - 1] - map->x[0]);
	int k = (int)floor(part*map->nx);

	return k >= 0 && k < map->nx && row[k] < map->border;
}

void hawser__map_tongues(struct hawser__figure *figure, const struct hawser__map_picture *map)
{
	double *at = malloc(((size_t)map->segments + 1)*sizeof *at);
	double wide = (map->x[map->nx - 1] - map->x[0])/map->nx;
	double tall = (map->y[map->ny - 1] - map->y[0])/map->ny;

	for (int j = 0; at && j < map->ny; j++) {
		const double *row = map->value + (long)j*map->nx;
		double y = map->y[0] + tall*(j + 0.5);
		int count = crossings(at, map, y);

		for (int k = 0; k + 1 < count; k++) {
			if (at[k + 1] - at[k] > 2.0*wide || !stable(map, row, at[k] - wide) ||
			    !stable(map, row, at[k + 1] + wide))
				continue;
			hawser__figure_row(figure, "xyxy", (double[]){at[k], y - 0.55*tall, at[k + 1],
			                                              y + 0.55*tall});
			k++;
		}
	}
	free(at);
}
