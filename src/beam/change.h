/* beam/change.h - the speed at which the number of growing pairs, or of real ones, changes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BEAM_CHANGE_H
#define HAWSER_BEAM_CHANGE_H

#include "beam/sample.h"

enum hawser__beam_counted { HAWSER__BEAM_GROWING, HAWSER__BEAM_REAL };

/* How to solve at a speed; `watched` as in hawser__beam_sample. */
struct hawser__beam_solver {
	enum hawser_status (*solve)(struct hawser__beam_sample *stop, void *context, double speed,
	                            struct hawser_report *report);
	void *context;
	int watched;
};

/* Both sides of a change, and what is to be said of the far one. */
struct hawser__beam_change {
	double speed;        /* the middle of the bracket */
	double beyond;       /* its end at which the number has changed */
	int before, after;   /* the numbers at its ends */
	double im;           /* at `beyond`, of the growing pair of least growth; 0: real, or none */
};

/* A change between the speeds of `a` and `b`, whose numbers differ, bracketed to 1e-13 of the larger
 * speed. Fails only as `solve` does. */
enum hawser_status hawser__beam_change(struct hawser__beam_change *change,
                                       const struct hawser__beam_solver *solver,
                                       const struct hawser__beam_sample *a,
                                       const struct hawser__beam_sample *b,
                                       enum hawser__beam_counted counted,
                                       struct hawser_report *report);

#endif
