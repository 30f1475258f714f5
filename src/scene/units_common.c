/* scene/units_common.c - the units that most scenes use.
 *
 * udunits2 reads its database of units, an XML file, in 5 ms: more than all the rest of a short run
 * of the program. These units need it not. A test compares each with udunits2, to the last bit.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "scene/reader.h"

double hawser__units_common(const char *from, const char *to)
{
	/* from, to, factor */
	static const struct row {
		const char *from, *to;
		double factor;
	} rows[] = {
		{"mm", "m", 1e-3}, {"cm", "m", 1e-2}, {"km", "m", 1e3},
		{"kN", "N", 1e3}, {"MN", "N", 1e6}, {"GN", "N", 1e9}, {"kN/m", "N/m", 1e3},
		{"t", "kg", 1e3}, {"ms", "s", 1e-3},
	};
	static const char *const units[] = {
		"m", "kg/m", "N/m", "m/s", "N", "s", "kg", "kg/m/s", "rad/s", "N.s/m",
	};

	for (size_t i = 0; i < sizeof units/sizeof *units; i++)
		if (!strcmp(from, units[i]) && !strcmp(to, units[i]))
			return 1.0;
	for (size_t i = 0; i < sizeof rows/sizeof *rows; i++)
		if (!strcmp(from, rows[i].from) && !strcmp(to, rows[i].to))
			return rows[i].factor;
	return 0.0;
}
