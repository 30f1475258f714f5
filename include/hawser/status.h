/* hawser/status.h - return statuses, and the report of where and why a call failed.
 *
 * Law of arguments, for every public function: the object acted on first, then outputs, then
 * in/outs, then inputs (an array is followed by its length), then settings, and the report last.
 * Every pointer's shape and unit is in its comment. The library has no global state: threads may
 * call any functions at the same time, unless one thread changes an object that another one uses.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATUS_H
#define HAWSER_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define HAWSER_MUST_CHECK __attribute__((warn_unused_result))
#define HAWSER_PRINTF(fmt, args) __attribute__((format(printf, fmt, args)))
#else
#define HAWSER_MUST_CHECK
#define HAWSER_PRINTF(fmt, args)
#endif

/* hawser_status_exit() maps a status to the program's exit status, given in parentheses. */
enum hawser_status {
	HAWSER_OK = 0,
	HAWSER_ERR_ARGUMENT,    /* an invalid argument or option                   (exit 1) */
	HAWSER_ERR_SCENE,       /* an invalid scene or model file                  (exit 1) */
	HAWSER_ERR_NO_SOLUTION, /* the problem has no solution                     (exit 2) */
	HAWSER_ERR_CONVERGENCE, /* an iteration did not reach its tolerance        (exit 3) */
	HAWSER_ERR_NAN,         /* a value is not a number; the report names it    (exit 3) */
	HAWSER_ERR_MEMORY,      /* allocation failed                               (exit 4) */
	HAWSER_ERR_IO,          /* a file could not be read or written             (exit 4) */
	HAWSER_ERR_PROGRAM,     /* an external program is missing or failed        (exit 4) */
	HAWSER_STATUS_COUNT
};

/* Where a call failed and why. The caller owns it and need not initialise it. Every function that
 * takes a report accepts NULL. A call that returns HAWSER_OK does not change it. */
struct hawser_report {
	enum hawser_status status;
	char message[640];  /* one or two sentences for the user, no trailing newline */
	const char *where;  /* static string: the function or stage that failed */
	int iteration;      /* number of iterations done by the iteration that failed, else 0 */
	double residual;    /* its last residual, in the unit the message states; 0 if there is none */
};

/* Short name, such as "no-solution". Static string; "unknown" outside the enum. */
const char *hawser_status_name(enum hawser_status status);

/* 0 success, 1 usage or scene, 2 no solution, 3 not converged, 4 system. */
int hawser_status_exit(enum hawser_status status);

/* Options: all members of 0 have their defaults, so that a structure of options that is all zero is
 * ready once its range is set. Every function that takes options replaces zeros by the defaults; the
 * functions named _settle do only that, for callers that want to know them. HAWSER_NONE (or any
 * negative number) is for those of which 0 would mean "none". */
#define HAWSER_NONE (-1)

/* The version of these headers; for #if, HAWSER_VERSION_NUMBER is 10000 major + 100 minor + patch. */
#define HAWSER_VERSION_MAJOR 0
#define HAWSER_VERSION_MINOR 1
#define HAWSER_VERSION_PATCH 0
#define HAWSER_VERSION_NUMBER \
	(10000*HAWSER_VERSION_MAJOR + 100*HAWSER_VERSION_MINOR + HAWSER_VERSION_PATCH)

/* The version of the library that runs: "0.1.0". */
const char *hawser_version(void);

#ifdef __cplusplus
}
#endif
#endif
