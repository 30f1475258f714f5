/* response/locus/folds_known.h - folds on curves that have been traced.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_FOLDS_KNOWN_H
#define HAWSER_RESPONSE_FOLDS_KNOWN_H

#include "response/locus/folds_walk.h"

struct hawser__fold_place {
	double omega, load;
	int kind;
};

struct hawser__fold_known {
	int m;                            /* size of a state, 2n */
	int count;
	struct hawser__fold_place *place; /* [count] curve after curve */
	double *state;                    /* [count][m] */
};

void hawser__known_clear(struct hawser__fold_known *known);
/* Whether a curve has a point with this Omega at exactly this load: at a crossing of the nominal
 * load or at an end. A motion and its mirror image have the same curve. */
int hawser__known_passage(const struct hawser__fold_known *known, double omega, double load);
/* Whether this fold, with its state [m], lies on a curve. */
int hawser__known_fold(const struct hawser__fold_known *known, double omega, double load,
                       const double *state);
/* Whether a list is part of a curve; range[2] of Omega. */
int hawser__known_curve(const struct hawser__fold_known *known,
                        const struct hawser__fold_list *list, const double *range);
/* Add a list to the curves. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__known_add(struct hawser__fold_known *known,
                                     const struct hawser__fold_list *list, const double *range,
                                     struct hawser_report *report);
/* Whether two states [m] differ by at most this fraction of their size. */
int hawser__same_state(const double *a, const double *b, int m, double tolerance);

#endif
