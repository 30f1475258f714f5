/* study/accuracy/certify.h - a fold or a peak on a curve of periodic motions, whatever their equations
 * are: those of a mesh, or of the exact energy of a span.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_CERTIFY_H
#define HAWSER_STUDY_CERTIFY_H

#include <hawser/certificate.h>

/* Motions are rows of numbers [size], Omega the last one. */
struct hawser__corrector {
	void *of;
	size_t size;
	/* The metric of dot is that of the motion y. */
	void (*metric)(void *of, const double *y);
	double (*dot)(void *of, const double *a, const double *b);
	/* y becomes the motion in the plane through it normal to `along`, which becomes the unit tangent;
	 * *lost 1: there is none within the distance `far`. */
	void (*correct)(void *of, double *y, double *along, int *lost, double far);
	/* Largest |x| of the component of a peak over the period, and its derivative along a tangent. */
	double (*size_of)(void *of, double *slope, const struct hawser_certified *peak, const double *y,
	                  const double *along);
};

/* Motions from which one is looked for. */
struct hawser__neighbours {
	const double *y;       /* [size] on the model's curve near the landmark; */
	const double *around[2]; /* those before and behind it */
};

/* The landmark of the curve of `corrector` near that of the model: exact_omega (as the last number of a
 * motion) and exact_size of *item, NAN: it is not found. y, along [size] become the motion and the
 * tangent there, and *bend the second derivative along the curve of what is extreme. */
enum hawser_status hawser__certify_near(struct hawser_certified *item, double *y, double *along,
                                        double *bend, const struct hawser__corrector *corrector,
                                        const struct hawser__neighbours *from,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same from a motion and a tangent near it, with its bend. */
enum hawser_status hawser__certify_from(struct hawser_certified *item, double *y, double *along,
                                        double *bend, const struct hawser__corrector *corrector,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
