/* rom/full_error.c - how far the basis of a full-order model is off in the linear modes.
 *
 * A basis of few functions has no inextensible motions of a sagging cable in the plane: it
 * stretches the cable in each of them, which costs 1/epsilon of energy, and their frequencies are too
 * high by a factor of ten or a hundred. The model then answers as a cable that hardly moves in the
 * plane, with tensions that mean nothing; its orbits converge as well as any other's. The
 * frequencies show it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <hawser/rom.h>

/* Index of the coordinate that is this mode by plane and number; -1: the model has none. */
static int coordinate_of(const struct hawser_rom *full, const struct hawser_mode *mode)
{
	char name[64];
	size_t length = (size_t)snprintf(name, sizeof name, "%s %d", hawser_plane_name(mode->plane),
	                                 mode->number);

	for (int i = 0; i < full->n; i++)
		if (strncmp(full->label[i], name, length) == 0 &&
		    (full->label[i][length] == '\0' || full->label[i][length] == ' '))
			return i;
	return -1;
}

double hawser_rom_full_error(int *worst, const struct hawser_rom *full,
                             const struct hawser_modes *modes, double to)
{
	double largest = -1.0;
	int seen[2] = {0};

	*worst = 0;
	for (int j = 0; j < modes->n; j++) {
		const struct hawser_mode *mode = &modes->mode[j];
		int i, first = !seen[mode->plane]++;
		double error;

		if (!first && mode->omega > to)
			continue;
		i = coordinate_of(full, mode);
		error = i < 0 ? INFINITY
		        : fabs(sqrt(full->K[(size_t)i*((size_t)full->n + 1)])/mode->omega - 1.0);
		if (error > largest) {
			largest = error;
			*worst = j;
		}
	}
	return largest;
}
