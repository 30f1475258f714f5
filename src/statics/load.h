/* statics/load.h - the varying load of a scene in parts: see load.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_LOAD_H
#define HAWSER_STATICS_LOAD_H

#include <hawser/statics.h>

#define HAWSER__LOAD_STEP 0.5 /* rad: change of a wave's phase on which a rule of Gauss is exact */

enum { HAWSER__PIECES = HAWSER_LOADS_MAX + 1 };

/* A force per length f cos(k tau + phase - kappa s) between two scaled arclengths, or at a point. */
struct hawser__piece {
	enum hawser_frame frame;
	double f[3];        /* N/m; at a point, as if spread over the length unit (`scale` of the loads) */
	double from, to;    /* scaled arclength; equal: a force at this point */
	double phase, kappa;
	int harmonic[2];    /* index in the loads' harmonics of its cosine and its sine part, -1: none */
};

struct hawser__loads {
	int count, harmonics;
	struct hawser__piece piece[HAWSER__PIECES];
	int k[2*HAWSER__PIECES];
	int sine[2*HAWSER__PIECES]; /* [harmonics] 0: of cos(k tau), 1: of sin; with k the first
	                             * harmonics of a model */
	int cuts;
	double *cut;        /* [cuts] ascending: begins, ends and points of the pieces, and as many points
	                     * of waves as their phase requires; owned */
	double scale;       /* converts the work of f in N/m over scaled lengths to a scaled force */
};

/* 1 if the scene has a varying load. */
int hawser__loaded(const struct hawser_scene *scene);

/* The load of the scene in pieces: the section load, then the list loads; scene NULL: none.
 * HAWSER_ERR_SCENE: a place that is not on the cable, a wave that is too short. */
enum hawser_status hawser__loads_make(struct hawser__loads *loads, const struct hawser_statics *st,
                                      const struct hawser_scene *scene,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__loads_clear(struct hawser__loads *loads);

/* Part of harmonic h in the force of a piece at s, N/m: in the axes of the piece, and (_at) in the
 * local frame. */
void hawser__piece_part(double f[3], const struct hawser__piece *piece,
                        const struct hawser__loads *loads, int h, double s);
void hawser__piece_at(double local[3], const struct hawser__piece *piece,
                      const struct hawser__loads *loads, int h, const struct hawser_statics *st,
                      double s);

#endif
