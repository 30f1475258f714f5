/* response/locus/folds_walk.h - the trace of a fold curve, and its results.
 *
 * folds_begin.c finds the first point, folds_walk.c makes the steps, folds_end.c detects the end,
 * folds_events.c locates events between two stations, folds_list.c stores the results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_FOLDS_WALK_H
#define HAWSER_RESPONSE_FOLDS_WALK_H

#include "core/progress.h"
#include "response/branch/amplitude.h"
#include "response/locus/folds.h"

/* Orbits by harmonic balance, stored by their frequency. The state at one phase determines the orbit
 * only if an integration over a period is accurate, which it is not for stiff models and strongly
 * unstable orbits: the complete orbits of folds are stored. */
struct hawser__fold_store {
	int size;          /* of an orbit: Fourier coefficients and Omega, the last */
	int count;
	double *y;         /* [count][size] */
	int failed;        /* 1: an orbit was not stored for lack of memory */
};

void hawser__store_add(struct hawser__fold_store *store, const double *y);
/* The orbit with exactly this Omega, or NULL. */
const double *hawser__store_find(const struct hawser__fold_store *store, double omega);
void hawser__store_clear(struct hawser__fold_store *store);

/* A corrected point of the curve. */
struct hawser__fold_station {
	double *z, *t;  /* [size] unknowns and unit tangent */
	double *b, *c;  /* [size] borders: null vectors, which give the test functions their sign */
	double arc;
	double test[HAWSER_FOLD_TESTS];
	double F_load;
	double mesh;
	int orientation; /* sign of the determinant with the tangent; constant along a curve */
	struct hawser__correction correction;
	double *memory;
};

/* Half a curve, from its start in one direction, or a whole one. */
struct hawser__fold_list {
	int n, probes;
	int points, events;
	struct hawser_folds_point *point; /* [points] */
	double *row;                      /* [points][n + 3 probes + 2n] amplitudes and state */
	struct hawser_folds_event *event; /* [events] `after` is an index in this list */
	double *event_state;              /* [events][2n] */
	enum hawser_folds_end end;
	char message[240];
};

struct hawser__fold_walk {
	struct hawser__fold *fold;
	const struct hawser_folds_options *options;
	struct hawser__amplitude *amplitude;
	struct hawser__fold_station start, before, prev, here, next, scratch, lo, hi;
	struct hawser__fold_list *list;
	struct hawser__fold_store *passages; /* orbits at the nominal load of all curves */
	double *direction, *plane; /* [size] */
	double *state;             /* [2n] */
	struct hawser__curve curve;
	double omega_lo, omega_hi; /* the requested range */
	double window_lo, window_hi;   /* the range with margins (folds_end.c) */
	double ceiling;                /* load at which the curve left the window: above it, the curve
	                                * ends */
	int settled;               /* number of points known when the last one was corrected again */
	int known;                 /* number of stations before here, and here itself */
	int stopped;
	double work;               /* of the responses so far, s, as counted (hawser_orbit_work) */
	int costly;                /* 1: something was left out, as no work was left */
	const char *stage;
	struct hawser__span span;  /* of the whole search */
	struct hawser_report *report;
	struct hawser__hold hold;
};

static inline struct hawser__node hawser__fold_node(const struct hawser__fold_station *station)
{
	return (struct hawser__node){station->z, station->t};
}

static inline int hawser__fold_width(const struct hawser__fold_list *list)
{
	return 3*list->n + 3*list->probes;
}

/* --- folds_walk.c --- */

/* Work that is left for responses and curves, s; INFINITY: it has no limit. */
double hawser__walk_left(const struct hawser__fold_walk *walk);
/* Whether none is left for what is to be done next: walk->costly then. */
int hawser__walk_refused(struct hawser__fold_walk *walk);

enum hawser_status hawser__walk_open(struct hawser__fold_walk *walk, struct hawser__fold *fold,
                                     const struct hawser_folds_options *options,
                                     struct hawser_report *report);
void hawser__walk_clear(struct hawser__fold_walk *walk);

/* Correct station->z in the plane of `row` with the number of harmonics that it needs; *failed
 * becomes 1 if that is not possible. */
enum hawser_status hawser__walk_correct(struct hawser__fold_walk *walk,
                                        struct hawser__fold_station *station, const double *row,
                                        int *failed);
/* After a correction: compute the tangent with a positive component along `side` [size], and the
 * test functions. */
void hawser__walk_finish(struct hawser__fold_walk *walk, struct hawser__fold_station *station,
                         const double *side);
/* Set the metrics of the orbit and of the load at z [size]. */
void hawser__walk_metric(struct hawser__fold_walk *walk, const double *z);
/* Trace from walk->start to the end of the curve; at first the load increases (direction 1) or
 * decreases (-1). */
enum hawser_status hawser__walk_follow(struct hawser__fold_walk *walk,
                                       struct hawser__fold_list *list, int direction);
/* Use the borders of a station, from which the next station is computed. */
void hawser__walk_orient(struct hawser__fold_walk *walk,
                         const struct hawser__fold_station *station);
void hawser__station_copy(struct hawser__fold_station *to, const struct hawser__fold_station *from,
                          int size);

void hawser__fold_swap(struct hawser__fold_station *a, struct hawser__fold_station *b);

/* --- folds_end.c --- */

/* Detect an end of the curve between here and next and move next there. If the curve crosses an end
 * of the range, next is moved to the crossing, and the curve continues. */
enum hawser_status hawser__walk_end(struct hawser__fold_walk *walk, int *ended, int *failed);

/* --- folds_begin.c --- */

/* walk->start becomes the fold at this load nearest to the state x [2n] at omega. *failed as
 * above. */
enum hawser_status hawser__walk_begin(struct hawser__fold_walk *walk, const double *x, double omega,
                                      double load, int *failed);
/* The same from the orbit y [size - 1] at the fold, from harmonic balance. */
enum hawser_status hawser__walk_begin_orbit(struct hawser__fold_walk *walk, const double *y,
                                            double load, int *failed);
/* The same between two states of the response, xa [2n] and xb [2n]. It is slower, but cannot
 * converge to a fold elsewhere. */
enum hawser_status hawser__walk_begin_between(struct hawser__fold_walk *walk, const double *xa,
                                              double omega_a, const double *xb, double omega_b,
                                              double load, int *failed);

/* --- folds_events.c --- */

/* Store the events between here and next; *missed: 1: an event was not located. *cut: 1: the step turns
 * at an event within the range, outside which it begins and ends: next is now that event. */
enum hawser_status hawser__fold_events(struct hawser__fold_walk *walk, int *missed, int *cut);

/* --- folds_list.c --- */

enum hawser_status hawser__list_point(struct hawser__fold_list *list,
                                      struct hawser__fold_walk *walk,
                                      const struct hawser__fold_station *station);
enum hawser_status hawser__list_event(struct hawser__fold_list *list,
                                      struct hawser__fold_walk *walk,
                                      const struct hawser_folds_event *event, const double *z);
void hawser__list_swap(struct hawser__fold_list *list, int a, int b); /* two events */
void hawser__list_clear(struct hawser__fold_list *list);
/* Append the parts of a curve that lie within the range of Omega, range[2], to the result: `back`
 * in reverse order without its first point, then `on`. Each part is a curve of the result. */
enum hawser_status hawser__list_join(struct hawser_folds *folds,
                                     const struct hawser__fold_list *back,
                                     const struct hawser__fold_list *on, const double *range,
                                     struct hawser_report *report);

#endif
