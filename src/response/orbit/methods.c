/* response/orbit/methods.c - the table of methods for periodic orbits. The first one that suits a model
 * is its default; the last one suits all.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "core/report.h"
#include "response/orbit/method.h"
#include "rom/file/plug.h"
#include "rom/terms/drag.h"
#include "rom/terms/terms.h"

static const struct hawser__orbit_method *const rows[] = {&hawser__balance_method,
	&hawser__scales_method, &hawser__shooting_method};
#define ROWS ((int)(sizeof rows/sizeof *rows))

const struct hawser_frf_method *hawser_frf_method(int index)
{
	return index >= 0 && index < ROWS ? &rows[index]->about : NULL;
}

enum hawser_status hawser__orbit_method(const struct hawser__orbit_method **method,
                                        const struct hawser_rom *rom,
                                        const struct hawser_frf_options *options,
                                        struct hawser_report *report)
{
	const char *name = options->method;
	int rough = rom->drag && hawser__drag_rough(rom), plug = rom->plug && !rom->plug->water;

	if (name && strcmp(name, "auto") == 0)
		name = NULL;
	if (rough && name && strcmp(name, "shooting") != 0)
		return hawser__drag_refuse(rom, "this method for orbits", report);
	if (hawser__rom_more(rom) && name && strcmp(name, "shooting") != 0 &&
	    (plug || strcmp(name, "balance") != 0))
		return hawser__more_refuse(rom, "this method for orbits", report);
	/* equations of first order are stiff by their relaxation only, which shooting resolves */
	if (rough || plug || (hawser__rom_more(rom) && rom->first && !name))
		name = "shooting";
	/* the kinks of the drag of water are as many as points of the mesh: steps in time find no end */
	if (!name && rom->plug)
		name = "balance";

	for (int i = 0; i < ROWS; i++)
		if (name ? strcmp(rows[i]->about.name, name) == 0
		         : !rows[i]->suits || rows[i]->suits(rom, options)) {
			*method = rows[i];
			return HAWSER_OK;
		}
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
	                    "there is no method \"%s\" for a frequency response: write %s, %s or %s", name,
	                    rows[0]->about.name, rows[1]->about.name, rows[2]->about.name);
	_Static_assert(ROWS == 3, "the message names each method");
}
