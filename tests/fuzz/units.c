/* tests/fuzz/units.c - udunits2's database is read once and kept, because reading it for every
 * scene with a unit would take most of the time of the fuzz targets. Linked with --wrap=ut_read_xml
 * and --wrap=ut_free_system.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <udunits2.h>

ut_system *__real_ut_read_xml(const char *path);
ut_system *__wrap_ut_read_xml(const char *path);
void __wrap_ut_free_system(ut_system *system);

static ut_system *kept;

ut_system *__wrap_ut_read_xml(const char *path)
{
	if (!kept)
		kept = __real_ut_read_xml(path);
	return kept;
}

void __wrap_ut_free_system(ut_system *system)
{
	(void)system;
}
