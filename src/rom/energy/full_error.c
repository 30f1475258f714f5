/* rom/energy/full_error.c - what the basis of a full-order model lacks: of its linear modes, and of
 * its load.
 *
 * A basis with few functions contains no inextensible in-plane motions of a sagging cable. Each of
 * its motions stretches the cable, which costs energy in proportion to 1/epsilon, and their
 * frequencies are too high by a factor of ten or a hundred. Such a model hardly moves in the plane,
 * and its tensions are meaningless, although its orbits converge. Only the frequencies show the
 * error.
 *
 * Nor does a basis hold the response to a load that changes along the cable faster than its
 * functions. A static response u has the energy f.u/2, the sum of f_j^2/(2 w_j^2) over all motions of
 * the basis, which grows with the basis and is compared with that of the largest.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/terms/load.h"

enum { LARGEST = 24 }; /* functions of the basis with which loads are compared; chosen */

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

/* Twice the energy of the static response to the load, of all its harmonics. */
static enum hawser_status energy(double *sum, const struct hawser__loads *loads,
                                 const struct hawser_statics *statics, int functions,
                                 struct hawser_report *report)
{
	struct hawser_modes modes;
	enum hawser_status status = hawser_modes_basis(&modes, statics, functions, functions, report);
	double *work = status ? NULL : malloc(((size_t)modes.n + 1)*sizeof *work);

	*sum = 0.0;
	if (!status && !work)
		status = hawser__no_memory(report, "rom");
	for (int h = 0; !status && h < loads->harmonics; h++) {
		status = hawser__loads_work(work, loads, h, &modes, report);
		for (int j = 0; !status && j < modes.n; j++)
			*sum += pow(work[j]/modes.mode[j].omega, 2);
	}
	free(work);
	hawser_modes_clear(&modes);
	return status;
}

enum hawser_status hawser_rom_full_lacks(double *lacks, const struct hawser_statics *statics,
                                         const struct hawser_scene *scene, int functions,
                                         struct hawser_report *report)
{
	double own = 0.0, most = 0.0;
	struct hawser__loads loads;
	enum hawser_status status = hawser__loads_make(&loads, statics, scene, report);

	*lacks = 0.0;
	if (!status && loads.harmonics > 0 && functions < LARGEST) {
		status = energy(&own, &loads, statics, functions, report);
		if (!status)
			status = energy(&most, &loads, statics, LARGEST, report);
		*lacks = most > 0.0 ? fmax(1.0 - own/most, 0.0) : 0.0;
	}
	hawser__loads_clear(&loads);
	return status;
}
