/* study/compare/curve.h - the distance of two frequency responses as curves: see curve.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_CURVE_H
#define HAWSER_STUDY_CURVE_H

#include <hawser/frf.h>

/* The data of a response that are compared; a copy, which may outlive the response. */
struct hawser__drawn_curve {
	int points, width; /* width: number of displacement components, 3 for each probe */
	double *arc;       /* [points] ascending */
	double *value;     /* [points][1 + width] log Omega, then the amplitudes */
	int largest[2];    /* columns of the two largest stable peaks, from 1; 0: none */
};

/* Copy a response. HAWSER_ERR_MEMORY. Release with hawser__curve_clear, whatever the status. */
enum hawser_status hawser__curve_copy(struct hawser__drawn_curve *curve, const struct hawser_frf *frf,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__curve_clear(struct hawser__drawn_curve *curve);
/* Whether a component, from 1, reaches a part of the largest one, or has one of the two largest
 * peaks. */
int hawser__curve_reaches(const struct hawser__drawn_curve *curve, int column, double part);

/* *distance becomes the least t with this property: every point of either curve that is farther
 * than t from the ends of the range of Omega has a point of the other curve within t, in Omega
 * (relative) and in amplitude (relative to the largest amplitude of the component). Only components
 * that reach half of the largest one count, and those of the two largest peaks. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__curve_distance(double *distance, const struct hawser__drawn_curve *a,
                                          const struct hawser__drawn_curve *b,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same of the counterparts of some points of a curve, at[a->points], in two other responses a and
 * b: the largest distance of a point of b from the curve, moved by what that of a is off, and at
 * extremes of an amplitude the change of that. a == NULL: from the curve itself, and then at may be
 * NULL, and extremes are points like others. peaks: 1: of the components of the two largest peaks
 * alone. */
enum hawser_status hawser__curve_points_distance(double *distance,
                                                 const struct hawser__drawn_curve *curve,
                                                 const int *at,
                                                 const struct hawser__drawn_curve *a,
                                                 const struct hawser__drawn_curve *b,
                                                 int peaks,
                                                 struct hawser_report *report) HAWSER_MUST_CHECK;
/* at [curve->points]: points of which the counterparts show a difference, *count of them: the turning
 * points of Omega and of the components that count, and between them points at some distance from
 * each other whose amplitudes are not small. */
enum hawser_status hawser__curve_marks(int *at, int *count, const struct hawser__drawn_curve *curve,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
