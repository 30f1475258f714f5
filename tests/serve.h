/* tests/serve.h - processes forked from a program of tests that has hawser in it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_SERVE_H
#define HAWSER_TESTS_SERVE_H

/* In a child: this file as that descriptor; it ends where that fails. */
void redirect(int to, const char *name, int flags);
/* Run the command lines that standard input has. Returns the exit status of the server. */
int serve(void);

#endif
