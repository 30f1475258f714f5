/* study/accuracy/landmark.h - peaks on pieces of the branch that were traced again in shorter steps.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_LANDMARK_H
#define HAWSER_STUDY_LANDMARK_H

#include <hawser/study.h>

/* Improve a peak from a piece of the branch that was traced again. The peak on the piece is the
 * highest of the maxima about the one nearest to `arc` between which the amplitude decreases by
 * less than the prominence (struct hawser_landmark_options). *peak is replaced if its error by
 * interpolation becomes smaller. Returns the index of the point, or 0 for none. */
int hawser__peak_again(struct hawser_landmark *peak, const struct hawser_frf *frf, double arc);

/* Relative error of a peak by interpolation between points, without that of the orbits. */
static inline double hawser__peak_unread(const struct hawser_landmark *peak)
{
	double omega = peak->omega_error - peak->omega_orbits;
	double size = peak->size_error - peak->size_orbits;

	return omega > size ? omega : size;
}

/* largest [2] become the two largest stable peaks of displacements of a response; probe -1: none. */
void hawser__largest_peaks(struct hawser_landmark *largest, const struct hawser_frf *frf,
                           const struct hawser_landmark *peak, int count);
/* Whether two records are of the same peak of a displacement. */
static inline int hawser__is_peak(const struct hawser_landmark *a, const struct hawser_landmark *b)
{
	return a->probe == b->probe && a->axis == b->axis && a->size == b->size;
}
/* Which displacement it is of; below 0: none. */
static inline int hawser__peak_column(const struct hawser_landmark *peak)
{
	return 3*peak->probe + peak->axis;
}

/* The peaks of displacements (of coordinates, if there are no probes) and of tensions, before any
 * is traced again. rest: smallest and largest tension at rest, N; slope [n]: their derivatives by
 * the coordinates, N. */
enum hawser_status hawser__landmark_peaks(struct hawser_landmark **peak, int *count,
                                          const struct hawser_frf *frf, const double rest[2],
                                          const double *slope,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* Settings for tracing a branch again: see sharpen.c. */
struct hawser__sharpening {
	double wanted; /* required relative error: peaks with a larger one are traced once more, in a
	                * shorter window */
	double step;   /* longest step relative to the window's range of Omega; 0: 0.01 */
	int reach;     /* number of points of the window on either side of the peak; 0: 2 */
	double known;  /* peaks with a smaller relative error by interpolation, with a factor of safety,
	                * are not traced again; 0: all are */
	int orbits;    /* 1: nor are those whose error is mostly that of the orbits; where this counts */
};

/* The factor of safety on the error by interpolation of a peak that is not traced again. */
void hawser__peak_allow(struct hawser_landmark *peak);

/* Trace the branch again in short steps about every peak, and once more about those whose error is
 * still too large. A peak for which this fails, or which is known well enough, keeps its
 * value; with known > 0 its error by interpolation is stated with the factor of safety. */
enum hawser_status hawser__study_sharpen(struct hawser_study_curve *curve,
                                         const struct hawser_rom *rom,
                                         const struct hawser_frf_options *options,
                                         const struct hawser__sharpening *how,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
