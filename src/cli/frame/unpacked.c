/* cli/frame/unpacked.c - see unpacked.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/auxv.h>
#endif

#include "cli/frame/unpacked.h"

static const char units[] = "/../share/hawser/udunits/udunits2.xml"; /* from the program's folder */

void cli_unpacked_units(void)
{
#ifdef __linux__
	/* the name by which the system started the program: /proc need not be there */
	const char *name = (const char *)getauxval(AT_EXECFN);
	char *program = name ? realpath(name, NULL) : NULL, *slash = program ? strrchr(program, '/') : NULL;
	char *path = slash ? malloc((size_t)(slash - program) + sizeof units) : NULL;

	if (path) {
		memcpy(path, program, (size_t)(slash - program));
		strcpy(path + (slash - program), units);
		if (access(path, R_OK) == 0)
			(void)setenv("UDUNITS2_XML_PATH", path, 0);
	}
	free(path);
	free(program);
#endif
}
