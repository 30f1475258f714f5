/* core/status.c - statuses, their names and exit codes, and the report.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdarg.h>
#include <stdio.h>

#include "core/report.h"

static const struct {
	const char *name;
	int exit;
} table[HAWSER_STATUS_COUNT] = {
	[HAWSER_OK] = {"ok", 0},
	[HAWSER_ERR_ARGUMENT] = {"argument", 1},
	[HAWSER_ERR_SCENE] = {"scene", 1},
	[HAWSER_ERR_NO_SOLUTION] = {"no-solution", 2},
	[HAWSER_ERR_CONVERGENCE] = {"not-converged", 3},
	[HAWSER_ERR_NAN] = {"not-a-number", 3},
	[HAWSER_ERR_MEMORY] = {"memory", 4},
	[HAWSER_ERR_IO] = {"file", 4},
	[HAWSER_ERR_PROGRAM] = {"program", 4},
};

static int known(enum hawser_status status)
{
	return (int)status >= 0 && status < HAWSER_STATUS_COUNT;
}

const char *hawser_status_name(enum hawser_status status)
{
	return known(status) ? table[status].name : "unknown";
}

int hawser_status_exit(enum hawser_status status)
{
	return known(status) ? table[status].exit : 4;
}

const char *hawser_version(void)
{
	return PACKAGE_VERSION;
}

static void fill(struct hawser_report *report, enum hawser_status status, const char *where,
                 int iteration, double residual, const char *format, va_list args)
{
	if (!report)
		return;
	report->status = status;
	report->where = where;
	report->iteration = iteration;
	report->residual = residual;
	vsnprintf(report->message, sizeof report->message, format, args);
	/* names and words from files may contain control characters, which could control a terminal or
	 * start a new line: mask them */
	for (char *at = report->message; *at; at++)
		if ((unsigned char)*at < ' ' || *at == '\177')
			*at = '?';
}

enum hawser_status (hawser__fail)(struct hawser_report *report, enum hawser_status status,
                                  const char *where, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	fill(report, status, where, 0, 0.0, format, args);
	va_end(args);
	return status;
}

enum hawser_status (hawser__fail_at)(struct hawser_report *report, enum hawser_status status,
                                     const char *where, int iteration, double residual,
                                     const char *format, ...)
{
	va_list args;

	va_start(args, format);
	fill(report, status, where, iteration, residual, format, args);
	va_end(args);
	return status;
}
