/* rom/block.c - restoring forces and tangents at many states in one call.
 *
 * What a Fourier method asks for: all the samples of a period. Evaluated together, the products that
 * do not depend on the state are read once for all of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "rom/exact.h"
#include "rom/kernel.h"

size_t hawser__rom_tangents_work(const struct hawser_rom *rom, int count)
{
	return rom->exact ? hawser__exact_work(rom->exact, count) : 0;
}

void hawser__rom_tangents(const struct hawser_rom *rom, double *restoring, double *tangent,
                          const double *u, int count, double *work)
{
	size_t n = (size_t)rom->n;

	if (rom->exact) {
		hawser__exact_tangents(rom->exact, restoring, tangent, u, count, work);
		return;
	}
	for (size_t i = 0; i < (size_t)count; i++)
		if (tangent)
			hawser_rom_tangent(rom, restoring + i*n, tangent + i*n*n, u + i*n);
		else
			hawser_rom_restoring(rom, restoring + i*n, u + i*n);
}
