/* study/landmark.h - peaks looked at again where the branch was followed more closely.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_LANDMARK_H
#define HAWSER_STUDY_LANDMARK_H

#include <hawser/study.h>

/* The same peak on a piece of the branch that was followed again: the highest of the maxima about the
 * one nearest to `arc` between which the amplitude falls by less than hawser_landmark_defaults
 * says. Changed where less of it is left to reading between points. Returns the index of the point,
 * or 0 for none. */
int hawser__peak_again(struct hawser_landmark *peak, const struct hawser_frf *frf, double arc);

/* What reading between the points is off by, relative: the errors without those of the orbits. */
static inline double hawser__peak_unread(const struct hawser_landmark *peak)
{
	double omega = peak->omega_error - peak->omega_orbits;
	double size = peak->size_error - peak->size_orbits;

	return omega > size ? omega : size;
}

/* The peaks of displacements (of coordinates, where there are no probes) and tensions, as hawser_peaks
 * has them before any is traced again. rest: least and largest tension at rest, N; slope
 * [n]: how fast they change by each coordinate, N. */
enum hawser_status hawser__landmark_peaks(struct hawser_landmark **peak, int *count,
                                          const struct hawser_frf *frf, const double rest[2],
                                          const double *slope,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* How a branch is gone over again: see sharpen.c. */
struct hawser__sharpening {
	double wanted; /* relative: peaks not known to it are looked at once more, in a shorter window */
	double step;   /* of a window's range of Omega; 0: 0.01 */
	int reach;     /* points on either side of a peak that the window reaches to; 0: 2 */
	double known;  /* relative: peaks that reading between the points knows to it stay as they are */
};

/* Go over the branch again in short steps about every peak, and once more about those that are not
 * known well enough then. What cannot be followed again stays as it is, with its error. */
enum hawser_status hawser__study_sharpen(struct hawser_study_curve *curve,
                                         const struct hawser_rom *rom,
                                         const struct hawser_frf_options *options,
                                         const struct hawser__sharpening *how,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
