/* response/branch/account.h - all events between two neighbouring stations of a branch.
 *
 * The unstable multipliers are counted at both stations. The located events must explain the change
 * of this count. A change that they do not explain becomes an event of the kind HAWSER_UNEXPLAINED,
 * so that every change of stability has an event. A multiplier near 1 that is undecided may or may
 * not be counted: for the fold or branch point that it belongs to, the test function is more
 * accurate than the multiplier.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_ACCOUNT_H
#define HAWSER_RESPONSE_ACCOUNT_H

#include "response/branch/crossing.h"
#include "response/branch/station.h"

#define HAWSER__DEEPEST 24 /* halvings of a step: 0.4 becomes 2e-8 */

/* A part of a step that could not be halved further, and whose events do not explain the change of
 * its count. */
struct hawser__remainder {
	double arc[2], omega[2];
	struct hawser__circle circle[2];
	int first, events; /* its events */
};

struct hawser__account {
	double tolerance;       /* of the corrector */
	double event_tolerance; /* relative, in Omega */
	double lo, hi;          /* range of the parameter: events are within it */
	/* Called for every located event, y [size] its orbit; or NULL. */
	void (*watch)(void *context, const struct hawser_frf_event *event,
	              const struct hawser__orbit *orbit, const double *y);
	void *context;
	int uncounted;          /* 1: there are no multipliers, whose count the events would explain */
	/* Results of the last step. */
	struct hawser_frf_event *event; /* [events], in order along the branch; `after` is the row of
	                                 * `state`, -1: none */
	double *state;  /* [events][m] of the events' orbits, in the units of their model */
	int events;
	int unresolved; /* remainders that were not explained */
	int sure;       /* 1: the sure test functions and counts (station.h) were used in the last step */
	int gaps;       /* number of points at which the corrector failed: the two stations may lie on
	                 * different branches */
	/* Work space. */
	struct hawser__remainder *remainder; /* [remainders] */
	int remainders;
	struct hawser__station station[HAWSER__DEEPEST], scratch;
	struct hawser__crossing crossing;
};

/* Allocate the first workspace; all other members but tolerances and watch must be zero. */
enum hawser_status hawser__account_init(struct hawser__account *account,
                                        const struct hawser__orbit *orbit,
                                        struct hawser_report *report);
void hawser__account_clear(struct hawser__account *account);

/* Locate all events between a and b; one that a multiplier's error hides may lie beside them
 * (crossing.h). If the corrector fails, account->gaps is increased, and the
 * call does not fail. */
enum hawser_status hawser__account_step(struct hawser__account *account, struct hawser__orbit *orbit,
                                        const struct hawser__station *a,
                                        const struct hawser__station *b,
                                        struct hawser_report *report);

/* Number of test functions, the sure ones or the others (station.h), that change sign between a and
 * b. *width becomes the change of the number of unstable multipliers by these events if all have
 * the same direction. */
int hawser__account_crossings(const struct hawser__station *a, const struct hawser__station *b,
                              int *width, int sure);

#endif
