/* rom/compile_cable.c - the kernel of a cable's model: tensors, functions, or both.
 *
 * Each task (effort.h) is done in the form whose estimated time is shorter. If functions are faster in
 * all tasks, the tensors are not compiled; they remain lists, for files, exports and what is computed
 * of single entries.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <string.h>

#include "rom/kernel.h"
#include "rom/quartic.h"

/* Which tasks are faster by function; returns whether all are. */
static int choose(int by_function[HAWSER__TASKS], const struct hawser__size *size)
{
	struct hawser__effort effort;
	int all = 1;

	hawser__effort(&effort, size);
	for (int task = 0; task < HAWSER__TASKS; task++) {
		by_function[task] = effort.functions[task] < effort.tensors[task];
		all = all && by_function[task];
	}
	return all;
}

enum hawser_status hawser__rom_compile_cable(struct hawser_rom *rom,
                                             const struct hawser_modes *modes,
                                             const struct hawser__condensed *condensed,
                                             struct hawser_report *report)
{
	struct hawser__quartic *quartic;
	int by_function[HAWSER__TASKS] = {0}, bare = 0;
	struct hawser__size size = {0};
	enum hawser_status status = hawser__quartic_new(&quartic, rom, modes, condensed, report);

	if (status)
		return status;
	if (quartic) {
		size = (struct hawser__size){rom->n, quartic->moving_in, quartic->moving_out,
		                             quartic->points, quartic->condensed, rom->cubics};
		bare = choose(by_function, &size);
	}
	status = hawser__rom_compile(rom, bare, report);
	if (status) {
		hawser__quartic_free(quartic);
		return status;
	}
	rom->kernel->quartic = quartic;
	rom->kernel->size = size;
	memcpy(rom->kernel->by_function, by_function, sizeof by_function);
	return HAWSER_OK;
}
