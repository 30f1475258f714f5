/* response/locus/locus_walk.h - continuation of a locus: points, tests, events.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_LOCUS_WALK_H
#define HAWSER_RESPONSE_LOCUS_WALK_H

#include "continuation/curve.h"
#include "core/progress.h"
#include "response/locus/locus.h"

struct hawser__locus_station {
	double *z, *t;               /* [room], zero beyond the size of the system */
	double complex *b, *c;       /* [room] borders of the next point */
	int order;
	int orientation;             /* sign of the determinant with the tangent; constant along a curve */
	double test[LOCUS_TESTS];    /* NAN: not a test of this kind */
	int pairs;                   /* complex pairs outside the unit circle, besides the critical one */
	double arc;
	struct hawser__correction correction;
	struct hawser_locus_point point;
	double *coordinate, *state;  /* [n], [2n] */
};

/* Points and events of one direction. */
struct hawser__locus_list {
	int points, events;
	struct hawser_locus_point *point;
	double *coordinate, *state;
	struct hawser_locus_event *event;
	enum hawser_locus_end end;
	char message[240];
};
void hawser__locus_list_clear(struct hawser__locus_list *list);
/* The events from the first one in order along the curve. */
void hawser__locus_sort(struct hawser__locus_list *list, int first);

struct hawser__locus_walk {
	struct hawser__locus *locus;
	const struct hawser_locus_options *options;
	struct hawser_report *report;
	struct hawser__locus_station start, before, prev, here, next, scratch;
	double *weight, *row, *dz, *spare; /* [room] */
	double complex *kept;        /* [2 room] borders of `here` */
	int room;
	double reference[2];         /* logarithms of determinants at the start */
	struct hawser__locus_list *list;
	struct hawser__curve curve;
	int known, stopped;
	int costly;                  /* 1: something was left out, as no work was left */
	struct hawser__span span;    /* of the whole search; set by the caller */
};

enum hawser_status hawser__locus_walk_open(struct hawser__locus_walk *walk, struct hawser__locus *locus,
                                           const struct hawser_locus_options *options,
                                           struct hawser_report *report);
void hawser__locus_walk_close(struct hawser__locus_walk *walk);
void hawser__locus_station_copy(const struct hawser__locus_walk *walk,
                                struct hawser__locus_station *to,
                                const struct hawser__locus_station *from);

/* Correct station->z: <row, dz> = 0, with row [size]; more harmonics where they are needed. */
enum hawser_status hawser__locus_correct(struct hawser__locus_walk *walk,
                                         struct hawser__locus_station *station, const double *row,
                                         int *failed);
/* Tangent (along `side`, as row of the plane), tests and the point's numbers. */
enum hawser_status hawser__locus_finish(struct hawser__locus_walk *walk,
                                        struct hawser__locus_station *station, const double *side);
/* From start, which is corrected. direction: of the parameter, 1 or -1. */
enum hawser_status hawser__locus_follow(struct hawser__locus_walk *walk,
                                        struct hawser__locus_list *list, int direction);

/* Whether no work is left for what is to be done next: walk->costly then. */
int hawser__locus_refused(struct hawser__locus_walk *walk);

/* locus_begin.c: z = the orbit through the state x [2n] at `first`, Omega or the first parameter. */
enum hawser_status hawser__locus_orbit_through(struct hawser__locus_walk *walk, double *z,
                                               const double *x, double first);
/* Arrange for the first number of harmonics, or fewer where there is no room. */
enum hawser_status hawser__locus_first_order(struct hawser__locus *locus);
/* locus_phase.c: add the resonances of a response to its events. */
enum hawser_status hawser__locus_find_resonances(struct hawser__locus_walk *walk,
                                                 struct hawser_frf *frf);
/* start = the bifurcation between points `after` and `after` + 1 of the response. */
enum hawser_status hawser__locus_begin(struct hawser__locus_walk *walk, const struct hawser_frf *frf,
                                       int event, int *failed);

/* locus_torus.c: whether the locus of a torus passes kappa = `end`, 0 or 1/2, between here and next;
 * let all points have kappa between 0 and 1/2 again. */
enum hawser_status hawser__locus_pass(struct hawser__locus_walk *walk, double end, int *passes);
void hawser__locus_mirror(struct hawser__locus_walk *walk, double end);
static inline int hawser__locus_is_beyond(const struct hawser__locus_walk *walk)
{
	double kappa = walk->next.z[LOCUS_KAPPA];

	return walk->locus->kind == HAWSER_TORUS && (kappa <= 0.0 || kappa >= 0.5);
}

/* locus_events.c: tests at the last evaluation; the events between here and next. */
enum hawser_status hawser__locus_test(struct hawser__locus_walk *walk,
                                      struct hawser__locus_station *station);
void hawser__locus_test_angle(const struct hawser__locus *locus,
                              struct hawser__locus_station *station);
enum hawser_status hawser__locus_find_events(struct hawser__locus_walk *walk);
/* The end of a torus locus at kappa = 0 or 1/2, beyond `here`. */
enum hawser_status hawser__locus_resonance(struct hawser__locus_walk *walk, double kappa);

/* Amplitudes and the state at the phase 0, of the orbit that was evaluated last. The largest value lies
 * between samples: it is that of the parabola through the three largest. */
void hawser__locus_describe(struct hawser__locus_walk *walk, struct hawser__locus_station *station);
/* Angle by which a null vector turns in a step. Borders have length 1, and the right phase. */
double hawser__locus_turn(const struct hawser__locus_walk *walk, const double complex *from,
                          const double complex *to);

#endif
