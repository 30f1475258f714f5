/* water/water.c - the flow of the water around cables.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/water.h>

#include "water/water.h"

void hawser_water_clear(struct hawser_water *water)
{
	free(water->current);
	free(water->file);
	hawser_waves_clear(&water->waves);
	*water = (struct hawser_water){0};
}

void hawser__water_current(double u[3], double u_y[3], const struct hawser_water *water, double y)
{
	const struct hawser_water_level *level = water->current;
	int last = water->levels - 1, i = 0;

	memset(u, 0, 3*sizeof *u);
	memset(u_y, 0, 3*sizeof *u_y);
	if (last < 0)
		return;
	while (i < last && y > level[i + 1].y)
		i++;
	for (int k = 0; k < 3; k++)
		if (i == last || y <= level[0].y) {
			u[k] = level[i].u[k];
		} else {
			u_y[k] = (level[i + 1].u[k] - level[i].u[k])/(level[i + 1].y - level[i].y);
			u[k] = level[i].u[k] + (y - level[i].y)*u_y[k];
		}
}
