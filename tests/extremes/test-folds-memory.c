/* Fold curves that need more memory than is available: the status must be HAWSER_ERR_MEMORY, without a
 * leak.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <sys/resource.h>

#include <hawser/folds.h>

#include "tests/folds-duffing.h"
#include "tests/tap.h"

#ifdef __SANITIZE_ADDRESS__
#define SANITIZED 1
#elif defined(__has_feature)
#define SANITIZED __has_feature(address_sanitizer)
#else
#define SANITIZED 0
#endif

/* From a given call on, the process cannot allocate more memory. */
static int no_more(void *data, const struct hawser_progress_state *state)
{
	const char *from = data;
	struct rlimit limit;

	if (strcmp(state->stage, from) != 0 || getrlimit(RLIMIT_AS, &limit) || limit.rlim_cur == 1)
		return 0;
	limit.rlim_cur = 1;
	return setrlimit(RLIMIT_AS, &limit);
}

/* In the response, and in the fold curves that start from it. */
static void check_stage(const struct hawser_rom *rom, char *stage)
{
	struct hawser_folds_options options = {.method = NULL};
	struct hawser_report report = {.message = ""};
	struct rlimit before;
	struct hawser_folds folds;
	enum hawser_status status;

	options.from = 0.8;
	options.to = 1.8;
	options.step_max = 1e-7; /* more points than the heap has room for */
	options.max_points = 10000000;
	options.progress = (struct hawser_progress){no_more, stage};
	getrlimit(RLIMIT_AS, &before);
	status = hawser_folds_trace(&folds, rom, &options, &report);
	setrlimit(RLIMIT_AS, &before);
	ok(status == HAWSER_ERR_MEMORY, "%s: %s", stage, report.message);
	hawser_folds_clear(&folds);
}

CASE(extremes_folds_memory)
{
	static char curve[] = "fold curve", response[] = "response";
	struct hawser_rom rom;

	/* AddressSanitizer needs its own terabytes of address space. */
	if (SANITIZED) {
		ok(1, "memory limit # SKIP not possible here");
		return done_testing();
	}
	if (!ok(!duffing(&rom, 0.05, 0.1, 0.18), "a Duffing oscillator"))
		return done_testing();
	check_stage(&rom, response);
	check_stage(&rom, curve);
	hawser_rom_clear(&rom);
	return done_testing();
}
