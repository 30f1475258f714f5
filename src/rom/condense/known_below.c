/* rom/condense/known_below.c - the condensed modes below a frequency, computed for a model that
 * keeps others. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "rom/build/build.h"
#include "rom/terms/dampers.h"
#include "rom/energy/kernel.h"
#include "rom/condense/known.h"

enum { MORE = 8 }; /* further modes in the first attempt; chosen */

/* The lowest modes: all below `top`, up to the limit of a model. In both planes together their
 * frequencies are about evenly spaced, so that a second attempt mostly suffices. */
static enum hawser_status lowest(struct hawser_modes *all, const struct hawser_modes *modes,
                                 double top, struct hawser_report *report)
{
	struct hawser_modes_options options = {.n = modes->n + MORE};
	enum hawser_status status = HAWSER_OK;

	*all = (struct hawser_modes){.n = 0};
	while (!status) {
		double last;

		if (options.n > HAWSER_ROM_MAX)
			options.n = HAWSER_ROM_MAX;
		hawser_modes_clear(all);
		status = hawser_modes_solve(all, &modes->statics, &options, report);
		last = status ? 0.0 : all->mode[all->n - 1].omega;
		if (status || last >= top || options.n == HAWSER_ROM_MAX)
			break;
		options.n = (int)fmin(ceil(options.n*top/last) + 2.0, HAWSER_ROM_MAX);
	}
	return status;
}

/* Indices in `all` of the modes of the model: the same plane, and the same number in it. */
static int find_kept(int *kept, const struct hawser_modes *all, const struct hawser_modes *modes)
{
	int count = 0;

	for (int s = 0; s < all->n; s++)
		for (int j = 0; j < modes->n; j++)
			if (all->mode[s].plane == modes->mode[j].plane &&
			    all->mode[s].number == modes->mode[j].number)
				kept[count++] = s;
	return count;
}

enum hawser_status hawser_rom_know_below(struct hawser_rom *rom, const struct hawser_modes *modes,
                                         const struct hawser_scene *scene, double top,
                                         struct hawser_report *report)
{
	int kept[HAWSER_ROM_MAX], count;
	struct hawser_rom linear = {.n = 0};
	struct hawser_modes all;
	enum hawser_status status;

	/* static shapes of dampers contain a part of every mode that is not kept */
	if (!hawser__rom_answers_load(rom) || hawser__has_dampers(&modes->statics))
		return HAWSER_OK;
	status = lowest(&all, modes, top, report);
	if (status == HAWSER_ERR_CONVERGENCE) {
		/* higher modes than those of the caller cannot be computed */
		rom->known.reach = modes->mode[modes->n - 1].omega;
		hawser_modes_clear(&all);
		return HAWSER_OK;
	}
	if (!status)
		status = hawser__rom_build_forces(&linear, &all, scene, report);
	if (!status) {
		count = find_kept(kept, &all, modes);
		status = hawser_rom_know(rom, &linear, kept, count, report);
	}
	hawser_rom_clear(&linear);
	hawser_modes_clear(&all);
	return status;
}
