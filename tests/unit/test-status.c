/* Statuses: each has its own name and an exit status; reports keep the given values.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/report.h"
#include "tests/tap.h"

CASE(unit_status)
{
	static const int want_exit[HAWSER_STATUS_COUNT] = {0, 1, 1, 2, 3, 3, 4, 4, 4};
	struct hawser_report report = {.message = ""};
	char version[32];

	for (int s = 0; s < HAWSER_STATUS_COUNT; s++) {
		ok(hawser_status_exit(s) == want_exit[s], "%s exits with %d", hawser_status_name(s),
		   want_exit[s]);
		for (int t = 0; t < s; t++)
			if (!strcmp(hawser_status_name(s), hawser_status_name(t)))
				ok(0, "two statuses are called %s", hawser_status_name(s));
	}
	ok(!strcmp(hawser_status_name(HAWSER_STATUS_COUNT), "unknown"), "outside the enum: unknown");
	ok(hawser_status_exit(HAWSER_STATUS_COUNT) == 4, "outside the enum: exit 4");

	ok(hawser__fail_at(&report, HAWSER_ERR_CONVERGENCE, "here", 7, 2.5e-3, "got %d", 9) ==
	           HAWSER_ERR_CONVERGENCE, "fail_at returns its status");
	ok(report.iteration == 7 && report.residual == 2.5e-3 && !strcmp(report.message, "got 9") &&
	           !strcmp(report.where, "here"), "and fills the report");
	(void)hawser__fail(&report, HAWSER_ERR_SCENE, "here", "no \"%s\": \xc3\xbc", "a\033[2Jb\nc\177");
	ok(!strcmp(report.message, "no \"a?[2Jb?c?\": \xc3\xbc"),
	   "nothing of a name steers a terminal: %s", report.message);
	ok(hawser__no_memory(NULL, "here") == HAWSER_ERR_MEMORY, "a NULL report is fine");
	snprintf(version, sizeof version, "%d.%d.%d", HAWSER_VERSION_MAJOR, HAWSER_VERSION_MINOR,
	         HAWSER_VERSION_PATCH);
	ok(!strcmp(hawser_version(), version), "the headers are those of version %s", version);
	return done_testing();
}
