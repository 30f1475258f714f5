/* modes/branches.h - following branches of frequencies along a sweep: of the tension (irvine.h) or of
 * the speed (campbell.h). doc/theory-irvine.md.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_BRANCHES_H
#define HAWSER_MODES_BRANCHES_H

#include <hawser/gyroscopic.h>
#include <hawser/irvine.h>

#include "modes/grid.h"

enum {
	HAWSER__HERE = 96,      /* room for "H = 80000 N" */
	HAWSER__ASK_MOST = 1000 /* modes asked for at a stop; more than the 500 branches of a sweep */
};

struct hawser__branches;

/* What a sweep runs over. */
struct hawser__course {
	const char *where; /* of reports */
	/* Statics at x, the abscissa of the sweep. */
	enum hawser_status (*place)(struct hawser_statics *statics,
	                            const struct hawser__branches *all, double x,
	                            struct hawser_report *report);
	/* "H = 80000 N", for reports. */
	void (*say)(char *text, size_t size, const struct hawser_statics *statics);
	int moving; /* modes of struct hawser_complex_modes, which travelling ones need */
	int ends;   /* the cable has no solution beyond some x: a search that gets there gives up */
	int marks;  /* where branches cannot be told apart the stop is marked, and the sweep goes on */
};

/* Settled: no zeros left. */
struct hawser__branch_options {
	int n;         /* branches */
	const char *method;
	int basis;
	double tolerance;
	double correlation; /* steps are halved where a squared correlation is below */
	double crossing;    /* largest relative gap of a crossing */
	double least_step;  /* in x */
};

/* What only a complex mode has. */
struct hawser__wave {
	double re;         /* of the eigenvalue, rad/s */
	double downstream; /* of struct hawser_complex_mode */
};

/* Modes at one place of a sweep, sorted by frequency in each plane. */
struct hawser__stop {
	double x;
	double moved; /* in x */
	int inserted;
	int unsure; /* the branches could not be told apart on the way here */
	struct hawser_statics statics;
	int in, out; /* modes in the plane and out of it */
	struct hawser_mode *mode; /* [in + out] the ones in the plane first; omega in rad/s */
	/* [in][values] shapes in the plane, in a form in which the plain product of the shapes of two modes
	 * of one stop vanishes; of unit norm. */
	double *shape;
	double *imaginary; /* [in][values] their imaginary part; NULL where they are real */
	struct hawser__wave *wave; /* [in + out] NULL at rest */
};

/* Sorted neighbours k, k + 1 in the plane at their closest. */
struct hawser__meeting {
	int k;
	double x;
	double gap; /* relative */
	enum hawser_crossover_kind kind;
	double omega; /* rad/s, mean */
	struct hawser_statics statics;
};

struct hawser__branches {
	const struct hawser__course *course;
	const void *context; /* of the course */
	struct hawser_span span;
	struct hawser__branch_options options;
	int in, out;   /* branches in the plane and out of it */
	int need;      /* modes in the plane that a stop has to have */
	int ask;       /* modes that are asked of the method to get them */
	int solves;
	int basis;     /* the largest that was used */
	const char *method;
	struct hawser_grid nodes; /* common coordinate S/L in [0, 1] of the shapes */
	int values;               /* of a shape: so many fields at each node */
	double *resample;         /* [nodes][resampled order] from a single element to the nodes */
	int resampled;            /* order that it is for; 0: none yet */
	struct hawser__stop *stop; /* [stops] in the order of the sweep */
	int stops, stop_capacity;
	struct hawser__meeting *meeting; /* [meetings] */
	int meetings, meeting_capacity;
	int *at;       /* [at_capacity] branch at each sorted place in the plane */
	int at_capacity;
	double least_correlation;
};

/* branches_meet.c: the two branches of a meeting, which change their places in all->at where they
 * cross. Returns 0 where neither is one that was asked for. Called for each meeting in the order
 * of the sweep. */
int hawser__branches_pair(int *below, int *above, struct hawser__branches *all,
                          const struct hawser__meeting *meeting);

/* Ready for _follow: *all with its course, context, span and options. */
enum hawser_status hawser__branches_open(struct hawser__branches *all,
                                         struct hawser_report *report);
void hawser__branches_clear(struct hawser__branches *all);

/* branches_stop.c: modes at x, with shapes or without. *stop is overwritten. */
enum hawser_status hawser__stop_solve(struct hawser__stop *stop, struct hawser__branches *all,
                                      double x, int shapes, struct hawser_report *report);
void hawser__stop_clear(struct hawser__stop *stop);
/* Squared correlation of shape i of `a` with shape j of `b`. */
double hawser__stop_correlation(const struct hawser__stop *a, int i, const struct hawser__stop *b,
                                int j, const struct hawser__branches *all);
/* 2 (w[k+1] - w[k])/(w[k+1] + w[k]) in the plane. */
double hawser__stop_gap(const struct hawser__stop *stop, int k);

/* branches_resample.c: `fields` fields of in[points][stride] on `grid`, from 0 to l, at the common
 * nodes, times the square root of their weights, into out[fields][nodes]. */
enum hawser_status hawser__branches_sample(double *out, struct hawser__branches *all,
                                           const struct hawser_grid *grid, const double *in,
                                           int stride, int fields, struct hawser_report *report);

/* branches_moving.c: fill a stop, whose statics are known, of a travelling cable. */
enum hawser_status hawser__stop_moving(struct hawser__stop *stop, struct hawser__branches *all,
                                       int shapes, struct hawser_report *report);
/* branches_stop.c: are have[2] modes in each plane enough? Otherwise raise all->ask, clear *enough. */
enum hawser_status hawser__branches_enough(int *enough, struct hawser__branches *all, const int *have,
                                           const struct hawser_statics *statics,
                                           struct hawser_report *report);

/* branches_follow.c: stops, meetings and the order in the plane, from the first stop on;
 * x[points] ascending or descending. */
enum hawser_status hawser__branches_follow(struct hawser__branches *all, const double *x,
                                           int points, struct hawser_report *report);
/* Put a stop in at `place` and take it over; clears it on failure. */
enum hawser_status hawser__branches_insert(struct hawser__branches *all, int place,
                                           struct hawser__stop *stop,
                                           struct hawser_report *report);

/* branches_meet.c: between the stops `a` and `b` the sorted neighbours k, k + 1 exchange their shapes:
 * find where, and what it is. The new meeting is the last one; none where the closest is beyond the end
 * of a course that ends. */
enum hawser_status hawser__branches_meet(struct hawser__branches *all, int k,
                                         const struct hawser__stop *a, const struct hawser__stop *b,
                                         struct hawser_report *report);
/* Veerings that are wider than a step; and stops added that show the narrow ones. */
enum hawser_status hawser__branches_veerings(struct hawser__branches *all,
                                             struct hawser_report *report);

#endif
