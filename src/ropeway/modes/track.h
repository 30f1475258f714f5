/* ropeway/modes/track.h - following the frequencies of a ropeway along a sweep.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_TRACK_H
#define HAWSER_ROPEWAY_TRACK_H

#include <hawser/ropeway_modes.h>

/* Modes at one value, by ascending frequency. */
struct hawser__track_sample {
	struct hawser_ropeway_track_sample at;
	int n, spans, values;
	double *omega, *residual; /* [n] rad/s, relative */
	enum hawser_plane *plane; /* [n] */
	double *share;            /* [n][spans] of the kinetic energy */
	double *shape;            /* [n][2][values] of unit norm: real and imaginary parts */
	int *branch;              /* [n] that has this mode, or -1 */
};

struct hawser__track {
	const struct hawser_ropeway_track_options *options;
	struct hawser__track_sample *sample; /* [samples] of the sweep */
	int samples;
	int n, ask;               /* branches; modes at a sample */
	int solves;
	struct hawser_ropeway_track_crossover *crossover; /* [crossovers] */
	int crossovers;
	double least;             /* see least_correlation */
};

/* The scene at a value. */
struct hawser__track_scene {
	double value;
	struct hawser_ropeway ropeway;
	struct hawser_obstacles obstacles;
};

/* track_sample.c: open the scene; solve it: calls for different samples may run at the same time, and
 * the caller counts them in t->solves; both. */
enum hawser_status hawser__track_open(struct hawser__track_scene *scene, const struct hawser__track *t,
                                      double value, struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__track_solve(struct hawser__track_sample *sample,
                                       const struct hawser__track *t,
                                       const struct hawser__track_scene *scene,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__track_scene_clear(struct hawser__track_scene *scene);
enum hawser_status hawser__track_sample(struct hawser__track_sample *sample, struct hawser__track *t,
                                        double value, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__track_sample_clear(struct hawser__track_sample *sample);
/* Squared correlation of the shapes of mode i of a and mode j of b. */
double hawser__track_alike(const struct hawser__track_sample *a, int i,
                           const struct hawser__track_sample *b, int j);
/* 1 if the modes i and j of a sample are in the same plane and move common spans. */
int hawser__track_coupled(const struct hawser__track_sample *a, int i, int j);

/* track_match.c: b->branch from a->branch; a crossover between them is added to t. *split: 1 if the
 * step is too long to tell the branches apart, unless `last`. */
enum hawser_status hawser__track_match(int *split, struct hawser__track *t,
                                       const struct hawser__track_sample *a,
                                       struct hawser__track_sample *b, int last,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* Where the modes at a place (from 0, by frequency in their plane) and the next one are closest between
 * two samples; at->below and above are not set. */
enum hawser_status hawser__track_closest(struct hawser_ropeway_track_crossover *at,
                                         struct hawser__track *t, const struct hawser__track_sample *a,
                                         const struct hawser__track_sample *b, enum hawser_plane plane,
                                         int place, struct hawser_report *report) HAWSER_MUST_CHECK;
/* Place of mode k among those of its plane. */
int hawser__track_place(const struct hawser__track_sample *a, int k);
enum hawser_status hawser__track_crossover(struct hawser__track *t,
                                           const struct hawser_ropeway_track_crossover *at,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
