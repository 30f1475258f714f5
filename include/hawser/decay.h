/* hawser/decay.h - damping from measurements: a free decay (Bertrand 2022, Appendix D) and a
 * response's half-power points (Appendix F). SPDX-License-Identifier: GPL-3.0-or-later */
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
	double noise;              /* standard deviation of what is left */
	int extremes;              /* that the logarithmic decrement was taken from */
};
/* t and x [count], t ascending; `confidence` such as 0.95 holds for noise that is independent from
 * sample to sample. *decay receives the result. HAWSER_ERR_ARGUMENT (too few samples or cycles,
 * times not ascending), HAWSER_ERR_NAN, HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_decay_fit(struct hawser_decay *decay, const double *t, const double *x,
                                    int count, double confidence,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* Of a linear oscillator's amplitudes a [count] at ascending frequencies omega [count]: where they
 * are the largest over sqrt(2), on both sides. The ratio is exact, not for small damping only, and for
 * points far apart as well: 1/a^2 is a polynomial of second degree in omega^2. */
struct hawser_half_power {
	double peak, low, high; /* frequencies */
	double ratio;
	double ratio_error; /* the larger of the half width of its confidence interval and the distance
	                     * from what other points of the table give */
	double peak_error;  /* of the peak, likewise */
};
/* From a [count] at omega [count]; `confidence` such as 0.95. HAWSER_ERR_ARGUMENT (too few points,
 * frequencies not ascending), HAWSER_ERR_NO_SOLUTION (a side does not reach down to half the power, or
 * the points are not those of one linear oscillator). */
enum hawser_status hawser_half_power_find(struct hawser_half_power *half, const double *omega,
                                          const double *a, int count, double confidence,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
