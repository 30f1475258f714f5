/* response/locus/folds_search.h - the search for fold curves and for the detached response curves that
 * they reveal.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_FOLDS_SEARCH_H
#define HAWSER_RESPONSE_FOLDS_SEARCH_H

#include "response/locus/folds_known.h"
#include "response/locus/folds_walk.h"

struct hawser__fold_search {
	struct hawser_folds *folds;
	const struct hawser_rom *rom;
	const struct hawser_folds_options *options;
	struct hawser__fold fold;
	struct hawser__fold_walk walk;
	double *beside; /* [2n] a state on a detached curve */
	double bend;    /* f_xx/f_Omega at the fold from which this state is sought */
	struct hawser__fold_store seeds;    /* folds of the last response */
	struct hawser__fold_store passages; /* folds of the curves at the nominal load */
	struct hawser__fold_known known;    /* points of the known curves */
	int unfinished; /* 1: a curve ended because the corrector failed or a limit was reached */
	int for_folds;  /* 1: of the present response only the folds are of interest */
	int unasked;    /* 1: the number of pseudo-random motions (`starts`) is the default */
	int cut;        /* responses that ended at options->most_unstable */
	double window[2]; /* scaled Omega: the range with margins */
	double part[2]; /* of the whole search, of the responses at the present load */
	double *decay;  /* [4n] real parts of the linear model's eigenvalues, falling, and workspace */
	struct hawser_report *report;
};

/* Progress of responses and curves, as parts of the whole search. */
struct hawser__fold_watch {
	const struct hawser_folds_options *options;
	struct hawser__span *span;
	const char *stage;
	const struct hawser_frf *other; /* a response, or NULL: a trace that begins on its last orbit is
	                                 * stopped */
	int same;                       /* 1: this happened */
};

/* The responses at one load from both ends of the range. */
struct hawser__fold_level {
	int folds;  /* number of folds of the responses */
	int linear; /* 1: both are the same curve, from end to end, and nearly linear */
	int failed; /* 1: one could not be traced to its end */
};
/* folds.c: what begins now takes `stage` s, and what follows `after` s. */
void hawser__fold_ahead(struct hawser__fold_search *search, double stage, double after);
/* folds_isola.c: the time that detached curves take, s, after the search for others has taken
 * `before`. */
double hawser__fold_detached(const struct hawser__fold_search *search, double before);
/* folds.c: tell progress between traces; 1: the search is to end. */
int hawser__fold_told_to_stop(struct hawser__fold_search *search, const char *stage, const char *unit,
                              long done);
int hawser__fold_watch(void *data, const struct hawser_progress_state *state);

/* folds_seed.c: trace a response and store its folds in search->seeds. */
enum hawser_status hawser__fold_trace(struct hawser__fold_search *search, struct hawser_frf *frf,
                                      const struct hawser_rom *rom,
                                      const struct hawser_frf_options *choice,
                                      struct hawser_report *report);
/* folds_seed.c: start the walk at this fold of the last response. *failed: 1: it was not found. */
enum hawser_status hawser__fold_seed(struct hawser__fold_search *search,
                                     const struct hawser_frf *frf,
                                     const struct hawser_frf_event *event, double load,
                                     int *failed);

/* folds_isola.c: trace the curves at the nominal load that have folds which are not on the
 * response. */
enum hawser_status hawser__fold_isolas(struct hawser__fold_search *search);

/* folds_starts.c: look for detached curves at the nominal load from pseudo-random motions. */
enum hawser_status hawser__fold_starts(struct hawser__fold_search *search);

/* folds_isola.c: add a response at the nominal load to the detached ones; *frf is moved. The curves
 * through its folds are followed and may lead to further ones. */
enum hawser_status hawser__fold_keep(struct hawser__fold_search *search, struct hawser_frf *frf);

/* folds_linear.c: compute search->decay and search->window. */
enum hawser_status hawser__fold_decay(struct hawser__fold_search *search);
/* folds_linear.c: whether a response at this load is nearly linear. */
int hawser__fold_linear(const struct hawser__fold_search *search, const struct hawser__load *load,
                        const struct hawser_frf *frf);
/* folds_levels.c: trace the curves through the folds of the response in reverse, unless it is the same
 * curve as the first one. */
enum hawser_status hawser__fold_reverse(struct hawser__fold_search *search,
                                        const struct hawser_frf *first,
                                        const struct hawser__load *load, int wide,
                                        struct hawser__fold_level *level);
/* folds_levels.c: record in the result that responses at this load were searched. */
enum hawser_status hawser__fold_note_level(struct hawser__fold_search *search, double load, int wide,
                                           int found);
/* folds_levels.c: search responses at falling loads until there is no fold. */
enum hawser_status hawser__fold_levels(struct hawser__fold_search *search);
/* folds_levels.c: the least load of the result. */
void hawser__fold_least(struct hawser__fold_search *search);

/* Whether the search is to end although something remains to be done: told so, or after the most
 * work. */
static inline int hawser__fold_ended(struct hawser__fold_search *search)
{
	return search->folds->interrupted || hawser__walk_refused(&search->walk);
}

/* Whether a response ended at a limit. */
static inline int hawser__fold_limited(const struct hawser_frf *frf)
{
	return frf->end == HAWSER_END_MAX_POINTS || frf->end == HAWSER_END_WORK;
}

/* folds.c: number of folds among the events of a response. */
int hawser__fold_count(const struct hawser_frf *frf);
/* folds.c: append to the note of the result, with the arguments of printf; "..." where it is full. */
void hawser__fold_note(struct hawser__fold_search *search, const char *format, ...)
	HAWSER_PRINTF(2, 3);
/* folds.c: append that a response at this load ended at a limit, if it did. */
void hawser__fold_note_cut(struct hawser__fold_search *search, const struct hawser_frf *frf,
                           double load);

/* folds.c: trace the curves through all folds of a response at this load, except known ones. */
enum hawser_status hawser__fold_curves(struct hawser__fold_search *search,
                                       const struct hawser_frf *frf, double load);

/* folds.c: trace the curve through walk.start, unless it is known. */
enum hawser_status hawser__fold_new(struct hawser__fold_search *search);
/* folds_image.c: the same, and then the curves through the images of that fold. */
enum hawser_status hawser__fold_images(struct hawser__fold_search *search);

/* folds.c: record a fold through which no curve was traced. */
enum hawser_status hawser__fold_lost(struct hawser__fold_search *search, double omega, double load);

/* folds.c: options of a response within the range. */
struct hawser_frf_options hawser__fold_response(struct hawser__fold_search *search,
                                                struct hawser__fold_watch *watch);

#endif
