/* A run whose output rows need more memory than is available: the status must be HAWSER_ERR_MEMORY,
 * without a leak.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <sys/resource.h>

#include "tests/integrate-models.h"

#ifdef __SANITIZE_ADDRESS__
#define SANITIZED 1
#elif defined(__has_feature)
#define SANITIZED __has_feature(address_sanitizer)
#else
#define SANITIZED 0
#endif

CASE(extremes_integrate_memory)
{
	struct rlimit limit = {1u << 29, 1u << 29};
	struct hawser_rom rom = model_oscillator(0.1, 1.0, 0.0, 0.0);
	struct hawser_integrate_options options = {.until = 1e8, .every = 1.0};
	struct hawser_report report = {0};
	struct hawser_trajectory run;

	/* AddressSanitizer needs its own terabytes of address space. */
	if (SANITIZED || setrlimit(RLIMIT_AS, &limit)) {
		ok(1, "memory limit # SKIP not possible here");
		hawser_rom_clear(&rom);
		return done_testing();
	}
	ok(hawser_integrate(&run, &rom, &options, &report) == HAWSER_ERR_MEMORY,
	   "a hundred million rows in half a gigabyte: %s", report.message);
	ok(!run.state && run.rows == 0, "and nothing is left behind");
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
	return done_testing();
}
