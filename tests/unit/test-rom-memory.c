/* The memory in which the program writes a model of many modes: not a multiple of its file.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include "tests/tap.h"

#if defined __SANITIZE_ADDRESS__ || defined __SANITIZE_THREAD__
enum { INFLATED = 1 };
#else
enum { INFLATED = 0 };
#endif

CASE(unit_rom_memory)
{
	/* 18 MB of memory, of which 11 MB are the program with its libraries; with trees of the model
	 * it was 135 MB. The file has 9.6 MB. */
	const long most_kb = 40000;
	struct rusage used;
	int status = system("\"${HAWSER:-./hawser}\" rom "
	                    "\"${SRCDIR:-.}/notebooks-data/scenes/chairlift.yaml\" "
	                    "-n 40 --json /dev/null -q");

	getrusage(RUSAGE_CHILDREN, &used);
	ok(status == 0, "rom with 40 modes");
	printf("# %ld KB\n", used.ru_maxrss);
	ok(INFLATED || used.ru_maxrss < most_kb, "takes less than %ld KB of memory", most_kb);
	return done_testing();
}
