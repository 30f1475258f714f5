/* study/trial.h - what a response takes, from a part of it that is run: see trial.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_TRIAL_H
#define HAWSER_STUDY_TRIAL_H

#include <hawser/frf.h>

/* Processor time, in s, that the trials of a plan may take. */
struct hawser__allowance {
	double left;  /* of what they may take whatever they find, shared by the rows that are left */
	int rows;     /* that are left, this one included */
	double share; /* of the time that a row's estimate comes to, which it may take beside */
	double most;  /* a row */
	double extra; /* left of what all rows together may take so */
};

/* What is measured of a row. */
struct hawser__trial {
	const struct hawser_frf_options *options; /* as the response is traced */
	double expected;      /* points of a curve, by the formula of points_of */
	double start, end;    /* clock: begin of the row's trial; where it ends whatever it finds */
	double share, most;   /* of the allowance */
	double part;          /* of what may be taken, what the run may take; the rest is for the coarse
	                       * trace */
	/* the curve that is being traced */
	int curve;            /* from 1 */
	double began, last;   /* clock at its first and at its last point */
	int points;
	int before;           /* points of the curve before; 0: this is the first */
	double recent[32];    /* time of the last points, the i-th at i%32 */
	int stopped;          /* 1: ended by the clock */
};

/* What it comes to. */
struct hawser__cost {
	double seconds; /* of the processor */
	double seen;    /* the part of it that is of points that were traced, finely or coarsely */
	double points;
	int complete;   /* 1: the curve was traced to its end, finely or coarsely */
	int bound;      /* 1: seconds and points are the least that it comes to: how the curve goes on is
	                 * not known */
	double omega;   /* where the trace was cut; NAN where it was not */
	int limited;    /* 1: it is ended by the limit on the number of points */
	int slack;      /* points with a tension below zero, of `traced` */
	int traced;
};

double hawser__processor_seconds(void);

/* Begin a row's trial. */
void hawser__trial_begin(struct hawser__trial *trial, struct hawser__allowance *allowance,
                         const struct hawser_frf_options *options, double expected);
/* The row's trial has ended: the next rows have what it left. */
void hawser__trial_end(const struct hawser__trial *trial, struct hawser__allowance *allowance);

/* The progress function of the run that is measured; data: the trial. */
int hawser__trial_watch(void *data, const struct hawser_progress_state *state);

/* Median time of the last points of the present curve. */
double hawser__trial_point(const struct hawser__trial *trial);

/* What is known of a curve without a trace. */
struct hawser__outlook {
	/* the number of points that the formula has between two frequencies; */
	double (*points)(const void *context, double from, double to);
	double (*least)(const void *context, double from, double to); /* and the longest step; */
	/* 1: no resonance lies there that may make many more of them */
	int (*smooth)(const void *context, double from, double to);
	const void *context;
};

/* The cost of a curve of which `frf` is the beginning, traced with trial->options: what is left of it
 * is traced coarsely, as far as the allowance goes, and follows from the outlook from there on. *left
 * is the coarse trace; the caller clears it. */
void hawser__trial_finish(struct hawser__cost *cost, struct hawser_frf *left,
                          struct hawser__trial *trial, const struct hawser_rom *rom,
                          const struct hawser_frf *frf, const struct hawser__outlook *outlook);

/* The first points of a curve, traced as they would be, for hawser__trial_point; seconds of it in
 * *cost, and complete = 1 where the curve ends before. *frf is what was traced; the caller clears it.
 * Statuses of hawser_frf_trace. */
enum hawser_status hawser__trial_points(struct hawser__cost *cost, struct hawser_frf *frf,
                                        struct hawser__trial *trial, const struct hawser_rom *rom,
                                        const struct hawser_frf_options *options, int points,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same of a curve that is not begun yet: its first points are run as they would be. Statuses of
 * hawser_frf_trace. */
enum hawser_status hawser__trial_curve(struct hawser__cost *cost, struct hawser__trial *trial,
                                       const struct hawser_rom *rom,
                                       const struct hawser_frf_options *options, int points,
                                       const struct hawser__outlook *outlook,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
