/* modes/sweep/branches.h - following branches of frequencies along a sweep: of the tension
 * (irvine.h) or of the speed (campbell.h). doc/theory-irvine.md.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_BRANCHES_H
#define HAWSER_MODES_BRANCHES_H

#include <hawser/campbell.h>
#include <hawser/gyroscopic.h>
#include <hawser/irvine.h>

#include "core/progress.h"
#include "modes/grid.h"

enum {
	HAWSER__HERE = 96,      /* room for "H = 80000 N" */
	HAWSER__ASK_MOST = 1000 /* most modes computed at a sample; above the 500 branches of a sweep */
};

struct hawser__branches;

struct hawser__sample;
struct hawser__crossover;

/* A kind of sweep: the functions and properties that depend on the swept quantity. */
struct hawser__sweep {
	const char *where; /* `where` of reports */
	/* Statics at the abscissa x of the sweep. */
	enum hawser_status (*statics_at)(struct hawser_statics *statics,
	                            const struct hawser__branches *all, double x,
	                            struct hawser_report *report);
	/* Write the abscissa as text for reports, such as "H = 80000 N". */
	void (*describe)(char *text, size_t size, const struct hawser_statics *statics);
	/* Put into the result: station i; the mode of a branch there, `place` by frequency in its plane,
	 * at [stations][branches]; a crossover of two branches, numbered from 1. */
	void (*station)(void *result, int i, const struct hawser__sample *sample);
	void (*branch)(void *result, size_t at, int place, const struct hawser_mode *mode);
	void (*crossover)(void *result, const struct hawser__crossover *at, int below, int above);
	int moving; /* 1: the cable travels, the modes are complex */
	int ends;   /* 1: the cable has no solution beyond some x; a search that reaches it stops */
	int marks;  /* branches that cannot be distinguished: 1: mark the sample and continue; 0:
	             * fail */
};

/* Options after defaults have replaced zeros. */
struct hawser__branch_options {
	int n;         /* number of branches */
	const char *method;
	int basis;
	double tolerance;
	double correlation; /* a step with a smaller squared correlation is halved */
	double crossing;    /* largest relative gap of a crossing */
	double least_step;  /* in x */
};

/* Modes at one abscissa of a sweep, sorted by frequency in each plane. */
struct hawser__sample {
	double x;
	double moved; /* distance from the requested abscissa */
	int inserted; /* 1: added by the refinement */
	int unsure; /* 1: the branches could not be distinguished between the last sample and this
	             * one */
	struct hawser_statics statics;
	int in, out; /* modes in the plane and out of it */
	struct hawser_mode *mode; /* [in + out] in-plane modes first; omega and re in rad/s */
	/* [in][parts][values] in-plane shapes of unit norm, represented so that the shapes of two modes
	 * of one sample are orthogonal in the Euclidean inner product. parts is 1, or 2 if the modes are
	 * complex: real, imaginary */
	double *shape;
};

/* The point at which the in-plane frequencies k and k + 1, in ascending order, are closest. */
struct hawser__crossover {
	int k;
	double x;
	double gap; /* relative */
	enum hawser_crossover_kind kind;
	double omega; /* rad/s, mean */
	struct hawser_statics statics;
};

struct hawser__branches {
	const struct hawser__sweep *sweep;
	const void *context; /* data of `sweep` */
	struct hawser_span span;
	struct hawser__branch_options options;
	int in, out;   /* number of branches in the plane and out of it */
	int need;      /* number of in-plane modes that a sample must have */
	int ask;       /* number of modes of both planes to be computed so that `need` are in-plane */
	int solves;    /* number of modal solutions computed */
	int basis;     /* largest basis used, functions per component */
	const char *method;
	struct hawser_grid nodes; /* nodes in S/L in [0, 1] at which the shapes of all samples are
	                           * stored */
	int values;               /* length of a part of a shape: number of fields times number of
	                           * nodes */
	double *resample;         /* [nodes][resampled] interpolation from a single element to the
	                           * nodes */
	int resampled;            /* order of that element; 0: `resample` is not computed yet */
	struct hawser__sample *sample; /* [samples] in the order of the sweep */
	int samples;
	struct hawser__crossover *crossover; /* [crossovers] */
	int crossovers;
	int *at;       /* [at_capacity] branch at each place, the index in ascending order of
	                * frequency */
	int at_capacity;
	double least_correlation;
	const struct hawser_progress *progress; /* NULL: none */
	struct hawser__span done;
};

/* branches_follow.c: tell that this part of the present stage is done. */
void hawser__branches_tell(struct hawser__branches *all, double fraction);

/* branches_crossover.c: fill branch [in + out] and, by the functions of the sweep and in its order, the
 * rest of a result. The crossovers of `all` are sorted. */
void hawser__branches_read(void *result, struct hawser_irvine_branch *branch,
                           struct hawser__branches *all);

/* Prepare *all, whose sweep, context, span and options are set, for _follow. */
enum hawser_status hawser__branches_open(struct hawser__branches *all,
                                         struct hawser_report *report);
void hawser__branches_clear(struct hawser__branches *all);

/* branches_sample.c: modes at x, with shapes if `shapes` is nonzero. *sample is overwritten. */
enum hawser_status hawser__sample_solve(struct hawser__sample *sample, struct hawser__branches *all,
                                      double x, int shapes, struct hawser_report *report);
void hawser__sample_clear(struct hawser__sample *sample);
/* Squared correlation of shape i of `a` with shape j of `b`. */
double hawser__sample_correlation(const struct hawser__sample *a, int i, const struct hawser__sample *b,
                                int j, const struct hawser__branches *all);
/* 2 (w[k+1] - w[k])/(w[k+1] + w[k]) in the plane. */
double hawser__sample_gap(const struct hawser__sample *sample, int k);

/* branches_resample.c: interpolate the first `fields` columns of in[points][stride] on `grid` to
 * the common nodes and multiply them by the square roots of the weights: out[fields][nodes]. */
enum hawser_status hawser__branches_interpolate(double *out, struct hawser__branches *all,
                                           const struct hawser_grid *grid, const double *in,
                                           int stride, int fields, struct hawser_report *report);

/* branches_sample.c: *enough is 1 if the numbers of modes have[2], by plane, suffice; otherwise it
 * is 0 and all->ask is increased. */
enum hawser_status hawser__branches_enough(int *enough, struct hawser__branches *all, const int *have,
                                           const struct hawser_statics *statics,
                                           struct hawser_report *report);

/* branches_follow.c: compute samples, crossovers and the order of the in-plane branches at
 * x[points], ascending or descending. */
enum hawser_status hawser__branches_follow(struct hawser__branches *all, const double *x,
                                           int points, struct hawser_report *report);
/* Insert a sample at index `place`. The function takes ownership; it clears the sample on
 * failure. */
enum hawser_status hawser__branches_insert(struct hawser__branches *all, int place,
                                           struct hawser__sample *sample,
                                           struct hawser_report *report);

/* branches_crossover.c: the frequencies k and k + 1 exchange their shapes between the samples `a`
 * and `b`. Locate the crossover, classify it and append it to all->crossover. Nothing is appended
 * if the point is beyond the end of the solutions (sweep->ends). */
enum hawser_status hawser__branches_locate(struct hawser__branches *all, int k,
                                         const struct hawser__sample *a, const struct hawser__sample *b,
                                         struct hawser_report *report);
/* Find veerings that are wider than a step, and insert samples that resolve the narrow ones. */
enum hawser_status hawser__branches_veerings(struct hawser__branches *all,
                                             struct hawser_report *report);

/* --- campbell_range.c: the range of speeds of a Campbell diagram, and its stations --- */

/* Replace zeros by defaults and check the options; *limit as in struct hawser_campbell. */
enum hawser_status hawser__campbell_settle(struct hawser_campbell_options *options, double *limit,
                                           const struct hawser_scene *scene,
                                           struct hawser_report *report);

/* *x [*count]: speeds of the stations, m/s, ascending, below the limit; the first *asked are the
 * requested ones. Release with free(). */
enum hawser_status hawser__campbell_place(double **x, int *count, int *asked,
                                          const struct hawser_campbell_options *options,
                                          double limit, struct hawser_report *report);

/* --- irvine_range.c: the range of a sweep of the tension, and its stations --- */

/* x[points]: log of H (N) at the stations; strictly monotone. */
enum hawser_status hawser__irvine_place(double *x, int points, const struct hawser_span *span,
                                        const struct hawser_irvine_options *options,
                                        struct hawser_report *report);

/* The static solution with the apparent horizontal tension H (N), with attachments and motion as in the
 * options. */
enum hawser_status hawser__irvine_at(struct hawser_statics *st, const struct hawser_span *span,
                                     const struct hawser_irvine_options *options, double H,
                                     struct hawser_report *report);

/* hawser_irvine_range, with attachments and motion as in the options. */
enum hawser_status hawser__irvine_range(double *from, double *to, const struct hawser_span *span,
                                        const struct hawser_irvine_options *options,
                                        enum hawser_given given, struct hawser_report *report);

#endif
