/* response/methods.c - the table of methods for periodic orbits.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <string.h>

#include "core/report.h"
#include "response/method.h"

static const struct hawser__orbit_method *const rows[] = {&hawser__shooting_method,
	&hawser__balance_method};
#define ROWS ((int)(sizeof rows/sizeof *rows))

const struct hawser_frf_method *hawser_frf_method(int index)
{
	return index >= 0 && index < ROWS ? &rows[index]->about : NULL;
}

enum hawser_status hawser__orbit_method(const struct hawser__orbit_method **method,
                                        const struct hawser_rom *rom, const char *name,
                                        struct hawser_report *report)
{
	(void)rom;
	*method = rows[0];
	if (!name)
		return HAWSER_OK;
	for (int i = 0; i < ROWS; i++)
		if (strcmp(rows[i]->about.name, name) == 0) {
			*method = rows[i];
			return HAWSER_OK;
		}
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
	                    "there is no method \"%s\" for a frequency response", name);
}
