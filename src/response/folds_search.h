/* response/folds_search.h - where fold curves are looked for, and the detached curves that they tell
 * of.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_FOLDS_SEARCH_H
#define HAWSER_RESPONSE_FOLDS_SEARCH_H

#include "response/folds_known.h"
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
	struct hawser__fold_known known;    /* what the curves pass */
	int unfinished; /* a curve ended where the corrector or a limit did */
	double window[2]; /* scaled Omega: the range and what is beside it */
	double *decay;  /* [4n] real parts of the linear model's eigenvalues, falling, and work space */
	struct hawser_report *report;
};

/* What the responses and the curves report to the caller of the whole. */
struct hawser__fold_watch {
	const struct hawser_folds_options *options;
	const char *stage;
	const struct hawser_frf *other; /* or NULL: end a response that begins where this one ended */
	int same;                       /* that was so */
};

/* Responses at one load from both ends. */
struct hawser__fold_level {
	int folds;  /* of the responses */
	int linear; /* they are one, from end to end, and nearly linear */
	int failed; /* one could not be traced to its end */
};
int hawser__fold_watch(void *data, const struct hawser_progress_state *state);

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

/* folds_isola.c: keep a response at the nominal load among the detached ones; *frf is taken over. Its
 * folds are followed: they may lead to others. */
enum hawser_status hawser__fold_keep(struct hawser__fold_search *search, struct hawser_frf *frf);

/* folds_linear.c: search->decay and search->window. */
enum hawser_status hawser__fold_decay(struct hawser__fold_search *search);
/* folds_linear.c: whether a response at this load is nearly linear. */
int hawser__fold_linear(const struct hawser__fold_search *search, const struct hawser__load *load,
                        const struct hawser_frf *frf);
/* folds_levels.c: the curves through the folds at this load, within the range or, where wide, within
 * its window; what cannot be traced in the window is within the range. */
enum hawser_status hawser__fold_level(struct hawser__fold_search *search, double factor, int wide,
                                      struct hawser__fold_level *level);
/* folds_levels.c: the same for the response in reverse alone, unless it is the first one, reversed. */
enum hawser_status hawser__fold_reverse(struct hawser__fold_search *search,
                                        const struct hawser_frf *first,
                                        const struct hawser__load *load, int wide,
                                        struct hawser__fold_level *level);
/* folds_levels.c: tell in the result that responses at this load were searched. */
enum hawser_status hawser__fold_note_level(struct hawser__fold_search *search, double load, int wide,
                                           int found);
/* folds_levels.c: responses at falling loads, until no fold is left. */
enum hawser_status hawser__fold_levels(struct hawser__fold_search *search);
/* folds_levels.c: the least load of the result. */
void hawser__fold_least(struct hawser__fold_search *search);

/* folds.c: folds among the events of a response. */
int hawser__fold_count(const struct hawser_frf *frf);
/* folds.c: add to the result's note, as printf does. */
#define HAWSER__FOLDS_CUT "the response at load factor %.6g ended at Omega %.6g%s, after %d points: " \
	"folds beyond may be missing (--max-points)"
void hawser__fold_note(struct hawser__fold_search *search, const char *format, ...)
	HAWSER_PRINTF(2, 3);

/* folds.c: the curves through all folds of a response at this load, but those that are known. */
enum hawser_status hawser__fold_curves(struct hawser__fold_search *search,
                                       const struct hawser_frf *frf, double load);

/* folds.c: a fold from which there is no curve. */
enum hawser_status hawser__fold_lost(struct hawser__fold_search *search, double omega, double load);

/* folds.c: options of a response within the range. */
struct hawser_frf_options hawser__fold_response(const struct hawser__fold_search *search,
                                                struct hawser__fold_watch *watch);

#endif
