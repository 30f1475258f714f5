/* hawser/cover.h - the response over a whole range of Omega where its first branch does not cover it:
 * that branch came back to where it began, or ended where the cable goes slack.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_COVER_H
#define HAWSER_COVER_H

#include <hawser/frf.h>

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_cover {
	int branches;
	struct hawser_frf *branch; /* [branches] in the order in which they were traced */
	int gaps;
	double *gap;               /* [gaps][2] scaled Omega, ascending: parts of the range in which no
	                            * branch was found */
	double work;               /* of all of it, s (hawser_orbit_work) */
	int costly;                /* 1: a branch ended, or was left out, at options->most_work
	                            * of all branches together */
};

/* Whether `first`, traced with these options, leaves a part of the range uncovered that
 * hawser_cover_trace looks for: it ended at neither the other end of the range nor a limit. */
int hawser_cover_needed(const struct hawser_frf *first, const struct hawser_frf_options *options);

/* Trace further branches: one from the other end of the range, and then, as long as a part of the range
 * has no branch, one from the middle of that part to each of its ends. A first orbit in such a part is
 * found from the linear response. A branch that cannot be followed to its end is kept with the end
 * HAWSER_END_FAILED. options: those of `first`. Release with hawser_cover_clear. Statuses: those of
 * hawser_frf_trace but HAWSER_ERR_CONVERGENCE. */
enum hawser_status hawser_cover_trace(struct hawser_cover *cover, const struct hawser_frf *first,
                                      const struct hawser_rom *rom,
                                      const struct hawser_frf_options *options,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_cover_clear(struct hawser_cover *cover);

#ifdef __cplusplus
}
#endif
#endif
