/* response/folds_search.h - where fold curves are looked for, and the detached curves that they tell
 * of.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_FOLDS_SEARCH_H
#define HAWSER_RESPONSE_FOLDS_SEARCH_H

#include "response/folds_walk.h"

struct hawser__fold_search {
	struct hawser_folds *folds;
	const struct hawser_rom *rom;
	const struct hawser_folds_options *options;
	struct hawser__fold fold;
	struct hawser__fold_walk walk;
	double *beside; /* [2n] a state on a detached curve */
	double bend;    /* f_xx/f_Omega at the fold from which one is sought */
	struct hawser__fold_store seeds;    /* folds of the last response */
	struct hawser__fold_store passages; /* of the curves */
	struct hawser_report *report;
};

/* What the responses and the curves report to the caller of the whole. */
struct hawser__fold_watch {
	const struct hawser_folds_options *options;
	const char *stage;
};
int hawser__fold_watch(void *context, const struct hawser_frf *frf);

/* folds_seed.c: a response whose folds are kept in search->seeds. */
enum hawser_status hawser__fold_trace(struct hawser__fold_search *search, struct hawser_frf *frf,
                                      const struct hawser_rom *rom,
                                      const struct hawser_frf_options *choice,
                                      struct hawser_report *report);
/* folds_seed.c: walk.start is this fold of the last response. *failed where it is not found. */
enum hawser_status hawser__fold_seed(struct hawser__fold_search *search,
                                     const struct hawser_frf *frf,
                                     const struct hawser_frf_event *event, double load,
                                     int *failed);

/* folds_isola.c: trace the curves at the nominal load on which there are folds that the response did
 * not visit. */
enum hawser_status hawser__fold_isolas(struct hawser__fold_search *search);

/* folds.c: the curves through all folds of a response at this load, but those that are known. */
enum hawser_status hawser__fold_curves(struct hawser__fold_search *search,
                                       const struct hawser_frf *frf, double load);

/* folds.c: a fold from which there is no curve. */
enum hawser_status hawser__fold_lost(struct hawser__fold_search *search, double omega, double load);

/* folds.c: options of a response within the range. */
struct hawser_frf_options hawser__fold_response(const struct hawser__fold_search *search,
                                                struct hawser__fold_watch *watch);

#endif
