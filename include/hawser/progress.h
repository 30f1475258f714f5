/* hawser/progress.h - how a long computation reports its progress, and how the caller ends it.
 *
 * The options of every long computation have a member `progress`. Its function is called again and
 * again, always from the thread that called the library, with the state of the computation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_PROGRESS_H
#define HAWSER_PROGRESS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_frf; /* frf.h */

/* Valid during the call only, with all that it points to. Later versions may add members at the
 * end. */
struct hawser_progress_state {
	const char *stage;  /* what is being computed, such as "response" */
	const char *unit;   /* what is counted: "points", "rows", "frequencies" */
	long done;          /* number computed so far */
	long expected;      /* estimated number in all; 0: unknown */
	long fresh;         /* of `done`, those computed by this call; the others are from a file */
	double fraction;    /* of the work that is done, 0 to 1; NAN: unknown */
	double seconds;     /* wall time since the computation of this stage began */
	double left;        /* s, estimated wall time until its end; NAN: unknown, INFINITY: and what was
	                     * told before does not hold */
	double omega;       /* forcing frequency of the last point, rad/s (if the model has no units, its
	                     * Omega); NAN: none */
	double load;        /* load factor of the last point; NAN: none */
	int events;         /* number of located bifurcations; -1: not counted */
	const struct hawser_frf *frf; /* the response curve so far, or NULL */
	int longer;         /* 1: the end is later than was shown before; set by what shows it */
};

/* All zero: progress is not reported. */
struct hawser_progress {
	/* Returns 0 to go on; any other value ends the computation, which then returns the results
	 * that it has and marks them as interrupted. */
	int (*function)(void *data, const struct hawser_progress_state *state);
	void *data; /* passed to function */
};

/* The state in one line, such as "response: 120 points, 2 events, Omega 1.7". text [size] is cut at
 * size - 1 characters and ended by '\0'. */
void hawser_progress_text(const struct hawser_progress_state *state, char *text, size_t size);

#ifdef __cplusplus
}
#endif
#endif
