/* hawser/decay.h - damping from measurements: from a free decay (Bertrand 2022, Appendix D) and
 * from the half-power points of a response (Appendix F). SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_DECAY_H
#define HAWSER_DECAY_H

#include <hawser/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* x(t) = offset + amplitude exp(-ratio omega t) cos(omega sqrt(1 - ratio^2) t + phase) + noise, by
 * least squares. Units are those of the data. */
struct hawser_decay {
	double omega, omega_error; /* undamped frequency, half width of its confidence interval */
	double ratio, ratio_error; /* damping ratio, half width of its confidence interval */
	double log_decrement;      /* ratio from the logarithms of successive extremes */
	double amplitude, offset;
	double noise;              /* standard deviation of the residuals of the fit */
	int extremes;              /* number of extremes used for the logarithmic decrement */
};
/* Fit t and x [count], t ascending, with intervals of the given confidence, such as 0.95, which
 * assumes that the noise of the samples is independent. HAWSER_ERR_ARGUMENT (too few samples or
 * cycles, times not ascending), HAWSER_ERR_NAN, HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_decay_fit(struct hawser_decay *decay, const double *t, const double *x,
                                    int count, double confidence,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* The half-power points of a linear oscillator: the two frequencies at which the amplitude is
 * 1/sqrt(2) of the largest. Since 1/a^2 is a polynomial of second degree in omega^2, the ratio is
 * exact for any damping and any spacing of the points. */
struct hawser_half_power {
	double peak, low, high; /* frequencies */
	double ratio;
	double ratio_error; /* the larger of the half width of its confidence interval and the
	                     * difference from the ratio that other points of the table give */
	double peak_error;  /* the same for `peak` */
	int modes;          /* 2: the points are certainly those of two modes within each other's width,
	                     * and `ratio` is their mean; peak and half-power points are those of their
	                     * sum */
	double noise;       /* standard deviation of the points, relative to the peak, where they scatter
	                     * at random; else 0. With modes 1, ratio_error leaves out pairs of two
	                     * ratios that this noise hides */
	double pair_error;  /* the error that contains both ratios of two modes of which none is seen,
	                     * but which what one mode leaves of the points may hide: the weaker part at
	                     * least a tenth of the other; NAN: not known. With modes 2: ratio_error */
};
/* Find the points from the amplitudes a [count] at ascending frequencies omega [count];
 * `confidence` such as 0.95. HAWSER_ERR_ARGUMENT (too few points, frequencies not ascending),
 * HAWSER_ERR_NO_SOLUTION (the amplitude does not fall to half the power on a side, or the points
 * are not those of one linear oscillator). */
enum hawser_status hawser_half_power_find(struct hawser_half_power *half, const double *omega,
                                          const double *a, int count, double confidence,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
