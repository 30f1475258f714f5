/* core/report.h - how a function fails: fill the caller's report and return its status.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_REPORT_H
#define HAWSER_CORE_REPORT_H

#include <errno.h>

#include <hawser/status.h>

/* return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes", "the basis of %d functions ...", n); */
enum hawser_status hawser__fail(struct hawser_report *report, enum hawser_status status,
                                const char *where, const char *format, ...) HAWSER_PRINTF(4, 5);

/* The same for an iteration that stopped: records iteration and residual too. */
enum hawser_status hawser__fail_at(struct hawser_report *report, enum hawser_status status,
                                   const char *where, int iteration, double residual,
                                   const char *format, ...) HAWSER_PRINTF(6, 7);

/* What an analyser that sees one file at a time cannot know (`make check-analyzers`): they return
 * `status`. */
#if defined(__clang_analyzer__) || defined(HAWSER_ANALYSED)
#define hawser__fail(report, status, where, ...) \
	(hawser__fail(report, status, where, __VA_ARGS__), (status))
#define hawser__fail_at(report, status, where, iteration, residual, ...) \
	(hawser__fail_at(report, status, where, iteration, residual, __VA_ARGS__), (status))
#endif

/* The one sentence for a failed allocation. Here, where every caller's analyser sees that what comes
 * back is not HAWSER_OK. */
static inline enum hawser_status hawser__no_memory(struct hawser_report *report, const char *where)
{
	(void)hawser__fail(report, HAWSER_ERR_MEMORY, where, "out of memory");
	return HAWSER_ERR_MEMORY;
}

/* The status of an input that could not be read, by errno: a name under which there is no file
 * is the user's mistake, as any other wrong name; the rest is the system's. */
static inline enum hawser_status hawser__unreadable(int error)
{
	return error == ENOENT || error == ENOTDIR || error == EISDIR || error == ENAMETOOLONG ||
	       error == ELOOP ? HAWSER_ERR_ARGUMENT : HAWSER_ERR_IO;
}

/* Whether the info of a LAPACKE call says that it got no work space (the two constants of lapacke.h,
 * which this stage does not include). That is not the failure of the matrix that any other info is. */
static inline int hawser__lapack_starved(int info)
{
	return info == -1010 || info == -1011;
}

#endif
