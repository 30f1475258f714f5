/* hawser/status.h - what a call can answer, and the report that says where and why.
 *
 * Law of arguments, for every public function: the object acted on first, then outputs, then
 * in/outs, then inputs (an array is followed by its length), then settings, and the report last.
 * Every pointer's shape and unit is in its comment. No global state: two threads may call
 * anything as long as they do not share an object that one of them changes.
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

/* The program's exit status is hawser_status_exit() of these. */
enum hawser_status {
	HAWSER_OK = 0,
	HAWSER_ERR_ARGUMENT,    /* a call or option that makes no sense            (exit 1) */
	HAWSER_ERR_SCENE,       /* a scene or model file that breaks its contract  (exit 1) */
	HAWSER_ERR_NO_SOLUTION, /* no such equilibrium; the problem has no answer  (exit 2) */
	HAWSER_ERR_CONVERGENCE, /* an iteration stopped short of its tolerance     (exit 3) */
	HAWSER_ERR_NAN,         /* a not-a-number appeared; the report names it    (exit 3) */
	HAWSER_ERR_MEMORY,      /* allocation failed                               (exit 4) */
	HAWSER_ERR_IO,          /* a file could not be read or written             (exit 4) */
	HAWSER_ERR_PROGRAM,     /* a helper program is missing or failed           (exit 4) */
	HAWSER_STATUS_COUNT
};

/* Where a call failed and why; owned by the caller, valid without initialisation. Every function
 * that takes one accepts NULL. On HAWSER_OK it is left alone. */
struct hawser_report {
	enum hawser_status status;
	char message[640];  /* one or two sentences for the user, no trailing newline */
	const char *where;  /* static string: the function or stage that gave up */
	int iteration;      /* of the iteration that failed, 0 where there is none */
	double residual;    /* its last residual, in the unit the message states; 0 where none */
};

/* Short name, such as "no-solution". Static string; "unknown" outside the enum. */
const char *hawser_status_name(enum hawser_status status);

/* 0 done, 1 usage or scene, 2 no answer, 3 not converged, 4 system. */
int hawser_status_exit(enum hawser_status status);

/* "0.1.0" */
const char *hawser_version(void);

#ifdef __cplusplus
}
#endif
#endif
