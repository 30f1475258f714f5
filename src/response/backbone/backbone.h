/* response/backbone/backbone.h - the walk along a backbone: where it begins, and its branch points.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_BACKBONE_H
#define HAWSER_RESPONSE_BACKBONE_H

#include <hawser/backbone.h>

#include "continuation/curve.h"
#include "response/branch/amplitude.h"
#include "response/floquet/half.h"
#include "response/branch/signs.h"

struct hawser__free_walk {
	const struct hawser_rom *rom;
	const struct hawser_backbone_options *options;
	struct hawser_backbone *backbone;
	struct hawser__half half;
	struct hawser__amplitude *amplitude;
	double *y, *t, *next, *next_t, *row; /* [n + 1] */
	double *at, *at_t, *other;           /* [n + 1] of a branch point */
	struct hawser__signs signs;
	unsigned char *member;               /* [n] 1: the first point moves in this coordinate */
	double first;                        /* size of the first point */
	/* what vanishes at branch points, as sign (0: unknown) and logarithm: of the motion's own
	 * class, then of each other class with its signs and with the opposite ones */
	int events;
	double *event, *next_event;          /* [events][2] */
	int met;                             /* 1: a known branch point was reached */
	struct hawser__curve curve;
	double lo, hi;
	double began; /* s, hawser__wall_seconds */
	struct hawser_report *report;
};

/* Correct y in the plane of `row`, with the number of steps that the tolerance requires. */
enum hawser_status hawser__free_correct(struct hawser__free_walk *walk, double *y, const double *row,
                                        struct hawser__correction *correction, int *failed,
                                        struct hawser_report *report);

/* backbone_begin.c: signs and classes of the coordinates; walk->at = the first point, nearly; first. */
enum hawser_status hawser__free_signs(struct hawser__free_walk *walk, struct hawser_report *report);

/* backbone_branch.c: event [events][2] at the last factors, which are lost; and find the branch
 * points in the step to `next`. *moved 1: the last integration is not that of `next` any more. */
void hawser__free_events(struct hawser__free_walk *walk, double *event);
enum hawser_status hawser__free_branches(struct hawser__free_walk *walk, int *moved);

#endif
