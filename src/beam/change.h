/* beam/change.h - the speed at which the number of growing pairs, or of real pairs, changes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BEAM_CHANGE_H
#define HAWSER_BEAM_CHANGE_H

#include "beam/sample.h"

enum hawser__beam_counted { HAWSER__BEAM_GROWING, HAWSER__BEAM_REAL };

/* Solves the eigenvalue problem at a speed; `watched` as in hawser__beam_sample. */
struct hawser__beam_solver {
	enum hawser_status (*solve)(struct hawser__beam_sample *sample, void *context, double speed,
	                            struct hawser_report *report);
	void *context;
	int watched;
};

/* A located change. */
struct hawser__beam_change {
	double speed;        /* middle of the bracket */
	double beyond;       /* end of the bracket at which the number has changed */
	int before, after;   /* numbers at the two ends */
	double im;           /* at `beyond`, imaginary part of the growing pair of smallest real part;
	                      * 0: the pair is real, or no pair grows */
};

/* Locate a change between the speeds of `a` and `b`, whose numbers must differ, in a bracket of
 * relative width 1e-13. Returns the status of `solve` if that fails. */
enum hawser_status hawser__beam_change(struct hawser__beam_change *change,
                                       const struct hawser__beam_solver *solver,
                                       const struct hawser__beam_sample *a,
                                       const struct hawser__beam_sample *b,
                                       enum hawser__beam_counted counted,
                                       struct hawser_report *report);

#endif
