/* core/report.h - how a function fails: fill the caller's report and return its status.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_REPORT_H
#define HAWSER_CORE_REPORT_H

#include <errno.h>

#include <hawser/status.h>

/* return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes", "the basis of %d functions ...", n); */
enum hawser_status hawser__fail(struct hawser_report *report, enum hawser_status status,
                                const char *where, const char *format, ...) HAWSER_PRINTF(4, 5);

/* The same for an iteration that failed: also records iteration and residual. */
enum hawser_status hawser__fail_at(struct hawser_report *report, enum hawser_status status,
                                   const char *where, int iteration, double residual,
                                   const char *format, ...) HAWSER_PRINTF(6, 7);

/* For analysers, which see one file at a time (`make check-analyzers`): both functions return
 * `status`. */
#if defined(__clang_analyzer__) || defined(HAWSER_ANALYSED)
#define hawser__fail(report, status, where, ...) \
	(hawser__fail(report, status, where, __VA_ARGS__), (status))
#define hawser__fail_at(report, status, where, iteration, residual, ...) \
	(hawser__fail_at(report, status, where, iteration, residual, __VA_ARGS__), (status))
#endif

/* Report a failed allocation. Inline, so that analysers see that the status is not HAWSER_OK. */
static inline enum hawser_status hawser__no_memory(struct hawser_report *report, const char *where)
{
	(void)hawser__fail(report, HAWSER_ERR_MEMORY, where, "out of memory");
	return HAWSER_ERR_MEMORY;
}

/* The status for an input that could not be read, by errno: HAWSER_ERR_ARGUMENT if the file does
 * not exist, which is a mistake of the user, else HAWSER_ERR_IO. */
static inline enum hawser_status hawser__unreadable(int error)
{
	return error == ENOENT || error == ENOTDIR || error == EISDIR || error == ENAMETOOLONG ||
	       error == ELOOP ? HAWSER_ERR_ARGUMENT : HAWSER_ERR_IO;
}

/* 1 if the info of a LAPACKE call reports that work space could not be allocated (two constants of
 * lapacke.h, which this stage does not include). Any other nonzero info is a failure of the
 * matrix. */
static inline int hawser__lapack_starved(int info)
{
	return info == -1010 || info == -1011;
}

#endif
