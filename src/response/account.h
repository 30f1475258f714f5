/* response/account.h - the events between two neighbouring stations of a branch, and the proof that
 * they are all.
 *
 * The unstable multipliers are counted at both stations. The located events must explain the change
 * of this count; a change that they do not explain becomes an event of its own,
 * HAWSER_UNEXPLAINED. So no change of stability passes without an event. A multiplier beside 1 that is
 * undecided may be counted or not: of the fold or branch point that it makes, the test function is
 * known better than the multiplier.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_ACCOUNT_H
#define HAWSER_RESPONSE_ACCOUNT_H

#include "response/station.h"

#define HAWSER__DEEPEST 24 /* halvings of a step: 0.4 becomes 2e-8 */

/* A part of a step that could not be halved further although its events do not explain the change
 * of the count in it. */
struct hawser__remainder {
	double arc[2], omega[2];
	struct hawser__circle circle[2];
	int first, events; /* its events */
};

struct hawser__account {
	double tolerance;       /* of the corrector */
	double event_tolerance; /* relative, in Omega */
	/* Called for every located event, y [size] its orbit; or NULL. */
	void (*watch)(void *context, const struct hawser_frf_event *event,
	              const struct hawser__orbit *orbit, const double *y);
	void *context;
	/* Results of the last step. */
	struct hawser_frf_event *event; /* [events], in order along the branch, without `after` */
	int events, event_capacity;
	int unresolved; /* remainders that were not explained */
	int sure;       /* the tests and the counts of the last step are the sure ones (station.h) */
	int gaps;       /* places at which the corrector failed: the stations may lie on two branches */
	/* Work space. */
	struct hawser__remainder *remainder; /* [remainders] */
	int remainders, remainder_capacity;
	struct hawser__station station[HAWSER__DEEPEST], scratch;
};

/* Allocate the first work space; all other fields but tolerances and watch must be zero. */
enum hawser_status hawser__account_init(struct hawser__account *account,
                                        const struct hawser__orbit *orbit,
                                        struct hawser_report *report);
void hawser__account_clear(struct hawser__account *account);

/* Locate all events between a and b. A failure of the corrector is counted in account->gaps and is
 * no failure of the call. */
enum hawser_status hawser__account_step(struct hawser__account *account, struct hawser__orbit *orbit,
                                        const struct hawser__station *a,
                                        const struct hawser__station *b,
                                        struct hawser_report *report);

/* Number of test functions, the sure ones or the others (station.h), that change sign between a and b;
 * *width is by how much these events change the number of unstable multipliers, where none undoes
 * another. */
int hawser__account_crossings(const struct hawser__station *a, const struct hawser__station *b,
                              int *width, int sure);

#endif
