/* hawser/integrate.h - time response of a reduced model, by SUNDIALS CVODE, and spectra by FFTW.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_INTEGRATE_H
#define HAWSER_INTEGRATE_H

#include <hawser/rom.h>

#ifdef __cplusplus
extern "C" {
#endif

struct hawser_integrate_options {
	double omega;      /* scaled forcing frequency, > 0 where the model has harmonics */
	double until;      /* scaled end time, > 0 */
	double every;      /* scaled output interval, > 0 */
	double rtol, atol; /* CVODE tolerances on u and u'; defaults 1e-10 and 1e-13 */
	const char *method; /* "adams", "bdf", or NULL: adams */
	const double *initial; /* [2n] u then u' at t = 0, or NULL: rest */
	/* called after each output; nonzero ends the run cleanly with what is there. May be NULL. */
	int (*progress)(void *context, double t, double until);
	void *progress_context;
};

/* A run: one row an output time. */
struct hawser_trajectory {
	int n, rows;
	double *time;   /* [rows] scaled */
	double *state;  /* [rows][2n] u then u' */
	double *energy; /* [rows] scaled */
	long steps, evaluations, jacobians; /* the integrator's cost */
	int interrupted;
};

enum hawser_status hawser_integrate(struct hawser_trajectory *trajectory,
                                    const struct hawser_rom *rom,
                                    const struct hawser_integrate_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_trajectory_clear(struct hawser_trajectory *trajectory);

/* One-sided amplitude spectrum of `rows` equidistant samples `dt` apart (any time unit), after a
 * Hann window and removal of the mean: *bins bins, frequency[i] in cycles per time unit, amplitude[i]
 * such that a sine of amplitude A on a bin shows A. Both arrays hold rows/2 + 1; caller-owned. */
enum hawser_status hawser_spectrum(double *frequency, double *amplitude, int *bins,
                                   const double *samples, int rows, double dt,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
