/* study/basin/basin.c - motions over periods of the load, with an error that is controlled.
 *
 * The flow of a period (response/time/flow.h) has a fixed mesh, so that it is a smooth function of
 * the state and has an exact derivative. The number of steps is doubled where the estimated error
 * of a period is too large, and halved where it is far too small. It begins anew with each motion,
 * so that the result for a state does not depend on those before.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "study/basin/basin.h"

#define TOLERANCE 1e-8 /* of a period, relative to the size of the state; chosen */
#define ROOM 1e-5      /* steps are halved where the error is this part of the tolerance: the order of
                        * the formula is above 8, half the steps make it 2^8 times larger; chosen */
#define BEYOND 1e3     /* sizes of the map's states beyond which a motion counts as unbounded; chosen */
enum { LEAST_STEPS = 16, MOST_STEPS = 1 << 13 };

enum hawser_status hawser__orbiter_open(struct hawser__orbiter *orbiter, const struct hawser_rom *rom,
                                        double omega, struct hawser_report *report)
{
	size_t m = 2*(size_t)rom->n;
	enum hawser_status status;

	*orbiter = (struct hawser__orbiter){.rom = rom, .omega = omega, .m = 2*rom->n,
	                                    .steps = LEAST_STEPS};
	if ((status = hawser__flow_init(&orbiter->flow, rom, report)))
		return status;
	orbiter->amplitude = hawser__amplitude_new(rom);
	orbiter->work = malloc(m*(4*m + 16)*sizeof *orbiter->work);
	orbiter->matrix = malloc(m*m*sizeof *orbiter->matrix);
	return orbiter->work && orbiter->matrix && orbiter->amplitude ? HAWSER_OK
	                                                              : hawser__no_memory(report, "map");
}

void hawser__orbiter_close(struct hawser__orbiter *orbiter)
{
	if (orbiter->rom)
		hawser__flow_clear(&orbiter->flow);
	if (orbiter->amplitude)
		hawser__amplitude_free(orbiter->amplitude);
	free(orbiter->work);
	free(orbiter->matrix);
	*orbiter = (struct hawser__orbiter){.rom = NULL};
}

double hawser__orbiter_size(const struct hawser__orbiter *orbiter, const double *x)
{
	double sum = 0.0, per = 1.0/(orbiter->omega*orbiter->omega);

	for (int i = 0; i < orbiter->m; i++)
		sum += x[i]*x[i]*(i < orbiter->m/2 ? 1.0 : per);
	return sqrt(sum);
}

enum hawser__fate hawser__orbiter_map(struct hawser__orbiter *orbiter, double *x)
{
	size_t bytes = (size_t)orbiter->m*sizeof *x;
	double *start = orbiter->work;

	memcpy(start, x, bytes);
	for (;;) {
		const struct hawser__stretch stretch = {0.0, 2.0*M_PI/orbiter->steps, orbiter->steps, 1, 0.0};
		double error = hawser__flow_map(&orbiter->flow, x, NULL, &stretch, orbiter->omega), size;

		orbiter->maps++;
		size = fmax(hawser__orbiter_size(orbiter, x), hawser__orbiter_size(orbiter, start));
		if (isfinite(size) && size > BEYOND*orbiter->size)
			return HAWSER__ESCAPED;
		if (error <= TOLERANCE*fmax(size, 1e-3*orbiter->size)) {
			if (error < ROOM*TOLERANCE*size && orbiter->steps > LEAST_STEPS)
				orbiter->steps /= 2;
			return HAWSER__MOVES;
		}
		if (orbiter->steps >= MOST_STEPS)
			return isfinite(size) ? HAWSER__UNRESOLVED : HAWSER__ESCAPED;
		orbiter->steps *= 2;
		memcpy(x, start, bytes);
	}
}
