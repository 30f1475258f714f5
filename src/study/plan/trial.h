/* study/plan/trial.h - the cost of a response, from a part of it that is computed: see trial.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_TRIAL_H
#define HAWSER_STUDY_TRIAL_H

#include <hawser/frf.h>

#include "core/progress.h"

/* The processor time, in s, that the trials of a plan may take. */
struct hawser__allowance {
	double left;  /* remaining time for the remaining rows, independent of their estimates */
	int rows;     /* number of remaining rows, including this one */
	double share; /* additional time of a row, relative to its estimated time */
	double most;  /* limit of the additional time of a row */
	double extra; /* remaining additional time of all rows */
};

/* The measurements of a row. */
struct hawser__trial {
	const struct hawser_frf_options *options; /* options of the response */
	double expected;      /* number of points of a curve by the formula points_of */
	double start, end;    /* clock at the start of the row's trial, and time at which it ends
	                       * without additional time */
	double share, most;   /* as in the allowance */
	double part;          /* part of the time allowed for the run; the rest is for the coarse trace */
	/* the present curve */
	int curve;            /* its number, from 1 */
	double began, last;   /* clock at its first and at its last point */
	int points;
	int before;           /* number of points of the previous curve; 0: this is the first */
	double recent[32];    /* times of the last points, that of the i-th at i%32 */
	int stopped;          /* 1: interrupted by the clock */
};

/* The resulting cost. */
struct hawser__trial_cost {
	double seconds; /* processor time */
	double seen;    /* part of it for points that were traced, accurately or coarsely */
	double points;
	int complete;   /* 1: the curve was traced to its end, accurately or coarsely */
	int bound;      /* 1: seconds and points are lower bounds, since the rest of the curve is not
	                 * known */
	double omega;   /* frequency at which the trace was interrupted; NAN: it was not */
	int limited;    /* 1: it ended at the limit on the number of points */
	int slack;      /* number of points of `traced` with negative tension */
	int traced;
};

/* Begin the trial of a row. */
void hawser__trial_begin(struct hawser__trial *trial, struct hawser__allowance *allowance,
                         const struct hawser_frf_options *options, double expected);
/* End the trial of a row: the remaining time is for the next rows. */
void hawser__trial_end(const struct hawser__trial *trial, struct hawser__allowance *allowance);

/* The progress function of the measured run; data: the trial. */
int hawser__trial_watch(void *data, const struct hawser_progress_state *state);

/* Median of the times of the last points of the present curve. */
double hawser__trial_point(const struct hawser__trial *trial);

/* Predictions for a curve that is not traced. */
struct hawser__outlook {
	/* number of points between two frequencies by the formula; */
	double (*points)(const void *context, double from, double to);
	double (*least)(const void *context, double from, double to); /* number that the longest step
	                                                               * requires; */
	/* 1: no resonance between them may increase these numbers much */
	int (*smooth)(const void *context, double from, double to);
	const void *context;
};

/* The cost of a curve that begins with `frf`, traced with trial->options: the rest is traced
 * coarsely within the allowance, and predicted from there on. *left becomes the coarse trace; the
 * caller clears it. */
void hawser__trial_finish(struct hawser__trial_cost *cost, struct hawser_frf *left,
                          struct hawser__trial *trial, const struct hawser_rom *rom,
                          const struct hawser_frf *frf, const struct hawser__outlook *outlook);

/* Compute the first points of a curve, for hawser__trial_point. *cost gets their time, and complete
 * = 1 if the curve ends before. *frf becomes the trace; the caller clears it. Statuses of
 * hawser_frf_trace. */
enum hawser_status hawser__trial_points(struct hawser__trial_cost *cost, struct hawser_frf *frf,
                                        struct hawser__trial *trial, const struct hawser_rom *rom,
                                        const struct hawser_frf_options *options, int points,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* The cost of a curve of which nothing is traced: its first points are computed. Statuses of
 * hawser_frf_trace. */
enum hawser_status hawser__trial_curve(struct hawser__trial_cost *cost, struct hawser__trial *trial,
                                       const struct hawser_rom *rom,
                                       const struct hawser_frf_options *options, int points,
                                       const struct hawser__outlook *outlook,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
