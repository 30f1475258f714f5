/* study/basin/basin_count.c - the shares of the basins of a map, with their errors, and the basin
 * entropy.
 *
 * A cell whose corners have one number counts as a part of this basin; of a cell on a boundary a basin
 * has between nothing and all. The share is the middle of these bounds, the error half their distance.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "study/basin/basin.h"

enum { BOX = 5 };

/* Index of a number in a list that begins with escaped and other motions. */
static int slot(const struct hawser_map *map, int i, int j)
{
	const struct hawser_map_sample *sample = &map->point[(long)j*map->nx + i].sample;

	return sample->code == HAWSER_MAP_OK ? sample->number + 1 : 1;
}

/* pure, mixed [count + 2]: areas of cells whose corners agree, and of those of which one has this
 * number, as shares. */
static void areas(double *pure, double *mixed, const struct hawser_map *map)
{
	double cell = 1.0/((double)(map->nx - 1)*(map->ny - 1));

	for (int j = 0; j + 1 < map->ny; j++)
		for (int i = 0; i + 1 < map->nx; i++) {
			int corner[4] = {slot(map, i, j), slot(map, i + 1, j), slot(map, i, j + 1),
			                 slot(map, i + 1, j + 1)};

			if (corner[0] == corner[1] && corner[0] == corner[2] && corner[0] == corner[3]) {
				pure[corner[0]] += cell;
				continue;
			}
			for (int k = 0; k < 4; k++) {
				int again = 0;

				for (int l = 0; l < k; l++)
					again |= corner[l] == corner[k];
				mixed[corner[k]] += again ? 0.0 : cell;
			}
		}
}

/* Daza, Wagemakers, Georgeot, Guery-Odelin and Sanjuan, Scientific Reports 6 (2016) 31416. */
static void entropies(struct hawser_basins *to, const struct hawser_map *map, int *count)
{
	int boxes = 0, several = 0;
	double sum = 0.0;

	for (int j = 0; j + BOX <= map->ny; j += BOX)
		for (int i = 0; i + BOX <= map->nx; i += BOX, boxes++) {
			double part = 0.0;

			memset(count, 0, ((size_t)to->count + 2)*sizeof *count);
			for (int k = 0; k < BOX*BOX; k++)
				count[slot(map, i + k%BOX, j + k/BOX)]++;
			for (int k = 0; k < to->count + 2; k++)
				if (count[k] > 0)
					part -= count[k]*log(count[k]/(double)(BOX*BOX))/(BOX*BOX);
			sum += part;
			several += part > 1e-9;
		}
	to->entropy = boxes > 0 ? sum/boxes : 0.0;
	to->boundary_entropy = several > 0 ? sum/several : 0.0;
}

enum hawser_status hawser_basins_count(struct hawser_basins *to, const struct hawser_map_field *field,
                                       const struct hawser_map *map, struct hawser_report *report)
{
	const struct hawser__basins *basins = field->context;
	const struct hawser_rom *rom = basins->rom;
	size_t count = (size_t)basins->count, m = 2*(size_t)rom->n;
	double length = rom->scaled ? rom->length : 1.0, time = rom->scaled ? rom->time : 1.0;
	double *pure = calloc(2*(count + 2), sizeof *pure), *mixed;
	int *box = calloc(count + 2, sizeof *box);

	*to = (struct hawser_basins){.n = rom->n, .count = basins->count, .periods = basins->periods};
	to->basin = calloc(count, sizeof *to->basin);
	to->state = calloc(count*m, sizeof *to->state);
	if (!pure || !box || !to->basin || !to->state) {
		free(pure);
		free(box);
		hawser_basins_clear(to);
		return hawser__no_memory(report, "map");
	}
	mixed = pure + count + 2;
	areas(pure, mixed, map);
	to->escaped = pure[0] + 0.5*mixed[0];
	to->escaped_error = 0.5*mixed[0];
	to->other = pure[1] + 0.5*mixed[1];
	to->other_error = 0.5*mixed[1];
	for (size_t a = 0; a < count; a++) {
		to->basin[a] = basins->attractor[a].about;
		to->basin[a].share = pure[a + 2] + 0.5*mixed[a + 2];
		to->basin[a].error = 0.5*mixed[a + 2];
		for (size_t i = 0; i < m; i++)
			to->state[a*m + i] = basins->attractor[a].state[i]*length/
			                     (i < m/2 ? 1.0 : time);
	}
	entropies(to, map, box);
	free(pure);
	free(box);
	return HAWSER_OK;
}

void hawser_basins_clear(struct hawser_basins *basins)
{
	if (!basins)
		return;
	free(basins->basin);
	free(basins->state);
	*basins = (struct hawser_basins){.n = 0};
}
