/* rom/condense/twin.c - modes are the same if their frequencies and the slopes of their shapes agree.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>

#include "rom/condense/known.h"

#define SAME 1e-3 /* largest difference of shapes and frequencies; chosen */

/* Cosine of the angle between the slopes along the cable. */
static double likeness(const struct hawser_rom *rom, int j, const struct hawser_rom *full, int i)
{
	int count = 3*rom->line.points;
	const double *a = rom->line.slope + (size_t)j*(size_t)count;
	const double *b = full->line.slope + (size_t)i*(size_t)count;

	return cblas_ddot(count, a, 1, b, 1)/(cblas_dnrm2(count, a, 1)*cblas_dnrm2(count, b, 1));
}

static double frequency(const struct hawser_rom *rom, int j)
{
	return sqrt(rom->K[(size_t)j*((size_t)rom->n + 1)]);
}

int hawser__twin(const struct hawser_rom *rom, int j, const struct hawser_rom *full)
{
	double w = frequency(rom, j);

	for (int i = 0; i < full->n; i++) {
		double like;

		if (!(fabs(frequency(full, i)/w - 1.0) < SAME))
			continue;
		like = likeness(rom, j, full, i);
		if (1.0 - fabs(like) < SAME)
			return like > 0.0 ? i + 1 : -(i + 1);
	}
	return 0;
}
