/* rom/full_error.c - error of the linear modes of a full-order model that is due to its basis.
 *
 * A basis with few functions contains no inextensible in-plane motions of a sagging cable. Each of
 * its motions stretches the cable, which costs energy in proportion to 1/epsilon, and their
 * frequencies are too high by a factor of ten or a hundred. Such a model hardly moves in the plane,
 * and its tensions are meaningless, although its orbits converge. Only the frequencies show the
 * error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <hawser/rom.h>

/* Index of the coordinate that is this mode, by plane and number; -1: there is none. */
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
