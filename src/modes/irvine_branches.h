/* modes/irvine_branches.h - following branches of frequencies along a sweep (doc/theory-irvine.md).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_IRVINE_BRANCHES_H
#define HAWSER_MODES_IRVINE_BRANCHES_H

#include <hawser/irvine.h>

#include "modes/grid.h"

/* Modes at one tension, sorted by frequency in each plane. */
struct hawser__stop {
	double x; /* log of H */
	double moved;
	int inserted;
	struct hawser_statics statics;
	int in, out; /* modes in the plane and out of it */
	struct hawser_mode *mode; /* [in + out] the ones in the plane first; omega in rad/s */
	double *shape; /* [in][2][nodes] P and Q times the square root of the weight, unit norm */
};

/* Sorted neighbours k, k + 1 in the plane at their closest. */
struct hawser__meeting {
	int k;
	double x;   /* log of H */
	double gap; /* relative */
	enum hawser_crossover_kind kind;
	double omega; /* rad/s, mean */
	struct hawser_statics statics;
};

struct hawser__branches {
	struct hawser_span span;
	struct hawser_irvine_options options; /* settled: no zeros left */
	int in, out;   /* branches in the plane and out of it */
	int need;      /* modes in the plane that a stop has to have */
	int ask;       /* modes that are asked of the method to get them */
	int solves;
	const char *method;
	struct hawser_grid nodes; /* common coordinate S/L in [0, 1] of the shapes */
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

/* irvine_stop.c: modes at x = log H, with shapes or without. *stop is overwritten. */
enum hawser_status hawser__stop_solve(struct hawser__stop *stop, struct hawser__branches *all,
                                      double x, int shapes, struct hawser_report *report);
void hawser__stop_clear(struct hawser__stop *stop);
/* Squared correlation of shape i of `a` with shape j of `b`. */
double hawser__stop_correlation(const struct hawser__stop *a, int i, const struct hawser__stop *b,
                                int j, const struct hawser__branches *all);
/* 2 (w[k+1] - w[k])/(w[k+1] + w[k]) in the plane. */
double hawser__stop_gap(const struct hawser__stop *stop, int k);

/* irvine_follow.c: stops, meetings and the order in the plane, from the first stop on;
 * x[points] ascending or descending. */
enum hawser_status hawser__branches_follow(struct hawser__branches *all, const double *x,
                                           int points, struct hawser_report *report);
/* Put a stop in at `place` and take it over; clears it on failure. */
enum hawser_status hawser__branches_insert(struct hawser__branches *all, int place,
                                           struct hawser__stop *stop,
                                           struct hawser_report *report);

/* irvine_meet.c: between the stops `a` and `b` the sorted neighbours k, k + 1 exchange their shapes:
 * find where, and what it is. The new meeting is the last one. */
enum hawser_status hawser__branches_meet(struct hawser__branches *all, int k,
                                         const struct hawser__stop *a, const struct hawser__stop *b,
                                         struct hawser_report *report);
/* Veerings that are wider than a step; and stops added that show the narrow ones. */
enum hawser_status hawser__branches_veerings(struct hawser__branches *all,
                                             struct hawser_report *report);

#endif
