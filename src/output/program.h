/* output/program.h - external programs that draw: found at run time, run with files as their standard
 * streams. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PROGRAM_H
#define HAWSER_OUTPUT_PROGRAM_H

#include <signal.h>
#include <stdio.h>

#include <hawser/status.h>

struct hawser__program {
	const char *name;     /* sought along PATH */
	const char *variable; /* of the environment: another name, or a path */
	/* What cannot be done without it; `at`: where the variable says that it is, or "". */
	enum hawser_status (*missing)(const char *at, struct hawser_report *report);
};
extern const struct hawser__program hawser__gnuplot, hawser__ffmpeg;

/* HAWSER_ERR_PROGRAM if it is not there. */
enum hawser_status hawser__program_check(const struct hawser__program *program,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* Run it with arguments [count] after its name, the files as standard input and output, and this signal
 * mask, so that an interrupt ends it although interrupts are blocked in this process. */
enum hawser_status hawser__program_run(const struct hawser__program *program,
                                       const char *const *arguments, int count, FILE *in, FILE *out,
                                       const sigset_t *signals, struct hawser_report *report)
	HAWSER_MUST_CHECK;

#endif
